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
//! at the angle α_l to the parallel lies against the floor across itself like a circle of the radius
//!
//! > S = cos²α_l/q_m + sin²α_l/q_p
//!
//! on a plane. Two of these that are Δ apart leave
//!
//! > c = S − √(S² − Δ²/4) ≈ Δ²/(8·S).
//!
//! Balls in a hollow or on a hill of four times their radius or more leave at most 1.05 times that, up to ridges of S/2. Higher ones
//! are not planned: from there it is not far to a rib as high as the blade.
//!
//! A flat end has an infinite q_m. It reaches as far along the parallel as its flat does; a bull nose by √(2·r_c·c) farther, and it
//! holds balls of its corner's radius, so that it leaves no more than they do. Beyond the outermost lane the same laws hold with half
//! the spacing replaced by the angle beyond it.
//!
//! # Units
//! Millimetres and radians.

use crate::kinds::impeller::clear::lane::OwnNormal;
use crate::number::trig::{asin, sin, sin_cos};

/// The part of its width, or of that of its flat, by which a tool steps from lane to lane at most.
pub(super) const LAPPED: f64 = 0.9;
/// The highest ridge that rounded ends are planned for, in S.
const HIGHEST: f64 = 0.5;

/// How a rounded end lies against the floor across a lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// S, mm.
    radius: f64,
    /// Δ over the turn between lanes, mm.
    across: f64,
}

impl Round {
    /// c between lanes that are ΔC apart; without end where the two do not meet.
    fn height(&self, turn: f64) -> f64 {
        let half = self.across * turn / 2.0;
        if half < self.radius { self.radius - (self.radius * self.radius - half * half).sqrt() } else { f64::INFINITY }
    }

    /// ΔC between lanes that leave c, no more than [`HIGHEST`].
    fn turn(&self, height: f64) -> f64 {
        let height = height.min(HIGHEST * self.radius);
        2.0 * (height * (2.0 * self.radius - height)).sqrt() / self.across
    }
}

/// How an end mill lies against the floor across a lane, at one v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ridge {
    /// Of a flat end: c = r_f − √(r_f² − 4·ρ_f·R·sin²(ΔC/4)).
    Flat {
        /// r_f, radius of the floor's meridian, mm.
        r_f: f64,
        /// 4·ρ_f·R, mm².
        square: f64,
        /// The greatest turn between lanes that lap over one another.
        lapped: f64,
    },
    /// Of a ball: c = S − √(S² − Δ²/4).
    Ball(Round),
    /// Of a bull nose: no more than by its own law, nor than balls of its corner's radius leave.
    Bull {
        /// By its own law, with q_p = 1/r_f − cos v/ρ_f.
        own: Round,
        /// Of balls of its corner's radius.
        ball: Round,
        /// The greatest turn between lanes whose flats lap over one another.
        lapped: f64,
        /// By how much more two lanes may be turned for each √c.
        corner: f64,
    },
}

impl Ridge {
    /// At v, for lanes at the angle to the parallel whose sine is given.
    #[must_use]
    pub fn at(lane: &OwnNormal, v: f64, sin_l: f64) -> Self {
        let (R, r_f, r_c) = (lane.torus.R, lane.r_f, lane.tool.r_c);
        let flat = lane.tool.flat_radius();
        let cos_v = sin_cos(v).1;
        let rho_f = R + r_f * cos_v;
        let lapped = 2.0 * LAPPED * flat / rho_f;
        if r_c == 0.0 {
            return Self::Flat { r_f, square: 4.0 * rho_f * R, lapped };
        }
        let round = |across: f64| {
            let (along, across) = (1.0 / r_c - 1.0 / r_f, across - cos_v / rho_f);
            let radius = (1.0 - sin_l * sin_l) / along + sin_l * sin_l / across;
            Round { radius, across: rho_f * sin_l }
        };
        let ball = round(1.0 / r_c);
        if flat <= 0.0 {
            return Self::Ball(ball);
        }
        Self::Bull { own: round(1.0 / r_f), ball, lapped, corner: 2.0 * (2.0 * r_c).sqrt() / rho_f }
    }

    /// c between lanes that are ΔC apart, no farther than [`Self::turn`] allows; the depth of the tube where they are so far apart that
    /// they leave all.
    #[must_use]
    pub fn height(&self, turn: f64) -> f64 {
        match *self {
            Self::Flat { r_f, square, .. } => {
                let half = sin(turn / 4.0);
                r_f - (r_f * r_f - square * half * half).max(0.0).sqrt()
            }
            Self::Ball(ball) => ball.height(turn),
            Self::Bull { own, ball, lapped, corner } => {
                let beyond = ((turn - lapped) / corner).max(0.0);
                own.height(turn).max(beyond * beyond).min(ball.height(turn))
            }
        }
    }

    /// ΔC between lanes that leave c and lap over one another.
    #[must_use]
    pub fn turn(&self, height: f64) -> f64 {
        match *self {
            Self::Flat { r_f, square, lapped } => {
                let low = (r_f - height).max(0.0);
                (4.0 * asin(((r_f * r_f - low * low) / square).sqrt().min(1.0))).min(lapped)
            }
            Self::Ball(ball) => ball.turn(height),
            Self::Bull { own, ball, lapped, corner } => {
                own.turn(height).min(lapped + corner * height.sqrt()).max(ball.turn(height))
            }
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
    use crate::number::trig::hypot;

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
        for ridge in [flat, ball, bull, ridge(Tool { d: 6.0, r_c: 2.0 }), ridge(Tool { d: 6.0, r_c: 2.99 })] {
            for c in [0.005, 0.02, 0.1, 0.3] {
                assert!((ridge.height(ridge.turn(c)) - c).abs() < 1e-12, "{ridge:?} {c}");
            }
        }
    }

    #[test]
    fn two_balls_leave_what_the_law_says_however_high_the_ridge() {
        // On a plane: where they meet, a right angle goes to each centre.
        for a in [0.5, 1.5, 3.0] {
            let ball = Round { radius: a, across: 1.0 };
            for share in [0.01, 0.2, 0.5] {
                let c = share * a;
                let apart = ball.turn(c);
                assert!((hypot(apart / 2.0, a - c) - a).abs() < 1e-12 && (ball.height(apart) - c).abs() < 1e-12);
            }
            // Never so far apart that a rib is left between them.
            assert!(ball.turn(9.0) < 1.8 * a && ball.height(ball.turn(9.0)) <= a / 2.0 + 1e-12);
        }
    }

    #[test]
    fn a_bull_nose_takes_no_more_lanes_than_balls_of_its_corner() {
        let torus = Torus { R: 25.0, r: 15.0 };
        let ridge = |d: f64, r_c: f64, sin_l: f64| {
            Ridge::at(&OwnNormal::new(torus, Tool { d, r_c }, 17.0).unwrap(), 4.0, sin_l)
        };
        for sin_l in [0.3, 0.6, 0.9] {
            for c in [0.005, 0.025, 0.2] {
                let ball = ridge(3.0, 1.5, sin_l).turn(c);
                for r_c in [1.0, 1.45, 1.499] {
                    let (bull, inner) = (ridge(3.0, r_c, sin_l).turn(c), ridge(2.0 * r_c, r_c, sin_l).turn(c));
                    assert!(bull >= inner, "{r_c} {sin_l} {c}: {bull} {inner}");
                }
                assert!(ridge(3.0, 1.499, sin_l).turn(c) > 0.999 * ball, "{sin_l} {c}");
            }
        }
    }
}
