//! A comparison of two workbooks as a workbook: a sheet each for inputs, derived values, findings and programs.

use std::io::{Seek, Write};

use rust_xlsxwriter::{ColNum, RowNum, Workbook};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::listing::sheets;
use super::package::Package;
use super::page::{Page, properties};
use super::save::{Additions, save};
use super::style::{Styles, grade_fill};
use crate::finding::Grade;
use crate::kind::comparison::Comparison;
use crate::kind::comparison::sheets::{ComparedCell, NAMES, Sheet};
use crate::text::{Language, Text, t};

/// The row of the headings, from 0.
const HEADINGS: RowNum = 3;
/// The least and the greatest width of a column, in characters.
const WIDTH: [f64; 2] = [9.0, 60.0];

/// Writes a comparison; `names` are the files of A and B. Rows that differ are coloured. The same comparison gives the same
/// bytes.
///
/// # Errors
/// For a value that is not finite, and for what `out` refuses.
pub fn write<W: Write + Seek + Send>(
    comparison: &Comparison<'_>,
    names: [&str; 2],
    language: Language,
    out: W,
) -> Result<(), WriteError> {
    static TITLE: Text = t("Comparación", "Comparison");
    let (mut workbook, styles) = (Workbook::new(), Styles::default());
    workbook.set_properties(&properties(TITLE.get(language))?);
    let files = format!("A: {}   B: {}", names[0], names[1]);
    for sheet in comparison.sheets() {
        write_sheet(&mut workbook, &sheet, &files, language, &styles)?;
    }
    save(&mut workbook, Additions::default(), out)
}

/// True of a workbook that holds a comparison: its sheets bear these names, in one of the languages.
#[must_use]
pub fn is_comparison(bytes: &[u8]) -> bool {
    let listed = Package::open(bytes).and_then(|mut package| sheets(&mut package));
    let held: Vec<String> =
        listed.map(|found| found.sheets.into_iter().map(|sheet| sheet.name).collect()).unwrap_or_default();
    [Language::Es, Language::En].into_iter().any(|language| NAMES.iter().map(|name| name.get(language)).eq(&held))
}

fn write_sheet(
    workbook: &mut Workbook,
    table: &Sheet,
    files: &str,
    language: Language,
    styles: &Styles,
) -> Result<(), WriteError> {
    let sheet = workbook.add_worksheet().set_name(table.name.get(language))?;
    write_text(sheet, 0, 0, table.title.get(language), &styles.title)?;
    write_text(sheet, 1, 0, files, &styles.source)?;
    let fill = grade_fill(Grade::Caution);
    let coloured = styles.text.clone().set_background_color(fill);
    let numbers = [styles.number.clone(), styles.number.clone().set_background_color(fill)];
    let mut widths = Vec::new();
    for (at, heading) in table.headings.iter().enumerate() {
        let column = ColNum::try_from(at).map_err(|_| WriteError::TooLarge("comparison"))?;
        write_text(sheet, HEADINGS, column, heading.get(language), &styles.header)?;
        let longest = table.lines.iter().filter_map(|line| match line.cells.get(at) {
            Some(ComparedCell::Text(text)) => u16::try_from(text.get(language).chars().count()).ok(),
            Some(ComparedCell::Number(_)) => Some(12),
            _ => None,
        });
        let [least, most] = WIDTH;
        let width = f64::from(longest.max().unwrap_or_default() + 2).clamp(least, most);
        sheet.set_column_width(column, width)?;
        widths.push(width);
    }
    let mut last = HEADINGS;
    for line in &table.lines {
        last += 1;
        let mut texts = Vec::new();
        for ((column, held), width) in (0..).zip(&line.cells).zip(&widths) {
            let format = if line.differs { &coloured } else { &styles.text };
            match held {
                ComparedCell::Nothing => {
                    sheet.write_blank(last, column, format)?;
                }
                ComparedCell::Number(value) if value.is_finite() => {
                    sheet.write_number_with_format(last, column, *value, &numbers[usize::from(line.differs)])?;
                }
                ComparedCell::Number(_) => {
                    let place = format!("{}, row {}", table.name.get(language), last + 1);
                    return Err(WriteError::NotFinite { place });
                }
                ComparedCell::Text(text) => {
                    let text = text.get(language);
                    texts.push((text, *width));
                    write_text(sheet, last, column, text, format)?;
                }
            }
        }
        let height = row_height(&texts);
        if height > row_height(&[]) {
            sheet.set_row_height(last, height)?;
        }
    }
    if table.lines.is_empty() {
        static NONE: Text = t("Ninguna diferencia.", "No difference.");
        write_text(sheet, HEADINGS + 1, 0, NONE.get(language), &styles.source)?;
    } else {
        let columns = ColNum::try_from(table.headings.len()).map_err(|_| WriteError::TooLarge("comparison"))?;
        sheet.autofilter(HEADINGS, 0, last, columns.saturating_sub(1))?;
    }
    sheet.set_freeze_panes(HEADINGS + 1, 0)?;
    Page { part: "", origin: "", repeat: (HEADINGS, HEADINGS), landscape: true, single: false }
        .set_up(sheet, language)?;
    Ok(())
}
