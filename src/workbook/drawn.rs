//! A figure as shapes of a sheet: lines that a spreadsheet draws itself, sharp at any size and on paper.
//!
//! The library that writes our workbooks knows one shape only, a box of text. It puts a box where the figure belongs, and the
//! box is replaced by the figure's shapes when the workbook is saved.
//!
//! # References
//! ECMA-376 part 1, 20.1 (DrawingML, shapes) and 20.5 (DrawingML, spreadsheet drawing).

use std::fmt::Write as _;

use rust_xlsxwriter::{ColNum, ObjectMovement, RowNum, Shape, Worksheet, XlsxError};

use crate::figure::{Figure, Ink, Stroke};
use crate::text::Language;
use crate::typeset::mark::{escape, head};
use crate::typeset::pen::{face, pen};

/// English metric units in a millimetre.
const EMU: f64 = 36_000.0;
/// English metric units in a pixel.
const PIXEL: u32 = 9_525;
/// Pixels in a millimetre.
const PIXELS: f64 = 96.0 / 25.4;
/// The number of the figure in its drawing: charts beside it have the first ones.
const FIRST_ID: u32 = 100;
/// Around the figure, mm.
const MARGIN: f64 = 4.0;
/// Height of letters, points.
const SIZE: f64 = 9.0;
/// From the foot of letters to their middle, mm.
const MIDDLE: f64 = 1.1;
/// Height and, for each character, width of a word's box, mm.
const BOX: [f64; 2] = [4.2, 1.9];

/// A figure in millimetres of paper, on its way to a sheet.
#[derive(Clone, Copy, Debug)]
pub struct Drawn<'a> {
    /// The figure, in mm of paper.
    pub figure: &'a Figure,
    /// The language of its words.
    pub language: Language,
}

impl Drawn<'_> {
    /// Left, right, lower and upper edge with the margin, mm.
    fn edges(&self) -> [f64; 4] {
        let strokes = self.figure.strokes.iter().flat_map(|stroke| &stroke.points);
        let points = strokes.chain(self.figure.labels.iter().map(|label| &label.at));
        let [x0, x1, y0, y1] = points
            .fold([f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY], |[x0, x1, y0, y1], [x, y]| {
                [x0.min(*x), x1.max(*x), y0.min(*y), y1.max(*y)]
            });
        [x0 - MARGIN, x1 + MARGIN, y0 - MARGIN, y1 + MARGIN]
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        let [x0, x1, y0, y1] = self.edges();
        [x1 - x0, y1 - y0].map(|side| whole(side * PIXELS))
    }

    /// Keeps the place of the figure, its upper left corner in that of a cell.
    ///
    /// # Errors
    /// For a cell outside the sheet.
    pub fn place(&self, sheet: &mut Worksheet, row: RowNum, column: ColNum) -> Result<(), XlsxError> {
        let [width, height] = self.size();
        // Folding the rows beside it moves it and leaves its size.
        let shape = Shape::textbox()
            .set_width(width)
            .set_height(height)
            .set_object_movement(ObjectMovement::MoveButDontSizeWithCells);
        sheet.insert_shape(row, column, &shape)?;
        Ok(())
    }

    /// A sheet's drawing with the box that keeps the figure's place replaced by it; as it is where there is no box.
    #[must_use]
    pub fn put_into(&self, drawing: &str) -> String {
        let parted = drawing.split_once("<xdr:sp ").and_then(|(before, rest)| {
            let (_, after) = rest.split_once("</xdr:sp>")?;
            Some((before, after))
        });
        parted.map_or_else(|| drawing.to_owned(), |(before, after)| format!("{before}{}{after}", self.group()))
    }

    /// The shapes as one group.
    fn group(&self) -> String {
        let [x0, _, _, y1] = self.edges();
        let [width, height] = self.size().map(|side| side * PIXEL);
        let at = |[x, y]: [f64; 2]| [(x - x0) * EMU, (y1 - y) * EMU];
        let caption = escape(self.figure.caption.get(self.language));
        let mut shapes = Shapes { text: String::new(), count: FIRST_ID, language: self.language };
        for stroke in &self.figure.strokes {
            shapes.stroke(stroke, &stroke.points.iter().map(|point| at(*point)).collect::<Vec<_>>());
        }
        for label in &self.figure.labels {
            let [x, y] = label.at;
            shapes.word(at([x, y + MIDDLE]), label.text.get(self.language));
        }
        format!(
            "<xdr:grpSp><xdr:nvGrpSpPr><xdr:cNvPr id=\"{FIRST_ID}\" name=\"{caption}\" descr=\"{caption}\"/><xdr:cNvGrpSpPr/>\
             </xdr:nvGrpSpPr><xdr:grpSpPr><a:xfrm><a:off x=\"0\" y=\"0\"/><a:ext cx=\"{width}\" cy=\"{height}\"/><a:chOff x=\"0\" y=\"0\"/><a:chExt cx=\"{width}\" cy=\"{height}\"/>\
             </a:xfrm></xdr:grpSpPr>{}</xdr:grpSp>",
            shapes.text
        )
    }
}

/// A sheet's drawing with every object of the size given for it in pixels, in their order. Else it would reach from cell to cell,
/// and its shape would hang on the widths of columns, which a spreadsheet takes from the fonts that it has.
#[must_use]
pub fn sized(drawing: &str, sizes: &[[u32; 2]]) -> String {
    let mut text = String::with_capacity(drawing.len());
    let mut rest = drawing;
    for [width, height] in sizes {
        let [width, height] = [width * PIXEL, height * PIXEL];
        let Some((before, after)) = rest.split_once("<xdr:twoCellAnchor") else { break };
        let parted = after.split_once("</xdr:twoCellAnchor>").and_then(|(anchor, after)| {
            let (_, from) = anchor.split_once("<xdr:from>")?;
            let (from, to) = from.split_once("<xdr:to>")?;
            let (_, object) = to.split_once("</xdr:to>")?;
            Some((from, object, after))
        });
        let Some((from, object, after)) = parted else { break };
        text.push_str(before);
        text.push_str(&format!(
            "<xdr:oneCellAnchor><xdr:from>{from}<xdr:ext cx=\"{width}\" cy=\"{height}\"/>{object}</xdr:oneCellAnchor>"
        ));
        rest = after;
    }
    text.push_str(rest);
    text
}

/// Shapes of a group, in its own units.
struct Shapes {
    text: String,
    count: u32,
    language: Language,
}

impl Shapes {
    fn stroke(&mut self, stroke: &Stroke, points: &[[f64; 2]]) {
        let pen = pen(stroke.ink);
        if stroke.filled {
            let tint = if let Ink::Face(light) = stroke.ink { face(light) } else { pen.tint.to_owned() };
            self.path(points, true, &format!("{}<a:ln><a:noFill/></a:ln>", solid(&tint)));
            return;
        }
        let dash = match pen.dash.len() {
            0 => "solid",
            2 => "dash",
            _ => "lgDashDot",
        };
        let width = whole(pen.width * EMU);
        let look = format!(
            "<a:noFill/><a:ln w=\"{width}\" cap=\"rnd\">{}<a:prstDash val=\"{dash}\"/><a:round/></a:ln>",
            solid(pen.colour)
        );
        self.path(points, false, &look);
        if stroke.arrow
            && let Some(head) = head(points, EMU)
        {
            self.path(&head, true, &format!("{}<a:ln><a:noFill/></a:ln>", solid(pen.colour)));
        }
    }

    /// A path with its look: fill, then line.
    fn path(&mut self, points: &[[f64; 2]], closed: bool, look: &str) {
        let [x0, y0] = points.iter().fold([f64::INFINITY; 2], |[x0, y0], [x, y]| [x0.min(*x), y0.min(*y)]);
        let [x1, y1] = points.iter().fold([f64::NEG_INFINITY; 2], |[x1, y1], [x, y]| [x1.max(*x), y1.max(*y)]);
        let (width, height) = (whole(x1 - x0).max(1), whole(y1 - y0).max(1));
        let (x0, y0) = (f64::from(whole(x0)), f64::from(whole(y0)));
        self.open("Line", [x0, y0], [width, height]);
        let _ = write!(
            self.text,
            "<a:custGeom><a:avLst/><a:gdLst/><a:ahLst/><a:cxnLst/><a:rect l=\"0\" t=\"0\" r=\"r\" b=\"b\"/><a:pathLst>\
             <a:path w=\"{width}\" h=\"{height}\"{}>",
            if closed { "" } else { " fill=\"none\"" }
        );
        for (index, [x, y]) in points.iter().enumerate() {
            let step = if index == 0 { "moveTo" } else { "lnTo" };
            let _ = write!(self.text, "<a:{step}><a:pt x=\"{}\" y=\"{}\"/></a:{step}>", whole(x - x0), whole(y - y0));
        }
        if closed {
            self.text.push_str("<a:close/>");
        }
        let _ = write!(self.text, "</a:path></a:pathLst></a:custGeom>{look}</xdr:spPr></xdr:sp>");
    }

    /// A word about a point.
    fn word(&mut self, [x, y]: [f64; 2], text: &str) {
        let [height, each] = BOX;
        let lines: Vec<&str> = text.split('\n').collect();
        let longest = lines.iter().map(|line| line.chars().fold(0.0, |count, _| count + 1.0)).fold(1.0, f64::max);
        let rows = lines.iter().fold(0.0, |count, _| count + 1.0);
        let (width, height) = (longest * each * EMU, rows * height * EMU);
        self.open("Word", [x - width / 2.0, y - height / 2.0], [whole(width), whole(height)]);
        let (lang, size) = (self.language.code(), whole(SIZE * 100.0));
        self.text.push_str(
            "<a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom><a:noFill/><a:ln><a:noFill/></a:ln></xdr:spPr><xdr:txBody>\
             <a:bodyPr wrap=\"none\" lIns=\"0\" tIns=\"0\" rIns=\"0\" bIns=\"0\" anchor=\"ctr\"><a:noAutofit/></a:bodyPr><a:lstStyle/>",
        );
        for line in lines {
            let _ = write!(
                self.text,
                "<a:p><a:pPr algn=\"ctr\"/><a:r><a:rPr lang=\"{lang}\" sz=\"{size}\"><a:solidFill><a:srgbClr val=\"1D232B\"/>\
                 </a:solidFill><a:latin typeface=\"Calibri\"/></a:rPr><a:t>{}</a:t></a:r></a:p>",
                escape(line)
            );
        }
        self.text.push_str("</xdr:txBody></xdr:sp>");
    }

    /// Begins a shape with its place and size.
    fn open(&mut self, name: &str, at: [f64; 2], [width, height]: [u32; 2]) {
        self.count += 1;
        let [x, y] = at.map(|side| side.round() + 0.0);
        let _ = write!(
            self.text,
            "<xdr:sp macro=\"\" textlink=\"\"><xdr:nvSpPr><xdr:cNvPr id=\"{0}\" name=\"{name} {0}\"/><xdr:cNvSpPr/></xdr:nvSpPr>\
             <xdr:spPr><a:xfrm><a:off x=\"{x}\" y=\"{y}\"/><a:ext cx=\"{width}\" cy=\"{height}\"/></a:xfrm>",
            self.count
        );
    }
}

/// A fill of one colour, given as `#rrggbb`.
fn solid(colour: &str) -> String {
    format!("<a:solidFill><a:srgbClr val=\"{}\"/></a:solidFill>", colour.trim_start_matches('#').to_uppercase())
}

/// A size as a whole number; 0 for what is none.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast keeps within the type's range")]
fn whole(size: f64) -> u32 {
    size.round() as u32
}
