//! Programs side by side, motion by motion.

use crate::gcode::control::Comments;
use crate::gcode::interpreter::{Interpreter, Refused, Setting, bare};
use crate::gcode::motion::{Feed, Motion, MotionKind};
use crate::gcode::program::Program;
use crate::kind::{Outcome, Proved};
use crate::machine::axis::{Axis, Pose};
use crate::proof::account::Extents;
use crate::text::Text;

/// Positions no farther apart than this are the same, mm and degrees: increments add up to sums of floating point, which are off
/// by far less, and a program's grid is a thousand times coarser.
const SAME: f64 = 1e-6;

/// True of figures that differ by the rounding of sums at most.
pub(super) fn same(one: f64, other: f64) -> bool {
    (one - other).abs() <= SAME
}

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
    /// The axis along which they are.
    pub axis: Axis,
    /// How far: mm, of a rotary axis degrees.
    pub by: f64,
    /// The number of the motion, counted from 1.
    pub motion: u64,
}

/// A block of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Its line, counted from 1.
    pub line: usize,
    /// The block as it is written.
    pub text: String,
}

/// A program of each side.
#[derive(Clone, Debug)]
pub struct ProgramPair {
    /// Its key, as `blade`.
    pub key: &'static str,
    /// What it does.
    pub title: Text,
    /// It is a lathe's: X is a diameter.
    pub turning: bool,
    /// How many motions each has; `None` where the side has no such program.
    pub motions: [Option<u64>; 2],
    /// The first motion that differs; `None` where all are the same, or one side has no such program.
    pub first: Option<Difference>,
    /// The first block of each whose words are others: another tool or offset, S, an M code, or the same motion written in another
    /// way. `None` where all words are the same; comments, block numbers and the program's name do not count.
    pub words: Option<[Option<Block>; 2]>,
    /// The greatest distance of linear axes, and of rotary ones, over the motions that both have; none where there is none. X of a
    /// lathe is a diameter, here and below.
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
    pub const fn moves_alike(&self) -> bool {
        self.first.is_none() && matches!(self.motions, [Some(_), Some(_)])
    }

    /// True where all words are the same as well: the machine does the same.
    #[must_use]
    pub const fn equal(&self) -> bool {
        self.moves_alike() && self.words.is_none()
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
    let turning = named.control.turns();
    let (mut first, mut apart, mut words) = (None, Vec::new(), None);
    if let ([Some(one), Some(other)], [Some(of), Some(from)]) = (sides, outcomes) {
        let texts = [text(one), text(other)];
        let forms = [one, other].map(|program| program.control.lexis.comments);
        let settings = [setting(of, one), setting(from, other)];
        let [read, against] = texts.each_ref();
        let [setting, another] = settings;
        let readers =
            [(read, setting), (against, another)].map(|(text, setting)| Interpreter::over(text.as_bytes(), setting));
        let texts = Texts::new(texts.each_ref().map(String::as_str), forms);
        (first, apart) = compared(readers, &texts, turning);
        words = texts.first_other();
    }
    let as_written = |pose: Pose| if turning { diameter(pose) } else { pose };
    Some(ProgramPair {
        key: named.key,
        title: named.title.clone(),
        turning,
        motions: sides.map(|side| side.map(|side| side.account.motions)),
        first,
        words,
        apart,
        end: sides.map(|side| side.map(|side| as_written(side.account.end[0]))),
        extents: sides.map(|side| {
            side.and_then(|side| side.account.program)
                .map(|Extents { least, greatest }| Extents { least: as_written(least), greatest: as_written(greatest) })
        }),
        seconds: sides.map(|side| side.and_then(seconds)),
    })
}

/// X as a lathe's program has it.
fn diameter(mut pose: Pose) -> Pose {
    pose.set(Axis::X, 2.0 * pose.get(Axis::X));
    pose
}

fn seconds(program: &Proved) -> Option<f64> {
    let feed = (!program.account.untimed).then_some(program.account.seconds);
    program.duration.filter(|duration| duration.timeless == 0).map(|duration| duration.seconds).or(feed)
}

/// The text of a program, which can be read at any place: turning cycles look for their contours behind them.
fn text(program: &Program) -> String {
    let (mut text, mut lines) = (String::new(), program.lines());
    let mut line = String::new();
    while lines.next_whole(&mut line) {
        text.push_str(&line);
    }
    text
}

/// The setting in which its kind reads the program.
fn setting(outcome: &Outcome, program: &Program) -> Setting {
    outcome.kind.setting(&outcome.fields, program).unwrap_or_else(|| program.setting())
}

/// The texts of both sides.
struct Texts<'a> {
    lines: [Vec<&'a str>; 2],
    forms: [Comments; 2],
}

impl<'a> Texts<'a> {
    fn new(texts: [&'a str; 2], forms: [Comments; 2]) -> Self {
        Self { lines: texts.map(|text| text.lines().collect()), forms }
    }

    /// The words of a line, counted from 1, of a side.
    fn words(&self, side: usize, line: usize) -> String {
        let line = line.checked_sub(1).and_then(|at| self.lines[side].get(at));
        line.map_or_else(String::new, |line| bare(line, self.forms[side]))
    }

    /// The first blocks whose words are not the same; lines without words are passed over.
    fn first_other(&self) -> Option<[Option<Block>; 2]> {
        let mut blocks = [0, 1].map(|side: usize| {
            let words = (1..=self.lines[side].len()).map(move |line| (line, self.words(side, line)));
            words.filter(|(_, words)| !words.is_empty())
        });
        loop {
            let pair = blocks.each_mut().map(Iterator::next);
            if pair.iter().all(Option::is_none) {
                return None;
            }
            let [one, other] = pair.each_ref().map(|block| block.as_ref().map(|(_, words)| words));
            if one != other {
                let block = |side: usize| {
                    pair[side].as_ref().map(|&(line, _)| {
                        let text = self.lines[side].get(line - 1).map_or("", |text| text.trim());
                        Block { line, text: text.to_owned() }
                    })
                };
                return Some([block(0), block(1)]);
            }
        }
    }
}

/// The first motion that differs, and the greatest distances. A block that cannot be read counts as a motion at its line, which is the
/// same where neither can be read and the words of both are the same.
fn compared(
    [mut one, mut other]: [Interpreter<'_>; 2],
    texts: &Texts<'_>,
    turning: bool,
) -> (Option<Difference>, Vec<Apart>) {
    let (mut first, mut greatest): (Option<Difference>, [Option<Apart>; 2]) = (None, [None; 2]);
    for motion in 1.. {
        let pair = [one.next(), other.next()];
        if let [None, None] = pair {
            break;
        }
        let same = match &pair {
            [Some(Ok(one)), Some(Ok(other))] => is(one, other),
            [Some(Err(one)), Some(Err(other))] => texts.words(0, one.line) == texts.words(1, other.line),
            _ => false,
        };
        if !same && first.is_none() {
            let line = |one: &Option<Result<Motion, Box<Refused>>>| {
                one.as_ref().map(|read| read.as_ref().map_or_else(|refused| refused.line, |motion| motion.line))
            };
            first = Some(Difference { motion, lines: pair.each_ref().map(line) });
        }
        if let [Some(Ok(one)), Some(Ok(other))] = &pair {
            for axis in Axis::ALL {
                let diameters = if turning && axis == Axis::X { 2.0 } else { 1.0 };
                let by = (one.to.get(axis) - other.to.get(axis)).abs() * diameters;
                let worst = &mut greatest[usize::from(axis.rotary())];
                if by > worst.map_or(SAME, |worst| worst.by) {
                    *worst = Some(Apart { axis, by, motion });
                }
            }
        } else if pair.iter().any(Option::is_none) {
            // One has ended: there is nothing more to be told.
            break;
        }
    }
    (first, greatest.into_iter().flatten().collect())
}

/// True of the same motion: its sort, feed, arc, and where it ends; not of its line and number.
fn is(one: &Motion, other: &Motion) -> bool {
    let fed = |one: Feed, other: Feed| one.mode == other.mode && same(one.value, other.value);
    let kind = match (one.kind, other.kind) {
        (MotionKind::Rapid, MotionKind::Rapid) => true,
        (MotionKind::Feed(one), MotionKind::Feed(other)) => fed(one, other),
        (MotionKind::Arc(one, feed), MotionKind::Arc(other, another)) => {
            let turns = one.plane == other.plane && one.turns == other.turns;
            let centre = same(one.centre[0], other.centre[0]) && same(one.centre[1], other.centre[1]);
            turns && centre && same(one.rotation, other.rotation) && fed(feed, another)
        }
        (MotionKind::Thread(one), MotionKind::Thread(other)) => {
            same(one.lead, other.lead) && same(one.change, other.change) && same(one.angle, other.angle)
        }
        (MotionKind::Dwell(one), MotionKind::Dwell(other)) => same(one, other),
        _ => false,
    };
    let near = |one: &Pose, other: &Pose| Axis::ALL.into_iter().all(|axis| same(one.get(axis), other.get(axis)));
    kind && near(&one.to, &other.to) && near(&one.machine, &other.machine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::interpreter::Setting;

    fn difference(one: &str, other: &str) -> (Option<Difference>, Vec<Apart>) {
        let texts = Texts::new([one, other], [LINUXCNC.lexis.comments; 2]);
        compared([one, other].map(|text| Interpreter::over(text.as_bytes(), Setting::new(&LINUXCNC))), &texts, false)
    }

    #[test]
    fn comments_numbers_and_the_way_to_write_a_motion_make_no_other_program() {
        let one = "G21 G90 G54\nG0 X0 Y0\nG1 X0.3 F100\nG2 X2.3 I1 J0\nG4 P1\nM2\n";
        let other = "(a)\nG21 G90 G54\nN10 G0 X0 Y0\nG91 G1 X0.1 F100\nM2\n";
        assert_eq!(difference(one, &one.replace("G0 ", "(b)\nN5 G0 ")), (None, Vec::new()));
        let (first, _) = difference(one, other);
        assert_eq!(first, Some(Difference { motion: 2, lines: [Some(3), Some(4)] }));
        // Three tenths in increments are not 0.3 to the last bit, and end there all the same.
        let steps = "G21 G91\nG1 X0.1 F100\nX0.1\nX0.1\nM2\n";
        let places = "G21 G90\nG1 X0.1 F100\nX0.2\nX0.3\nM2\n";
        assert_eq!(difference(steps, places).0, None);
    }

    #[test]
    fn a_thousandth_another_feed_a_rapid_and_an_end_are_found_with_their_lines() {
        let one = "G21 G90\nG0 X0\nG1 X10 F100\nG1 X20 B5\nM2\n";
        for (from, to, motion, lines) in [
            ("X10", "X10.001", 2, [Some(3), Some(3)]),
            ("F100", "F101", 2, [Some(3), Some(3)]),
            ("G1 X20", "G0 X20", 3, [Some(4), Some(4)]),
            ("G1 X20 B5\n", "", 3, [Some(4), None]),
        ] {
            let (first, apart) = difference(one, &one.replace(from, to));
            assert_eq!(first, Some(Difference { motion, lines }), "{to}");
            assert_eq!(apart.iter().any(|apart| apart.by > 0.0009), to == "X10.001", "{to}");
        }
        let (_, apart) = difference(one, &one.replace("B5", "B7").replace("X20", "X21"));
        assert_eq!(apart.iter().map(|one| (one.axis, one.by)).collect::<Vec<_>>(), [(Axis::X, 1.0), (Axis::B, 2.0)]);
    }
}
