//! What cannot be cut with the nose is refused with its numbers.

use std::f64::consts::FRAC_PI_2;

use rodete::gcode::in_force::Compensation::{Left, Off, Right};
use rodete::gcode::turning::nose::{Element, Misfit, Path, STRAIGHT, Stage, Step};
use rodete::limits::STILL_PIECES;

use super::contour::{arc, line, nose, run, through};

#[test]
fn an_arc_cannot_begin_or_end_the_compensation() {
    let bow = arc([5.0, 0.0], [0.0, 5.0], [0.0, 0.0], FRAC_PI_2);
    assert_eq!(run(&[bow], Right, nose(0.8, 3), STRAIGHT, None).unwrap_err(), (Misfit::ArcEntry, 0));
    let mut stage = Stage::new(STRAIGHT);
    let mut placed = Vec::new();
    stage
        .push(
            Step { element: line([9.0, 0.0], [5.0, 0.0]), side: Right, nose: nose(0.8, 3), rapid: false, tag: 0 },
            &mut placed,
        )
        .unwrap();
    let end = stage.push(Step { element: bow, side: Off, nose: nose(0.8, 3), rapid: false, tag: 1 }, &mut placed);
    assert_eq!(end, Err((Misfit::ArcExit, 1)));
    assert_eq!(placed.len(), 2, "nothing is lost");
}

#[test]
fn a_nose_larger_than_an_inner_arc_is_refused_with_both_radii() {
    let bow = |r: f64| {
        [
            line([5.0, 10.0], [0.0, 10.0]),
            line([0.0, 10.0], [-10.0, 10.0]),
            arc([-10.0, 10.0], [-10.0 - r, 10.0 + r], [-10.0, 10.0 + r], -FRAC_PI_2),
        ]
    };
    assert_eq!(
        run(&bow(0.5), Right, nose(0.8, 3), STRAIGHT, None).unwrap_err(),
        (Misfit::Arc { radius: 0.8, arc: 0.5 }, 2)
    );
    assert!(run(&bow(0.5), Left, nose(0.8, 3), STRAIGHT, None).is_ok(), "on its outside any nose fits");
    assert!(run(&bow(0.7995), Right, nose(0.8, 3), STRAIGHT, None).is_ok(), "half a rounding step is none");
    assert!(run(&bow(0.798), Right, nose(0.8, 3), STRAIGHT, None).is_err());
}

#[test]
fn a_groove_narrower_than_the_nose_is_refused_at_its_bottom() {
    let groove = |width: f64| {
        through(&[
            [5.0, 10.0],
            [0.0, 10.0],
            [-10.0, 10.0],
            [-10.0, 5.0],
            [-10.0 - width, 5.0],
            [-10.0 - width, 10.0],
            [-20.0, 10.0],
        ])
    };
    let refused = run(&groove(1.5), Right, nose(0.8, 3), STRAIGHT, None).unwrap_err();
    let (Misfit::Short { radius, length, taken }, 3) = refused else { panic!("{refused:?}") };
    assert!((radius - 0.8).abs() < 1e-12 && (length - 1.5).abs() < 1e-12 && (taken - 1.6).abs() < 1e-12);
    assert!(run(&groove(1.6), Right, nose(0.8, 3), STRAIGHT, None).is_ok());
}

/// A cylinder into a bowl of radius 3 whose wall stands at right angles to it: the offset line at 2 and the offset circle of 1
/// about the height 0 have no point in common. A nose of 1.5 just touches, and needs a bowl that reaches there.
#[test]
fn an_inner_corner_whose_offsets_do_not_meet_is_refused() {
    let bowl = [
        line([20.0, 0.0], [10.0, 0.0]),
        line([10.0, 0.0], [0.0, 0.0]),
        arc([0.0, 0.0], [3.0, 3.0], [3.0, 0.0], -FRAC_PI_2),
    ];
    let (misfit, place) = run(&bowl, Right, nose(2.0, 3), STRAIGHT, None).unwrap_err();
    let Misfit::Corner { radius, turn } = misfit else { panic!("{misfit:?}") };
    assert_eq!(place, 2);
    assert!((radius - 2.0).abs() < 1e-12 && (turn - FRAC_PI_2).abs() < 1e-12);
    assert!(run(&bowl, Right, nose(1.4, 3), STRAIGHT, None).is_ok());
    assert!(run(&bowl, Left, nose(2.0, 3), STRAIGHT, None).is_ok());
}

/// Out and back along the same line with the tool between: no nose fits into a cusp.
#[test]
fn a_cusp_on_the_side_of_the_tool_is_refused() {
    let contour = [
        line([15.0, 0.0], [10.0, 0.0]),
        line([10.0, 0.0], [0.0, 0.0]),
        arc([0.0, 0.0], [5.0, 5.0], [0.0, 5.0], FRAC_PI_2),
    ];
    let refused = run(&contour, Right, nose(0.8, 3), STRAIGHT, None).unwrap_err();
    assert!(matches!(refused, (Misfit::Corner { .. }, 2)), "{refused:?}");
    assert!(run(&contour, Left, nose(0.8, 3), STRAIGHT, None).is_ok());
}

#[test]
fn the_nose_may_not_change_and_too_many_pieces_without_way_are_refused() {
    let mut stage = Stage::new(STRAIGHT);
    let mut placed = Vec::new();
    let mut push = |stage: &mut Stage<usize>, element, radius, tag| {
        stage.push(Step { element, side: Right, nose: nose(radius, 3), rapid: false, tag }, &mut placed)
    };
    push(&mut stage, line([9.0, 0.0], [5.0, 0.0]), 0.8, 0).unwrap();
    assert_eq!(push(&mut stage, line([5.0, 0.0], [0.0, 0.0]), 0.4, 1), Err((Misfit::Changed, 1)));

    let mut stage = Stage::new(STRAIGHT);
    push(&mut stage, line([9.0, 0.0], [5.0, 0.0]), 0.8, 0).unwrap();
    let still = Element { from: [5.0, 0.0], to: [5.0, 0.0], path: Path::Still };
    for tag in 1..=STILL_PIECES {
        push(&mut stage, still, 0.8, tag).unwrap();
    }
    assert_eq!(push(&mut stage, still, 0.8, 99), Err((Misfit::Still, 99)));
}

/// One misfit is one refusal: until the side goes off, the rest passes as programmed; then compensation works again.
#[test]
fn after_a_misfit_the_path_passes_as_programmed_until_the_compensation_ends() {
    let mut stage = Stage::new(STRAIGHT);
    let mut placed = Vec::new();
    let small = arc([5.0, 0.0], [4.5, 0.5], [4.5, 0.0], FRAC_PI_2);
    let steps =
        [(line([9.0, 0.0], [5.0, 0.0]), Left), (small, Left), (small, Left), (line([4.5, 0.5], [9.0, 0.0]), Off)];
    let mut refused = 0;
    for (tag, (element, side)) in steps.into_iter().enumerate() {
        refused += usize::from(
            stage.push(Step { element, side, nose: nose(0.8, 0), rapid: false, tag }, &mut placed).is_err(),
        );
    }
    assert_eq!(refused, 1);
    assert_eq!(placed.len(), 4);
    assert_eq!(placed[3].0, line([4.5, 0.5], [9.0, 0.0]));
    assert!(stage.idle());
}

/// An undercut behind a neck: each corner has room for the nose, but the neck is narrower than the nose.
#[test]
fn a_neck_that_no_neighbouring_pieces_make_is_told_with_its_depth() {
    let cuts = |neck: f64| {
        let contour = through(&[
            [10.0, 10.0],
            [5.0, 10.0],
            [0.0, 10.0],
            [0.0, 7.0],
            [2.0, 7.0],
            [2.0, 4.0],
            [-4.0, 4.0],
            [-4.0, 7.0],
            [-neck, 7.0],
            [-neck, 10.0],
            [-20.0, 10.0],
        ]);
        let mut stage = Stage::new(STRAIGHT);
        let mut placed = Vec::new();
        for (tag, element) in contour.into_iter().enumerate() {
            stage.push(Step { element, side: Right, nose: nose(0.8, 3), rapid: false, tag }, &mut placed).unwrap();
        }
        stage.finish(&mut placed).unwrap();
        stage.cuts()
    };
    assert_eq!(cuts(1.7), []);
    let found = cuts(1.5);
    assert!(!found.is_empty());
    for cut in &found {
        assert!((cut.depth - 0.1).abs() < 1e-9 || cut.depth <= 0.1, "{cut:?}");
        assert!(cut.along.abs_diff(cut.into) > 1, "neighbours are refused, not told: {cut:?}");
    }
    assert!(found.iter().any(|cut| (cut.along, cut.into) == (2, 8) || (cut.along, cut.into) == (8, 2)), "{found:?}");
}
