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
use crate::gcode::rules::modes::{CutsBeforeSpindle, NoFeed, NoSpeedLimit, SpindleStopped};
use crate::gcode::word::NumberFormat;
use crate::kind::live_form::LiveForm;
use crate::kind::measure::{Measure, Suggested};
use crate::kind::method::{Method, Written};
use crate::kind::{Chapters, Chart, Proved, Shown, Wants, out_of_format};
use crate::kinds;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::blade_count::{N_max, e_max, hub_circumference, least_gap};
use crate::kinds::impeller::clear::cut::Job;
use crate::kinds::impeller::clear::fields as cut;
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::remarks as remarks_of;
use crate::kinds::impeller::clear::rules::{PublishedLeavesMetal, TooManyClearBlocks};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::figures::figures;
use crate::kinds::impeller::gap::Limits;
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::parameters::{self as form, FORM};
use crate::kinds::impeller::programs::{Tracks, programs};
use crate::kinds::impeller::proof::cutting::Known;
use crate::kinds::impeller::proof::{Geometry, SOURCE};
use crate::kinds::impeller::remarks::{no_calibration, no_splitter, remarks};
use crate::kinds::impeller::shortfalls::{shortfalls, too_narrow};
use crate::kinds::impeller::splitter::Splitter;
use crate::kinds::impeller::tables::ToolPaths;
use crate::machine::axis::Axis;
use crate::machine::calibration::Axis as Calibrated;
use crate::machine::rapids::Rapids;
use crate::number::grid::OutOfFormat;
use crate::parameter::field::Fields;
use crate::parameter::{Case, Form, at};
use crate::proof::step::Judge;
use crate::scene::part::Part;
use crate::table::{Quantity, Table, Unit};
use crate::text::{Text, t};

/// The tables of the published passes: a clear cut has others.
const PUBLISHED: [&str; 3] = ["annex-6", "annex-7", "annex-8"];

/// The kind.
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
    /// The plan of a clear cut.
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
    type Memo = Known;

    const FORM: &'static Form = &FORM;
    const CASES: &'static [Case] = &cases::CASES;
    const RULES: &'static [&'static [&'static Rule]] =
        &[kinds::rules::RULES, rules::RULES, clear::rules::RULES, proof::rules::RULES];
    // A published program has neither feed nor spindle, and of the limit of the blank's speed its judge speaks.
    const ANSWERED: &'static [&'static Rule] =
        &[NoFeed::RULE, NoSpeedLimit::RULE, CutsBeforeSpindle::RULE, SpindleStopped::RULE];
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
        design.written.control
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

    fn programs(design: &Design, model: &Model, origin: &Origin<'_>) -> Result<Written, Vec<Finding>> {
        if let (Some(plan), Some(asked)) = (&model.clear, &design.clear) {
            let made = clear::programs::programs(design, plan, origin)
                .map_err(|error| vec![out_of_format(error, [form::R.key(), form::R_B.key(), form::H.key()])])?;
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
            return Ok(Written { programs: made.programs, findings });
        }
        let made = match &model.tracks {
            Ok(tracks) => programs(design, tracks, origin),
            Err(error) => Err(*error),
        };
        let made = made.map_err(|error| vec![out_of_format(error, [form::R.key(), form::R_B.key(), form::H.key()])])?;
        let mut findings = remarks(design, &made, model.calibration.as_ref().map(|(_, axis)| *axis));
        findings.extend(too_narrow(design, &model.limits));
        Ok(Written { programs: made.programs, findings })
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

    fn memo(design: &Design, model: &Model, wants: Wants) -> Known {
        Known::new(model.geometry(design), wants)
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
        known: &'a mut Known,
        program: &'a Program,
    ) -> Vec<Box<dyn Judge + 'a>> {
        proof::judges(model.geometry(design), known, program)
    }

    fn due(design: &Design, program: &Program) -> &'static [&'static str] {
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
        let length = ("length-by-offset", Shown::Whether(design.written.writing.tool.may_bring_length()));
        enough.into_iter().chain([length]).collect()
    }

    fn charts(_: &Design, model: &Model) -> Vec<Chart> {
        charts::charts(model.splitter.is_some(), model.clear.is_some())
    }

    fn figures(design: &Design, model: &Model, known: &Known) -> Vec<Figure> {
        figures(design, model, &known.curves())
    }
}

/// Derived limits, angles and lengths.
fn quantities(design: &Design, model: &Model, programs: &[Proved]) -> Vec<Quantity> {
    let Model { limits, passes, splitter, .. } = model;
    let (torus, a_p, e, d_t) = (design.torus, design.a_p, design.e, design.d_t);
    let mm = Unit::Millimetre;
    let circle = crate::geometry::villarceau::Villarceau::new(torus);
    let gap = hub_circumference(torus, a_p) / f64::from(design.N) - e;
    let mut list = vec![
        quantity(
            "L",
            "Longitud de pivote, del eje B al centro del toro",
            "Pivot length, from the B axis to the torus centre",
            design.machine.L,
            mm,
            ["R_B + H", "R_B + H"],
        )
        .by("derived_L", "spindle_height_R_B+height_H"),
        quantity("k", "Semieje √(R² − r²)", "Semi-axis √(R² − r²)", circle.k, mm, ["TFG, ec. (6)", "thesis, eq. (6)"])
            .by("derived_k", "SQRT((torus_R-meridian_r)*(torus_R+meridian_r))"),
        quantity(
            "alpha",
            "Ángulo α del círculo de Villarceau",
            "Angle α of the Villarceau circle",
            circle.alpha().to_degrees(),
            Unit::Degree,
            ["sen α = r/R", "sin α = r/R"],
        )
        .by("derived_alpha", "DEGREES(ASIN(meridian_r/torus_R))"),
        quantity(
            "length",
            "Longitud de la fibra media",
            "Length of the mean line",
            torus.R * std::f64::consts::FRAC_PI_2,
            mm,
            ["|dX/dv| = R: R·π/2", "|dX/dv| = R: R·π/2"],
        )
        .by("derived_length", "torus_R*PI()/2"),
        quantity(
            "w",
            "Semiancho de álabe y herramienta",
            "Half width of blade and tool",
            design.w(),
            mm,
            ["(e + d_t)/2, TFG, ecs. (20) y (21)", "(e + d_t)/2, thesis, eqs (20) and (21)"],
        )
        .by("derived_w", "(thickness_e+tool_diameter_d_t)/2"),
        quantity(
            "d",
            "Separación mínima entre álabes, según lo publicado",
            "Minimum gap between blades, as published",
            least_gap(d_t),
            mm,
            ["4/3·d_t, TFG, sección 4.2.2", "4/3·d_t, thesis, section 4.2.2"],
        )
        .by("derived_d", "tool_diameter_d_t*4/3"),
        quantity(
            "gap",
            "Separación entre álabes en el cubo, medida por el paralelo",
            "Gap between blades at the hub, along the parallel",
            gap,
            mm,
            ["2π(R − r − a_p)/N − e", "2π(R − r − a_p)/N − e"],
        )
        .by("derived_gap", "2*PI()*(torus_R-meridian_r-depth_a_p)/blades_N-thickness_e"),
        quantity(
            "N_max",
            "Número máximo de álabes, según lo publicado",
            "Maximum number of blades, as published",
            N_max(torus, a_p, e, d_t),
            Unit::Count,
            ["TFG, ec. (34)", "thesis, eq. (34)"],
        )
        .by("derived_N_max", "INT(2*PI()*(torus_R-meridian_r-depth_a_p)/(thickness_e+derived_d))"),
        quantity(
            "e_max",
            "Espesor máximo del álabe, según lo publicado",
            "Maximum blade thickness, as published",
            e_max(torus, a_p, design.N, d_t),
            mm,
            ["TFG, ec. (35)", "thesis, eq. (35)"],
        )
        .by("derived_e_max", "2*PI()*(torus_R-meridian_r-depth_a_p)/blades_N-derived_d"),
        quantity(
            "gap_true",
            "Separación real: mayor herramienta que pasa entre los álabes",
            "True gap: largest tool that passes between the blades",
            limits.gap.width,
            mm,
            [
                "el doble de lo que el eje de la fresa se aparta de las caras en el paso más estrecho",
                "twice the distance of the tool axis from the faces at the narrowest place",
            ],
        ),
        quantity(
            "beta",
            "Inclinación β del extremo del álabe",
            "Inclination β of the blade's end",
            passes.entry.beta.to_degrees(),
            Unit::Degree,
            ["TFG, ec. (23) corregida", "thesis, eq. (23) corrected"],
        )
        .by("derived_beta", "[annex-8.β first]"),
        quantity(
            "pitch",
            "Giro entre álabes",
            "Turn between blades",
            360.0 / f64::from(design.N),
            Unit::Degree,
            ["TFG, ec. (22)", "thesis, eq. (22)"],
        )
        .by("derived_pitch", "360/blades_N"),
        quantity(
            "X_e",
            "X final del torneado, en diámetro",
            "End X of the turning, on the diameter",
            design.blank.X_e,
            mm,
            ["la de la hoja; vacía: 2·R + 30", "as in the form; empty: 2·R + 30"],
        )
        .by("derived_X_e", "IF(ISBLANK(blank_end_X_e),2*torus_R+30,blank_end_X_e)"),
    ];
    // A limit that does not exist is left out; the caution about the gap says so.
    list.extend(limits.N_max.map(|N| {
        quantity(
            "N_max_true",
            "Número máximo de álabes si la separación real cumple la regla publicada",
            "Maximum number of blades whose true gap keeps the published rule",
            f64::from(N),
            Unit::Count,
            ["separación real ≥ 4/3·d_t", "true gap ≥ 4/3·d_t"],
        )
    }));
    list.extend(limits.e_max.map(|e| {
        quantity(
            "e_max_true",
            "Espesor máximo del álabe si la separación real cumple la regla publicada",
            "Maximum blade thickness whose true gap keeps the published rule",
            e,
            mm,
            ["separación real ≥ 4/3·d_t", "true gap ≥ 4/3·d_t"],
        )
    }));
    if let (Some(plan), Some(asked)) = (&model.clear, &design.clear) {
        // There is no annex of the published paths that it could be taken from.
        for beta in list.iter_mut().filter(|one| one.symbol == "beta") {
            *beta = beta.clone().by("derived_beta", "DEGREES(ASIN(meridian_r/torus_R))");
        }
        list.extend(clear::tables::quantities(asked, plan));
    }
    list.extend(splitter.as_ref().map(crossings).into_iter().flatten());
    let first = |program: &Program| matches!(Operation::of(program), Some(Operation::Blade | Operation::Rough));
    if let Some(program) = programs.iter().find(|program| program.format == NumberFormat::Fixed && first(program)) {
        list.push(
            quantity(
                "Z_r",
                "Altura de retirada",
                "Retract height",
                program.start.get(Axis::Z).value(),
                mm,
                ["√(L² + R²) − L + d_s", "√(L² + R²) − L + d_s"],
            )
            .by("derived_Z_r", "ROUNDUP((SQRT(derived_L^2+torus_R^2)-derived_L+safety_d_s)*1000,0)/1000"),
        );
    }
    list
}

pub(in crate::kinds::impeller) fn quantity(
    symbol: &'static str,
    es: &'static str,
    en: &'static str,
    value: f64,
    unit: Unit,
    source: [&'static str; 2],
) -> Quantity {
    Quantity { symbol, meaning: t(es, en), value, unit, source: t(source[0], source[1]), cell: None }
}

/// Where a splitter's paths cross its neighbours', and from where on its offset is full.
#[expect(clippy::cast_precision_loss, reason = "counts of points")]
fn crossings(splitter: &Splitter) -> Vec<Quantity> {
    let Splitter { out, back, .. } = splitter;
    let section = ["TFG, sección 4.3", "thesis, section 4.3"];
    let room = ["donde la herramienta libra al vecino", "where the tool clears the neighbour"];
    match splitter.fade {
        Fade::Published => vec![
            quantity(
                "crossing",
                "Índice del cruce con el álabe vecino",
                "Index of the crossing with the neighbour",
                back.crossing,
                Unit::One,
                section,
            ),
            quantity(
                "m",
                "Punto desde el que el intermedio tiene todo su espesor",
                "Point from which the splitter has its full thickness",
                back.m as f64,
                Unit::Count,
                section,
            )
            .named("derived_m"),
        ],
        Fade::EachSide => vec![
            quantity(
                "crossing_1",
                "Índice del cruce con el álabe vecino, a la ida",
                "Index of the crossing with the neighbour, out",
                out.crossing,
                Unit::One,
                section,
            ),
            quantity(
                "m_1",
                "Punto desde el que la ida lleva toda su separación",
                "Point from which the way out has its full offset",
                out.m as f64,
                Unit::Count,
                room,
            )
            .named("derived_m_1"),
            quantity(
                "crossing_2",
                "Índice del cruce con el álabe vecino, a la vuelta",
                "Index of the crossing with the neighbour, back",
                back.crossing,
                Unit::One,
                section,
            ),
            quantity(
                "m_2",
                "Punto desde el que la vuelta lleva toda su separación",
                "Point from which the way back has its full offset",
                back.m as f64,
                Unit::Count,
                room,
            )
            .named("derived_m_2"),
        ],
    }
}
