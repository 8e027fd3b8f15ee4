//! Annex 1: the angle v along the meridian.

use std::f64::consts::{FRAC_PI_2, PI};

/// v_i = π + i·h for i = 0 … n with h = (π/2)/n; the last point is backed off by `eps_v` steps.
///
/// The published tables end at v_n = 3π/2 − 1e-5·h, because an arctangent has a pole at 3π/2; with `eps_v` 0 the blade
/// goes up to the rim. Radians. n ≥ 1.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
pub fn v(n: usize, eps_v: f64) -> Vec<f64> {
    let h = FRAC_PI_2 / n as f64;
    (0..=n).map(|i| PI + h * if i == n { n as f64 - eps_v } else { i as f64 }).collect()
}
