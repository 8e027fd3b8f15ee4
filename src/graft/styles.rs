//! The formats of cells: those of sheets that are put into a workbook become formats of that workbook.
//!
//! A record that the workbook has already is used again, so that building again does not let it grow.
//!
//! # References
//! ECMA-376 part 1, 18.8 (styles).

use std::collections::BTreeMap;

use crate::finding::{Exit, Place, Raise, Refusal};
use crate::limits::CELL_FORMATS;

use super::rules::TooManyCellFormats;
use super::tree::{Element, Splices};

/// The lists of a part of styles, in their order.
const ORDER: [&str; 8] = ["numFmts", "fonts", "fills", "borders", "cellStyleXfs", "cellXfs", "cellStyles", "dxfs"];
/// Number formats of one's own begin here.
const OWN: u32 = 164;

/// The codes of number formats that a spreadsheet knows by their numbers alone. A workbook may say something else under such a number.
const BUILT_IN: [(u32, &str); 9] = [
    (0, "General"),
    (1, "0"),
    (2, "0.00"),
    (3, "#,##0"),
    (4, "#,##0.00"),
    (9, "0%"),
    (10, "0.00%"),
    (11, "0.00E+00"),
    (49, "@"),
];

/// What the first records of a list are where a workbook has no such list: a spreadsheet takes them as these.
const fn neutral(list: &str) -> &[&str] {
    match list.as_bytes() {
        b"fonts" => &["<font><sz val=\"11\"/><name val=\"Calibri\"/></font>"],
        b"fills" => {
            &["<fill><patternFill patternType=\"none\"/></fill>", "<fill><patternFill patternType=\"gray125\"/></fill>"]
        }
        b"borders" => &["<border><left/><right/><top/><bottom/><diagonal/></border>"],
        b"cellStyleXfs" => &["<xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\"/>"],
        b"cellXfs" => &["<xf numFmtId=\"0\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\"/>"],
        _ => &[],
    }
}

/// The formats of the sheets that are put in.
#[derive(Debug)]
pub struct Donor {
    root: Element,
    /// The theme's colours, by the number that a record has for them.
    theme: Vec<String>,
}

impl Donor {
    /// From the parts of styles and theme.
    pub fn new(root: Element, theme: Option<&Element>) -> Self {
        let scheme = theme.and_then(|theme| theme.child("themeElements")).map(|all| all.listed("clrScheme"));
        let colour = |name: &str| {
            let entry = scheme?.iter().find(|one| one.local() == name)?.children.first()?;
            entry.attribute("lastClr").or_else(|| entry.attribute("val")).map(|rgb| format!("FF{}", rgb.to_uppercase()))
        };
        // Records count light before dark.
        let names = ["lt1", "dk1", "lt2", "dk2", "accent1", "accent2", "accent3", "accent4", "accent5", "accent6"];
        let theme = names.into_iter().map(|name| colour(name).unwrap_or_default()).collect();
        Self { root, theme }
    }

    fn record(&self, list: &str, index: usize) -> Option<Element> {
        let mut record = self.root.listed(list).get(index)?.clone();
        self.free(&mut record);
        Some(record)
    }

    /// Takes out what would follow the theme of another workbook.
    fn free(&self, record: &mut Element) {
        record.children.retain(|one| one.local() != "scheme");
        if record.attribute("tint").is_none()
            && let Some(rgb) = record.attribute("theme").and_then(|theme| self.theme.get(theme.parse::<usize>().ok()?))
            && !rgb.is_empty()
        {
            let rgb = rgb.clone();
            record.attributes.retain(|(name, _)| name != "theme");
            record.set("rgb", &rgb);
        }
        for child in &mut record.children {
            self.free(child);
        }
    }
}

/// One list of the workbook, as it grows.
#[derive(Debug, Default)]
struct List {
    /// The number of each record by what it says; of equal ones the first.
    known: BTreeMap<String, usize>,
    count: usize,
    added: Vec<Element>,
}

impl List {
    fn of(list: Option<&Element>, name: &str) -> Self {
        let mut grown = Self::default();
        let records = list.map_or(&[][..], |list| &list.children);
        for record in records {
            grown.known.entry(record.canonical()).or_insert(grown.count);
            grown.count += 1;
        }
        if records.is_empty() {
            for text in neutral(name) {
                if let Ok((_, record)) = super::tree::parse(name, text.as_bytes().to_vec()) {
                    grown.number(record);
                }
            }
        }
        grown
    }

    fn number(&mut self, record: Element) -> usize {
        let next = self.count;
        let said = record.canonical();
        if let Some(number) = self.known.get(&said) {
            return *number;
        }
        self.known.insert(said, next);
        self.count += 1;
        self.added.push(record);
        next
    }
}

/// The formats of a workbook, being added to.
#[derive(Debug)]
pub struct Styles<'d> {
    text: String,
    root: Element,
    donor: &'d Donor,
    lists: BTreeMap<&'static str, List>,
    /// The number formats of one's own by their codes.
    codes: BTreeMap<String, u32>,
    new_codes: Vec<(u32, String)>,
    formats: BTreeMap<usize, usize>,
    differences: BTreeMap<usize, usize>,
}

impl<'d> Styles<'d> {
    /// Those of a workbook's part, to which some of a donor's are added.
    pub fn new((text, root): (String, Element), donor: &'d Donor) -> Self {
        let lists = ORDER.into_iter().map(|name| (name, List::of(root.child(name), name))).collect();
        let mut codes = BTreeMap::new();
        for format in root.listed("numFmts") {
            let id = format.attribute("numFmtId").and_then(|id| id.parse().ok());
            if let (Some(id), Some(code)) = (id, format.attribute("formatCode")) {
                codes.entry(code.to_owned()).or_insert(id);
            }
        }
        let (formats, differences) = Default::default();
        Self { text, root, donor, lists, codes, new_codes: Vec::new(), formats, differences }
    }

    fn list(&mut self, name: &'static str) -> &mut List {
        self.lists.entry(name).or_default()
    }

    /// The number that a cell format of the donor has here.
    pub fn format(&mut self, number: usize) -> usize {
        if let Some(known) = self.formats.get(&number) {
            return *known;
        }
        let plain = || Element { name: "xf".to_owned(), ..Element::default() };
        let mut record = self.donor.record("cellXfs", number).unwrap_or_else(plain);
        for (list, attribute, applied) in
            [("fonts", "fontId", "applyFont"), ("fills", "fillId", "applyFill"), ("borders", "borderId", "applyBorder")]
        {
            let donors = record.attribute(attribute).and_then(|number| number.parse().ok()).unwrap_or_default();
            let here = self.donor.record(list, donors).map_or(0, |one| self.list(list).number(one));
            record.set(attribute, &here.to_string());
            record.set(applied, "1");
        }
        let id = record.attribute("numFmtId").and_then(|id| id.parse().ok()).unwrap_or_default();
        let id = self.number_format(id);
        record.set("numFmtId", &id.to_string());
        record.set("applyNumberFormat", "1");
        record.set("xfId", "0");
        for (child, applied) in [("alignment", "applyAlignment"), ("protection", "applyProtection")] {
            if record.child(child).is_some() {
                record.set(applied, "1");
            }
        }
        let here = self.list("cellXfs").number(record);
        self.formats.insert(number, here);
        here
    }

    /// The number that a conditional format of the donor has here.
    pub fn difference(&mut self, number: usize) -> usize {
        if let Some(known) = self.differences.get(&number) {
            return *known;
        }
        let Some(mut record) = self.donor.record("dxfs", number) else { return number };
        for child in record.children.iter_mut().filter(|one| one.local() == "numFmt") {
            let id = child.attribute("numFmtId").and_then(|id| id.parse().ok()).unwrap_or_default();
            let id = match child.attribute("formatCode") {
                Some(code) if id >= OWN => self.code(code),
                _ => id,
            };
            child.set("numFmtId", &id.to_string());
        }
        let here = self.list("dxfs").number(record);
        self.differences.insert(number, here);
        here
    }

    fn number_format(&mut self, id: u32) -> u32 {
        let donors = self.donor.root.listed("numFmts");
        let own = donors.iter().find(|one| one.attribute("numFmtId") == Some(&*id.to_string()));
        let taken = self.root.listed("numFmts").iter().any(|one| one.attribute("numFmtId") == Some(&*id.to_string()));
        let known = BUILT_IN.iter().find(|(known, _)| taken && *known == id).map(|(_, code)| *code);
        own.and_then(|one| one.attribute("formatCode")).or(known).map_or(id, |code| self.code(code))
    }

    fn code(&mut self, code: &str) -> u32 {
        if let Some(id) = self.codes.get(code) {
            return *id;
        }
        let taken = self
            .codes
            .values()
            .copied()
            .chain(self.root.listed("numFmts").iter().filter_map(|one| one.attribute("numFmtId")?.parse().ok()));
        let id = taken.max().map_or(OWN, |most| OWN.max(most.saturating_add(1)));
        self.codes.insert(code.to_owned(), id);
        self.new_codes.push((id, code.to_owned()));
        id
    }

    /// The part with what was added; `None` where nothing was.
    ///
    /// # Errors
    /// For more formats than a workbook may have.
    pub fn finish(mut self) -> Result<Option<Vec<u8>>, Refusal> {
        if self.list("cellXfs").count > CELL_FORMATS {
            return Err(TooManyCellFormats { most: CELL_FORMATS }.refused(Exit::Limit, Place::File));
        }
        let codes: Vec<Element> = self
            .new_codes
            .iter()
            .map(|(id, code)| {
                let mut record = Element { name: "numFmt".to_owned(), ..Element::default() };
                record.set("numFmtId", &id.to_string());
                record.set("formatCode", code);
                record
            })
            .collect();
        let numbered = self.list("numFmts");
        numbered.count += codes.len();
        numbered.added.extend(codes);
        let prefix = self.root.prefix().to_owned();
        let (mut splices, mut all) = (Splices::default(), String::new());
        for (at, name) in ORDER.into_iter().enumerate() {
            let Some(List { added, count, .. }) = self.lists.get(name) else { continue };
            if added.is_empty() {
                continue;
            }
            let records: String = added.iter().map(|one| one.written(&prefix)).collect();
            match self.root.child(name) {
                Some(list) => {
                    let mut tag =
                        Element { name: list.name.clone(), attributes: list.attributes.clone(), ..Element::default() };
                    if tag.attribute("count").is_some() {
                        tag.set("count", &count.to_string());
                    }
                    match &list.inner {
                        Some(inner) => {
                            splices.replace(list.outer.start..inner.start, tag.tag(false));
                            splices.insert(inner.end, records);
                        }
                        None => {
                            splices.replace(list.outer.clone(), format!("{}{records}</{}>", tag.tag(false), tag.name))
                        }
                    }
                }
                None => {
                    let text = format!("<{prefix}{name} count=\"{count}\">{records}</{prefix}{name}>");
                    let before = ORDER.get(..at).unwrap_or_default();
                    let behind = before.iter().rev().find_map(|name| self.root.child(name)).map(|one| one.outer.end);
                    match behind.or_else(|| self.root.inner.as_ref().map(|inner| inner.start)) {
                        Some(place) => splices.insert(place, text),
                        None => all.push_str(&text),
                    }
                }
            }
        }
        if !all.is_empty() {
            splices.append(&self.root, &all);
        }
        Ok((!splices.is_empty()).then(|| splices.apply(&self.text).into_bytes()))
    }
}
