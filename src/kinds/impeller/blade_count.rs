//! Equations (33) to (35): how many blades fit at the hub, and how thick they may be.
//!
//! Lengths in mm. The circumference at the bottom of the cut is 2π(R − r − a_p).

use std::f64::consts::TAU;

use crate::geometry::torus::Torus;

/// d = 4/3·d_t: the least gap between blades, the tool oversized by a third.
#[must_use]
pub fn least_gap(d_t: f64) -> f64 {
    d_t * 4.0 / 3.0
}

/// 2π(R − r − a_p), the circumference at the hub at the bottom of the cut.
#[must_use]
pub fn hub_circumference(torus: Torus, a_p: f64) -> f64 {
    TAU * (torus.R - torus.r - a_p)
}

/// N_max = ⌊2π(R − r − a_p)/(e + d)⌋, as a whole number in floating point; negative where the hub has no room at all.
#[must_use]
pub fn N_max(torus: Torus, a_p: f64, e: f64, d_t: f64) -> f64 {
    (hub_circumference(torus, a_p) / (e + least_gap(d_t))).floor()
}

/// e_max = 2π(R − r − a_p)/N − d.
#[must_use]
pub fn e_max(torus: Torus, a_p: f64, N: u32, d_t: f64) -> f64 {
    hub_circumference(torus, a_p) / f64::from(N) - least_gap(d_t)
}
