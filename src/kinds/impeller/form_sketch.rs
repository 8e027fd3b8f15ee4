//! The sketch of the form: section, plan and turning, to no scale but with the true shape of the blades.

use std::f64::consts::PI;

use crate::figure::{Figure, Ink, Sketch, arc, on_circle};
use crate::geometry::torus::Torus;
use crate::geometry::villarceau::Villarceau;
use crate::text::t;

/// The part, mm of paper.
const TORUS: Torus = Torus { R: 26.0, r: 15.0 };
const DEPTH: f64 = 4.0;
const STOCK: f64 = 30.0;
const NOSE: f64 = -52.0;
const PIVOT: f64 = -74.0;
/// The middle of the plan, mm of paper.
const PLAN: [f64; 2] = [88.0, -13.0];
/// Half the thickness of a blade in plan.
const HALF: f64 = 1.3;
/// The turned face and the axis of the turning.
const FACE: f64 = 82.0;
const AXIS: f64 = -84.0;

/// The sketch of the impeller's form.
pub(super) fn sketch() -> Figure {
    let mut sketch = Sketch::on_paper();
    section(&mut sketch);
    plan(&mut sketch);
    turning(&mut sketch);
    sketch.figure(
        "sketch",
        Figure::HEIGHT,
        t(
            "Qué es cada símbolo: sección, planta y torneado, sin escala",
            "What the symbols are: section, plan and turning, not to scale",
        ),
    )
}

/// Half of the part on the work spindle, in a plane through its axis.
fn section(sketch: &mut Sketch) {
    let Torus { R, r } = TORUS;
    sketch.rectangle(Ink::Thin, [0.0, -STOCK], [19.0, NOSE]);
    let mut half = vec![[0.0, 0.0], [R - r, 0.0]];
    half.extend(arc([R, 0.0], r, [180.0, 270.0]));
    half.extend([[R, -STOCK], [0.0, -STOCK]]);
    sketch.shape(Ink::Outline, half);
    sketch.line(Ink::Safe, arc([R, 0.0], r + DEPTH, [180.0, 270.0]));
    sketch.line(Ink::Outline, [[-10.0, NOSE], [30.0, NOSE]]);
    sketch.line(Ink::Centre, [[0.0, 13.0], [0.0, PIVOT - 5.0]]);
    sketch.line(Ink::Outline, arc([0.0, PIVOT], 1.6, [0.0, 360.0]));
    sketch.line(Ink::Centre, [[-6.0, PIVOT], [27.0, PIVOT]]);
    sketch.word([0.0, 15.0], t("eje C", "axis of C"));
    sketch.word([12.0, PIVOT - 3.0], t("eje B", "axis of B"));
    sketch.word([12.5, NOSE - 5.0], t("nariz del husillo\nportapieza", "nose of the\nwork spindle"));
    sketch.word([-7.5, 2.5], t("cara", "face"));
    sketch.line(Ink::Thin, [[-11.0, 0.0], [0.0, 0.0]]);
    sketch.dimension([0.0, 0.0], [R, 0.0], 7.0, "R");
    sketch.radius([R, 0.0], r, 222.0, 2.6, "r");
    sketch.dimension(on_circle([R, 0.0], r, 246.0), on_circle([R, 0.0], r + DEPTH, 246.0), 0.0, "a_p");
    sketch.dimension([R, 0.0], [R, -STOCK], 6.0, "L_b");
    sketch.dimension([R, 0.0], [R, NOSE], 15.0, "H");
    sketch.dimension([R, NOSE], [R, PIVOT], 15.0, "R_B");
}

/// The mean line of a blade in plan, turned by an angle in degrees, from a part of its length on.
fn mean_line(turned: f64, from: f64) -> Vec<[f64; 2]> {
    const PARTS: u8 = 24;
    let circle = Villarceau::new(TORUS);
    (0..=PARTS)
        .map(|at| {
            let part = from + (1.0 - from) * f64::from(at) / f64::from(PARTS);
            let v = PI + PI / 2.0 * part;
            on_circle(PLAN, TORUS.rho(v), circle.u(v).to_degrees() + turned)
        })
        .collect()
}

/// A line beside another, to its left.
fn beside(line: &[[f64; 2]], by: f64) -> Vec<[f64; 2]> {
    let ends = |at: usize| (at.saturating_sub(1), (at + 1).min(line.len() - 1));
    (0..line.len())
        .map(|at| {
            let (before, after) = ends(at);
            let (dx, dy) = (line[after][0] - line[before][0], line[after][1] - line[before][1]);
            let length = (dx * dx + dy * dy).sqrt();
            [line[at][0] - dy / length * by, line[at][1] + dx / length * by]
        })
        .collect()
}

/// The blades as the tool sees them.
fn plan(sketch: &mut Sketch) {
    let Torus { R, r } = TORUS;
    sketch.line(Ink::Outline, arc(PLAN, R, [0.0, 360.0]));
    sketch.line(Ink::Thin, arc(PLAN, R - r, [0.0, 360.0]));
    let [x, y] = PLAN;
    sketch.line(Ink::Centre, [[x - R - 3.0, y], [x + R + 3.0, y]]);
    sketch.line(Ink::Centre, [[x, y - R - 3.0], [x, y + R + 3.0]]);
    for turned in [0.0, 90.0, 180.0, 270.0] {
        let line = mean_line(turned, 0.0);
        let (one, other) = (beside(&line, HALF), beside(&line, -HALF));
        sketch.shape(Ink::Outline, one.into_iter().chain(other.into_iter().rev()).collect::<Vec<_>>());
        sketch.line(Ink::Splitter, mean_line(turned + 45.0, 0.35));
    }
    let line = mean_line(180.0, 0.0);
    for point in line.iter().step_by(4) {
        sketch.line(Ink::Dimension, arc(*point, 0.4, [0.0, 360.0]));
    }
    let near = |at: usize| line.get(at).copied().unwrap_or(PLAN);
    sketch.pointer([x + R + 7.0, y + 17.0], near(16), "n");
    let widest = mean_line(90.0, 0.0);
    let at = |sides: f64| beside(&widest, sides).get(20).copied().unwrap_or(PLAN);
    sketch.dimension(at(HALF), at(-HALF), 0.0, "e");
    let tool = on_circle(PLAN, 19.0, 190.0);
    sketch.line(Ink::Safe, arc(tool, 2.6, [0.0, 360.0]));
    sketch.pointer([x - R - 8.0, y - 17.0], [tool[0] - 2.6, tool[1]], "d_t");
    sketch.word([x, y + R + 6.0], t("N álabes", "N blades"));
    sketch.word([x + 15.0, y - R - 7.5], t("splitters (a trazo ocre)", "splitters (ochre line)"));
}

/// Half of the stock in the lathe, the way of the tool about it.
fn turning(sketch: &mut Sketch) {
    let (R, r, length) = (13.0, 7.5, 24.0);
    let (left, top) = (FACE - length, AXIS + R);
    let mut half = vec![[left, AXIS], [left, top], [FACE - r, top]];
    half.extend(arc([FACE, top], r, [180.0, 270.0]));
    half.push([FACE, AXIS]);
    sketch.shape(Ink::Outline, half);
    let (start, end) = ([FACE + 18.0, top], [FACE + 30.0, top + 9.0]);
    sketch.line(Ink::Centre, [[left - 5.0, AXIS], [FACE + 33.0, AXIS]]);
    sketch.line(Ink::Safe, [start, [FACE, top + 1.5], [FACE, AXIS - 1.5]]);
    sketch.line(Ink::Safe, [[FACE, top + 3.0], end]);
    sketch.word([left + 8.0, top + 4.0], t("torneado del bruto", "turning of the blank"));
    sketch.dimension([FACE, AXIS], [start[0], AXIS], -5.0, "Z_b");
    sketch.dimension([FACE, AXIS], [end[0], AXIS], -11.0, "Z_e");
    sketch.line(Ink::Thin, [end, [end[0] + 6.0, end[1]]]);
    sketch.dimension([end[0] + 5.0, AXIS], [end[0] + 5.0, end[1]], -0.1, "⌀ X_e");
    sketch.line(Ink::Thin, [start, [start[0], AXIS]]);
    sketch.pointer([FACE - 9.0, AXIS - 4.5], [FACE - 0.3, AXIS - 1.3], "c_o");
}
