//! The verification of an impeller: every program read back once, every judge asked.
//!
//! | judge | question |
//! |---|---|
//! | [`passes`] | is every blade and splitter cut once on both sides |
//! | [`tip_path`], by [`cutting`] | how far does the tip leave its path between the blocks, and how fine must the steps be |
//! | [`floor`], by [`cutting`] | how much deeper than the floor does the tool's rim cut |
//! | [`flanks`], by [`cutting`] | does the tool keep clear of the other blades |
//! | [`clear`] | of a clear cut: does the tool keep out of faces, splitters and floor; how far does its holder stay from the blank |
//! | [`tool_terms`] | do tool, spindle and speed in force stand in the form |
//! | [`stock`] | does it keep clear of the stock where it does not cut |
//! | [`blank`] | does the turning program leave the torus, cut at the speeds and feeds asked for, and nowhere at rapid |

pub mod blank;
pub mod clear;
pub mod cutting;
pub mod flanks;
pub mod floor;
mod holder;
pub mod nose;
pub mod passes;
pub mod refinement;
pub mod rules;
pub mod stock;
pub mod tip_path;
pub mod tool_terms;
pub mod track_step;

use crate::gcode::interpreter::Setting;
use crate::gcode::program::Program;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::programs::SLOT;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::proof::clear::ClearCutting;
use crate::kinds::impeller::proof::cutting::{Cutting, ProofMemo};
use crate::kinds::impeller::proof::passes::{PassCount, Passes};
use crate::kinds::impeller::proof::stock::Clear;
use crate::kinds::impeller::proof::tool_terms::ToolTerms;
use crate::kinds::impeller::splitter::Splitter;
use crate::machine::travel::AxisTravel;
use crate::number::grid::Milli;
use crate::proof::agreement::Agreement;
use crate::proof::arcs::Arcs;
use crate::proof::closure::{Closure, Turn};
use crate::proof::due::Due;
use crate::proof::feed::{self, Feeds};
use crate::proof::rollover::{self, Rollover};
use crate::proof::step::Judge;
use crate::proof::travel::Axes;
use crate::proof::turning::RotarySteps;
use crate::text::{Text, t};

/// The geometry that programs are compared with.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<'a> {
    /// What the workbook asks for.
    pub design: &'a Design,
    /// The mean line with its frame, point by point.
    pub blade: &'a Blade,
    /// The published splitter, where there is one.
    pub splitter: Option<&'a Splitter>,
    /// `None` where the part is cut as published.
    pub clear: Option<&'a Plan>,
}

/// What stands under the title of the table.
pub const SOURCE: Text = t(
    "Leída de los programas, bloque a bloque; cada trayectoria se mide en el primer programa que la recorre",
    "Read back from the programs, block by block; each path is measured in the first program that cuts it",
);

/// What a program is read with.
#[must_use]
pub fn setting(design: &Design, program: &Program) -> Setting {
    if Operation::of(program) == Some(Operation::Blank) { blank::setting(design) } else { program.setting() }
}

/// What must be answered of a program that mills at F, mm/min: what is asked of all of them, and of its cut.
fn milling(design: &Design, F: Option<f64>, cut: Vec<Due>) -> Vec<Due> {
    let mut due = ["agreement", "tool", "passes", "closure"].map(Due::judged).to_vec();
    due.push(Due::told_where(!design.travel.iter().any(AxisTravel::is_known), "travel"));
    due.push(Due::judged("turning"));
    due.extend(feed::due(F, design.F_max));
    due.extend(cut);
    // Where there is no arc, that is told.
    due.extend([Due::judged("clear-moves"), Due::told("arcs"), rollover::due(design.counting)]);
    due
}

/// What must be answered of the cut in the program that is the first to run along a track.
fn first(design: &Design) -> Vec<Due> {
    let toleranced = design.tol.is_some();
    let mut due = vec![
        Due::told_where(!toleranced, "tip-path"),
        // Where a tolerance is given, that is what the tip is held against.
        Due::told_where(toleranced, "into-metal"),
        Due::judged("grid"),
        Due::told("floor-rim"),
        // A single blade has no other.
        Due::told_where(design.N == 1, "blades"),
    ];
    if design.splitters {
        // How far a pass reaches into a splitter where that is meant is told.
        due.push(Due::told("splitters"));
    }
    due.push(Due::judged("safe-points"));
    due
}

/// What must be answered of the cut in the program of one tool of a clear cut.
fn clear_cut(design: &Design, which: Which) -> Vec<Due> {
    let mut due = vec![Due::judged("faces")];
    if design.splitters {
        due.push(Due::judged("splitters"));
    }
    due.push(Due::judged("floor"));
    // Its holder, where the form gives it.
    if design.clear.as_ref().is_some_and(|asked| asked.cut.stage(which).is_some()) {
        due.push(Due::judged("holder"));
    }
    due
}

/// The checks that must be answered for a program.
#[must_use]
pub fn due(design: &Design, program: &Program) -> Vec<Due> {
    let clear = |which: Which| milling(design, design.mill(which).F, clear_cut(design, which));
    match Operation::of(program) {
        Some(Operation::Blank) => blank::due(design),
        Some(Operation::Rough) => clear(Which::Rough),
        Some(Operation::Finish) => clear(Which::Finish),
        // Its tracks were measured in those of blade and splitter.
        Some(Operation::Whole) => milling(design, written_feed(design), vec![Due::judged("safe-points")]),
        // A program that is not known here is stopped: nobody judges it.
        Some(Operation::Blade | Operation::Splitter) | None => milling(design, written_feed(design), first(design)),
    }
}

/// F of the programs along the published paths, mm/min: the published layout carries none.
fn written_feed(design: &Design) -> Option<f64> {
    design.F.filter(|_| design.style == Style::Full)
}

/// The judges of a program, with what is known from the programs before it; none of a program that is none of an impeller's, or
/// of a clear cut that was not planned.
#[must_use]
pub fn judges<'a>(geometry: Geometry<'a>, known: &'a mut ProofMemo, program: &'a Program) -> Vec<Box<dyn Judge + 'a>> {
    let design = geometry.design;
    let (which, moves) = match Operation::of(program) {
        None => return Vec::new(),
        Some(Operation::Blank) => return blank::judges(design),
        Some(operation @ (Operation::Blade | Operation::Splitter | Operation::Whole)) => {
            return published(geometry, known, program, operation);
        }
        Some(Operation::Rough) => (Which::Rough, &mut known.clear_moves),
        Some(Operation::Finish) => (Which::Finish, &mut known.finish_moves),
    };
    let (Some(plan), Some(asked)) = (geometry.clear, &design.clear) else { return Vec::new() };
    let mill = design.mill(which);
    vec![
        Box::new(Agreement::of_the_tip(design.machine, program)),
        Box::new(ToolTerms::new(design, mill)),
        Box::new(ClearCutting::new(design, asked, plan, which)),
        Box::new(Closure::new(Turn::Whole)),
        Box::new(Axes::new(design.travel)),
        Box::new(RotarySteps::default()),
        Box::new(Feeds::new(design.machine, mill.F, design.F_max).slower(SLOT)),
        Box::new(Clear::new(design, mill.d, moves)),
        Box::new(Arcs::default()),
        Box::new(Rollover::new(design.counting)),
    ]
}

/// The judges of a program along the published paths.
fn published<'a>(
    geometry: Geometry<'a>,
    known: &'a mut ProofMemo,
    program: &'a Program,
    operation: Operation,
) -> Vec<Box<dyn Judge + 'a>> {
    let (design, ProofMemo { tracks, clear_moves, .. }) = (geometry.design, known);
    vec![
        Box::new(Agreement::of_the_tip(design.machine, program)),
        Box::new(ToolTerms::new(design, design.mill(Which::Rough))),
        Box::new(Passes::new(expected(design, operation))),
        Box::new(Closure::new(turn(design, operation))),
        Box::new(Axes::new(design.travel)),
        Box::new(RotarySteps::default()),
        Box::new(Feeds::new(design.machine, written_feed(design), design.F_max)),
        Box::new(Cutting::new(geometry, tracks)),
        Box::new(Clear::new(design, design.d_t, clear_moves)),
        Box::new(Arcs::default()),
        Box::new(Rollover::new(design.counting)),
    ]
}

/// How many passes of each track a program should make.
fn expected(design: &Design, operation: Operation) -> PassCount {
    let N = usize::try_from(design.N).unwrap_or(usize::MAX);
    match operation {
        Operation::Blade => [1, 1, 0, 0],
        Operation::Splitter => [0, 0, 1, 1],
        Operation::Whole => {
            let splitters = if design.splitters { N } else { 0 };
            [N, N, splitters, splitters]
        }
        // They run along no track.
        Operation::Blank | Operation::Rough | Operation::Finish => [0; 4],
    }
}

/// The turn of C that a program should leave.
fn turn(design: &Design, operation: Operation) -> Turn {
    match design.style {
        Style::Full => Turn::Whole,
        Style::Annex => match operation {
            Operation::Blade | Operation::Splitter => {
                Turn::Exactly(Milli::round(360.0 / f64::from(design.N)).unwrap_or(Milli::ZERO))
            }
            Operation::Whole | Operation::Blank | Operation::Rough | Operation::Finish => Turn::Whole,
        },
    }
}
