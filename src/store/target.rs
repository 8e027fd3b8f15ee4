//! What may not be replaced.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::reason::{refusal, shown, unwritable};
use super::rules::*;
use crate::finding::{Exit, Place, Raise, Refusal};

/// Checks that a file of a set may come under its final name.
///
/// # Errors
/// Exit 2 where it is one of `inputs`, also through another name or link; exit 5 where it is a symbolic link, a folder
/// or a device, or where Excel or LibreOffice have it open.
pub(super) fn check(target: &Path, inputs: &[PathBuf]) -> Result<(), Refusal> {
    let found = match fs::symlink_metadata(target) {
        Ok(found) => found,
        Err(error) if error.kind() == ErrorKind::NotFound => return check_open(target),
        Err(error) => return Err(unwritable(target, &error)),
    };
    let path = shown(target);
    if found.is_symlink() {
        return Err(refusal(&OutputIsLink { path }));
    }
    if !found.is_file() {
        return Err(refusal(&OutputIsNoFile { path }));
    }
    if inputs.iter().any(|input| same_file::is_same_file(input, target).unwrap_or(false)) {
        return Err(OutputIsInput { path }.refused(Exit::CommandLine, Place::File));
    }
    check_open(target)
}

/// Looks for the lock files that Excel and LibreOffice leave beside an open workbook.
fn check_open(target: &Path) -> Result<(), Refusal> {
    let Some(name) = target.file_name() else { return Ok(()) };
    for (program, lock) in [("Excel", joined("~$", name, "")), ("LibreOffice", joined(".~lock.", name, "#"))] {
        let lock = target.with_file_name(lock);
        if fs::symlink_metadata(&lock).is_ok() {
            let (path, lock) = (shown(target), shown(&lock));
            return Err(refusal(&OutputIsOpen { path, program, lock }));
        }
    }
    Ok(())
}

fn joined(before: &str, name: &OsStr, after: &str) -> OsString {
    let mut joined = OsString::from(before);
    joined.push(name);
    joined.push(after);
    joined
}
