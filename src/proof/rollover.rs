//! What rotary axes the machine may have: whether a program makes the same motions where they are rollover, so that in G90 the
//! number is an angle from 0 to 360 and the sign the direction, and where they count on as linear axes do.
//!
//! A program in which every word of a rotary axis leads to the same place on either kind reads alike with each setting: its one
//! reading tells it. Any other is read back twice, once with each setting, with B and C at 0 before. A program that makes the
//! same motions under both is true for any machine; one that does not is written only for axes that the workbook says are
//! linear.

use crate::finding::Raise;
use crate::gcode::control::RotaryMode;
use crate::gcode::interpreter::{Interpreter, Setting};
use crate::gcode::motion::Motion;
use crate::gcode::program::Program;
use crate::parameter::field::Chosen;
use crate::proof::check::{At, Check, Question};
use crate::proof::due::Due;
use crate::proof::rules::OtherwiseOnRollover;
use crate::proof::step::{Judge, Step, same};
use crate::text::{Text, t};

/// What must be answered of a program for axes that count so: on linear ones it is told whether it holds for others, too.
#[must_use]
pub const fn due(counting: RotaryMode) -> Due {
    Due::told_where(!counting.rolls_over(), "rotary")
}

/// Reads a program back under both settings. `counting` is what the workbook says, or the control is delivered with.
#[must_use]
pub fn check(program: &Program, counting: RotaryMode) -> Check {
    let setting = |rotary| Setting { rotary, ..program.setting() };
    let mut linear = program.read_back_with(setting(RotaryMode::Linear));
    let mut rollover = program.read_back_with(setting(RotaryMode::Rollover));
    let (mut motions, mut differs) = (0_usize, None);
    loop {
        match (linear.next(), rollover.next()) {
            (None, None) => break,
            (Some(Ok(one)), Some(Ok(other))) if alike(&one, &other) => motions += 1,
            (Some(Ok(one)), _) | (_, Some(Ok(one))) => {
                differs = Some(At::motion(&one));
                break;
            }
            // A text that is refused under both settings is reported by the reading of it.
            (Some(Err(fault)), _) | (None, Some(Err(fault))) => {
                differs = Some(At::line(fault.line));
                break;
            }
        }
    }
    answer(program, counting, motions, differs)
}

/// The answer on a program of which so many motions are the same, and of the first that is not.
fn answer(program: &Program, counting: RotaryMode, motions: usize, differs: Option<At>) -> Check {
    let name = t("Ejes giratorios: para qué máquina vale", "Rotary axes: which machine it is valid for");
    let asked = Question::new("rotary", name, program).at(differs);
    let limit = counting.label().clone();
    let Some(at) = differs else {
        let value = Text::new(
            format!("rollover y lineal: los mismos {motions} movimientos"),
            format!("rollover and linear: the same {motions} motions"),
        );
        return asked.showing(value, limit).seen(motions).passes();
    };
    let asked = asked.showing(t("solo ejes lineales", "linear axes only"), limit).seen(motions + 1);
    match counting {
        RotaryMode::Linear => asked.informs(),
        RotaryMode::Rollover => {
            asked.holds(false, |place| OtherwiseOnRollover { at: at.words(), program: program.title.clone() }.at(place))
        }
    }
}

/// Asks it of the program's own text, when that has been read as the program is set.
#[derive(Clone, Copy, Debug)]
pub struct Rollover {
    counting: RotaryMode,
    motions: usize,
    /// It reads alike with each setting.
    alike: bool,
}

impl Rollover {
    /// The judge of programs for axes that the workbook says there are, or the control is delivered with.
    #[must_use]
    pub const fn new(counting: RotaryMode) -> Self {
        Self { counting, motions: 0, alike: false }
    }
}

impl Judge for Rollover {
    fn see(&mut self, _: &Step<'_>) {
        self.motions += 1;
    }

    fn end(&mut self, text: &Interpreter<'_>) {
        self.alike = text.any_rotary();
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let Self { counting, motions, alike } = *self;
        vec![if alike { answer(program, counting, motions, None) } else { check(program, counting) }]
    }
}

fn alike(one: &Motion, other: &Motion) -> bool {
    one.line == other.line && same(&one.from, &other.from) && same(&one.to, &other.to)
}
