//! Tools: selection, change, length offsets.

use crate::gcode::code::{G, Group, M};
use crate::gcode::control::{ToolCall, ToolChange};
use crate::gcode::in_force::Spindle;
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::setting::ToolOffset;
use crate::gcode::interpreter::{Reader, doubt};
use crate::gcode::turning::rules::{
    AddedLength, ChangeWithoutTool, LengthWithoutAxes, NoOrientation, NoToolNumber, NoToolTable,
    OffsetMeasuredAtMachine, SetToolWithoutQ, ToolNotInTable, ToolOffsetWithoutValues, ToolTableNotKnown,
};
use crate::machine::axis::{Axis, Pose};
use crate::machine::work_offset::{ActiveOffsets, G92_FIRST, G92_SWITCH};
use crate::number::trig::sin_cos;

impl Reader<'_, '_> {
    /// T: the tool that the next change brings, or the turret's place.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn take_tool(&mut self) -> Result<()> {
        match self.memory.control.tool {
            ToolCall::Change => {}
            ToolCall::Words => return self.turn_by_words(),
            ToolCall::Digits => return self.turn_by_digits(),
        }
        if let Some(T) = self.block.get(letter::T) {
            self.state.modal.selected = Some(self.tool_number(letter::T, T)?);
        }
        self.take_offset()
    }

    /// The number of a tool that the table holds, if it is known; 0 is none.
    pub(super) fn tool_number(&mut self, letter: usize, value: f64) -> Result<u32> {
        let number = self.number_of(letter, value)?;
        if !self.has_place(number) {
            return Err(Refused::of(&ToolNotInTable { tool: number }, &[self.block.column(letter)]));
        }
        Ok(number)
    }

    /// The number of a tool or of an offset.
    pub(super) fn number_of(&self, letter: usize, value: f64) -> Result<u32> {
        let number = whole(value).and_then(|number| u32::try_from(number).ok());
        number.ok_or_else(|| Refused::of(&NoToolNumber { value }, &[self.block.column(letter)]))
    }

    /// M6 brings the tool that T selected into the spindle, M61 says by Q which is there. M61 is refused without Q, M6
    /// on some controls without a T before it.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn change_tool(&mut self, code: M) -> Result<()> {
        let column = self.block.m_column(6);
        if code == M::SetTool {
            let Some(Q) = self.block.get(letter::Q) else {
                return Err(Refused::of(&SetToolWithoutQ {}, &[column]));
            };
            self.state.modal.tool = self.tool_number(letter::Q, Q)?;
            return Ok(());
        }
        let selected = self.state.modal.selected;
        let before = self.state.modal.tool;
        self.state.modal.tool = selected.unwrap_or(before);
        // A length of the program's own was for the tool that was in the spindle.
        let waits = self.length_waits();
        if waits {
            self.bring_offset();
        }
        if !waits && self.state.modal.lengthened && before != 0 && before != self.state.modal.tool {
            self.state.modal.length_of.get_or_insert(before);
        }
        match self.memory.control.change {
            ToolChange::Routine => {}
            ToolChange::Selected if selected.is_none() => {
                return Err(Refused::of(&ChangeWithoutTool {}, &[column]).hanging_on(doubt::TOOL));
            }
            ToolChange::Selected => self.state.modal.spindle = Spindle::Stopped,
        }
        Ok(())
    }

    /// A tool's offset; 0 where there is no table, with a Caution, or a Note where the program's header names the tool.
    pub(super) fn offset_of(&mut self, number: u32) -> Pose {
        if self.memory.setting.tools.is_none() && number != 0 {
            if self.memory.setting.headed.contains(&number) {
                self.memory.remarks.row(&OffsetMeasuredAtMachine {}, self.block.spot, None);
            } else {
                self.memory.remarks.row(&NoToolTable {}, self.block.spot, None);
            }
        }
        self.memory.tools.get(&number).map_or_else(Pose::default, |tool| tool.offset)
    }

    /// Length offset: of the table (G43), of the block (G43.1), one more on top (G43.2), or none (G49).
    pub(super) fn tool_length(&mut self, code: G) -> Result<()> {
        if self.length_waits() {
            self.await_length(code);
            return Ok(());
        }
        let column = self.block.g_column(Group::ToolLength);
        let H = self.block.get(letter::H);
        let axes = AXES.into_iter().any(|axis| self.block.has(axis));
        let mut length_of = if code == G::ToolLengthAdded { self.state.modal.length_of } else { None };
        let tool = match (code, H) {
            (G::ToolLengthOff, _) => Pose::default(),
            (G::ToolLength, H) => {
                let number = match H {
                    Some(H) => self.tool_number(letter::H, H)?,
                    None => 0,
                };
                // H0 and no H both mean the tool in the spindle.
                let number = if number == 0 { self.state.modal.tool } else { number };
                length_of = Some(number);
                self.offset_of(number)
            }
            (G::ToolLengthGiven, _) if !axes => {
                return Err(Refused::of(&LengthWithoutAxes {}, &[column]));
            }
            (G::ToolLengthGiven, _) => {
                let mut tool = self.state.frame.tool;
                self.each_axis_word(|axis, value| tool.set(axis, value));
                tool
            }
            (_, Some(H)) if !axes => {
                let number = self.tool_number(letter::H, H)?;
                let number = if number == 0 { self.state.modal.tool } else { number };
                let added = self.offset_of(number);
                Pose(std::array::from_fn(|axis| self.state.frame.tool.0[axis] + added.0[axis]))
            }
            _ => {
                return Err(Refused::of(&AddedLength {}, &[column]));
            }
        };
        let machine = self.state.frame.to_machine(&self.state.at);
        self.state.frame = ActiveOffsets { tool, ..self.state.frame };
        self.state.modal.lengthened = code != G::ToolLengthOff;
        self.state.modal.length_of = length_of;
        self.state.at = self.state.frame.to_program(&machine);
        Ok(())
    }

    fn each_axis_word(&self, mut visit: impl FnMut(Axis, f64)) {
        let unit = self.state.modal.unit;
        for axis in Axis::ALL {
            if let Some(word) = self.block.get(AXES[axis as usize]) {
                visit(axis, if axis.rotary() { word } else { unit.to_mm(word) });
            }
        }
    }

    /// G10 L1 (the tool gets these offsets), L10 and L11 (so that this position reads the axis words in the system in force,
    /// or in G59.3 without G92).
    pub(super) fn set_tool_offset(&mut self, number: u32, system: Option<u8>) -> Result<()> {
        let column = self.block.g_column(Group::NonModal);
        if self.memory.setting.tools.is_none() {
            return Err(Refused::of(&ToolTableNotKnown {}, &[column]));
        }
        let Some(&old) = self.memory.tools.get(&number) else {
            return Err(Refused::of(&ToolNotInTable { tool: number }, &[column]));
        };
        let words = [letter::R, letter::Q, letter::I, letter::J];
        if !AXES.into_iter().chain(words).any(|letter| self.block.has(letter)) {
            return Err(Refused::of(&ToolOffsetWithoutValues {}, &[column]));
        }
        if let Some(Q) = self.block.get(letter::Q)
            && whole(Q).is_none_or(|orientation| !(0..=9).contains(&orientation))
        {
            return Err(Refused::of(&NoOrientation { value: Q }, &[self.block.column(letter::Q)]));
        }
        let mut tool: ToolOffset = old;
        match system {
            None => self.each_axis_word(|axis, value| tool.offset.set(axis, value)),
            Some(system) => self.offsets_from_here(&mut tool, system),
        }
        if let Some(R) = self.block.get(letter::R) {
            tool.diameter = 2.0 * self.state.modal.unit.to_mm(R);
        }
        self.memory.tools.insert(number, tool);
        Ok(())
    }

    fn offsets_from_here(&self, tool: &mut ToolOffset, system: u8) {
        let (mut here, rotation) = self.without_tool(system);
        if system == 9 && self.memory.parameters.get(G92_SWITCH as usize) != 0.0 {
            let g92 = self.pose_of(G92_FIRST);
            for axis in Axis::ALL {
                here.set(axis, here.get(axis) + g92.get(axis));
            }
        }
        let (sin, cos) = sin_cos(rotation.to_radians());
        // The offset in the axes of the system: the words replace their part of it.
        let (x, y) = (tool.offset.get(Axis::X), tool.offset.get(Axis::Y));
        let mut across = [x * cos + y * sin, y * cos - x * sin];
        let mut turned = false;
        self.each_axis_word(|axis, value| {
            let offset = here.get(axis) - value;
            match axis {
                Axis::X => (across[0], turned) = (offset, true),
                Axis::Y => (across[1], turned) = (offset, true),
                axis => tool.offset.set(axis, offset),
            }
        });
        if turned {
            tool.offset.set(Axis::X, across[0] * cos - across[1] * sin);
            tool.offset.set(Axis::Y, across[0] * sin + across[1] * cos);
        }
    }
}
