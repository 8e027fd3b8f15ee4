//! The sketch of the form: the two pipes, and the template of the branch, to no scale.

use std::f64::consts::TAU;

use crate::figure::{Figure, Ink, Sketch};
use crate::kinds::pipe::form_sketch::{pair, pipes};
use crate::text::t;

/// Lower left corner of the template, its length, Z, and how much of the curve's height is shown.
const CORNER: [f64; 2] = [-34.0, -62.0];
const LENGTH: f64 = 112.0;
const Z: f64 = 18.0;
const SHARE: f64 = 0.8;

/// The sketch of the branch's form.
pub(super) fn sketch() -> Figure {
    let mut sketch = Sketch::on_paper();
    pipes(&mut sketch);
    let zero = pair().point(0.0);
    let [x, y] = [zero.x, zero.z];
    sketch.line(Ink::Outline, [[x - 0.6, y], [x + 0.6, y]]);
    sketch.pointer([x + 16.0, y + 7.0], [x + 0.4, y + 0.2], "φ = 0");
    template(&mut sketch);
    sketch.figure(
        "sketch",
        Figure::HEIGHT,
        t(
            "Qué es cada símbolo: tubos y plantilla del injerto, sin escala",
            "What the symbols are: pipes and template of the branch, not to scale",
        ),
    )
}

/// The development of the branch with the curve to cut.
fn template(sketch: &mut Sketch) {
    const PARTS: u8 = 48;
    let [left, low] = CORNER;
    let at = |part: f64| [left + LENGTH * part, low + Z + SHARE * pair().depth(TAU * part)];
    let curve: Vec<[f64; 2]> = (0..=PARTS).map(|index| at(f64::from(index) / f64::from(PARTS))).collect();
    let end = left + LENGTH;
    sketch.shape(Ink::Outline, [[end, low], [left, low]].into_iter().chain(curve.iter().copied()).collect::<Vec<_>>());
    for index in 1..12_u8 {
        let point = at(f64::from(index) / 12.0);
        sketch.line(Ink::Thin, [[point[0], low], point]);
    }
    let start = at(0.0);
    let pierce = [start[0] - 5.0, start[1] + 9.0];
    sketch.line(Ink::Cut, [pierce, start]);
    sketch.line(Ink::Cut, [at(1.0), [end + 7.0, at(1.0)[1]]]);
    sketch.dimension([left, low], start, 6.0, "Z");
    sketch.pointer([pierce[0] + 12.0, pierce[1] + 3.0], [pierce[0] + 2.2, pierce[1] - 3.5], "lead_in");
    sketch.pointer([end + 5.0, at(1.0)[1] + 8.0], [end + 4.5, at(1.0)[1] + 0.4], "overcut");
    sketch.dimension([left, low], [end, low], -5.0, "2·π·r_dev");
    sketch.word([left + LENGTH / 2.0, low + 5.0], t("plantilla, N divisiones", "template, N divisions"));
}
