//! Canonical motions: what a control does with a program, whatever the dialect.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::machine::axis::{Axis, Pose};
use crate::number::trig;

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
    /// How far the work offset turns program coordinates about Z against the machine's, degrees.
    pub rotation: f64,
}

impl Arc {
    /// The length of the arc, a helix if it rises across its plane; mm.
    #[must_use]
    pub fn length(&self, rise: f64) -> f64 {
        let around = self.sweep * self.radius;
        (around * around + rise * rise).sqrt()
    }

    /// The points of the arc between two poses where it reaches farthest along a direction, start and end left out;
    /// program coordinates, the other axes at their share of the way.
    ///
    /// Along the direction d the arc goes as f(θ) = A cos θ + B sin θ + D θ, with A and B the radius by d's shares of the
    /// plane's axes and D the rise per radian by d's share of the axis across. f′ = 0 where sin(θ − φ) = D/H with
    /// H = √(A² + B²), φ = atan2(B, A): twice a turn, and from turn to turn f at either goes on by 2πD, so that the first
    /// and the last of each are the farthest. Derived here.
    pub fn farthest(&self, from: &Pose, to: &Pose, direction: [f64; 3], visit: &mut dyn FnMut(&Pose)) {
        let axes = self.plane.axes();
        let [a, b, across] = axes;
        let share = axes.map(|axis| direction[axis as usize]);
        let D = share[2] * (to.get(across) - from.get(across)) / self.sweep;
        let H = self.radius * trig::hypot(share[0], share[1]);
        if self.sweep == 0.0 || D.abs() >= H {
            return;
        }
        let (low, high) = (self.start.min(self.start + self.sweep), self.start.max(self.start + self.sweep));
        let (middle, aside) = (trig::atan2(share[1], share[0]), trig::asin(D / H));
        for stationary in [middle + aside, middle + PI - aside] {
            let first = stationary + ((low - stationary) / TAU).ceil() * TAU;
            let last = stationary + ((high - stationary) / TAU).floor() * TAU;
            if first > last {
                continue;
            }
            for angle in [first, last] {
                let part = (angle - self.start) / self.sweep;
                let (sin, cos) = trig::sin_cos(angle);
                let mut at = Pose(std::array::from_fn(|axis| from.0[axis] + (to.0[axis] - from.0[axis]) * part));
                at.set(a, self.centre[0] + self.radius * cos);
                at.set(b, self.centre[1] + self.radius * sin);
                visit(&at);
            }
        }
    }

    /// The points of the arc between two poses where it reaches farthest along its plane's axes, start and end left out:
    /// at every quarter turn about its centre that it passes. Program coordinates; the other axes at their share of the way.
    pub fn quarters(&self, from: &Pose, to: &Pose, visit: &mut dyn FnMut(&Pose)) {
        let [a, b, _] = self.plane.axes();
        if self.sweep == 0.0 {
            return;
        }
        // At most the four quarters of one turn are farthest; a helix adds nothing to them.
        let (begin, step) = if self.sweep > 0.0 {
            ((self.start / FRAC_PI_2).floor() + 1.0, 1.0)
        } else {
            ((self.start / FRAC_PI_2).ceil() - 1.0, -1.0)
        };
        for passed in 0..4_u8 {
            let quarter = begin + step * f64::from(passed);
            let part = (quarter * FRAC_PI_2 - self.start) / self.sweep;
            if part >= 1.0 {
                break;
            }
            let mut at = *from;
            for axis in Axis::ALL {
                at.set(axis, from.get(axis) + (to.get(axis) - from.get(axis)) * part);
            }
            let ways = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 3")]
            let way = ways[quarter.rem_euclid(4.0) as usize % 4];
            at.set(a, self.centre[0] + self.radius * way[0]);
            at.set(b, self.centre[1] + self.radius * way[1]);
            visit(&at);
        }
    }
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
