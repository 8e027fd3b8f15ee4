//! The command `sweep`: every design of a plan, on this machine, chunk by chunk, or on a cluster.

pub(super) mod args;
mod folder;
mod merge;
mod progress;
mod record;
mod slurm;
mod top;
mod work;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use self::args::Sweep;
use self::folder::{Opening, Rows};
use self::work::Workshop;
use super::interrupt;
use super::locale::spoken;
use super::plan::beside;
use super::terminal::Terminal;
use super::verdict::Verdict;
use super::{fault, finding, reading, refused};
use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::kind::Kind;
use crate::limits::{ASKED_CHUNKS, SWEEP_CHUNKS};
use crate::number::duration;
use crate::parameter::Values;
use crate::parameter::field::Fields;
use crate::store;
use crate::sweep::asked;
use crate::sweep::form::NAME;
use crate::sweep::plan::Plan;
use crate::sweep::rules::{NoSweepSheet, WrongChunk};
use crate::sweep::sensitivity::most;
use crate::sweep::table::ID;
use crate::text::{Language, Text, t};
use crate::workbook::sweep_sheet;

/// Designs of a chunk, where nothing else is asked for.
const CHUNK: u64 = 1000;

/// A workbook with its plan.
pub(super) struct Study<'a> {
    workbook: &'a Path,
    kind: &'a dyn Kind,
    /// The SHA-256 of its bytes.
    sha256: String,
    /// Its values, with their cells.
    values: Values,
    /// Its values without cells, as every design begins with them.
    base: Values,
    plan: Plan,
    /// What the plan says, for files and for comparison.
    told: String,
    /// What a person should know before.
    notes: Vec<Finding>,
    /// The language of results.
    language: Language,
}

/// Works out what is asked for, and prints what came of it.
pub(super) fn run(arguments: &Sweep, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    static INTERRUPTED: Text = t(
        "interrumpido: repita el mismo comando y sigue donde estaba",
        "interrupted: run the same command again to go on",
    );
    let interrupted = interrupt::listen_saying(INTERRUPTED.get(spoken(arguments.lang, None)));
    let chunk = match arguments.chunk.as_deref().map(chunk_of).transpose() {
        Ok(chunk) => chunk,
        Err(refusal) => return refused(&refusal, spoken(arguments.lang, None), terminal),
    };
    let study = match study(arguments, kinds) {
        Ok(study) => study,
        Err((refusal, language)) => {
            let language = spoken(arguments.lang, language);
            let name = printable_path(&arguments.workbook);
            finding::faults(&refusal.findings, &name, language, terminal);
            return refusal.exit;
        }
    };
    let name = printable_path(&arguments.workbook);
    finding::faults(&study.notes, &name, study.language, terminal);
    let done = if arguments.dry_run {
        forecast(arguments, &study, terminal)
    } else {
        all(arguments, &study, chunk, kinds, &interrupted, terminal)
    };
    done.unwrap_or_else(|refusal| refused(&refusal, study.language, terminal))
}

/// The workbook and its plan.
///
/// # Errors
/// Everything that is wrong with the workbook, with its language where that is known.
fn study<'a>(arguments: &'a Sweep, kinds: &[&'a dyn Kind]) -> Result<Study<'a>, (Refusal, Option<Language>)> {
    let path = arguments.workbook.as_path();
    let unread = |refusal| (refusal, None);
    reading::settled([beside(path)]).map_err(unread)?;
    let mut verdict = Verdict::new(path.to_owned());
    let (bytes, filled) = reading::read(path, kinds, &mut verdict).map_err(|refusal| (refusal, verdict.language))?;
    let language = Some(filled.values.language);
    let wrong = |refusal| (refusal, language);
    let Some(kind) = kinds.iter().find(|kind| kind.form().schema == filled.form.schema) else {
        return Err(wrong(fault::refusal("a form without a kind")));
    };
    let sheet = sweep_sheet::read(&bytes, filled.form, filled.values.language).map_err(wrong)?;
    let Some(sheet) = sheet else {
        return Err(wrong(NoSweepSheet { sheet: NAME }.refused(Exit::Refused, Place::File)));
    };
    let (plan, notes) = asked::plan(*kind, &sheet.fields, sheet.designs)
        .map_err(|findings| wrong(Refusal { exit: Exit::Refused, findings }))?;
    let plan = plan.limited(arguments.limit);
    // What the workbook says is whole, though the values that vary come from the plan.
    Fields::of(filled.form, filled.values.clone()).map_err(wrong)?;
    let sha256 = store::sha256(&bytes);
    let mut base = filled.values.clone();
    base.cells.clear();
    let sum = store::sha256(format!("{:?}", (&base.values, &base.lists)).as_bytes());
    let told = plan.told(&sha256, &sum, env!("CARGO_PKG_VERSION")).to_string();
    Ok(Study {
        workbook: path,
        kind: *kind,
        sha256,
        values: filled.values,
        base,
        plan,
        told,
        notes: sheet.findings.into_iter().chain(notes).collect(),
        language: arguments.lang.or(language).unwrap_or_default(),
    })
}

/// How many designs there are, and how long all would take.
fn forecast(arguments: &Sweep, study: &Study<'_>, terminal: &mut Terminal) -> Result<Exit, Refusal> {
    let workshop = Workshop::open(study, arguments.jobs)?;
    let tried = workshop.tried()?;
    let plan = &study.plan;
    let jobs = workshop.jobs();
    let chunks = arguments.chunks.unwrap_or_else(|| slurm::chunks(plan.count, tried.mean()));
    let axes: String = plan
        .inputs
        .iter()
        .map(|one| {
            let levels = one.levels.count().map_or_else(|| "…".to_owned(), |count| count.to_string());
            format!("  {} ({levels})\n", one.symbol())
        })
        .collect();
    let each = format!("{:.1}", tried.mean() * 1000.0);
    let range = |jobs: u64| {
        let [least, most] = tried.range().map(|one| duration(one * count(plan.count) / count(jobs)));
        let same = least == most;
        let range = Text::new(format!("{least} a {most}"), format!("{least} to {most}"));
        if same { least } else { range.get(study.language).to_owned() }
    };
    let (core, here) = (range(1), range(jobs));
    // They are worked out one input beside the other, each in one row.
    let looks = most(&study.base, plan);
    let beside = 1 + looks.iter().sum::<u64>();
    let in_a_row = (beside.div_ceil(jobs)).max(looks.iter().copied().max().unwrap_or(0));
    let sensitivities = duration(workshop.own()? * count(in_a_row));
    let (all, refused, inputs) = (tried.count(), tried.refused, plan.inputs.len());
    let unknown = if tried.judged > 0 {
        t("", "")
    } else {
        t(
            "rodete rechaza todos los probados: no se sabe cuánto tarda uno que no lo sea\n",
            "rodete refused all that were tried: how long one takes that is not refused is not known\n",
        )
    };
    let text = Text::new(
        format!(
            "{} diseños, {inputs} entradas:\n{axes}{all} probados, {refused} rechazados: {each} ms por diseño y núcleo\n{}{core} en un núcleo, {here} con --jobs {jobs}; trozos para Slurm: {chunks}\ndespués, para las sensibilidades, {beside} diseños como mucho: {sensitivities} con --jobs {jobs}\n",
            plan.count, unknown.es
        ),
        format!(
            "{} designs, {inputs} inputs:\n{axes}{all} tried, {refused} refused: {each} ms a design and core\n{}{core} on one core, {here} with --jobs {jobs}; chunks for Slurm: {chunks}\nthen, for the sensitivities, at most {beside} designs: {sensitivities} with --jobs {jobs}\n",
            plan.count, unknown.en
        ),
    );
    terminal.out(text.get(study.language));
    Ok(Exit::Done)
}

/// Works out what is asked for: one chunk, what is to be submitted, or all that is missing and the merge.
fn all(
    arguments: &Sweep,
    study: &Study<'_>,
    chunk: Option<(u64, u64)>,
    kinds: &[&dyn Kind],
    interrupted: &Arc<AtomicBool>,
    terminal: &mut Terminal,
) -> Result<Exit, Refusal> {
    let folder = arguments
        .output
        .clone()
        .unwrap_or_else(|| beside(study.workbook).join(store::file_name(&store::stem(study.workbook), "-sweep")));
    let wanted = chunk.map(|(_, of)| of).or(arguments.chunks);
    let usual = || match &arguments.submit {
        Some(_) => Ok(slurm::chunks(study.plan.count, Workshop::open(study, arguments.jobs)?.tried()?.mean())),
        None => Ok(study.plan.count.div_ceil(CHUNK).clamp(1, SWEEP_CHUNKS)),
    };
    let opening = match (arguments.fresh, arguments.merge) {
        (true, _) => Opening::Anew,
        (false, false) => Opening::GoOn,
        (false, true) => Opening::Merge,
    };
    let rows = Rows::open(&folder, study, wanted, usual, opening)?;
    if chunk.is_none() {
        // Hours before they are written.
        merge::free(arguments, study, rows.place())?;
    }
    if let Some((number, _)) = chunk {
        let workshop = Workshop::open(study, arguments.jobs)?;
        let mut progress = progress::Progress::new(study, study.plan.chunk(number, rows.chunks()));
        let worked = workshop.chunk(&rows, number, &mut progress, terminal);
        progress.end(terminal);
        return worked.map(|()| Exit::Done);
    }
    if arguments.submit.is_some() {
        return slurm::submit(arguments, study, &folder, &rows, terminal);
    }
    if !arguments.merge {
        let workshop = Workshop::open(study, arguments.jobs)?;
        let mut progress = progress::Progress::new(study, 0..study.plan.count);
        let worked = (0..rows.chunks()).try_for_each(|number| workshop.chunk(&rows, number, &mut progress, terminal));
        progress.end(terminal);
        worked?;
    }
    // Whether all their columns can be read is seen when they are merged.
    if !rows.missing(&|name| name == ID).is_empty() {
        return Err(rows.lacking());
    }
    merge::merge(arguments, study, kinds, &rows, interrupted, terminal)
}

/// The chunk that an option asks for.
///
/// # Errors
/// Exit 2 where it asks for none.
fn chunk_of(text: &str) -> Result<(u64, u64), Refusal> {
    let parts = text.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
    parts
        .filter(|(number, of): &(u64, u64)| number < of && *of <= ASKED_CHUNKS)
        .ok_or_else(|| WrongChunk { text: printable(text) }.refused(Exit::CommandLine, Place::File))
}

/// Numbers in order as an array of jobs takes them: `3,17,20-22`.
fn ranges(numbers: &[u64]) -> String {
    let runs = numbers.chunk_by(|one, next| one + 1 == *next);
    let told = runs.filter_map(|run| match (run.first()?, run.last()?) {
        (first, last) if first == last => Some(first.to_string()),
        (first, last) => Some(format!("{first}-{last}")),
    });
    told.collect::<Vec<_>>().join(",")
}

/// A count as a factor.
#[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
fn count(number: u64) -> f64 {
    number as f64
}

/// A path that does not depend on the current folder.
fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_are_counted_from_nought() {
        assert_eq!(chunk_of("0/40").ok(), Some((0, 40)));
        assert_eq!(chunk_of("39/40").ok(), Some((39, 40)));
        for wrong in ["40/40", "1", "a/3", "0/0", "-1/3", "1/2/3", "0/100001"] {
            assert_eq!(chunk_of(wrong).expect_err(wrong).exit, Exit::CommandLine);
        }
    }

    #[test]
    fn missing_chunks_are_listed_as_an_array() {
        assert_eq!(ranges(&[3, 17, 20, 21, 22]), "3,17,20-22");
        assert_eq!((ranges(&[]), ranges(&[0, 1])), (String::new(), "0-1".to_owned()));
    }
}
