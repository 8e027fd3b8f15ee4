//! A torch over a turning pipe: axes A, X, Z, B and C.
//!
//! The pipe lies along X and turns about it. As ISO 841 has it for every axis, A counts how the torch goes round the pipe,
//! by the right hand about +X: the pipe itself turns the other way. The torch stands over its axis (Y = 0): X along the pipe
//! and Z up from the pipe's axis are the place of its tip; B tilts it from the vertical and C swings the tilt about it, 0
//! towards +X. B and C turn the torch about its tip: a head made so, or a control that keeps the tip in its place.
//!
//! # Derivation
//! The pipe turns by −A about +X, so that a point of it at (x, y, z) with A = 0 stands at
//! (x, y cos A + z sin A, z cos A − y sin A).
//!
//! # Units
//! Millimetres and radians.

use nalgebra::Vector3;

use crate::number::trig::{acos, atan2, hypot, sin_cos};

/// Where the torch is, seen from the pipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorchPose {
    /// The middle of the torch's tip.
    pub tip: Vector3<f64>,
    /// The direction of the torch's axis, from the tip upwards, of length 1.
    pub axis: Vector3<f64>,
}

/// Where the five axes stand: X and Z in mm, A, B and C in radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TorchAxes {
    /// A, how far the torch has gone round the pipe.
    pub A: f64,
    /// X, along the pipe.
    pub X: f64,
    /// Z, up from the pipe's axis.
    pub Z: f64,
    /// B, tilt from the vertical: 0 … π from [`TorchPose::axes`]; signed where C does not swing round.
    pub B: f64,
    /// C, swing of the tilt.
    pub C: f64,
}

fn about_x(point: &Vector3<f64>, angle: f64) -> Vector3<f64> {
    let (sin, cos) = sin_cos(angle);
    Vector3::new(point.x, point.y * cos - point.z * sin, point.y * sin + point.z * cos)
}

impl TorchPose {
    /// The axes that bring the torch into the pose: the pipe turned so that the tip stands over its axis. A and C are
    /// between −π and π; upright C is 0.
    #[must_use]
    pub fn axes(&self) -> TorchAxes {
        let A = atan2(-self.tip.y, self.tip.z);
        let axis = about_x(&self.axis, -A);
        let across = hypot(axis.x, axis.y);
        TorchAxes {
            A,
            X: self.tip.x,
            Z: hypot(self.tip.y, self.tip.z),
            B: if across < 1e-12 { 0.0 } else { acos(axis.z.clamp(-1.0, 1.0)) },
            C: if across < 1e-12 { 0.0 } else { atan2(axis.y, axis.x) },
        }
    }
}

impl TorchAxes {
    /// The pose that the axes bring the torch into.
    #[must_use]
    pub fn pose(&self) -> TorchPose {
        let (sin_B, cos_B) = sin_cos(self.B);
        let (sin_C, cos_C) = sin_cos(self.C);
        TorchPose {
            tip: about_x(&Vector3::new(self.X, 0.0, self.Z), self.A),
            axis: about_x(&Vector3::new(sin_B * cos_C, sin_B * sin_C, cos_B), self.A),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn inverse_and_forward_agree(
            x in -500.0..500.0_f64, y in -300.0..300.0_f64, z in -300.0..300.0_f64,
            tilt in 0.0..PI, swing in -PI..PI,
        ) {
            let (sin, cos) = sin_cos(tilt);
            let (s, c) = sin_cos(swing);
            let pose = TorchPose { tip: Vector3::new(x, y, z), axis: Vector3::new(sin * c, sin * s, cos) };
            let back = pose.axes().pose();
            prop_assert!((back.tip - pose.tip).norm() < 1e-9 && (back.axis - pose.axis).norm() < 1e-7);
        }
    }

    #[test]
    fn a_counts_the_torch_round_the_pipe_by_the_right_hand() {
        // From +Z by the right hand about +X towards −Y.
        let pose = TorchAxes { A: PI / 2.0, X: 0.0, Z: 50.0, B: 0.0, C: 0.0 }.pose();
        assert!((pose.tip - Vector3::new(0.0, -50.0, 0.0)).norm() < 1e-12, "{:?}", pose.tip);
    }

    #[test]
    fn a_torch_leaning_along_the_pipe_needs_no_turn() {
        let (sin, cos) = sin_cos(0.5);
        let pose = TorchPose { tip: Vector3::new(10.0, 0.0, 60.0), axis: Vector3::new(sin, 0.0, cos) };
        let axes = pose.axes();
        assert_eq!((axes.A, axes.X, axes.Z, axes.C), (0.0, 10.0, 60.0, 0.0));
        assert!((axes.B - 0.5).abs() < 1e-12);
    }
}
