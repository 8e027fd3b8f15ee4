//! A cell's value as it is written in the sheet's part, compared with the type the cell says it has.

use crate::escape::excerpt;
use crate::finding::Raise;
use crate::limits::EXCERPT;

use super::rules::cell::*;

/// Most bytes of a number.
const NUMBER: usize = 400;
/// The errors that calamine knows; another one makes it give the sheet up.
const ERRORS: [&str; 7] = ["#DIV/0!", "#N/A", "#NAME?", "#NULL!", "#NUM!", "#REF!", "#VALUE!"];

/// Why a value cannot stand.
pub struct Fault {
    /// What is reported.
    pub row: Box<dyn Raise>,
    /// True where calamine must not read the sheet: it would give it up, or take another value.
    pub unsound: bool,
    /// True where the package is damaged and not only a value wrong.
    pub damaged: bool,
}

impl Fault {
    fn wrong(row: impl Raise + 'static, unsound: bool) -> Option<Self> {
        Some(Self { row: Box::new(row), unsound, damaged: false })
    }

    fn damage(row: impl Raise + 'static) -> Option<Self> {
        Some(Self { row: Box::new(row), unsound: true, damaged: true })
    }
}

/// Judges the value of a cell by its type (`t`) and the number of shared texts in the workbook.
pub fn judge(kind: Option<&str>, value: &str, texts: usize, cell: impl FnOnce() -> String) -> Option<Fault> {
    let shown = || excerpt(value, EXCERPT);
    match kind {
        None | Some("n" | "s" | "b" | "e" | "str" | "inlineStr" | "d") if value.is_empty() => None,
        None | Some("n") => number(kind, value, cell),
        Some("s") => {
            let digits = value.len() <= 9 && value.bytes().all(|byte| byte.is_ascii_digit());
            if digits && value.parse::<usize>().is_ok_and(|index| index < texts) {
                return None;
            }
            Fault::damage(NoSuchText { cell: cell(), text: shown(), texts })
        }
        Some("b") => match value.trim().to_ascii_lowercase().as_str() {
            "" | "0" | "1" | "true" | "false" => None,
            _ => Fault::wrong(NoTruthValue { cell: cell(), value: shown() }, true),
        },
        Some("e") if ERRORS.contains(&value) => None,
        Some("e") => Fault::wrong(UnknownError { cell: cell(), error: shown() }, true),
        Some("str" | "inlineStr" | "d") => None,
        Some(other) => Fault::damage(UnknownType { cell: cell(), kind: excerpt(other, EXCERPT) }),
    }
}

fn number(kind: Option<&str>, value: &str, cell: impl FnOnce() -> String) -> Option<Fault> {
    let shown = || excerpt(value, EXCERPT);
    if is_number(value) {
        let overflows = !value.parse::<f64>().is_ok_and(f64::is_finite);
        return if overflows { Fault::wrong(NotFinite { cell: cell(), value: shown() }, false) } else { None };
    }
    let words = ["nan", "inf", "+inf", "-inf", "infinity", "+infinity", "-infinity", "1.#inf", "-1.#ind"];
    // Without a type given, calamine takes it for a text; with one, it gives the sheet up.
    if words.iter().any(|word| value.trim().eq_ignore_ascii_case(word)) {
        Fault::wrong(NotFinite { cell: cell(), value: shown() }, kind.is_some())
    } else {
        Fault::wrong(NotANumberInFile { cell: cell(), value: shown() }, kind.is_some())
    }
}

/// True for a number as spreadsheet programs write it: digits with an optional sign, point and exponent.
fn is_number(text: &str) -> bool {
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).map_or((unsigned, None), |(one, two)| (one, Some(two)));
    let (whole, fraction) = mantissa.split_once('.').map_or((mantissa, None), |(one, two)| (one, Some(two)));
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    text.len() <= NUMBER
        && digits(whole)
        && fraction.is_none_or(digits)
        && exponent.is_none_or(|text| digits(text.strip_prefix(['+', '-']).unwrap_or(text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_a_spreadsheet_writes_is_a_number() {
        for number in ["0", "-0", "12.5", "1E-3", "1e+300", "0.30000000000000004", "1e400"] {
            assert!(is_number(number), "{number}");
        }
        for text in ["", " 12 ", "12x", "abc", "+1", ".5", "5.", "1e", "NaN", "0x10", "1_0", "1,5", "--1", "1e1.5"] {
            assert!(!is_number(text), "{text}");
        }
    }

    #[test]
    fn calamine_is_kept_from_what_it_would_give_up_and_from_damage() {
        let graded = |kind, value| judge(kind, value, 3, String::new).map(|fault| (fault.unsound, fault.damaged));
        assert_eq!(graded(None, "abc"), Some((false, false)));
        assert_eq!(graded(Some("n"), "abc"), Some((true, false)));
        assert_eq!(graded(None, "1e400"), Some((false, false)));
        assert_eq!(graded(Some("s"), "2"), None);
        assert_eq!(graded(Some("s"), "3"), Some((true, true)));
        assert_eq!(graded(Some("s"), "0x1"), Some((true, true)));
        assert_eq!(graded(Some("b"), "2"), Some((true, false)));
        assert_eq!(graded(Some("e"), "#N/A"), None);
        assert_eq!(graded(Some("e"), "#CALC!"), Some((true, false)));
        assert_eq!(graded(Some("q"), ""), Some((true, true)));
    }
}
