//! Pattern repeating (G73), Fanuc system A.
//!
//! # References
//! Fanuc Series 0i-TF and 30i, operator's manual for lathe systems, pattern repeating G73; the article on the lathe
//! simulator, figure 19.
//!
//! # The passes
//! Pass j of d (from 0) runs along the contour moved by the finishing allowance and by (Δi, Δk)·(1 − j/(d − 1)): the first by
//! the whole relief, the last by none. A single pass is the last.
//!
//! # Left open, and chosen here
//! The ways from one pass to the next, and back to the start, are straight, as in the figure.

use crate::finding::Size;
use crate::gcode::turning::Move;
use crate::gcode::turning::profile::Profile;
use crate::gcode::turning::rough::{check, finite, into_metal};
use crate::gcode::turning::rules::{
    ContourBeginsWithArc, ContourNotFound, RepeatIntoMetal, RepeatWithoutPasses, TooManyRepeats,
};
use crate::gcode::turning::scan::{PassFrame, moved};
use crate::gcode::turning::tool::CycleMoves;
use crate::gcode::turning::trouble::Trouble;
use crate::limits::REPEATED_MOVES;
use crate::limits::ROUGHING_PASSES;

/// The parameters of G73. Lengths in mm, X on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeat {
    /// Δi and Δk, the whole relief along X and Z, signed: U and W of the first block.
    pub relief: [f64; 2],
    /// R, the number of passes.
    pub passes: i64,
    /// The finishing allowance along X (on the radius: half of U) and Z, signed.
    pub allowance: [f64; 2],
    /// F of the cycle; none for the one in force.
    pub feed: Option<f64>,
}

/// G73: passes parallel to the contour.
///
/// # Errors
/// PS0321 for a number of passes below 1, PS0063 for a contour without blocks, PS0065 for one that begins with an arc, a refusal
/// without a number for a first or a last pass that runs into the contour, and a limit for more than [`ROUGHING_PASSES`] passes or 1,000,000 moves.
pub fn repeat(profile: &Profile, repeat: &Repeat) -> Result<Vec<Move>, Box<Trouble>> {
    let Repeat { relief, passes, allowance, feed } = *repeat;
    finite(&[relief[0], relief[1], allowance[0], allowance[1], feed.unwrap_or(0.0)])?;
    check(profile)?;
    let Some(first) = profile.elements.first() else { return Err(Trouble::of(&ContourNotFound {})) };
    if first.arc.is_some() {
        return Err(Trouble::of(&ContourBeginsWithArc {}).at(first.line));
    }
    let Some(count) = usize::try_from(passes).ok().filter(|&passes| passes > 0) else {
        return Err(Trouble::of(&RepeatWithoutPasses {}));
    };
    let most = ROUGHING_PASSES.min(REPEATED_MOVES / profile.elements.len());
    #[expect(clippy::cast_precision_loss, reason = "counts of passes")]
    if count > most {
        return Err(Trouble::of(&TooManyRepeats { passes: Size::number(count as f64, 0), most: most as f64 }).beyond());
    }
    // The first pass and the last: those between lie between them.
    let by = |left: f64| [0, 1].map(|axis: usize| allowance[axis] + relief[axis] * left);
    if into_metal(profile, by(0.0)) || count > 1 && into_metal(profile, by(1.0)) {
        return Err(Trouble::of(&RepeatIntoMetal {}));
    }
    let plain = PassFrame { axes: [0, 1], signs: [1.0; 2] };
    let mut tool = CycleMoves::new(plain, profile.start);
    for pass in 0..count {
        #[expect(clippy::cast_precision_loss, reason = "counts of passes")]
        let left = if count == 1 { 0.0 } else { 1.0 - pass as f64 / (count - 1) as f64 };
        let by = by(left);
        tool.rapid([profile.start[0] + by[0], profile.start[1] + by[1]]);
        for element in &profile.elements {
            tool.element(&moved(element, by), feed);
        }
    }
    tool.rapid(profile.start);
    Ok(tool.moves)
}
