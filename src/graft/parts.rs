//! The parts of a package: their names, relationships and content types.
//!
//! # References
//! ECMA-376 part 2, 6 (names of parts), 6.5 (relationships), 7.2.3 (content types).

use std::collections::{BTreeMap, BTreeSet};

use crate::escape::excerpt;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::workbook::limits;
use crate::workbook::package::Package;
use crate::workbook::rules::package::NoSheets;

use super::tree::{Element, Splices, parse};

/// The types of relationships end so.
pub mod kind {
    /// The workbook part, from the package.
    pub const DOCUMENT: &str = "/officeDocument";
    /// A sheet of cells.
    pub const WORKSHEET: &str = "/worksheet";
    /// The formats of cells.
    pub const STYLES: &str = "/styles";
    /// The order of calculation.
    pub const CALC_CHAIN: &str = "/calcChain";
    /// Shared texts.
    pub const STRINGS: &str = "/sharedStrings";
    /// The theme: colours and fonts of the workbook.
    pub const THEME: &str = "/theme";
}

/// The namespace that types of relationships begin with.
pub const RELATIONSHIPS: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
/// The ending of a part of relationships, and its type: ECMA-376 part 2, annex E.
pub const RELS: [&str; 2] = ["rels", "application/vnd.openxmlformats-package.relationships+xml"];
/// The list of content types.
pub const CONTENT_TYPES: &str = "[Content_Types].xml";

/// A relationship of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct Relation {
    /// Its id, by which the part names it.
    pub id: String,
    /// Its type, an address whose ending says what it leads to.
    pub kind: String,
    /// What it leads to: the normal name of a part, or an address outside of the package.
    pub target: String,
    /// It leads out of the package.
    pub external: bool,
}

/// The part that the last relationship of a kind leads to.
pub fn one(relations: Vec<Relation>, kind: &str) -> Option<String> {
    relations.into_iter().rfind(|one| !one.external && one.kind.ends_with(kind)).map(|one| one.target)
}

/// A part's name as two names are compared: escapes resolved, capitals and the slash before it left out.
pub fn normal(name: &str) -> String {
    let bytes = name.trim_start_matches('/').replace('\\', "/").into_bytes();
    let (mut plain, mut at) = (Vec::with_capacity(bytes.len()), 0);
    while let Some(&byte) = bytes.get(at) {
        let escaped = (byte == b'%')
            .then(|| bytes.get(at + 1..at + 3).and_then(|digits| std::str::from_utf8(digits).ok()))
            .flatten()
            .filter(|digits| digits.bytes().all(|one| one.is_ascii_hexdigit()))
            .and_then(|digits| u8::from_str_radix(digits, 16).ok());
        plain.push(escaped.unwrap_or(byte));
        at += if escaped.is_some() { 3 } else { 1 };
    }
    String::from_utf8_lossy(&plain).to_lowercase()
}

/// The folder of a part, with its slash.
pub fn folder(part: &str) -> &str {
    part.rfind('/').and_then(|slash| part.get(..=slash)).unwrap_or_default()
}

/// The normal name of the part that a target in a folder names.
fn resolved(folder: &str, target: &str) -> String {
    let path = if target.starts_with('/') { target.to_owned() } else { format!("{folder}{target}") };
    let mut steps = Vec::new();
    for step in path.split('/') {
        match step {
            "" | "." => {}
            ".." => drop(steps.pop()),
            step => steps.push(step),
        }
    }
    normal(&steps.join("/"))
}

/// The part that holds a part's relationships.
pub fn relations_of(part: &str) -> String {
    let folder = folder(part);
    format!("{folder}_rels/{}.rels", part.get(folder.len()..).unwrap_or_default())
}

/// A package whose parts are found by their normal names.
#[derive(Debug)]
pub struct Parts<'a> {
    /// The package itself.
    pub package: Package<'a>,
    /// The names as they stand in it, by their normal names.
    names: BTreeMap<String, String>,
}

impl<'a> Parts<'a> {
    /// The parts of a package that passed the gate.
    pub fn new(package: Package<'a>) -> Self {
        let names = package.names().into_iter().map(|name| (normal(&name), name)).collect();
        Self { package, names }
    }

    /// A part's name as it stands in the package.
    pub fn name(&self, part: &str) -> Option<&str> {
        self.names.get(&normal(part)).map(String::as_str)
    }

    /// The normal names of all parts.
    pub fn all(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }

    /// A part's bytes.
    ///
    /// # Errors
    /// Where it does not unpack.
    pub fn bytes(&mut self, part: &str) -> Result<Option<Vec<u8>>, Refusal> {
        let Some(name) = self.name(part).map(|name| name.replace('\\', "/")) else { return Ok(None) };
        self.package.part(&name, limits::PART)
    }

    /// A part's text and root; `None` where there is no such part.
    ///
    /// # Errors
    /// Where it does not unpack or is not well formed.
    pub fn parsed(&mut self, part: &str) -> Result<Option<(String, Element)>, Refusal> {
        self.bytes(part)?.map(|bytes| parse(part, bytes)).transpose()
    }

    /// The same of a part that must be there.
    ///
    /// # Errors
    /// Where it is missing, and as [`Parts::parsed`].
    pub fn needed(&mut self, part: &str) -> Result<(String, Element), Refusal> {
        let missing = || NoSheets { part: excerpt(part, 80) }.refused(Exit::Unreadable, Place::File);
        self.parsed(part)?.ok_or_else(missing)
    }

    /// The relationships of a part; those of the package for an empty name.
    ///
    /// # Errors
    /// As [`Parts::parsed`].
    pub fn relations(&mut self, part: &str) -> Result<Vec<Relation>, Refusal> {
        let Some((_, root)) = self.parsed(&relations_of(part))? else { return Ok(Vec::new()) };
        let folder = folder(part);
        Ok(root.children.iter().map(|one| relation(folder, one)).collect())
    }

    /// The parts that are reached from the package, when what leads from `closed` parts on is left out.
    ///
    /// # Errors
    /// As [`Parts::parsed`].
    pub fn reached(&mut self, closed: &BTreeSet<String>) -> Result<BTreeSet<String>, Refusal> {
        let (mut reached, mut next) = (BTreeSet::new(), vec![String::new()]);
        while let Some(part) = next.pop() {
            if closed.contains(&part) {
                continue;
            }
            for relation in self.relations(&part)? {
                if !relation.external && reached.insert(relation.target.clone()) {
                    next.push(relation.target);
                }
            }
        }
        Ok(reached)
    }
}

/// A relationship as it stands in a part of a folder.
pub fn relation(folder: &str, element: &Element) -> Relation {
    let said = |name: &str| element.attribute(name).unwrap_or_default().to_owned();
    let external = element.attribute("TargetMode") == Some("External");
    let target = said("Target");
    let target = if external { target } else { resolved(folder, &target) };
    Relation { id: said("Id"), kind: said("Type"), target, external }
}

/// The content types of a package, being changed.
#[derive(Debug)]
pub struct ContentTypes {
    text: String,
    root: Element,
    splices: Splices,
}

impl ContentTypes {
    /// Those of a package.
    ///
    /// # Errors
    /// As [`Parts::needed`].
    pub fn of(parts: &mut Parts<'_>) -> Result<Self, Refusal> {
        let (text, root) = parts.needed(CONTENT_TYPES)?;
        Ok(Self { text, root, splices: Splices::default() })
    }

    /// The type of a part.
    pub fn of_part(&self, part: &str) -> Option<&str> {
        let part = normal(part);
        let own = self.root.children.iter().find(|one| {
            one.local() == "Override" && one.attribute("PartName").is_some_and(|name| normal(name) == part)
        });
        let usual = || self.usual(part.rsplit('.').next().unwrap_or_default());
        own.and_then(|one| one.attribute("ContentType")).or_else(usual)
    }

    /// The type of parts with such an ending, where they have none of their own.
    pub fn usual(&self, extension: &str) -> Option<&str> {
        let of_ending = |one: &&Element| {
            one.local() == "Default"
                && one.attribute("Extension").is_some_and(|one| one.eq_ignore_ascii_case(extension))
        };
        self.root.children.iter().find(of_ending).and_then(|one| one.attribute("ContentType"))
    }

    /// Takes parts out and puts others in, each with its type.
    pub fn change(&mut self, gone: &BTreeSet<String>, added: &[(String, String)]) {
        let wanted: BTreeMap<String, &str> = added.iter().map(|(part, kind)| (normal(part), kind.as_str())).collect();
        let mut there = BTreeSet::new();
        for one in self.root.children.iter().filter(|one| one.local() == "Override") {
            let part = normal(one.attribute("PartName").unwrap_or_default());
            match wanted.get(&part) {
                Some(kind) if one.attribute("ContentType") == Some(kind) => drop(there.insert(part)),
                Some(_) => self.splices.replace(one.outer.clone(), ""),
                None if gone.contains(&part) => self.splices.replace(one.outer.clone(), ""),
                None => {}
            }
        }
        let prefix = self.root.prefix().to_owned();
        let new: String = added
            .iter()
            .filter(|(part, _)| !there.contains(&normal(part)))
            .map(|(part, kind)| format!("<{prefix}Override PartName=\"/{part}\" ContentType=\"{kind}\"/>"))
            .collect();
        if !new.is_empty() {
            self.splices.append(&self.root, &new);
        }
    }

    /// The part with its changes.
    pub fn finish(self) -> Vec<u8> {
        self.splices.apply(&self.text).into_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::{normal, relations_of, resolved};

    #[test]
    fn names_are_compared_as_the_format_says() {
        for (name, plain) in [
            ("/xl/Styles.xml", "xl/styles.xml"),
            ("xl/st%20yles.xml", "xl/st yles.xml"),
            ("xl\\workbook.xml", "xl/workbook.xml"),
            ("xl/100%.xml", "xl/100%.xml"),
            ("xl/%C3%B1.xml", "xl/ñ.xml"),
        ] {
            assert_eq!(normal(name), plain);
        }
        assert_eq!(resolved("Book/", "../xl/./a/../st%20yles.xml"), "xl/st yles.xml");
        assert_eq!(resolved("Book/", "/xl/a.xml"), "xl/a.xml");
        assert_eq!(relations_of("xl/workbook.xml"), "xl/_rels/workbook.xml.rels");
        assert_eq!(relations_of(""), "_rels/.rels");
    }
}
