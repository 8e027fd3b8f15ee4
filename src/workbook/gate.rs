//! The gate: what a file must be before a spreadsheet reader may see it.
//!
//! calamine trusts its input: it reserves memory for a declared count, does not mind a wrong checksum, and takes a sheet
//! in UTF-16 for an empty one. Whatever it relies on is therefore looked at here first, with this module's own walk over
//! the same parts.

use std::collections::{BTreeMap, BTreeSet};

use crate::escape::{excerpt, printable};
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::text::{Text, t};

use super::limits;
use super::listing::{self, Listing, SheetEntry};
use super::package::Package;
use super::rules::package::*;
use super::shared_tables::{self, structure};

/// A workbook that passed the gate.
#[derive(Debug)]
pub struct Gated<'a> {
    /// The package, whose entries and sizes are within the limits.
    pub package: Package<'a>,
    /// The sheets in their order.
    pub sheets: Vec<SheetEntry>,
    /// What the workbook's defined names stand for, by the names in lower case.
    pub names: BTreeMap<String, String>,
    /// The places of the sheets that have names of their own.
    pub own: BTreeSet<usize>,
    /// Parts that the reader gets in place of those of the package.
    pub plain: Vec<(String, Vec<u8>)>,
    /// How many shared texts there are.
    pub strings: usize,
    /// Notes on the file.
    pub notes: Vec<Finding>,
}

/// Lets a workbook through, or says why not.
///
/// # Errors
/// [`Exit::Unreadable`] for what is no sound `.xlsx` (old `.xls`, password, `.ods`, `.xlsb`, text, a cut or damaged
/// package, a document type, missing parts), [`Exit::Limit`] for what exceeds [`limits`].
pub fn gate(bytes: &[u8]) -> Result<Gated<'_>, Refusal> {
    signature(bytes)?;
    let mut package = Package::open(bytes)?;
    format(&mut package)?;
    let Listing { folder, sheets, names, own, plain } = listing::sheets(&mut package)?;
    let strings = shared_tables::strings(&mut package, &format!("{folder}sharedStrings.xml"))?;
    shared_tables::styles(&mut package, &format!("{folder}styles.xml"))?;
    structure(&mut package, &format!("{folder}theme/theme1.xml"), limits::ATTRIBUTE, |_, _| Ok(()))?;
    let mut notes = Vec::new();
    if package.has_ending("vbaproject.bin") {
        notes.push(MacrosNotRead {}.at(Place::File));
    }
    Ok(Gated { package, sheets, names, own, plain, strings, notes })
}

/// Judges the first bytes.
fn signature(bytes: &[u8]) -> Result<(), Refusal> {
    if bytes.is_empty() {
        return Err(FileEmpty {}.refused(Exit::Unreadable, Place::File));
    }
    if bytes.starts_with(b"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1") {
        return Err(OldOrProtected {}.refused(Exit::Unreadable, Place::File));
    }
    if !bytes.starts_with(b"PK") {
        let head: String = String::from_utf8_lossy(bytes.get(..64).unwrap_or(bytes)).chars().take(16).collect();
        let head = printable(head.lines().next().unwrap_or_default());
        if begins_a_program(bytes) {
            return Err(ProgramForWorkbook { head }.refused(Exit::Unreadable, Place::File));
        }
        return Err(NoWorkbook { head }.refused(Exit::Unreadable, Place::File));
    }
    Ok(())
}

/// True for a text whose first line begins as a program does: with a percent sign, a number of program or block, a G word or a
/// comment.
fn begins_a_program(bytes: &[u8]) -> bool {
    let line = bytes.trim_ascii_start().split(|byte| b"\r\n".contains(byte)).next().unwrap_or_default();
    match line {
        [b'%' | b'(', ..] => true,
        [b'O' | b'o' | b'N' | b'n' | b'G' | b'g' | b':', digit, ..] => digit.is_ascii_digit(),
        _ => false,
    }
}

/// Names the packages that are no `.xlsx`.
fn format(package: &mut Package<'_>) -> Result<(), Refusal> {
    let named = |format: Text| OtherFormat { format }.refused(Exit::Unreadable, Place::File);
    let other = |format: &str| named(Text::same(format));
    if let Some(mime) = package.part("mimetype", limits::STRUCTURE)? {
        let mime = String::from_utf8_lossy(&mime);
        if mime.contains("opendocument.spreadsheet") {
            return Err(other("OpenDocument (.ods)"));
        }
        return Err(other(&excerpt(mime.trim(), 60)));
    }
    if package.has("xl/workbook.bin") {
        return Err(other("Excel (.xlsb)"));
    }
    if package.has_beginning("word/") {
        return Err(other("Office (.docx)"));
    }
    if package.has_beginning("ppt/") {
        return Err(other("Office (.pptx)"));
    }
    if !package.has("[Content_Types].xml") {
        return Err(named(t(".zip", "archive (.zip)")));
    }
    structure(package, "[Content_Types].xml", limits::ATTRIBUTE, |_, _| Ok(()))?;
    Ok(())
}
