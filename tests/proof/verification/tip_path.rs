//! The way of the tip between the points is bounded: against looks by chance, and where eighths of a block told too little.

use nalgebra::Vector3;
use proptest::prelude::*;
use rodete::geometry::torus::Torus;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::ideal::Ideal;
use rodete::kinds::impeller::programs::Tracks;
use rodete::kinds::impeller::proof::tip_path::limits;
use rodete::kinds::impeller::proof::tip_path::{Along, between, deviation, grid_bound};
use rodete::kinds::impeller::splitter::Splitter;
use rodete::kinds::impeller::tables::ToolPaths;
use rodete::kinds::impeller::track::Track;
use rodete::machine::axis::{Axis, Pose};
use rodete::machine::rotary::TiltingTable;
use rodete::number::grid::Milli;
use rodete::proof::agreement::tip;

use super::{common, published};

/// The bounds of distance and depth into the metal over all tracks, and the greatest of both at some parts of each block.
fn over(design: &Design, parts: &[f64]) -> [[f64; 2]; 2] {
    let blade = common::blade(design);
    let splitter = Splitter::new(design, &blade).ok();
    let tracks = Tracks::new(&blade, &ToolPaths::new(design, &blade), splitter.as_ref()).unwrap();
    let (mut most, mut seen) = ([0.0_f64; 2], [0.0_f64; 2]);
    for track in Track::ALL {
        let Some(ideal) = Ideal::new(design, splitter.as_ref(), track) else { continue };
        let mut along = Along::new(ideal, design.n, limits(design));
        for (i, pair) in tracks.positions(track).unwrap().windows(2).enumerate() {
            let [from, to] = [pair[0], pair[1]].map(Pose::from);
            along.block(design.machine, [&from, &to], [i, i + 1], Milli::ZERO, (0, None));
            for part in parts {
                let x = f64::from(u32::try_from(i).unwrap()) + part;
                let off = deviation(&ideal, design.machine, &between(&from, &to, *part), Milli::ZERO, x);
                seen = [seen[0].max(off.total), seen[1].max(off.into_metal())];
            }
        }
        let bound = along.at_most();
        most = [most[0].max(bound[0]), most[1].max(bound[1])];
    }
    [most, seen]
}

#[test]
fn what_the_tip_does_between_eighths_of_a_block_is_bounded() {
    let parts = |count: u32| (0..=count).map(|part| f64::from(part) / f64::from(count)).collect::<Vec<_>>();
    let mut missed = 0.0_f64;
    for n in [3, 4, 5, 7, 40] {
        let [bound, dense] = over(&published(n), &parts(1000));
        let eighths = over(&published(n), &parts(8))[1];
        for k in 0..2 {
            assert!(dense[k] <= bound[k] && bound[k] < dense[k] + 1e-5, "{n}: {dense:?} {bound:?}");
            missed = missed.max(bound[k] - eighths[k]);
        }
    }
    assert!(missed > 1e-4, "{missed}");
}

#[test]
fn the_floor_is_told_with_its_upper_bound_alone() {
    let outcome = common::outcome("tfg-2021", &[]);
    assert!(outcome.findings.iter().any(|finding| finding.what.en.contains("deeper than a_p (upper bound")));
    let shown = format!("{:?}", outcome.tables.iter().find(|table| table.key == "verification").unwrap());
    assert!(shown.contains("the rim of the tool below the meridian r") && !shown.contains("deepest point of the rim"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn no_look_between_the_points_is_beyond_the_bound(
        (R, part) in (10.0..400.0_f64, 0.2..0.9_f64), n in 3_u32..60, L in 0.4..4.0_f64, w in 0.02..0.12_f64, seed in 0.0..1.0_f64,
    ) {
        let mut design = published(n);
        design.torus = Torus { R, r: R * part };
        design.machine.L = R * L;
        (design.e, design.d_t, design.a_p) = (R * w, R * w, R * w * (1.0 - part));
        // 10,000 looks by chance.
        let count = 10_000 / n;
        let parts: Vec<f64> = (0..count).map(|k| (seed + f64::from(k) * 0.618_033_988_749_895).fract()).collect();
        let [bound, seen] = over(&design, &parts);
        prop_assert!(seen[0] <= bound[0] && seen[1] <= bound[1], "{:?} {:?}", seen, bound);
        prop_assert!(bound[0] <= seen[0] * 1.05 + 1e-3, "{:?} {:?}", seen, bound);
    }

    #[test]
    fn no_rounding_moves_the_tip_farther_than_its_bound(
        at in [-400.0..400.0_f64, -50.0..50.0, -400.0..100.0, -5.0..95.0, -800.0..800.0], L in 0.0..500.0_f64,
        steps in prop::collection::vec([-1.0..1.0_f64, -1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0], 600),
    ) {
        let machine = TiltingTable { L };
        let pose = |off: [f64; 5]| {
            let mut pose = Pose::default();
            for (k, axis) in [Axis::X, Axis::Y, Axis::Z, Axis::B, Axis::C].into_iter().enumerate() {
                pose.set(axis, at[k] + off[k] * 0.0005);
            }
            pose
        };
        let rounded = pose([0.0; 5]);
        let point: Vector3<f64> = tip(machine, &rounded);
        let bound = grid_bound(machine, &rounded, &point);
        for off in steps {
            for off in [off, off.map(f64::signum)] {
                let moved = (tip(machine, &pose(off)) - point).norm();
                prop_assert!(moved <= bound, "{} {}", moved, bound);
            }
        }
    }
}
