//! Calibration of the B axis from two slots cut at B = 0° and B = 90°.
//!
//! # Units
//! Millimetres and radians.
//!
//! # References
//! The thesis, section 5.2, equations (37) to (39), corrected: with a = H − e_x + d_t/2, b = H − d_w/2 + e_z,
//! D = R_B + a and E = R_B + b, the slot at B = 90° gives −x0 = D cos B − E sin B and −z0 = D sin B + E cos B. Squared
//! and added: x0² + z0² = D² + E², a quadratic in R_B without any small-angle step.

use crate::number::root::quadratic;
use crate::number::trig::atan2;

/// What was set and measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slots {
    /// H, height of the part above the spindle.
    pub H: f64,
    /// d_w, width of the part through its centre.
    pub d_w: f64,
    /// e_z, depth of the slot in Z.
    pub e_z: f64,
    /// e_x, depth of the slot in X.
    pub e_x: f64,
    /// d_t, diameter of the tool.
    pub d_t: f64,
    /// x0, X programmed at B = 90°.
    pub x0: f64,
    /// z0, Z programmed at B = 90°.
    pub z0: f64,
}

/// Spindle height and deviation of the B axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// R_B, height of the spindle above the axis of rotation.
    pub R_B: f64,
    /// B, deviation of the axis in radians.
    pub B: f64,
}

impl Slots {
    /// a = H − e_x + d_t/2.
    #[must_use]
    pub fn a(&self) -> f64 {
        self.H - self.e_x + self.d_t / 2.0
    }

    /// b = H − d_w/2 + e_z.
    #[must_use]
    pub fn b(&self) -> f64 {
        self.H - self.d_w / 2.0 + self.e_z
    }

    /// The two solutions of 2R_B² + 2(a+b)R_B + a² + b² − x0² − z0² = 0, the smaller R_B first; none where the slots
    /// cannot have been cut on one machine.
    #[must_use]
    pub fn exact(&self) -> Option<[Axis; 2]> {
        let (a, b) = (self.a(), self.b());
        let roots = quadratic(2.0, 2.0 * (a + b), a * a + b * b - self.x0 * self.x0 - self.z0 * self.z0)?;
        Some(roots.map(|R_B| self.with_angle(R_B)))
    }

    /// The printed small-angle form, D² + x0·D + E² + z0·E = 0 (cos B = 1, sin B = B), in its corrected signs:
    /// 2R_B² + R_B(2(a+b) + x0 + z0) + a² + b² + a·x0 + b·z0 = 0.
    #[must_use]
    pub fn small_angle(&self) -> Option<[Axis; 2]> {
        let (a, b) = (self.a(), self.b());
        let roots = quadratic(2.0, 2.0 * (a + b) + self.x0 + self.z0, a * a + b * b + a * self.x0 + b * self.z0)?;
        // −x0 = D − E·B gives B in the same approximation.
        Some(roots.map(|R_B| Axis { R_B, B: (R_B + a + self.x0) / (R_B + b) }))
    }

    /// B from −x0 = D cos B − E sin B and −z0 = D sin B + E cos B:
    /// (D, E) turned by B is (−x0, −z0), so B is the difference of their directions.
    fn with_angle(&self, R_B: f64) -> Axis {
        let (D, E) = (R_B + self.a(), R_B + self.b());
        let B = atan2(E * self.x0 - D * self.z0, -(D * self.x0 + E * self.z0));
        Axis { R_B, B }
    }
}

/// The solution whose R_B lies nearest to the nominal spindle height.
#[must_use]
pub fn nearest(solutions: [Axis; 2], nominal: f64) -> Axis {
    let [one, other] = solutions;
    if (one.R_B - nominal).abs() <= (other.R_B - nominal).abs() { one } else { other }
}
