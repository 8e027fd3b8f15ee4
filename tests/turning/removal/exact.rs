//! The region under the tool, against what it must be: the stock's points that no polygon covered.

use proptest::prelude::*;
use rodete::geometry::exact::convex::Convex;
use rodete::geometry::exact::cut::CutEffect;
use rodete::geometry::exact::grid::Point;
use rodete::geometry::exact::meeting::Meeting;
use rodete::geometry::exact::region::{Region, Ring, twice_area};

const SIDE: i64 = 12;

/// Corners on a coarse grid, so that edges and corners lie on one another as often as on a turned part; or anywhere.
fn polygon(step: i64) -> impl Strategy<Value = Convex> {
    let most = SIDE * 1000 / step;
    prop::collection::vec((-most / 6..=most * 7 / 6, -most / 6..=most * 7 / 6), 3..8).prop_filter_map(
        "a line",
        move |points| {
            Convex::hull(&points.iter().map(|&(z, r)| Point { z: z * step, r: r * step }).collect::<Vec<_>>())
        },
    )
}

fn stock() -> Region {
    let side = SIDE * 1000;
    Region::new(&[[(0, 0), (side, 0), (side, side), (0, side)].map(|(z, r)| Point { z, r }).to_vec()])
}

fn inside(polygon: &Convex, [z, r]: [f64; 2]) -> bool {
    polygon.corners().iter().zip(polygon.corners().iter().cycle().skip(1)).all(|(from, to)| {
        let ([z0, r0], [z1, r1]) = (from.mm(), to.mm());
        (z1 - z0) * (r - r0) - (r1 - r0) * (z - z0) > 0.0
    })
}

fn area(rings: &[Ring]) -> f64 {
    rings.iter().map(|ring| twice_area(ring)).sum::<f64>() / 2.0
}

/// Points with odd coordinates, off every edge.
fn probes() -> impl Iterator<Item = [f64; 2]> {
    (0..60).flat_map(|i| {
        (0..60).map(move |j| {
            let at = |k: i32, odd: f64| (f64::from(k) * 0.2 + 0.1 + odd) * 1e-3;
            [at(i, 0.000_312_7), at(j, 0.000_718_3)]
        })
    })
}

fn judge(region: &Region, gone: &[Convex]) {
    for at in probes() {
        assert_eq!(region.contains(at), !gone.iter().any(|polygon| inside(polygon, at)), "at {at:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn what_is_left_is_the_stock_without_the_polygons(
        coarse in prop::collection::vec(polygon(1000), 1..9),
        fine in prop::collection::vec(polygon(1), 0..3),
    ) {
        let (mut region, mut meeting) = (stock(), Meeting::default());
        let mut gone = Vec::new();
        for polygon in coarse.into_iter().chain(fine) {
            let before = area(&region.rings());
            meeting.find(&region, &polygon);
            let cut = region.cut(&polygon, &meeting, &[]);
            let after = area(&region.rings());
            // Green's theorem over the stretches: what the meeting says was taken is what is missing.
            let swept = |from: [f64; 2], to: [f64; 2]| (from[0] * to[1] - to[0] * from[1]) / 2.0;
            let taken = meeting.removed.iter().map(|one| swept(one.from, one.to)).sum::<f64>()
                - meeting.inserted.iter().map(|(one, _)| swept(one.from, one.to)).sum::<f64>();
            prop_assert!((before - after - taken).abs() < 1e-15, "{} {}", before - after, taken);
            prop_assert!((cut == CutEffect::Missed) == (taken.abs() < 1e-18), "{cut:?} {taken}");
            prop_assert!(taken > -1e-16);
            gone.push(polygon.clone());
            judge(&region, &gone);
            // The same once more finds nothing.
            meeting.find(&region, &polygon);
            prop_assert!(meeting.is_empty());
        }
    }

    #[test]
    fn the_order_of_polygons_makes_no_difference(polygons in prop::collection::vec(polygon(1000), 2..7)) {
        let run = |polygons: &mut dyn Iterator<Item = &Convex>| {
            let (mut region, mut meeting) = (stock(), Meeting::default());
            for polygon in polygons {
                meeting.find(&region, polygon);
                region.cut(polygon, &meeting, &[]);
            }
            region.rings()
        };
        let (forward, backward) = (run(&mut polygons.iter()), run(&mut polygons.iter().rev()));
        prop_assert!((area(&forward) - area(&backward)).abs() < 1e-17);
        // The corners, to a thousandth of a nanometre.
        let corners = |rings: &[Ring]| {
            let mut corners: Vec<_> = rings.iter().flatten().map(|corner| corner.map(|at| (at * 1e9).round() + 0.0)).collect();
            corners.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
            corners
        };
        prop_assert_eq!(corners(&forward), corners(&backward));
    }
}
