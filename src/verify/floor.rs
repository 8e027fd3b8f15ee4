//! The floor: a flat end mill on a concave meridian cuts deeper at its rim than in its middle.
//!
//! Across a meridian of radius r, the rim at d_t/2 from the middle lies r − √(r² − (d_t/2)²) below the arc through the
//! middle. The floor itself is a_p below the torus and has the radius r + a_p, so that against the floor the same formula
//! holds with r + a_p. Both take the middle to be on the arc. It is not: the tip stands w beside the mean line in the
//! mean line's tangent plane. So the rim is also measured, in the poses that the text gives, against the torus of
//! radius r + a_p. Derived here.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::impeller::design::Design;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::Rotary;
use crate::number::trig::{hypot, sin_cos};
use crate::verify::agreement::tip;

/// Poses of a pass that are looked at.
pub const POSES: usize = 96;
/// Directions in which the rim is looked at.
const DIRECTIONS: u16 = 48;

/// How much deeper the rim of a flat end mill cuts than its middle across a meridian of some radius, mm.
#[must_use]
pub fn rim(radius: f64, d_t: f64) -> f64 {
    let half = d_t / 2.0;
    radius - (radius * radius - half * half).max(0.0).sqrt()
}

/// How far the deepest point of the tool's rim in a pose lies below the floor, mm.
#[must_use]
pub fn below_floor(design: &Design, pose: &Pose) -> f64 {
    let Torus { R, r } = design.torus;
    let angle = |axis: Axis| pose.get(axis).to_radians();
    let direction = |a: Vector3<f64>| Rotary::direction_to_part(&a, angle(Axis::B), angle(Axis::C));
    let (first, second) = (direction(Vector3::x()), direction(Vector3::y()));
    let middle = tip(design.machine, pose);
    (0..DIRECTIONS)
        .map(|at| {
            let (sin, cos) = sin_cos(TAU * f64::from(at) / f64::from(DIRECTIONS));
            let point = middle + (first * cos + second * sin) * (design.d_t / 2.0);
            hypot(hypot(point.x, point.y) - R, point.z) - (r + design.a_p)
        })
        .fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use super::rim;

    #[test]
    fn a_6_mm_end_mill_cuts_0_303_mm_too_deep_on_a_meridian_of_15_mm() {
        assert_eq!(format!("{:.3}", rim(15.0, 6.0)), "0.303");
        assert_eq!(format!("{:.3}", rim(17.0, 6.0)), "0.267");
        assert_eq!(rim(3.0, 6.0), 3.0);
    }
}
