//! The sheet of variants: written for a new workbook, and read.
//!
//! Settings stand above as on any sheet of a form, the inputs that vary below as a list. The designs of a list stand on a sheet of
//! their own, a row of symbols and one design a row.

use std::collections::BTreeSet;

use rust_xlsxwriter::Workbook;

use super::address::{self, Position};
use super::book::Book;
use super::error::WriteError;
use super::form_sheet::Filling;
use super::gate::gate;
use super::list_rows;
use super::list_sheet::ListSheet;
use super::listing::SheetEntry;
use super::names::{Made, Role};
use super::page::{Page, SheetStyle};
use super::rules::form::SymbolUnknown;
use super::schema::{calculated, hidden, refusal, take};
use super::sheet_cells::SheetCells;
use super::sheet_names::find;
use super::value::read_at;
use super::words::fold;
use crate::escape::excerpt;
use crate::finding::{Exit, Finding, Grade, Place, Raise, Refusal};
use crate::kind::measure::{Suggested, Varied};
use crate::limits::{EXCERPT, SWEEP_INPUTS};
use crate::parameter::field::Fields;
use crate::parameter::list::{List, Row, Rows};
use crate::parameter::{Form, Parameter, Sheet, Value, Values};
use crate::sweep::asked::{Designs, input, varies};
use crate::sweep::form::{CONSTRAINTS, DESIGNS, FORM, FROM, INPUT, METHOD, NAME, OBJECTIVES, STEP, TO, VALUES};
use crate::sweep::plan::Method;
use crate::sweep::rules::{DesignCellBeyond, DesignCellEmpty, InputNotVaried, InputTwice, NoSuchInput, UnderNoSymbol};
use crate::text::{Language, Text, t};

/// Rows that stand ready below those that are filled in.
const SPARE: usize = 8;

/// How the sheet is filled in.
static HOW: Text = t(
    "Escriba solo en las celdas amarillas: los ajustes en la columna C; debajo, una fila por entrada que varía.",
    "Write only in the yellow cells: the settings in column C; below, one row for each input that varies.",
);

/// The sheet with what a kind suggests.
#[must_use]
pub fn suggested(suggested: &Suggested, language: Language) -> Values {
    let mut values = Values { language, ..Values::default() };
    values.put(&METHOD, Some(Method::Factorial));
    values.put(&OBJECTIVES, Some(suggested.objectives.to_owned()).filter(|text| !text.is_empty()));
    values.put(&CONSTRAINTS, Some(suggested.constraints.to_owned()).filter(|text| !text.is_empty()));
    let row = |(symbol, varied): &(&'static str, Varied)| {
        let mut row = Row::default();
        row.put(&INPUT, (*symbol).to_owned());
        match varied {
            Varied::Steps(from, to, step) => {
                for (field, number) in [(&FROM, from), (&TO, to), (&STEP, step)] {
                    row.put(field, *number);
                }
            }
            Varied::Values(list) => row.put(&VALUES, (*list).to_owned()),
        }
        row
    };
    let rows = suggested.inputs.iter().map(row).collect();
    values.lists.push(Rows { list: "inputs", sheet: NAME.get(language).to_owned(), rows });
    values
}

/// Writes the sheet into a new workbook, and gives what it is: rodete finds the sheet by its name, which is never another.
///
/// # Errors
/// For what a workbook cannot hold.
pub(super) fn write(
    workbook: &mut Workbook,
    variants: &Values,
    look: &SheetStyle<'_>,
) -> Result<Option<Made>, WriteError> {
    let SheetStyle { styles, page, language } = *look;
    let (Some(described), Some(list)) = (FORM.sheets.first(), FORM.lists.first()) else { return Ok(None) };
    let name = described.name.get(language);
    let notes = [list.note.get(language), HOW.get(language)];
    let values = |key: &str| variants.values.get(key);
    let sheet = workbook.add_worksheet();
    let filling = Filling { sheet: described, values, notes: &notes, guard: None, live: None, sketch: None, language };
    let layout = filling.write(sheet, styles)?;
    let rows = variants.rows(list.key);
    ListSheet { list, name, rows, language }.write_below(sheet, styles, layout.last + 2, SPARE)?;
    for (column, width) in (5..).zip(list.widths.iter().skip(5)) {
        sheet.set_column_width(column, *width)?;
    }
    sheet.set_freeze_panes(layout.header + 1, 0)?;
    Page { repeat: (layout.header, layout.header), landscape: true, ..*page }.set_up(sheet, language)?;
    for (defined, cell) in layout.defined_names(name) {
        workbook.define_name(defined, &cell)?;
    }
    Ok(Some(Made { name: name.to_owned(), role: Role::Form }))
}

/// The sheet of variants of a workbook, as it was read.
#[derive(Debug)]
pub struct SweepSheet {
    /// Its cells as typed fields.
    pub fields: Fields,
    /// The designs of a list, where the workbook has such a sheet.
    pub designs: Option<Designs>,
    /// Notes and cautions.
    pub findings: Vec<Finding>,
}

/// True where one of the sheets is that of variants, or where it cannot be told which.
pub(super) fn may_be(sheets: &[SheetEntry], language: Language) -> bool {
    let mut named = FORM.sheets.iter().map(|sheet| find(sheets, &sheet.name, language, &mut Vec::new()));
    named.any(|found| !matches!(found, Ok(None)))
}

/// Reads the sheet of variants of a workbook that follows `form`; `None` where it has none.
///
/// # Errors
/// One refusal with everything that is wrong with its cells.
pub fn read(bytes: &[u8], form: &'static Form, language: Language) -> Result<Option<SweepSheet>, Refusal> {
    let (Some(described), Some(list)) = (FORM.sheets.first(), FORM.lists.first()) else { return Ok(None) };
    let gated = gate(bytes)?;
    let mut findings = Vec::new();
    let Some(entry) = find(&gated.sheets, &described.name, language, &mut findings)? else { return Ok(None) };
    let mut book = Book::open(gated)?;
    let sheet = book.read(&entry, list_rows::COLUMNS)?;
    if sheet.survey.unsound {
        return Err(refusal(sheet.survey.exit(), sheet.survey.findings));
    }
    findings.extend(hidden(&entry));
    let values = cells(described, list, sheet, language, &mut findings);
    static LISTED: Text = DESIGNS;
    let designs = match find(&book.gated.sheets, &LISTED, language, &mut findings)? {
        None => None,
        Some(entry) => {
            let sheet = book.read(&entry, SWEEP_INPUTS)?;
            if sheet.survey.unsound {
                return Err(refusal(sheet.survey.exit(), sheet.survey.findings));
            }
            findings.extend(sheet.survey.findings.iter().cloned());
            Some(designs(form, &sheet, &mut findings))
        }
    };
    if findings.iter().any(|finding| finding.grade == Grade::Stop) {
        return Err(refusal(Exit::Refused, findings));
    }
    Ok(Some(SweepSheet { fields: Fields::of(&FORM, values)?, designs, findings }))
}

/// The cells of the sheet: settings above the row of headings, inputs below.
fn cells(
    described: &'static Sheet,
    list: &'static List,
    mut sheet: SheetCells,
    language: Language,
    findings: &mut Vec<Finding>,
) -> Values {
    findings.append(&mut sheet.survey.findings);
    let mut values = Values { language, ..Values::default() };
    let first = list.columns.first().map_or("", |column| column.symbol());
    let heads = |row: &u32| sheet.text((*row, 0)).is_some_and(|text| fold(text) == fold(first));
    let head = sheet.rows.keys().copied().find(heads).unwrap_or(u32::MAX);
    let below = sheet.rows.split_off(&head);
    // The meanings of the list's columns, as the sheet is written.
    let meaning = list.columns.first().map(|column| &column.meaning);
    let means = |row: u32| {
        let text = sheet.text((row, 0));
        text.is_some() && Language::ALL.into_iter().any(|one| meaning.map(|meaning| meaning.get(one)) == text)
    };
    let meanings: Vec<u32> = sheet.rows.keys().copied().filter(|row| means(*row)).collect();
    meanings.iter().for_each(|row| drop(sheet.rows.remove(row)));
    take((FORM.schema, None), described, &sheet, &mut values, findings);
    findings.extend(calculated(&sheet, values.cells.values()));
    sheet.rows = below;
    values.lists.extend(list_rows::read(list, &sheet, findings));
    values
}

/// The designs of a list: symbols in the first row that holds something, values below. Whatever else the sheet holds would be left out
/// of the designs without a word, and is refused.
fn designs(form: &'static Form, sheet: &SheetCells, findings: &mut Vec<Finding>) -> Designs {
    let place = |at: Position| Place::Cells(vec![sheet.place(at)]);
    let held: BTreeSet<Position> = sheet
        .rows
        .iter()
        .flat_map(|(row, cells)| (0..).zip(cells).filter(|(_, cell)| cell.is_some()).map(|(at, _)| (*row, at)))
        .chain(sheet.survey.uncalculated.iter().copied())
        .collect();
    let head = sheet.rows.keys().next().or_else(|| held.first().map(|(row, _)| row)).copied().unwrap_or_default();
    let mut columns: Vec<(&'static Parameter, u32)> = Vec::new();
    let mut headed = BTreeSet::new();
    for at in (0..SWEEP_INPUTS).filter(|at| sheet.cell((head, *at)).is_some()) {
        headed.insert(at);
        let place = place((head, at));
        let symbol = sheet.text((head, at)).unwrap_or_default();
        match input(form, symbol) {
            None if symbol.is_empty() => findings.push(SymbolUnknown { symbol: "?".to_owned() }.at(place)),
            None => findings.push(NoSuchInput { symbol: excerpt(symbol, EXCERPT) }.at(place)),
            Some(one) if !varies(one) => findings.push(InputNotVaried { symbol: one.key() }.at(place)),
            Some(one) if columns.iter().any(|(other, _)| other.key == one.key) => {
                findings.push(InputTwice { symbol: one.key() }.at(place));
            }
            Some(one) => columns.push((one, at)),
        }
    }
    for at in &held {
        if headed.insert(at.1) {
            let (column, row) = (address::letters(at.1), u64::from(head) + 1);
            findings.push(UnderNoSymbol { column, row }.at(place(*at)));
        }
    }
    if let Some(beyond) = sheet.survey.beyond {
        let last = address::letters(SWEEP_INPUTS - 1);
        findings.push(DesignCellBeyond { cell: address::format(beyond), last }.at(place(beyond)));
    }
    let mut rows = Vec::new();
    for row in list_rows::filled(sheet, head, &columns) {
        let mut values: Vec<Value> = Vec::new();
        for (parameter, at) in &columns {
            let before = findings.len();
            match read_at(parameter, sheet, (row, *at), findings) {
                Some(value) => values.push(value),
                None if findings.len() == before && !sheet.survey.judged.contains(&(row, *at)) => {
                    findings.push(DesignCellEmpty { symbol: parameter.key() }.at(place((row, *at))));
                }
                None => {}
            }
        }
        if values.len() == columns.len() {
            rows.push(values);
        }
    }
    Designs { sheet: sheet.name.clone(), inputs: columns.into_iter().map(|(one, _)| one).collect(), rows }
}
