//! The Darboux frame along a curve on a surface.
//!
//! # References
//! The thesis, section 2.2.3 and annex 3; the signs are those of its tables.

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::geometry::villarceau::Villarceau;

/// Three unit vectors, orthogonal to each other: normal to the surface, tangent to the curve, and b = t × N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Darboux {
    /// N, out of the metal.
    pub N: Vector3<f64>,
    /// t, along the curve.
    pub t: Vector3<f64>,
    /// b = t × N, across the curve on the surface.
    pub b: Vector3<f64>,
}

impl Darboux {
    /// The frame of a Villarceau circle at (u, v): t = (X_u·du/dv + X_v)/R, since |dX/dv| = R.
    #[must_use]
    pub fn of(circle: Villarceau, u: f64, v: f64) -> Self {
        let [along_u, along_v] = circle.torus.derivatives(u, v);
        let N = Torus::inward_normal(u, v);
        let t = (along_u * circle.du_dv(v) + along_v) / circle.torus.R;
        Self { N, t, b: t.cross(&N) }
    }
}

/// A direction the other way, number by number: a vector's own minus is a loop, which not every place unrolls.
#[inline]
#[must_use]
pub fn opposite(of: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-of.x, -of.y, -of.z)
}
