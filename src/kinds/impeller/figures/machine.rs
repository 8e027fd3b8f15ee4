//! Drawings in machine coordinates: the part turned about the pivot under the tool, the safe points, the turned blank.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use nalgebra::Vector3;

use super::{FINE, arrow, label, line, sampled, steps, t};
use crate::figure::{Axes, Figure, Ink, Label, Stroke};
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::tables::ToolPaths;
use crate::number::trig::sin_cos;
use crate::text::Text;

fn xz(point: &Vector3<f64>) -> [f64; 2] {
    [point.x, point.z]
}

/// The part in section at B = 90°, 45° and 0° with the tool on it, and the curve of the mean line.
pub(super) fn positions(design: &Design, blade: &Blade) -> Figure {
    let machine = design.machine;
    let mut strokes = Vec::new();
    let mut labels = Vec::new();
    let pivot = [0.0, -machine.L];
    for B in [FRAC_PI_2, FRAC_PI_4, 0.0] {
        position(&mut strokes, &mut labels, design, B);
    }
    // The path of the part's origin about the pivot.
    let arc = steps(0.0, FRAC_PI_2, 60).map(|B| xz(&machine.to_machine(&Vector3::zeros(), B, 0.0))).collect();
    strokes.push(line(Ink::Centre, arc));
    let path = sampled(blade.points(), FINE).filter_map(|at| blade.machine.get(at)).map(xz).collect();
    strokes.push(line(Ink::Blade, path));
    let size = 0.02 * machine.L;
    strokes.push(line(Ink::Outline, ring(pivot, size)));
    labels.push(label([pivot[0] + 5.0 * size, pivot[1] - 0.5 * size], t("pivote", "pivot")));
    Figure {
        letters: Figure::LETTERS,
        key: "positions",
        height: 104.0,
        caption: t(
            "La pieza, en sección, girada alrededor del pivote bajo la herramienta (plano XZ de la máquina)",
            "The part, in section, turned about the pivot under the tool (machine plane XZ)",
        ),
        axes: None,
        strokes,
        labels,
        legend: vec![
            (Ink::Blade, t("fibra media, coordenadas de máquina", "mean line, machine coordinates")),
            (Ink::Outline, t("pieza y herramienta", "part and tool")),
        ],
    }
}

/// Part and tool at one angle B.
fn position(strokes: &mut Vec<Stroke>, labels: &mut Vec<Label>, design: &Design, B: f64) {
    let machine = design.machine;
    let torus = design.torus;
    let turned = |rho: f64, z: f64| xz(&machine.to_machine(&Vector3::new(rho, 0.0, z), B, 0.0));
    let meridian = |side: f64| {
        steps(PI, PI + FRAC_PI_2, 40).map(move |v| {
            let (sin, cos) = sin_cos(v);
            (side * (torus.R + torus.r * cos), torus.r * sin)
        })
    };
    let foot = -1.5 * torus.r;
    let mut section: Vec<[f64; 2]> = meridian(1.0).map(|(rho, z)| turned(rho, z)).collect();
    section.extend([turned(torus.R, foot), turned(-torus.R, foot)]);
    let mut left: Vec<[f64; 2]> = meridian(-1.0).map(|(rho, z)| turned(rho, z)).collect();
    left.reverse();
    section.extend(left);
    section.extend(section.first().copied());
    strokes.push(Stroke { ink: Ink::Outline, points: section.clone(), filled: true, arrow: false });
    strokes.push(line(Ink::Outline, section));
    strokes.push(line(Ink::Thin, vec![[0.0, -machine.L], turned(0.0, 0.0)]));
    // The tool is at the point whose normal is vertical: v = 3π/2 − B.
    let v = PI + FRAC_PI_2 - B;
    let tip = turned(torus.rho(v), torus.r * sin_cos(v).0);
    let (half, top) = (design.d_t / 2.0, tip[1] + 0.45 * design.tool_reach());
    let tool = vec![
        [tip[0] - half, top],
        [tip[0] - half, tip[1]],
        [tip[0] + half, tip[1]],
        [tip[0] + half, top],
        [tip[0] - half, top],
    ];
    strokes.push(Stroke { ink: Ink::Safe, points: tool.clone(), filled: true, arrow: false });
    strokes.push(line(Ink::Outline, tool));
    strokes.push(line(Ink::Centre, vec![[tip[0], tip[1]], [tip[0], top + 0.06 * design.tool_reach()]]));
    let angle = format!("B = {}°", B.to_degrees());
    // Beside the tool, on the side away from the path.
    let side = if B > FRAC_PI_4 { -0.28 } else { 0.28 };
    labels.push(label([tip[0] + side * design.tool_reach(), top], Text::same(angle)));
}

/// The path of the tool round a blade in machine XY, with the safe points.
pub(super) fn safe_points(passes: &ToolPaths) -> Figure {
    let xy = |point: &Vector3<f64>| [point.x, point.y];
    let path = |points: &[Vector3<f64>]| {
        sampled(points.len(), FINE).filter_map(|at| points.get(at)).map(xy).collect::<Vec<_>>()
    };
    let (obverse, reverse) = (path(&passes.obverse), path(&passes.reverse));
    let (entry, exit) = (&passes.entry, &passes.exit);
    let ends = |points: &[[f64; 2]]| Some((*points.first()?, *points.last()?));
    let mut strokes = Vec::new();
    if let (Some((o0, o1)), Some((r0, r1))) = (ends(&obverse), ends(&reverse)) {
        for (from, to) in [
            (xy(&entry.obverse), o0),
            (o1, xy(&exit.obverse)),
            (xy(&exit.obverse), xy(&exit.reverse)),
            (xy(&exit.reverse), r1),
            (r0, xy(&entry.reverse)),
            (xy(&entry.reverse), xy(&entry.obverse)),
        ] {
            strokes.push(arrow(Ink::Safe, from, to));
        }
    }
    strokes.push(line(Ink::Obverse, obverse));
    strokes.push(line(Ink::Reverse, reverse));
    Figure {
        letters: Figure::LETTERS,
        key: "safety",
        height: Figure::HEIGHT,
        caption: t(
            "Recorrido de la herramienta alrededor de un álabe, en el plano XY de la máquina",
            "Path of the tool round a blade, in the machine's XY plane",
        ),
        axes: Some(Axes { x: Text::same("x (mm)"), y: Text::same("y (mm)") }),
        strokes,
        labels: Vec::new(),
        legend: vec![
            (Ink::Obverse, t("anverso", "obverse")),
            (Ink::Reverse, t("reverso", "reverse")),
            (Ink::Safe, t("por los puntos de seguridad", "by the safe points")),
        ],
    }
}

/// Both ends of a blade in machine XY, to scale, side by side: the blade, the tool at the ends of the passes and at the
/// safe points.
pub(super) fn safe_ends(design: &Design, blade: &Blade, passes: &ToolPaths) -> Figure {
    let (mut strokes, mut labels) = (Vec::new(), Vec::new());
    let reach = design.d_s + 2.0 * design.d_t + 2.0 * design.w();
    let last = blade.points().saturating_sub(1);
    let ends = [
        (0, &passes.entry, 1.0, -1.15 * reach, t("entrada, B = 90°", "entry, B = 90°")),
        (last, &passes.exit, -1.0, 1.15 * reach, t("salida, B = 0°", "exit, B = 0°")),
    ];
    for (at, safe, inwards, shift, name) in ends {
        let (Some(P), Some(o), Some(r)) = (blade.machine.get(at), passes.obverse.get(at), passes.reverse.get(at))
        else {
            continue;
        };
        let place = |point: &Vector3<f64>| [point.x - P.x + shift, point.y - P.y];
        let along = blade.t_machine * (inwards * reach);
        let half = blade.b_machine * (design.e / 2.0);
        let wall: Vec<[f64; 2]> = [P + half, P + half + along, P - half + along, P - half].iter().map(place).collect();
        strokes.push(Stroke { ink: Ink::Blade, points: wall.clone(), filled: true, arrow: false });
        strokes.push(line(Ink::Blade, wall.into_iter().cycle().take(5).collect()));
        for (ink, end, point) in [(Ink::Obverse, o, &safe.obverse), (Ink::Reverse, r, &safe.reverse)] {
            strokes.push(line(ink, vec![place(end), place(&(end + along))]));
            strokes.push(line(ink, ring(place(end), design.d_t / 2.0)));
            strokes.push(line(Ink::Safe, ring(place(point), design.d_t / 2.0)));
            strokes.push(arrow(Ink::Safe, place(point), place(end)));
        }
        strokes.push(line(Ink::Safe, vec![place(&safe.obverse), place(&safe.reverse)]));
        labels.push(label([shift, -1.5 * reach], name));
    }
    Figure {
        letters: Figure::LETTERS,
        key: "safe-ends",
        height: 82.0,
        caption: t(
            "Los extremos del álabe a escala: herramienta al final de las pasadas y en los puntos de seguridad",
            "The blade's ends to scale: the tool at the ends of the passes and at the safe points",
        ),
        axes: None,
        strokes,
        labels,
        legend: vec![
            (Ink::Blade, t("álabe", "blade")),
            (Ink::Obverse, t("anverso", "obverse")),
            (Ink::Reverse, t("reverso", "reverse")),
            (Ink::Safe, t("puntos de seguridad", "safe points")),
        ],
    }
}

fn ring(centre: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    steps(0.0, TAU, 48)
        .map(|angle| {
            let (sin, cos) = sin_cos(angle);
            [centre[0] + radius * cos, centre[1] + radius * sin]
        })
        .collect()
}

/// The turned profile in the stock, half section; the lathe's Z to the right.
pub(super) fn blank(design: &Design) -> Figure {
    let torus = design.torus;
    let length = design.blank.L_b.max(torus.r);
    let profile: Vec<[f64; 2]> = steps(PI, PI + FRAC_PI_2, 60)
        .map(|v| {
            let (sin, cos) = sin_cos(v);
            [torus.r * sin, torus.R + torus.r * cos]
        })
        .collect();
    let mut outline = profile.clone();
    outline.extend([[-length, torus.R], [-length, 0.0], [0.0, 0.0]]);
    outline.extend(profile.first().copied());
    let stock = vec![[-torus.r, torus.R], [0.0, torus.R], [0.0, torus.R - torus.r]];
    let overhang = 0.08 * length;
    Figure {
        letters: Figure::LETTERS,
        key: "blank",
        height: Figure::HEIGHT,
        caption: t(
            "Perfil torneado, en semisección: el arco del ciclo G85 dentro del bruto",
            "Turned profile, in half section: the arc of the cycle G85 within the stock",
        ),
        axes: None,
        strokes: vec![
            Stroke { ink: Ink::Outline, points: outline.clone(), filled: true, arrow: false },
            line(Ink::Safe, stock),
            line(Ink::Outline, outline),
            line(Ink::Obverse, profile),
            line(Ink::Centre, vec![[-length - overhang, 0.0], [overhang, 0.0]]),
        ],
        labels: vec![
            label([overhang * 1.5, -0.2 * overhang], Text::same("Z")),
            label([-torus.r * 0.32, torus.R - torus.r * 0.32], Text::same("r")),
            label([-length / 2.0 - torus.r / 2.0, torus.R * 1.05], Text::same("2·R")),
        ],
        legend: vec![(Ink::Obverse, t("arco de radio r", "arc of radius r")), (Ink::Safe, t("bruto", "stock"))],
    }
}
