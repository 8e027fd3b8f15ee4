//! The sketch of the form: the two pipes, the groove, and the torch over the header, to no scale.

use crate::figure::{Figure, Ink, Sketch, on_circle};
use crate::kinds::pipe::form_sketch::pipes;
use crate::number::trig::sin_cos;
use crate::text::t;

/// The groove: where the branch's outside is, the header's bore and outside, root gap, land and angle.
const FACE: f64 = -18.0;
const BORE: f64 = -62.0;
const OUTSIDE: f64 = -46.0;
const GAP: f64 = 5.0;
const LAND: f64 = 5.0;
const GAMMA: f64 = 38.0;
/// The torch: its tip, the radii of tip and body, and the half angle of its taper.
const TIP: [f64; 2] = [68.0, -50.0];
const TIP_RADIUS: f64 = 4.0;
const BODY: f64 = 9.0;
const TAPER: f64 = 28.0;
/// The header below the torch: a point of its outside, and its slope in degrees.
const BELOW: [f64; 2] = [44.0, -73.0];
const SLOPE: f64 = 20.0;

/// The sketch of the hole's form.
pub(super) fn sketch() -> Figure {
    let mut sketch = Sketch::on_paper();
    pipes(&mut sketch);
    groove(&mut sketch);
    torch(&mut sketch);
    sketch.figure(
        "sketch",
        Figure::HEIGHT,
        t(
            "Qué es cada símbolo: tubos, bisel y antorcha, sin escala",
            "What the symbols are: pipes, groove and torch, not to scale",
        ),
    )
}

/// The walls of branch and header where they are to be welded.
fn groove(sketch: &mut Sketch) {
    let edge = FACE + GAP;
    let (sin, cos) = sin_cos(GAMMA.to_radians());
    let lip = edge + (OUTSIDE - BORE - LAND) * sin / cos;
    sketch.shape(
        Ink::Outline,
        [[FACE - 7.0, BORE - 7.0], [FACE, BORE - 7.0], [FACE, OUTSIDE + 14.0], [FACE - 7.0, OUTSIDE + 14.0]],
    );
    sketch.shape(Ink::Outline, [[edge, BORE], [edge, BORE + LAND], [lip, OUTSIDE], [26.0, OUTSIDE], [26.0, BORE]]);
    sketch.line(Ink::Centre, [[edge, BORE + LAND], [edge, OUTSIDE + 11.0]]);
    sketch.line(Ink::Thin, [[edge, BORE + LAND], on_circle([edge, BORE + LAND], 24.0, 90.0 - GAMMA)]);
    sketch.angle([edge, BORE + LAND], 19.0, [90.0 - GAMMA, 90.0], "gamma");
    sketch.dimension([FACE, BORE], [edge, BORE], -4.0, "b");
    sketch.dimension([edge + 8.0, BORE], [edge + 8.0, BORE + LAND], 0.0, "h");
    sketch.line(Ink::Thin, [[edge, BORE + LAND], [edge + 9.0, BORE + LAND]]);
    sketch.dimension([26.0, BORE], [26.0, OUTSIDE], -4.0, "t_header");
    sketch.word([FACE - 3.5, OUTSIDE + 17.0], t("injerto", "branch"));
    sketch.word([14.0, OUTSIDE + 3.0], t("tubo base", "header"));
}

/// The torch over the header.
fn torch(sketch: &mut Sketch) {
    let [x, y] = TIP;
    let (sin, cos) = sin_cos(TAPER.to_radians());
    let shoulder = y + (BODY - TIP_RADIUS) * cos / sin;
    let top = shoulder + 5.0;
    sketch.shape(
        Ink::Thin,
        [
            [x - TIP_RADIUS, y],
            [x - BODY, shoulder],
            [x - BODY, top],
            [x + BODY, top],
            [x + BODY, shoulder],
            [x + TIP_RADIUS, y],
        ],
    );
    let on_header = |along: f64| on_circle(BELOW, along, SLOPE);
    let deeper = |along: f64| [on_header(along)[0], on_header(along)[1] - 7.0];
    sketch.shape(Ink::Outline, [on_header(0.0), on_header(52.0), deeper(52.0), deeper(0.0)]);
    let (rise, run) = sin_cos(SLOPE.to_radians());
    let height = |at: f64| BELOW[1] + (at - BELOW[0]) * rise / run;
    for side in [-1.3, 1.3] {
        sketch.line(Ink::Safe, [[x + side, y], [x + side, height(x + side)]]);
    }
    sketch.line(Ink::Centre, [[x, top + 3.0], [x, height(x) - 9.0]]);
    sketch.dimension([x, height(x)], [x, y], 6.5, "d0");
    let corner = [x + TIP_RADIUS, y];
    let along = (corner[0] - BELOW[0]) * run + (corner[1] - BELOW[1]) * rise;
    sketch.dimension(corner, on_header(along), 0.0, "g0");
    sketch.dimension([x, top], [x + BODY, top], 3.0, "R_g");
    sketch.line(Ink::Thin, [corner, [corner[0], y + 13.0]]);
    sketch.angle(corner, 10.0, [90.0 - TAPER, 90.0], "Psi");
    sketch.pointer([x - 14.0, y + 5.0], [x - TIP_RADIUS, y + 0.3], "r_g");
    sketch.pointer([x - 15.0, height(x) - 3.0], [x - 1.3, height(x) + 4.0], "m");
}
