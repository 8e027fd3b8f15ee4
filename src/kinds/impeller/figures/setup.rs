//! The sketches of the set-up: the part on the nose of the work spindle, from the side and from above.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;

use super::{FINE, sampled, steps, t};
use crate::figure::{Figure, Ink, Side, Sketch, sized};
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::design::Design;
use crate::machine::rotary::TiltingTable;
use crate::number::shown;
use crate::number::trig::{atan2, sin_cos};
use crate::text::Text;

/// The printed height of each sketch, mm.
const HEIGHT: f64 = 74.0;

/// The half section of the turned blank, `[x, z]` on the side of +X, from the axis down to `foot`.
fn profile(design: &Design, foot: f64) -> Vec<[f64; 2]> {
    let torus = design.torus;
    let arc = steps(PI, PI + FRAC_PI_2, 40).map(|v| {
        let (sin, cos) = sin_cos(v);
        [torus.R + torus.r * cos, torus.r * sin]
    });
    std::iter::once([0.0, 0.0]).chain(arc).chain([[torus.R, foot], [0.0, foot]]).collect()
}

/// Side view: axis B, spindle nose, turned face, and the tool on the part zero, at B = 0 and C = 0.
pub(super) fn side(design: &Design) -> Figure {
    let (R, L, H) = (design.torus.R, design.machine.L, design.H);
    let tool = 0.18 * (L + R);
    let mut sketch = Sketch::new([2.0 * R, L + tool], [40.0, HEIGHT - 16.0]);
    let mm = |value: f64| sketch.paper(value);
    // The dimensions stand beyond the arrow of X and its name.
    let (column, wide) = (R + mm(21.0), 0.6 * R);
    // The arrow of X runs above the extension line of H.
    let (ring, long, gap, over) = (mm(1.6), mm(9.0), mm(3.0), mm(3.5));
    let stock = -design.blank.L_b.max(design.torus.r);
    // The spindle, from the B axis up to its nose, and the fixture.
    sketch.rectangle(Ink::Thin, [-wide, -L], [wide, -H]);
    let foot = stock.max(-H);
    if foot > -H {
        sketch.rectangle(Ink::Safe, [-0.7 * wide, -H], [0.7 * wide, foot]);
        sketch.label([-0.7 * wide, f64::midpoint(-H, foot)], Side::Left, t("amarre", "fixture"));
    }
    sketch.line(Ink::Cut, [[-R, -H], [R, -H]]);
    let right = profile(design, foot);
    let whole: Vec<[f64; 2]> = right.iter().copied().chain(right.iter().rev().map(|[x, z]| [-x, *z])).collect();
    sketch.shape(Ink::Outline, whole);
    // The tool on the zero.
    let half = design.d_t / 2.0;
    sketch.rectangle(Ink::Safe, [-half, 0.0], [half, tool]);
    sketch.line(Ink::Centre, [[0.0, -L - long / 2.0], [0.0, tool + gap]]);
    let side = (0.45 * R).max(half + gap);
    sketch.label(
        [half, 0.8 * tool],
        Side::Right,
        Text::same(format!("T{} · d_t = {}", design.T, shown(design.d_t, 3))),
    );
    sketch.zero([0.0, 0.0]);
    sketch.arrow(Ink::Axis(0), [[R + gap, over], [R + gap + long, over]]);
    sketch.label([R + gap + long, over], Side::Right, Text::same("+X"));
    sketch.arrow(Ink::Axis(2), [[-side, gap], [-side, gap + long]]);
    sketch.label([-side, gap + long], Side::Left, Text::same("+Z"));
    // The B axis, and the direction in which +B tilts the part.
    sketch.ring(Ink::Outline, [0.0, -L], ring);
    let tilted = TiltingTable::direction_to_machine(&Vector3::z(), 0.5, 0.0);
    let angle = atan2(tilted.z, tilted.x).to_degrees();
    let about = 0.55 * (L - H).max(0.2 * L);
    sketch.turn(Ink::Axis(1), [0.0, -L], about, [90.0, angle]);
    let (sin, cos) = sin_cos(angle.to_radians());
    let named = if cos < 0.0 { Side::Left } else { Side::Right };
    sketch.label([about * cos, -L + about * sin], named, Text::same("+B"));
    sketch.label([-wide, -L], Side::Left, t("eje B", "B axis"));
    sketch.label([-R, -H], Side::Left, t("nariz del husillo", "spindle nose"));
    sketch.upright([R, 0.0], [R, -H], column, Side::Right, sized("H", H));
    sketch.upright([R, -H], [ring, -L], column, Side::Right, sized("R_B", design.R_B));
    let beyond = column + sketch.paper(27.0);
    sketch.upright([column, 0.0], [column, -L], beyond, Side::Right, sized("L", L));
    sketch.figure(
        "setup",
        HEIGHT,
        t("Pieza en la nariz del husillo, B = 0° y C = 0°", "Part on the spindle nose, B = 0° and C = 0°"),
    )
}

/// Top view: the direction of C = 0, and the start of the first blade.
pub(super) fn above(design: &Design, blade: &Blade) -> Figure {
    let (R, r) = (design.torus.R, design.torus.r);
    let mut sketch = Sketch::new([2.0 * R, 2.0 * R], [44.0, HEIGHT - 26.0]);
    let (gap, long) = (sketch.paper(2.0), sketch.paper(10.0));
    let flat: Vec<[f64; 2]> =
        sampled(blade.points(), FINE).filter_map(|at| blade.P.get(at)).map(|P| [P.x, P.y]).collect();
    sketch.ring(Ink::Outline, [0.0, 0.0], R);
    sketch.ring(Ink::Thin, [0.0, 0.0], R - r);
    for number in 1..design.N {
        let (sin, cos) = sin_cos(f64::from(number) * 2.0 * PI / f64::from(design.N));
        sketch.line(Ink::Thin, flat.iter().map(|[x, y]| [x * cos - y * sin, x * sin + y * cos]).collect::<Vec<_>>());
    }
    sketch.line(Ink::Blade, flat.clone());
    sketch.line(Ink::Centre, [[0.0, -R - gap], [0.0, R + gap]]);
    sketch.line(Ink::Centre, [[-R - gap, 0.0], [0.0, 0.0]]);
    sketch.arrow(Ink::Axis(0), [[0.0, 0.0], [R + long, 0.0]]);
    sketch.label([R + long, 0.0], Side::Right, Text::same("C = 0°: +X"));
    sketch.arrow(Ink::Axis(1), [[0.0, R + gap], [0.0, R + gap + long * 0.6]]);
    sketch.label([0.0, R + gap + long * 0.5], Side::Right, Text::same("+Y"));
    // The start of the first blade, and its angle from C = 0.
    if let Some(&[x, y]) = flat.first() {
        let angle = atan2(y, x).to_degrees();
        let reach = R * 0.55;
        sketch.line(Ink::Thin, [[0.0, 0.0], [x, y]]);
        sketch.turn(Ink::Outline, [0.0, 0.0], reach, [0.0, angle]);
        let (sin, cos) = sin_cos((angle / 2.0).to_radians());
        let side = if cos < 0.0 { Side::Left } else { Side::Right };
        let text = format!("{}°", shown(angle, 2));
        sketch.label([reach * cos, reach * sin], side, Text::same(text));
    }
    // The direction in which +C turns the part, clear of the lines below it.
    let turned = TiltingTable::direction_to_machine(&Vector3::x(), 0.0, 0.6);
    let by = atan2(turned.y, turned.x).to_degrees();
    sketch.turn(Ink::Axis(2), [0.0, 0.0], R + 1.6 * gap, [160.0, 160.0 + by]);
    let (sin, cos) = sin_cos((160.0 + by / 2.0).to_radians());
    let at = R + 2.0 * gap;
    sketch.label([at * cos, at * sin], Side::Left, t("+C gira la pieza", "+C turns the part"));
    sketch.zero([0.0, 0.0]);
    sketch.level([-R, 0.0], [R, 0.0], -R - sketch.paper(8.0), sized("2·R", 2.0 * R));
    sketch.figure(
        "setup-side",
        HEIGHT,
        t("Desde arriba; en trazo grueso, el primer álabe", "From above; the heavy line is the first blade"),
    )
}
