//! The workbook whose sheets are put into another.

use std::collections::BTreeMap;

use crate::finding::Refusal;
use crate::text::t;
use crate::workbook::names::{Made, Role};
use crate::workbook::package::Package;

use super::book::Book;
use super::host::unfit;
use super::parts::{ContentTypes, Parts, Relation, kind, one};
use super::sheet::strings;
use super::styles;

/// A workbook that `rodete` wrote, and which of its sheets go into another.
#[derive(Clone, Debug)]
pub struct Donor<'a> {
    /// The bytes of its `.xlsx` file.
    pub bytes: &'a [u8],
    /// Its sheets in order.
    pub sheets: &'a [Made],
    /// The names of the inputs with the cells that they have in the other workbook, as `'DATA'!$C$7`.
    pub inputs: Vec<(&'static str, String)>,
    /// The SHA-256 of the other workbook as it was read, of which programs and report tell.
    pub source: &'a str,
}

impl Donor<'_> {
    /// True where it has results: then its form stays out.
    pub(super) fn has_results(&self) -> bool {
        self.sheets.iter().any(|one| matches!(one.role, Role::Result(_)))
    }
}

/// The donor's parts.
#[derive(Debug)]
pub struct Opened<'a> {
    /// The package, with its parts by their normal names.
    pub parts: Parts<'a>,
    /// The workbook part.
    pub book: Book,
    /// The part of each sheet, in order.
    pub sheets: Vec<String>,
    /// What type each of its parts has.
    pub types: ContentTypes,
    /// Its shared texts.
    pub strings: Vec<String>,
}

/// Opens a donor: its parts, and its formats.
///
/// # Errors
/// Where it is not as `rodete` writes one.
pub fn open(bytes: &[u8]) -> Result<(Opened<'_>, styles::Donor), Refusal> {
    let mut parts = Parts::new(Package::open(bytes)?);
    let types = ContentTypes::of(&mut parts)?;
    let root = one(parts.relations("")?, kind::DOCUMENT)
        .ok_or_else(|| unfit(t("ninguna parte de libro", "no workbook part")))?;
    let book = Book::new(parts.needed(&root)?);
    let relations = parts.relations(&root)?;
    let by_id: BTreeMap<&str, &Relation> = relations.iter().map(|one| (one.id.as_str(), one)).collect();
    let sheets: Option<Vec<String>> =
        book.sheets.iter().map(|one| by_id.get(one.relation.as_str()).map(|one| one.target.clone())).collect();
    let sheets = sheets.ok_or_else(|| unfit(t("una hoja sin parte", "a sheet without a part")))?;
    let strings = match one(relations.clone(), kind::STRINGS) {
        Some(part) => parts.parsed(&part)?.map(|(text, root)| strings(&text, &root)).unwrap_or_default(),
        None => Vec::new(),
    };
    let theme = match one(relations.clone(), kind::THEME) {
        Some(part) => parts.parsed(&part)?.map(|(_, root)| root),
        None => None,
    };
    let formats = one(relations, kind::STYLES).ok_or_else(|| unfit(t("ningún formato", "no formats")))?;
    let formats = styles::Donor::new(parts.needed(&formats)?.1, theme.as_ref());
    Ok((Opened { parts, book, sheets, types, strings }, formats))
}
