//! The command `build`: tables, programs, drawings and report of each workbook, all or nothing.

use std::env;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, LazyLock};

use super::args::{Build, Outputs};
use super::delivery::{self, Delivery, REPORT, SETUP, endings, leftovers, program_name};
use super::interrupt::{self, AtWork};
use super::into::{self, Into};
use super::locale::spoken;
use super::made::Made;
use super::plan::{self, Item};
use super::terminal::Terminal;
use super::verdict::Verdict;
use super::{BUILD, Sink, drawings, finding, opened, reading, refused, side_by_side, stationery};
use crate::escape::printable;
use crate::finding::{Exit, Finding, Refusal};
use crate::kind::{Kind, Outcome, Wants};
use crate::report::stationery::{Logo, Stationery, Template};
use crate::report::{self, Attachment, Content, Role};
use crate::store::{self, Existing, Folder, Set};
use crate::text::{Language, t};
use crate::typeset::compiler::Typst;
use crate::workbook;
use crate::workbook::results::Tables;

/// The variable that names a typst command line.
const TYPST: &str = "RODETE_TYPST";

/// What the command line asks of every workbook.
pub(super) struct BuildRequest<'a> {
    /// The workbooks: no output may replace one.
    pub(super) workbooks: &'a [PathBuf],
    /// The language of sheets and report, if not the workbook's.
    pub(super) language: Option<Language>,
    /// No report is set.
    pub(super) no_report: bool,
    /// The folder of typst files of one's own.
    pub(super) templates: Option<&'a Path>,
    /// The typst that sets the report.
    pub(super) typst: Option<&'a Path>,
    /// The results go into the workbook.
    pub(super) into: bool,
    /// The viewer's page is written for every kind, and refreshes itself.
    pub(super) view: bool,
    /// What the results hold.
    pub(super) tables: Tables,
}

impl<'a> From<&'a Outputs> for BuildRequest<'a> {
    fn from(outputs: &'a Outputs) -> Self {
        Self {
            workbooks: &outputs.workbooks,
            language: outputs.lang,
            no_report: outputs.no_report,
            templates: outputs.templates.as_deref(),
            typst: outputs.typst.as_deref(),
            into: false,
            view: false,
            tables: Tables::Live,
        }
    }
}

/// What all workbooks of one command share.
pub(super) struct Settings<'a> {
    /// The language of sheets and report, if not the workbook's.
    language: Option<Language>,
    /// What the results hold.
    tables: Tables,
    /// The typst that sets the report; `None`: no report.
    typst: Option<Typst>,
    /// The typst files of one's own, or why there is no report with them.
    templates: Result<Vec<Template>, Box<Finding>>,
    /// The results go into the workbook.
    into: bool,
    /// The folder of all outputs, if there is one.
    folder: Option<&'a Folder>,
    /// Every workbook named: no output may replace one.
    inputs: Vec<&'a Path>,
    /// The kinds of workbooks.
    kinds: &'a [&'a dyn Kind],
    /// The viewer's page is written for every kind, and refreshes itself.
    view: bool,
}

impl<'a> Settings<'a> {
    /// What is asked, over a folder of all outputs.
    pub(super) fn of(
        asked: &BuildRequest<'a>,
        folder: Option<&'a Folder>,
        kinds: &'a [&'a dyn Kind],
        interrupted: Arc<AtomicBool>,
    ) -> Self {
        Self {
            language: asked.language,
            typst: (!asked.no_report).then(|| typst(asked.typst.map(Path::to_owned), interrupted)),
            templates: asked.templates.map_or_else(|| Ok(Vec::new()), stationery::templates),
            into: asked.into,
            folder,
            inputs: asked.workbooks.iter().map(PathBuf::as_path).collect(),
            kinds,
            view: asked.view,
            tables: asked.tables,
        }
    }
}

/// What a report is set with.
struct Setter<'a> {
    /// What the office brings.
    stationery: Stationery<'a>,
    /// The language of the report.
    language: Language,
    /// The compiler.
    typst: &'a Typst,
}

/// Builds every workbook and prints what came of it.
pub(super) fn run(arguments: &Build, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let outputs = &arguments.outputs;
    let language = spoken(outputs.lang, None);
    let items = match plan::items(&outputs.workbooks, outputs.output.as_deref()) {
        Ok(items) => items,
        Err(refusal) => return refused(&refusal, of_workbooks(outputs, kinds), terminal),
    };
    let interrupted = interrupt::listen(language);
    let mut sink = Sink::new(BUILD, outputs.lang, arguments.json);
    let folder = match outputs.output.as_deref().map(Folder::open).transpose() {
        Ok(folder) => folder,
        Err(refusal) if arguments.json => {
            for item in &items {
                sink.take(reading::verdict(&item.workbook, |_| Err(refusal.clone())), terminal);
            }
            return sink.end(terminal);
        }
        Err(refusal) => return refused(&refusal, of_workbooks(outputs, kinds), terminal),
    };
    let tables = if arguments.values { Tables::Values } else { Tables::Live };
    let asked = BuildRequest { tables, into: arguments.into, ..BuildRequest::from(outputs) };
    let settings = Settings::of(&asked, folder.as_ref(), kinds, interrupted);
    let work = |item: &Item| made(item, &settings, &|| false).verdict;
    let mut to_open = Vec::new();
    side_by_side::run(&items, work, terminal, |verdict, terminal| {
        let path = opened::chosen(&verdict).filter(|_| arguments.open);
        to_open.extend(path.map(|path| (verdict.workbook.clone(), path)));
        sink.take(verdict, terminal);
    });
    to_open.dedup_by(|(_, one), (_, other)| one == other);
    let mut told = Vec::new();
    for (workbook, path) in &to_open {
        let Some(finding) = opened::open(path) else { continue };
        sink.add(workbook, &finding);
        told.push(finding);
    }
    let exit = sink.end(terminal);
    finding::general(&told, language, terminal);
    exit
}

/// The language of what is said before any workbook is read: that of the first one that tells.
fn of_workbooks(outputs: &Outputs, kinds: &[&dyn Kind]) -> Language {
    let forms: Vec<_> = kinds.iter().map(|kind| kind.form()).collect();
    let of = |path: &PathBuf| workbook::language(&workbook::open(path).ok()?, &forms);
    spoken(outputs.lang, outputs.lang.or_else(|| outputs.workbooks.iter().find_map(of)))
}

/// The typst that was asked for: on the command line, in the environment, else the one inside rodete, or an installed
/// one where rodete was built without.
#[expect(clippy::disallowed_methods, reason = "the door to the environment: the compiler that is asked for")]
pub(super) fn typst(named: Option<PathBuf>, interrupted: Arc<AtomicBool>) -> Typst {
    let named = named.or_else(|| env::var_os(TYPST).filter(|path| !path.is_empty()).map(PathBuf::from));
    // It is started in a folder of its own: a path is seen from here. A mere name is looked up as a command.
    let named = named.map(|program| match program.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => std::path::absolute(&program).unwrap_or(program),
        _ => program,
    });
    let typst = match (named, env::current_exe()) {
        (Some(program), _) => Typst::installed(program),
        (None, Ok(rodete)) if cfg!(feature = "embedded-typst") => Typst::embedded(rodete),
        (None, _) => Typst::installed("typst"),
    };
    typst.with_interrupt(interrupted)
}

/// Builds one workbook. `overtaken` says whether it was saved again meanwhile: then nothing is written.
pub(super) fn made(item: &Item, settings: &Settings<'_>, overtaken: &dyn Fn() -> bool) -> Made {
    let mut made = Made::default();
    let verdict = reading::verdict(&item.workbook, |verdict| build(item, settings, overtaken, &mut made, verdict));
    Made { verdict, ..made }
}

fn build(
    item: &Item,
    settings: &Settings<'_>,
    overtaken: &dyn Fn() -> bool,
    made: &mut Made,
    verdict: &mut Verdict,
) -> Result<(), Refusal> {
    if settings.into {
        // What a killed run left may be the workbook itself: before it is read.
        verdict.findings.extend(into::settled(item)?);
    }
    let (bytes, filled) = reading::read(&item.workbook, settings.kinds, verdict)?;
    made.read(&filled);
    let into = if settings.into { Some(Into::open(item, &bytes, &filled, &settings.inputs)?) } else { None };
    let own = if settings.folder.is_none() { Some(Folder::open(&item.folder)?) } else { None };
    let Some(folder) = settings.folder.or(own.as_ref()) else { return Ok(()) };
    verdict.findings.extend(folder.settled().cloned());
    let mut set = Set::new(folder, &settings.inputs, Existing::Replace);
    for ending in endings(settings.kinds) {
        set.check(&store::file_name(&item.stem, &ending))?;
    }
    let language = settings.language.unwrap_or(filled.values.language);
    let wants = Wants { scene: filled.form.viewer || settings.view, ..Wants::default() };
    let verified = filled.named_files.clone();
    let outcome = made.outcome.insert(reading::compute(&item.workbook, filled, settings.kinds, wants, verdict)?);
    made.overtaken = overtaken();
    if made.overtaken || outcome.stopped() {
        return Ok(());
    }
    let notes = into.as_ref().map(|into| into.notes().to_vec()).unwrap_or_default();
    verdict.findings.extend(notes);
    let scene = outcome.scene.take().transpose()?;
    let logo = match stationery::logo(&item.workbook, outcome.fields.values(), &verified) {
        Ok(Some((logo, file))) => {
            outcome.named_files.push(file);
            Some(logo)
        }
        Err(caution) if settings.typst.is_some() => {
            verdict.findings.push((*caution).clone());
            outcome.told(*caution);
            None
        }
        _ => None,
    };
    let (printed, viewer) = (settings.typst.is_some(), scene.is_some());
    let outcome = &*outcome;
    let (tables, live) = (settings.tables, settings.view);
    let delivery = Delivery { item, outcome, language, tables, printed, viewer, live, into: into.is_some() };
    // The figures of the report, which take as long as the results, beside them.
    let draw = || {
        if printed {
            LazyLock::force(&outcome.figures);
        }
    };
    let (written, ()) = rayon::join(|| delivery.write(scene, &mut set), draw);
    written?;
    let failed = print(&delivery, &bytes, settings, logo, &mut set, verdict)?;
    if let Some(into) = into {
        into.put(outcome, &delivery.listed(&set), settings.tables, language, &mut set)?;
    }
    made.overtaken = overtaken();
    if made.overtaken {
        return Ok(());
    }
    verdict.files = set.commit()?;
    verdict.folder = Some(item.folder.clone());
    verdict.findings.extend(leftovers(item, settings.kinds, verdict));
    if !failed.is_empty() {
        verdict.refuse(Refusal { exit: Exit::ReportFailed, findings: failed });
    }
    Ok(())
}

/// Adds drawings, report and set-up sheet to the set, where they are asked for, and lists anew what is delivered where any of them fails; gives the
/// findings of those that fail, which keep nothing else from being delivered.
fn print(
    delivery: &Delivery<'_>,
    bytes: &[u8],
    settings: &Settings<'_>,
    logo: Option<Logo>,
    set: &mut Set<'_>,
    verdict: &mut Verdict,
) -> Result<Vec<Finding>, Refusal> {
    let Some(typst) = &settings.typst else { return Ok(Vec::new()) };
    let Delivery { item, outcome, language, .. } = *delivery;
    let at_work = AtWork::begin();
    let mut failed = drawings::print(item, outcome, language, typst, set)?;
    drop(at_work);
    // The report tells the sum of the results: what these list must be settled before.
    if !failed.is_empty() {
        delivery.list_again(&[SETUP, REPORT], set)?;
    }
    let unset = match &settings.templates {
        Ok(templates) => {
            let setter = Setter { stationery: Stationery { logo, templates }, language, typst };
            typeset(item, bytes, outcome, &setter, set, verdict)?
        }
        Err(refused) => Some((**refused).clone()),
    };
    if unset.is_some() {
        delivery.list_again(&[], set)?;
    }
    failed.extend(unset);
    Ok(failed)
}

/// Adds report and set-up sheet to the set; gives the finding where it fails, which keeps nothing else from being delivered.
///
/// # Errors
/// Exit 5 where one cannot be written.
fn typeset(
    item: &Item,
    workbook: &[u8],
    outcome: &Outcome,
    setter: &Setter<'_>,
    set: &mut Set<'_>,
    verdict: &mut Verdict,
) -> Result<Option<Finding>, Refusal> {
    let input = Attachment {
        name: outcome.source.workbook.clone(),
        role: Role::Input,
        mime: "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
        description: t("Libro de datos", "Workbook"),
        content: Content::Bytes(workbook),
    };
    let programs = outcome.programs.iter().filter_map(|program| {
        let name = program_name(item, program);
        Some(Attachment {
            role: Role::Program(program.key),
            mime: "text/plain",
            description: program.title.clone(),
            content: Content::File(set.draft(&name)?),
            name: printable(&name.to_string_lossy()),
        })
    });
    let attachments: Vec<_> = std::iter::once(input)
        .chain(programs)
        .chain(drawings::attachments(item, outcome, set))
        .chain(delivery::attachments(item, outcome.fields.form(), set))
        .collect();
    let at_work = AtWork::begin();
    let report = report::typeset(outcome, &attachments, &setter.stationery, setter.language, setter.typst);
    drop(at_work);
    match report {
        Ok(report) => {
            verdict.findings.extend(report.findings);
            let name = store::file_name(&item.stem, REPORT);
            set.write(&name, |out| out.write_all(&report.pdf))?;
            let name = store::file_name(&item.stem, SETUP);
            set.write(&name, |out| out.write_all(&report.setup))?;
            Ok(None)
        }
        Err(failure) => Ok(Some(failure.finding())),
    }
}
