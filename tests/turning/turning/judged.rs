//! Lathe programs against LinuxCNC's interpreter: plain motions written in both languages, and cycles expanded to plain blocks.

use std::fmt::Write;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use rodete::gcode::motion::{self, Motion};
use rodete::machine::axis::Axis;
use rodete::number::trig::hypot;

use super::common::rs274::{self, HALF, Kind};
use super::lines::read;

/// Whether the motions have the same kind, end and centre to the last decimal that rs274 prints. Either may leave out a straight
/// move to where the tool is.
fn same(ours: &[Motion], theirs: &[rs274::Motion]) -> Result<(), String> {
    let place = |motion: &Motion| [motion.to.get(Axis::X), motion.to.get(Axis::Z)];
    let ours: Vec<_> = ours.iter().filter(|motion| !matches!(motion.kind, motion::MotionKind::Dwell(_))).collect();
    let moves = |from: [f64; 2], to: [f64; 2]| hypot(from[0] - to[0], from[1] - to[1]) > 1e-9;
    let mut at = [0.0; 2];
    let ours: Vec<_> = ours
        .into_iter()
        .filter(|motion| {
            let from = std::mem::replace(&mut at, place(motion));
            matches!(motion.kind, motion::MotionKind::Arc(..)) || moves(from, at)
        })
        .collect();
    let mut at = [0.0; 2];
    let theirs: Vec<_> = theirs
        .iter()
        .filter(|motion| {
            let to = [motion.program[0], motion.program[2]];
            let from = std::mem::replace(&mut at, to);
            matches!(motion.kind, Kind::Arc { .. }) || moves(from, to)
        })
        .collect();
    if ours.len() != theirs.len() {
        return Err(format!("{} motions of ours, {} of rs274", ours.len(), theirs.len()));
    }
    for (our, their) in ours.into_iter().zip(theirs) {
        // Arcs may be off by what their text has been rounded by, through the radius.
        let near = |a: f64, b: f64| (a - b).abs() < 4.0 * HALF;
        let mut fits = near(our.to.get(Axis::X), their.program[0]) && near(our.to.get(Axis::Z), their.program[2]);
        fits &= match (our.kind, their.kind) {
            (motion::MotionKind::Rapid, Kind::Rapid) => true,
            (motion::MotionKind::Feed(_) | motion::MotionKind::Thread(_), Kind::Feed(_)) => true,
            (motion::MotionKind::Arc(arc, _), Kind::Arc { centre, turns, plane, .. }) => {
                let centres = near(arc.centre[0], centre[0]) && near(arc.centre[1], centre[1]);
                centres && arc.turns == turns && arc.plane == plane
            }
            _ => false,
        };
        if !fits {
            return Err(format!("ours {our:?}\nrs274 {their:?}"));
        }
    }
    Ok(())
}

/// The motions as plain blocks, X a radius.
fn plain(motions: &[Motion]) -> String {
    let mut text = String::from("G21 G18 G90 G94\nM3 S500\nF100\n");
    for motion in motions {
        let [x, z] = [motion.to.get(Axis::X), motion.to.get(Axis::Z)];
        match motion.kind {
            motion::MotionKind::Rapid => writeln!(text, "G0 X{x:.6} Z{z:.6}"),
            motion::MotionKind::Feed(_) => writeln!(text, "G1 X{x:.6} Z{z:.6}"),
            motion::MotionKind::Thread(thread) => writeln!(text, "G33 X{x:.6} Z{z:.6} K{:.6}", thread.lead),
            motion::MotionKind::Arc(arc, _) => {
                let code = if arc.sweep < 0.0 { 2 } else { 3 };
                let i = arc.centre[1] - motion.from.get(Axis::X);
                let k = arc.centre[0] - motion.from.get(Axis::Z);
                writeln!(text, "G{code} X{x:.6} Z{z:.6} I{i:.6} K{k:.6}")
            }
            motion::MotionKind::Dwell(seconds) => writeln!(text, "G4 P{seconds:.6}"),
        }
        .unwrap();
    }
    text + "M2\n"
}

#[test]
fn linuxcnc_moves_as_the_expanded_cycles_do() {
    if !rs274::is_here() {
        return;
    }
    let contour = "N10 G0 X16.\nG1 Z-10. F.1\nG2 X26. W-5. R5.\nG1 Z-25.\nG3 X40. W-7. R7.\nN20 G1 X52.\n";
    let start = "S800 M3 F.2\nG0 X52. Z3.\n";
    let programs = [
        format!("{start}G71 U2.5 R.8\nG71 P10 Q20 U.6 W.2 F.3\n{contour}G70 P10 Q20"),
        format!("{start}G73 U6. W2. R4\nG73 P10 Q20 U.6 W.2 F.3\n{contour}G70 P10 Q20"),
        format!(
            "{start}G72 W2. R.8\nG72 P10 Q20 U.6 W.2 F.3\nN10 G0 Z-20.\nG1 X40.\nG2 U-10. W5. R5.\nG1 Z-4.\nN20 X10. Z2."
        ),
        format!("{start}G74 R.5\nG74 X30. Z-8. P2500 Q3000"),
        format!("{start}G75 R.5\nG75 X30. Z-8. P2500 Q3000"),
        format!("{start}G76 P021060 Q50 R.05\nG76 X26. Z-20. P1300 Q400 F2."),
        format!("{start}G76 P011029 Q50 R.05\nG76 X30. Z-20. R-1.5 P1300 Q400 F2."),
        format!("{start}G90 X46. Z-20.\nX42. R-1.\nG94 X20. Z0\nZ-2. R-1.\nG92 X40. Z-15. F1.5\nX39.5 R-.8"),
        format!("{start}G83 X0 Z-30. R2. Q7000 P100\nG80\nG32 X40. Z-10. F2.\nX38. Z-20."),
    ];
    for program in programs {
        let ours = read(&program).motions;
        assert!(ours.len() > 8, "{program}");
        let theirs = rs274::run(plain(&ours).as_bytes(), None, None).unwrap_or_else(|why| panic!("{program}\n{why:?}"));
        same(&ours, &theirs.motions).unwrap_or_else(|why| panic!("{program}\n{why}"));
    }
}

/// A plain motion: which code, where to (diameter, Z; thousandths), which axes are named, and which of them by increments.
type Plain = (u8, [i32; 2], [bool; 2], [bool; 2], i32);

/// One program in both languages.
fn both(moves: &[Plain]) -> [String; 2] {
    let mut fanuc = String::from("S500 M3 G98 F100.\nG0 X0 Z0\n");
    let mut linuxcnc = String::from("G21 G18 G7 G90 G94 F100\nS500 M3\nG0 X0 Z0\n");
    let mut at = [0; 2];
    let mm = |thousandths: i32| format!("{:.3}", f64::from(thousandths) / 1000.0);
    for &(code, to, named, increments, bulge) in moves {
        let named = if named == [false; 2] || code > 1 { [true; 2] } else { named };
        let mut to = [0, 1].map(|axis| if named[axis] { to[axis] } else { at[axis] });
        // The radius of an arc reaches at least half its chord.
        let by = [f64::from(to[0] - at[0]) / 2.0, f64::from(to[1] - at[1])];
        if code > 1 && by == [0.0; 2] {
            to[1] += 5_000;
        }
        let by = [f64::from(to[0] - at[0]) / 2.0, f64::from(to[1] - at[1])];
        write!(fanuc, "G{code}").unwrap();
        write!(linuxcnc, "G{code}").unwrap();
        for axis in [0, 1] {
            let [absolute, step] = [["X", "U"], ["Z", "W"]][axis];
            if named[axis] {
                if increments[axis] {
                    write!(fanuc, " {step}{}", mm(to[axis] - at[axis])).unwrap();
                } else {
                    write!(fanuc, " {absolute}{}", mm(to[axis])).unwrap();
                }
                write!(linuxcnc, " {absolute}{}", mm(to[axis])).unwrap();
            }
        }
        if code > 1 {
            let half = hypot(by[0], by[1]) / 2000.0;
            // A Fanuc lathe has no negative R.
            let radius = half * 1.01 + f64::from(bulge) / 1000.0;
            for text in [&mut fanuc, &mut linuxcnc] {
                write!(text, " R{radius:.4}").unwrap();
            }
        }
        fanuc.push('\n');
        linuxcnc.push('\n');
        at = to;
    }
    [fanuc, linuxcnc + "M2\n"]
}

#[test]
fn plain_motions_by_chance_move_as_in_linuxcnc() {
    if !rs274::is_here() {
        return;
    }
    let one =
        (0..4_u8, [-60_000..200_000_i32, -150_000..50_000_i32], any::<[bool; 2]>(), any::<[bool; 2]>(), 0..20_000_i32);
    let mut runner = TestRunner::new(Config { cases: 150, failure_persistence: None, ..Config::default() });
    runner
        .run(&proptest::collection::vec(one, 1..30), |moves| {
            let [fanuc, linuxcnc] = both(&moves);
            let ours = read(&fanuc).motions;
            let theirs = rs274::run(linuxcnc.as_bytes(), None, None)
                .map_err(|why| TestCaseError::fail(format!("{linuxcnc}\n{why:?}")))?;
            same(&ours, &theirs.motions).map_err(|why| TestCaseError::fail(format!("{fanuc}\n{linuxcnc}\n{why}")))
        })
        .unwrap();
}
