//! Saving a workbook, with what the library that writes it cannot do: long rows and drawn figures.
//!
//! The library's package is passed on part by part; parts that are to be changed are changed on the way.

use std::io::{Cursor, Read, Seek, Write};

use rust_xlsxwriter::Workbook;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::calculated::Book;
use super::drawn::{Drawn, sized};
use super::error::WriteError;
use super::long_rows::{LARGE, LongRows, Span, stream};
use super::page::Further;

/// Deflate level of every part: far quicker than the default for a tenth more bytes.
const LEVEL: u8 = 3;

/// What is added to a workbook when it is saved.
#[derive(Debug, Default)]
pub struct Additions<'a> {
    /// The rows of long sheets.
    pub long: Vec<LongRows<'a>>,
    /// The figure of the workbook, where a place is kept for one.
    pub drawn: Option<Drawn<'a>>,
    /// Formulas were written without results: these are worked out.
    pub uncomputed: bool,
    /// The sizes of the charts in pixels, in their order; all stand on one sheet.
    pub charts: Vec<[u32; 2]>,
    /// What is printed of sheets in several areas.
    pub printed: Vec<Further>,
    /// What is done to each chart.
    pub redrawn: Option<fn(&str) -> String>,
}

/// Saves the workbook to `out`, with its additions.
///
/// # Errors
/// For what the workbook or `out` refuses, and for a number that is not finite.
pub fn save<W: Write + Seek + Send>(
    workbook: &mut Workbook,
    additions: Additions<'_>,
    out: W,
) -> Result<(), WriteError> {
    let Additions { long, drawn, uncomputed, charts, printed, redrawn } = additions;
    workbook.set_zip_compression_level(LEVEL);
    let mut skeleton = ZipArchive::new(Cursor::new(workbook.save_to_buffer()?))?;
    let mut package = ZipWriter::new(out);
    let book = if uncomputed { Some(Book::of(&mut skeleton)?) } else { None };
    let spans: Vec<Span> = long.iter().map(Span::of).collect();
    let part_of = |sheet: usize| format!("xl/worksheets/sheet{}.xml", sheet + 1);
    let mut long: Vec<(String, LongRows<'_>)> = long.into_iter().map(|rows| (part_of(rows.sheet), rows)).collect();
    for index in 0..skeleton.len() {
        let mut part = skeleton.by_index(index)?;
        let name = part.name()?.into_owned();
        let rows = long.iter().position(|(one, _)| *one == name).map(|at| long.swap_remove(at).1);
        let chart = name.starts_with("xl/charts/") && (!spans.is_empty() || uncomputed || redrawn.is_some());
        let drawing = name.starts_with("xl/drawings/drawing");
        let number = name.strip_prefix("xl/worksheets/sheet").and_then(|one| one.strip_suffix(".xml")?.parse().ok());
        let sheet = book.as_ref().zip(number.and_then(|number: usize| number.checked_sub(1)));
        let list = name == "xl/workbook.xml" && !printed.is_empty();
        if rows.is_none() && !chart && !drawing && sheet.is_none() && !list {
            package.raw_copy_file(part)?;
            continue;
        }
        let mut xml = String::new();
        part.read_to_string(&mut xml)?;
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .compression_level(Some(i64::from(LEVEL)))
            .last_modified_time(zip::DateTime::default())
            .unix_permissions(0o600)
            .large_file(rows.as_ref().is_some_and(|rows| rows.count > LARGE));
        package.start_file(name, options)?;
        if let Some(rows) = rows {
            stream(&xml, rows, &mut package)?;
            continue;
        }
        if chart {
            xml = spans.iter().fold(xml, |xml, span| span.stretch(&xml));
            if let Some(book) = &book {
                xml = book.charted(&xml);
            }
            if let Some(redrawn) = redrawn {
                xml = redrawn(&xml);
            }
        }
        if let Some((book, sheet)) = sheet {
            xml = book.filled(sheet, &xml);
        }
        if list {
            xml = printed.iter().fold(xml, |xml, further| further.put_into(&xml));
        }
        if drawing {
            xml = with_sizes(&xml, drawn, &charts);
        }
        package.write_all(xml.as_bytes())?;
    }
    package.finish()?;
    Ok(())
}

/// A sheet's drawing with its objects in their own size, and the figure in the box that keeps its place.
fn with_sizes(drawing: &str, drawn: Option<Drawn<'_>>, charts: &[[u32; 2]]) -> String {
    let (chart, boxed) = (drawing.find("<xdr:graphicFrame"), drawing.find("<xdr:sp "));
    match (drawn, boxed) {
        (Some(drawn), Some(boxed)) => {
            let own = std::iter::once(drawn.size());
            let charts = charts.iter().copied().filter(|_| chart.is_some());
            let sizes: Vec<[u32; 2]> = if chart.is_some_and(|chart| chart < boxed) {
                charts.chain(own).collect()
            } else {
                own.chain(charts).collect()
            };
            drawn.put_into(&sized(drawing, &sizes))
        }
        _ => sized(drawing, charts),
    }
}
