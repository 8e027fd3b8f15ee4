//! G41 and G42 against LinuxCNC's, with its own tools: a diameter of 0.1 inch and the orientations 2, 6 and 7.
//!
//! Fanuc's tips are the same with X the other way round: 2 is 3, 6 is 8, 7 stays. Every contour here is entered along its own
//! direction or tangent: there both controls end the entry at the same point. LinuxCNC has the figures in mm, in which rs274
//! prints finer.

use rodete::gcode::interpreter::{ToolOffset, Tools};
use rodete::gcode::turning::nose::{Nose, Tip};

use super::common::rs274;
use super::lines::{read_with, setting};
use super::linuxcnc::{NEAR, assert_same, canon, of_canon, of_motions};

/// A block in inches: G, `[X, Z]` with X a radius, and the radius of an arc.
type Block = (u8, [f64; 2], f64);

/// The ball, the cylinder and the two arcs of `lathecomp`, from outside.
const BALL: [Block; 6] = [
    (1, [0.1, 0.0], 0.0),
    (3, [0.0, 0.1], 0.1),
    (1, [0.0, 1.0], 0.0),
    (2, [-0.25, 1.25], 0.25),
    (3, [-0.5, 1.5], 0.25),
    (1, [-0.5, 1.75], 0.0),
];
/// The other way, with a corner between its arcs.
const RETURN: [Block; 7] = [
    (1, [-0.4, 1.85], 0.0),
    (2, [-0.5, 1.75], 0.1),
    (1, [-0.5, 1.5], 0.0),
    (2, [-0.25, 1.25], 0.25),
    (3, [0.0, 1.0], 0.25),
    (1, [0.0, 0.1], 0.0),
    (2, [0.1, 0.0], 0.1),
];

/// A compensated contour in both languages: LinuxCNC's tool, the side, the start, the contour, where G40 goes.
fn both(tool: u8, side: u8, start: [f64; 2], contour: &[Block], end: [f64; 2]) -> [String; 2] {
    let mm = |inches: f64| inches * 25.4;
    let mut linuxcnc = format!("G21 G18 G8 G90 F30\nT{tool} M6\nG0 X{} Z{}\nG{side}\n", mm(start[0]), mm(start[1]));
    let mut fanuc =
        format!("G20 G98 S500 M3 F30.\nT0{tool}0{tool}\nG0 X{:.6} Z{:.6}\nG{side}\n", 2.0 * start[0], start[1]);
    for &(code, [x, z], radius) in contour {
        let (their, our) = if code > 1 {
            (format!(" R{}", mm(radius)), format!(" R{radius:.4}"))
        } else {
            (String::new(), String::new())
        };
        linuxcnc += &format!("G{code} X{} Z{}{their}\n", mm(x), mm(z));
        fanuc += &format!("G{code} X{:.6} Z{z:.6}{our}\n", 2.0 * x);
    }
    linuxcnc += &format!("G40\nG0 X{} Z{}\nM2\n", mm(end[0]), mm(end[1]));
    fanuc += &format!("G40\nG0 X{:.6} Z{:.6}\nM30\n", 2.0 * end[0], end[1]);
    [linuxcnc, fanuc]
}

#[test]
fn the_tip_runs_where_theirs_does_along_their_contours() {
    if !rs274::is_here() {
        return;
    }
    let tangent = rodete::number::trig::tan(10.0_f64.to_radians());
    // A taper of 10 degrees from X1 at Z0 over 2 inches (diameters), and its shoulder. The way back is made under G40.
    let x = (1.0 + 2.0 * tangent) / 2.0;
    let taper = [(0, [0.5, 0.1], 0.0), (1, [0.5, 0.0], 0.0), (1, [x, -2.0], 0.0), (1, [x + 0.1025, -2.0], 0.0)];
    let runs = [
        (2, 41, [0.3, 0.0], &BALL[..], [0.3, 1.75]),
        (2, 42, [0.3, 0.0], &BALL[..], [0.3, 1.75]),
        (7, 42, [-0.3, 1.85], &RETURN[..], [0.3, 0.0]),
        (7, 41, [-0.3, 1.85], &RETURN[..], [0.3, 0.0]),
        (6, 42, [0.5, 0.2], &taper[..], [x + 0.1025, 0.0]),
        (2, 42, [0.5, 0.2], &taper[..], [x + 0.1025, 0.0]),
    ];
    let tip = |number: u8| Some(Nose { radius: 0.05 * 25.4, tip: Tip::new(number).unwrap() });
    let table = "T2 P2 D0.1 Q2\nT6 P6 D0.1 Q6\nT7 P7 D0.1 Q7\n";
    for (tool, side, start, contour, end) in runs {
        let [linuxcnc, fanuc] = both(tool, side, start, contour, end);
        let mut with = setting();
        with.tools = Some(Tools::from_iter(
            [(2, 3), (6, 8), (7, 7)]
                .map(|(number, at)| (number, ToolOffset { nose: tip(at), ..ToolOffset::default() })),
        ));
        let read = read_with(&fanuc, with);
        assert!(read.faults.is_empty(), "{fanuc}\n{:?}", read.faults);
        let theirs = of_canon(&canon(&linuxcnc, Some(table)));
        assert_same(&of_motions(&read.motions), &theirs, NEAR, &fanuc);
        assert!(theirs.len() >= contour.len() + 2, "{theirs:?}");
    }
}
