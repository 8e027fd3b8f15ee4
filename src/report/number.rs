//! Numbers as the report prints them: fixed decimals, a point, a true minus sign and never a minus zero.

pub(super) use crate::number::grouped;
use crate::table::Unit;

/// U+2212: as wide as a digit, so that columns of numbers align.
const MINUS: char = '\u{2212}';

/// A number with fixed decimals.
pub(super) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_owned(),
        Some(rest) => format!("{MINUS}{rest}"),
        None => text,
    }
}

/// A number with at most some decimals, without trailing zeros.
pub(super) fn trimmed(value: f64, decimals: usize) -> String {
    let text = fixed(value, decimals);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A value typed by the user, with every digit.
pub(super) fn given(value: f64) -> String {
    let text = format!("{}", if value == 0.0 { 0.0 } else { value });
    text.replace('-', "\u{2212}")
}

/// The decimals of a single value in its unit: those that a shop can use.
pub(super) const fn usable(unit: Unit) -> usize {
    match unit {
        Unit::Count | Unit::CubicMillimetre | Unit::RevolutionPerMinute => 0,
        Unit::MetrePerMinute | Unit::CubicCentimetrePerMinute | Unit::MillimetrePerMinute | Unit::DegreePerMinute => 1,
        // A time is told to the tenth that it has reached: with one decimal a part of it would be rounded up beside it.
        Unit::Second => 2,
        Unit::Millimetre
        | Unit::SquareMillimetre
        | Unit::Degree
        | Unit::MillimetrePerRevolution
        | Unit::One
        | Unit::None => 3,
        Unit::Radian => 5,
        Unit::Step => 6,
    }
}

/// A single value in its unit, to the digits that a shop can use; a smaller value is printed as below that limit.
pub(super) fn quantity(value: f64, unit: Unit) -> String {
    rounded(value, usable(unit))
}

/// A value with at most some decimals; one that they do not show is printed as below that limit.
pub(super) fn rounded(value: f64, decimals: usize) -> String {
    let text = trimmed(value, decimals);
    if text == "0" && value != 0.0 {
        let least = trimmed(1.0 / (0..decimals).fold(1.0, |power, _| power * 10.0), decimals);
        return if value > 0.0 { format!("< {least}") } else { format!("> {MINUS}{least}") };
    }
    text
}

/// The most decimals that a column is given beyond its own to tell neighbouring rows apart.
const APART: usize = 3;

/// The decimals of a column of rows that are compared: its own or, where two neighbouring values that differ would be printed
/// alike, as many more as tell them apart. Those that [`APART`] more, or [`WIDEST`] digits in all, do not part stay alike:
/// what lies beyond is rounding.
pub(super) fn telling(values: &[f64], own: usize) -> usize {
    let whole = |value: &f64| fixed(value.abs().trunc(), 0).len();
    let widest = WIDEST.saturating_sub(values.iter().map(whole).max().unwrap_or(1)).max(own);
    let parts = |pair: &[f64]| {
        (own..=widest.min(own + APART))
            .find(|&decimals| pair.windows(2).all(|two| rounded(two[0], decimals) != rounded(two[1], decimals)))
    };
    values.windows(2).filter_map(parts).max().unwrap_or(own)
}

/// The decimals of a table's column: for lengths and angles, one more than in programs.
pub(super) const fn decimals(unit: Unit) -> usize {
    match unit {
        Unit::Count | Unit::RevolutionPerMinute => 0,
        Unit::CubicMillimetre
        | Unit::CubicCentimetrePerMinute
        | Unit::MetrePerMinute
        | Unit::MillimetrePerMinute
        | Unit::DegreePerMinute => 1,
        Unit::Second => 2,
        Unit::MillimetrePerRevolution => 3,
        Unit::Millimetre | Unit::SquareMillimetre | Unit::Degree | Unit::None => 4,
        Unit::One | Unit::Radian | Unit::Step => 6,
    }
}

/// The digits that a column of numbers has at most.
const WIDEST: usize = 9;

/// The decimals of a column, of those of its unit: as many as leave no number more than [`WIDEST`] digits and, unless all are
/// kept, as many as its values need.
pub(super) fn needed(values: impl Iterator<Item = f64>, most: usize, all: bool) -> usize {
    let (mut whole, mut part) = (1, 0);
    for value in values {
        let text = trimmed(value, most);
        let (before, after) = text.split_once('.').unwrap_or((&text, ""));
        whole = whole.max(before.bytes().filter(u8::is_ascii_digit).count());
        part = part.max(after.len());
    }
    (if all { most } else { part }).min(WIDEST.saturating_sub(whole))
}

#[cfg(test)]
mod tests {
    use super::{fixed, given, needed, quantity, telling, trimmed};
    use crate::table::Unit;

    #[test]
    fn numbers_carry_a_point_a_true_minus_and_no_minus_zero() {
        assert_eq!(fixed(-239.7, 5), "\u{2212}239.70000");
        assert_eq!(fixed(-0.000_001, 5), "0.00000");
        assert_eq!(fixed(-0.0, 0), "0");
        assert_eq!(trimmed(36.869_897_6, 4), "36.8699");
        assert_eq!(trimmed(20.0, 4), "20");
        assert_eq!(trimmed(100.0, 0), "100");
        assert_eq!(given(1e-5), "0.00001");
        assert_eq!(given(-0.0), "0");
    }

    #[test]
    fn a_quantity_has_the_digits_that_its_unit_is_worth_and_is_never_0_unless_it_is() {
        assert_eq!(quantity(19.999_999_969, Unit::Millimetre), "20");
        assert_eq!(quantity(36.869_897_6, Unit::Degree), "36.87");
        assert_eq!(quantity(78_444.5, Unit::CubicMillimetre), "78444");
        assert_eq!(quantity(227.537, Unit::MetrePerMinute), "227.5");
        assert_eq!(quantity(6.4e-12, Unit::Millimetre), "< 0.001");
        assert_eq!(quantity(-6.4e-12, Unit::Millimetre), "> \u{2212}0.001");
        assert_eq!(quantity(0.0, Unit::Millimetre), "0");
    }

    #[test]
    fn neighbouring_rows_that_differ_are_told_apart_as_far_as_digits_are_worth_it() {
        assert_eq!(telling(&[1.25, 1.5, 1.75], 3), 3);
        // Those of one value, and those that rounding alone parts, ask for nothing.
        assert_eq!(telling(&[1.25, 1.25, 1.250_000_000_1], 3), 3);
        assert_eq!(telling(&[1.250_41, 1.250_44, 1.3], 3), 5);
        assert_eq!(telling(&[0.000_2, 0.000_4], 3), 4);
        // Rows that are not neighbours are told apart by what lies between them.
        assert_eq!(telling(&[1.250_41, 1.3, 1.250_44], 3), 3);
        // No number is wider than nine digits, and no column has fewer decimals than its unit.
        assert_eq!(telling(&[1_234_567.86, 1_234_567.88], 1), 2);
        assert_eq!(telling(&[1_234_567.891_1, 1_234_567.893_3], 1), 1);
        assert_eq!(telling(&[1_234_567_890.1, 1_234_567_890.12], 1), 1);
        assert_eq!(telling(&[], 3), 3);
    }

    #[test]
    fn a_column_has_the_decimals_that_its_values_need() {
        let of = |values: &[f64], most, all| needed(values.iter().copied(), most, all);
        assert_eq!(of(&[60.0, 40.0], 4, false), 0);
        assert_eq!(of(&[0.8, 40.0, 1.250_000_01], 4, false), 2);
        assert_eq!(of(&[60.0, 40.0], 4, true), 4);
        assert_eq!(of(&[-202_163.201_432], 6, true), 3);
        assert_eq!(of(&[], 4, false), 0);
    }
}
