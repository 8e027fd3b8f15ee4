//! Shank and holder against the blank.
//!
//! # Derivation
//! Beyond c the axis of an own-normal tool stays at least r away from the blank. A stage of the radius R_k from the height
//! l_k above the tip on is therefore clear of it by
//!
//! > min(r − R_k, r − √((r_t − l_k)² + R_k²)) where l_k < r_t, and by l_k − r_t, whatever its radius, where l_k ≥ r_t.
//!
//! On a flank, and where the tool leans on the floor, c is the nearest point of K, which the axis passes at m: all is m
//! less. So a stick-out of r_t + m and the clearance that is wanted is always enough; less of it only while R_k is less
//! than r. Clamps, chuck and table are not in the blank.
//!
//! # Units
//! Millimetres.

/// A stage of shank or holder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// R_k, its radius.
    pub radius: f64,
    /// l_k, how far above the tip it begins.
    pub from: f64,
}

/// How far a stage stays clear of the blank at least, in a tube of radius r, the tip r_t below K and the axis passing K at
/// m at most.
#[must_use]
pub fn clearance(stage: Stage, r: f64, r_t: f64, m: f64) -> f64 {
    let Stage { radius, from } = stage;
    let below = r_t - from;
    let clear = if below > 0.0 { (r - radius).min(r - (below * below + radius * radius).sqrt()) } else { -below };
    clear - m
}

/// The stick-out that keeps a stage of any radius clear by some clearance.
#[must_use]
pub fn stick_out(r_t: f64, m: f64, clear: f64) -> f64 {
    r_t + m + clear
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_beyond_the_middle_of_the_tube_is_clear_whatever_its_radius() {
        let clear = |radius, from| clearance(Stage { radius, from }, 15.0, 16.7, 0.0);
        assert!((clear(200.0, 18.7) - 2.0).abs() < 1e-12);
        assert!((clear(4.0, 10.0) - (15.0 - (6.7_f64 * 6.7 + 16.0).sqrt())).abs() < 1e-12);
        assert!((clear(10.0, 16.69) - 5.0).abs() < 1e-4);
        assert!(clear(20.0, 10.0) < 0.0);
        assert!(
            (clearance(Stage { radius: 200.0, from: stick_out(16.7, 4.0, 1.5) }, 15.0, 16.7, 4.0) - 1.5).abs() < 1e-12
        );
    }

    #[test]
    fn the_bound_holds_against_a_dense_search() {
        // A tube about the y axis, straight: a torus bends away from a tool inside it.
        let (r, r_t) = (15.0_f64, 16.7_f64);
        for (radius, from) in [(3.0_f64, 4.0_f64), (8.0, 9.0), (12.0, 15.0), (14.0, 16.0), (30.0, 17.5)] {
            let found = clearance(Stage { radius, from }, r, r_t, 0.0);
            // Points of the stage, seen from c: across x and along the axis z; the metal is where x² + z² ≥ r², z ≤ 0.
            let mut least = f64::INFINITY;
            for step in 0..400 {
                let z = from - r_t + f64::from(step) * 0.05;
                for side in 0..=40 {
                    let x = radius * f64::from(side) / 40.0;
                    let beside = (r - x).max(0.0);
                    let lip = (beside * beside + z * z).sqrt();
                    least = least.min(if z <= 0.0 { r - (x * x + z * z).sqrt() } else { lip });
                }
            }
            assert!(found <= least + 1e-9, "{radius} {from}: {found} {least}");
        }
    }
}
