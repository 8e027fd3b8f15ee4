//! Jets: a value with its first and second derivative along one parameter, each an interval, and the bounds that follow.
//!
//! Between two parameters u₀ and u₁ a curve leaves its chord by no more than (u₁ − u₀)²/8 times its greatest second
//! derivative: from its values at the ends and the jet of the span between them follows what it can nowhere exceed.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::interval::Interval;

/// A value and its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// The values over the span of the parameter.
    pub value: Interval,
    /// Its first derivative.
    pub first: Interval,
    /// Its second derivative.
    pub second: Interval,
}

impl Jet {
    /// A constant.
    #[must_use]
    pub const fn of(value: f64) -> Self {
        Self { value: Interval::of(value), first: Interval::ZERO, second: Interval::ZERO }
    }

    /// A quantity that runs evenly from one value to another while the parameter runs from 0 to 1, seen on a part of that.
    #[must_use]
    pub fn running(from: f64, to: f64, part: [f64; 2]) -> Self {
        let by = Interval::of(to) - Interval::of(from);
        Self { value: Interval::of(from) + by * Interval::between(part[0], part[1]), first: by, second: Interval::ZERO }
    }

    /// The parameter itself between two of its values.
    #[must_use]
    pub const fn parameter(low: f64, high: f64) -> Self {
        Self { value: Interval::between(low, high), first: Interval::of(1.0), second: Interval::ZERO }
    }

    /// A function of it, from the function's value and derivatives there.
    fn through(self, value: Interval, first: Interval, second: Interval) -> Self {
        Self { value, first: first * self.first, second: second * self.first.square() + first * self.second }
    }

    /// What encloses this and another.
    #[must_use]
    pub const fn hull(self, other: Self) -> Self {
        Self {
            value: self.value.hull(other.value),
            first: self.first.hull(other.first),
            second: self.second.hull(other.second),
        }
    }

    /// The square of the quantity.
    #[must_use]
    pub fn square(self) -> Self {
        self.through(self.value.square(), self.value * 2.0, Interval::of(2.0))
    }

    /// The root of the quantity; where its values reach down to 0, nothing is known of its derivatives.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        let half = (root * 2.0).inverse();
        self.through(root, half, -(half * (self.value * 2.0).inverse()))
    }

    /// The inverse of the quantity; nothing is known of one whose values hold 0.
    #[must_use]
    pub fn inverse(self) -> Self {
        let inverse = self.value.inverse();
        let square = inverse.square();
        self.through(inverse, -square, inverse * square * 2.0)
    }

    /// Its sine, radians.
    #[must_use]
    pub fn sin(self) -> Self {
        let (sin, cos) = (self.value.sin(), self.value.cos());
        self.through(sin, cos, -sin)
    }

    /// Its cosine, radians.
    #[must_use]
    pub fn cos(self) -> Self {
        let (sin, cos) = (self.value.sin(), self.value.cos());
        self.through(cos, -sin, -cos)
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, first: self.first + other.first, second: self.second + other.second }
    }
}

impl Neg for Jet {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, first: -self.first, second: -self.second }
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            first: self.first * other.value + self.value * other.first,
            second: self.second * other.value + self.first * other.first * 2.0 + self.value * other.second,
        }
    }
}

impl Mul<f64> for Jet {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { value: self.value * factor, first: self.first * factor, second: self.second * factor }
    }
}

impl Div for Jet {
    type Output = Self;

    #[expect(clippy::suspicious_arithmetic_impl, reason = "a quotient is a product with the inverse")]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}

/// A direction or place in three dimensions.
pub type Vector = [Jet; 3];

/// The sum of two.
#[must_use]
pub fn sum(one: Vector, other: Vector) -> Vector {
    std::array::from_fn(|axis| one[axis] + other[axis])
}

/// The difference of two.
#[must_use]
pub fn difference(one: Vector, other: Vector) -> Vector {
    std::array::from_fn(|axis| one[axis] - other[axis])
}

/// One made longer.
#[must_use]
pub fn scaled(one: Vector, by: Jet) -> Vector {
    one.map(|part| part * by)
}

/// The scalar product.
#[must_use]
pub fn dot(one: Vector, other: Vector) -> Jet {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

/// The vector product.
#[must_use]
pub fn cross(one: Vector, other: Vector) -> Vector {
    let at = |i: usize, j: usize| one[i] * other[j] - one[j] * other[i];
    [at(1, 2), at(2, 0), at(0, 1)]
}

/// By how much a curve may leave the chord over a span of its parameter.
#[must_use]
pub fn bow(parts: &[Jet], span: f64) -> f64 {
    let most = parts.iter().map(|part| part.second.size()).map(|size| size * size).sum::<f64>().sqrt();
    let bow = most * span * span / 8.0 * (1.0 + 1e-12);
    if bow.is_nan() { f64::INFINITY } else { bow }
}

/// What a function is nowhere more than over a span of its parameter, from its values at both ends and its jet over the span: by
/// the second derivative, by the first, and by the values. Where the first derivative jumps, its second is to be the whole line.
#[must_use]
pub fn at_most(one: f64, other: f64, jet: Jet, span: f64) -> f64 {
    let wider = 1.0 + 1e-12;
    let curved = one.max(other) + jet.second.size() * span * span / 8.0 * wider;
    let steep = f64::midpoint(one, other) + jet.first.size() * span / 2.0 * wider;
    [curved, steep, jet.value.high].into_iter().filter(|most| !most.is_nan()).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn inside(interval: Interval, value: f64) -> bool {
        interval.low <= value + 1e-9 * value.abs() && value - 1e-9 * value.abs() <= interval.high
    }

    proptest! {
        #[test]
        fn derivatives_are_those_of_the_function(x in 0.1..3.0_f64, wide in 0.0..0.2_f64, part in 0.0..1.0_f64) {
            // f = x²·sin x / √(1 + cos x + x), by hand.
            let jet = Jet::parameter(x, x + wide);
            let under = Jet::of(1.0) + jet.cos() + jet;
            let f = jet.square() * jet.sin() / under.sqrt();
            let at = x + wide * part;
            let value = |x: f64| {
                let (sin, cos) = crate::number::trig::sin_cos(x);
                x * x * sin / (1.0 + cos + x).sqrt()
            };
            let step = 1e-4;
            prop_assert!(inside(f.value, value(at)));
            let first = (value(at + step) - value(at - step)) / (2.0 * step);
            prop_assert!(f.first.low <= first + 1e-5 && first - 1e-5 <= f.first.high);
            let second = (value(at + step) - 2.0 * value(at) + value(at - step)) / (step * step);
            prop_assert!(f.second.low <= second + 1e-3 && second - 1e-3 <= f.second.high);
        }

        #[test]
        fn a_function_is_nowhere_more_than_at_most(x in -3.0..3.0_f64, wide in 0.0..1.0_f64, part in 0.0..1.0_f64) {
            let jet = Jet::parameter(x, x + wide);
            let value = |x: f64| crate::number::trig::sin(x) * x;
            let most = at_most(value(x), value(x + wide), jet.sin() * jet, wide);
            prop_assert!(value(x + wide * part) <= most + 1e-12);
            let kinked = Jet { second: Interval::WHOLE, ..jet.sin() * jet };
            prop_assert!(value(x + wide * part) <= at_most(value(x), value(x + wide), kinked, wide) + 1e-12);
        }

        #[test]
        fn no_point_of_a_curve_leaves_its_chord_by_more_than_the_bow(
            x in -3.0..3.0_f64, wide in 0.01..1.0_f64, part in 0.0..1.0_f64,
        ) {
            let jet = Jet::parameter(x, x + wide);
            let bow = bow(&[jet.sin(), jet.cos()], wide);
            let at = crate::number::trig::sin_cos;
            let ((s0, c0), (s1, c1), (s, c)) = (at(x), at(x + wide), at(x + wide * part));
            let off = libm::hypot(s - (s0 + (s1 - s0) * part), c - (c0 + (c1 - c0) * part));
            prop_assert!(off <= bow + 1e-15, "{off} {bow}");
        }
    }
}
