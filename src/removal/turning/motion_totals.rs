//! The totals of one motion while it runs, and the alarms that follow from the motion alone.

use super::alarm::{Alarm, Cause, Moving, TOUCH};
use super::contact::Bite;
use super::machine::Lathe;
use super::path::Piece;
use super::spindle::{Engaged, SpindleUse};
use super::stock::Fixture;
use super::workpiece::taken;
use crate::gcode::motion::Motion;
use crate::geometry::exact::convex::Convex;
use crate::geometry::exact::meeting::Meeting;
use crate::machine::axis::Axis;
use crate::number::trig::hypot;

/// The totals of one motion so far.
pub(super) struct Tally<'a> {
    pub motion: &'a Motion,
    pub index: usize,
    /// The number of the subprogram's file; 0 for the program.
    pub file: usize,
    /// From `[z, r]` on the grid to program coordinates.
    pub shift: [f64; 2],
    pub turning: SpindleUse,
    /// The programmed point at the beginning of the cut, `[z, r]` on the grid.
    pub begins: Option<[f64; 2]>,
    /// The volumes cut on this side of the axis and beyond it, mm³.
    pub sides: [f64; 2],
    /// The maximum cutting speed, m/min.
    pub speed: f64,
    pub alarms: Vec<Alarm>,
}

impl Tally<'_> {
    /// Notes the metal that a cutter met along a piece of its path, on this side of the axis or mirrored across it.
    pub fn met(&mut self, Bite { along, reach: [low, high], metal }: Bite, [from, to]: Piece, mirrored: bool) {
        let long = hypot(to[0] - from[0], to[1] - from[1]);
        let part = if long > 0.0 { (along / long).clamp(0.0, 1.0) } else { 0.0 };
        self.begins.get_or_insert([0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part));
        let (side, reach) = if mirrored { (-1.0, [-high, -low]) } else { (1.0, [low, high]) };
        let engaged = Engaged { from: side * from[1], to: side * to[1], shift: side * self.shift[1], reach, metal };
        self.speed = self.speed.max(self.turning.cutting_speed(&engaged));
    }

    /// Adds the volume of a meeting to its side of the axis.
    pub fn weigh(&mut self, meeting: &Meeting, mirrored: bool) {
        self.sides[usize::from(mirrored)] += taken(meeting);
    }

    /// True if most of the cut is beyond the axis, and the programmed point as well.
    ///
    /// # Derivation
    /// Metal that both sides sweep is cut on this side: a nose that goes past the axis continues to cut here, and so does a round
    /// insert with its centre on the axis.
    pub fn beyond(&self, [start, end]: Piece) -> bool {
        start[1].max(end[1]) < -TOUCH && self.sides[1] > self.sides[0]
    }

    /// The alarm of a cause in this motion, with its place on the grid.
    pub fn alarm(&self, cause: Cause, [z, r]: [f64; 2], depth: Option<f64>) -> Alarm {
        let Motion { line, n, .. } = *self.motion;
        let place = [2.0 * (r + self.shift[1]), z + self.shift[0]];
        Alarm { cause, motion: self.index, file: self.file, line, n, place, depth }
    }

    /// Raises it; of each cause in one motion, only the deepest.
    pub fn raise(&mut self, cause: Cause, place: [f64; 2], depth: Option<f64>) {
        let alarm = self.alarm(cause, place, depth);
        match self.alarms.iter_mut().find(|other| other.cause.key() == cause.key()) {
            Some(other) if depth > other.depth => *other = alarm,
            Some(_) => {}
            None => self.alarms.push(alarm),
        }
    }
}

/// Raises the collisions with fixed bodies.
pub(super) fn collide(fixtures: &[(Fixture, Convex)], swept: &Convex, moving: Moving, tally: &mut Tally) {
    let (low, high) = swept.extent();
    for (fixture, polygon) in fixtures {
        let (from, to) = polygon.extent();
        if low.z >= to.z || from.z >= high.z || low.r >= to.r || from.r >= high.r {
            continue;
        }
        if let Some((deep, place)) = swept.overlap(polygon)
            && deep > TOUCH
        {
            tally.raise(Cause::Collision(moving, *fixture), place, Some(deep));
        }
    }
}

/// Raises the alarm of a reference point beyond its travel; `to_reference` leads from the programmed point to the reference point.
pub(super) fn travel(tally: &mut Tally, pieces: &[Piece], to_reference: [f64; 2], lathe: &Lathe) {
    for point in pieces.iter().flatten() {
        for (axis, at, [low, high], scale) in [
            (Axis::Z, point[0] + to_reference[0], lathe.travel_z, 1.0),
            (Axis::X, point[1] + to_reference[1], lathe.travel_x, 2.0),
        ] {
            for (greatest, limit, over) in [(false, low, low - at), (true, high, at - high)] {
                if over > TOUCH {
                    tally.raise(Cause::Travel { axis, greatest, limit: limit * scale }, *point, Some(over));
                }
            }
        }
    }
}
