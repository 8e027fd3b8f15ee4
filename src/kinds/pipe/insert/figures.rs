//! The drawings of a branch: both pipes in space, the development, and how far the path leaves the exact curve.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use crate::figure::{Axes, Figure, Ink, Label, Side as Beside, Sketch, Stroke, sized};
use crate::geometry::pipe_pair::{PipePair, Side};
use crate::geometry::pipe_wall::Seat;
use crate::geometry::scene::{Camera, Scene};
use crate::kinds::pipe::insert::cut::{Cut, Follows};
use crate::kinds::pipe::insert::design::{Design, Mode};
use crate::kinds::pipe::sketch;
use crate::number::trig::sin_cos;
use crate::text::{Text, t};

/// Faces about a pipe.
const ABOUT: u16 = 96;
/// Points of a curve that is drawn.
const FINE: u16 = 720;
/// Room for the name of a quarter on the template in mm, at 1:1: its six characters with a gap.
const QUARTER_NAME: f64 = 16.0;

/// All figures, by the keys that the report's templates know. `deviation` has φ in degrees and mm.
#[must_use]
pub fn figures(design: &Design, cut: Option<&Cut>, deviation: &[[f64; 2]]) -> Vec<Figure> {
    let mut figures = vec![pipes(design), development(design, cut), deviation_figure(deviation)];
    match design.mode {
        Mode::Flat => figures.push(sheet(design, cut)),
        Mode::Rotary => figures.extend([on_rotary(design, cut), turned(design)]),
    }
    figures
}

fn turns(count: u16) -> impl Iterator<Item = f64> {
    (0..=count).map(move |at| TAU * f64::from(at) / f64::from(count))
}

/// Both pipes: the header cut off on both sides, the branch above the curve.
fn pipes(design: &Design) -> Figure {
    let outline = design.template();
    // What touches all round is one line of the wall only where the cut follows one: of the envelope the outside is shown.
    let pair = match outline.seat {
        Seat::Edge(pair) => pair,
        Seat::Envelope(wall) => wall.at(design.branch.D / 2.0),
    };
    let down = outline.seat.level() - pair.reach(0.0);
    let depth = |phi: f64| outline.seat.depth(phi) - down;
    let (r, R) = (pair.r, design.R);
    let camera = Camera::new(-62.0, 24.0);
    let mut scene = Scene::new(camera);
    let reach = pair.point(0.0).x.abs().max(pair.point(PI).x.abs()).max(r) + 1.1 * R;
    let angles: Vec<f64> = turns(ABOUT).collect();
    header_pipe(&mut scene, &angles, R, reach);
    // From the curve up to a little above its highest point.
    let top = outline.extent()[0] - design.Z - down - 1.6 * r;
    let parts: Vec<f64> = (0..=12_u16).map(|at| f64::from(at) / 12.0).collect();
    let branch = |phi: f64, part: f64| {
        let depth = depth(phi);
        pair.on_branch(phi, depth + (top - depth) * part)
    };
    for phi in angles.windows(2) {
        for part in parts.windows(2) {
            let corners =
                [branch(phi[0], part[0]), branch(phi[1], part[0]), branch(phi[1], part[1]), branch(phi[0], part[1])];
            let edges: &[usize] = if part[1] == 1.0 { &[2] } else { &[] };
            scene.add(&corners, edges, Ink::Outline, 0.3 * r);
        }
    }
    let rim: Vec<Vector3<f64>> = angles.iter().skip(1).map(|&phi| branch(phi, 1.0)).collect();
    scene.add(&rim, &[], Ink::Outline, 0.3 * r);
    let mut strokes = scene.strokes();
    strokes.extend(seen_curve(&camera, &pair, depth));
    Figure {
        letters: Figure::LETTERS,
        key: "cover",
        height: 118.0,
        caption: t("El injerto sobre el tubo base", "The branch on the header"),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: Vec::new(),
    }
}

/// The header's outside, as far as `reach` mm to both sides, and its ends.
fn header_pipe(scene: &mut Scene, angles: &[f64], R: f64, reach: f64) {
    let header = |phi: f64, x: f64| {
        let (sin, cos) = sin_cos(phi);
        Vector3::new(x, R * sin, R * cos)
    };
    // In short pieces, so that what lies nearer is drawn later.
    let pieces: Vec<f64> = (0..=24_u16).map(|at| reach * (f64::from(at) / 12.0 - 1.0)).collect();
    for pair in angles.windows(2) {
        for along in pieces.windows(2) {
            let corners = [
                header(pair[0], along[0]),
                header(pair[1], along[0]),
                header(pair[1], along[1]),
                header(pair[0], along[1]),
            ];
            let corners = [corners[0], corners[3], corners[2], corners[1]];
            let end = along[0] <= -reach + 1e-9;
            let other = along[1] >= reach - 1e-9;
            let edges: &[usize] = match (end, other) {
                (true, _) => &[3],
                (_, true) => &[1],
                _ => &[],
            };
            scene.add(&corners, edges, Ink::Outline, 0.0);
        }
    }
    for x in [-reach, reach] {
        let mut rim: Vec<Vector3<f64>> = angles.iter().skip(1).map(|&phi| header(phi, x)).collect();
        if x > 0.0 {
            rim.reverse();
        }
        scene.add(&rim, &[], Ink::Outline, 0.0);
    }
}

/// The curve between the pipes where it is seen; `depth` is that of each angle of the branch.
fn seen_curve(camera: &Camera, pair: &PipePair, depth: impl Fn(f64) -> f64) -> Vec<Stroke> {
    // The curve where it is seen: its point's outside of both pipes faces the viewer.
    let (mut strokes, mut run) = (Vec::new(), Vec::<Vector3<f64>>::new());
    for phi in turns(FINE) {
        let point = pair.on_branch(phi, depth(phi));
        let outward = pair.on_branch(phi, 0.0) - pair.on_branch(phi + PI, 0.0);
        let up = Vector3::new(0.0, point.y, point.z);
        if camera.faces(&outward) && camera.faces(&up) {
            run.push(point);
        } else if run.len() > 1 {
            strokes.push(camera.curve(Ink::Obverse, std::mem::take(&mut run)));
        } else {
            run.clear();
        }
    }
    if run.len() > 1 {
        strokes.push(camera.curve(Ink::Obverse, run));
    }
    strokes
}

/// The set-up on a turning pipe, from the side: zero, curve and waste, at A = 0.
fn on_rotary(design: &Design, cut: Option<&Cut>) -> Figure {
    let (outline, half) = (design.outline(), design.branch.D / 2.0);
    let [least, most] = outline.extent();
    let left = -0.7 * design.branch.D;
    let right = most + 0.5 * design.branch.D;
    let mut sketch = Sketch::new([right - left, design.branch.D], [98.0, sketch::HEIGHT - 36.0]);
    let (gap, long) = (sketch.paper(3.0), sketch.paper(9.0));
    sketch::pipe(&mut sketch, design.branch.D, [left, right]);
    // What is seen lies towards −Y: A from 0 to half a turn.
    let at = |phi: f64| [outline.curve(phi).y, half * sin_cos(phi).1];
    let seen: Vec<[f64; 2]> = turns(FINE).filter(|phi| *phi <= PI).map(at).collect();
    let waste: Vec<[f64; 2]> = seen.iter().copied().chain([[right, -half], [right, half]]).collect();
    sketch.shape(Ink::Safe, waste);
    sketch.line(Ink::Safe, turns(FINE).filter(|phi| *phi >= PI).map(at).collect::<Vec<_>>());
    sketch.line(Ink::Obverse, seen);
    sketch.label([f64::midpoint(most, right), 0.0], Beside::Above, t("sobrante", "waste"));
    sketch.label([0.5 * left, 0.0], Beside::Above, t("injerto", "branch"));
    let pierce = cut.map_or(at(0.0)[0], |cut| cut.pierce[1].value());
    sketch::torch(&mut sketch, [pierce, half + gap / 2.0]);
    sketch.zero([0.0, half]);
    sketch.label([0.0, half + gap], Beside::Above, Text::same("X0 A0"));
    sketch.arrow(Ink::Axis(0), [[right - long, half + gap], [right, half + gap]]);
    sketch.label([right, half + gap], Beside::Right, Text::same("+X"));
    let low = -half - sketch.paper(7.0);
    sketch.level([0.0, -half], [least, -half], low, sized("", least));
    sketch.level([0.0, -half], [most, -half], low - sketch.paper(7.0), sized("", most));
    sketch.figure(
        "setup",
        sketch::HEIGHT,
        sketch::held(&t(
            "Tubo en el eje giratorio, A = 0°: X mínima y máxima de la curva",
            "Pipe on the rotary axis, A = 0°: minimum and maximum X of the curve",
        )),
    )
}

/// The same along the pipe's axis.
fn turned(design: &Design) -> Figure {
    sketch::end(design.branch.D, design.branch.t, Text::same("φ = 0, A = 0"), Vec::new())
}

/// The set-up on a flat sheet: zero, curve and waste.
fn sheet(design: &Design, cut: Option<&Cut>) -> Figure {
    let outline = design.outline();
    let (round, [least, most]) = (outline.round(), outline.extent());
    let (edge, top) = (0.06 * round, most + 0.06 * round);
    let mut sketch = Sketch::new([round + 2.0 * edge, top + edge], [112.0, sketch::HEIGHT - 26.0]);
    let (gap, long) = (sketch.paper(2.0), sketch.paper(9.0));
    sketch.rectangle(Ink::Thin, [-edge, -edge], [round + edge, top]);
    let curve: Vec<[f64; 2]> = turns(FINE).map(|phi| outline.curve(phi).into()).collect();
    let kept: Vec<[f64; 2]> = curve.iter().copied().chain([[round, 0.0], [0.0, 0.0]]).collect();
    sketch.shape(Ink::Outline, kept);
    sketch.line(Ink::Obverse, curve);
    sketch.label([round / 2.0, 0.3 * least], Beside::Above, t("injerto", "branch"));
    // Where the curve leaves most room above it.
    let above = |part: f64| [round * part, f64::midpoint(outline.curve(TAU * part).y, top)];
    let places = [0.5, 0.15, 0.85].map(above);
    if let Some(widest) = places.into_iter().min_by(|one, other| one[1].total_cmp(&other[1])) {
        sketch.label(widest, Beside::Above, t("sobrante", "waste"));
    }
    if let Some(cut) = cut {
        let at = cut.pierce.map(crate::number::grid::Milli::value);
        sketch.ring(Ink::Obverse, at, gap / 2.0);
    }
    sketch.zero([0.0, 0.0]);
    sketch.label([-edge, 0.0], Beside::Left, Text::same("X0 Y0, φ = 0"));
    sketch.arrow(Ink::Axis(0), [[0.0, 0.0], [long, 0.0]]);
    sketch.label([long, gap], Beside::Right, Text::same("+X"));
    sketch.arrow(Ink::Axis(1), [[0.0, 0.0], [0.0, long]]);
    sketch.label([0.0, long + gap], Beside::Right, Text::same("+Y"));
    sketch.level([0.0, -edge], [round, -edge], -edge - sketch.paper(9.0), sized("W", round));
    let beyond = round + edge + sketch.paper(6.0);
    sketch.upright([round, 0.0], [round, least], beyond, Beside::Right, sized("", least));
    sketch.upright([round, 0.0], [round, most], beyond + sketch.paper(16.0), Beside::Right, sized("", most));
    sketch.figure(
        "setup",
        sketch::HEIGHT,
        match cut {
            None => t("Chapa plana: Y mínima y máxima de la curva", "Flat sheet: minimum and maximum Y of the curve"),
            Some(_) => t(
                "Chapa plana: Y mínima y máxima de la curva; el círculo es la perforación",
                "Flat sheet: minimum and maximum Y of the curve; the circle is where it pierces",
            ),
        },
    )
}

/// The development: the curve, the torch's path, the seam and the edge.
fn development(design: &Design, cut: Option<&Cut>) -> Figure {
    let outline = design.outline();
    let round = outline.round();
    let [least, most] = outline.extent();
    let curve: Vec<[f64; 2]> = turns(FINE).map(|phi| outline.curve(phi).into()).collect();
    let margin = 0.12 * (most - least).max(10.0);
    let mut strokes = vec![
        Stroke::line(Ink::Outline, vec![[0.0, 0.0], [round, 0.0]]),
        Stroke::line(Ink::Centre, vec![[0.0, -margin], [0.0, most + margin]]),
        Stroke::line(Ink::Centre, vec![[round, -margin], [round, most + margin]]),
        Stroke::line(Ink::Blade, curve),
    ];
    let mut legend = vec![(Ink::Blade, t("curva", "curve")), (Ink::Centre, t("costura", "seam"))];
    if let Some(cut) = cut {
        let place = |to: [crate::number::grid::Milli; 2]| {
            let [first, second] = to.map(crate::number::grid::Milli::value);
            match design.mode {
                Mode::Flat => [first, second],
                Mode::Rotary => [first.to_radians() * outline.radius, second],
            }
        };
        let mut torch = vec![place(cut.pierce)];
        for leg in &cut.legs {
            match leg.follows {
                // Arcs are drawn by the path that they follow.
                Follows::Curve([from, to]) if leg.bend.is_some() => torch.extend((1..=16_u16).map(|at| -> [f64; 2] {
                    let part = f64::from(at) / 16.0;
                    outline.torch(from + (to - from) * part, if at == 16 { Side::Before } else { Side::After }).into()
                })),
                _ => torch.push(place(leg.to)),
            }
        }
        strokes.push(Stroke::line(Ink::Obverse, torch));
        legend.insert(1, (Ink::Obverse, t("antorcha", "torch")));
    }
    Figure {
        letters: Figure::LETTERS,
        key: "development",
        height: Figure::HEIGHT,
        caption: if cut.is_some() {
            t(
                "Desarrollo del injerto con la trayectoria de la antorcha",
                "Development of the branch with the torch path",
            )
        } else {
            t("Desarrollo del injerto", "Development of the branch")
        },
        axes: None,
        strokes,
        labels: vec![Label { at: [0.0, -margin], text: Text::same("φ = 0") }],
        legend,
    }
}

/// The template at 1:1: the curve to cut, the edge, the seam, and the lines of the four quarters.
#[must_use]
pub fn template(design: &Design) -> Figure {
    let outline = design.template();
    let round = outline.round();
    let height = |phi: f64| outline.curve(phi).y;
    let mut phis: Vec<f64> = turns(FINE).chain(outline.corners()).collect();
    phis.sort_by(f64::total_cmp);
    let quarter = |number: u16| {
        let phi = TAU * f64::from(number) / 4.0;
        Stroke::line(Ink::Thin, vec![[outline.radius * phi, 0.0], [outline.radius * phi, height(phi)]])
    };
    let mut strokes = vec![
        Stroke::line(Ink::Outline, vec![[0.0, 0.0], [round, 0.0]]),
        Stroke::line(Ink::Seam, vec![[0.0, 0.0], [0.0, height(0.0)]]),
        Stroke::line(Ink::Seam, vec![[round, 0.0], [round, height(TAU)]]),
    ];
    strokes.extend((1..=3).map(quarter));
    strokes.push(Stroke::line(Ink::Cut, phis.iter().map(|&phi| outline.curve(phi).into()).collect()));
    // Names that have no room side by side stand one below the other.
    let step = if round / 4.0 < QUARTER_NAME { 5.0 } else { 0.0 };
    let labels = (0..=3_u16).map(|number| Label {
        at: [round * f64::from(number) / 4.0, -4.0 - step * f64::from(number)],
        text: Text::same(format!("φ {}°", 90 * number)),
    });
    Figure {
        letters: Figure::LETTERS,
        key: "template",
        height: Figure::HEIGHT,
        caption: t("Plantilla del injerto", "Template of the branch"),
        axes: None,
        strokes,
        labels: labels.collect(),
        legend: vec![(Ink::Cut, t("corte", "cut")), (Ink::Seam, t("costura", "seam"))],
    }
}

fn deviation_figure(deviation: &[[f64; 2]]) -> Figure {
    // Along a long move the nearest place of the curve may go back a little: drawn as it comes the line would, too.
    let mut along: Vec<[f64; 2]> = deviation.iter().map(|&[phi, off]| [phi, off * 1000.0]).collect();
    along.sort_by(|one, other| one[0].total_cmp(&other[0]));
    Figure {
        letters: Figure::LETTERS,
        key: "deviation",
        height: Figure::HEIGHT,
        caption: t(
            "Desviación de la trayectoria leída respecto a la curva exacta, positiva hacia el sobrante",
            "Deviation of the path as read back from the exact curve, positive into the waste",
        ),
        axes: Some(Axes { x: t("φ (°)", "φ (°)"), y: t("desviación (µm)", "deviation (µm)") }),
        strokes: vec![Stroke::line(Ink::Blade, along)],
        labels: Vec::new(),
        legend: Vec::new(),
    }
}
