//! How a sheet looks and is printed.

use std::ops::RangeInclusive;

use rust_xlsxwriter::{
    ColNum, DocProperties, ExcelDateTime, RowNum, Worksheet, XlsxError, utility::column_number_to_name,
};

use super::cell::{header_text, shortened};
use super::style::Styles;
use crate::text::{Language, Text, t};

const A4: u8 = 9;

/// So many rows of a sheet are printed whole: some twenty pages. Of more, the first and the last are.
pub const WHOLE: RowNum = 1_000;
/// So many rows are printed from either end: a page, upright.
pub const ENDS: RowNum = 45;
/// How large a table of many columns is printed, in percent: its figures are 7 to 8 pt high.
const WIDE: RangeInclusive<u16> = 62..=72;
/// What a page of A4 across has room for between its margins, mm; a little is kept back, for columns are set in whole pixels.
const ACROSS: f64 = 297.0 - 2.0 * 0.6 * 25.4 - 5.0;
/// The most characters of a note in a header: more would run into the sheet's name.
pub const NOTE: usize = 90;

/// A range of cells: first row and column, last row and column, from 0.
pub type Area = [(RowNum, ColNum); 2];

/// How sheets are written.
pub(super) struct SheetStyle<'a> {
    /// The formats.
    pub styles: &'a Styles,
    /// How they are printed.
    pub page: &'a Page<'a>,
    /// Their language.
    pub language: Language,
}

/// Areas of a sheet that are printed beside its first one, each on pages of its own.
#[derive(Debug)]
pub struct Further {
    /// The sheet, counted from 0.
    pub sheet: usize,
    /// The areas, in the order of their pages.
    pub areas: Vec<Area>,
}

impl Further {
    /// Sets what is printed of a sheet, counted from 0: everything where no area is given.
    ///
    /// # Errors
    /// For cells outside the sheet.
    pub fn set(sheet: &mut Worksheet, at: usize, areas: &[Area]) -> Result<Option<Self>, XlsxError> {
        let Some(([(row, column), (last_row, last_column)], further)) = areas.split_first() else { return Ok(None) };
        sheet.set_print_area(*row, *column, *last_row, *last_column)?;
        Ok((!further.is_empty()).then(|| Self { sheet: at, areas: further.to_vec() }))
    }

    /// The part of the workbook with these areas behind the sheet's first one: the library that writes workbooks takes one.
    #[must_use]
    pub fn put_into(&self, workbook: &str) -> String {
        let head = format!("<definedName name=\"_xlnm.Print_Area\" localSheetId=\"{}\">", self.sheet);
        let Some((before, rest)) = workbook.split_once(&head) else { return workbook.to_owned() };
        let Some((first, rest)) = rest.split_once('<') else { return workbook.to_owned() };
        let sheet = first.rsplit_once('!').map_or("", |(sheet, _)| sheet);
        let cell = |(row, column): (RowNum, ColNum)| format!("${}${}", column_number_to_name(column), row + 1);
        let areas = self.areas.iter().map(|[first, last]| format!(",{sheet}!{}:{}", cell(*first), cell(*last)));
        format!("{before}{head}{first}{}<{rest}", areas.collect::<String>())
    }
}

/// What the header of a table says of which only both ends are printed.
#[must_use]
pub fn both_ends(rows: usize) -> Text {
    Text::new(
        format!("De {rows} filas se imprimen las {ENDS} primeras y las {ENDS} últimas"),
        format!("Of {rows} rows the first and the last {ENDS} are printed"),
    )
}

/// What is printed on every page of a sheet.
#[derive(Clone, Copy, Debug)]
pub struct Page<'a> {
    /// The part's name, top left; may be empty.
    pub part: &'a str,
    /// Where the sheet comes from, bottom left; may be empty.
    pub origin: &'a str,
    /// First and last row repeated on every page, counted from 0.
    pub repeat: (RowNum, RowNum),
    /// Across instead of upright.
    pub landscape: bool,
    /// Everything on one page; else fitted across only.
    pub single: bool,
}

impl Page<'_> {
    /// Sets a sheet up for A4, fitted to one page across.
    ///
    /// # Errors
    /// For rows outside the sheet.
    pub fn set_up(&self, sheet: &mut Worksheet, language: Language) -> Result<(), XlsxError> {
        self.set_up_fitted(sheet, language);
        sheet.set_repeat_rows(self.repeat.0, self.repeat.1)?;
        Ok(())
    }

    /// Sets a sheet of many columns, whose widths are given in digits, up for A4 at a size that can be read, on as few pages across
    /// as the columns take at it, one beside the other; with the first rows and so many of the first columns on each.
    ///
    /// # Errors
    /// For rows or columns outside the sheet.
    pub fn set_up_wide(
        &self,
        sheet: &mut Worksheet,
        language: Language,
        widths: &[f64],
        columns: ColNum,
    ) -> Result<(), XlsxError> {
        self.set_up_columns(sheet, language);
        sheet.set_print_scale(wide(widths, columns.into()));
        // Across first: the library calls the order downwards the true one.
        sheet.set_page_order(false);
        sheet.set_repeat_rows(self.repeat.0, self.repeat.1)?;
        sheet.set_repeat_columns(0, columns.saturating_sub(1))?;
        Ok(())
    }

    /// Sets a sheet up for A4, fitted to one page across, without repeated rows.
    pub fn set_up_fitted(&self, sheet: &mut Worksheet, language: Language) {
        self.set_up_columns(sheet, language);
        sheet.set_print_fit_to_pages(1, u16::from(self.single));
    }

    /// Sets the header of a sheet, with a note below the name of the part.
    pub fn set_header(&self, sheet: &mut Worksheet, note: &str) {
        let note =
            if note.is_empty() { String::new() } else { format!("\n{}", shortened(note, NOTE).replace('&', "&&")) };
        sheet.set_header(format!("&L{}{note}&R&A", header_text(self.part)));
    }

    /// Sets a sheet up for A4 in its own size, without repeated rows.
    pub fn set_up_columns(&self, sheet: &mut Worksheet, language: Language) {
        static PAGES: Text = t("Página &P de &N", "Page &P of &N");
        sheet.set_paper_size(A4).set_margins(0.6, 0.6, 0.8, 0.7, 0.35, 0.35);
        if self.landscape {
            sheet.set_landscape();
        } else {
            sheet.set_portrait();
        }
        self.set_header(sheet, "");
        sheet.set_footer(format!("&L{}&R{}", header_text(self.origin), PAGES.get(language)));
    }
}

/// The size in percent at which columns of some widths in digits take the fewest pages across, so many of the first being
/// repeated on each; the largest such one.
fn wide(widths: &[f64], repeated: usize) -> u16 {
    // A digit of the usual font is 7 pixels wide, and a column has 5 more; 96 pixels make an inch.
    let mm = |width: &f64| (width * 7.0 + 5.0) * 25.4 / 96.0;
    let (first, rest) = widths.split_at(repeated.min(widths.len()));
    let first: f64 = first.iter().map(mm).sum();
    let pages = |scale: &u16| {
        let room = ACROSS * 100.0 / f64::from(*scale) - first;
        let (mut pages, mut left) = (1_u32, room);
        for width in rest.iter().map(mm) {
            if width > left {
                (pages, left) = (pages + 1, room);
            }
            left -= width;
        }
        pages
    };
    WIDE.rev().min_by_key(pages).unwrap_or(*WIDE.end())
}

/// The properties of a workbook: its title, and the same date for ever, so that equal input gives equal bytes.
///
/// # Errors
/// Never: the date is a valid one.
pub fn properties(title: &str) -> Result<DocProperties, XlsxError> {
    // The first day of the zip format's calendar: it stands for "no date", as in the package's own entries.
    let date = ExcelDateTime::from_ymd(1980, 1, 1)?;
    Ok(DocProperties::new().set_title(title).set_creation_datetime(&date))
}

#[cfg(test)]
mod tests {
    use super::wide;

    #[test]
    fn a_wide_table_is_printed_as_large_as_its_fewest_pages_allow() {
        // 260 mm at 72 % are 361 mm, some 190 digits in columns of 10; two columns are repeated.
        assert_eq!(wide(&[10.0; 18], 2), 72);
        assert_eq!(wide(&[10.0; 19], 2), 69);
        // At no size on one page: as large as two allow.
        assert_eq!(wide(&[10.0; 30], 2), 72);
    }
}
