//! What is to be small or large, and what must hold, as their cells say it.

use std::fmt;

use crate::kind::measure::Measure;
use crate::number::decimal;

/// A measure that is to be small or large.
#[derive(Clone, Copy, Debug)]
pub struct Objective {
    /// The measure.
    pub measure: &'static Measure,
    /// It is to be large.
    pub most: bool,
}

impl Objective {
    /// A value so that less is better, on the grid on which objectives are compared.
    #[must_use]
    pub fn cost(&self, value: f64) -> f64 {
        let value = gridded(value);
        // Of two zeros neither is the better one.
        if self.most { 0.0 - value } else { value + 0.0 }
    }
}

/// The decimals of the scientific notation that objectives are compared in, and the least step in the unit of an objective.
const DECIMALS: usize = 8;
const STEP: f64 = 1e-9;

/// A value to nine significant digits, but to no step finer than 1e-9 of its unit: what rounding alone makes of equal designs, some 1e-14
/// of a value, must not decide which of them is the better one.
///
/// Both steps keep order, so that values that are put on the grid first compare as any numbers do: of three designs, none betters in a
/// circle, and the front of fronts stays the front. Two values that differ by rounding alone fall apart only where they lie to both
/// sides of the middle between two steps, once in some 100,000.
fn gridded(value: f64) -> f64 {
    let steps = (value / STEP).round() * STEP;
    // A value of which so small a step says nothing stays as it is.
    let value = if steps.is_finite() { steps } else { value };
    format!("{value:.DECIMALS$e}").parse().unwrap_or(value)
}

impl fmt::Display for Objective {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{} {}", self.measure.key, if self.most { "max" } else { "min" })
    }
}

/// A measure with a bound.
#[derive(Clone, Copy, Debug)]
pub struct Constraint {
    /// The measure.
    pub measure: &'static Measure,
    /// It must not be less; else it must not be more.
    pub least: bool,
    /// The bound.
    pub bound: f64,
}

impl Constraint {
    /// By how much a value keeps it; negative where it breaks it.
    #[must_use]
    pub fn room(&self, value: f64) -> f64 {
        if self.least { value - self.bound } else { self.bound - value }
    }
}

impl fmt::Display for Constraint {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.least { ">=" } else { "<=" };
        write!(out, "{} {sign} {}", self.measure.key, decimal(self.bound))
    }
}

/// The pieces of a cell, parted by semicolons, without the empty ones.
pub(super) fn pieces(text: &str) -> impl Iterator<Item = &str> {
    text.split(';').map(str::trim).filter(|piece| !piece.is_empty())
}

/// A piece as a key and a direction; `None` where it is not one.
pub(super) fn direction(piece: &str) -> Option<(&str, bool)> {
    let mut words = piece.split_whitespace();
    let (key, direction) = (words.next()?, words.next()?);
    let most = match direction.to_lowercase().as_str() {
        "min" | "mín" => false,
        "max" | "máx" => true,
        _ => return None,
    };
    words.next().is_none().then_some((key, most))
}

/// A piece as a key, whether the bound is the least, and the bound; `None` where it is not one.
pub(super) fn bound(piece: &str) -> Option<(&str, bool, f64)> {
    let signs = [(">=", true), ("<=", false), ("≥", true), ("≤", false)];
    let (key, number, least) =
        signs.iter().find_map(|(sign, least)| piece.split_once(sign).map(|(key, number)| (key, number, *least)))?;
    let number: f64 = number.trim().parse().ok()?;
    (number.is_finite() && !key.trim().contains(char::is_whitespace)).then_some((key.trim(), least, number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_alone_makes_of_a_value_is_no_difference_and_a_millionth_is_one() {
        for value in [0.1 + 0.2, 22.518_274_4, 3_861.123_456_7, 1e-3, 1.25e12] {
            for off in [1e-15, -3e-14, 1e-12] {
                let other = value * (1.0 + off);
                assert_eq!(gridded(value).to_bits(), gridded(other).to_bits(), "{value} {off}");
            }
            assert!(gridded(value * (1.0 + 1e-6)) > gridded(value) && (gridded(value) / value - 1.0).abs() < 1e-8);
        }
        // Nothing is left of what rounding leaves of 0.
        assert_eq!(gridded(-3e-16).abs().to_bits(), 0);
        assert!(gridded(f64::INFINITY).is_infinite() && gridded(f64::MAX) > 1e308);
    }

    #[test]
    fn cells_are_read_piece_by_piece() {
        assert_eq!(pieces(" a min; ;b max ;").collect::<Vec<_>>(), ["a min", "b max"]);
        assert_eq!(direction("time_s min"), Some(("time_s", false)));
        assert_eq!(direction("time_s MÁX"), Some(("time_s", true)));
        assert_eq!((direction("time_s"), direction("time_s least"), direction("a min b")), (None, None, None));
        assert_eq!(bound("clearance_mm >= 0.5"), Some(("clearance_mm", true, 0.5)));
        assert_eq!(bound("time_s≤60"), Some(("time_s", false, 60.0)));
        assert_eq!((bound("a = 3"), bound("a <= x"), bound("a b <= 3")), (None, None, None));
    }
}
