//! A table of the method as a sheet.
//!
//! Row 1 is the title, row 2 the source, row 3 the symbols, row 4 the units; values stand from row 5 on, the point
//! index in column A. Values are stored whole and shown to the digits of their unit.

use rust_xlsxwriter::{ColNum, DataValidation, Format, RowNum, Worksheet};

use super::cell::{row_height, shortened, write_text};
use super::error::WriteError;
use super::guard::{self, Guard};
use super::live::{self, LiveTables, NOTHING};
use super::long_rows::{RowWriter, Rows};
use super::page::{Area, ENDS, Further, Page, WHOLE, both_ends};
use super::placed::FIRST;
use super::style::{Styles, digits};
use crate::table::{Cells, Column, Entry, Table};
use crate::text::{Language, Text, t};

/// The row of the symbols, from 0.
const SYMBOLS: RowNum = 2;
/// The row of the units, from 0.
const UNITS: RowNum = 3;

/// A table with more rows than this is streamed.
const LONG: usize = 2_000;

/// The widths of a column of numbers and of the index, in characters.
const NUMBER_WIDTH: f64 = 14.0;
const INDEX_WIDTH: f64 = 8.0;
/// The least and greatest width of a column of texts.
const TEXT_WIDTH: [f64; 2] = [14.0, 50.0];

/// The width of a column that was not given one.
const EMPTY_WIDTH: f64 = 8.43;
/// The widest print for the sake of a title or source.
const WIDEST: f64 = 120.0;

/// What the words of the guard take behind the source.
const SEALED: f64 = 20.0;

/// A sheet with fewer rows than this is printed on one page.
const ONE_PAGE: RowNum = 66;

/// More columns than this are printed across.
const UPRIGHT: usize = 6;
/// More columns of text than this, too: they are wide.
const TEXTS: usize = 3;

/// A table on its way to a sheet.
#[derive(Clone, Copy, Debug)]
pub struct TableSheet<'a> {
    /// The table that is written.
    pub table: &'a Table,
    /// The language of headings and texts.
    pub language: Language,
}

impl<'a> TableSheet<'a> {
    /// How many columns stand before the table's own: the index.
    #[must_use]
    pub const fn offset(&self) -> ColNum {
        if self.table.index.counted() { 1 } else { 0 }
    }

    /// The last row, from 0; the row of the units for an empty table.
    ///
    /// # Errors
    /// For a table longer than a sheet.
    pub fn last_row(&self) -> Result<RowNum, WriteError> {
        let rows = RowNum::try_from(self.table.rows()).map_err(|_| WriteError::TooLarge(self.table.key))?;
        Ok(UNITS + rows)
    }

    /// True where the rows are streamed.
    #[must_use]
    pub fn long(&self) -> bool {
        self.table.rows() > LONG
    }

    /// Writes the sheet; of a long table the headings and one row of formatted empty cells, to be replaced by
    /// [`TableSheet::rows`].
    ///
    /// # Errors
    /// For a value that is not finite, and for a table larger than a sheet.
    pub fn write(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        live: &LiveTables<'_>,
        guard: &Guard,
    ) -> Result<(), WriteError> {
        let (offset, source, last) = (self.offset(), live.source(self.table), self.last_row()?);
        write_text(sheet, 0, 0, self.table.title.get(self.language), &styles.title)?;
        let (source, grown) = (source.get(self.language), live.grown(self.table));
        let columns = [0, self.printed(source)?];
        let told = (source, grown.as_deref().map(|grown| (grown, last)));
        guard.banner_of_rows(sheet, 1, columns, told, self.language, [&styles.source, &styles.stale])?;
        if offset > 0 {
            write_text(sheet, SYMBOLS, 0, "i", &styles.number_header)?;
            write_text(sheet, UNITS, 0, "", &styles.number_unit)?;
            sheet.set_column_width(0, INDEX_WIDTH)?;
        }
        for (at, column) in self.table.columns.iter().enumerate() {
            self.write_head(sheet, column_number(at)? + offset, column, styles)?;
        }
        if self.long() {
            self.write_frame(sheet, styles)?;
        } else {
            self.write_rows(sheet, styles, live)?;
        }
        if live.on() { self.strike_values(sheet, styles, live, guard) } else { Ok(()) }
    }

    /// Strikes out the values when an input was changed, and what follows it only in part: among cells that follow, those of before would
    /// pass for new ones.
    fn strike_values(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        live: &LiveTables<'_>,
        guard: &Guard,
    ) -> Result<(), WriteError> {
        let number = |column: &Column| !matches!(column.values, Cells::Texts(_));
        // Where no points are counted, words before the first number name the rows; words alone are a verdict.
        let first = if self.table.index.counted() { None } else { self.table.columns.iter().position(number) };
        for (at, column) in self.table.columns.iter().enumerate().skip(first.unwrap_or_default()) {
            let to = column_number(at)? + self.offset();
            // What follows in part is so in the prepared rows, too.
            if column.in_part {
                let rows = RowNum::try_from(live.rows(self.table)).map_err(|_| WriteError::TooLarge(self.table.key))?;
                guard.strike(sheet, [FIRST, FIRST + rows - 1], [to, to], &styles.left)?;
                continue;
            }
            let follows = |row: usize| {
                let formula = column.live.as_ref().and_then(|live| live.get(row));
                formula.is_some_and(|formula| !formula.is_empty())
            };
            let mut from = None;
            for (row, at) in (FIRST..=self.last_row()? + 1).zip(0..) {
                let value = at < self.table.rows() && !follows(at);
                match from {
                    None if value => from = Some(row),
                    Some(first) if !value => {
                        guard.strike(sheet, [first, row - 1], [to, to], &styles.left)?;
                        from = None;
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    /// Sets panes and printing, when everything is written, of the sheet that stands at a place.
    ///
    /// # Errors
    /// For a table larger than a sheet.
    pub fn finish(
        &self,
        sheet: &mut Worksheet,
        at: usize,
        page: &Page<'_>,
        live: &LiveTables<'_>,
    ) -> Result<Option<Further>, WriteError> {
        sheet.set_freeze_panes(FIRST, self.offset())?;
        let last = self.last_row()?;
        let further = Further::set(sheet, at, &self.areas(live.source(self.table).get(self.language))?)?;
        let columns = &self.table.columns;
        let texts = columns.iter().filter(|column| matches!(column.values, Cells::Texts(_))).count();
        let landscape = columns.len() > UPRIGHT || texts > TEXTS;
        let single = last < ONE_PAGE;
        Page { repeat: (0, UNITS), landscape, single, ..*page }.set_up(sheet, self.language)?;
        if further.is_some() {
            page.set_header(sheet, both_ends(self.table.rows()).get(self.language));
        }
        Ok(further)
    }

    /// The areas that are printed: the whole, or both ends of a long table.
    fn areas(&self, source: &str) -> Result<Vec<Area>, WriteError> {
        let (last, column) = (self.last_row()?, self.printed(source)?);
        if self.table.rows() <= WHOLE as usize {
            return Ok(vec![[(0, 0), (last, column)]]);
        }
        Ok(vec![[(0, 0), (FIRST + ENDS - 1, column)], [(last + 1 - ENDS, 0), (last, column)]])
    }

    /// The last column to be printed: that of the table, or further to the right as title and source need.
    fn printed(&self, source: &str) -> Result<ColNum, WriteError> {
        // Bold letters of the title are wider than the digits that widths count.
        let title = 1.6 * count(self.table.title.get(self.language));
        let warning = f64::from(u16::try_from(guard::warning(self.language)).unwrap_or(u16::MAX));
        // The words that say that the inputs are verified follow the source.
        let source = count(source) + SEALED;
        let needed = title.max(source).max(warning).min(WIDEST);
        let mut width = f64::from(self.offset()) * INDEX_WIDTH;
        width += self.table.columns.iter().map(|column| self.width(column)).sum::<f64>();
        let mut last = (column_number(self.table.columns.len())? + self.offset()).saturating_sub(1);
        while width < needed {
            width += EMPTY_WIDTH;
            last += 1;
        }
        Ok(last)
    }

    /// Symbol, unit and width of a column; selecting the symbol shows how the values are computed.
    fn write_head(
        &self,
        sheet: &mut Worksheet,
        at: ColNum,
        column: &Column,
        styles: &Styles,
    ) -> Result<(), WriteError> {
        let symbol = column.symbol.get(self.language);
        let (header, unit) = match &column.values {
            Cells::Texts(_) => (&styles.text_header, &styles.unit),
            Cells::Numbers(_) | Cells::Component(..) => (&styles.number_header, &styles.number_unit),
        };
        write_text(sheet, SYMBOLS, at, symbol, header)?;
        write_text(sheet, UNITS, at, column.unit.label(), unit)?;
        sheet.set_column_width(at, self.width(column))?;
        if let Some(told) = column.law.told() {
            let shown = DataValidation::new()
                .allow_any_value()
                .set_input_title(shortened(symbol, 32))?
                .set_input_message(shortened(told, 255))?;
            sheet.add_data_validation(SYMBOLS, at, SYMBOLS, at, &shown)?;
        }
        Ok(())
    }

    /// The row of formatted empty cells.
    fn write_frame(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<(), WriteError> {
        if self.offset() > 0 {
            sheet.write_blank(FIRST, 0, &styles.index)?;
        }
        for (at, column) in self.table.columns.iter().enumerate() {
            sheet.write_blank(FIRST, column_number(at)? + self.offset(), &styles.values(column))?;
        }
        Ok(())
    }

    fn write_rows(&self, sheet: &mut Worksheet, styles: &Styles, live: &LiveTables<'_>) -> Result<(), WriteError> {
        let offset = self.offset();
        let looks: Vec<(f64, Format)> =
            self.table.columns.iter().map(|column| (self.width(column), styles.values(column))).collect();
        for (row, index) in (FIRST..=self.last_row()?).zip(0_u32..) {
            if offset > 0 {
                match live.index(self.table, row) {
                    Some(formula) => {
                        let formula = live::number(&formula, f64::from(index), String::new)?;
                        sheet.write_formula_with_format(row, 0, formula, &styles.index)?;
                    }
                    None => drop(sheet.write_number_with_format(row, 0, index, &styles.index)?),
                }
            }
            let mut texts = Vec::new();
            for ((at, column), (width, format)) in self.table.columns.iter().enumerate().zip(&looks) {
                let to = column_number(at)? + offset;
                let formula = live.cell(self.table, column.live.as_ref(), row)?;
                match (self.entry(column, row)?, formula) {
                    (Entry::Number(value), Some(formula)) => {
                        let formula = live::number(&formula, value, || self.place(column, row))?;
                        sheet.write_formula_with_format(row, to, formula, format)?;
                    }
                    (Entry::Number(value), None) if value.is_finite() => {
                        sheet.write_number_with_format(row, to, value, format)?;
                    }
                    (Entry::Number(_), None) => return Err(WriteError::NotFinite { place: self.place(column, row) }),
                    (Entry::Text(text), formula) => {
                        let text = text.get(self.language);
                        texts.push((text, *width));
                        match formula {
                            Some(formula) => {
                                sheet.write_formula_with_format(row, to, live::text(&formula, text), format)?;
                            }
                            None => write_text(sheet, row, to, text, format)?,
                        }
                    }
                }
            }
            // Rows of one line keep the sheet's own height.
            let height = row_height(&texts);
            if height > row_height(&[]) {
                sheet.set_row_height(row, height)?;
            }
        }
        self.write_spare_rows(sheet, styles, live)
    }

    /// The rows that are prepared for more points than there are, and what stands below them.
    fn write_spare_rows(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        live: &LiveTables<'_>,
    ) -> Result<(), WriteError> {
        static ENDS: Text = t("aquí acaban las filas: vuelva a generar", "the rows end here: build again");
        let rows = RowNum::try_from(live.rows(self.table)).map_err(|_| WriteError::TooLarge(self.table.key))?;
        let end = FIRST + rows;
        for row in self.last_row()? + 1..end {
            if let Some(formula) = live.index(self.table, row) {
                sheet.write_formula_with_format(row, 0, live::text(&formula, NOTHING), &styles.index)?;
            }
            for (at, column) in self.table.columns.iter().enumerate() {
                if let Some(formula) = live.cell(self.table, column.live.as_ref(), row)? {
                    let to = column_number(at)? + self.offset();
                    sheet.write_formula_with_format(row, to, live::text(&formula, NOTHING), &styles.values(column))?;
                }
            }
        }
        if let Some(formula) = live.end(self.table, ENDS.get(self.language)) {
            sheet.write_formula_with_format(end, 0, live::text(&formula, NOTHING), &styles.warning)?;
        }
        Ok(())
    }

    /// Streams the rows of a long table.
    #[must_use]
    pub fn rows(self) -> RowWriter<'a> {
        Box::new(move |rows: &mut Rows<'_>| {
            let offset = usize::from(self.offset());
            for (row, index) in (FIRST..=self.last_row()?).zip(0_u32..) {
                rows.start()?;
                if offset > 0 {
                    rows.number(0, f64::from(index))?;
                }
                for (at, column) in self.table.columns.iter().enumerate() {
                    match self.entry(column, row)? {
                        Entry::Number(value) => rows.number(at + offset, value)?,
                        Entry::Text(text) => rows.text(at + offset, &shortened(text.get(self.language), 32_767))?,
                    }
                }
            }
            Ok(())
        })
    }

    /// The entry of a column on a row of the sheet; a column shorter than the first is a fault.
    fn entry<'c>(&self, column: &'c Column, row: RowNum) -> Result<Entry<'c>, WriteError> {
        let at = usize::try_from(row.saturating_sub(FIRST)).map_err(|_| WriteError::TooLarge(self.table.key))?;
        if at < column.values.len() { Ok(column.values.get(at)) } else { Err(WriteError::Uneven(self.table.key)) }
    }

    /// The width of a column, in characters.
    fn width(&self, column: &Column) -> f64 {
        match &column.values {
            Cells::Texts(texts) => {
                let longest = texts.iter().map(|text| count(text.get(self.language))).fold(0.0, f64::max);
                let [least, most] = TEXT_WIDTH;
                (longest + 2.0).clamp(least, most)
            }
            Cells::Numbers(_) | Cells::Component(..) => {
                let decimals = digits(column.unit).split_once('.').map_or(0, |(_, decimals)| decimals.len());
                let numbers = (0..column.values.len()).filter_map(|row| match column.values.get(row) {
                    Entry::Number(value) => Some(value),
                    Entry::Text(_) => None,
                });
                let ends = numbers.fold([0.0_f64; 2], |[least, most], value| [least.min(value), most.max(value)]);
                // With room for a digit more: changed inputs give other values.
                ends.map(|end| count(&format!("{end:.decimals$}")) + 2.0).into_iter().fold(NUMBER_WIDTH, f64::max)
            }
        }
    }

    /// Where a value stands, for a message.
    fn place(&self, column: &Column, row: RowNum) -> String {
        format!("{}, {}, row {}", self.table.key, column.symbol.get(self.language), row + 1)
    }
}

/// The number of characters of a text.
fn count(text: &str) -> f64 {
    f64::from(u16::try_from(text.chars().count()).unwrap_or(u16::MAX))
}

/// A column's number on the sheet.
fn column_number(at: usize) -> Result<ColNum, WriteError> {
    ColNum::try_from(at).map_err(|_| WriteError::TooLarge("table"))
}

impl Styles {
    /// The format of a column's values.
    fn values(&self, column: &Column) -> Format {
        match column.values {
            Cells::Texts(_) => self.entry.clone(),
            Cells::Numbers(_) | Cells::Component(..) => Format::new().set_num_format(digits(column.unit)),
        }
    }
}
