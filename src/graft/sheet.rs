//! A sheet on its way into another workbook: its formats become formats there, its shared texts its own.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use crate::workbook::address;
use crate::workbook::xml::raw;

use super::styles::Styles;
use super::tree::{Element, element, parse};

/// What stands in the first cell of a sheet: by this it is known again.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Title {
    /// Nothing, or what is no text.
    #[default]
    None,
    /// A text, as the cell shows it.
    Text(String),
    /// The result of a formula: it may change.
    Formula,
}

/// A sheet that was moved.
#[derive(Debug)]
pub struct Moved {
    /// The text of its part, for the other workbook.
    pub text: String,
    /// What stands in its first cell.
    pub title: Title,
    /// Its formulas, one a line, those of conditional formats and validations among them.
    pub formulas: String,
}

/// The part of a sheet for another workbook. `strings` are the contents of the shared texts as they are written in their part.
pub fn moved(text: &str, strings: &[String], styles: &mut Styles<'_>) -> Moved {
    let mut reader = Reader::from_str(text);
    let mut out = String::with_capacity(text.len() + text.len() / 4);
    let (mut title, mut formulas, mut formula) = (Title::None, String::new(), false);
    let mut within: Option<Cell> = None;
    loop {
        let from = position(&reader);
        let Ok(event) = reader.read_event() else { break };
        let place = text.get(from..position(&reader)).unwrap_or_default();
        match &event {
            Event::Eof => break,
            Event::Start(start) | Event::Empty(start) => {
                let closed = matches!(event, Event::Empty(_));
                let name = start.local_name();
                let name = name.as_ref();
                formula = !closed && matches!(name, "f" | "formula" | "formula1" | "formula2");
                if name == "c" {
                    let (tag, cell) = opened(start, styles, closed);
                    out.push_str(&tag);
                    within = (!closed).then_some(cell);
                    continue;
                }
                if let Some(cell) = &mut within {
                    cell.formula |= name == "f";
                    cell.value = !closed && matches!(name, "v" | "t");
                    if cell.shared && name == "v" {
                        continue;
                    }
                }
                match changed(start, name, styles) {
                    Some(element) => out.push_str(&element.tag(closed)),
                    None => out.push_str(place),
                }
            }
            Event::End(end) => {
                let name = end.local_name();
                let name = name.as_ref();
                if std::mem::take(&mut formula) {
                    formulas.push('\n');
                }
                if let Some(cell) = &mut within {
                    cell.value = false;
                    if cell.shared && name == "v" {
                        let content = cell.said.trim().parse::<usize>().ok().and_then(|index| strings.get(index));
                        let content = content.map_or("", String::as_str);
                        out.push_str(&format!("<is>{content}</is>"));
                        if cell.first {
                            cell.said = plain(content);
                        }
                        continue;
                    }
                    if name == "c"
                        && let Some(cell) = within.take().filter(|cell| cell.first)
                    {
                        title = cell.title();
                    }
                }
                out.push_str(place);
            }
            Event::Text(_) | Event::CData(_) | Event::GeneralRef(_) => {
                if formula {
                    formulas.push_str(&entity(place));
                }
                if let Some(cell) = within.as_mut().filter(|cell| cell.value) {
                    match &event {
                        Event::Text(text) => cell.said.push_str(text),
                        Event::CData(text) => cell.said.push_str(text),
                        _ => cell.said.push_str(&entity(place)),
                    }
                    if cell.shared {
                        continue;
                    }
                }
                out.push_str(place);
            }
            _ => out.push_str(place),
        }
    }
    Moved { text: out, title, formulas }
}

fn position(reader: &Reader<&[u8]>) -> usize {
    usize::try_from(reader.buffer_position()).unwrap_or_default()
}

/// A cell while its element is open.
#[derive(Debug, Default)]
struct Cell {
    /// It is A1.
    first: bool,
    /// Its value is the number of a shared text.
    shared: bool,
    /// It holds a text.
    texts: bool,
    formula: bool,
    /// The walk is inside the element of its value.
    value: bool,
    said: String,
}

impl Cell {
    fn title(self) -> Title {
        if self.formula {
            Title::Formula
        } else if (self.texts || self.shared) && !self.said.is_empty() {
            Title::Text(self.said)
        } else {
            Title::None
        }
    }
}

/// The tag of a cell with its format there, and what is to be known of it.
fn opened(start: &BytesStart<'_>, styles: &mut Styles<'_>, closed: bool) -> (String, Cell) {
    let mut tag = element(start);
    let number = tag.attribute("s").and_then(|number| number.parse().ok()).unwrap_or_default();
    // What these count is in a part that stays behind; a formula of many cells works without.
    tag.attributes.retain(|(name, _)| !matches!(name.as_str(), "cm" | "vm"));
    // A cell without a number would take the first format, which there may be any.
    tag.set("s", &styles.format(number).to_string());
    let kind = tag.attribute("t").unwrap_or_default().to_owned();
    let shared = kind == "s" && !closed;
    if shared {
        tag.set("t", "inlineStr");
    }
    let first = tag.attribute("r") == Some("A1");
    let texts = matches!(kind.as_str(), "inlineStr" | "str");
    (tag.tag(closed), Cell { first, shared, texts, ..Cell::default() })
}

/// An element that names formats, or belongs to the workbook that it comes from; `None` where it stays as it is.
fn changed(start: &BytesStart<'_>, name: &str, styles: &mut Styles<'_>) -> Option<Element> {
    let number = |tag: &Element, attribute: &str| tag.attribute(attribute).and_then(|number| number.parse().ok());
    let mut tag = element(start);
    match name {
        "row" => {
            let format = styles.format(number(&tag, "s")?);
            tag.set("s", &format.to_string());
        }
        "col" => {
            let format = styles.format(number(&tag, "style")?);
            tag.set("style", &format.to_string());
        }
        "cfRule" => {
            let format = styles.difference(number(&tag, "dxfId")?);
            tag.set("dxfId", &format.to_string());
        }
        // Two selected sheets would both take what is typed.
        "sheetView" => tag.attributes.retain(|(name, _)| name != "tabSelected"),
        // The name that macros know it by is given by the workbook with the macros.
        "sheetPr" => tag.attributes.retain(|(name, _)| name != "codeName"),
        _ => return None,
    }
    Some(tag)
}

fn entity(place: &str) -> String {
    quick_xml::escape::unescape(place).map_or_else(|_| String::new(), |said| said.into_owned())
}

/// The letters of a shared text, its formats and its readings left out.
pub fn plain(content: &str) -> String {
    let Ok((_, root)) = parse("", format!("<si>{content}</si>").into_bytes()) else { return String::new() };
    let own = root.children.iter().filter(|one| one.local() == "t").map(|one| one.text.as_str());
    let runs = root.children.iter().filter(|one| one.local() == "r").flat_map(|run| &run.children);
    own.chain(runs.filter(|one| one.local() == "t").map(|one| one.text.as_str())).collect()
}

/// The contents of each shared text as they are written in their part.
pub fn strings(text: &str, root: &Element) -> Vec<String> {
    let inner = |one: &Element| one.inner.clone().and_then(|place| text.get(place)).unwrap_or_default().to_owned();
    root.children.iter().filter(|one| one.local() == "si").map(inner).collect()
}

/// What stands in the cell of a workbook's sheet by which the sheet is known again.
pub fn title(text: &str, address: &str, strings: &[String]) -> Title {
    let bare = text.trim_start_matches('\u{feff}');
    let mut reader = Reader::from_str(bare);
    // The position that an element without an address of its own has, counted from 0.
    let (mut row, mut column, mut next) = (0, 0, 0);
    let mut found = None;
    loop {
        let from = position(&reader);
        let Ok(event) = reader.read_event() else { return Title::None };
        match &event {
            Event::Eof => return Title::None,
            Event::Start(start) | Event::Empty(start) => match start.local_name().as_ref() {
                "row" => {
                    row = raw(start, "r").and_then(|row| address::row(&row)).unwrap_or(next);
                    (next, column) = (row + 1, 0);
                }
                "c" => {
                    let at = raw(start, "r").and_then(|at| address::parse(&at)).unwrap_or((row, column));
                    column = at.1 + 1;
                    if address::format(at) == address {
                        if matches!(event, Event::Empty(_)) {
                            return Title::None;
                        }
                        found = Some(from);
                    }
                }
                _ => {}
            },
            Event::End(end) if end.local_name().as_ref() == "c" => {
                let cell = found.and_then(|from| bare.get(from..position(&reader)));
                if let Some(cell) = cell {
                    return title_of(cell, strings);
                }
            }
            _ => {}
        }
    }
}

/// The same of a cell's element.
fn title_of(text: &str, strings: &[String]) -> Title {
    let Ok((text, cell)) = parse("", text.as_bytes().to_vec()) else { return Title::None };
    if cell.child("f").is_some() {
        return Title::Formula;
    }
    let value = cell.child("v").map_or("", |one| one.text.as_str());
    let said = match cell.attribute("t") {
        Some("s") => value.trim().parse().ok().and_then(|at: usize| strings.get(at)).map(|one| plain(one)),
        Some("str") => Some(value.to_owned()),
        Some("inlineStr") => {
            cell.child("is").and_then(|one| one.inner.clone()).and_then(|place| text.get(place)).map(plain)
        }
        _ => None,
    };
    said.filter(|said| !said.is_empty()).map_or(Title::None, Title::Text)
}

/// A sheet with one line and nothing else.
pub fn emptied(line: &str, format: usize) -> String {
    let line = quick_xml::escape::escape(line);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<worksheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\">\
         <dimension ref=\"A1\"/><sheetData><row r=\"1\"><c r=\"A1\" s=\"{format}\" t=\"inlineStr\"><is><t>{line}</t></is></c></row></sheetData></worksheet>"
    )
}
