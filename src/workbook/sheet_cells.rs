//! The cells of one sheet, streamed: the first columns, A to E of a form, of the rows that hold something.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::Cursor;

use calamine::{DataRef, ExcelDateTime, ExcelDateTimeType, Xlsx};

use crate::escape::excerpt;
use crate::finding::{CellPlace, Exit, Place, Raise, Refusal};
use crate::number::decimal;

use super::address::{self, Position};
use super::book::unread;
use super::limits;
use super::rules::package::TooManyRows;
use super::survey::Survey;
use super::xml::damaged;

/// What a cell holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// A finite number.
    Number(f64),
    /// A text; of a long one the beginning, and how many characters it has, counted up to one more than a cell can
    /// hold.
    Text(String, usize),
    /// A truth value.
    Truth(bool),
    /// A date or a time: a number in a cell formatted as one; the day as `2026-11-23`, the number as a text where no spreadsheet has
    /// a day for it, empty where it says none; and the number where that is stored.
    Date(String, Option<f64>),
    /// An error of the spreadsheet, as `#DIV/0!`.
    Error(String),
}

/// A cell that holds something.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// What it holds.
    pub content: Content,
    /// True where it is formatted as a percentage.
    pub percent: bool,
}

/// The rows of a sheet: as many cells each as columns are read.
pub type Rows = BTreeMap<u32, Vec<Option<Cell>>>;

/// Texts of blanks alone, by their cells.
pub type Blanks = BTreeMap<Position, String>;

/// Where the columns of a form stand on a sheet, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Columns {
    /// The column of the symbols.
    pub symbol: u32,
    /// The column of the values.
    pub value: u32,
    /// The column of the units.
    pub unit: u32,
}

impl Columns {
    /// As a form is written: A, C and D.
    pub const WRITTEN: Self = Self { symbol: 0, value: 2, unit: 3 };
}

/// A sheet, as far as it is read.
#[derive(Debug)]
pub struct SheetCells {
    /// Where the columns of a form stand.
    pub columns: Columns,
    /// The sheet's name as it stands in the workbook.
    pub name: String,
    /// The rows that hold something in the columns that are read, by their index from 0.
    pub rows: Rows,
    /// The texts of blanks alone: empty as a value, but not as a formula sees a cell.
    pub blanks: Blanks,
    /// What the walk over its part saw.
    pub survey: Survey,
}

impl SheetCells {
    /// The cell of a row and a column, from 0; `None` where it is empty or not read.
    #[must_use]
    pub fn cell(&self, (row, column): Position) -> Option<&Cell> {
        self.rows.get(&row)?.get(usize::try_from(column).ok()?)?.as_ref()
    }

    /// The text of a cell, without blanks around it; `None` where it holds none.
    #[must_use]
    pub fn text(&self, position: Position) -> Option<&str> {
        match &self.cell(position)?.content {
            Content::Text(text, _) => Some(text.trim()).filter(|text| !text.is_empty()),
            _ => None,
        }
    }

    /// True where a cell holds this text.
    #[must_use]
    pub fn says(&self, text: &str) -> bool {
        self.rows
            .iter()
            .any(|(row, cells)| (0_u32..).take(cells.len()).any(|column| self.text((*row, column)) == Some(text)))
    }

    /// The columns of a form whose value of a symbol stands in a cell: the symbol stands to the left of it in its row, the
    /// heading of the units somewhere above.
    #[must_use]
    pub fn columns_about(&self, (row, value): Position, symbol: &str) -> Option<Columns> {
        let symbol = (0..value).rev().find(|column| self.text((row, *column)) == Some(symbol))?;
        let heads = |row: u32| {
            let cells = self.rows.get(&row).map_or(0, Vec::len);
            let mut columns = (0_u32..).take(cells);
            columns.find(|column| self.text((row, *column)).is_some_and(|text| ["Unit", "Unidad"].contains(&text)))
        };
        let unit = self.rows.range(..row).rev().find_map(|(row, _)| heads(*row)).unwrap_or(value + 1);
        Some(Columns { symbol, value, unit })
    }

    /// The place of a cell, for findings.
    #[must_use]
    pub fn place(&self, position: Position) -> CellPlace {
        CellPlace { sheet: self.name.clone(), cell: address::format(position) }
    }
}

/// The rows of a sheet that calamine may read: its survey found it sound. So many columns are read, from A on.
///
/// # Errors
/// [`Exit::Unreadable`] where calamine does not read the sheet; [`Exit::Limit`] for more than [`limits::ROWS`] rows.
pub fn stream(
    xlsx: &mut Xlsx<Cursor<Cow<'_, [u8]>>>,
    sheet: &str,
    part: &str,
    columns: u32,
) -> Result<(Rows, Blanks), Refusal> {
    let fault = |error: &calamine::XlsxError| damaged(part, &unread(error));
    let width = usize::try_from(columns).unwrap_or_default();
    let (mut rows, mut blanks) = (Rows::new(), Blanks::new());
    let mut reader = xlsx.worksheet_cells_reader(sheet).map_err(|error| fault(&error))?;
    let percentages: Vec<bool> = reader
        .styles()
        .iter()
        .map(|style| style.number_format.as_ref().is_some_and(|format| is_percentage(&format.format_code)))
        .collect();
    while let Some((cell, style)) = reader.next_cell_with_style_id().map_err(|error| fault(&error))? {
        let at @ (row, column) = cell.get_position();
        let Some(column) = usize::try_from(column).ok().filter(|column| *column < width) else { continue };
        let value = cell.get_value();
        let Some(content) = content(value) else {
            let text = match value {
                DataRef::String(text) => text.as_str(),
                DataRef::SharedString(text) => text,
                _ => "",
            };
            if !text.is_empty() && blanks.len() < limits::ROWS {
                blanks.insert(at, text.to_owned());
            }
            continue;
        };
        let percent = percentages.get(style).copied().unwrap_or_default();
        let kept = rows.entry(row).or_insert_with(|| vec![None; width]);
        if let Some(slot) = kept.get_mut(column) {
            *slot = Some(Cell { content, percent });
        }
        if rows.len() > limits::ROWS {
            let last = address::letters(columns.saturating_sub(1));
            let row = TooManyRows { sheet: excerpt(sheet, 80), most: limits::ROWS, last };
            return Err(row.refused(Exit::Limit, Place::Sheet(sheet.to_owned())));
        }
    }
    Ok((rows, blanks))
}

/// What is kept of a value; `None` for an empty one.
fn content(value: &DataRef<'_>) -> Option<Content> {
    let text = |text: &str| {
        let kept: String = text.chars().take(limits::TEXT).collect();
        // One shared text may stand in every cell, so a long one is neither counted nor trimmed whole.
        let characters = if text.len() > 4 * limits::CELL_TEXT {
            limits::CELL_TEXT + 1
        } else {
            text.chars().take(limits::CELL_TEXT + 1).count()
        };
        let blank = kept.len() == text.len() && kept.trim().is_empty();
        (!blank).then_some(Content::Text(kept, characters))
    };
    match value {
        DataRef::Empty => None,
        DataRef::Float(number) => Some(Content::Number(*number)),
        #[expect(clippy::cast_precision_loss, reason = "the reader takes whole numbers of .xlsx as floating point")]
        DataRef::Int(number) => Some(Content::Number(*number as f64)),
        DataRef::String(string) => text(string),
        DataRef::SharedString(string) => text(string),
        DataRef::Bool(truth) => Some(Content::Truth(*truth)),
        DataRef::DateTime(date) if date.is_datetime() => Some(Content::Date(day(*date), Some(date.as_f64()))),
        DataRef::DateTimeIso(date) => Some(Content::Date(date.split('T').next().unwrap_or_default().to_owned(), None)),
        DataRef::DateTime(date) => Some(Content::Date(String::new(), Some(date.as_f64()))),
        DataRef::DurationIso(_) => Some(Content::Date(String::new(), None)),
        DataRef::Error(error) => Some(Content::Error(error.to_string())),
    }
}

/// The day of a number as `2026-11-23`; the number itself where it is before the first day of the workbook's calendar or after the
/// year 9999, which calamine makes the nearest day that there is.
fn day(date: ExcelDateTime) -> String {
    let number = date.as_f64();
    let since_1904 = date == ExcelDateTime::new(number, ExcelDateTimeType::DateTime, true);
    let days = if since_1904 { 0.0..2_957_004.0 } else { 1.0..2_958_466.0 };
    if !days.contains(&number) {
        return decimal(number);
    }
    let (year, month, day, ..) = date.to_ymd_hms_milli();
    format!("{year:04}-{month:02}-{day:02}")
}

/// True for a number format that shows a hundredfold value: an unquoted `%` in its first section.
fn is_percentage(code: &str) -> bool {
    let mut quoted = false;
    let mut literal = false;
    for character in code.chars() {
        match character {
            _ if literal => literal = false,
            '\\' | '_' | '*' if !quoted => literal = true,
            '"' => quoted = !quoted,
            ';' if !quoted => return false,
            '%' if !quoted => return true,
            _ => {}
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_percentage_is_told_from_a_literal_percent_sign() {
        for code in ["0%", "0.00%", "#,##0.0 %", "0%;[Red]-0%"] {
            assert!(is_percentage(code), "{code}");
        }
        for code in ["General", "0.00", "0\"%\"", "0\\%", "0;0%"] {
            assert!(!is_percentage(code), "{code}");
        }
    }

    #[test]
    fn a_number_that_is_no_day_of_its_calendar_is_not_made_the_nearest_one() {
        for (number, since_1904, said) in [
            (46_349.0, false, "2026-11-23"),
            (46_349.75, false, "2026-11-23"),
            (1.0, false, "1900-01-01"),
            (60.0, false, "1900-02-29"),
            (2_958_465.9, false, "9999-12-31"),
            (2_958_466.0, false, "2958466"),
            (1e7, false, "10000000"),
            (0.0, false, "0"),
            (-5.0, false, "-5"),
            (0.0, true, "1904-01-01"),
            (2_957_003.0, true, "9999-12-31"),
            (2_957_004.0, true, "2957004"),
            (-5.0, true, "-5"),
        ] {
            let date = ExcelDateTime::new(number, ExcelDateTimeType::DateTime, since_1904);
            let held = content(&DataRef::DateTime(date));
            assert_eq!(held, Some(Content::Date(said.to_owned(), Some(number))), "{number} {since_1904}");
        }
    }

    #[test]
    fn a_long_text_is_counted_whole_and_kept_in_part() {
        let long = "ñ".repeat(2_000);
        match content(&DataRef::String(long)) {
            Some(Content::Text(kept, characters)) => {
                assert_eq!((kept.chars().count(), characters), (limits::TEXT, 2_000));
            }
            other => panic!("{other:?}"),
        }
    }
}
