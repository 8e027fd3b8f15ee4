//! A figure as DXF for CAD and for cutting machines.
//!
//! Written is the text form of release 12 (`AC1009`), which every reader takes, the import filters of plasma and laser
//! machines among them: strokes as `POLYLINE` on a layer for each ink, arcs as `ARC`, labels as `TEXT`. Release 12 has no unit; the header
//! variable `$INSUNITS` of release 2000 is given all the same (4, millimetres): readers that know it use it, others skip
//! it. Letters are in code page 1252, the one that `$DWGCODEPAGE` names. Sources: Autodesk, *AutoCAD R12 Customization Manual*, chapter 11, and *DXF Reference*, header section.
//!
//! The writer is our own: the `dxf` crate stamps the clock and random identifiers into what it writes and brings image and
//! time-zone libraries with it, for the hundred lines that are needed here.

use std::fmt::Display;

use super::layer::{self, CENTRE, DASHED, FULL, Layer, layer};
use super::{Drawing, LETTERS, NotDrawn, bounds};
use crate::escape::printable;
use crate::figure::{Arc, Stroke};

/// Points of a stroke nearer to the last one are left out, in mm: half of what the file resolves. A polyline with a
/// segment of no length stops some cutting programs.
const FINEST: f64 = 0.000_05;

/// Name, description and dashes (mm; gaps negative) of the line types.
const LINES: [(&str, &str, &[f64]); 3] = [
    (FULL, "Solid line", &[]),
    (DASHED, "__ __ __", &[6.0, -1.5]),
    (CENTRE, "____ _ ____ _", &[12.0, -2.0, 2.0, -2.0]),
];

/// The drawing as a DXF file, in mm, with lines that end in CR LF.
///
/// # Errors
/// Where there is nothing to draw, or a coordinate is not finite.
pub fn dxf(drawing: &Drawing<'_>) -> Result<Vec<u8>, NotDrawn> {
    let [[left, right], [bottom, top]] = bounds(drawing.figure, drawing.arcs, drawing.language)?;
    let mut file = Groups(Vec::new());
    let source = drawing.source;
    file.text(999, &format!("{} - {}", drawing.title.get(drawing.language), drawing.part));
    file.text(999, &format!("{} SHA-256 {}", source.workbook, source.sha256));
    file.text(999, &format!("rodete {} - mm 1:1", source.version));
    file.section("HEADER");
    file.text(9, "$ACADVER");
    file.text(1, "AC1009");
    file.text(9, "$DWGCODEPAGE");
    file.text(3, "ANSI_1252");
    file.text(9, "$INSUNITS");
    file.put(70, 4);
    file.text(9, "$MEASUREMENT");
    file.put(70, 1);
    for (name, [x, y]) in [("$EXTMIN", [left, bottom]), ("$EXTMAX", [right, top])] {
        file.text(9, name);
        file.point([x, y]);
    }
    file.text(0, "ENDSEC");
    tables(&mut file, drawing);
    file.section("ENTITIES");
    for stroke in &drawing.figure.strokes {
        polyline(&mut file, stroke, &layer(stroke.ink), drawing);
    }
    for arc in drawing.arcs {
        file.arc(layer(arc.ink).name.get(drawing.language), arc);
    }
    for label in &drawing.figure.labels {
        words(&mut file, label.at, label.text.get(drawing.language), drawing);
    }
    file.text(0, "ENDSEC");
    file.text(0, "EOF");
    Ok(file.0)
}

/// Line types, the layers in use, and the text style.
fn tables(file: &mut Groups, drawing: &Drawing<'_>) {
    file.section("TABLES");
    file.table("LTYPE", LINES.len());
    for (name, description, dashes) in LINES {
        file.text(0, "LTYPE");
        file.text(2, name);
        file.put(70, 0);
        file.text(3, description);
        file.put(72, 65);
        file.put(73, dashes.len());
        file.length(40, dashes.iter().map(|dash| dash.abs()).sum());
        for &dash in dashes {
            file.length(49, dash);
        }
    }
    file.text(0, "ENDTAB");
    let mut layers: Vec<Layer> = Vec::new();
    let arcs = drawing.arcs.iter().map(|arc| layer(arc.ink));
    let used = drawing.figure.strokes.iter().map(|stroke| layer(stroke.ink)).chain(arcs);
    for one in used.chain((!drawing.figure.labels.is_empty()).then_some(layer::WORDS)) {
        if !layers.iter().any(|other| other.name == one.name) {
            layers.push(one);
        }
    }
    file.table("LAYER", layers.len() + 1);
    // Layer 0 is part of every drawing.
    file.layer("0", 7, FULL);
    for layer in &layers {
        file.layer(layer.name.get(drawing.language), layer.colour, layer.line);
    }
    file.text(0, "ENDTAB");
    file.table("STYLE", 1);
    file.text(0, "STYLE");
    file.text(2, "STANDARD");
    file.put(70, 0);
    file.length(40, 0.0);
    file.length(41, 1.0);
    file.length(50, 0.0);
    file.put(71, 0);
    file.length(42, LETTERS);
    file.text(3, "txt");
    file.text(4, "");
    file.text(0, "ENDTAB");
    file.text(0, "ENDSEC");
}

/// A stroke; closed where its ends meet or it bounds a filled shape. An arrow head is a stroke of its own.
fn polyline(file: &mut Groups, stroke: &Stroke, layer: &Layer, drawing: &Drawing<'_>) {
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(stroke.points.len());
    for &point in &stroke.points {
        if points.last().is_none_or(|&last| distance(last, point) > FINEST) {
            points.push(point);
        }
    }
    let meets = points.len() > 3
        && points.first().zip(points.last()).is_some_and(|(&first, &last)| distance(first, last) <= FINEST);
    if meets {
        points.pop();
    }
    let [first, .., last] = points.as_slice() else { return };
    let closed = meets || (stroke.filled && points.len() > 2 && first != last);
    let name = layer.name.get(drawing.language);
    file.polyline(name, &points, closed);
    if let (true, [.., from, to]) = (stroke.arrow, points.as_slice()) {
        let length = distance(*from, *to);
        let back = |side: f64| {
            let [dx, dy] = [(to[0] - from[0]) / length * 2.2, (to[1] - from[1]) / length * 2.2];
            [to[0] - dx - side * 0.32 * dy, to[1] - dy + side * 0.32 * dx]
        };
        file.polyline(name, &[back(1.0), *to, back(-1.0)], false);
    }
}

fn distance([a, b]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    ((x - a) * (x - a) + (y - b) * (y - b)).sqrt()
}

/// A label, centred on its point and standing on it.
fn words(file: &mut Groups, at: [f64; 2], text: &str, drawing: &Drawing<'_>) {
    file.text(0, "TEXT");
    file.text(8, layer::WORDS.name.get(drawing.language));
    file.point(at);
    file.length(40, LETTERS * 0.7);
    file.text(1, text);
    file.put(72, 1);
    file.put(11, Fixed(at[0]));
    file.put(21, Fixed(at[1]));
    file.length(31, 0.0);
}

/// A length in mm to 0.0001 mm, with its point.
struct Fixed(f64);

impl Display for Fixed {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = super::number(self.0);
        if text.contains('.') { formatter.write_str(&text) } else { write!(formatter, "{text}.0") }
    }
}

/// Group codes with their values.
struct Groups(Vec<u8>);

impl Groups {
    fn put(&mut self, code: u16, value: impl Display) {
        self.0.extend(format!("{code:>3}\r\n{value}\r\n").into_bytes());
    }

    fn length(&mut self, code: u16, value: f64) {
        self.put(code, Fixed(value));
    }

    /// A text: characters beyond code page 1252 as `\U+2033`, and what AutoCAD would take for a sign of its own (`%%`,
    /// `^`) parted, so that it is shown.
    fn text(&mut self, code: u16, value: &str) {
        let mut text: Vec<u8> = Vec::with_capacity(value.len());
        for one in printable(value).chars() {
            match (one, u8::try_from(one)) {
                ('^', _) => text.extend(b"^ "),
                ('%', _) if text.ends_with(b"%") => text.extend(b" %"),
                // Here the code page is Latin-1.
                (' '..='~' | '\u{a0}'..='\u{ff}', Ok(byte)) => text.push(byte),
                _ => text.extend(format!("\\U+{:04X}", u32::from(one)).into_bytes()),
            }
        }
        self.0.extend(format!("{code:>3}\r\n").into_bytes());
        self.0.extend(text);
        self.0.extend(b"\r\n");
    }

    fn point(&mut self, [x, y]: [f64; 2]) {
        self.length(10, x);
        self.length(20, y);
        self.length(30, 0.0);
    }

    fn section(&mut self, name: &str) {
        self.text(0, "SECTION");
        self.text(2, name);
    }

    fn table(&mut self, name: &str, entries: usize) {
        self.text(0, "TABLE");
        self.text(2, name);
        self.put(70, entries);
    }

    fn layer(&mut self, name: &str, colour: u8, line: &str) {
        self.text(0, "LAYER");
        self.text(2, name);
        self.put(70, 0);
        self.put(62, colour);
        self.text(6, line);
    }

    /// An arc, anticlockwise from its first angle to its second; degrees, to 1e-8 so that its ends are where they belong.
    fn arc(&mut self, layer: &str, arc: &Arc) {
        self.text(0, "ARC");
        self.text(8, layer);
        self.point(arc.centre);
        self.length(40, arc.radius);
        for (code, angle) in [50, 51].into_iter().zip(arc.angles()) {
            let degrees = angle.to_degrees().rem_euclid(360.0);
            self.put(code, format!("{degrees:.8}"));
        }
    }

    fn polyline(&mut self, layer: &str, points: &[[f64; 2]], closed: bool) {
        self.text(0, "POLYLINE");
        self.text(8, layer);
        self.put(66, 1);
        self.point([0.0, 0.0]);
        self.put(70, u8::from(closed));
        for &point in points {
            self.text(0, "VERTEX");
            self.text(8, layer);
            self.point(point);
        }
        self.text(0, "SEQEND");
        self.text(8, layer);
    }
}

#[cfg(test)]
mod tests {
    use super::Groups;

    #[test]
    fn texts_are_in_code_page_1252_and_hold_no_code_of_autocad() {
        let mut file = Groups(Vec::new());
        file.text(1, "ñ ″ 90 % 100%%d ^J\u{1b}");
        assert_eq!(file.0, b"  1\r\n\xF1 \\U+2033 90 % 100% %d ^ J\\u{1b}\r\n");
    }
}
