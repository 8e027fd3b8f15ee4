//! The metal that passes of threads take out: what a profile, which has no threads, must not count as missing.

use super::alarm::TOUCH;
use super::path::Piece;
use super::tool::{Cutter, TurningTool};
use crate::number::trig::{hypot, sin, tan};

/// The groove of a pass of a thread, as far as its insert can cut one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreadGroove {
    /// The root from the start of the pass to its end, `[z, r]` in mm.
    way: Piece,
    /// The axis along which the thread runs: 0 for z, 1 for r.
    along: usize,
    /// 1 where the tip points towards greater values across the thread, else -1.
    into: f64,
    /// The tangent of half the thread's angle.
    flank: f64,
    /// How far the apex of the sharp profile is below the tip, mm.
    apex: f64,
    /// How deep a groove of the lead has crests, mm.
    most: f64,
}

impl ThreadGroove {
    /// The groove of a pass, `[z, r]` in mm, with a lead in mm; `None` for a tool that is not for threading, or whose tip does
    /// not point across the thread.
    pub(super) fn new([from, to]: Piece, lead: f64, tool: &TurningTool) -> Option<Self> {
        let Cutter::Threader { angle, nose, .. } = tool.cutter else { return None };
        let along = usize::from((to[1] - from[1]).abs() > (to[0] - from[0]).abs());
        let into = tool.tip.vector()[1 - along];
        let half = angle.to_radians() / 2.0;
        let (flank, apex) = (tan(half), nose * (1.0 / sin(half) - 1.0));
        let slope = (to[1 - along] - from[1 - along]) / (to[along] - from[along]);
        // Where the pass goes at an angle, as in pulling out, the round of the nose goes deeper than the way of the tip.
        let below = nose * (hypot(1.0, slope) - 1.0);
        let most = lead / (2.0 * flank) - apex + below;
        let whole = into != 0.0 && below.is_finite() && most.is_finite();
        let root = |mut tip: [f64; 2]| {
            tip[1 - along] += into.signum() * below;
            tip
        };
        whole.then(|| Self { way: [root(from), root(to)], along, into: into.signum(), flank, apex, most })
    }

    /// The same groove with z mirrored: z becomes `sum` - z, in mm.
    pub(super) fn mirrored(self, sum: f64) -> Self {
        let into = if self.along == 1 { -self.into } else { self.into };
        Self { way: self.way.map(|[z, r]| [sum - z, r]), into, ..self }
    }

    /// The same groove farther along z by so much, in mm.
    pub(super) fn shifted(self, by: f64) -> Self {
        Self { way: self.way.map(|[z, r]| [z + by, r]), ..self }
    }

    /// How far a place `[z, r]` is from the root towards the crest, mm; `None` beyond the ends of the pass, where not even a
    /// flank reaches.
    fn height(&self, place: [f64; 2]) -> Option<f64> {
        let ([from, to], across) = (self.way, 1 - self.along);
        let at = place[self.along];
        let ends = [from[self.along].min(to[self.along]), from[self.along].max(to[self.along])];
        let part = (at.clamp(ends[0], ends[1]) - from[self.along]) / (to[self.along] - from[self.along]);
        let root = from[across] + (to[across] - from[across]) * part;
        let height = self.into * (root - place[across]);
        let beyond = (ends[0] - at).max(at - ends[1]);
        (height > 0.0 && beyond <= (height + self.apex) * self.flank + TOUCH).then_some(height)
    }
}

/// True where threads explain that metal is missing from a place `[z, r]`, whose nearest surface is `off` away, mm: it lies between
/// root and crest of a pass, and the surface is no deeper than that root. A place beyond the crests of any pass there is not
/// explained.
#[must_use]
pub fn explained(grooves: &[ThreadGroove], place: [f64; 2], off: f64) -> bool {
    let mut explained = false;
    for groove in grooves {
        let Some(height) = groove.height(place) else { continue };
        if height > groove.most + TOUCH {
            return false;
        }
        explained |= off <= height + TOUCH;
    }
    explained
}

/// A thread of lead 2 mm and 60° with a sharp tip, its root at r 9, from z 5 to z -20.
#[cfg(test)]
pub(crate) const OUTSIDE: ThreadGroove = ThreadGroove {
    way: [[5.0, 9.0], [-20.0, 9.0]],
    along: 0,
    into: -1.0,
    flank: 0.577_350_269_189_625_7,
    apex: 0.0,
    most: 1.732_050_807_568_877_2,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thread_explains_metal_between_its_root_and_its_crest_alone() {
        for (place, off, wanted) in [
            ([-10.0, 10.0], 1.0, true),
            ([-10.0, 10.0], 0.3, true),
            // Deeper than the root, below it, beyond the crest.
            ([-10.0, 10.0], 1.1, false),
            ([-10.0, 8.9], 0.05, false),
            ([-10.0, 10.8], 0.5, false),
            // Its last groove ends where the flank does.
            ([-20.5, 10.0], 0.5, true),
            ([-20.6, 10.0], 0.5, false),
        ] {
            assert_eq!(explained(&[OUTSIDE], place, off), wanted, "{place:?} {off}");
        }
        assert!(!explained(&[], [-10.0, 10.0], 0.1));
    }

    #[test]
    fn a_thread_in_a_bore_explains_metal_towards_the_axis() {
        let inside = ThreadGroove { into: 1.0, ..OUTSIDE };
        assert!(explained(&[inside], [-10.0, 8.5], 0.5));
        assert!(!explained(&[inside], [-10.0, 9.5], 0.5));
    }

    #[test]
    fn a_part_turned_about_takes_its_threads_along() {
        let turned = [OUTSIDE.mirrored(-50.0).shifted(-1.0)];
        assert!(explained(&turned, [-32.0, 10.0], 1.0));
        assert!(!explained(&turned, [-10.0, 10.0], 1.0));
    }
}
