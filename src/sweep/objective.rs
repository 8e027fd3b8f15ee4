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
    /// A value so that less is better.
    #[must_use]
    pub fn cost(&self, value: f64) -> f64 {
        // Of two zeros neither is the better one.
        if self.most { 0.0 - value } else { value + 0.0 }
    }
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
