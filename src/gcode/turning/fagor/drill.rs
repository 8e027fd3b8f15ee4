//! Axial drilling and tapping: G83.
//!
//! # References
//! Fagor Automation, CNC 8055 T programming manual, G83.
//!
//! # The moves
//! At rapid to the approach point, D before the face; at feed to the first depth B. After each step the tool goes back at
//! rapid by H, or to the approach point without H, comes at rapid to C before the depth it had reached, and drills on. Each
//! step is R times the one before, but never less than L; the last is as long as is left. At the bottom it waits K, returns at
//! rapid to the approach point and to where it was called. With B0 it taps: at feed to the bottom and back to the approach
//! point.
//!
//! # Left open, and chosen here
//! C is 1 mm where it is not given, D is 0. With an H that is shorter than C the tool drills on from where H left it.

use crate::finding::Size;
use crate::gcode::turning::Move;
use crate::gcode::turning::fagor::sign;
use crate::gcode::turning::rough::finite;
use crate::gcode::turning::rules::{
    FagorDrillFactor, FagorDrillNegative, FagorHoleWithoutDepth, TooManyFagorDrillSteps,
};
use crate::gcode::turning::scan::{EPS, PassFrame};
use crate::gcode::turning::tool::CycleMoves;
use crate::gcode::turning::trouble::Trouble;
use crate::limits::DRILL_STEPS;

/// The parameters of G83. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drill {
    /// The point on the face: X, Z.
    pub at: [f64; 2],
    /// I, the depth, positive towards −Z.
    pub depth: f64,
    /// B, the first step; 0 to tap.
    pub step: f64,
    /// D, how far before the face the approach point lies.
    pub safety: f64,
    /// K, the dwell at the bottom, s.
    pub dwell: f64,
    /// H, how far the tool goes back after each step; none or 0 to the approach point.
    pub back: Option<f64>,
    /// C, how near it comes at rapid to the depth that it had reached; none for 1 mm.
    pub near: Option<f64>,
    /// L, the least step.
    pub least: f64,
    /// R, by which each step is multiplied: above 0, up to 1.
    pub factor: f64,
}

/// G83 from the point where the tool stands, `[X, Z]`.
///
/// # Errors
/// Refusals for a depth of 0, negative distances, an R beyond 0 to 1; a limit for more than 10,000 steps.
pub fn drill(start: [f64; 2], drill: &Drill) -> Result<Vec<Move>, Box<Trouble>> {
    let Drill { at, depth, step, safety, dwell, least, factor, .. } = *drill;
    let (back, near) = (drill.back.unwrap_or(0.0), drill.near.unwrap_or(1.0));
    finite(&[start[0], start[1], at[0], at[1], depth, step, safety, dwell, least, factor, back, near])?;
    if depth.abs() < EPS {
        return Err(Trouble::of(&FagorHoleWithoutDepth {}));
    }
    let wrong = [('B', step), ('D', safety), ('K', dwell), ('H', back), ('C', near), ('L', least)];
    if let Some((letter, _)) = wrong.into_iter().find(|(_, value)| *value < 0.0) {
        return Err(Trouble::of(&FagorDrillNegative { letter }));
    }
    if !(factor > 0.0 && factor <= 1.0) {
        return Err(Trouble::of(&FagorDrillFactor {}));
    }
    // v counts out of the hole.
    let frame = PassFrame { axes: [0, 1], signs: [1.0, sign(depth)] };
    let [u, face] = frame.inward(at);
    let bottom = face - depth.abs();
    let approach = [u, face + safety];
    let mut reached = Vec::new();
    let (mut v, mut next) = (face, if step > 0.0 { step } else { depth.abs() });
    while v - bottom > EPS {
        if reached.len() >= DRILL_STEPS || next < EPS {
            #[expect(clippy::cast_precision_loss, reason = "a small constant")]
            let most = DRILL_STEPS as f64;
            return Err(Trouble::of(&TooManyFagorDrillSteps { passes: Size::number(most + 1.0, 0), most }).beyond());
        }
        v = (v - next).max(bottom);
        if v - bottom < EPS {
            v = bottom;
        }
        reached.push(v);
        next = (next * factor).max(least);
    }
    let mut tool = CycleMoves::new(frame, start);
    tool.rapid(approach);
    for (at, &v) in reached.iter().enumerate() {
        if let Some(before) = at.checked_sub(1).and_then(|at| reached.get(at)) {
            tool.rapid(if back > 0.0 { [u, before + back] } else { approach });
            tool.rapid([u, tool.at[1].min(before + near)]);
        }
        tool.feed([u, v], None);
    }
    tool.wait(dwell);
    if step > 0.0 {
        tool.rapid(approach);
    } else {
        tool.feed(approach, None);
    }
    tool.rapid(frame.inward(start));
    Ok(tool.moves)
}
