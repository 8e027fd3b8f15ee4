//! The one place that opens a path for reading.

#![expect(clippy::disallowed_methods, reason = "the door by which workbooks come in")]

use std::fs::{self, File};
use std::io::{self, BufReader, ErrorKind, Read};
use std::path::{Path, PathBuf};

use crate::escape::{printable, printable_path};
use crate::finding::answer::answer;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::limits::{FOLDER_ENTRIES, LISTED_FILES};
use crate::text::{Text, t};

use super::limits;
use super::rules::file::*;

/// A kind of file that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// A workbook, `.xlsx`.
    Workbook,
    /// LinuxCNC's parameter file.
    VarFile,
    /// LinuxCNC's tool table.
    ToolTable,
    /// An ISO program.
    Program,
}

impl Input {
    /// What it is called, as the object of "name".
    const fn named(self) -> Text {
        match self {
            Self::Workbook => t("el libro .xlsx", "the .xlsx workbook"),
            Self::VarFile => t("el archivo .var", "the .var file"),
            Self::ToolTable => t("la tabla de herramientas", "the tool table"),
            Self::Program => t("el programa ISO", "the ISO program"),
        }
    }

    /// How names of its kind end.
    const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Workbook => &[".xlsx", ".xlsm"],
            Self::VarFile => &[".var"],
            Self::ToolTable => &[".tbl"],
            Self::Program => &[".nc", ".ngc"],
        }
    }
}

/// The bytes of a workbook's file; see [`open_as`].
///
/// # Errors
/// As [`open_as`].
pub fn open(path: &Path) -> Result<Vec<u8>, Refusal> {
    open_as(Input::Workbook, path)
}

/// The bytes of a file, read once: what happens to the file afterwards changes nothing.
///
/// # Errors
/// Refuses with [`Exit::Unreadable`] a path that is missing, no regular file or may not be read, and with
/// [`Exit::Limit`] a file of more than [`limits::FILE`] bytes.
pub fn open_as(input: Input, path: &Path) -> Result<Vec<u8>, Refusal> {
    let metadata = regular(input, path)?;
    if metadata.len() > limits::FILE {
        return Err(too_large(input, path));
    }
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(limits::FILE + 1).read_to_end(&mut bytes))
        .map_err(|error| unopened(input, path, &error))?;
    if u64::try_from(bytes.len()).is_ok_and(|length| length <= limits::FILE) {
        Ok(bytes)
    } else {
        Err(too_large(input, path))
    }
}

/// What is known of a regular file.
fn regular(input: Input, path: &Path) -> Result<fs::Metadata, Refusal> {
    // Asked before opening: opening a pipe would wait for a writer.
    let metadata = fs::metadata(path).map_err(|error| unopened(input, path, &error))?;
    let (path, wanted) = (printable_path(path), input.named());
    if metadata.is_dir() {
        return Err(InputIsFolder { path, wanted }.refused(Exit::Unreadable, Place::File));
    }
    if !metadata.is_file() {
        return Err(NoRegularFile { path, wanted }.refused(Exit::Unreadable, Place::File));
    }
    Ok(metadata)
}

/// A program's file, to be read piece by piece: the interpreter has caps of its own.
///
/// # Errors
/// Refuses with [`Exit::Unreadable`] a path that is missing, no regular file or may not be read.
pub fn open_program(path: &Path) -> Result<BufReader<File>, Refusal> {
    regular(Input::Program, path)?;
    let file = File::open(path).map_err(|error| unopened(Input::Program, path, &error))?;
    Ok(BufReader::with_capacity(1 << 16, file))
}

fn too_large(input: Input, path: &Path) -> Refusal {
    let (path, most) = (printable_path(path), limits::mebibytes(limits::FILE));
    match input {
        Input::Workbook => WorkbookTooLarge { path, most }.refused(Exit::Limit, Place::File),
        Input::VarFile | Input::ToolTable | Input::Program => {
            FileTooLarge { path, most, wanted: input.named() }.refused(Exit::Limit, Place::File)
        }
    }
}

/// The refusal for what the operating system answered where a file of a kind was to be opened: [`Exit::Unreadable`], with the path as
/// it was named and what to do about it.
#[must_use]
pub fn unopened(input: Input, named: &Path, error: &io::Error) -> Refusal {
    let path = printable_path(named);
    let open = || lock_file(named).exists();
    let finding = match error.kind() {
        ErrorKind::ResourceBusy => HeldByProgram { path }.at(Place::File),
        // 32 and 33: another program holds the file, or a part of it.
        _ if cfg!(windows) && matches!(error.raw_os_error(), Some(32 | 33)) => HeldByProgram { path }.at(Place::File),
        ErrorKind::NotFound => not_found(input, named, path),
        ErrorKind::NotADirectory => PathThroughFile { path }.at(Place::File),
        ErrorKind::PermissionDenied if open() => NoPermissionWhileOpen { path }.at(Place::File),
        ErrorKind::PermissionDenied => NoPermissionToRead { path }.at(Place::File),
        _ => {
            let reason = answer(error);
            if open() {
                CannotOpenWhileOpen { path, reason }.at(Place::File)
            } else {
                CannotOpen { path, reason }.at(Place::File)
            }
        }
    };
    Refusal::new(Exit::Unreadable, finding)
}

/// The file that Excel keeps beside a workbook while it is open.
fn lock_file(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from("~$");
    name.push(path.file_name().unwrap_or_default());
    path.with_file_name(name)
}

/// What is told of a file that is not there: with the files of the kind in the folder, those most alike first.
fn not_found(input: Input, named: &Path, path: String) -> Finding {
    let folder = match named.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let wanted = named.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
    let mut names: Vec<(bool, usize, String)> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .take(FOLDER_ENTRIES)
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| !name.starts_with("~$"))
        .filter_map(|name| {
            let lower = name.to_lowercase();
            let kind = input.endings().iter().any(|ending| lower.ends_with(ending));
            // Names are at most a few hundred bytes, so the distance is cheap.
            let distance = strsim::damerau_levenshtein(&wanted, &lower);
            kind.then_some((distance * 3 > wanted.chars().count(), distance, name))
        })
        .collect();
    names.sort();
    let near: Vec<_> = names.iter().filter(|name| !name.0).take(LISTED_FILES).map(|name| printable(&name.2)).collect();
    if !near.is_empty() {
        return NoSuchFileButAlike { path, near: near.join(", ") }.at(Place::File);
    }
    if names.is_empty() {
        return NoSuchFile { path }.at(Place::File);
    }
    let mut there = names.iter().take(LISTED_FILES).map(|name| printable(&name.2)).collect::<Vec<_>>().join(", ");
    if names.len() > LISTED_FILES {
        there.push_str(" …");
    }
    NoSuchFileAmong { path, there }.at(Place::File)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn remedy(path: &Path, error: &io::Error) -> (Exit, String, String) {
        let refusal = unopened(Input::Workbook, path, error);
        let finding = refusal.findings.into_iter().next().map(|finding| (finding.what.en, finding.remedy.en));
        let (what, remedy) = finding.unwrap_or_default();
        (refusal.exit, what.into_owned(), remedy.into_owned())
    }

    #[test]
    fn a_workbook_that_excel_holds_open_is_to_be_closed() -> io::Result<()> {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("impeller.xlsx");
        let denied = io::Error::from(ErrorKind::PermissionDenied);
        let (exit, what, before) = remedy(&path, &denied);
        assert_eq!(exit, Exit::Unreadable);
        assert!(what.ends_with("impeller.xlsx: no permission to read it"), "{what}");
        assert_eq!(before, "allow reading it, or copy the file");
        File::create(folder.path().join("~$impeller.xlsx"))?;
        let closed = "close it in Excel or LibreOffice and run the command again";
        assert_eq!(remedy(&path, &denied).2, closed);
        let other = io::Error::other("device \u{1b}[31mgone");
        assert!(remedy(&path, &other).1.ends_with("device \\u{1b}[31mgone"));
        assert_eq!(remedy(&path, &other).2, closed);
        Ok(())
    }
}
