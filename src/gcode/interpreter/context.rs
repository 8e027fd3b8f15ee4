//! M70 to M73: the modal state kept in the program or subprogram in hand, and given back.
//!
//! # References
//! LinuxCNC, M-code reference, M70 to M73. What is given back is what its interpreter (2.9) gives back: F with one decimal and S
//! with none, whether a tool's length is taken up but not which, and no motion code.

use crate::finding::Raise;
use crate::gcode::code::{G, M};
use crate::gcode::in_force::Spindle;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::{FeedMode, Plane};
use crate::gcode::rules::modes::{RestoreOfLength, RestoreRounds, RestoreWithWords, RestoreWithoutSave};
use crate::machine::axis::Pose;
use crate::machine::length_unit::LengthUnit;
use crate::machine::work_offset::ActiveOffsets;

/// The modal state as it was kept.
#[derive(Clone, Debug)]
struct Kept {
    plane: Plane,
    unit: LengthUnit,
    incremental: bool,
    centre_absolute: bool,
    feed_mode: FeedMode,
    feed_word: f64,
    speed: f64,
    constant_surface_speed: bool,
    return_initial: bool,
    system: u8,
    tool: Pose,
    g92_on: bool,
    spindle: Spindle,
    coolant: bool,
}

/// What a program or a call of a subprogram has kept.
#[derive(Debug, Default)]
pub(super) struct Context {
    /// The state, until M71 takes it back.
    state: Option<Kept>,
    /// The end of the call gives it back.
    at_return: bool,
}

/// A number as it comes back when it is written with some decimals.
fn written(number: f64, decimals: usize) -> f64 {
    format!("{number:.decimals$}").parse().unwrap_or(number)
}

impl Reader<'_, '_> {
    /// M70 keeps what is in force, M71 discards that, M72 takes it up again; M73 keeps it up to the return of its
    /// subprogram.
    pub(super) fn context_code(&mut self, code: M) -> Result<()> {
        match code {
            M::SaveState(at_return) => {
                let state = self.kept();
                let inside = !self.memory.flow.frames.is_empty();
                let context = self.memory.flow.context();
                context.state = Some(state);
                context.at_return |= at_return && inside;
                Ok(())
            }
            M::ForgetState => {
                self.memory.flow.context().state = None;
                Ok(())
            }
            _ if self.block.present != 0 || self.block.groups != 0 || self.block.machine_codes > 1 => {
                Err(Refused::of(&RestoreWithWords {}, &[self.block.m_column(7)]))
            }
            _ => match self.memory.flow.context().state.clone() {
                Some(state) => {
                    self.give_state_back(&state);
                    Ok(())
                }
                None => Err(Refused::of(&RestoreWithoutSave {}, &[self.block.m_column(7)])),
            },
        }
    }

    /// A call has returned: what M73 kept in it is in force again.
    pub(super) fn leave_context(&mut self, context: &Context) {
        if let Some(state) = context.state.as_ref().filter(|_| context.at_return) {
            self.give_state_back(state);
        }
    }

    fn kept(&self) -> Kept {
        let modal = &self.state.modal;
        Kept {
            plane: modal.plane,
            unit: modal.unit,
            incremental: modal.incremental,
            centre_absolute: modal.centre_absolute,
            feed_mode: modal.feed_mode,
            feed_word: modal.feed_word,
            speed: modal.speed,
            constant_surface_speed: modal.constant_surface_speed,
            return_initial: self.returns_initial(),
            system: modal.system,
            tool: self.state.frame.tool,
            g92_on: self.g92_registers().0,
            spindle: modal.spindle,
            coolant: modal.coolant,
        }
    }

    fn give_state_back(&mut self, state: &Kept) {
        self.state.modal.unit = state.unit;
        if state.feed_mode != self.state.modal.feed_mode {
            self.set_feed_mode(state.feed_mode);
        }
        let (F, S) = (written(state.feed_word, 1), written(state.speed, 0));
        self.state.modal.feed_word = F;
        self.state.modal.feed = match state.feed_mode {
            FeedMode::PerMinute | FeedMode::PerRevolution => state.unit.to_mm(F),
            FeedMode::InverseTime | FeedMode::Seconds => F,
        };
        self.state.modal.speed = S;
        for (letter, was, is) in [('F', state.feed_word, F), ('S', state.speed, S)] {
            if was != is {
                self.remark_context(&RestoreRounds { letter, was, back: is });
            }
        }
        if state.constant_surface_speed && !self.state.modal.constant_surface_speed {
            // G96 comes back without its D.
            self.state.modal.greatest_speed = None;
        }
        self.state.modal.constant_surface_speed = state.constant_surface_speed;
        self.state.modal.plane = state.plane;
        let (none, now) = (Pose::default(), self.state.frame.tool);
        if (state.tool == none) != (now == none) {
            let tool = if state.tool == none { none } else { self.offset_of(self.state.modal.tool) };
            self.reframe(ActiveOffsets { tool, ..self.state.frame });
            self.state.modal.lengthened = state.tool != none;
            self.state.modal.length_of = self.state.modal.lengthened.then_some(self.state.modal.tool);
        }
        if self.state.frame.tool != state.tool {
            self.remark_context(&RestoreOfLength {});
        }
        self.select_system(state.system);
        self.state.modal.incremental = state.incremental;
        self.state.modal.centre_absolute = state.centre_absolute;
        if state.return_initial != self.returns_initial() {
            self.state.modal.return_initial = Some(state.return_initial);
        }
        if state.g92_on != self.g92_registers().0 {
            self.change_position(if state.g92_on { G::RestorePosition } else { G::SuspendPosition });
        }
        self.state.modal.spindle = state.spindle;
        self.state.modal.coolant = state.coolant;
    }

    fn remark_context(&mut self, row: &dyn Raise) {
        self.memory.remarks.row(row, self.block.spot, None);
    }
}

#[cfg(test)]
mod tests {
    use crate::finding::Grade;
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::interpreter::{Interpreter, Setting, ToolOffset, Tools};
    use crate::machine::axis::Axis;

    fn cautions(program: &str) -> Vec<String> {
        let tool = |length: f64| {
            let mut tool = ToolOffset::default();
            tool.offset.set(Axis::Z, length);
            tool
        };
        let mut setting = Setting::new(&LINUXCNC);
        setting.tools = Some(Tools::from([(1, tool(50.0)), (2, tool(80.0))]));
        let mut interpreter = Interpreter::over(program.as_bytes(), setting);
        assert!(interpreter.by_ref().all(|motion| motion.is_ok()), "{program}");
        let remarks = interpreter.remarks().into_iter().filter(|finding| finding.grade == Grade::Caution);
        remarks.map(|finding| finding.what.en.into_owned()).collect()
    }

    #[test]
    fn what_comes_back_otherwise_than_it_was_kept_is_told() {
        assert_eq!(cautions("G21 G90\nF100.5 S500 M3\nM70\nG91\nF3\nM72\nG1 X1\nM2\n"), Vec::<String>::new());
        let rounded = cautions("G20 G90\nF1.23 S99.6 M3\nM70\nM72\nG1 X1\nM2\n");
        assert_eq!(rounded.len(), 2, "{rounded:?}");
        assert!(rounded[0].starts_with("F1.23 comes back as F1.2:"), "{rounded:?}");
        assert!(rounded[1].starts_with("S99.6 comes back as S100:"), "{rounded:?}");
        let other = cautions("G21 G90\nT1 M6\nG43\nM70\nG43 H2\nM72\nG0 Z5\nM2\n");
        assert_eq!(other.len(), 1, "{other:?}");
        assert!(other[0].starts_with("M72 does not restore the saved tool length offset"), "{other:?}");
        assert_eq!(cautions("G21 G90\nT1 M6\nG43\nM70\nG49\nM72\nG0 Z5\nM2\n"), Vec::<String>::new());
    }
}
