//! Finishing (G70), Fanuc system A.
//!
//! # References
//! Fanuc Series 0i-TF and 30i, operator's manual for lathe systems, finishing cycle G70.

use crate::gcode::turning::profile::Profile;
use crate::gcode::turning::rough::{check, finite};
use crate::gcode::turning::trouble::Trouble;
use crate::gcode::turning::{Move, Way};

/// G70: once along the contour, each block at its own F or at the last one that a block of the contour gave, before that at
/// `feed` (F of the cycle; none for the one in force); then back to the start at rapid.
///
/// # Errors
/// PS0063 for a contour without blocks, PS0065 for one that begins with an arc.
pub fn finish(profile: &Profile, feed: Option<f64>) -> Result<Vec<Move>, Trouble> {
    finite(&[feed.unwrap_or(0.0)])?;
    check(profile)?;
    let Some(first) = profile.elements.first() else { return Err(Trouble::ps(63)) };
    if first.arc.is_some() {
        return Err(Trouble::ps(65).at(first.line));
    }
    let mut feed = feed;
    let mut moves: Vec<Move> = Vec::with_capacity(profile.elements.len() + 1);
    for element in &profile.elements {
        feed = element.feed.or(feed);
        let way = match element.arc {
            Some((centre, clockwise)) => Way::Arc { centre, clockwise, feed },
            None if element.rapid => Way::Rapid,
            None => Way::Feed(feed),
        };
        moves.push(Move { way, to: element.to, line: Some(element.line) });
    }
    moves.push(Move { way: Way::Rapid, to: profile.start, line: None });
    Ok(moves)
}
