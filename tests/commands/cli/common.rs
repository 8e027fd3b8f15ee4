//! Workbooks to work on, and the command.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use rodete::kinds::impeller::cases::CASES;
use rodete::parameter::Value;
use rodete::text::{Language, Text};
use rodete::workbook::template;
use tempfile::TempDir;

/// A folder of its own for a test.
pub fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// The command, run in a folder.
pub fn rodete(folder: &TempDir) -> Command {
    let mut command = Command::cargo_bin("rodete").expect("the binary");
    command.current_dir(folder.path()).env_remove("RODETE_TYPST").env("LC_ALL", "C");
    command
}

/// Writes an English workbook of the case `full`, which is computed at once, with some values changed.
pub fn workbook(path: &Path, changes: &[(&'static str, Value)]) {
    workbook_in(Language::En, path, changes);
}

/// Writes a workbook of the case `full` with some values changed.
pub fn workbook_in(language: Language, path: &Path, changes: &[(&'static str, Value)]) {
    let mut values = CASES.iter().find(|case| case.name == "full").expect("a case").values(language);
    for (key, value) in changes {
        values.retain(|(other, _)| other != key);
        values.push((key, value.clone()));
    }
    let file = File::create(path).expect("a workbook to write");
    template::write(rodete::kinds::KINDS[0], &values, &[], &Text::same(""), language, file).expect("a workbook");
}

/// A folder with `impeller.xlsx` of the case `full` in it.
pub fn with_impeller() -> TempDir {
    let folder = folder();
    workbook(&folder.path().join("impeller.xlsx"), &[]);
    folder
}

/// A folder with `impeller.xlsx` in it that is refused: there is no room for so many blades.
pub fn with_refused() -> TempDir {
    let folder = folder();
    workbook(&folder.path().join("impeller.xlsx"), &[("N", Value::Whole(40))]);
    folder
}

/// Every name in a folder, sorted.
pub fn names(folder: impl AsRef<Path>) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .expect("a readable folder")
        .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Every file of a folder with its contents, sorted.
pub fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    names(folder)
        .into_iter()
        .map(|name| (PathBuf::from(&name), fs::read(folder.join(&name)).expect("a readable file")))
        .collect()
}

/// The names of what a build without a report writes.
pub const OUTPUTS: [&str; 5] =
    ["impeller-blade.nc", "impeller-blank.nc", "impeller-impeller.nc", "impeller-results.xlsx", "impeller-splitter.nc"];
