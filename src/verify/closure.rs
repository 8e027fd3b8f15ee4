//! Closure: a program that is run again must start where it started.

use crate::finding::{Finding, Grade, Place};
use crate::gcode::program::Program;
use crate::machine::axis::{Axis, Position};
use crate::number::grid::Milli;
use crate::number::shown;
use crate::text::Text;

/// What a program leaves of C when it ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Any whole number of turns.
    Whole,
    /// One certain angle: the turn to the next blade.
    Exactly(Milli),
}

/// The sum of a program's increments: where it ends, seen from where it starts.
#[must_use]
pub fn net_travel(program: &Program) -> Position {
    let mut net = Position::default();
    program.for_each_move(&mut |each| {
        for axis in Axis::ALL {
            net = net.moved(axis, each.to.get(axis) - each.from.get(axis));
        }
    });
    net
}

/// Checks that a program closes to exactly 0 in every axis, and in C to the turn expected of it.
#[must_use]
pub fn closure(program: &Program, turn: Turn) -> Finding {
    let net = net_travel(program);
    let C = net.get(Axis::C);
    let (C_closes, C_limit) = match turn {
        Turn::Whole => (C.thousandths() % 360_000 == 0, "C 360·k".to_owned()),
        Turn::Exactly(angle) => (C == angle, format!("C {}", shown(angle.value(), 3))),
    };
    let closes = C_closes && Axis::ALL.into_iter().all(|axis| axis == Axis::C || net.get(axis) == Milli::ZERO);
    let value = [Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C]
        .map(|axis| format!("{} {}", axis.letter(), shown(net.get(axis).value(), 3)))
        .join("  ");
    let limit = format!("X 0  Y 0  Z 0  B 0  {C_limit}");
    let place = Place::Block { program: program.key, line: 1 };
    let finding = if closes {
        Finding::note(
            place,
            Text::new(
                format!("el programa «{}» cierra: la suma de sus incrementos es exactamente 0", program.title.es),
                format!("program \"{}\" closes: the sum of its increments is exactly 0", program.title.en),
            ),
        )
    } else {
        Finding::new(
            Grade::Stop,
            place,
            Text::new(
                format!("el programa «{}» no cierra", program.title.es),
                format!("program \"{}\" does not close", program.title.en),
            ),
            Text::fixed("es un fallo de rodete: comuníquelo", "this is a fault in rodete: report it"),
        )
    };
    finding.with(value, limit)
}
