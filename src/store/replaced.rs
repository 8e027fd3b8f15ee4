//! A workbook that is input and output at once: it is replaced where it stands, and kept once as it was before.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use super::draft::{Draft, sha256};
use super::folder::here;
use super::notice;
use super::reason::{refusal, shown, unwritable};
use super::rules::*;
use super::set::{Pending, Set, Written};
use super::target;
use crate::finding::Refusal;

/// What is put behind the name of a workbook that is kept.
pub(super) const KEPT: &str = ".bak";

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
    fn of(file: &Path, from: &Path) -> Self {
        let path = here(file.parent().unwrap_or(Path::new(""))).to_owned();
        let same = |other: &Path| same_file::is_same_file(&path, other).unwrap_or(false);
        let way = if same(from) {
            Some("")
        } else if same(&from.join("..")) {
            Some(notice::ABOVE)
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
fn kept(workbook: &Path) -> PathBuf {
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

impl Set<'_> {
    /// Replaces a workbook that was read, in the folder where it stands; `read` are the bytes that it had then. As it was before it is
    /// kept once, with `.bak` behind its name. It comes under its name last of all files of the set.
    ///
    /// # Errors
    /// As [`replaceable`]; exit 5 where the system does not take the contents.
    pub fn replace(&mut self, workbook: &Path, read: &[u8], contents: &[u8]) -> Result<(), Refusal> {
        let inputs: Vec<&Path> = self.inputs.iter().map(PathBuf::as_path).collect();
        replaceable(workbook, &inputs)?;
        let kept = kept(workbook);
        match fs::symlink_metadata(&kept) {
            Ok(_) => {}
            Err(_) => self.beside(&kept, workbook, read, None)?,
        }
        self.beside(workbook, workbook, contents, Some(sha256(read)))
    }

    /// Adds a file in the folder of a workbook, with the workbook's mode.
    fn beside(&mut self, path: &Path, like: &Path, contents: &[u8], before: Option<String>) -> Result<(), Refusal> {
        use std::io::Write;
        let (place, disk) = (self.folder.place(), self.folder.disk());
        let home = Home::of(path, place);
        let wrong = |error| unwritable(path, &error);
        let draft = Draft::new(&home.path, disk).map_err(wrong)?;
        let mut output = draft.output().map_err(wrong)?;
        let written = output.write_all(contents);
        output.finish().map_err(wrong)?;
        written.map_err(wrong)?;
        disk.permit(draft.path(), like).map_err(wrong)?;
        let (bytes, sha256) = draft.sum().map_err(wrong)?;
        let name = path.file_name().unwrap_or_default().to_owned();
        let written = Written { name, path: path.to_owned(), bytes, sha256 };
        self.pending.push(Pending { draft, written, home, before });
        Ok(())
    }
}
