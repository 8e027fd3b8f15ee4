//! The output grid: whole thousandths of a millimetre or of a degree, as a program carries them.
//!
//! Positions are rounded to the grid once and subtracted as whole numbers after, so that increments cannot drift and a
//! closed path closes to exactly 0.

use std::ops::{Add, Neg, Sub};

/// Greatest value that a program may carry, in thousandths: 99 999.999 (the ±5.4 format of Fagor controls).
pub const LIMIT: i32 = 99_999_999;

/// Half a step: by how much rounding to the grid moves a value at most, mm or degrees.
pub const HALF: f64 = 0.0005;

/// A whole turn, thousandths of a degree.
pub const TURN: i32 = 360_000;

/// A position or increment in thousandths of a millimetre or of a degree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Milli(i32);

/// A value that no program may carry.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{0} does not fit the format of five digits before and three after the point")]
pub struct OutOfFormat(pub f64);

impl Milli {
    /// 0 mm or 0°.
    pub const ZERO: Self = Self(0);

    /// So many thousandths of a millimetre or of a degree; what a program may carry is not asked.
    #[must_use]
    pub const fn new(thousandths: i32) -> Self {
        Self(thousandths)
    }

    /// A value in millimetres or degrees rounded to the grid, halves away from zero.
    ///
    /// # Errors
    /// For a value that is not finite or beyond ±99 999.999.
    pub fn round(value: f64) -> Result<Self, OutOfFormat> {
        let scaled = (value * 1000.0).round();
        if scaled.is_finite() && scaled.abs() <= f64::from(LIMIT) {
            #[expect(clippy::cast_possible_truncation, reason = "a whole number within ±LIMIT")]
            Ok(Self(scaled as i32))
        } else {
            Err(OutOfFormat(value))
        }
    }

    /// The value in whole thousandths of a millimetre or of a degree.
    #[must_use]
    pub const fn thousandths(self) -> i32 {
        self.0
    }

    /// The value in millimetres or degrees.
    #[must_use]
    pub fn value(self) -> f64 {
        f64::from(self.0) / 1000.0
    }
}

impl Add for Milli {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Milli {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Neg for Milli {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_no_program_may_carry_are_refused() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e22, 100_000.0, -100_000.0] {
            assert!(Milli::round(value).is_err(), "{value}");
        }
        assert!(Milli::round(99_999.999).is_ok());
    }
}
