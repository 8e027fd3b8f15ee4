//! Transcendental functions, all from `libm`: those of the standard library differ in the last digit between
//! platforms, and the same workbook must give the same bytes everywhere. Angles in radians.

pub use libm::{acos, asin, atan, atan2, cos, exp, hypot, log, log10, pow, sin, tan};

/// Sine and cosine of one angle.
#[inline]
#[must_use]
pub fn sin_cos(angle: f64) -> (f64, f64) {
    libm::sincos(angle)
}
