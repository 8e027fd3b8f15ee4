//! A set of files that come under their final names together, or not at all.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::{OsStr, OsString};
use std::fmt::Display;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};

use super::disk::Disk;
use super::draft::{Draft, Output, Unfinished, sha256, unfinished};
use super::folder::Folder;
use super::lock::Lock;
use super::notice::{self, Notice};
use super::reason::{mixed, put_back, refusal, shown, unwritable};
use super::replaced::{Home, kept, replaceable};
use super::rules::*;
use super::target;
use crate::escape::printable;
use crate::finding::rules::NotComposed;
use crate::finding::{Exit, Place, Raise, Refusal};

/// What happens to a file that already has the name of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existing {
    /// It is replaced, once all of the set is written.
    Replace,
    /// The set is refused.
    Keep,
}

/// A file that was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenFile {
    /// The file's name.
    pub name: OsString,
    /// Its path: the folder as it was given, and the name.
    pub path: PathBuf,
    /// Its size in bytes.
    pub bytes: u64,
    /// The SHA-256 of its bytes, in lower-case hexadecimal.
    pub sha256: String,
}

#[derive(Debug)]
struct Pending {
    draft: Draft,
    written: WrittenFile,
    /// Where it stands.
    home: Home,
    /// Of a workbook that is input and output at once, the SHA-256 that it had when it was read.
    before: Option<String>,
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
            return Err(WrittenTwice { path: shown(&path) }.refused(Exit::CommandLine, Place::File));
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
    ) -> Result<&WrittenFile, Refusal> {
        self.check(name)?;
        let path = self.folder.join(name);
        let draft = Draft::new(self.folder.place(), self.folder.disk()).map_err(|error| unwritable(&path, &error))?;
        let mut output = draft.output().map_err(|error| unwritable(&path, &error))?;
        let filled = fill(&mut output);
        output.finish().map_err(|error| unwritable(&path, &error))?;
        filled.map_err(|error| fault(&path, &error))?;
        let (bytes, sha256) = draft.sum().map_err(|error| unwritable(&path, &error))?;
        let written = WrittenFile { name: name.to_owned(), path, bytes, sha256 };
        self.pending.push(Pending { draft, written, home: Home::own(self.folder.place()), before: None });
        self.pending
            .last()
            .map(|one| &one.written)
            .ok_or_else(|| unwritable(self.folder.place(), &ErrorKind::Other.into()))
    }

    /// Writes a file anew that is in the set already, in its place.
    ///
    /// # Errors
    /// As [`Set::write`].
    pub fn write_again<E: Display>(
        &mut self,
        name: &OsStr,
        fill: impl FnOnce(&mut Output<'_>) -> Result<(), E>,
    ) -> Result<(), Refusal> {
        let at = self.pending.iter().position(|one| one.written.name == name);
        drop(at.map(|at| self.pending.remove(at)));
        self.write(name, fill)?;
        if let (Some(at), Some(written)) = (at, self.pending.pop()) {
            self.pending.insert(at, written);
        }
        Ok(())
    }

    /// Replaces a workbook that was read, in the folder where it stands; `read` are the bytes that it had then. As it was before it is
    /// kept once, with `.bak` behind its name. It comes under its name last of all files of the set.
    ///
    /// # Errors
    /// As [`replaceable`](super::replaceable); exit 5 where the system does not take the contents.
    pub fn replace(&mut self, workbook: &Path, read: &[u8], contents: &[u8]) -> Result<(), Refusal> {
        let inputs: Vec<&Path> = self.inputs.iter().map(PathBuf::as_path).collect();
        replaceable(workbook, &inputs)?;
        let kept = kept(workbook);
        match fs::symlink_metadata(&kept) {
            Ok(_) => {}
            Err(_) => self.beside(&kept, workbook, read, None)?,
        }
        self.beside(workbook, workbook, contents, Some(sha256(read)))
    }

    /// Adds a file in the folder of a workbook, with the workbook's mode.
    fn beside(&mut self, path: &Path, like: &Path, contents: &[u8], before: Option<String>) -> Result<(), Refusal> {
        use std::io::Write;
        let (place, disk) = (self.folder.place(), self.folder.disk());
        let home = Home::of(path, place);
        let wrong = |error| unwritable(path, &error);
        let draft = Draft::new(&home.path, disk).map_err(wrong)?;
        let mut output = draft.output().map_err(wrong)?;
        let written = output.write_all(contents);
        output.finish().map_err(wrong)?;
        written.map_err(wrong)?;
        disk.permit(draft.path(), like).map_err(wrong)?;
        let (bytes, sha256) = draft.sum().map_err(wrong)?;
        let name = path.file_name().unwrap_or_default().to_owned();
        let written = WrittenFile { name, path: path.to_owned(), bytes, sha256 };
        self.pending.push(Pending { draft, written, home, before });
        Ok(())
    }

    /// The files written so far, in order.
    pub fn written(&self) -> impl Iterator<Item = &WrittenFile> {
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

    /// Brings all files under their final names, in order. Where the process is ended meanwhile, whoever comes next into
    /// the folder completes the set or puts back what was there.
    ///
    /// # Errors
    /// Exit 5 where a file cannot be put there, or another run holds the folder's lock for long. The files that were
    /// there before are then back; where that fails too, the message names those that stand in their new version.
    pub fn commit(mut self) -> Result<Vec<WrittenFile>, Refusal> {
        self.check_all()?;
        self.sync()?;
        let (place, disk) = (self.folder.place(), self.folder.disk());
        let _lock = Lock::wait(place, disk)?;
        notice::settle_locked(place, disk)?;
        let other = self.pending.iter().map(|one| &one.home).find(|home| home.is_other()).map(|home| home.path.clone());
        let _other = match &other {
            Some(other) => {
                let lock = Lock::wait(other, disk)?;
                notice::settle_locked(other, disk)?;
                Some(lock)
            }
            None => None,
        };
        self.check_read()?;
        let mut unfinished = unfinished();
        // One file alone is whole at any moment: nothing needs to be noted.
        let done = if self.pending.len() > 1 { self.together(&mut unfinished) } else { self.alone(&mut unfinished) };
        // Drafts that are left take the register themselves.
        drop(unfinished);
        done?;
        Ok(self.pending.drain(..).map(|one| one.written).collect())
    }

    /// Checks every final name again: much may have happened since the files were begun.
    fn check_all(&self) -> Result<(), Refusal> {
        for one in &self.pending {
            if one.before.is_some() {
                let inputs: Vec<&Path> = self.inputs.iter().map(PathBuf::as_path).collect();
                replaceable(&one.written.path, &inputs)?;
            } else {
                target::check(&one.written.path, &self.inputs)?;
            }
        }
        Ok(())
    }

    /// Checks that a workbook that is replaced still is the one that was read.
    fn check_read(&self) -> Result<(), Refusal> {
        for Pending { written, before, .. } in &self.pending {
            let Some(before) = before else { continue };
            let found = notice::sum_of(&written.path).map_err(|error| unwritable(&written.path, &error))?;
            if found.as_ref() != Some(before) {
                return Err(refusal(&BookChanged { path: shown(&written.path) }));
            }
        }
        Ok(())
    }

    /// Brings one file under its final name.
    fn alone(&mut self, unfinished: &mut Unfinished) -> Result<(), Refusal> {
        let replace = self.existing == Existing::Replace;
        for one in &mut self.pending {
            one.draft.become_final(&one.written.path, replace, unfinished).map_err(|error| match error.kind() {
                ErrorKind::AlreadyExists if !replace => exists(&one.written.path),
                _ => put_back(&one.written.path, &error),
            })?;
        }
        // The rename survives a power cut once the folder is on the disk; whether it does changes nothing here.
        let _ = self.folder.disk().sync_folder(self.folder.place());
        Ok(())
    }

    /// Brings several files under their final names, with a notice beside them meanwhile.
    fn together(&mut self, unfinished: &mut Unfinished) -> Result<(), Refusal> {
        let (place, disk, existing) = (self.folder.place(), self.folder.disk(), self.existing);
        let mut notice = Notice::default();
        if let Err((path, error)) = prepare(&self.pending, place, disk, existing, &mut notice) {
            notice.end(place, disk);
            return Err(put_back(&path, &error));
        }
        let mut rename = |elsewhere: bool| {
            let these = self.pending.iter_mut().filter(|one| one.home.way.is_none() == elsewhere);
            these.map(|one| (one.written.path.clone(), one)).try_for_each(|(path, one)| {
                one.draft.become_final(&path, existing == Existing::Replace, unfinished).map_err(|error| (path, error))
            })
        };
        // What no notice tells of comes last, when nothing can fail behind it.
        let renamed = rename(false)
            .and_then(|()| disk.sync_folder(place).map_err(|error| (place.to_owned(), error)))
            .and_then(|()| rename(true));
        // The rename of a file that stands elsewhere survives a power cut once that folder is on the disk, too; whether it does
        // changes nothing here.
        for one in self.pending.iter().filter(|one| one.home.is_other()) {
            let _ = disk.sync_folder(&one.home.path);
        }
        let Err((path, error)) = renamed else {
            notice.end(place, disk);
            return Ok(());
        };
        for one in
            self.pending.iter().filter(|one| one.home.way.is_none() && one.before.is_none() && one.draft.is_left())
        {
            let _ = disk.remove(&one.written.path);
        }
        let stuck = notice.put_back(place, disk);
        if stuck.is_empty() && disk.sync_folder(place).is_ok() {
            notice.end(place, disk);
        } else {
            // The notice stays, and all that it names: the next run tries again.
            for one in &mut self.pending {
                one.draft.leave(unfinished);
            }
        }
        Err(match error.kind() {
            ErrorKind::AlreadyExists if existing == Existing::Keep => exists(&path),
            _ if stuck.is_empty() => put_back(&path, &error),
            _ => mixed(&path, &error, stuck.iter().map(|path| shown(path)).collect::<Vec<_>>().join(", ")),
        })
    }
}

/// Gives every file that is replaced a second name, and puts the notice into the folder.
fn prepare(
    pending: &[Pending],
    place: &Path,
    disk: &Disk,
    existing: Existing,
    notice: &mut Notice,
) -> Result<(), (PathBuf, io::Error)> {
    for Pending { draft, written, home, .. } in pending {
        let Some(way) = home.way else { continue };
        let wrong = |error| (written.path.clone(), error);
        let there = existing == Existing::Replace && is_there(&written.path).map_err(wrong)?;
        let second = if there { Some(disk.second_name(&written.path, &home.path).map_err(wrong)?) } else { None };
        if let Err(error) = notice.add(way, &written.name, &written.sha256, draft.path(), second.as_deref()) {
            if let Some(second) = second {
                let _ = disk.remove(&second);
            }
            return Err(wrong(error));
        }
    }
    notice.put(place, disk).map_err(|error| (place.to_owned(), error))
}

fn is_there(path: &Path) -> io::Result<bool> {
    match fs::symlink_metadata(path) {
        Ok(_) => Ok(true),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

fn exists(path: &Path) -> Refusal {
    refusal(&ExistsAlready { path: shown(path) })
}

fn fault(path: &Path, error: &dyn Display) -> Refusal {
    let reason = printable(&error.to_string());
    NotComposed { path: shown(path), reason }.refused(Exit::Fault, Place::File)
}
