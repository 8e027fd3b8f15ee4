//! Results and forms that go into a workbook of the engineer's own.

use std::io::Cursor;
use std::path::Path;

use super::plan::Item;
use crate::escape::{printable, printable_path};
use crate::finding::rules::NotComposed;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::graft::rules::CopyThere;
use crate::graft::{Donor, Host};
use crate::kind::Outcome;
use crate::store::{self, Folder, Set};
use crate::text::Language;
use crate::workbook::error::WriteError;
use crate::workbook::names::{Made, Present};
use crate::workbook::results::Tables;
use crate::workbook::{self, Filled, gate, results};

/// A workbook that results go into.
#[derive(Debug)]
pub(super) struct Into<'a> {
    workbook: &'a Path,
    bytes: &'a [u8],
    host: Host<'a>,
    /// What a person should know about it.
    notes: Vec<Finding>,
    present: Present,
    /// The names of the inputs with their cells.
    inputs: Vec<(&'static str, String)>,
}

/// What was done with deliveries that killed runs left half done where the workbook and its files are; leftovers are removed.
///
/// # Errors
/// Exit 5 where files of two sets are mixed, or where nothing can be written beside the workbook.
pub(super) fn settled(item: &Item) -> Result<Vec<Finding>, Refusal> {
    let out = store::settle(&item.folder)?;
    let own = Folder::open(item.workbook.parent().unwrap_or(Path::new("")))?;
    Ok(out.into_iter().chain(own.settled().cloned()).collect())
}

impl<'a> Into<'a> {
    /// Opens a workbook that was read, with the form that it fills in.
    ///
    /// # Errors
    /// Exit 3 where no sheets may be put in; exit 5 where it cannot be replaced.
    pub(super) fn open(item: &'a Item, bytes: &'a [u8], filled: &Filled, inputs: &[&Path]) -> Result<Self, Refusal> {
        store::replaceable(&item.workbook, inputs)?;
        let host = Host::open(bytes)?;
        let mut notes = host.notes().to_vec();
        let mut present = host.present();
        notes.extend(copy_there(&host, &item.workbook));
        let cell_of = |key: &str| filled.values.cells.get(key);
        for (index, sheet) in filled.form.sheets.iter().enumerate() {
            let keys = sheet.sections.iter().flat_map(|section| section.parameters);
            if let Some(cell) = keys.filter_map(|one| cell_of(one.key)).next() {
                present.forms.insert(index, cell.sheet.clone());
            }
        }
        present.folder = printable_path(&item.folder);
        present.copies = filled.copies.clone();
        let inputs = filled.form.parameters().filter_map(|(_, one)| {
            let cell = cell_of(one.key)?;
            let (letters, digits) = cell.cell.split_at(cell.cell.find(|one: char| one.is_ascii_digit())?);
            Some((one.name, format!("'{}'!${letters}${digits}", cell.sheet.replace('\'', "''"))))
        });
        let inputs = inputs.collect();
        Ok(Self { workbook: &item.workbook, bytes, host, notes, present, inputs })
    }

    /// What a person should know about the workbook.
    pub(super) fn notes(&self) -> &[Finding] {
        &self.notes
    }

    /// Adds the workbook with the results to the set.
    ///
    /// # Errors
    /// Exit 3 where the workbook does not take them, 5 where it cannot be written, 7 where it would become too large.
    pub(super) fn put(
        self,
        outcome: &Outcome,
        files: &[results::File],
        tables: Tables,
        language: Language,
        set: &mut Set<'_>,
    ) -> Result<(), Refusal> {
        let Self { workbook, bytes, host, present, inputs, .. } = self;
        let (donor, sheets) =
            composed(workbook, |out| results::write_into(outcome, files, tables, language, &present, out))?;
        let grown = host.put(&Donor { bytes: &donor, sheets: &sheets, inputs, source: &outcome.source.sha256 })?;
        set.replace(workbook, bytes, &grown)
    }
}

/// The note on a copy that is there before any was kept, and that is no earlier one of this workbook.
pub(super) fn copy_there(host: &Host<'_>, workbook: &Path) -> Option<Finding> {
    let copy = store::copy_of(workbook).filter(|_| host.first())?;
    let told = CopyThere { path: printable_path(&copy) }.at(Place::File);
    (!is_earlier(&copy, &host.present().taken)).then_some(told)
}

/// True for a workbook that may be an earlier one with these sheets, such as the copy of before its form was put in.
fn is_earlier(copy: &Path, sheets: &[String]) -> bool {
    let Ok(bytes) = workbook::open(copy) else { return false };
    gate(&bytes).is_ok_and(|gated| gated.sheets.iter().all(|one| sheets.contains(&one.name)))
}

/// The bytes of a workbook as it is composed, with its sheets.
///
/// # Errors
/// Exit 1 where it cannot be composed.
pub(super) fn composed(
    path: &Path,
    write: impl FnOnce(&mut Cursor<Vec<u8>>) -> Result<Vec<Made>, WriteError>,
) -> Result<(Vec<u8>, Vec<Made>), Refusal> {
    let mut out = Cursor::new(Vec::new());
    let sheets = write(&mut out).map_err(|error| {
        let reason = printable(&error.to_string());
        NotComposed { path: printable_path(path), reason }.refused(Exit::Fault, Place::File)
    })?;
    Ok((out.into_inner(), sheets))
}
