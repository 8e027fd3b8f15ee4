//! Judging programs: what a control would do with their text, compared with the design.
//!
//! [`of`] is the whole: a program is read back from its text once, motion by motion, and every judge of its kind sees each
//! motion in turn ([`step`]), so that a program of any length takes no memory. A judge answers with [`check::Check`]s: the rows
//! of the table of the verification, and the findings of those that failed. What a kind must ask is a list of its own ([`due`]);
//! a key of it that nobody answered is a stop, so that a judge left out stops the build.
//!
//! | judge | question |
//! |---|---|
//! | [`agreement`] | does the text say what was planned, move by move |
//! | [`closure`] | does the program end where it began |
//! | [`travel`] | do the axes stay within their travel |
//! | [`turning`] | does C run on without a jump |
//! | [`rollover`] | does it make the same motions whatever the rotary axes of the machine are |
//! | [`feed`] | is no axis, and the tip, faster than it may be |
//! | [`three_axes`] | is every rapid move above the clearance plane, does the spindle turn in every cut |
//! | [`arcs`] | how well do the radii of an arc agree |
//! | [`torch`] | does the torch burn in the cut only |
//! | [`text`] | are characters, numbers and lines such as the control takes them |
//! | [`account`] | what does the program come to: it asks nothing |
//!
//! The other judges are those of the kinds: [`impeller`](crate::kinds::impeller::proof), [`branch`](crate::kinds::pipe::insert::proof),
//! [`hole`](crate::kinds::pipe::hole::proof).

pub mod account;
pub mod agreement;
pub mod arcs;
pub mod check;
pub mod closure;
pub mod due;
pub mod enclosed;
pub mod feed;
pub mod rollover;
pub mod rules;
pub mod step;
pub mod text;
pub mod three_axes;
pub mod torch;
pub mod travel;
pub mod turning;
pub mod verification;

use rayon::prelude::*;

use crate::finding::{Raise, Rule};
use crate::gcode::interpreter::{Interpreter, Setting};
use crate::gcode::program::Program;
use crate::machine::rapids::Rapids;
use crate::proof::account::Account;
use crate::proof::check::{Check, Question};
use crate::proof::due::Due;
use crate::proof::rules::NotAnswered;
use crate::proof::step::{Judge, Plan, Steps};
use crate::proof::verification::reading;
use crate::text::Text;

/// What came of one program.
#[derive(Debug)]
pub struct Judged {
    /// Every check, in the order of the judges.
    pub checks: Vec<Check>,
    /// What it comes to.
    pub account: Account,
    /// How many bytes its text takes.
    pub bytes: u64,
}

/// Reads a program back from its text and asks all judges, what is asked of every text among them. A text that the
/// interpreter refuses is asked nothing else. Each key of `due` must be answered. Of the rows of `answered` the judges speak, so
/// that the reading does not. `rapids` is how fast the machine is where it does not cut.
#[must_use]
pub fn of(
    program: &Program,
    setting: Setting,
    plan: Plan<'_>,
    judges: Vec<Box<dyn Judge + '_>>,
    due: &[Due],
    answered: &[&Rule],
    rapids: Rapids,
) -> Judged {
    let mut characters = None;
    let mut judged = rayon::in_place_scope(|scope| {
        scope.spawn(|_| characters = Some(text::read(program)));
        over(program, &mut program.read_back_with(setting), plan, judges, due, answered, rapids)
    });
    let characters = characters.unwrap_or_else(|| text::read(program));
    judged.bytes = characters.bytes();
    judged.checks.push(characters.check());
    judged
}

/// The same but for its characters.
fn over(
    program: &Program,
    text: &mut Interpreter<'_>,
    plan: Plan<'_>,
    mut judges: Vec<Box<dyn Judge + '_>>,
    due: &[Due],
    answered: &[&Rule],
    rapids: Rapids,
) -> Judged {
    let (mut steps, mut account, mut fault) = (Steps::new(plan), Account::on(rapids), None);
    let mut before = Interpreter::position(text).1;
    while let Some(motion) = text.next() {
        let motion = match motion {
            Ok(motion) => motion,
            Err(found) => {
                fault = Some(found);
                break;
            }
        };
        let step = steps.next(motion, *text.in_force());
        account.see(&step, &before);
        before = step.motion.machine;
        judges.iter_mut().for_each(|judge| judge.see(&step));
    }
    let mut checks = reading(program, text, fault.as_deref(), answered);
    if fault.is_none() {
        judges.iter_mut().for_each(|judge| judge.end(text));
        // Some of them search for long, each by itself.
        let found: Vec<Vec<Check>> = judges.into_par_iter().map(|judge| judge.checks(program)).collect();
        checks.extend(found.into_iter().flatten());
        let missing = due.iter().filter(|due| !due.is_answered(&checks)).map(|due| unanswered(program, due.key()));
        let missing: Vec<Check> = missing.collect();
        checks.extend(missing);
    }
    Judged { checks, account, bytes: 0 }
}

/// The stop for what nobody answered.
fn unanswered(program: &Program, key: &'static str) -> Check {
    let name = Text::new(format!("Comprobación pendiente: {key}"), format!("Check that is due: {key}"));
    let asked = Question::new(key, name, program).seen(1);
    asked.holds(false, |place| NotAnswered { check: key, program: program.title.clone() }.at(place))
}

#[cfg(test)]
mod tests {
    use super::{Due, Plan, Rapids, of};
    use crate::finding::Grade;
    use crate::gcode::program::{Part, Program};
    use crate::gcode::word::Word;
    use crate::proof::check::{Check, Question};
    use crate::proof::step::{Judge, Step};
    use crate::text::Text;

    /// Answers a key, having looked at so much, for information or by judging it.
    struct Answers {
        key: &'static str,
        informs: bool,
        seen: usize,
    }

    impl Judge for Answers {
        fn see(&mut self, _: &Step<'_>) {}

        fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
            let asked = Question::new(self.key, Text::same("Name"), program).seen(self.seen);
            vec![if self.informs { asked.informs() } else { asked.passes() }]
        }
    }

    /// The stops of a program of which so much is due and which so is answered: keys and codes.
    fn stops(due: &[Due], answers: Vec<Answers>) -> Vec<(&'static str, &'static str)> {
        let program = Program {
            title: Text::same("Hole"),
            parts: vec![Part::Block(vec![Word::whole('M', 2)])],
            ..Program::sample("hole")
        };
        let judges = answers.into_iter().map(|one| Box::new(one) as Box<dyn Judge>).collect();
        let judged = of(&program, program.setting(), Plan::of(&program), judges, due, &[], Rapids::default());
        let stopped = judged.checks.iter().filter(|check| check.grade() == Some(Grade::Stop));
        stopped.map(|check| (check.key(), check.finding().unwrap().rule().code)).collect()
    }

    const fn judged(key: &'static str) -> Answers {
        Answers { key, informs: false, seen: 1 }
    }

    const fn informs(key: &'static str) -> Answers {
        Answers { key, informs: true, seen: 1 }
    }

    #[test]
    fn a_check_that_is_due_and_that_no_judge_answers_is_a_stop() {
        let feed = [Due::judged("feed")];
        assert_eq!(stops(&feed, vec![judged("feed")]), []);
        assert_eq!(stops(&feed, Vec::new()), [("feed", "V0002")]);
        assert_eq!(stops(&feed, vec![judged("feeding")]), [("feed", "V0002")]);
        let both = [Due::judged("feed-axis"), Due::judged("feed-tip")];
        assert_eq!(stops(&both, vec![judged("feed-tip"), judged("feed-axis")]), []);
    }

    #[test]
    fn a_key_is_answered_by_itself_alone_and_not_by_one_that_begins_as_it_does() {
        for other in ["feed-word", "feed-axis", "fee", "feed-"] {
            assert_eq!(stops(&[Due::judged("feed")], vec![judged(other)]), [("feed", "V0002")], "{other}");
            assert_eq!(stops(&[Due::told("feed")], vec![informs(other)]), [("feed", "V0002")], "{other}");
        }
        let both = [Due::judged("feed"), Due::judged("feed-word")];
        assert_eq!(stops(&both, vec![judged("feed-word")]), [("feed", "V0002")]);
        assert_eq!(stops(&both, vec![judged("feed")]), [("feed-word", "V0002")]);
    }

    #[test]
    fn what_must_be_judged_is_not_answered_for_information() {
        assert_eq!(stops(&[Due::judged("feed")], vec![informs("feed")]), [("feed", "V0002")]);
        assert_eq!(stops(&[Due::told("feed")], vec![informs("feed")]), []);
        assert_eq!(stops(&[Due::told("feed")], vec![judged("feed")]), []);
        assert_eq!(stops(&[Due::told_where(true, "feed")], vec![informs("feed")]), []);
        assert_eq!(stops(&[Due::told_where(false, "feed")], vec![informs("feed")]), [("feed", "V0002")]);
        // Of several checks of a key, as one for each axis, one must be judged.
        assert_eq!(stops(&[Due::judged("travel")], vec![informs("travel"), judged("travel")]), []);
        // One that looked at nothing is a stop of its own.
        let nothing = Answers { seen: 0, ..judged("feed") };
        assert_eq!(stops(&[Due::judged("feed")], vec![nothing]), [("feed", "V0001")]);
    }
}
