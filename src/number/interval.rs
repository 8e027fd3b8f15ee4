//! Intervals: what a computation gives for every number between two.
//!
//! Each result encloses the true one: ends are moved outwards by more than the arithmetic and `libm` can be off. What cannot be
//! bounded (a quotient by an interval around 0, a root of one below 0) is the whole line, never a NaN. Of an interval around 0 the roots
//! are those of its numbers that have one.

use std::f64::consts::{PI, TAU};
use std::ops::{Add, Mul, Neg, Sub};

use crate::number::trig;

/// All numbers from the one to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end; −∞ where nothing bounds it.
    pub low: f64,
    /// The upper end; ∞ where nothing bounds it.
    pub high: f64,
}

/// An end moved outwards by two units in its last place.
fn below(value: f64) -> f64 {
    value - value.abs() * 2.0 * f64::EPSILON - f64::MIN_POSITIVE
}

fn above(value: f64) -> f64 {
    value + value.abs() * 2.0 * f64::EPSILON + f64::MIN_POSITIVE
}

impl Interval {
    /// Every number: nothing is known.
    pub const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
    /// Only 0.
    pub const ZERO: Self = Self::of(0.0);

    /// One number.
    #[must_use]
    pub const fn of(value: f64) -> Self {
        Self { low: value, high: value }
    }

    /// All between two numbers, in whichever order they come.
    #[must_use]
    pub const fn between(one: f64, other: f64) -> Self {
        Self { low: one.min(other), high: one.max(other) }
    }

    /// What encloses this and another.
    #[must_use]
    pub const fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// From ends as computed, moved outwards; the whole line where one of them is no number.
    fn outwards(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() { Self::WHOLE } else { Self { low: below(low), high: above(high) } }
    }

    /// The greatest size of a number in it.
    #[must_use]
    pub const fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// The squares of all numbers in it.
    #[must_use]
    pub fn square(self) -> Self {
        let most = self.size();
        let least = if self.low > 0.0 || self.high < 0.0 { self.low.abs().min(self.high.abs()) } else { 0.0 };
        Self::outwards(least * least, most * most)
    }

    /// The inverses of all numbers in it; the whole line where 0 is among them.
    #[must_use]
    pub fn inverse(self) -> Self {
        if self.low > 0.0 || self.high < 0.0 { Self::outwards(1.0 / self.high, 1.0 / self.low) } else { Self::WHOLE }
    }

    /// The root of each; from 0 where it reaches below.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.high < 0.0 { Self::WHOLE } else { Self::outwards(self.low.max(0.0).sqrt(), self.high.sqrt()) }
    }

    /// The sine of each, radians.
    #[must_use]
    pub fn sin(self) -> Self {
        // Farther out than this no program goes, and what a turn's remainder loses counts.
        if self.high - self.low >= TAU || !self.size().is_finite() || self.size() > 1e6 {
            return Self { low: -1.0, high: 1.0 };
        }
        let (one, other) = (trig::sin(self.low), trig::sin(self.high));
        let reached = |top: f64| ((self.high - top) / TAU + 1e-9).floor() >= ((self.low - top) / TAU - 1e-9).ceil();
        let slack = 1e-9 * f64::from(u8::from(self.size() > 1e3)) + 4.0 * f64::EPSILON;
        let low = if reached(-PI / 2.0) { -1.0 } else { one.min(other) - slack };
        let high = if reached(PI / 2.0) { 1.0 } else { one.max(other) + slack };
        Self { low: low.max(-1.0), high: high.min(1.0) }
    }

    /// The cosine of each, radians.
    #[must_use]
    pub fn cos(self) -> Self {
        (self + Self::of(PI / 2.0)).sin()
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::outwards(self.low + other.low, self.high + other.high)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let products = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        if products.iter().any(|product| product.is_nan()) {
            // Nothing times anything is nothing.
            return if self == Self::ZERO || other == Self::ZERO { Self::ZERO } else { Self::WHOLE };
        }
        let [one, other, third, fourth] = products;
        Self::outwards(one.min(other).min(third.min(fourth)), one.max(other).max(third.max(fourth)))
    }
}

impl Mul<f64> for Interval {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self * Self::of(factor)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_result_lies_in_the_interval_of_its_operation(
            a in -50.0..50.0_f64, wide in 0.0..8.0_f64, b in -50.0..50.0_f64, broad in 0.0..8.0_f64,
            one in 0.0..1.0_f64, other in 0.0..1.0_f64,
        ) {
            let (x, y) = (Interval::between(a, a + wide), Interval::between(b, b + broad));
            let (p, q) = (a + wide * one, b + broad * other);
            let inside = |interval: Interval, value: f64| interval.low <= value && value <= interval.high;
            prop_assert!(inside(x + y, p + q) && inside(x - y, p - q) && inside(x * y, p * q) && inside(-x, -p));
            prop_assert!(inside(x.square(), p * p) && inside(x.inverse(), 1.0 / p));
            prop_assert!(inside(x.sin(), trig::sin(p)) && inside(x.cos(), trig::cos(p)));
            prop_assert!(p < 0.0 || inside(x.sqrt(), p.sqrt()));
        }
    }

    #[test]
    fn what_cannot_be_bounded_is_the_whole_line() {
        let around = Interval::between(-1.0, 1.0);
        assert_eq!(around.inverse(), Interval::WHOLE);
        assert_eq!(Interval::between(-2.0, -1.0).sqrt(), Interval::WHOLE);
        assert_eq!(Interval::WHOLE * Interval::ZERO, Interval::ZERO);
        assert_eq!((Interval::WHOLE - Interval::WHOLE), Interval::WHOLE);
        let top = Interval::between(1.5, 1.7).sin();
        assert!(top.high == 1.0 && top.low <= trig::sin(1.7) && top.low > 0.99);
    }
}
