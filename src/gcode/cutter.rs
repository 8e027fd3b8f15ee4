//! Cutter radius compensation: G41 and G42 of a milling machine as LinuxCNC makes them.
//!
//! [`Stage`] takes the programmed path in its plane piece by piece and hands out the path of the cutter's centre, R aside of it.
//! The last piece is held back, with what follows it without way in the plane, since the next one says where it ends.
//!
//! # The rules
//! - Entry: a line from where the cutter is to R aside of the programmed end, at right angles to the programmed line; or an
//!   arc whose programmed end is touched tangentially by the arc that is made: its centre lies on the normal there, as
//!   far from the start as from the end.
//! - Inner corners: the piece held back and the next one meet where their offsets cross. Of the two crossings beside an arc
//!   rodete takes LinuxCNC's, which near a reversal may be the one far from the corner.
//! - Outer corners: an arc about the corner at the next piece's feed, behind what follows the last piece without way; before
//!   a rapid motion a straight rapid one.
//! - Corners that turn by no more than [`NEARLY`] are none: the next piece goes on from where the last one ends.
//! - Exit: the last piece ends R aside of its own end, and the next motion, a straight one, leads from there to its end.
//!
//! # Units
//! Millimetres and radians; points along the plane's first and second axis.
//!
//! # Refusals
//! [`Misfit`]. A piece that the corners at its ends would turn round is refused at outer corners too, where LinuxCNC looks at
//! inner ones only.
//!
//! # References
//! LinuxCNC, cutter compensation, G40 to G42.1; corners as its interpreter `rs274` prints them, and crossings as
//! `convert_straight_comp2` and `convert_arc_comp2` of its `interp_convert.cc` choose them.

use std::f64::consts::{PI, TAU};

use crate::gcode::turning::nose::element::{End, distance, dot, plus};
use crate::gcode::turning::nose::{Element, Path, Point};
use crate::limits::HELD_PIECES;
use crate::machine::length_unit::LengthUnit;
use crate::number::trig;

/// A turn by no more than this is no corner; radians.
pub const NEARLY: f64 = 0.05;
/// By how much an arc may grow at its ends in a unit; radians.
const fn growth(unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::Inch => 0.001,
        LengthUnit::Millimetre => 0.0254,
    }
}
/// An arc that is left shorter than this is none; mm.
const LEFT: f64 = 0.001;

/// What keeps the cutter from following the path. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Misfit {
    /// The entry is not longer than the radius of the cutter.
    Entry {
        /// How long the entry is, from its start to its programmed end.
        length: f64,
        /// The radius of the cutter.
        radius: f64,
    },
    /// The entry arc cannot be made tangential at its end.
    EntryArc,
    /// An inner arc is not larger than the cutter.
    Arc {
        /// The radius of the cutter.
        radius: f64,
        /// The radius of the arc.
        arc: f64,
    },
    /// The offsets of the pieces before and after an inner corner do not meet.
    Corner {
        /// The radius of the cutter.
        radius: f64,
    },
    /// More than [`HELD_PIECES`] pieces without way in the plane in a row.
    Still,
    /// The corners at its ends take more of a piece than there is.
    Short {
        /// The radius of the cutter.
        radius: f64,
    },
}

/// A piece of the programmed path.
#[derive(Clone, Copy, Debug)]
pub struct Step<T> {
    /// Its way in the plane; [`Path::Still`] and lines without way are carried along.
    pub element: Element,
    /// It is a rapid motion.
    pub rapid: bool,
    /// What the caller knows it by.
    pub tag: T,
}

/// A piece of the cutter's path.
#[derive(Clone, Copy, Debug)]
pub struct OffsetPiece<T> {
    /// Its way in the plane.
    pub element: Element,
    /// It leads round the corner before the piece of its tag.
    pub corner: bool,
    /// The tag of the programmed piece.
    pub tag: T,
}

/// Where the centre of the cutter may be aside of a piece.
#[derive(Clone, Copy, Debug)]
enum Offset {
    /// `at` is the programmed end.
    Line { at: Point, through: Point, along: Point },
    /// `inside` says on which side of the programmed arc the cutter is; `turning` is 1 counter-clockwise, −1 clockwise; `ends` is
    /// the programmed radius at the end over that at the start.
    Circle { centre: Point, radius: f64, inside: bool, turning: f64, ends: f64 },
}

/// The pieces that are held back, the first with a way in the plane.
struct PendingPieces<T> {
    /// Where the first begins.
    start: Point,
    /// The programmed way of the first, whose direction or sweep tells a reversal; for an entry what is made.
    way: Element,
    entry: bool,
    first: T,
    stills: Vec<T>,
}

struct Following<T> {
    /// How the programmed path arrives at the corner to come.
    end: End,
    offset: Offset,
    held: PendingPieces<T>,
}

/// Radius compensation of a mill: pieces of the programmed path go in, pieces of the way of the cutter's centre come
/// out.
pub struct Stage<T> {
    /// 1 for left, −1 for right.
    side: f64,
    radius: f64,
    /// The unit in force, which decides by how much an arc may grow.
    unit: LengthUnit,
    following: Option<Following<T>>,
}

impl<T: Clone> Stage<T> {
    /// A stage before its entry, with the cutter's radius, greater than 0, and the unit of length in force.
    #[must_use]
    pub const fn new(left: bool, radius: f64, unit: LengthUnit) -> Self {
        Self { side: if left { 1.0 } else { -1.0 }, radius, unit, following: None }
    }

    /// Where the cutter's centre is R aside of the last piece's end; `None` before the entry.
    #[must_use]
    pub fn aside(&self) -> Option<Point> {
        self.following.as_ref().map(|following| self.beside(&following.end))
    }

    /// The entry that has just been taken in begins at another point than its programmed one.
    pub fn enter_from(&mut self, point: Point) {
        if let Some(following) = &mut self.following {
            following.held.start = point;
        }
    }

    /// Takes in a piece and puts what can be placed behind `out`, in order.
    ///
    /// # Errors
    /// What does not fit. The stage is of no use then.
    pub fn push(&mut self, step: Step<T>, out: &mut Vec<OffsetPiece<T>>) -> Result<(), Misfit> {
        let Some(mut following) = self.following.take() else { return self.enter(step, out) };
        let (Some(start), Some(end)) = (step.element.start(), step.element.end()) else {
            if following.held.stills.len() == HELD_PIECES {
                return Err(Misfit::Still);
            }
            following.held.stills.push(step.tag);
            self.following = Some(following);
            return Ok(());
        };
        let from = self.beside(&following.end);
        let turn = self.side * trig::atan2(cross(&following.end, &start), dot(following.end.along, start.along));
        let inside = |curvature: f64| self.side * curvature > 0.0;
        if inside(end.curvature) && 1.0 / end.curvature.abs() <= self.radius {
            return Err(Misfit::Arc { radius: self.radius, arc: 1.0 / end.curvature.abs() });
        }
        let offset = self.offset(&step.element, &end);
        // A path that goes back on itself turns round the corner outside, but where the two pieces bend apart.
        let back = PI - turn.abs() <= NEARLY;
        let bent = if start.curvature == 0.0 { following.end.curvature } else { start.curvature };
        let inner = if back { bent != 0.0 && !inside(bent) } else { turn > NEARLY };
        let begin = if inner {
            let meeting = meet(&following.offset, &offset).ok_or(Misfit::Corner { radius: self.radius })?;
            self.flush(following.held, meeting, out)?;
            meeting
        } else if back || turn < -NEARLY {
            self.flush(following.held, from, out)?;
            let to = self.beside(&start);
            let path = if step.rapid {
                Path::Line
            } else {
                let sweep = if back { PI } else { -turn };
                Path::Arc { centre: start.at, sweep: -self.side * self.around(start.at, from, to, sweep) }
            };
            out.push(OffsetPiece { element: Element { from, to, path }, corner: true, tag: step.tag.clone() });
            to
        } else {
            self.flush(following.held, from, out)?;
            from
        };
        let held = PendingPieces { start: begin, way: step.element, entry: false, first: step.tag, stills: Vec::new() };
        self.following = Some(Following { end, offset, held });
        Ok(())
    }

    /// Places what is held back; the compensation ends. Where the cutter's centre stays; `None` without an entry.
    ///
    /// # Errors
    /// As for [`Stage::push`].
    pub fn finish(&mut self, out: &mut Vec<OffsetPiece<T>>) -> Result<Option<Point>, Misfit> {
        let Some(following) = self.following.take() else { return Ok(None) };
        let end = self.beside(&following.end);
        self.flush(following.held, end, out).map(|()| Some(end))
    }

    /// The point R aside of the path at an end of a piece.
    fn beside(&self, end: &End) -> Point {
        plus(end.at, end.left(), self.side * self.radius)
    }

    fn offset(&self, element: &Element, end: &End) -> Offset {
        match element.path {
            Path::Arc { centre, .. } => {
                let ends = distance(end.at, centre) / distance(element.from, centre);
                self.circle(centre, distance(self.beside(end), centre), end, ends)
            }
            _ => Offset::Line { at: end.at, through: self.beside(end), along: end.along },
        }
    }

    fn circle(&self, centre: Point, radius: f64, end: &End, ends: f64) -> Offset {
        let inside = self.side * end.curvature > 0.0;
        Offset::Circle { centre, radius, inside, turning: 1.0_f64.copysign(end.curvature), ends }
    }

    fn enter(&mut self, step: Step<T>, _: &mut Vec<OffsetPiece<T>>) -> Result<(), Misfit> {
        let Element { from, to, path } = step.element;
        let (length, radius) = (distance(from, to), self.radius);
        let Some(end) = step.element.end().filter(|_| length > radius) else {
            return Err(Misfit::Entry { length, radius });
        };
        let (mut way, mut offset) = (step.element, self.offset(&step.element, &end));
        way.to = self.beside(&end);
        if let Path::Arc { sweep, .. } = path {
            if self.side * end.curvature > 0.0 && 1.0 / end.curvature.abs() <= radius {
                return Err(Misfit::Arc { radius, arc: 1.0 / end.curvature.abs() });
            }
            // The centre on the normal at the end, as far from the start.
            let normal = end.left().map(|share| share * 1.0_f64.copysign(end.curvature));
            let chord = plus(from, way.to, -1.0);
            let along = dot(chord, normal);
            let apart = dot(chord, chord) / (2.0 * along);
            if !apart.is_finite() || along.abs() <= 1e-6 * distance(from, way.to) || apart <= 0.0 {
                return Err(Misfit::EntryArc);
            }
            let centre = plus(way.to, normal, apart);
            let turns = (sweep.abs() / TAU).ceil().max(1.0) - 1.0;
            let swept = angle(centre, from, way.to, sweep);
            way.path = Path::Arc { centre, sweep: (swept + turns * TAU).copysign(sweep) };
            offset = self.circle(centre, apart, &end, 1.0);
        }
        let held = PendingPieces { start: from, way, entry: true, first: step.tag, stills: Vec::new() };
        self.following = Some(Following { end, offset, held });
        Ok(())
    }

    /// Places what is held back, its first piece ending at a point.
    fn flush(&self, held: PendingPieces<T>, to: Point, out: &mut Vec<OffsetPiece<T>>) -> Result<(), Misfit> {
        let PendingPieces { start: from, way, entry, first, stills } = held;
        let short = Misfit::Short { radius: self.radius };
        let path = match way.path {
            Path::Arc { centre, sweep } => {
                let left = angle(centre, from, to, sweep);
                // As far round as the programmed arc goes, and no further.
                let turns = ((sweep.abs() + growth(self.unit) - left) / TAU).floor();
                let left = left + turns * TAU;
                if left * distance(from, centre) < LEFT {
                    return Err(short);
                }
                Path::Arc { centre, sweep: left.copysign(sweep) }
            }
            _ if !entry && dot(plus(way.to, way.from, -1.0), plus(to, from, -1.0)) < 0.0 => return Err(short),
            path => path,
        };
        out.push(OffsetPiece { element: Element { from, to, path }, corner: false, tag: first });
        let still = Element { from: to, to, path: Path::Still };
        out.extend(stills.into_iter().map(|tag| OffsetPiece { element: still, corner: false, tag }));
        Ok(())
    }

    /// The angle round a corner, near to `about`.
    fn around(&self, corner: Point, from: Point, to: Point, about: f64) -> f64 {
        let swept = angle(corner, from, to, -self.side);
        if swept > about + PI { swept - TAU } else { swept }
    }
}

fn cross(one: &End, other: &End) -> f64 {
    one.along[0] * other.along[1] - one.along[1] * other.along[0]
}

/// The angle from one point to another about a centre in the direction of a sign, 0 to 2π.
fn angle(centre: Point, from: Point, to: Point, direction: f64) -> f64 {
    let [a, b] = [from, to].map(|point| plus(point, centre, -1.0));
    let between = trig::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b)) * 1.0_f64.copysign(direction);
    if between < 0.0 { between + TAU } else { between }
}

/// The crossing of two offsets at an inner corner, the first piece's before the next one's: LinuxCNC's, by side and turn.
fn meet(one: &Offset, other: &Offset) -> Option<Point> {
    let found = match (*one, *other) {
        (Offset::Line { through, along, .. }, Offset::Line { through: point, along: other, .. }) => {
            let across = along[0] * other[1] - along[1] * other[0];
            let apart = plus(point, through, -1.0);
            let way = (apart[0] * other[1] - apart[1] * other[0]) / across;
            plus(through, along, way)
        }
        // The distance of the corner from the centre is that of the end, as LinuxCNC has it.
        (Offset::Line { at, through, along }, Offset::Circle { centre, radius, inside, ends, .. }) => {
            let left = [-along[1], along[0]];
            let high = dot(plus(through, at, -1.0), left) + dot(plus(at, centre, -1.0), left) * ends;
            aside(centre, along, high, if inside { radius } else { -radius })
        }
        (Offset::Circle { centre, radius, inside, .. }, Offset::Line { through, along, .. }) => {
            let high = dot(plus(through, centre, -1.0), [-along[1], along[0]]);
            aside(centre, along, high, if inside { -radius } else { radius })
        }
        (
            Offset::Circle { centre, radius, inside, .. },
            Offset::Circle { centre: other, radius: second, turning, .. },
        ) => {
            let apart = distance(centre, other);
            let along = plus(other, centre, -1.0).map(|share| share / apart);
            let way = (apart * apart + radius * radius - second * second) / (2.0 * apart);
            let half = (radius * radius - way * way).sqrt() * if inside { turning } else { -turning };
            plus(plus(centre, along, way), [-along[1], along[0]], half)
        }
    };
    found.iter().all(|share| share.is_finite()).then_some(found)
}

/// Where a line crosses a circle, its height to the left of the centre known: the crossing further on for a positive radius, the
/// one further back for a negative.
fn aside(centre: Point, along: Point, high: f64, radius: f64) -> Point {
    let half = (radius * radius - high * high).sqrt().copysign(radius);
    plus(plus(centre, [-along[1], along[0]], high), along, half)
}
