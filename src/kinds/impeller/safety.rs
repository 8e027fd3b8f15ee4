//! Annex 8: the safe points before and after the passes.
//!
//! # References
//! The thesis, equations (23) to (32), corrected: tan β is the ratio, and the increments at the entry are negative.

use nalgebra::Vector3;

use crate::number::trig::{atan2, cos, tan};

/// The safe points at one end of the blade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SafeEnd {
    /// β, inclination of the blade's end section, radians.
    pub beta: f64,
    /// Δx and Δy from the end of the obverse pass to its safe point, mm.
    pub step_obverse: [f64; 2],
    /// Δx and Δy from the end of the reverse pass to its safe point, mm.
    pub step_reverse: [f64; 2],
    /// The safe point of the obverse, mm.
    pub obverse: Vector3<f64>,
    /// The safe point of the reverse, mm. Both have one x, so that the tool crosses in y alone.
    pub reverse: Vector3<f64>,
}

/// The end of the blade at which a pass begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// B = 90°: the safe points lie towards −x.
    Entry,
    /// B = 0°: the safe points lie towards +x.
    Exit,
}

/// The safe points at an end, from the end points of the passes (machine coordinates), the safety distance d_s, the
/// tool's diameter d_t and the half width w (mm): tan β = (y_r − y_a)/(x_a − x_r); at the entry
/// Δx_a = −(d_s + d_t/2 + w cos β), Δx_r = −(d_s + d_t/2 − w cos β), at the exit
/// Δx_a = d_s + d_t/2 − w cos β, Δx_r = d_s + d_t/2 + w cos β; Δy = Δx/tan β.
///
/// Both safe points lie the distance d_s + d_t/2 outside the end of the mean line.
#[must_use]
pub fn safe_end(end: End, obverse: &Vector3<f64>, reverse: &Vector3<f64>, d_s: f64, d_t: f64, w: f64) -> SafeEnd {
    let beta = atan2(reverse.y - obverse.y, obverse.x - reverse.x);
    let (reach, across) = (d_s + d_t / 2.0, w * cos(beta));
    let (obverse_x, reverse_x) = match end {
        End::Entry => (-(reach + across), -(reach - across)),
        End::Exit => (reach - across, reach + across),
    };
    let step = |x: f64| [x, x / tan(beta)];
    let (step_obverse, step_reverse) = (step(obverse_x), step(reverse_x));
    SafeEnd {
        beta,
        step_obverse,
        step_reverse,
        obverse: obverse + Vector3::new(step_obverse[0], step_obverse[1], 0.0),
        reverse: reverse + Vector3::new(step_reverse[0], step_reverse[1], 0.0),
    }
}
