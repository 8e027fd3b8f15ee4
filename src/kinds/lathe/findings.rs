//! What is said of a turning program: its alarms, and where following it ended.

use std::collections::BTreeMap;

use crate::finding::clause::{LimitIn, More, MoreBeyond, OnceMore, OnceMoreBeyond, OneFollows, SeveralFollow};
use crate::finding::rules::OtherContour;
use crate::finding::{Bare, Finding, Grade, Limit, Place, Raise, Size};
use crate::gcode::interpreter::Interpreter;
use crate::gcode::motion::{Motion, MotionKind};
use crate::kinds::lathe::Raised;
use crate::kinds::lathe::rules::{
    MachineZeroAssumed, MoreAlarms, NotJudgedFromHere, PositionAssumed, ProgramNotJudged, ReferenceAssumed,
    ThreadTooMuchWork, TooManyMotions, TooMuchWork,
};
use crate::kinds::lathe::setup::Given;
use crate::kinds::lathe::text::SheetProgram;
use crate::limits::{FOLLOWED_MOTIONS, PROGRAM_FINDINGS};
use crate::machine::axis::Axis;
use crate::removal::turning::alarm::{Alarm, Cause};
use crate::removal::turning::second_removal::AGREE;
use crate::removal::turning::spindle::revolutions;

/// What went wrong with the blocks of a program.
#[derive(Default)]
pub(super) struct Faults {
    /// As it is told of lines.
    pub(super) told: Vec<Finding>,
    /// How many refusals are not listed.
    pub(super) more: usize,
    /// Refusals in more than one cell, as they are told of lines and as they are told of cells.
    together: Vec<(Finding, Finding)>,
}

impl Faults {
    /// Takes a refusal, once: a cycle reads the blocks of its contour, and they are read again where they stand.
    pub(super) fn refused(&mut self, fault: Finding, in_cells: Option<Finding>) {
        if self.told.contains(&fault) {
            return;
        }
        if self.told.len() < PROGRAM_FINDINGS {
            self.together.extend(in_cells.map(|in_cells| (fault.clone(), in_cells)));
            self.told.push(fault);
        } else {
            self.more += 1;
        }
    }

    /// All of it, each at its cells where the program stands in cells.
    pub(super) fn placed(self, source: &SheetProgram) -> Vec<Finding> {
        let Self { told, together, .. } = self;
        told.into_iter()
            .map(|finding| match together.iter().find(|(told, _)| *told == finding) {
                Some((_, in_cells)) => in_cells.clone(),
                None => {
                    let place = source.placed(finding.place.clone());
                    finding.placed(place)
                }
            })
            .collect()
    }
}

/// A line of the program, or of the file of a subprogram.
pub(super) fn at_line(file: Option<&str>, line: usize) -> Place {
    match file {
        None => Place::Line { line, columns: Vec::new() },
        Some(file) => Place::Subprogram { file: file.to_owned(), line, columns: Vec::new() },
    }
}

/// The note on where the judging of motions stopped; the file as a whole where that was before the program.
pub(super) fn unjudged_from(place: Place) -> Finding {
    if place == Place::File { ProgramNotJudged {}.at(place) } else { NotJudgedFromHere {}.at(place) }
}

/// The stop of a program of more motions than a sheet has rows.
pub(super) fn too_many(file: Option<&str>, line: usize) -> Finding {
    TooManyMotions { most: FOLLOWED_MOTIONS }.at(at_line(file, line))
}

/// The stop of a program whose motions take more work than is done: what was made until there, and at which motion, with the
/// turns of the thread where it is one.
pub(super) fn too_much_work(file: Option<&str>, motion: &Motion, made: usize) -> Finding {
    let place = at_line(file, motion.line);
    let MotionKind::Thread(thread) = motion.kind else { return TooMuchWork { made }.at(place) };
    let lead = Size::length(thread.lead, 6);
    let length = [Axis::X, Axis::Z].map(|axis| (motion.to.get(axis) - motion.from.get(axis)).abs());
    let turns = revolutions(thread, length[0].max(length[1])).unwrap_or_default();
    ThreadTooMuchWork { made, lead, turns: Size::number(turns, 0) }.at(place)
}

/// What of the machine's places a program counts on, as far as it was run, with its subprograms.
#[derive(Clone, Copy, Debug)]
pub struct Reached {
    /// It moves in machine coordinates: G53.
    pub machine: bool,
    /// It goes to the reference point: G28. The second one, of G30, no workbook gives (G0835).
    pub reference: bool,
    /// It gives coordinates to where the turret stands: G50 X Z.
    pub set: bool,
}

impl Reached {
    /// What a program has counted on so far.
    #[must_use]
    pub const fn by(interpreter: &Interpreter<'_>) -> Self {
        Self {
            machine: interpreter.moves_in_machine(),
            reference: interpreter.returns_to_reference(),
            set: interpreter.sets_position(),
        }
    }
}

/// What is assumed of the machine where the form does not give the reference point.
pub fn assumed(given: &Given, reached: &Reached) -> Vec<Finding> {
    let mut found = Vec::new();
    if !given.referred && reached.machine {
        found.push(MachineZeroAssumed {}.at(Place::File));
    }
    let reference = || {
        let [X, Z] = given.reference();
        [2.0 * X, Z].map(|at| Bare::mm(at, 3))
    };
    if !given.referred && reached.set {
        let [X, Z] = reference();
        found.push(PositionAssumed { X, Z }.at(Place::File));
    } else if !given.referred && reached.reference {
        let [X, Z] = reference();
        found.push(ReferenceAssumed { X, Z }.at(Place::File));
    }
    found
}

/// The alarms as findings: of one number and one grade on one line the deepest, the gravest first, at most so many; of one end of an
/// axis' travel, which every later motion may leave too, the deepest of the whole program, before the others. Where a tool
/// works with another offset than its own, what hangs on where it is may follow from that: it is counted with that cause, which
/// is then as grave as the gravest of them.
pub(super) fn alarms(alarms: &[Raised], given: &Given) -> Vec<Finding> {
    // A number may be a stop or a caution: a shallow stop is not hidden by a deeper caution.
    let mut worst = BTreeMap::new();
    let travel = |alarm: &Alarm| matches!(alarm.cause, Cause::Travel { .. });
    let cause = |one: &Raised| one.other_offset.filter(|_| matches!(one.alarm.cause, Cause::OtherOffset { .. }));
    let mut following: BTreeMap<(u32, u32), Vec<Grade>> =
        alarms.iter().filter_map(cause).map(|pair| (pair, Vec::new())).collect();
    for raised in alarms {
        let Raised { alarm, place, other_offset } = raised;
        if alarm.cause.hangs_on_offset()
            && let Some(grades) = other_offset.as_ref().and_then(|pair| following.get_mut(pair))
        {
            grades.push(alarm.cause.grade());
            continue;
        }
        let line = if travel(alarm) { (0, 0) } else { (alarm.file, alarm.line) };
        let key = (line, alarm.cause.key(), alarm.cause.grade(), cause(raised));
        let known: &mut (usize, &Alarm, &Place) = worst.entry(key).or_insert((0, alarm, place));
        known.0 += 1;
        if alarm.depth > known.1.depth {
            (known.1, known.2) = (alarm, place);
        }
    }
    let mut found: Vec<((bool, bool), Finding)> = worst
        .into_iter()
        .map(|((.., pair), (count, alarm, place))| {
            let mut finding = alarm.finding().placed(place.clone());
            if let Cause::Travel { axis, greatest, .. } = alarm.cause
                && let Some(cell) = given.travel_cell(axis, greatest)
            {
                finding = finding.with_clause(&LimitIn { limit_cell: cell });
            }
            let left_out = pair.and_then(|pair| following.get(&pair)).map_or(&[][..], Vec::as_slice);
            if let Some(gravest) = left_out.iter().max() {
                finding.grade = finding.grade.max(*gravest);
                finding = match left_out.len() {
                    following @ 1 => finding.with_clause(&OneFollows { following }),
                    following => finding.with_clause(&SeveralFollow { following }),
                };
            }
            if count > 1 {
                finding = finding.found(count as u64);
                finding = match count - 1 {
                    more @ 1 if travel(alarm) => finding.with_clause(&OnceMoreBeyond { more }),
                    more if travel(alarm) => finding.with_clause(&MoreBeyond { more }),
                    more @ 1 => finding.with_clause(&OnceMore { more }),
                    more => finding.with_clause(&More { more }),
                };
            }
            ((travel(alarm), !left_out.is_empty()), finding)
        })
        .collect();
    found.sort_by_key(|(cause, finding)| std::cmp::Reverse((finding.grade, *cause)));
    let mut found: Vec<Finding> = found.into_iter().map(|(_, finding)| finding).collect();
    let more = found.len().saturating_sub(PROGRAM_FINDINGS);
    found.truncate(PROGRAM_FINDINGS);
    if more > 0 {
        found.push(MoreAlarms { count: more }.at(Place::File));
    }
    found
}

/// The stop of a removal that a library of polygons does not confirm.
pub(super) fn not_repeated(apart: f64) -> Finding {
    let told = OtherContour {}.at(Place::File).with(format!("{apart:.9} mm"), format!("≤ {AGREE:.6} mm"));
    told.measuring(apart, Limit::AtMost(AGREE))
}
