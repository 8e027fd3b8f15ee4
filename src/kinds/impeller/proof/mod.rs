//! The verification of an impeller: every program read back once, every judge asked.
//!
//! | judge | question |
//! |---|---|
//! | [`passes`] | is every blade and splitter cut once on both sides |
//! | [`tip_path`], by [`cutting`] | how far does the tip leave its path between the blocks, and how fine must the steps be |
//! | [`floor`], by [`cutting`] | how much deeper than the floor does the tool's rim cut |
//! | [`flanks`], by [`cutting`] | does the tool keep clear of the other blades |
//! | [`clear`] | of a clear cut: does the tool keep out of faces, splitters and floor |
//! | [`tool_terms`] | of a clear cut: do tool, spindle and speed in force stand in the form |
//! | [`stock`] | does it keep clear of the stock where it does not cut |
//! | [`blank`] | does the turning program leave the torus, cut at the speeds and feeds asked for, and nowhere at rapid |

pub mod blank;
pub mod clear;
pub mod cutting;
pub mod flanks;
pub mod floor;
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
use crate::kinds::impeller::proof::clear::ClearCutting;
use crate::kinds::impeller::proof::cutting::{Cutting, Known};
use crate::kinds::impeller::proof::passes::{PassCount, Passes};
use crate::kinds::impeller::proof::stock::Clear;
use crate::kinds::impeller::proof::tool_terms::ToolTerms;
use crate::kinds::impeller::splitter::Splitter;
use crate::number::grid::Milli;
use crate::proof::agreement::Agreement;
use crate::proof::arcs::Arcs;
use crate::proof::closure::{Closure, Turn};
use crate::proof::feed::Feeds;
use crate::proof::rollover::Rollover;
use crate::proof::step::Judge;
use crate::proof::travel::Axes;
use crate::proof::turning::RotarySteps;
use crate::text::{Text, t};

/// The geometry that programs are compared with.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<'a> {
    /// The design.
    pub design: &'a Design,
    /// The blade.
    pub blade: &'a Blade,
    /// The published splitter, where there is one.
    pub splitter: Option<&'a Splitter>,
    /// The plan of a clear cut.
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
    if program.key == "blank" { blank::setting(design) } else { program.setting() }
}

/// What is asked of every program that mills.
const MILLING: &[&str] =
    &["agreement", "passes", "closure", "travel", "turning", "feed", "safe-points", "clear-moves", "arcs", "rotary"];
/// What is asked of the program that is the first to cut a track, beside that.
const FIRST: &[&str] = &[
    "agreement",
    "passes",
    "closure",
    "travel",
    "turning",
    "feed",
    "tip-path",
    "into-metal",
    "grid",
    "floor-rim",
    "blades",
    "safe-points",
    "clear-moves",
    "arcs",
    "rotary",
];

/// What is asked of the program of one tool of a clear cut.
const CLEAR: &[&str] = &[
    "agreement",
    "tool",
    "passes",
    "closure",
    "travel",
    "turning",
    "feed",
    "faces",
    "floor",
    "clear-moves",
    "arcs",
    "rotary",
];
/// The same where there are splitters.
const CLEAR_SPLITTERS: &[&str] = &[
    "agreement",
    "tool",
    "passes",
    "closure",
    "travel",
    "turning",
    "feed",
    "faces",
    "splitters",
    "floor",
    "clear-moves",
    "arcs",
    "rotary",
];

/// The checks that must be answered for a program.
#[must_use]
pub fn due(design: &Design, program: &Program) -> &'static [&'static str] {
    match program.key {
        "blank" => blank::due(design),
        "rough" | "finish" if design.splitters => CLEAR_SPLITTERS,
        "rough" | "finish" => CLEAR,
        // Its tracks were measured in those of blade and splitter.
        "impeller" => MILLING,
        // All that is asked of any: a program that is not known here is stopped.
        _ => FIRST,
    }
}

/// The judges of a program, with what is known from the programs before it.
#[must_use]
pub fn judges<'a>(geometry: Geometry<'a>, known: &'a mut Known, program: &'a Program) -> Vec<Box<dyn Judge + 'a>> {
    let design = geometry.design;
    if program.key == "blank" {
        return blank::judges(design);
    }
    let Known { tracks, clear_moves, finish_moves } = known;
    if let (Some(plan), Some(asked)) = (geometry.clear, &design.clear) {
        let (which, moves) = match program.key {
            "rough" => (Which::Rough, clear_moves),
            _ => (Which::Finish, finish_moves),
        };
        let mill = design.mill(which);
        return vec![
            Box::new(Agreement::of_the_tip(design.machine, program)),
            Box::new(ToolTerms::new(design, mill)),
            Box::new(ClearCutting::new(design, asked, plan, which)),
            Box::new(Closure::new(turn(design, program))),
            Box::new(Axes::new(&design.travel)),
            Box::new(RotarySteps::default()),
            Box::new(Feeds::new(design.machine, mill.F, design.F_max).slower(SLOT)),
            Box::new(Clear::new(design, mill.d, moves)),
            Box::new(Arcs::default()),
            Box::new(Rollover(design.counting)),
        ];
    }
    vec![
        Box::new(Agreement::of_the_tip(design.machine, program)),
        Box::new(Passes::new(expected(design, program))),
        Box::new(Closure::new(turn(design, program))),
        Box::new(Axes::new(&design.travel)),
        Box::new(RotarySteps::default()),
        Box::new(Feeds::new(design.machine, design.F, design.F_max)),
        Box::new(Cutting::new(geometry, tracks)),
        Box::new(Clear::new(design, design.d_t, clear_moves)),
        Box::new(Arcs::default()),
        Box::new(Rollover(design.counting)),
    ]
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
