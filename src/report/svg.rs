//! A figure as SVG: scaled to the page, with ticks for graphs.
//!
//! The unit of the drawing is the millimetre of paper. Captions and legends are set by the templates, with the same
//! inks: [`pen`](crate::typeset::pen::pen).

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::ticks::ticks;
use crate::figure::{self, Axes, Figure, Ink};
use crate::text::Language;
use crate::typeset::mark::{arrow_head, word};
use crate::typeset::pen::{face, pen};

/// Width of the drawing area on paper in mm.
const WIDTH: f64 = 160.0;
/// Height of the plot area of a graph in mm.
const GRAPH_HEIGHT: f64 = 52.0;
/// Margins around shapes for labels: left, top, right, bottom in mm.
const MARGIN: [f64; 4] = [5.0, 4.0, 5.0, 4.0];
/// Margins around a plot for ticks and titles.
const GRAPH_MARGIN: [f64; 4] = [21.0, 3.0, 5.0, 13.5];
/// Points of a stroke nearer than this to the last one drawn are left out, in mm of paper.
const FINEST: f64 = 0.05;
/// Width of the hairline that closes the seam between two filled shapes, mm.
const SEAM: f64 = 0.14;

/// Where figure coordinates fall on paper.
struct Plot {
    scale: [f64; 2],
    shift: [f64; 2],
    size: [f64; 2],
}

impl Plot {
    fn at(&self, point: [f64; 2]) -> [f64; 2] {
        [point[0] * self.scale[0] + self.shift[0], self.shift[1] - point[1] * self.scale[1]]
    }
}

/// The figure as an SVG document; `None` if it has nothing to show or a coordinate is not finite.
pub(super) fn svg(figure: &Figure, language: Language) -> Option<String> {
    let bounds = bounds(figure)?;
    let mut body = String::new();
    let frame = match &figure.axes {
        Some(axes) => graph(&mut body, axes, bounds, language),
        None => drawing(bounds, figure, language),
    };
    for stroke in &figure.strokes {
        let points: Vec<[f64; 2]> = stroke.points.iter().map(|&point| frame.at(point)).collect();
        if stroke.filled {
            fill(&mut body, stroke.ink, &points);
        } else {
            line(&mut body, stroke.ink, &points);
            if stroke.arrow {
                arrow_head(&mut body, stroke.ink, &points);
            }
        }
    }
    if !figure.labels.is_empty() {
        // Paper about the letters keeps those that stand on a line legible.
        body.push_str("<g stroke=\"#ffffff\" stroke-width=\"1.2\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n");
        for label in &figure.labels {
            word(&mut body, frame.at(label.at), figure.letters, "middle", "#1d232b", label.text.get(language));
        }
        body.push_str("</g>\n");
    }
    Some(document(&body, frame.size))
}

/// Dots of one colour and size on a graph.
pub(super) struct Dots {
    /// Their colour.
    pub colour: &'static str,
    /// Their radius on paper, mm.
    pub radius: f64,
    /// Where they are.
    pub at: Vec<[f64; 2]>,
}

/// A graph of dots as an SVG document, the first drawn first; of those that fall on one another one is drawn. `None` if there is none,
/// or a coordinate is not finite.
pub(super) fn dots(axes: &Axes, dots: &[Dots], language: Language) -> Option<String> {
    let all = || dots.iter().flat_map(|one| &one.at);
    if !all().flatten().all(|coordinate| coordinate.is_finite()) {
        return None;
    }
    let first = *all().next()?;
    let [low, high] = all()
        .fold([first; 2], |[low, high], [x, y]| [[low[0].min(*x), low[1].min(*y)], [high[0].max(*x), high[1].max(*y)]]);
    // A dot stands clear of the frame, and one alone in the middle.
    let edge = [0, 1].map(|axis| if high[axis] > low[axis] { 0.02 * (high[axis] - low[axis]) } else { 0.5 });
    let bounds = [0, 1].map(|axis| [low[axis] - edge[axis], high[axis] + edge[axis]]);
    let mut body = String::new();
    let frame = graph(&mut body, axes, bounds, language);
    for one in dots {
        let mut drawn = BTreeSet::new();
        for &at in &one.at {
            let at = frame.at(at).map(|coordinate| format!("{coordinate:.1}"));
            let [x, y] = &at;
            let dot = format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{}\" fill=\"{}\"/>\n", one.radius, one.colour);
            if drawn.insert(at) {
                body.push_str(&dot);
            }
        }
    }
    Some(document(&body, frame.size))
}

/// An SVG document of a size in mm. What the thousands of faces of a solid share stands once, at its head.
fn document(body: &str, [width, height]: [f64; 2]) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.2}mm\" height=\"{height:.2}mm\" viewBox=\"0 0 {width:.2} {height:.2}\" stroke-width=\"{SEAM}\" stroke-linejoin=\"round\">\n{body}</svg>\n"
    )
}

/// Minimum and maximum coordinates: x, then y.
fn bounds(figure: &Figure) -> Option<[[f64; 2]; 2]> {
    let points =
        figure.strokes.iter().flat_map(|stroke| &stroke.points).chain(figure.labels.iter().map(|label| &label.at));
    let mut found: Option<[[f64; 2]; 2]> = None;
    for &[x, y] in points {
        if !(x.is_finite() && y.is_finite()) {
            return None;
        }
        found = Some(match found {
            None => [[x, x], [y, y]],
            Some([[x0, x1], [y0, y1]]) => [[x0.min(x), x1.max(x)], [y0.min(y), y1.max(y)]],
        });
    }
    found
}

/// One scale for both axes, with the shapes in the middle and room on both sides for labels that project.
fn drawing([[x0, x1], [y0, y1]]: [[f64; 2]; 2], figure: &Figure, language: Language) -> Plot {
    let [mut left, top, mut right, bottom] = MARGIN;
    let (dx, dy) = ((x1 - x0).max(1e-9), (y1 - y0).max(1e-9));
    let fit = |left: f64, right: f64| ((WIDTH - left - right) / dx).min((figure.height - top - bottom) / dy);
    let letter = figure::LETTER * figure.letters / Figure::SKETCHED;
    // A drawing that fills the width gets smaller, and its labels then project more: a few rounds are enough.
    for _ in 0..4 {
        let scale = fit(left, right);
        for label in &figure.labels {
            let half = 0.5 * letter * figure::letters(label.text.get(language));
            left = left.max(half - (label.at[0] - x0) * scale);
            right = right.max(half - (x1 - label.at[0]) * scale);
        }
    }
    let scale = fit(left, right);
    let size = [dx * scale + left + right, dy * scale + top + bottom];
    Plot { scale: [scale, scale], shift: [left - x0 * scale, top + y1 * scale], size }
}

/// Draws the axes with ticks; a scale of its own for each.
fn graph(body: &mut String, axes: &Axes, [[x0, x1], [y0, y1]]: [[f64; 2]; 2], language: Language) -> Plot {
    let [left, top, right, bottom] = GRAPH_MARGIN;
    let (width, height) = (WIDTH - left - right, GRAPH_HEIGHT);
    let room = 0.06 * (y1 - y0).max(1e-9);
    let (y0, y1) = (y0 - room, y1 + room);
    let (dx, dy) = ((x1 - x0).max(1e-9), (y1 - y0).max(1e-9));
    let scale = [width / dx, height / dy];
    let shift = [left - x0 * scale[0], top + y1 * scale[1]];
    let frame = Plot { scale, shift, size: [WIDTH, height + top + bottom] };
    let (foot, end) = (top + height, left + width);
    for (value, text) in ticks(x0, x1, 10) {
        let [x, _] = frame.at([value, y0]);
        rule(body, [x, top], [x, foot]);
        word(body, [x, foot + 4.4], Figure::LETTERS, "middle", "#333b44", &text);
    }
    for (value, text) in ticks(y0, y1, 6) {
        let [_, y] = frame.at([x0, value]);
        rule(body, [left, y], [end, y]);
        word(body, [left - 1.5, y + 1.2], Figure::LETTERS, "end", "#333b44", &text);
    }
    let _ = writeln!(
        body,
        "<rect x=\"{left:.2}\" y=\"{top:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" fill=\"none\" stroke=\"#333b44\" stroke-width=\"0.25\"/>"
    );
    word(body, [left + width / 2.0, foot + 10.0], Figure::LETTERS, "middle", "#1d232b", axes.x.get(language));
    let _ = write!(body, "<g transform=\"translate(4.2 {:.2}) rotate(-90)\">", top + height / 2.0);
    word(body, [0.0, 0.0], Figure::LETTERS, "middle", "#1d232b", axes.y.get(language));
    body.push_str("</g>\n");
    frame
}

fn rule(body: &mut String, from: [f64; 2], to: [f64; 2]) {
    let _ = writeln!(
        body,
        "<line x1=\"{:.3}\" y1=\"{:.3}\" x2=\"{:.3}\" y2=\"{:.3}\" stroke=\"#dde2e7\" stroke-width=\"0.15\"/>",
        from[0], from[1], to[0], to[1]
    );
}

/// The points of a polyline without those too near to be seen; always with the last one.
fn path(points: &[[f64; 2]]) -> String {
    let mut text = String::new();
    let mut last: Option<[f64; 2]> = None;
    for (at, &[x, y]) in points.iter().enumerate() {
        let near = last.is_some_and(|[a, b]| (a - x).abs().max((b - y).abs()) < FINEST);
        if near && at + 1 < points.len() {
            continue;
        }
        let _ = write!(text, "{}{x:.2} {y:.2}", if last.is_some() { " " } else { "M" });
        last = Some([x, y]);
    }
    text
}

fn line(body: &mut String, ink: Ink, points: &[[f64; 2]]) {
    let pen = pen(ink);
    let _ = write!(
        body,
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2}\" stroke-linecap=\"round\"",
        path(points),
        pen.colour,
        pen.width
    );
    if !pen.dash.is_empty() {
        let dashes: Vec<String> = pen.dash.iter().map(|length| format!("{length:.2}")).collect();
        let _ = write!(body, " stroke-dasharray=\"{}\"", dashes.join(" "));
    }
    body.push_str("/>\n");
}

/// A filled shape, its seam closed by a hairline of its own colour.
fn fill(body: &mut String, ink: Ink, points: &[[f64; 2]]) {
    let colour = match ink {
        Ink::Face(light) => face(light),
        other => pen(other).tint.to_owned(),
    };
    let _ = writeln!(body, "<path d=\"{} Z\" fill=\"{colour}\" stroke=\"{colour}\"/>", path(points));
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use crate::figure::Figure;

    /// The parts of their width that templates set figures at, in %.
    #[expect(clippy::disallowed_methods, reason = "the templates of the tree, not of the binary")]
    fn parts(folder: &Path, found: &mut Vec<f64>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                parts(&path, found);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            found.extend(text.split("part: ").skip(1).filter_map(|rest| rest.split_once('%')?.0.parse::<f64>().ok()));
        }
    }

    #[test]
    fn the_letters_of_a_figure_are_seven_and_a_half_points_or_more_on_its_page() {
        let mut found = Vec::new();
        parts(&Path::new(env!("CARGO_MANIFEST_DIR")).join("report-templates"), &mut found);
        assert!(found.len() > 4, "{found:?}");
        for part in found {
            let points = Figure::LETTERS * part / 100.0 * 72.0 / 25.4;
            assert!(points >= 7.5, "{points} pt at {part} %");
        }
    }
}
