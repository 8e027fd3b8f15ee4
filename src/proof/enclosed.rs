//! What a judge has enclosed over the motions of a program: between the looks too, so that a pass is one of every place.

use crate::finding::{Finding, Grade, Limit, Place, Raise, Said, Size};
use crate::number::bound::Enclosure;
use crate::proof::check::{At, Check, Question, mm, up};
use crate::proof::rules::{NotEnclosed, OffByN, OffTolerance};
use crate::text::{Language, Text, t};

/// The greatest values of K questions, with where they were found.
#[derive(Clone, Copy, Debug)]
pub struct Enclosed<const K: usize> {
    found: Enclosure<K>,
    at: [Option<At>; K],
    /// How many motions were taken in.
    seen: usize,
}

/// What a length may be, mm, and how a sentence behind it says what that is made of.
#[derive(Clone, Debug)]
pub struct Tolerance {
    /// What it may be.
    pub limit: f64,
    of: Text,
}

impl Tolerance {
    /// A limit of which a part is typed as the symbol `arc_tolerance`, both in mm; `rest` says what the rest is for. Nothing is said of a
    /// rest that rounds to 0.
    #[must_use]
    pub fn of_arcs(typed: f64, limit: f64, rest: &Text) -> Self {
        let shown = |language, value| Size::length(value, 4).said(language).into_owned();
        let told = |language, and: &str| {
            let [typed, added] = [typed, limit - typed].map(|value| shown(language, value));
            format!(" (arc_tolerance {typed} {and} {added} {})", rest.get(language))
        };
        let of = if limit - typed < 5e-5 {
            Text::same("")
        } else {
            Text::new(told(Language::Es, "y"), told(Language::En, "and"))
        };
        Self { limit, of }
    }
}

/// Whose it is to mend what leaves its tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// The user's, with a greater N.
    GreaterN {
        /// One that will do, where one is known.
        enough: Option<u32>,
        /// How grave it is until then.
        grade: Grade,
    },
    /// rodete's own: a stop.
    Fault,
}

impl<const K: usize> Enclosed<K> {
    /// Of no motion yet; see [`Enclosure::new`].
    #[must_use]
    pub const fn new(fine: [f64; K], limit: [f64; K], looks: u32) -> Self {
        Self { found: Enclosure::new(fine, limit, looks), at: [None; K], seen: 0 }
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
        self.seen += usize::from(!looks.is_empty());
        for k in 0..K {
            if self.found.reached[k] > before.reached[k] || self.at[k].is_none() {
                self.at[k] = Some(at);
            }
        }
    }

    /// What the `k`th is nowhere greater than; 0 where nothing was looked at.
    #[must_use]
    pub fn at_most(&self, k: usize) -> f64 {
        if self.seen == 0 { 0.0 } else { self.found.at_most[k] }
    }

    /// The greatest value seen of the `k`th; 0 where nothing was looked at.
    #[must_use]
    pub fn reached(&self, k: usize) -> f64 {
        if self.seen == 0 { 0.0 } else { self.found.reached[k] }
    }

    /// Where the `k`th was seen; `None` where nothing was looked at.
    #[must_use]
    pub const fn at(&self, k: usize) -> Option<At> {
        self.at[k]
    }

    /// The question with where the `k`th was found, and how many motions were looked at.
    pub fn put(&self, asked: Question, k: usize) -> Question {
        asked.at(self.at[k]).seen(self.seen)
    }

    /// The check that the `k`th length stays within its tolerance everywhere. `what` says what leaves what. What could not be
    /// enclosed is a caution.
    #[must_use]
    pub fn within(&self, asked: Question, k: usize, tolerance: &Tolerance, what: Text, remedy: Remedy) -> Check {
        let (reached, at_most) = (self.reached(k), self.at_most(k));
        let asked = self.put(asked, k).measuring(at_most).against(Limit::AtMost(tolerance.limit));
        asked.holds(at_most <= tolerance.limit, |place| beyond(reached, at_most, tolerance, what, remedy, place))
    }
}

/// What is said of a length beyond its tolerance, or not known to be within.
fn beyond(reached: f64, at_most: f64, tolerance: &Tolerance, what: Text, remedy: Remedy, place: Place) -> Finding {
    let (off, limit, of) = (Size::length(reached, 4), Size::length(tolerance.limit, 4), tolerance.of.clone());
    match remedy {
        _ if reached.is_nan() || reached <= tolerance.limit => {
            NotEnclosed { what, off, most: Size::length(at_most, 4), limit }.at(place)
        }
        Remedy::GreaterN { enough, grade } => {
            let N = enough
                .map_or(t("un N mayor o una arc_tolerance mayor", "a larger N or a larger arc_tolerance"), |N| {
                    Text::same(format!("N = {N}"))
                });
            OffByN { what, off, limit, of, N }.at(place).graded(grade)
        }
        Remedy::Fault => OffTolerance { what, off, limit, of }.at(place),
    }
}

/// A length that is nowhere greater, rounded up, and its limit.
#[must_use]
pub fn bound(at_most: f64, limit: f64) -> [Text; 2] {
    [Text::same(format!("≤ {}", mm(up(at_most)))), Text::same(mm(limit))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::program::Program;

    /// The answer on a length that is 1 mm where it is looked at, and between up to `over`.
    fn grade(over: f64, tolerance: f64, remedy: Remedy) -> Option<Grade> {
        let mut enclosed = Enclosed::new([0.0], [tolerance], 0);
        enclosed.take(At::line(1), &[0.0, 1.0], |_| [1.0], |_, _| [over], |one, _| *one);
        let program = Program::sample("hole");
        let [value, limit] = bound(enclosed.at_most(0), tolerance);
        let asked = Question::new("path", Text::same(""), &program).showing(value, limit);
        let tolerance = Tolerance::of_arcs(tolerance, tolerance, &Text::same(""));
        enclosed.within(asked, 0, &tolerance, Text::same(""), remedy).grade()
    }

    #[test]
    fn what_the_work_does_not_settle_is_not_passed() {
        assert_eq!(grade(1.1, 1.2, Remedy::Fault), None);
        assert_eq!(grade(1.3, 1.2, Remedy::Fault), Some(Grade::Caution));
        assert_eq!(grade(f64::NAN, 1.2, Remedy::Fault), Some(Grade::Caution));
        assert_eq!(grade(1.1, 0.9, Remedy::Fault), Some(Grade::Stop));
        assert_eq!(grade(1.1, 0.9, Remedy::GreaterN { enough: None, grade: Grade::Caution }), Some(Grade::Caution));
    }

    #[test]
    fn a_tolerance_tells_what_is_typed_and_what_the_rest_is_for() {
        let rest = t("por el redondeo", "for the rounding");
        let told = Tolerance::of_arcs(0.02, 0.022, &rest).of;
        assert_eq!(told.en, " (arc_tolerance 0.02 mm and 0.002 mm for the rounding)");
        assert_eq!(told.es, " (arc_tolerance 0.02 mm y 0.002 mm por el redondeo)");
        assert_eq!(Tolerance::of_arcs(0.02, 0.020_001, &rest).of.en, "");
    }

    #[test]
    fn a_bound_that_is_told_is_rounded_up() {
        let [value, limit] = bound(0.050_01, 0.05);
        assert_eq!((value.en.as_ref(), limit.en.as_ref()), ("≤ 0.0501 mm", "0.05 mm"));
    }
}
