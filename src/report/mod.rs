//! The typeset report: typst sets an outcome and its files as one PDF/A-3b, with the workbook and the programs as attachments. The
//! set-up sheet, the page for the machinist, is a second PDF.
//!
//! The templates of `report-templates/` are part of the library. Their contents arrive as JSON, as texts and numbers
//! ready to print, never as markup. A character that the fonts do not have is printed as its code point, and a note
//! says so.

mod attachments;
pub mod comparison;
mod contents;
mod document;
mod number;
pub mod rules;
mod shorten;
pub mod stationery;
mod svg;
pub mod sweep;
mod templates;
mod ticks;

use std::fs;
use std::path::Path;

use crate::finding::{Finding, Place, Raise};
use crate::kind::Outcome;
use crate::text::{Language, Text};
use crate::typeset::compiler::Typst;
use crate::typeset::failure::ReportFailure;
use crate::typeset::{MAIN, close};

use self::contents::{Contents, Manuscript};
use self::rules::TemplatesReplaceNothing;
use self::stationery::{Stationery, Template};

/// Where the bytes of an attachment are.
#[derive(Clone, Copy, Debug)]
pub enum Content<'a> {
    /// In memory.
    Bytes(&'a [u8]),
    /// In a file.
    File(&'a Path),
}

/// The role of a file in the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The workbook that everything was computed from.
    Input,
    /// The program with a key, as `blade`.
    Program(&'static str),
    /// Anything else that was written beside the report.
    Result,
    /// The same, listed with its SHA-256 and not attached: it would make the report large, and the workbook gives it again.
    Beside,
}

/// A file that the report lists with its SHA-256 and attaches.
#[derive(Clone, Debug)]
pub struct Attachment<'a> {
    /// The file's name, without folders.
    pub name: String,
    /// Its role in the report.
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
    /// The report, as the bytes of a PDF.
    pub pdf: Vec<u8>,
    /// The set-up sheet, a PDF of its own: the page of the report that is for the machinist.
    pub setup: Vec<u8>,
    /// The findings of setting them: characters without a glyph, files too large to attach.
    pub findings: Vec<Finding>,
}

/// The template of the set-up sheet.
const SETUP: &str = "setup-sheet.typ";

/// Sets the report of an outcome, and its set-up sheet from the same contents.
///
/// It works in a private temporary folder and removes it afterwards. It takes as long as typst, at most until the deadline. If typst
/// cannot draw the logo, the report is set a second time without it, with a caution.
///
/// # Errors
/// A [`ReportFailure`] if the folder cannot be filled, or if typst does not start, fails, hangs, or leaves no complete PDF.
pub fn typeset(
    outcome: &Outcome,
    attachments: &[Attachment<'_>],
    stationery: &Stationery<'_>,
    language: Language,
    typst: &Typst,
) -> Result<Report, ReportFailure> {
    let Stationery { logo, templates } = stationery;
    let contents = |logo, found| Contents { outcome, attachments, logo, found, language };
    let vain = !templates.is_empty() && templates::replace_nothing(outcome.kind, templates);
    let mut found: Vec<_> = vain.then(|| TemplatesReplaceNothing {}.at(Place::File)).into_iter().collect();
    let first = set(&contents(logo.as_ref(), found.clone()), templates, typst);
    let set = match (first, logo) {
        (Err(failure), Some(logo)) if failure.refused() => {
            found.push(outcome.fields.locate(logo.not_drawn()));
            set(&contents(None, found), templates, typst)
        }
        (first, _) => first,
    };
    set.map_err(|failure| if templates.is_empty() { failure } else { failure.of_own_templates() })
}

#[expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]
fn set(contents: &Contents<'_>, templates: &[Template], typst: &Typst) -> Result<Report, ReportFailure> {
    let folder = tempfile::Builder::new().prefix("rodete-").tempdir()?;
    templates::write(folder.path(), contents.outcome.kind, templates)?;
    let Manuscript { json, findings } = contents.write(folder.path())?;
    fs::write(folder.path().join("contents.json"), &json)?;
    // The sheet takes a quarter of the time of the report: side by side nobody waits for it.
    let (pdf, setup) = rayon::join(|| typst.compile(folder.path(), MAIN), || typst.compile(folder.path(), SETUP));
    let (pdf, setup) = (pdf?, setup?);
    close(folder)?;
    Ok(Report { pdf, setup, findings })
}
