//! The sketch of a set-up: the stock in the chuck with machine zero, part zero and the lengths that a machinist measures.

use super::drawn::Drawn;
use crate::figure::{Figure, Ink, Side, Sketch, sized};
use crate::removal::turning::simulation::Setup;
use crate::text::{Text, t};

/// The printed height, mm.
const HEIGHT: f64 = 72.0;

/// Where a set-up holds the part; mm along Z from W1.
#[derive(Clone, Copy, Debug)]
pub struct Clamping {
    /// Machine zero M.
    pub machine: f64,
    /// The face of the jaws.
    pub jaws: f64,
    /// The turret is behind the axis: +X points up.
    pub behind: bool,
    /// The stock of the form, so its lengths have the form's symbols; false for a part that was turned round.
    pub first: bool,
}

impl Clamping {
    /// How a set-up holds its part.
    #[must_use]
    pub fn of(setup: &Setup) -> Self {
        Self {
            machine: -setup.stock.zero(&setup.lathe),
            jaws: setup.stock.held(&setup.lathe)[1],
            behind: setup.lathe.x_up(),
            first: setup.part.is_none(),
        }
    }
}

/// The caption of a figure with only that of the chuck which is near the part.
#[must_use]
pub fn chuck_cut_off(caption: &Text) -> Text {
    let Text { es, en } = caption;
    Text::new(
        format!("{es}; el plato y las garras siguen más allá del dibujo"),
        format!("{en}; chuck and jaws reach farther out than drawn"),
    )
}

/// The sketch of one set-up; `None` if there is nothing to hold.
#[must_use]
pub fn sketch(drawn: &Drawn, clamping: Clamping, key: &'static str) -> Option<Figure> {
    let points = || drawn.stock.iter().flatten();
    points().next()?;
    let most = |axis: usize| points().map(|point| point[axis]).fold(f64::NEG_INFINITY, f64::max);
    let (right, radius) = (most(0), most(1));
    let left = points().map(|point| point[0]).fold(f64::INFINITY, f64::min);
    // Only the bodies of chuck and tailstock near the part.
    let high = 1.5 * radius;
    let reach = drawn.chuck.iter().flatten().map(|point| point[0]).fold(right, f64::max).min(right + 1.2 * radius);
    let mut sketch = Sketch::new([reach - clamping.machine, 2.0 * high], [118.0, HEIGHT - 38.0]);
    let (gap, long) = (sketch.paper(2.0), sketch.paper(10.0));
    for ring in &drawn.chuck {
        let near: Vec<[f64; 2]> = ring.iter().map(|&[z, r]| [z.min(reach), r.clamp(-high, high)]).collect();
        sketch.shape(Ink::Thin, near);
    }
    for ring in &drawn.stock {
        sketch.shape(Ink::Outline, ring.as_slice());
        sketch.shape(Ink::Outline, ring.iter().map(|&[z, r]| [z, -r]).collect::<Vec<_>>());
    }
    sketch.line(Ink::Centre, [[clamping.machine - long, 0.0], [reach + gap, 0.0]]);
    // M, W1, and the direction of X: towards the turret.
    let up = if clamping.behind { 1.0 } else { -1.0 };
    sketch.zero([clamping.machine, 0.0]);
    sketch.label([clamping.machine, gap], Side::Above, Text::same("M"));
    sketch.zero([0.0, 0.0]);
    // Over the part, or beside it if its face is behind W1.
    if right < -gap {
        sketch.label([0.0, -gap], Side::Below, Text::same("W1"));
    } else {
        sketch.label([-gap / 2.0, sketch.paper(3.2)], Side::Left, Text::same("W1 (G54)"));
    }
    let (axes, beyond) = (reach.max(0.0) + gap, up * (radius + sketch.paper(4.0)));
    sketch.arrow(Ink::Axis(2), [[axes, 0.0], [axes + long, 0.0]]);
    sketch.label([axes + long, 0.0], Side::Right, Text::same("+Z"));
    sketch.arrow(Ink::Axis(0), [[axes, 0.0], [axes, beyond]]);
    let turret = if clamping.behind {
        t("+X, torreta trasera", "+X, rear turret")
    } else {
        t("+X, torreta delantera", "+X, front turret")
    };
    sketch.label([axes, beyond], Side::Right, turret);
    let symbol = |name: &'static str| if clamping.first { name } else { "" };
    // Above: the clamped length, and the stick-out.
    let over = high + sketch.paper(4.0);
    let (facing, clamped, out) = (right, clamping.jaws - left, right - clamping.jaws);
    // The jaws may hold only a part of what is behind their face, if the part was turned round.
    if clamping.first && clamped > 0.0 {
        sketch.level([left, radius], [clamping.jaws, high], over, sized("L4", clamped));
    }
    sketch.level([clamping.jaws, high], [right, radius], over, sized(symbol("L3"), out));
    if facing.abs() > 0.0 {
        let (low, high) = (facing.min(0.0), facing.max(0.0));
        sketch.level([low, radius], [high, radius], over + sketch.paper(7.0), sized(symbol("L5"), high - low));
    }
    // Below: the whole length, and the part zero from M, whose number the extension lines of a shorter one do not cross.
    let under = -high - sketch.paper(7.0);
    sketch.level([left, -radius], [right, -radius], under, sized(symbol("L"), right - left));
    sketch.level(
        [clamping.machine, -high],
        [0.0, -radius],
        under - sketch.paper(7.0),
        sized("Z_W1", -clamping.machine),
    );
    let across = axes + sketch.paper(24.0);
    sketch.upright([right, -radius], [right, radius], across, Side::Right, sized(symbol("D"), 2.0 * radius));
    let caption = if clamping.first {
        t("El bruto en el plato, antes de tornear", "The stock in the chuck, before turning")
    } else {
        t(
            "Segundo amarre: la pieza ya vuelta, antes de tornear",
            "Second set-up: the part turned round, before turning",
        )
    };
    let cut_off = drawn.chuck.iter().flatten().any(|point| point[1].abs() > high);
    Some(sketch.figure(key, HEIGHT, if cut_off { chuck_cut_off(&caption) } else { caption }))
}
