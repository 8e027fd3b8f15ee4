//! All findings as a sheet, coloured by grade.

use rust_xlsxwriter::{ColNum, RowNum, Worksheet};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::guard::Guard;
use super::page::{Page, SheetStyle};
use super::style::grade_fill;
use crate::finding::Finding;
use crate::kind::checks;
use crate::table::{Entry, Table};

/// The row of the column headings, from 0.
const HEADINGS: RowNum = 2;

/// Widths in characters: grade, code, place, what, value, limit, remedy.
const WIDTHS: [f64; 7] = [12.0, 8.0, 26.0, 54.0, 24.0, 24.0, 44.0];

/// The last column.
const LAST: ColNum = 6;

/// Writes the sheet of an outcome's checks: title, count by grade, and one row for each finding. As soon as an input was changed they are
/// struck out where `live` cells follow it.
///
/// # Errors
/// For more findings than a sheet has rows.
pub(super) fn write(
    sheet: &mut Worksheet,
    table: &Table,
    findings: &[Finding],
    &SheetStyle { styles, page, language }: &SheetStyle<'_>,
    guard: &Guard,
    live: bool,
) -> Result<(), WriteError> {
    write_text(sheet, 0, 0, table.title.get(language), &styles.title)?;
    let summary = checks::summary(findings);
    guard.banner(sheet, 1, [0, LAST], summary.get(language), language, [&styles.source, &styles.stale])?;
    for (at, (column, width)) in (0..).zip(table.columns.iter().zip(WIDTHS)) {
        write_text(sheet, HEADINGS, at, column.symbol.get(language), &styles.header)?;
        sheet.set_column_width(at, width)?;
    }
    let mut last = HEADINGS;
    for (index, finding) in findings.iter().enumerate() {
        last = HEADINGS + 1 + RowNum::try_from(index).map_err(|_| WriteError::TooLarge(table.key))?;
        let fill = grade_fill(finding.grade);
        let (plain, bold) =
            (styles.text.clone().set_background_color(fill), styles.symbol.clone().set_background_color(fill));
        let mut texts = Vec::new();
        for (at, (column, width)) in table.columns.iter().zip(WIDTHS).enumerate() {
            if let Entry::Text(text) = column.values.get(index) {
                let text = text.get(language);
                let to = ColNum::try_from(at).map_err(|_| WriteError::TooLarge(table.key))?;
                write_text(sheet, last, to, text, if at == 0 { &bold } else { &plain })?;
                texts.push((text, width));
            }
        }
        sheet.set_row_height(last, row_height(&texts))?;
    }
    sheet.set_freeze_panes(HEADINGS + 1, 0)?;
    if last > HEADINGS {
        sheet.autofilter(HEADINGS, 0, last, LAST)?;
        if live {
            guard.strike(sheet, [HEADINGS + 1, last], [0, LAST], &styles.left)?;
        }
    }
    Page { repeat: (HEADINGS, HEADINGS), landscape: true, ..*page }.set_up(sheet, language)?;
    Ok(())
}
