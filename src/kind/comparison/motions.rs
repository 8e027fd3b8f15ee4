//! Programs side by side, motion by motion.

use crate::gcode::interpreter::Interpreter;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::Program;
use crate::kind::{Outcome, Proved};
use crate::machine::axis::{Axis, Pose};
use crate::proof::account::Extents;
use crate::text::Text;

/// The first motion that is another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Its number, counted from 1.
    pub motion: u64,
    /// Its line in each program, counted from 1; `None` in a program that has ended.
    pub lines: [Option<usize>; 2],
}

/// How far the ends of two motions of the same number are apart at most, along one axis of a sort.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart {
    /// The axis.
    pub axis: Axis,
    /// How far: mm, of a rotary axis degrees.
    pub by: f64,
    /// The number of the motion, counted from 1.
    pub motion: u64,
}

/// A program of each side.
#[derive(Clone, Debug)]
pub struct ProgramPair {
    /// Its key, as `blade`.
    pub key: &'static str,
    /// What it does.
    pub title: Text,
    /// How many motions each has; `None` where the side has no such program.
    pub motions: [Option<u64>; 2],
    /// The first motion that differs; `None` where all are the same, or one side has no such program.
    pub first: Option<Difference>,
    /// The greatest distance of linear axes, and of rotary ones, over the motions that both have; none where there is none.
    pub apart: Vec<Apart>,
    /// Where each ends, in program coordinates.
    pub end: [Option<Pose>; 2],
    /// How far each goes, in program coordinates.
    pub extents: [Option<Extents>; 2],
    /// Its time, s: the cycle's where rapid moves are known, else at feed; `None` where it is not known.
    pub seconds: [Option<f64>; 2],
}

impl ProgramPair {
    /// True where both sides have it, and all motions are the same.
    #[must_use]
    pub const fn equal(&self) -> bool {
        self.first.is_none() && matches!(self.motions, [Some(_), Some(_)])
    }
}

/// The programs of both sides, by their keys.
pub(super) fn programs(outcomes: [Option<&Outcome>; 2]) -> Vec<ProgramPair> {
    let programs = outcomes.map(|one| one.map_or(&[][..], |one| &one.programs));
    let mut keys: Vec<&'static str> = Vec::new();
    for program in programs.into_iter().flatten() {
        if !keys.contains(&program.key) {
            keys.push(program.key);
        }
    }
    keys.into_iter()
        .filter_map(|key| pair(programs.map(|all| all.iter().find(|one| one.key == key)), outcomes))
        .collect()
}

fn pair(sides: [Option<&Proved>; 2], outcomes: [Option<&Outcome>; 2]) -> Option<ProgramPair> {
    let named = sides.into_iter().flatten().next()?;
    let (mut first, mut apart) = (None, Vec::new());
    if let ([Some(one), Some(other)], [Some(of), Some(from)]) = (sides, outcomes) {
        (first, apart) = compared(reader(of, one), reader(from, other));
    }
    Some(ProgramPair {
        key: named.key,
        title: named.title.clone(),
        motions: sides.map(|side| side.map(|side| side.account.motions)),
        first,
        apart,
        end: sides.map(|side| side.map(|side| side.account.end[0])),
        extents: sides.map(|side| side.and_then(|side| side.account.program)),
        seconds: sides.map(|side| side.and_then(seconds)),
    })
}

fn seconds(program: &Proved) -> Option<f64> {
    let feed = (!program.account.untimed).then_some(program.account.seconds);
    program.duration.filter(|duration| duration.timeless == 0).map(|duration| duration.seconds).or(feed)
}

/// The program as its kind reads it.
fn reader<'a>(outcome: &Outcome, program: &'a Program) -> Interpreter<'a> {
    let setting = outcome.kind.setting(&outcome.fields, program);
    program.read_back_with(setting.unwrap_or_else(|| program.setting()))
}

/// The first motion that differs, and the greatest distances. A block that cannot be read counts as a motion at its line that
/// is the same where both cannot be read.
fn compared(mut one: Interpreter<'_>, mut other: Interpreter<'_>) -> (Option<Difference>, Vec<Apart>) {
    let (mut first, mut greatest): (Option<Difference>, [Option<Apart>; 2]) = (None, [None; 2]);
    for motion in 1.. {
        let pair = [one.next(), other.next()];
        let read = pair.each_ref().map(|one| one.as_ref().map(|motion| motion.as_ref().ok()));
        if let [None, None] = read {
            break;
        }
        let same = match read {
            [Some(Some(one)), Some(Some(other))] => is(one, other),
            [Some(None), Some(None)] => true,
            _ => false,
        };
        if !same && first.is_none() {
            let line = |one: Option<Option<&Motion>>| one.flatten().map(|motion| motion.line);
            first = Some(Difference { motion, lines: read.map(line) });
        }
        if let [Some(Some(one)), Some(Some(other))] = read {
            for axis in Axis::ALL {
                let by = (one.to.get(axis) - other.to.get(axis)).abs();
                let worst = &mut greatest[usize::from(axis.rotary())];
                if by > worst.map_or(0.0, |worst| worst.by) {
                    *worst = Some(Apart { axis, by, motion });
                }
            }
        } else if read.iter().any(Option::is_none) {
            // One has ended: there is nothing more to be told.
            break;
        }
    }
    (first, greatest.into_iter().flatten().collect())
}

/// True of the same motion: its sort, feed, arc, and where it ends; not of its line and number.
fn is(one: &Motion, other: &Motion) -> bool {
    let same = match (one.kind, other.kind) {
        (MotionKind::Arc(arc, feed), MotionKind::Arc(another, fed)) => arc == another && feed == fed,
        (kind, another) => kind == another,
    };
    same && one.to == other.to && one.machine == other.machine
}
