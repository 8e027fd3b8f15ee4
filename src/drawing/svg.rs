//! A figure as SVG that prints at 1:1: width and height are in millimetres, and so is its unit.

use std::f64::consts::PI;
use std::fmt::Write as _;

use super::layer::layer;
use super::{Drawing, LETTERS, NotDrawn, bounds, number};
use crate::escape::printable;
use crate::figure::{Arc, Figure, Ink, Stroke};
use crate::text::{Language, Text};
use crate::typeset::mark::{arrow_head, escape, word};
use crate::typeset::pen::{face, pen};

/// Room around the drawing in mm, for the width of its lines.
const MARGIN: f64 = 2.0;

/// The drawing as an SVG file. Each stroke bears the name of its ink as its class.
///
/// # Errors
/// Where there is nothing to draw, or a coordinate is not finite.
pub fn svg(drawing: &Drawing<'_>) -> Result<Vec<u8>, NotDrawn> {
    let [[left, right], [bottom, top]] = bounds(drawing.figure, drawing.arcs, drawing.language)?;
    let at = |[x, y]: [f64; 2]| [x - left + MARGIN, top - y + MARGIN];
    let (width, height) = (number(right - left + 2.0 * MARGIN), number(top - bottom + 2.0 * MARGIN));
    let source = drawing.source;
    let text = |text: &str| escape(&printable(text));
    let mut file = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\">\n\
         <title>{} - {}</title>\n<desc>{} SHA-256 {}; rodete {}; mm 1:1</desc>\n",
        text(drawing.title.get(drawing.language)),
        text(drawing.part),
        text(&source.workbook),
        text(&source.sha256),
        text(source.version)
    );
    strokes(&mut file, drawing.figure, drawing.language, at, None);
    for arc in drawing.arcs {
        round(&mut file, arc, at, drawing.language);
    }
    labels(&mut file, drawing.figure, at, |words| printable(words.get(drawing.language)));
    file.push_str("</svg>\n");
    Ok(file.into_bytes())
}

/// Least and greatest x, then y, in mm of the figure.
pub(super) type Window = [[f64; 2]; 2];
/// What of a stroke is farther than this from a window is left out, mm.
const ROOM: f64 = 10.0;

/// Strokes, each point put where `at` says; of long strokes only the parts that come near a window.
pub(super) fn strokes(
    file: &mut String,
    figure: &Figure,
    language: Language,
    at: impl Fn([f64; 2]) -> [f64; 2],
    window: Option<Window>,
) {
    for stroke in &figure.strokes {
        if stroke.filled {
            fill(file, stroke, &at, language);
            continue;
        }
        let runs = match window {
            Some(window) => near(&stroke.points, window, ROOM),
            None => vec![(0.0, stroke.points.as_slice())],
        };
        for (before, points) in runs {
            let points: Vec<[f64; 2]> = points.iter().map(|&point| at(point)).collect();
            line(file, stroke.ink, &points, before, language);
        }
        if stroke.arrow {
            let points: Vec<[f64; 2]> = stroke.points.iter().map(|&point| at(point)).collect();
            arrow_head(file, stroke.ink, &points);
        }
    }
}

/// Labels, each put where `at` says, in the words of `shown`.
pub(super) fn labels(
    file: &mut String,
    figure: &Figure,
    at: impl Fn([f64; 2]) -> [f64; 2],
    mut shown: impl FnMut(&Text) -> String,
) {
    for label in &figure.labels {
        word(file, at(label.at), LETTERS, "middle", "#1d232b", &shown(&label.text));
    }
}

/// True where a segment of a polyline comes into a window, or near one of its corners.
pub(super) fn comes_near(points: &[[f64; 2]], window: Window) -> bool {
    !near(points, window, 0.0).is_empty()
}

/// The parts of a polyline whose segments come within so many mm of a window, with the length of the polyline before each.
fn near(points: &[[f64; 2]], window: Window, room: f64) -> Vec<(f64, &[[f64; 2]])> {
    let mut runs: Vec<(f64, &[[f64; 2]])> = Vec::new();
    let mut open: Option<(usize, f64)> = None;
    let mut length = 0.0;
    for (at, pair) in points.windows(2).enumerate() {
        let &[a, b] = pair else { continue };
        let close = (0..2).all(|axis| {
            let [least, greatest] = window[axis];
            a[axis].max(b[axis]) >= least - room && a[axis].min(b[axis]) <= greatest + room
        });
        match (close, open) {
            (true, None) => open = Some((at, length)),
            (false, Some((from, before))) => {
                runs.extend(points.get(from..=at).map(|run| (before, run)));
                open = None;
            }
            _ => {}
        }
        let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        length += (dx * dx + dy * dy).sqrt();
    }
    if let Some((from, before)) = open {
        runs.extend(points.get(from..).map(|run| (before, run)));
    }
    runs
}

/// The points as path data.
pub(super) fn path(points: &[[f64; 2]]) -> String {
    let mut data = String::with_capacity(points.len() * 16);
    for (at, &[x, y]) in points.iter().enumerate() {
        let _ = write!(data, "{}{} {}", if at == 0 { "M" } else { " " }, number(x), number(y));
    }
    data
}

fn class(ink: Ink, language: Language) -> String {
    layer(ink).name.get(language).to_lowercase()
}

/// A line whose dashes begin as if `before` mm of it came first.
fn line(file: &mut String, ink: Ink, points: &[[f64; 2]], before: f64, language: Language) {
    if points.len() < 2 {
        return;
    }
    let pen = pen(ink);
    let _ = write!(
        file,
        "<path class=\"{}\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" stroke-linecap=\"butt\"",
        class(ink, language),
        path(points),
        pen.colour,
        number(pen.width)
    );
    if !pen.dash.is_empty() {
        let period: f64 = pen.dash.iter().sum();
        let dashes: Vec<String> = pen.dash.iter().map(|&length| number(length)).collect();
        let _ = write!(
            file,
            " stroke-dasharray=\"{}\" stroke-dashoffset=\"{}\"",
            dashes.join(" "),
            number(before % period)
        );
    }
    file.push_str("/>\n");
}

/// An arc of a circle; y goes down, so that anticlockwise is the negative sense.
fn round(file: &mut String, arc: &Arc, at: impl Fn([f64; 2]) -> [f64; 2], language: Language) {
    let pen = pen(arc.ink);
    let [[x0, y0], [x1, y1]] = arc.ends.map(at).map(|end| end.map(number));
    let [first, last] = arc.angles();
    let _ = writeln!(
        file,
        "<path class=\"{}\" d=\"M{x0} {y0} A{r} {r} 0 {} 0 {x1} {y1}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>",
        class(arc.ink, language),
        u8::from(last - first > PI),
        pen.colour,
        number(pen.width),
        r = number(arc.radius),
    );
}

fn fill(file: &mut String, stroke: &Stroke, at: &impl Fn([f64; 2]) -> [f64; 2], language: Language) {
    let colour = match stroke.ink {
        Ink::Face(light) => face(light),
        other => pen(other).tint.to_owned(),
    };
    let points: Vec<[f64; 2]> = stroke.points.iter().map(|&point| at(point)).collect();
    let _ =
        writeln!(file, "<path class=\"{}\" d=\"{} Z\" fill=\"{colour}\"/>", class(stroke.ink, language), path(&points));
}

#[cfg(test)]
mod tests {
    use super::{ROOM, near};

    #[test]
    fn parts_near_a_window_keep_their_place_along_the_line() {
        let points = [[0.0, 0.0], [100.0, 0.0], [200.0, 0.0], [300.0, 0.0], [300.0, 300.0], [0.0, 300.0], [0.0, 50.0]];
        let runs = near(&points, [[0.0, 80.0], [0.0, 80.0]], ROOM);
        assert_eq!(runs, [(0.0, &points[..2]), (900.0, &points[5..])]);
        assert_eq!(near(&points, [[-500.0, -400.0], [0.0, 1.0]], ROOM), []);
        // A segment that only passes by is kept whole.
        assert_eq!(near(&points[..2], [[40.0, 50.0], [0.0, 1.0]], ROOM), [(0.0, &points[..2])]);
    }
}
