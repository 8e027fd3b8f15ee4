//! The edge between two straight lines, chamfered or rounded.
//!
//! # References
//! Fanuc Series 0i-T, operator's manual, direct drawing dimensions programming; Mitsubishi M700V, programming manual, corner
//! chamfering and corner rounding: a chamfer begins and ends at its size from the corner, along either line; a rounding touches
//! both lines. Fanuc Series 30i, user's manual, chamfering and corner R: I, K and R on a line along one axis, before one along
//! the other; their sign says which way the second goes. Alarms PS0051 to PS0055: the texts are rodete's own.

use crate::finding::Size;
use crate::gcode::turning::rules::{
    CornerLineWithoutLength, CornerNotSquare, CornerRunsBack, CornerSignAgainstLine, CornerTooLong,
};
use crate::gcode::turning::trouble::Trouble;
use crate::number::trig;

/// By how much a corner may be longer than its line: rounding alone; mm.
const TOLERANCE: f64 = 1e-6;
/// Below this sine of the turn two lines are one.
const STRAIGHT: f64 = 1e-9;

/// How an edge is broken. Lengths in mm, on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    /// By a chamfer, with the distance of its ends from the corner.
    Chamfer(f64),
    /// By an arc of a radius.
    Round(f64),
}

/// What an edge says of the corner it stands in: between a line along one axis and one along the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square {
    /// The axis of the second line, X (0) or Z (1), where the letter says it: I and K.
    pub axis: Option<usize>,
    /// Its way along the axis: 1 or −1.
    pub toward: f64,
}

impl Square {
    /// Refuses another corner.
    fn check(self, u: [f64; 2], v: [f64; 2]) -> Result<(), Box<Trouble>> {
        let along = |way: [f64; 2]| [0, 1].into_iter().find(|&axis| way[1 - axis].abs() < STRAIGHT);
        let (Some(first), Some(second)) = (along(u), along(v)) else { return Err(Trouble::of(&CornerNotSquare {})) };
        if first == second || self.axis.is_some_and(|axis| axis != second) {
            return Err(Trouble::of(&CornerNotSquare {}));
        }
        if v[second] * self.toward > 0.0 {
            return Ok(());
        }
        Err(Trouble::of(&CornerSignAgainstLine {}))
    }
}

/// What replaces the corner between two lines; points `[X, Z]`, X the radius, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Broken {
    /// Where the first line ends.
    pub from: [f64; 2],
    /// Where the second begins.
    pub to: [f64; 2],
    /// Of a rounding its centre, and whether it runs clockwise (G2).
    pub arc: Option<([f64; 2], bool)>,
}

/// The direction from one point to another, and the distance; `None` for the same point.
fn way(from: [f64; 2], to: [f64; 2]) -> Option<([f64; 2], f64)> {
    let by = [to[0] - from[0], to[1] - from[1]];
    let length = trig::hypot(by[0], by[1]);
    (length > TOLERANCE).then(|| (by.map(|by| by / length), length))
}

/// Breaks the corner `b` between the lines from `a` to `b` and from `b` to `c`; `None` where nothing is to be broken: a size of 0,
/// a rounding of two lines that are one.
///
/// # Derivation
/// With the turn φ between the directions a rounding of radius r takes r tan(φ/2) = r |sin φ| / (1 + cos φ) of either line.
///
/// # Errors
/// PS0051 where a line has no length or goes another way than `square` says, PS0054 for lines that are not along one axis each,
/// PS0055 for an edge that takes more than a line has; a refusal between two lines that run back along each other.
pub fn broken([a, b, c]: [[f64; 2]; 3], edge: Edge, square: Option<Square>) -> Result<Option<Broken>, Box<Trouble>> {
    let (Some((u, before)), Some((v, behind))) = (way(a, b), way(b, c)) else {
        return Err(Trouble::of(&CornerLineWithoutLength {}));
    };
    square.map_or(Ok(()), |square| square.check(u, v))?;
    // Positive where the path turns from +Z to +X, as G3 does.
    let turn = u[1] * v[0] - u[0] * v[1];
    let straight = u[0] * v[0] + u[1] * v[1];
    let (Edge::Chamfer(size) | Edge::Round(size)) = edge;
    if size == 0.0 {
        return Ok(None);
    }
    // 0 where they run back along each other, and then for a turn of up to 1e-8 short of it.
    let open = 1.0 + straight;
    if straight < 0.0 && (turn.abs() < STRAIGHT || open <= 0.0) {
        return Err(Trouble::of(&CornerRunsBack {}));
    }
    let taken = match edge {
        Edge::Chamfer(_) => size,
        Edge::Round(_) if turn.abs() < STRAIGHT => return Ok(None),
        Edge::Round(_) => size * turn.abs() / open,
    };
    let shortest = before.min(behind);
    if taken > shortest + TOLERANCE {
        return Err(Trouble::of(&CornerTooLong { taken: Size::mm(taken), shortest: Size::mm(shortest) }));
    }
    let along = |way: [f64; 2], by: f64| [b[0] + way[0] * by, b[1] + way[1] * by];
    // A corner that takes a whole line ends where the line does.
    let from = if before - taken < TOLERANCE { a } else { along(u, -taken) };
    let to = if behind - taken < TOLERANCE { c } else { along(v, taken) };
    let arc = match edge {
        Edge::Chamfer(_) => None,
        Edge::Round(radius) => {
            let side = radius.copysign(turn);
            Some(([from[0] + u[1] * side, from[1] - u[0] * side], turn < 0.0))
        }
    };
    Ok(Some(Broken { from, to, arc }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::finding::AlarmFamily;

    #[test]
    fn a_chamfer_lies_at_its_size_from_the_corner_along_both_lines() {
        // Up along X from (10, 0) to (20, 0), then along Z to (20, −30).
        let broken = broken([[10.0, 0.0], [20.0, 0.0], [20.0, -30.0]], Edge::Chamfer(2.0), None).unwrap().unwrap();
        assert_eq!(broken, Broken { from: [18.0, 0.0], to: [20.0, -2.0], arc: None });
    }

    #[test]
    fn a_rounding_touches_both_lines_on_the_inside_of_the_turn() {
        // The same lines turn from +X to −Z, as G3 does; the circle about (17, −3) touches (17, 0) and (20, −3).
        let lines = [[10.0, 0.0], [20.0, 0.0], [20.0, -30.0]];
        let edge = broken(lines, Edge::Round(3.0), None).unwrap().unwrap();
        assert_eq!(edge, Broken { from: [17.0, 0.0], to: [20.0, -3.0], arc: Some(([17.0, -3.0], false)) });
        let [a, b, c] = lines;
        let back = broken([c, b, a], Edge::Round(3.0), None).unwrap().unwrap();
        assert_eq!(back, Broken { from: [20.0, -3.0], to: [17.0, 0.0], arc: Some(([17.0, -3.0], true)) });
        // A turn of 45 degrees, from −Z to up the cone: r tan 22.5° = 0.828427… for r 2.
        let edge = broken([[10.0, 0.0], [10.0, -10.0], [15.0, -15.0]], Edge::Round(2.0), None).unwrap().unwrap();
        let taken = 2.0 * (2.0_f64.sqrt() - 1.0);
        assert!((edge.from[1] + 10.0 - taken).abs() < 1e-12 && edge.from[0] == 10.0);
        let half = taken / 2.0_f64.sqrt();
        assert!((edge.to[0] - 10.0 - half).abs() < 1e-12 && (edge.to[1] + 10.0 + half).abs() < 1e-12);
        let (centre, clockwise) = edge.arc.unwrap();
        assert!(clockwise && (centre[0] - 12.0).abs() < 1e-12 && (centre[1] - edge.from[1]).abs() < 1e-12);
        assert!((trig::hypot(edge.to[0] - centre[0], edge.to[1] - centre[1]) - 2.0).abs() < 1e-12);
    }

    #[test]
    fn an_edge_may_take_a_whole_line_and_no_more() {
        let lines = [[10.0, 0.0], [20.0, 0.0], [20.0, -5.0]];
        let whole = broken(lines, Edge::Round(5.0), None).unwrap().unwrap();
        assert_eq!(whole.to, [20.0, -5.0]);
        let trouble = broken(lines, Edge::Chamfer(5.001), None).unwrap_err();
        assert_eq!(trouble.what.en, "the corner needs 5.001 mm of each line, and the shorter line is 5 mm long");
        assert_eq!(
            broken([[0.0; 2], [0.0; 2], [1.0, 0.0]], Edge::Chamfer(0.5), None).unwrap_err().rule,
            CornerLineWithoutLength::RULE
        );
    }

    #[test]
    fn a_square_corner_has_a_line_along_each_axis_and_the_sign_of_the_second() {
        let (up, along) = ([[10.0, 0.0], [20.0, 0.0], [20.0, -30.0]], [[20.0, 0.0], [20.0, -9.0], [30.0, -9.0]]);
        let alarm = |lines, axis, toward: f64| {
            broken(lines, Edge::Chamfer(1.0), Some(Square { axis, toward }))
                .map_err(|trouble| trouble.alarm(AlarmFamily::Fanuc))
        };
        for axis in [None, Some(1)] {
            assert!(alarm(up, axis, -1.0).unwrap().is_some());
            assert_eq!(alarm(up, axis, 1.0), Err(Some(51)));
        }
        assert!(alarm(along, Some(0), 1.0).unwrap().is_some());
        assert_eq!(alarm(up, Some(0), -1.0), Err(Some(54)));
        assert_eq!(alarm([[10.0, 0.0], [20.0, -1.0], [20.0, -30.0]], None, -1.0), Err(Some(54)));
        assert_eq!(alarm([[10.0, 0.0], [20.0, 0.0], [30.0, 0.0]], None, 1.0), Err(Some(54)));
    }

    #[test]
    fn where_there_is_no_corner_nothing_is_rounded() {
        let on = [[10.0, 0.0], [20.0, 0.0], [30.0, 0.0]];
        assert_eq!(broken(on, Edge::Round(2.0), None).unwrap(), None);
        assert_eq!(broken(on, Edge::Chamfer(0.0), None).unwrap(), None);
    }

    #[test]
    fn lines_that_run_back_along_each_other_have_no_corner() {
        // The last by 5e-9 of a turn, which the cosine does not show.
        for lines in [[[10.0, 0.0], [20.0, 0.0], [15.0, 0.0]], [[0.0, 0.0], [0.0, -9000.0], [0.000_045, 0.0]]] {
            assert_eq!(broken(lines, Edge::Round(0.0), None).unwrap(), None);
            for edge in [Edge::Round(2.0), Edge::Chamfer(2.0)] {
                let trouble = broken(lines, edge, None).unwrap_err();
                assert_eq!(trouble.what.en, "the second line runs back along the first: there is no corner");
            }
        }
    }
}
