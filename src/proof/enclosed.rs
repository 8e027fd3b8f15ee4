//! What a judge has enclosed over the motions of a program: between the looks too, so that a pass is one of every place.

use crate::gcode::program::Program;
use crate::number::bound::Enclosure;
use crate::proof::check::{At, Check, FAULT, Verdict, mm};
use crate::text::Text;

/// The greatest values of K questions, with where they were found.
#[derive(Clone, Copy, Debug)]
pub struct Enclosed<const K: usize> {
    /// The values.
    pub found: Enclosure<K>,
    /// Where.
    pub at: [Option<At>; K],
}

impl<const K: usize> Enclosed<K> {
    /// Of no motion yet; see [`Enclosure::new`].
    #[must_use]
    pub const fn new(fine: [f64; K], limit: [f64; K], looks: u32) -> Self {
        Self { found: Enclosure::new(fine, limit, looks), at: [None; K] }
    }

    /// Takes a motion in; see [`Enclosure::take`].
    pub fn take<N: Copy>(
        &mut self,
        at: At,
        looks: &[N],
        values: impl Fn(&N) -> [f64; K],
        over: impl Fn(&N, &N) -> [f64; K],
        middle: impl FnMut(&N, &N) -> N,
    ) {
        let before = self.found;
        self.found.take(looks, values, over, middle);
        for k in 0..K {
            if self.found.reached[k] > before.reached[k] || self.at[k].is_none() {
                self.at[k] = Some(at);
            }
        }
    }

    /// What the `k`th is nowhere greater than; 0 where nothing was looked at.
    #[must_use]
    pub fn at_most(&self, k: usize) -> f64 {
        if self.at[k].is_none() { 0.0 } else { self.found.at_most[k] }
    }

    /// The greatest value seen of the `k`th.
    #[must_use]
    pub fn reached(&self, k: usize) -> f64 {
        if self.at[k].is_none() { 0.0 } else { self.found.reached[k] }
    }
}

/// The check that a length stays within its tolerance everywhere. `what` says what leaves what; a remedy is the user's, who
/// gets a caution, or [`FAULT`], which is a stop. What could not be enclosed is a caution.
#[must_use]
pub fn within<const K: usize>(
    check: Check,
    worst: (&Enclosed<K>, usize),
    tolerance: f64,
    [es, en]: [&str; 2],
    remedy: Text,
) -> Check {
    let (enclosed, k) = worst;
    let (reached, at_most) = (enclosed.reached(k), enclosed.at_most(k));
    let check = check.at(enclosed.at[k]);
    let (off, limit) = (mm(reached), mm(tolerance));
    if at_most <= tolerance {
        check
    } else if reached > tolerance {
        let verdict = if remedy == FAULT { Verdict::Stop } else { Verdict::Caution };
        let what =
            Text::new(format!("{es} {off}; la tolerancia es {limit}"), format!("{en} {off}; the tolerance is {limit}"));
        check.found(verdict, what, remedy)
    } else {
        let most = mm(at_most);
        let what = Text::new(
            format!(
                "{es} {off} donde se ha mirado, y entre medias no se ha podido asegurar más que {most}; la tolerancia es {limit}"
            ),
            format!(
                "{en} {off} where it was looked at, and between no more than {most} could be made sure of; the tolerance is {limit}"
            ),
        );
        check.found(
            Verdict::Caution,
            what,
            Text::fixed("más arc_tolerance, u otro N", "a greater arc_tolerance, or another N"),
        )
    }
}

/// A row of the table for a length that is nowhere greater.
#[must_use]
pub fn row(key: &'static str, name: Text, program: &Program, at_most: f64, limit: f64) -> Check {
    Check::passed(key, name, program, Text::same(format!("≤ {}", mm(at_most))), Text::same(mm(limit)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::word::NumberFormat;
    use crate::machine::axis::Position;

    /// The verdict on a length that is 1 mm where it is looked at, and between up to `over`.
    fn verdict(over: f64, tolerance: f64, remedy: Text) -> Verdict {
        let mut enclosed = Enclosed::new([0.0], [tolerance], 0);
        let at = At { line: 1, n: None, point: None };
        enclosed.take(at, &[0.0, 1.0], |_| [1.0], |_, _| [over], |one, _| *one);
        let program = Program {
            key: "hole",
            title: Text::same(""),
            control: &LINUXCNC,
            format: NumberFormat::Fixed,
            block_step: None,
            start: Position::default(),
            parts: Vec::new(),
        };
        let check = row("path", Text::same(""), &program, enclosed.at_most(0), tolerance);
        within(check, (&enclosed, 0), tolerance, ["", ""], remedy).verdict
    }

    #[test]
    fn what_the_work_does_not_settle_is_not_passed() {
        assert_eq!(verdict(1.1, 1.2, FAULT), Verdict::Passed);
        assert_eq!(verdict(1.3, 1.2, FAULT), Verdict::Caution);
        assert_eq!(verdict(f64::NAN, 1.2, FAULT), Verdict::Caution);
        assert_eq!(verdict(1.1, 0.9, FAULT), Verdict::Stop);
        assert_eq!(verdict(1.1, 0.9, Text::same("a greater N")), Verdict::Caution);
    }
}
