//! The typst compiler inside the binary: `rodete typst compile …`, with the arguments of `typst compile` that the
//! report needs.
//!
//! The report runs it as a child process, exactly as it would run an installed `typst`, so that one code path serves
//! both. What can be read is the folder given as `--root`; fonts are the embedded ones, the date is the one given, and
//! there are no packages: nothing here reaches the clock, the system's fonts or the network.

#![expect(
    clippy::disallowed_methods,
    reason = "the door of the compiler: it reads and writes the folder that it is given"
)]

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};
use typst::diag::{FileError, FileResult, PackageError, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Dict, Duration, IntoValue};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World};
use typst_kit::diagnostics::termcolor::NoColor;
use typst_kit::diagnostics::{DiagnosticFormat, DiagnosticWorld, emit};
use typst_kit::files::{FileLoader, FileStore, FsRoot};
use typst_kit::fonts::{FontStore, embedded};
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards, Timestamp};

/// The version of the compiler inside.
#[must_use]
pub fn version() -> &'static str {
    typst::utils::version().raw()
}

/// The arguments after `rodete typst`.
#[derive(Parser)]
#[command(name = "rodete typst", about = "The typst compiler that rodete carries for its reports")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Compiles a typst file into a PDF.
    Compile(Compile),
}

#[derive(clap::Args)]
struct Compile {
    /// The folder that the document may read; by default that of INPUT.
    #[arg(long, value_name = "DIR")]
    root: Option<PathBuf>,
    /// A pair for `sys.inputs`.
    #[arg(long = "input", value_name = "KEY=VALUE", value_parser = pair)]
    inputs: Vec<(String, String)>,
    /// The document's date in seconds since 1970; without it the document has none.
    #[arg(long, value_name = "UNIX", allow_negative_numbers = true)]
    creation_timestamp: Option<i64>,
    /// The PDF standard to hold to.
    #[arg(long, value_name = "NAME")]
    pdf_standard: Option<Standard>,
    /// Accepted for the sake of `typst`: system fonts are never used here.
    #[arg(long)]
    ignore_system_fonts: bool,
    /// Accepted for the sake of `typst`: the short format is the only one.
    #[arg(long, value_name = "FORMAT")]
    diagnostic_format: Option<String>,
    /// The typst file.
    input: PathBuf,
    /// The PDF to write.
    output: PathBuf,
}

#[derive(Clone, Copy, ValueEnum)]
enum Standard {
    #[value(name = "1.7")]
    Pdf17,
    #[value(name = "a-3b")]
    A3b,
}

fn pair(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((key, value)) if !key.trim().is_empty() => Ok((key.trim().to_owned(), value.to_owned())),
        _ => Err("must be key=value".to_owned()),
    }
}

/// Runs the compiler with the arguments that follow `rodete typst`.
///
/// Ends with 0 when the PDF is written, 1 with the faults on standard error as `file:line:column: error: message`, and
/// 2 for a wrong command line.
#[must_use]
pub fn compile(arguments: &[OsString]) -> ExitCode {
    let named = std::iter::once(OsString::from("rodete typst")).chain(arguments.iter().cloned());
    let Command::Compile(arguments) = match Arguments::try_parse_from(named) {
        Ok(arguments) => arguments.command,
        Err(error) => {
            let code = if error.use_stderr() { 2 } else { 0 };
            // Nothing is left to say where standard error itself is closed.
            let _ = error.print();
            return ExitCode::from(code);
        }
    };
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprint!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Compiles and writes the PDF; the error is the whole text for standard error.
fn run(arguments: &Compile) -> Result<(), String> {
    let desk = Desk::new(arguments)?;
    let pdf = desk.pdf(arguments.pdf_standard)?;
    fs::write(&arguments.output, pdf)
        .map_err(|error| format!("error: cannot write {}: {error}\n", arguments.output.display()))
}

/// What a document under compilation can see: its folder, the embedded fonts, the library and the given date.
struct Desk {
    main: FileId,
    library: LazyHash<Library>,
    fonts: FontStore,
    files: FileStore<Folder>,
    date: Option<time::OffsetDateTime>,
}

impl Desk {
    fn new(arguments: &Compile) -> Result<Self, String> {
        let resolve = |path: &Path, what: &str| {
            path.canonicalize().map_err(|error| format!("error: {what} {}: {error}\n", path.display()))
        };
        let input = resolve(&arguments.input, "input file")?;
        let root = match &arguments.root {
            Some(root) => resolve(root, "root folder")?,
            None => input.parent().map_or_else(|| input.clone(), Path::to_path_buf),
        };
        let main = VirtualPath::virtualize(&root, &input)
            .map_err(|_| "error: the input file must lie in the root folder and its path must be UTF-8\n".to_owned())?;
        let date = match arguments.creation_timestamp {
            Some(seconds) => Some(
                time::OffsetDateTime::from_unix_timestamp(seconds)
                    .map_err(|_| "error: the creation timestamp is out of range\n".to_owned())?,
            ),
            None => None,
        };
        let inputs: Dict =
            arguments.inputs.iter().map(|(key, value)| (key.as_str().into(), value.as_str().into_value())).collect();
        let mut fonts = FontStore::new();
        fonts.extend(embedded());
        Ok(Self {
            main: RootedPath::new(VirtualRoot::Project, main).intern(),
            library: LazyHash::new(Library::builder().with_inputs(inputs).build()),
            fonts,
            files: FileStore::new(Folder(FsRoot::new(root))),
            date,
        })
    }

    /// The PDF, or the faults as text.
    fn pdf(&self, standard: Option<Standard>) -> Result<Vec<u8>, String> {
        let compiled = typst::compile::<PagedDocument>(self);
        self.report(&compiled.warnings, |text| eprint!("{text}"));
        let document = compiled.output.map_err(|errors| self.text(&errors))?;
        let standard = match standard.unwrap_or(Standard::Pdf17) {
            Standard::Pdf17 => PdfStandard::V_1_7,
            Standard::A3b => PdfStandard::A_3b,
        };
        let standards = PdfStandards::new(&[standard]).map_err(|error| format!("error: {}\n", error.message()))?;
        let timestamp = self.date.and_then(datetime).map(Timestamp::new_utc);
        let options = PdfOptions { timestamp, standards, ..PdfOptions::default() };
        typst_pdf::pdf(&document, &options).map_err(|errors| self.text(&errors))
    }

    fn report(&self, diagnostics: &[SourceDiagnostic], say: impl FnOnce(String)) {
        if !diagnostics.is_empty() {
            say(self.text(diagnostics));
        }
    }

    /// The diagnostics in typst's short form, one a line.
    fn text(&self, diagnostics: &[SourceDiagnostic]) -> String {
        let mut text = NoColor::new(Vec::new());
        match emit(&mut text, self, diagnostics, DiagnosticFormat::Short) {
            Ok(()) => String::from_utf8_lossy(&text.into_inner()).into_owned(),
            // The place is lost, the messages are not.
            Err(_) => diagnostics.iter().map(|one| format!("error: {}\n", one.message)).collect(),
        }
    }
}

/// The date and time as typst knows them.
fn datetime(date: time::OffsetDateTime) -> Option<Datetime> {
    Datetime::from_ymd_hms(date.year(), date.month().into(), date.day(), date.hour(), date.minute(), date.second())
}

impl World for Desk {
    fn library(&self) -> &LazyHash<Library> {
        &self.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        self.fonts.book()
    }

    fn main(&self) -> FileId {
        self.main
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        self.files.source(id)
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        self.files.file(id)
    }

    fn font(&self, index: usize) -> Option<Font> {
        self.fonts.font(index)
    }

    fn today(&self, offset: Option<Duration>) -> Option<Datetime> {
        let date = match offset {
            None => self.date?,
            Some(offset) => self.date?.checked_add(time::Duration::checked_seconds_f64(offset.seconds())?)?,
        };
        Datetime::from_ymd(date.year(), date.month().into(), date.day())
    }
}

impl DiagnosticWorld for Desk {
    fn name(&self, id: FileId) -> String {
        id.vpath().get_without_slash().to_owned()
    }
}

/// The folder given as `--root`; packages are refused.
struct Folder(FsRoot);

impl FileLoader for Folder {
    fn load(&self, id: FileId) -> FileResult<Bytes> {
        match id.root() {
            VirtualRoot::Project => self.0.load(id.vpath()),
            VirtualRoot::Package(package) => Err(FileError::Package(PackageError::NotFound(package.clone()))),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::typeset::characters::SHOWN;
    use typst_kit::fonts::embedded;

    #[test]
    fn the_embedded_fonts_have_every_character_that_reports_show() {
        let fonts: Vec<_> = embedded().map(|(_, font)| font).collect();
        let missing: Vec<String> = SHOWN
            .iter()
            .flat_map(|&(first, last)| first..=last)
            .filter(|&one| !fonts.iter().any(|font| font.coverage.contains(u32::from(one))))
            .map(|one| format!("U+{:04X}", u32::from(one)))
            .collect();
        assert_eq!(missing, Vec::<String>::new());
    }
}
