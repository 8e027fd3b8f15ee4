//! The workbook part: its sheets and its defined names.
//!
//! # References
//! ECMA-376 part 1, 18.2 (workbook).

use std::collections::BTreeSet;

use quick_xml::escape::escape;

use super::parts::RELATIONSHIPS;
use super::tree::{Element, Splices};

/// The largest number of a sheet.
const LARGEST_ID: u32 = 65_534;

/// A sheet as the workbook part lists it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Its name, as the tab shows it.
    pub name: String,
    /// Its number, `sheetId`: 0 where it cannot be read.
    pub id: u32,
    /// Its state where it is not shown, as `hidden`.
    pub state: Option<String>,
    /// The id of its relationship.
    pub relation: String,
}

/// A defined name.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The name, in the capitals that it was given.
    pub name: String,
    /// The sheet that it is of, counted from 0; `None` for one of the workbook.
    pub sheet: Option<usize>,
    /// It is not shown.
    pub hidden: bool,
    /// What it stands for.
    pub formula: String,
}

impl Name {
    /// What tells it from others: capitals do not.
    pub fn key(&self) -> (String, Option<usize>) {
        (self.name.to_lowercase(), self.sheet)
    }
}

/// The workbook part, being changed.
#[derive(Debug)]
pub struct Book {
    text: String,
    /// The element that holds all others, as it was read.
    pub root: Element,
    /// Its sheets in order.
    pub sheets: Vec<Sheet>,
    /// Its defined names in order.
    pub names: Vec<Name>,
    splices: Splices,
}

impl Book {
    /// From the part's text and root.
    pub fn new((text, root): (String, Element)) -> Self {
        let sheets = root.listed("sheets").iter().map(|one| Sheet {
            name: one.attribute("name").unwrap_or_default().to_owned(),
            id: one.attribute("sheetId").and_then(|id| id.trim().parse().ok()).unwrap_or_default(),
            state: one.attribute("state").map(str::to_owned),
            relation: relation_id(one).to_owned(),
        });
        let names = root.listed("definedNames").iter().map(|one| Name {
            name: one.attribute("name").unwrap_or_default().to_owned(),
            sheet: one.attribute("localSheetId").and_then(|index| index.trim().parse().ok()),
            hidden: one.says("hidden"),
            formula: one.text.clone(),
        });
        let (sheets, names) = (sheets.collect(), names.collect());
        Self { text, root, sheets, names, splices: Splices::default() }
    }

    /// A name of the workbook, capitals aside.
    pub fn global(&self, name: &str) -> Option<&Name> {
        let wanted = (name.to_lowercase(), None);
        self.names.iter().find(|one| one.key() == wanted)
    }

    /// Lists further sheets at the end: name, state and relationship of each.
    pub fn add_sheets(&mut self, new: &[(String, Option<String>, String)]) {
        let Some(sheets) = self.root.child("sheets") else { return };
        let prefix = self.root.prefix();
        let declared = |element: &Element| {
            let bound = element.attributes.iter().find(|(_, value)| value == RELATIONSHIPS);
            bound.and_then(|(name, _)| name.strip_prefix("xmlns:")).map(str::to_owned)
        };
        let bound = declared(sheets).or_else(|| declared(&self.root));
        let (id, declaration) = match bound {
            Some(bound) => (format!("{bound}:id"), String::new()),
            None => ("r:id".to_owned(), format!(" xmlns:r=\"{RELATIONSHIPS}\"")),
        };
        let mut taken: BTreeSet<u32> = self.sheets.iter().map(|one| one.id).collect();
        let mut text = String::new();
        for (name, state, relation) in new {
            let above = taken.last().map_or(1, |most| most.saturating_add(1));
            let number = if above <= LARGEST_ID { above } else { (1..).find(|one| !taken.contains(one)).unwrap_or(1) };
            taken.insert(number);
            let state = state.as_ref().map_or_else(String::new, |state| format!(" state=\"{state}\""));
            let name = escape(name);
            text.push_str(&format!(
                "<{prefix}sheet{declaration} name=\"{name}\" sheetId=\"{number}\"{state} {id}=\"{relation}\"/>"
            ));
        }
        if text.is_empty() {
            return;
        }
        // The views of our sheets are views in a window: Excel repairs a workbook that has none.
        if self.root.child("bookViews").is_none() {
            let views = format!("<{prefix}bookViews><{prefix}workbookView/></{prefix}bookViews>");
            self.splices.insert(sheets.outer.start, views);
        }
        self.splices.append(sheets, &text);
    }

    /// Defines these names, and takes out those that `gone` points at. A name that is there keeps its place.
    pub fn define(&mut self, wanted: &[Name], gone: impl Fn(&Name) -> bool) {
        let prefix = self.root.prefix().to_owned();
        let written = |name: &Name| {
            let sheet = name.sheet.map_or_else(String::new, |sheet| format!(" localSheetId=\"{sheet}\""));
            let hidden = if name.hidden { " hidden=\"1\"" } else { "" };
            let (said, formula) = (escape(&name.name), escape(&name.formula));
            format!("<{prefix}definedName name=\"{said}\"{sheet}{hidden}>{formula}</{prefix}definedName>")
        };
        let mut left: Vec<&Name> = wanted.iter().collect();
        let places: Vec<_> = self.root.listed("definedNames").iter().map(|one| one.outer.clone()).collect();
        let mut kept = Vec::new();
        for (there, place) in self.names.iter().zip(places) {
            match left.iter().position(|one| one.key() == there.key()) {
                Some(at) => {
                    let name = left.remove(at);
                    if name != there {
                        self.splices.replace(place.clone(), written(name));
                    }
                    kept.push((there.key(), place));
                }
                None if gone(there) => self.splices.replace(place, ""),
                None => kept.push((there.key(), place)),
            }
        }
        left.sort_by_key(|one| one.key());
        let Some(list) = self.root.child("definedNames") else {
            let all: String = left.iter().map(|one| written(one)).collect();
            let before = ["externalReferences", "functionGroups", "sheets"];
            let behind = before.iter().find_map(|name| self.root.child(name)).map(|one| one.outer.end);
            if let (Some(behind), false) = (behind, all.is_empty()) {
                self.splices.insert(behind, format!("<{prefix}definedNames>{all}</{prefix}definedNames>"));
            }
            return;
        };
        // Among those that are there each stands before the first that is greater: spreadsheets list names in order.
        let mut last = String::new();
        for name in left {
            match kept.iter().find(|(key, _)| *key > name.key()) {
                Some((_, place)) => self.splices.insert(place.start, written(name)),
                None => last.push_str(&written(name)),
            }
        }
        if !last.is_empty() {
            self.splices.append(list, &last);
        }
    }

    /// The part with its changes.
    pub fn finish(self) -> Vec<u8> {
        self.splices.apply(&self.text).into_bytes()
    }
}

/// The id of the relationship that a sheet's element has, whatever prefix it is written with.
fn relation_id(sheet: &Element) -> &str {
    let id = sheet.attributes.iter().rev().find(|(name, _)| name.rsplit_once(':').is_some_and(|(_, one)| one == "id"));
    id.map_or("", |(_, value)| value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graft::tree::parse;

    fn book(text: &str) -> Book {
        Book::new(parse("p", text.as_bytes().to_vec()).expect("well formed"))
    }

    fn named(name: &str, sheet: Option<usize>, formula: &str) -> Name {
        Name { name: name.to_owned(), sheet, hidden: false, formula: formula.to_owned() }
    }

    #[test]
    fn sheets_and_names_are_put_where_they_belong_whatever_the_prefixes() {
        let text = "<x:workbook xmlns:x='m' xmlns:q='http://schemas.openxmlformats.org/officeDocument/2006/relationships'><!-- </x:sheets> \
                    --><x:sheets><x:sheet name='A' sheetId='65534' q:id='rId7'/></x:sheets><x:calcPr/></x:workbook>";
        let mut book = book(text);
        assert_eq!(book.sheets, [Sheet { name: "A".to_owned(), id: 65_534, state: None, relation: "rId7".to_owned() }]);
        book.add_sheets(&[("B & C".to_owned(), None, "rId9".to_owned())]);
        book.define(&[named("b", None, "'B & C'!$A$1"), named("a", Some(1), "1")], |_| false);
        let after = String::from_utf8(book.finish()).expect("UTF-8");
        let views = "<x:bookViews><x:workbookView/></x:bookViews><x:sheets>";
        let new = "<x:sheet name=\"B &amp; C\" sheetId=\"1\" q:id=\"rId9\"/></x:sheets><x:definedNames><x:definedName name=\"a\" \
                   localSheetId=\"1\">1</x:definedName><x:definedName name=\"b\">&apos;B &amp; C&apos;!$A$1</x:definedName></x:definedNames>";
        let expected =
            text.replace("</x:sheets><x:calcPr/>", &format!("{new}<x:calcPr/>")).replace("<x:sheets>", views);
        assert_eq!(after, expected);
    }

    #[test]
    fn names_keep_their_places_and_new_ones_stand_in_order() {
        let text = "<workbook><sheets/><definedNames><definedName name=\"a\">1</definedName><definedName name=\"Own\">2</definedName><definedName \
                    name=\"z\">3</definedName></definedNames></workbook>";
        let mut one = book(text);
        one.define(&[named("own", None, "5"), named("b", None, "6"), named("zz", None, "7")], |name| name.name == "a");
        let after = String::from_utf8(one.finish()).expect("UTF-8");
        let mut again = book(&after);
        let names: Vec<_> = again.names.iter().map(|one| (one.name.as_str(), one.formula.as_str())).collect();
        assert_eq!(names, [("b", "6"), ("own", "5"), ("z", "3"), ("zz", "7")]);
        again
            .define(&[named("own", None, "5"), named("b", None, "6"), named("zz", None, "7")], |name| name.name == "a");
        assert_eq!(again.finish(), after.into_bytes(), "what is there already is not written again");
    }
}
