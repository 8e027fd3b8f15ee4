//! What the formulas of a workbook come to, worked out when it is saved: a spreadsheet that computes nothing, as Excel's protected view
//! or a mail program's preview, shows what is stored with them.

use std::cell::RefCell;
use std::collections::HashMap;
use std::io::{Read, Seek};

use quick_xml::escape::{escape, unescape};
use zip::ZipArchive;

use super::address::{self, Position};
use super::cell::UNCOMPUTED;
use super::error::WriteError;
use super::formula::{self, Found, Value};

/// The sheet of a cell, from 0, and where it stands there.
pub(super) type Place = (usize, Position);

/// What a cell begins with in its sheet's part.
const CELL: &str = "<c r=\"";

/// What a cell holds.
enum CellContent {
    Value(Value),
    Formula(String),
}

/// The cells and the names of a workbook as the library that writes it leaves it.
pub(super) struct Book {
    /// The sheets' names, and how many rows each has.
    sheets: Vec<(String, u32)>,
    names: HashMap<String, Place>,
    cells: HashMap<Place, CellContent>,
    found: RefCell<HashMap<Place, Found>>,
}

impl Book {
    /// Reads the package of a workbook whose sheets stand in their order.
    ///
    /// # Errors
    /// For a part that cannot be unpacked.
    pub(super) fn of<R: Read + Seek>(package: &mut ZipArchive<R>) -> Result<Self, WriteError> {
        let mut part = |name: &str| -> Result<String, WriteError> {
            let mut xml = String::new();
            package.by_name(name)?.read_to_string(&mut xml)?;
            Ok(xml)
        };
        let listed = part("xl/workbook.xml")?;
        let strings = part("xl/sharedStrings.xml")?;
        let pieces =
            |text: &str| text.split("<t").skip(1).filter_map(|one| inside(one, ">", "</t>")).collect::<String>();
        let strings: Vec<String> = strings.split("<si>").skip(1).map(pieces).collect();
        let sheets = listed.split("<sheet name=\"").skip(1).filter_map(|one| one.split_once('"'));
        let sheets = sheets.map(|(name, _)| (plain(name), 0)).collect();
        let mut book = Self { sheets, names: HashMap::new(), cells: HashMap::new(), found: RefCell::default() };
        for one in listed.split("<definedName name=\"").skip(1) {
            let place = inside(one, ">", "</definedName>").and_then(|formula| address::cell(&formula));
            let place = place.and_then(|(sheet, cell)| Some((book.sheet(&sheet)?, address::parse(&cell)?)));
            book.names.extend(one.split_once('"').zip(place).map(|((name, _), place)| (name.to_owned(), place)));
        }
        for at in 0..book.sheets.len() {
            let xml = part(&format!("xl/worksheets/sheet{}.xml", at + 1))?;
            for (position, cell) in xml.split(CELL).skip(1).filter_map(read) {
                if let Some((_, rows)) = book.sheets.get_mut(at) {
                    *rows = (*rows).max(position.0 + 1);
                }
                book.cells.extend(content(cell, &strings).map(|content| ((at, position), content)));
            }
        }
        Ok(book)
    }

    /// The number of a sheet.
    pub(super) fn sheet(&self, name: &str) -> Option<usize> {
        self.sheets.iter().position(|(one, _)| one == name)
    }

    /// How many rows of a sheet hold something.
    pub(super) fn rows(&self, sheet: usize) -> u32 {
        self.sheets.get(sheet).map_or(1, |(_, rows)| *rows)
    }

    /// The cell of a name.
    pub(super) fn name(&self, name: &str) -> Option<Place> {
        self.names.get(name).copied()
    }

    /// What a cell shows.
    pub(super) fn cell(&self, place: Place) -> Found {
        let formula = match self.cells.get(&place) {
            None => return Ok(Value::Blank),
            Some(CellContent::Value(value)) => return Ok(value.clone()),
            Some(CellContent::Formula(formula)) => formula,
        };
        if let Some(found) = self.found.borrow().get(&place) {
            return found.clone();
        }
        // Of one that asks for itself.
        self.found.borrow_mut().insert(place, Err("#REF!"));
        let found = match formula::value(formula, place.0, self) {
            Ok(Value::Blank) => Ok(Value::Number(0.0)),
            found => found,
        };
        self.found.borrow_mut().insert(place, found.clone());
        found
    }

    /// The part of a sheet with what its formulas come to; without, where that is not known.
    pub(super) fn filled(&self, sheet: usize, xml: &str) -> String {
        let marked = format!("<v>{UNCOMPUTED}</v>");
        let mut cells = xml.split(CELL);
        let mut filled = cells.next().unwrap_or_default().to_owned();
        for cell in cells {
            filled.push_str(CELL);
            let parts = cell.split_once(" t=\"str\"><f>").and_then(|(before, rest)| {
                let (formula, after) = rest.split_once(&marked)?;
                Some((read(cell)?.0, before, formula, after))
            });
            let Some((position, before, formula, after)) = parts else {
                filled.push_str(cell);
                continue;
            };
            let (kind, result) = match self.cell((sheet, position)) {
                Ok(Value::Number(number)) => ("", format!("<v>{number}</v>")),
                Ok(Value::Text(text)) => (" t=\"str\"", format!("<v>{}</v>", escape(text))),
                Ok(Value::Truth(truth)) => (" t=\"b\"", format!("<v>{}</v>", u8::from(truth))),
                Err(error) if error != formula::UNKNOWN => (" t=\"e\"", format!("<v>{error}</v>")),
                _ => ("", String::new()),
            };
            filled.extend([before, kind, "><f>", formula, &result, after]);
        }
        filled
    }

    /// The part of a chart with the numbers of its series.
    pub(super) fn charted(&self, xml: &str) -> String {
        let mut ranges = xml.split("<c:f>");
        let mut filled = ranges.next().unwrap_or_default().to_owned();
        for series in ranges {
            filled.push_str("<c:f>");
            let count = series.find("<c:ptCount ").and_then(|at| Some(at + series.get(at..)?.find('>')? + 1));
            let (before, after) = series.split_at_checked(count.unwrap_or_default()).unwrap_or_default();
            filled.push_str(before);
            let range = series.split_once("</c:f>").map_or("", |(range, _)| range);
            if let Ok(Value::Many(points)) = formula::value(&plain(range), 0, self) {
                for (at, point) in (0..).zip(points).filter(|_| count.is_some()) {
                    if let Ok(Value::Number(number)) = point {
                        filled.push_str(&format!("<c:pt idx=\"{at}\"><c:v>{number}</c:v></c:pt>"));
                    }
                }
            }
            filled.push_str(after);
        }
        filled
    }
}

/// The position of a cell, and what follows it, from what stands behind [`CELL`].
fn read(cell: &str) -> Option<(Position, &str)> {
    let (address, rest) = cell.split_once('"')?;
    Some((address::parse(address)?, rest.split_once("</c>").map_or(rest, |(cell, _)| cell)))
}

/// What a cell holds; `None` of an empty one.
fn content(cell: &str, strings: &[String]) -> Option<CellContent> {
    let (kind, content) = cell.split_once('>')?;
    if let Some(formula) = inside(content, "<f>", "</f>") {
        return Some(CellContent::Formula(formula));
    }
    let value = inside(content, "<v>", "</v>")?;
    Some(CellContent::Value(if kind.contains("t=\"s\"") {
        Value::Text(strings.get(value.parse::<usize>().ok()?)?.clone())
    } else {
        Value::Number(value.parse().ok()?)
    }))
}

/// The text between two marks.
fn inside(text: &str, from: &str, to: &str) -> Option<String> {
    Some(plain(text.split_once(from)?.1.split_once(to)?.0))
}

fn plain(text: &str) -> String {
    unescape(text).map_or_else(|_| text.to_owned(), std::borrow::Cow::into_owned)
}
