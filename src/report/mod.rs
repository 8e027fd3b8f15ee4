//! The typeset report: an outcome and the files made of it, set by typst into one PDF/A-3b that carries the workbook
//! and the programs as attachments.
//!
//! The templates of `report-templates/` are part of the library; what they set arrives as JSON, as texts and numbers
//! ready to print, and never as markup. A character that the fonts cannot show is shown by its code point, and a note
//! says so.

mod attachments;
pub mod characters;
mod compiler;
mod contents;
mod document;
mod failure;
mod number;
pub(crate) mod pen;
mod shorten;
pub(crate) mod svg;
mod templates;
mod ticks;

use std::fs;
use std::path::Path;

use tempfile::TempDir;

pub use self::compiler::{DEADLINE, Typst};
pub use self::failure::{Ending, ReportFailure, TYPST_VERSION};

use crate::finding::Finding;
use crate::job::Outcome;
use crate::text::{Language, Text};

/// Where the bytes of an attachment are.
#[derive(Clone, Copy, Debug)]
pub enum Content<'a> {
    /// In memory.
    Bytes(&'a [u8]),
    /// In a file.
    File(&'a Path),
}

/// What a file is to the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The workbook that everything was computed from.
    Input,
    /// The program with a key, as `blade`.
    Program(&'static str),
    /// Anything else that was written beside the report.
    Result,
    /// The same, listed with its SHA-256 and not carried: what would make the report large, and comes of the workbook again.
    Beside,
}

/// A file that the report lists with its SHA-256 and carries.
#[derive(Clone, Debug)]
pub struct Attachment<'a> {
    /// The file's name, without folders.
    pub name: String,
    /// What it is to the report.
    pub role: Role,
    /// The media type, as `text/plain`.
    pub mime: &'static str,
    /// What it is.
    pub description: Text,
    /// Its bytes.
    pub content: Content<'a>,
}

/// A finished report.
#[derive(Debug)]
pub struct Report {
    /// The PDF.
    pub pdf: Vec<u8>,
    /// What was found while it was made: characters without a glyph, files too large to be carried.
    pub findings: Vec<Finding>,
}

/// The template that the report begins with.
const MAIN: &str = "report.typ";

/// Sets a document of its own from files by name, the first of them the one that typst reads first.
///
/// Works in a private temporary folder, which is gone afterwards; takes as long as typst takes, at most its deadline.
///
/// # Errors
/// As [`typeset`].
pub(crate) fn document(files: &[(String, Vec<u8>)], typst: &Typst) -> Result<Vec<u8>, ReportFailure> {
    let folder = tempfile::Builder::new().prefix("rodete-").tempdir()?;
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes)?;
    }
    let main = files.first().map_or(MAIN, |(name, _)| name);
    let pdf = typst.compile(folder.path(), main)?;
    close(folder)?;
    Ok(pdf)
}

/// Sets the report of an outcome.
///
/// Works in a private temporary folder, which is gone afterwards; takes as long as typst takes, at most its deadline.
///
/// # Errors
/// A [`ReportFailure`] when the folder cannot be filled, typst cannot be started, fails, hangs, or leaves no whole PDF.
pub fn typeset(
    outcome: &Outcome,
    attachments: &[Attachment<'_>],
    language: Language,
    typst: &Typst,
) -> Result<Report, ReportFailure> {
    let folder = tempfile::Builder::new().prefix("rodete-").tempdir()?;
    let contents = contents::write(outcome, attachments, language, folder.path())?;
    templates::write(folder.path())?;
    fs::write(folder.path().join("contents.json"), &contents.json)?;
    let pdf = typst.compile(folder.path(), MAIN)?;
    close(folder)?;
    Ok(Report { pdf, findings: contents.findings })
}

/// Removes the folder now, so that what cannot be removed is told and not left behind in silence.
fn close(folder: TempDir) -> Result<(), ReportFailure> {
    Ok(folder.close()?)
}
