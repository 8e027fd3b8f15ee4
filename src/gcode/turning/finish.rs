//! Finishing (G70), Fanuc system A.
//!
//! # References
//! Fanuc Series 0i-TF and 30i, operator's manual for lathe systems, finishing cycle G70.

use crate::gcode::turning::profile::Profile;
use crate::gcode::turning::rough::check;
use crate::gcode::turning::rules::{ContourBeginsWithArc, ContourNotFound};
use crate::gcode::turning::trouble::Trouble;
use crate::gcode::turning::{Move, MoveKind};

/// G70: once along the contour, at the feed that is in force at each of its blocks; then back to the start at rapid.
///
/// # Errors
/// PS0063 for a contour without blocks, PS0065 for one that begins with an arc.
pub fn finish(profile: &Profile) -> Result<Vec<Move>, Box<Trouble>> {
    check(profile)?;
    let Some(first) = profile.elements.first() else { return Err(Trouble::of(&ContourNotFound {})) };
    if first.arc.is_some() {
        return Err(Trouble::of(&ContourBeginsWithArc {}).at(first.line));
    }
    let mut moves: Vec<Move> = Vec::with_capacity(profile.elements.len() + 1);
    for element in &profile.elements {
        let kind = match element.arc {
            Some((centre, clockwise)) => MoveKind::Arc { centre, clockwise, feed: None },
            None if element.rapid => MoveKind::Rapid,
            None => MoveKind::Feed(None),
        };
        moves.push(Move { kind, to: element.to, line: Some(element.line) });
    }
    moves.push(Move { kind: MoveKind::Rapid, to: profile.start, line: None });
    Ok(moves)
}
