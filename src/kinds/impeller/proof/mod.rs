//! The verification of an impeller: every program read back once, every judge asked.

pub mod blank;
pub mod cutting;
pub mod flanks;
pub mod floor;
pub mod refinement;
pub mod stock;
pub mod tip_path;

use crate::gcode::interpreter::Interpreter;
use crate::gcode::program::Program;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::figures::Curve;
use crate::kinds::impeller::proof::cutting::{Cutting, Known};
use crate::kinds::impeller::proof::stock::Clear;
use crate::kinds::impeller::splitter::Splitter;
use crate::number::grid::Milli;
use crate::proof::agreement::{Agreement, PassCount};
use crate::proof::arcs::Arcs;
use crate::proof::check::Check;
use crate::proof::closure::{Closure, Turn};
use crate::proof::feed::Feeds;
use crate::proof::rollover;
use crate::proof::step::watch;
use crate::proof::travel::Axes;
use crate::proof::turning::RotarySteps;
use crate::proof::verification::{Verification, reading};
use crate::text::Text;

/// The geometry that programs are held against.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<'a> {
    /// The design.
    pub design: &'a Design,
    /// The blade.
    pub blade: &'a Blade,
    /// The splitter, where there is one.
    pub splitter: Option<&'a Splitter>,
}

/// Reads the programs of an impeller back and judges them. Beside the verification: how far the tip goes into the metal
/// along each track, for the figure.
#[must_use]
pub fn verify(geometry: Geometry<'_>, programs: &[Program]) -> (Verification, Vec<Curve>) {
    let mut known = Known::new(geometry);
    let mut verification = Verification::default();
    for program in programs {
        let checks = if program.key == "blank" {
            blank::judge(geometry.design, program, &mut program.read_back_with(blank::setting(geometry.design)))
        } else {
            let mut checks = judge(geometry, program, &mut program.read_back(), &mut known);
            checks.push(rollover::check(program, geometry.design.counting));
            checks
        };
        verification.add(program, checks);
    }
    (verification, known.curves())
}

/// What stands under the title of the table.
pub const SOURCE: Text = Text::fixed(
    "Leída de los programas, bloque a bloque; las pistas se miden en el primer programa que las recorre",
    "Read back from the programs, block by block; tracks are measured in the first program that cuts them",
);

/// Judges the motions that a program's text gives. A text that the interpreter refuses is asked nothing else.
pub fn judge(geometry: Geometry<'_>, program: &Program, text: &mut Interpreter<'_>, known: &mut Known) -> Vec<Check> {
    let design = geometry.design;
    let mut agreement = Agreement::new(design.machine, expected(design, program));
    let mut closure = Closure::new(turn(design, program));
    let mut axes = Axes::new(&design.travel);
    let mut turning = RotarySteps::default();
    let mut feeds = Feeds::new(design.machine, design.F, design.F_max);
    let mut arcs = Arcs::default();
    let mut clear_moves = std::mem::take(&mut known.clear_moves);
    let mut clear = Clear::new(design, &mut clear_moves);
    let mut cutting = Cutting::new(geometry, known);
    let mut judges: [&mut dyn crate::proof::step::Judge; 8] =
        [&mut agreement, &mut closure, &mut axes, &mut turning, &mut feeds, &mut cutting, &mut clear, &mut arcs];
    let read = watch(program, &mut *text, &mut judges);
    let mut checks = vec![reading(program, text, read.as_ref().err().map(Box::as_ref))];
    if read.is_ok() {
        checks.extend(judges.iter_mut().flat_map(|judge| judge.checks(program)));
    }
    known.clear_moves = clear_moves;
    checks
}

/// How many passes of each track a program should make.
fn expected(design: &Design, program: &Program) -> PassCount {
    let N = usize::try_from(design.N).unwrap_or(usize::MAX);
    match program.key {
        "blade" => [1, 1, 0, 0],
        "splitter" => [0, 0, 1, 1],
        _ if design.splitters => [N; 4],
        _ => [N, N, 0, 0],
    }
}

/// The turn of C that a program should leave.
fn turn(design: &Design, program: &Program) -> Turn {
    match (design.style, program.key) {
        (Style::Annex, "blade" | "splitter") => {
            Turn::Exactly(Milli::round(360.0 / f64::from(design.N)).unwrap_or(Milli::ZERO))
        }
        _ => Turn::Whole,
    }
}
