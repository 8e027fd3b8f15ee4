//! Face grooving and peck drilling (G74), grooving outside and inside (G75), Fanuc system A.
//!
//! # References
//! Fanuc Series 0i-TF and 30i, operator's manual for lathe systems, end face peck drilling G74 and outer/internal diameter
//! drilling G75; the article on the lathe simulator, figures 20 and 21.
//!
//! # The moves
//! At each place the tool cuts a step deeper, goes back by R at rapid, and so on to the bottom; there it moves aside by the
//! relief, against the direction from place to place, leaves at rapid, and goes to the next place. The last step and the last
//! place are as far as is left. At the end it returns to the start.
//!
//! # Left open, and chosen here
//! The relief, where given, is made at every place, the first included, as the figure of the manual draws it.

use crate::finding::Size;
use crate::gcode::turning::Move;
use crate::gcode::turning::rough::finite;
use crate::gcode::turning::rules::{
    GrooveReliefNegative, GrooveStepNegative, GrooveStepZero, GrooveWithoutDepth, RetractionNegative,
    TooManyGrooveSteps,
};
use crate::gcode::turning::scan::{EPS, PassFrame};
use crate::gcode::turning::tool::CycleMoves;
use crate::gcode::turning::trouble::Trouble;
use crate::limits::GROOVE_STEPS;

/// The parameters of G74 and G75. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groove {
    /// R of the first block, how far the tool goes back after each step.
    pub retract: f64,
    /// The corner opposite to the start, `[X, Z]`; the start's own coordinate along an axis that is not programmed.
    pub to: [f64; 2],
    /// P and Q, the steps along X (on the radius) and Z; without a sign.
    pub step: [f64; 2],
    /// R of the second block, how far the tool moves aside at the bottom; 0 where it is not given.
    pub relief: f64,
    /// F of the cycle; none for the one in force.
    pub feed: Option<f64>,
}

impl Groove {
    /// How far apart along an axis (0 for X, 1 for Z) the tool goes in from where it starts, mm; 0 where it goes in at one place.
    #[must_use]
    pub fn spacing(&self, start: [f64; 2], axis: usize) -> f64 {
        let way = (self.to[axis] - start[axis]).abs();
        if way < EPS { 0.0 } else { self.step[axis].min(way) }
    }
}

/// G74: cuts along Z, goes from place to place along X. Without a way along X it drills in steps.
///
/// # Errors
/// PS0318 to PS0320 for reliefs and steps of the wrong sign, or a step of 0 along an axis with a way to go; refusals for a
/// groove without depth; a limit for more than 100,000 steps.
pub fn face(start: [f64; 2], groove: &Groove) -> Result<Vec<Move>, Box<Trouble>> {
    expand(start, groove, [0, 1])
}

/// G75: cuts along X, goes from place to place along Z.
///
/// # Errors
/// As for [`face`].
pub fn radial(start: [f64; 2], groove: &Groove) -> Result<Vec<Move>, Box<Trouble>> {
    expand(start, groove, [1, 0])
}

/// How many steps a way takes: the last as long as is left.
fn steps(way: f64, step: f64) -> f64 {
    if way.abs() < EPS { 0.0 } else { (way.abs() / step - EPS).ceil().max(1.0) }
}

/// Where step `n` of `count` ends, mm; the last one ends at `to` itself.
#[expect(clippy::cast_precision_loss, reason = "steps are counted up to 100,000")]
fn step_end(from: f64, to: f64, step: f64, n: usize, count: usize) -> f64 {
    if n == count { to } else { from + (to - from).signum() * step * n as f64 }
}

fn expand(start: [f64; 2], groove: &Groove, axes: [usize; 2]) -> Result<Vec<Move>, Box<Trouble>> {
    let Groove { retract, to, step, relief, feed } = *groove;
    finite(&[start[0], start[1], retract, to[0], to[1], step[0], step[1], relief, feed.unwrap_or(0.0)])?;
    let frame = PassFrame { axes, signs: [1.0; 2] };
    let [from, to, step] = [start, to, step].map(|p| frame.inward(p));
    if step.iter().any(|&step| step < 0.0) {
        return Err(Trouble::of(&GrooveStepNegative {}));
    }
    let way: [f64; 2] = std::array::from_fn(|axis| to[axis] - from[axis]);
    if way[1].abs() < EPS {
        return Err(Trouble::of(&GrooveWithoutDepth {}));
    }
    if way.iter().zip(step).any(|(way, step)| way.abs() >= EPS && step == 0.0) {
        return Err(Trouble::of(&GrooveStepZero {}));
    }
    let stepping = way[0].abs() >= EPS;
    if stepping && relief < 0.0 {
        return Err(Trouble::of(&GrooveReliefNegative {}));
    }
    if retract < 0.0 {
        return Err(Trouble::of(&RetractionNegative {}));
    }
    let [across, down] = [steps(way[0], step[0]), steps(way[1], step[1])];
    let total = (across + 1.0) * down;
    if total > GROOVE_STEPS {
        return Err(Trouble::of(&TooManyGrooveSteps { passes: Size::number(total, 0), most: GROOVE_STEPS }).beyond());
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 100,000")]
    let [across, down] = [across as usize, down as usize];
    let aside = if stepping { -way[0].signum() * relief } else { relief };
    let mut tool = CycleMoves::new(frame, start);
    for place in 0..=across {
        let u = step_end(from[0], to[0], step[0], place, across.max(1));
        let u = if place == 0 { from[0] } else { u };
        tool.rapid([u, from[1]]);
        for n in 1..=down {
            let v = step_end(from[1], to[1], step[1], n, down);
            tool.feed([u, v], feed);
            if n < down {
                tool.rapid([u, v - way[1].signum() * retract]);
            }
        }
        tool.rapid([u + aside, to[1]]);
        tool.rapid([u + aside, from[1]]);
    }
    tool.rapid(from);
    Ok(tool.moves)
}
