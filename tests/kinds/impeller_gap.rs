//! The gap between blades against a dense search over points of both faces, which uses nothing of its geometry.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use rodete::kinds::impeller::clear::cut::CutStrategy;
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::gap::{Limits, gap};
use rodete::number::trig::{atan2, cos, sin};

use super::impeller_swept::{Design, Point, add, dot, norm};

/// The largest tool that passes, its tip as deep as that of a tool of the radius a: the axis turned between points of both
/// faces, some tenths apart. Before the hub plane stations are in parts of a length.
fn widest(design: &Design, a: f64, run_out: f64) -> f64 {
    let Design { R, r, a_p, e, .. } = *design;
    let sin_alpha = r / R;
    let beyond = ((e / 2.0 + a) * (1.0 - sin_alpha * sin_alpha).sqrt() / sin_alpha + a / sin_alpha + 0.5) / R;
    let lines = ((FRAC_PI_2 + 2.0 * beyond) * R / 0.2).ceil();
    // As deep as the floor is beside the tangent plane.
    let bottom = a_p + e * e / (8.0 * (R - r - a_p));
    let face = |side: f64| -> Vec<Point> {
        (0..=4000_u32)
            .take_while(|&line| f64::from(line) <= lines)
            .flat_map(|line| {
                let v = PI - beyond + (FRAC_PI_2 + 2.0 * beyond) * f64::from(line) / lines;
                let [P, _, b, N] = design.frame(v);
                let foot = add(P, b, side * e / 2.0);
                // From where the torus comes up to it, beside the tangent plane.
                let cos_v = cos(v.clamp(PI, 1.5 * PI));
                let bent = (1.0 - sin_alpha * sin_alpha) / r + sin_alpha * sin_alpha * cos_v / (R + r * cos_v);
                let head = e * e / 8.0 * bent;
                (0..=16_u32).map(move |step| add(foot, N, head - (bottom + head) * f64::from(step) / 16.0))
            })
            .collect()
    };
    let walls = [face(1.0), face(-1.0)];
    let width = |q: f64| {
        let (out, v) = ((-q).max(0.0) * run_out, PI + q.max(0.0) * FRAC_PI_2);
        let reach = (a - out).max(0.0);
        let low = r - ((r + a_p) * (r + a_p) - reach * reach).max(0.0).sqrt();
        // Metal within a of the axis, r from the middle of the tube at least, is no higher.
        let high = (r - (r * r - a * a).max(0.0).sqrt()).max(0.3).max(low);
        let apart = |psi: f64, wall: &[Point]| {
            let along = [-cos(v) * cos(psi), -cos(v) * sin(psi), -sin(v)];
            let rho = R + r * cos(v);
            let foot = [rho * cos(psi), rho * sin(psi), r * sin(v) + out];
            let far = |x: &Point| {
                let from = add(*x, foot, -1.0);
                let up = dot(from, along).clamp(low, high);
                norm(add(from, along, -up))
            };
            wall.iter().map(far).fold(f64::INFINITY, f64::min)
        };
        let k = (R * R - r * r).sqrt();
        let u = atan2(-(r + R * cos(v)), k * sin(v));
        let u = if u < 0.0 { u + TAU } else { u };
        let within = e / 2.0 / ((R + r * cos(v)) * sin_alpha);
        let (mut low, mut high) = (u - design.pitch() + within, u - within);
        let mut most: f64 = 0.0;
        for _ in 0..24 {
            let psi = f64::midpoint(low, high);
            let both = [apart(psi, &walls[0]), apart(psi + design.pitch(), &walls[1])];
            most = most.max(both[0].min(both[1]));
            if both[0] > both[1] { low = psi } else { high = psi }
        }
        2.0 * most
    };
    let stations = [-0.4, -0.2, 0.0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.75, 1.0];
    let widths = stations.map(width);
    let least = (0..stations.len()).min_by(|&one, &two| widths[one].total_cmp(&widths[two])).unwrap();
    let [low, high] = [least.saturating_sub(1), (least + 1).min(stations.len() - 1)].map(|at| stations[at]);
    (1..8).map(|k| width(low + (high - low) * f64::from(k) / 8.0)).fold(widths[least], f64::min)
}

#[test]
fn the_largest_tool_number_and_thickness_are_those_of_a_dense_search() {
    let mut state = 7_u32;
    let mut drawn = |low: f64, high: f64| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        low + (high - low) * f64::from(state >> 8) / f64::from(1_u32 << 24)
    };
    for N in [2, 3, 4, 5] {
        let R = drawn(20.0, 80.0);
        let r = R * drawn(0.4, 0.7);
        let design = Design { R, r, N, e: drawn(0.8, 3.0), a_p: (R - r) * drawn(0.1, 0.25) };
        let d = drawn(2.0, 5.0);
        let limits = Limits::of(&design.job().part, N, d);
        let found = limits.gap.width;
        // Points of a face are somewhat farther than the face.
        let dense = widest(&design, found / 2.0, d / 2.0);
        assert!((-0.03..=0.005).contains(&(found - dense)), "{design:?} {found} {dense}");
        let spare = |N: u32, e: f64| widest(&Design { N, e, ..design }, d / 2.0, d / 2.0) - 4.0 / 3.0 * d;
        if let Some(most) = limits.N_max.filter(|most| *most > 1) {
            assert!(spare(most, design.e) >= -0.005 && spare(most + 1, design.e) <= 0.03, "{design:?} {limits:?}");
        }
        if let Some(most) = limits.e_max {
            let spare = [0.0, 0.04].map(|more| spare(N, most + more));
            assert!(spare[0] >= -0.005 && spare[1] <= 0.03, "{design:?} {limits:?} {spare:?}");
        }
        // A clear cut is stopped only by a tool wider than the gap down to the floor, with what it leaves on both walls.
        let cut = |rough: f64| CutStrategy { scallop: 0.5, tolerance: 0.05, ..CutStrategy::usual(rough, 1.0) };
        let least = gap(&design.job().part, N, d).width - 2.0 * cut(1.0).s;
        if least > 1.2 && least < 1.9 * r {
            let fits = Plan::new(&design.job(), &cut(least * 0.995 - 0.05)).map(|_| ());
            assert!(fits.is_ok(), "{design:?} {least} {fits:?}");
            let wide = Plan::new(&design.job(), &cut(least * 1.1 + 0.2)).map(|_| ());
            assert!(wide.is_err(), "{design:?} {least}");
        }
    }
}
