//! Rotary axes that count from 0 to 359.9999, and motions at feed that turn one by more than half a turn.
//!
//! # References
//! Fagor CNC 8055/8055i M & EN programming manual (Ref. 1711), p. 52, and installation manual, p. 294: a rollover axis, as
//! delivered: in G90 the sign is the direction and the number the target, 0 to 359.9999; in G91 the sign is the direction and
//! the number how far, more than a turn where it is more than 360. Error manual, 0168 and 0199: the ranges. LinuxCNC,
//! `WRAPPED_ROTARY` and `unwrap_rotary` in `interp_find.cc`: the same, and no motion where the angle is reached already.

use crate::finding::Grade;
use crate::gcode::code::{G, Group};
use crate::gcode::control::Letters;
use crate::gcode::control::Rotary;
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::block::{AXES, letter};
use crate::gcode::interpreter::fault::{Fault, Outcome};
use crate::gcode::motion::MotionKind;
use crate::machine::axis::{Axis, Pose};
use crate::text::Text;

/// The words of rotary axes.
const WORDS: u32 = Letters::of("ABC").mask();
/// The rotary axes with their letters.
const ROTARY: [(Axis, usize); 3] = [(Axis::A, letter::A), (Axis::B, letter::B), (Axis::C, letter::C)];
/// Two angles nearer than this are one: half of what the control shows, degrees.
const SAME: f64 = 0.000_05;
/// What the sum of increments may lose, degrees.
const ROUNDING: f64 = 1e-6;

impl Interpreter<'_> {
    /// Refuses absolute words of rollover axes that the control refuses, before the block is executed.
    pub(super) fn rotary_words(&self) -> Outcome<()> {
        if self.setting.rotary == Rotary::Linear || self.block.present & WORDS == 0 {
            return Ok(());
        }
        let incremental = match self.block.g(Group::Distance) {
            Some(code) => code == G::Incremental,
            None => self.modal.incremental,
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
            let fault = |what: Text, remedy: Text| Err(Fault::at(&[self.block.column(index)], what, remedy));
            if preset && !self.control.rotary.rollover.wrapped() && !(0.0..360.0).contains(&word) {
                return fault(
                    Text::new(
                        format!("0199: {name}{word} como cota de un eje rotativo rollover: va de 0 a 359.9999"),
                        format!("0199: {name}{word} to preset a rollover axis: it goes from 0 to 359.9999"),
                    ),
                    Text::fixed(
                        "escriba el mismo ángulo entre 0 y 359.9999",
                        "write the same angle from 0 to 359.9999",
                    ),
                );
            }
            if self.control.rotary.rollover.wrapped() && self.block.g(Group::NonModal) == Some(G::MachineCoordinates) {
                return fault(
                    Text::new(
                        format!(
                            "{name} con G53 en un eje con WRAPPED_ROTARY: el control toma el signo de la palabra y el destino sin el traslado"
                        ),
                        format!(
                            "{name} with G53 on an axis with WRAPPED_ROTARY: the control takes the sign of the word and the target without the offset"
                        ),
                    ),
                    Text::fixed("mueva el eje sin G53", "move the axis without G53"),
                );
            }
            if word.abs() >= 360.0 {
                let number = if self.control.rotary.rollover.wrapped() { "" } else { "0168: " };
                return fault(
                    Text::new(
                        format!(
                            "{number}{name}{word} en G90: en un eje rollover el número es el destino, de 0 a 359.9999, y el \
                             signo el sentido"
                        ),
                        format!(
                            "{number}{name}{word} in G90: on a rollover axis the number is the target, 0 to 359.9999, and \
                             the sign the direction"
                        ),
                    ),
                    Text::fixed(
                        "escriba el giro en G91; si el eje de la máquina no es rollover, dígalo con --rotary linear",
                        "write the turn in G91; if the machine's axis is not rollover say so with --rotary linear",
                    ),
                );
            }
        }
        Ok(())
    }

    /// Where an absolute word leads a rotary axis that stands at an angle, counted on beyond a turn; degrees.
    pub(super) fn rolled(&mut self, axis: Axis, word: f64, at: f64) -> f64 {
        let index = AXES.get(axis as usize).copied().unwrap_or_default();
        let (target, minus) = (word.abs(), word.is_sign_negative());
        let turn = ((at + ROUNDING) / 360.0).floor() * 360.0;
        let shown = at - turn;
        let way = target - shown;
        // An angle a hair below a whole turn is reached at the turn's beginning.
        let reached = [0.0, -360.0].into_iter().find(|whole| (way + whole).abs() < SAME);
        let name = axis.letter();
        if reached.is_some() {
            self.undefined(
                index,
                Text::new(
                    format!("{name} ya está en el ángulo de su palabra en G90: no está definido en este control"),
                    format!("{name} stands at the angle of its word in G90 already: undefined on this control"),
                ),
            );
        } else if minus && target == 0.0 {
            self.undefined(
                index,
                Text::new(
                    format!("{name}-0 en G90: no está definido en este control; leído como giro negativo hasta 0"),
                    format!("{name}-0 in G90: undefined on this control; read as a turn in minus to 0"),
                ),
            );
        }
        let whole = reached.unwrap_or(match (minus, way < 0.0) {
            (false, true) => 360.0,
            (true, false) => -360.0,
            _ => 0.0,
        });
        turn + target + whole
    }

    /// Cautions that the control's manuals do not say what a word of a rollover axis does; LinuxCNC's program does.
    fn undefined(&mut self, letter: usize, what: Text) {
        if self.control.rotary.rollover.wrapped() {
            return;
        }
        let remedy = Text::fixed(
            "quite la palabra de un eje que no gira, o escriba el giro en G91",
            "take out the word of an axis that does not turn, or write the turn in G91",
        );
        self.remarks.add(Grade::Caution, self.line, Some(self.block.column(letter)), what, remedy);
    }

    /// Points out a motion at feed that turns a rotary axis by more than half a turn.
    pub(super) fn see_turn(&mut self, kind: MotionKind, to: &Pose) {
        if !matches!(kind, MotionKind::Feed(_) | MotionKind::Arc(..)) {
            return;
        }
        for (axis, _) in ROTARY {
            let by = to.get(axis) - self.current.get(axis);
            if by.abs() > 180.0 + ROUNDING {
                self.remarks.turned(self.line, axis.letter(), by);
            }
        }
    }
}
