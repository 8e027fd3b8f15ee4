//! Temporary files: locked while they are written, known to the whole process, so that an interruption removes them.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use sha2::{Digest, Sha256};

use super::disk::Disk;

/// What would have to be removed if the process ended now.
#[derive(Debug, Default)]
pub(super) struct Unfinished {
    files: BTreeSet<PathBuf>,
    folders: BTreeSet<PathBuf>,
}

impl Unfinished {
    pub(super) fn forget(&mut self, path: &Path) {
        self.files.remove(path);
    }

    pub(super) fn begun(&mut self, path: &Path) {
        self.files.insert(path.to_owned());
    }

    pub(super) fn folder_made(&mut self, path: &Path) {
        self.folders.insert(path.to_owned());
    }
}

static UNFINISHED: Mutex<Unfinished> = Mutex::new(Unfinished { files: BTreeSet::new(), folders: BTreeSet::new() });

/// The register of unfinished files. While it is held no interruption removes anything: renames are done under it.
pub(super) fn unfinished() -> MutexGuard<'static, Unfinished> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes every unfinished file, and the folders made for them where they are empty, for a process that is about to
/// end: nothing can be written after it. A set that is just coming under its final names is finished first.
pub fn abandon() {
    let mut unfinished = unfinished();
    for file in std::mem::take(&mut unfinished.files) {
        let _ = fs::remove_file(file);
    }
    for folder in std::mem::take(&mut unfinished.folders).iter().rev() {
        let _ = fs::remove_dir(folder);
    }
    // The register stays locked: no thread may begin another file or commit a set from here on.
    std::mem::forget(unfinished);
}

/// A temporary file in the folder of its final name.
#[derive(Debug)]
pub(super) struct Draft {
    /// `None` once it has been handed over.
    file: Option<File>,
    path: PathBuf,
    disk: Disk,
}

impl Draft {
    /// A new temporary file, locked.
    pub(super) fn new(folder: &Path, disk: &Disk) -> io::Result<Self> {
        let mut unfinished = unfinished();
        let (file, path) = disk.create(folder)?;
        unfinished.begun(&path);
        // Without a lock its age alone keeps it from being taken for a leftover. On Windows a lock would keep everyone
        // else from reading it.
        if cfg!(unix) {
            let _ = file.try_lock();
        }
        Ok(Self { file: Some(file), path, disk: disk.clone() })
    }

    fn file(&self) -> io::Result<&File> {
        self.file.as_ref().ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))
    }

    /// Somewhere to write the file's contents to.
    pub(super) fn output(&self) -> io::Result<Output<'_>> {
        Ok(Output::new(Paper { file: self.file()?, path: &self.path, disk: &self.disk }, 1 << 16))
    }

    /// Where the file is until it gets its final name.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Brings the file to the disk.
    pub(super) fn sync(&self) -> io::Result<()> {
        self.disk.sync(self.file()?, &self.path)
    }

    /// Reads the file back: its bytes and their SHA-256 in lower-case hexadecimal.
    pub(super) fn sum(&self) -> io::Result<(u64, String)> {
        let mut file = self.file()?;
        file.seek(SeekFrom::Start(0))?;
        sum(&mut file)
    }

    /// Renames the file to its final name, replacing what is there if `replace`.
    pub(super) fn become_final(&mut self, target: &Path, replace: bool, unfinished: &mut Unfinished) -> io::Result<()> {
        if replace {
            self.disk.rename(&self.path, target)?;
        } else {
            self.disk.rename_to_free(&self.path, target)?;
        }
        self.leave(unfinished);
        Ok(())
    }

    /// True once the file has its final name, or was left where it is.
    pub(super) const fn is_left(&self) -> bool {
        self.file.is_none()
    }

    /// Leaves the file where it is, and lets go of it.
    pub(super) fn leave(&mut self, unfinished: &mut Unfinished) {
        unfinished.forget(&self.path);
        if let Some(file) = self.file.take() {
            let _ = file.unlock();
        }
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if let Some(file) = self.file.take() {
            let mut unfinished = unfinished();
            drop(file);
            let _ = self.disk.remove(&self.path);
            unfinished.forget(&self.path);
        }
    }
}

/// The bytes of a file and their SHA-256 in lower-case hexadecimal.
pub(super) fn sum(file: &mut impl Read) -> io::Result<(u64, String)> {
    let mut digest = Sha256::new();
    let bytes = sum_into(&mut digest, file)?;
    Ok((bytes, hexadecimal(&digest.finalize())))
}

/// Takes a file, from where it stands to its end, into a sum; gives how many bytes there were.
pub(super) fn sum_into(digest: &mut Sha256, file: &mut impl Read) -> io::Result<u64> {
    let mut bytes = 0;
    let mut part = vec![0; 1 << 16];
    loop {
        let read = match file.read(&mut part) {
            Ok(0) => break,
            Ok(read) => read,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        digest.update(part.get(..read).unwrap_or_default());
        bytes += u64::try_from(read).unwrap_or(u64::MAX);
    }
    Ok(bytes)
}

/// The SHA-256 of bytes, in lower-case hexadecimal.
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

pub(super) fn hexadecimal(bytes: &[u8]) -> String {
    use std::fmt::Write as _;
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// Where the contents of one file are written to. It remembers the first error of the system, so that the message is
/// right even where a library in between wraps it. After that error it takes everything and writes nothing: libraries
/// that finish their work while giving up shall do so in silence.
#[derive(Debug)]
pub struct Output<'a> {
    inner: BufWriter<Paper<'a>>,
    fault: Option<Fault>,
}

/// The file itself, under its temporary name.
#[derive(Debug)]
struct Paper<'a> {
    file: &'a File,
    path: &'a Path,
    disk: &'a Disk,
}

impl Write for Paper<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.disk.write(self.file, self.path, bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Paper<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }
}

/// The first error, and where writing would stand had there been none.
#[derive(Debug)]
struct Fault {
    error: io::Error,
    at: u64,
    end: u64,
}

impl Fault {
    fn write(&mut self, bytes: usize) {
        self.at = self.at.saturating_add(u64::try_from(bytes).unwrap_or(u64::MAX));
        self.end = self.end.max(self.at);
    }

    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let at = match to {
            SeekFrom::Start(at) => Some(at),
            SeekFrom::Current(by) => self.at.checked_add_signed(by),
            SeekFrom::End(by) => self.end.checked_add_signed(by),
        };
        self.at = at.ok_or(io::ErrorKind::InvalidInput)?;
        Ok(self.at)
    }
}

impl<'a> Output<'a> {
    fn new(paper: Paper<'a>, buffer: usize) -> Self {
        Self { inner: BufWriter::with_capacity(buffer, paper), fault: None }
    }

    /// Flushes; gives the first error that writing met.
    pub(super) fn finish(mut self) -> io::Result<()> {
        let flushed = self.flush();
        let Some(fault) = self.fault.take() else { return flushed };
        // What is still in the buffer cannot be written either, and no more attempt is wanted.
        let _ = self.inner.into_parts();
        Err(fault.error)
    }

    fn remember<T>(&mut self, result: io::Result<T>) -> io::Result<T> {
        if let (Err(error), None) = (&result, &self.fault)
            && error.kind() != io::ErrorKind::Interrupted
        {
            let error = match error.raw_os_error() {
                Some(code) => io::Error::from_raw_os_error(code),
                None => io::Error::new(error.kind(), error.to_string()),
            };
            let mut file = self.inner.get_ref().file;
            let at = file.stream_position().unwrap_or(0);
            let at = at.saturating_add(u64::try_from(self.inner.buffer().len()).unwrap_or(0));
            let end = file.metadata().map_or(at, |found| found.len().max(at));
            self.fault = Some(Fault { error, at, end });
        }
        result
    }
}

impl Write for Output<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Some(fault) = &mut self.fault {
            fault.write(bytes.len());
            return Ok(bytes.len());
        }
        let written = self.inner.write(bytes);
        self.remember(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.fault.is_some() {
            return Ok(());
        }
        let flushed = self.inner.flush();
        self.remember(flushed)
    }
}

impl Seek for Output<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        if let Some(fault) = &mut self.fault {
            return fault.seek(to);
        }
        let at = self.inner.seek(to);
        self.remember(at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn after_the_first_error_everything_is_taken_and_the_error_kept() {
        let there = tempfile::tempdir().expect("a folder");
        let path = there.path().join("read-only");
        fs::write(&path, "0123456789").expect("a file");
        // Open for reading alone: the system takes nothing.
        let file = File::open(&path).expect("the file");
        let disk = Disk::default();
        let mut output = Output::new(Paper { file: &file, path: &path, disk: &disk }, 4);
        assert!(output.write_all(b"more than the buffer").is_err());
        assert_eq!(output.seek(SeekFrom::End(0)).expect("an end"), 10);
        output.write_all(b"more").expect("taken");
        assert_eq!(output.stream_position().expect("a position"), 14);
        assert_eq!(output.seek(SeekFrom::Current(-4)).expect("a position"), 10);
        assert!(output.seek(SeekFrom::Current(-11)).is_err());
        output.flush().expect("taken");
        assert!(output.finish().is_err());
        assert_eq!(fs::read(&path).expect("the file"), b"0123456789");
    }
}
