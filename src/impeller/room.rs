//! From which point on a splitter's tool may stand at its full offset without cutting into the neighbouring blade.
//!
//! Where two tip paths w beside their mean lines cross, a tool on either of them is as near to the other's blade as to
//! its own, if both stand upright. That is the published rule: full offset from the crossing in plan on. The tools do not
//! stand upright, though. At the crossing the splitter's tool leans along its own N, the neighbour's flank along an N′
//! turned on about the axis, and the tips, one above the other in plan, differ in height. In the published case a tool at
//! full offset reaches 0.31 mm into the neighbour where the paths at +w cross, at 19.1, and is clear of it from 20.3 on;
//! at −w it reaches 0.53 mm into it at 28.6 and is clear from 31.5 on.
//!
//! So each side asks the solids themselves. Let c(x, m) be the least distance of the tool, a cylinder of diameter d_t
//! with a flat end, from the flanks of the blades on both sides, in the pose that the control gives it at the index x,
//! between the points of the path with the offset w·f_j(m): X, Y, Z, B and C linear between them. Then m is the least
//! index, not before the crossing in plan, with
//!
//! > c(x, m) ≥ ε for all 0 ≤ x ≤ n.
//!
//! A greater m lowers f_j at every point before it and leaves it at 1 past it: the tool moves towards the middle of the
//! channel, away from the neighbour on its side, and the other one is farther off. What is met by one m is met by all
//! greater ones, and the least is found by halving. There is none where the tool does not fit through the middle, or not
//! at the exit.
//!
//! The ways from the safe points to the path and back are the same whatever m is; they are left to the judge of the
//! finished program, which stops what is too narrow for them.
//!
//! ε is what rounding to the output grid may take: 0.0005 mm on each of X, Y, Z, and 0.0005° on B and C at the distance of
//! any point of the part from the pivot, L + R at most, and from the axis, R at most.
//!
//! # References
//! Derived here.
//!
//! # Units
//! Millimetres and radians; x in steps.

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::impeller::blade::Blade;
use crate::impeller::design::Design;
use crate::impeller::fade::fraction;
use crate::impeller::solids::{Flanks, Tool};
use crate::impeller::track::Track;
use crate::machine::rotary::Rotary;

/// Least number of poses along a path that are looked at; with fewer blocks, several within each.
const POSES: usize = 96;

/// The channel that a splitter stands in, with its walls.
#[derive(Debug)]
pub struct Room<'a> {
    design: &'a Design,
    blade: &'a Blade,
    flanks: Flanks,
    /// ε.
    least: f64,
}

impl<'a> Room<'a> {
    /// The channel between two blades of a design.
    #[must_use]
    pub fn new(design: &'a Design, blade: &'a Blade) -> Self {
        let turned = 0.0005_f64.to_radians() * (design.machine.L + 2.0 * design.torus.R);
        Self {
            design,
            blade,
            flanks: Flanks::new(blade, design.n, design.e, design.a_p),
            least: 0.0005 * 3.0_f64.sqrt() + turned,
        }
    }

    /// The least m from `from` on with which the tool of a splitter's track has room; `None` where there is none.
    #[must_use]
    pub fn least(&self, track: Track, from: usize) -> Option<usize> {
        // Nearly always it is the first full offset that has no room, which one block tells.
        let beginning = least(from, self.design.n, |m| self.clear(track, m, [m.saturating_sub(1)]))?;
        least(beginning, self.design.n, |m| {
            let stride = self.design.n.div_ceil(POSES).max(1);
            self.clear(track, m, [m.saturating_sub(1), m].into_iter().chain((0..self.design.n).step_by(stride)))
        })
    }

    /// True where the tool keeps clear of both blades in the blocks that begin at some points of a path.
    fn clear(&self, track: Track, m: usize, blocks: impl IntoIterator<Item = usize>) -> bool {
        let half = PI / f64::from(self.design.N);
        let parts = u16::try_from(POSES.div_ceil(self.design.n.max(1))).unwrap_or(1);
        blocks.into_iter().filter(|&j| j < self.design.n).all(|j| {
            (0..=parts).all(|part| {
                let tool = self.tool(track, m, j, f64::from(part) / f64::from(parts));
                [half, -half].iter().all(|&angle| self.flanks.nearest(&tool.turned(angle), 0.0, self.least).is_none())
            })
        })
    }

    /// The tool at a part of the way from the point j to the next.
    fn tool(&self, track: Track, m: usize, j: usize, part: f64) -> Tool {
        let (design, blade) = (self.design, self.blade);
        let next = j + 1;
        let linear = |from: f64, to: f64| from + (to - from) * part;
        let offset = track.side() * design.w() * linear(fraction(j, m), fraction(next, m));
        let machine = blade.machine[j] + (blade.machine[next] - blade.machine[j]) * part + blade.b_machine * offset
            - Vector3::new(0.0, 0.0, design.a_p);
        let (B, C) = (linear(blade.B[j], blade.B[next]), linear(blade.C[j], blade.C[next]));
        Tool {
            tip: design.machine.to_part(&machine, B, C),
            axis: Rotary::direction_to_part(&Vector3::z(), B, C),
            radius: design.d_t / 2.0,
        }
    }
}

/// The least whole number from `from` to `to` for which something holds that holds for all greater ones.
fn least(from: usize, to: usize, holds: impl Fn(usize) -> bool) -> Option<usize> {
    if from > to {
        return None;
    }
    if holds(from) {
        return Some(from);
    }
    if !holds(to) {
        return None;
    }
    let (mut low, mut high) = (from + 1, to);
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    Some(high)
}
