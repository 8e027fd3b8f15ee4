//! What lathes do in their own way: coordinate systems, reference points, times by revolutions.
//!
//! # References
//! The lathe simulator's description of G50, G53 to G59 and G96; Fanuc Series 0i-T operator's manual, G-code system A, for G28,
//! G30 and G50 with U and W.
//!
//! # Where the two differ
//! `G54 X30.5 Z15` without G0 or G1 beside it shifts the system, as the simulator has it, and gets a Caution: on a Fanuc it is a
//! motion. With G0 or G1 in the block it is a motion for both.

use crate::finding::Grade;
use crate::gcode::code::{G, Group};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::letters::Letters;
use crate::gcode::motion::{Arc, Feed, FeedMode, MotionKind, Thread};
use crate::gcode::turning::pace::Pace;
use crate::gcode::turning::rules::{
    AxisNotFollowed, AxisNotOfLathe, BeyondAxis, G91InSystemA, IncrementNotFollowed, IncrementNotOfLathe,
    MachineMoveByIncrements, ReferencePointNotKnown, ReferencePointNotSupported, ReferenceWithoutAxes,
    SecondPointNotKnown, StaleFeed, SystemShifted, TwoWordsAnAxis,
};
use crate::machine::axis::{Axis, Pose};
use crate::machine::length_unit::LengthUnit;
use crate::machine::work_offset::{ACTIVE, ActiveOffsets, G28_FIRST, G30_FIRST, WorkOffset};

/// The axes of a lathe with the letters of their absolute and their incremental words.
const WORDS: [(Axis, usize, usize); 2] = [(Axis::X, letter::X, letter::U), (Axis::Z, letter::Z, letter::W)];

/// How far beyond the axis facing may end, mm on the diameter.
const FACING: f64 = 6.0;

impl Reader<'_, '_> {
    /// Refuses X with U and Z with W, and increments in machine coordinates.
    pub(super) fn one_word_an_axis(&self) -> Result<()> {
        let at_once = self.block.g(Group::NonModal);
        if at_once == Some(G::Dwell) {
            return Ok(());
        }
        for (axis, absolute, incremental) in WORDS {
            let column = self.block.column(incremental);
            if self.block.has(absolute) && self.block.has(incremental) {
                let (name, step) = (axis.letter(), if axis == Axis::X { 'U' } else { 'W' });
                return Err(Refused::of(&TwoWordsAnAxis { axis: name, step }, &[self.block.column(absolute), column]));
            }
            if at_once == Some(G::MachineCoordinates) && self.block.has(incremental) {
                return Err(Refused::of(&MachineMoveByIncrements {}, &[column]));
            }
        }
        Ok(())
    }

    /// Axis words other than X and Z and the increments of them: refused where the machine's axes are known, else told.
    pub(super) fn axes_of_lathe(&mut self) -> Result<()> {
        let control = self.memory.control;
        // Letters of a turning cycle are its parameters.
        if !control.turns() || self.has_turning_cycle() {
            return Ok(());
        }
        for (letter, axis) in AXES.into_iter().zip(Axis::ALL) {
            if !self.block.has(letter) || matches!(axis, Axis::X | Axis::Z) || control.axes.increment(axis).is_some() {
                continue;
            }
            let (name, column) = (axis.letter(), self.block.column(letter));
            // The axis that U and W would move by an increment, had the control such words.
            let along = match axis {
                Axis::U => Some('X'),
                Axis::W => Some('Z'),
                Axis::X | Axis::Y | Axis::Z | Axis::A | Axis::B | Axis::C | Axis::V => None,
            };
            let spot = self.block.spot;
            match (self.memory.setting.axes, along) {
                (Some(axes), _) if axes.has(name as u8 - b'A') => {}
                (Some(_), None) => return Err(Refused::of(&AxisNotOfLathe { axis: name }, &[column])),
                (Some(_), Some(along)) => {
                    return Err(Refused::of(&IncrementNotOfLathe { axis: name, along }, &[column]));
                }
                (None, None) => self.memory.remarks.row(&AxisNotFollowed { axis: name }, spot, Some(column)),
                (None, Some(along)) => {
                    self.memory.remarks.row(&IncrementNotFollowed { axis: name, along }, spot, Some(column));
                }
            }
        }
        Ok(())
    }

    /// G91, which system A does not have: told where it stands without axes, else refused.
    pub(super) fn no_increments(&mut self) -> Result<()> {
        if self.block.g(Group::Distance) != Some(G::Incremental) {
            return Ok(());
        }
        let column = self.block.g_column(Group::Distance);
        if self.has_axes() {
            return Err(self.unknown('G', 91.0, column));
        }
        self.memory.remarks.row(&G91InSystemA {}, self.block.spot, Some(column));
        Ok(())
    }

    /// G20 and G21, G70 and G71.
    pub(super) fn take_unit(&mut self) {
        match self.block.g(Group::Units) {
            Some(G::Inch) => self.set_unit(LengthUnit::Inch),
            Some(G::Millimetre) => self.set_unit(LengthUnit::Millimetre),
            _ => {}
        }
    }

    /// What is kept in mind when a motion begins: the passes of a turning cycle end with another motion code, and a drilling cycle has
    /// the motion code before it under it, which comes back behind G80 where the control says so.
    pub(super) fn begin_motion(&mut self, motion: G) {
        if !matches!(motion, G::Pass(_) | G::Cancel) {
            self.state.modal.pass = None;
        }
        if matches!(motion, G::Cycle(_)) && !matches!(self.state.modal.motion, G::Cycle(_)) {
            self.state.modal.under = self.state.modal.motion;
        }
    }

    /// True where the block shifts a coordinate system: G54 to G59 with X or Z and no motion code.
    pub(super) fn shifts_system(&self) -> bool {
        self.memory.control.offsets.shifts()
            && self.block.g(Group::WorkOffset).is_some()
            && self.block.g(Group::Motion).is_none()
            && self.block.g(Group::NonModal).is_none()
            && self.block.present & Letters::of("XZUW").mask() != 0
    }

    /// G54 to G59 with X and Z: the origin lies that far from the zero of the first system.
    pub(super) fn shift_system(&mut self, system: u8) {
        let mut origin = self.system(1).origin;
        for axis in [Axis::X, Axis::Z] {
            origin.set(axis, origin.get(axis) + self.axis_word(axis).unwrap_or(0.0));
        }
        let spot = self.block.spot;
        self.memory.remarks.row(&SystemShifted {}, spot, Some(self.block.g_column(Group::WorkOffset)));
        self.state.modal.system = system;
        self.state.modal.shifted = true;
        self.memory.parameters.set(ACTIVE as usize, f64::from(system));
        self.reframe(ActiveOffsets { work: WorkOffset { origin, rotation: 0.0 }, ..self.state.frame });
    }

    /// G50 with axis words: this position gets the coordinates X and Z, or its own and U and W more.
    pub(super) fn set_lathe_position(&mut self) {
        let to = self.end_point();
        self.memory.seen.position_set |= [letter::X, letter::Z].into_iter().any(|word| self.block.has(word));
        let mut g92 = self.state.frame.g92;
        for axis in [Axis::X, Axis::Z] {
            g92.set(axis, self.state.at.get(axis) + g92.get(axis) - to.get(axis));
        }
        self.state.at = to;
        self.state.frame.g92 = g92;
        self.keep_g92(true, Some(g92));
    }

    /// G28 and G30: over the point of the words to the reference point, in the axes named.
    pub(super) fn return_to_reference(&mut self, second: bool) -> Result<()> {
        let column = self.block.g_column(Group::NonModal);
        let number = if second { 30 } else { 28 };
        let named: Vec<Axis> = WORDS
            .into_iter()
            .filter(|&(_, absolute, incremental)| self.block.has(absolute) || self.block.has(incremental))
            .map(|(axis, ..)| axis)
            .collect();
        if let Some(P) = self.block.get(letter::P).filter(|&P| second && P != 2.0) {
            return Err(Refused::of(&ReferencePointNotSupported { value: P }, &[self.block.column(letter::P)]));
        }
        if named.is_empty() {
            return Err(Refused::of(&ReferenceWithoutAxes { code: number }, &[column]));
        }
        self.memory.seen.referred |= !second;
        let first = if second { G30_FIRST } else { G28_FIRST };
        if !self.memory.setting.var_file.iter().any(|(parameter, _)| (first..first + 3).contains(&parameter)) {
            let spot = self.block.spot;
            if second {
                self.memory.remarks.row(&SecondPointNotKnown { first, last: first + 2 }, spot, Some(column));
            } else {
                self.memory.remarks.row(&ReferencePointNotKnown {}, spot, Some(column));
            }
        }
        let over = self.end_point();
        if over != self.state.at {
            self.state.modal.to_intermediate = true;
            self.emit(MotionKind::Rapid, over, None);
            self.state.modal.to_intermediate = false;
        }
        let reference = self.state.frame.to_program(&self.pose_of(first));
        let mut to = self.state.at;
        for axis in named {
            self.place_at_reference(axis);
            to.set(axis, reference.get(axis));
        }
        self.emit(MotionKind::Rapid, to, None);
        Ok(())
    }

    /// The program has gone on with a feed from before F changed its meaning.
    pub(super) fn remark_stale_feed(&mut self) {
        let spot = self.block.spot;
        self.memory.remarks.row(&StaleFeed {}, spot, None);
    }

    /// X has been given below the axis. Facing ends a little beyond it, by the nose of the tool; farther is a slip of the
    /// sign.
    pub(super) fn remark_beyond_axis(&mut self, to: &Pose) {
        let Some(word) = [letter::X, letter::U].into_iter().find(|&word| self.block.has(word)) else { return };
        self.remark_word_beyond_axis(to.get(Axis::X), word);
    }

    /// The same of a word that gives X the radius, mm.
    pub(super) fn remark_word_beyond_axis(&mut self, radius: f64, word: usize) {
        let spot = self.block.spot;
        let facing = 2.0 * radius >= -FACING;
        let grade = if facing { Grade::Note } else { Grade::Caution };
        self.memory.remarks.row_as(grade, &BeyondAxis {}, spot, Some(self.block.column(word)));
    }

    /// True for a feed per revolution of a lathe, whose spindle's speed may change along the motion.
    pub(super) fn by_revolution(&self, feed: Feed) -> bool {
        self.memory.control.spindle.turns.part() && feed.mode == FeedMode::PerRevolution
    }

    pub(super) fn pace(&self) -> Option<Pace> {
        Pace::of(&self.state.modal.in_force(), self.memory.setting.greatest_speed)
    }

    /// The time of a straight motion at a feed per revolution.
    pub(super) fn turned_seconds(&self, to: &Pose, feed: Feed) -> Option<f64> {
        let by = to.differences(&self.state.at);
        let length = by.iter().map(|by| by * by).sum::<f64>().sqrt();
        self.pace()?.straight([self.state.at.get(Axis::X), to.get(Axis::X)], length, feed.value)
    }

    /// The time of an arc from here at a feed per revolution.
    pub(super) fn turned_arc_seconds(&self, arc: &Arc, feed: Feed) -> Option<f64> {
        self.pace()?.arc(arc, [self.state.at.get(Axis::X), self.state.at.get(Axis::Z)], feed.value)
    }

    /// The time of a thread.
    pub(super) fn thread_seconds(&self, to: &Pose, thread: &Thread) -> Option<f64> {
        let by = |axis: Axis| (to.get(axis) - self.state.at.get(axis)).abs();
        let distance = by(Axis::X).max(by(Axis::Z));
        self.pace()?.thread([self.state.at.get(Axis::X), to.get(Axis::X)], distance, thread)
    }
}
