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

/// A single value in its unit, to the digits that a shop can use; a smaller value is printed as below that limit.
pub(super) fn quantity(value: f64, unit: Unit) -> String {
    let decimals = match unit {
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
    };
    let text = trimmed(value, decimals);
    if text == "0" && value != 0.0 {
        let least = trimmed(1.0 / (0..decimals).fold(1.0, |power, _| power * 10.0), decimals);
        return if value > 0.0 { format!("< {least}") } else { format!("> {MINUS}{least}") };
    }
    text
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
    use super::{fixed, given, needed, quantity, trimmed};
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
    fn a_column_has_the_decimals_that_its_values_need() {
        let of = |values: &[f64], most, all| needed(values.iter().copied(), most, all);
        assert_eq!(of(&[60.0, 40.0], 4, false), 0);
        assert_eq!(of(&[0.8, 40.0, 1.250_000_01], 4, false), 2);
        assert_eq!(of(&[60.0, 40.0], 4, true), 4);
        assert_eq!(of(&[-202_163.201_432], 6, true), 3);
        assert_eq!(of(&[], 4, false), 0);
    }
}
