//! The sheet of a list: meanings, units and headings of its columns, and one row for each thing.

use rust_xlsxwriter::{ColNum, IgnoreError, RowNum, Worksheet, quote_sheet_name, utility::column_number_to_name};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::guard::{Column, Copy, Guard};
use super::page::Page;
use super::style::Styles;
use super::validation::{red, validation};
use crate::parameter::list::{List, Naming, Row};
use crate::parameter::{FieldKind, Parameter, Value};
use crate::text::Language;

/// The rows of meanings, units and headings, and the first row of the list, counted from 0.
const MEANINGS: RowNum = 2;
const HEADINGS: RowNum = 4;
const FIRST: RowNum = 5;

/// Rows that stand ready to be filled in below those that are.
const SPARE: usize = 25;

/// What fills a list's sheet.
#[derive(Clone, Copy, Debug)]
pub struct ListSheet<'a> {
    /// The list whose sheet it is.
    pub list: &'static List,
    /// The sheet's name.
    pub name: &'a str,
    /// The rows that are filled in already.
    pub rows: &'a [Row],
    /// The language of everything but the values.
    pub language: Language,
}

/// The cells of a column of a list that has one sheet, as `TOOLS!$A$6:$A$505` for `tools.T`; `None` where it is another list's.
#[must_use]
pub fn cells(list: &List, reference: &str, language: Language) -> Option<String> {
    let (key, symbol) = reference.split_once('.')?;
    let at = list.columns.iter().position(|column| list.key == key && column.symbol() == symbol)?;
    column_cells(list, at, language)
}

fn column_cells(list: &List, at: usize, language: Language) -> Option<String> {
    let Naming::One(name) = &list.naming else { return None };
    let column = letter(at)?;
    let last = last(list)?;
    Some(format!("{}!${column}${}:${column}${last}", quote_sheet_name(name.get(language)), FIRST + 1))
}

/// The last row of a list, from 1.
fn last(list: &List) -> Option<usize> {
    Some(usize::try_from(FIRST).ok()? + list.most)
}

fn letter(at: usize) -> Option<String> {
    Some(column_number_to_name(ColNum::try_from(at).ok()?))
}

/// Where a cell of a column of a list is empty in a row that is used.
#[derive(Debug)]
pub struct Gap {
    /// The formula: how far above the row behind the list the first such row stands; 0 where there is none.
    pub found: String,
    column: String,
    behind: usize,
}

impl Gap {
    /// The address of the empty cell as a formula, where `found` stands in a cell.
    #[must_use]
    pub fn address(&self, found: &str) -> String {
        format!("\"{}\"&({}-{found})", self.column, self.behind)
    }
}

/// The gaps in a column of a list that has one sheet; `None` of others.
#[must_use]
pub fn gap(list: &List, parameter: &Parameter, language: Language) -> Option<Gap> {
    let at = list.columns.iter().position(|one| one.key == parameter.key)?;
    let (own, column, behind) = (column_cells(list, at, language)?, letter(at)?, last(list)? + 1);
    let others = (0..list.columns.len()).filter(|other| *other != at);
    let others = others.filter_map(|other| column_cells(list, other, language));
    let filled = others.map(|cells| format!("LEN(TRIM({cells}))")).collect::<Vec<_>>().join("+");
    let empty = format!("(LEN(TRIM({own}))=0)*(({filled})>0)");
    Some(Gap { found: format!("SUMPRODUCT(MAX({empty}*({behind}-ROW({own}))))"), column, behind })
}

impl ListSheet<'_> {
    /// Writes the sheet, watched by a guard where there is one. It is not protected: rows are put in and taken out.
    ///
    /// # Errors
    /// For a value that is not finite, and for a list that a workbook cannot hold.
    pub fn write(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        page: &Page<'_>,
        guard: Option<&mut Guard>,
    ) -> Result<(), WriteError> {
        let language = self.language;
        sheet.set_name(self.name)?;
        write_text(sheet, 0, 0, self.list.title.get(language), &styles.title)?;
        let mut last: ColNum = 0;
        let mut across = 0.0;
        for (column, width) in (0..).zip(self.list.widths) {
            sheet.set_column_width(column, *width)?;
            (last, across) = (column, across + width);
        }
        let note = self.list.note.get(language);
        if last > 0 {
            sheet.merge_range(1, 0, 1, last, "", &styles.note)?;
        }
        if let Some(guard) = &guard {
            guard.banner(sheet, 1, [0, last], note, language, [&styles.note, &styles.stale])?;
        } else {
            write_text(sheet, 1, 0, note, &styles.note)?;
        }
        sheet.set_row_height(1, row_height(&[(note, across)]))?;
        self.write_head(sheet, styles, MEANINGS)?;
        let ready = (self.rows.len() + SPARE).min(self.list.most);
        let mut end = HEADINGS;
        for (row, at) in (FIRST..).zip(0..ready) {
            self.write_row(sheet, styles, row, self.rows.get(at))?;
            end = row;
        }
        if let Some(guard) = guard {
            for (column, parameter) in (0..).zip(self.list.columns).filter(|(_, parameter)| parameter.read) {
                let value = |at| self.rows.get(at).and_then(|row: &Row| row.values.get(parameter.key));
                let copies = (0..ready).map(|at| Copy::of(parameter, value(at), language)).collect();
                guard.watch_column(Column {
                    key: parameter.key,
                    sheet: self.name.to_owned(),
                    column,
                    first: FIRST,
                    copies,
                });
            }
        }
        let most = FIRST + RowNum::try_from(self.list.most).unwrap_or(RowNum::MAX - FIRST) - 1;
        for (column, parameter) in (0..).zip(self.list.columns) {
            // Blocks of a program are anything; a message at each would be in the way.
            if !matches!(parameter.kind, FieldKind::Line { .. }) {
                let validation = validation(parameter, true, language)?;
                sheet.add_data_validation(FIRST, column, most, column, &validation)?;
                let cell = format!("{}{}", column_number_to_name(column), FIRST + 1);
                if let Some(red) = red(parameter, &cell, styles) {
                    sheet.add_conditional_format(FIRST, column, most, column, &red)?;
                }
            }
        }
        sheet.ignore_error_range(FIRST, 0, most, last, IgnoreError::NumberStoredAsText)?;
        sheet.set_freeze_panes(FIRST, 0)?;
        sheet.set_selection(FIRST, 0, FIRST, 0)?;
        let printed = FIRST + RowNum::try_from(self.rows.len()).unwrap_or_default();
        sheet.set_print_area(0, 0, printed.max(HEADINGS).min(end.max(HEADINGS)), last)?;
        Page { repeat: (MEANINGS, HEADINGS), landscape: last > 4, ..*page }.set_up(sheet, language)?;
        Ok(())
    }

    /// Writes the list below what a sheet holds already: meanings, units and headings from a row on, then its rows and as many
    /// spare ones. Gives the last row.
    ///
    /// # Errors
    /// For a value that is not finite, and for a list that a workbook cannot hold.
    pub(super) fn write_below(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        top: RowNum,
        spare: usize,
    ) -> Result<RowNum, WriteError> {
        self.write_head(sheet, styles, top)?;
        let ready = (self.rows.len() + spare).min(self.list.most);
        let mut last = top + 2;
        for (row, at) in (top + 3..).zip(0..ready) {
            self.write_row(sheet, styles, row, self.rows.get(at))?;
            last = row;
        }
        Ok(last)
    }

    /// Writes meanings, units and headings into three rows from `top` on.
    fn write_head(&self, sheet: &mut Worksheet, styles: &Styles, top: RowNum) -> Result<(), WriteError> {
        let language = self.language;
        let mut meanings = Vec::new();
        for ((column, parameter), width) in (0..).zip(self.list.columns).zip(self.list.widths) {
            let meaning = parameter.meaning.get(language);
            meanings.push((meaning, *width));
            write_text(sheet, top, column, meaning, &styles.faint)?;
            write_text(sheet, top + 1, column, parameter.unit.label(), &styles.unit)?;
            write_text(sheet, top + 2, column, parameter.symbol(), &styles.header)?;
        }
        sheet.set_row_height(top, row_height(&meanings))?;
        Ok(())
    }

    fn write_row(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        at: RowNum,
        row: Option<&Row>,
    ) -> Result<(), WriteError> {
        for (column, parameter) in (0..).zip(self.list.columns) {
            let format = match parameter.kind {
                FieldKind::Real { .. } | FieldKind::Whole { .. } => &styles.input_number,
                FieldKind::Line { .. } => &styles.input_line,
                _ => &styles.input_text,
            };
            match row.and_then(|row| row.values.get(parameter.key)) {
                Some(Value::Real(value)) if !value.is_finite() => {
                    return Err(WriteError::NotFinite { place: parameter.key.to_owned() });
                }
                Some(Value::Real(value)) => {
                    sheet.write_number_with_format(at, column, *value, format)?;
                }
                Some(Value::Whole(value)) => {
                    sheet.write_number_with_format(at, column, *value, format)?;
                }
                Some(Value::Choice(key)) => {
                    write_text(sheet, at, column, parameter.label(key, self.language), format)?;
                }
                Some(Value::Line(text)) => write_text(sheet, at, column, text, format)?,
                None => {
                    sheet.write_blank(at, column, format)?;
                }
            }
        }
        Ok(())
    }
}
