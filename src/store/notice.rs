//! The notice of a set that is coming under its final names.
//!
//! Before the first file of a set gets its final name, a notice with the names and sums of the new files and of those
//! that they replace lies on the disk beside them; after the last one it is removed. Where a run ended in between,
//! however it ended, whoever comes next into the folder finds the notice and completes the set, or puts back what was
//! there before; where neither can be done, it tells which files do not belong together.

#![expect(clippy::disallowed_methods, reason = "the store is the door to files")]

use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::disk::{Disk, PREFIX, SUFFIX, here};
use super::draft::sum;
use super::lock::Lock;
use super::reason::{refusal, shown};
use super::rules::*;
use crate::finding::{Finding, Place, Raise, Refusal};
use crate::limits::NOTICE_BYTES;
use crate::text::{Text, t};

/// The notice's name.
const NAME: &str = ".rodete-delivery.json";

/// What is put behind the name of a workbook that is kept.
pub(super) const KEPT: &str = ".bak";

/// The way to the folder above.
pub(super) const ABOVE: &str = "../";

/// The files of a set.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Notice {
    files: Vec<Entry>,
}

/// A file of the set.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    /// Its final name.
    name: OsString,
    /// The SHA-256 of its new bytes.
    sha256: String,
    /// Where it is until it gets its final name.
    draft: OsString,
    /// The file that has the final name before; `None` where there is none.
    before: Option<Before>,
}

/// A file that is replaced.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Before {
    /// Its second name.
    second: OsString,
    /// The SHA-256 of its bytes.
    sha256: String,
}

/// What stands under a final name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stands {
    /// The file of this set.
    New,
    /// What stood there before: a file, or nothing.
    Old,
    /// Something else: it was changed or removed since.
    Other,
}

impl Entry {
    fn stands(&self, folder: &Path) -> io::Result<Stands> {
        let found = sum_of(&folder.join(&self.name))?;
        Ok(match (found, &self.before) {
            (Some(found), _) if found == self.sha256 => Stands::New,
            (Some(found), Some(before)) if found == before.sha256 => Stands::Old,
            (None, None) => Stands::Old,
            _ => Stands::Other,
        })
    }

    /// True where new and old are the same.
    fn same(&self) -> bool {
        self.before.as_ref().is_some_and(|before| before.sha256 == self.sha256)
    }
}

impl Notice {
    /// Adds a file: its final name, its sum, the draft, and the second name of the file that it replaces.
    /// `way` leads from the folder of the notice to that of the file.
    pub(super) fn add(
        &mut self,
        way: &str,
        name: &OsStr,
        sha256: &str,
        draft: &Path,
        second: Option<&Path>,
    ) -> io::Result<()> {
        let led = |name: &OsStr| {
            let mut led = OsString::from(way);
            led.push(name);
            led
        };
        let last = |path: &Path| path.file_name().map(led).ok_or(ErrorKind::InvalidFilename);
        let before = match second {
            None => None,
            Some(second) => {
                let sha256 = sum_of(second)?.ok_or(ErrorKind::NotFound)?;
                Some(Before { second: last(second)?, sha256 })
            }
        };
        self.files.push(Entry { name: led(name), sha256: sha256.to_owned(), draft: last(draft)?, before });
        Ok(())
    }

    /// Puts the notice into a folder; it is on the disk when this is done.
    pub(super) fn put(&self, folder: &Path, disk: &Disk) -> io::Result<()> {
        let text = serde_json::to_string_pretty(self)?;
        let (file, path) = disk.create(folder)?;
        let written = write_all(disk, &file, &path, text.as_bytes())
            .and_then(|()| disk.sync(&file, &path))
            .and_then(|()| disk.rename(&path, &folder.join(NAME)));
        if let Err(error) = written {
            let _ = disk.remove(&path);
            return Err(error);
        }
        disk.sync_folder(folder)
    }

    /// The notice in a folder, if there is one.
    ///
    /// # Errors
    /// Exit 5 where it cannot be read.
    fn read(folder: &Path) -> Result<Option<Self>, Refusal> {
        let path = folder.join(NAME);
        match fs::symlink_metadata(&path) {
            Ok(found) if found.is_file() && found.len() <= NOTICE_BYTES => {}
            Ok(_) => return Err(illegible(&path)),
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(_) => return Err(illegible(&path)),
        }
        let mut text = String::new();
        match File::open(&path).and_then(|file| file.take(NOTICE_BYTES).read_to_string(&mut text)) {
            Ok(_) => {}
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(_) => return Err(illegible(&path)),
        }
        let notice: Self = serde_json::from_str(&text).map_err(|_| illegible(&path))?;
        if notice.sound() { Ok(Some(notice)) } else { Err(illegible(&path)) }
    }

    /// True where every name is that of a file in the folder itself, and what may be moved or removed is ours. In the folder above a
    /// workbook alone may be replaced, and kept.
    fn sound(&self) -> bool {
        let plain = |name: &OsStr| {
            let mut steps = Path::new(name).components();
            matches!((steps.next(), steps.next()), (Some(Component::Normal(only)), None) if only == name)
        };
        let ours = |name: &OsStr| {
            let bytes = name.as_encoded_bytes();
            plain(name) && bytes.starts_with(PREFIX.as_bytes()) && bytes.ends_with(SUFFIX.as_bytes())
        };
        self.files.iter().all(|entry| {
            let seconds = || entry.before.iter().map(|before| &*before.second);
            let Some(book) = above(&entry.name) else {
                return plain(&entry.name) && ours(&entry.draft) && seconds().all(ours);
            };
            let names = std::iter::once(&*entry.draft).chain(seconds());
            let name = book.to_string_lossy().to_lowercase();
            let kept = name.strip_suffix(KEPT);
            let workbook = [".xlsx", ".xlsm"].iter().any(|ending| kept.unwrap_or(&name).ends_with(ending));
            plain(book)
                && workbook
                && (kept.is_some() || entry.before.is_some())
                && names.map(above).all(|name| name.is_some_and(ours))
        })
    }

    /// Completes the set. False where that cannot be done; nothing is changed then.
    fn complete(&self, folder: &Path, disk: &Disk) -> io::Result<bool> {
        let mut left = Vec::new();
        for entry in &self.files {
            match entry.stands(folder)? {
                Stands::New => {}
                Stands::Old if sum_of(&folder.join(&entry.draft))?.as_deref() == Some(&entry.sha256) => {
                    left.push(entry)
                }
                _ => return Ok(false),
            }
        }
        for entry in left {
            disk.rename(&folder.join(&entry.draft), &folder.join(&entry.name))?;
        }
        Ok(true)
    }

    /// Takes every new file away again and puts back what was there before; gives those with which that failed. What was
    /// changed or removed since is left as it is.
    pub(super) fn put_back(&self, folder: &Path, disk: &Disk) -> Vec<PathBuf> {
        let mut stuck = Vec::new();
        for entry in self.files.iter().rev().filter(|entry| !entry.same()) {
            let target = folder.join(&entry.name);
            let undone = match (entry.stands(folder), &entry.before) {
                (Ok(Stands::Old | Stands::Other), _) => Ok(()),
                (Ok(Stands::New), None) => disk.remove(&target),
                (Ok(Stands::New), Some(before)) => {
                    let second = folder.join(&before.second);
                    match sum_of(&second) {
                        Ok(Some(found)) if found == before.sha256 => disk.rename(&second, &target),
                        Ok(_) => Err(ErrorKind::NotFound.into()),
                        Err(error) => Err(error),
                    }
                }
                (Err(error), _) => Err(error),
            };
            if undone.is_err() {
                stuck.push(target);
            }
        }
        stuck
    }

    /// Removes the notice and what was kept for it, now that the set is whole and its names are on the disk. Where the
    /// notice cannot be removed, whoever comes next sees that the set is whole.
    pub(super) fn end(&self, folder: &Path, disk: &Disk) {
        match disk.remove(&folder.join(NAME)) {
            Err(error) if error.kind() != ErrorKind::NotFound => return,
            _ => {}
        }
        let _ = disk.sync_folder(folder);
        for entry in &self.files {
            for name in std::iter::once(&entry.draft).chain(entry.before.iter().map(|before| &before.second)) {
                let path = folder.join(name);
                if fs::symlink_metadata(&path).is_ok() {
                    let _ = disk.remove(&path);
                }
            }
        }
    }

    /// `None` where all files are new, or none is: the set is whole. Else which is which.
    fn mixed(&self, folder: &Path) -> Option<Refusal> {
        let (mut new, mut old, mut other) = (Vec::new(), Vec::new(), Vec::new());
        for entry in &self.files {
            let name = shown(Path::new(&entry.name));
            match entry.stands(folder) {
                Ok(_) if entry.same() => {}
                Ok(Stands::New) => new.push(name),
                Ok(Stands::Old) if entry.before.is_none() => other.push(name),
                Ok(Stands::Old) => old.push(name),
                Ok(Stands::Other) | Err(_) => other.push(name),
            }
        }
        if new.is_empty() || (old.is_empty() && other.is_empty()) {
            return None;
        }
        let listed = |word: &str, names: &[String]| {
            if names.is_empty() { String::new() } else { format!("; {word}: {}", names.join(", ")) }
        };
        let files = [["nuevos", "de antes", "faltan o han cambiado"], ["new", "of before", "missing or changed"]].map(
            |words| words.into_iter().zip([&new, &old, &other]).map(|(word, names)| listed(word, names)).collect(),
        );
        let [es, en] = files;
        Some(refusal(&SetsMixed { folder: shown(folder), files: Text::new(es, en) }))
    }

    fn names(&self) -> String {
        self.files.iter().map(|entry| shown(Path::new(&entry.name))).collect::<Vec<_>>().join(", ")
    }
}

/// The name of a file in the folder above, from the way to it.
fn above(name: &OsStr) -> Option<&OsStr> {
    let mut steps = Path::new(name).components();
    match (steps.next(), steps.next(), steps.next()) {
        (Some(Component::ParentDir), Some(Component::Normal(name)), None) => Some(name),
        _ => None,
    }
}

/// True where a folder holds a notice.
pub(super) fn stands(folder: &Path) -> bool {
    fs::symlink_metadata(folder.join(NAME)).is_ok()
}

/// Looks for a set that a run left half delivered in a folder, and completes it or puts back what was there before. Says
/// what was done; nothing where every set is whole. A folder that does not exist holds no set.
///
/// # Errors
/// Exit 5 where files of two sets are mixed and neither can be done, with their names; where another run is at work
/// there for long.
pub fn settle(folder: &Path) -> Result<Option<Finding>, Refusal> {
    settle_on(folder, &Disk::default())
}

/// The same on another disk.
///
/// # Errors
/// As [`settle`].
pub fn settle_on(folder: &Path, disk: &Disk) -> Result<Option<Finding>, Refusal> {
    let folder = here(folder);
    if !stands(folder) {
        return Ok(None);
    }
    match Lock::wait(folder, disk) {
        Ok(_lock) => settle_locked(folder, disk),
        // Nothing can be changed there: it may be whole all the same.
        Err(refusal) => match Notice::read(folder)? {
            None => Ok(None),
            Some(notice) => match notice.mixed(folder) {
                None => Ok(None),
                Some(mut mixed) => {
                    mixed.findings.extend(refusal.findings);
                    Err(mixed)
                }
            },
        },
    }
}

/// The same under the folder's lock.
pub(super) fn settle_locked(folder: &Path, disk: &Disk) -> Result<Option<Finding>, Refusal> {
    let Some(notice) = Notice::read(folder)? else { return Ok(None) };
    let done = if notice.complete(folder, disk).unwrap_or(false) {
        t("se ha completado", "was completed")
    } else if notice.put_back(folder, disk).is_empty() {
        t("se ha dejado como estaba antes", "was put back as it was before")
    } else if let Some(mixed) = notice.mixed(folder) {
        return Err(mixed);
    } else {
        t("está entero", "is whole")
    };
    if disk.sync_folder(folder).is_ok() {
        notice.end(folder, disk);
    }
    Ok(Some(SetSettled { folder: shown(folder), done, files: notice.names() }.at(Place::File)))
}

/// The SHA-256 of an ordinary file, in lower-case hexadecimal; `None` where there is no file. Of what is no file the text is empty.
///
/// # Errors
/// Where the system does not let it be read.
pub fn sum_of(path: &Path) -> io::Result<Option<String>> {
    match fs::symlink_metadata(path) {
        Ok(found) if found.is_file() => {}
        Ok(_) => return Ok(Some(String::new())),
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    }
    File::open(path).and_then(|mut file| sum(&mut file)).map(|(_, sha256)| Some(sha256))
}

fn write_all(disk: &Disk, file: &File, path: &Path, mut bytes: &[u8]) -> io::Result<()> {
    while !bytes.is_empty() {
        match disk.write(file, path, bytes) {
            Ok(0) => return Err(ErrorKind::WriteZero.into()),
            Ok(written) => bytes = bytes.get(written..).unwrap_or_default(),
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

fn illegible(path: &Path) -> Refusal {
    refusal(&NoticeIllegible { path: shown(path) })
}
