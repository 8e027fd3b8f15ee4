//! One place of the cut: the point on the curve, the angle between the pipes there, and the torch.
//!
//! The curve is where the branch's outside, grown by the root gap b, meets the header's bore, grown by the land h. At a
//! point P of it let n be the direction out of the header, and m that in its tangent plane which leads away from the hole,
//! square to the curve. φ, the angle between the pipes seen from outside, is π less the angle between the directions out of
//! both. The torch stands in the plane of m and n at φ − γ from m: with no groove along the branch's wall, with the groove
//! angle γ leaning away from it by as much. The angle to the tangent plane is σ = asin(sin(φ − γ)).
//!
//! Where φ is less than γ the torch would stand below the tangent plane, and its beam would cross the bore and come out of the wall
//! on the other side: there is no such place. A beam that stays in the wall is taken.
//!
//! The torch is over the header's outside, so that its height is counted from where its axis leaves the wall, at Q, and from
//! the tangent plane there, which stands at σ_o to it.
//!
//! # Units
//! Millimetres and radians.

use nalgebra::Vector3;

use crate::geometry::pipe_pair::PipePair;
use crate::kinds::pipe::hole::height::{Rule, Torch};
use crate::machine::torch::TorchPose;
use crate::number::trig::{acos, asin, hypot, sin_cos};

/// What a cut is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groove {
    /// The branch's outside grown by the gap, and the header's bore grown by the land.
    pub pair: PipePair,
    /// R_o, the header's outside.
    pub R_o: f64,
    /// R_i, the radius of the header's bore.
    pub R_i: f64,
    /// γ, the groove angle.
    pub gamma: f64,
    /// Half the kerf.
    pub beside: f64,
    /// Its shape, and what is asked of its height.
    pub torch: Torch,
}

/// How far a beam may dip into the bore on its way through the wall, mm: far less than it is wide.
const DIP: f64 = 0.01;

/// One place of the cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// The angle round the branch.
    pub alpha: f64,
    /// P, the point of the curve.
    pub root: Vector3<f64>,
    /// The direction out of the header at P.
    pub normal: Vector3<f64>,
    /// The direction in its tangent plane away from the hole.
    pub away: Vector3<f64>,
    /// φ, the angle between the pipes.
    pub phi: f64,
    /// σ, the angle of the torch to the tangent plane at P.
    pub sigma: f64,
    /// Q, where the torch's axis leaves the header's outside.
    pub face: Vector3<f64>,
    /// σ_o, its angle to the tangent plane there.
    pub sigma_o: f64,
    /// D, from Q to the torch's tip along its axis.
    pub D: f64,
    /// What sets it.
    pub rule: Rule,
    /// g, the distance of the torch from the tangent plane at Q.
    pub gap: f64,
    /// The direction across the cut face into the waste.
    pub waste: Vector3<f64>,
    /// Tip and axis of the torch, seen from the pipe.
    pub pose: TorchPose,
}

impl Groove {
    /// The place at the angle α round the branch; `None` where the torch's axis does not leave the header's outside, or crosses its
    /// bore before.
    #[must_use]
    pub fn at(&self, alpha: f64) -> Option<Station> {
        let pair = &self.pair;
        let root = pair.point(alpha);
        let normal = Vector3::new(0.0, root.y, root.z).try_normalize(1e-12)?;
        let out =
            (pair.on_branch(alpha, 0.0) - pair.on_branch(alpha + std::f64::consts::PI, 0.0)).try_normalize(1e-12)?;
        // Square to n and to the direction along the curve, n × o: in the plane of n and o.
        let c = normal.dot(&out).clamp(-1.0, 1.0);
        let away = (out - normal * c).try_normalize(1e-9)?;
        let phi = std::f64::consts::PI - acos(c);
        let lean = phi - self.gamma;
        let (sin, cos) = sin_cos(lean);
        let axis = away * cos + normal * sin;
        let waste = normal * cos - away * sin;
        let beam = root + waste * self.beside;
        // |beam + s·axis| = R_o across the header's axis.
        let (a, b, c) = (
            axis.y * axis.y + axis.z * axis.z,
            beam.y * axis.y + beam.z * axis.z,
            beam.y * beam.y + beam.z * beam.z - self.R_o * self.R_o,
        );
        let inside = b * b - a * c;
        if a <= 1e-12 || inside < 0.0 {
            return None;
        }
        // Nearest to the header's axis the line of the root is at −b/a, which lies before it where the torch stands above the wall.
        let across = root.y * axis.y + root.z * axis.z;
        let bore = self.R_i - DIP;
        if across < 0.0 && root.y * root.y + root.z * root.z - across * across / a < bore * bore {
            return None;
        }
        let face = beam + axis * ((inside.sqrt() - b) / a);
        let above = Vector3::new(0.0, face.y, face.z) / hypot(face.y, face.z);
        let sigma_o = asin(axis.dot(&above).clamp(-1.0, 1.0));
        if sigma_o <= 0.0 {
            return None;
        }
        let (D, rule) = self.torch.height(sigma_o);
        Some(Station {
            alpha,
            root,
            normal,
            away,
            phi,
            sigma: asin(sin),
            face,
            sigma_o,
            D,
            rule,
            gap: self.torch.gap(D, sigma_o),
            waste,
            pose: TorchPose { tip: face + axis * D, axis },
        })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;

    fn groove(gamma: f64) -> Groove {
        Groove {
            pair: PipePair::new(30.0, 50.0, 90.0, 0.0),
            R_o: 56.0,
            R_i: 50.0,
            gamma,
            beside: 0.0,
            torch: Torch { r_g: 6.0, R_g: 15.0, Psi: 0.5, d0: 4.0, g0: 2.0 },
        }
    }

    #[test]
    fn a_square_branch_meets_the_header_squarely_at_its_crown_and_obtusely_at_its_side() {
        let crown = groove(0.0).at(0.0).unwrap();
        assert!((crown.phi - FRAC_PI_2).abs() < 1e-9 && (crown.sigma - FRAC_PI_2).abs() < 1e-6);
        // The torch stands along the branch's wall.
        assert!((crown.pose.axis - Vector3::z()).norm() < 1e-9);
        let side = groove(0.0).at(FRAC_PI_2).unwrap();
        assert!((side.phi - (FRAC_PI_2 + asin(0.6))).abs() < 1e-9);
        assert!((side.pose.axis - Vector3::z()).norm() < 1e-6, "{:?}", side.pose.axis);
    }

    #[test]
    fn the_groove_leans_the_torch_away_from_the_branch() {
        let gamma = 30.0_f64.to_radians();
        for alpha in [0.0, 0.7, FRAC_PI_2, 2.5, PI, 4.0, 5.5] {
            let (bare, open) = (groove(0.0).at(alpha).unwrap(), groove(gamma).at(alpha).unwrap());
            assert!((acos(bare.pose.axis.dot(&open.pose.axis)) - gamma).abs() < 1e-6);
            // Away from the branch's axis, which is z.
            let out = Vector3::new(open.root.x, open.root.y, 0.0);
            assert!(open.pose.axis.dot(&out) > bare.pose.axis.dot(&out));
        }
    }
}
