//! What stands in the way in a channel: the faces of its two blades, and the splitter between them with its half-round nose.
//!
//! # Derivation
//! A splitter is the same blade turned by −π/N, from v_s on. Its leading edge is a half round of the radius e/2 about its
//! mean ruling at v_s, on the side of −t; its faces meet that within (e/2)(hτ)²/2. An axis is as far from it as from its
//! faces and its nose, and inside where it is nearer to the mean surface than e/2.
//!
//! # Units
//! Millimetres and radians.

use crate::kinds::impeller::nearest::{Axis, HalfRound, Wall};
use crate::kinds::impeller::part::{Face, Part};
use crate::number::trig::sin_cos;
use nalgebra::Vector3;

/// The turn of vectors about the axis of the part.
pub fn turn(by: f64) -> impl Fn(&Vector3<f64>) -> Vector3<f64> {
    let (sin, cos) = sin_cos(by);
    move |vector| Vector3::new(vector.x * cos - vector.y * sin, vector.x * sin + vector.y * cos, vector.z)
}

/// An axis turned about that of the part.
#[must_use]
pub fn turned(axis: &Axis, by: f64) -> Axis {
    let turn = turn(by);
    Axis { foot: turn(&axis.foot), along: turn(&axis.along), range: axis.range }
}

/// A splitter, in the channel that begins at blade 0's obverse.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// v_s, where it begins.
    pub v_s: f64,
    /// The angle by which it is turned from blade 0.
    pub turn: f64,
    half: f64,
    wall: Wall,
    nose: HalfRound,
}

impl Body {
    /// The splitter of a part, turned from blade 0, from v_s on, as a tool of the radius a needs it.
    #[must_use]
    pub fn new(part: &Part, v_s: f64, turn: f64, a: f64) -> Self {
        let wall = Wall::new(part, a).from(v_s);
        Self { v_s, turn, half: part.e / 2.0, nose: wall.half_round(v_s), wall }
    }

    /// How far an axis is from it; negative inside.
    #[must_use]
    pub fn apart(&self, axis: &Axis) -> f64 {
        self.least(&turned(axis, -self.turn), None)
    }

    /// True where an axis is no less than `asked` from it, which is more than 0.
    #[must_use]
    pub fn keeps(&self, axis: &Axis, asked: f64) -> bool {
        self.least(&turned(axis, -self.turn), Some(asked)) >= asked
    }

    /// True where a point is no less than `asked` from it. The axis that stands for it runs along the nose: one that leans would be seen
    /// longer than a point is.
    #[must_use]
    pub fn keeps_point(&self, point: &Vector3<f64>, asked: f64) -> bool {
        let here = Axis { foot: turn(-self.turn)(point), along: self.nose.down(), range: [0.0, 0.0] };
        self.least(&here, Some(asked)) >= asked
    }

    /// How far an axis is from it. Where only an answer is asked for, any distance on the right side of what is asked.
    ///
    /// A point of the mean surface is half the thickness from both faces: an axis that is e from one of them is not inside.
    fn least(&self, axis: &Axis, asked: Option<f64>) -> f64 {
        let mut least = self.nose.apart(axis);
        let less = |least: f64| asked.is_some_and(|asked| least < asked);
        if less(least) {
            return least;
        }
        let asked_of_faces = asked.map_or(f64::INFINITY, |asked| asked.max(2.0 * self.half));
        let mut nearer = self.wall.seen(Face::Obverse, axis, asked_of_faces);
        if less(nearer.most) {
            return nearer.most;
        }
        let mut other = self.wall.seen(Face::Reverse, axis, asked_of_faces);
        if less(other.most) {
            return other.most;
        }
        if other.most < nearer.most {
            std::mem::swap(&mut nearer, &mut other);
        }
        if nearer.least.max(other.least) < 2.0 * self.half {
            let middle = self.wall.seen_from_middle(axis);
            if !middle.keeps(self.half) {
                return middle.nearest().0 - self.half;
            }
        }
        for face in [nearer, other] {
            if face.least < asked.map_or(least, |asked| least.min(asked)) {
                least = least.min(face.least_or_less(asked.unwrap_or(f64::NEG_INFINITY)));
            }
        }
        least
    }
}

/// All that a tool in a channel may meet.
#[derive(Clone, Debug)]
pub struct Obstacles {
    wall: Wall,
    pitch: f64,
    /// `None` where the channel has no splitter.
    pub body: Option<Body>,
}

impl Obstacles {
    /// Those in a channel of a part whose blades stand `pitch` apart, as a tool of the radius a needs them.
    #[must_use]
    pub fn new(part: &Part, pitch: f64, a: f64, v_s: Option<f64>) -> Self {
        let body = v_s.map(|v_s| Body::new(part, v_s, -pitch / 2.0, a));
        Self { wall: Wall::new(part, a), pitch, body }
    }

    /// True where an axis is no less than `asked` from the obverse of blade 0.
    #[must_use]
    pub fn keeps_obverse(&self, axis: &Axis, asked: f64) -> bool {
        self.wall.seen(Face::Obverse, axis, asked).keeps(asked)
    }

    /// True where it is no less from the reverse of the next blade.
    #[must_use]
    pub fn keeps_reverse(&self, axis: &Axis, asked: f64) -> bool {
        self.wall.seen(Face::Reverse, &turned(axis, self.pitch), asked).keeps(asked)
    }

    /// True where it is no less from the splitter, or there is none.
    #[must_use]
    pub fn keeps_splitter(&self, axis: &Axis, asked: f64) -> bool {
        self.body.as_ref().is_none_or(|body| body.keeps(axis, asked))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::torus::Torus;

    #[test]
    fn a_quick_answer_is_that_of_the_distance() {
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0);
        let body = Body::new(&part, 4.2, -0.4, 1.8);
        let mut answers = [0_u32; 2];
        for across in -20..=20_i8 {
            for along in 0..=12_u8 {
                let (P, frame) = part.frame(3.9 + f64::from(along) * 0.07);
                let along = (frame.N + frame.b * (f64::from(across) * 0.01)).try_normalize(1e-9).unwrap();
                let foot = P + frame.b * (f64::from(across) * 0.25);
                let axis = turned(&Axis { foot, along, range: [-1.7, 1.0] }, -0.4);
                let apart = body.apart(&axis);
                for asked in [0.4, 1.8, 3.3] {
                    assert_eq!(body.keeps(&axis, asked), apart >= asked, "{across} {apart} {asked}");
                    answers[usize::from(apart >= asked)] += 1;
                }
            }
        }
        assert!(answers.iter().all(|count| *count > 100), "{answers:?}");
    }

    #[test]
    fn a_point_before_a_nose_is_as_far_from_it_as_it_is() {
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 6.0, 2.0);
        for v_s in [3.6, 4.0, 4.4] {
            let body = Body::new(&part, v_s, -0.4, 1.8);
            let (P, frame) = part.frame(v_s);
            let before = |far: f64| turn(-0.4)(&(P + body.nose.down() - frame.t * (part.e / 2.0 + far)));
            for far in [0.3, 1.0, 2.9] {
                assert!(body.keeps_point(&before(far), far - 1e-6), "{v_s} {far}");
                assert!(!body.keeps_point(&before(far), far + 1e-6), "{v_s} {far}");
            }
        }
    }
}
