//! The drawings of a hole: the header with it, the angles and heights round it, how far the beam leaves it, and the
//! template.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::figure::{Axes, Figure, Ink, Label, Side, Sketch, Stroke, sized};
use crate::geometry::scene::{Camera, Scene};
use crate::kinds::pipe::hole::design::Design;
use crate::kinds::pipe::hole::station::Station;
use crate::kinds::pipe::sketch;
use crate::number::shown;
use crate::number::trig::{atan2, sin_cos};
use crate::text::{Text, t};

/// Places round the hole that are drawn.
const FINE: u16 = 360;

fn round(design: &Design) -> Vec<Station> {
    let groove = design.groove();
    (0..=FINE).filter_map(|at| groove.at(TAU * f64::from(at) / f64::from(FINE))).collect()
}

/// All figures, by the keys that the report's templates know. `deviation` has α in degrees and mm.
#[must_use]
pub fn figures(design: &Design, deviation: &[[f64; 2]]) -> Vec<Figure> {
    let stations = round(design);
    vec![
        cover(design, &stations),
        angles(&stations),
        heights(design, &stations),
        left(deviation),
        on_rotary(design, &stations),
        turned(design, &stations),
    ]
}

/// The set-up from the side, at A = 0: zeros, hole, branch, and the torch at the height of its rapid moves.
fn on_rotary(design: &Design, stations: &[Station]) -> Figure {
    let (R, Z_s) = (design.R_o(), design.Z_s);
    let reach = stations.iter().map(|one| one.face.x.abs()).fold(0.0, f64::max) + 0.8 * R;
    let mut sketch = Sketch::new([2.0 * reach, 2.0 * R + Z_s], [92.0, sketch::HEIGHT - 24.0]);
    let (gap, long) = (sketch.paper(3.0), sketch.paper(9.0));
    sketch::pipe(&mut sketch, design.header.D, [-reach, reach]);
    let edge: Vec<[f64; 2]> = stations.iter().map(|one| [one.face.x, one.face.z]).collect();
    sketch.shape(Ink::Obverse, edge);
    // The axis of the branch leans to the right where θ is less than 90°.
    let (sin, cos) = sin_cos(design.theta.to_radians());
    let top = (R + Z_s + sketch.paper(4.0)) / sin;
    sketch.line(Ink::Centre, [[0.0, 0.0], [top * cos, top * sin]]);
    let about = 0.5 * R;
    sketch.turn(Ink::Outline, [0.0, 0.0], about, [0.0, design.theta]);
    let (sin, cos) = sin_cos((design.theta / 2.0).to_radians());
    sketch.label([about * cos, about * sin], Side::Right, Text::same(format!("θ = {}°", shown(design.theta, 3))));
    sketch::torch(&mut sketch, [0.0, R + Z_s]);
    sketch.zero([0.0, 0.0]);
    sketch.label([0.0, -gap / 2.0], Side::Below, Text::same("X0 Z0"));
    sketch.arrow(Ink::Axis(0), [[reach - long, -R - gap], [reach, -R - gap]]);
    sketch.label([reach, -R - gap], Side::Right, Text::same("+X"));
    let beyond = reach + sketch.paper(7.0);
    sketch.upright([reach, -R], [reach, R], beyond, Side::Right, sized("D", design.header.D));
    sketch.upright([reach, R], [sketch.paper(3.0), R + Z_s], beyond, Side::Right, sized("Z_s", Z_s));
    sketch.figure(
        "setup",
        sketch::HEIGHT,
        sketch::held(&t(
            "Tubo en el eje giratorio, A = 0°, B = 0° y C = 0°",
            "Pipe on the rotary axis, A = 0°, B = 0° and C = 0°",
        )),
    )
}

/// The same along the pipe's axis.
fn turned(design: &Design, stations: &[Station]) -> Figure {
    let edge = stations.iter().map(|one| [one.face.y, one.face.z]).collect();
    sketch::end(design.header.D, design.header.t, Text::same("A = 0"), edge)
}

/// The header with the hole in it: the groove's face, and the torch at a few places.
fn cover(design: &Design, stations: &[Station]) -> Figure {
    let R = design.R_o();
    let camera = Camera::new(-62.0, 40.0);
    let mut scene = Scene::new(camera);
    let reach = stations.iter().map(|one| one.face.x.abs()).fold(0.0, f64::max) + 0.9 * R;
    let point = |angle: f64, x: f64| {
        let (sin, cos) = sin_cos(angle);
        Vector3::new(x, R * sin, R * cos)
    };
    // A face counts as cut out where its middle lies inside of the hole's edge.
    let edge: Vec<[f64; 2]> = stations.iter().map(|one| [atan2(one.face.y, one.face.z), one.face.x]).collect();
    let inside = |angle: f64, x: f64| {
        let mut odd = false;
        for pair in edge.windows(2) {
            let ([a0, x0], [a1, x1]) = (pair[0], pair[1]);
            if (a0 > angle) != (a1 > angle) && x < x0 + (x1 - x0) * (angle - a0) / (a1 - a0) {
                odd = !odd;
            }
        }
        odd
    };
    let (about, along) = (144_u16, 72_u16);
    for i in 0..about {
        let angle = |i: u16| TAU * (f64::from(i) / f64::from(about) - 0.5);
        for j in 0..along {
            let x = |j: u16| reach * (2.0 * f64::from(j) / f64::from(along) - 1.0);
            let (a0, a1, x0, x1) = (angle(i), angle(i + 1), x(j), x(j + 1));
            if inside(f64::midpoint(a0, a1), f64::midpoint(x0, x1)) {
                continue;
            }
            let corners = [point(a0, x0), point(a0, x1), point(a1, x1), point(a1, x0)];
            let edges: &[usize] = match j {
                0 => &[3],
                _ if j + 1 == along => &[1],
                _ => &[],
            };
            scene.add(&corners, edges, Ink::Outline, 0.0);
        }
    }
    let mut rim: Vec<Vector3<f64>> = (0..about).map(|i| point(TAU * f64::from(i) / f64::from(about), reach)).collect();
    rim.reverse();
    scene.add(&rim, &[], Ink::Outline, 0.0);
    let mut strokes = scene.strokes();
    let curve = |of: fn(&Station) -> Vector3<f64>| stations.iter().map(of).collect::<Vec<_>>();
    strokes.push(camera.curve(Ink::Reverse, curve(|one| one.root)));
    strokes.push(camera.curve(Ink::Obverse, curve(|one| one.face)));
    for one in stations.iter().step_by(usize::from(FINE / 12)) {
        strokes.push(camera.curve(Ink::Safe, [one.root, one.pose.tip + one.pose.axis * (0.5 * R)]));
    }
    Figure {
        letters: Figure::LETTERS,
        key: "cover",
        height: 118.0,
        caption: t(
            "El agujero: borde exterior, raíz y eje de la antorcha",
            "The hole: outer edge, root, and the torch's axis",
        ),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: vec![
            (Ink::Obverse, t("borde exterior", "outer edge")),
            (Ink::Reverse, t("raíz", "root")),
            (Ink::Safe, t("eje de la antorcha", "axis of the torch")),
        ],
    }
}

fn over_alpha(stations: &[Station], value: impl Fn(&Station) -> f64) -> Vec<[f64; 2]> {
    stations.iter().map(|one| [one.alpha.to_degrees(), value(one)]).collect()
}

fn angles(stations: &[Station]) -> Figure {
    Figure {
        letters: Figure::LETTERS,
        key: "angles",
        height: Figure::HEIGHT,
        caption: t("Ángulos alrededor del agujero", "Angles round the hole"),
        axes: Some(Axes { x: t("α (°)", "α (°)"), y: t("ángulo (°)", "angle (°)") }),
        strokes: vec![
            Stroke::line(Ink::Blade, over_alpha(stations, |one| one.phi.to_degrees())),
            Stroke::line(Ink::Obverse, over_alpha(stations, |one| one.sigma.to_degrees())),
            Stroke::line(Ink::Reverse, over_alpha(stations, |one| one.sigma_o.to_degrees())),
        ],
        labels: Vec::new(),
        legend: vec![(Ink::Blade, Text::same("φ")), (Ink::Obverse, Text::same("σ")), (Ink::Reverse, Text::same("σ_o"))],
    }
}

fn heights(design: &Design, stations: &[Station]) -> Figure {
    let level = |value: f64| vec![[0.0, value], [360.0, value]];
    Figure {
        letters: Figure::LETTERS,
        key: "heights",
        height: Figure::HEIGHT,
        caption: t("Altura y distancia alrededor del agujero", "Height and distance round the hole"),
        axes: Some(Axes { x: t("α (°)", "α (°)"), y: t("mm", "mm") }),
        strokes: vec![
            Stroke::line(Ink::Safe, level(design.g0)),
            Stroke::line(Ink::Blade, over_alpha(stations, |one| one.D)),
            Stroke::line(Ink::Reverse, over_alpha(stations, |one| one.gap)),
        ],
        labels: Vec::new(),
        legend: vec![
            (Ink::Blade, t("D, altura", "D, height")),
            (Ink::Reverse, t("g, distancia", "g, distance")),
            (Ink::Safe, t("g0", "g0")),
        ],
    }
}

fn left(deviation: &[[f64; 2]]) -> Figure {
    Figure {
        letters: Figure::LETTERS,
        key: "deviation",
        height: Figure::HEIGHT,
        caption: t(
            "Distancia del chorro, leído del programa, a la raíz exacta",
            "Distance of the beam, read back from the program, from the exact root",
        ),
        axes: Some(Axes { x: t("α (°)", "α (°)"), y: t("desviación (µm)", "deviation (µm)") }),
        strokes: vec![Stroke::line(Ink::Blade, deviation.iter().map(|&[alpha, off]| [alpha, off * 1000.0]).collect())],
        labels: Vec::new(),
        legend: Vec::new(),
    }
}

/// The template at 1:1, to be laid round the header, printed face outwards: the hole's outer edge as finished, with the
/// header's top generator along it and the line across it through the foot of the branch's axis. A branch with θ < 90° leans
/// to the right.
#[must_use]
pub fn template(design: &Design) -> Figure {
    let R = design.R_o();
    // The edge of the groove as finished, without the kerf.
    let bare = crate::kinds::pipe::hole::station::Groove { beside: 0.0, ..design.groove() };
    let edge: Vec<[f64; 2]> = (0..=4 * FINE)
        .filter_map(|at| bare.at(TAU * f64::from(at) / f64::from(4 * FINE)))
        .map(|one| [one.face.x, R * atan2(one.face.y, one.face.z)])
        .collect();
    let most = |axis: usize| edge.iter().map(|point| point[axis].abs()).fold(0.0, f64::max) + 15.0;
    let (width, height) = (most(0), most(1));
    Figure {
        letters: Figure::LETTERS,
        key: "template",
        height: Figure::HEIGHT,
        caption: t("Plantilla del agujero sobre el exterior del tubo", "Template of the hole on the pipe's outside"),
        axes: None,
        strokes: vec![
            Stroke::line(Ink::Seam, vec![[-width, 0.0], [width, 0.0]]),
            Stroke::line(Ink::Thin, vec![[0.0, -height], [0.0, height]]),
            Stroke::line(Ink::Cut, edge),
        ],
        labels: vec![
            Label { at: [width + 20.0, -1.0], text: t("+X, generatriz superior", "+X, top generator") },
            Label { at: [0.0, height + 2.0], text: Text::same("x = 0") },
        ],
        legend: vec![(Ink::Cut, t("corte", "cut")), (Ink::Seam, t("generatriz", "generator"))],
    }
}
