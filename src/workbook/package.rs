//! The zip package of a workbook: its entries under caps, every one unpacked to its end.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::io::{self, Cursor, Read, Write};

use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use crate::escape::{excerpt, printable};
use crate::finding::answer::quoted;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::text::{Text, t};

use super::limits;
use super::rules::package::*;

/// The signature of an entry in a zip's central directory.
const CENTRAL_ENTRY: &[u8] = b"PK\x01\x02";

/// A package whose entries all unpack within the caps and whose checksums hold.
#[derive(Debug)]
pub struct Package<'a> {
    archive: ZipArchive<Cursor<&'a [u8]>>,
    /// Index of each entry by its name in lower case, with `/` between folders: calamine looks parts up this way.
    entries: HashMap<String, usize>,
    /// The file's bytes.
    pub bytes: &'a [u8],
}

impl<'a> Package<'a> {
    /// Walks the whole package.
    ///
    /// # Errors
    /// [`Exit::Unreadable`] for a damaged package and for names that are doubled or point outside of it;
    /// [`Exit::Limit`] for more entries or more unpacked bytes than [`limits`] allows. Nothing is unpacked beyond them.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Refusal> {
        // Counted before the directory is read into memory. A signature inside of packed data could only raise it.
        if memchr::memmem::find_iter(bytes, CENTRAL_ENTRY).nth(limits::ENTRIES).is_some() {
            let most = limits::ENTRIES;
            return Err(TooManyEntries { most }.refused(Exit::Unreadable, Place::File));
        }
        let archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| match error {
            // No end-of-directory record was found: the usual sign of an interrupted download.
            ZipError::InvalidArchive(_) if memchr::memmem::rfind(bytes, b"PK\x05\x06").is_none() => {
                ZipEndMissing {}.refused(Exit::Unreadable, Place::File)
            }
            error => {
                let reason = printable(&error.to_string());
                ZipDirectoryDamaged { reason }.refused(Exit::Unreadable, Place::File)
            }
        })?;
        if archive.has_duplicate_names() {
            return Err(EntryTwice {}.refused(Exit::Unreadable, Place::File));
        }
        let mut package = Self { archive, entries: HashMap::new(), bytes };
        package.list()?;
        for index in 0..package.archive.len() {
            package.verify(index)?;
        }
        Ok(package)
    }

    /// True where the package has a part of this name, in whatever case.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.entries.contains_key(&name.to_ascii_lowercase())
    }

    /// True where a name of the package, in lower case, ends so.
    #[must_use]
    pub fn has_ending(&self, ending: &str) -> bool {
        self.entries.keys().any(|name| name.ends_with(ending))
    }

    /// True where a name of the package, in lower case, begins so.
    #[must_use]
    pub fn has_beginning(&self, beginning: &str) -> bool {
        self.entries.keys().any(|name| name.starts_with(beginning))
    }

    /// A part's bytes; `None` where there is no such part.
    ///
    /// # Errors
    /// [`Exit::Limit`] for a part of more than `most` bytes.
    pub fn part(&mut self, name: &str, most: u64) -> Result<Option<Vec<u8>>, Refusal> {
        let Some(&index) = self.entries.get(&name.to_ascii_lowercase()) else {
            return Ok(None);
        };
        let mut entry = self.archive.by_index(index).map_err(|error| broken(name, &error))?;
        let mut bytes = Vec::new();
        let read = io::copy(&mut entry.by_ref().take(most + 1), &mut bytes);
        read.map_err(|error| broken(name, &ZipError::Io(error)))?;
        if u64::try_from(bytes.len()).is_ok_and(|length| length <= most) {
            Ok(Some(bytes))
        } else {
            Err(too_large(name, most))
        }
    }

    /// The same package with other contents in some of its parts; the rest is not packed anew.
    ///
    /// # Errors
    /// [`Exit::Unreadable`] where an entry cannot be taken over.
    pub fn with(&self, parts: &[(String, Vec<u8>)]) -> Result<Vec<u8>, Refusal> {
        let mut archive = self.archive.clone();
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        let replaced: Vec<usize> =
            parts.iter().filter_map(|(name, _)| self.entries.get(&name.to_ascii_lowercase()).copied()).collect();
        for index in (0..archive.len()).filter(|index| !replaced.contains(index)) {
            let entry = archive.by_index_raw(index).map_err(|error| broken("", &error))?;
            writer.raw_copy_file(entry).map_err(|error| broken("", &error))?;
        }
        for (name, content) in parts {
            let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
            writer.start_file(name.as_str(), stored).map_err(|error| broken(name, &error))?;
            writer.write_all(content).map_err(|error| broken(name, &ZipError::Io(error)))?;
        }
        Ok(writer.finish().map_err(|error| broken("", &error))?.into_inner())
    }

    /// The names of the entries as they stand in the package, in its order.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let name = |index| self.archive.name_for_index(index).and_then(Result::ok).unwrap_or_default().into_owned();
        (0..self.archive.len()).map(name).collect()
    }

    /// The package without some entries, with other contents in some, and with further ones at its end. Names are those of
    /// [`Package::names`]. What is not named is copied as it lies there, packed and dated.
    ///
    /// # Errors
    /// [`Exit::Unreadable`] where an entry cannot be taken over.
    pub fn changed(
        &self,
        gone: &BTreeSet<String>,
        changed: &BTreeMap<String, Vec<u8>>,
        added: &[(String, Vec<u8>)],
    ) -> Result<Vec<u8>, Refusal> {
        let mut archive = self.archive.clone();
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        writer.set_raw_comment(archive.comment().into()).map_err(|error| broken("", &error))?;
        let packed = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(zip::DateTime::default())
            .unix_permissions(0o600);
        for (index, name) in self.names().iter().enumerate() {
            if gone.contains(name) {
                continue;
            }
            let entry = archive.by_index_raw(index).map_err(|error| broken(name, &error))?;
            if let Some(content) = changed.get(name) {
                let dated = packed.last_modified_time(entry.last_modified().unwrap_or_default());
                drop(entry);
                writer.start_file(name.as_str(), dated).map_err(|error| broken(name, &error))?;
                writer.write_all(content).map_err(|error| broken(name, &ZipError::Io(error)))?;
            } else {
                writer.raw_copy_file(entry).map_err(|error| broken(name, &error))?;
            }
        }
        for (name, content) in added {
            writer.start_file(name.as_str(), packed).map_err(|error| broken(name, &error))?;
            writer.write_all(content).map_err(|error| broken(name, &ZipError::Io(error)))?;
        }
        Ok(writer.finish().map_err(|error| broken("", &error))?.into_inner())
    }

    /// Takes the names and the declared sizes.
    fn list(&mut self) -> Result<(), Refusal> {
        let mut total = 0_u64;
        for index in 0..self.archive.len() {
            let entry = self.archive.by_index_data(index).map_err(|error| broken("", &error))?;
            // Any name can be read: as UTF-8, or else in code page 437.
            let name = entry.name().map_err(|error| broken("", &error))?.into_owned();
            let normal = name.replace('\\', "/").to_ascii_lowercase();
            let outside = normal.starts_with('/')
                || normal.contains('\0')
                || normal.contains(':')
                || normal.split('/').any(|step| step == "..");
            if outside {
                return Err(EntryOutside { entry: excerpt(&name, 80) }.refused(Exit::Unreadable, Place::File));
            }
            if entry.encrypted() {
                return Err(EntryEncrypted {}.refused(Exit::Unreadable, Place::File));
            }
            let method = entry.compression();
            if !matches!(method, CompressionMethod::Stored | CompressionMethod::Deflated) {
                let how = Text::new(
                    format!("método de compresión {method}, ajeno a .xlsx"),
                    format!("compression method {method}, not one of .xlsx"),
                );
                return Err(part_damaged(&name, how));
            }
            let size = entry.size();
            if size > limits::PART {
                return Err(too_large(&name, limits::PART));
            }
            total = total.saturating_add(size);
            if self.entries.insert(normal, index).is_some() {
                let entry = excerpt(&name, 80);
                return Err(EntryTwiceButForCapitals { entry }.refused(Exit::Unreadable, Place::File));
            }
        }
        if total > limits::TOTAL {
            let most = limits::mebibytes(limits::TOTAL);
            return Err(PackageTooLarge { most }.refused(Exit::Limit, Place::File));
        }
        Ok(())
    }

    /// Unpacks an entry to its end without keeping it: the reader compares the checksum there.
    fn verify(&mut self, index: usize) -> Result<(), Refusal> {
        let name = self.archive.name_for_index(index).and_then(Result::ok).unwrap_or_default().into_owned();
        let mut entry = self.archive.by_index(index).map_err(|error| broken(&name, &error))?;
        let declared = entry.size();
        // One byte more than declared is enough to see that the declaration is false.
        let unpacked = io::copy(&mut entry.by_ref().take(declared + 1), &mut io::sink())
            .map_err(|error| broken(&name, &ZipError::Io(error)))?;
        if unpacked != declared {
            return Err(part_damaged(&name, t("longitud", "length")));
        }
        Ok(())
    }
}

fn part_damaged(name: &str, how: Text) -> Refusal {
    EntryDamaged { entry: excerpt(name, 80), how }.refused(Exit::Unreadable, Place::Part(name.to_owned()))
}

/// The refusal of an entry that does not unpack.
fn broken(name: &str, error: &ZipError) -> Refusal {
    let how = match error {
        ZipError::Io(error) if error.to_string().contains("checksum") => t("suma de comprobación", "checksum"),
        ZipError::Io(_) => t("datos comprimidos", "compressed data"),
        error => quoted(printable(&error.to_string())),
    };
    part_damaged(name, how)
}

fn too_large(name: &str, most: u64) -> Refusal {
    let (part, most) = (excerpt(name, 80), limits::mebibytes(most));
    PartTooLarge { part, most }.refused(Exit::Limit, Place::Part(name.to_owned()))
}
