//! From the sheet of a list to its rows.
//!
//! The row of headings is found by the first column's heading in column A, the columns by their headings, wherever they
//! stand; every row below that holds something is one of the list.

use std::collections::BTreeSet;

use crate::escape::excerpt;
use crate::finding::{Finding, Place, Raise};
use crate::limits::{COVERED_ROWS, EXCERPT};
use crate::parameter::Parameter;
use crate::parameter::list::{List, Row, Rows};
use crate::text::Text;

use super::address::{self, Position};
use super::guard::{Column, Copy};
use super::rules::form::*;
use super::sheet_cells::SheetCells;
use super::unit;
use super::value::{holds, read_at};
use super::words::fold;

/// Columns A to X.
pub const COLUMNS: u32 = 24;

/// The rows of a sheet; `None` where the list may be left out and has none. What is wrong goes to `findings`.
pub fn read(list: &'static List, sheet: &SheetCells, findings: &mut Vec<Finding>) -> Option<Rows> {
    let head = heading(list, sheet);
    let first = list.columns.first().map_or("", |column| column.symbol());
    let head = match head {
        None => {
            findings.push(HeadingsMissing { first: Text::same(first) }.at(Place::Sheet(sheet.name.clone())));
            return None;
        }
        Some(head) => head,
    };
    let columns = columns(list, sheet, head, findings);
    let rows = filled(sheet, head, &columns);
    if head > 0 && !rows.is_empty() {
        units(sheet, head - 1, &columns, findings);
    }
    if rows.is_empty() {
        if !list.optional {
            findings.push(ListEmpty {}.at(Place::Sheet(sheet.name.clone())));
        }
        return None;
    }
    if rows.len() > list.most {
        let (count, most) = (rows.len(), list.most);
        findings.push(ListTooLong { count, most }.at(Place::Sheet(sheet.name.clone())));
        return None;
    }
    let rows = rows
        .into_iter()
        .map(|row| {
            let mut read = Row::default();
            for &(parameter, column) in &columns {
                let at = (row, column);
                read.cells.insert(parameter.key, sheet.place(at));
                if let Some(value) = read_at(parameter, sheet, at, findings) {
                    read.values.insert(parameter.key, value);
                }
            }
            read
        })
        .collect();
    Some(Rows { list: list.key, sheet: sheet.name.clone(), rows })
}

/// What the cells of each column hold as they stand, from the row below the headings to the last one that is filled and one more.
pub fn written(list: &'static List, sheet: &SheetCells) -> Vec<Column> {
    let Some(head) = heading(list, sheet) else { return Vec::new() };
    let columns = columns(list, sheet, head, &mut Vec::new());
    let end = filled(sheet, head, &columns).last().copied().unwrap_or(head) + 1;
    let column = |&(parameter, at): &(&'static Parameter, u32)| {
        Some(Column {
            key: parameter.key,
            sheet: sheet.name.clone(),
            column: u16::try_from(at).ok()?,
            first: head + 1,
            copies: (head + 1..=end).map(|row| Copy::held(sheet, (row, at))).collect(),
        })
    };
    columns.iter().filter(|(parameter, _)| parameter.read).filter_map(column).collect()
}

/// The row of the headings. Where there is none with all of them, the one that a person takes for it says which are missing.
fn heading(list: &List, sheet: &SheetCells) -> Option<u32> {
    let heads = |required: bool| sheet.rows.keys().copied().find(|row| is_heading(list, sheet, *row, required));
    heads(true).or_else(|| heads(false))
}

/// True for a row that begins with the first heading and has all required ones, or, of a list of several columns, another.
fn is_heading(list: &List, sheet: &SheetCells, row: u32, required: bool) -> bool {
    let is = |column: usize, symbol: &str| {
        u32::try_from(column).is_ok_and(|at| sheet.text((row, at)).is_some_and(|text| fold(text) == fold(symbol)))
    };
    // A program may hold a block that reads as the first heading: the others must stand beside it.
    let width = COLUMNS as usize;
    let mut others = list.columns.iter().skip(1);
    let stands = |one: &Parameter| (0..width).any(|at| is(at, one.symbol()));
    list.columns.first().is_some_and(|first| is(0, first.symbol()))
        && if required { others.all(|one| !one.required || stands(one)) } else { others.any(|one| stands(one)) }
}

/// The columns by where they stand.
fn columns(
    list: &'static List,
    sheet: &SheetCells,
    head: u32,
    findings: &mut Vec<Finding>,
) -> Vec<(&'static Parameter, u32)> {
    let mut found: Vec<(&'static Parameter, u32)> = Vec::new();
    for at in 0..COLUMNS {
        let Some(text) = sheet.text((head, at)) else { continue };
        let heading = excerpt(text, EXCERPT);
        // Capitals count where two headings differ by them alone.
        let exact = list.columns.iter().find(|one| one.symbol() == text);
        match exact.or_else(|| list.columns.iter().find(|one| fold(one.symbol()) == fold(text))) {
            None => findings.push(HeadingUnknown { heading }.at(Place::Cells(vec![sheet.place((head, at))]))),
            Some(one) => match found.iter().find(|(other, _)| other.key == one.key) {
                Some((_, first)) => {
                    let cells = vec![sheet.place((head, *first)), sheet.place((head, at))];
                    findings.push(HeadingTwice { heading }.at(Place::Cells(cells)));
                }
                None => found.push((one, at)),
            },
        }
    }
    for lost in list.columns.iter().filter(|one| one.required && found.iter().all(|(other, _)| other.key != one.key)) {
        findings.push(ColumnMissing { column: lost.key() }.at(Place::Sheet(sheet.name.clone())));
    }
    found
}

/// Compares the units above the headings with those of the columns: what stands below a cell that says none, or another, may
/// have been typed in that.
fn units(sheet: &SheetCells, row: u32, columns: &[(&'static Parameter, u32)], findings: &mut Vec<Finding>) {
    for &(parameter, at) in columns {
        let written = sheet.text((row, at)).unwrap_or_default();
        if unit::says(parameter.unit, written) {
            continue;
        }
        let (column, unit) = (parameter.key(), parameter.unit.label());
        let (cell, shown) = (address::format((row, at)), excerpt(written, EXCERPT));
        let place = Place::Cells(vec![sheet.place((row, at))]);
        let finding = match (unit, written) {
            ("", _) => ColumnUnitWhereNone { column, cell, written: shown }.at(place),
            (_, "") => ColumnUnitEmpty { column, unit, cell }.at(place),
            _ => ColumnUnitOther { column, unit, cell, written: shown }.at(place),
        };
        findings.push(finding);
    }
}

/// The rows below the headings that hold something in a column that is read, and those over which a cell of the list is
/// merged: what stood there is hidden.
pub(super) fn filled(sheet: &SheetCells, head: u32, columns: &[(&'static Parameter, u32)]) -> Vec<u32> {
    let marked = sheet.survey.uncalculated.iter().chain(&sheet.survey.judged).map(|(row, _)| *row);
    let covered = sheet.survey.merges.iter().flat_map(|range| (range.start.0..=range.end.0).take(COVERED_ROWS));
    let rows: BTreeSet<u32> =
        sheet.rows.keys().copied().chain(marked).chain(covered).filter(|row| *row > head).collect();
    let holds_or_hides = |at: Position| {
        holds(sheet, at)
            || sheet.survey.covering(at).is_some_and(|range| range.start.0 > head && holds(sheet, range.start))
    };
    rows.into_iter().filter(|row| columns.iter().any(|(_, column)| holds_or_hides((*row, *column)))).collect()
}
