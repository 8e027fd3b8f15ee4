//! Before a splitter's nose no upright tool reaches the floor: the simulator of the cut judges the pass of a leaning one.

use rodete::kinds::impeller::clear::cut::{Cut, Which};
use rodete::kinds::impeller::clear::holder::{Stage, clearance};
use rodete::kinds::impeller::clear::pass::Cutting;
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::part::Face;

use crate::impeller_cut::{SHIPPED, judge, simulate};

/// The cut of the new workbook.
fn cut() -> Cut {
    let usual = Cut::usual(6.0, 3.0);
    Cut { s: 0.3, step: 0.7, scallop: 0.025, tolerance: 0.0085, splitters: true, feed: Some(0.1), d_s: 5.0, ..usual }
}

fn leans(plan: &Plan) -> Vec<Face> {
    let face = |cutting| if let Cutting::Leaning { face } = cutting { Some(face) } else { None };
    plan.of(Which::Finish).filter_map(|pass| face(pass.cutting)).collect()
}

#[test]
fn the_new_workbooks_impeller_with_splitters_keeps_the_rests_of_the_one_without() {
    let (plan, found) = judge(&SHIPPED, &cut(), [24, 6], [48, 120]);
    assert_eq!(leans(&plan), [Face::Obverse]);
    assert!(plan.told.root.height <= 0.40 && plan.told.root.width <= 0.35, "{:?}", plan.told.root);
    assert!(found.floor_rest <= 0.03 && plan.told.floor.most <= 0.03, "{found:?} {:?}", plan.told.floor);
    // Without that pass a ridge stays.
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
        let cut = Cut { splitters, scallop: 0.1, ..cut() };
        let (plan, _) = judge(&SHIPPED, &cut, [6, 3], [6, 30]);
        assert_eq!(leans(&plan), [], "{splitters}");
    }
}

#[test]
fn a_tool_leans_only_as_far_as_its_holder_stays_clear() {
    let plan = |from: f64| {
        let stages = [None, Some(Stage { radius: 20.0, from })];
        Plan::new(&SHIPPED.job(), &Cut { stages, ..cut() }).unwrap()
    };
    // A holder that is clear of the blank on the faces alone, and one that is clear of it where the tool leans, too.
    let (near, far) = (plan(19.8), plan(21.0));
    assert_eq!((leans(&near), leans(&far)), (vec![], vec![Face::Obverse]));
    for (plan, from) in [(near, 19.8), (far, 21.0)] {
        let finish = &plan.told.finish;
        let r_t = SHIPPED.r + finish.t;
        let m = finish.stick_out - r_t - cut().d_s;
        assert!(clearance(Stage { radius: 20.0, from }, SHIPPED.r, r_t, m) >= 0.0, "{from} {m}");
    }
}
