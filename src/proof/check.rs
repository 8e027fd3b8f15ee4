//! A question put to one program, and the check that it becomes once it is answered.
//!
//! A [`Question`] is no check until it is answered, and one for which nothing was looked at is answered with a stop whatever
//! was measured: silence passes nothing. What is not asked at all, or has nothing to be compared with, says so with
//! [`Question::informs`].

use crate::finding::{Figures, Finding, Grade, Key, Limit, Place, Raise};
use crate::gcode::motion::Motion;
use crate::gcode::program::Program;
use crate::number::shown;
use crate::proof::rules::NothingSeen;
use crate::text::{Text, t};

/// Where in a program something is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct At {
    /// The line of the text, counted from 1.
    pub line: usize,
    /// The block number.
    pub n: Option<u32>,
    /// What the program follows there, and the point index along it, continued between the points.
    pub along: Option<(&'static Text, f64)>,
}

impl At {
    /// A line of the text, counted from 1, without a block number.
    #[must_use]
    pub const fn line(line: usize) -> Self {
        Self { line, n: None, along: None }
    }

    /// Line and block number of the block that a motion comes from.
    #[must_use]
    pub const fn motion(motion: &Motion) -> Self {
        Self { line: motion.line, n: motion.n, along: None }
    }

    /// The place as findings say it: line, block number, and the point along what is followed.
    #[must_use]
    pub fn words(&self) -> Text {
        let block = self.n.map(|n| format!(" (N{n})")).unwrap_or_default();
        let (mut es, mut en) = (format!("línea {}{block}", self.line), format!("line {}{block}", self.line));
        if let Some((name, x)) = self.along {
            let x = shown(x, 2);
            es.push_str(&format!(", {}, punto {x}", name.es));
            en.push_str(&format!(", {}, point {x}", name.en));
        }
        Text::new(es, en)
    }
}

/// The greatest of what was measured, where it was first found, and of how much.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extreme {
    value: f64,
    at: Option<At>,
    seen: usize,
}

impl Extreme {
    /// Nothing measured yet: the value is 0.
    #[must_use]
    pub const fn nothing() -> Self {
        Self { value: 0.0, at: None, seen: 0 }
    }

    /// Takes a value in. One that is no number is beyond every limit, and stays.
    pub fn take(&mut self, value: f64, at: impl Into<Option<At>>) {
        if self.seen == 0 || value > self.value || (value.is_nan() && !self.value.is_nan()) {
            (self.value, self.at) = (value, at.into());
        }
        self.seen += 1;
    }

    /// The greatest value; 0 where nothing was measured.
    #[must_use]
    pub const fn value(&self) -> f64 {
        self.value
    }

    /// Where the greatest value was first found; `None` where nothing was measured, or it belongs to the program as a
    /// whole.
    #[must_use]
    pub const fn at(&self) -> Option<At> {
        self.at
    }

    /// The line of the text where it is; 1 where it belongs to the program as a whole.
    #[must_use]
    pub fn line(&self) -> usize {
        self.at.map_or(1, |at| at.line)
    }

    /// How much was measured.
    #[must_use]
    pub const fn seen(&self) -> usize {
        self.seen
    }
}

/// How a question was answered.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "some twenty a program")]
pub enum Answer {
    /// Within its limit.
    Passed,
    /// Worth knowing: it is no test, and nothing is compared with its value.
    Informs,
    /// Something is to be said of it.
    Found(Finding),
}

/// A question to a program that is not yet answered.
#[derive(Clone, Debug)]
#[must_use = "a question is to be answered"]
pub struct Question {
    key: &'static str,
    name: Text,
    program: &'static str,
    title: Text,
    value: Text,
    limit: Text,
    at: Option<At>,
    parameters: Option<Vec<Key>>,
    seen: usize,
    measured: Option<f64>,
    figures: Figures,
}

const NOTHING: Text = t("", "");

impl Question {
    /// A question by its key, as `closure`, and what is asked.
    pub fn new(key: &'static str, name: Text, program: &Program) -> Self {
        let title = program.title.clone();
        let (value, limit) = (NOTHING, NOTHING);
        Self {
            key,
            name,
            program: program.key,
            title,
            value,
            limit,
            at: None,
            parameters: None,
            seen: 0,
            measured: None,
            figures: Figures::NONE,
        }
    }

    /// The question with the value found and its limit, both with their units; an empty limit where there is none.
    pub fn showing(mut self, value: Text, limit: Text) -> Self {
        (self.value, self.limit) = (value, limit);
        self
    }

    /// The question with the place where its value was found.
    pub fn at(mut self, at: Option<At>) -> Self {
        self.at = at;
        self
    }

    /// The question with parameters as the place of what is found.
    pub fn of_parameters(mut self, keys: impl IntoIterator<Item = Key>) -> Self {
        self.parameters = Some(keys.into_iter().collect());
        self
    }

    /// The question with how much was looked at for it.
    pub const fn seen(mut self, seen: usize) -> Self {
        self.seen = seen;
        self
    }

    /// The question with place, number and value of what was measured.
    pub const fn of(mut self, measured: &Extreme) -> Self {
        (self.at, self.seen) = (measured.at, measured.seen);
        self.measuring(measured.value)
    }

    /// The question with the number that was measured for it, in the unit of its value.
    pub const fn measuring(mut self, value: f64) -> Self {
        self.measured = Some(value);
        self
    }

    /// The question with the number of its limit, in the unit of its value.
    pub const fn against(mut self, limit: Limit) -> Self {
        self.figures.limit = Some(limit);
        self
    }

    /// The question with the numbers of its value and its limit, where the value shown is another than what is measured.
    pub const fn comparing(mut self, figures: Figures) -> Self {
        self.figures = figures;
        self
    }

    /// What a finding of it carries: what is shown, or else what was measured.
    fn compared(&self) -> Figures {
        Figures { found: self.figures.found.or_else(|| self.measured.map(|value| [value; 2])), ..self.figures }
    }

    /// Held against a limit: passed where what was measured is not beyond it.
    #[must_use]
    pub fn within(self, measured: &Extreme, limit: f64, otherwise: impl FnOnce(&Extreme, Place) -> Finding) -> Check {
        let shown = self.figures.limit.unwrap_or(Limit::AtMost(limit));
        self.against(shown).of(measured).holds(measured.value <= limit, |place| otherwise(measured, place))
    }

    /// Held against what must be so; `otherwise` says what is found at a place.
    #[must_use]
    pub fn holds(self, yes: bool, otherwise: impl FnOnce(Place) -> Finding) -> Check {
        self.unless((!yes).then_some(otherwise))
    }

    /// Passed unless there is something to be said of it, at a place.
    #[must_use]
    pub fn unless(self, found: Option<impl FnOnce(Place) -> Finding>) -> Check {
        let line = self.at.map_or(1, |at| at.line);
        let place = self.parameters.clone().map_or(Place::Block { program: self.program, line }, Place::Parameters);
        let found = if self.seen == 0 {
            let (check, program) = (self.name.clone(), self.title.clone());
            NothingSeen { check, program }.at(Place::Block { program: self.program, line })
        } else {
            match found {
                None => return Check { asked: self, answer: Answer::Passed },
                Some(found) => found(place),
            }
        };
        let figures = if self.seen == 0 { Figures::NONE } else { self.compared() };
        let found = found.worded(&self.value, &self.limit).comparing(figures);
        Check { asked: self, answer: Answer::Found(found) }
    }

    /// Passed: it was decided on the way.
    #[must_use]
    pub fn passes(self) -> Check {
        self.unless(None::<fn(Place) -> Finding>)
    }

    /// Answered as what is no test: it is for information, or there is nothing to be asked.
    #[must_use]
    pub const fn informs(self) -> Check {
        Check { asked: self, answer: Answer::Informs }
    }
}

/// A question with its answer.
#[derive(Clone, Debug)]
pub struct Check {
    asked: Question,
    answer: Answer,
}

impl Check {
    /// Its name in code, as `closure`.
    #[must_use]
    pub const fn key(&self) -> &'static str {
        self.asked.key
    }

    /// What is asked.
    #[must_use]
    pub const fn name(&self) -> &Text {
        &self.asked.name
    }

    /// The program's key.
    #[must_use]
    pub const fn program(&self) -> &'static str {
        self.asked.program
    }

    /// The value found, with its unit.
    #[must_use]
    pub const fn value(&self) -> &Text {
        &self.asked.value
    }

    /// The limit, with its unit; empty where there is none.
    #[must_use]
    pub const fn limit(&self) -> &Text {
        &self.asked.limit
    }

    /// Where the value was found; `None` where it belongs to the program as a whole.
    #[must_use]
    pub const fn at(&self) -> Option<At> {
        self.asked.at
    }

    /// The number that was measured for it; `None` where it is not one number, or nothing was looked at.
    #[must_use]
    pub const fn measured(&self) -> Option<f64> {
        if self.asked.seen == 0 { None } else { self.asked.measured }
    }

    /// How it was answered.
    #[must_use]
    pub const fn answer(&self) -> &Answer {
        &self.answer
    }

    /// How grave the answer is; `None` where it was passed.
    #[must_use]
    pub const fn grade(&self) -> Option<Grade> {
        match &self.answer {
            Answer::Passed => None,
            Answer::Informs => Some(Grade::Note),
            Answer::Found(found) => Some(found.grade),
        }
    }

    /// The answer in the table of checks: passed, or the name of its grade.
    #[must_use]
    pub fn word(&self) -> Text {
        self.grade().map_or(t("Cumple", "Passed"), Grade::name)
    }

    /// The same where what there is to say has nothing to do with value and limit of the row.
    #[must_use]
    pub fn apart(self) -> Self {
        match self.answer {
            Answer::Found(found) => Self { answer: Answer::Found(found.with("", "")), ..self },
            _ => self,
        }
    }

    /// What there is to say of it beside its row in the table.
    #[must_use]
    pub const fn finding(&self) -> Option<&Finding> {
        match &self.answer {
            Answer::Found(found) => Some(found),
            Answer::Passed | Answer::Informs => None,
        }
    }
}

/// A length with its unit, to a tenth of a micrometre.
#[must_use]
pub fn mm(value: f64) -> String {
    format!("{} mm", shown(value, 4))
}

/// A length rounded up to a tenth of a micrometre.
#[must_use]
pub fn up(value: f64) -> f64 {
    // What is on the grid but for the arithmetic stays there.
    (value * 1e4 - 1e-6).ceil() / 1e4
}

/// A length that lies between two bounds, the lower one rounded down and the upper one up to a tenth of a micrometre.
#[must_use]
pub fn bounded(lower: f64, upper: f64) -> Text {
    let (low, high) = (shown(-up(-lower), 4), mm(up(upper)));
    Text::new(format!("comprendida entre {low} y {high}"), format!("bounded between {low} and {high}"))
}

#[cfg(test)]
mod tests {
    use super::{At, Extreme, Question};
    use crate::finding::sample::Cautioned;
    use crate::finding::{Finding, Grade, Place, Raise};
    use crate::gcode::program::Program;
    use crate::text::Text;

    fn question() -> Question {
        let program = Program { title: Text::same("Hole"), ..Program::sample("hole") };
        Question::new("path", Text::same("Path"), &program)
    }

    fn beyond(_: &Extreme, place: Place) -> Finding {
        Cautioned { what: Text::same("beyond"), todo: Text::same("less") }.at(place)
    }

    #[test]
    fn a_question_for_which_nothing_was_looked_at_is_answered_with_a_stop() {
        let check = question().within(&Extreme::default(), 1.0, beyond);
        let found = check.finding().expect("a finding");
        assert_eq!((found.grade, found.rule().code), (Grade::Stop, "V0001"));
        assert_eq!(question().holds(true, |_| unreachable!()).grade(), Some(Grade::Stop));
        assert_eq!(question().informs().grade(), Some(Grade::Note));
        assert!(question().informs().finding().is_none());
    }

    #[test]
    fn what_is_measured_is_held_against_its_limit_once_and_no_number_passes_none() {
        let grade = |values: &[f64], limit: f64| {
            let mut most = Extreme::default();
            values.iter().zip(1..).for_each(|(value, line)| most.take(*value, At::line(line)));
            question().within(&most, limit, beyond).grade()
        };
        assert_eq!(grade(&[1.0, 3.0, 2.0], 3.0), None);
        assert_eq!(grade(&[1.0, 3.0, 2.0], 2.9), Some(Grade::Caution));
        assert_eq!(grade(&[1.0, f64::NAN, 2.0], 3.0), Some(Grade::Caution));
        let mut most = Extreme::default();
        [2.0, 5.0, 5.0].into_iter().zip(4..).for_each(|(value, line)| most.take(value, At::line(line)));
        assert_eq!((most.value(), most.line(), most.seen()), (5.0, 5, 3));
    }
}
