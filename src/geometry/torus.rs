//! The torus.
//!
//! # Units
//! Millimetres and radians. Z is the axis, the origin is in the centre plane.
//!
//! # References
//! The thesis, equation (4).

use nalgebra::Vector3;

use crate::number::trig::sin_cos;

/// A ring torus: the circle of radius r about a point at distance R from the axis, turned about the axis.
///
/// u is the angle about the axis, v the angle on the meridian circle, 0 on the outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    /// R, axis to the centre of the meridian.
    pub R: f64,
    /// r, radius of the meridian. 0 < r < R.
    pub r: f64,
}

impl Torus {
    /// ρ = R + r cos v, distance from the axis.
    #[inline]
    #[must_use]
    pub fn rho(self, v: f64) -> f64 {
        self.R + self.r * sin_cos(v).1
    }

    /// The point P(u, v), mm: (ρ cos u, ρ sin u, r sin v).
    #[must_use]
    pub fn point(self, u: f64, v: f64) -> Vector3<f64> {
        let (sin_u, cos_u) = sin_cos(u);
        let (sin_v, cos_v) = sin_cos(v);
        let rho = self.R + self.r * cos_v;
        Vector3::new(rho * cos_u, rho * sin_u, self.r * sin_v)
    }

    /// The unit normal N that points from the metal into the tube's hollow: −(cos v cos u, cos v sin u, sin v).
    #[must_use]
    pub fn inward_normal(u: f64, v: f64) -> Vector3<f64> {
        let (sin_u, cos_u) = sin_cos(u);
        let (sin_v, cos_v) = sin_cos(v);
        Vector3::new(-cos_v * cos_u, -cos_v * sin_u, -sin_v)
    }

    /// The derivatives X_u and X_v of the point.
    #[must_use]
    pub fn derivatives(self, u: f64, v: f64) -> [Vector3<f64>; 2] {
        let (sin_u, cos_u) = sin_cos(u);
        let (sin_v, cos_v) = sin_cos(v);
        let rho = self.R + self.r * cos_v;
        [
            Vector3::new(-rho * sin_u, rho * cos_u, 0.0),
            Vector3::new(-self.r * sin_v * cos_u, -self.r * sin_v * sin_u, self.r * cos_v),
        ]
    }
}
