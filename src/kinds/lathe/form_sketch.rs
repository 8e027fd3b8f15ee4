//! The sketch of the form: chuck, stock, zeros and turret, to no scale.

use crate::figure::{Figure, Ink, Sketch};
use crate::text::t;

/// The sketch of the lathe's form. M lies at the origin.
pub(super) fn sketch() -> Figure {
    let mut sketch = Sketch::on_paper();
    work(&mut sketch);
    turret(&mut sketch);
    sketch.figure(
        "sketch",
        Figure::HEIGHT,
        t(
            "Qué es cada símbolo: plato, bruto, orígenes y torreta, sin escala",
            "What the symbols are: chuck, stock, zeros and turret, not to scale",
        ),
    )
}

/// Chuck, stock and tailstock.
fn work(sketch: &mut Sketch) {
    sketch.rectangle(Ink::Thin, [0.0, -26.0], [18.0, 26.0]);
    for side in [1.0, -1.0] {
        sketch.rectangle(Ink::Thin, [18.0, 14.0 * side], [32.0, 21.0 * side]);
    }
    sketch.rectangle(Ink::Outline, [23.0, -14.0], [88.0, 14.0]);
    for side in [1.0, -1.0] {
        sketch.line(Ink::Safe, [[23.0, 4.0 * side], [88.0, 4.0 * side]]);
    }
    sketch.shape(Ink::Thin, [[88.0, 0.0], [96.0, 5.0], [104.0, 5.0], [104.0, -5.0], [96.0, -5.0]]);
    sketch.line(Ink::Centre, [[-4.0, 0.0], [130.0, 0.0]]);
    sketch.line(Ink::Centre, [[82.0, -18.0], [82.0, 18.0]]);
    sketch.line(Ink::Outline, [[0.0, -30.0], [0.0, 30.0]]);
    sketch.word([-3.5, 3.0], t("M", "M"));
    sketch.word([77.0, 17.5], t("W1", "W1"));
    sketch.word([100.0, -9.0], t("tailstock", "tailstock"));
    sketch.dimension([0.0, -26.0], [0.0, 26.0], 7.0, "D_c");
    sketch.dimension([0.0, 26.0], [18.0, 26.0], 6.0, "L1");
    sketch.dimension([18.0, 21.0], [32.0, 21.0], 11.0, "L2");
    sketch.dimension([23.0, -14.0], [32.0, -14.0], -15.0, "L4");
    sketch.dimension([23.0, -14.0], [88.0, -14.0], -25.0, "L");
    sketch.dimension([82.0, -14.0], [88.0, -14.0], -15.0, "L5");
    sketch.dimension([66.0, -14.0], [66.0, 14.0], 0.0, "D");
    sketch.dimension([46.0, -4.0], [46.0, 4.0], 0.0, "d");
}

/// The turret's reference point, and the body about it.
fn turret(sketch: &mut Sketch) {
    let [x, y] = [106.0, 44.0];
    sketch.rectangle(Ink::Thin, [x - 14.0, y - 10.0], [x + 14.0, y + 10.0]);
    for line in [[[x - 2.0, y], [x + 2.0, y]], [[x, y - 2.0], [x, y + 2.0]]] {
        sketch.line(Ink::Outline, line);
    }
    sketch.word([x + 6.5, y - 6.0], t("turret", "turret"));
    sketch.dimension([x - 14.0, y], [x - 14.0, y + 10.0], 4.0, "BX_max");
    sketch.dimension([x - 14.0, y - 10.0], [x - 14.0, y], 4.0, "BX_min");
    sketch.dimension([x - 14.0, y + 10.0], [x, y + 10.0], 4.0, "BZ_min");
    sketch.dimension([x, y + 10.0], [x + 14.0, y + 10.0], 4.0, "BZ_max");
    sketch.line(Ink::Thin, [[x, y], [x, y + 25.0]]);
    sketch.line(Ink::Thin, [[0.0, 30.0], [0.0, y + 25.0]]);
    sketch.dimension([0.0, y + 24.0], [x, y + 24.0], 0.0, "R_Z");
    sketch.line(Ink::Thin, [[x, y], [x + 20.0, y]]);
    sketch.dimension([x + 19.0, 0.0], [x + 19.0, y], -0.1, "⌀ R_X");
}
