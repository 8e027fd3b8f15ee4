//! Coordinate systems: work offsets, G10, G52, G92, reference points.
//!
//! # References
//! LinuxCNC, "Coordinate systems" and G10, G28, G30, G52, G53, G92. Parameters: 5161 G28, 5181 G30, 5210 the switch of G92
//! and G52, 5211 their registers, 5220 the active system, 5221 + 20·(n − 1) system n with its rotation at + 9.

use crate::gcode::code::G;
use crate::gcode::control::Reference;
use crate::gcode::in_force::Spindle;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::MotionKind;
use crate::gcode::rules::geometry::{
    AxesOrSpeed, LengthOfRotaryAxis, OffsetsPNotWhole, OffsetsPTooGreat, OffsetsRotation, OffsetsWithTurning,
    OffsetsWithoutL, OffsetsWithoutP, PresetEnds, PresetLeft, RotationWithG92, SetPositionLeft, SetPositionLeftOfLathe,
    ToolTableLoaded, ToolTableWithTool,
};
use crate::gcode::rules::modes::{PositionOrSpeedMissing, SetPositionWithoutAxes};
use crate::machine::axis::{Axis, Pose};
use crate::machine::work_offset::{
    ACTIVE, ActiveOffsets, G28_FIRST, G30_FIRST, G92_FIRST, G92_SWITCH, System, WorkOffset,
};
use crate::text::t;

impl Reader<'_, '_> {
    /// A coordinate system as the parameters hold it.
    pub(super) fn system(&self, system: u8) -> WorkOffset {
        let system = System::from_number(system.into()).unwrap_or_default();
        WorkOffset {
            origin: self.pose_of(system.first_parameter()),
            rotation: self.memory.parameters.get(system.rotation_parameter() as usize),
        }
    }

    /// Puts another frame into force; the machine does not move.
    pub(super) fn reframe(&mut self, frame: ActiveOffsets) {
        let machine = self.state.frame.to_machine(&self.state.at);
        self.state.frame = frame;
        self.state.at = frame.to_program(&machine);
    }

    /// G54 to G59.3. A system that is in force already stays as it is.
    pub(super) fn select_system(&mut self, system: u8) {
        if system != self.state.modal.system || self.state.modal.shifted {
            self.state.modal.system = system;
            self.state.modal.shifted = false;
            self.memory.parameters.set(ACTIVE as usize, f64::from(system));
            self.reframe(ActiveOffsets { work: self.system(system), ..self.state.frame });
        }
    }

    /// The value of an axis word in mm or degrees.
    pub(super) fn axis_word(&self, axis: Axis) -> Option<f64> {
        let word = self.block.get(AXES[axis as usize])?;
        let value = if axis.rotary() { word } else { self.state.modal.unit.to_mm(word) };
        Some(self.memory.control.axes.coordinate(axis, value))
    }

    /// G10: work offsets and tool table.
    pub(super) fn set_offsets(&mut self) -> Result<()> {
        let column = self.block.g_column(crate::gcode::code::Group::NonModal);
        let L = self.block.get(letter::L).and_then(whole);
        if L == Some(0) {
            if self.state.modal.tool != 0 {
                return Err(Refused::of(&ToolTableWithTool { tool: self.state.modal.tool }, &[column]));
            }
            self.memory.remarks.row(&ToolTableLoaded {}, self.block.spot, Some(column));
            self.memory.tools = self.memory.setting.tools.clone().unwrap_or_default();
            return Ok(());
        }
        if !matches!(L, Some(1 | 2 | 10 | 11 | 20)) {
            return Err(Refused::of(&OffsetsWithoutL {}, &[column]));
        }
        let Some(P) = self.block.get(letter::P) else {
            return Err(Refused::of(&OffsetsWithoutP {}, &[column]));
        };
        let Some(number) = whole(P).and_then(|number| u32::try_from(number).ok()) else {
            return Err(Refused::of(&OffsetsPNotWhole { number: P }, &[column]));
        };
        match L {
            Some(2 | 20) => {
                let system = match number {
                    0 => self.state.modal.system,
                    1..=9 => u8::try_from(number).unwrap_or(1),
                    _ => {
                        return Err(Refused::of(&OffsetsPTooGreat { number }, &[column]));
                    }
                };
                if self.block.has(letter::I) || self.block.has(letter::J) || self.block.has(letter::Q) {
                    return Err(Refused::of(&OffsetsWithTurning {}, &[column]));
                }
                if L == Some(20) && self.block.has(letter::R) {
                    return Err(Refused::of(&OffsetsRotation {}, &[column]));
                }
                self.set_system(system, L == Some(20));
                Ok(())
            }
            Some(10) => self.set_tool_offset(number, Some(self.state.modal.system)),
            Some(11) => self.set_tool_offset(number, Some(9)),
            _ => self.set_tool_offset(number, None),
        }
    }

    /// G10 L2 (the origin gets the axis words) and L20 (this position gets the axis words).
    fn set_system(&mut self, number: u8, from_here: bool) {
        let mut work = self.system(number);
        if let Some(R) = self.block.get(letter::R) {
            work.rotation = R;
        }
        if from_here {
            // machine = Rz(p + g92) + origin + tool: the origin goes where p reads what is wanted.
            let machine = self.state.frame.to_machine(&self.state.at);
            let frame = ActiveOffsets { work, ..self.state.frame };
            let mut wanted = frame.to_program(&machine);
            for axis in Axis::ALL {
                if let Some(value) = self.axis_word(axis) {
                    wanted.set(axis, value);
                }
            }
            let there = frame.to_machine(&wanted);
            for axis in Axis::ALL {
                work.origin.set(axis, work.origin.get(axis) + machine.get(axis) - there.get(axis));
            }
        } else {
            for axis in Axis::ALL {
                if let Some(value) = self.axis_word(axis) {
                    work.origin.set(axis, value);
                }
            }
        }
        // The rotation may have been changed before, by its parameter.
        let turns = self.block.has(letter::R) || work.rotation != self.state.frame.work.rotation;
        let forgets = number == self.state.modal.system && turns && self.state.frame.g92 != Pose::default();
        if forgets {
            let g = self.block.g_column(crate::gcode::code::Group::NonModal);
            let column = if self.block.has(letter::R) { self.block.column(letter::R) } else { g };
            self.memory.remarks.row(&RotationWithG92 {}, self.block.spot, Some(column));
        }
        let system = System::from_number(number.into()).unwrap_or_default();
        self.keep_pose(system.first_parameter(), &work.origin);
        self.memory.parameters.set(system.rotation_parameter() as usize, work.rotation);
        if number == self.state.modal.system {
            self.reframe(ActiveOffsets { work, ..self.state.frame });
        }
    }

    /// The position in a coordinate system as it would read without tool offset.
    pub(super) fn without_tool(&self, system: u8) -> (Pose, f64) {
        let work = self.system(system);
        let machine = self.state.frame.to_machine(&self.state.at);
        let frame = ActiveOffsets { work, tool: Pose::default(), ..self.state.frame };
        (frame.to_program(&machine), work.rotation)
    }

    /// G28 and G30.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn reference_point(&mut self, second: bool) -> Result<()> {
        match self.memory.control.reference {
            Reference::Named => self.return_to_reference(second),
            Reference::NamedOrAll => self.go_to_reference(second),
            Reference::None => {
                let column = self.block.g_column(crate::gcode::code::Group::NonModal);
                Err(self.unknown('G', if second { 30.0 } else { 28.0 }, column))
            }
        }
    }

    /// G28 and G30: over the point of the axis words to the reference point, in the axes named or in all. Refused where the tool
    /// has an offset in A, B or C: LinuxCNC 2.9 ends off the point by it, and its reference promises the point itself.
    fn go_to_reference(&mut self, second: bool) -> Result<()> {
        let named: Vec<Axis> = Axis::ALL.into_iter().filter(|&axis| self.block.has(AXES[axis as usize])).collect();
        self.no_rotary_length(named.is_empty())?;
        if !named.is_empty() {
            let over = self.end_point();
            self.emit(MotionKind::Rapid, over, None);
        }
        let reference = self.state.frame.to_program(&self.pose_of(if second { G30_FIRST } else { G28_FIRST }));
        let mut to = self.state.at;
        for axis in Axis::ALL {
            if named.is_empty() || named.contains(&axis) {
                to.set(axis, reference.get(axis));
            }
        }
        self.emit(MotionKind::Rapid, to, None);
        Ok(())
    }

    /// Refuses G28, G30 and G53 with a tool that has an offset in a rotary axis of the block, or in any of them.
    pub(super) fn no_rotary_length(&self, any: bool) -> Result<()> {
        let turned = |axis: &Axis| {
            axis.rotary() && self.state.frame.tool.get(*axis) != 0.0 && (any || self.block.has(AXES[*axis as usize]))
        };
        let column = self.block.g_column(crate::gcode::code::Group::NonModal);
        Axis::ALL
            .into_iter()
            .find(turned)
            .map_or(Ok(()), |axis| Err(Refused::of(&LengthOfRotaryAxis { axis: axis.letter() }, &[column])))
    }

    /// G28.1 and G30.1: this is the reference point.
    pub(super) fn keep_reference(&mut self, second: bool) {
        let machine = self.state.frame.to_machine(&self.state.at);
        self.keep_pose(if second { G30_FIRST } else { G28_FIRST }, &machine);
    }

    pub(super) fn keep_g92(&mut self, on: bool, registers: Option<Pose>) {
        self.memory.parameters.set(G92_SWITCH as usize, f64::from(u8::from(on)));
        if let Some(registers) = registers {
            self.keep_pose(G92_FIRST, &registers);
        }
    }

    /// G52: the local offset, in the registers of G92.
    pub(super) fn local_offset(&mut self) {
        let mut g92 = self.state.frame.g92;
        for axis in Axis::ALL {
            if let Some(value) = self.axis_word(axis) {
                self.state.at.set(axis, self.state.at.get(axis) + g92.get(axis) - value);
                g92.set(axis, value);
            }
        }
        self.state.frame.g92 = g92;
        self.keep_g92(true, Some(g92));
    }

    /// G92: this position gets the axis words as its coordinates.
    pub(super) fn set_position(&mut self) {
        self.memory.seen.start_preset |= self.memory.seen.distances == [false; 2];
        let mut g92 = self.state.frame.g92;
        for axis in Axis::ALL {
            if let Some(value) = self.axis_word(axis) {
                g92.set(axis, self.state.at.get(axis) + g92.get(axis) - value);
                self.state.at.set(axis, value);
            }
        }
        self.state.frame.g92 = g92;
        self.keep_g92(true, Some(g92));
    }

    /// The refusal of G52 or G92 without axes, with the code that cancels it where the control has one.
    pub(super) fn position_without_axes(&self) -> Box<Refused> {
        let group = crate::gcode::code::Group::NonModal;
        let code = if self.block.g(group) == Some(G::LocalOffset) { "G52" } else { "G92" };
        let cancels = self.memory.control.codes.has(G::ClearPosition);
        let cancel = if cancels { t(", o G92.1 para anularlo", ", or G92.1 to cancel it") } else { t("", "") };
        Refused::of(&SetPositionWithoutAxes { code, cancel }, &[self.block.g_column(group)])
    }

    /// What G92 has set ends: a work offset is selected, and the control has one of both in force.
    pub(super) fn end_preset(&mut self) {
        let (on, registers) = self.g92_registers();
        if on && registers != Pose::default() {
            let column = self.block.g_column(crate::gcode::code::Group::WorkOffset);
            self.memory.remarks.row(&PresetEnds {}, self.block.spot, Some(column));
            self.change_position(G::ClearPosition);
        }
    }

    /// G92 or G50 of a lathe: with S alone the greatest spindle speed.
    pub(super) fn set_position_or_speed(&mut self) -> Result<()> {
        let axes = AXES.into_iter().any(|axis| self.block.has(axis));
        match (axes, self.block.get(letter::S)) {
            (false, Some(S)) => {
                self.state.modal.greatest_speed = Some(S);
                Ok(())
            }
            (true, None) => {
                self.see_preset();
                if self.memory.control.offsets.shifts() {
                    self.set_lathe_position();
                } else {
                    self.set_position();
                }
                Ok(())
            }
            (axes, _) => {
                let column = self.block.g_column(crate::gcode::code::Group::NonModal);
                if axes {
                    return Err(Refused::of(&AxesOrSpeed {}, &[column]));
                }
                let code = self.memory.control.codes.names(G::SetPositionOrSpeed).join(", ");
                Err(Refused::of(&PositionOrSpeedMissing { code }, &[column]))
            }
        }
    }

    /// G92.1 clears the offsets of G92, G92.2 sets them aside, G92.3 takes them up again.
    pub(super) fn change_position(&mut self, code: G) {
        let registers = self.g92_registers().1;
        let (on, in_force, kept) = match code {
            G::ClearPosition => (false, Pose::default(), Some(Pose::default())),
            G::SuspendPosition => (false, Pose::default(), None),
            _ => (true, registers, None),
        };
        self.memory.seen.placed.preset_ends();
        self.memory.seen.start_preset &= code != G::ClearPosition;
        self.keep_g92(on, kept);
        self.reframe(ActiveOffsets { g92: in_force, ..self.state.frame });
    }

    /// The end of a program: G54, G17, G90, G94, spindle off; G92 stays unless the control does not keep it.
    pub(super) fn end_of_program(&mut self) {
        let (on, registers) = self.g92_registers();
        // At an assumed start of 0, G92 X0 shifts by nothing; on the machine by where it stands.
        let left = on && (registers != Pose::default() || self.memory.seen.start_preset);
        if !self.memory.setting.keep_g92 {
            self.keep_g92(false, Some(Pose::default()));
            self.reframe(ActiveOffsets { g92: Pose::default(), ..self.state.frame });
        } else if left {
            let spot = self.block.spot;
            if self.memory.control.offsets.shifts() {
                self.memory.remarks.row(&SetPositionLeftOfLathe {}, spot, None);
            } else if self.memory.control.offsets.preset_ends() {
                self.memory.remarks.row(&PresetLeft {}, spot, None);
            } else {
                self.memory.remarks.row(&SetPositionLeft {}, spot, None);
            }
        }
        self.select_system(1);
        self.state.modal.plane = self.memory.control.start.plane;
        self.state.modal.incremental = false;
        self.state.modal.feed_mode = self.memory.control.start.feed;
        (self.state.modal.feed, self.state.modal.feed_word) = (0.0, 0.0);
        self.state.modal.spindle = Spindle::Stopped;
        self.state.modal.coolant = false;
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::{Control, FAGOR_8055, FAGOR_8070, LINUXCNC};
    use crate::gcode::interpreter::{Interpreter, Setting};
    use crate::machine::axis::Axis;

    /// Where X of the machine ends.
    fn end(program: &str, control: &'static Control) -> f64 {
        let motions: Result<Vec<_>, _> = Interpreter::over(program.as_bytes(), Setting::new(control)).collect();
        motions.expect("a good program").last().expect("a motion").machine.get(Axis::X)
    }

    #[test]
    fn a_work_offset_ends_g92_on_a_fagor_and_adds_to_it_on_linuxcnc() {
        let fagor = "%A,MX--,\nG71 G90 G54\nG0 X10\nG92 X0\nG54\nG0 X5\nM30\n";
        assert_eq!(end(fagor, &FAGOR_8055), 5.0);
        assert_eq!(end(&fagor.replace("A,MX--,", "1-A"), &FAGOR_8070), 5.0);
        // Set after the offset, it counts.
        assert_eq!(end(&fagor.replace("G54\nG0 X5", "G54\nG92 X0\nG0 X5"), &FAGOR_8055), 15.0);
        assert_eq!(end("G21 G90 G54\nG0 X10\nG92 X0\nG54\nG0 X5\nG92.1\nM2\n", &LINUXCNC), 15.0);
    }
}
