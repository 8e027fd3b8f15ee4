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
pub(super) struct Told {
    /// The sentence.
    pub(super) what: Text,
    /// The remedy; empty where there is nothing to do.
    pub(super) remedy: Text,
    /// True where figures and names are those of the row's example.
    pub(super) example: bool,
}

/// Sentence and remedy as the row's example is told them; where it has none, with an ellipsis for each field.
pub(super) fn of(rule: &Rule) -> Told {
    let own = |[what_es, remedy_es, what_en, remedy_en]: &[&'static str; 4]| Told {
        what: t(what_es, what_en),
        remedy: t(remedy_es, remedy_en),
        example: true,
    };
    let without = || Told { what: without_fields(&rule.what), remedy: without_fields(&rule.remedy), example: false };
    BY_CODE.get(rule.code).map_or_else(without, own)
}

/// A text of a row with an ellipsis for each of its fields.
fn without_fields(text: &Text) -> Text {
    let bare = |text: &str| {
        let mut parts = text.split('{');
        let first = parts.next().unwrap_or_default().to_owned();
        parts.fold(first, |shown, part| {
            let rest = part.split_once('}').map_or(part, |(_, rest)| rest);
            format!("{shown}…{rest}")
        })
    };
    Text::new(bare(&text.es), bare(&text.en))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_is_an_ellipsis() {
        let text = t("la pieza {part} mide {size}", "{part} is {size} long");
        assert_eq!(without_fields(&text), t("la pieza … mide …", "… is … long"));
    }
}
