//! Blades for grooves and threads: which way the spindle turns, on which side the shank is, and how deep they go.
//!
//! M3 cuts where the edge is at the chuck's side of a right-hand tool, or at the other side of a left-hand one.

use super::lathe::{Run, bar};
use super::tools;
use rodete::finding::Grade;
use rodete::gcode::in_force::Spindle;
use rodete::number::trig::tan;
use rodete::removal::turning::alarm::Cause;
use rodete::removal::turning::machine::Lathe;
use rodete::removal::turning::simulation::Setup;
use rodete::removal::turning::stock::Stock;
use rodete::removal::turning::tool::{Cutter, Hand, Holder, Shape, Tip, TurningTool};
use rodete::removal::turning::turret::Turret;

const M3: Option<Spindle> = Some(Spindle::Clockwise);
const M4: Option<Spindle> = Some(Spindle::CounterClockwise);
const EITHER: Option<Spindle> = None;
const R: Hand = Hand::Right;
const L: Hand = Hand::Left;
const N: Hand = Hand::Neutral;
const FRONT: bool = false;
const REAR: bool = true;

/// A blade of 3 mm, 10 mm deep, on a shank of 25 mm.
fn blade(hand: Hand, tip: Tip, turns: Option<Spindle>, face: bool) -> TurningTool {
    let cutter = Cutter::Groover { width: 3.0, depth: 10.0, corner: 0.2, face };
    TurningTool { cutter, hand, tip, turns, ..tools::parter() }
}

fn threader(hand: Hand, turns: Option<Spindle>) -> TurningTool {
    // Its flank stands out 1.5 tan 30° at the bottom of the profile.
    let cutter = Cutter::Threader { angle: 60.0, nose: 0.0, depth: 1.5, leads: [0.5, 2.0] };
    TurningTool { cutter, hand, turns, ..tools::threader() }
}

fn setup(tool: TurningTool, behind: bool, stock: Stock) -> Setup {
    let lathe = Lathe { turret_behind: behind, ..Lathe::default() };
    Setup::new(lathe, stock, Turret { tools: [(1, tool)].into(), body: None })
}

/// From where to where the holder is, along z (0) or r (1).
#[track_caller]
fn shank(tool: &TurningTool, behind: bool, axis: usize) -> [f64; 2] {
    let outline = tool.outline(0.0002, behind).unwrap();
    let (low, high) = outline.holder[0].extent();
    [low.mm()[axis], high.mm()[axis]]
}

#[track_caller]
fn near(found: [f64; 2], wanted: [f64; 2], row: &str) {
    assert!((0..2).all(|at| (found[at] - wanted[at]).abs() < 2e-6), "{row}: {found:?} {wanted:?}");
}

/// One way of the spindle cuts in silence, and the other is told, or both do where there is none; on a cut that `cut`
/// makes.
#[track_caller]
fn only_way(tool: &TurningTool, behind: bool, stock: Stock, right: Option<Spindle>, cut: fn(Run) -> Run, row: &str) {
    for spindle in [M3, M4] {
        let mut run = Run::on(setup(tool.clone(), behind, stock));
        run.control.spindle = spindle.unwrap();
        let run = cut(run);
        assert!(run.steps.iter().any(|step| step.cuts()), "{row}: it cuts");
        let wanted: &[u16] = if right.is_none() || spindle == right { &[] } else { &[154] };
        assert_eq!(run.alarms(), wanted, "{row} with {spindle:?}");
    }
}

#[test]
fn a_blade_on_a_shank_has_one_way_of_the_spindle_and_its_shank_lies_accordingly() {
    use Tip::{Outside as Middle, OutsideLeft as Left, OutsideRight as Right};
    // The blade is 3 mm wide, its shank 25 mm, 0.1 mm behind the edge that it is flush with.
    for (hand, tip, behind, cell, right, z) in [
        // Nothing is said. Right-hand: face up in front, face down behind, the edge at the chuck's side; whichever of its
        // corners is programmed.
        (R, Left, FRONT, None, M3, [0.1, 25.1]),
        (R, Left, REAR, None, M3, [0.1, 25.1]),
        (R, Right, FRONT, None, M3, [-2.9, 22.1]),
        (R, Right, REAR, None, M3, [-2.9, 22.1]),
        (R, Middle, FRONT, None, M3, [-1.4, 23.6]),
        // Left-hand, face up: in front the edge is at the right and the body towards the chuck; behind, where the tip points
        // down the page, the edge is at the chuck's side, and the face that looks up wants M4.
        (L, Left, FRONT, None, M3, [-22.1, 2.9]),
        (L, Left, REAR, None, M4, [0.1, 25.1]),
        (L, Right, FRONT, None, M3, [-25.1, -0.1]),
        (L, Middle, FRONT, None, M3, [-23.6, 1.4]),
        (L, Middle, REAR, None, M4, [-1.4, 23.6]),
        // Neutral, it may lie either face up; its edge is in the middle, or where it is programmed.
        (N, Middle, FRONT, None, EITHER, [-12.5, 12.5]),
        (N, Middle, REAR, None, EITHER, [-12.5, 12.5]),
        (N, Left, FRONT, None, EITHER, [0.1, 25.1]),
        (N, Right, REAR, None, EITHER, [-25.1, -0.1]),
        // The cell says it: right-hand with M4 lies face down in front, face up behind, the edge at the right.
        (R, Left, FRONT, M3, M3, [0.1, 25.1]),
        (R, Left, FRONT, M4, M4, [-22.1, 2.9]),
        (R, Left, REAR, M4, M4, [-22.1, 2.9]),
        (R, Right, FRONT, M4, M4, [-25.1, -0.1]),
        (R, Middle, REAR, M4, M4, [-23.6, 1.4]),
        // Left-hand: face up in front with M3, its body towards the chuck; face down with M4, away from it. Behind, face down
        // with M3 and face up with M4.
        (L, Left, FRONT, M3, M3, [-22.1, 2.9]),
        (L, Left, FRONT, M4, M4, [0.1, 25.1]),
        (L, Left, REAR, M3, M3, [-22.1, 2.9]),
        (L, Middle, REAR, M4, M4, [-1.4, 23.6]),
        // Neutral, which has no side.
        (N, Left, FRONT, M4, M4, [0.1, 25.1]),
        (N, Middle, REAR, M3, M3, [-12.5, 12.5]),
    ] {
        let row = format!("{hand:?} {tip:?} rear {behind} {cell:?}");
        let tool = blade(hand, tip, cell, false);
        assert_eq!(tool.spindle(behind, false), right, "{row}");
        let other = right.and_then(|_| if right == M3 { M4 } else { M3 });
        assert_eq!(tool.spindle(behind, true), other, "{row}, beyond the axis");
        near(shank(&tool, behind, 0), z, &row);
        only_way(&tool, behind, bar(), right, |run| run.rapid(54.0, -40.0).cut(46.0, -40.0).rapid(54.0, -40.0), &row);
    }
}

#[test]
fn a_threading_tool_has_one_way_of_the_spindle_and_its_shank_lies_accordingly() {
    // The shank stands out half a millimetre beyond the flank.
    let side = 1.5 / 3_f64.sqrt() + 0.5;
    let (chuck, away) = ([-side, 25.0 - side], [side - 25.0, side]);
    for (hand, behind, cell, right, z) in [
        (R, FRONT, None, M3, chuck),
        (R, REAR, None, M3, chuck),
        (L, FRONT, None, M3, away),
        (L, REAR, None, M4, chuck),
        (N, FRONT, None, EITHER, [-12.5, 12.5]),
        (N, REAR, None, EITHER, [-12.5, 12.5]),
        (R, FRONT, M4, M4, away),
        (R, REAR, M4, M4, away),
        (L, FRONT, M4, M4, chuck),
        (L, REAR, M3, M3, away),
        (N, FRONT, M4, M4, [-12.5, 12.5]),
    ] {
        let (row, tool) = (format!("{hand:?} rear {behind} {cell:?}"), threader(hand, cell));
        near(shank(&tool, behind, 0), z, &row);
        only_way(&tool, behind, bar(), right, |run| run.rapid(49.0, 5.0).thread(49.0, -20.0, 1.5), &row);
    }
}

#[test]
fn a_blade_for_faces_has_its_edge_outside_where_another_has_it_at_the_chuck() {
    let left = Tip::OutsideLeft;
    for (hand, behind, cell, right, r) in [
        (R, FRONT, None, M3, [-22.1, 2.9]),
        (R, REAR, None, M3, [-22.1, 2.9]),
        (L, FRONT, None, M3, [0.1, 25.1]),
        (L, REAR, None, M4, [-22.1, 2.9]),
        (N, FRONT, None, EITHER, [0.1, 25.1]),
        (R, FRONT, M4, M4, [0.1, 25.1]),
        (L, FRONT, M4, M4, [-22.1, 2.9]),
    ] {
        let (row, tool) = (format!("{hand:?} rear {behind} {cell:?}"), blade(hand, left, cell, true));
        near(shank(&tool, behind, 1), r, &row);
        only_way(&tool, behind, bar(), right, |run| run.rapid(30.0, 2.0).cut(30.0, -4.0).rapid(30.0, 2.0), &row);
    }
}

/// A blade on a bar of 16 mm whose surface is 3 mm behind the tip.
fn inside(cutter: Cutter, tip: Tip) -> TurningTool {
    TurningTool { cutter, tip, ..tools::borer() }
}

fn groover(tip: Tip) -> TurningTool {
    inside(Cutter::Groover { width: 2.0, depth: 2.0, corner: 0.1, face: false }, tip)
}

fn bored(bore: f64) -> Stock {
    Stock { bore, ..bar() }
}

#[test]
fn a_blade_on_a_bar_has_its_edge_at_the_chucks_end() {
    let cut = |run: Run| run.rapid(22.0, 3.0).rapid(22.0, -20.0).cut(25.0, -20.0).rapid(22.0, -20.0).rapid(22.0, 3.0);
    for tip in [Tip::InsideLeft, Tip::Inside, Tip::InsideRight] {
        for (hand, behind, cell, right) in [
            (R, FRONT, None, M3),
            (R, REAR, None, M3),
            (L, FRONT, None, M4),
            (L, REAR, None, M4),
            (N, FRONT, None, EITHER),
            (N, REAR, None, EITHER),
            (R, FRONT, M4, M4),
            (L, FRONT, M3, M3),
        ] {
            let tool = TurningTool { hand, turns: cell, ..groover(tip) };
            only_way(&tool, behind, bored(24.0), right, cut, &format!("{tip:?} {hand:?} rear {behind} {cell:?}"));
            // The bar always comes from the right.
            assert!(shank(&tool, behind, 0)[1] > 70.0, "{tip:?}");
        }
    }
}

#[test]
fn what_is_said_of_an_insert_or_a_drill_stands_above_its_hand() {
    let left = |turns| TurningTool { hand: L, turns, ..tools::rougher() };
    let turn = |run: Run| run.rapid(46.0, 2.0).cut(46.0, -20.0);
    only_way(&left(None), FRONT, bar(), M4, turn, "left-hand, tip 3");
    only_way(&left(M3), FRONT, bar(), M3, turn, "left-hand, tip 3, M3");
    let drill = |turns| TurningTool { turns, ..tools::drill(20.0, 90.0) };
    let bore = |run: Run| run.rapid(0.0, 3.0).cut(0.0, -10.0);
    only_way(&drill(None), REAR, bar(), M3, bore, "drill");
    only_way(&drill(M4), REAR, bar(), M4, bore, "left-hand drill");
}

#[test]
fn a_groove_in_a_bore_is_no_deeper_than_the_blade() {
    // Left, middle and right of the blade on Z-20.
    for tip in [Tip::InsideLeft, Tip::Inside, Tip::InsideRight] {
        let groove =
            |x: f64| Run::on(setup(groover(tip), FRONT, bored(24.0))).rapid(22.0, 3.0).rapid(22.0, -20.0).cut(x, -20.0);
        groove(28.0).silent();
        groove(28.0).rapid(22.0, -20.0).rapid(22.0, 3.0).silent();
        // Before the bar comes to the wall, 3 mm deep, the head does.
        let alarm = groove(28.4).only(103);
        assert!((alarm.depth.unwrap() - 0.2).abs() < 1e-6, "{alarm:?}");
    }
    // In front of the bottom of a hole, 20 mm deep, as deep as the blade reaches.
    let ring = vec![[-150.0, 0.0], [-20.0, 0.0], [-20.0, 12.0], [0.0, 12.0], [0.0, 25.0], [-150.0, 25.0]];
    let hole = Setup { part: Some(vec![ring]), ..setup(groover(Tip::InsideLeft), FRONT, bar()) };
    Run::on(hole).rapid(22.0, 3.0).rapid(22.0, -20.0).cut(28.0, -20.0).rapid(22.0, -20.0).silent();
    // Where the bar reaches as far as the blade it has no head; the bar itself is what touches first.
    let thick =
        TurningTool { holder: Holder::Bar { diameter: 16.0, length: 80.0, reach: 10.0 }, ..groover(Tip::InsideLeft) };
    assert_eq!(thick.outline(0.0002, false).unwrap().holder.len(), 1);
}

#[test]
fn a_thread_in_a_bore_is_no_deeper_than_its_profile() {
    let cutter = Cutter::Threader { angle: 60.0, nose: 0.05, depth: 1.5, leads: [0.5, 3.0] };
    let thread = |deep: f64| {
        let x = 24.0 + 2.0 * deep;
        let run = Run::on(setup(inside(cutter, Tip::Inside), FRONT, bored(24.0))).rapid(x, 5.0);
        run.thread(x, -30.0, 2.5)
    };
    // Cut in one pass.
    thread(1.5).only(149);
    assert!(thread(1.7).alarms().contains(&103), "{:?}", thread(1.7).alarms());
}

#[test]
fn a_groove_in_a_face_is_no_deeper_than_the_blade() {
    let face = |holder: Holder, hand: Hand, z: f64| {
        let tool = TurningTool { holder, ..blade(hand, Tip::OutsideLeft, None, true) };
        Run::on(setup(tool, FRONT, bar())).rapid(30.0, 2.0).cut(30.0, z)
    };
    let shank = Holder::Shank { width: 25.0, length: 60.0 };
    let bar = Holder::Bar { diameter: 16.0, length: 80.0, reach: 11.0 };
    for (holder, hand) in [(shank, R), (shank, L), (bar, R)] {
        face(holder, hand, -10.0).silent();
        let run = face(holder, hand, -10.2);
        let alarm = run.only(103);
        assert!((alarm.depth.unwrap() - 0.2).abs() < 1e-6, "{holder:?} {alarm:?}");
    }
}

#[test]
fn a_boring_bar_that_cuts_away_from_the_chuck_comes_from_the_right_too() {
    let cutter = Cutter::Insert { shape: Shape::D, circle: 9.525, main: 93.0, auxiliary: 32.0, nose: 0.4 };
    let tool = TurningTool { hand: L, ..inside(cutter, Tip::InsideRight) };
    let [left, right] = shank(&tool, FRONT, 0);
    assert!(left < -5.0 && left > -15.0 && (right - 80.0).abs() < 1e-6, "{left} {right}");
    let back =
        |x: f64| Run::on(setup(tool.clone(), FRONT, bored(30.0))).rapid(28.0, 20.0).rapid(28.0, -40.0).cut(x, -40.0);
    back(30.0).cut(30.0, -20.0).rapid(28.0, -20.0).rapid(28.0, 3.0).silent();
    let cut = |run: Run| run.rapid(28.0, 20.0).rapid(28.0, -40.0).rapid(30.0, -40.0).cut(31.0, -38.0).cut(31.0, -20.0);
    only_way(&tool, FRONT, bored(30.0), M3, cut, "back boring");
}

/// Turned sideways, a blade leaves at the wall what its side is drawn in: depth × tan 1°, less what its rounded corner reaches out.
#[test]
fn a_blade_that_scrapes_its_own_wedge_in_rapid_stops_with_the_remedy_that_helps() {
    let wedge = |deep: f64| (deep * tan(1_f64.to_radians())) - 0.2 * (1.0 / tan(44.5_f64.to_radians()) - 1.0);
    let outside = |deep: f64| {
        let x = 50.0 - 2.0 * deep;
        Run::new(bar()).tool(3).rapid(54.0, -20.0).cut(x, -20.0).cut(x, -30.0)
    };
    for deep in [2.0, 5.0, 20.0] {
        let alarm = outside(deep).rapid(54.0, -30.0).only(101);
        assert!((alarm.depth.unwrap() - wedge(deep)).abs() < 1e-5, "{alarm:?}");
        assert_eq!((alarm.cause, alarm.cause.grade()), (Cause::BladeWedge, Grade::Stop));
    }
    // In several rapids it is the same wedge; aside from the second on, it is more.
    for (z, cause) in [(-30.0, Cause::BladeWedge), (-30.05, Cause::RapidInMetal)] {
        let two = outside(5.0).rapid(46.0, -30.0).rapid(54.0, z).raised();
        let causes: Vec<Cause> = two.iter().map(|alarm| alarm.cause).collect();
        assert_eq!(causes, [Cause::BladeWedge, cause], "{two:?}");
    }
    // What the remedy names helps.
    outside(5.0).cut(54.0, -30.0).silent();
    outside(5.0).rapid(40.0, -29.8).rapid(54.0, -29.8).silent();
    // Away from the chuck, and into a face.
    let back = Run::new(bar()).tool(3).rapid(54.0, -30.0).cut(40.0, -30.0).cut(40.0, -20.0).rapid(54.0, -20.0);
    assert_eq!(back.only(101).cause, Cause::BladeWedge);
    let face = |x: f64| {
        let tool = blade(R, Tip::OutsideLeft, None, true);
        Run::on(setup(tool, FRONT, bar())).rapid(30.0, 2.0).cut(30.0, -4.0).cut(20.0, -4.0).rapid(x, 2.0)
    };
    assert_eq!(face(20.0).only(101).cause, Cause::BladeWedge);
    // Into the wall, or from where it has not worked, a blade meets more than its wedge.
    assert_eq!(face(19.9).only(101).cause, Cause::RapidInMetal);
    assert_eq!(outside(5.0).rapid(54.0, -30.05).only(101).cause, Cause::RapidInMetal);
    let again = outside(5.0).cut(54.0, -30.0).rapid(54.0, -30.05).rapid(40.0, -30.05);
    assert_eq!(again.only(101).cause, Cause::RapidInMetal);
}
