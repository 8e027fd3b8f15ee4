//! Canonical motions: what a control does with a program, whichever it is.

use std::f64::consts::{PI, TAU};

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
    /// The number; 0 where the program has given none and the control lets that pass.
    pub value: f64,
}

/// A circular arc or helix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// The plane in which it is an arc.
    pub plane: Plane,
    /// The centre in program coordinates, along the plane's first and second axis; mm.
    pub centre: [f64; 2],
    /// Whole and begun turns, positive counter-clockwise seen against the axis across the plane: 1 for an arc up to a
    /// full circle, 2 for one that passes its start once, and so on. Never 0.
    pub turns: i32,
    /// The radius at the start, mm.
    pub radius: f64,
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
    /// # Derivation
    /// Along the direction d the arc goes as f(θ) = A cos θ + B sin θ + D θ, with A and B the radius by d's shares of the
    /// plane's axes and D the rise per radian by d's share of the axis across. f′ = 0 where sin(θ − φ) = D/H with
    /// H = √(A² + B²), φ = atan2(B, A): twice a turn, and from turn to turn f at either goes on by 2πD, so that the first
    /// and the last of each are the farthest.
    pub fn farthest(&self, from: &Pose, to: &Pose, direction: [f64; 3], visit: &mut dyn FnMut(&Pose)) {
        let axes = self.plane.axes();
        let [a, b, across] = axes;
        let share = axes.map(|axis| direction[axis as usize]);
        let D = share[2] * (to.get(across) - from.get(across)) / self.sweep;
        let H = self.radius * trig::hypot(share[0], share[1]);
        if self.sweep == 0.0 || D.abs() >= H {
            return;
        }
        let [x, y] = [from.get(a) - self.centre[0], from.get(b) - self.centre[1]];
        let start = trig::atan2(y, x);
        let (low, high) = (start.min(start + self.sweep), start.max(start + self.sweep));
        let (middle, aside) = (trig::atan2(share[1], share[0]), trig::asin(D / H));
        for stationary in [middle + aside, middle + PI - aside] {
            let first = stationary + ((low - stationary) / TAU).ceil() * TAU;
            let last = stationary + ((high - stationary) / TAU).floor() * TAU;
            if first > last {
                continue;
            }
            for angle in [first, last] {
                let part = (angle - start) / self.sweep;
                let (sin, cos) = trig::sin_cos(angle);
                let mut at = Pose(std::array::from_fn(|axis| from.0[axis] + (to.0[axis] - from.0[axis]) * part));
                at.set(a, self.centre[0] + self.radius * cos);
                at.set(b, self.centre[1] + self.radius * sin);
                visit(&at);
            }
        }
    }

    /// How far the arc between two poses reaches along the axes of its plane where it passes a quarter turn about its
    /// centre: there it is farthest. Program coordinates.
    pub fn quarters(&self, from: &Pose, to: &Pose, visit: &mut dyn FnMut(Axis, f64)) {
        let [a, b, _] = self.plane.axes();
        let clockwise = self.sweep < 0.0;
        // Quarters counted in the direction of the arc.
        let quarter = |pose: &Pose| {
            let (x, y) = (pose.get(a) - self.centre[0], pose.get(b) - self.centre[1]);
            let y = if clockwise { -y } else { y };
            match (x > 0.0, y > 0.0) {
                (true, _) if y >= 0.0 => 0_u8,
                (false, true) => 1,
                (false, false) if x < 0.0 => 2,
                _ => 3,
            }
        };
        let (first, last) = (quarter(from), quarter(to));
        let passed = match (last + 4 - first) % 4 {
            _ if self.sweep.abs() >= TAU => 4,
            0 if self.sweep.abs() > PI => 4,
            passed => passed,
        };
        let up = if clockwise { -self.radius } else { self.radius };
        for next in first + 1..=first + passed {
            match next % 4 {
                0 => visit(a, self.centre[0] + self.radius),
                1 => visit(b, self.centre[1] + up),
                2 => visit(a, self.centre[0] - self.radius),
                _ => visit(b, self.centre[1] - up),
            }
        }
    }
}

/// A thread cut in one pass: the spindle's revolutions lead the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thread {
    /// The lead at the start, mm a revolution, along the axis that moves more.
    pub lead: f64,
    /// By how much the lead grows with each revolution, mm; 0 for a constant lead.
    pub change: f64,
    /// The spindle's angle at which the pass begins, degrees, from 0 to below 360. In a block that goes on a thread it says
    /// nothing: the thread goes on as it stands.
    pub angle: f64,
}

/// What is moved how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MotionKind {
    /// At the machine's rapid rate, each axis as it can.
    Rapid,
    /// Along a straight line in all axes, at feed.
    Feed(Feed),
    /// Along an arc or helix, at feed.
    Arc(Arc, Feed),
    /// Along a straight line, led by the spindle.
    Thread(Thread),
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
    pub kind: MotionKind,
    /// Where it starts, in the program coordinates of `to`.
    pub from: Pose,
    /// Where it ends, in program coordinates: work offset, rotation, G92 and tool offset taken out.
    pub to: Pose,
    /// Where it ends, in machine coordinates.
    pub machine: Pose,
    /// The time it takes, s; `None` for rapid moves and where no feed was given.
    pub seconds: Option<f64>,
}
