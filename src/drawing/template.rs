//! A figure as a PDF to be printed at 1:1, tiled over sheets of paper, cut out and wrapped round the part.
//!
//! Each page has its [tile](super::tiles) of the drawing, registration marks, a ruler of 100 mm to check the print with,
//! a map of the sheets, and what the drawing belongs to.

use serde::Serialize;

use super::sheet::{self, GAP, MAP, RULER};
use super::tiles::{FOOT, MARGIN, Tiling};
use super::{Drawing, NotDrawn, bounds};
use crate::figure::Paper;
use crate::finding::Finding;
use crate::text::Text;
use crate::typeset;
use crate::typeset::characters::Words;
use crate::typeset::compiler::Typst;
use crate::typeset::failure::ReportFailure;
use crate::typeset::pen::pen;

/// The typst template.
const TEMPLATE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/report-templates/template.typ"));

/// What it imports.
const SHORTENED: (&str, &str) =
    ("shortened.typ", include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/report-templates/shortened.typ")));

/// Why there is no PDF.
#[derive(Debug)]
pub enum NotPrinted {
    /// The figure cannot be drawn on sheets.
    Drawing(NotDrawn),
    /// Typst did not do its work.
    Typst(ReportFailure),
}

impl NotPrinted {
    /// The reason as a finding on the drawing with a title.
    #[must_use]
    pub fn finding(&self, title: &Text) -> Finding {
        match self {
            Self::Drawing(why) => why.finding(title),
            Self::Typst(failure) => failure
                .finding_on(&Text::new(format!("la plantilla «{}»", title.es), format!("the template '{}'", title.en))),
        }
    }
}

/// What the typst template sets.
#[derive(Serialize)]
struct Contents {
    language: &'static str,
    title: String,
    part: String,
    workbook: String,
    sha256: String,
    version: &'static str,
    page: [f64; 2],
    window: [f64; 2],
    margin: f64,
    foot: f64,
    gap: f64,
    ruler: f64,
    map: f64,
    columns: u32,
    rows: u32,
    legend: Vec<Key>,
    sheets: Vec<Sheet>,
}

/// An ink and its meaning.
#[derive(Serialize)]
struct Key {
    colour: &'static str,
    width: f64,
    dash: &'static [f64],
    text: String,
}

/// A sheet, its row and column from 1.
#[derive(Serialize)]
struct Sheet {
    file: String,
    row: u32,
    column: u32,
}

/// The drawing as a PDF whose pages are sheets of paper at 1:1.
///
/// # Errors
/// Where there is nothing to draw, a coordinate is not finite, it takes more than [`PRINTED_SHEETS`](crate::limits::PRINTED_SHEETS) sheets, or typst
/// does not do its work.
pub fn pdf(drawing: &Drawing<'_>, paper: Paper, typst: &Typst) -> Result<Vec<u8>, NotPrinted> {
    let bounds = bounds(drawing.figure, drawing.arcs, drawing.language).map_err(NotPrinted::Drawing)?;
    let tiling = Tiling::over(bounds, paper).map_err(NotPrinted::Drawing)?;
    let mut words = Words::new(drawing.language);
    let templates = [("template.typ", TEMPLATE), SHORTENED];
    let mut files = templates.map(|(name, text)| (name.to_owned(), text.as_bytes().to_vec())).to_vec();
    let mut sheets = Vec::new();
    let printed = sheet::printed(drawing.figure, &tiling);
    for (number, &place) in (1..).zip(&printed) {
        let file = format!("sheet-{number}.svg");
        files.push((file.clone(), sheet::page(drawing, &tiling, &printed, place, &mut words).into_bytes()));
        sheets.push(Sheet { file, row: place[0] + 1, column: place[1] + 1 });
    }
    let contents = Contents {
        language: drawing.language.code(),
        title: words.text(drawing.title),
        part: words.line(drawing.part),
        workbook: words.line(&drawing.source.workbook),
        sha256: drawing.source.sha256.clone(),
        version: drawing.source.version,
        page: tiling.page,
        window: tiling.window,
        margin: MARGIN,
        foot: FOOT,
        gap: GAP,
        ruler: RULER,
        map: MAP[0],
        columns: tiling.columns,
        rows: tiling.rows,
        legend: drawing
            .figure
            .legend
            .iter()
            .map(|(ink, text)| {
                let pen = pen(*ink);
                Key { colour: pen.colour, width: pen.width, dash: pen.dash, text: words.text(text) }
            })
            .collect(),
        sheets,
    };
    let json = serde_json::to_vec(&contents).map_err(|error| NotPrinted::Typst(error.into()))?;
    files.push(("contents.json".to_owned(), json));
    typeset::document(&files, typst).map_err(NotPrinted::Typst)
}
