//! The checked values, and where the holes are.

use rodete::finding::{Finding, Raise, Size};
use rodete::gcode::control::Post;
use rodete::gcode::fields::{DIALECT, PART};
use rodete::number::trig::sin_cos;
use rodete::parameter::at;
use rodete::parameter::field::Fields;

use crate::form::{DEPTH, DRILL, FEED, FIRST, N, PITCH, SPEED, Sense, WAY};
use crate::rules::{HolesMeet, TooDeep};

/// How far above the face the drill moves from hole to hole, mm.
pub const CLEAR: f64 = 5.0;

/// The deepest hole that is drilled in one go, in diameters.
const IN_ONE_GO: f64 = 5.0;

#[derive(Debug)]
pub struct BoltCircle {
    pub N: u32,
    pub D: f64,
    pub alpha: f64,
    /// The angle from a hole to the next, degrees.
    pub step: f64,
    pub d: f64,
    pub h: f64,
    pub F: f64,
    pub S: u32,
    pub part: String,
    pub post: Post,
}

impl BoltCircle {
    pub fn new(fields: &Fields) -> Result<Self, Vec<Finding>> {
        let turn = match fields.get(&WAY) {
            Sense::Left => 360.0,
            Sense::Right => -360.0,
        };
        let circle = Self {
            step: turn / f64::from(fields.get(&N)),
            N: fields.get(&N),
            D: fields.get(&PITCH),
            alpha: fields.get(&FIRST),
            d: fields.get(&DRILL),
            h: fields.get(&DEPTH),
            F: fields.get(&FEED),
            S: fields.get(&SPEED),
            part: fields.get(&PART),
            post: fields.get(&DIALECT),
        };
        let mut found = Vec::new();
        let (between, most) = (circle.D * sin_cos(std::f64::consts::PI / f64::from(circle.N)).0, IN_ONE_GO * circle.d);
        if between <= circle.d {
            let place = at([DRILL.key(), N.key(), PITCH.key()]);
            found.push(HolesMeet { between: Size::mm(between), d: Size::mm(circle.d) }.at(place));
        }
        if circle.h > most {
            let place = at([DEPTH.key(), DRILL.key()]);
            found.push(TooDeep { h: Size::mm(circle.h), most: Size::mm(most) }.at(place));
        }
        if found.is_empty() { Ok(circle) } else { Err(found) }
    }

    /// The angle of a hole, counted from 0, in degrees.
    pub fn angle(&self, hole: u32) -> f64 {
        self.alpha + self.step * f64::from(hole)
    }

    /// Where a hole is, mm.
    pub fn at(&self, hole: u32) -> [f64; 2] {
        let (sin, cos) = sin_cos(self.angle(hole).to_radians());
        [cos, sin].map(|along| self.D / 2.0 * along)
    }
}
