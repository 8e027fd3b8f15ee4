//! The lathe: a turning program of a workbook followed as it removes material, judged and shown.
//!
//! # References
//! The lathe simulator's machine, stock, tools and cycles; what it leaves open says so where it stands, under "Derivation" or as chosen.

pub mod cases;
pub mod catalogue;
pub mod drawn;
pub mod figures;
pub mod findings;
mod follow;
mod form_sketch;
mod hold;
mod live_form;
mod measures;
mod outside;
pub mod parameters;
mod part_view;
mod profile;
pub mod quantities;
pub mod rules;
pub mod scene;
pub mod setup;
mod setup_sheet;
pub mod sketch;
pub(crate) mod tables;
pub mod text;
pub mod tool_sheet;

use std::sync::LazyLock;

use crate::figure::Figure;
use crate::finding::{Exit, Finding, Grade, Place, Refusal, Rule};
use crate::gcode::interpreter::{Setting, Standstill};
use crate::gcode::program::Program;
use crate::kind::live_form::LiveForm;
use crate::kind::measure::{Limits, Measure, Suggested};
use crate::kind::{Chapters, Drawing, End, Kind, Outcome, Provenance, Shown, Solid, Wants};
use crate::kinds::lathe::drawn::Drawn;
use crate::kinds::lathe::follow::{Begins, Followed, follow, late};
use crate::kinds::lathe::parameters::{FORM, PROGRAM_KEY, SECOND_KEY};
use crate::kinds::lathe::profile::{Comparison, WantedProfile, compared, wanted};
use crate::kinds::lathe::scene::Watching;
use crate::kinds::lathe::setup::Given;
use crate::kinds::lathe::sketch::Clamping;
use crate::kinds::lathe::tables::{Rows, alarms_table, contour_table, lines_table, tools_table, turret_table};
use crate::parameter::field::Fields;
use crate::parameter::{Case, Form};
use crate::removal::turning::alarm::Alarm;
use crate::removal::turning::simulation::Simulation;
use crate::removal::turning::step::Step;
use crate::text::t;

/// How far the facets of the solid may be from the round part, mm.
const TOLERANCE: f64 = 0.01;

/// What happens while a program is followed.
#[derive(Debug)]
pub enum SimulationEvent<'a> {
    /// A program begins, with its text and the part as it is.
    Begin(&'a Program, &'a text::SheetProgram, &'a Simulation),
    /// What is in force before the first block, or after one that changed it without a motion; with the name of the
    /// subprogram's file that the block stands in.
    Stood(&'a Standstill, &'a Simulation, Option<&'a str>),
    /// A motion was made, and this is what it left; with the name of the subprogram's file that its block stands in.
    Step(&'a Step, &'a Simulation, Option<&'a str>),
    /// An alarm that could be reported only when all programs had ended, of a motion of the program of this number, from 0; with
    /// the name of the subprogram's file that its block stands in.
    Late(usize, &'a Alarm, Option<&'a str>),
    /// What the interpreter found in the program that has ended, by line; its alarms were seen with their motions.
    End(&'a [Finding], &'a Simulation),
}

/// An alarm and where its block stands.
#[derive(Clone, Debug)]
pub struct Raised {
    /// The alarm.
    pub alarm: Alarm,
    /// Its block: a cell, or a line of a file.
    pub place: Place,
    /// The tool's place and the offset in force, where it is not the tool's own.
    pub other_offset: Option<(u32, u32)>,
}

/// What came of turning programs.
#[derive(Debug)]
pub struct Simulated {
    /// What every kind comes to.
    pub outcome: Outcome,
    /// Every alarm of the programs, in their order.
    pub alarms: Vec<Raised>,
    /// True if the programs were followed to their ends; else no figure of them is that of the whole.
    pub whole: bool,
}

/// The kind.
#[derive(Debug)]
pub struct Lathe;

impl Kind for Lathe {
    fn form(&self) -> &'static Form {
        &FORM
    }

    fn sketch(&self) -> Option<Figure> {
        Some(form_sketch::sketch())
    }

    fn live(&self) -> Option<LiveForm> {
        Some(live_form::live())
    }

    fn cases(&self) -> &'static [Case] {
        &cases::CASES
    }

    fn chapters(&self) -> &'static Chapters {
        const {
            &Chapters {
                labels: include_str!("../../../report-templates/lathe/labels.typ"),
                method: [
                    include_str!("../../../report-templates/lathe/method-es.typ"),
                    include_str!("../../../report-templates/lathe/method-en.typ"),
                ],
                setup: include_str!("../../../report-templates/lathe/setup.typ"),
                further: &[("equations.typ", include_str!("../../../report-templates/lathe/equations.typ"))],
            }
        }
    }

    fn rules(&self) -> &'static [&'static [&'static Rule]] {
        &[rules::RULES]
    }

    fn setting(&self, fields: &Fields, _program: &Program) -> Option<Setting> {
        Given::of(fields).ok().map(|given| given.setting())
    }

    fn design(&self, fields: &Fields) -> Result<(), Vec<Finding>> {
        Given::of(fields).map(drop)
    }

    fn measures(&self) -> &'static [Measure] {
        measures::MEASURES
    }

    fn suggested(&self) -> &'static Suggested {
        &measures::SUGGESTED
    }

    /// Of a program that is written already nothing is known before it is read.
    fn limits(&self, fields: &Fields) -> Result<Limits, Refusal> {
        Given::of(fields).map(|_| Limits::default()).map_err(refused)
    }

    /// Follows the programs of a filled-in form.
    fn run(&self, fields: Fields, found: Vec<Finding>, source: Provenance, wants: Wants) -> Result<Outcome, Refusal> {
        let mut outcome = simulated(fields, source, None, wants)?.outcome;
        outcome.findings.extend(found);
        outcome.findings.sort_by_key(|finding| std::cmp::Reverse(finding.grade));
        Ok(outcome)
    }
}

/// Follows the programs of a filled-in form, or `program` in place of that on its sheets. The scene shows as well what
/// stops the work.
///
/// # Errors
/// A refusal with every contradiction between values.
pub fn simulated(
    fields: Fields,
    source: Provenance,
    program: Option<text::SheetProgram>,
    wants: Wants,
) -> Result<Simulated, Refusal> {
    let mut watching = wants.scene.then(Watching::default);
    let mut simulated = watched(fields, source, program, &mut |event| {
        if let Some(watching) = &mut watching {
            watching.see(event);
        }
    })?;
    simulated.outcome.scene = watching.map(|watching| Ok(watching.scene()));
    Ok(simulated)
}

/// Follows programs; `watch` is shown everything as it happens. `program` stands in for the program of the sheets.
///
/// # Errors
/// A refusal with every contradiction between values.
pub fn watched(
    fields: Fields,
    source: Provenance,
    program: Option<text::SheetProgram>,
    watch: &mut dyn FnMut(SimulationEvent<'_>),
) -> Result<Simulated, Refusal> {
    let mut wrong = Vec::new();
    if program.is_none() {
        wrong.extend(setup::without_rule(&fields));
        wrong.extend(text::twice(&fields));
    }
    let wanted = wanted(&fields).map_err(|finding| wrong.push(*finding)).unwrap_or_default();
    let given = match Given::of(&fields) {
        Ok(given) if wrong.is_empty() => given,
        Ok(_) => return Err(refused(wrong)),
        Err(findings) => return Err(refused(findings.into_iter().chain(wrong).collect())),
    };
    let first = program.or_else(|| text::SheetProgram::of(&fields, PROGRAM_KEY)).unwrap_or_default();
    let title = t("Programa", "Program");
    let held = hold::bar(&given.setup.stock, &given.setup.lathe).map(|held| fields.locate(held));
    let begins = Begins { held, ..Begins::new(Simulation::new(given.setup.clone())?) };
    let one = follow("program", title, &first, &given, begins, watch);
    let second = text::SheetProgram::of(&fields, SECOND_KEY);
    let two = if let Some(second) = &second {
        let simulation = one.simulation.turned_about(given.second)?;
        let title = t("Programa del segundo amarre", "Program of the second set-up");
        // How a part is held that is not the one meant says nothing.
        let held = (!one.lost && !one.endless).then(|| fields.locate(hold::turned(simulation.setup())));
        let loose = held.as_ref().is_some_and(|held| held.grade == Grade::Stop);
        let lost = one.lost || one.endless || loose;
        // Of a program that was not followed to its end the part was not made; on one that nothing holds nothing is.
        let begins = Begins { simulation, lost, uncut: one.uncut || one.endless || loose, held };
        Some(follow("program-2", title, second, &given, begins, watch))
    } else {
        None
    };
    let mut followed: Vec<Followed> = std::iter::once(one).chain(two).collect();
    late(&mut followed, &given, watch);
    Ok(outcome(fields, source, &given, followed, wanted))
}

fn refused(findings: Vec<Finding>) -> Refusal {
    Refusal { exit: Exit::Refused, findings }
}

fn outcome(
    fields: Fields,
    source: Provenance,
    given: &Given,
    mut followed: Vec<Followed>,
    wanted: Option<WantedProfile>,
) -> Simulated {
    let on_sheet = setup_sheet::shown_on_sheet(&fields, given, &followed);
    let mut findings: Vec<Finding> = followed.iter_mut().flat_map(|one| std::mem::take(&mut one.findings)).collect();
    findings.sort_by_key(|finding| std::cmp::Reverse(finding.grade));
    let mut quantities = quantities::quantities(given, &followed);
    let whole = !followed.iter().any(|one| one.lost || one.endless);
    let mut tables = Rows::tables(followed.iter_mut().map(|one| std::mem::take(&mut one.rows)).collect());
    tables.push(lines_table(&tables));
    tables.push(alarms_table(followed.iter().flat_map(|one| one.alarms.iter())));
    tables.push(tools_table(&given.setup.turret, followed.iter().map(|one| one.simulation.totals())));
    tables.push(turret_table(&given.setup.turret, &given.own));
    let mut drawn = followed.last().map(|one| one.drawn.clone()).unwrap_or_default();
    tables.push(contour_table(&drawn.part));
    let paths: Vec<(Drawn, Clamping)> = followed
        .iter()
        .map(|one| {
            let setup = one.simulation.setup();
            let chuck = setup.fixtures().into_iter().map(|(_, ring)| ring).collect();
            (Drawn { chuck, ..one.drawn.clone() }, Clamping::of(setup))
        })
        .collect();
    drawn.chuck = paths.last().map(|(drawn, _)| drawn.chuck.clone()).unwrap_or_default();
    let (mut lines, mut arcs) = (Vec::new(), Vec::new());
    let profiled = ("profile", Shown::Whether(wanted.is_some()));
    let mut endless = followed.iter().any(|one| one.endless);
    // Where a program was not followed to its end, or not made, there is no part yet to be compared.
    let made = !endless && !followed.iter().any(|one| one.uncut);
    if let Some(wanted) = wanted.filter(|_| made) {
        let grooves = followed.last().map(|one| one.simulation.thread_grooves()).unwrap_or_default();
        let left = followed.last().map_or(0, |one| one.simulation.work_left());
        let part = Comparison {
            contours: &drawn.part,
            tolerance: given.setup.tolerance,
            second: followed.len() > 1,
            grooves: &grooves,
            most_work: left,
        };
        let (told, undone) = compared(&part, &wanted, &mut quantities);
        findings.extend(told);
        findings.sort_by_key(|finding| std::cmp::Reverse(finding.grade));
        endless = undone;
        drawn.wanted = wanted.profile.points().unwrap_or_default();
        (lines, arcs) = wanted.profile.drawn();
    }
    let contour = figures::contour(&drawn.part, lines);
    let alarms = followed.iter_mut().flat_map(|one| std::mem::take(&mut one.alarms)).collect();
    let supported = given.setup.stock.supported(&given.setup.lathe);
    let second = (followed.len() > 1).then_some(("second", Shown::Length(given.second)));
    // How the part that was turned about is held.
    let grip = followed.get(1).and_then(|one| {
        let setup = one.simulation.setup();
        setup.part.as_deref().and_then(|part| setup.stock.grip(&setup.lathe, part))
    });
    let grip = grip.map(|grip| [("held", Shown::Length(grip.length)), ("held-X", Shown::Length(grip.diameter))]);
    let end = End::of(&findings, endless);
    let programs = followed.into_iter().filter(|_| end == End::Whole).map(Followed::proved).collect();
    let outcome = Outcome {
        named_files: Vec::new(),
        kind: &Lathe,
        fields,
        control: given.control,
        style: None,
        quantities,
        tables,
        charts: Vec::new(),
        // Of a part of which nothing is left there is nothing to draw.
        drawings: (!drawn.part.is_empty())
            .then(|| Drawing {
                key: "contour",
                title: t("Contorno de la pieza", "Contour of the part"),
                figure: contour,
                arcs,
                paper: None,
            })
            .into_iter()
            .collect(),
        solids: vec![Solid { key: "part", contours: drawn.part.clone(), tolerance: TOLERANCE }],
        scene: None,
        setup: [("supported", Shown::Whether(supported)), profiled]
            .into_iter()
            .chain(second)
            .chain(grip.into_iter().flatten())
            .chain(on_sheet)
            .collect(),
        checks: Vec::new(),
        figures: LazyLock::new(Box::new(move || figures::figures(&drawn, &paths))),
        programs,
        findings,
        end,
        source,
    };
    Simulated { outcome, alarms, whole }
}
