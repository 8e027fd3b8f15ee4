//! What the example of each row is told: the sentence and the remedy with real figures in place of the fields.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use crate::finding::Rule;
use crate::text::{Text, t};

/// A line a row that has fields: code, sentence and remedy in Spanish and in English, parted by tabs. The tests of the
/// findings write it, and compare it with what each example is told.
static TOLD: &str = include_str!("told.tsv");

static BY_CODE: LazyLock<BTreeMap<&str, [&str; 4]>> = LazyLock::new(|| TOLD.lines().filter_map(line).collect());

/// The code of a line, and what is told.
fn line(line: &'static str) -> Option<(&'static str, [&'static str; 4])> {
    let mut parts = line.split('\t');
    let code = parts.next()?;
    let told = [parts.next()?, parts.next()?, parts.next()?, parts.next()?];
    Some((code, told))
}

/// What a reader is shown of a row.
pub(super) struct ShownFinding {
    /// The sentence.
    pub(super) what: Text,
    /// The remedy; empty where there is nothing to do.
    pub(super) remedy: Text,
    /// True where figures and names are those of the row's example.
    pub(super) example: bool,
}

/// Sentence and remedy as the row's example is told them; where it has none, with an ellipsis for each field.
pub(super) fn of(rule: &Rule) -> ShownFinding {
    let own = |[what_es, remedy_es, what_en, remedy_en]: &[&'static str; 4]| ShownFinding {
        what: t(what_es, what_en),
        remedy: t(remedy_es, remedy_en),
        example: true,
    };
    let without = || ShownFinding { what: rule.unfilled_what(), remedy: rule.unfilled_remedy(), example: false };
    BY_CODE.get(rule.code).map_or_else(without, own)
}
