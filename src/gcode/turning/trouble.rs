//! Why a cycle is not made.

use crate::finding::{AlarmFamily, Datum, Exit, Raise, Rule};
use crate::text::Text;

/// Why a cycle is not made: a row, with what it carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Trouble {
    /// The row of which it is a finding.
    pub rule: &'static Rule,
    /// What it carries, by name, unrounded.
    pub data: Vec<(&'static str, Datum)>,
    /// [`Exit::Refused`], or [`Exit::Limit`] where there would be too many passes.
    pub exit: Exit,
    /// What is wrong.
    pub what: Text,
    /// What to do about it.
    pub remedy: Text,
    /// The line of the block of the contour that is at fault; none for the cycle's own block.
    pub line: Option<usize>,
}

impl Trouble {
    /// The refusal that a row makes of its values, at the cycle's own block.
    #[must_use]
    pub fn of(row: &dyn Raise) -> Box<Self> {
        let (rule, data) = (row.rule(), row.carries());
        Box::new(Self { rule, data, exit: Exit::Refused, what: row.what(), remedy: row.remedy(), line: None })
    }

    /// The same where a limit of rodete's own is reached.
    #[must_use]
    pub fn beyond(mut self: Box<Self>) -> Box<Self> {
        self.exit = Exit::Limit;
        self
    }

    /// The number under which a control of a family raises it, as 64 for PS0064; none where it has no alarm for it.
    #[must_use]
    pub fn alarm(&self, family: AlarmFamily) -> Option<u16> {
        self.rule.alarm_of(family)
    }

    /// The same in a block of the contour.
    #[must_use]
    pub fn at(mut self: Box<Self>, line: usize) -> Box<Self> {
        self.line = Some(line);
        self
    }
}
