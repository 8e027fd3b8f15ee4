//! The lock under which a set comes under its final names.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::fs::{self, File, TryLockError};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};

use same_file::Handle;

use super::disk::Disk;
use super::draft::unfinished;
use super::reason::{refusal, shown, unwritable};
use super::rules::FolderHeld;
use crate::escape::printable;
use crate::finding::Refusal;

/// The lock file's name.
pub(super) const NAME: &str = ".rodete.lock";

/// How long another run may take for its renames before this one gives up.
const PATIENCE: Duration = Duration::from_secs(5);

/// The lock of a folder, held until it is dropped. The system lets go of it when the process ends, however it ends.
#[derive(Debug)]
pub(super) struct Lock {
    path: PathBuf,
    /// `None` on a file system without locks.
    file: Option<File>,
    disk: Disk,
}

impl Lock {
    /// Waits for the lock of a folder.
    ///
    /// # Errors
    /// Exit 5 where the lock file cannot be made, or where another run holds it for more than five seconds.
    pub(super) fn wait(folder: &Path, disk: &Disk) -> Result<Self, Refusal> {
        let started = Instant::now();
        loop {
            if let Some(lock) = Self::attempt(folder, disk)? {
                return Ok(lock);
            }
            if started.elapsed() > PATIENCE {
                return Err(held(folder));
            }
            sleep(Duration::from_millis(10));
        }
    }

    /// The lock of a folder, or `None` while another run holds it.
    ///
    /// # Errors
    /// Exit 5 where the lock file cannot be made.
    pub(super) fn attempt(folder: &Path, disk: &Disk) -> Result<Option<Self>, Refusal> {
        let path = folder.join(NAME);
        // Under the register, so that an interruption finds the lock file in it or not made at all.
        let mut unfinished = unfinished();
        // Its owner is written into it: never through a link.
        if fs::symlink_metadata(&path).is_ok_and(|found| !found.is_file()) {
            return Err(unwritable(&path, &ErrorKind::AlreadyExists.into()));
        }
        let file = match disk.lock_file(&path) {
            Ok(file) => file,
            // The system says so while a file of this name is being removed.
            Err(error) if error.kind() == ErrorKind::PermissionDenied && cfg!(windows) => return Ok(None),
            Err(error) => return Err(unwritable(&path, &error)),
        };
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Ok(None),
            Err(TryLockError::Error(_)) => return Ok(Some(Self { path, file: None, disk: disk.clone() })),
        }
        // The owner removes the file before letting go: a lock on a file that is no longer there protects nothing.
        let locked = file.try_clone().and_then(Handle::from_file);
        match (locked, Handle::from_path(&path)) {
            (Ok(locked), Ok(there)) if locked == there => {}
            _ => return Ok(None),
        }
        // The owner's name is a courtesy: without it the lock holds as well.
        let owner = format!("rodete, process {}\n", std::process::id());
        let _ = file.set_len(0).and_then(|()| disk.write(&file, &path, owner.as_bytes()));
        unfinished.begun(&path);
        Ok(Some(Self { path, file: Some(file), disk: disk.clone() }))
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        let mut unfinished = unfinished();
        let _ = self.disk.remove(&self.path);
        unfinished.forget(&self.path);
        if let Some(file) = self.file.take() {
            let _ = file.unlock();
        }
    }
}

fn held(folder: &Path) -> Refusal {
    let path = folder.join(NAME);
    let mut owner = String::new();
    if let Ok(file) = File::open(&path) {
        let _ = file.take(100).read_to_string(&mut owner);
    }
    let owner = printable(owner.trim());
    refusal(&FolderHeld { lock: shown(&path), owner })
}
