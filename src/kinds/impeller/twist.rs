//! Which way a face of a blade looks along a ruling.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use nalgebra::Vector3;

use crate::geometry::darboux::Darboux;
use crate::geometry::torus::Torus;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::trig::sin_cos;

/// How a face turns along a ruling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist {
    /// Across the face where the ruling meets the tangent plane.
    at_foot: Vector3<f64>,
    /// What is added to it for each millimetre of depth.
    deeper: Vector3<f64>,
}

impl Twist {
    /// How a face of a part turns along its ruling at v.
    ///
    /// # Derivation
    /// With S' of [`Part::change`], n = σ·S' × N = σ·(b·(1 − σ(e/2)κ_g + h·κ_t) − t·h·τ), since t × N = b and b × N = −t. The
    /// straight ends are planes.
    #[must_use]
    pub fn new(part: &Part, face: Face, v: f64) -> Self {
        let Torus { R, r } = part.circle.torus;
        let (side, k, Darboux { t, b, .. }) = (face.side(), part.circle.k, part.frame(v).1);
        if !(HUB..=RIM).contains(&v) {
            return Self { at_foot: b * (side * R), deeper: Vector3::zeros() };
        }
        let cos = sin_cos(v).1;
        let rho = R + r * cos;
        // R·κ_t, −R·κ_g and R·τ.
        let along = r / R + k * k / R * cos / rho;
        let aside = (1.0 - along * along).max(0.0).sqrt();
        Self { at_foot: b * (side * (R + side * part.e / 2.0 * aside)), deeper: (b * along - t * (k / rho)) * side }
    }

    /// Across the face at the depth h, away from the blade; as long as the face's points move aside of the ruling, in mm for
    /// each radian of v.
    #[must_use]
    pub fn normal(&self, h: f64) -> Vector3<f64> {
        self.at_foot + self.deeper * h
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_square_to_the_face() {
        for (R, r, e, a_p) in [(25.0, 15.0, 2.0, 2.0), (25.0, 17.0, 1.0, 4.0), (50.0, 30.0, 9.0, 3.0)] {
            let part = Part::with(Torus { R, r }, e, a_p);
            for face in Face::ALL {
                for v in [HUB - 0.02, 3.3, 4.0, 4.6, RIM + 0.02] {
                    let (step, twist) = (1e-5, Twist::new(&part, face, v));
                    for h in [-0.1, 0.7 * part.a_p, part.a_p] {
                        let [before, after] = [-step, step].map(|off| part.ruling(face, v + off).at(h));
                        let (N, along) = (part.ruling(face, v).N, (after - before) / (2.0 * step));
                        let out = along.cross(&N) * face.side();
                        assert!((out - twist.normal(h)).norm() < 1e-6, "{v} {h} {out} {twist:?}");
                        assert!(out.dot(&part.frame(v).1.b) * face.side() > 0.0);
                    }
                }
            }
        }
    }
}
