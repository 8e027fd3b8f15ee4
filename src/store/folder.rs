//! The folder that outputs go to.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::OsStr;
use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::disk::{Disk, PREFIX, SUFFIX, here};
use super::draft::{Draft, unfinished};
use super::lock::Lock;
use super::notice;
use super::reason::{refusal, shown, unwritable};
use super::rules::NotAFolder;
use crate::finding::{Finding, Refusal};

/// The age from which an unlocked temporary file is a leftover. It covers the moment between making and locking one, or
/// a whole run where temporary files are not locked.
const LEFTOVER: Duration = Duration::from_secs(if cfg!(unix) { 60 } else { 3600 });

/// A folder known to exist and to take files.
#[derive(Debug)]
pub struct Folder {
    /// As it was given; empty for the current folder.
    path: PathBuf,
    /// The folders made for it, outermost first.
    made: Vec<PathBuf>,
    disk: Disk,
    /// What was done with a set that a killed run left there half delivered.
    settled: Option<Finding>,
}

impl Folder {
    /// The folder at a path, made with its parents if it is not there. A set that a killed run left there half delivered
    /// is completed or put back, and leftovers of such runs are removed. Folders made here are removed again when this
    /// value is dropped, if nothing came into them.
    ///
    /// # Errors
    /// Exit 5 where the path is not a folder, where no file can be made in it, or where it holds a mixed set that can be
    /// neither completed nor put back.
    pub fn open(path: &Path) -> Result<Self, Refusal> {
        Self::open_on(path, &Disk::default())
    }

    /// The same on another disk.
    ///
    /// # Errors
    /// As [`Folder::open`].
    pub fn open_on(path: &Path, disk: &Disk) -> Result<Self, Refusal> {
        let mut folder = Self { path: path.to_owned(), made: Vec::new(), disk: disk.clone(), settled: None };
        let path = here(path);
        folder.make().map_err(|error| match fs::metadata(path) {
            Ok(found) if !found.is_dir() => refusal(&NotAFolder { path: shown(path) }),
            _ => unwritable(path, &error),
        })?;
        Draft::new(path, disk).map_err(|error| unwritable(path, &error))?;
        folder.settled = notice::settle_on(path, disk)?;
        folder.sweep();
        Ok(folder)
    }

    /// The folder's path as the system wants it: `.` for the current folder.
    pub(super) fn place(&self) -> &Path {
        here(&self.path)
    }

    /// What was done with a set that a killed run had left there half delivered.
    #[must_use]
    pub const fn settled(&self) -> Option<&Finding> {
        self.settled.as_ref()
    }

    /// The disk that the folder is on.
    pub(super) fn disk(&self) -> &Disk {
        &self.disk
    }

    /// The path of a file in the folder, beginning with the folder as it was given.
    pub(super) fn join(&self, name: &OsStr) -> PathBuf {
        self.path.join(name)
    }

    /// Removes a file of ours from it, where it is there.
    ///
    /// # Errors
    /// Exit 5 where the system does not remove it.
    pub fn remove(&self, name: &OsStr) -> Result<(), Refusal> {
        let path = self.join(name);
        match self.disk.remove(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => Err(unwritable(&path, &error)),
            _ => Ok(()),
        }
    }

    fn make(&mut self) -> io::Result<()> {
        let missing: Vec<_> = self
            .path
            .ancestors()
            .take_while(|path| !path.as_os_str().is_empty() && !path.exists())
            .map(Path::to_owned)
            .collect();
        let mut unfinished = unfinished();
        for path in missing.into_iter().rev() {
            match self.disk.make_folder(&path) {
                Ok(()) => {
                    unfinished.folder_made(&path);
                    self.made.push(path);
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists && path.is_dir() => {}
                Err(error) => return Err(error),
            }
        }
        if fs::metadata(self.place())?.is_dir() { Ok(()) } else { Err(ErrorKind::NotADirectory.into()) }
    }

    /// Removes leftovers: temporary files of ours that are old and that nobody has locked. What cannot be removed does
    /// no harm and stays.
    fn sweep(&self) {
        let Ok(entries) = fs::read_dir(self.place()) else { return };
        let old: Vec<_> = entries.flatten().filter(is_ours_and_old).map(|entry| entry.path()).collect();
        if old.is_empty() {
            return;
        }
        // Under the lock, so that no set is just being renamed: its way back lies in such files.
        let Ok(Some(_lock)) = Lock::attempt(self.place(), &self.disk) else { return };
        if notice::stands(self.place()) {
            return;
        }
        for path in old {
            let unlocked = OpenOptions::new().write(true).open(&path).is_ok_and(|file| file.try_lock().is_ok());
            if unlocked {
                let _ = self.disk.remove(&path);
            }
        }
    }
}

fn is_ours_and_old(entry: &fs::DirEntry) -> bool {
    let name = entry.file_name();
    let name = name.as_encoded_bytes();
    let ours = name.starts_with(PREFIX.as_bytes()) && name.ends_with(SUFFIX.as_bytes());
    ours && entry.metadata().is_ok_and(|found| {
        found.is_file() && found.modified().ok().and_then(|at| at.elapsed().ok()).is_some_and(|age| age > LEFTOVER)
    })
}

impl Drop for Folder {
    fn drop(&mut self) {
        for path in self.made.iter().rev() {
            let _ = self.disk.remove_folder(path);
        }
    }
}
