//! A set of files that come under their final names together, or not at all.

use std::ffi::{OsStr, OsString};
use std::fmt::Display;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};

use tempfile::{Builder, TempPath};

use super::draft::{Draft, Output, PREFIX, SUFFIX, Unfinished, unfinished};
use super::folder::Folder;
use super::lock::Lock;
use super::reason::{shown, unwritable, words};
use super::target;
use crate::escape::printable;
use crate::finding::{Exit, Finding, Place, Refusal};
use crate::text::Text;

/// What happens to a file that already has the name of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existing {
    /// It is replaced.
    Replace,
    /// The set is refused.
    Keep,
}

/// A file that was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The file's name.
    pub name: OsString,
    /// Its path: the folder as it was given, and the name.
    pub path: PathBuf,
    /// Its size.
    pub bytes: u64,
    /// The SHA-256 of its bytes, in lower-case hexadecimal.
    pub sha256: String,
}

#[derive(Debug)]
struct Pending {
    draft: Draft,
    written: Written,
}

/// A set of outputs in one folder. Dropped before [`Set::commit`], it leaves nothing behind.
#[derive(Debug)]
pub struct Set<'f> {
    folder: &'f Folder,
    inputs: Vec<PathBuf>,
    existing: Existing,
    pending: Vec<Pending>,
}

impl<'f> Set<'f> {
    /// An empty set in a folder. `inputs` are files that no output may replace.
    #[must_use]
    pub fn new(folder: &'f Folder, inputs: &[&Path], existing: Existing) -> Self {
        let inputs = inputs.iter().map(|&path| path.to_owned()).collect();
        Self { folder, inputs, existing, pending: Vec::new() }
    }

    /// Checks that a file of this name may be written, before the work that fills it is done.
    ///
    /// # Errors
    /// Exit 2 where it is an input or already in the set. Exit 5 where the name is not one of a file, is taken by a
    /// link, a folder or a device, is open in Excel or LibreOffice, or exists and is to be kept.
    pub fn check(&self, name: &OsStr) -> Result<(), Refusal> {
        let path = self.folder.join(name);
        // A separator would lead out of the folder.
        let mut steps = Path::new(name).components();
        if !matches!((steps.next(), steps.next()), (Some(Component::Normal(only)), None) if only == name) {
            return Err(unwritable(&path, &ErrorKind::InvalidFilename.into()));
        }
        if self.pending.iter().any(|one| one.written.name == name) {
            let path = shown(&path);
            return Err(Refusal::new(
                Exit::CommandLine,
                Finding::stop(
                    Place::File,
                    Text::new(format!("{path} se escribiría dos veces"), format!("{path} would be written twice")),
                    Text::fixed("dé un nombre propio a cada libro", "give every workbook a name of its own"),
                ),
            ));
        }
        if self.existing == Existing::Keep && path.symlink_metadata().is_ok() {
            return Err(exists(&path));
        }
        target::check(&path, &self.inputs)
    }

    /// Writes a file of the set: `fill` gives its contents. Nothing appears under its name yet.
    ///
    /// # Errors
    /// As [`Set::check`]; exit 5 where the system does not take the contents; exit 1 where `fill` gives up for a reason
    /// of its own.
    pub fn write<E: Display>(
        &mut self,
        name: &OsStr,
        fill: impl FnOnce(&mut Output<'_>) -> Result<(), E>,
    ) -> Result<&Written, Refusal> {
        self.check(name)?;
        let path = self.folder.join(name);
        let draft = Draft::new(self.folder.place()).map_err(|error| unwritable(&path, &error))?;
        let mut output = draft.output().map_err(|error| unwritable(&path, &error))?;
        let filled = fill(&mut output);
        output.finish().map_err(|error| unwritable(&path, &error))?;
        filled.map_err(|error| fault(&path, &error))?;
        let (bytes, sha256) = draft.sum().map_err(|error| unwritable(&path, &error))?;
        let written = Written { name: name.to_owned(), path, bytes, sha256 };
        self.pending.push(Pending { draft, written });
        self.pending
            .last()
            .map(|one| &one.written)
            .ok_or_else(|| unwritable(self.folder.place(), &ErrorKind::Other.into()))
    }

    /// The files written so far, in order.
    pub fn written(&self) -> impl Iterator<Item = &Written> {
        self.pending.iter().map(|one| &one.written)
    }

    /// Where the contents of a file written so far can be read until the set is committed; `None` for a name that is not
    /// in the set.
    #[must_use]
    pub fn draft(&self, name: &OsStr) -> Option<&Path> {
        self.pending.iter().find(|one| one.written.name == name).map(|one| one.draft.path())
    }

    /// Brings every file to the disk before any gets its final name. All at once: a disk takes one after another in as
    /// many times the time.
    fn sync(&self) -> Result<(), Refusal> {
        let synced: Vec<io::Result<()>> = std::thread::scope(|scope| {
            let threads: Vec<_> = self.pending.iter().map(|one| scope.spawn(|| one.draft.sync())).collect();
            threads.into_iter().map(|thread| thread.join().unwrap_or_else(|_| Err(ErrorKind::Other.into()))).collect()
        });
        for (one, synced) in self.pending.iter().zip(synced) {
            synced.map_err(|error| unwritable(&one.written.path, &error))?;
        }
        Ok(())
    }

    /// Brings all files under their final names, in order.
    ///
    /// # Errors
    /// Exit 5 where a file cannot be put there, or another run holds the folder's lock for long. The files that were
    /// there before are then back; where that fails too, the message names those that stand in their new version.
    pub fn commit(mut self) -> Result<Vec<Written>, Refusal> {
        for one in &self.pending {
            target::check(&one.written.path, &self.inputs)?;
        }
        self.sync()?;
        let _lock = Lock::wait(self.folder.place())?;
        let mut unfinished = unfinished();
        let mut replaced = Vec::with_capacity(self.pending.len());
        for one in &mut self.pending {
            match replace(one, self.folder, self.existing, &mut unfinished) {
                Ok(step) => replaced.push(step),
                Err(error) => {
                    let stuck = put_back(replaced);
                    return Err(match error.kind() {
                        ErrorKind::AlreadyExists if self.existing == Existing::Keep => exists(&one.written.path),
                        _ => mixed(&one.written.path, &error, &stuck),
                    });
                }
            }
        }
        // The old files' second names go before an interruption is let through.
        drop(replaced);
        drop(unfinished);
        // The renames themselves survive a power cut once the folder is on the disk; not every system can do that.
        let _ = fs::File::open(self.folder.place()).and_then(|folder| folder.sync_all());
        Ok(self.pending.drain(..).map(|one| one.written).collect())
    }
}

/// One file that was put in its place, with the way back.
struct Replaced {
    target: PathBuf,
    /// The file that was there, under a temporary name; `None` where there was none.
    before: Option<TempPath>,
}

fn replace(
    one: &mut Pending,
    folder: &Folder,
    existing: Existing,
    unfinished: &mut Unfinished,
) -> io::Result<Replaced> {
    let target = &one.written.path;
    let before = if existing == Existing::Replace { second_name(target, folder)? } else { None };
    one.draft.become_final(target, existing == Existing::Replace, unfinished)?;
    Ok(Replaced { target: target.clone(), before })
}

/// A second name for a file, so that its first one can be replaced and put back; `None` where there is no file. On a
/// file system without hard links the file is copied.
fn second_name(target: &Path, folder: &Folder) -> io::Result<Option<TempPath>> {
    if let Err(error) = fs::symlink_metadata(target) {
        return if error.kind() == ErrorKind::NotFound { Ok(None) } else { Err(error) };
    }
    let second =
        Builder::new().prefix(PREFIX).suffix(SUFFIX).rand_bytes(8).make_in(
            folder.place(),
            |path| match fs::hard_link(target, path) {
                Err(error) if matches!(error.kind(), ErrorKind::AlreadyExists | ErrorKind::NotFound) => Err(error),
                Err(_) => fs::copy(target, path).map(|_| ()),
                Ok(()) => Ok(()),
            },
        )?;
    Ok(Some(second.into_temp_path()))
}

/// Puts back what was replaced, last first; gives the paths where that failed.
fn put_back(replaced: Vec<Replaced>) -> Vec<PathBuf> {
    let mut stuck = Vec::new();
    for step in replaced.into_iter().rev() {
        let undone = match step.before {
            Some(before) => before.persist(&step.target).map_err(|failed| failed.error),
            None => fs::remove_file(&step.target),
        };
        if undone.is_err() {
            stuck.push(step.target);
        }
    }
    stuck
}

fn mixed(path: &Path, error: &io::Error, stuck: &[PathBuf]) -> Refusal {
    let mut refusal = unwritable(path, error);
    let (_, remedy) = words(error);
    if let Some(finding) = refusal.findings.first_mut() {
        if stuck.is_empty() {
            finding.what = Text::new(
                format!("{}; los archivos anteriores siguen en su sitio", finding.what.es),
                format!("{}; the files of before stand", finding.what.en),
            );
        } else {
            let list = stuck.iter().map(|path| shown(path)).collect::<Vec<_>>().join(", ");
            finding.what = Text::new(
                format!("{}; de este conjunto quedan en versión nueva: {list}", finding.what.es),
                format!("{}; of this set these stand in their new version: {list}", finding.what.en),
            );
            finding.remedy = Text::new(
                format!("no use ningún programa de esta carpeta hasta repetir la orden; {}", remedy.es),
                format!("use no program of this folder before the command has run again; {}", remedy.en),
            );
        }
    }
    refusal
}

fn exists(path: &Path) -> Refusal {
    let path = shown(path);
    super::reason::refusal(
        Text::new(format!("{path} ya existe"), format!("{path} exists already")),
        Text::fixed("dé otro nombre, o quite ese archivo", "give another name, or remove that file"),
    )
}

fn fault(path: &Path, error: &dyn Display) -> Refusal {
    let (path, error) = (shown(path), error.to_string());
    let error = printable(&error);
    Refusal::new(
        Exit::Fault,
        Finding::stop(
            Place::File,
            Text::new(
                format!("fallo de rodete: no se pudo componer {path}: {error}"),
                format!("fault in rodete: {path} could not be composed: {error}"),
            ),
            Text::fixed(
                "comunique el fallo con el libro que lo provoca",
                "report the fault with the workbook that shows it",
            ),
        ),
    )
}
