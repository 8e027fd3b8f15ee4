//! Closure: a program that is run again must start where it started.

use crate::gcode::program::Program;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::shown;
use crate::proof::check::{Check, FAULT, Verdict};
use crate::proof::step::{Judge, SAME, Stage, Step};
use crate::text::Text;

/// What a program leaves of C when it ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Any whole number of turns.
    Whole,
    /// One certain angle: the turn to the next blade.
    Exactly(Milli),
}

/// Checks that a program closes to exactly 0 in every axis, and in C to the turn expected of it.
#[derive(Debug)]
pub struct Closure {
    turn: Turn,
    ends: Option<[Pose; 2]>,
}

impl Closure {
    /// The judge of a program that should leave this turn of C.
    #[must_use]
    pub const fn new(turn: Turn) -> Self {
        Self { turn, ends: None }
    }

    /// The sum of the increments seen: where the program ends, seen from where it starts.
    #[must_use]
    pub fn net(&self) -> Pose {
        self.ends.map_or_else(Pose::default, |[first, last]| Pose(last.differences(&first)))
    }
}

impl Judge for Closure {
    fn see(&mut self, step: &Step<'_>) {
        if !matches!(step.stage, Stage::Positioning) {
            self.ends.get_or_insert([step.motion.from, step.motion.to])[1] = step.motion.to;
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
        let net = self.net();
        let (C_left, C_limit) = match self.turn {
            Turn::Whole => {
                let turns = (net.get(Axis::C) / 360.0).round();
                (net.get(Axis::C) - turns * 360.0, "C 360·k".to_owned())
            }
            Turn::Exactly(angle) => (net.get(Axis::C) - angle.value(), format!("C {}", shown(angle.value(), 3))),
        };
        let closes =
            C_left.abs() < SAME && Axis::ALL.into_iter().all(|axis| axis == Axis::C || net.get(axis).abs() < SAME);
        let value = [Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C]
            .map(|axis| format!("{} {}", axis.letter(), shown(net.get(axis), 3)))
            .join("  ");
        let name = Text::fixed("Cierre: suma de los incrementos", "Closure: sum of the increments");
        let limit = format!("X 0  Y 0  Z 0  B 0  {C_limit}");
        let check = Check::passed("closure", name, program, Text::same(value), Text::same(limit));
        vec![if closes {
            check
        } else {
            check.found(
                Verdict::Stop,
                Text::new(
                    format!("el programa «{}» no cierra", program.title.es),
                    format!("program \"{}\" does not close", program.title.en),
                ),
                FAULT,
            )
        }]
    }
}
