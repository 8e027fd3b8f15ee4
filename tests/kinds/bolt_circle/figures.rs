//! The drawings: the holes from above, on the set-up page and before their table.

use rodete::figure::{Figure, Ink, Side, Sketch, sized};
use rodete::text::{Text, t};

use crate::design::BoltCircle;

/// The set-up page names its sketches by their keys, `setup` and `setup-side`; a table's figure is named in `labels.typ`.
pub fn figures(circle: &BoltCircle) -> Vec<Figure> {
    let caption = t("Los agujeros, vistos desde arriba", "The holes, seen from above");
    let of = |key| seen(circle).figure(key, Figure::HEIGHT, caption.clone());
    vec![of("setup"), of("circle")]
}

fn seen(circle: &BoltCircle) -> Sketch {
    let R = circle.D / 2.0;
    let reach = R + circle.d;
    let mut sketch = Sketch::new([2.0 * reach; 2], [Figure::HEIGHT - 16.0; 2]);
    sketch.ring(Ink::Centre, [0.0, 0.0], R);
    for hole in 0..circle.N {
        sketch.ring(Ink::Outline, circle.at(hole), circle.d / 2.0);
    }
    sketch.label(circle.at(0), Side::Right, Text::same("1"));
    sketch.arrow(Ink::Axis(0), [[0.0, 0.0], [R / 2.0, 0.0]]);
    sketch.label([R / 2.0, 0.0], Side::Right, Text::same("+X"));
    sketch.zero([0.0, 0.0]);
    sketch.level([-R, 0.0], [R, 0.0], -reach - sketch.paper(4.0), sized("D", circle.D));
    sketch
}
