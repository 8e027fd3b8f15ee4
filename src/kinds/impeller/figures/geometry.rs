//! Drawings of the part's geometry: the circle on the torus, the blades in plan, the frame, the paths about a blade.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use super::{FINE, arrow, label, line, sampled, steps, t};
use crate::figure::{Figure, Ink, Label, Stroke};
use crate::geometry::scene::Camera;
use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::bodies::{Bodies, Body, Steps, about_axis};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::splitter::{Splitter, plan_paths};
use crate::kinds::impeller::tool_path::part_path;
use crate::number::trig::sin_cos;
use crate::text::Text;

/// Steps of the tops of blades in plan.
const TOPS: Steps = Steps { along: 96, deep: 1, across: 12 };

fn round(radius: f64) -> Vec<[f64; 2]> {
    steps(0.0, TAU, 180)
        .map(|angle| {
            let (sin, cos) = sin_cos(angle);
            [radius * cos, radius * sin]
        })
        .collect()
}

/// The lines of a torus that are seen from in front, within ranges of u and v.
fn wire(
    strokes: &mut Vec<Stroke>,
    camera: &Camera,
    torus: Torus,
    u: [f64; 2],
    v: [f64; 2],
    counts: [u16; 2],
    hollow: bool,
) {
    let side = if hollow { 1.0 } else { -1.0 };
    let mut draw = |points: Vec<(f64, f64)>| {
        // A line is broken where it passes behind.
        let mut run: Vec<[f64; 2]> = Vec::new();
        for (u, v) in points {
            if camera.faces(&(Torus::inward_normal(u, v) * side)) {
                run.push(camera.see(&torus.point(u, v)));
            } else if !run.is_empty() {
                strokes.push(line(Ink::Thin, std::mem::take(&mut run)));
            }
        }
        if run.len() > 1 {
            strokes.push(line(Ink::Thin, run));
        }
    };
    for meridian in steps(u[0], u[1], counts[0]) {
        draw(steps(v[0], v[1], 72).map(|v| (meridian, v)).collect());
    }
    for parallel in steps(v[0], v[1], counts[1]) {
        draw(steps(u[0], u[1], 144).map(|u| (u, parallel)).collect());
    }
}

/// The torus with its Villarceau circle; the quarter in use is the mean line.
pub(super) fn villarceau(blade: &Blade) -> Figure {
    let circle = blade.circle;
    let torus = circle.torus;
    let camera = Camera::new(-62.0, 38.0);
    let mut strokes = Vec::new();
    wire(&mut strokes, &camera, torus, [0.0, TAU], [0.0, TAU], [48, 20], false);
    let axis = [Vector3::new(0.0, 0.0, -1.6 * torus.r), Vector3::new(0.0, 0.0, 1.9 * torus.r)];
    strokes.push(camera.curve(Ink::Centre, axis));
    let on_circle = |v: f64| torus.point(circle.u(v), v);
    strokes.push(camera.curve(Ink::Blade, steps(0.0, TAU, 180).map(on_circle)));
    strokes.push(camera.curve(Ink::Obverse, steps(PI, PI + FRAC_PI_2, 60).map(on_circle)));
    let at = -FRAC_PI_2;
    let (sin, cos) = sin_cos(at);
    let centre = Vector3::new(torus.R * cos, torus.R * sin, 0.0);
    strokes.push(camera.curve(Ink::Outline, steps(0.0, TAU, 90).map(|v| torus.point(at, v))));
    let (origin, foot) = (camera.see(&Vector3::zeros()), camera.see(&centre));
    strokes.push(arrow(Ink::Outline, origin, foot));
    let rim = camera.see(&torus.point(at, -0.5));
    strokes.push(arrow(Ink::Outline, foot, rim));
    let middle = |a: [f64; 2], b: [f64; 2], lift: f64| [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0 + lift];
    Figure {
        letters: Figure::LETTERS,
        key: "villarceau",
        height: 56.0,
        caption: t(
            "El toro y su círculo de Villarceau; el cuarto en uso es la fibra media de un álabe",
            "The torus and its Villarceau circle; the quarter in use is the mean line of a blade",
        ),
        axes: None,
        strokes,
        labels: vec![
            label(middle(origin, foot, 0.08 * torus.r), Text::same("R")),
            label(middle(foot, rim, 0.1 * torus.r), Text::same("r")),
            label(camera.see(&Vector3::new(0.0, 0.0, 2.05 * torus.r)), Text::same("Z")),
        ],
        legend: vec![
            (Ink::Blade, t("círculo de Villarceau", "Villarceau circle")),
            (Ink::Obverse, t("fibra media, v de π a 3π/2", "mean line, v from π to 3π/2")),
        ],
    }
}

/// All blades in plan, with the splitters: their tops, as the blank cuts them off.
pub(super) fn plan(design: &Design, blade: &Blade, splitter: Option<&Splitter>, plan: Option<&Plan>) -> Figure {
    let torus = design.torus;
    let inner = torus.R - torus.r;
    let bodies = Bodies::new(design, blade, splitter, plan, TOPS);
    let mut strokes = vec![line(Ink::Outline, round(torus.R)), line(Ink::Outline, round(inner))];
    let mut top = |ink: Ink, body: &Body, turn: f64| {
        let outline: Vec<[f64; 2]> =
            body.outlines[0].iter().map(|point| about_axis(point, turn)).map(|at| [at.x, at.y]).collect();
        strokes.push(Stroke { filled: true, ..line(ink, outline.clone()) });
        strokes.push(line(ink, outline));
    };
    for number in 0..design.N {
        let turn = TAU * f64::from(number) / f64::from(design.N);
        top(Ink::Blade, &bodies.blade, turn);
        if let Some(splitter) = &bodies.splitter {
            top(Ink::Splitter, splitter, turn);
        }
    }
    let middle: Vec<[f64; 2]> =
        sampled(blade.points(), FINE).filter_map(|at| blade.P.get(at)).map(|P| [P.x, P.y]).collect();
    strokes.push(line(Ink::Centre, middle));
    strokes.push(line(Ink::Centre, vec![[-1.12 * torus.R, 0.0], [1.12 * torus.R, 0.0]]));
    strokes.push(line(Ink::Centre, vec![[0.0, -1.12 * torus.R], [0.0, 1.12 * torus.R]]));
    let mut legend =
        vec![(Ink::Blade, t("álabes", "blades")), (Ink::Centre, t("fibra media, ejes", "mean line, axes"))];
    if bodies.splitter.is_some() {
        legend.insert(1, (Ink::Splitter, t("álabes intermedios", "splitters")));
    }
    Figure {
        letters: Figure::LETTERS,
        key: "plan",
        height: 104.0,
        caption: t("Los álabes en planta", "The blades in plan"),
        axes: None,
        strokes,
        labels: vec![label([1.17 * torus.R, 0.0], Text::same("x")), label([0.0, 1.15 * torus.R], Text::same("y"))],
        legend,
    }
}

/// The channel's surface with a mean line.
fn channel(blade: &Blade, camera: &Camera) -> Vec<Stroke> {
    let torus = blade.circle.torus;
    let mut strokes = Vec::new();
    wire(&mut strokes, camera, torus, [0.0, TAU], [PI, PI + FRAC_PI_2], [48, 8], true);
    for v in [PI, PI + FRAC_PI_2] {
        strokes.push(camera.curve(Ink::Outline, steps(0.0, TAU, 144).map(|u| torus.point(u, v))));
    }
    let points = sampled(blade.points(), FINE).filter_map(|at| blade.P.get(at).copied());
    strokes.push(camera.curve(Ink::Blade, points));
    strokes
}

/// The Darboux frame at five points of the mean line.
pub(super) fn frame(blade: &Blade) -> Figure {
    let camera = Camera::new(150.0, 34.0);
    let mut strokes = channel(blade, &camera);
    let mut labels: Vec<Label> = Vec::new();
    let length = 0.36 * blade.circle.torus.R;
    for (number, at) in sampled(blade.points(), 4).enumerate() {
        let (Some(P), Some(t), Some(N), Some(b)) = (blade.P.get(at), blade.t.get(at), blade.N.get(at), blade.b.get(at))
        else {
            continue;
        };
        for (axis, (vector, name)) in [(t, "t"), (N, "N"), (b, "b")].into_iter().enumerate() {
            let tip = P + vector * length;
            let ink = Ink::Axis(u8::try_from(axis).unwrap_or(0));
            strokes.push(arrow(ink, camera.see(P), camera.see(&tip)));
            if number == 2 {
                labels.push(label(camera.see(&(P + vector * (length * 1.14))), Text::same(name)));
            }
        }
    }
    Figure {
        letters: Figure::LETTERS,
        key: "frame",
        height: 82.0,
        caption: t("El triedro de Darboux a lo largo de la fibra media", "The Darboux frame along the mean line"),
        axes: None,
        strokes,
        labels,
        legend: vec![
            (Ink::Axis(0), t("t, tangente", "t, tangent")),
            (Ink::Axis(1), t("N, normal", "N, normal")),
            (Ink::Axis(2), t("b = t × N", "b = t × N")),
        ],
    }
}

/// Both tool paths about a blade, with the tool's axis at some points, in the part frame.
pub(super) fn tool_paths(design: &Design, blade: &Blade) -> Figure {
    let camera = Camera::new(150.0, 34.0);
    let mut strokes = channel(blade, &camera);
    let shank = 0.45 * design.torus.R;
    for (ink, w) in [(Ink::Obverse, design.w()), (Ink::Reverse, -design.w())] {
        let path = part_path(blade, w, design.a_p);
        for at in sampled(path.len(), 20) {
            if let (Some(tip), Some(N)) = (path.get(at), blade.N.get(at)) {
                strokes.push(camera.curve(Ink::Thin, [*tip, tip + N * shank]));
            }
        }
        strokes.push(camera.curve(ink, sampled(path.len(), FINE).filter_map(|at| path.get(at).copied())));
    }
    Figure {
        letters: Figure::LETTERS,
        key: "tool-path",
        height: 92.0,
        caption: t(
            "Trayectorias de la punta a ambos lados de un álabe, sobre la pieza; en gris, el eje de la herramienta",
            "Paths of the tool tip on both sides of a blade, on the part; in grey, the tool's axis",
        ),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: vec![
            (Ink::Blade, t("fibra media", "mean line")),
            (Ink::Obverse, t("anverso", "obverse")),
            (Ink::Reverse, t("reverso", "reverse")),
        ],
    }
}

/// Where the splitter's path crosses its neighbour's, in plan.
pub(super) fn crossing(design: &Design, blade: &Blade, splitter: &Splitter) -> Figure {
    let [own, neighbour] = plan_paths(blade, design.N, design.w(), design.a_p);
    let curve = |ink, points: &[nalgebra::Vector2<f64>]| {
        line(ink, sampled(points.len(), FINE).filter_map(|at| points.get(at)).map(|point| [point.x, point.y]).collect())
    };
    let at = [splitter.crossing.at.x, splitter.crossing.at.y];
    let Splitter { out, back, .. } = splitter;
    let size = 0.035 * design.torus.R;
    let mark: Vec<[f64; 2]> = round(size).into_iter().map(|[x, y]| [x + at[0], y + at[1]]).collect();
    Figure {
        letters: Figure::LETTERS,
        key: "crossing",
        height: 92.0,
        caption: match splitter.fade {
            Fade::Published => Text::new(
                format!("Cruce de las trayectorias en planta, en el índice {:.2}; m = {}", back.crossing, back.m),
                format!("Crossing of the paths in plan, at the index {:.2}; m = {}", back.crossing, back.m),
            ),
            Fade::EachSide => Text::new(
                format!(
                    "Cruce de las trayectorias en planta: índice {:.2} de la vecina y {:.2} de la propia; m_1 = {}, m_2 = {}",
                    out.crossing, back.crossing, out.m, back.m
                ),
                format!(
                    "Crossing of the paths in plan: index {:.2} of the neighbour's and {:.2} of its own; m_1 = {}, m_2 = {}",
                    out.crossing, back.crossing, out.m, back.m
                ),
            ),
        },
        axes: None,
        strokes: vec![
            line(Ink::Thin, round(design.torus.R)),
            line(Ink::Thin, round(design.torus.R - design.torus.r)),
            curve(Ink::Obverse, &own),
            curve(Ink::Reverse, &neighbour),
            line(Ink::Outline, mark),
        ],
        labels: Vec::new(),
        legend: vec![
            (Ink::Obverse, t("anverso del álabe", "obverse of the blade")),
            (Ink::Reverse, t("reverso del vecino", "reverse of its neighbour")),
        ],
    }
}
