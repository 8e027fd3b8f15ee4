//! Workbooks as packages: their parts, and the same with other values in some cells.

use std::collections::BTreeMap;
use std::io::{Cursor, Read, Write};

use zip::write::SimpleFileOptions;

/// The parts of a package by name.
pub struct Parts(pub BTreeMap<String, Vec<u8>>);

impl Parts {
    pub fn of(bytes: &[u8]) -> Self {
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        let count = archive.len();
        let part = |index| {
            let mut entry = archive.by_index(index).unwrap();
            let mut content = Vec::new();
            entry.read_to_end(&mut content).unwrap();
            (entry.name().unwrap().into_owned(), content)
        };
        Self((0..count).map(part).collect())
    }

    pub fn zip(&self) -> Vec<u8> {
        let mut writer = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for (name, content) in &self.0 {
            writer.start_file(name.as_str(), SimpleFileOptions::default()).unwrap();
            writer.write_all(content).unwrap();
        }
        writer.finish().unwrap().into_inner()
    }

    fn text(&self, part: &str) -> String {
        String::from_utf8(self.0[part].clone()).unwrap()
    }

    /// The names that are defined for cells, with sheet and address as they are written.
    pub fn names(&self) -> BTreeMap<String, String> {
        let book = self.text("xl/workbook.xml");
        let defined = book.split("<definedName name=\"").skip(1);
        let one = |rest: &str| {
            let (name, rest) = rest.split_once("\">")?;
            let (place, _) = rest.split_once('<')?;
            Some((name.to_owned(), place.replace(['$', '\''], "")))
        };
        defined.filter_map(one).filter(|(_, place)| place.contains('!') && !place.contains(':')).collect()
    }

    /// The same with a value in a cell, which is told by its defined name or as `SHEET!A1`; an empty value clears it.
    pub fn put(mut self, cell: &str, value: &str) -> Self {
        let place = if cell.contains('!') { cell.to_owned() } else { self.names()[cell].clone() };
        let (sheet, address) = place.split_once('!').unwrap();
        let book = self.text("xl/workbook.xml");
        let mut sheets = book.split("<sheet name=\"").skip(1).map(|rest| rest.split('"').next().unwrap());
        let number = sheets.position(|name| name == sheet).unwrap() + 1;
        let part = format!("xl/worksheets/sheet{number}.xml");
        let text = self.text(&part);
        let start = text.find(&format!("<c r=\"{address}\"")).unwrap_or_else(|| panic!("{place}"));
        let rest = &text[start..];
        let tag = &rest[..rest.find('>').unwrap()];
        let end = if tag.ends_with('/') { tag.len() + 1 } else { rest.find("</c>").unwrap() + 4 };
        let style = tag.split_whitespace().find(|word| word.starts_with("s=")).unwrap_or_default();
        let style = style.trim_end_matches('/');
        let cell = match value {
            "" => format!("<c r=\"{address}\" {style}/>"),
            _ if value.parse::<f64>().is_ok() => format!("<c r=\"{address}\" {style}><v>{value}</v></c>"),
            _ => format!("<c r=\"{address}\" {style} t=\"inlineStr\"><is><t>{value}</t></is></c>"),
        };
        let text = format!("{}{cell}{}", &text[..start], &rest[end..]);
        self.0.insert(part, text.into_bytes());
        self
    }

    /// The same with values in cells.
    pub fn with(self, edits: &[(&str, &str)]) -> Self {
        edits.iter().fold(self, |parts, (cell, value)| parts.put(cell, value))
    }
}
