//! The motions of a program beside its plan, and what a judge is.

use std::fmt;
use std::iter::Peekable;

use crate::gcode::in_force::InForce;
use crate::gcode::interpreter::Interpreter;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::{Path, Program};
use crate::machine::axis::{Axis, Pose};
use crate::proof::check::Check;

/// Positions closer than this are one: a hundredth of the output grid, far above what sums of increments lose.
pub const SAME: f64 = 1e-5;

/// True where two poses are one.
#[must_use]
pub fn same(one: &Pose, other: &Pose) -> bool {
    one.differences(other).iter().all(|difference| difference.abs() < SAME)
}

/// How a planned move is interpolated, as controls call it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interpolation {
    /// At rapid: no metal is meant to be cut.
    Rapid,
    /// Straight, at feed.
    Straight,
    /// Along an arc.
    Arc {
        /// To the right: G2.
        clockwise: bool,
        /// Its radius, mm.
        radius: f64,
    },
}

/// How long a planned move takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Time {
    /// What the machine needs, or what a judge of its own asks for.
    Free,
    /// It carries no feed.
    Unknown,
    /// So many seconds.
    Seconds(f64),
}

/// A move of the plan.
#[derive(Clone, Copy, Debug)]
pub struct Planned<'a> {
    /// Where it starts.
    pub from: Pose,
    /// Where it ends.
    pub to: Pose,
    /// How it runs from there.
    pub interpolation: Interpolation,
    /// How long it takes.
    pub time: Time,
    /// Its line in the program's text, counted from 1, where the plan knows it.
    pub line: Option<usize>,
    /// Its number in the kind's own list of moves.
    pub leg: usize,
    /// Its path and its number in that, where the program was written along paths.
    pub path: Option<(&'a Path, usize)>,
}

/// Where a plan begins.
#[derive(Clone, Copy, Debug)]
enum Begin {
    /// At its first position. A program that does not find it itself begins wherever the machine stands, and is moved there;
    /// the line that takes the tool away is none of the plan's.
    Position { start: Pose, found: bool, away: Option<(usize, Frame)> },
    /// With the first motion that is not rapid.
    Pierce,
}

/// What the block that takes the tool away counts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Frame {
    Machine,
    Program,
}

/// What a program is meant to do, move by move.
pub struct Plan<'a> {
    begin: Begin,
    moves: Peekable<Box<dyn Iterator<Item = Planned<'a>> + 'a>>,
}

impl fmt::Debug for Plan<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Plan").field("begin", &self.begin).finish_non_exhaustive()
    }
}

impl<'a> Plan<'a> {
    /// The moves along the paths of a program.
    #[must_use]
    pub fn of(program: &'a Program) -> Self {
        let moves = program.moves().enumerate().map(|(leg, planned)| {
            let rapid = planned.path.rapid;
            let time = match planned.path.seconds(planned.step) {
                _ if rapid => Time::Free,
                None => Time::Unknown,
                Some(seconds) => Time::Seconds(seconds),
            };
            Planned {
                from: Pose::from(planned.from),
                to: Pose::from(planned.to),
                interpolation: if rapid { Interpolation::Rapid } else { Interpolation::Straight },
                time,
                line: Some(planned.line),
                leg,
                path: Some((planned.path, planned.step)),
            }
        });
        let (start, found) = (Pose::from(program.start), program.finds_its_start());
        let away = program
            .away()
            .map(|(line, retract)| (line, if retract.by_machine() { Frame::Machine } else { Frame::Program }));
        let moves: Box<dyn Iterator<Item = Planned<'a>> + 'a> = Box::new(moves);
        Self { begin: Begin::Position { start, found, away }, moves: moves.peekable() }
    }

    /// The moves of a program from its first motion on, rapid moves too; that begins at zero in each axis.
    #[must_use]
    pub fn from_zero(moves: impl Iterator<Item = Planned<'a>> + 'a) -> Self {
        let moves: Box<dyn Iterator<Item = Planned<'a>> + 'a> = Box::new(moves);
        let begin = Begin::Position { start: Pose::default(), found: true, away: None };
        Self { begin, moves: moves.peekable() }
    }

    /// The moves of a torch from where it pierces: what is rapid before the first other motion brings it there.
    #[must_use]
    pub fn from_the_pierce(moves: impl Iterator<Item = Planned<'a>> + 'a) -> Self {
        let moves: Box<dyn Iterator<Item = Planned<'a>> + 'a> = Box::new(moves);
        Self { begin: Begin::Pierce, moves: moves.peekable() }
    }
}

/// What a motion is to the plan.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "one at a time, and most are of the largest")]
pub enum Stage<'a> {
    /// It goes nowhere, or takes the tool away first of all to a place of the machine: a dwell, a rapid move to where the machine
    /// stands.
    Still,
    /// It takes the tool away first of all, in program coordinates.
    Away,
    /// It brings the machine to the start: where it comes from is not known.
    Positioning,
    /// It answers to this move.
    Planned(Planned<'a>),
    /// The plan has ended, or there is none.
    Unplanned,
}

/// A motion beside its plan.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// The motion, in program coordinates.
    pub motion: Motion,
    /// What the control has in force during it.
    pub in_force: InForce,
    /// What it is to the plan.
    pub stage: Stage<'a>,
}

impl Step<'_> {
    /// True for a motion that belongs to the plan, or should: the machine neither stands nor is on its way to the start.
    #[must_use]
    pub const fn at_work(&self) -> bool {
        matches!(self.stage, Stage::Planned(_) | Stage::Unplanned)
    }

    /// Where a judge that watches positions must look: the end, and the beginning where it is known.
    pub fn ends(&self) -> impl Iterator<Item = &Pose> {
        let (from, to) = match self.stage {
            Stage::Still | Stage::Away => (false, false),
            Stage::Positioning => (false, true),
            Stage::Planned(_) | Stage::Unplanned => (true, true),
        };
        from.then_some(&self.motion.from).into_iter().chain(to.then_some(&self.motion.to))
    }
}

/// One that watches a program, motion by motion.
pub trait Judge: Send {
    /// The next motion.
    fn see(&mut self, step: &Step<'_>);

    /// The program has been read to its end.
    fn end(&mut self, _text: &Interpreter<'_>) {}

    /// The answers, when the program has ended.
    fn checks(self: Box<Self>, program: &Program) -> Vec<Check>;
}

/// Puts the motions of a program beside its plan.
#[derive(Debug)]
pub struct Steps<'a> {
    plan: Plan<'a>,
    shift: Option<[f64; 9]>,
    started: bool,
}

impl<'a> Steps<'a> {
    /// For the motions of a program with this plan.
    #[must_use]
    pub const fn new(plan: Plan<'a>) -> Self {
        Self { plan, shift: None, started: false }
    }

    /// The next motion of the text beside its plan.
    pub fn next(&mut self, mut motion: Motion, in_force: InForce) -> Step<'a> {
        if let Begin::Position { start, found, .. } = self.plan.begin {
            let shift = if found { [0.0; 9] } else { start.differences(&motion.from) };
            let shift = *self.shift.get_or_insert(shift);
            for axis in Axis::ALL {
                for pose in [&mut motion.from, &mut motion.to] {
                    pose.set(axis, pose.get(axis) + shift[axis as usize]);
                }
            }
        }
        let stage = self.stage(&motion);
        Step { motion, in_force, stage }
    }

    fn stage(&mut self, motion: &Motion) -> Stage<'a> {
        let rapid = matches!(motion.kind, MotionKind::Rapid);
        if matches!(motion.kind, MotionKind::Dwell(_)) {
            return Stage::Still;
        }
        let still = rapid && same(&motion.from, &motion.to);
        match self.plan.begin {
            Begin::Position { away: Some((line, frame)), .. } if line == motion.line => {
                // A place of the machine is none of the program's positions.
                return if frame == Frame::Machine || still { Stage::Still } else { Stage::Away };
            }
            Begin::Position { .. } if still => return Stage::Still,
            Begin::Position { start, .. } => {
                let before = self.plan.moves.peek().and_then(|planned| planned.line);
                let before = before.is_some_and(|line| motion.line < line);
                if !self.started && !same(&motion.from, &start) && before {
                    return Stage::Positioning;
                }
            }
            Begin::Pierce if rapid && !self.started => return Stage::Positioning,
            Begin::Pierce if still => return Stage::Still,
            Begin::Pierce => {}
        }
        self.started = true;
        self.plan.moves.next().map_or(Stage::Unplanned, Stage::Planned)
    }
}
