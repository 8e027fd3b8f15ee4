//! Feed: no axis faster than F_max, and the tip over the part no faster than F.
//!
//! The speed of an axis is its way over the time of the motion (mm/min, °/min); that of the tip is its way over the
//! part over that time, an upper bound of it and not the chord ([`tip_way`](crate::machine::tip_way)): the mean over the motion,
//! which is what an F word settles. F words are rounded to the slower side; by how much that
//! slows the most is a check of its own, here and for pipes.

use crate::finding::{Figures, Limit, Raise, Size};
use crate::gcode::control::FeedLaw;
use crate::gcode::feed_word::step;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::{Program, Role};
use crate::machine::axis::Axis;
use crate::machine::rotary::TiltingTable;
use crate::machine::tip_way::Ways;
use crate::number::shown;
use crate::proof::check::{At, Check, Extreme, Question};
use crate::proof::due::Due;
use crate::proof::rules::{AxisTooFast, CutWithoutFeed, DecimalsAssumed, FeedWordSlows, TipTooFast};
use crate::proof::step::{Judge, Stage, Step};
use crate::text::{Text, t};

/// A motion that takes no longer than this, s, is over before a control begins its next block, at whatever F.
const BLINK: f64 = 0.001;
/// By what part rounding the F word may slow a motion before a person must judge it.
const SLOWER: f64 = 0.05;

/// What must be answered of a program with [`Feeds::new`]: of a design without F, that it has none; of an axis, where its
/// greatest speed is known.
#[must_use]
pub fn due(F: Option<f64>, F_max: Option<f64>) -> Vec<Due> {
    if F.is_none() {
        return vec![Due::told("feed-tip")];
    }
    vec![Due::told_where(F_max.is_none(), "feed-axis"), Due::judged("feed-tip"), Due::judged("feed-word")]
}

/// The check of what rounding the F words costs: by what part it slows a motion the most, and where. Of a design that is
/// `fed` with an F it must be seen; of one without, nothing is asked where there are no F words.
#[must_use]
pub fn feed_word(program: &Program, worst: &Extreme, fed: bool) -> Check {
    let name = t("Palabra F: pérdida máxima por redondeo", "F word: maximum loss by rounding");
    let asked = Question::new("feed-word", name, program);
    if worst.seen() == 0 && !fed {
        return asked.showing(t("sin palabra F", "no F word"), Text::same("")).informs();
    }
    let law = program.control.feed.law;
    let part = |part: f64| format!("{} %", shown(part * 100.0, 3));
    let limit = part(SLOWER);
    let (limit, assumed) = match law {
        FeedLaw::Seconds => {
            (Text::new(format!("{limit}; F a 0.0001 s, supuesto"), format!("{limit}; F to 0.0001 s, assumed")), true)
        }
        FeedLaw::Resultant | FeedLaw::InverseTime => (Text::same(limit), false),
    };
    // Both are shown in percent.
    let figures = Figures::of(worst.value() * 100.0, Some(Limit::AtMost(SLOWER * 100.0)));
    let asked = asked.showing(Text::same(part(worst.value())), limit).comparing(figures);
    let slowed = |found: &Extreme, place| {
        let (part, line) = (Size::percent(found.value() * 100.0, 3), found.line());
        FeedWordSlows { line, part, program: program.title.clone() }.at(place)
    };
    if assumed && worst.value() <= SLOWER {
        return asked.of(worst).holds(false, |place| DecimalsAssumed {}.at(place));
    }
    asked.within(worst, SLOWER, slowed)
}

/// True where the F word of a motion lets it take the time that was planned, or longer by what rounding the word takes.
#[must_use]
pub fn timely(law: FeedLaw, motion: &Motion, word: f64, planned: f64) -> bool {
    let by = motion.to.differences(&motion.from);
    let wanted = law.word(planned, by.iter().map(|by| by * by).sum::<f64>().sqrt());
    let slower = law.slower().by(word, wanted);
    (-1e-8 * wanted..=step(law, wanted) * (1.0 + 1e-6)).contains(&slower)
}

/// What the arithmetic of a control may lose.
const SLACK: f64 = 1.0 + 1e-6;

/// Watches the speed of axes and tip.
#[derive(Debug)]
pub struct Feeds {
    ways: Ways,
    F: Option<f64>,
    F_max: Option<f64>,
    axis: Extreme,
    /// The axis whose speed `axis` is.
    fastest: Axis,
    tip: Extreme,
    rounded: Extreme,
    /// The first motion that is over in a blink, whatever its word is.
    blink: Option<At>,
    without: Option<At>,
    /// Passes whose name ends so are run at this part of F.
    slower: Option<(&'static str, f64)>,
    /// What rounding the F words costs is asked, too.
    rounding: bool,
}

impl Feeds {
    /// The judge of programs on a machine with a feed at the tip, mm/min, and the greatest of an axis, mm/min and °/min.
    #[must_use]
    pub const fn new(machine: TiltingTable, F: Option<f64>, F_max: Option<f64>) -> Self {
        let nothing = Extreme::nothing();
        Self {
            ways: Ways::new(machine),
            F,
            F_max,
            axis: nothing,
            fastest: Axis::X,
            tip: nothing,
            rounded: nothing,
            blink: None,
            without: None,
            slower: None,
            rounding: true,
        }
    }

    /// The judge of programs of three axes with F along the path, mm/min, and the greatest speed of an axis, mm/min. What
    /// rounding costs is not asked: such an F word has three decimals on every control.
    #[must_use]
    pub const fn of_three_axes(F: Option<f64>, F_max: Option<f64>) -> Self {
        let mut feeds = Self::new(TiltingTable { L: 0.0 }, F, F_max);
        feeds.rounding = false;
        feeds
    }
}

impl Feeds {
    /// The same, where passes whose name ends so are run at a part of F.
    #[must_use]
    pub fn slower(self, slower: (&'static str, f64)) -> Self {
        Self { slower: Some(slower), ..self }
    }

    /// F for a motion, mm/min, or the part of it that its pass is run at; `None` where no F is given.
    fn of(&self, step: &Step<'_>) -> Option<f64> {
        let part = self.slower.filter(|(ending, _)| {
            let Stage::Planned(planned) = &step.stage else { return false };
            matches!(planned.path, Some((path, _)) if matches!(path.role, Role::Cut(name) if name.ends_with(ending)))
        });
        self.F.map(|F| F * part.map_or(1.0, |(_, part)| part))
    }
}

impl Judge for Feeds {
    fn see(&mut self, step: &Step<'_>) {
        let motion = &step.motion;
        if matches!(motion.kind, MotionKind::Rapid) || !step.at_work() {
            return;
        }
        let Some(seconds) = motion.seconds else {
            self.without.get_or_insert(At::motion(motion));
            return;
        };
        let at = At::motion(motion);
        let by = motion.to.differences(&motion.from);
        for axis in Axis::ALL {
            let before = self.axis;
            self.axis.take(by[axis as usize].abs() * 60.0 / seconds, at);
            if before.seen() == 0 || self.axis.value() > before.value() {
                self.fastest = axis;
            }
        }
        let way = self.ways.longest(&motion.from, &motion.to);
        if let Some(F) = self.of(step) {
            let greatest = by.iter().fold(0.0_f64, |most, by| most.max(by.abs()));
            let wanted = (way * 60.0 / F).max(self.F_max.map_or(0.0, |F_max| greatest * 60.0 / F_max));
            if wanted > BLINK {
                self.rounded.take(seconds / wanted - 1.0, at);
            } else {
                self.blink.get_or_insert(at);
            }
        }
        self.tip.take(way * 60.0 / seconds, at);
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let axis_name = t("Velocidad del eje más rápido", "Speed of the fastest axis");
        let tip_name = t("Avance de la punta sobre la pieza", "Feed of the tip over the part");
        let speed = |speed: f64, unit: &str| Text::same(format!("{} {unit}", shown(speed, 2)));
        let limit = |limit: Option<f64>, unit: &str| limit.map_or_else(|| Text::same(""), |limit| speed(limit, unit));
        let (axis, unit) = (self.fastest, if self.fastest.rotary() { "°/min" } else { "mm/min" });
        let none = t("sin palabra F", "no F word");
        if self.F.is_none() && self.tip.seen() == 0 && self.without.is_some() {
            // Of a design without F nothing is asked: its cuts have no F word.
            let asked = Question::new("feed-tip", tip_name, program).showing(none, Text::same(""));
            return vec![asked.at(self.without).informs()];
        }
        let without = self.without.map(|at| {
            let name = t("Movimiento de corte sin avance", "Cutting motion without feed");
            let asked = Question::new("feed", name, program).showing(none, Text::same("")).at(Some(at)).seen(1);
            asked.holds(false, |place| CutWithoutFeed { line: at.line, program: program.title.clone() }.at(place))
        });
        let value = Text::same(format!("{} {} {unit}", axis.letter(), shown(self.axis.value(), 2)));
        let by_axis = Question::new("feed-axis", axis_name, program).showing(value, limit(self.F_max, unit));
        let by_axis = match self.F_max {
            None => by_axis.of(&self.axis).informs(),
            Some(most) => by_axis.against(Limit::AtMost(most)).within(&self.axis, most * SLACK, |found, place| {
                let (speed, limit) = (Size { value: found.value(), unit, decimals: 2 }, Size::number(most, 2));
                let (axis, line, program) = (axis.letter(), found.line(), program.title.clone());
                AxisTooFast { axis, speed, line, program, limit }.at(place)
            }),
        };
        let tip = Question::new("feed-tip", tip_name, program);
        let tip = tip.showing(speed(self.tip.value(), "mm/min"), limit(self.F, "mm/min"));
        let tip = match self.F {
            // A program in which nothing cuts has nothing to be told of.
            None if self.tip.seen() == 0 => tip.passes(),
            None => tip.of(&self.tip).informs(),
            Some(most) => tip.against(Limit::AtMost(most)).within(&self.tip, most * SLACK, |found, place| {
                let (speed, limit) = (Size::feed(found.value(), 2), Size::number(most, 2));
                TipTooFast { speed, line: found.line(), program: program.title.clone(), limit }.at(place)
            }),
        };
        let mut checks: Vec<Check> = without.into_iter().chain([by_axis, tip]).collect();
        if self.rounding {
            let mut rounded = self.rounded;
            if let (0, Some(at)) = (rounded.seen(), self.blink) {
                // All are over in a blink: rounding costs nothing that a control would notice.
                rounded.take(0.0, at);
            }
            checks.push(feed_word(program, &rounded, self.F.is_some()));
        }
        checks
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finding::Grade;

    /// The answers on a program of which nothing was seen: keys, grades and codes.
    fn unseen(F: Option<f64>, F_max: Option<f64>) -> Vec<(&'static str, Option<Grade>, &'static str)> {
        let judge = Box::new(Feeds::new(TiltingTable { L: 100.0 }, F, F_max));
        let told = |check: Check| (check.key(), check.grade(), check.finding().map_or("", |one| one.rule().code));
        judge.checks(&Program::sample("blade")).into_iter().map(told).collect()
    }

    #[test]
    fn a_program_in_which_nothing_was_seen_is_stopped_whatever_its_feed() {
        let (stop, note) = (Some(Grade::Stop), Some(Grade::Note));
        let [axis, tip, word] = ["feed-axis", "feed-tip", "feed-word"];
        assert_eq!(unseen(Some(300.0), Some(3000.0)), [axis, tip, word].map(|key| (key, stop, "V0001")));
        assert_eq!(unseen(Some(300.0), None), [(axis, note, ""), (tip, stop, "V0001"), (word, stop, "V0001")]);
        assert_eq!(unseen(None, None), [(axis, note, ""), (tip, stop, "V0001"), (word, note, "")]);
    }

    #[test]
    fn a_loss_by_rounding_that_was_not_seen_is_told_of_a_design_without_feed_alone() {
        let grade = |fed| feed_word(&Program::sample("hole"), &Extreme::nothing(), fed).grade();
        assert_eq!((grade(true), grade(false)), (Some(Grade::Stop), Some(Grade::Note)));
    }

    #[test]
    fn every_answer_on_the_feed_of_a_design_that_has_one_is_due() {
        let keys = |F, F_max| due(F, F_max).iter().map(Due::key).collect::<Vec<_>>();
        assert_eq!(keys(Some(300.0), None), ["feed-axis", "feed-tip", "feed-word"]);
        assert_eq!(keys(None, Some(3000.0)), ["feed-tip"]);
    }
}
