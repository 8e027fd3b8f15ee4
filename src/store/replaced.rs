//! A workbook that is input and output at once: it is replaced where it stands, and kept once as it was before.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use super::disk::here;
use super::notice::{ABOVE, KEPT};
use super::reason::{refusal, shown, unwritable};
use super::rules::*;
use super::target;
use crate::finding::Refusal;

/// A folder beside the one of a set.
#[derive(Clone, Debug)]
pub(super) struct Home {
    /// Its path.
    pub(super) path: PathBuf,
    /// The way to it from the set's folder: nothing or `../`. `None` where it is elsewhere: no notice tells of files there.
    pub(super) way: Option<&'static str>,
}

impl Home {
    /// The folder of the set itself.
    pub(super) fn own(path: &Path) -> Self {
        Self { path: path.to_owned(), way: Some("") }
    }

    /// The folder of a file, as it is reached from another.
    pub(super) fn of(file: &Path, from: &Path) -> Self {
        let path = here(file.parent().unwrap_or(Path::new(""))).to_owned();
        let same = |other: &Path| same_file::is_same_file(&path, other).unwrap_or(false);
        let way = if same(from) {
            Some("")
        } else if same(&from.join("..")) {
            Some(ABOVE)
        } else {
            None
        };
        Self { path, way }
    }

    /// True where it is not the set's own.
    pub(super) fn is_other(&self) -> bool {
        self.way != Some("")
    }
}

/// The workbook with the ending of one that is kept.
pub(super) fn kept(workbook: &Path) -> PathBuf {
    let mut path = OsString::from(workbook);
    path.push(KEPT);
    path.into()
}

/// Checks that a workbook may be replaced, before the work that changes it is done. `inputs` are files that no output may replace;
/// it may be among them.
///
/// # Errors
/// Exit 5 where it is a link, no ordinary file, write-protected, or open in Excel or LibreOffice.
pub fn replaceable(workbook: &Path, inputs: &[&Path]) -> Result<(), Refusal> {
    let others: Vec<PathBuf> = inputs
        .iter()
        .filter(|input| !same_file::is_same_file(input, workbook).unwrap_or(false))
        .map(|&input| input.to_owned())
        .collect();
    target::check(workbook, &others)?;
    let found = fs::metadata(workbook).map_err(|error| unwritable(workbook, &error))?;
    if found.permissions().readonly() {
        return Err(refusal(&BookReadOnly { path: shown(workbook) }));
    }
    // A folder or a link is no copy of it.
    let kept = kept(workbook);
    if fs::symlink_metadata(&kept).is_ok_and(|found| !found.is_file()) {
        target::check(&kept, &[])?;
    }
    Ok(())
}

/// The copy of a workbook that is kept, where there is one already.
#[must_use]
pub fn copy_of(workbook: &Path) -> Option<PathBuf> {
    Some(kept(workbook)).filter(|kept| kept.is_file())
}
