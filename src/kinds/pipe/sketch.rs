//! What the sketches of both pipe kinds share: the pipe on its rotary axis, seen from the side and along its axis.

use crate::figure::{Figure, Ink, Side, Sketch, sized};
use crate::text::{Text, t};

/// The height of the sketches in print, mm.
pub(in crate::kinds) const HEIGHT: f64 = 66.0;

/// The pipe from the side, from `left` to `right` along X, its axis at z = 0, on the rotary that turns it.
pub(in crate::kinds) fn pipe(sketch: &mut Sketch, diameter: f64, [left, right]: [f64; 2]) {
    let (half, chuck) = (diameter / 2.0, sketch.paper(9.0));
    sketch.rectangle(Ink::Outline, [left, -half], [right, half]);
    let high = 1.25 * half;
    sketch.rectangle(Ink::Thin, [left - chuck, -high], [left + 0.25 * chuck, high]);
    sketch.line(Ink::Centre, [[left - 1.3 * chuck, 0.0], [right + 0.4 * chuck, 0.0]]);
    sketch.label([left - 0.4 * chuck, high], Side::Above, t("giratorio A", "rotary A"));
}

/// A caption that says what of the drawing no value of the form decides.
pub(in crate::kinds) fn held(caption: &Text) -> Text {
    let Text { es, en } = caption;
    Text::new(format!("{es}. Giratorio dibujado en −X por convenio"), format!("{en}. Rotary drawn at −X by convention"))
}

/// A torch above a point, its tip there.
pub(in crate::kinds) fn torch(sketch: &mut Sketch, [x, z]: [f64; 2]) {
    let (half, tip, long) = (sketch.paper(2.4), sketch.paper(0.8), sketch.paper(4.0));
    let outline = [
        [x - tip, z],
        [x + tip, z],
        [x + half, z + long],
        [x + half, z + 2.2 * long],
        [x - half, z + 2.2 * long],
        [x - half, z + long],
    ];
    sketch.shape(Ink::Safe, outline);
}

/// The pipe along its axis, seen against X: how the torch goes round it by +A, and how the pipe turns for that. `edge` is
/// drawn on it.
pub(in crate::kinds) fn end(diameter: f64, wall: f64, line: Text, edge: Vec<[f64; 2]>) -> Figure {
    let half = diameter / 2.0;
    let mut sketch = Sketch::new([2.6 * half, 2.6 * half], [44.0, HEIGHT - 22.0]);
    let gap = sketch.paper(2.0);
    sketch.ring(Ink::Outline, [0.0, 0.0], half);
    sketch.ring(Ink::Outline, [0.0, 0.0], half - wall);
    sketch.line(Ink::Centre, [[-half - gap, 0.0], [half + gap, 0.0]]);
    sketch.line(Ink::Centre, [[0.0, -half - gap], [0.0, half + gap]]);
    if !edge.is_empty() {
        sketch.line(Ink::Obverse, edge);
    }
    torch(&mut sketch, [0.0, half + gap]);
    sketch.label([sketch.paper(2.4), half + 3.0 * gap], Side::Right, line);
    // By ISO 841 A turns from +Y to +Z: seen against X, with +Y to the right, anticlockwise.
    let about = half + 2.6 * gap;
    sketch.turn(Ink::Obverse, [0.0, 0.0], about, [112.0, 160.0]);
    sketch.label([-0.8 * about, 0.66 * about], Side::Left, t("+A: la antorcha", "+A: the torch"));
    sketch.turn(Ink::Axis(2), [0.0, 0.0], about, [-20.0, -68.0]);
    sketch.label([0.42 * about, -1.04 * about], Side::Right, t("gira el tubo", "the pipe turns"));
    sketch.upright([0.0, -half], [0.0, half], half + sketch.paper(8.0), Side::Right, sized("D", diameter));
    sketch.figure("setup-side", HEIGHT, t("Desde el lado de +X", "From the side of +X"))
}
