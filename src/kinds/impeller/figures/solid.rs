//! The impeller as a solid: hub, blades and splitters.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Vector3;

use super::{steps, t};
use crate::figure::{Figure, Ink};
use crate::geometry::scene::{Camera, Scene};
use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::bodies::{Bodies, Body, Facet, Side, Steps};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::splitter::Splitter;
use crate::number::trig::sin_cos;

/// Steps of a blade; fewer along it where there are many.
const STEPS: Steps = Steps { along: 32, deep: 1, across: 6 };
const ALONG_MANY: u16 = 18;
const MANY: u32 = 12;
/// Steps about the hub, and along its meridian.
const ABOUT: u16 = 96;
const MERIDIAN: u16 = 16;

/// The impeller seen from above its narrow end.
pub(super) fn cover(design: &Design, blade: &Blade, splitter: Option<&Splitter>, plan: Option<&Plan>) -> Figure {
    let mut scene = Scene::new(Camera::new(-58.0, 33.0));
    hub(&mut scene, design);
    let along = if design.N > MANY { ALONG_MANY } else { STEPS.along };
    let bodies = Bodies::new(design, blade, splitter, plan, Steps { along, ..STEPS });
    for body in [Some(&bodies.blade), bodies.splitter.as_ref()].into_iter().flatten() {
        let edges = edges(body);
        for number in 0..design.N {
            wall(&mut scene, &body.turned(TAU * f64::from(number) / f64::from(design.N)), &edges, design.a_p);
        }
    }
    Figure {
        letters: Figure::LETTERS,
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

/// Which edges of each facet are edges of the body: where two of its sides meet, but for those that pass smoothly into a nose.
fn edges(body: &Body) -> Vec<Vec<usize>> {
    let ends = |corners: &[usize; 4], at: usize| {
        let (one, other) = (corners[at], corners[(at + 1) % 4]);
        (one.min(other), one.max(other))
    };
    let mut sides: BTreeMap<(usize, usize), Vec<Side>> = BTreeMap::new();
    for Facet { corners, side } in &body.facets {
        for at in 0..4 {
            sides.entry(ends(corners, at)).or_default().push(*side);
        }
    }
    let smooth = |side: Side| matches!(side, Side::Nose | Side::Obverse | Side::Reverse);
    let drawn = |facet: &Facet, at: usize| {
        let ends = ends(&facet.corners, at);
        sides.get(&ends).filter(|_| ends.0 != ends.1).is_some_and(|met| {
            let nose = met.contains(&Side::Nose) && met.iter().all(|&side| smooth(side));
            met.iter().any(|&side| side != facet.side) && !nose
        })
    };
    body.facets.iter().map(|facet| (0..4).filter(|&at| drawn(facet, at)).collect()).collect()
}

/// A body with its edges; what stands on the floor goes before it, its top before its sides.
fn wall(scene: &mut Scene, body: &Body, edges: &[Vec<usize>], a_p: f64) {
    for (Facet { corners, side }, edges) in body.facets.iter().zip(edges) {
        let nearer = match side {
            Side::Foot => continue,
            Side::Top => 0.55 * a_p,
            _ => 0.5 * a_p,
        };
        let points: Vec<Vector3<f64>> = corners.iter().filter_map(|&corner| body.points.get(corner)).copied().collect();
        scene.add(&points, edges, Ink::Outline, nearer);
    }
}
