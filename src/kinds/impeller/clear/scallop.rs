//! The ridges that lanes leave on the floor.
//!
//! # Derivation
//! A flat end touches the floor at two points of the meridian circle through c, θ to both sides. Two balls of radius r_f
//! about points of K that are ΔC apart meet on a circle whose deepest point at v is, with ρ_f = R + r_f·cos v,
//!
//! > c = r_f − √(r_f² − 4·ρ_f·R·sin²(ΔC/4))
//!
//! above the floor. A ball or bull-nose end is a surface of its own: with q_m = 1/r_c − 1/r_f and q_p = 1/r_c − cos v/ρ_f
//! (ball) or 1/r_f − cos v/ρ_f (bull nose) its curvature against the floor along the meridian and along the parallel, a lane
//! at the angle α_l to the parallel and Δ across,
//!
//! > c = Δ²/(8(cos²α_l/q_m + sin²α_l/q_p)).
//!
//! A flat end has an infinite q_m. Beyond the outermost lane the same laws hold with half the spacing replaced by the angle
//! beyond it.
//!
//! # Units
//! Millimetres and radians.

use crate::kinds::impeller::clear::lane::OwnNormal;
use crate::number::trig::{asin, sin, sin_cos};

/// How an end mill lies against the floor across a lane, at one v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ridge {
    /// Of a flat end.
    Flat {
        /// r_f.
        r_f: f64,
        /// 4·ρ_f·R.
        square: f64,
    },
    /// Of a rounded end: c over the square of the turn between lanes.
    Round {
        /// What the square of the turn is multiplied by.
        factor: f64,
    },
}

impl Ridge {
    /// At v, for lanes at the angle to the parallel whose sine is given.
    #[must_use]
    pub fn at(lane: &OwnNormal, v: f64, sin_l: f64) -> Self {
        let (R, r_f, r_c) = (lane.torus.R, lane.r_f, lane.tool.r_c);
        let cos_v = sin_cos(v).1;
        let rho_f = R + r_f * cos_v;
        if r_c == 0.0 {
            return Self::Flat { r_f, square: 4.0 * rho_f * R };
        }
        let along = 1.0 / r_c - 1.0 / r_f;
        let across = if lane.tool.flat_radius() > 0.0 { 1.0 / r_f } else { 1.0 / r_c } - cos_v / rho_f;
        let spread = (1.0 - sin_l * sin_l) / along + sin_l * sin_l / across;
        Self::Round { factor: (rho_f * sin_l) * (rho_f * sin_l) / (8.0 * spread) }
    }

    /// c between lanes that are ΔC apart; the depth of the tube where they are so far apart that they leave all.
    #[must_use]
    pub fn height(&self, turn: f64) -> f64 {
        match *self {
            Self::Flat { r_f, square } => {
                let half = sin(turn / 4.0);
                r_f - (r_f * r_f - square * half * half).max(0.0).sqrt()
            }
            Self::Round { factor } => factor * turn * turn,
        }
    }

    /// ΔC between lanes that leave c.
    #[must_use]
    pub fn turn(&self, height: f64) -> f64 {
        match *self {
            Self::Flat { r_f, square } => {
                let low = (r_f - height).max(0.0);
                4.0 * asin(((r_f * r_f - low * low) / square).sqrt().min(1.0))
            }
            Self::Round { factor } => (height / factor).sqrt(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::geometry::torus::Torus;
    use crate::kinds::impeller::clear::tool::Tool;
    use crate::kinds::impeller::part::RIM;

    #[test]
    fn ridges_and_spacings_are_those_of_the_check_values() {
        for (R, r, a_p, height, step) in [
            (25.0, 15.0, 2.0, 0.018_176, 3.778_844),
            (25.0, 17.0, 4.0, 0.011_505, 4.200_231),
            (50.0, 30.0, 3.0, 0.038_476, 2.632_772),
        ] {
            let lane = OwnNormal::new(Torus { R, r }, Tool::flat(6.0), r + a_p).unwrap();
            let middle = Ridge::at(&lane, PI * 1.25, r / R);
            assert!((middle.height(5.0_f64.to_radians()) - height).abs() < 5.1e-7);
            let rim = Ridge::at(&lane, RIM, r / R).turn(0.02);
            assert!((rim.to_degrees() - step).abs() < 5.1e-7, "{}", rim.to_degrees());
        }
    }

    #[test]
    fn a_round_end_leaves_ridges_that_go_with_its_radius() {
        let torus = Torus { R: 25.0, r: 15.0 };
        let ridge = |tool| Ridge::at(&OwnNormal::new(torus, tool, 17.0).unwrap(), 4.0, 0.6);
        let (flat, ball, bull) = (ridge(Tool::flat(6.0)), ridge(Tool::ball(6.0)), ridge(Tool { d: 6.0, r_c: 0.05 }));
        assert!(ball.height(0.05) > flat.height(0.05), "{ball:?} {flat:?}");
        // A corner of next to no radius is a flat end.
        assert!((bull.height(0.05) / flat.height(0.05) - 1.0).abs() < 0.02);
        for ridge in [flat, ball, bull] {
            assert!((ridge.height(ridge.turn(0.02)) - 0.02).abs() < 1e-12);
        }
    }
}
