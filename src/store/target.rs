//! What may not be replaced.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::reason::{refusal, shown, unwritable};
use crate::finding::{Exit, Finding, Place, Refusal};
use crate::text::Text;

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
    let another = Text::fixed(
        "cámbiele el nombre, quítelo o elija otra carpeta (opción -o)",
        "rename it, remove it or choose another folder (option -o)",
    );
    if found.is_symlink() {
        return Err(refusal(
            Text::new(
                format!("{path} es un enlace simbólico, y no se escribe a través de enlaces"),
                format!("{path} is a symbolic link, and nothing is written through links"),
            ),
            another,
        ));
    }
    if !found.is_file() {
        return Err(refusal(
            Text::new(format!("{path} no es un archivo ordinario"), format!("{path} is not an ordinary file")),
            another,
        ));
    }
    if inputs.iter().any(|input| same_file::is_same_file(input, target).unwrap_or(false)) {
        return Err(Refusal::new(
            Exit::CommandLine,
            Finding::stop(
                Place::File,
                Text::new(
                    format!("{path} es a la vez entrada y salida: se perdería el libro"),
                    format!("{path} is both an input and an output: the workbook would be lost"),
                ),
                Text::fixed("elija otra carpeta (opción -o)", "choose another folder (option -o)"),
            ),
        ));
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
            return Err(refusal(
                Text::new(format!("{path} está abierto en {program}"), format!("{path} is open in {program}")),
                Text::new(
                    format!("ciérrelo en {program}; si no está abierto en ninguna parte, borre {lock}"),
                    format!("close it in {program}; if it is not open anywhere, delete {lock}"),
                ),
            ));
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
