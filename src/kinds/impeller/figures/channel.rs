//! One channel of a clear cut in plan: what is run, in which order and which way.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{label, line, steps};
use crate::figure::{Figure, Ink, Stroke, letters};
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::bodies::{Bodies, Body, Steps, about_axis};
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::pass::{Cutting, Mode, Pass};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::part::{Face, RIM};
use crate::number::shown;
use crate::number::trig::{hypot, sin_cos};
use crate::text::{Text, t};

const OUTLINES: Steps = Steps { along: 96, deep: 1, across: 12 };
/// How far the circles go on beyond the blades, radians.
const BEYOND: f64 = 0.2;
/// How far a number stands off the end of its way, and how near to another it is put beside it; in R.
const OFF: f64 = 0.045;
const APART: f64 = 0.085;
/// The maximum number of pass numbers that are all written in one place.
const LISTED: usize = 4;
/// The maximum length of a label of pass numbers.
const WIDEST: usize = 18;
/// A letter of a label with the paper about it, across and up, mm of paper.
const LABEL: [f64; 2] = [2.2, 5.0];
/// In how many steps a label goes from its line to the axis.
const TO_AXIS: u16 = 24;
/// The printed height of each figure, mm.
const HEIGHT: f64 = 118.0;

/// The figures of roughing and finishing.
pub(super) fn channel(design: &Design, blade: &Blade, plan: &Plan) -> [Figure; 2] {
    [roughing(design, blade, plan), finishing(design, blade, plan)]
}

/// The blades on both sides of the channel and the splitter between, their tops and feet, on the circles of hub and rim.
fn walls(design: &Design, blade: &Blade, plan: &Plan) -> Vec<Stroke> {
    let torus = design.torus;
    let pitch = TAU / f64::from(design.N);
    let bodies = Bodies::new(design, blade, None, Some(plan), OUTLINES);
    // Each circle from the next blade to this one: no farther, so that the channel fills the figure.
    let round = |(radius, at): (f64, f64)| {
        let (from, to) = (at - pitch - BEYOND, at + BEYOND);
        let points = steps(from, to.min(from + TAU), 120).map(move |angle| {
            let (sin, cos) = sin_cos(angle);
            [radius * cos, radius * sin]
        });
        line(Ink::Thin, points.collect())
    };
    let circles = [(torus.R, blade.circle.u(RIM)), (torus.R - torus.r - design.a_p, FRAC_PI_2)];
    let mut strokes: Vec<Stroke> = circles.into_iter().map(round).collect();
    let mut stand = |ink: Ink, body: &Body, turn: f64| {
        let flat = |level: usize| -> Vec<[f64; 2]> {
            body.outlines[level].iter().map(|point| about_axis(point, turn)).map(|at| [at.x, at.y]).collect()
        };
        strokes.push(Stroke { filled: true, ..line(ink, flat(0)) });
        strokes.push(line(Ink::Outline, flat(0)));
        strokes.push(line(Ink::Thin, flat(1)));
    };
    stand(Ink::Blade, &bodies.blade, 0.0);
    stand(Ink::Blade, &bodies.blade, -pitch);
    if let Some(splitter) = &bodies.splitter {
        stand(Ink::Splitter, splitter, 0.0);
    }
    strokes
}

/// The way of the tip along a pass, on the part, in plan.
fn way(design: &Design, pass: &Pass) -> Vec<[f64; 2]> {
    pass.points
        .iter()
        .map(|stand| design.machine.to_part(&stand.at, stand.B, stand.C))
        .map(|tip| [tip.x, tip.y])
        .collect()
}

fn arrow(ink: Ink, points: Vec<[f64; 2]>) -> Stroke {
    Stroke { arrow: true, ..line(ink, points) }
}

/// Puts a number beyond the end of a way that is farther out, or beyond the other one where both are in the channel; ways that
/// end near one another have their numbers in one place.
fn number_at_end(design: &Design, points: &[[f64; 2]], number: usize, places: &mut Vec<([f64; 2], Vec<usize>)>) {
    let far = |[x, y]: &[f64; 2]| x * x + y * y;
    let [first, second, .., before, last] = points else { return };
    let R = design.torus.R;
    let out = far(first).max(far(last)) >= R * R;
    let [end, before] = if (far(first) > far(last)) == out { [first, second] } else { [last, before] };
    let long = hypot(end[0] - before[0], end[1] - before[1]).max(1e-9);
    // From the hub on, clear of the blade.
    let off = if out { OFF } else { 4.0 * OFF };
    let at = [0, 1].map(|axis| end[axis] + (end[axis] - before[axis]) * off * R / long);
    let near = |(other, _): &&mut ([f64; 2], Vec<usize>)| hypot(at[0] - other[0], at[1] - other[1]) < APART * R;
    match places.iter_mut().find(near) {
        Some((_, numbers)) => numbers.push(number),
        None => places.push((at, vec![number])),
    }
}

/// Where a label near the hub stands on no line: there, or on its way to the axis; there again, where no place is clear.
fn clear_place(strokes: &[Stroke], at: [f64; 2], text: &str) -> [f64; 2] {
    let points = || strokes.iter().flat_map(|stroke| &stroke.points);
    let [low, high] = [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| {
        [0, 1].map(|axis| points().map(|point| point[axis]).reduce(pick).unwrap_or_default())
    });
    let paper = (high[1] - low[1]) / HEIGHT;
    let half = [0.5 * letters(text) * LABEL[0] * paper, 0.5 * LABEL[1] * paper];
    let covers = |foot: [f64; 2], [x, y]: [f64; 2]| {
        (x - foot[0]).abs() < half[0] && (y - foot[1] - half[1] / 2.0).abs() < half[1]
    };
    let meets = |foot: [f64; 2], [from, to]: [[f64; 2]; 2]| {
        let length = hypot(to[0] - from[0], to[1] - from[1]);
        let mut part = 0.0;
        while part < length && !covers(foot, [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part / length)) {
            part += half[1] / 2.0;
        }
        part < length || covers(foot, to)
    };
    let clear = |foot: &[f64; 2]| {
        let mut segments = strokes.iter().flat_map(|stroke| stroke.points.windows(2));
        !segments.any(|ends| matches!(ends, [from, to] if meets(*foot, [*from, *to])))
    };
    let places = (0..=TO_AXIS).map(|step| at.map(|end| end * (1.0 - f64::from(step) / f64::from(TO_AXIS))));
    places.into_iter().find(clear).unwrap_or(at)
}

/// The roughing lanes of the first level, each with its number in the table of passes.
fn roughing(design: &Design, blade: &Blade, plan: &Plan) -> Figure {
    let mut strokes = walls(design, blade, plan);
    let mut places = Vec::new();
    let (mut modes, mut rest) = (Vec::new(), false);
    for (number, pass) in (1..).zip(&plan.passes) {
        let ink = match (pass.cutting, pass.mode) {
            (Cutting::Rest { level: 0, .. } | Cutting::RestContour { level: 0 }, _) => {
                rest = true;
                Ink::Splitter
            }
            (Cutting::Rough { level: 0, .. } | Cutting::RoughContour { level: 0 }, mode) => {
                if !modes.contains(&mode) {
                    modes.push(mode);
                }
                of_mode(mode).0
            }
            _ => continue,
        };
        let points = way(design, pass);
        number_at_end(design, &points, number, &mut places);
        strokes.push(arrow(ink, points));
    }
    let mut legend: Vec<(Ink, Text)> = [Mode::Slot, Mode::Climb, Mode::Conventional]
        .into_iter()
        .filter(|mode| modes.contains(mode))
        .map(of_mode)
        .collect();
    if rest {
        legend.push((
            Ink::Splitter,
            t("desbaste del resto, con la fresa de acabado", "roughing of the rest, with the finishing tool"),
        ));
    }
    legend.push((Ink::Thin, t("pie de los álabes, en el fondo", "foot of the blades, on the floor")));
    let labels = places
        .into_iter()
        .map(|(at, numbers)| {
            let text = listed(&numbers);
            let within = hypot(at[0], at[1]) < design.torus.R;
            label(if within { clear_place(&strokes, at, &text) } else { at }, Text::same(text))
        })
        .collect();
    let s = shown(design.clear.as_ref().map_or(0.0, |asked| asked.cut.s), 3);
    Figure {
        letters: Figure::LETTERS,
        key: "roughing",
        height: HEIGHT,
        caption: Text::new(
            format!(
                "Desbaste de un canal en planta: trayectorias de la punta en el primer nivel, con los números de sus pasadas; quedan {s} mm en \
                 caras y fondo"
            ),
            format!(
                "Roughing of one channel in plan: tip paths on the first level, with the numbers of their passes; {s} mm are \
                 left on faces and floor"
            ),
        ),
        axes: None,
        strokes,
        labels,
        legend,
    }
}

/// Numbers that stand in one place: of many that follow one another the first and the last, so that they fit beside the channel.
fn listed(numbers: &[usize]) -> String {
    let follow = |one: &usize, next: &usize| numbers.len() > LISTED && *next == one + 1;
    let runs = numbers.chunk_by(follow).map(|run| match run {
        [first, _, .., last] => format!("{first} … {last}"),
        _ => run.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "),
    });
    let runs: Vec<String> = runs.collect();
    let all = runs.join(", ");
    match runs.as_slice() {
        // The table of passes has them all.
        [first, _, .., last] if all.chars().count() > WIDEST => format!("{first}, …, {last}"),
        _ => all,
    }
}

const fn of_mode(mode: Mode) -> (Ink, Text) {
    match mode {
        Mode::Slot => (Ink::Cut, t("ranura, a medio avance", "slot, at half the feed")),
        Mode::Climb => (Ink::Reverse, t("concordancia", "climb")),
        Mode::Conventional => (Ink::Obverse, t("oposición", "conventional")),
    }
}

/// Floor lanes, flanks and the ways round the splitter.
fn finishing(design: &Design, blade: &Blade, plan: &Plan) -> Figure {
    let mut strokes = walls(design, blade, plan);
    let mut found = Vec::new();
    for pass in plan.of(Which::Finish) {
        let Some((ink, name)) = finished(pass.cutting) else { continue };
        if found.iter().all(|(known, _)| *known != ink) {
            found.push((ink, name));
        }
        strokes.push(arrow(ink, way(design, pass)));
    }
    let lanes = plan.told.finish.lanes;
    let then = if found.iter().any(|(ink, _)| *ink == Ink::Splitter) {
        t("caras y álabe intermedio", "faces and splitter")
    } else {
        t("caras", "faces")
    };
    Figure {
        letters: Figure::LETTERS,
        key: "finishing",
        height: HEIGHT,
        caption: Text::new(
            format!(
                "Acabado de un canal en planta: {lanes} trayectorias de la punta en el fondo, del centro hacia fuera, y después {}",
                then.es
            ),
            format!(
                "Finishing of one channel in plan: {lanes} tip paths on the floor, from the middle outwards, then {}",
                then.en
            ),
        ),
        axes: None,
        strokes,
        labels: Vec::new(),
        legend: found,
    }
}

const fn finished(cutting: Cutting) -> Option<(Ink, Text)> {
    Some(match cutting {
        Cutting::Floor { .. } | Cutting::Leaning { .. } => (Ink::Profile, t("fondo", "floor")),
        Cutting::Flank { face: Face::Obverse, .. } => (Ink::Obverse, t("cara, anverso", "face, obverse")),
        Cutting::Flank { face: Face::Reverse, .. } => (Ink::Reverse, t("cara, reverso", "face, reverse")),
        Cutting::Contour | Cutting::SplitterFlanks { .. } => (Ink::Splitter, t("álabe intermedio", "splitter")),
        Cutting::Rough { .. } | Cutting::RoughContour { .. } | Cutting::Rest { .. } | Cutting::RestContour { .. } => {
            return None;
        }
    })
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn only_passes_that_follow_one_another_are_joined() {
        for (numbers, text) in [
            (&[1, 2, 3, 4][..], "1, 2, 3, 4"),
            (&[1, 2, 3, 4, 5, 6], "1 … 6"),
            (&[1, 2, 3, 4, 6], "1 … 4, 6"),
            (&[1, 2, 5, 6, 7], "1, 2, 5 … 7"),
            (&[1, 2, 3, 5, 7, 8, 9, 11, 12, 13], "1 … 3, …, 11 … 13"),
            (&[101, 102, 103, 104], "101, 102, 103, 104"),
        ] {
            assert_eq!(listed(numbers), text);
        }
    }
}
