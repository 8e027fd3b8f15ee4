//! Rotary axes that count from 0 to 359.9999, and motions at feed that turn one by more than half a turn.
//!
//! # References
//! Fagor CNC 8055/8055i M & EN programming manual (Ref. 1711), p. 52, and installation manual, p. 294: a rollover axis, as
//! delivered: in G90 the sign is the direction and the number the target, 0 to 359.9999; in G91 the sign is the direction and
//! the number how far, more than a turn where it is more than 360. Error manual, 0168 and 0199: the ranges. LinuxCNC,
//! `WRAPPED_ROTARY` and `unwrap_rotary` in `interp_find.cc`: the same, and no motion where the angle is reached already.

use crate::finding::Raise;
use crate::gcode::code::{G, Group};
use crate::gcode::control::Rollover;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::letters::Letters;
use crate::gcode::motion::MotionKind;
use crate::gcode::rules::geometry::{
    RolloverBeyondTurn, RolloverMinusZero, RolloverPreset, RolloverReached, WrappedInMachine,
};
use crate::machine::axis::{Axis, Pose};

/// The words of rotary axes.
const WORDS: u32 = Letters::of("ABC").mask();
/// The rotary axes with their letters.
const ROTARY: [(Axis, usize); 3] = [(Axis::A, letter::A), (Axis::B, letter::B), (Axis::C, letter::C)];
/// Two angles nearer than this are one: half of what the control shows, degrees.
const SAME: f64 = 0.000_05;
/// What the sum of increments may lose, degrees.
const ROUNDING: f64 = 1e-6;

impl Reader<'_, '_> {
    /// Refuses absolute words of rollover axes that the control refuses, before the block is executed.
    pub(super) fn rotary_words(&mut self) -> Result<()> {
        if self.block.present & WORDS == 0 {
            return Ok(());
        }
        let taken = self.on_rollover();
        self.memory.seen.rotary_differs |= taken.is_err();
        if self.memory.setting.rotary.rolls_over() { taken } else { Ok(()) }
    }

    fn on_rollover(&self) -> Result<()> {
        let incremental = match self.block.g(Group::Distance) {
            Some(code) => code == G::Incremental,
            None => self.state.modal.incremental,
        };
        let preset = match self.block.g(Group::NonModal) {
            None | Some(G::MachineCoordinates | G::Reference(_)) if incremental => return Ok(()),
            None | Some(G::MachineCoordinates | G::Reference(_)) => false,
            Some(G::LocalOffset | G::SetPosition | G::SetPositionOrSpeed) => true,
            Some(_) => return Ok(()),
        };
        for (axis, index) in ROTARY {
            let Some(word) = self.block.get(index) else { continue };
            let name = axis.letter();
            let column = self.block.column(index);
            let alarm = match self.memory.control.rotary.rollover {
                Rollover::Numbered if preset && !(0.0..360.0).contains(&word) => {
                    return Err(Refused::of(&RolloverPreset { axis: name, angle: word }, &[column]));
                }
                Rollover::Wrapped if self.block.g(Group::NonModal) == Some(G::MachineCoordinates) => {
                    return Err(Refused::of(&WrappedInMachine { axis: name }, &[column]));
                }
                Rollover::Numbered => "0168: ",
                Rollover::Wrapped => "",
            };
            if word.abs() >= 360.0 {
                return Err(Refused::of(&RolloverBeyondTurn { alarm, axis: name, angle: word }, &[column]));
            }
        }
        Ok(())
    }

    /// Where an absolute word leads a rotary axis that stands at an angle, counted on beyond a turn; degrees.
    pub(super) fn turned_to(&mut self, axis: Axis, word: f64, at: f64) -> f64 {
        let (rolled, reached) = rolled(word, at);
        self.memory.seen.rotary_differs |= rolled != word;
        if !self.memory.setting.rotary.rolls_over() {
            return word;
        }
        let index = AXES.get(axis as usize).copied().unwrap_or_default();
        let name = axis.letter();
        if reached {
            self.unclear(index, &RolloverReached { axis: name });
        } else if word == 0.0 && word.is_sign_negative() {
            self.unclear(index, &RolloverMinusZero { axis: name });
        }
        rolled
    }

    /// Cautions that the control's manuals do not say what a word of a rollover axis does; LinuxCNC's program does.
    fn unclear(&mut self, letter: usize, row: &dyn Raise) {
        match self.memory.control.rotary.rollover {
            Rollover::Numbered => self.memory.remarks.row(row, self.block.spot, Some(self.block.column(letter))),
            Rollover::Wrapped => {}
        }
    }

    /// Points out a motion at feed that turns a rotary axis by more than half a turn.
    pub(super) fn see_turn(&mut self, kind: MotionKind, to: &Pose) {
        if !matches!(kind, MotionKind::Feed(_) | MotionKind::Arc(..)) {
            return;
        }
        for (axis, _) in ROTARY {
            let by = to.get(axis) - self.state.at.get(axis);
            if by.abs() > 180.0 + ROUNDING {
                self.memory.remarks.turned(self.block.spot, axis.letter(), by);
            }
        }
    }
}

/// Where a word leads a rollover axis that stands at an angle, counted on beyond a turn, degrees; true where it is there.
fn rolled(word: f64, at: f64) -> (f64, bool) {
    let (target, minus) = (word.abs(), word.is_sign_negative());
    let turn = ((at + ROUNDING) / 360.0).floor() * 360.0;
    let shown = at - turn;
    let way = target - shown;
    // An angle a hair below a whole turn is reached at the turn's beginning.
    let reached = [0.0, -360.0].into_iter().find(|whole| (way + whole).abs() < SAME);
    let whole = reached.unwrap_or(match (minus, way < 0.0) {
        (false, true) => 360.0,
        (true, false) => -360.0,
        _ => 0.0,
    });
    (turn + target + whole, reached.is_some())
}
