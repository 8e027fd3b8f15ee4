//! The way of every kind that plans and writes programs, written once.

use std::marker::PhantomData;
use std::sync::LazyLock;

use super::live_form::LiveForm;
use super::measure::{Limits, Measure, MeasureSource, Suggested};
use super::rules::NotNumbered;
use super::{
    Chapters, Chart, Drawing, Duration, End, Kind, Outcome, Proved, Provenance, Shown, Solid, Wants, faults, staging,
};
use crate::figure::Figure;
use crate::finding::{Exit, Finding, Place, Raise, Refusal, Rule, gravest_first};
use crate::gcode::control::Control;
use crate::gcode::fields::RAPID_LINEAR;
use crate::gcode::header::Origin;
use crate::gcode::interpreter::Setting;
use crate::gcode::program::{Part as ProgramPart, Program, Style};
use crate::machine::rapids::Rapids;
use crate::parameter::field::Fields;
use crate::parameter::{Case, Form};
use crate::proof::account::Account;
use crate::proof::due::Due;
use crate::proof::step::{Judge, Plan};
use crate::proof::verification::Verification;
use crate::proof::{self, Judged};
use crate::scene::part::Part;
use crate::table::{Quantity, Table, Unit};
use crate::text::{Text, t};

/// Programs as a kind writes them, and what there is to say of the design and of them before they are proved.
#[derive(Debug)]
pub struct Unproved {
    /// The programs, in the order in which they are handed over.
    pub programs: Vec<Program>,
    /// What a person should know.
    pub findings: Vec<Finding>,
}

/// A kind that plans and writes programs, step by step. [`Of`] makes a [`Kind`] of it.
pub trait Method: Send + Sync + 'static {
    /// The checked values as the formulas take them.
    type Design: Send + Sync + 'static;
    /// What is worked out of a design before anything is written.
    type Model: Send + Sync + 'static;
    /// What one program's proof leaves the next, and figures.
    type Memo: Send + Sync + 'static;

    /// What the user fills in.
    const FORM: &'static Form;
    /// The cases that a new workbook can start from, the usual one first.
    const CASES: &'static [Case];
    /// What it brings to the report.
    const CHAPTERS: &'static Chapters;
    /// The rows of its own findings, one list for each of its `rules.rs`: `explain` knows these alone.
    const RULES: &'static [&'static [&'static Rule]];
    /// The remarks of the interpreter of which its judges speak, or its own findings: the proof does not repeat them.
    const ANSWERED: &'static [&'static Rule] = &[];
    /// How the proof goes, for the table of the checks.
    const PROVED: Text;
    /// What designs of it are compared by; the time of all its programs, where it says nothing else.
    const MEASURES: &'static [Measure] = &[Measure::of_programs(
        "time_s",
        Unit::Second,
        MeasureSource::Time(Self::FORM.programs),
        t("Duración de los programas", "Time of the programs"),
    )];
    /// What a new workbook suggests to vary.
    const SUGGESTED: &'static Suggested = &Suggested::NOTHING;

    /// The part with the symbols of its form; `None` where there is nothing to draw.
    fn sketch() -> Option<Figure> {
        None
    }

    /// The design of checked values.
    ///
    /// # Errors
    /// Every contradiction between values.
    fn design(fields: &Fields) -> Result<Self::Design, Vec<Finding>>;

    /// The control that its programs are for.
    fn control(design: &Self::Design) -> &'static Control;

    /// The layout of its programs, for a kind that has several.
    fn style(_: &Self::Design) -> Option<Style> {
        None
    }

    /// What is worked out of a design.
    ///
    /// # Errors
    /// Where there is none.
    fn model(design: &Self::Design) -> Result<Self::Model, Vec<Finding>>;

    /// How a run ends that these findings stop.
    fn stopped(_: &[Finding]) -> Exit {
        Exit::Refused
    }

    /// What the form computes while it is being filled in.
    fn live() -> Option<LiveForm> {
        None
    }

    /// Programs line by line as a spreadsheet puts them together from the tables, where it can; they follow the tables.
    fn lines(_: &Self::Design, _: &Self::Model, _: &[Program]) -> Vec<Table> {
        Vec::new()
    }

    /// The tables, in the order of their sheets; that of the checks follows them.
    fn tables(design: &Self::Design, model: &Self::Model) -> Vec<Table>;

    /// The programs.
    ///
    /// # Errors
    /// For a position that no program may carry.
    fn programs(design: &Self::Design, model: &Self::Model, origin: &Origin<'_>) -> Result<Unproved, Vec<Finding>>;

    /// What the programs leave or spoil by their method, where that is searched along their ways: found together with the
    /// programs, but not of a design that is judged by its limits alone.
    fn shortfalls(_: &Self::Design, _: &Self::Model) -> Vec<Finding> {
        Vec::new()
    }

    /// What is known before the first program is judged.
    fn memo(design: &Self::Design, model: &Self::Model, wants: Wants) -> Self::Memo;

    /// Which cells, changed how, give a program fewer blocks.
    fn fewer(design: &Self::Design, program: &Program) -> Text;

    /// What a program is read with.
    fn setting(_: &Self::Design, program: &Program) -> Setting {
        program.setting()
    }

    /// How fast the machine of a program is where it does not cut, for the cycle time.
    fn rapids(_: &Self::Design, _: &Program) -> Rapids {
        Rapids::default()
    }

    /// What a program is meant to do, move by move: along its own paths, where it was written along any.
    fn plan<'a>(_: &'a Self::Design, _: &'a Self::Model, program: &'a Program) -> Plan<'a> {
        Plan::of(program)
    }

    /// Who judges a program, with what is known from those before it.
    fn judges<'a>(
        design: &'a Self::Design,
        model: &'a Self::Model,
        memo: &'a mut Self::Memo,
        program: &'a Program,
    ) -> Vec<Box<dyn Judge + 'a>>;

    /// What must be answered for a program; what nobody answers stops the work.
    fn due(design: &Self::Design, program: &Program) -> Vec<Due>;

    /// Derived limits, angles and lengths.
    fn quantities(design: &Self::Design, model: &Self::Model, programs: &[Proved]) -> Vec<Quantity>;

    /// What can be shown of the part, with what cuts it.
    fn part(_: &Self::Design, _: &Self::Model) -> Option<Part> {
        None
    }

    /// Bodies with files of their own, each of a key of [`Form::solids`].
    fn solids(_: &Self::Design, _: &Self::Model) -> Vec<Solid> {
        Vec::new()
    }

    /// Charts for the sheets.
    fn charts(_: &Self::Design, _: &Self::Model) -> Vec<Chart> {
        Vec::new()
    }

    /// Drawings at 1:1, mm, each with files of its own.
    fn drawings(_: &Self::Design, _: &Self::Model) -> Vec<Drawing> {
        Vec::new()
    }

    /// Values that its set-up sheet prints, and nothing else does.
    fn setup(_: &Self::Design, _: &Self::Model) -> Vec<(&'static str, Shown)> {
        Vec::new()
    }

    /// Figures of the report; made when they are first looked at.
    fn figures(_: &Self::Design, _: &Self::Model, _: &Self::Memo) -> Vec<Figure> {
        Vec::new()
    }
}

/// What comes of one program when `text` is read in the place of its own lines, with what is known from the programs before
/// it: `program` itself or, to see a judge at work, the same program with other lines.
pub fn judged<M: Method>(
    design: &M::Design,
    model: &M::Model,
    memo: &mut M::Memo,
    program: &Program,
    text: &Program,
) -> Judged {
    let (setting, plan) = (M::setting(design, program), M::plan(design, model, program));
    let judges = M::judges(design, model, memo, program);
    proof::of(text, setting, plan, judges, &M::due(design, program), M::ANSWERED, M::rapids(design, program))
}

/// True where the rates of rapid motions are known of a program, or where the rates of the form are not its machine's.
fn rated<M: Method>(design: &M::Design, program: &Program) -> bool {
    program.control.turns() || M::rapids(design, program).linear.is_some()
}

/// How a run ends that findings stop: as `otherwise`, unless one is a fault of code.
fn ended(findings: &[Finding], otherwise: Exit) -> Exit {
    if findings.iter().any(Finding::is_fault) { Exit::Fault } else { otherwise }
}

/// Refused where there is a fault.
fn faultless(fault: Option<Finding>) -> Result<(), Refusal> {
    fault.map_or(Ok(()), |fault| Err(Refusal::new(Exit::Fault, fault)))
}

/// The programs of a design, such as the form announces them. Their blocks have no numbers where those would exceed what the control reads, and that is told.
fn unproved<M: Method>(design: &M::Design, model: &M::Model, origin: &Origin<'_>) -> Result<Unproved, Vec<Finding>> {
    let mut unproved = M::programs(design, model, origin)?;
    let due = |program: &Program| M::due(design, program);
    let faults = faults::programs(M::FORM, M::control(design), &unproved.programs, due);
    if !faults.is_empty() {
        return Err(faults);
    }
    for program in &mut unproved.programs {
        let greatest = program.control.text.greatest_number;
        let last = program.blocks().saturating_mul(program.block_step.unwrap_or(0).into());
        if last > greatest.into() {
            program.block_step = None;
            let place = Place::Block { program: program.key, line: 1 };
            unproved.findings.push(NotNumbered { greatest }.at(place));
        }
    }
    Ok(unproved)
}

/// The kind of a method.
pub struct Of<M>(PhantomData<fn() -> M>);

impl<M> Of<M> {
    /// The kind.
    #[must_use]
    #[expect(
        clippy::new_without_default,
        reason = "there is one of each method, and it is named where kinds are listed"
    )]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<M: Method> Kind for Of<M> {
    fn form(&self) -> &'static Form {
        M::FORM
    }

    fn cases(&self) -> &'static [Case] {
        M::CASES
    }

    fn sketch(&self) -> Option<Figure> {
        M::sketch()
    }

    fn live(&self) -> Option<LiveForm> {
        M::live()
    }

    fn chapters(&self) -> &'static Chapters {
        M::CHAPTERS
    }

    fn rules(&self) -> &'static [&'static [&'static Rule]] {
        M::RULES
    }

    fn setting(&self, fields: &Fields, program: &Program) -> Option<Setting> {
        M::design(fields).ok().map(|design| M::setting(&design, program))
    }

    fn design(&self, fields: &Fields) -> Result<(), Vec<Finding>> {
        M::design(fields).map(drop)
    }

    fn measures(&self) -> &'static [Measure] {
        M::MEASURES
    }

    fn suggested(&self) -> &'static Suggested {
        M::SUGGESTED
    }

    fn judged_text(&self, fields: &Fields, key: &str, edited: &dyn Fn(&str) -> String) -> Option<Vec<Finding>> {
        let judge = || {
            let design = M::design(fields)?;
            let model = M::model(&design)?;
            let origin = Origin { workbook: "", sha256: "", version: "", language: fields.language() };
            let programs = unproved::<M>(&design, &model, &origin)?.programs;
            let Some(program) = programs.iter().find(|program| program.key == key) else { return Ok(None) };
            let lines = edited(&program.text());
            let text = Program {
                parts: lines.lines().map(|line| ProgramPart::Line(line.to_owned())).collect(),
                ..program.clone()
            };
            let (mut memo, mut verification) = (M::memo(&design, &model, Wants::default()), Verification::default());
            let judged = judged::<M>(&design, &model, &mut memo, program, &text);
            verification.add(&text, judged, M::fewer(&design, program));
            Ok(Some(verification.findings))
        };
        judge().unwrap_or_else(Some)
    }

    fn limits(&self, fields: &Fields) -> Result<Limits, Refusal> {
        let refused = |findings: Vec<Finding>| Refusal { exit: ended(&findings, Exit::Refused), findings };
        let design = M::design(fields).map_err(refused)?;
        let model = M::model(&design).map_err(refused)?;
        let origin = Origin { workbook: "", sha256: "", version: "", language: fields.language() };
        let Unproved { findings, .. } = unproved::<M>(&design, &model, &origin).map_err(refused)?;
        let quantities = M::quantities(&design, &model, &[]);
        faultless(faults::quantities(&quantities))?;
        Ok(Limits { quantities, findings })
    }

    fn run(&self, fields: Fields, found: Vec<Finding>, source: Provenance, wants: Wants) -> Result<Outcome, Refusal> {
        let refused = |findings: Vec<Finding>| Refusal {
            exit: ended(&findings, M::stopped(&findings)),
            findings: findings.into_iter().map(|finding| fields.locate(finding)).collect(),
        };
        let design = M::design(&fields).map_err(refused)?;
        let model = M::model(&design).map_err(refused)?;
        let mut tables = M::tables(&design, &model);
        faultless(faults::tables(&tables))?;
        let origin = Origin {
            workbook: &source.workbook,
            sha256: &source.sha256,
            version: source.version,
            language: fields.language(),
        };
        let Unproved { programs, mut findings } = unproved::<M>(&design, &model, &origin).map_err(refused)?;
        findings.extend(M::shortfalls(&design, &model));
        let (mut memo, mut verification) = (M::memo(&design, &model, wants), Verification::default());
        debug_assert!(
            fields.values().found(&RAPID_LINEAR).is_none() || programs.iter().any(|one| rated::<M>(&design, one)),
            "{} asks for rapid rates, and its Method::rapids gives none: the report would say that the form does not",
            M::FORM.kind
        );
        let mut accounts = Vec::new();
        for program in &programs {
            let judged = judged::<M>(&design, &model, &mut memo, program, program);
            accounts.push(judged.account.clone());
            verification.add(program, judged, M::fewer(&design, program));
        }
        let lines = M::lines(&design, &model, &programs);
        faultless(faults::tables(&lines))?;
        tables.extend(lines);
        tables.push(verification.table(&programs, M::PROVED));
        let proved = |(program, account): (Program, Account)| {
            let duration = account.cycle_seconds().map(|seconds| Duration { seconds, timeless: 0 });
            Proved { program, account, duration }
        };
        let programs: Vec<Proved> = programs.into_iter().zip(accounts).map(proved).collect();
        let quantities = M::quantities(&design, &model, &programs);
        faultless(faults::quantities(&quantities))?;
        findings.extend(verification.findings);
        let mut findings: Vec<Finding> = findings.into_iter().map(|finding| fields.locate(finding)).collect();
        findings.extend(found);
        gravest_first(&mut findings);
        let end = End::of(&findings, false);
        // Of what stops nothing is handed over, nor shown.
        let whole = end == End::Whole;
        let scene = (wants.scene && whole)
            .then(|| staging::scene(M::part(&design, &model), &programs, |one| M::setting(&design, one), &findings));
        let solids = M::solids(&design, &model);
        Ok(Outcome {
            named_files: Vec::new(),
            kind: const { &Self::new() },
            control: M::control(&design),
            style: M::style(&design),
            quantities,
            tables,
            programs: programs.into_iter().filter(|_| whole).collect(),
            charts: M::charts(&design, &model),
            drawings: M::drawings(&design, &model),
            setup: M::setup(&design, &model),
            figures: LazyLock::new(Box::new(move || M::figures(&design, &model, &memo))),
            solids,
            scene,
            checks: verification.checks,
            findings,
            end,
            fields,
            source,
        })
    }
}
