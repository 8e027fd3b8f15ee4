//! The impeller as a solid: hub, blades and splitters.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use super::{steps, t};
use crate::figure::{Figure, Ink};
use crate::geometry::darboux::Darboux;
use crate::geometry::scene::{Camera, Scene};
use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::splitter::Splitter;
use crate::number::trig::sin_cos;

/// Steps of the mesh along a blade (fewer where there are many), about the hub, and along the hub's meridian.
const ALONG: u16 = 44;
const ALONG_MANY: u16 = 18;
const MANY: u32 = 12;
const ABOUT: u16 = 132;
const MERIDIAN: u16 = 20;

/// The impeller seen from above its narrow end.
pub(super) fn cover(design: &Design, blade: &Blade, splitter: Option<&Splitter>) -> Figure {
    let mut scene = Scene::new(Camera::new(-58.0, 33.0));
    hub(&mut scene, design);
    for number in 0..design.N {
        let turn = TAU * f64::from(number) / f64::from(design.N);
        wall(&mut scene, design, blade, turn, |_| blade_halves(design));
        if let Some(splitter) = splitter {
            let half = |v: f64| splitter_halves(design, blade, splitter, v);
            wall(&mut scene, design, blade, turn - PI / f64::from(design.N), half);
        }
    }
    Figure {
        key: "cover",
        height: 118.0,
        caption: t(
            "El rodete mecanizado; la base bajo el canal es indicativa",
            "The impeller as cut; the base below the channel is indicative",
        ),
        axes: None,
        strokes: scene.strokes(),
        labels: Vec::new(),
        legend: Vec::new(),
    }
}

fn about_axis(point: &Vector3<f64>, angle: f64) -> Vector3<f64> {
    let (sin, cos) = sin_cos(angle);
    Vector3::new(point.x * cos - point.y * sin, point.x * sin + point.y * cos, point.z)
}

/// The floor of the channel, a torus whose meridian is deeper by a_p; the top, and a base below.
fn hub(scene: &mut Scene, design: &Design) {
    let (R, a_p) = (design.torus.R, design.a_p);
    let floor = Torus { R, r: design.torus.r + a_p };
    let base = -floor.r - 0.16 * R;
    let edge = |u: f64, rho: f64, z: f64| {
        let (sin, cos) = sin_cos(u);
        Vector3::new(rho * cos, rho * sin, z)
    };
    let angles: Vec<f64> = steps(0.0, TAU, ABOUT).collect();
    let meridian: Vec<f64> = steps(PI, PI + FRAC_PI_2, MERIDIAN).collect();
    let top: Vec<Vector3<f64>> = angles.iter().skip(1).map(|&u| floor.point(u, PI)).collect();
    scene.add(&top, &(0..top.len()).collect::<Vec<_>>(), Ink::Outline, 0.0);
    for about in angles.windows(2) {
        let (from, to) = (about[0], about[1]);
        for along in meridian.windows(2) {
            let corners = [
                floor.point(from, along[0]),
                floor.point(from, along[1]),
                floor.point(to, along[1]),
                floor.point(to, along[0]),
            ];
            scene.add(&corners, &[], Ink::Thin, 0.0);
        }
        let rim = [edge(from, R, -floor.r), edge(from, R, base), edge(to, R, base), edge(to, R, -floor.r)];
        // A little farther, so that what stands on the rim is not cut by it.
        scene.add(&rim, &[1, 3], Ink::Outline, -0.02 * R);
    }
}

/// What a blade's thickness leaves towards +b and towards −b.
#[must_use]
pub fn blade_halves(design: &Design) -> [f64; 2] {
    [design.e / 2.0; 2]
}

/// What the tool leaves of a splitter at v between its two paths: how far towards +b and towards −b.
#[must_use]
pub fn splitter_halves(design: &Design, blade: &Blade, splitter: &Splitter, v: f64) -> [f64; 2] {
    let last = blade.points().saturating_sub(1);
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    let position = (v - PI) / FRAC_PI_2 * last as f64;
    let position = position.clamp(0.0, last as f64);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the last index")]
    let below = position as usize;
    #[expect(clippy::cast_precision_loss, reason = "an index of a point")]
    let part = position - below as f64;
    // Between two points the fraction is a power of a straight line: a straight line serves a drawing.
    [&splitter.back, &splitter.out].map(|side| {
        let at = |index: usize| side.fraction.get(index).copied().unwrap_or(1.0);
        let fraction = at(below) + (at(below + 1) - at(below)) * part;
        design.w() * fraction - design.d_t / 2.0
    })
}

/// Sections of a blade that reaches so far towards +b and −b, at `along` + 1 places from its entry on, turned about the
/// axis; where nothing is left of it there is none. Each has four corners: at the top towards +b and −b, on the floor of the
/// channel towards −b and +b; mm.
pub fn sections(
    design: &Design,
    blade: &Blade,
    turn: f64,
    along: u16,
    halves: impl Fn(f64) -> [f64; 2],
) -> Vec<[Vector3<f64>; 4]> {
    let circle = blade.circle;
    let section = |v: f64| -> Option<[Vector3<f64>; 4]> {
        let [plus, minus] = halves(v);
        if plus + minus <= 0.0 {
            return None;
        }
        let u = circle.u(v);
        let point = circle.torus.point(u, v);
        let frame = Darboux::of(circle, u, v);
        let (plus, minus) = (point + frame.b * plus, point - frame.b * minus);
        let depth = frame.N * design.a_p;
        Some([plus, minus, minus - depth, plus - depth].map(|at| about_axis(&at, turn)))
    };
    steps(PI, PI + FRAC_PI_2, along).filter_map(section).collect()
}

/// A blade that reaches so far towards +b and −b, turned about the axis: both flanks, the top and the ends.
fn wall(scene: &mut Scene, design: &Design, blade: &Blade, turn: f64, halves: impl Fn(f64) -> [f64; 2]) {
    let along = if design.N > MANY { ALONG_MANY } else { ALONG };
    let sections = sections(design, blade, turn, along, halves);
    let nearer = 0.5 * design.a_p;
    for (number, pair) in sections.windows(2).enumerate() {
        let ([a, b, c, d], [e, f, g, h]) = (pair[0], pair[1]);
        // Corner 1 begins the edge at the far end, corner 3 that at the near end of a piece.
        let ends: &[usize] = match (number == 0, number + 2 == sections.len()) {
            (true, true) => &[1, 3],
            (true, false) => &[3],
            (false, true) => &[1],
            (false, false) => &[],
        };
        let with = |edges: &[usize]| [edges, ends].concat();
        scene.add(&[a, e, f, b], &with(&[0, 2]), Ink::Outline, nearer + 0.05 * design.a_p);
        scene.add(&[d, h, e, a], &with(&[0]), Ink::Outline, nearer);
        scene.add(&[b, f, g, c], &with(&[2]), Ink::Outline, nearer);
    }
    if let (Some([a, b, c, d]), Some([e, f, g, h])) = (sections.first(), sections.last()) {
        scene.add(&[*a, *b, *c, *d], &[0, 1, 2, 3], Ink::Outline, nearer);
        scene.add(&[*e, *h, *g, *f], &[0, 1, 2, 3], Ink::Outline, nearer);
    }
}
