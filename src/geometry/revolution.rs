//! Volumes of revolution about the axis r = 0.

use std::f64::consts::PI;

/// What an edge from one `[z, r]` to another adds to the volume of the body that a contour makes when turned about the
/// axis, mm³: positive where the contour runs counter-clockwise with the body to its left.
///
/// V = −∮ π r² dz, and along a straight edge ∫ r² dz = Δz (r₁² + r₁ r₂ + r₂²)/3: the frustum of a cone, by Pappus.
#[must_use]
pub fn frustum(from: [f64; 2], to: [f64; 2]) -> f64 {
    PI * (from[0] - to[0]) * (from[1] * from[1] + from[1] * to[1] + to[1] * to[1]) / 3.0
}

/// The volume of the body that a closed contour makes when turned about the axis, mm³; negative for a clockwise one, as a
/// hole is.
#[must_use]
pub fn volume(ring: &[[f64; 2]]) -> f64 {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&from, &to)| frustum(from, to)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cylinder_a_cone_and_a_tube_have_the_volumes_of_the_tables() {
        let cylinder = [[0.0, 0.0], [10.0, 0.0], [10.0, 3.0], [0.0, 3.0]];
        assert!((volume(&cylinder) - PI * 90.0).abs() < 1e-12);
        let cone = [[0.0, 0.0], [12.0, 0.0], [0.0, 5.0]];
        assert!((volume(&cone) - PI * 100.0).abs() < 1e-11);
        let tube = [[-4.0, 2.0], [6.0, 2.0], [6.0, 5.0], [-4.0, 5.0]];
        assert!((volume(&tube) - PI * 210.0).abs() < 1e-11);
        let hole: Vec<_> = tube.iter().rev().copied().collect();
        assert!((volume(&hole) + PI * 210.0).abs() < 1e-11);
    }
}
