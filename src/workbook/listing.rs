//! Which sheets a workbook lists, and the parts of the package that hold them.
//!
//! Names and targets are resolved as calamine resolves them, so that both look at the same parts. A target may go through
//! folders with `./` and `../`, which calamine does not follow: it gets the same package with plain targets.

use std::collections::{BTreeMap, BTreeSet};

use quick_xml::escape::{escape, resolve_xml_entity};
use quick_xml::events::{BytesStart, Event};

use crate::escape::excerpt;
use crate::finding::{Exit, Place, Raise, Refusal};

use super::limits;
use super::package::Package;
use super::rules::package::*;
use super::shared_tables::structure;
use super::xml::{attribute, damaged, limit, raw};

/// What a sheet consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SheetKind {
    /// A sheet of cells.
    Cells,
    /// A sheet that is one chart or dialogue: it has no cells.
    Other,
}

/// A sheet as the workbook lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SheetEntry {
    /// The name on its tab.
    pub name: String,
    /// The package's part that holds its cells.
    pub part: String,
    /// What it consists of.
    pub kind: SheetKind,
    /// Not shown to the user.
    pub hidden: bool,
}

/// What a workbook lists.
#[derive(Debug)]
pub struct Listing {
    /// The folder of the workbook part, with its last `/`.
    pub folder: String,
    /// The sheets in their order.
    pub sheets: Vec<SheetEntry>,
    /// What the workbook's defined names stand for, by the names in lower case; those of one sheet alone are left out.
    pub names: BTreeMap<String, String>,
    /// The places, among the sheets, of those that have defined names of their own, as a copy of a sheet has; not those of Excel itself.
    pub own: BTreeSet<usize>,
    /// The parts of relationships with plain targets, by name, where a target has `./` or `../` in it; else empty.
    pub plain: Vec<(String, Vec<u8>)>,
}

/// The part that a target in a folder names, without `./` and `../`; `None` where it lies outside of the package.
fn resolved(folder: &str, target: &str) -> Option<String> {
    let path = target.strip_prefix('/').map_or_else(|| format!("{folder}{target}"), str::to_owned);
    if !path.split('/').any(|step| matches!(step, "." | "..")) {
        return Some(path);
    }
    let mut steps = Vec::new();
    for step in path.split('/') {
        match step {
            "." => {}
            ".." => drop(steps.pop()?),
            step => steps.push(step),
        }
    }
    Some(steps.join("/"))
}

/// A part of relationships: id, type and target of each.
fn relationships<'a>(relations: impl Iterator<Item = (&'a str, &'a str, &'a str)>) -> Vec<u8> {
    const SPACE: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
    let mut text = format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?><Relationships xmlns=\"{SPACE}\">");
    for (id, kind, target) in relations {
        text.push_str(&format!("<Relationship Id=\"{id}\" Type=\"{kind}\" Target=\"{target}\"/>"));
    }
    text.push_str("</Relationships>");
    text.into_bytes()
}

/// The folder of the workbook part, its name, and the target as it is written, from the package's own relationships.
fn root(package: &mut Package<'_>) -> Result<(String, String, String), Refusal> {
    let mut target = None;
    structure(package, "_rels/.rels", limits::ATTRIBUTE, |_, event| {
        if let Event::Start(start) = event
            && start.local_name().as_ref() == "Relationship"
            && raw(start, "Type").is_some_and(|kind| kind.ends_with("/relationships/officeDocument"))
        {
            target = attribute(start, "Target").or(target.take());
        }
        Ok(())
    })?;
    let target = target.ok_or_else(|| no_sheets("_rels/.rels"))?;
    let path = resolved("", &target).ok_or_else(|| no_sheets(&target))?;
    let (folder, name) = path.split_at(path.rfind('/').map_or(0, |slash| slash + 1));
    let folder = folder.to_owned();
    let name = if name.is_empty() { "workbook.xml" } else { name }.to_owned();
    if package.has(&format!("{folder}{name}")) {
        Ok((folder, name, target))
    } else {
        Err(no_sheets(&format!("{folder}{name}")))
    }
}

fn no_sheets(part: &str) -> Refusal {
    NoSheets { part: excerpt(part, 80) }.refused(Exit::Unreadable, Place::File)
}

/// A relationship of the workbook part: its target and its type.
struct Relation {
    id: String,
    target: String,
    kind: String,
}

fn relations(package: &mut Package<'_>, folder: &str, workbook: &str) -> Result<Vec<Relation>, Refusal> {
    let part = format!("{folder}_rels/{workbook}.rels");
    let mut relations = Vec::new();
    let found = structure(package, &part, limits::ATTRIBUTE, |_, event| {
        if let Event::Start(start) = event
            && start.local_name().as_ref() == "Relationship"
            && let Some(id) = raw(start, "Id")
        {
            if relations.len() >= 2 * limits::SHEETS {
                return Err(limit(&part, &TooManyRelations {}));
            }
            relations.push(Relation {
                id: id.into_owned(),
                target: raw(start, "Target").unwrap_or_default().into_owned(),
                kind: raw(start, "Type").unwrap_or_default().into_owned(),
            });
        }
        Ok(())
    })?;
    if found { Ok(relations) } else { Err(no_sheets(&part)) }
}

/// What the workbook lists.
///
/// # Errors
/// [`Exit::Unreadable`] where the list or a sheet's part is missing or damaged;
/// [`Exit::Limit`] for more sheets than [`limits::SHEETS`].
pub fn sheets(package: &mut Package<'_>) -> Result<Listing, Refusal> {
    let (folder, workbook, target) = root(package)?;
    let relations = relations(package, &folder, &workbook)?;
    let part = format!("{folder}{workbook}");
    let mut sheets = Vec::new();
    let (mut names, mut open, mut own) = (BTreeMap::new(), None, BTreeSet::new());
    structure(package, &part, limits::ATTRIBUTE, |_, event| {
        defined(event, &mut open, &mut names);
        let Event::Start(start) = event else { return Ok(()) };
        own.extend(of_sheet(start));
        if start.local_name().as_ref() != "sheet" {
            return Ok(());
        }
        let name = attribute(start, "name").unwrap_or_default();
        let sheet = excerpt(&name, 80);
        if sheets.len() >= limits::SHEETS {
            return Err(limit(&part, &TooManySheets {}));
        }
        let hidden = match raw(start, "state").as_deref() {
            None | Some("visible") => false,
            Some("hidden" | "veryHidden") => true,
            Some(_) => return Err(damaged(&part, &SheetStateUnknown { sheet })),
        };
        let id = start
            .attributes()
            .flatten()
            .filter(|one| one.key.local_name().as_ref() == "id")
            .last()
            .map(|one| one.value.into_owned())
            .unwrap_or_default();
        // The last relationship of an id counts.
        let relation = relations.iter().rev().find(|relation| relation.id == id);
        let Some(relation) = relation else {
            return Err(damaged(&part, &SheetWithoutPart { sheet }));
        };
        let kind = match relation.kind.rsplit('/').next() {
            Some("worksheet") => SheetKind::Cells,
            Some("chartsheet" | "dialogsheet") => SheetKind::Other,
            _ => return Err(damaged(&part, &SheetOfOtherKind { sheet })),
        };
        let path = resolved(&folder, &relation.target)
            .ok_or_else(|| damaged(&part, &SheetOutside { sheet, target: excerpt(&relation.target, 80) }))?;
        sheets.push(SheetEntry { name, part: path, kind, hidden });
        Ok(())
    })?;
    if sheets.is_empty() {
        return Err(no_sheets(&part));
    }
    if let Some(lost) = sheets.iter().find(|sheet| !package.has(&sheet.part)) {
        let (sheet, part) = (excerpt(&lost.name, 80), excerpt(&lost.part, 80));
        return Err(damaged(&lost.part, &SheetPartMissing { part, sheet }));
    }
    let dotted = |target: &str| target.split('/').any(|step| matches!(step, "." | ".."));
    let mut plain = Vec::new();
    if dotted(&target) || relations.iter().any(|relation| dotted(&relation.target)) {
        const DOCUMENT: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument";
        let root = escape(&part).into_owned();
        plain.push(("_rels/.rels".to_owned(), relationships([("rId1", DOCUMENT, root.as_str())].into_iter())));
        // What leads nowhere is no sheet's, and stays as it is.
        let absolute: Vec<String> = relations
            .iter()
            .map(|one| resolved(&folder, &one.target).map_or_else(|| one.target.clone(), |path| format!("/{path}")))
            .collect();
        let listed = relations.iter().zip(&absolute);
        plain.push((
            format!("{folder}_rels/{workbook}.rels"),
            relationships(listed.map(|(one, target)| (one.id.as_str(), one.kind.as_str(), target.as_str()))),
        ));
    }
    Ok(Listing { folder, sheets, names, own, plain })
}

/// The place of the sheet to which alone a defined name belongs.
fn of_sheet(start: &BytesStart<'_>) -> Option<usize> {
    let named = start.local_name().as_ref() == "definedName";
    let name = attribute(start, "name").filter(|name| named && !name.starts_with("_xlnm."));
    name.and_then(|_| raw(start, "localSheetId")?.parse().ok())
}

/// Follows a defined name of the workbook through its events; `open` is the one that is being read.
fn defined(event: &Event<'_>, open: &mut Option<(String, String)>, names: &mut BTreeMap<String, String>) {
    match event {
        Event::Start(start) if start.local_name().as_ref() == "definedName" => {
            let of_sheet = raw(start, "localSheetId").is_some();
            *open = attribute(start, "name").filter(|_| !of_sheet).map(|name| (name.to_lowercase(), String::new()));
        }
        Event::Text(text) => add(open, text),
        Event::CData(text) => add(open, text),
        Event::GeneralRef(reference) => {
            let character = reference.resolve_char_ref().ok().flatten().map(String::from);
            let said = character.or_else(|| resolve_xml_entity(reference).map(str::to_owned));
            add(open, &said.unwrap_or_default());
        }
        Event::End(end) if end.local_name().as_ref() == "definedName" && names.len() < limits::NAMES => {
            names.extend(open.take());
        }
        _ => {}
    }
}

fn add(open: &mut Option<(String, String)>, text: &str) {
    if let Some((_, formula)) = open
        && formula.len() + text.len() <= limits::ATTRIBUTE
    {
        formula.push_str(text);
    }
}

#[cfg(test)]
mod tests {
    use super::resolved;

    #[test]
    fn a_target_may_go_through_folders_and_not_out_of_the_package() {
        for (folder, target, part) in [
            ("xl/", "worksheets/sheet1.xml", Some("xl/worksheets/sheet1.xml")),
            ("xl/", "./worksheets/sheet1.xml", Some("xl/worksheets/sheet1.xml")),
            ("xl/", "../xl/worksheets/./sheet1.xml", Some("xl/worksheets/sheet1.xml")),
            ("xl/", "worksheets/../../sheet1.xml", Some("sheet1.xml")),
            ("xl/", "/xl/../xl/sheet1.xml", Some("xl/sheet1.xml")),
            ("", "./xl/workbook.xml", Some("xl/workbook.xml")),
            ("xl/", "..sheet1.xml", Some("xl/..sheet1.xml")),
            ("xl/", "../../sheet1.xml", None),
            ("", "../xl/workbook.xml", None),
            ("xl/", "/../sheet1.xml", None),
        ] {
            assert_eq!(resolved(folder, target).as_deref(), part, "{target} in {folder}");
        }
    }
}
