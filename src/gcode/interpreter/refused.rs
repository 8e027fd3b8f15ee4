//! What the interpreter refuses.

use crate::finding::clause::{AlarmOfControl, Clause};
use crate::finding::{AlarmFamily, Datum, Exit, Finding, Grade, Place, Raise, Rule};
use crate::gcode::turning::trouble::Trouble;
use crate::text::{Text, t};

/// A refusal with its place. The block is not executed.
#[derive(Clone, Debug, PartialEq)]
pub struct Refused {
    /// [`Exit::Refused`], or [`Exit::Limit`] where a budget ended.
    pub exit: Exit,
    /// The file of a subprogram that stands in a file of its own.
    pub file: Option<String>,
    /// The line, counted from 1.
    pub line: usize,
    /// The columns, counted from 1.
    pub columns: Vec<usize>,
    /// Other lines of one file that are at fault with it, which `what` does not name: the file as in `file`, and the line,
    /// counted from 1.
    pub others: Vec<(Option<String>, usize)>,
    /// The row that it is of.
    pub rule: &'static Rule,
    /// What it carries, by name, unrounded.
    pub data: Vec<(&'static str, Datum)>,
    /// The alarm that it is for the control.
    pub alarm: Option<(AlarmFamily, u16)>,
    /// What is wrong.
    pub what: Text,
    /// What to do about it.
    pub remedy: Text,
    /// True where nothing can be read after it.
    pub fatal: bool,
    /// True where the motions of a turning cycle are not made because of it: what comes after it meets another part than
    /// the program counts on.
    pub uncut: bool,
    /// Parts of what is in force that it hangs on: where one is in doubt behind a refused block, it follows from that.
    pub(super) hangs: u32,
}

impl Refused {
    /// What a row says, at no place yet.
    fn new(rule: &'static Rule, data: Vec<(&'static str, Datum)>, what: Text, remedy: Text) -> Self {
        Self {
            exit: Exit::Refused,
            file: None,
            line: 0,
            columns: Vec::new(),
            others: Vec::new(),
            rule,
            data,
            alarm: None,
            what,
            remedy,
            fatal: false,
            uncut: false,
            hangs: 0,
        }
    }

    /// A row at columns of the line in hand (counted from 0); at none, of the block as a whole.
    pub(super) fn of(row: &dyn Raise, columns: &[usize]) -> Box<Self> {
        let columns = columns.iter().map(|column| column + 1).collect();
        Box::new(Self { columns, ..Self::new(row.rule(), row.carries(), row.what(), row.remedy()) })
    }

    /// The same, as the end of a budget.
    pub(super) fn ended(row: &dyn Raise) -> Box<Self> {
        let mut fault = Self::of(row, &[]);
        fault.exit = Exit::Limit;
        fault.fatal = true;
        fault
    }

    /// The same where a limit of rodete's own is reached.
    pub(super) fn beyond(row: &dyn Raise, columns: &[usize]) -> Box<Self> {
        let mut fault = Self::of(row, columns);
        fault.exit = Exit::Limit;
        fault
    }

    /// The refusal with the alarm that a control of a family raises for it, its number before the sentence.
    pub(super) fn as_alarm_of(mut self: Box<Self>, family: Option<AlarmFamily>) -> Box<Self> {
        let alarm = family.and_then(|family| Some((family, self.rule.alarm_of(family)?)));
        self.alarm = alarm;
        if alarm.is_some() { self.with_clause(&AlarmOfControl {}) } else { self }
    }

    /// The refusal with a clause before or behind its sentence, and what that carries.
    pub(super) fn with_clause(mut self: Box<Self>, clause: &dyn Clause) -> Box<Self> {
        self.what = clause.said(&self.what, self.alarm, "");
        self.data.extend(clause.carries());
        self
    }

    /// What is wrong, with the other lines at fault.
    #[must_use]
    pub fn message(&self) -> Text {
        let Some(((file, last), lines)) = self.others.split_last() else { return self.what.clone() };
        let lines = lines.iter().map(|(_, line)| line.to_string()).collect::<Vec<_>>().join(", ");
        let of = match file {
            _ if *file == self.file => t("", ""),
            None => t(" del programa", " of the program"),
            Some(file) => Text::new(format!(" de «{file}»"), format!(" of '{file}'")),
        };
        let Text { es, en } = &self.what;
        Text::new(
            format!("{es}: en las líneas {lines} y {last}{}", of.es),
            format!("{en}: in lines {lines} and {last}{}", of.en),
        )
    }

    /// The refusal, after which nothing can be read.
    pub(super) fn fatal(mut self: Box<Self>) -> Box<Self> {
        self.fatal = true;
        self
    }
}

impl From<Refused> for Finding {
    fn from(fault: Refused) -> Self {
        let told = fault.message();
        let mut data = fault.data;
        if let Some((file, _)) = fault.others.first() {
            let line = |(_, line): &(_, usize)| i64::try_from(*line).unwrap_or(i64::MAX);
            data.push(("lines", Datum::Wholes(fault.others.iter().map(line).collect())));
            data.extend(file.clone().map(|file| ("file", Datum::Word(file))));
        }
        let place = place(fault.file.as_deref(), fault.line, fault.columns);
        let mut finding = Finding::of(fault.rule, data, place, told, fault.remedy).graded(Grade::Stop);
        finding.alarm = fault.alarm;
        finding
    }
}

impl From<Trouble> for Refused {
    fn from(trouble: Trouble) -> Self {
        let Trouble { rule, data, exit, what, remedy, line } = trouble;
        Self { exit, line: line.unwrap_or(0), ..Self::new(rule, data, what, remedy) }
    }
}

/// The place of a line of the program, or of a subprogram's own file.
pub(super) fn place(file: Option<&str>, line: usize, columns: Vec<usize>) -> Place {
    match file {
        None => Place::Line { line, columns },
        Some(file) => Place::Subprogram { file: file.to_owned(), line, columns },
    }
}

/// The result of reading or executing a block.
pub(super) type Result<T, E = Box<Refused>> = std::result::Result<T, E>;
