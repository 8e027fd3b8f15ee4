//! Every change that the store makes on the disk, one method a step.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use tempfile::{Builder, PathPersistError, TempPath};

/// How the names of temporary files begin and end.
pub(super) const PREFIX: &str = ".rodete-";
pub(super) const SUFFIX: &str = ".tmp";

/// What is about to be done to a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// A folder is made.
    MakeFolder,
    /// A folder that has nothing in it is removed.
    RemoveFolder,
    /// A file is made.
    Create,
    /// Bytes are written into a file.
    Write,
    /// A file gets the mode of another.
    Permit,
    /// A file's contents are brought to the disk.
    Sync,
    /// A file gets a second name.
    Link,
    /// A file gets another name.
    Rename,
    /// A file is removed.
    Remove,
    /// A folder's names are brought to the disk.
    SyncFolder,
}

type Watch = dyn Fn(Step, &Path) -> io::Result<()> + Send + Sync;

/// The disk, through which every change goes. A watch is asked before each step and may let it fail: so it is shown that
/// a set stays whole wherever its delivery ends.
#[derive(Clone, Default)]
pub struct Disk {
    watch: Option<Arc<Watch>>,
}

impl fmt::Debug for Disk {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.debug_struct("Disk").field("watched", &self.watch.is_some()).finish()
    }
}

impl Disk {
    /// A disk of which each step is shown to `watch` first, and fails with its error.
    pub fn watched(watch: impl Fn(Step, &Path) -> io::Result<()> + Send + Sync + 'static) -> Self {
        Self { watch: Some(Arc::new(watch)) }
    }

    fn before(&self, step: Step, path: &Path) -> io::Result<()> {
        self.watch.as_ref().map_or(Ok(()), |watch| watch(step, path))
    }

    pub(super) fn make_folder(&self, path: &Path) -> io::Result<()> {
        self.before(Step::MakeFolder, path)?;
        fs::create_dir(path)
    }

    pub(super) fn remove_folder(&self, path: &Path) -> io::Result<()> {
        self.before(Step::RemoveFolder, path)?;
        fs::remove_dir(path)
    }

    /// A new file under a temporary name in a folder, with the mode that the umask gives.
    pub(super) fn create(&self, folder: &Path) -> io::Result<(File, PathBuf)> {
        let made = temporary().make_in(folder, |path| {
            self.before(Step::Create, path)?;
            OpenOptions::new().read(true).write(true).create_new(true).open(path)
        })?;
        let (file, path) = made.into_parts();
        Ok((file, path.keep().map_err(|failed| failed.error)?))
    }

    /// The file that a lock is on, made if it is not there.
    pub(super) fn lock_file(&self, path: &Path) -> io::Result<File> {
        self.before(Step::Create, path)?;
        OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)
    }

    pub(super) fn write(&self, mut file: &File, path: &Path, bytes: &[u8]) -> io::Result<usize> {
        self.before(Step::Write, path)?;
        file.write(bytes)
    }

    /// Gives a file the mode of another.
    pub(super) fn permit(&self, path: &Path, like: &Path) -> io::Result<()> {
        self.before(Step::Permit, path)?;
        fs::set_permissions(path, fs::metadata(like)?.permissions())
    }

    pub(super) fn sync(&self, file: &File, path: &Path) -> io::Result<()> {
        self.before(Step::Sync, path)?;
        file.sync_all()
    }

    /// A second, temporary name for a file. On a file system without hard links the file is copied.
    pub(super) fn second_name(&self, target: &Path, folder: &Path) -> io::Result<PathBuf> {
        let second = temporary().make_in(folder, |path| {
            self.before(Step::Link, path)?;
            match fs::hard_link(target, path) {
                Err(error) if matches!(error.kind(), ErrorKind::AlreadyExists | ErrorKind::NotFound) => Err(error),
                Err(_) => {
                    fs::copy(target, path)?;
                    self.sync(&OpenOptions::new().write(true).open(path)?, path)
                }
                Ok(()) => Ok(()),
            }
        })?;
        second.into_temp_path().keep().map_err(|failed| failed.error)
    }

    /// Gives a file its other name, replacing what is there.
    pub(super) fn rename(&self, path: &Path, to: &Path) -> io::Result<()> {
        self.before(Step::Rename, to)?;
        fs::rename(path, to)
    }

    /// Gives a file its other name, where nothing has that name.
    pub(super) fn rename_to_free(&self, path: &Path, to: &Path) -> io::Result<()> {
        self.before(Step::Rename, to)?;
        TempPath::try_from_path(path)?.persist_noclobber(to).map_err(|PathPersistError { error, path }| {
            // The file stays: whoever made it removes it.
            let _ = path.keep();
            error
        })
    }

    pub(super) fn remove(&self, path: &Path) -> io::Result<()> {
        self.before(Step::Remove, path)?;
        fs::remove_file(path)
    }

    /// Brings the names in a folder to the disk: renames survive a power cut from then on. Systems that have no such
    /// thing are taken at their word that they need none.
    pub(super) fn sync_folder(&self, folder: &Path) -> io::Result<()> {
        self.before(Step::SyncFolder, folder)?;
        if cfg!(windows) {
            return Ok(());
        }
        match File::open(folder)?.sync_all() {
            Err(error) if matches!(error.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => Ok(()),
            synced => synced,
        }
    }
}

/// A folder's path as the system wants it.
pub(super) fn here(path: &Path) -> &Path {
    if path.as_os_str().is_empty() { Path::new(".") } else { path }
}

/// How temporary names are made.
fn temporary() -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX).rand_bytes(8);
    builder
}
