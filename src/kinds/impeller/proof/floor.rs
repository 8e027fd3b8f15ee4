//! The floor: a flat end mill on a concave meridian cuts deeper at its rim than in its middle.
//!
//! # Derivation
//! Across a meridian of radius r, the rim at d_t/2 from the middle lies r − √(r² − (d_t/2)²) below the arc through the
//! middle. The floor itself is a_p below the torus and has the radius r + a_p, so that against the floor the same formula
//! holds with r + a_p. Both take the middle to be on the arc. It is not: the tip stands w beside the mean line in the
//! mean line's tangent plane. How deep the rim really reaches over all blocks is bounded by
//! [`floor_depth`](crate::kinds::impeller::floor_depth) and reported with the plan's shortfalls.

/// How much deeper the rim of a flat end mill cuts than its middle across a meridian of some radius, mm.
#[must_use]
pub fn rim(radius: f64, d_t: f64) -> f64 {
    let half = d_t / 2.0;
    radius - (radius * radius - half * half).max(0.0).sqrt()
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
