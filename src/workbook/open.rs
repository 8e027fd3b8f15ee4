//! The one place that opens a path for reading.

#![expect(clippy::disallowed_methods, reason = "the door by which workbooks come in")]

use std::fs::{self, File};
use std::io::{self, BufReader, ErrorKind, Read};
use std::path::{Path, PathBuf};

use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Finding, Place, Refusal};
use crate::text::Text;

use super::limits;

/// Most names of other files that a refusal lists.
const NAMES: usize = 3;
/// Most entries of a folder that are looked through for them.
const FOLDER_ENTRIES: usize = 10_000;

/// A kind of file that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// A workbook.
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
            Self::Workbook => Text::fixed("el libro .xlsx", "the .xlsx workbook"),
            Self::VarFile => Text::fixed("el archivo .var", "the .var file"),
            Self::ToolTable => Text::fixed("la tabla de herramientas", "the tool table"),
            Self::Program => Text::fixed("el programa ISO", "the ISO program"),
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
        .map_err(|error| refuse(input, path, &error))?;
    if u64::try_from(bytes.len()).is_ok_and(|length| length <= limits::FILE) {
        Ok(bytes)
    } else {
        Err(too_large(input, path))
    }
}

/// What is known of a regular file.
fn regular(input: Input, path: &Path) -> Result<fs::Metadata, Refusal> {
    // Asked before opening: opening a pipe would wait for a writer.
    let metadata = fs::metadata(path).map_err(|error| refuse(input, path, &error))?;
    let named = input.named();
    if metadata.is_dir() {
        return Err(cannot(
            path,
            &Text::fixed("es una carpeta", "it is a folder"),
            say!("indique {named} que está dentro de la carpeta", "name {named} inside the folder", named = named),
        ));
    }
    if !metadata.is_file() {
        return Err(cannot(
            path,
            &Text::fixed("no es un archivo normal", "it is not a regular file"),
            say!("indique {named}, guardado en disco", "name {named}, stored on disk", named = named),
        ));
    }
    Ok(metadata)
}

/// A program's file, to be read piece by piece: the interpreter has caps of its own.
///
/// # Errors
/// Refuses with [`Exit::Unreadable`] a path that is missing, no regular file or may not be read.
pub fn open_program(path: &Path) -> Result<BufReader<File>, Refusal> {
    regular(Input::Program, path)?;
    let file = File::open(path).map_err(|error| refuse(Input::Program, path, &error))?;
    Ok(BufReader::with_capacity(1 << 16, file))
}

fn too_large(input: Input, path: &Path) -> Refusal {
    let remedy = match input {
        Input::Workbook => {
            Text::fixed("deje en el libro solo las hojas de entrada", "leave only the input sheets in the workbook")
        }
        Input::VarFile | Input::ToolTable | Input::Program => {
            say!("indique {named}", "name {named}", named = input.named())
        }
    };
    let (name, most) = (printable_path(path), limits::mebibytes(limits::FILE));
    Refusal::new(
        Exit::Limit,
        Finding::stop(Place::File, say!("{name} ocupa más de {most} MiB", "{name} is larger than {most} MiB"), remedy),
    )
}

fn cannot(path: &Path, why: &Text, remedy: Text) -> Refusal {
    let name = printable_path(path);
    let what = Text::new(format!("no se puede abrir {name}: {}", why.es), format!("cannot open {name}: {}", why.en));
    Refusal::new(Exit::Unreadable, Finding::stop(Place::File, what, remedy))
}

/// The refusal for what the operating system answered.
fn refuse(input: Input, path: &Path, error: &io::Error) -> Refusal {
    let locked = Text::fixed(
        "ciérrelo en Excel o LibreOffice y repita la orden",
        "close it in Excel or LibreOffice and run the command again",
    );
    // 32 and 33: another program holds the file, or a part of it.
    if cfg!(windows) && matches!(error.raw_os_error(), Some(32 | 33)) {
        return cannot(path, &Text::fixed("otro programa lo tiene abierto", "another program has it open"), locked);
    }
    match error.kind() {
        ErrorKind::NotFound => cannot(path, &Text::fixed("no existe", "no such file"), others(input, path)),
        ErrorKind::NotADirectory => cannot(
            path,
            &Text::fixed("una parte de la ruta no es una carpeta", "a part of the path is not a folder"),
            Text::fixed("compruebe la ruta", "check the path"),
        ),
        ErrorKind::PermissionDenied => cannot(
            path,
            &Text::fixed("falta el permiso de lectura", "no permission to read it"),
            if lock_file(path).exists() {
                locked
            } else {
                Text::fixed("dé permiso de lectura o copie el archivo", "allow reading it, or copy the file")
            },
        ),
        _ => {
            let reason = printable(&error.to_string());
            cannot(
                path,
                &Text::same(reason),
                if lock_file(path).exists() { locked } else { Text::fixed("compruebe la ruta", "check the path") },
            )
        }
    }
}

/// The file that Excel keeps beside a workbook while it is open.
fn lock_file(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from("~$");
    name.push(path.file_name().unwrap_or_default());
    path.with_file_name(name)
}

/// A remedy that names the files of the kind in the folder, those most alike first.
fn others(input: Input, path: &Path) -> Text {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let wanted = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
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
    let near: Vec<_> = names.iter().filter(|name| !name.0).take(NAMES).map(|name| printable(&name.2)).collect();
    if !near.is_empty() {
        let near = near.join(", ");
        return say!("¿quiere decir {near}?", "did you mean {near}?");
    }
    if names.is_empty() {
        return Text::fixed("compruebe el nombre y la carpeta", "check the name and the folder");
    }
    let there = names.iter().take(NAMES).map(|name| printable(&name.2)).collect::<Vec<_>>().join(", ");
    if names.len() > NAMES {
        say!("en la carpeta hay: {there} …", "the folder has: {there} …")
    } else {
        say!("en la carpeta hay: {there}", "the folder has: {there}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn remedy(path: &Path, error: &io::Error) -> (Exit, String, String) {
        let refusal = refuse(Input::Workbook, path, error);
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
