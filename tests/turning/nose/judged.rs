//! Contours by chance against LinuxCNC's interpreter, in G18 with an orientation in the tool table.
//!
//! Where both controls mean the same: from the second piece on, with round outer corners. LinuxCNC ends the first
//! piece at right angles to itself, not to the next one, so every contour here is entered along its own first direction; its
//! orientations have X the other way round (`Tip`); it makes no arc at outer corners of less than 0.05 rad, so turns here are
//! none or more than that; it too goes straight from the last compensated point to the first one after G40.

use std::fmt::Write;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use rodete::gcode::in_force::Compensation::{Left, Right};
use rodete::gcode::turning::nose::{Element, Nose, Path, Tip};
use rodete::number::trig::{atan2, hypot};

use super::common::rs274::{self, Kind};
use super::contour::{at, distance, line, run};
use super::properties::{contour, shares};

/// The orientation of LinuxCNC for each of ours.
const ORIENTATION: [u8; 10] = [0, 4, 3, 2, 1, 5, 8, 7, 6, 9];
/// The unit of the last decimal that is printed, with what rounding does to it.
const PRINTED: f64 = 1.5e-4;

fn headings(element: &Element) -> [f64; 2] {
    match element.path {
        Path::Arc { centre, sweep } => [element.from, element.to]
            .map(|end| atan2(end[1] - centre[1], end[0] - centre[0]) + std::f64::consts::FRAC_PI_2.copysign(sweep)),
        _ => [atan2(element.to[1] - element.from[1], element.to[0] - element.from[0]); 2],
    }
}

fn clear_turns(elements: &[Element]) -> bool {
    elements.windows(2).all(|pair| {
        let turn = headings(&pair[1])[0] - headings(&pair[0])[1];
        let (sin, cos) = rodete::number::trig::sin_cos(turn);
        let turn = atan2(sin, cos).abs();
        !(1e-9..0.1).contains(&turn)
    })
}

fn program(elements: &[Element], left: bool) -> String {
    let start = elements[0].from;
    let mut text = format!("G21 G18 G90 G8 G64\nT1 M6\nG0 X{:.9} Z{:.9}\n", start[1], start[0]);
    let _ = writeln!(text, "G{} F100", if left { 41 } else { 42 });
    for element in elements {
        let [z, x] = element.to;
        let _ = match element.path {
            Path::Arc { centre, sweep } => writeln!(
                text,
                "G{} X{x:.9} Z{z:.9} I{:.9} K{:.9}",
                if sweep > 0.0 { 3 } else { 2 },
                centre[1] - element.from[1],
                centre[0] - element.from[0]
            ),
            _ => writeln!(text, "G1 X{x:.9} Z{z:.9}"),
        };
    }
    text + "G40\nG1 X50 Z50\nM2\n"
}

/// In what the two differ, if in anything.
fn difference(ours: &[Element], theirs: &[rs274::Motion]) -> Option<String> {
    let mut ours = ours.iter().filter(|element| element.length() > PRINTED);
    for their in theirs {
        let [x, _, z, ..] = their.program;
        if hypot(x - their.from[0], z - their.from[2]) < PRINTED && matches!(their.kind, Kind::Feed(_)) {
            continue;
        }
        let Some(our) = ours.next() else { return Some(format!("they have {their:?} more")) };
        if distance(our.to, [z, x]) > PRINTED {
            return Some(format!("{our:?} and {their:?}"));
        }
        match (our.path, their.kind) {
            (Path::Line, Kind::Feed(_)) => {}
            (Path::Arc { centre, sweep }, Kind::Arc { centre: found, turns, .. })
                if distance(centre, found) < PRINTED && (turns > 0) == (sweep > 0.0) => {}
            _ => return Some(format!("{our:?} and {their:?}")),
        }
    }
    ours.next().map(|our| format!("we have {our:?} more"))
}

#[test]
fn linuxcnc_moves_the_same_tip() {
    if !rs274::is_here() {
        return;
    }
    let mut runner = TestRunner::deterministic();
    let (mut arcs, mut programmed) = (0, 0);
    let cases = (shares(), 0.1..0.8, 1_u8..10, any::<bool>());
    let cases = prop::strategy::Strategy::prop_filter(cases, "the turns are clear", |(shares, ..)| {
        clear_turns(&contour(shares, 1.3))
    });
    for _ in 0..200 {
        let (shares, R, tip, left) = prop::strategy::ValueTree::current(&cases.new_tree(&mut runner).unwrap());
        let mut elements = contour(&shares, 1.3);
        let (sin, cos) = rodete::number::trig::sin_cos(headings(&elements[0])[0]);
        let before = |way: f64| [elements[0].from[0] - way * cos, elements[0].from[1] - way * sin];
        let (first, second) = (line(before(20.0), before(10.0)), line(before(10.0), elements[0].from));
        elements.splice(0..0, [first, second]);
        let side = if left { Left } else { Right };
        let nose = Nose { radius: R, tip: Tip::new(tip).unwrap() };
        let ours = run(&elements, side, nose, 0.0, Some([50.0, 50.0]));
        let table = format!("T1 P1 D{:.12} Q{}\n", 2.0 * R / 25.4, ORIENTATION[usize::from(tip)]);
        let text = program(&elements, left);
        let theirs = rs274::run(text.as_bytes(), None, Some(&table));
        let (Ok(ours), Ok(theirs)) = (&ours, &theirs) else { panic!("{ours:?}\n{theirs:?}\n{text}") };
        let ours: Vec<Element> = ours.iter().filter(|(_, tag)| *tag > 0).map(|&(element, _)| element).collect();
        // The rapid move to the start, and the entry.
        if let Some(difference) = difference(&ours, &theirs.motions[2..]) {
            panic!("{difference}\nR {R}, tip {tip}\n{text}\n{}", theirs.text);
        }
        arcs += ours.iter().filter(|element| matches!(element.path, Path::Arc { .. })).count();
        programmed += elements[1..].iter().filter(|element| matches!(element.path, Path::Arc { .. })).count();
        assert!(ours.iter().all(|element| distance(at(element, 1.0), element.to) < 1e-9));
    }
    assert!(programmed > 200 && arcs > programmed + 200, "{arcs} arcs, {programmed} of them programmed");
}
