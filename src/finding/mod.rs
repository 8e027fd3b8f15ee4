//! What rodete has to say about an input or a result: graded, placed, with the value, the limit and the remedy.

pub mod answer;
pub mod clause;
pub mod datum;
pub mod figures;
pub mod key;
pub mod rule;
pub mod rules;
#[cfg(test)]
pub mod sample;

use std::borrow::Borrow;
use std::cmp::Reverse;

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use self::clause::{Clause, OfFile};
pub use self::datum::{Bare, Datum, Said, Size, Typed};
pub use self::figures::{Figures, Limit};
pub use self::key::Key;
pub use self::rule::{AlarmFamily, Example, Raise, Rule};
use crate::text::{Language, Text, t};

/// How grave a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Grade {
    /// Worth knowing; also a check that was passed.
    Note,
    /// To be judged by a person before the program is run.
    Caution,
    /// No program is written.
    Stop,
}

impl Grade {
    /// The grade's name.
    #[must_use]
    pub const fn name(self) -> Text {
        match self {
            Self::Note => t("Nota", "Note"),
            Self::Caution => t("Precaución", "Caution"),
            Self::Stop => t("Parada", "Stop"),
        }
    }
}

/// A cell of an input workbook.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CellPlace {
    /// The sheet's name as it stands in the workbook.
    pub sheet: String,
    /// The cell's address, as `C9`.
    pub cell: String,
}

/// Where a finding belongs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Place {
    /// The file as a whole.
    File,
    /// A part of the file's package, as `xl/worksheets/sheet1.xml`.
    Part(String),
    /// A sheet of the workbook.
    Sheet(String),
    /// Cells of the workbook.
    Cells(Vec<CellPlace>),
    /// Parameters by key; the schema turns them into [`Place::Cells`] with [`crate::parameter::Values::locate`].
    Parameters(Vec<Key>),
    /// A row of a result table.
    Point {
        /// The table's key.
        table: &'static str,
        /// The point index i.
        index: usize,
    },
    /// A block of a program.
    Block {
        /// The program's key, as `blade`.
        program: &'static str,
        /// The line in the program's text, counted from 1.
        line: usize,
    },
    /// A line of a subprogram that stands in a file of its own.
    Subprogram {
        /// The file's name without its ending, as `O0005`.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The columns in it, as for [`Place::Line`].
        columns: Vec<usize>,
    },
    /// A file that was named beside a program: a parameter file or a tool table.
    Beside {
        /// The file's path as it was given.
        file: String,
        /// The line, counted from 1; none where the file as a whole is meant.
        line: Option<usize>,
        /// The columns in it, as for [`Place::Line`].
        columns: Vec<usize>,
    },
    /// A line of a program file that was read.
    Line {
        /// The line, counted from 1.
        line: usize,
        /// The columns in it, counted from 1 in characters; none where the line as a whole is meant.
        columns: Vec<usize>,
    },
}

/// The remedy where only rodete itself can be wrong: of the rows that say `remedy fault` and no more.
pub const FAULT: Text = t("es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it");

/// One thing found: a row with its values at a place. It comes of [`Raise::at`], and of nothing else.
#[derive(Clone, Debug)]
pub struct Finding {
    rule: &'static Rule,
    /// What it carries, by name, unrounded.
    pub data: Vec<(&'static str, Datum)>,
    /// The alarm that it is for the control, or among rodete's own of the lathe; none where it has no number.
    pub alarm: Option<(AlarmFamily, u16)>,
    /// How grave it is.
    pub grade: Grade,
    /// What was found, as a sentence without a full stop.
    pub what: Text,
    /// Where it was found.
    pub place: Place,
    /// The value found, with its unit; empty where there is none.
    pub value: String,
    /// The limit it was compared with, with its unit; empty where there is none.
    pub limit: String,
    /// The numbers of value and limit.
    figures: Figures,
    /// Value and limit in both languages, where they are words; the fields above have them in English, as JSON has.
    words: Option<Box<[Text; 2]>>,
    /// What to do about it; empty for a passed check.
    pub remedy: Text,
    /// How often it was found.
    times: u64,
    /// True where the value says how often it was found, as `12 ×`.
    counted: bool,
}

impl PartialEq for Finding {
    /// Two are the same by their row, what they carry and their place; their sentences follow from these.
    fn eq(&self, other: &Self) -> bool {
        self.rule == other.rule
            && self.data == other.data
            && self.place == other.place
            && (self.grade, self.alarm, self.times) == (other.grade, other.alarm, other.times)
            && (&self.value, &self.limit) == (&other.value, &other.limit)
    }
}

impl Finding {
    /// What a row has said, at a place: as grave as the row, without alarm, value and limit.
    pub(crate) const fn of(
        rule: &'static Rule,
        data: Vec<(&'static str, Datum)>,
        place: Place,
        what: Text,
        remedy: Text,
    ) -> Self {
        Self {
            rule,
            data,
            alarm: None,
            grade: rule.grade,
            what,
            place,
            value: String::new(),
            limit: String::new(),
            figures: Figures::NONE,
            words: None,
            remedy,
            times: 1,
            counted: false,
        }
    }

    /// The row that it is of.
    #[must_use]
    pub const fn rule(&self) -> &'static Rule {
        self.rule
    }

    /// True for a stop for which only code can be to blame, rodete's or that of a kind: the command ends with
    /// [`Exit::Fault`].
    #[must_use]
    pub fn is_fault(&self) -> bool {
        self.grade == Grade::Stop && self.rule.fault
    }

    /// True for a finding of a row.
    #[must_use]
    pub fn is(&self, rule: &Rule) -> bool {
        self.rule == rule
    }

    /// The code by which `rodete explain` knows it.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        self.rule.code
    }

    /// The same at another place.
    #[must_use]
    pub fn placed(self, place: Place) -> Self {
        Self { place, ..self }
    }

    /// The same in a file that was named beside a program, where it is of a line of it or of the file as a whole.
    #[must_use]
    pub fn beside(self, file: &str) -> Self {
        let (line, columns) = match &self.place {
            Place::File => (None, Vec::new()),
            Place::Line { line, columns } => (Some(*line), columns.clone()),
            _ => return self,
        };
        self.placed(Place::Beside { file: file.to_owned(), line, columns })
    }

    /// The same as grave as a site has it: a row says the gravest.
    #[must_use]
    pub fn graded(self, grade: Grade) -> Self {
        Self { grade, ..self }
    }

    /// How often it was found.
    #[must_use]
    pub const fn count(&self) -> u64 {
        self.times
    }

    /// How often it was found, where that is its value.
    #[must_use]
    pub const fn counted(&self) -> Option<u64> {
        if self.counted { Some(self.times) } else { None }
    }

    /// The same, found so often, which is its value.
    #[must_use]
    pub fn repeated(self, times: u64) -> Self {
        Self { times, counted: true, ..self.with(format!("{times} ×"), "") }
    }

    /// True where the row and all that it carries would be told alike, whatever the place: no number differs by what its last
    /// decimal shows.
    #[must_use]
    pub fn alike(&self, other: &Self) -> bool {
        let same = |(one, other): (&(&str, Datum), &(&str, Datum))| one.0 == other.0 && one.1.alike(&other.1);
        self.rule == other.rule
            && self.data.len() == other.data.len()
            && self.data.iter().zip(&other.data).all(same)
            && self.value == other.value
    }

    /// The same with a clause before or behind its sentence, and what that carries.
    #[must_use]
    pub fn with_clause(mut self, clause: &dyn Clause) -> Self {
        self.what = clause.said(&self.what, self.alarm, &self.value);
        self.data.extend(clause.carries());
        self
    }

    /// The same, found so often.
    #[must_use]
    pub fn found(self, times: u64) -> Self {
        Self { times, ..self }
    }

    /// The finding with the name of the file that it is of before its sentence, where the sentence does not say it.
    #[must_use]
    pub fn of_file(self, name: &str) -> Self {
        if self.what.en.contains(name) { self } else { self.with_clause(&OfFile { file: name.to_owned() }) }
    }

    /// The same where they are words in two languages.
    #[must_use]
    pub fn worded(self, value: &Text, limit: &Text) -> Self {
        let alike = value.es == value.en && limit.es == limit.en;
        let words = (!alike).then(|| Box::new([value.clone(), limit.clone()]));
        Self { words, ..self.with(value.en.as_ref(), limit.en.as_ref()) }
    }

    /// Value and limit as a person reads them.
    #[must_use]
    pub fn shown(&self, language: Language) -> [&str; 2] {
        match &self.words {
            Some(words) => words.each_ref().map(|text| text.get(language)),
            None => [&self.value, &self.limit],
        }
    }

    /// The finding with the value found and the limit it was compared with.
    #[must_use]
    pub fn with(mut self, value: impl Into<String>, limit: impl Into<String>) -> Self {
        self.value = value.into();
        self.limit = limit.into();
        self.figures = Figures::NONE;
        self.words = None;
        self.counted = false;
        self
    }

    /// The finding with the numbers of its value and its limit.
    #[must_use]
    pub fn comparing(self, figures: Figures) -> Self {
        Self { figures, ..self }
    }

    /// The same of one value and its limit, in the unit that they are printed with.
    #[must_use]
    pub fn measuring(self, value: f64, limit: Limit) -> Self {
        self.comparing(Figures::of(value, Some(limit)))
    }

    /// The numbers of its value and its limit, unrounded.
    #[must_use]
    pub const fn figures(&self) -> Figures {
        self.figures
    }
}

/// Puts findings in the order in which they are told: the gravest first, those of one grade as they were.
pub fn gravest_first(findings: &mut [impl Borrow<Finding>]) {
    findings.sort_by_key(|finding| Reverse(finding.borrow().grade));
}

impl Serialize for Finding {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut finding = serializer.serialize_struct("Finding", 11)?;
        finding.serialize_field("code", self.rule.code)?;
        finding.serialize_field("name", &self.rule.name())?;
        finding.serialize_field("grade", &self.grade)?;
        finding.serialize_field("what", &self.what)?;
        finding.serialize_field("place", &self.place)?;
        finding.serialize_field("value", &self.value)?;
        finding.serialize_field("limit", &self.limit)?;
        finding.serialize_field("remedy", &self.remedy)?;
        finding.serialize_field("count", &self.count())?;
        finding.serialize_field("data", &DataByName(&self.data))?;
        finding.serialize_field("alarm", &self.alarm.map(|(family, number)| family.shown(number)))?;
        finding.end()
    }
}

/// Values by name, as one object.
struct DataByName<'a>(&'a [(&'static str, Datum)]);

impl Serialize for DataByName<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, datum)| (name, datum)))
    }
}

/// How a command ends: the process exit codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[repr(u8)]
pub enum Exit {
    /// All that was asked for was done.
    Done = 0,
    /// A fault in rodete itself.
    Fault = 1,
    /// Wrong command line.
    CommandLine = 2,
    /// The input was read and is refused.
    Refused = 3,
    /// The input cannot be read.
    Unreadable = 4,
    /// The output cannot be written.
    Unwritable = 5,
    /// The report failed; sheets and programs are delivered.
    ReportFailed = 6,
    /// A limit was reached.
    Limit = 7,
    /// Parts that are needed are not there yet.
    Incomplete = 9,
    /// Interrupted by the user.
    Interrupted = 130,
}

/// Why nothing was made: the exit code and every finding.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Refusal {
    /// With what exit code the command ends.
    pub exit: Exit,
    /// All findings; at least one of them is a [`Grade::Stop`].
    pub findings: Vec<Finding>,
}

impl Refusal {
    /// A refusal for one reason.
    #[must_use]
    pub fn new(exit: Exit, finding: Finding) -> Self {
        Self { exit, findings: vec![finding] }
    }

    /// What was found first, as the reason in another sentence.
    #[must_use]
    pub fn reason(&self) -> Text {
        self.findings.first().map_or(t("", ""), |finding| finding.what.clone())
    }
}
