//! The codes that are meant where one is not known: what is nearly typed.

use crate::finding::Rule;
use crate::limits::NEAR_CODES;
use crate::text::{Text, one_of};

/// How a question names the codes near a typed one; empty where none is.
///
/// Those with its letters and its number come first, whatever zeros it lacks and whatever stands behind them; then those with its
/// number under other letters; then those that one character more, less or other makes of it, or two that changed places.
pub(super) fn near(typed: &str, rows: &[&Rule]) -> Text {
    let named = one_of(nearest(typed, &known(rows)).into_iter().map(Text::same));
    if named.is_empty() {
        return named;
    }
    Text::new(format!("; ¿quería decir {}?", named.es), format!("; did you mean {}?", named.en))
}

/// Every code, and every alarm as its control writes it, once, in order.
fn known(rows: &[&Rule]) -> Vec<String> {
    let alarms = |rule: &&Rule| rule.alarm.iter().map(|(family, number)| family.shown(*number)).collect::<Vec<_>>();
    let mut known: Vec<String> = rows.iter().map(|rule| rule.code.to_owned()).collect();
    known.extend(rows.iter().flat_map(alarms));
    known.sort();
    known.dedup();
    known
}

/// The letters before the first digits, and the number of these.
fn parted(code: &str) -> Option<(&str, u64)> {
    let first = code.find(|one: char| one.is_ascii_digit())?;
    let (letters, rest) = code.split_at(first);
    let digits = rest.find(|one: char| !one.is_ascii_digit()).map_or(rest, |end| &rest[..end]);
    Some((letters, digits.parse().ok()?))
}

fn nearest(typed: &str, known: &[String]) -> Vec<String> {
    let typed = typed.trim().to_uppercase();
    let of = |same: &dyn Fn(&str) -> bool| {
        known.iter().filter(|code| same(code)).take(NEAR_CODES).cloned().collect::<Vec<_>>()
    };
    if let Some((letters, number)) = parted(&typed) {
        let same = of(&|code| parted(code) == Some((letters, number)));
        if !same.is_empty() {
            return same;
        }
        let numbered = of(&|code| parted(code).is_some_and(|(_, other)| other == number));
        if !numbered.is_empty() {
            return numbered;
        }
    }
    of(&|code| strsim::damerau_levenshtein(&typed, code) == 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::explain::rows;
    use crate::kinds::KINDS;

    #[test]
    fn a_code_that_is_nearly_typed_is_named() {
        let rows = rows(KINDS);
        for (typed, named) in [
            ("L131", "; did you mean L0131?"),
            ("G0117x", "; did you mean G0117?"),
            ("PS64", "; did you mean PS0064?"),
            ("g117", "; did you mean G0117?"),
            (" W0424", "; did you mean W0424?"),
            ("W4024", "; did you mean W0424?"),
            ("Z9999", ""),
            ("", ""),
            ("99999999999999999999999999", ""),
        ] {
            assert_eq!(near(typed, &rows).en, named, "{typed}");
        }
        let several = near("Q0141", &rows);
        assert!(several.en.contains("G0141") && several.en.contains(" or "), "{several:?}");
        assert!(several.es.starts_with("; ¿quería decir ") && several.es.contains(" o "), "{several:?}");
    }
}
