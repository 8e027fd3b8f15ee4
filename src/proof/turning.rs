//! Continuity of C: it counts on past a turn and never jumps back.
//!
//! C may turn far while the tool stands clear and nothing else moves in line. Where X, Y or Z move with it the tool is
//! at work, and a jump of more than half a turn would sweep it through the part.

use crate::finding::{Limit, Raise, Size};
use crate::gcode::program::Program;
use crate::machine::axis::Axis;
use crate::number::shown;
use crate::proof::check::{At, Check, Extreme, Question};
use crate::proof::rules::TurnJumps;
use crate::proof::step::{Judge, SAME, Step};
use crate::text::{Text, t};

/// The greatest step of C while a linear axis moves, degrees.
pub const LIMIT: f64 = 180.0;
/// What the sums of a control add to a step of 0.001°, degrees.
const NOISE: f64 = 1e-6;

/// Watches the steps of C.
#[derive(Debug, Default)]
pub struct RotarySteps {
    greatest: Extreme,
}

impl Judge for RotarySteps {
    fn see(&mut self, step: &Step<'_>) {
        if !step.at_work() {
            return;
        }
        let by = step.motion.to.differences(&step.motion.from);
        let linear = [Axis::X, Axis::Y, Axis::Z].into_iter().any(|axis| by[axis as usize].abs() > SAME);
        let C = by[Axis::C as usize].abs();
        self.greatest.take(if linear { C } else { 0.0 }, At::motion(&step.motion));
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Continuidad de C: paso máximo", "Continuity of C: largest step");
        let degrees = |value: f64, decimals| Text::same(format!("{}°", shown(value, decimals)));
        let asked =
            Question::new("turning", name, program).showing(degrees(self.greatest.value(), 3), degrees(LIMIT, 0));
        // A step of half a turn itself, on the grid of programs, is none that is more.
        vec![asked.against(Limit::AtMost(LIMIT)).within(&self.greatest, LIMIT + NOISE, |found, place| {
            let (step, line) = (Size::degrees(found.value(), 3), found.line());
            TurnJumps { step, line, program: program.title.clone() }.at(place)
        })]
    }
}
