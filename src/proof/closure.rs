//! Closure: a program that is run again must start where it started.

use crate::finding::Raise;
use crate::gcode::program::Program;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::shown;
use crate::proof::check::{Check, Question};
use crate::proof::rules::NotClosed;
use crate::proof::step::{Judge, SAME, Step};
use crate::text::{Text, t};

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
    seen: usize,
}

impl Closure {
    /// The judge of a program that should leave this turn of C.
    #[must_use]
    pub const fn new(turn: Turn) -> Self {
        Self { turn, ends: None, seen: 0 }
    }

    /// The sum of the increments seen: where the program ends, seen from where it starts.
    #[must_use]
    pub fn net(&self) -> Pose {
        self.ends.map_or_else(Pose::default, |[first, last]| Pose(last.differences(&first)))
    }
}

impl Judge for Closure {
    fn see(&mut self, step: &Step<'_>) {
        if step.at_work() {
            self.ends.get_or_insert([step.motion.from, step.motion.to])[1] = step.motion.to;
            self.seen += 1;
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
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
        let name = t("Cierre: suma de los incrementos", "Closure: sum of the increments");
        let limit = format!("X 0  Y 0  Z 0  B 0  {C_limit}");
        let asked = Question::new("closure", name, program).showing(Text::same(value), Text::same(limit));
        let open = |place| NotClosed { program: program.title.clone() }.at(place);
        vec![asked.seen(self.seen).holds(closes, open)]
    }
}
