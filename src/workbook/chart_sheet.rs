//! The charts on a sheet of their own, two on each printed page: beside long tables they are printed too small to be read.

use rust_xlsxwriter::{Chart, RowNum, Worksheet};

use super::charts::{HEIGHT, WIDTH};
use super::error::WriteError;
use super::guard::Guard;
use super::page::Page;
use super::style::Styles;
use crate::text::{Language, Text, t};

/// The sheet's name.
pub static NAME: Text = t("GRAFICOS", "CHARTS");

/// The height of a row in pixels.
const ROW: u32 = 20;
/// Charts on a printed page.
const ON_PAGE: u32 = 2;
/// How large it is printed, in percent: two charts fill an upright page.
const SCALE: u16 = 85;

/// Rows of a chart: a line that says which sheet it is of, the chart, and a gap.
const ROWS: RowNum = HEIGHT.div_ceil(ROW) + 2;

/// Writes the charts one below the other, each with the name of the sheet that its values stand on.
///
/// # Errors
/// For more charts than a sheet has rows.
pub fn write(
    sheet: &mut Worksheet,
    charts: &[(String, Chart)],
    language: Language,
    styles: &Styles,
    page: &Page<'_>,
    guard: &Guard,
) -> Result<(), WriteError> {
    sheet.set_column_width_pixels(0, WIDTH)?;
    let mut breaks = Vec::new();
    for (number, (name, chart)) in (0_u32..).zip(charts) {
        let row = number * ROWS;
        if number > 0 && number % ON_PAGE == 0 {
            breaks.push(row);
        }
        let from = Text::new(format!("De la hoja {name}"), format!("From the sheet {name}"));
        guard.banner(sheet, row, [0, 0], from.get(language), language, [&styles.source, &styles.stale])?;
        sheet.insert_chart(row + 1, 0, chart)?;
    }
    sheet.set_page_breaks(&breaks)?;
    page.set_up_columns(sheet, language);
    sheet.set_print_scale(SCALE);
    Ok(())
}
