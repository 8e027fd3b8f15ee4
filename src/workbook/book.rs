//! A gated workbook with its sheets ready to be read.

use std::borrow::Cow;
use std::io::Cursor;

use calamine::{Reader, Xlsx, XlsxError};

use crate::escape::printable;
use crate::finding::{Exit, Place, Raise, Refusal};

use super::gate::Gated;
use super::listing::SheetEntry;
use super::rules::package::WorkbookUnread;
use super::sheet_cells::{self, Columns, SheetCells};
use super::survey::survey;
use super::{limits, xml};

/// A workbook that passed the gate, opened by calamine.
pub struct Book<'a> {
    /// What the gate found.
    pub gated: Gated<'a>,
    xlsx: Xlsx<Cursor<Cow<'a, [u8]>>>,
}

/// What calamine says of a workbook, or of a sheet, that it does not take although the gate let it through.
pub fn unread(error: &XlsxError) -> WorkbookUnread {
    WorkbookUnread { reason: printable(&error.to_string()) }
}

impl<'a> Book<'a> {
    /// Hands a workbook that passed the gate to calamine.
    ///
    /// # Errors
    /// [`Exit::Unreadable`](crate::finding::Exit::Unreadable) where calamine does not take it.
    pub fn open(gated: Gated<'a>) -> Result<Self, Refusal> {
        let bytes = match gated.plain.as_slice() {
            [] => Cow::Borrowed(gated.package.bytes),
            parts => Cow::Owned(gated.package.with(parts)?),
        };
        let xlsx =
            Xlsx::new(Cursor::new(bytes)).map_err(|error| unread(&error).refused(Exit::Unreadable, Place::File))?;
        Ok(Self { gated, xlsx })
    }

    /// The cells of a sheet in so many columns, from A on. Where its survey found it unsound or empty, no cells but only the survey.
    ///
    /// # Errors
    /// Where the sheet's part is damaged as a whole.
    pub fn read(&mut self, sheet: &SheetEntry, columns: u32) -> Result<SheetCells, Refusal> {
        let bytes = self.gated.package.part(&sheet.part, limits::PART)?.unwrap_or_default();
        let text = xml::text(&sheet.part, bytes)?;
        let survey = survey(&sheet.name, &sheet.part, &text, self.gated.strings, columns)?;
        drop(text);
        let (rows, blanks) = if survey.unsound || !survey.filled {
            Default::default()
        } else {
            sheet_cells::stream(&mut self.xlsx, &sheet.name, &sheet.part, columns)?
        };
        Ok(SheetCells { columns: Columns::WRITTEN, name: sheet.name.clone(), rows, blanks, survey })
    }
}
