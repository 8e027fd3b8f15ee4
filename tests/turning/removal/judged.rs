//! The region under the tool, against another library's: `i_overlay`, which holds corners on a grid and rounds each new
//! one onto it.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use proptest::prelude::*;
use rodete::geometry::exact::convex::Convex;
use rodete::geometry::exact::grid::Point;
use rodete::geometry::exact::meeting::Meeting;
use rodete::geometry::exact::region::{Region, Ring, twice_area};
use rodete::removal::turning::tool::TurningTool;

use super::tools;

type Shapes = Vec<Vec<Vec<[f64; 2]>>>;

fn corners(polygon: &Convex) -> Vec<[f64; 2]> {
    polygon.corners().iter().map(|corner| corner.mm()).collect()
}

fn area(shapes: &Shapes) -> f64 {
    shapes.iter().flatten().map(|ring| twice_area(ring)).sum::<f64>() / 2.0
}

/// A stock, and what is left of it after some polygons, by both.
fn both(stock: &[[f64; 2]; 4], gone: &[Convex]) -> (Vec<Ring>, Shapes) {
    let ring = stock.map(|corner| Point::near(corner).unwrap()).to_vec();
    let (mut region, mut meeting) = (Region::new(&[ring]), Meeting::default());
    let mut judge: Shapes = vec![vec![stock.to_vec()]];
    for polygon in gone {
        meeting.find(&region, polygon);
        region.cut(polygon, &meeting, &[]);
        judge = judge.overlay_as::<i64>(&vec![corners(polygon)], OverlayRule::Difference, FillRule::NonZero);
    }
    (region.rings(), judge)
}

/// The area of what is in one of them and not in the other, mm².
fn apart(rings: &[Ring], judge: &Shapes) -> f64 {
    let ours: Shapes = vec![rings.to_vec()];
    area(&ours.overlay_as::<i64>(judge, OverlayRule::Xor, FillRule::EvenOdd))
}

/// Where the tool goes, in mm: from place to place, some of them on a coarse grid so that passes lie on one another.
fn way() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let coarse = (-100..=10_i32, 0..=30_i32).prop_map(|(z, r)| [f64::from(z), f64::from(r)]);
    let fine = (-100.0..10.0_f64, 0.0..30.0_f64).prop_map(|(z, r)| [z, r]);
    prop::collection::vec(prop_oneof![3 => coarse, 1 => fine], 2..40)
}

fn swept(tool: &TurningTool, way: &[[f64; 2]]) -> Vec<Convex> {
    let outline = tool.outline(0.0002, false).unwrap();
    let mut polygons = Vec::new();
    for ends in way.windows(2) {
        let [from, to] = [ends[0], ends[1]].map(|at| Point::near(at).unwrap());
        for part in &outline.cutter {
            let mut polygon = part.polygon.clone();
            if part.polygon.sweep(from, to, &mut polygon) {
                polygons.push(polygon);
            }
        }
    }
    polygons
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    /// Forty motions over a bar of D 60 and 120 mm: within 10⁻⁸ mm² of 3,600.
    #[test]
    fn what_tools_leave_of_a_bar_is_what_another_library_leaves(
        way in way(),
        tool in prop::sample::select(vec![tools::rougher(), tools::profiler(), tools::copier(), tools::parter(), tools::threader()]),
    ) {
        let stock = [[-120.0, 0.0], [0.0, 0.0], [0.0, 30.0], [-120.0, 30.0]];
        let (rings, judge) = both(&stock, &swept(&tool, &way));
        let (ours, theirs) = (rings.iter().map(|ring| twice_area(ring)).sum::<f64>() / 2.0, area(&judge));
        prop_assert!((ours - theirs).abs() < 1e-8, "{ours} against {theirs}");
        let apart = apart(&rings, &judge);
        prop_assert!(apart.abs() < 1e-8, "{apart}");
    }
}

#[test]
fn the_judge_sees_a_micrometre() {
    let stock = [[-120.0, 0.0], [0.0, 0.0], [0.0, 30.0], [-120.0, 30.0]];
    let way = [[2.0, 25.0], [-60.0, 25.0]];
    let (rings, _) = both(&stock, &swept(&tools::rougher(), &way));
    let (_, judge) = both(&stock, &swept(&tools::rougher(), &way.map(|[z, r]| [z, r + 0.001])));
    let apart = apart(&rings, &judge);
    assert!((apart - 0.001 * 60.0).abs() < 0.002, "{apart}");
}
