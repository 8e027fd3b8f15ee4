//! The workbook that sheets are put into: whether it may take any, and which are there already.

use std::collections::{BTreeMap, BTreeSet};

use crate::escape::excerpt;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::limits::NAME_EXCERPT;
use crate::store::sha256;
use crate::text::{Text, t};
use crate::workbook::gate;
use crate::workbook::limits;
use crate::workbook::listing::SheetKind;
use crate::workbook::names::Present;
use crate::workbook::stamp::{self, STALE};

use super::book::Book;
use super::marks::{self, SheetMark};
use super::parts::{CONTENT_TYPES, ContentTypes, Parts, Relation, kind, normal, one, relations_of};
use super::rules::*;
use super::sheet::{strings, title};

/// The types of workbooks that are taken.
const WORKBOOKS: [&str; 2] = [
    "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml",
    "application/vnd.ms-excel.sheet.macroEnabled.main+xml",
];

/// The type of a table.
const TABLE: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml.table+xml";

/// A workbook that may take sheets.
#[derive(Debug)]
pub struct Host<'a> {
    pub(super) parts: Parts<'a>,
    /// The normal name of the workbook part.
    pub(super) root: String,
    pub(super) book: Book,
    pub(super) relations: Vec<Relation>,
    pub(super) types: ContentTypes,
    /// The part with the formats of cells.
    pub(super) styles: String,
    /// The part of each sheet, in order.
    pub(super) sheets: Vec<String>,
    /// The sheets that were put in before, by their slugs.
    pub(super) ours: BTreeMap<String, usize>,
    /// The names of tables and their ranges: a workbook has them and its defined names of one stock.
    pub(super) tables: Vec<[String; 2]>,
    notes: Vec<Finding>,
}

/// The hidden name that says which workbook the results were made from.
pub(super) const SOURCE: &str = "rodete_source";
/// The hidden name that says what the sheets of others were then.
pub(super) const OTHERS: &str = "rodete_others";

/// The SHA-256 that a workbook had when the results in it were made; `None` where it has none, or where any part has changed since
/// that rodete did not edit, a sheet with inputs among them.
#[must_use]
pub fn made_from(bytes: &[u8]) -> Option<String> {
    let mut host = Host::open(bytes).ok()?;
    let said = |host: &Host<'_>, name| Some(host.book.global(name)?.formula.trim_matches(['=', '"']).to_owned());
    let (source, others) = (said(&host, SOURCE)?, said(&host, OTHERS)?);
    let ours = host.replaced().ok()?;
    (host.others(&ours).ok()? == others).then_some(source)
}

impl<'a> Host<'a> {
    /// Opens a workbook and judges whether sheets may be put in.
    ///
    /// # Errors
    /// What the gate refuses, and [`Exit::Refused`] for a workbook of a kind that no sheet is put into.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Refusal> {
        let gated = gate(bytes)?;
        let (listed, macros) = (gated.sheets, gated.package.has_ending("vbaproject.bin"));
        let mut parts = Parts::new(gated.package);
        let packaged = parts.relations("")?;
        if packaged.iter().any(|one| one.kind.contains("digital-signature")) || parts.all().any(is_signature) {
            return Err(refused(&BookSigned {}));
        }
        let root =
            one(packaged, kind::DOCUMENT).ok_or_else(|| unfit(t("ninguna parte de libro", "no workbook part")))?;
        let book = Book::new(parts.needed(&root)?);
        let types = ContentTypes::of(&mut parts)?;
        let relations = parts.relations(&root)?;
        admitted(&book, &relations, types.of_part(&root).unwrap_or_default())?;
        let styles = one(relations.clone(), kind::STYLES).filter(|part| parts.name(part).is_some());
        let styles = styles.ok_or_else(|| refused(&NoStyles {}))?;
        let sheets: Vec<String> = listed.iter().map(|one| normal(&one.part)).collect();
        let cells: Vec<bool> = listed.iter().map(|one| one.kind == SheetKind::Cells).collect();
        let mut notes = told(&book, &relations);
        notes.extend(macros.then(|| MacrosStay {}.at(Place::File)));
        let ours = BTreeMap::new();
        let tables = Vec::new();
        let mut host = Self { parts, root, book, relations, types, styles, sheets, ours, tables, notes };
        host.ours = host.known(&cells)?;
        host.tables = host.tables()?;
        let copies = host.copies()?;
        host.notes.extend(copies);
        Ok(host)
    }

    /// What a person should know about this workbook.
    #[must_use]
    pub fn notes(&self) -> &[Finding] {
        &self.notes
    }

    /// True where no results were put in before.
    #[must_use]
    pub fn first(&self) -> bool {
        self.book.global(SOURCE).is_none()
    }

    /// The names of its sheets: those that were put in before by their keys, and all that are taken.
    #[must_use]
    pub fn present(&self) -> Present {
        let name = |index: usize| self.book.sheets.get(index).map(|one| one.name.clone()).unwrap_or_default();
        Present {
            taken: self.book.sheets.iter().map(|one| one.name.clone()).collect(),
            ours: self.ours.iter().map(|(slug, index)| (slug.clone(), name(*index))).collect(),
            ..Present::default()
        }
    }

    /// The SHA-256 over all parts that a graft leaves as they are, with their names; `ours` are those of our sheets.
    pub(super) fn others(&mut self, ours: &BTreeSet<String>) -> Result<String, Refusal> {
        let chains = self.relations.iter().filter(|one| one.kind.ends_with(kind::CALC_CHAIN));
        let mut edited: BTreeSet<String> = chains.map(|one| one.target.clone()).collect();
        let lists = [self.root.clone(), relations_of(&self.root), self.styles.clone(), CONTENT_TYPES.to_owned()];
        edited.extend(lists.iter().map(|part| normal(part)));
        let parts = self.parts.all().filter(|part| !edited.contains(*part) && !ours.contains(*part));
        let parts: Vec<String> = parts.map(str::to_owned).collect();
        let mut told = String::new();
        for part in parts {
            let sum = self.parts.bytes(&part)?.map_or_else(String::new, |bytes| sha256(&bytes));
            told.push_str(&format!("{part} {sum}\n"));
        }
        Ok(sha256(told.as_bytes()))
    }

    /// The sheets that were put in before, each known by its mark and by what its first cell says.
    fn known(&mut self, cells: &[bool]) -> Result<BTreeMap<String, usize>, Refusal> {
        let marks = marks::marks(&self.book.names);
        let strings = self.strings(marks.is_empty())?;
        let mut ours = BTreeMap::new();
        let mut seen = BTreeSet::new();
        for SheetMark { slug, name, place, title: said } in marks {
            // Of a sheet that was deleted the mark is left: the sheet is made anew.
            let Some((sheet, cell)) = place else { continue };
            let there = |one: &super::book::Sheet| one.name.to_lowercase() == sheet.to_lowercase();
            // Others than Excel and LibreOffice leave the mark of a deleted sheet as it was.
            let Some(index) = self.book.sheets.iter().position(there) else { continue };
            let lost = || {
                let title = marks::title(&said);
                refused(&MarkLost { sheet: excerpt(&sheet, NAME_EXCERPT), mark: excerpt(&name, NAME_EXCERPT), title })
            };
            let part = self.sheets.get(index).cloned().ok_or_else(lost)?;
            if cells.get(index) != Some(&true) || !seen.insert(index) {
                return Err(lost());
            }
            let text = self.parts.bytes(&part)?.and_then(|bytes| String::from_utf8(bytes).ok()).ok_or_else(lost)?;
            if marks::said(&title(&text, &cell, &strings)) != said {
                return Err(lost());
            }
            ours.insert(slug, index);
        }
        Ok(ours)
    }

    /// The cautions on sheets that turn red with ours, and are not: copies that somebody made, with the figures of that day.
    fn copies(&mut self) -> Result<Vec<Finding>, Refusal> {
        let ours: BTreeSet<usize> = self.ours.values().copied().collect();
        // The rule of an earlier rodete.
        let rule = format!(">{STALE}&lt;&gt;0<");
        let mut found = Vec::new();
        for index in (0..self.sheets.len()).filter(|index| !ours.contains(index)) {
            let Some(text) = self.parts.bytes(&self.sheets[index])? else { continue };
            let text = String::from_utf8_lossy(&text);
            if text.contains(&rule) || stamp::stamps(&text).next().is_some() {
                let sheet = self.book.sheets.get(index).map(|one| excerpt(&one.name, NAME_EXCERPT)).unwrap_or_default();
                found.push(SheetCopied { sheet }.at(Place::File));
            }
        }
        Ok(found)
    }

    /// The names of its tables, and their ranges.
    fn tables(&mut self) -> Result<Vec<[String; 2]>, Refusal> {
        let is_table = |part: &&str| self.types.of_part(part).is_some_and(|kind| kind.eq_ignore_ascii_case(TABLE));
        let parts: Vec<String> = self.parts.all().filter(is_table).map(str::to_owned).collect();
        let mut tables = Vec::new();
        for part in parts {
            let Some((_, root)) = self.parts.parsed(&part)? else { continue };
            let said = ["displayName", "ref"].map(|key| root.attribute(key).unwrap_or_default().to_owned());
            tables.push(said);
        }
        Ok(tables)
    }

    fn strings(&mut self, none: bool) -> Result<Vec<String>, Refusal> {
        let part = one(self.relations.clone(), kind::STRINGS).filter(|_| !none);
        let Some(part) = part else { return Ok(Vec::new()) };
        Ok(self.parts.parsed(&part)?.map(|(text, root)| strings(&text, &root)).unwrap_or_default())
    }
}

fn is_signature(part: &str) -> bool {
    part.starts_with("_xmlsignatures/")
}

/// Refuses what no sheet is put into.
fn admitted(book: &Book, relations: &[Relation], kind: &str) -> Result<(), Refusal> {
    let root = &book.root;
    let strict = root.attributes.iter().any(|(_, value)| value.contains("purl.oclc.org"));
    if strict || root.attribute("conformance") == Some("strict") {
        return Err(refused(&BookStrict {}));
    }
    if !WORKBOOKS.iter().any(|one| one.eq_ignore_ascii_case(kind)) {
        return Err(refused(&BookOfOtherKind { kind: excerpt(kind, NAME_EXCERPT) }));
    }
    if root
        .child("calcPr")
        .and_then(|one| one.attribute("fullPrecision"))
        .is_some_and(|full| ["0", "false"].contains(&full))
    {
        return Err(refused(&PrecisionAsShown {}));
    }
    if let Some(protection) = root.child("workbookProtection") {
        if protection.says("lockStructure") {
            return Err(refused(&StructureLocked {}));
        }
        if protection.says("lockRevision") {
            return Err(refused(&RevisionsLocked {}));
        }
    }
    if relations.iter().any(|one| ["/revisionHeaders", "/usernames"].iter().any(|kind| one.kind.ends_with(kind))) {
        return Err(refused(&BookShared {}));
    }
    if root.child("customWorkbookViews").is_some() {
        return Err(refused(&CustomViews {}));
    }
    if book.sheets.len() >= limits::SHEETS {
        return Err(refused(&BookTooLarge {}));
    }
    Ok(())
}

/// Notes and cautions on what the workbook is.
fn told(book: &Book, relations: &[Relation]) -> Vec<Finding> {
    let root = &book.root;
    let mut told = Vec::new();
    if root.child("calcPr").and_then(|one| one.attribute("calcMode")) == Some("manual") {
        told.push(CalculationManual {}.at(Place::File));
    }
    if relations.iter().any(|one| one.kind.ends_with("/externalLink")) {
        told.push(LinksElsewhere {}.at(Place::File));
    }
    if root.child("fileSharing").is_some() {
        told.push(ReadOnlyWished {}.at(Place::File));
    }
    told
}

pub(super) fn refused(row: &dyn Raise) -> Refusal {
    row.refused(Exit::Refused, Place::File)
}

/// The refusal of what only a fault of `rodete` brings about.
pub(super) fn unfit(what: Text) -> Refusal {
    NotPutIn { what }.refused(Exit::Fault, Place::File)
}
