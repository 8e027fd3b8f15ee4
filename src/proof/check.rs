//! A check: one question put to one program, with its answer.

pub use crate::finding::FAULT;
use crate::finding::{Finding, Grade, Place};
use crate::gcode::motion::Motion;
use crate::gcode::program::Program;
use crate::number::shown;
use crate::proof::track::Track;
use crate::text::Text;

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Within its limit.
    Passed,
    /// Worth knowing; nothing is held against it.
    Note,
    /// To be judged by a person.
    Caution,
    /// No program may be written.
    Stop,
}

impl Verdict {
    /// The verdict in a word.
    #[must_use]
    pub const fn name(self) -> Text {
        match self {
            Self::Passed => Text::fixed("Cumple", "Passed"),
            Self::Note => Grade::Note.name(),
            Self::Caution => Grade::Caution.name(),
            Self::Stop => Grade::Stop.name(),
        }
    }
}

/// Where in a program something is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct At {
    /// The line of the text, counted from 1.
    pub line: usize,
    /// The block number.
    pub n: Option<u32>,
    /// The track and the point index along it, continued between the points.
    pub point: Option<(Track, f64)>,
}

impl At {
    /// Where a motion is.
    #[must_use]
    pub const fn motion(motion: &Motion) -> Self {
        Self { line: motion.line, n: motion.n, point: None }
    }

    /// The place in words.
    #[must_use]
    pub fn words(&self) -> Text {
        let block = self.n.map(|n| format!(" (N{n})")).unwrap_or_default();
        let (mut es, mut en) = (format!("línea {}{block}", self.line), format!("line {}{block}", self.line));
        if let Some((track, x)) = self.point {
            let (name, x) = (track.name(), shown(x, 2));
            es.push_str(&format!(", {}, punto {x}", name.es));
            en.push_str(&format!(", {}, point {x}", name.en));
        }
        Text::new(es, en)
    }
}

/// A check with its answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Its name in code, as `closure`.
    pub key: &'static str,
    /// What is asked.
    pub name: Text,
    /// The program's key.
    pub program: &'static str,
    /// The value found, with its unit.
    pub value: Text,
    /// The limit, with its unit; empty where there is none.
    pub limit: Text,
    /// Where the value was found; `None` where it belongs to the program as a whole.
    pub at: Option<At>,
    /// How it ended.
    pub verdict: Verdict,
    /// What was found, as a sentence; empty where the row of the table says it all.
    what: Text,
    remedy: Text,
    place: Place,
}

const NOTHING: Text = Text::fixed("", "");

impl Check {
    /// A check that was passed.
    #[must_use]
    pub fn passed(key: &'static str, name: Text, program: &Program, value: Text, limit: Text) -> Self {
        Self {
            key,
            name,
            program: program.key,
            value,
            limit,
            at: None,
            verdict: Verdict::Passed,
            what: NOTHING,
            remedy: NOTHING,
            place: Place::Block { program: program.key, line: 1 },
        }
    }

    /// The check with the place where its value was found.
    #[must_use]
    pub fn at(mut self, at: Option<At>) -> Self {
        if let (Some(at), Place::Block { line, .. }) = (at, &mut self.place) {
            *line = at.line;
        }
        self.at = at;
        self
    }

    /// The check as one that was not passed: what was found and what to do about it.
    #[must_use]
    pub fn found(mut self, verdict: Verdict, what: Text, remedy: Text) -> Self {
        (self.verdict, self.what, self.remedy) = (verdict, what, remedy);
        self
    }

    /// The check as one that is for information: nothing is held against its value.
    #[must_use]
    pub fn informing(mut self) -> Self {
        self.verdict = Verdict::Note;
        self
    }

    /// The check with parameters as the place of its finding.
    #[must_use]
    pub fn of_parameters(mut self, keys: Vec<&'static str>) -> Self {
        self.place = Place::Parameters(keys);
        self
    }

    /// What there is to say of it beside its row in the table.
    #[must_use]
    pub fn finding(&self) -> Option<Finding> {
        let grade = match self.verdict {
            Verdict::Passed => return None,
            Verdict::Note => Grade::Note,
            Verdict::Caution => Grade::Caution,
            Verdict::Stop => Grade::Stop,
        };
        if self.what.is_empty() {
            return None;
        }
        let finding = Finding::new(grade, self.place.clone(), self.what.clone(), self.remedy.clone());
        Some(finding.with(self.value.en.as_ref(), self.limit.en.as_ref()))
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
    Text::new(format!("acotada entre {low} y {high}"), format!("bounded between {low} and {high}"))
}
