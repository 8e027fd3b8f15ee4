//! One printed sheet of a tiled drawing, without its words, as an SVG of the whole page in mm.

use std::fmt::Write as _;

use super::tiles::{FOOT, Joint, MARGIN, Tiling};
use super::{Drawing, number, svg};
use crate::figure::Figure;
use crate::typeset::characters::Words;

/// Length of the check ruler in mm.
pub(super) const RULER: f64 = 100.0;
/// Half the length of a registration mark's arms in mm.
const ARM: f64 = 4.0;
/// Greatest width and height of the map of the sheets in mm.
pub(super) const MAP: [f64; 2] = [30.0, 17.0];
/// How far a label reaches from its place, in mm.
const WORD: f64 = 12.0;
/// From the window to what the foot holds, in mm.
pub(super) const GAP: f64 = 2.5;

/// The places whose sheets have something of the drawing on them: its lines go on from each to a neighbour.
pub(super) fn printed(figure: &Figure, tiling: &Tiling) -> Vec<[u32; 2]> {
    let holds = |&place: &[u32; 2]| {
        let window = tiling.shown(place);
        let close =
            |at: [f64; 2]| at.iter().zip(window).all(|(at, [least, most])| (least - WORD..=most + WORD).contains(at));
        figure.strokes.iter().any(|stroke| stroke.filled || svg::comes_near(&stroke.points, window))
            || figure.labels.iter().any(|label| close(label.at))
    };
    tiling.places().filter(holds).collect()
}

/// The page of one of the `printed` sheets, with the joints to those of its neighbours that are among them. Labels show the
/// characters that typst's fonts have.
pub(super) fn page(
    drawing: &Drawing<'_>,
    tiling: &Tiling,
    printed: &[[u32; 2]],
    place: [u32; 2],
    words: &mut Words,
) -> String {
    let [width, height] = tiling.page;
    let (left, top) = (MARGIN, MARGIN);
    let corner = tiling.corner(place);
    let at = |[x, y]: [f64; 2]| [x - corner[0] + left, corner[1] - y + top];
    let [across, down] = tiling.window;
    let (width, height) = (number(width), number(height));
    let mut file = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\">\n"
    );
    let _ = writeln!(
        file,
        "<clipPath id=\"window\"><rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\"/></clipPath>\n\
         <rect x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" fill=\"none\" stroke=\"#8d97a3\" stroke-width=\"0.13\"/>",
        number(left),
        number(top),
        number(across),
        number(down)
    );
    let middle = [left + across / 2.0, top + down / 2.0];
    for joint in tiling.joints(place) {
        if let Some(number) = printed.iter().position(|one| *one == joint.neighbour) {
            cut(&mut file, &joint, number + 1, middle, at);
        }
    }
    file.push_str("<g clip-path=\"url(#window)\">\n");
    svg::strokes(&mut file, drawing.figure, drawing.language, at, Some(tiling.shown(place)));
    svg::labels(&mut file, drawing.figure, at, |text| words.text(text));
    file.push_str("</g>\n");
    ruler(&mut file, [left, top + down + GAP]);
    map(&mut file, tiling, printed, place);
    file.push_str("</svg>\n");
    file
}

/// Lines of one look, each from a point to another.
fn lines(file: &mut String, lines: &[[[f64; 2]; 2]], look: &str) {
    let data: Vec<String> = lines.iter().map(|line| svg::path(line)).collect();
    let _ = writeln!(file, "<path d=\"{}\" fill=\"none\" {look}/>", data.join(""));
}

/// The line to cut along with its registration marks; on its side away from the window's middle, the neighbour's number.
fn cut(file: &mut String, joint: &Joint, neighbour: usize, middle: [f64; 2], at: impl Fn([f64; 2]) -> [f64; 2]) {
    let ends = joint.line.map(&at);
    lines(file, &[ends], "stroke=\"#6b7682\" stroke-width=\"0.13\" stroke-dasharray=\"3 2\"");
    for cross in joint.crosses {
        let [x, y] = at(cross);
        let arms = [[[x - ARM, y], [x + ARM, y]], [[x, y - ARM], [x, y + ARM]]];
        lines(file, &arms, "stroke=\"#000000\" stroke-width=\"0.18\"");
        let _ = writeln!(
            file,
            "<circle cx=\"{}\" cy=\"{}\" r=\"2\" fill=\"none\" stroke=\"#000000\" stroke-width=\"0.18\"/>",
            number(x),
            number(y)
        );
    }
    let [[ax, ay], [bx, by]] = ends;
    let upright = (bx - ax).abs() < (by - ay).abs();
    let [x, y] = [f64::midpoint(ax, bx), f64::midpoint(ay, by)];
    let out = |value: f64, middle: f64| value + 2.6_f64.copysign(value - middle);
    let [x, y] = if upright { [out(x, middle[0]), y] } else { [x, out(y, middle[1])] };
    figures(file, [x, y + 1.0], 3.0, "#6b7682", neighbour);
}

/// A number, centred.
fn figures(file: &mut String, [x, y]: [f64; 2], size: f64, colour: &str, value: usize) {
    let _ = writeln!(
        file,
        "<text x=\"{}\" y=\"{}\" font-family=\"Libertinus Serif\" font-size=\"{size}\" text-anchor=\"middle\" fill=\"{colour}\">{value}</text>",
        number(x),
        number(y)
    );
}

/// The check ruler, from its left end.
fn ruler(file: &mut String, [x, y]: [f64; 2]) {
    let mut ticks = vec![[[x, y], [x + RULER, y]]];
    for step in 0..=100_u16 {
        let length = match step {
            _ if step % 10 == 0 => 4.0,
            _ if step % 5 == 0 => 2.8,
            _ => 1.8,
        };
        let at = x + f64::from(step) / 100.0 * RULER;
        ticks.push([[at, y], [at, y + length]]);
        if step % 10 == 0 {
            figures(file, [at, y + 6.4], 2.4, "#1d232b", step.into());
        }
    }
    lines(file, &ticks, "stroke=\"#000000\" stroke-width=\"0.13\"");
}

/// A small map of the sheets in the lower right corner, this one filled; pale where nothing is printed.
fn map(file: &mut String, tiling: &Tiling, printed: &[[u32; 2]], place: [u32; 2]) {
    let [across, down] = tiling.window;
    let (columns, rows) = (f64::from(tiling.columns), f64::from(tiling.rows));
    let scale = (MAP[0] / (columns * across)).min(MAP[1] / (rows * down)).min(0.05);
    let (width, height) = (across * scale, down * scale);
    let right = tiling.page[0] - MARGIN;
    let top = tiling.page[1] - MARGIN - FOOT + GAP;
    let (empty, full): (Vec<_>, Vec<_>) = tiling.places().partition(|place| !printed.contains(place));
    for [row, column] in empty.into_iter().chain(full) {
        let fill = if [row, column] == place { "#163a63" } else { "none" };
        let ink = if printed.contains(&[row, column]) { "#1d232b" } else { "#c9d0d8" };
        let _ = writeln!(
            file,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{fill}\" stroke=\"{ink}\" stroke-width=\"0.13\"/>",
            number(right - (columns - f64::from(column)) * width),
            number(top + f64::from(row) * height),
            number(width),
            number(height)
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{Ink, Label, Paper, Stroke};
    use crate::text::{Text, t};

    #[test]
    fn sheets_without_a_line_are_not_printed_and_those_with_one_hang_together() {
        let arch =
            (0..=400_u16).map(|at| f64::from(at) / 400.0).map(|part| [1500.0 * part, 3200.0 * part * (1.0 - part)]);
        let figure = Figure {
            letters: Figure::LETTERS,
            key: "arch",
            height: Figure::HEIGHT,
            caption: t("", ""),
            axes: None,
            strokes: vec![Stroke::line(Ink::Cut, arch.clone().collect())],
            labels: vec![Label { at: [0.0, -4.0], text: Text::same("φ") }],
            legend: Vec::new(),
        };
        let tiling = Tiling::over([[0.0, 1500.0], [-6.0, 800.0]], Paper::A4).unwrap();
        let printed = printed(&figure, &tiling);
        assert!(printed.len() < tiling.places().count() * 3 / 4, "{} of {}", printed.len(), tiling.places().count());
        for [x, y] in arch {
            let seen = |&place: &[u32; 2]| {
                let [[left, right], [low, high]] = tiling.shown(place);
                (left..=right).contains(&x) && (low..=high).contains(&y)
            };
            assert!(printed.iter().any(seen), "{x} {y}");
        }
        // From the first, every other is reached by joints between printed ones.
        let (mut reached, mut open) = (vec![printed[0]], vec![printed[0]]);
        while let Some(place) = open.pop() {
            for joint in tiling.joints(place) {
                if printed.contains(&joint.neighbour) && !reached.contains(&joint.neighbour) {
                    reached.push(joint.neighbour);
                    open.push(joint.neighbour);
                }
            }
        }
        assert_eq!(reached.len(), printed.len());
    }
}
