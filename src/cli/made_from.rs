//! The workbook that a program was made from: whether it is still the same.

use std::path::Path;

use super::plan::beside;
use super::rules::*;
use crate::escape::{printable, printable_path};
use crate::finding::{Finding, Place, Raise};
use crate::gcode::header::NamedWorkbook;
use crate::graft;
use crate::limits::FOLDER_ENTRIES;
use crate::store;
use crate::workbook::{self, Input};

/// What the head of a program says of its workbook, compared with the workbooks of that name beside the program and in the
/// folder above; `None` of a program that names none. Of several with the name one that is the same counts.
#[expect(clippy::disallowed_methods, reason = "the door to the workbook that a program was made from")]
pub(super) fn compared(program: &Path, head: &[u8]) -> Option<Finding> {
    let named = NamedWorkbook::of(head)?;
    // Without its links and dots a folder has the folder above that it is in.
    let folder = match beside(program) {
        folder if folder.as_os_str().is_empty() => Path::new("."),
        folder => folder,
    };
    let above = folder.canonicalize().ok().and_then(|folder| folder.parent().map(Path::to_owned));
    let mut changed = None;
    for folder in [Some(folder), above.as_deref()].into_iter().flatten() {
        let entries = folder.read_dir().into_iter().flatten().take(FOLDER_ENTRIES).flatten();
        let mut names: Vec<_> = entries.map(|entry| entry.file_name()).collect();
        names.sort();
        for name in names {
            let shown = printable(&name.to_string_lossy());
            if !named.is(&shown) {
                continue;
            }
            let path = folder.join(&name);
            // What cannot be read is as good as not there.
            let Ok(bytes) = workbook::open_as(Input::Workbook, &path) else { continue };
            let made_from = || graft::made_from(&bytes);
            // A workbook that its own results went into is another file since, and says which one it was.
            if store::sha256(&bytes) == named.sha256 || made_from().is_some_and(|one| one == named.sha256) {
                return Some(WorkbookUnchanged { workbook: shown }.at(Place::File));
            }
            changed.get_or_insert(shown);
        }
    }
    Some(match changed {
        Some(workbook) => WorkbookChanged { workbook }.at(Place::File),
        None => WorkbookNotThere { workbook: printable_path(Path::new(named.name())) }.at(Place::File),
    })
}
