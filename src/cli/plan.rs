//! Which folder each workbook's outputs go to, settled before anything is read.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use super::rules::*;
use crate::escape::printable_path;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::store;

/// One workbook with the place of its outputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Item {
    /// The workbook, as it was named.
    pub(super) workbook: PathBuf,
    /// How the names of its outputs begin.
    pub(super) stem: OsString,
    /// The folder of its outputs.
    pub(super) folder: PathBuf,
}

/// The workbooks with their folders: `output`, or `<stem>-out` beside each workbook.
///
/// # Errors
/// Exit 2 where a workbook is named twice, also through a link, or where the outputs of two would bear the same names,
/// letter case aside.
pub(super) fn items(workbooks: &[PathBuf], output: Option<&Path>) -> Result<Vec<Item>, Refusal> {
    twice(workbooks)?;
    if output.is_none() {
        workbooks.iter().try_for_each(|workbook| alone(workbook))?;
    }
    let items: Vec<_> = workbooks
        .iter()
        .map(|workbook| {
            let folder = output.map_or_else(|| folder(workbook), Path::to_owned);
            Item { workbook: workbook.clone(), stem: store::stem(workbook), folder }
        })
        .collect();
    let mut places = BTreeMap::new();
    for item in &items {
        let stem = item.stem.to_string_lossy().to_lowercase();
        if let Some(other) = places.insert((real(&item.folder), stem), item) {
            let (one, other) = (printable_path(&other.workbook), printable_path(&item.workbook));
            return Err(SameOutputs { one, other }.refused(Exit::CommandLine, Place::File));
        }
    }
    Ok(items)
}

/// The folder of a workbook's outputs where none is named: `<stem>-out` beside it.
pub(super) fn folder(workbook: &Path) -> PathBuf {
    beside(workbook).join(store::file_name(&store::stem(workbook), "-out"))
}

/// The folder that a file is in.
pub(super) fn beside(file: &Path) -> &Path {
    file.parent().unwrap_or(Path::new(""))
}

/// Refuses an input beside which another one stands whose outputs would bear the same names, because what may not stand
/// in a file name is replaced, or what is too long cut.
///
/// # Errors
/// Exit 2, naming both.
pub(super) fn alone(input: &Path) -> Result<(), Refusal> {
    store::namesake(input).map_or(Ok(()), |other| {
        let (one, other) = (printable_path(input), printable_path(&other));
        Err(SameOutputsBeside { one, other }.refused(Exit::CommandLine, Place::File))
    })
}

/// Refuses a workbook that is named twice.
///
/// # Errors
/// Exit 2, naming it.
pub(super) fn twice(workbooks: &[PathBuf]) -> Result<(), Refusal> {
    let mut seen = BTreeMap::new();
    for workbook in workbooks {
        if let Some(other) = seen.insert(real(workbook), workbook) {
            let (one, other) = (printable_path(other), printable_path(workbook));
            return Err(if one == other {
                NamedTwice { path: one }.refused(Exit::CommandLine, Place::File)
            } else {
                SameFile { one, other }.refused(Exit::CommandLine, Place::File)
            });
        }
    }
    Ok(())
}

/// A path without links and dots, as far as it exists.
#[expect(clippy::disallowed_methods, reason = "the door to the files that a build names")]
fn real(path: &Path) -> PathBuf {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    if let Ok(real) = fs::canonicalize(path) {
        return real;
    }
    match (path.parent(), path.file_name()) {
        (Some(parent), Some(name)) => real(parent).join(name),
        _ => path.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paths(names: &[&str]) -> Vec<PathBuf> {
        names.iter().map(PathBuf::from).collect()
    }

    #[test]
    fn outputs_go_beside_the_workbook_unless_a_folder_is_named() {
        let workbooks = paths(&["no-such/a.xlsx", "b.v2.xlsx"]);
        let folders =
            |output| items(&workbooks, output).expect("a plan").into_iter().map(|item| item.folder).collect::<Vec<_>>();
        assert_eq!(folders(None), paths(&["no-such/a-out", "b.v2-out"]));
        assert_eq!(folders(Some(Path::new("x"))), paths(&["x", "x"]));
    }

    #[test]
    fn one_workbook_twice_is_refused_however_it_is_named() {
        for names in [["a.xlsx", "a.xlsx"], ["./a.xlsx", "a.xlsx"]] {
            let refusal = items(&paths(&names), None).expect_err("a refusal");
            assert_eq!(refusal.exit, Exit::CommandLine, "{names:?}");
        }
    }

    #[test]
    fn outputs_of_one_name_are_refused() {
        let out = Path::new("out");
        assert!(items(&paths(&["no/a.xlsx", "na/a.xlsx"]), None).is_ok());
        assert!(items(&paths(&["no/a.xlsx", "na/a.xlsx"]), Some(out)).is_err());
        assert!(items(&paths(&["no/a.xlsx", "na/A.xlsx"]), Some(out)).is_err());
        assert!(items(&paths(&["a.xlsx", "a.xlsm"]), None).is_err());
        assert!(items(&paths(&["a:.xlsx", "a?.xlsx"]), Some(out)).is_err());
    }
}
