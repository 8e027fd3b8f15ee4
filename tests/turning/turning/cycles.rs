//! G70 to G76: from their words to motions, and the contour that they name.

use rodete::gcode::in_force::Speed;
use rodete::gcode::motion::MotionKind;

use super::lines::{line, moves, read, read_with, refusal, remarked, setting};

/// X50 Z5 is the start. The contour: to X30 at rapid, along Z to −10, out to X50.
const CONTOUR: &str = "N10 G0 X30.\nG1 Z-10. F0.1\nN20 X50.\n";

#[test]
fn g71_takes_the_stock_in_passes_of_its_depth() {
    // C = (X50 + 1, Z5 + 0.2). Passes at 21.5, 17.5 of radius … by 4: 25.5 − 4 = 21.5 (X43), 17.5 (X35), the last at 15.5 (X31)
    // as the contour moved by U/2 = 0.5; each to Z −10 + 0.2, out at 45° by R 1, back. Then along the moved contour, and home.
    moves(
        &format!("G71 U4. R1.\nG71 P10 Q20 U1. W.2 F.3\n{CONTOUR}G0 X60."),
        &[
            "G0 X51 Z5.2",
            "G0 X43 Z5.2",
            "G1 X43 Z-9.8 F0.3",
            "G0 X45 Z-8.8",
            "G0 X45 Z5.2",
            "G0 X35 Z5.2",
            "G1 X35 Z-9.8 F0.3",
            "G0 X37 Z-8.8",
            "G0 X37 Z5.2",
            "G0 X31 Z5.2",
            "G1 X31 Z-9.8 F0.3",
            "G0 X33 Z-8.8",
            "G0 X33 Z5.2",
            "G0 X31 Z5.2",
            "G1 X31 Z-9.8 F0.3",
            "G1 X51 Z-9.8 F0.3",
            "G0 X51 Z5.2",
            "G0 X50 Z5",
            "G0 X60 Z5",
        ],
    );
}

#[test]
fn g70_follows_the_contour_at_its_own_feeds_and_goes_on_behind_itself() {
    let program = format!(
        "T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG71 U20. R1.\nG71 P10 Q20 F.3\n{CONTOUR}G0 X60.\nX50. Z5.\nG70 P10 Q20 F.25\nG0 X70."
    );
    let read = read(&program);
    let lines: Vec<_> = read.motions.iter().map(line).collect();
    let from = lines.iter().position(|line| line == "G0 X60 Z5").unwrap();
    assert_eq!(
        lines[from..],
        ["G0 X60 Z5", "G0 X50 Z5", "G0 X30 Z5", "G1 X30 Z-10 F0.1", "G1 X50 Z-10 F0.1", "G0 X50 Z5", "G0 X70 Z5"]
    );
    // The moves along the contour name its blocks.
    let named: Vec<_> = read.motions[from + 2..from + 6].iter().map(|motion| (motion.line, motion.n)).collect();
    assert_eq!(named, [(5, Some(10)), (6, None), (7, Some(20)), (10, None)]);
}

#[test]
fn the_contour_s_speeds_count_for_g70_alone() {
    let program = "S1000 M3 F0.2\nG0 X50. Z5.\nG71 U20. R1.\nG71 P10 Q20 F.3 S800\nN10 G0 X30. S1500\nG1 Z-10.\nN20 X50. S600\nG70 P10 Q20\nG0 X60.";
    let read = read(program);
    let speeds: Vec<f64> = read
        .controls
        .iter()
        .map(|control| match control.speed {
            Speed::Revolutions(speed) => speed,
            Speed::Surface(_) => panic!("not under G96"),
        })
        .collect();
    let g70 = read.motions.iter().rposition(|motion| motion.line == 5).unwrap();
    assert!(speeds[1..g70].iter().all(|speed| *speed == 800.0), "{speeds:?}");
    assert_eq!(speeds[g70..], [1500.0, 1500.0, 600.0, 600.0, 600.0]);
}

#[test]
fn a_contour_takes_increments_arcs_and_deleted_blocks() {
    // G3 of R 5 from X20 Z−5 to X30 Z−10, about X20 Z−10.
    let contour = "N10 G0 U-30.\nG1 W-10.\n/X90.\n(a comment)\n\nG3 U10. W-5. R5.\nN20 G1 X50. F.05\n";
    let mut with = setting();
    with.block_delete = true;
    let program = format!("S1000 M3 F0.2\nG0 X50. Z5.\nG73 U0. W0. R1\nG73 P10 Q20\n{contour}M30\n");
    let read = read_with(&program, with);
    assert!(read.faults.is_empty(), "{:?}", read.faults);
    let lines: Vec<_> = read.motions.iter().map(line).collect();
    assert_eq!(lines[1], "G0 X20 Z5");
    assert_eq!(lines[2..5], ["G1 X20 Z-5 F0.2", "G3 X30 Z-10 C20,-10 F0.2", "G1 X50 Z-10 F0.2"]);
}

#[test]
fn g72_takes_the_stock_across() {
    // From X50 Z5: passes at Z 3, 1, −1, −2 along X to 10 + 1 on the diameter, the contour moved by W 0.
    moves(
        "G72 W2. R1.\nG72 P10 Q20 U1. W0 F.3\nN10 G0 Z-2.\nG1 X10.\nN20 Z5.",
        &[
            "G0 X51 Z5",
            "G0 X51 Z3",
            "G1 X11 Z3 F0.3",
            "G0 X13 Z4",
            "G0 X51 Z4",
            "G0 X51 Z1",
            "G1 X11 Z1 F0.3",
            "G0 X13 Z2",
            "G0 X51 Z2",
            "G0 X51 Z-1",
            "G1 X11 Z-1 F0.3",
            "G0 X13 Z0",
            "G0 X51 Z0",
            "G0 X51 Z-2",
            "G1 X11 Z-2 F0.3",
            "G0 X13 Z-1",
            "G0 X51 Z-1",
            "G0 X51 Z-2",
            "G1 X11 Z-2 F0.3",
            "G1 X11 Z5 F0.3",
            "G0 X51 Z5",
            "G0 X50 Z5",
        ],
    );
}

#[test]
fn g73_repeats_the_contour_from_its_relief() {
    // Three passes: moved by (4, 2), (2, 1), (0, 0) — on the radius — and by the allowance (0.5, 0.1).
    let read = read(&format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG73 U4. W2. R3\nG73 P10 Q20 U1. W.1 F.3\n{CONTOUR}"));
    let lines: Vec<_> = read.motions.iter().map(line).collect();
    for pass in ["G1 X39 Z-7.9 F0.3", "G1 X35 Z-8.9 F0.3", "G1 X31 Z-9.9 F0.3"] {
        assert!(lines.iter().any(|line| line == pass), "{pass}: {lines:#?}");
    }
    assert_eq!(lines.last().unwrap(), "G0 X50 Z5");
}

#[test]
fn g74_pecks_along_z_and_steps_along_x() {
    // P3000: 3 mm on the radius; Q4000: 4 mm. From X50 Z5 to X38 Z−1: places at X50, X44, X38; steps to 1, −1.
    moves(
        "G74 R.5\nG74 X38. Z-1. P3000 Q4000 F.1",
        &[
            "G1 X50 Z1 F0.1",
            "G0 X50 Z1.5",
            "G1 X50 Z-1 F0.1",
            "G0 X50 Z5",
            "G0 X44 Z5",
            "G1 X44 Z1 F0.1",
            "G0 X44 Z1.5",
            "G1 X44 Z-1 F0.1",
            "G0 X44 Z5",
            "G0 X38 Z5",
            "G1 X38 Z1 F0.1",
            "G0 X38 Z1.5",
            "G1 X38 Z-1 F0.1",
            "G0 X38 Z5",
            "G0 X50 Z5",
        ],
    );
    // Drilling: along Z alone.
    moves(
        "G0 X0\nG74 R1.\nG74 Z-3. Q4000 F.1",
        &["G0 X0 Z5", "G1 X0 Z1 F0.1", "G0 X0 Z2", "G1 X0 Z-3 F0.1", "G0 X0 Z5"],
    );
}

#[test]
fn g75_pecks_along_x_and_steps_along_z() {
    moves(
        "G75 R.5\nG75 X40. Z3. P3000 Q2000 F.1",
        &[
            "G1 X44 Z5 F0.1",
            "G0 X45 Z5",
            "G1 X40 Z5 F0.1",
            "G0 X50 Z5",
            "G0 X50 Z3",
            "G1 X44 Z3 F0.1",
            "G0 X45 Z3",
            "G1 X40 Z3 F0.1",
            "G0 X50 Z3",
            "G0 X50 Z5",
        ],
    );
}

#[test]
fn g76_reads_its_six_digits_and_its_increments() {
    // One finishing pass, no pull-out, tip 0°: passes at the height 1 less the allowance 0.1 by 0.5·√n, n = 1, 2, 3 (0.5, 0.707,
    // 0.866, 0.9), then the full height; the crest is at X28 + 2 = X30.
    let read = read("S400 M3\nG0 X50. Z5.\nG76 P010000 Q50 R.1\nG76 X28. Z-20. P1000 Q500 F1.5");
    let cuts: Vec<_> = read.motions.iter().map(line).filter(|line| line.starts_with("G32")).collect();
    assert_eq!(
        cuts,
        [
            "G32 X29 Z-20 F1.5",
            "G32 X28.5858 Z-20 F1.5",
            "G32 X28.2679 Z-20 F1.5",
            "G32 X28.2 Z-20 F1.5",
            "G32 X28 Z-20 F1.5",
        ]
    );
    assert!(read.motions.iter().all(|motion| motion.line == 2 || motion.line == 4));
}

#[test]
fn the_words_of_a_first_block_stay_in_force() {
    let twice = "G75 R.5\nG75 X40. Z5. P9000 Q1000 F.1\nG0 Z0\nG75 X44. Z0 P9000 Q1000";
    moves(twice, &["G1 X40 Z5 F0.1", "G0 X50 Z5", "G0 X50 Z0", "G1 X44 Z0 F0.1", "G0 X50 Z0"]);
}

#[test]
fn of_a_second_block_that_is_refused_it_is_not_said_that_it_is_missing() {
    let missing = |blocks: &str| {
        let read = read_with(&format!("S1000 M3 F.2\nG0 X50. Z5.\n{blocks}\nG0 X60.\nM30\n"), setting());
        ["G71", "G75", "G76"].iter().any(|cycle| {
            remarked(&read, &format!("no second block follows this first block of {cycle}: nothing is cut"))
        })
    };
    // A word that stands twice is refused before the cycle is looked at.
    for [first, second] in [
        ["G76 P020060 Q100 R.5", "G76 X40. X41. Z-8. P1300 Q200 F1.5"],
        ["G75 R.5", "G75 X40. X41. Z5. P9000 Q1000 F.1"],
        ["G71 U2. R1.", "G71 P10 Q20 Q21 U.4 W.1\nN10 G0 X30.\nG1 Z-10.\nN20 X50."],
    ] {
        assert!(!missing(&format!("{first}\n{second}")), "{second}");
        assert!(missing(first), "{first}");
        // A first block that is refused is no second one.
        assert!(missing(&format!("{first}\n{first} R9.")), "{first}");
    }
}

#[test]
fn blocks_between_a_cycle_and_its_contour_are_not_executed_and_said() {
    let read = read(
        "S1000 M3 F.2\nG0 X50. Z5.\nG71 U20. R1.\nG71 P10 Q20\nG0 X90.\n(a comment)\nN10 G0 X30.\nG1 Z-10.\nN20 X50.\nG0 X60.",
    );
    assert!(remarked(&read, "the control does not run the blocks between G71 and its contour: 1"));
    assert!(!read.motions.iter().map(line).any(|line| line.starts_with("G0 X90")));
}

#[test]
fn a_contour_before_its_roughing_does_not_repeat_the_program() {
    let program = format!("S1000 M3 F.2\nG0 X50. Z5.\n{CONTOUR}G0 X50. Z5.\nG71 U20. R1.\nG71 P10 Q20\nG0 X60.");
    assert_eq!(line(read(&program).motions.last().unwrap()), "G0 X60 Z5");
}

#[test]
fn a_contour_is_found_in_its_own_subprogram() {
    // N10 and N20 stand in both programs; each cycle takes those of its own.
    let program = "O0001\nS1000 M3 F.2\nG0 X50. Z5.\nM98 P0002\nN10 G0 X51.\nN20 X52.\nM30\nO0002\nG70 P10 Q20\nM99\nN10 G0 X30.\nG1 Z-10.\nN20 X50.\nM99\n";
    let read = read_with(program, setting());
    assert!(read.faults.is_empty(), "{:?}", read.faults);
    let lines: Vec<_> = read.motions.iter().map(line).collect();
    assert_eq!(
        lines,
        ["G0 X50 Z5", "G0 X30 Z5", "G1 X30 Z-10 F0.2", "G1 X50 Z-10 F0.2", "G0 X50 Z5", "G0 X51 Z5", "G0 X52 Z5"]
    );
}

#[test]
fn s_and_f_of_a_contour_hold_in_its_finishing_from_the_block_that_says_them_and_afterwards() {
    // S in a block of its own, S before the first motion, and a trailing S.
    for (contour, speeds) in [
        ("N10 G0 X40.\nS1500\nG1 Z-10. F.1\nN30 X50.", [1000.0, 1500.0, 1500.0, 1500.0]),
        ("N10 S1500\nG0 X40.\nG1 Z-10. F.1\nN30 X50.", [1500.0, 1500.0, 1500.0, 1500.0]),
        ("N10 G0 X40.\nG1 Z-10. F.1\nX50.\nN30 S1500", [1000.0, 1000.0, 1000.0, 1500.0]),
    ] {
        let program = format!("T0101 M3 S1000\nG0 X50. Z5.\nG70 P10 Q30\nG0 X60.\nM30\n{contour}\n");
        let read = read_with(&program, setting());
        assert!(read.faults.is_empty(), "{:?}", read.faults);
        let said: Vec<_> = read.controls.iter().skip(1).take(3).map(|control| control.speed).collect();
        let behind = read.controls.last().map(|control| control.speed);
        let wanted = speeds.map(Speed::Revolutions);
        assert_eq!(said, wanted[..3], "{contour}");
        assert_eq!(behind, Some(wanted[3]), "{contour}");
        // No move of the contour is without F.
        assert!(!remarked(&read, "feed move without F"), "{contour}");
    }
}

#[test]
fn a_cones_r_holds_from_one_single_cycle_to_another_until_a_one_shot_code() {
    moves(
        "G90 X46. Z-20. R-3. F.2\nG92 X44. F1.5",
        &[
            "G0 X40 Z5",
            "G1 X46 Z-20 F0.2",
            "G1 X50 Z-20 F0.2",
            "G0 X50 Z5",
            "G0 X38 Z5",
            "G32 X44 Z-20 F1.5",
            "G0 X50 Z-20",
            "G0 X50 Z5",
        ],
    );
    let cylinder = ["G0 X44 Z5", "G1 X44 Z-20 F0.2", "G1 X50 Z-20 F0.2", "G0 X50 Z5"];
    let read =
        |between: &str| read(&format!("S1000 M3 F.2\nG0 X50. Z5.\nG90 X46. Z-20. R-3.\n{between}\nG90 X44. Z-20."));
    for (between, start) in [("G50 S2000", "G0 X44 Z5"), ("G4 X1.", "G0 X38 Z5"), ("", "G0 X38 Z5")] {
        let lines: Vec<_> = read(between)
            .motions
            .iter()
            .filter(|motion| !matches!(motion.kind, MotionKind::Dwell(_)))
            .map(line)
            .collect();
        assert_eq!(lines[5], start, "{between}");
        assert_eq!(lines[6..], cylinder[1..], "{between}");
    }
    let refused = refusal("S1000 M3 F.2\nG0 X50. Z5.\nG90 X46. Z-20.\nG50 S2000\nX44.\nM30\n");
    assert!(refused.starts_with("5"), "{refused}");
}
