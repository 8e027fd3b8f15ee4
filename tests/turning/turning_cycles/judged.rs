//! G71 against LinuxCNC's own roughing cycle, where both mean the same: where the passes of a level begin and end.

use rodete::gcode::turning::MoveKind;
use rodete::gcode::turning::rough::{Rough, axial};

use super::lathe::{arc, line, profile, rapid};
use super::rs274;

/// A turned figure with four pockets, straight and round, in the words of LinuxCNC: X is the radius, the arcs have centres.
const FIGURE: &[u8] = b"G18 G21 G90 G8 G54 F400
O100 SUB
G0 X0.2
G1 X1.1 Z0.9
G1 X3 Z-1
G1 Z-4
G1 X2.25 Z-5.25
G1 Z-7
G2 X4 Z-8.75 I1.75 K0
G1 X4.5
G3 X7 Z-11.25 I0 K-2.5
G3 X6.5 Z-12.75 I-2.5 K0
G2 X6.5 Z-20.75 I3 K-4
G1 X10 Z-21
G1 X8.5 Z-22.6
G1 X10 Z-25.2
G1 Z-27.2
G1 X12 Z-36
G1 Z-38
G1 X15
O100 ENDSUB
G0 X15 Z3
G71 Q100 X15 Z3 D0 I1 R0.3
M2
";

/// Levels at which no pocket has its brim: LinuxCNC cuts a pocket from its brim on, Fanuc by the levels of the whole.
const LEVELS: [f64; 8] = [14.0, 13.0, 11.0, 9.0, 8.0, 6.0, 5.0, 2.0];

#[test]
fn linuxcnc_begins_and_ends_its_passes_where_g71_of_type_ii_does() {
    if !rs274::is_here() {
        return;
    }
    let contour = profile(
        [15.0, 3.0],
        [
            rapid([0.2, 3.0]),
            line([1.1, 0.9]),
            line([3.0, -1.0]),
            line([3.0, -4.0]),
            line([2.25, -5.25]),
            line([2.25, -7.0]),
            arc([4.0, -8.75], [4.0, -7.0], true),
            line([4.5, -8.75]),
            arc([7.0, -11.25], [4.5, -11.25], false),
            arc([6.5, -12.75], [4.5, -11.25], false),
            arc([6.5, -20.75], [9.5, -16.75], true),
            line([10.0, -21.0]),
            line([8.5, -22.6]),
            line([10.0, -25.2]),
            line([10.0, -27.2]),
            line([12.0, -36.0]),
            line([12.0, -38.0]),
            line([15.0, -38.0]),
        ],
    );
    let rough = Rough { depth: 1.0, retract: 0.3, U: 0.0, W: 0.0, feed: None, both_axes: Some(true) };
    let level = |x: f64| LEVELS.iter().position(|level| (level - x).abs() < 1e-4);
    let mut ours = Vec::new();
    let mut at = contour.start;
    for m in axial(&contour, &rough).unwrap() {
        if matches!(m.kind, MoveKind::Feed(_)) && (m.to[0] - at[0]).abs() < 1e-9 {
            ours.extend(level(at[0]).map(|level| (level, at[1], m.to[1])));
        }
        at = m.to;
    }
    let mut theirs: Vec<(usize, f64, f64)> = rs274::run(FIGURE, None, None)
        .unwrap()
        .motions
        .iter()
        .filter(|motion| matches!(motion.kind, rs274::Kind::Feed(_)) && motion.from[0] == motion.program[0])
        .filter_map(|motion| level(motion.from[0]).map(|level| (level, motion.from[2], motion.program[2])))
        .collect();
    let order = |a: &(usize, f64, f64), b: &(usize, f64, f64)| (a.0, -a.1).partial_cmp(&(b.0, -b.1)).unwrap();
    ours.sort_by(order);
    theirs.sort_by(order);
    assert_eq!(ours.len(), 11, "three levels have a pocket beside the open way: {ours:?}");
    assert_eq!(ours.len(), theirs.len(), "{ours:?} {theirs:?}");
    for (ours, theirs) in ours.iter().zip(&theirs) {
        let close = ours.0 == theirs.0 && (ours.1 - theirs.1).abs() < 1e-4 && (ours.2 - theirs.2).abs() < 1e-4;
        assert!(close, "{ours:?} {theirs:?}");
    }
}
