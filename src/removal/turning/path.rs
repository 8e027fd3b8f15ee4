//! The way of the tool's point during a motion, as straight pieces.

use crate::gcode::motion::{Motion, MotionKind, Plane};
use crate::geometry::chords;
use crate::geometry::exact::grid::Point;
use crate::machine::axis::Axis;

/// A straight piece of the way, `[z, r]` in mm.
pub type Piece = [[f64; 2]; 2];

/// Fills `pieces` with the way of a motion whose point ends at `to`, `[z, r]` in mm.
///
/// A rapid motion bends where the axis that has the shorter time is there, if `bent` gives the rates of X and Z; each axis
/// keeps its rate. Arcs in the plane of X and Z become chords within the tolerance.
pub fn pieces(motion: &Motion, to: [f64; 2], bent: Option<[f64; 2]>, tolerance: f64, pieces: &mut Vec<Piece>) {
    pieces.clear();
    let point = |pose: &crate::machine::axis::Pose| [pose.get(Axis::Z), pose.get(Axis::X)];
    let (start, end) = (point(&motion.from), point(&motion.to));
    // From program coordinates to those of the way.
    let shift = [to[0] - end[0], to[1] - end[1]];
    let from = [start[0] + shift[0], start[1] + shift[1]];
    match motion.kind {
        MotionKind::Dwell(_) => {}
        MotionKind::Arc(arc, _) if arc.plane == Plane::ZX && arc.sweep != 0.0 => {
            let centre = [arc.centre[0] + shift[0], arc.centre[1] + shift[1]];
            let mut last = from;
            chords::corners(centre, [from, to], arc.sweep, tolerance, |corner| {
                pieces.push([last, corner]);
                last = corner;
            });
        }
        MotionKind::Rapid => {
            let [dz, dr] = [to[0] - from[0], to[1] - from[1]];
            if let Some([rate_x, rate_z]) = bent
                && dz != 0.0
                && dr != 0.0
                && rate_x > 0.0
                && rate_z > 0.0
            {
                let (time_z, time_r) = (dz.abs() / rate_z, dr.abs() / rate_x);
                let bend = if time_z < time_r {
                    [to[0], from[1] + dr * time_z / time_r]
                } else {
                    [from[0] + dz * time_r / time_z, to[1]]
                };
                pieces.push([from, bend]);
                if bend != to {
                    pieces.push([bend, to]);
                }
            } else if from != to {
                pieces.push([from, to]);
            }
        }
        _ if from != to => pieces.push([from, to]),
        _ => {}
    }
}

/// The part of a piece inside the square |z|, |r| ≤ `within`, on the grid; `None` where none of it is.
///
/// Liang and Barsky: the piece's parameter is narrowed by each of the four sides.
#[must_use]
pub fn on_grid([from, to]: Piece, within: f64) -> Option<[Point; 2]> {
    if [from, to].iter().flatten().all(|at| at.abs() <= within) {
        return Some([Point::near(from)?, Point::near(to)?]);
    }
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let step = to[axis] - from[axis];
        if step == 0.0 {
            if from[axis].abs() > within {
                return None;
            }
            continue;
        }
        let (low, high) = ((-within - from[axis]) / step, (within - from[axis]) / step);
        first = first.max(low.min(high));
        last = last.min(low.max(high));
    }
    let at = |part: f64| Point::near([from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part]);
    (first <= last).then(|| Some([at(first)?, at(last)?]))?
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_piece_is_cut_to_the_grid_on_every_side() {
        let point = |z: i64, r: i64| Point { z: z * 1_000_000, r: r * 1_000_000 };
        assert_eq!(on_grid([[1.0, 2.0], [3.0, 4.0]], 10.0), Some([point(1, 2), point(3, 4)]));
        assert_eq!(on_grid([[0.0, 5.0], [2000.0, 5.0]], 10.0), Some([point(0, 5), point(10, 5)]));
        assert_eq!(on_grid([[-2000.0, 0.0], [2000.0, 0.0]], 10.0), Some([point(-10, 0), point(10, 0)]));
        assert_eq!(on_grid([[0.0, 11.0], [2000.0, 11.0]], 10.0), None);
        assert_eq!(on_grid([[20.0, 0.0], [0.0, 20.0]], 5.0), None);
        assert_eq!(on_grid([[12.0, 2.0], [2.0, 12.0]], 10.0), Some([point(10, 4), point(4, 10)]));
    }
}
