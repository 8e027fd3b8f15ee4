//! Grooving: G88 (along X, into the cylinder) and G89 (along Z, into the face).
//!
//! # References
//! Fagor Automation, CNC 8055 T programming manual, G88 and G89.
//!
//! # The moves
//! The groove goes from the initial point (X, Z) at its brim to the final point (Q, R) at its bottom. The tool plunges at
//! feed at places at equal steps, as great as C allows, from the initial to the final point; at each it waits K, and goes
//! back at rapid to D over the brim. The cycle ends where it was called.
//!
//! # Left open, and chosen here
//! The points are those of the tool's cutting point: the control makes the groove narrower by the width of the cutter in its
//! tool table, which no program says; with the places as programmed the groove is wider than R − Z by that width.

use crate::finding::Size;
use crate::gcode::turning::Move;
use crate::gcode::turning::fagor::{Along, no_step, sign, wrong_start};
use crate::gcode::turning::rough::finite;
use crate::gcode::turning::rules::{FagorGrooveNegative, FagorGrooveWithoutDepth, TooManyFagorPasses};
use crate::gcode::turning::scan::EPS;
use crate::gcode::turning::tool::CycleMoves;
use crate::gcode::turning::trouble::Trouble;
use crate::limits::GROOVE_PLACES;

/// The parameters of G88 and G89. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Groove {
    /// The initial point: X, Z.
    pub from: [f64; 2],
    /// The final point: Q, R.
    pub to: [f64; 2],
    /// C, the greatest step.
    pub step: f64,
    /// D, how far over the brim the tool goes back.
    pub safety: f64,
    /// K, the dwell at the bottom, s.
    pub dwell: f64,
}

impl Groove {
    /// How far apart the tool plunges, mm: the way from the initial to the final point in equal steps, as great as C allows; 0 for
    /// a groove of one plunge.
    #[must_use]
    pub fn spacing(&self, along: Along) -> f64 {
        let [u, _] = along.axes();
        let way = (self.from[u] - self.to[u]).abs();
        let steps = (way / self.step - EPS).ceil();
        if steps >= 1.0 { way / steps } else { 0.0 }
    }
}

/// G88 and G89 from the point where the tool stands, `[X, Z]`.
///
/// # Errors
/// Refusals for a groove without depth, a step that is not above 0, a negative D or K, a start below the brim; a limit for
/// more than 10,000 places.
pub fn groove(start: [f64; 2], along: Along, groove: &Groove) -> Result<Vec<Move>, Box<Trouble>> {
    let Groove { from, to, step, safety, dwell } = *groove;
    finite(&[start[0], start[1], from[0], from[1], to[0], to[1], step, safety, dwell])?;
    let [u, v] = along.axes();
    if (from[v] - to[v]).abs() < EPS {
        return Err(Trouble::of(&FagorGrooveWithoutDepth {}));
    }
    if step <= 0.0 {
        return Err(no_step('C'));
    }
    if safety < 0.0 || dwell < 0.0 {
        return Err(Trouble::of(&FagorGrooveNegative {}));
    }
    let frame = along.frame([sign(from[u] - to[u]), sign(from[v] - to[v])]);
    let [S, A, B] = [start, from, to].map(|p| frame.inward(p));
    if S[1] < A[1] - EPS {
        return Err(wrong_start());
    }
    let places = ((A[0] - B[0]) / step - EPS).ceil().max(0.0);
    if places >= GROOVE_PLACES {
        return Err(
            Trouble::of(&TooManyFagorPasses { passes: Size::number(places + 1.0, 0), most: GROOVE_PLACES }).beyond()
        );
    }
    let mut tool = CycleMoves::new(frame, start);
    tool.rapid([A[0], S[1]]);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 10,000")]
    for place in 0..=places as usize {
        #[expect(clippy::cast_precision_loss, reason = "0 to 10,000")]
        let part = if place == 0 { 0.0 } else { place as f64 / places };
        let at = A[0] + (B[0] - A[0]) * part;
        tool.rapid([at, tool.at[1]]);
        tool.rapid([at, A[1] + safety]);
        tool.feed([at, B[1]], None);
        tool.wait(dwell);
        tool.rapid([at, A[1] + safety]);
    }
    tool.rapid([tool.at[0], S[1]]);
    tool.rapid(S);
    Ok(tool.moves)
}
