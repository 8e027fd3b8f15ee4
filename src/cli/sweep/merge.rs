//! All rows of a plan in one file, which of them are the best, and the best as workbooks.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::super::build::{self, Asked, Settings};
use super::super::interrupt::AtWork;
use super::super::plan::Item;
use super::super::terminal::Terminal;
use super::super::{fault, finding, stationery};
use super::Study;
use super::args::Sweep;
use super::folder::Rows;
use super::progress;
use super::work::Workshop;
use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Finding, Place, Raise, Refusal, Rule};
use crate::kind::Kind;
use crate::limits::{FRONT_DESIGNS, SWEEP_ROWS};
use crate::parameter::Values;
use crate::report;
use crate::report::sweep::Titled;
use crate::store::{self, Existing, Folder, Set};
use crate::sweep::csv;
use crate::sweep::file::RowFile;
use crate::sweep::indices::Indices;
use crate::sweep::plan::Plan;
use crate::sweep::ranking::{Ranked, Ranking, Reason};
use crate::sweep::results::{Coded, Results};
use crate::sweep::row::{told, values};
use crate::sweep::rules::{FrontCut, NoneDone};
use crate::sweep::sensitivity::{Shares, around, most};
use crate::sweep::table::{Cells, Column, FRONT, Table};
use crate::text::{Text, t};
use crate::workbook::results::Tables;
use crate::workbook::sweep_book::SweepBook;
use crate::workbook::template;

/// Takes in all chunks, one after another: what the designs come to, and what there is to know of the inputs, shares or, of a plan
/// for them, Sobol's indices.
fn take_in<'a>(plan: &'a Plan, rows: &Rows<'_>) -> Result<(Ranked, Shares<'a>, Option<Indices<'a>>), Refusal> {
    let kept = usize::try_from(SWEEP_ROWS).unwrap_or(usize::MAX);
    let (mut ranking, mut shares) = (Ranking::new(plan, kept), Shares::new(plan));
    let mut indices = Indices::new(plan);
    let needed = |name: &str| {
        ["id", "state", "feasible", "reason"].contains(&name)
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
    let (all, best) = summary(arguments, study, rows, (&ranked, &top), &folder)?;
    let links = build_top(study, kinds, rows, (&top, &built))?;
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
        unbuilt: links.iter().take(ranked.front.len()).filter(|link| link.is_none()).count(),
        cut: ranked.cut,
        why: &coded(ranked.why.iter().cloned(), study, &rules),
        cautions: &coded(cautions(&best), study, &rules),
        effects: &effects,
        triples: indices.map(|one| one.triples()),
    };
    let mut names = vec![store::file_name(&stem, "-sweep.xlsx")];
    write_book(study, &results, &links, &folder, &names[0])?;
    let mut failed = None;
    if arguments.report {
        let name = store::file_name(&stem, "-sweep.pdf");
        match write_report(study, &results, interrupted, &folder, &name, terminal)? {
            None => names.push(name),
            failure => failed = failure,
        }
    }
    if ranked.cut {
        finding::general(&[FrontCut { most: FRONT_DESIGNS }.at(Place::File)], *language, terminal);
    }
    if let Some(failed) = &failed {
        finding::general(std::slice::from_ref(failed), *language, terminal);
    }
    if ranked.counts.done == 0 {
        let code = ranked.why.first().map_or_else(String::new, |first| first.code.clone());
        let path = printable_path(&rows.place().join(&names[0]));
        return Err(NoneDone { count: plan.count, code, path }.refused(Exit::Refused, Place::File));
    }
    let names: Vec<_> = names.iter().map(|name| printable(&name.to_string_lossy())).collect();
    let folder = printable_path(rows.place());
    terminal.out(&format!("{}\n{folder}: summary.parquet, {}\n", results.counted().get(*language), names.join(", ")));
    Ok(if failed.is_some() { Exit::ReportFailed } else { Exit::Done })
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
        let ids = ids(&part);
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
    set.write(&OsString::from("summary.parquet"), |out| {
        let mut file = RowFile::new(out, &empty, &study.told)?;
        for (part, ids) in (0..rows.chunks()).map_while(&mut take) {
            let pick = |wanted: &dyn Fn(&u64) -> bool| part.picked(&ids.iter().map(wanted).collect::<Vec<_>>());
            all.append(listed.as_ref().map_or_else(|| part.clone(), |listed| pick(&|id| listed.contains(id))));
            best.append(pick(&|id| shown.contains(id)));
            file.write(part)?;
        }
        file.end()
    })?;
    if arguments.csv {
        set.write(&OsString::from("summary.csv"), |out| {
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
    set.commit()?;
    // In the order of the top.
    let places: BTreeMap<u64, usize> = ids(&best).into_iter().zip(0..).collect();
    let order: Vec<usize> = top.iter().filter_map(|id| places.get(id).copied()).collect();
    Ok((all, best.ordered(&order)))
}

fn ids(table: &Table) -> Vec<u64> {
    let cells = table.column("id");
    (0..table.rows()).filter_map(|row| cells.and_then(|cells| cells.number(row))).map(super::whole).collect()
}

/// Writes those of the best designs that are to be built as workbooks into a folder of their own, and builds them; gives the file of
/// each of the best, as it is found from the folder above.
fn build_top(
    study: &Study<'_>,
    kinds: &[&dyn Kind],
    rows: &Rows<'_>,
    (top, built): (&[u64], &[u64]),
) -> Result<Vec<Option<String>>, Refusal> {
    if built.is_empty() {
        return Ok(vec![None; top.len()]);
    }
    let place = rows.place().join("top");
    let folder = Folder::open(&place)?;
    let build = |id: &u64| {
        let wanted = built.contains(id).then(|| build_one(study, kinds, (&place, &folder), *id));
        wanted.transpose().map(|name| name.map(|name| format!("top/{name}")))
    };
    top.iter().map(build).collect()
}

/// Writes a design as a workbook and builds it; gives the name of its results, or of the workbook itself where it is refused: then its
/// programs were not read back for its row.
fn build_one(
    study: &Study<'_>,
    kinds: &[&dyn Kind],
    (place, folder): (&Path, &Folder),
    id: u64,
) -> Result<String, Refusal> {
    let values = values(&study.base, &study.plan, &study.plan.design(id));
    let stem = store::file_name(&store::stem(study.workbook), &format!("-{id:06}"));
    let name = store::file_name(&stem, ".xlsx");
    let held: Vec<_> = values.values.iter().map(|(key, value)| (*key, value.clone())).collect();
    let note = Text::new(
        format!("Diseño {id} de un barrido de {}", printable_path(study.workbook)),
        format!("Design {id} of a sweep of {}", printable_path(study.workbook)),
    );
    let mut set = Set::new(folder, &[study.workbook], Existing::Replace);
    set.write(&name, |out| template::write(study.kind, &held, &values.lists, &note, study.language, out))?;
    set.commit()?;
    let workbook = place.join(&name);
    let item = Item { workbook: workbook.clone(), stem, folder: place.to_owned() };
    let workbooks = [workbook];
    let asked = Asked {
        workbooks: &workbooks,
        language: Some(study.language),
        no_report: true,
        templates: None,
        typst: None,
        into: false,
        view: false,
        tables: Tables::Live,
    };
    let made = build::made(&item, &Settings::of(&asked, None, kinds, Arc::default()), &|| false);
    if !matches!(made.ending.exit, Exit::Done | Exit::Refused) {
        return Err(Refusal { exit: made.ending.exit, findings: made.ending.findings });
    }
    let built = made.ending.files.iter().map(|file| file.name.to_string_lossy().into_owned());
    let results = built.into_iter().find(|name| name.ends_with("-results.xlsx"));
    Ok(results.unwrap_or_else(|| name.to_string_lossy().into_owned()))
}

/// Reasons with how many designs have each, and what each says: an objective, a constraint, or what the first design with it is told.
fn coded(reasons: impl IntoIterator<Item = Reason>, study: &Study<'_>, rules: &[&Rule]) -> Vec<Coded> {
    let plan = &study.plan;
    let what = |Reason { code, first, .. }: &Reason| {
        let code = code.as_str();
        if plan.objectives.iter().any(|one| one.to_string() == code) {
            t("el diseño no tiene valor de este objetivo", "the design has no value of this objective")
        } else if plan.constraints.iter().any(|one| one.to_string() == code) {
            t(
                "no se cumple la restricción, o el diseño no tiene valor de ella",
                "the constraint is broken, or the design has no value of it",
            )
        } else {
            match fault::guarded(|| told(study.kind, &study.base, plan, *first, code)) {
                Ok(Some(Text { es, en })) => {
                    Text::new(format!("diseño {first}: {es}"), format!("design {first}: {en}"))
                }
                _ => rules.iter().find(|rule| rule.code == code).map_or(t("", ""), |rule| rule.unfilled_what()),
            }
        }
    };
    reasons.into_iter().map(|one| Coded { what: what(&one), code: one.code, count: one.count }).collect()
}

/// The cautions of the best designs, most first.
fn cautions(top: &Table) -> Vec<Reason> {
    let mut counts: BTreeMap<&str, Reason> = BTreeMap::new();
    let codes = top.column("codes");
    for (text, first) in (0..top.rows()).zip(ids(top)).filter_map(|(row, id)| Some((codes?.text(row)?, id))) {
        for code in text.split(';').filter(|code| !code.is_empty()) {
            counts.entry(code).or_insert_with(|| Reason { code: code.to_owned(), count: 0, first }).count += 1;
        }
    }
    let mut counts: Vec<Reason> = counts.into_values().collect();
    counts.sort_by(|one, other| other.count.cmp(&one.count).then_with(|| one.code.cmp(&other.code)));
    counts
}

fn write_book(
    study: &Study<'_>,
    results: &Results<'_>,
    links: &[Option<String>],
    folder: &Folder,
    name: &OsStr,
) -> Result<(), Refusal> {
    let book = SweepBook { results: *results, links, language: study.language };
    let mut set = Set::new(folder, &[study.workbook], Existing::Replace);
    set.write(name, |out| book.write(out)).map_err(|refusal| match refusal.exit {
        Exit::Fault => fault::refusal(&refusal.reason().en),
        _ => refusal,
    })?;
    set.commit().map(drop)
}

/// Typesets the report; gives the finding where that fails, which keeps nothing else from being delivered.
///
/// # Errors
/// Exit 5 where the report cannot be written.
fn write_report(
    study: &Study<'_>,
    results: &Results<'_>,
    interrupted: &Arc<AtomicBool>,
    folder: &Folder,
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
            set.commit().map(|_| None)
        }
        Err(failure) => Ok(Some(failure.finding_on(&t("el informe del barrido", "the report of the sweep")))),
    }
}
