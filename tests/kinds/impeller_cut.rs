//! What an impeller's cut takes away and leaves, told by the plan and judged by the simulator of
//! [`impeller_swept`](super::impeller_swept).

use rodete::kinds::impeller::clear::cut::{CutStrategy, Which};
use rodete::kinds::impeller::clear::pass::Cutting;
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::clear::tool::Tool;

use super::impeller_swept::{DEEP, Design, LARGE, MOST, SHIPPED, add, distance, faces, judge, plan, poses, simulate};

#[test]
fn the_usual_cut_of_the_shipped_design_keeps_its_rests() {
    let (plan, found) = judge(&SHIPPED, &CutStrategy::usual(6.0, 3.0), [30, 6], [24, 90]);
    assert!(plan.told.root.height <= 0.40 && plan.told.root.width <= 0.35, "{found:?} {:?}", plan.told.root);
    assert!(found.floor_rest <= 0.03 && plan.told.floor.most <= 0.03, "{found:?} {:?}", plan.told.floor);
    assert!(plan.told.dropped.is_empty());
    assert!(plan.all_blocks(Which::Rough) < 5_000 && plan.all_blocks(Which::Finish) < 12_000);
}

#[test]
fn one_tool_cuts_the_check_designs_and_tells_what_it_leaves() {
    for (design, root) in [(SHIPPED, 1.46), (DEEP, 1.71), (LARGE, 0.71)] {
        let (plan, _) = judge(&design, &CutStrategy::usual(6.0, 6.0), [16, 4], [12, 30]);
        assert!(plan.told.root.height <= root, "{design:?} {:?}", plan.told.root);
    }
}

#[test]
fn splitters_are_cut_round_and_neither_they_nor_their_neighbours_are_touched() {
    for (design, rough, finish) in [(SHIPPED, 6.0, 3.0), (LARGE, 6.0, 6.0)] {
        let cut = CutStrategy { splitters: true, scallop: 0.05, ..CutStrategy::usual(rough, finish) };
        let (plan, found) = judge(&design, &cut, [16, 4], [12, 30]);
        assert!(plan.told.splitter_from.is_some() && found.left < 0.01, "{found:?}");
        assert!(plan.passes.iter().any(|pass| pass.cutting == Cutting::Contour));
        // Where the roughing tool has no room beside a splitter, the finishing tool roughs.
        let rest = plan.passes.iter().any(|pass| matches!(pass.cutting, Cutting::Rest { .. }));
        assert_eq!(rest, design.R < 30.0);
    }
}

#[test]
fn designs_by_chance_are_cut_as_told() {
    let mut state = 20_u32;
    let mut drawn = |low: f64, high: f64| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        low + (high - low) * f64::from(state >> 8) / f64::from(1_u32 << 24)
    };
    let mut judged = 0;
    while judged < 2 {
        let R = drawn(20.0, 80.0);
        let r = R * drawn(0.4, 0.7);
        let design = Design { R, r, N: [3, 5][judged], e: drawn(0.8, 3.0), a_p: (R - r) * drawn(0.1, 0.25) };
        let cut = CutStrategy::usual(drawn(2.0, 8.0), drawn(2.0, 6.0));
        if let Err(refused) = Plan::new(&design.job(), &cut) {
            assert!(refused.largest.is_none_or(|largest| largest < refused.d), "{refused:?}");
            continue;
        }
        judge(&design, &cut, [12, 4], [10, 20]);
        judged += 1;
    }
}

#[test]
fn a_ball_end_mill_cuts_no_deeper_than_a_flat_one() {
    let cut = CutStrategy { finish: Tool::ball(4.0), scallop: 0.1, ..CutStrategy::usual(6.0, 4.0) };
    let plan = plan(&SHIPPED, &cut);
    let all = poses(&plan, &cut);
    let undercut = faces(&SHIPPED, [24, 6]).into_iter().map(|(x, ..)| -distance(x, &all)).fold(0.0, f64::max);
    assert!(undercut <= MOST, "{undercut}");
    let below = all.iter().flat_map(|run| &run.poses).filter(|pose| pose.r_c > 0.0).map(|pose| {
        let centre = add(pose.tip, pose.axis, pose.r_c);
        if SHIPPED.in_blank(centre) { SHIPPED.depth(centre) + pose.r_c - SHIPPED.a_p } else { f64::MIN }
    });
    let below = below.fold(f64::MIN, f64::max);
    assert!((-0.001..=MOST).contains(&below), "{below}");
}

#[test]
fn rounded_ends_leave_what_is_told() {
    for (rough, finish) in [(Tool { d: 6.0, r_c: 1.0 }, Tool { d: 3.0, r_c: 0.5 }), (Tool::ball(6.0), Tool::ball(4.0))]
    {
        let cut = CutStrategy { rough, finish, scallop: 0.05, ..CutStrategy::usual(6.0, 3.0) };
        let (plan, _) = judge(&SHIPPED, &cut, [16, 4], [12, 60]);
        // Ridges as the law says; the corner as high as the round end leaves more than a ridge.
        assert!(plan.told.floor.most <= 0.07 && plan.told.root.height >= finish.r_c / 3.0, "{:?}", plan.told);
    }
}

#[test]
fn a_thin_tool_keeps_out_of_the_straight_end_of_a_thick_blade_at_a_narrow_hub() {
    for (design, rough, finish) in [
        (Design { R: 29.878_778, r: 23.314_398, N: 2, e: 2.931_121, a_p: 3.839_135 }, 3.720_912, 1.795_543),
        (Design { R: 23.83, r: 16.0, N: 2, e: 3.93, a_p: 4.49 }, 4.91, 1.94),
    ] {
        let cut = CutStrategy { scallop: 0.1, blank: 60.0, ..CutStrategy::usual(rough, finish) };
        let found = simulate(&design, &plan(&design, &cut), &cut, [32, 6], [8, 20]);
        assert!(found.undercut <= MOST && found.too_deep <= MOST && found.tops < 1e-9, "{design:?} {found:?}");
    }
}

#[test]
fn a_tool_that_does_not_fit_at_the_hub_cuts_no_blade_and_leaves_the_share_told() {
    let cut = CutStrategy { partly: true, scallop: 0.1, ..CutStrategy::usual(8.0, 3.0) };
    let (plan, _) = judge(&SHIPPED, &cut, [16, 4], [12, 30]);
    assert!(plan.told.rough_from > 0.1 && plan.told.finish_from == 0.0 && plan.told.uncut == 0.0);
    assert!(plan.passes.iter().any(|pass| matches!(pass.cutting, Cutting::Rest { .. })));
    let cut = CutStrategy { finish: Tool::flat(7.5), ..cut };
    let plan = super::impeller_swept::plan(&SHIPPED, &cut);
    let found = simulate(&SHIPPED, &plan, &cut, [16, 4], [24, 40]);
    assert!(found.undercut <= MOST && found.too_deep <= MOST && found.tops < 1e-9, "{found:?}");
    assert!(plan.told.finish_from > 0.0 && (found.left - plan.told.uncut).abs() < 0.05, "{found:?} {:?}", plan.told);
    // Check value: of 160,000 places of the turned surface no pose of either program came to so many.
    assert!((plan.told.uncut - 0.0537).abs() < 1e-3, "{:?}", plan.told);
    assert!(plan.told.dropped.iter().any(|one| matches!(one.cutting, Cutting::Flank { .. })));
}
