//! Two pipes that meet: where a branch of radius r meets a header of radius R.
//!
//! # Frame
//! The header's axis is the x axis; the branch's axis leaves it upwards at the angle θ in a plane parallel to xz at
//! y = e. A point of the branch has the angle φ about its axis, 0 on the side of the obtuse angle's mouth, and stands at
//! e·ŷ + s·d + r(cos φ·u + sin φ·ŷ) with d = (cos θ, 0, sin θ), u = (sin θ, 0, −cos θ) and s the way along its axis.
//!
//! It is on the header where y² + z² = R²: q = r sin φ + e and s = (√(R² − q²) + r cos φ cos θ)/sin θ. Counted down the
//! branch from the point at φ = 0 this is the template of the published source, its equation 9.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use crate::number::trig::{hypot, sin_cos};

/// A branch and a header.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PipePair {
    /// r, the branch's radius.
    pub r: f64,
    /// R, the header's radius.
    pub R: f64,
    /// sin θ and cos θ of the angle between the axes.
    sin: f64,
    cos: f64,
    /// e, how far the axes pass each other.
    pub e: f64,
}

/// The side from which a corner of the curve is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// From smaller angles φ.
    Before,
    /// From greater ones.
    After,
}

impl PipePair {
    /// The pair with the angle θ between the axes in degrees. At 90° the cosine is exactly 0.
    #[must_use]
    pub fn new(r: f64, R: f64, theta: f64, e: f64) -> Self {
        let (sin, cos) = if theta == 90.0 { (1.0, 0.0) } else { sin_cos(theta.to_radians()) };
        Self { r, R, sin, cos, e }
    }

    /// sin θ and cos θ.
    pub(super) const fn angle(&self) -> [f64; 2] {
        [self.sin, self.cos]
    }

    /// Another line of the same branch, r from its axis.
    pub(super) const fn with_radius(self, r: f64) -> Self {
        Self { r, ..self }
    }

    /// √(R² − q²) at φ = 0, from which depths are counted.
    pub(super) fn level(&self) -> f64 {
        self.R * self.cos_beta(0.0)
    }

    /// By how much the branch overhangs the header: the greatest |r sin φ + e| less R; negative where it does not.
    #[must_use]
    pub fn overhang(&self) -> f64 {
        self.r + self.e.abs() - self.R
    }

    /// q, the distance of the branch's point at φ from the plane through the header's axis.
    fn q(&self, phi: f64) -> f64 {
        self.r * sin_cos(phi).0 + self.e
    }

    /// cos β = √(1 − (q/R)²).
    fn cos_beta(&self, phi: f64) -> f64 {
        let q = self.q(phi);
        ((self.R - q) * (self.R + q)).max(0.0).sqrt() / self.R
    }

    /// s, how far along the branch's axis the curve is at φ from the point of the axis nearest to the header's, mm. Where the branch
    /// passes the header, that of the header's side.
    #[must_use]
    pub fn reach(&self, phi: f64) -> f64 {
        (self.R * self.cos_beta(phi) + self.r * sin_cos(phi).1 * self.cos) / self.sin
    }

    /// How much further down the branch the curve is at φ than at φ = 0, mm: equation 9 without Z.
    #[must_use]
    pub fn depth(&self, phi: f64) -> f64 {
        let first = self.r * self.cos / self.sin * (1.0 - sin_cos(phi).1);
        first + self.R / self.sin * (self.cos_beta(0.0) - self.cos_beta(phi))
    }

    /// The angle at which the curve has a corner: where the branch touches the header's side.
    #[must_use]
    pub fn corners(&self) -> Vec<f64> {
        if self.overhang() < -1e-9 * self.R {
            return Vec::new();
        }
        let (up, down) = (FRAC_PI_2, PI + FRAC_PI_2);
        if self.e.abs() <= 1e-9 * self.R {
            vec![up, down]
        } else if self.e > 0.0 {
            vec![up]
        } else {
            vec![down]
        }
    }

    /// The slope of [`Self::depth`] at φ, mm a radian; at a corner that of one side.
    ///
    /// # Derivation
    /// At a corner |q| = R. At the angle δ from it |q| is R − r δ²/2 to δ⁴, so that w² = R² − q² is R r δ², and
    /// cos β = w/R is |δ|√(r/R), to second order.
    #[must_use]
    pub fn slope(&self, phi: f64, side: Side) -> f64 {
        let (sin, cos) = sin_cos(phi);
        let (q, w) = (self.r * sin + self.e, self.cos_beta(phi));
        let towards = if w < 1e-7 {
            let falling = (self.r / self.R).sqrt();
            if side == Side::Before { -falling } else { falling }
        } else {
            -q * self.r * cos / (self.R * self.R * w)
        };
        self.r * self.cos / self.sin * sin - self.R / self.sin * towards
    }

    /// The point of the curve at φ, in the frame above.
    #[must_use]
    pub fn point(&self, phi: f64) -> Vector3<f64> {
        let (sin, cos) = sin_cos(phi);
        let q = self.r * sin + self.e;
        let z = ((self.R - q) * (self.R + q)).max(0.0).sqrt();
        let s = (z + self.r * cos * self.cos) / self.sin;
        Vector3::new(s * self.cos + self.r * cos * self.sin, q, z)
    }

    /// The point of the branch's surface at φ that is `depth` mm further down the branch than the curve is at φ = 0.
    #[must_use]
    pub fn on_branch(&self, phi: f64, depth: f64) -> Vector3<f64> {
        let (sin, cos) = sin_cos(phi);
        let s = (self.R * self.cos_beta(0.0) + self.r * self.cos) / self.sin - depth;
        let (across, along) = (self.r * cos, s);
        Vector3::new(along * self.cos + across * self.sin, self.e + self.r * sin, along * self.sin - across * self.cos)
    }

    /// How far a point is from the header's surface, mm; negative inside.
    #[must_use]
    pub fn off_header(&self, point: &Vector3<f64>) -> f64 {
        hypot(point.y, point.z) - self.R
    }
}

/// An angle brought between 0 and 2π.
#[must_use]
pub fn once_round(phi: f64) -> f64 {
    phi.rem_euclid(TAU)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_curve_lies_on_both_pipes(
            R in 5.0..500.0_f64, part in 0.05..1.0_f64, theta in 15.0..165.0_f64, off in -1.0..1.0_f64, phi in 0.0..TAU,
        ) {
            let r = R * part;
            let pair = PipePair::new(r, R, theta, (R - r) * off);
            prop_assert!(pair.overhang() <= 1e-12 * R);
            let point = pair.point(phi);
            let off_branch = hypot(point.y - pair.e, point.x * pair.sin - point.z * pair.cos) - r;
            prop_assert!(pair.off_header(&point).abs() < 1e-9 && off_branch.abs() < 1e-9);
            prop_assert!((pair.on_branch(phi, pair.depth(phi)) - point).norm() < 1e-9);
        }

        #[test]
        fn the_slope_is_that_of_finite_differences(
            R in 5.0..500.0_f64, part in 0.05..0.98_f64, theta in 15.0..165.0_f64, off in -0.9..0.9_f64, phi in 0.0..TAU,
        ) {
            let r = R * part;
            let pair = PipePair::new(r, R, theta, (R - r) * off);
            let step = 1e-5;
            let difference = (pair.depth(phi + step) - pair.depth(phi - step)) / (2.0 * step);
            let slope = pair.slope(phi, Side::After);
            prop_assert!((difference - slope).abs() < 1e-4 * R, "{difference} {slope}");
        }
    }

    #[test]
    fn equal_pipes_have_two_corners_whose_sides_slope_as_the_curve() {
        let pair = PipePair::new(40.0, 40.0, 70.0, 0.0);
        assert_eq!(pair.corners(), [FRAC_PI_2, PI + FRAC_PI_2]);
        for corner in pair.corners() {
            for (side, step) in [(Side::Before, -1e-4), (Side::After, 1e-4)] {
                let difference = (pair.depth(corner + step) - pair.depth(corner)) / step;
                assert!((difference - pair.slope(corner, side)).abs() < 1e-2, "{corner} {side:?}");
            }
        }
        assert_eq!(PipePair::new(30.0, 40.0, 70.0, -10.0).corners(), [PI + FRAC_PI_2]);
        assert!(PipePair::new(30.0, 40.0, 70.0, -9.9).corners().is_empty());
    }

    #[test]
    fn at_a_right_angle_the_first_term_is_exactly_nothing() {
        let pair = PipePair::new(30.0, 40.0, 90.0, 0.0);
        assert_eq!(pair.depth(PI), 0.0);
    }
}
