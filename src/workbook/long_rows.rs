//! Long sheets in little memory: rows streamed into a finished workbook.
//!
//! The library that writes our workbooks keeps every cell in memory, or else in a temporary file whose faults end the
//! process. So it writes a long sheet with its headings and one row of empty, formatted cells; that row is replaced by
//! the real ones on the way from the finished package to the output. Nothing is kept but one block of text. Charts refer
//! to that one row, too (else the library would keep a text for each cell they refer to), and are stretched to all rows.

use std::fmt;
use std::io::Write;

use quick_xml::Reader;
use quick_xml::events::Event;
use rust_xlsxwriter::{RowNum, column_number_to_name, quote_sheet_name};

use super::error::WriteError;

/// Text is handed on in blocks of about this many bytes.
const BLOCK: usize = 64 * 1024;

/// A sheet with more rows than this may need the 64-bit form of a zip entry.
pub(super) const LARGE: RowNum = 500_000;

/// Writes the rows of a sheet.
pub type RowWriter<'a> = Box<dyn FnOnce(&mut Rows<'_>) -> Result<(), WriteError> + 'a>;

/// The rows of one sheet.
pub struct LongRows<'a> {
    /// The sheet, counted from 0.
    pub sheet: usize,
    /// The name on its tab.
    pub name: String,
    /// The row, from 0, that holds formatted empty cells: the first to be written.
    pub first: RowNum,
    /// How many rows there will be; at least one.
    pub count: RowNum,
    /// Writes them.
    pub source: RowWriter<'a>,
}

impl fmt::Debug for LongRows<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LongRows").field("sheet", &self.sheet).field("first", &self.first).finish_non_exhaustive()
    }
}

/// What stands before and after the row's number in the tag of a column's cell.
#[derive(Debug)]
struct Tag {
    before: String,
    after: String,
}

/// Takes rows of cells from top to bottom.
pub struct Rows<'w> {
    out: &'w mut dyn Write,
    text: Vec<u8>,
    tags: Vec<Tag>,
    row: RowNum,
    digits: String,
    number: zmij::Buffer,
}

impl fmt::Debug for Rows<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Rows").field("row", &self.row).finish_non_exhaustive()
    }
}

impl Rows<'_> {
    /// Starts a row below the last one.
    ///
    /// # Errors
    /// Those of the output.
    pub fn start(&mut self) -> Result<(), WriteError> {
        self.end()?;
        self.row += 1;
        self.digits = self.row.to_string();
        self.text.extend_from_slice(b"<row r=\"");
        self.text.extend_from_slice(self.digits.as_bytes());
        self.text.extend_from_slice(b"\">");
        Ok(())
    }

    /// A number in a column from 0, stored so that it reads back bit for bit. Columns come from left to right.
    ///
    /// # Errors
    /// For a number that is not finite, and for a column without a formatted cell.
    pub fn number(&mut self, column: usize, value: f64) -> Result<(), WriteError> {
        if !value.is_finite() {
            return Err(WriteError::NotFinite { place: format!("column {}, row {}", column + 1, self.digits) });
        }
        self.open(column)?;
        self.text.extend_from_slice(b"><v>");
        self.text.extend_from_slice(self.number.format_finite(value).as_bytes());
        self.text.extend_from_slice(b"</v></c>");
        Ok(())
    }

    /// A text in a column from 0, never a formula. Columns come from left to right.
    ///
    /// # Errors
    /// For a column without a formatted cell.
    pub fn text(&mut self, column: usize, text: &str) -> Result<(), WriteError> {
        self.open(column)?;
        self.text.extend_from_slice(b" t=\"inlineStr\"><is><t xml:space=\"preserve\">");
        escape(text, &mut self.text);
        self.text.extend_from_slice(b"</t></is></c>");
        Ok(())
    }

    fn open(&mut self, column: usize) -> Result<(), WriteError> {
        let tag = self.tags.get(column).ok_or(WriteError::Skeleton("a column without a formatted cell"))?;
        self.text.extend_from_slice(tag.before.as_bytes());
        self.text.extend_from_slice(self.digits.as_bytes());
        self.text.extend_from_slice(tag.after.as_bytes());
        Ok(())
    }

    /// Ends the row that is open, and hands the text on when there is enough of it.
    fn end(&mut self) -> Result<(), WriteError> {
        if !self.digits.is_empty() {
            self.text.extend_from_slice(b"</row>");
            self.digits.clear();
        }
        if self.text.len() >= BLOCK {
            self.flush()?;
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), WriteError> {
        self.out.write_all(&self.text)?;
        self.text.clear();
        Ok(())
    }
}

/// The rows of a long sheet, as charts have to refer to them.
pub(super) struct Span {
    /// What a reference to a column of the sheet starts with, up to the column.
    start: String,
    /// How a reference to the sheet's first row ends, from the column on.
    first: String,
    /// The last row, from 1.
    last: RowNum,
}

impl Span {
    pub(super) fn of(rows: &LongRows<'_>) -> Self {
        let mut sheet = Vec::new();
        escape(&quote_sheet_name(&rows.name), &mut sheet);
        Self {
            start: format!("<c:f>{}!$", String::from_utf8_lossy(&sheet)),
            first: format!("${}</c:f>", rows.first + 1),
            last: rows.first + rows.count,
        }
    }

    /// A chart with its references to the first row made to go down to the last, and without the values stored for
    /// them.
    pub(super) fn stretch(&self, chart: &str) -> String {
        let mut stretched = String::with_capacity(chart.len());
        let mut rest = chart;
        while let Some((before, after)) = rest.split_once(self.start.as_str()) {
            stretched.push_str(before);
            stretched.push_str(&self.start);
            rest = after;
            if let Some((column, after)) = after.split_once(self.first.as_str())
                && column.bytes().all(|byte| byte.is_ascii_uppercase())
            {
                let first = self.first.trim_end_matches("</c:f>");
                stretched.push_str(&format!("{column}{first}:${column}${}</c:f>", self.last));
                rest = match after.strip_prefix("<c:numCache>").and_then(|cache| cache.split_once("</c:numCache>")) {
                    Some((_, after)) => after,
                    None => after,
                };
            }
        }
        stretched.push_str(rest);
        stretched
    }
}

/// Writes a sheet's text with its row of formatted empty cells replaced.
pub(super) fn stream(sheet: &str, rows: LongRows<'_>, out: &mut dyn Write) -> Result<(), WriteError> {
    const LOST: WriteError = WriteError::Skeleton("a long sheet without its row of formatted cells");
    let start = sheet.rfind(&format!("<row r=\"{}\"", rows.first + 1)).ok_or(LOST)?;
    let (head, rest) = sheet.split_at_checked(start).ok_or(LOST)?;
    let end = rest.find("</row>").ok_or(LOST)? + "</row>".len();
    let (probe, tail) = rest.split_at_checked(end).ok_or(LOST)?;
    let tags = tags(probe)?;
    let last = rows.first + rows.count;
    let corner = column_number_to_name(u16::try_from(tags.len().saturating_sub(1)).map_err(|_| LOST)?);
    let (before, after) = dimension(head).ok_or(LOST)?;
    write!(out, "{before}<dimension ref=\"A1:{corner}{last}\"/>{after}")?;
    let mut sink = Rows {
        out,
        text: Vec::with_capacity(2 * BLOCK),
        tags,
        row: rows.first,
        digits: String::new(),
        number: zmij::Buffer::new(),
    };
    (rows.source)(&mut sink)?;
    sink.end()?;
    sink.flush()?;
    if sink.row != last {
        return Err(WriteError::Skeleton("another number of rows than was said"));
    }
    out.write_all(tail.as_bytes())?;
    Ok(())
}

/// The text before and after the `dimension` element, whose range does not know of the rows to come.
fn dimension(head: &str) -> Option<(&str, &str)> {
    let (before, rest) = head.split_once("<dimension ")?;
    let (_, after) = rest.split_once("/>")?;
    Some((before, after))
}

/// The tags of the cells of a row, by column: empty ones between them keep their place.
fn tags(row: &str) -> Result<Vec<Tag>, WriteError> {
    const ODD: WriteError = WriteError::Skeleton("a cell that cannot be read");
    let mut reader = Reader::from_str(row);
    let mut tags: Vec<Tag> = Vec::new();
    loop {
        match reader.read_event().map_err(|_| ODD)? {
            Event::Eof => return Ok(tags),
            Event::Empty(cell) | Event::Start(cell) if cell.name().as_ref() == "c" => {
                let text = |name: &str| -> Result<String, WriteError> {
                    let attribute = cell.try_get_attribute(name).map_err(|_| ODD)?;
                    Ok(attribute.map_or_else(String::new, |one| one.value.into_owned()))
                };
                let column: String = text("r")?.chars().filter(char::is_ascii_alphabetic).collect();
                let style = text("s")?;
                // Columns between two formatted ones have the plain style.
                while let Ok(next) = u16::try_from(tags.len())
                    && column_number_to_name(next) != column
                {
                    tags.push(Tag::new(&column_number_to_name(next), ""));
                }
                tags.push(Tag::new(&column, &style));
            }
            _ => {}
        }
    }
}

impl Tag {
    fn new(column: &str, style: &str) -> Self {
        let after = if style.is_empty() { "\"".to_owned() } else { format!("\" s=\"{style}\"") };
        Self { before: format!("<c r=\"{column}"), after }
    }
}

/// Adds a text to XML. Control characters, and texts that look like one escaped, are written as `_x001B_`, the
/// workbook format's own way.
fn escape(text: &str, xml: &mut Vec<u8>) {
    let plain = |byte: u8| byte >= 0x20 && !matches!(byte, b'&' | b'<' | b'>' | b'_') && byte < 0x7F;
    if text.bytes().all(plain) {
        xml.extend_from_slice(text.as_bytes());
        return;
    }
    for (at, one) in text.char_indices() {
        match one {
            '&' => xml.extend_from_slice(b"&amp;"),
            '<' => xml.extend_from_slice(b"&lt;"),
            '>' => xml.extend_from_slice(b"&gt;"),
            '_' if text.get(at + 1..).is_some_and(looks_escaped) => xml.extend_from_slice(b"_x005F_"),
            '\t' | '\n' => xml.extend_from_slice(one.encode_utf8(&mut [0; 4]).as_bytes()),
            '\0'..='\x1F' | '\u{FFFE}' | '\u{FFFF}' => {
                xml.extend_from_slice(format!("_x{:04X}_", u32::from(one)).as_bytes());
            }
            _ => xml.extend_from_slice(one.encode_utf8(&mut [0; 4]).as_bytes()),
        }
    }
}

/// True for `x001B_…`, what follows an underscore in an escaped character.
fn looks_escaped(rest: &str) -> bool {
    match rest.as_bytes() {
        [b'x', digits @ ..] if digits.len() >= 5 => {
            digits.iter().take(4).all(u8::is_ascii_hexdigit) && digits.get(4) == Some(&b'_')
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn text_is_escaped_as_the_workbook_format_does() {
        for (text, xml) in [
            ("G1 X1.000", "G1 X1.000"),
            ("a<b & c>d", "a&lt;b &amp; c&gt;d"),
            ("\u{1B}[0m", "_x001B_[0m"),
            ("_x001B_", "_x005F_x001B_"),
            ("_x001", "_x001"),
            ("_álabe_\t", "_álabe_\t"),
            ("\0\u{FFFF}", "_x0000__xFFFF_"),
        ] {
            let mut out = Vec::new();
            escape(text, &mut out);
            assert_eq!(String::from_utf8_lossy(&out), xml);
        }
    }
}
