//! M62 to M68: digital and analog inputs and outputs. None moves the machine.
//!
//! # References
//! LinuxCNC, M-code reference, M62 to M68. What an input reads is not in the program: it is refused where a block uses it.

use crate::gcode::code::M;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::rules::expressions::{
    AnalogOutputIncomplete, InputAnalogWait, InputNeither, InputRead, InputWaitUnknown, InputWaited, InputWithoutTime,
    OutputWithoutNumber,
};

/// The parameter that M66 leaves its input in.
pub(super) const INPUT: usize = 5399;

impl Reader<'_, '_> {
    /// M62 to M68.
    pub(super) fn inputs_and_outputs(&mut self) -> Result<()> {
        match self.block.m(5) {
            Some((M::Output, _)) if !self.is_channel(letter::P) => {
                Err(Refused::of(&OutputWithoutNumber {}, &[self.block.m_column(5)]))
            }
            Some((M::AnalogOutput, _)) if !self.is_channel(letter::E) || !self.block.has(letter::Q) => {
                Err(Refused::of(&AnalogOutputIncomplete {}, &[self.block.m_column(5)]))
            }
            Some((M::Input, _)) => self.input(),
            _ => Ok(()),
        }
    }

    fn is_channel(&self, letter: usize) -> bool {
        self.block.get(letter).and_then(whole).is_some_and(|channel| channel >= 0)
    }

    /// M66: `P` a digital input, `E` an analog one; `L` 0 to 4 what is waited for, `Q` for how many seconds at most.
    fn input(&mut self) -> Result<()> {
        let (digital, analog) = (self.block.has(letter::P), self.block.has(letter::E));
        if digital == analog || !(self.is_channel(letter::P) || self.is_channel(letter::E)) {
            return Err(Refused::of(&InputNeither {}, &[self.block.m_column(5)]));
        }
        let wait = self.block.get(letter::L).map_or(Some(0), whole);
        if !wait.is_some_and(|wait| (0..=4).contains(&wait)) {
            return Err(Refused::of(&InputWaitUnknown {}, &[self.block.m_column(5)]));
        }
        if analog && wait != Some(0) {
            return Err(Refused::of(&InputAnalogWait {}, &[self.block.m_column(5)]));
        }
        if wait != Some(0) && self.block.get(letter::Q).is_none_or(|seconds| seconds <= 0.0) {
            return Err(Refused::of(&InputWithoutTime {}, &[self.block.m_column(5)]));
        }
        self.memory.parameters.forget(INPUT);
        self.memory.seen.input_read = true;
        let column = Some(self.block.m_column(5));
        if wait == Some(0) {
            self.memory.remarks.row(&InputRead {}, self.block.spot, column);
        } else {
            self.memory.remarks.row(&InputWaited {}, self.block.spot, column);
        }
        Ok(())
    }

    /// True where a parameter holds what M66 has read.
    pub(super) fn is_input(&self, number: usize) -> bool {
        number == INPUT && self.memory.seen.input_read && !self.memory.parameters.known(INPUT)
    }
}
