//! One sheet of a form: the parameters with their values, to be filled in.
//!
//! Column A holds the symbol, B the meaning, C the value, D the unit, E the allowed range and a note; the sketch of the part
//! stands beside them. The same sheet stands in a new workbook and in a results workbook, so that results can be edited and
//! built again. Sections fold. A spreadsheet does not fold on a protected sheet: what is not to be written over is guarded cell
//! by cell.

use rust_xlsxwriter::{ColNum, DataValidation, Formula, IgnoreError, RowNum, Worksheet};

use super::cell::{row_height, write_text};
use super::drawn::Drawn;
use super::error::WriteError;
use super::guard::Guard;
use super::live_form::LivePart;
use super::page::Page;
use super::style::Styles;
use super::validation::{range_and_note, red, validation};
use crate::finding::CellPlace;
use crate::kind::live_form::LiveForm;
use crate::parameter::{FieldKind, Parameter, Section, Sheet, Value};
use crate::text::{Language, Text, t};

const SYMBOL: ColNum = 0;
const MEANING: ColNum = 1;
const VALUE: ColNum = 2;
const UNIT: ColNum = 3;
const RANGE: ColNum = 4;

/// The column where the sketch begins, and the width of the one before it in characters.
const SKETCH: ColNum = 6;
const GAP: f64 = 3.0;
/// The width in pixels of a column that was given none.
const PLAIN: u32 = 64;

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
    /// What tells in a banner whether the values are those that the programs were verified with.
    pub guard: Option<&'a Guard>,
    /// What is computed beside the values.
    pub live: Option<&'a LiveForm>,
    /// The sketch beside the values.
    pub sketch: Option<Drawn<'a>>,
    /// The language of everything but the values.
    pub language: Language,
}

/// Where things came to stand on a form's sheet.
#[derive(Clone, Debug)]
pub struct Layout {
    /// The row of the column headings, from 0.
    pub header: RowNum,
    /// The last row that a parameter stands in, from 0.
    pub last: RowNum,
    /// The last column that is printed.
    last_column: ColNum,
    /// The defined name and row of every value cell; all are in column C.
    pub names: Vec<(&'static str, RowNum)>,
    /// The defined names of what is computed beside them, with their cells.
    pub live: Vec<(String, String)>,
}

impl Layout {
    /// Sets panes and printing.
    ///
    /// # Errors
    /// For rows outside the sheet.
    pub fn finish(&self, sheet: &mut Worksheet, page: &Page<'_>, language: Language) -> Result<(), WriteError> {
        sheet.set_freeze_panes(self.header + 1, 0)?;
        sheet.set_print_area(0, SYMBOL, self.last, self.last_column)?;
        let landscape = self.last_column > RANGE;
        Page { repeat: (self.header, self.header), landscape, ..*page }.set_up(sheet, language)?;
        Ok(())
    }

    /// The cells of an input's symbol and of the heading above its value, on the sheet whose name is given.
    pub fn beside(&self, name: &str, sheet: &str) -> Option<[CellPlace; 2]> {
        let (_, row) = self.names.iter().find(|(own, _)| *own == name)?;
        let cell =
            |column: char, row: RowNum| CellPlace { sheet: sheet.to_owned(), cell: format!("{column}{}", row + 1) };
        Some([cell('A', *row), cell('C', self.header)])
    }

    /// The defined names with the cells they stand for, as `=DATOS!$C$7`.
    pub fn defined_names<'a>(&'a self, sheet: &'a str) -> impl Iterator<Item = (&'static str, String)> + 'a {
        let quoted = rust_xlsxwriter::quote_sheet_name(sheet);
        self.names.iter().map(move |(name, row)| (*name, format!("={quoted}!$C${}", row + 1)))
    }
}

impl<'v, V: Fn(&str) -> Option<&'v Value>> Filling<'_, V> {
    /// Writes the sheet's cells, value cells validated, the others guarded against being written over.
    ///
    /// # Errors
    /// For a value that is not finite, and for a form that a workbook cannot hold.
    pub fn write(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<Layout, WriteError> {
        let language = self.language;
        sheet.set_name(self.sheet.name.get(language))?;
        for (column, width) in (0..).zip(WIDTHS) {
            sheet.set_column_width(column, width)?;
        }
        sheet.group_symbols_above(true);
        let header = self.write_head(sheet, styles)?;
        let mut layout = Layout { header, last: header, last_column: RANGE, names: Vec::new(), live: Vec::new() };
        let mut sections = self.sheet.sections.iter().peekable();
        while let Some(section) = sections.next() {
            layout.last += 1;
            let title = layout.last;
            for column in SYMBOL..=RANGE {
                sheet.write_blank(title, column, &styles.section)?;
            }
            write_text(sheet, title, SYMBOL, &self.title(section), &styles.section)?;
            for parameter in section.parameters {
                layout.last += 1;
                self.write_parameter(sheet, styles, layout.last, parameter)?;
                layout.names.push((parameter.name, layout.last));
            }
            let (first, last) = (title + 1, layout.last);
            // A spreadsheet takes the row behind a group for its mark, or the one before it: only where the next group is
            // folded too, or there is none, do both see the same.
            match (self.folds(section), sections.peek().is_none_or(|next| self.folds(next))) {
                (false, _) => sheet.group_rows(first, last)?,
                (true, true) => sheet.group_rows_collapsed(first, last)?,
                (true, false) => {
                    for row in first..=last {
                        sheet.set_row_hidden(row)?;
                    }
                    sheet.group_rows(first, last)?
                }
            };
        }
        sheet.ignore_error_range(header, VALUE, layout.last, VALUE, IgnoreError::NumberStoredAsText)?;
        sheet.set_selection(header + 2, VALUE, header + 2, VALUE)?;
        self.guard(sheet, &layout)?;
        if let Some(sketch) = &self.sketch {
            sheet.set_column_width(SKETCH - 1, GAP)?;
            // On the row of the headings it would be printed again on every page.
            sketch.place(sheet, header + 1, SKETCH)?;
            let [width, _] = sketch.size();
            layout.last_column = SKETCH + ColNum::try_from(width / PLAIN).unwrap_or_default();
        }
        if let Some(live) = self.live_part() {
            layout.live = live.write(sheet, layout.header, &layout.names, styles)?;
        }
        Ok(layout)
    }

    /// What is computed beside the values, behind the sketch.
    fn live_part(&self) -> Option<LivePart<'_>> {
        let [width, _] = self.sketch.map_or([0, 0], |sketch| sketch.size());
        let column = SKETCH + ColNum::try_from(width / PLAIN).unwrap_or_default() + 2;
        self.live.map(|form| LivePart { form, sheet: self.sheet, column, language: self.language })
    }

    /// True for a section that may stay empty, and is: it comes folded.
    fn folds(&self, section: &Section) -> bool {
        section.optional && section.parameters.iter().all(|parameter| (self.values)(parameter.key).is_none())
    }

    /// The heading of a section.
    fn title(&self, section: &Section) -> String {
        static OPTIONAL: Text = t("opcional", "optional");
        let title = section.title.get(self.language);
        if section.optional { format!("{title} ({})", OPTIONAL.get(self.language)) } else { title.to_owned() }
    }

    /// Has every cell but those of values refuse what is typed over it.
    fn guard(&self, sheet: &mut Worksheet, layout: &Layout) -> Result<(), WriteError> {
        static TITLE: Text = t("Celda protegida", "Protected cell");
        static MESSAGE: Text = t(
            "Los valores van en las celdas amarillas de la columna C.",
            "Values go into the yellow cells of column C.",
        );
        let refused = DataValidation::new()
            .allow_custom(Formula::new("=FALSE"))
            .set_error_title(TITLE.get(self.language))?
            .set_error_message(MESSAGE.get(self.language))?;
        for [first, last] in [[SYMBOL, MEANING], [UNIT, RANGE]] {
            sheet.add_data_validation(layout.header, first, layout.last, last, &refused)?;
        }
        Ok(())
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
        if let Some(guard) = self.guard {
            row += 1;
            sheet.merge_range(row, SYMBOL, row, RANGE, "", &styles.source)?;
            guard.banner(sheet, row, [SYMBOL, RANGE], "", self.language, [&styles.source, &styles.stale])?;
        }
        if let Some(live) = self.live_part() {
            live.write_line(sheet, 0, [VALUE, RANGE], styles)?;
        }
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
    ) -> Result<(), WriteError> {
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
                write_text(sheet, row, VALUE, parameter.label(key, language), format)?;
            }
            Some(Value::Line(text)) => write_text(sheet, row, VALUE, text, format)?,
            None => {
                sheet.write_blank(row, VALUE, format)?;
            }
        }
        if !matches!(parameter.kind, FieldKind::Schema) {
            let optional = !parameter.required || self.sheet.optional;
            sheet.add_data_validation(row, VALUE, row, VALUE, &validation(parameter, optional, language)?)?;
            if let Some(red) = red(parameter, &format!("$C${}", row + 1), styles) {
                sheet.add_conditional_format(row, VALUE, row, VALUE, &red)?;
            }
        }
        Ok(())
    }
}
