//! Turning cycles of the Fagor CNC 8055 T.
//!
//! # References
//! Fagor Automation, CNC 8055 T programming manual, canned cycles G81 to G89, as far as its rules are known (see
//! [`crate::gcode::turning`]); G85 against the published program. What they leave open is named under "Left open" in each
//! cycle.

pub mod drill;
pub mod groove;
pub mod section;
pub mod thread;

use crate::gcode::turning::rules::{FagorStartInside, FagorStepNotPositive};
use crate::gcode::turning::scan::PassFrame;
use crate::gcode::turning::trouble::Trouble;

/// Which way a cycle works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Passes or threads along Z, grooves along X into the cylinder: G81, G84, G86, G88.
    Cylinder,
    /// Passes or threads along X, grooves along Z into the face: G82, G85, G87, G89.
    Face,
}

impl Along {
    /// Which of `[X, Z]` run along the surface, and across it.
    const fn axes(self) -> [usize; 2] {
        match self {
            Self::Cylinder => [1, 0],
            Self::Face => [0, 1],
        }
    }

    /// The drawing in which the surface runs towards −u and the metal lies at small v.
    const fn frame(self, signs: [f64; 2]) -> PassFrame {
        PassFrame { axes: self.axes(), signs }
    }
}

/// A sign: −1 for a negative way, else 1.
fn sign(way: f64) -> f64 {
    if way < 0.0 { -1.0 } else { 1.0 }
}

/// A refusal for C, B or another step that is not above 0.
fn no_step(letter: char) -> Box<Trouble> {
    Trouble::of(&FagorStepNotPositive { letter })
}

/// A refusal for a start from which the cycle cannot be made.
fn wrong_start() -> Box<Trouble> {
    Trouble::of(&FagorStartInside {})
}
