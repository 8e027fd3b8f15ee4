//! Blades and splitters as bodies: closed, in the blank, and of the volume of what is defined.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;
use rodete::geometry::torus::Torus;
use rodete::kinds::impeller::bodies::{Beginning, Body, Steps};
use rodete::kinds::impeller::clear::cut::Job;
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::part::{HUB, Part, RIM};
use rodete::kinds::impeller::scene;
use rodete::kinds::impeller::splitter::Splitter;
use rodete::number::trig::{hypot, sin_cos};

use crate::common;

const FINE: Steps = Steps { along: 160, deep: 8, across: 12 };
/// R, r, e, a_p, and where a splitter begins, a part of the way from hub to rim.
const DESIGNS: [([f64; 4], f64); 4] = [
    ([25.0, 15.0, 2.0, 2.0], 0.8),
    ([25.0, 15.0, 3.7, 2.0], 0.8),
    ([25.0, 17.0, 1.0, 4.0], 0.4),
    ([50.0, 30.0, 2.0, 3.0], 0.3),
];

fn bodies() -> impl Iterator<Item = (Part, Body, Option<f64>)> {
    DESIGNS.into_iter().flat_map(|([R, r, e, a_p], q)| {
        let part = Part::with(Torus { R, r }, e, a_p);
        let v_s = HUB + q * FRAC_PI_2;
        [(Beginning::Hub, None), (Beginning::Round(v_s), Some(v_s))]
            .map(|(beginning, v_s)| (part, Body::new(&part, |_| [e / 2.0; 2], beginning, FINE), v_s))
    })
}

/// The triangles of a body as they are shown.
fn triangles(body: &Body) -> Vec<[usize; 3]> {
    let halves = body.facets.iter().flat_map(|facet| {
        let [a, b, c, d] = facet.corners;
        [[a, b, c], [a, c, d]]
    });
    halves.filter(|[a, b, c]| a != b && b != c && c != a).collect()
}

#[test]
fn every_edge_is_run_once_each_way() {
    for (part, body, v_s) in bodies() {
        let mut edges: BTreeMap<(usize, usize), u32> = BTreeMap::new();
        for [a, b, c] in triangles(&body) {
            for edge in [(a, b), (b, c), (c, a)] {
                *edges.entry(edge).or_default() += 1;
            }
        }
        for (&(from, to), &count) in &edges {
            assert_eq!((count, edges.get(&(to, from))), (1, Some(&1)), "{part:?} {v_s:?}");
        }
        // No two of its points are one.
        let mut places: Vec<[u64; 3]> =
            body.points.iter().map(|point| [point.x, point.y, point.z].map(f64::to_bits)).collect();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), body.points.len());
    }
}

#[test]
fn it_is_in_the_blank_between_tops_and_floor_and_reaches_all_of_its_ends() {
    for (part, body, v_s) in bodies() {
        let mut reach = [f64::MAX, f64::MIN, f64::MIN, f64::MIN];
        for point in &body.points {
            let (depth, rho) = (part.depth(point), hypot(point.x, point.y));
            reach = [reach[0].min(depth), reach[1].max(depth), reach[2].max(point.z), reach[3].max(rho)];
        }
        let R = part.circle.torus.R;
        assert!(reach[0].abs() < 1e-9 && (reach[1] - part.a_p).abs() < 1e-9, "{part:?} {reach:?}");
        assert!((reach[3] - R).abs() < 1e-9, "{reach:?}");
        assert!(if v_s.is_none() { reach[2].abs() < 1e-9 } else { reach[2] < -0.1 }, "{reach:?}");
    }
}

/// The volume of what is defined, by cells of its own coordinates.
fn defined(part: &Part, v_s: Option<f64>) -> f64 {
    let (half, far) = (part.e / 2.0, 2.0 * part.e / part.circle.torus.R);
    let (from, to) = (v_s.unwrap_or(HUB - far), RIM + far);
    let counts = [1200_u16, 24, 160];
    let deep = [-0.1 * part.a_p - 0.1 * part.e, 1.6 * part.a_p];
    let cell = |at: u16, of: u16, [from, to]: [f64; 2]| from + (to - from) * (f64::from(at) + 0.5) / f64::from(of);
    // Tops and floor cut all lines down the blade at nearly one depth: each line has its cells elsewhere, by the golden section.
    let lower = |at: u16, of: u16, line: [u16; 2]| {
        let phase = (0.618_033_988_75 * (f64::from(line[0]) * 61.0 + f64::from(line[1]))).fract();
        deep[0] + (deep[1] - deep[0]) * (f64::from(at) + phase) / f64::from(of)
    };
    let held = |point: &Vector3<f64>| part.trimmed(point) && (0.0..=part.a_p).contains(&part.depth(point));
    let (mut volume, step) = (0.0, 1e-5);
    for i in 0..counts[0] {
        let v = cell(i, counts[0], [from, to]);
        let (P, frame) = part.frame(v);
        let [(P_0, before), (P_1, after)] = [v - step, v + step].map(|v| part.frame(v));
        let change = |one: Vector3<f64>, other: Vector3<f64>| (other - one).dot(&frame.t) / (2.0 * step);
        let along = [change(P_0, P_1), change(before.b, after.b), change(before.N, after.N)];
        for j in 0..counts[1] {
            let y = cell(j, counts[1], [-half, half]);
            for k in 0..counts[2] {
                let h = lower(k, counts[2], [i, j]);
                if held(&(P + frame.b * y - frame.N * h)) {
                    volume += along[0] + y * along[1] - h * along[2];
                }
            }
        }
    }
    volume *= (to - from) / 1200.0 * part.e / 24.0 * (deep[1] - deep[0]) / 160.0;
    let Some(v_s) = v_s else { return volume };
    // The half round, in rings and angles.
    let (P, frame) = part.frame(v_s);
    let mut nose = 0.0;
    for i in 0..20_u16 {
        let out = cell(i, 20, [0.0, half]);
        for j in 0..60_u16 {
            let (sin, cos) = sin_cos(cell(j, 60, [-FRAC_PI_2, FRAC_PI_2]));
            for k in 0..400_u16 {
                let h = lower(k, 400, [i, j]);
                nose += if held(&(P + (frame.b * sin - frame.t * cos) * out - frame.N * h)) { out } else { 0.0 };
            }
        }
    }
    volume + nose * half / 20.0 * PI / 60.0 * (deep[1] - deep[0]) / 400.0
}

#[test]
fn its_volume_is_that_of_what_is_defined() {
    for (part, body, v_s) in bodies() {
        let corner = |at: usize| body.points[at];
        let found: f64 =
            triangles(&body).iter().map(|&[a, b, c]| corner(a).dot(&corner(b).cross(&corner(c))) / 6.0).sum();
        let defined = defined(&part, v_s);
        // The chords of a half round lie in it; its rulings are hardly longer than a_p.
        let (n, half) = (f64::from(FINE.across), part.e / 2.0);
        let chords = (FRAC_PI_2 - n / 2.0 * sin_cos(PI / n).0) * half * half * 1.1 * part.a_p;
        let less = if v_s.is_some() { chords } else { 0.0 };
        let off = found - defined;
        assert!(off < 2e-3 * defined && off > -2e-3 * defined - less, "{part:?} {v_s:?}: {found} {defined}");
    }
}

#[test]
fn all_that_is_shown_of_a_case_is_closed() {
    for case in ["full", "tfg-2021", "clear"] {
        let design = Design::new(&common::fields(case, &[])).unwrap();
        let blade = common::blade(&design);
        let plan = design.clear.as_ref().map(|asked| Plan::new(&Job::of(&design), &asked.cut).unwrap());
        let splitter = if plan.is_none() { Splitter::new(&design, &blade).ok() } else { None };
        let part = scene::part(&design, &blade, splitter.as_ref(), plan.as_ref());
        assert_eq!(part.meshes.len(), 3, "{case}: hub, blades and splitters");
        for mesh in &part.meshes {
            // Corners at one place are one.
            let place = |at: u32| mesh.points[at as usize].map(|x| (x + 0.0).to_bits());
            let mut edges: BTreeMap<([u64; 3], [u64; 3]), i32> = BTreeMap::new();
            for corners in mesh.triangles.chunks(3) {
                for at in 0..3 {
                    let (from, to) = (place(corners[at]), place(corners[(at + 1) % 3]));
                    assert_ne!(from, to, "{case}: {}", mesh.name.en);
                    *edges.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
                }
            }
            assert!(edges.values().all(|&left| left == 0), "{case}: {}", mesh.name.en);
            let R = design.torus.R;
            assert!(mesh.points.iter().all(|[x, y, z]| *z <= 1e-9 && hypot(*x, *y) <= R + 1e-9), "{case}");
        }
    }
}
