//! The motions of a program beside its plan, and what a judge is.

use crate::gcode::interpreter::Fault;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::{Move, Moves, Program, Role};
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::proof::check::Check;
use crate::proof::track::Track;

/// Positions closer than this are one: a hundredth of the output grid, far above what sums of increments lose.
pub const SAME: f64 = 1e-5;

/// True where two poses are one.
#[must_use]
pub fn same(one: &Pose, other: &Pose) -> bool {
    one.differences(other).iter().all(|difference| difference.abs() < SAME)
}

/// What a motion is to the plan.
#[derive(Clone, Copy, Debug)]
pub enum Stage<'a> {
    /// It brings the machine to the start: where it comes from is not known.
    Positioning,
    /// It answers to this move.
    Planned(Move<'a>),
    /// The plan has ended.
    Unplanned,
}

/// A motion beside its plan.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// The motion, in program coordinates.
    pub motion: Motion,
    /// What it is to the plan.
    pub stage: Stage<'a>,
}

/// A motion that cuts.
#[derive(Clone, Copy, Debug)]
pub struct TrackStep {
    /// The track.
    pub track: Track,
    /// How far C is turned on beyond the track's own position.
    pub turn: Milli,
    /// The point index from which it runs and that to which it runs; `None` for the safe point.
    pub points: [Option<usize>; 2],
}

impl Step<'_> {
    /// What of a track the motion cuts, or leaves.
    #[must_use]
    pub fn cut(&self) -> Option<TrackStep> {
        let Stage::Planned(planned) = self.stage else { return None };
        let path = planned.path;
        let index = |step: usize| if path.backwards { path.positions.len().checked_sub(step + 1) } else { Some(step) };
        let (key, points) = match path.role {
            Role::Clear => return None,
            Role::Cut(key) => (key, [planned.step.checked_sub(1).and_then(index), index(planned.step)]),
            Role::Leave(key) => (key, [None, None]),
        };
        Some(TrackStep { track: Track::from_key(key)?, turn: path.turn, points })
    }

    /// True for a motion that should be clear of the part.
    #[must_use]
    pub const fn clear(&self) -> bool {
        matches!(self.stage, Stage::Planned(Move { path, .. }) if matches!(path.role, Role::Clear))
    }

    /// Where a judge that watches positions must look: the end, and the beginning where it is known.
    pub fn ends(&self) -> impl Iterator<Item = &Pose> {
        let known = !matches!(self.stage, Stage::Positioning);
        known.then_some(&self.motion.from).into_iter().chain([&self.motion.to])
    }
}

/// One that watches a program, motion by motion.
pub trait Judge {
    /// The next motion.
    fn see(&mut self, step: &Step<'_>);

    /// The answers, when the program has ended.
    fn checks(&mut self, program: &Program) -> Vec<Check>;
}

/// The motions of a program beside its moves. Motions of no length and dwells are passed over, as in the plan.
///
/// A program that does not find its start is moved to where the plan starts.
#[derive(Debug)]
pub struct Steps<'a, I> {
    motions: I,
    plan: Moves<'a>,
    next: Option<Move<'a>>,
    start: Pose,
    shift: Option<[f64; 9]>,
    away: Option<usize>,
    started: bool,
}

impl<'a, I: Iterator<Item = Result<Motion, Box<Fault>>>> Steps<'a, I> {
    /// The steps of a program whose text gave these motions.
    #[must_use]
    pub fn new(program: &'a Program, motions: I) -> Self {
        let mut plan = program.moves();
        let next = plan.next();
        let shift = program.finds_its_start().then_some([0.0; 9]);
        Self { motions, plan, next, start: Pose::from(program.start), shift, away: program.away(), started: false }
    }
}

impl<'a, I: Iterator<Item = Result<Motion, Box<Fault>>>> Iterator for Steps<'a, I> {
    type Item = Result<Step<'a>, Box<Fault>>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let mut motion = match self.motions.next()? {
                Ok(motion) => motion,
                Err(fault) => return Some(Err(fault)),
            };
            let shift = *self.shift.get_or_insert_with(|| self.start.differences(&motion.from));
            for axis in Axis::ALL {
                for pose in [&mut motion.from, &mut motion.to] {
                    pose.set(axis, pose.get(axis) + shift[axis as usize]);
                }
            }
            // Where the tool is taken away to may be a place of the machine: it is none of the program's positions.
            let away = self.away == Some(motion.line);
            if away || matches!(motion.kind, MotionKind::Dwell(_)) || same(&motion.from, &motion.to) {
                continue;
            }
            let before = self.next.is_some_and(|planned| motion.line < planned.line);
            if !self.started && !same(&motion.from, &self.start) && before {
                return Some(Ok(Step { motion, stage: Stage::Positioning }));
            }
            self.started = true;
            let stage = self.next.map_or(Stage::Unplanned, Stage::Planned);
            self.next = self.plan.next();
            return Some(Ok(Step { motion, stage }));
        }
    }
}

/// Lets all judges see all motions of a program.
///
/// # Errors
/// Passes on what the interpreter refuses.
pub fn watch(
    program: &Program,
    motions: impl Iterator<Item = Result<Motion, Box<Fault>>>,
    judges: &mut [&mut dyn Judge],
) -> Result<(), Box<Fault>> {
    for step in Steps::new(program, motions) {
        let step = step?;
        for judge in &mut *judges {
            judge.see(&step);
        }
    }
    Ok(())
}
