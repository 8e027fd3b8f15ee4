//! Annexes 6 and 7: the tool's paths along obverse and reverse.
//!
//! # References
//! The thesis, equations (20) and (21), with the signs that its tables have: the obverse lies on the side of +b″.

use nalgebra::Vector3;

use crate::kinds::impeller::blade::{Blade, Vectors};

/// Half of blade and tool together: w = (e + d_t)/2, mm.
#[must_use]
pub fn half_width(e: f64, d_t: f64) -> f64 {
    (e + d_t) / 2.0
}

/// P″ + w·b″ − a_p·N″ with N″ = (0, 0, 1): the tool tip at the offset `w` across the blade and the depth `a_p`, in
/// machine coordinates (mm). The obverse has w > 0, the reverse w < 0.
#[must_use]
pub fn tool_path(blade: &Blade, w: f64, a_p: f64) -> Vectors {
    tapered(blade, a_p, |_| w)
}

/// The tool path whose offset changes along the blade: `w(i)` at the point i.
#[must_use]
pub fn tapered(blade: &Blade, a_p: f64, w: impl Fn(usize) -> f64) -> Vectors {
    let depth = Vector3::new(0.0, 0.0, a_p);
    blade.machine.iter().enumerate().map(|(i, P)| P + blade.b_machine * w(i) - depth).collect()
}

/// The same path in the part frame: P + w·b − a_p·N, mm.
#[must_use]
pub fn part_path(blade: &Blade, w: f64, a_p: f64) -> Vec<Vector3<f64>> {
    blade.P.iter().zip(blade.b.iter().zip(blade.N.iter())).map(|(P, (b, N))| P + b * w - N * a_p).collect()
}
