//! Why a file could not be written, in words.

use std::io::{self, ErrorKind};
use std::path::Path;

use super::rules::*;
use crate::escape::printable_path;
use crate::finding::answer::answer;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::text::{Text, t};

/// The refusal for what the operating system answered.
pub(super) fn unwritable(path: &Path, error: &io::Error) -> Refusal {
    refusal(&*row(path, error, t("", "")))
}

/// The same where the files that were there before stand again.
pub(super) fn put_back(path: &Path, error: &io::Error) -> Refusal {
    refusal(&*row(path, error, t("; los archivos anteriores siguen en su sitio", "; the earlier files stay in place")))
}

/// The same where files stand in their new version beside others of before.
pub(super) fn mixed(path: &Path, error: &io::Error, stuck: String) -> Refusal {
    let plain = row(path, error, t("", ""));
    let mut refused = refusal(&SetMixed { failure: plain.what(), stuck });
    // What to do about the failure is its own row's.
    refused.findings.push(plain.at(Place::File));
    refused
}

/// The refusal of a set that cannot be written.
pub(super) fn refusal(row: &dyn Raise) -> Refusal {
    row.refused(Exit::Unwritable, Place::File)
}

/// A path for a person.
pub(super) fn shown(path: &Path) -> String {
    printable_path(path)
}

/// What is told of an answer of the operating system, and at the end of the sentence what became of the set.
fn row(path: &Path, error: &io::Error, after: Text) -> Box<dyn Raise> {
    let path = shown(path);
    match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => Box::new(DiskFull { path, after }),
        ErrorKind::FileTooLarge => Box::new(FileOverLimit { path, after }),
        ErrorKind::PermissionDenied => Box::new(NoPermissionToWrite { path, after }),
        ErrorKind::ReadOnlyFilesystem => Box::new(ReadOnly { path, after }),
        ErrorKind::NotFound => Box::new(NowhereToWrite { path, after }),
        ErrorKind::NotADirectory => Box::new(FileInPlaceOfFolder { path, after }),
        ErrorKind::IsADirectory => Box::new(FolderInPlaceOfFile { path, after }),
        ErrorKind::InvalidFilename => Box::new(NameNotAllowed { path, after }),
        ErrorKind::ResourceBusy => Box::new(FileBusy { path, after }),
        _ => Box::new(CannotWrite { path, reason: answer(error), after }),
    }
}
