//! The points that charts draw of tables whose rows follow an input.
//!
//! A chart has a fixed number of points: rows that show nothing would spoil its axes, and a range that is itself a formula is
//! lost by some spreadsheets. So points are picked from the table on a hidden sheet: all of them while there are at most as
//! many as were prepared, some of them twice.

use rust_xlsxwriter::{ColNum, RowNum, Workbook, utility::column_number_to_name};

use super::error::WriteError;
use super::live::{self, LiveTables};
use crate::table::{Cells, Entry, Table};
use crate::text::{Text, t};

/// The name of the sheet.
pub const NAME: &str = "Curves";
/// The same, in both languages.
pub static SHEET: Text = t(NAME, NAME);

/// The row of the names, and the first of the points, from 0.
const FIRST: RowNum = 1;

/// The columns that are drawn.
#[derive(Debug)]
pub struct Curves<'a> {
    live: LiveTables<'a>,
    sheet: String,
    /// Each a table and a column of it, its point index where that is `None`; and when the part has what is drawn.
    drawn: Vec<(&'a Table, Option<usize>, Option<&'static str>)>,
}

/// The cells of a chart: sheet, first row and column, last row and column, from 0.
pub type Range = (String, RowNum, ColNum, RowNum, ColNum);

impl<'a> Curves<'a> {
    /// None as yet, on a sheet of this name.
    pub const fn new(live: LiveTables<'a>, sheet: String) -> Self {
        Self { live, sheet, drawn: Vec::new() }
    }

    /// Where the picked points of a column stand; `None` where its table does not follow an input.
    ///
    /// # Errors
    /// For more columns than a sheet has.
    pub fn range(
        &mut self,
        table: &'a Table,
        column: Option<usize>,
        when: Option<&'static str>,
    ) -> Result<Option<Range>, WriteError> {
        if !self.live.on() || live::last(table.index).is_none() {
            return Ok(None);
        }
        let at = |one: &(&Table, Option<usize>, _)| one.0.key == table.key && (one.1, one.2) == (column, when);
        let place = self.drawn.iter().position(at).unwrap_or_else(|| {
            self.drawn.push((table, column, when));
            self.drawn.len() - 1
        });
        let place = ColNum::try_from(place).map_err(|_| WriteError::TooLarge(NAME))?;
        let points = RowNum::try_from(points(table)).map_err(|_| WriteError::TooLarge(table.key))?;
        Ok(Some((self.sheet.clone(), FIRST, place, FIRST + points, place)))
    }

    /// Writes the hidden sheet.
    ///
    /// # Errors
    /// For a value that is not finite.
    pub fn write(&self, workbook: &mut Workbook) -> Result<(), WriteError> {
        let sheet = workbook.add_worksheet().set_name(&self.sheet)?;
        sheet.set_hidden(true);
        for (place, (table, column, when)) in (0..).zip(&self.drawn) {
            let Some(count) = live::last(table.index) else { continue };
            let symbol = column.and_then(|at| table.columns.get(at)).map_or("i", |column| column.symbol.en.as_ref());
            sheet.write_string(0, place, format!("{} {symbol}", table.key))?;
            let (letter, points) = (column_number_to_name(place), points(table));
            let intervals = table.rows() - 1;
            for (row, k) in (FIRST..).zip(0..=points) {
                // Half a step goes away from zero, in the sheet and here.
                let at = (2 * k * intervals + points) / (2 * points);
                let step = format!("ROUND((ROWS({letter}$2:{letter}{})-1)*({count})/{points},0)", row + 1);
                let (formula, value) = match column {
                    None => (step, Entry::Number(f64::from(u32::try_from(at).unwrap_or(u32::MAX)))),
                    Some(column) => {
                        let of = &table.columns[*column];
                        let all = format!("INDEX([{}.{symbol} all],1+{step})", table.key);
                        (all, entry(&of.values, at))
                    }
                };
                // What a chart leaves out, where the part has lost what is drawn.
                let formula = match when {
                    Some(when) => format!("IF({when},{formula},NA())"),
                    None => formula,
                };
                let (Some(formula), Entry::Number(value)) = (self.live.along(table, &formula, "NA()")?, value) else {
                    continue;
                };
                let formula = live::number(&formula, value, || table.key.to_owned())?;
                sheet.write_formula(row, place, formula)?;
            }
        }
        Ok(())
    }
}

fn entry(cells: &Cells, row: usize) -> Entry<'_> {
    cells.get(row.min(cells.len().saturating_sub(1)))
}

/// How many intervals a chart draws of a table.
fn points(table: &Table) -> usize {
    (table.rows() - 1).max(100)
}
