//! What stands in the way in a channel: the faces of its two blades, and the splitter between them with its half-round nose.
//!
//! # Derivation
//! A splitter is the same blade turned by −π/N, from v_s on. Its leading edge is a half round of the radius e/2 about its
//! mean ruling at v_s, on the side of −t; its faces meet that within (e/2)(hτ)²/2. An axis is as far from it as from its
//! faces and its nose, and inside where it is nearer to the mean surface than e/2.
//!
//! # Units
//! Millimetres and radians.

use crate::kinds::impeller::nearest::{Axis, Wall};
use crate::kinds::impeller::part::{Face, Part};
use crate::number::trig::sin_cos;
use nalgebra::Vector3;

/// An axis turned about that of the part.
#[must_use]
pub fn turned(axis: &Axis, by: f64) -> Axis {
    let (sin, cos) = sin_cos(by);
    let turn =
        |vector: Vector3<f64>| Vector3::new(vector.x * cos - vector.y * sin, vector.x * sin + vector.y * cos, vector.z);
    Axis { foot: turn(axis.foot), along: turn(axis.along), range: axis.range }
}

/// A splitter, in the channel that begins at blade 0's obverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// v_s, where it begins.
    pub v_s: f64,
    /// The angle by which it is turned from blade 0.
    pub turn: f64,
    half: f64,
    wall: Wall,
}

impl Body {
    /// The splitter of a part, turned from blade 0, from v_s on, as a tool of the radius a needs it.
    #[must_use]
    pub fn new(part: &Part, v_s: f64, turn: f64, a: f64) -> Self {
        Self { v_s, turn, half: part.e / 2.0, wall: Wall::new(part, a).from(v_s) }
    }

    /// How far an axis is from it; negative inside.
    #[must_use]
    pub fn apart(&self, axis: &Axis) -> f64 {
        let axis = turned(axis, -self.turn);
        let (middle, _) = self.wall.from_middle(&axis);
        if middle < self.half {
            return middle - self.half;
        }
        let nose = self.wall.from_ruling(self.v_s, &axis) - self.half;
        Face::ALL.into_iter().map(|face| self.wall.nearest(face, &axis, None).0).fold(nose, f64::min)
    }
}

/// All that a tool in a channel may meet.
#[derive(Clone, Debug)]
pub struct Obstacles {
    wall: Wall,
    pitch: f64,
    /// The splitter.
    pub body: Option<Body>,
}

impl Obstacles {
    /// Those in a channel of a part whose blades stand `pitch` apart, as a tool of the radius a needs them.
    #[must_use]
    pub fn new(part: &Part, pitch: f64, a: f64, v_s: Option<f64>) -> Self {
        let body = v_s.map(|v_s| Body::new(part, v_s, -pitch / 2.0, a));
        Self { wall: Wall::new(part, a), pitch, body }
    }

    /// How far an axis is from the obverse of blade 0.
    #[must_use]
    pub fn from_obverse(&self, axis: &Axis) -> f64 {
        self.wall.nearest(Face::Obverse, axis, None).0
    }

    /// How far it is from the reverse of the next blade.
    #[must_use]
    pub fn from_reverse(&self, axis: &Axis) -> f64 {
        self.wall.nearest(Face::Reverse, &turned(axis, self.pitch), None).0
    }

    /// How far it is from the splitter; infinite where there is none.
    #[must_use]
    pub fn from_splitter(&self, axis: &Axis) -> f64 {
        self.body.as_ref().map_or(f64::INFINITY, |body| body.apart(axis))
    }
}
