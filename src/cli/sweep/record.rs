//! What sweeps have written into a folder beside the rows, so that nothing else is replaced or removed: a best design is there to be
//! edited.

#![expect(clippy::disallowed_methods, reason = "the door to the files of a sweep")]

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::escape::printable_path;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::store::{Existing, Folder, Set, WrittenFile, sum_of};
use crate::sweep::rules::ChangedSince;

/// The record's file.
const NAME: &str = "written.json";

/// The files that sweeps have written into a folder: by their path in it, the sums that they were written with.
pub(super) struct Record {
    place: PathBuf,
    known: BTreeMap<String, BTreeSet<String>>,
}

impl Record {
    /// The record of a folder; empty where there is none, or none that can be read.
    pub(super) fn open(place: &Path) -> Self {
        let known = fs::read(place.join(NAME)).ok().and_then(|bytes| serde_json::from_slice(&bytes).ok());
        Self { place: place.to_owned(), known: known.unwrap_or_default() }
    }

    /// Checks that what stands under a name, if anything does, is what a sweep wrote.
    ///
    /// # Errors
    /// Exit 5 where it is another file, or was changed since.
    pub(super) fn check(&self, name: &str) -> Result<(), Refusal> {
        if self.is_free(name) { Ok(()) } else { Err(self.changed(name)) }
    }

    /// Checks all that a sweep wrote, as it stands there now; what is gone is no fault.
    ///
    /// # Errors
    /// Exit 5 where one of them was changed since.
    pub(super) fn check_known(&self, within: &str) -> Result<(), Refusal> {
        self.known.keys().filter(|name| name.starts_with(within)).try_for_each(|name| self.check(name))
    }

    /// The names of what sweeps wrote.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.known.keys().map(String::as_str)
    }

    fn is_free(&self, name: &str) -> bool {
        match sum_of(&self.place.join(name)) {
            Ok(None) => true,
            Ok(Some(sum)) => self.known.get(name).is_some_and(|sums| sums.contains(&sum)),
            Err(_) => false,
        }
    }

    fn changed(&self, name: &str) -> Refusal {
        ChangedSince { path: printable_path(&self.place.join(name)) }.refused(Exit::Unwritable, Place::File)
    }

    /// Notes files that are about to be written, or have just been: a run that is ended in between finds its own again. Another run in
    /// the folder may have noted others meanwhile, which stay.
    pub(super) fn note<'w>(
        &mut self,
        folder: &Folder,
        within: &str,
        files: impl IntoIterator<Item = &'w WrittenFile>,
    ) -> Result<(), Refusal> {
        let before = self.known.clone();
        self.known = Self::open(&self.place).known;
        for file in files {
            let name = format!("{within}{}", file.name.to_string_lossy());
            self.known.entry(name).or_default().insert(file.sha256.clone());
        }
        if self.known == before && self.place.join(NAME).is_file() {
            return Ok(());
        }
        let text = format!("{}\n", serde_json::json!(self.known));
        let mut set = Set::new(folder, &[], Existing::Replace);
        set.write(OsStr::new(NAME), |out| out.write_all(text.as_bytes()))?;
        set.commit().map(drop)
    }

    /// Removes what sweeps wrote, and the record.
    ///
    /// # Errors
    /// Exit 5 where one of them was changed since, before anything is removed; and where the system does not remove one.
    pub(super) fn clear(&self, outer: &Folder) -> Result<(), Refusal> {
        self.check_known("")?;
        for name in self.names() {
            match name.split_once('/') {
                None => outer.remove(OsStr::new(name))?,
                Some((within, name)) => {
                    let place = self.place.join(within);
                    if place.is_dir() {
                        Folder::open(&place)?.remove(OsStr::new(name))?;
                    }
                }
            }
        }
        outer.remove(OsStr::new(NAME))
    }
}

/// Writes one set into the folder of a sweep: nothing is replaced that the sweeps did not write.
///
/// # Errors
/// Exit 5 where something else stands under one of the names, and where nothing can be written.
pub(super) fn commit(set: Set<'_>, folder: &Folder, place: &Path) -> Result<(), Refusal> {
    let mut record = Record::open(place);
    set.written().try_for_each(|file| record.check(&file.name.to_string_lossy()))?;
    record.note(folder, "", set.written())?;
    set.commit().map(drop)
}
