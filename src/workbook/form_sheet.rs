//! One sheet of a form: the parameters with their values, to be filled in.
//!
//! Column A holds the symbol, B the meaning, C the value, D the unit, E the allowed range and a note. The same sheet
//! opens a new workbook and a results workbook, so that results can be edited and built again.

use std::collections::BTreeMap;

use rust_xlsxwriter::{ColNum, IgnoreError, ProtectionOptions, RowNum, Worksheet};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::page::Page;
use super::style::Styles;
use super::validation::{range_and_note, validation};
use crate::parameter::{FieldKind, Parameter, Sheet, Value};
use crate::text::{Language, Text, t};

const SYMBOL: ColNum = 0;
const MEANING: ColNum = 1;
const VALUE: ColNum = 2;
const UNIT: ColNum = 3;
const RANGE: ColNum = 4;

/// The last column of a form.
pub const LAST: ColNum = RANGE;

/// Widths of columns A to E, in characters.
const WIDTHS: [f64; 5] = [15.5, 37.0, 19.0, 8.0, 42.0];

/// What fills a form's sheet.
#[derive(Clone, Copy, Debug)]
pub struct Filling<'a, V> {
    /// The sheet of the form.
    pub sheet: &'static Sheet,
    /// The value of a parameter by its key; `None` leaves the cell empty.
    pub values: V,
    /// Notes under the title, one a row.
    pub notes: &'a [&'a str],
    /// The language of everything but the values.
    pub language: Language,
}

/// Where things came to stand on a form's sheet.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The row of the column headings, from 0.
    pub header: RowNum,
    /// The last row.
    pub last: RowNum,
    /// The defined name and row of every value cell; all are in column C.
    pub names: Vec<(&'static str, RowNum)>,
    /// The heights of rows in points.
    heights: BTreeMap<RowNum, f64>,
}

impl Layout {
    /// Makes a row at least so many points high.
    pub fn raise(&mut self, row: RowNum, height: f64) {
        let least = self.heights.entry(row).or_insert(height);
        *least = least.max(height);
        self.last = self.last.max(row);
    }

    /// Sets heights, panes, printing and protection, when everything is written.
    ///
    /// # Errors
    /// For rows outside the sheet.
    pub fn finish(
        &self,
        sheet: &mut Worksheet,
        last_column: ColNum,
        page: &Page<'_>,
        language: Language,
    ) -> Result<(), WriteError> {
        for (&row, &height) in &self.heights {
            sheet.set_row_height(row, height)?;
        }
        sheet.set_freeze_panes(self.header + 1, 0)?;
        sheet.set_print_area(0, SYMBOL, self.last, last_column)?;
        Page { repeat: (self.header, self.header), ..*page }.set_up(sheet, language)?;
        sheet.protect_with_options(&ProtectionOptions {
            format_cells: true,
            format_columns: true,
            format_rows: true,
            ..ProtectionOptions::new()
        });
        Ok(())
    }

    /// The defined names with the cells they stand for, as `=DATOS!$C$7`.
    pub fn defined_names<'a>(&'a self, sheet: &'a str) -> impl Iterator<Item = (&'static str, String)> + 'a {
        let quoted = rust_xlsxwriter::quote_sheet_name(sheet);
        self.names.iter().map(move |(name, row)| (*name, format!("={quoted}!$C${}", row + 1)))
    }
}

impl<'v, V: Fn(&str) -> Option<&'v Value>> Filling<'_, V> {
    /// Writes the sheet's cells, value cells unlocked and validated; [`Layout::finish`] protects it, without a
    /// password.
    ///
    /// # Errors
    /// For a value that is not finite, and for a form that a workbook cannot hold.
    pub fn write(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<Layout, WriteError> {
        let language = self.language;
        sheet.set_name(self.sheet.name.get(language))?;
        for (column, width) in (0..).zip(WIDTHS) {
            sheet.set_column_width(column, width)?;
        }
        let header = self.write_head(sheet, styles)?;
        let mut layout = Layout { header, last: header, names: Vec::new(), heights: BTreeMap::new() };
        for section in self.sheet.sections {
            layout.last += 1;
            for column in SYMBOL..=RANGE {
                sheet.write_blank(layout.last, column, &styles.section)?;
            }
            write_text(sheet, layout.last, SYMBOL, section.title.get(language), &styles.section)?;
            for parameter in section.parameters {
                layout.last += 1;
                let height = self.write_parameter(sheet, styles, layout.last, parameter)?;
                layout.raise(layout.last, height);
                layout.names.push((parameter.name, layout.last));
            }
        }
        sheet.ignore_error_range(header, VALUE, layout.last, VALUE, IgnoreError::NumberStoredAsText)?;
        sheet.set_selection(header + 2, VALUE, header + 2, VALUE)?;
        Ok(layout)
    }

    /// Title, notes and column headings; returns the row of the headings.
    fn write_head(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<RowNum, WriteError> {
        static HEADINGS: [Text; 5] = [
            t("Símbolo", "Symbol"),
            t("Significado", "Meaning"),
            t("Valor", "Value"),
            t("Unidad", "Unit"),
            t("Intervalo admitido y nota", "Allowed range and note"),
        ];
        write_text(sheet, 0, SYMBOL, self.sheet.title.get(self.language), &styles.title)?;
        let mut row = 0;
        for note in self.notes.iter().filter(|note| !note.is_empty()) {
            row += 1;
            // Heights of merged cells are not fitted by a spreadsheet: the lines are counted here.
            let across: f64 = WIDTHS.iter().sum();
            sheet.merge_range(row, SYMBOL, row, RANGE, "", &styles.note)?;
            write_text(sheet, row, SYMBOL, note, &styles.note)?;
            sheet.set_row_height(row, row_height(&[(note, across)]))?;
        }
        row += 1;
        for (column, heading) in (0..).zip(&HEADINGS) {
            let format = if column == VALUE { &styles.number_header } else { &styles.header };
            write_text(sheet, row, column, heading.get(self.language), format)?;
        }
        Ok(row)
    }

    fn write_parameter(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        row: RowNum,
        parameter: &Parameter,
    ) -> Result<f64, WriteError> {
        let language = self.language;
        let meaning = parameter.meaning.get(language);
        let range = range_and_note(parameter, language);
        let value = (self.values)(parameter.key);
        let line = if let Some(Value::Line(line)) = value { line.as_str() } else { "" };
        sheet
            .set_row_height(row, row_height(&[(meaning, WIDTHS[1]), (line, WIDTHS[2]), (range.as_str(), WIDTHS[4])]))?;
        write_text(sheet, row, SYMBOL, parameter.symbol(), &styles.symbol)?;
        write_text(sheet, row, MEANING, meaning, &styles.text)?;
        write_text(sheet, row, UNIT, parameter.unit.label(), &styles.unit)?;
        write_text(sheet, row, RANGE, &range, &styles.faint)?;
        let format = match parameter.kind {
            FieldKind::Real { .. } | FieldKind::Whole { .. } => &styles.input_number,
            FieldKind::Choice(_) | FieldKind::Line { .. } | FieldKind::Date | FieldKind::Codes | FieldKind::Block => {
                &styles.input_text
            }
            FieldKind::Schema => &styles.fixed,
        };
        match value {
            Some(Value::Real(value)) if !value.is_finite() => {
                return Err(WriteError::NotFinite { place: parameter.key.to_owned() });
            }
            Some(Value::Real(value)) => {
                sheet.write_number_with_format(row, VALUE, *value, format)?;
            }
            Some(Value::Whole(value)) => {
                sheet.write_number_with_format(row, VALUE, *value, format)?;
            }
            Some(Value::Choice(key)) => {
                write_text(sheet, row, VALUE, label(parameter, key, language), format)?;
            }
            Some(Value::Line(text)) => write_text(sheet, row, VALUE, text, format)?,
            None => {
                sheet.write_blank(row, VALUE, format)?;
            }
        }
        if !matches!(parameter.kind, FieldKind::Schema) {
            let optional = !parameter.required || self.sheet.optional;
            sheet.add_data_validation(row, VALUE, row, VALUE, &validation(parameter, optional, language)?)?;
        }
        Ok(row_height(&[(meaning, WIDTHS[1]), (line, WIDTHS[2]), (range.as_str(), WIDTHS[4])]))
    }
}

/// What stands in the cell of a choice.
#[must_use]
pub fn label(parameter: &Parameter, key: &'static str, language: Language) -> &'static str {
    match parameter.kind {
        FieldKind::Choice(choices) => {
            choices.iter().find(|choice| choice.key == key).map_or(key, |choice| choice.label.get(language))
        }
        _ => key,
    }
}
