//! The sample programs of the source on coordinate systems, against positions derived by hand from their text.

use rodete::gcode::motion::{Motion, MotionKind, Plane};
use rodete::machine::axis::Axis;
use rodete::machine::var_file::VarFile;

use super::common::rs274::{Judge, Six};
use super::corpus::{good, tools};
use super::ours;

const INCH: f64 = 25.4;

/// Rapid, feed, or a full circle about a centre counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
enum By {
    G0,
    G1(f64),
    G3(f64, [f64; 2]),
}

use By::{G0, G1, G3};

/// How each motion goes and where it ends in machine coordinates, in inches; feeds in inches per minute.
type Table = Vec<(By, [f64; 3])>;

fn run(name: &str) -> (Vec<Motion>, VarFile) {
    let (program, var) = good(name);
    let tools = tools();
    ours::run(&program, &Judge { var: var.as_deref(), tools: Some(&tools), ..Judge::default() }).unwrap()
}

fn assert_follows(motions: &[Motion], table: &Table) {
    assert_eq!(motions.len(), table.len());
    for (motion, (by, to)) in motions.iter().zip(table) {
        let feed = |feed: f64| (feed / INCH * 1e9).round() / 1e9;
        let done = match motion.kind {
            MotionKind::Rapid => G0,
            MotionKind::Feed(f) => G1(feed(f.value)),
            MotionKind::Arc(arc, f) => {
                assert_eq!((arc.plane, arc.turns), (Plane::XY, 1), "{motion:?}");
                // The centre in machine coordinates: the offsets are those of the end.
                let centre = [Axis::X, Axis::Y].map(|axis| motion.machine.get(axis) - motion.to.get(axis));
                let centre = [0, 1].map(|axis| (arc.centre[axis] + centre[axis]) / INCH);
                G3(feed(f.value), centre.map(|c| (c * 1e9).round() / 1e9))
            }
            MotionKind::Thread(_) | MotionKind::Dwell(_) => panic!("{motion:?}"),
        };
        assert_eq!(done, *by, "{motion:?}");
        let expected: Six = [to[0] * INCH, to[1] * INCH, to[2] * INCH, 0.0, 0.0, 0.0];
        let miss = expected.iter().zip(motion.machine.0).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(miss < 1e-9, "{motion:?} against {expected:?}");
    }
}

/// Five circles of radius 0.1 about their middles, cut at a depth that counts from the top.
fn five_circles(top: f64) -> Table {
    let deep = top - 0.25;
    let mut table = Vec::new();
    for [x, y] in [[0.0, 0.0], [0.5, 0.0], [-0.5, 0.0], [0.0, 0.5], [0.0, -0.5]] {
        let start = x - 0.1;
        table.push((G0, [start, y, top]));
        table.push((G1(1.0), [start, y, deep]));
        table.push((G3(1.0, [x, y]), [start, y, deep]));
        table.push((G0, [start, y, top]));
    }
    // After the last circle the tool goes straight to the origin.
    table.pop();
    table.push((G0, [0.0, 0.0, top]));
    table
}

#[test]
fn the_square_lies_where_g55_of_the_variable_file_puts_it() {
    let (motions, _) = run("source-square");
    assert_follows(
        &motions,
        &vec![
            (G0, [2.0, 1.0, -2.0]),
            (G1(2.0), [2.0, 1.0, -2.2]),
            (G1(2.0), [3.0, 1.0, -2.2]),
            (G1(2.0), [3.0, 2.0, -2.2]),
            (G1(2.0), [2.0, 2.0, -2.2]),
            (G1(2.0), [2.0, 1.0, -2.2]),
            (G0, [2.0, 1.0, -2.0]),
            (G0, [0.0, 0.0, 0.0]),
        ],
    );
}

#[test]
fn the_five_circles_lie_about_the_offsets_that_g10_sets() {
    let (motions, var) = run("source-five-circles");
    assert_follows(&motions, &five_circles(0.0));
    for (number, offset) in [(5221, 0.0), (5241, 0.5), (5261, -0.5), (5282, 0.5), (5302, -0.5)] {
        let left = var.get(number).unwrap();
        assert!((left - offset).abs() < 1e-12, "#{number} is {left}");
    }
}

#[test]
fn g92_z1_at_the_start_puts_the_five_circles_an_inch_deeper() {
    let (motions, var) = run("source-g92-shift");
    assert_follows(&motions, &five_circles(-1.0));
    // G92.1 at the end leaves nothing behind.
    for number in 5210..=5219 {
        assert!(var.get(number).unwrap().abs() < 1e-12, "#{number}");
    }
}
