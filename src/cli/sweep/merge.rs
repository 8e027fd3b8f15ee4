//! All rows of a plan in one file, which of them are the best, and the best as workbooks.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::super::build;
use super::super::interrupt::AtWork;
use super::super::terminal::Terminal;
use super::super::{fault, finding, stationery};
use super::Study;
use super::args::Sweep;
use super::folder::Rows;
use super::progress;
use super::record::{self, Record};
use super::slurm::SCRIPT;
use super::top::{build_top, judged_whole, rejected};
use super::work::Workshop;
use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Finding, Grade, Place, Raise, Refusal, Rule};
use crate::kind::Kind;
use crate::limits::SWEEP_ROWS;
use crate::number::{decimal, shown};
use crate::parameter::Values;
use crate::report;
use crate::report::sweep::Titled;
use crate::store::{self, Existing, Folder, Set};
use crate::sweep::csv;
use crate::sweep::file::RowFile;
use crate::sweep::indices::Indices;
use crate::sweep::plan::Plan;
use crate::sweep::ranking::{Ranked, Ranking, Reason};
use crate::sweep::results::{Built, Coded, Results};
use crate::sweep::row::{of_design, says, told};
use crate::sweep::rules::{NamesInCase, NoneDone, RejectedWhole};
use crate::sweep::sensitivity::{Shares, around, most};
use crate::sweep::table::{CODES, Cells, Column, FEASIBLE, FRONT, ID, MARGIN, REASON, STATE, Table, VALUE};
use crate::text::{Language, Text, t};
use crate::workbook::sweep_book::SweepBook;

/// Takes in all chunks, one after another: what the designs come to, and what there is to know of the inputs, shares or, of a plan
/// for them, Sobol's indices.
fn take_in<'a>(plan: &'a Plan, rows: &Rows<'_>) -> Result<(Ranked, Shares<'a>, Option<Indices<'a>>), Refusal> {
    let kept = usize::try_from(SWEEP_ROWS).unwrap_or(usize::MAX);
    let (mut ranking, mut shares) = (Ranking::new(plan, kept), Shares::new(plan));
    let mut indices = Indices::new(plan);
    let needed = |name: &str| {
        [ID, STATE, FEASIBLE, REASON, VALUE, MARGIN].contains(&name)
            || plan.objectives.iter().any(|one| one.measure.key == name)
    };
    for number in 0..rows.chunks() {
        let part = read(rows, number, &needed)?;
        ranking.take(&part);
        match &mut indices {
            Some(indices) => indices.take(&part),
            None => shares.take(&part),
        }
    }
    Ok((ranking.end(), shares, indices))
}

/// The designs that were tried, of those of the whole plan.
fn tried(count: u64, whole: u64) -> Text {
    match (count, count == whole) {
        (1, true) => t("el único diseño del plan", "the only design of the plan"),
        (_, true) => Text::new(format!("los {count} diseños del plan"), format!("all {count} designs of the plan")),
        (1, false) => Text::new(
            format!("el único diseño probado, de los {whole} del plan"),
            format!("the only design tried, of the {whole} of the plan"),
        ),
        (_, false) => Text::new(
            format!("los {count} diseños probados, de los {whole} del plan"),
            format!("all {count} designs tried, of the {whole} of the plan"),
        ),
    }
}

const SUMMARY: &str = "summary.parquet";
const LISTED: &str = "summary.csv";
const BOOK: &str = "-sweep.xlsx";
const REPORT: &str = "-sweep.pdf";

/// Checks that nothing stands in the folder that would be replaced and is not what a sweep wrote.
///
/// # Errors
/// Exit 5 with the first file that is.
pub(super) fn free(arguments: &Sweep, study: &Study<'_>, place: &Path) -> Result<(), Refusal> {
    let record = Record::open(place);
    let stem = store::stem(study.workbook);
    let of_stem = |end: &str| store::file_name(&stem, end).to_string_lossy().into_owned();
    let mut names = vec![SUMMARY.to_owned(), of_stem(BOOK)];
    names.extend(arguments.csv.then(|| LISTED.to_owned()));
    names.extend(arguments.report.then(|| of_stem(REPORT)));
    names.extend(arguments.submit.is_some().then(|| SCRIPT.to_owned()));
    names.iter().try_for_each(|name| record.check(name))?;
    if arguments.top == 0 { Ok(()) } else { record.check_known("top/") }
}

/// Makes summary, workbook, report and best designs from the chunks, which are all there.
pub(super) fn merge(
    arguments: &Sweep,
    study: &Study<'_>,
    kinds: &[&dyn Kind],
    rows: &Rows<'_>,
    interrupted: &Arc<AtomicBool>,
    terminal: &mut Terminal,
) -> Result<Exit, Refusal> {
    let Study { plan, language, .. } = study;
    let (ranked, shares, indices) = take_in(plan, rows)?;
    let (top, built) = (ranked.top(usize::from(arguments.top)), ranked.built(usize::from(arguments.top)));
    let folder = Folder::open(rows.place())?;
    let stem = store::stem(study.workbook);
    let (all, mut best) = summary(arguments, study, rows, (&ranked, &top), &folder)?;
    let built = build_top(study, kinds, rows, (&top, &built))?;
    judged_whole(&mut best, &built);
    let workshop = Workshop::open(study, arguments.jobs)?;
    let done = AtomicU64::new(0);
    let judge = |values: &Values| {
        let row = workshop.beside(values);
        done.fetch_add(1, Ordering::Relaxed);
        row
    };
    let work = || workshop.side_by_side(|| around(study.kind, &study.base, plan, &judge));
    let mut effects =
        progress::waiting(work, (&done, 1 + most(&study.base, plan).iter().sum::<u64>()), *language, terminal);
    match &indices {
        Some(indices) => effects.iter_mut().zip(indices.end()).for_each(|(effect, of)| effect.indices = of),
        None => effects.iter_mut().zip(shares.end()).for_each(|(effect, of)| effect.shares = of),
    }
    let rules = super::super::explain::rows(kinds);
    let source = printable(&study.workbook.file_name().unwrap_or_default().to_string_lossy());
    let results = Results {
        kind: study.kind,
        plan,
        source: &source,
        top: &best,
        all: &all,
        counts: ranked.counts,
        front: ranked.front.len(),
        built: &built,
        rejected: &rejected(&top, &built),
        cut: ranked.cut,
        why: &coded(ranked.why.iter().cloned(), study, &rules),
        cautions: &cautions(&best, &built, study, &rules),
        effects: &effects,
        triples: indices.map(|one| one.triples()),
    };
    let mut names = vec![store::file_name(&stem, BOOK)];
    write_book(study, &results, (&folder, rows.place()), &names[0])?;
    let mut failed = None;
    if arguments.report {
        let name = store::file_name(&stem, REPORT);
        match write_report(study, &results, interrupted, (&folder, rows.place()), &name, terminal)? {
            None => names.push(name),
            failure => failed = failure,
        }
    }
    let book = rows.place().join(&names[0]);
    remarks(&results, &book, [ranked.told(), failed.clone()], *language, terminal);
    if ranked.counts.done == 0 {
        let code = ranked.why.first().map_or_else(String::new, |first| first.code.clone());
        let path = printable_path(&book);
        let (designs, count) = (tried(plan.count, plan.whole), plan.count);
        return Err(NoneDone { designs, count, code, path }.refused(Exit::Refused, Place::File));
    }
    let names: Vec<_> = names.iter().map(|name| printable(&name.to_string_lossy())).collect();
    let folder = printable_path(rows.place());
    terminal.out(&format!("{}\n{folder}: summary.parquet, {}\n", results.counted().get(*language), names.join(", ")));
    Ok(if failed.is_some() { Exit::ReportFailed } else { Exit::Done })
}

/// Says what is to be known of the results, whose workbook is `book`: of a front that is cut, too, and of a report that failed.
fn remarks(
    results: &Results<'_>,
    book: &Path,
    [cut, failed]: [Option<Finding>; 2],
    language: Language,
    terminal: &mut Terminal,
) {
    finding::general(&in_case(results.all), language, terminal);
    if let Some(cut) = cut {
        finding::general(&[cut], language, terminal);
    }
    if let (Some(first), (built, rejected)) = (results.rejected.first(), results.tried()) {
        let path = printable_path(book);
        let caution = RejectedWhole { rejected, built, code: first.code.clone(), path }.at(Place::File);
        finding::general(&[caution], language, terminal);
    }
    if let Some(failed) = failed {
        finding::general(&[failed], language, terminal);
    }
}

/// What a person should know of columns whose names differ in their capitals only: to DuckDB each is one with the first of them.
fn in_case(rows: &Table) -> Vec<Finding> {
    let named = |one: &str, other: &str| one != other && one.to_lowercase() == other.to_lowercase();
    let columns = rows.columns.iter().enumerate();
    let pairs = columns.filter_map(|(at, column)| {
        let first = rows.columns[..at].iter().find(|first| named(&first.name, &column.name))?;
        let (one, other) = (first.name.clone(), column.name.clone());
        Some(NamesInCase { renamed: format!("{other}_1"), one, other }.at(Place::File))
    });
    pairs.collect()
}

fn read(rows: &Rows<'_>, number: u64, wanted: &dyn Fn(&str) -> bool) -> Result<Table, Refusal> {
    rows.read(number, wanted).ok().flatten().ok_or_else(|| rows.lacking())
}

/// Writes all rows in the order of the plan, with the mark of the front; gives those of the sheet of all, and the top in its order.
fn summary(
    arguments: &Sweep,
    study: &Study<'_>,
    rows: &Rows<'_>,
    (ranked, top): (&Ranked, &[u64]),
    folder: &Folder,
) -> Result<(Table, Table), Refusal> {
    let on_front: BTreeSet<u64> = ranked.front.iter().map(|one| one.id).collect();
    let shown: BTreeSet<u64> = top.iter().copied().collect();
    let listed: Option<BTreeSet<u64>> = (study.plan.count > SWEEP_ROWS)
        .then(|| ranked.best.iter().map(|one| one.id).chain(on_front.iter().copied()).collect());
    let marked = |mut part: Table| {
        let ids: Vec<u64> = part.ids().collect();
        let marks = Cells::Truth(ids.iter().map(|id| Some(on_front.contains(id))).collect());
        part.columns.push(Column { name: FRONT.to_owned(), unit: "", cells: marks });
        (part, ids)
    };
    let (empty, _) = marked(rows.table().emptied());
    let (mut all, mut best) = (empty.emptied(), empty.emptied());
    let mut set = Set::new(folder, &[study.workbook], Existing::Replace);
    let mut broken = None;
    let mut take = |number: u64| match read(rows, number, &|_| true) {
        Ok(part) => Some(marked(part)),
        Err(refusal) => {
            broken = Some(refusal);
            None
        }
    };
    set.write(OsStr::new(SUMMARY), |out| {
        let mut file = RowFile::new(out, &empty, rows.told())?;
        for (part, ids) in (0..rows.chunks()).map_while(&mut take) {
            let pick = |wanted: &dyn Fn(&u64) -> bool| part.picked(&ids.iter().map(wanted).collect::<Vec<_>>());
            all.append(listed.as_ref().map_or_else(|| part.clone(), |listed| pick(&|id| listed.contains(id))));
            best.append(pick(&|id| shown.contains(id)));
            file.write(part)?;
        }
        file.end()
    })?;
    if arguments.csv {
        set.write(OsStr::new(LISTED), |out| {
            out.write_all(csv::head(&empty).as_bytes())?;
            for (part, _) in (0..rows.chunks()).map_while(&mut take) {
                out.write_all(csv::rows(&part).as_bytes())?;
            }
            Ok::<(), std::io::Error>(())
        })?;
    }
    if let Some(refusal) = broken {
        return Err(refusal);
    }
    record::commit(set, folder, rows.place())?;
    // In the order of the top.
    let places: BTreeMap<u64, usize> = best.ids().zip(0..).collect();
    let order: Vec<usize> = top.iter().filter_map(|id| places.get(id).copied()).collect();
    Ok((all, best.ordered(&order)))
}

/// Reasons with how many designs have each, and what each says of the first design with it: that an objective has no value, by how much a
/// constraint is broken, or what it is told.
fn coded(reasons: impl IntoIterator<Item = Reason>, study: &Study<'_>, rules: &[&Rule]) -> Vec<Coded> {
    let plan = &study.plan;
    let what = |Reason { code, first, value, margin, .. }: &Reason| {
        let code = code.as_str();
        if let Some(objective) = plan.objectives.iter().find(|one| one.to_string() == code) {
            of_design(*first, &unvalued(objective.measure.key))
        } else if let Some(constraint) = plan.constraints.iter().find(|one| one.to_string() == code) {
            let key = constraint.measure.key;
            let unit = constraint.measure.unit.label();
            let sized = |value: f64| format!("{} {unit}", short(value)).trim_end().to_owned();
            let told = value.zip(*margin).map_or_else(
                || unvalued(key),
                |(value, margin)| {
                    let (value, by) = (sized(value), sized(-margin));
                    Text::new(
                        format!("{key} es {value}; incumple {code} por {by}"),
                        format!("{key} is {value}; it breaks {code} by {by}"),
                    )
                },
            );
            of_design(*first, &told)
        } else {
            match fault::guarded(|| told(study.kind, &study.base, plan, *first, code)) {
                Ok(Some(what)) => of_design(*first, &what),
                _ => rules.iter().find(|rule| rule.code == code).map_or(t("", ""), |rule| rule.unfilled_what()),
            }
        }
    };
    reasons.into_iter().map(|one| Coded { what: what(&one), code: one.code, count: one.count }).collect()
}

/// The cautions of the best designs, most first. Of those that were built whole each says what the build found.
fn cautions(top: &Table, built: &[Option<Built>], study: &Study<'_>, rules: &[&Rule]) -> Vec<Coded> {
    let mut counts: BTreeMap<&str, Reason> = BTreeMap::new();
    let mut whole: BTreeMap<&str, Text> = BTreeMap::new();
    let codes = top.column(CODES);
    for (row, (id, built)) in top.ids().zip(built).enumerate() {
        let mut of_row: BTreeSet<&str> = BTreeSet::new();
        match built {
            Some(built) => {
                for found in built.findings.iter().filter(|one| one.grade == Grade::Caution) {
                    whole.entry(found.code()).or_insert_with(|| says(id, found));
                    of_row.insert(found.code());
                }
            }
            None => of_row.extend(codes.and_then(|codes| codes.text(row)).unwrap_or_default().split(';')),
        }
        for code in of_row.into_iter().filter(|code| !code.is_empty()) {
            let first = || Reason { code: code.to_owned(), count: 0, first: id, value: None, margin: None };
            counts.entry(code).or_insert_with(first).count += 1;
        }
    }
    let mut counts: Vec<Reason> = counts.into_values().collect();
    counts.sort_by(|one, other| other.count.cmp(&one.count).then_with(|| one.code.cmp(&other.code)));
    let coded = coded(counts, study, rules).into_iter();
    coded.map(|one| whole.remove(one.code.as_str()).map_or(one.clone(), |what| Coded { what, ..one })).collect()
}

/// What is said of a design that has no value of what is asked for.
fn unvalued(key: &str) -> Text {
    Text::new(format!("no tiene valor de {key}"), format!("it has no value of {key}"))
}

/// A number to the fourth decimal; a smaller one to three significant digits.
fn short(value: f64) -> String {
    match shown(value, 4) {
        zero if zero == "0" => format!("{value:.2e}").parse().map_or_else(|_| decimal(value), decimal),
        text => text,
    }
}

fn write_book(
    study: &Study<'_>,
    results: &Results<'_>,
    (folder, place): (&Folder, &Path),
    name: &OsStr,
) -> Result<(), Refusal> {
    let book = SweepBook { results: *results, language: study.language };
    let mut set = Set::new(folder, &[study.workbook], Existing::Replace);
    set.write(name, |out| book.write(out)).map_err(|refusal| match refusal.exit {
        Exit::Fault => fault::refusal(&refusal.reason().en),
        _ => refusal,
    })?;
    record::commit(set, folder, place)
}

/// Typesets the report; gives the finding where that fails, which keeps nothing else from being delivered.
///
/// # Errors
/// Exit 5 where the report cannot be written.
fn write_report(
    study: &Study<'_>,
    results: &Results<'_>,
    interrupted: &Arc<AtomicBool>,
    (folder, place): (&Folder, &Path),
    name: &OsStr,
    terminal: &mut Terminal,
) -> Result<Option<Finding>, Refusal> {
    let logo = stationery::logo(study.workbook, &study.values, &[]).unwrap_or_else(|caution| {
        finding::general(&[*caution], study.language, terminal);
        None
    });
    let titled = Titled {
        sha256: &study.sha256,
        values: &study.values,
        logo: logo.as_ref().map(|(logo, _)| logo),
        notes: &study.notes,
    };
    let at_work = AtWork::begin();
    let typst = build::typst(None, Arc::clone(interrupted));
    let report = report::sweep::pdf(results, &titled, study.language, &typst);
    drop(at_work);
    match report {
        Ok((pdf, findings)) => {
            finding::general(&findings, study.language, terminal);
            let mut set = Set::new(folder, &[study.workbook], Existing::Replace);
            set.write(name, |out| out.write_all(&pdf))?;
            record::commit(set, folder, place).map(|()| None)
        }
        Err(failure) => Ok(Some(failure.finding_on(&t("el informe del barrido", "the report of the sweep")))),
    }
}
