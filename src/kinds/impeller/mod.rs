//! The impeller: blades along Villarceau circles of a torus, milled on five axes.
//!
//! Each file holds one family of formulas; [`blade::Blade`] is the whole geometry of one blade, [`splitter::Splitter`]
//! that of the blade between two, [`tables`] shows both as the annexes set them and [`programs`](mod@programs) as ISO programs.

pub mod assembly;
pub mod blade;
pub mod blade_count;
pub mod blank;
pub mod bodies;
pub mod cases;
mod charts;
pub mod clear;
pub mod clearance;
pub mod contradictions;
pub mod corners;
pub mod design;
pub mod discretisation;
pub mod fade;
pub mod figures;
pub mod floor_depth;
mod form_sketch;
pub mod gap;
pub mod header;
pub mod ideal;
mod limit;
mod live_form;
mod live_lines;
mod measures;
pub mod nearest;
pub mod operation;
pub mod outside;
pub mod parameters;
pub mod part;
pub mod programs;
pub mod proof;
mod quantities;
mod remarks;
pub mod ribs;
pub mod room;
pub mod rules;
pub mod safety;
pub mod scene;
mod shortfalls;
pub mod slips;
pub mod solids;
pub mod splitter;
mod start;
pub mod sweep;
pub mod tables;
pub mod tool_path;
pub mod track;
mod twist;
pub mod undercut;

use crate::figure::Figure;
use crate::finding::{Exit, Finding, Raise, Rule};
use crate::gcode::control::Control;
use crate::gcode::header::Origin;
use crate::gcode::interpreter::Setting;
use crate::gcode::program::{Program, Style};
use crate::gcode::rules::modes::{
    CutsBeforeSpindle, CutsWithoutSpeed, NoFeed, NoSpeedLimit, SpindleStopped, SurfaceSpeedMissing,
};
use crate::kind::live_form::LiveForm;
use crate::kind::measure::{Measure, Suggested};
use crate::kind::method::{Method, Unproved};
use crate::kind::{Chapters, Chart, Proved, Shown, Wants, out_of_format};
use crate::kinds;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::clear::cut::Job;
use crate::kinds::impeller::clear::fields as cut;
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::remarks as remarks_of;
use crate::kinds::impeller::clear::rules::{PublishedLeavesMetal, TooManyClearBlocks};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::figures::figures;
use crate::kinds::impeller::gap::Limits;
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::parameters::{self as form, FORM};
use crate::kinds::impeller::programs::{Tracks, programs};
use crate::kinds::impeller::proof::cutting::ProofMemo;
use crate::kinds::impeller::proof::{Geometry, SOURCE};
use crate::kinds::impeller::quantities::quantities;
use crate::kinds::impeller::remarks::{no_calibration, no_splitter, remarks};
use crate::kinds::impeller::shortfalls::{shortfalls, too_narrow};
use crate::kinds::impeller::splitter::Splitter;
use crate::kinds::impeller::tables::ToolPaths;
use crate::machine::calibration::Axis as Calibrated;
use crate::machine::rapids::Rapids;
use crate::number::grid::OutOfFormat;
use crate::parameter::field::Fields;
use crate::parameter::{Case, Form, at};
use crate::proof::due::Due;
use crate::proof::step::Judge;
use crate::scene::part::Part;
use crate::table::{Quantity, Table};
use crate::text::{Text, t};

/// The tables of the published passes: a clear cut has others.
const PUBLISHED: [&str; 3] = ["annex-6", "annex-7", "annex-8"];

/// The workbook kind `impeller`; it has no values, all of it is in its traits.
#[derive(Debug)]
pub enum Impeller {}

/// The blades of a design, and what is worked out of them.
#[derive(Debug)]
pub struct Model {
    blade: Blade,
    passes: ToolPaths,
    splitter: Option<Splitter>,
    /// The table of the calibration, and the axis that it finds.
    calibration: Option<(Table, Calibrated)>,
    limits: Limits,
    /// Passes on the output grid, where they fit it.
    tracks: Result<Tracks, OutOfFormat>,
    /// `None` where the part is cut as published.
    clear: Option<Plan>,
}

impl Model {
    /// What programs are compared with.
    const fn geometry<'a>(&'a self, design: &'a Design) -> Geometry<'a> {
        Geometry { design, blade: &self.blade, splitter: self.splitter.as_ref(), clear: self.clear.as_ref() }
    }
}

impl Method for Impeller {
    type Design = Design;
    type Model = Model;
    type Memo = ProofMemo;

    const FORM: &'static Form = &FORM;
    const CASES: &'static [Case] = &cases::CASES;
    const RULES: &'static [&'static [&'static Rule]] =
        &[kinds::rules::RULES, rules::RULES, clear::rules::RULES, proof::rules::RULES];
    // A published program has neither feed nor speed nor spindle, as its own caution says, and of the limit of the blank's speed its judge speaks.
    const ANSWERED: &'static [&'static Rule] = &[
        NoFeed::RULE,
        NoSpeedLimit::RULE,
        SurfaceSpeedMissing::RULE,
        CutsBeforeSpindle::RULE,
        CutsWithoutSpeed::RULE,
        SpindleStopped::RULE,
    ];
    const CHAPTERS: &'static Chapters = &Chapters {
        labels: include_str!("../../../report-templates/impeller/labels.typ"),
        method: [
            include_str!("../../../report-templates/impeller/method-es.typ"),
            include_str!("../../../report-templates/impeller/method-en.typ"),
        ],
        setup: include_str!("../../../report-templates/impeller/setup.typ"),
        further: &[("equations.typ", include_str!("../../../report-templates/impeller/equations.typ"))],
    };
    const PROVED: Text = SOURCE;
    const MEASURES: &'static [Measure] = measures::MEASURES;
    const SUGGESTED: &'static Suggested = &measures::SUGGESTED;

    fn sketch() -> Option<Figure> {
        Some(form_sketch::sketch())
    }

    fn live() -> Option<LiveForm> {
        Some(live_form::live())
    }

    fn design(fields: &Fields) -> Result<Design, Vec<Finding>> {
        Design::new(fields)
    }

    fn control(design: &Design) -> &'static Control {
        design.post.control
    }

    fn style(design: &Design) -> Option<Style> {
        Some(design.style)
    }

    fn model(design: &Design) -> Result<Model, Vec<Finding>> {
        let blade = Blade::new(design.torus, design.n, design.eps_v, design.machine);
        let passes = ToolPaths::new(design, &blade);
        let mut stops = Vec::new();
        let clear = match &design.clear {
            Some(asked) => {
                let plan =
                    Plan::new(&Job::of(design), &asked.cut).map_err(|why| vec![remarks_of::does_not_fit(&why)])?;
                stops.extend(remarks_of::stops(design, asked, &plan));
                Some(plan)
            }
            None => None,
        };
        let splitter = if design.splitters && clear.is_none() {
            Splitter::new(design, &blade).map_err(|why| stops.push(no_splitter(why))).ok()
        } else {
            None
        };
        let calibration = design.calibration.as_ref().and_then(|slots| {
            let found = tables::calibration(slots, design.R_B);
            if found.is_none() {
                stops.push(no_calibration());
            }
            found
        });
        if !stops.is_empty() {
            return Err(stops);
        }
        let tracks = Tracks::new(&blade, &passes, splitter.as_ref());
        Ok(Model { blade, passes, splitter, calibration, limits: Limits::new(design), tracks, clear })
    }

    fn stopped(findings: &[Finding]) -> Exit {
        // Nothing is wrong with a design whose programs are too long for a control.
        if findings.iter().all(|finding| finding.is(TooManyClearBlocks::RULE)) { Exit::Limit } else { Exit::Refused }
    }

    fn tables(design: &Design, model: &Model) -> Vec<Table> {
        let Model { blade, passes, splitter, calibration, clear, .. } = model;
        let mut tables = tables::annexes(blade, passes);
        if let Some(plan) = clear {
            // Paths and safe points of the published passes.
            tables.retain(|table| !PUBLISHED.contains(&table.key));
            tables.extend(clear::tables::tables(design, plan));
        }
        if let Some(splitter) = splitter {
            tables.extend(tables::splitter(design, blade, splitter));
        }
        tables.push(tables::blank(design));
        tables.extend(calibration.iter().map(|(table, _)| table.clone()));
        tables.push(tables::views(blade));
        tables
    }

    fn lines(design: &Design, model: &Model, programs: &[Program]) -> Vec<Table> {
        if design.style == Style::Annex { live_lines::tables(&model.passes, programs) } else { Vec::new() }
    }

    fn programs(design: &Design, model: &Model, origin: &Origin<'_>) -> Result<Unproved, Vec<Finding>> {
        if let (Some(plan), Some(asked)) = (&model.clear, &design.clear) {
            let made = clear::programs::programs(design, plan, origin).map_err(no_room)?;
            let long: Vec<Finding> = made
                .programs
                .iter()
                .filter_map(|program| remarks_of::too_long(program.title.clone(), program.blocks()))
                .collect();
            if !long.is_empty() {
                return Err(long);
            }
            let mut findings = remarks(design, &made, model.calibration.as_ref().map(|(_, axis)| *axis));
            findings.extend(too_narrow(design, &model.limits));
            findings.extend(remarks_of::remarks(&Job::of(design), asked, plan));
            return Ok(Unproved { programs: made.programs, findings });
        }
        let made = match &model.tracks {
            Ok(tracks) => programs(design, tracks, origin),
            Err(error) => Err(*error),
        };
        let made = made.map_err(no_room)?;
        let mut findings = remarks(design, &made, model.calibration.as_ref().map(|(_, axis)| *axis));
        findings.extend(too_narrow(design, &model.limits));
        Ok(Unproved { programs: made.programs, findings })
    }

    fn shortfalls(design: &Design, model: &Model) -> Vec<Finding> {
        if design.clear.is_some() {
            return Vec::new();
        }
        let mut findings = model.tracks.as_ref().map_or(Vec::new(), |tracks| shortfalls(design, tracks));
        if !design.method_given {
            findings.push(PublishedLeavesMetal {}.at(at([cut::METHOD.key()])));
        }
        findings
    }

    fn memo(design: &Design, model: &Model, wants: Wants) -> ProofMemo {
        ProofMemo::new(model.geometry(design), wants)
    }

    fn fewer(_: &Design, program: &Program) -> Text {
        match Operation::of(program) {
            Some(Operation::Rough) => {
                t("una tol mayor, o menos niveles (una a_k mayor)", "a larger tol, or fewer levels (a larger a_k)")
            }
            Some(Operation::Finish) => t("una tol, una c_s o una delta mayor", "a larger tol, c_s or delta"),
            // The blank's program is never too long.
            Some(Operation::Blade | Operation::Splitter | Operation::Whole | Operation::Blank) | None => {
                t("un n menor", "a smaller n")
            }
        }
    }

    fn setting(design: &Design, program: &Program) -> Setting {
        proof::setting(design, program)
    }

    /// The blank is turned on a lathe, whose rates the form does not ask for.
    fn rapids(design: &Design, program: &Program) -> Rapids {
        if program.control.turns() { Rapids::default() } else { design.rapids }
    }

    fn judges<'a>(
        design: &'a Design,
        model: &'a Model,
        known: &'a mut ProofMemo,
        program: &'a Program,
    ) -> Vec<Box<dyn Judge + 'a>> {
        proof::judges(model.geometry(design), known, program)
    }

    fn due(design: &Design, program: &Program) -> Vec<Due> {
        proof::due(design, program)
    }

    fn quantities(design: &Design, model: &Model, programs: &[Proved]) -> Vec<Quantity> {
        quantities(design, model, programs)
    }

    fn part(design: &Design, model: &Model) -> Option<Part> {
        Some(scene::part(design, &model.blade, model.splitter.as_ref(), model.clear.as_ref()))
    }

    fn setup(design: &Design, model: &Model) -> Vec<(&'static str, Shown)> {
        let clear = design.clear.as_ref().zip(model.clear.as_ref());
        let enough = clear.map(|(asked, plan)| remarks_of::enough_stick_outs(asked, plan)).unwrap_or_default();
        let length = ("length-by-offset", Shown::Whether(design.post.writing.tool.may_bring_length()));
        enough.into_iter().chain([length]).collect()
    }

    fn charts(_: &Design, model: &Model) -> Vec<Chart> {
        charts::charts(model.splitter.is_some(), model.clear.is_some())
    }

    fn figures(design: &Design, model: &Model, known: &ProofMemo) -> Vec<Figure> {
        figures(design, model, &known.curves())
    }
}

/// The refusal of a position that no program may carry.
fn no_room(error: OutOfFormat) -> Vec<Finding> {
    vec![out_of_format(error, [form::R.key(), form::R_B.key(), form::H.key(), form::X_E.key()])]
}
