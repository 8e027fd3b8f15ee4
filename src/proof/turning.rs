//! Continuity of C: it counts on past a turn and never jumps back.
//!
//! C may turn far while the tool stands clear and nothing else moves in line. Where X, Y or Z move with it the tool is
//! at work, and a jump of more than half a turn would sweep it through the part.

use crate::gcode::program::Program;
use crate::machine::axis::Axis;
use crate::number::shown;
use crate::proof::check::{At, Check, FAULT, Verdict};
use crate::proof::step::{Judge, SAME, Stage, Step};
use crate::text::Text;

/// The greatest step of C while a linear axis moves, degrees.
pub const LIMIT: f64 = 180.0;

/// Watches the steps of C.
#[derive(Debug, Default)]
pub struct RotarySteps {
    greatest: f64,
    at: Option<At>,
}

impl Judge for RotarySteps {
    fn see(&mut self, step: &Step<'_>) {
        if matches!(step.stage, Stage::Positioning) {
            return;
        }
        let by = step.motion.to.differences(&step.motion.from);
        let linear = [Axis::X, Axis::Y, Axis::Z].into_iter().any(|axis| by[axis as usize].abs() > SAME);
        let C = by[Axis::C as usize].abs();
        if linear && C > self.greatest {
            (self.greatest, self.at) = (C, Some(At::motion(&step.motion)));
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
        let name = Text::fixed("Continuidad de C: mayor paso", "Continuity of C: greatest step");
        let value = Text::same(format!("{}°", shown(self.greatest, 3)));
        let check = Check::passed("turning", name, program, value, Text::same(format!("{}°", shown(LIMIT, 0))));
        let check = check.at(self.at);
        vec![if self.greatest <= LIMIT {
            check
        } else {
            let (line, step) = (self.at.map_or(1, |at| at.line), shown(self.greatest, 3));
            check.found(
                Verdict::Stop,
                Text::new(
                    format!("C salta {step}° en la línea {line} de «{}»", program.title.es),
                    format!("C jumps by {step}° at line {line} of \"{}\"", program.title.en),
                ),
                FAULT,
            )
        }]
    }
}
