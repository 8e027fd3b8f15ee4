//! What was made of a workbook, kept to be compared with another.

use std::path::PathBuf;

use super::verdict::Verdict;
use crate::kind::Outcome;
use crate::kind::comparison::Side;
use crate::parameter::{Form, Values};
use crate::workbook::Filled;

/// What was made of a workbook.
#[derive(Debug)]
pub(super) struct Made {
    /// What is said of it.
    pub(super) verdict: Verdict,
    /// The form that it fills in; `None` where it could not be read.
    pub(super) form: Option<&'static Form>,
    /// Its values; `None` where it could not be read.
    pub(super) values: Option<Values>,
    /// What came of them; `None` where they contradict each other.
    pub(super) outcome: Option<Outcome>,
    /// The workbook was saved again meanwhile: nothing was written.
    pub(super) overtaken: bool,
}

impl Default for Made {
    fn default() -> Self {
        Self { verdict: Verdict::new(PathBuf::new()), form: None, values: None, outcome: None, overtaken: false }
    }
}

impl Made {
    /// Keeps what was read.
    pub(super) fn read(&mut self, filled: &Filled) {
        self.form = Some(filled.form);
        self.values = Some(filled.values.clone());
    }

    /// The side of a comparison; `None` of a workbook that could not be read.
    pub(super) fn side(&self) -> Option<Side<'_>> {
        let (values, outcome) = (self.values.as_ref()?, self.outcome.as_ref());
        Some(Side { values, findings: &self.verdict.findings, outcome })
    }
}
