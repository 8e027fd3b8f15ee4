//! All rows of a plan in one file, which of them are the best, and the best as workbooks.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::io::Write;

use super::super::build::{self, Asked, Settings};
use super::super::plan::Item;
use super::super::terminal::Terminal;
use super::super::{fault, finding, show};
use super::Study;
use super::args::Sweep;
use super::folder::Rows;
use super::work::Workshop;
use crate::escape::printable;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::kind::Kind;
use crate::store::{self, Existing, Folder, Set};
use crate::sweep::csv;
use crate::sweep::file::RowFile;
use crate::sweep::front;
use crate::sweep::indices::Indices;
use crate::sweep::ranking::{Ranked, Ranking};
use crate::sweep::row::values;
use crate::sweep::rules::{FrontCut, NoneDone};
use crate::sweep::sensitivity::{Effect, Shares, around};
use crate::sweep::table::{Cells, Column, FRONT, Table};
use crate::text::{Text, t};
use crate::workbook::results::Tables;
use crate::workbook::sweep_book::{ALL_MOST, SweepBook, Why};
use crate::workbook::template;

/// Makes summary, workbook and best designs from the chunks, which are all there.
pub(super) fn merge(
    arguments: &Sweep,
    study: &Study<'_>,
    kinds: &[&dyn Kind],
    rows: &Rows<'_>,
    terminal: &mut Terminal,
) -> Result<Exit, Refusal> {
    let Study { plan, language, .. } = study;
    let kept = usize::try_from(ALL_MOST).unwrap_or(usize::MAX);
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
    let ranked = ranking.end();
    let top = ranked.top(usize::from(arguments.top));
    let folder = Folder::open(rows.place())?;
    let stem = store::stem(study.workbook);
    let (all, best) = summary(arguments, study, rows, (&ranked, &top), &folder)?;
    let links = build_top(study, kinds, rows, &top)?;
    let workshop = Workshop::open(study, arguments.jobs)?;
    let mut effects = around(study.kind, &study.base, plan, &|inputs| workshop.design(0, inputs));
    match &indices {
        Some(indices) => effects.iter_mut().zip(indices.end()).for_each(|(effect, of)| effect.indices = of),
        None => effects.iter_mut().zip(shares.end()).for_each(|(effect, of)| effect.shares = of),
    }
    let why = why(&ranked, kinds);
    let name = store::file_name(&stem, "-sweep.xlsx");
    write_book(
        study,
        (&ranked, &why),
        (&best, &links, &all),
        (&effects, indices.map(|one| one.triples())),
        &folder,
        &name,
    )?;
    if ranked.cut {
        finding::general(&[FrontCut { most: front::MOST }.at(Place::File)], *language, terminal);
    }
    let text = closing(study, &ranked, &show::path(rows.place()), &printable(&name.to_string_lossy()));
    if ranked.counts.done == 0 {
        let code = ranked.why.first().map_or_else(String::new, |(code, _)| code.clone());
        return Err(NoneDone { count: plan.count, code }.refused(Exit::Refused, Place::File));
    }
    terminal.out(text.get(*language));
    Ok(Exit::Done)
}

fn read(rows: &Rows<'_>, number: u64, wanted: &dyn Fn(&str) -> bool) -> Result<Table, Refusal> {
    rows.read(number, wanted).ok().flatten().ok_or_else(|| Refusal::new(Exit::Unreadable, rows.torn(number)))
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
    let listed: Option<BTreeSet<u64>> = (study.plan.count > ALL_MOST)
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
            best.append(pick(&|id| top.contains(id)));
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
    let places = ids(&best);
    let mut ordered = empty;
    for id in top {
        ordered.append(best.picked(&places.iter().map(|one| one == id).collect::<Vec<_>>()));
    }
    Ok((all, ordered))
}

fn ids(table: &Table) -> Vec<u64> {
    let cells = table.column("id");
    (0..table.rows()).filter_map(|row| cells.and_then(|cells| cells.number(row))).map(super::whole).collect()
}

/// Writes the best designs as workbooks into a folder of their own, and builds them; gives their files, as they are found from the
/// folder above.
fn build_top(
    study: &Study<'_>,
    kinds: &[&dyn Kind],
    rows: &Rows<'_>,
    top: &[u64],
) -> Result<Vec<Option<String>>, Refusal> {
    if top.is_empty() {
        return Ok(Vec::new());
    }
    let place = rows.place().join("top");
    let folder = Folder::open(&place)?;
    let stem = store::stem(study.workbook);
    let mut links = Vec::new();
    for id in top {
        let values = values(&study.base, &study.plan, &study.plan.design(*id));
        let stem = store::file_name(&stem, &format!("-{id:06}"));
        let name = store::file_name(&stem, ".xlsx");
        let held: Vec<_> = values.values.iter().map(|(key, value)| (*key, value.clone())).collect();
        let note = Text::new(
            format!("Diseño {id} de un barrido de {}", show::path(study.workbook)),
            format!("Design {id} of a sweep of {}", show::path(study.workbook)),
        );
        let mut set = Set::new(&folder, &[study.workbook], Existing::Replace);
        set.write(&name, |out| template::write(study.kind, &held, &values.lists, &note, study.language, out))?;
        set.commit()?;
        let workbook = place.join(&name);
        let item = Item { workbook: workbook.clone(), stem: stem.clone(), folder: place.clone() };
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
        let made = build::made(&item, &Settings::of(&asked, None, kinds, std::sync::Arc::default()), &|| false);
        if made.ending.exit == Exit::Fault {
            return Err(Refusal { exit: Exit::Fault, findings: made.ending.findings });
        }
        let built = made.ending.files.iter().map(|file| file.name.to_string_lossy().into_owned());
        let results = built.into_iter().find(|name| name.ends_with("-results.xlsx"));
        let link = results.unwrap_or_else(|| name.to_string_lossy().into_owned());
        links.push(Some(format!("top/{link}")));
    }
    Ok(links)
}

/// Why designs are not good, with what each code says.
fn why(ranked: &Ranked, kinds: &[&dyn Kind]) -> Vec<Why> {
    let rows = super::super::explain::rows(kinds);
    let what = |code: &str| rows.iter().find(|rule| rule.code == code).map_or(t("", ""), |rule| rule.what.clone());
    ranked.why.iter().map(|(code, count)| Why { what: what(code), code: code.clone(), count: *count }).collect()
}

fn write_book(
    study: &Study<'_>,
    (ranked, why): (&Ranked, &[Why]),
    (top, links, all): (&Table, &[Option<String>], &Table),
    (effects, triples): (&[Effect], Option<(u64, u64)>),
    folder: &Folder,
    name: &OsString,
) -> Result<(), Refusal> {
    let source = printable(&study.workbook.file_name().unwrap_or_default().to_string_lossy());
    let book = SweepBook {
        kind: study.kind,
        plan: &study.plan,
        source: &source,
        top,
        links,
        all,
        counts: ranked.counts,
        front: ranked.front.len(),
        why,
        effects,
        triples,
        language: study.language,
    };
    let mut set = Set::new(folder, &[study.workbook], Existing::Replace);
    set.write(name, |out| book.write(out)).map_err(|refusal| match refusal.exit {
        Exit::Fault => fault::refusal(&refusal.reason().en),
        _ => refusal,
    })?;
    set.commit().map(drop)
}

/// What came of it, in a line or two.
fn closing(study: &Study<'_>, ranked: &Ranked, folder: &str, book: &str) -> Text {
    let (all, counts, front) = (study.plan.count, ranked.counts, ranked.front.len());
    let (done, refused, failed, feasible) = (counts.done, counts.refused, counts.failed, counts.feasible);
    Text::new(
        format!(
            "{all} diseños: {done} hechos, {refused} rechazados, {failed} fallidos; {feasible} válidos, {front} en el frente\n{folder}: summary.parquet, {book}\n"
        ),
        format!(
            "{all} designs: {done} done, {refused} refused, {failed} failed; {feasible} feasible, {front} on the front\n{folder}: summary.parquet, {book}\n"
        ),
    )
}
