//! G81 to G89 in programs of the dialect fagor-8055-t.

use rodete::finding::{Finding, Grade, Place};
use rodete::gcode::control::FAGOR_8055_T;
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::motion::{FeedMode, Motion, MotionKind, Plane};
use rodete::machine::axis::Axis;

use super::rs274;

const PUBLISHED: &[u8] = include_bytes!("../../golden/lathe-g85-as-printed.nc");

/// The motions of a program, its refusals (line and text), and what is remarked.
fn run(program: &[u8]) -> (Vec<Motion>, Vec<(usize, String)>, Vec<String>) {
    let mut interpreter = Interpreter::over(program, Setting::new(&FAGOR_8055_T));
    let (mut motions, mut faults) = (Vec::new(), Vec::new());
    for next in interpreter.by_ref() {
        match next {
            Ok(motion) => motions.push(motion),
            Err(fault) => faults.push((fault.line, fault.what.en.to_string())),
        }
    }
    let remarks = interpreter.remarks().iter().map(|finding| finding.what.en.to_string()).collect();
    (motions, faults, remarks)
}

fn xz(motion: &Motion) -> [f64; 2] {
    [motion.to.get(Axis::X), motion.to.get(Axis::Z)]
}

#[test]
fn the_published_program_runs_its_cycle_from_where_it_stands_and_goes_on() {
    let (motions, faults, _) = run(PUBLISHED);
    assert_eq!(faults, []);
    let cycle: Vec<&Motion> = motions.iter().filter(|motion| motion.n == Some(60)).collect();
    assert_eq!(cycle.len(), 61, "fifteen passes of four motions, and back");
    assert!(cycle.iter().all(|motion| motion.line == 6));
    // X55 is the radius 27.5; the passes take F0.1, per revolution, of the block before.
    assert_eq!(xz(cycle[0]), [27.5, -1.0]);
    assert!(
        matches!(cycle[1].kind, MotionKind::Feed(feed) if feed.mode == FeedMode::PerRevolution && feed.value == 0.1)
    );
    assert_eq!(xz(cycle[60]), [27.5, 0.0]);
    let mut swept = 0.0;
    for motion in &cycle {
        if let MotionKind::Arc(arc, feed) = motion.kind {
            assert_eq!((arc.plane, arc.centre, feed.value), (Plane::ZX, [0.0, 25.0], 0.1));
            assert!((arc.radius - 15.0).abs() < 1e-9);
            swept += arc.sweep;
        }
    }
    assert!((swept - std::f64::consts::FRAC_PI_2).abs() < 1e-9, "a quarter circle: {swept}");
    let after = motions.last().unwrap();
    assert_eq!((after.n, after.kind, xz(after)), (Some(70), MotionKind::Rapid, [40.0, 80.0]));
}

#[test]
fn the_words_of_each_cycle_are_read_as_diameters_radii_and_hundredths() {
    // What each cycle does first, and what its second motion leads to; X and Q on the diameter.
    for (block, first, second) in [
        ("G81 X20 Z0 Q20 R-20 C5 D1", [15.0, 2.0], [15.0, -20.0]),
        ("G82 X20 Z-10 Q0 R0 C6 D1", [20.0, -4.0], [4.0, -4.0]),
        // Moved by L1 and M0.5: from Z2 to Z−9.5 in two steps of 5.75.
        ("G82 X20 Z-10 Q0 R0 C6 D1 L1 M0.5", [20.0, -3.75], [5.25, -3.75]),
        ("G83 X0 Z0 I10 B5 D1 K50", [0.0, 1.0], [0.0, -5.0]),
        ("G84 X20 Z0 Q40 R-10 C10 D1 I10 K0", [10.0, 2.0], [10.0, 0.0]),
        ("G86 X40 Z0 Q40 R-20 I1 B1 D3 C2 A0", [23.0, 0.0], [19.0, 0.0]),
        ("G87 X40 Z0 Q10 R0 I1 B1 D3 C2 A0", [20.0, 3.0], [20.0, -1.0]),
        ("G88 X30 Z-5 Q20 R-5 C2 D1 K100", [20.0, -5.0], [16.0, -5.0]),
        ("G89 X30 Z0 Q30 R-5 C2 D1 K100", [15.0, 2.0], [15.0, 1.0]),
    ] {
        let program = format!("G95 F0.2 S500 M3\nG0 X40 Z2\n{block}\nM30\n");
        let (motions, faults, _) = run(program.as_bytes());
        assert_eq!(faults, [], "{block}");
        assert_eq!([xz(&motions[1]), xz(&motions[2])], [first, second], "{block}");
        assert_eq!(motions.last().map(xz), Some([20.0, 2.0]), "{block}: back at its start");
        let dwells: Vec<f64> =
            motions.iter().filter_map(|m| if let MotionKind::Dwell(s) = m.kind { Some(s) } else { None }).collect();
        let expected: &[f64] = match &block[..3] {
            "G83" => &[0.5],
            "G88" | "G89" => &[1.0],
            _ => &[],
        };
        assert_eq!(dwells, expected, "{block}");
    }
}

#[test]
fn the_feeds_of_a_cycle_are_its_own() {
    let program = b"G95 F0.2 S500 M3\nG0 X40 Z2\nG81 X20 Z0 Q20 R-20 C20 L0.5 F0.3 H0.05\nG1 X30\nM30\n";
    let (motions, faults, _) = run(program);
    assert_eq!(faults, []);
    let feeds: Vec<f64> = motions
        .iter()
        .filter_map(|m| if let MotionKind::Feed(feed) = m.kind { Some(feed.value) } else { None })
        .collect();
    // One pass and out; the last roughing pass, to the profile and along it; the finishing pass; G1 at F0.2 again.
    assert_eq!(feeds, [0.2, 0.2, 0.3, 0.3, 0.05, 0.05, 0.2]);
}

#[test]
fn a_cycle_is_over_with_its_block() {
    let (motions, faults, _) = run(b"G95 F0.2 S500 M3\nG0 X40 Z2\nG82 X20 Z-3 Q0 R0 C3 D1\nX50\nM30\n");
    assert_eq!(faults, []);
    let last = motions.last().unwrap();
    assert_eq!((last.line, last.kind, xz(last)), (4, MotionKind::Rapid, [25.0, 2.0]));
    assert_eq!(motions.iter().filter(|motion| motion.line == 4).count(), 1);
}

#[test]
fn missing_and_unknown_words_and_impossible_cycles_are_refused_by_name() {
    for (block, what) in [
        ("G81 X20 Z0 Q20 R-20", "C is missing in G81"),
        ("G82 Z-10 Q0 R0 C6", "X is missing in G82"),
        ("G83 X0 Z0 B5", "I is missing in G83"),
        ("G84 X20 Z0 Q40 R-10 C10 I10", "K is missing in G84"),
        ("G85 X20 Z-10 Q0 R0 C1 K10", "I is missing in G85"),
        ("G86 X40 Z0 Q40 R-20 I1 B1 D3", "C is missing in G86"),
        ("G88 X30 Z-5 Q20 R-9 D1", "C is missing in G88"),
        ("G81 X20 Z0 Q20 R-20 C5 A1", "A in G81 is not supported"),
        ("G86 X40 Z0 Q40 R-20 I1 B1 D3 C2 V3", "V in G86 is not supported"),
        ("G86 X40 Z0 Q40 R-20 I1 B1 D3 C2 K5", "K in G86 is not supported"),
        ("G83 X0 Z0 I10 B0 D1 H3", "H in G83 with B0"),
        // Whatever stands before it.
        ("G83 X0 Z0 I10 B0 D1 C1 H3 L2 R0.8", "H in G83 with B0"),
        ("G83 X0 Z0 I10 B0 D1 C1 H0 L2", "L in G83 with B0"),
        ("G83 X0 Z0 I10 B0 D1 C1 H0 L0 R0", "R in G83 with B0"),
        ("G83 X0 Z0 I10 B5 D1 K1.5", "K1.5 in G83: K counts units of 0.01 s"),
        ("G88 X30 Z-5 Q20 R-5 C2 D1 K0.5", "K0.5 in G88: K counts units of 0.01 s"),
        ("G89 X30 Z0 Q30 R-5 C2 D1 K0.5", "K0.5 in G89: K counts units of 0.01 s"),
        ("G81 X20 Z0 Q20 R-20 C0", "the step C is not above 0"),
        ("G85 X20 Z-10 Q0 R0 C1 I0 K1", "two radii"),
        ("G81 X10 Z0 Q60 R-20 C5", "the cycle cannot start here"),
    ] {
        let program = format!("G95 F0.2 S500 M3\nG0 X40 Z2\n{block}\nM30\n");
        let (motions, faults, _) = run(program.as_bytes());
        assert_eq!(faults.len(), 1, "{block}: {faults:?}");
        assert_eq!(faults[0].0, 3, "{block}");
        assert!(faults[0].1.contains(what), "{block}: {}", faults[0].1);
        assert_eq!(motions.len(), 1, "{block}: the block is not executed");
    }
}

/// What a block of a program of these cycles is told, with its grade.
fn told(block: &str) -> Vec<(Grade, &'static str, String)> {
    let program = format!("G71 G90 G95 F0.2 S500 T5 D5 M3\nG0 X40 Z2\n{block}\nM30\n");
    let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(&FAGOR_8055_T));
    let faults: Vec<_> = interpreter.by_ref().filter_map(Result::err).collect();
    assert_eq!(faults, [], "{block}");
    let line_3 = |finding: &Finding| matches!(finding.place, Place::Line { line: 3, .. });
    let told = interpreter.remarks().into_iter().filter(line_3);
    told.map(|one| (one.grade, one.rule().code, one.what.en.to_string())).collect()
}

#[test]
fn a_b_of_0_is_told_to_tap_with_its_tool() {
    let [(grade, code, what)] = told("G83 X0 Z0 I10 B0 D1 H0 C1 K50").try_into().unwrap();
    assert_eq!((grade, code), (Grade::Caution, "G0695"));
    assert!(what.starts_with("G83 with B0 taps, with T5:"), "{what}");
    assert_eq!(told("G83 X0 Z0 I10 B5 D1 H0 C1 K50"), []);
}

#[test]
fn the_sign_of_d_in_a_thread_changes_no_motion() {
    let [one, other] = ["D2", "D-2"].map(|D| {
        let block =
            format!("G95 F0.2 S500 M3\nG0 X40 Z9\nG86 X30 Z8 Q30 R-33 I1.2 B0.3 E0.05 {D} L0.05 C2 J2 A29.5\nM30\n");
        let (motions, faults, _) = run(block.as_bytes());
        assert_eq!(faults, [], "{D}");
        motions
    });
    assert!(one.len() > 50);
    assert_eq!(one, other);
    // Of the other cycles D is a length.
    for (block, what) in [
        ("G81 X20 Z0 Q20 R-20 C5 D-1", "negative D in the cycle"),
        ("G83 X0 Z0 I10 B5 D-1", "negative D in G83"),
        ("G88 X30 Z-5 Q20 R-9 C2 D-1", "negative D or K in the grooving"),
    ] {
        let (_, faults, _) = run(format!("G95 F0.2 S500 M3\nG0 X40 Z2\n{block}\nM30\n").as_bytes());
        assert!(matches!(&faults[..], [(3, fault)] if fault == what), "{block}: {faults:?}");
    }
}

#[test]
fn points_of_a_cycle_beyond_the_axis_are_told_as_those_of_a_motion() {
    let beyond = |block| -> Vec<Grade> {
        told(block).into_iter().filter(|(_, code, _)| *code == "G0808").map(|(grade, ..)| grade).collect()
    };
    assert_eq!(beyond("G81 X-20 Z0 Q30 R-20 C5 D1"), [Grade::Caution]);
    assert_eq!(beyond("G82 X30 Z-2 Q-1.6 R0 C1 D1"), [Grade::Note], "facing");
    assert_eq!(beyond("G88 X30 Z-5 Q-20 R-5 C2 D1"), [Grade::Caution]);
    assert_eq!(beyond("G83 X-10 Z0 I10 B5 D1"), [Grade::Caution]);
    assert_eq!(beyond("G81 X20 Z0 Q30 R-20 C5 D1"), []);
}

#[test]
fn a_groove_is_remarked_for_the_width_of_its_cutter() {
    let (_, faults, remarks) = run(b"G95 F0.2 S500 M3\nG0 X40 Z2\nG88 X30 Z-5 Q20 R-9 C2 D1\nM30\n");
    assert_eq!(faults, []);
    assert!(remarks.iter().any(|remark| remark.contains("width of the grooving tool")), "{remarks:?}");
}

#[test]
fn linuxcnc_makes_the_same_motions_of_the_expanded_cycle() {
    if !rs274::is_here() {
        return;
    }
    let (motions, ..) = run(PUBLISHED);
    let ours: Vec<&Motion> = motions.iter().filter(|motion| motion.n == Some(60)).collect();
    // As plain blocks: radii, and the centres of arcs from where they begin.
    let mut program = String::from("G18 G21 G90 G91.1 G8 G94 F100\nG0 X27.5 Z0\n");
    for motion in &ours {
        let ([x, z], [from_x, from_z]) = (xz(motion), [motion.from.get(Axis::X), motion.from.get(Axis::Z)]);
        match motion.kind {
            MotionKind::Arc(arc, _) => {
                let code = if arc.sweep > 0.0 { 3 } else { 2 };
                let [k, i] = [arc.centre[0] - from_z, arc.centre[1] - from_x];
                program += &format!("G{code} X{x:.6} Z{z:.6} I{i:.6} K{k:.6}\n");
            }
            MotionKind::Rapid => program += &format!("G0 X{x:.6} Z{z:.6}\n"),
            _ => program += &format!("G1 X{x:.6} Z{z:.6}\n"),
        }
    }
    let canon = rs274::run(format!("{program}M2\n").as_bytes(), None, None).unwrap();
    let theirs = &canon.motions[1..];
    assert_eq!(theirs.len(), ours.len());
    for (ours, theirs) in ours.iter().zip(theirs) {
        let [x, z] = xz(ours);
        assert!((theirs.program[0] - x).abs() < 1e-4 && (theirs.program[2] - z).abs() < 1e-4, "{ours:?} {theirs:?}");
        match (ours.kind, theirs.kind) {
            (MotionKind::Arc(arc, _), rs274::Kind::Arc { plane: Plane::ZX, centre, turns, .. }) => {
                assert!((centre[0] - arc.centre[0]).abs() < 1e-3 && (centre[1] - arc.centre[1]).abs() < 1e-3);
                assert_eq!(turns.signum(), arc.turns.signum());
            }
            (MotionKind::Rapid, rs274::Kind::Rapid) | (MotionKind::Feed(_), rs274::Kind::Feed(_)) => {}
            (a, b) => panic!("{a:?} {b:?}"),
        }
    }
}
