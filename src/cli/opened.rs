//! `build --open`: the report, or the folder where there is none, in the program that the desktop has for it.

use std::path::{Path, PathBuf};

use opener::OpenError;

use super::delivery::REPORT;
use super::rules::NotOpened;
use super::verdict::Verdict;
use crate::escape::{printable, printable_path};
use crate::finding::answer::{answer, quoted};
use crate::finding::{Finding, Place, Raise};

/// What is to be opened of a workbook that was built; none where nothing was written.
pub(super) fn chosen(verdict: &Verdict) -> Option<PathBuf> {
    let report = verdict.files.iter().find(|file| file.name.to_string_lossy().ends_with(REPORT));
    let folder = || verdict.folder.clone().filter(|_| !verdict.files.is_empty());
    // The folder of outputs in the current one is the empty path.
    let seen = |path: PathBuf| if path.as_os_str().is_empty() { PathBuf::from(".") } else { path };
    report.map(|file| file.path.clone()).or_else(folder).map(seen)
}

/// Opens it; a caution where the desktop has nothing to do so with.
pub(super) fn open(path: &Path) -> Option<Finding> {
    let error = opener::open(path).err()?;
    let told = |error: &OpenError| match error {
        OpenError::Io(error) => answer(error),
        error => quoted(printable(&error.to_string())),
    };
    Some(NotOpened { path: printable_path(path), reason: told(&error) }.at(Place::File))
}
