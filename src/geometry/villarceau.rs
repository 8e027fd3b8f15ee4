//! The Villarceau circle of a torus: the circle of radius R in the plane through the centre that touches the tube
//! twice.
//!
//! # Units
//! Radians.
//!
//! # References
//! The thesis, equation (6), in the corrected form: with k = √(R² − r²) and ρ = R + r cos v,
//! cos u = k sin v / ρ and sin u = −(r + R cos v) / ρ. The printed arccosine gives the cosine alone and holds up to u = π
//! only. The derivative dv/du = ρ/k follows from dX/dv having the length R everywhere.

use std::f64::consts::TAU;

use crate::geometry::torus::Torus;
use crate::number::trig::{asin, atan2, sin_cos};

/// The Villarceau circle through (u, v) = (π/2, π).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Villarceau {
    /// The torus on which it lies, its R and r in mm.
    pub torus: Torus,
    /// k = √(R² − r²).
    pub k: f64,
}

impl Villarceau {
    /// The circle on a torus with 0 < r < R.
    #[must_use]
    pub fn new(torus: Torus) -> Self {
        Self { torus, k: ((torus.R - torus.r) * (torus.R + torus.r)).sqrt() }
    }

    /// α, the angle between the circle's plane and the centre plane and the angle at which it cuts every parallel:
    /// sin α = r/R.
    #[must_use]
    pub fn alpha(self) -> f64 {
        asin(self.torus.r / self.torus.R)
    }

    /// u, radians in [0, 2π), of the circle's point at v (radians).
    #[must_use]
    pub fn u(self, v: f64) -> f64 {
        let (sin_v, cos_v) = sin_cos(v);
        // The common factor 1/ρ > 0 does not change the angle.
        let u = atan2(-(self.torus.r + self.torus.R * cos_v), self.k * sin_v);
        if u < 0.0 { u + TAU } else { u }
    }

    /// du/dv = k/ρ at v, radians a radian.
    #[must_use]
    pub fn du_dv(self, v: f64) -> f64 {
        self.k / self.torus.rho(v)
    }
}
