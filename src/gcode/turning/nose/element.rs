//! The pieces of a path in the plane ZX, with their tangents and curvatures.

use crate::number::trig;

/// A point or a vector of the plane, `[Z, X]`, X the radius; mm. Angles count from +Z towards +X, as [`Arc`] has them.
///
/// [`Arc`]: crate::gcode::motion::Arc
pub type Point = [f64; 2];

/// How a piece goes from its start to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Path {
    /// Not at all: a dwell, or a motion of other axes.
    Still,
    /// Straight to its end.
    Line,
    /// Along an arc.
    Arc {
        /// The centre, `[Z, X]`, mm.
        centre: Point,
        /// The angle swept, positive counter-clockwise, radians.
        sweep: f64,
    },
}

/// A piece of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// Where it starts.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// How it goes.
    pub path: Path,
}

/// Shorter than this a piece has no direction: rounding of doubles, mm.
const NOTHING: f64 = 1e-9;

/// How an element leaves its start or arrives at its end.
#[derive(Clone, Copy, Debug)]
pub(in crate::gcode) struct End {
    /// Where that is, `[Z, X]`, mm.
    pub at: Point,
    /// The direction of travel, of length 1.
    pub along: Point,
    /// The curvature, positive where the path bends left; 0 for a line, 1/mm.
    pub curvature: f64,
}

impl End {
    /// The unit vector to the left of the direction of travel.
    pub const fn left(&self) -> Point {
        [-self.along[1], self.along[0]]
    }
}

impl Element {
    /// How far it is from the start to the end, along the path; mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self.path {
            Path::Still => 0.0,
            Path::Line => distance(self.from, self.to),
            Path::Arc { centre, sweep } => (sweep * distance(self.from, centre)).abs(),
        }
    }

    /// The same with every point shifted.
    #[must_use]
    pub fn shifted(&self, by: Point) -> Self {
        let path = match self.path {
            Path::Arc { centre, sweep } => Path::Arc { centre: plus(centre, by, 1.0), sweep },
            path => path,
        };
        Self { from: plus(self.from, by, 1.0), to: plus(self.to, by, 1.0), path }
    }

    /// How it leaves its start; `None` where it has no length.
    pub(in crate::gcode) fn start(&self) -> Option<End> {
        self.direction(self.from)
    }

    /// How it arrives at its end; `None` where it has no length.
    pub(in crate::gcode) fn end(&self) -> Option<End> {
        self.direction(self.to)
    }

    fn direction(&self, at: Point) -> Option<End> {
        match self.path {
            Path::Line => {
                let length = distance(self.from, self.to);
                let along = plus(self.to, self.from, -1.0).map(|share| share / length);
                (length > NOTHING).then_some(End { at, along, curvature: 0.0 })
            }
            Path::Arc { centre, sweep } => {
                let radius = distance(at, centre);
                if self.length() <= NOTHING || radius <= NOTHING {
                    return None;
                }
                let out = plus(at, centre, -1.0).map(|share| share / radius);
                let turning = 1.0_f64.copysign(sweep);
                Some(End { at, along: [-out[1] * turning, out[0] * turning], curvature: turning / radius })
            }
            Path::Still => None,
        }
    }
}

pub(in crate::gcode) fn plus(a: Point, b: Point, factor: f64) -> Point {
    [a[0] + b[0] * factor, a[1] + b[1] * factor]
}

pub(in crate::gcode) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Positive where `b` points to the left of `a`.
pub(super) fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(in crate::gcode) fn distance(a: Point, b: Point) -> f64 {
    trig::hypot(a[0] - b[0], a[1] - b[1])
}
