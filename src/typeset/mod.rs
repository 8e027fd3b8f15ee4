//! Typesetting: files by name go in, one PDF comes out, or the reason why not.
//!
//! Typst runs as a child process in a private temporary folder, under a deadline.

pub mod characters;
pub mod compiler;
#[cfg(feature = "embedded-typst")]
pub(crate) mod embedded;
pub mod failure;
pub(crate) mod mark;
pub(crate) mod pen;
pub mod rules;

use std::fs;

use tempfile::TempDir;

use crate::typeset::compiler::Typst;
use crate::typeset::failure::ReportFailure;

/// The template that the report begins with.
pub(crate) const MAIN: &str = "report.typ";

/// Sets a document of its own from files by name, the first of them the one that typst reads first.
///
/// Works in a private temporary folder, which is gone afterwards; takes as long as typst takes, at most its deadline.
///
/// # Errors
/// A [`ReportFailure`] when the folder cannot be filled, typst cannot be started, fails, hangs, or leaves no whole PDF.
#[expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]
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

/// Removes the folder now, so that what cannot be removed is reported and not left behind in silence.
pub(crate) fn close(folder: TempDir) -> Result<(), ReportFailure> {
    Ok(folder.close()?)
}
