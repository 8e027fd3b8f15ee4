//! How a sheet is printed.

use rust_xlsxwriter::{DocProperties, ExcelDateTime, RowNum, Worksheet, XlsxError};

use super::cell::header_text;
use crate::text::{Language, Text, t};

const A4: u8 = 9;

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

    /// Sets a sheet up for A4, fitted to one page across, without repeated rows.
    pub fn set_up_fitted(&self, sheet: &mut Worksheet, language: Language) {
        self.set_up_columns(sheet, language);
        sheet.set_print_fit_to_pages(1, u16::from(self.single));
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
        sheet.set_header(format!("&L{}&R&A", header_text(self.part)));
        sheet.set_footer(format!("&L{}&R{}", header_text(self.origin), PAGES.get(language)));
    }
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
