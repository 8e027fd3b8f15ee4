//! The best designs as workbooks, built whole: what came of each, which no row tells where programs were not read back for it.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use super::super::build::{self, BuildRequest, Settings};
use super::super::plan::Item;
use super::Study;
use super::folder::Rows;
use super::record::Record;
use crate::escape::printable_path;
use crate::finding::{Exit, Grade, Refusal};
use crate::kind::Kind;
use crate::store::{self, Existing, Folder, Set};
use crate::sweep::results::{Built, Coded};
use crate::sweep::row::{codes, says, values};
use crate::sweep::table::{CAUTION, CODES, Cells, Table};
use crate::text::Text;
use crate::workbook::results::Tables;
use crate::workbook::template;

/// The folder of the best designs, in that of the rows.
const TOP: &str = "top/";

/// Writes those of the best designs that are to be built as workbooks into a folder of their own, and builds them; gives what came of
/// each of the best.
pub(super) fn build_top(
    study: &Study<'_>,
    kinds: &[&dyn Kind],
    rows: &Rows<'_>,
    (top, built): (&[u64], &[u64]),
) -> Result<Vec<Option<Built>>, Refusal> {
    if built.is_empty() {
        return Ok(vec![None; top.len()]);
    }
    let place = rows.place().join("top");
    let folder = Folder::open(&place)?;
    let outer = Folder::open(rows.place())?;
    let build = |id: &u64| {
        let one = || build_one(study, kinds, (rows.place(), &outer), (&place, &folder), *id);
        built.contains(id).then(one).transpose()
    };
    top.iter().map(build).collect()
}

/// Writes a design as a workbook and builds it.
fn build_one(
    study: &Study<'_>,
    kinds: &[&dyn Kind],
    (outer_place, outer): (&Path, &Folder),
    (place, folder): (&Path, &Folder),
    id: u64,
) -> Result<Built, Refusal> {
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
    let mut record = Record::open(outer_place);
    record.check(&format!("{TOP}{}", name.to_string_lossy()))?;
    // What it was built into is there to be edited, too.
    record.check_known(&format!("{TOP}{}", stem.to_string_lossy()))?;
    record.note(outer, TOP, set.written())?;
    set.commit()?;
    let workbook = place.join(&name);
    let item = Item { workbook: workbook.clone(), stem, folder: place.to_owned() };
    let workbooks = [workbook];
    let asked = BuildRequest {
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
    record.note(outer, TOP, &made.verdict.files)?;
    if !matches!(made.verdict.exit, Exit::Done | Exit::Refused) {
        return Err(Refusal { exit: made.verdict.exit, findings: made.verdict.findings });
    }
    let files = made.verdict.files.iter().map(|file| file.name.to_string_lossy().into_owned());
    let results = files.into_iter().find(|name| name.ends_with("-results.xlsx"));
    // What is found of the folder says nothing of the design.
    let findings = made.outcome.map_or(made.verdict.findings, |outcome| outcome.findings);
    let file = results.clone().unwrap_or_else(|| name.to_string_lossy().into_owned());
    Ok(Built { file: format!("top/{file}"), rejected: results.is_none(), findings })
}

/// Puts what the whole builds found into the rows of the best designs.
pub(super) fn judged_whole(best: &mut Table, built: &[Option<Built>]) {
    let whole = || built.iter().enumerate().filter_map(|(row, built)| Some((row, built.as_ref()?)));
    for column in &mut best.columns {
        match (column.name.as_str(), &mut column.cells) {
            (CAUTION, Cells::Whole(cells)) => {
                for (row, built) in whole() {
                    let cautions = built.findings.iter().filter(|one| one.grade == Grade::Caution).count();
                    if let Some(cell) = cells.get_mut(row) {
                        *cell = i64::try_from(cautions).ok();
                    }
                }
            }
            (CODES, Cells::Text(cells)) => {
                for (row, built) in whole() {
                    if let Some(cell) = cells.get_mut(row) {
                        *cell = Some(codes(&built.findings).join(";").into());
                    }
                }
            }
            _ => {}
        }
    }
}

/// What those of the best that were rejected were rejected for, most first.
pub(super) fn rejected(top: &[u64], built: &[Option<Built>]) -> Vec<Coded> {
    let mut counts: BTreeMap<&str, Coded> = BTreeMap::new();
    let stops = top.iter().zip(built).filter_map(|(id, built)| Some((*id, built.as_ref()?.stop()?)));
    for (id, stop) in stops {
        let first = || Coded { code: stop.code().to_owned(), what: says(id, stop), count: 0 };
        counts.entry(stop.code()).or_insert_with(first).count += 1;
    }
    let mut counts: Vec<Coded> = counts.into_values().collect();
    counts.sort_by(|one, other| other.count.cmp(&one.count).then_with(|| one.code.cmp(&other.code)));
    counts
}
