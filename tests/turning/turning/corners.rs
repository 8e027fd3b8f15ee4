//! `,C` and `,R`: corners broken in plain motion and in contours, against positions derived by hand.

use rodete::gcode::in_force::{Compensation, Spindle};
use rodete::gcode::interpreter::{DecimalPoint, Interpreter};
use rodete::gcode::turning::nose::{Nose, Tip};

use super::lines::{line, moves, read, read_with, remarked, setting};

#[test]
fn a_chamfer_is_put_between_two_lines_at_its_size_from_the_corner() {
    // From X50 Z5 along Z to the corner X50 Z−10; then out along X to X70. 2 mm on the radius: 4 on the diameter.
    moves(
        "G1 Z-10. ,C2.\nX70.\nZ-30.",
        &["G1 X50 Z-8 F0.2", "G1 X54 Z-10 F0.2", "G1 X70 Z-10 F0.2", "G1 X70 Z-30 F0.2"],
    );
    // A cone of 45 degrees, X50 Z−10 to X70 Z−20: along it 2 mm are √2 on the radius and along Z.
    moves("G1 Z-10. ,C2.\nX70. Z-20.", &["G1 X50 Z-8 F0.2", "G1 X52.8284 Z-11.4142 F0.2", "G1 X70 Z-20 F0.2"]);
}

#[test]
fn a_rounding_touches_both_lines() {
    // Z− then X+: the path turns clockwise (from −Z to +X is against G3's way); the centre is 3 mm from both lines.
    moves(
        "G1 Z-10. ,R3.\nX70. ,R2.\nZ-30.",
        &[
            "G1 X50 Z-7 F0.2",
            "G2 X56 Z-10 C56,-7 F0.2",
            "G1 X66 Z-10 F0.2",
            "G3 X70 Z-12 C66,-12 F0.2",
            "G1 X70 Z-30 F0.2",
        ],
    );
    // Off by 45 degrees: r tan 22.5° = 2 · 0.41421 = 0.82843 from the corner; along the cone 0.58579 each way.
    moves(
        "G1 Z-10. ,R2.\nX70. Z-20.",
        &["G1 X50 Z-9.1716 F0.2", "G2 X51.1716 Z-10.5858 C54,-9.1716 F0.2", "G1 X70 Z-20 F0.2"],
    );
}

#[test]
fn i_k_and_r_break_square_corners_their_sign_leads_along_the_next_line() {
    // Along Z, then out: I2 is 2 mm towards +X. Along X, then towards −Z: K−3; in radii, as the comma's sizes.
    moves(
        "G1 Z-10. I2.\nX70. K-3.\nZ-30. R1.\nX80. R-2.\nZ-40.",
        &[
            "G1 X50 Z-8 F0.2",
            "G1 X54 Z-10 F0.2",
            "G1 X64 Z-10 F0.2",
            "G1 X70 Z-13 F0.2",
            "G1 X70 Z-29 F0.2",
            "G2 X72 Z-30 C72,-29 F0.2",
            "G1 X76 Z-30 F0.2",
            "G3 X80 Z-32 C76,-32 F0.2",
            "G1 X80 Z-40 F0.2",
        ],
    );
    moves("G1 Z-10. R0.\nX70.", &["G1 X50 Z-10 F0.2", "G1 X70 Z-10 F0.2"]);
}

#[test]
fn increments_behind_a_corner_count_from_the_corner() {
    moves(
        "G1 W-15. ,C2.\nU20. ,R1.\nW-20.",
        &["G1 X50 Z-8 F0.2", "G1 X54 Z-10 F0.2", "G1 X68 Z-10 F0.2", "G3 X70 Z-11 C68,-11 F0.2", "G1 X70 Z-30 F0.2"],
    );
}

#[test]
fn corners_may_take_their_lines_whole() {
    // 3 and 7 mm of a line of 10: nothing of it is left.
    moves(
        "G1 Z-10. ,R3.\nX70. ,R7.\nZ-30.",
        &["G1 X50 Z-7 F0.2", "G2 X56 Z-10 C56,-7 F0.2", "G3 X70 Z-17 C56,-17 F0.2", "G1 X70 Z-30 F0.2"],
    );
    moves("G1 Z-10. ,C0.\nX70.", &["G1 X50 Z-10 F0.2", "G1 X70 Z-10 F0.2"]);
}

#[test]
fn the_line_and_its_corner_are_made_as_their_own_block_says() {
    let read = read(
        "T0101 M3 S1000 F0.2\nG0 X50. Z5.\nN7 G1 Z-10. ,C2. F0.1 M9\n(the corner)\n\nN8\nN9 G98 X70. F80. M8\nG0 X80. M5",
    );
    let lines: Vec<_> = read.motions[1..].iter().map(line).collect();
    assert_eq!(lines, ["G1 X50 Z-8 F0.1", "G1 X54 Z-10 F0.1", "G1 X70 Z-10 F80", "G0 X80 Z-10"]);
    let named: Vec<_> = read.motions[1..].iter().map(|motion| (motion.line, motion.n)).collect();
    assert_eq!(named, [(3, Some(7)), (3, Some(7)), (7, Some(9)), (8, None)]);
    let coolant: Vec<_> = read.controls[1..].iter().map(|control| control.coolant).collect();
    assert_eq!(coolant, [false, false, true, true]);
    assert!(read.controls.iter().all(|control| control.spindle == Spindle::Clockwise));
    // 2√2 mm at 0.1 a revolution and 1000 revolutions a minute.
    let seconds = read.motions[2].seconds.unwrap();
    assert!((seconds - 8.0_f64.sqrt() * 60.0 / 100.0).abs() < 1e-9, "{seconds}");
}

#[test]
fn a_corner_is_no_block_without_motion_for_the_viewer() {
    let program = "T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG1 Z-10. ,C2. M5\nX70.\nM30\n";
    let mut interpreter = Interpreter::over(program.as_bytes(), setting());
    interpreter.keep_stood();
    let mut seen = Vec::new();
    loop {
        let item = interpreter.next();
        seen.extend(interpreter.stood().into_iter().map(|stood| (stood.line, "stands")));
        let Some(motion) = item else { break };
        seen.push((motion.unwrap().line, "moves"));
    }
    assert_eq!(seen[..5], [(1, "stands"), (2, "moves"), (3, "moves"), (3, "moves"), (4, "moves")]);
}

#[test]
fn a_corner_without_a_decimal_point_is_scaled_as_its_control_has_it() {
    for (point, size) in [(DecimalPoint::Calculator, 2.0), (DecimalPoint::Micrometre, 0.002)] {
        let with = rodete::gcode::interpreter::Setting { decimal_point: Some(point), ..setting() };
        let read = read_with("T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG1 Z-10. ,C2\nX70.\nM30\n", with);
        assert!(read.faults.is_empty(), "{:?}", read.faults);
        let z = read.motions[1].to.0[2];
        assert!((z + 10.0 - size).abs() < 1e-9, "{z}");
    }
}

const CONTOUR: &str = "N10 G0 X30.\nG1 Z-10. ,R2. F0.1 M8\nX40. ,C1.\nN20 Z-20.\n";

#[test]
fn a_contour_has_its_corners_broken_for_roughing_and_for_finishing() {
    // Along Z to X30 Z−10, out to X40, along Z. The rounding: Z−8 to X34 about X34 Z−8; the chamfer: X38 to Z−11.
    let program =
        format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG73 U0. W0. R1\nG73 P10 Q20 F.3\n{CONTOUR}G70 P10 Q20\nG0 X60.");
    let read = read(&program);
    let lines: Vec<_> = read.motions[1..].iter().map(line).collect();
    let along = |feed: &str| {
        ["G1 X30 Z-8", "G2 X34 Z-10 C34,-8", "G1 X38 Z-10", "G1 X40 Z-11", "G1 X40 Z-20"]
            .map(|to| format!("{to} F{feed}"))
    };
    assert_eq!(lines[0], "G0 X30 Z5");
    assert_eq!(lines[1..6], along("0.3"));
    assert_eq!(lines[6..8], ["G0 X50 Z5", "G0 X30 Z5"]);
    assert_eq!(lines[8..13], along("0.1"));
    assert_eq!(lines[13..], ["G0 X50 Z5", "G0 X60 Z5"]);
    let named: Vec<_> = read.motions[8..14].iter().map(|motion| motion.line).collect();
    assert_eq!(named, [5, 6, 6, 7, 7, 8]);
    let coolant: Vec<_> = read.controls[8..14].iter().map(|control| control.coolant).collect();
    assert_eq!(
        coolant,
        [false, true, true, true, true, true],
        "M8 is obeyed once, before the first motion of its block"
    );
    assert!(remarked(&read, "the oldest Fanuc controls do not allow them between P and Q"));
}

#[test]
fn the_words_of_a_contour_that_two_cycles_read_are_counted_once() {
    let counted = |finish: &str| {
        let program =
            format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG71 U2. R1.\nG71 P10 Q20 F.3\n{CONTOUR}{finish}G0 X60.");
        let read = read(&program);
        let told = read.remarks.iter().find(|remark| remark.what.en.contains("the oldest Fanuc controls"));
        told.map(|remark| remark.value.clone())
    };
    for finish in ["", "G70 P10 Q20\n", "G70 P10 Q20\nG70 P10 Q20\n"] {
        assert_eq!(counted(finish).as_deref(), Some("2 ×"), "{finish}");
    }
}

#[test]
fn square_corners_stand_in_contours_too() {
    let contour = "N10 G0 X30.\nG1 Z-10. R2. F0.1\nX40. K-1.\nN20 Z-20.\n";
    let read = read(&format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG70 P10 Q20\nM30\n{contour}"));
    let lines: Vec<_> = read.motions[2..7].iter().map(line).collect();
    let wanted = ["G1 X30 Z-8", "G2 X34 Z-10 C34,-8", "G1 X38 Z-10", "G1 X40 Z-11", "G1 X40 Z-20"];
    assert_eq!(lines, wanted.map(|to| format!("{to} F0.1")));
}

#[test]
fn m9_beside_a_corner_of_a_contour_is_obeyed_behind_the_corner() {
    let contour = "N10 G0 X30. M8\nG1 Z-10. ,C2. F0.1 M9\nN20 X40.\n";
    let read = read(&format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG70 P10 Q20\nM30\n{contour}"));
    let coolant: Vec<_> = read.controls[1..5].iter().map(|control| control.coolant).collect();
    assert_eq!(coolant, [true, true, true, false]);
}

#[test]
fn roughing_ends_its_passes_at_the_broken_corner() {
    // One depth of 4 from X50: the passes lie at X42 and X34, then X30. At X34 the rounding, from Z−8 to X34, ends the
    // pass at Z−10; at X42 there is nothing but the end of the contour; with the chamfer of 1 X38 … X40.
    let read = read(&format!("T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG71 U4. R1.\nG71 P10 Q20 F.3\n{CONTOUR}"));
    let lines: Vec<_> = read.motions[1..].iter().map(line).collect();
    for pass in ["G1 X42 Z-20 F0.3", "G1 X34 Z-10 F0.3", "G1 X30 Z-8 F0.3", "G2 X34 Z-10 C34,-8 F0.3"] {
        assert!(lines.iter().any(|line| line == pass), "{pass} {lines:#?}");
    }
}

#[test]
fn the_nose_goes_round_a_broken_corner_as_round_the_same_lines_and_arcs_written_out() {
    let noses = || {
        let mut with = setting();
        let nose = Nose { radius: 0.8, tip: Tip::new(3).unwrap() };
        with.tools.as_mut().unwrap().get_mut(&1).unwrap().nose = Some(nose);
        with
    };
    let head = "T0101 M3 S1000 F0.2\nG0 X30. Z5.\n";
    let short = "G42 G1 X20. Z2.\nZ-10. ,R2.\nX40. ,C1.\nZ-20. ,R1.5\nX50.\nG40 G0 X60. Z5.\nM30\n";
    let long = "G42 G1 X20. Z2.\nZ-8.\nG2 X24. Z-10. R2.\nG1 X38.\nX40. Z-11.\nZ-18.5\nG2 X43. Z-20. R1.5\nG1 X50.\nG40 G0 X60. Z5.\nM30\n";
    let [short, long] = [short, long].map(|program| read_with(&format!("{head}{program}"), noses()));
    assert!(short.faults.is_empty() && long.faults.is_empty(), "{:?} {:?}", short.faults, long.faults);
    let [a, b] = [&short, &long].map(|read| read.motions.iter().map(line).collect::<Vec<_>>());
    assert_eq!(a, b);
    assert!(a.len() >= 10 && short.controls.iter().any(|control| control.compensation == Compensation::Right));
}

/// Motions and refusals of a program in their order, a refusal by its file, line and alarm.
fn told(program: &str, setting: rodete::gcode::interpreter::Setting) -> Vec<String> {
    let mut interpreter = Interpreter::over(program.as_bytes(), setting);
    let mut told = Vec::new();
    while let Some(item) = interpreter.next() {
        told.push(match item {
            Ok(motion) => {
                let file = interpreter.file(interpreter.in_force().file).unwrap_or("-");
                format!("{file} {} {}", motion.line, line(&motion))
            }
            Err(fault) => {
                let text = fault.what.en.split(':').next().unwrap_or_default();
                format!("{} {} {text}", fault.file.as_deref().unwrap_or("-"), fault.line)
            }
        });
    }
    told
}

const HEAD: &str = "T0101 M3 S1000 F0.2\nG0 X50. Z5.\nG1 Z-10. ,R2.\n";

#[test]
fn the_block_behind_a_refused_corner_is_executed() {
    let behind = |blocks: &str| told(&format!("{HEAD}{blocks}"), setting())[1..].to_vec();
    // The rapid motion is made, and G0 in force behind it.
    assert_eq!(
        behind("G0 X60.\nZ5.\nM30\n"),
        ["- 3 PS0052", "- 3 G1 X50 Z-10 F0.2", "- 4 G0 X60 Z-10", "- 5 G0 X60 Z5"]
    );
    assert_eq!(
        behind("G2 X60. Z-15. R5.\nM30\n"),
        ["- 3 PS0052", "- 3 G1 X50 Z-10 F0.2", "- 4 G2 X60 Z-15 C60,-10 F0.2"]
    );
    // 2 mm of a line of 1.
    assert_eq!(
        behind("X52.\nZ-30.\nM30\n"),
        ["- 3 PS0055", "- 3 G1 X50 Z-10 F0.2", "- 4 G1 X52 Z-10 F0.2", "- 5 G1 X52 Z-30 F0.2"]
    );
    // The end of the program is one, and what stands behind it another program.
    assert_eq!(behind("M30\nO7\nG0 X99.\nM99\n"), ["- 3 PS0051", "- 3 G1 X50 Z-10 F0.2"]);
    // What is wrong with the block itself is said behind the corner.
    assert_eq!(behind("G0 X60. U5.\nM30\n"), ["- 3 PS0052", "- 3 G1 X50 Z-10 F0.2", "- 4 X and U in one block"]);
}

#[test]
fn a_corner_at_the_end_of_a_subprogram_is_one_of_its_file() {
    let with = |text: &str| {
        let files = [("O0002".to_owned(), text.to_owned())].into();
        rodete::gcode::interpreter::Setting { files: Box::new(super::lines::Folder(files)), ..setting() }
    };
    let program = "T0101 M3 S1000 F0.2\nG0 X50. Z5.\nM98 P2\nG1 X60.\nM30\n";
    assert_eq!(
        told(program, with("G1 Z-10. ,R2.\nM99\n"))[1..],
        ["O0002 1 PS0051", "O0002 1 G1 X50 Z-10 F0.2", "- 4 G1 X60 Z-10 F0.2"]
    );
    assert_eq!(
        told(program, with("G1 Z-10. ,R2. M99\n"))[1..],
        ["O0002 1 G1 X50 Z-8 F0.2", "O0002 1 G2 X54 Z-10 C54,-8 F0.2", "- 4 G1 X60 Z-10 F0.2"]
    );
    let short = told(program, with("G1 Z-10. ,R7. M99\n"));
    assert_eq!(short[1..], ["O0002 1 PS0055", "O0002 1 G1 X50 Z-10 F0.2", "- 4 G1 X60 Z-10 F0.2"]);
}
