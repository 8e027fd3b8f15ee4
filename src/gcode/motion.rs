//! Canonical motions: what a control does with a program, whatever the dialect.

use crate::machine::axis::{Axis, Pose};

/// The plane of arcs and canned cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plane {
    /// G17: first axis X, second Y, across it Z.
    #[default]
    XY,
    /// G18: first axis Z, second X, across it Y.
    ZX,
    /// G19: first axis Y, second Z, across it X.
    YZ,
}

impl Plane {
    /// The first and second axis, in the order in which the angle counts from the first to the second, and the axis across.
    #[must_use]
    pub const fn axes(self) -> [Axis; 3] {
        match self {
            Self::XY => [Axis::X, Axis::Y, Axis::Z],
            Self::ZX => [Axis::Z, Axis::X, Axis::Y],
            Self::YZ => [Axis::Y, Axis::Z, Axis::X],
        }
    }

    /// `G17`, `G18`, `G19`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::XY => "G17",
            Self::ZX => "G18",
            Self::YZ => "G19",
        }
    }
}

/// How F is meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FeedMode {
    /// mm (or degrees) per minute.
    #[default]
    PerMinute,
    /// mm per revolution of the spindle.
    PerRevolution,
    /// The inverse of the move's time in minutes.
    InverseTime,
    /// The move's time in seconds.
    Seconds,
}

/// A feed: the F word with its meaning, in mm (or degrees) where it carries a length.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Feed {
    /// How it is meant.
    pub mode: FeedMode,
    /// The number; 0 where the program has given none and the dialect lets that pass.
    pub value: f64,
}

/// A circular arc or helix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The plane.
    pub plane: Plane,
    /// The centre in program coordinates, along the plane's first and second axis; mm.
    pub centre: [f64; 2],
    /// Whole and begun turns, positive counter-clockwise seen against the axis across the plane: 1 for an arc up to a
    /// full circle, 2 for one that passes its start once, and so on. Never 0.
    pub turns: i32,
    /// The radius at the start, mm.
    pub radius: f64,
    /// The direction of the start seen from the centre, radians from the first axis towards the second.
    pub start: f64,
    /// The angle swept, positive counter-clockwise, radians.
    pub sweep: f64,
}

/// What is moved how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// At the machine's rapid rate, each axis as it can.
    Rapid,
    /// Along a straight line in all axes, at feed.
    Feed(Feed),
    /// Along an arc or helix, at feed.
    Arc(Arc, Feed),
    /// Not at all, for some seconds.
    Dwell(f64),
}

/// One canonical motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// The line of the program's file, counted from 1.
    pub line: usize,
    /// The block number.
    pub n: Option<u32>,
    /// What is done.
    pub kind: Kind,
    /// Where it starts, in the program coordinates of `to`.
    pub from: Pose,
    /// Where it ends, in program coordinates: work offset, rotation, G92 and tool offset taken out.
    pub to: Pose,
    /// Where it ends, in machine coordinates.
    pub machine: Pose,
    /// The time it takes, s; `None` for rapid moves and where no feed was given.
    pub seconds: Option<f64>,
}
