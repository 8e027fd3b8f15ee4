//! Fanuc's turning cycles as plain moves, held against positions derived by hand from the drawings of the manuals, against
//! properties that every contour must keep, and against LinuxCNC's interpreter where both mean the same.

use crate::common::rs274;
use crate::common::turned as lathe;

mod grooves;
mod judged;
mod properties;
mod threads;

use lathe::{arc, assert_moves, bare, line, profile, rapid};
use rodete::finding::{AlarmFamily, Exit};
use rodete::gcode::turning::finish::finish;
use rodete::gcode::turning::pattern_repeating::{Repeat, repeat};
use rodete::gcode::turning::rough::{Rough, axial, radial};
use rodete::gcode::turning::trouble::Trouble;
use rodete::gcode::turning::{Move, MoveKind};

const ROUGH: Rough = Rough { depth: 8.0, retract: 1.0, U: 0.5, W: 0.1, feed: Some(0.3), both_axes: None };

/// A step of radius 10 up to Z−20, a 45 degree taper to radius 20 at Z−30, and a face out to radius 30.
fn step_and_taper() -> rodete::gcode::turning::profile::Profile {
    profile([30.0, 2.0], [rapid([10.0, 2.0]), line([10.0, -20.0]), line([20.0, -30.0]), line([30.0, -30.0])])
}

/// Asserts what moves are made, with their X and Z to 1e-9.
#[test]
fn g71_type_i_runs_as_drawn() {
    // C = A + (U, W) = (30.5, 2.1). The contour moved by (0.5, 0.1) has its corners at (10.5, 2.1), (10.5, −19.9),
    // (20.5, −29.9), (30.5, −29.9). Levels: 30.5 − 8 = 22.5, 14.5, and 10.5 as the last (6.5 would be too deep).
    // 22.5 meets the face at Z−29.9; 14.5 meets the taper 4 mm after its beginning: Z−23.9; 10.5 ends where the taper begins.
    let moves = axial(&step_and_taper(), &ROUGH).unwrap();
    assert_moves(
        &moves,
        &[
            ('r', [30.5, 2.1]),
            ('r', [22.5, 2.1]),
            ('f', [22.5, -29.9]),
            ('r', [23.5, -28.9]),
            ('r', [23.5, 2.1]),
            ('r', [14.5, 2.1]),
            ('f', [14.5, -23.9]),
            ('r', [15.5, -22.9]),
            ('r', [15.5, 2.1]),
            ('r', [10.5, 2.1]),
            ('f', [10.5, -19.9]),
            ('r', [11.5, -18.9]),
            ('r', [11.5, 2.1]),
            ('r', [10.5, 2.1]),
            ('f', [10.5, -19.9]),
            ('f', [20.5, -29.9]),
            ('f', [30.5, -29.9]),
            ('r', [30.5, 2.1]),
            ('r', [30.0, 2.0]),
        ],
    );
    assert!(
        moves.iter().all(|m| !matches!(m.kind, MoveKind::Feed(feed) if feed != Some(0.3))),
        "F of the cycle throughout"
    );
    let lines: Vec<usize> = moves.iter().filter_map(|m| m.line).collect();
    assert_eq!(lines, [1, 2, 3, 4], "the pass along the contour names its blocks");
}

#[test]
fn g71_goes_down_at_feed_where_the_first_block_is_g1() {
    let mut contour = step_and_taper();
    contour.elements[0].rapid = false;
    let moves = axial(&contour, &ROUGH).unwrap();
    assert_eq!(bare(&moves[1]), ('f', [22.5, 2.1]));
    assert_eq!(bare(&moves[5]), ('f', [14.5, 2.1]));
}

#[test]
fn g72_is_g71_with_the_axes_exchanged() {
    // The contour of the first test with X and Z exchanged and shifted; its moves must be the exchanged ones.
    let swap = |p: [f64; 2]| [p[1] + 40.0, p[0] - 40.0];
    let mut contour = step_and_taper();
    contour.start = swap(contour.start);
    for element in &mut contour.elements {
        element.to = swap(element.to);
    }
    let faced = radial(&contour, &Rough { U: 0.1, W: 0.5, ..ROUGH }).unwrap();
    let turned = axial(&step_and_taper(), &ROUGH).unwrap();
    let expected: Vec<(char, [f64; 2])> = turned.iter().map(bare).map(|(way, p)| (way, swap(p))).collect();
    assert_moves(&faced, &expected);
}

#[test]
fn g71_type_ii_cuts_one_pocket_after_another() {
    // Start (20, 2); contour from (16, 0): down to 10 at Z−6, up to 16 at Z−12 (pocket 1), level to Z−16, straight down to 12,
    // level to Z−24, straight up to 20 (pocket 2). No allowance, depth 3, R 0.5.
    // Levels: 17: from Z2 to the wall at Z−24. 14: above the lead at 16 between Z2 and Z0, so only the two pockets: in pocket
    // 1 from Z−2 to Z−10 (slopes of 1:1), in pocket 2 from Z−16 to Z−24. In pocket 1 further to 11: Z−5 to Z−7, then 10 at
    // one point: nothing. In pocket 2 further to its bottom, 12.
    let contour = profile(
        [20.0, 2.0],
        [
            rapid([16.0, 0.0]),
            line([10.0, -6.0]),
            line([16.0, -12.0]),
            line([16.0, -16.0]),
            line([12.0, -16.0]),
            line([12.0, -24.0]),
            line([20.0, -24.0]),
        ],
    );
    let rough = Rough { depth: 3.0, retract: 0.5, U: 0.0, W: 0.0, feed: None, both_axes: None };
    let moves = axial(&contour, &rough).unwrap();
    assert_moves(
        &moves,
        &[
            // Level 17, and up the wall to the level of the start.
            ('r', [17.0, 2.0]),
            ('f', [17.0, -24.0]),
            ('f', [20.0, -24.0]),
            ('r', [20.5, -24.0]),
            // Pocket 1, level 14: entered along the lead, which lies under level 17, down the near slope, up the far one.
            ('r', [20.5, 2.0]),
            ('r', [17.5, 2.0]),
            ('f', [16.0, 2.0]),
            ('f', [16.0, 0.0]),
            ('f', [14.0, -2.0]),
            ('f', [14.0, -10.0]),
            ('f', [16.0, -12.0]),
            // Along the brim, which is below the level of the pass before.
            ('f', [16.0, -16.0]),
            ('r', [16.5, -16.0]),
            // Level 11, under level 14.
            ('r', [16.5, -2.0]),
            ('r', [14.5, -2.0]),
            ('f', [14.0, -2.0]),
            ('f', [11.0, -5.0]),
            ('f', [11.0, -7.0]),
            ('f', [14.0, -10.0]),
            ('r', [14.5, -10.0]),
            // Pocket 2, level 14: the level of the pass before is 17, so over 17.5 to its near wall.
            ('r', [17.5, -10.0]),
            ('r', [17.5, -12.0]),
            ('f', [16.0, -12.0]),
            ('f', [16.0, -16.0]),
            ('f', [14.0, -16.0]),
            ('f', [14.0, -24.0]),
            ('f', [17.0, -24.0]),
            ('r', [17.5, -24.0]),
            // Its bottom.
            ('r', [17.5, -16.0]),
            ('r', [14.5, -16.0]),
            ('f', [14.0, -16.0]),
            ('f', [12.0, -16.0]),
            ('f', [12.0, -24.0]),
            ('f', [14.0, -24.0]),
            ('r', [14.5, -24.0]),
            // Out, and once along the contour.
            ('r', [20.0, -24.0]),
            ('r', [20.0, 2.0]),
            ('r', [16.0, 0.0]),
            ('f', [10.0, -6.0]),
            ('f', [16.0, -12.0]),
            ('f', [16.0, -16.0]),
            ('f', [12.0, -16.0]),
            ('f', [12.0, -24.0]),
            ('f', [20.0, -24.0]),
            ('r', [20.0, 2.0]),
        ],
    );
}

#[test]
fn arcs_of_the_contour_end_the_passes_where_the_circle_is() {
    // A convex quarter of radius 10 from (10, 0) to (20, −10) about (10, −10), G3; then a face. Level 16 meets it at
    // Z = −10 + √(100 − 36) = −2; level 13 at −10 + √(100 − 9).
    let contour =
        profile([25.0, 0.0], [rapid([10.0, 0.0]), arc([20.0, -10.0], [10.0, -10.0], false), line([25.0, -10.0])]);
    let rough = Rough { depth: 3.0, retract: 1.0, U: 0.0, W: 0.0, feed: None, both_axes: None };
    let moves = axial(&contour, &rough).unwrap();
    let at = |x: f64| {
        moves.iter().find(|m| matches!(m.kind, MoveKind::Feed(_)) && (m.to[0] - x).abs() < 1e-9).unwrap().to[1]
    };
    assert!((at(16.0) + 2.0).abs() < 1e-12);
    assert!((at(13.0) + 10.0 - 91.0_f64.sqrt()).abs() < 1e-12);
    let round: Vec<&Move> = moves.iter().filter(|m| matches!(m.kind, MoveKind::Arc { .. })).collect();
    assert_eq!(round.len(), 1);
    assert_eq!(round[0].kind, MoveKind::Arc { centre: [10.0, -10.0], clockwise: false, feed: None });
}

#[test]
fn a_contour_that_a_control_refuses_is_refused_with_its_alarm_and_block() {
    let alarm = |contour: &rodete::gcode::turning::profile::Profile, rough: &Rough| -> (Option<u16>, Option<usize>) {
        let trouble = axial(contour, rough).unwrap_err();
        let Trouble { line, exit, .. } = *trouble;
        assert_eq!(exit, Exit::Refused);
        (trouble.alarm(AlarmFamily::Fanuc), line)
    };
    let good = step_and_taper();
    for depth in [0.0, -1.0] {
        assert_eq!(alarm(&good, &Rough { depth, ..ROUGH }), (Some(62), None));
    }
    // Back along Z in the third block.
    let back =
        profile([30.0, 2.0], [rapid([10.0, 2.0]), line([10.0, -20.0]), line([20.0, -15.0]), line([30.0, -30.0])]);
    assert_eq!(alarm(&back, &ROUGH), (Some(64), Some(3)));
    // Down along X in the third block, type I. As type II it is allowed.
    let pocket =
        profile([30.0, 2.0], [rapid([10.0, 2.0]), line([12.0, -10.0]), line([9.0, -20.0]), line([30.0, -30.0])]);
    assert_eq!(alarm(&pocket, &ROUGH), (Some(329), Some(3)));
    axial(&pocket, &Rough { both_axes: Some(true), ..ROUGH }).unwrap();
    // An arc that passes its quarter point, though both its ends lie on the way.
    let bulge =
        profile([30.0, 2.0], [rapid([10.0, 2.0]), line([10.0, -10.0]), arc([12.0, -20.0], [10.0, -14.8], false)]);
    assert_eq!(alarm(&bulge, &ROUGH).0, Some(329));
    // The contour rises above the start.
    let above = profile([25.0, 2.0], [rapid([10.0, 2.0]), line([10.0, -20.0]), line([30.0, -30.0])]);
    assert_eq!(alarm(&above, &ROUGH), (Some(322), Some(3)));
    // It begins with an arc.
    let round = profile([30.0, 2.0], [arc([10.0, 2.0], [20.0, 2.0], true), line([10.0, -20.0])]);
    assert_eq!(alarm(&round, &ROUGH), (Some(65), Some(1)));
    // In G72 X is the axis along the passes.
    let faced =
        profile([2.0, 30.0], [rapid([2.0, 10.0]), line([-20.0, 12.0]), line([-10.0, 20.0]), line([-30.0, 30.0])]);
    let trouble = radial(&faced, &Rough { both_axes: Some(true), ..ROUGH }).unwrap_err();
    assert_eq!((trouble.alarm(AlarmFamily::Fanuc), trouble.line), (Some(329), Some(3)));
    let faced =
        profile([2.0, 30.0], [rapid([2.0, 10.0]), line([-10.0, 12.0]), line([-20.0, 9.0]), line([-30.0, 30.0])]);
    let trouble = radial(&faced, &ROUGH).unwrap_err();
    assert_eq!((trouble.alarm(AlarmFamily::Fanuc), trouble.line), (Some(64), Some(3)));
    assert!(trouble.what.en.starts_with("the contour reverses along Z"));
    // Allowances into the metal, no extent, no numbers.
    assert_eq!(alarm(&good, &Rough { U: -0.5, ..ROUGH }), (None, None));
    assert_eq!(alarm(&good, &Rough { W: -0.1, ..ROUGH }), (None, None));
    assert_eq!(alarm(&profile([30.0, 2.0], [rapid([10.0, 2.0])]), &ROUGH).1, Some(1));
    assert_eq!(alarm(&good, &Rough { depth: f64::NAN, ..ROUGH }), (None, None));
    assert_eq!(alarm(&good, &Rough { retract: -1.0, ..ROUGH }), (None, None));
}

#[test]
fn too_many_passes_are_a_limit_before_any_is_made() {
    let trouble = axial(&step_and_taper(), &Rough { depth: 1e-9, ..ROUGH }).unwrap_err();
    assert_eq!(trouble.exit, Exit::Limit);
    let trouble =
        repeat(&step_and_taper(), &Repeat { relief: [1.0, 1.0], passes: i64::MAX, allowance: [0.0; 2], feed: None })
            .unwrap_err();
    assert_eq!(trouble.exit, Exit::Limit);
}

#[test]
fn g73_repeats_the_contour_by_the_relief_divided_among_the_passes() {
    // Δi = 4, Δk = 2, three passes: moved by (4, 2), (2, 1), (0, 0), each with the allowance (0.5, 0.1).
    let contour = profile([30.0, 2.0], [rapid([10.0, 2.0]), line([10.0, -20.0]), line([30.0, -20.0])]);
    let moves =
        repeat(&contour, &Repeat { relief: [4.0, 2.0], passes: 3, allowance: [0.5, 0.1], feed: Some(0.2) }).unwrap();
    let mut expected = Vec::new();
    for by in [[4.5, 2.1], [2.5, 1.1], [0.5, 0.1]] {
        for (way, [x, z]) in [('r', [30.0, 2.0]), ('r', [10.0, 2.0]), ('f', [10.0, -20.0]), ('f', [30.0, -20.0])] {
            expected.push((way, [x + by[0], z + by[1]]));
        }
    }
    expected.push(('r', [30.0, 2.0]));
    assert_moves(&moves, &expected);
    // A single pass leaves the allowance alone.
    let single =
        repeat(&contour, &Repeat { relief: [4.0, 2.0], passes: 1, allowance: [0.5, 0.1], feed: Some(0.2) }).unwrap();
    assert_moves(&single, &expected[8..]);
    for passes in [0, -3] {
        let trouble = repeat(&contour, &Repeat { relief: [4.0, 2.0], passes, allowance: [0.0; 2], feed: None });
        assert_eq!(trouble.unwrap_err().alarm(AlarmFamily::Fanuc), Some(321));
    }
}

#[test]
fn g70_runs_along_the_contour_and_returns() {
    let moves = finish(&step_and_taper()).unwrap();
    assert_moves(
        &moves,
        &[('r', [10.0, 2.0]), ('f', [10.0, -20.0]), ('f', [20.0, -30.0]), ('f', [30.0, -30.0]), ('r', [30.0, 2.0])],
    );
    assert!(moves[1..4].iter().all(|m| m.kind == MoveKind::Feed(None)), "at the feed in force at each block");
}
