//! Compensated points reckoned by hand.

use std::f64::consts::{FRAC_PI_2, PI};

use rodete::gcode::in_force::Compensation::{self, Left, Off, Right};
use rodete::gcode::turning::nose::{Element, Nose, Path, Point, STRAIGHT, Stage, Step, Tip};
use rodete::limits::STILL_PIECES;
use rodete::number::trig::tan;

use super::contour::{arc, distance, line, nose, run, through};

fn near(found: Point, expected: Point) {
    assert!(distance(found, expected) < 1e-12, "{found:?}, {expected:?} expected");
}

fn ends(contour: &[Element], side: Compensation, nose: Nose) -> Vec<Point> {
    run(contour, side, nose, STRAIGHT, None).unwrap().iter().map(|(element, _)| element.to).collect()
}

/// A face, a chamfer of 45 degrees, a cylinder; G42 outside with tip 3, R 0.8. The published corrections of a chamfer are
/// R(1 − tan(φ/2)) in Z and twice that in the diameter, φ the turn: 0.468629 and 0.937258.
#[test]
fn a_chamfer_gets_the_published_corrections() {
    let contour = through(&[[5.0, 0.0], [0.0, 0.0], [0.0, 8.0], [-2.0, 10.0], [-20.0, 10.0]]);
    let points = ends(&contour, Right, nose(0.8, 3));
    let correction = 0.8 * (1.0 - tan(PI / 8.0));
    assert!((correction - 0.468_629_150_1).abs() < 1e-10);
    near(points[0], [0.0, -0.8]);
    near(points[1], [0.0, 8.0 - correction]);
    near(points[2], [-2.0 - correction, 10.0]);
    near(points[3], [-20.8, 10.0]);
    assert_eq!(points.len(), 4);
}

/// Another angle: a taper of 30 degrees to the axis. At its foot the path turns by 30 degrees away from the tool.
#[test]
fn a_taper_gets_r_times_one_minus_the_tangent_of_half_the_turn() {
    let rise = 10.0 * tan(PI / 6.0);
    let contour = through(&[[3.0, 8.0], [0.0, 8.0], [-10.0, 8.0 + rise], [-30.0, 8.0 + rise]]);
    let points = ends(&contour, Right, nose(0.4, 3));
    // Turn of 30 degrees away from the tool at the end of the taper.
    near(points[1], [-10.0 + 0.4 * (tan(PI / 12.0) - 1.0), 8.0 + rise]);
    near(points[2], [-30.4, 8.0 + rise]);
}

/// A cylinder of radius 10 and a shoulder at Z −20: an inner corner, where the tip of tool 3 reaches the corner itself, and
/// the centre stays R away from both; the other tips lie R by their vector from the centre.
#[test]
fn each_of_the_nine_orientations_shifts_the_same_centre() {
    let contour = through(&[[5.0, 10.0], [2.0, 10.0], [-20.0, 10.0], [-20.0, 30.0]]);
    let centre = [-19.2, 10.8];
    let signs = [[0, 0], [1, 1], [-1, 1], [-1, -1], [1, -1], [1, 0], [0, 1], [-1, 0], [0, -1], [0, 0]];
    for (tip, [z, x]) in (0_u8..).zip(signs) {
        let points = ends(&contour, Right, nose(0.8, tip));
        near(points[1], [centre[0] + 0.8 * f64::from(z), centre[1] + 0.8 * f64::from(x)]);
    }
    near(ends(&contour, Right, nose(0.8, 3))[1], [-20.0, 10.0]);
    assert_eq!(Tip::new(10), None);
}

/// A convex quarter of radius 5 between a face and a cylinder: the centre's arc has 5.8; a fillet of 5 before a shoulder: 4.2.
/// All joins are tangent: the tips are R from the points of contact towards the quadrant of tool 3.
#[test]
fn arcs_keep_their_centre_and_change_their_radius() {
    let contour = [
        line([3.0, 0.0], [0.0, 0.0]),
        line([0.0, 0.0], [0.0, 5.0]),
        arc([0.0, 5.0], [-5.0, 10.0], [-5.0, 5.0], FRAC_PI_2),
        line([-5.0, 10.0], [-20.0, 10.0]),
        arc([-20.0, 10.0], [-25.0, 15.0], [-20.0, 15.0], -FRAC_PI_2),
        line([-25.0, 15.0], [-25.0, 30.0]),
    ];
    let placed = run(&contour, Right, nose(0.8, 3), STRAIGHT, None).unwrap();
    assert_eq!(placed.iter().map(|&(_, tag)| tag).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5]);
    near(placed[1].0.to, [0.0, 4.2]);
    near(placed[2].0.to, [-5.8, 10.0]);
    near(placed[3].0.to, [-20.8, 10.0]);
    near(placed[4].0.to, [-25.0, 14.2]);
    for (at, centre, radius, sweep) in [(2, [-5.8, 4.2], 5.8, FRAC_PI_2), (4, [-20.8, 14.2], 4.2, -FRAC_PI_2)] {
        let Element { from, path: Path::Arc { centre: found, sweep: swept }, .. } = placed[at].0 else { panic!() };
        near(found, centre);
        assert!((distance(from, found) - radius).abs() < 1e-12);
        assert!((swept - sweep).abs() < 1e-12);
    }
}

/// A cylinder that runs into an arc of radius 5 bulging towards +X about Z −15, X 9: the path turns towards the tool. Found by
/// Pythagoras: the centre of the nose at X = 10 + R is 5 + R from (−15, 9).
#[test]
fn an_inner_corner_of_a_line_and_an_arc_is_where_the_offsets_meet() {
    let R = 0.8;
    let half = (25.0_f64 - 1.0).sqrt();
    let start = [-15.0 + half, 10.0];
    let end = [-15.0 - half, 10.0];
    let sweep = PI - 2.0 * rodete::number::trig::asin(0.2);
    let contour = [
        line([3.0, 10.0], [0.0, 10.0]),
        line([0.0, 10.0], start),
        arc(start, end, [-15.0, 9.0], sweep),
        line(end, [-40.0, 10.0]),
    ];
    let placed = run(&contour, Right, nose(R, 0), STRAIGHT, None).unwrap();
    let x: f64 = 10.0 + R - 9.0;
    let z = ((5.0 + R) * (5.0 + R) - x * x).sqrt();
    near(placed[1].0.to, [-15.0 + z, 10.0 + R]);
    near(placed[2].0.to, [-15.0 - z, 10.0 + R]);
    let Path::Arc { sweep: swept, .. } = placed[2].0.path else { panic!() };
    assert!((swept - (PI - 2.0 * rodete::number::trig::asin(x / (5.0 + R)))).abs() < 1e-12);
}

/// Two bulges of radius 5, their centres 8 apart: they meet 3 above the line of their centres, the centre of the nose
/// (R 1) stands √(6² − 4²) above it.
#[test]
fn an_inner_corner_of_two_arcs_is_where_the_offsets_meet() {
    let (first, second) = ([0.0, 10.0], [-8.0, 10.0]);
    let sweep = rodete::number::trig::atan2(3.0, -4.0);
    let contour = [
        line([5.0, 5.0], [5.0, 10.0]),
        arc([5.0, 10.0], [-4.0, 13.0], first, sweep),
        arc([-4.0, 13.0], [-13.0, 10.0], second, sweep),
    ];
    let placed = run(&contour, Right, nose(1.0, 9), STRAIGHT, None).unwrap();
    near(placed[0].0.to, [6.0, 10.0]);
    near(placed[1].0.to, [-4.0, 10.0 + 20.0_f64.sqrt()]);
    near(placed[2].0.to, [-14.0, 10.0]);
}

/// Outer corners of lines: a quarter turn meets at R, R; past it the offsets go on by R each and a line joins them; back on
/// itself that is a square end of 2R by R. Round corners are arcs about the corner.
#[test]
fn outer_corners_go_on_straight_or_round() {
    let quarter = through(&[[5.0, 0.0], [0.0, 0.0], [0.0, 10.0], [-10.0, 10.0]]);
    let points = ends(&quarter, Right, nose(1.0, 0));
    near(points[1], [1.0, 11.0]);
    let back = through(&[[15.0, 0.0], [10.0, 0.0], [0.0, 0.0], [10.0, 0.0]]);
    let placed = run(&back, Right, nose(1.0, 0), STRAIGHT, None).unwrap();
    let points: Vec<Point> = placed.iter().map(|(element, _)| element.to).collect();
    near(points[0], [10.0, 1.0]);
    near(points[1], [-1.0, 1.0]);
    near(points[2], [-1.0, -1.0]);
    near(points[3], [10.0, -1.0]);
    assert_eq!(placed.iter().map(|&(_, tag)| tag).collect::<Vec<_>>(), [0, 1, 1, 2]);

    let round = run(&quarter, Right, nose(1.0, 3), 0.0, None).unwrap();
    near(round[1].0.to, [0.0, 9.0]);
    let Path::Arc { centre, sweep } = round[2].0.path else { panic!() };
    near(centre, [-1.0, 9.0]);
    near(round[2].0.to, [-1.0, 10.0]);
    assert!((sweep - FRAC_PI_2).abs() < 1e-12);
    let round = run(&back, Right, nose(1.0, 0), 0.0, None).unwrap();
    let Path::Arc { centre, sweep } = round[2].0.path else { panic!() };
    near(centre, [0.0, 0.0]);
    assert!((sweep - PI).abs() < 1e-12, "round the outside, over Z −1");
}

/// The retraced arc turns back on itself outside; the tip passes round it.
#[test]
fn an_arc_can_be_gone_back_along() {
    let contour = [
        line([3.0, 0.0], [0.0, 0.0]),
        line([0.0, 0.0], [0.0, 5.0]),
        arc([0.0, 5.0], [-5.0, 10.0], [-5.0, 5.0], FRAC_PI_2),
        arc([-5.0, 10.0], [0.0, 5.0], [-5.0, 5.0], -FRAC_PI_2),
    ];
    let placed = run(&contour, Right, nose(0.5, 0), STRAIGHT, None).unwrap();
    let points: Vec<Point> = placed.iter().map(|(element, _)| element.to).collect();
    near(points[2], [-5.0, 10.5]);
    near(points[3], [-5.5, 10.5]);
    near(points[4], [-5.5, 9.5]);
    near(points[5], [-5.0, 9.5]);
    near(points[6], [-0.5, 5.0]);
}

/// The first piece ends at right angles to the start of the second, whatever its own direction; the last before G40 ends at
/// right angles to its own end; the way out ends on the programmed point.
#[test]
fn the_nose_comes_and_goes_at_right_angles() {
    let contour = [line([10.0, 20.0], [2.0, 10.0]), line([2.0, 10.0], [-20.0, 10.0])];
    let placed = run(&contour, Right, nose(0.8, 3), STRAIGHT, Some([10.0, 30.0])).unwrap();
    near(placed[0].0.from, [10.0, 20.0]);
    near(placed[0].0.to, [1.2, 10.0]);
    near(placed[1].0.to, [-20.8, 10.0]);
    near(placed[2].0.from, [-20.8, 10.0]);
    near(placed[2].0.to, [10.0, 30.0]);
    // Towards an arc, at right angles to its tangent.
    let contour = [line([10.0, 20.0], [5.0, 0.0]), arc([5.0, 0.0], [0.0, 5.0], [0.0, 0.0], FRAC_PI_2)];
    near(ends(&contour, Right, nose(0.8, 0))[0], [5.8, 0.0]);
    near(ends(&contour, Left, nose(0.8, 0))[0], [4.2, 0.0]);
    // Alone, to its own direction.
    near(ends(&contour[..1], Left, nose(0.0, 3))[0], [5.0, 0.0]);
    near(ends(&[line([5.0, 1.0], [0.0, 1.0])], Left, nose(0.5, 0))[0], [0.0, 0.5]);
}

/// From one side to the other: the nose leaves the first piece at right angles and crosses to the second one's start.
#[test]
fn a_change_of_side_crosses_the_path_at_the_corner() {
    let mut stage = Stage::new(STRAIGHT);
    let mut placed = Vec::new();
    let points = [[5.0, 10.0], [0.0, 10.0], [-10.0, 10.0], [-20.0, 10.0]];
    for (element, side) in through(&points).into_iter().zip([Right, Right, Left]) {
        stage.push(Step { element, side, nose: nose(0.5, 0), rapid: false, tag: () }, &mut placed).unwrap();
    }
    stage.finish(&mut placed).unwrap();
    let ends: Vec<Point> = placed.iter().map(|(element, ())| element.to).collect();
    for (found, expected) in ends.iter().zip([[0.0, 10.5], [-10.0, 10.5], [-10.0, 9.5], [-20.0, 9.5]]) {
        near(*found, expected);
    }
    assert_eq!(ends.len(), 4);
}

/// Dwells and pieces without way keep their place, where the nose stands between its pieces.
#[test]
fn what_makes_no_way_keeps_its_place() {
    let mut stage = Stage::new(STRAIGHT);
    let mut placed = Vec::new();
    let still = |at| Element { from: at, to: at, path: Path::Still };
    let steps = [
        (still([5.0, 10.0]), Right),
        (line([5.0, 10.0], [0.0, 10.0]), Right),
        (still([0.0, 10.0]), Right),
        (line([0.0, 10.0], [-10.0, 10.0]), Right),
        (line([-10.0, 10.0], [-10.0, 10.0]), Right),
        (still([-10.0, 10.0]), Right),
        (line([-10.0, 10.0], [-10.0, 20.0]), Right),
        (still([-10.0, 20.0]), Off),
        (line([-10.0, 20.0], [5.0, 20.0]), Off),
    ];
    for (tag, (element, side)) in steps.into_iter().enumerate() {
        stage.push(Step { element, side, nose: nose(0.5, 0), rapid: false, tag }, &mut placed).unwrap();
    }
    assert!(stage.idle());
    assert_eq!(placed.iter().map(|&(_, tag)| tag).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
    near(placed[0].0.to, [5.0, 10.0]);
    near(placed[2].0.to, [0.0, 10.5]);
    near(placed[4].0.to, [-9.5, 10.5]);
    near(placed[5].0.to, [-9.5, 10.5]);
    near(placed[7].0.to, [-9.5, 20.0]);
    near(placed[8].0.to, [5.0, 20.0]);
    for pair in placed.windows(2) {
        near(pair[1].0.from, pair[0].0.to);
    }
    assert_eq!(STILL_PIECES, 17);
}

/// A full circle inside a bore of radius 10, entered and left on the tangent.
#[test]
fn a_full_circle_stays_full() {
    let contour = [
        line([0.0, 5.0], [-5.0, 0.0]),
        line([-5.0, 0.0], [0.0, 0.0]),
        arc([0.0, 0.0], [0.0, 0.0], [0.0, 10.0], 2.0 * PI),
        line([0.0, 0.0], [5.0, 0.0]),
    ];
    let placed = run(&contour, Left, nose(1.0, 0), STRAIGHT, None).unwrap();
    let Path::Arc { centre, sweep } = placed[2].0.path else { panic!() };
    near(centre, [0.0, 10.0]);
    near(placed[2].0.from, [0.0, 1.0]);
    near(placed[2].0.to, [0.0, 1.0]);
    assert!((sweep - 2.0 * PI).abs() < 1e-12);
}

/// A fillet of the nose's own radius: its arc shrinks to a point, the corner is left to the nose.
#[test]
fn a_fillet_of_the_nose_radius_is_cut_standing() {
    let contour = [
        line([5.0, 10.0], [0.0, 10.0]),
        line([0.0, 10.0], [-19.2, 10.0]),
        arc([-19.2, 10.0], [-20.0, 10.8], [-19.2, 10.8], -FRAC_PI_2),
        line([-20.0, 10.8], [-20.0, 20.0]),
    ];
    let points = ends(&contour, Right, nose(0.8, 3));
    near(points[1], [-20.0, 10.0]);
    near(points[2], [-20.0, 10.0]);
    near(points[3], [-20.0, 19.2]);
}
