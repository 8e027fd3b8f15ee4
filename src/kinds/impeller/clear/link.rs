//! From the end of a pass to the beginning of the next, outside of the blank.
//!
//! # Derivation
//! An own-normal tool that has run out by a + d_s stands d_s outside of z ≤ 0 or of x² + y² ≤ R², and stays there however C
//! turns and Z moves. So where both ends are such run-outs of one end of the channel, one move turns C from one to the
//! other. Any other link goes up along the tool's own axis, which is Z, to a height that no point of the part reaches,
//! turns there and comes down along the axis of the next pass.
//!
//! # Units
//! Millimetres and radians.

use crate::kinds::impeller::clear::pass::Move;
use crate::kinds::impeller::clearance::Stand;

/// Where a pass may be left or begun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Where the axes stand there.
    pub at: Stand,
    /// Here the tool has run out on a lane, far enough for C to turn.
    pub run_out: bool,
}

/// The moves from one end to another, above the height Z_r where they must; from above the part without a first one.
#[must_use]
pub fn link(from: Option<End>, to: End, Z_r: f64) -> Vec<Move> {
    let rapid = |to: Stand| Move { rapid: true, to };
    if let Some(from) = from
        && from.run_out
        && to.run_out
        && same(from.at.B, to.at.B)
        && same(from.at.at.x, to.at.at.x)
    {
        return vec![rapid(to.at)];
    }
    let above = |stand: Stand| {
        let mut high = stand;
        high.at.z = Z_r;
        high
    };
    let mut moves: Vec<Move> = from.into_iter().map(|from| rapid(above(from.at))).collect();
    moves.extend([rapid(above(to.at)), rapid(to.at)]);
    moves
}

/// The move that leaves the part from an end.
#[must_use]
pub fn up(from: End, Z_r: f64) -> Move {
    let mut to = from.at;
    to.at.z = Z_r;
    Move { rapid: true, to }
}

fn same(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-9
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    fn end(x: f64, z: f64, B: f64, C: f64, run_out: bool) -> End {
        End { at: Stand { at: Vector3::new(x, 0.0, z), B, C }, run_out }
    }

    #[test]
    fn run_outs_at_one_end_are_joined_by_a_turn_and_all_others_above_the_part() {
        let hub = end(-250.0, -230.0, 1.5, -4.0, true);
        let next = end(-250.0, -231.0, 1.5, -3.9, true);
        assert_eq!(link(Some(hub), next, 9.0), [Move { rapid: true, to: next.at }]);
        let rim = end(33.0, -17.0, 0.0, -3.0, true);
        let moves = link(Some(hub), rim, 9.0);
        assert_eq!(moves.len(), 3);
        assert_eq!((moves[0].to.at.z, moves[0].to.C, moves[1].to.at.z, moves[1].to.C), (9.0, -4.0, 9.0, -3.0));
        assert_eq!(moves[2].to, rim.at);
        assert_eq!(link(Some(hub), End { run_out: false, ..next }, 9.0).len(), 3);
        assert_eq!(link(None, hub, 9.0).len(), 2);
        assert_eq!(up(hub, 9.0).to.at.z, 9.0);
    }
}
