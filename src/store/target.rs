//! What may not be replaced.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

use super::reason::{refusal, shown, unwritable};
use super::rules::*;
use crate::escape::excerpt;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::limits::LOCK_BYTES;
use crate::text::{Text, t};

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
        if let Ok(found) = fs::symlink_metadata(&lock) {
            let mut bytes = Vec::new();
            if found.is_file()
                && let Ok(file) = File::open(&lock)
            {
                // Excel may not let others read it: then its owner is not known.
                let _ = file.take(LOCK_BYTES).read_to_end(&mut bytes);
            }
            let owner = if program == "Excel" { owner_of_excel(&bytes) } else { owner_of_libreoffice(&bytes) };
            let owner = excerpt(owner.trim(), 60);
            let owner = if owner.is_empty() { t("", "") } else { Text::same(format!(" ({owner})")) };
            let (path, lock) = (shown(target), shown(&lock));
            return Err(refusal(&OutputIsOpen { path, program, owner, lock }));
        }
    }
    Ok(())
}

/// The name in Excel's lock file: its length and its letters in 54 bytes, then once more with two bytes a letter.
fn owner_of_excel(bytes: &[u8]) -> String {
    let wide = bytes.get(55..).and_then(|rest| {
        let count = usize::from(u16::from_le_bytes([*rest.first()?, *rest.get(1)?]));
        let letters: Vec<u16> =
            rest.get(2..2 + 2 * count)?.chunks_exact(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).collect();
        String::from_utf16(&letters).ok().filter(|name| !name.trim().is_empty())
    });
    let narrow = || {
        let count = usize::from(*bytes.first()?);
        Some(String::from_utf8_lossy(bytes.get(1..=count.min(54))?).into_owned())
    };
    wide.or_else(narrow).unwrap_or_default()
}

/// The name in LibreOffice's lock file: fields with commas between them, a name, the user's and the machine's first.
fn owner_of_libreoffice(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let fields: Vec<&str> = text.split(',').take(3).map(str::trim).filter(|field| !field.is_empty()).collect();
    fields.join(", ")
}

fn joined(before: &str, name: &OsStr, after: &str) -> OsString {
    let mut joined = OsString::from(before);
    joined.push(name);
    joined.push(after);
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_file_names_its_owner() {
        let mut excel = vec![3, b'A', b'n', b'a'];
        excel.resize(55, b' ');
        assert_eq!(owner_of_excel(&excel), "Ana");
        excel.extend([5, 0]);
        excel.extend("Begoñ".encode_utf16().flat_map(u16::to_le_bytes));
        assert_eq!(owner_of_excel(&excel), "Begoñ");
        assert_eq!(
            owner_of_libreoffice(b"Ana Gil,ana,taller,23.11.2026 10:00,file:///home/ana;"),
            "Ana Gil, ana, taller"
        );
        assert_eq!((owner_of_excel(b""), owner_of_libreoffice(b"")), (String::new(), String::new()));
        assert_eq!(owner_of_excel(&[200, b'x']), "");
    }
}
