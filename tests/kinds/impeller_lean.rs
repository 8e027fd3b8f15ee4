//! Before a splitter's nose no upright tool reaches the floor: the simulator of the cut judges the pass of a leaning one.

use rodete::kinds::impeller::clear::cut::{CutStrategy, Which};
use rodete::kinds::impeller::clear::holder::{Blank, Stage};
use rodete::kinds::impeller::clear::pass::Cutting;
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::part::Face;
use rodete::kinds::impeller::solids::Stock;

use crate::impeller_swept::{Design, SHIPPED, judge, plan, simulate};

/// The cut of the new workbook.
fn cut() -> CutStrategy {
    let usual = CutStrategy::usual(6.0, 3.0);
    CutStrategy {
        s: 0.3,
        step: 0.7,
        scallop: 0.025,
        tolerance: 0.0087,
        splitters: true,
        feed: Some(0.1),
        d_s: 5.0,
        ..usual
    }
}

fn leans(plan: &Plan) -> Vec<Face> {
    let face = |cutting| if let Cutting::Leaning { face } = cutting { Some(face) } else { None };
    plan.of(Which::Finish).filter_map(|pass| face(pass.cutting)).collect()
}

#[test]
fn the_new_workbooks_impeller_with_splitters_keeps_the_rests_of_the_one_without() {
    let (plan, found) = judge(&SHIPPED, &cut(), [24, 6], [48, 120]);
    assert_eq!(leans(&plan), [Face::Obverse, Face::Reverse]);
    assert!(plan.told.root.height <= 0.40 && plan.told.root.width <= 0.35, "{:?}", plan.told.root);
    assert!(found.floor_rest <= 0.03 && plan.told.floor.most <= 0.03, "{found:?} {:?}", plan.told.floor);
    // Without these passes a ridge stays.
    let upright = Plan {
        passes: plan.passes.into_iter().filter(|pass| !matches!(pass.cutting, Cutting::Leaning { .. })).collect(),
        ..plan
    };
    let found = simulate(&SHIPPED, &upright, &cut(), [1, 1], [48, 120]);
    assert!(found.floor_rest > 0.035, "{found:?}");
}

#[test]
fn a_tool_leans_nowhere_where_upright_lanes_leave_no_more_than_their_ridges() {
    for splitters in [false, true] {
        let cut = CutStrategy { splitters, scallop: 0.1, ..cut() };
        let (plan, _) = judge(&SHIPPED, &cut, [6, 3], [6, 30]);
        assert_eq!(leans(&plan), [], "{splitters}");
    }
}

#[test]
fn a_tool_leans_only_where_its_holder_stays_clear() {
    let job = SHIPPED.job();
    let plan = |stage| Plan::new(&job, &CutStrategy { stages: [None, stage], ..cut() }).unwrap();
    let stock = Stock { torus: job.part.circle.torus, length: cut().blank };
    let blank = Blank { stock, L: job.machine.L };
    let leaning = |plan: &Plan| {
        let of = plan.passes.iter().filter(|pass| matches!(pass.cutting, Cutting::Leaning { .. }));
        of.map(|pass| pass.points.clone()).collect::<Vec<_>>()
    };
    let passes = leaning(&plan(None));
    let highest = blank.highest(passes.iter().map(Vec::as_slice));
    assert!(highest > 15.0, "{highest}");
    // Of any radius, just not above the highest place of the blank over the tip, and just above it.
    for (from, same) in [(highest - 0.01, false), (highest + 0.01, true)] {
        let stage = Stage { radius: f64::INFINITY, from };
        let held = leaning(&plan(Some(stage)));
        assert_eq!(held == passes, same, "{from}");
        assert!(blank.clearance(stage, held.iter().map(Vec::as_slice)) >= 0.0, "{from}");
    }
    // Below the lowest of them none.
    let stage = Stage { radius: f64::INFINITY, from: 5.0 };
    assert_eq!(leaning(&plan(Some(stage))), Vec::<Vec<_>>::new());
}

/// A ridge as high as the channel is deep once let the axis lean by 28° off the nose, past the floor and into the splitter, and took B
/// to 109°.
#[test]
fn the_pass_round_a_splitter_leans_no_farther_than_brings_it_to_the_floor_nor_than_b_may_go() {
    let design = Design { R: 20.0, r: 14.3, N: 3, e: 1.0, a_p: 0.3 };
    let cut = |scallop: f64, most: Option<f64>| {
        let usual = CutStrategy::usual(5.0, 3.0);
        CutStrategy { s: 0.0, scallop, partly: true, splitters: true, tilt: [None, most], ..usual }
    };
    let highest = |cut: &CutStrategy| {
        let plan = plan(&design, cut);
        let round = plan.of(Which::Finish).filter(|pass| matches!(pass.cutting, Cutting::SplitterFlanks { .. }));
        round.flat_map(|pass| &pass.points).map(|stand| stand.B.to_degrees()).fold(0.0, f64::max)
    };
    let upright = highest(&cut(0.0005, None));
    let leaning = highest(&cut(0.3, None));
    // atan of (e/2 + a)/r.
    let through = (2.0_f64 / 14.3).atan().to_degrees();
    assert!(leaning > upright + 2.0 && leaning < upright + through + 0.1, "{upright} {leaning}");
    let held = highest(&cut(0.3, Some(upright + 2.0)));
    assert!(held > upright + 0.5 && held <= upright + 2.0, "{upright} {held}");
    assert_eq!(highest(&cut(0.3, Some(leaning + 1.0))), leaning);
}
