//! What is told and not refused, because the control runs it; and refusals that follow from a refused block; and where a
//! control does what its reference does not say.

use rodete::finding::Grade;
use rodete::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, FANUC_LATHE_A, LINUXCNC};
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::motion::MotionKind;
use rodete::machine::axis::Axis;
use rodete::machine::length_unit::LengthUnit;

/// Refusals by line, cautions, and where X and Z go.
#[derive(Debug, Default)]
struct Read {
    refused: Vec<(usize, String)>,
    cautions: Vec<String>,
    ends: Vec<[f64; 2]>,
}

fn read(control: &'static Control, program: &str) -> Read {
    let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(control));
    let mut read = Read::default();
    for item in &mut interpreter {
        match item {
            Ok(motion) => read.ends.push([motion.to.get(Axis::X), motion.to.get(Axis::Z)]),
            Err(fault) => read.refused.push((fault.line, fault.what.en.to_string())),
        }
    }
    let cautions = interpreter.remarks().into_iter().filter(|remark| remark.grade == Grade::Caution);
    read.cautions = cautions.map(|remark| remark.what.en.to_string()).collect();
    read
}

fn told(program: &str, part: &str) -> Read {
    let read = read(&FANUC_LATHE_A, program);
    assert!(read.refused.is_empty(), "{program}\n{read:?}");
    assert!(read.cautions.iter().any(|caution| caution.contains(part)), "{program}\n{read:?}");
    read
}

#[test]
fn g90_and_g91_alone_are_told_on_a_lathe_of_system_a() {
    let bare = told("G90\nG0 X20. Z5.\nM30\n", "in system A this is the turning cycle");
    assert_eq!(bare.ends, [[10.0, 5.0]]);
    // Without G0 or G1 the cycle is what the next block makes.
    let pass = told("G0 X20. Z5.\nG90\nX10. Z0. F0.1\nM30\n", "in force until G0 or G1");
    assert_eq!(pass.ends[1..], [[5.0, 5.0], [5.0, 0.0], [10.0, 0.0], [10.0, 5.0]]);
    let increments = told("G91\nG0 X20. Z5.\nX10.\nM30\n", "X and Z stay absolute");
    assert_eq!(increments.ends, [[10.0, 5.0], [5.0, 5.0]]);
    assert_eq!(
        read(&FANUC_LATHE_A, "G91 G0 X20.\nM30\n").refused[0].1,
        "G91 is not known to rodete in the dialect fanuc-lathe-a"
    );
    assert_eq!(read(&FANUC_LATHE_A, "G90 X20.\nM30\n").refused.len(), 1);
}

#[test]
fn a_second_block_behind_a_rejected_first_one_and_a_rejected_speed_limit_are_not_told_again() {
    let thread =
        "G50 S2000 E1\nG96 S200 M3\nG0 X24. Z4.\nG76 P020060 Q50 R.05 E1\nG76 X17. Z-20. P1000 Q300 F1.75\nM30\n";
    let read = read(&FANUC_LATHE_A, thread);
    assert_eq!(read.refused.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [1, 4], "{read:?}");
    assert!(!read.cautions.iter().any(|one| one.contains("without a speed limit")), "{read:?}");
    let alone = self::read(&FANUC_LATHE_A, &thread.replace(" E1", "").replace("G76 P020060 Q50 R.05\n", ""));
    assert_eq!(alone.refused[0].1, "the first block of G76 is missing");
}

#[test]
fn another_unit_is_told_where_something_moves_in_it_and_gravely_where_the_manual_forbids_it() {
    let graded = |control: &'static Control, program: &str| {
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(control));
        interpreter.by_ref().for_each(drop);
        interpreter.remarks().into_iter().find(|one| one.code() == "G0506").map(|one| one.grade)
    };
    let across = "G21 G0 X1. Z1.\nG20\nX2.\nM30\n";
    assert_eq!(graded(&FANUC_LATHE_A, across), Some(Grade::Caution));
    assert_eq!(graded(&LINUXCNC, across), Some(Grade::Note));
    // At the end, and there and back, nothing moves in another unit.
    assert_eq!(graded(&FANUC_LATHE_A, "G21 G0 X1. Z1.\nG20\nM30\n"), None);
    assert_eq!(graded(&FANUC_LATHE_A, "G21 G0 X1. Z1.\nG20\nG21\nX2.\nM30\n"), None);
    assert_eq!(graded(&FANUC_LATHE_A, "G21\nG20\nG0 X1. Z1.\nM30\n"), None);
}

#[test]
fn text_before_the_first_percent_is_not_read_on_a_lathe_of_system_a() {
    let program = "shaft, second side\n\n%\nO0001\nG0 X20. Z5.\nM30\n%\n";
    assert_eq!(told(program, "text before the first '%' is not read").ends, [[10.0, 5.0]]);
    assert!(told("G0 X20. Z5.\n%\n", "without M2 or M30").ends.len() == 1, "the program itself is no such text");
    assert!(
        !read(&FANUC_LATHE_A, "O0001\nG0 X1. Z1.\n%\nO0002\nG0 X2.\nM30\n%\n")
            .cautions
            .iter()
            .any(|caution| { caution.contains("before the first") })
    );
    assert!(!read(&LINUXCNC, "text\n%\nG21 G0 X1\n%\n").refused.is_empty(), "LinuxCNC refuses it");
}

#[test]
fn a_missing_end_is_told_on_a_lathe_of_system_a_and_refused_elsewhere() {
    for program in ["O0001\nG0 X20. Z5.\n", "%\nO0001\nG0 X20. Z5.\n%\n"] {
        assert_eq!(told(program, "the program ends without M2 or M30").ends, [[10.0, 5.0]]);
    }
    for control in [&LINUXCNC, &FAGOR_8055, &FAGOR_8055_T] {
        assert_eq!(read(control, "G0 X20 Z5\n").refused[0].1, "the program ends without M2 or M30", "{}", control.name);
    }
}

#[test]
fn arcs_behind_a_refused_block_are_not_refused_again_until_the_position_is_known() {
    let mut program = "G21 G90 G17 F100\nG0 X0 Y0\nG77 X10 Y0\n".to_owned();
    for _ in 0..340 {
        program.push_str("G2 X20 Y0 I5 J0\nG2 X10 Y0 I-5 J0\n");
    }
    program.push_str("G0 X0 Y0\nG2 X9 Y0 I5 J0\nM2\n");
    let found = read(&LINUXCNC, &program);
    let lines: Vec<usize> = found.refused.iter().map(|refused| refused.0).collect();
    assert_eq!(lines, [3, 685], "the cause, and what does not follow from it: {:?}", found.refused);
    assert_eq!(
        found.cautions,
        ["680 errors that follow omitted, caused by rejected blocks; unknown from here on: X, Y"]
    );
}

#[test]
fn a_motion_a_feed_a_tool_or_a_parameter_that_a_refused_block_named_is_in_doubt() {
    for (program, left_out) in [
        (
            "G38.2 Z-1\nX5\nX6\nM2\n",
            "2 errors that follow omitted, caused by rejected blocks; unknown from here on: the motion in force",
        ),
        (
            "G1 F1,5 X1\nG1 X2\nM2\n",
            "1 error that follows omitted, caused by rejected blocks; unknown from here on: the feed",
        ),
        ("T1,0\nM6\nM2\n", "1 error that follows omitted, caused by rejected blocks; unknown from here on: the tool"),
        (
            "#<a>=[1/0]\nG0 X#<a>\nM2\n",
            "1 error that follows omitted, caused by rejected blocks; unknown from here on: a parameter",
        ),
        (
            "M3,1\nG84 X0 Y0 Z-1 R1 F1\nM2\n",
            "1 error that follows omitted, caused by rejected blocks; unknown from here on: the spindle's direction of rotation",
        ),
    ] {
        let found = read(&LINUXCNC, &format!("G21 G90\n{program}"));
        assert_eq!(found.refused.len(), 1, "{program}\n{found:?}");
        assert!(found.cautions.iter().any(|caution| caution == left_out), "{program}\n{found:?}");
    }
    // What the refused block did not name is not in doubt, nor what was given again.
    for program in ["G77 X1\nG1 X2\nM2\n", "G1 F1,5 X1\nF0\nG0 X1\nG1 X2\nM2\n", "#<b>=[1/0]\nG0 X#<a>\nM2\n"] {
        assert_eq!(read(&LINUXCNC, &format!("G21 G90\n{program}")).refused.len(), 2, "{program}");
    }
}

/// G70 and G71 are inches and millimetres there, as G20 and G21 elsewhere: an arc that hangs on the unit is not refused again.
#[test]
fn a_refused_block_with_the_unit_of_a_fagor_leaves_the_unit_in_doubt() {
    let left_out = "1 error that follows omitted, caused by rejected blocks; unknown from here on: the unit";
    for control in [&FAGOR_8055, &FAGOR_8070, &FAGOR_8055_T] {
        let plane = if control.turns() { "G18" } else { "G17" };
        let arc = if control.turns() { "G2 X20 Z0 I0 K9" } else { "G2 X10 Y0 I9 J0" };
        for (unit, other) in [("G70", "G71"), ("G71", "G70")] {
            let program = format!("{other}\n{plane} G90 G94 F100\n{unit} S1,5\n{arc}\nM30\n");
            let found = read(control, &program);
            assert_eq!(found.refused.len(), 1, "{}: {program}\n{found:?}", control.name);
            assert!(found.cautions.iter().any(|caution| caution == left_out), "{}: {found:?}", control.name);
            // What the refused block did not name is refused as ever, and so is an arc once the unit is given again.
            for named in ["S1,5".to_owned(), format!("{unit} S1,5\n{unit}")] {
                let found = read(control, &format!("{other}\n{plane} G90 G94 F100\n{named}\n{arc}\nM30\n"));
                assert_eq!(found.refused.len(), 2, "{}: {named}\n{found:?}", control.name);
            }
        }
    }
}

#[test]
fn a_dwell_behind_an_arc_of_a_fagor_is_no_arc() {
    let found = read(&FAGOR_8055, "G71 G17 G90 F100\nG2 X10 Y0 I5 J0\nG4 K100\nG1 X20\nM30\n");
    assert!(found.refused.is_empty(), "{found:?}");
    assert_eq!(found.ends, [[10.0, 0.0], [10.0, 0.0], [20.0, 0.0]]);
}

#[test]
fn abort_ends_the_program() {
    let found = read(&LINUXCNC, "G21 G0 X1\n(abort, no stock)\nG0 X2\nG77\n");
    assert_eq!((found.ends.len(), found.refused.len()), (1, 0), "{found:?}");
    assert_eq!(found.cautions, ["the program ends here: abort, no stock"]);
}

#[test]
fn where_linuxcnc_goes_elsewhere_is_a_caution() {
    let cautions = |program: &str| read(&LINUXCNC, &format!("G21 G90 F100 G98\n{program}M2\n")).cautions;
    let tap = |plane: &str| cautions(&format!("{plane} M3 S100\nG84 X1 Y1 Z1 R2\n"));
    assert!(tap("G17").is_empty());
    assert!(tap("G18").iter().any(|one| one.contains("G84 outside G17: LinuxCNC 2.9 swaps the axes")));
    let turn = "G10 L2 P1 R30\nG92.1\n";
    assert!(cautions(&format!("G0 X1\n{turn}")).is_empty());
    assert!(cautions(&format!("G92 X5\n{turn}")).iter().any(|one| one.contains("LinuxCNC 2.9 forgets G92")));
    assert!(cautions("G92 X5\nG10 L2 P2 R30\nG92.1\n").is_empty(), "of a system that is not active");
}

/// The codes of what is told or refused, and how many motions are made.
fn codes(control: &'static Control, program: &str) -> (Vec<String>, usize) {
    let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(control));
    let (mut codes, mut made) = (Vec::new(), 0);
    for item in &mut interpreter {
        match item {
            Ok(_) => made += 1,
            Err(fault) => codes.push(format!("{}:{}", fault.rule.code, fault.line)),
        }
    }
    codes.extend(interpreter.remarks().iter().map(|remark| remark.code().to_owned()));
    codes.retain(|code| ["G0535", "G0536", "G0553"].iter().any(|one| code.starts_with(one)));
    (codes, made)
}

#[test]
fn feed_and_surface_speed_beside_a_code_that_changes_the_unit_are_in_doubt_on_a_fagor() {
    for (control, program, told, motions) in [
        // The block itself moves at that feed; what follows at the same feed is counted with it.
        (&FAGOR_8055, "G71 G90 S900 M3\nG70 G1 X1 F10\nX2\nG1 X3 F10\nM30\n", &["G0536:2"][..], 1),
        (&FAGOR_8070, "G71 G90 S900 M3\nG70 F10\nG0 X1\nG1 X2\nG2 X4 I1 J0\nM30\n", &["G0536:4", "G0535"], 1),
        (&FAGOR_8055_T, "G71 G90 G95 S900 M3\nG70 F.01\nG1 X1\nM30\n", &["G0536:3", "G0535"], 0),
        (&FAGOR_8055_T, "G71 G90 G95 F.1 M3\nG70 G81 X2 Z0 Q2 R-1 C.1 F.01\nM30\n", &["G0536:2"], 0),
        // No motion hangs on it.
        (&FAGOR_8055, "G71 G90 S900 M3\nG70 F10\nG1 X1 F10\nM30\n", &["G0535"], 1),
        (&FAGOR_8055_T, "G71 G90 G95 F.1 M3\nG92 S2000\nG96 S100\nG70 S300\nG0 X1\nM30\n", &["G0535"], 1),
        // Alone, without a change, and where S is in rpm.
        (&FAGOR_8055, "G71 G90 S900 M3\nG70\nF10\nG1 X1\nM30\n", &[], 1),
        (&FAGOR_8055, "G71 G90 G94 F100 S900 M3\nG1 X1\nM30\n", &[], 1),
        (&FAGOR_8055_T, "G71 G90 G95 F.1 M3\nG70 S300\nG0 X1\nM30\n", &[], 1),
        (&FAGOR_8055, "G71 G90 G94 F100 M3\nG70 S300\nG0 X1\nM30\n", &[], 1),
        // Its reference says in which order it obeys them: F first.
        (&LINUXCNC, "G21 G90 S900 M3\nG20 G1 X1 F10\nM2\n", &["G0553"], 1),
        (&LINUXCNC, "G21 G90 S900 M3\nG20 F10\nG1 X1\nM2\n", &["G0553"], 1),
        (&LINUXCNC, "G21 G90 G95 S900 M3\nG20 F.1\nG1 X1\nM2\n", &["G0553"], 1),
        (&LINUXCNC, "G90 S900 M3\nG20 F10\nG0 X1\nG81 X1 Z-1 R1\nM2\n", &["G0553"], 5),
        // No cut is made at that F.
        (&LINUXCNC, "G90 S900 M3\nG20 F10\nF20\nG1 X1\nM2\n", &[], 1),
        (&LINUXCNC, "G90 S900 M3\nG20 F10\nG1 X1 F20\nM2\n", &[], 1),
        (&LINUXCNC, "G90 S900 M3\nG20 F10\nG0 X1\nM2\n", &[], 1),
        (&LINUXCNC, "G90 S900 M3\nG20 F10\nG93 G1 X1 F20\nM2\n", &[], 1),
        // The unit is the same, F is a time, or stands behind.
        (&LINUXCNC, "G21 G90 F100 S900 M3\nG21 G1 X1 F10\nM2\n", &[], 1),
        (&LINUXCNC, "G21 G90 S900 M3\nG20 G93 G1 X1 F10\nM2\n", &[], 1),
        (&LINUXCNC, "G21 G90 S900 M3\nG20\nF10\nG1 X1\nM2\n", &[], 1),
        (&FANUC_LATHE_A, "G21 G98 S900 M3\nG20 G1 X1. F10.\nM30\n", &[], 1),
    ] {
        assert_eq!(codes(control, program), (told.iter().map(|one| (*one).to_owned()).collect(), motions), "{program}");
    }
}

#[test]
fn a_feed_that_linuxcnc_takes_before_the_unit_is_told_with_the_unit_it_counts_in() {
    let told = |program: &str, unit: LengthUnit| {
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting { unit, ..Setting::new(&LINUXCNC) });
        let feeds: Vec<f64> = (&mut interpreter)
            .map(|motion| match motion.expect("a motion").kind {
                MotionKind::Feed(feed) => feed.value,
                _ => 0.0,
            })
            .collect();
        let remark = interpreter.remarks().into_iter().find(|remark| remark.code() == "G0553");
        assert!(remark.as_ref().is_none_or(|one| one.remedy.en.contains("--inch") == one.what.en.contains("first")));
        (feeds, remark.map(|remark| remark.what.en))
    };
    // Nothing has said the unit of before.
    let (feeds, remark) = told("G90 S900 M3\nG20 F10\nG1 X1\nM2\n", LengthUnit::Millimetre);
    let expected = "F in the block of G20, the first that says the unit: the control takes F before it, in the unit that is in force, which rodete does not know; it reads it in mm/min";
    assert_eq!((feeds, remark.as_deref()), (vec![10.0], Some(expected)));
    assert_eq!(told("G90 S900 M3\nG20 F10\nG1 X1\nM2\n", LengthUnit::Inch), (vec![254.0], None));
    let (feeds, remark) = told("G21 G90 S900 M3\nG20 F10\nG1 X1\nM2\n", LengthUnit::Millimetre);
    let expected = "F in the block of G20, which changes the unit: the control takes F before it, in mm/min";
    assert_eq!((feeds, remark.as_deref()), (vec![10.0], Some(expected)));
    // A machine that starts in inches.
    let (feeds, remark) = told("G21 G90 F200 S900 M3\nG1 X100\nM2\n", LengthUnit::Inch);
    let expected = "F in the block of G21, which changes the unit: the control takes F before it, in inches/min";
    assert_eq!((feeds, remark.as_deref()), (vec![5080.0], Some(expected)));
    assert_eq!(told("G21 G90 F200 S900 M3\nG1 X100\nM2\n", LengthUnit::Millimetre), (vec![200.0], None));
}

#[test]
fn a_unit_in_a_rejected_block_is_not_said_to_be_missing() {
    for (first, told) in [("G71 G90 G49", false), ("G90 G49", true), ("G90", true)] {
        let program = format!("%PLATE,MX,\n{first}\nG0 X5 Z5\nM30\n");
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(&FAGOR_8055));
        interpreter.by_ref().for_each(drop);
        assert_eq!(interpreter.remarks().iter().any(|one| one.code() == "G0534"), told, "{first}");
    }
}

#[test]
fn what_hangs_on_a_word_of_a_rejected_block_is_not_told() {
    let told = |control: &'static Control, blocks: &str| {
        let program = format!("{}\nM30\n", blocks.replace('|', "\n"));
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(control));
        interpreter.by_ref().for_each(drop);
        let codes = interpreter.remarks().into_iter().map(|one| one.code());
        codes.filter(|code| ["G0214", "G0538", "G0570"].contains(code)).collect::<Vec<_>>()
    };
    let start = "G21 G90 G94 F100";
    for (blocks, codes) in [
        // Where Z is, or X.
        ("S900 M3|G0 X0 Y0 Z5|G0 Z-3|G0 Z5 Q9|G0 X1|X60 F300", &[][..]),
        ("S900 M3|G0 X0 Y0 Z5|G0 Z-3|X5 Q9|X60 F300", &[]),
        ("S900 M3|G0 X0 Y0 Z5|Z5 Q9|Z-3 F300", &[]),
        ("S900 M3|G0 X0 Y0 Z5|G0 Z-3|G0 X5 Q9|G0 X6|X60 F300", &["G0570"]),
        ("S900 M3|G0 X0 Y0 Z5|G0 Z5 Q9|G0 Z-3|X60 F300", &["G0570"]),
        ("S900 M3|G0 X0 Y0 Z5|X5 Q9|Z-3 F300", &["G0570"]),
        ("S900 M3|G0 X0 Y0 Z5|G91 Q9|Z-3 F300", &[]),
        // S by a parameter that was to be set, and by what is worked out with it.
        ("#8=900 Q9|S#8|M3|G0 X0|G1 X1", &[]),
        ("#8=900 Q9|#9=[#8*2]|S#9|M3|G0 X0|G1 X1", &[]),
        ("#8=900 Q9|S#8|S0|M3|G0 X0|G1 X1", &["G0538"]),
        ("#8=900 Q9|#8=0|S#8|M3|G0 X0|G1 X1", &["G0538"]),
        ("G1 X#8 Q9|S#8|M3|G0 X0|G1 X1", &["G0214", "G0538"]),
        ("#8=9 Q9|S900 M3|G0 X0 Y0 Z#8|Z-3 F300", &[]),
    ] {
        let mut found = told(&LINUXCNC, &format!("{start}|{blocks}"));
        found.sort_unstable();
        assert_eq!(found, codes, "{blocks}");
    }
    let lathe = |blocks: &str| told(&FANUC_LATHE_A, &format!("G21 G98 F100.|S900 M3|T0101|{blocks}"));
    assert_eq!(lathe("G0 X20. Z2.|Z-20.|X30. F9."), ["G0570"]);
    assert!(lathe("G0 X20. Z2.|Z-20.|Z2. Q9.|X30. F9.").is_empty());
    assert!(lathe("G0 X50. Z2.|X20. Q9.|X30. F9.").is_empty());
}

#[test]
fn codes_of_a_fagor_mill_are_told_by_their_names() {
    let program = "%PLATE,MX,\nG71 G90 G94\nS500 M3 M41\nM45\nG4\nM101\nM30\n";
    let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(&FAGOR_8055));
    assert_eq!(interpreter.by_ref().count(), 0);
    let told: Vec<_> = interpreter.remarks().iter().map(|one| one.what.en.to_string()).collect();
    for part in ["M41: speed range", "M45: live tool", "stops preparing blocks", "M101 is a machine builder's code"] {
        assert!(told.iter().any(|one| one.contains(part)), "{part}: {told:?}");
    }
}

#[test]
fn g92_where_a_program_begins_stays_on_whatever_start_is_assumed() {
    for (blocks, stays) in [
        ("G92 X0 Y0\nG1 X1", true),
        ("G92 X5\nG1 X1", true),
        ("G1 X1\nG92 X1", false),
        ("G92 X0 Y0\nG1 X1\nG92.1", false),
        ("G92 X0 Y0\nG1 X1\nG92.2", false),
        ("G92 X0 Y0\nG1 X1\nG92.2\nG92.3", true),
    ] {
        let program = format!("G21 G90 F100 M3 S900\n{blocks}\nM2\n");
        let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(&LINUXCNC));
        assert!(interpreter.all(|item| item.is_ok()), "{blocks}");
        assert_eq!(interpreter.remarks().iter().any(|remark| remark.code() == "G0424"), stays, "{blocks}");
    }
}

#[test]
fn of_two_axes_too_fast_for_a_thread_the_one_that_allows_less_is_told() {
    let program = "G21 G99 T0101\nG96 S1000 M3\nG0 X6. Z6.\nG32 X11. Z-4. F2.\nM30\n";
    let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(&FANUC_LATHE_A));
    assert!(interpreter.all(|item| item.is_ok()));
    let remarks = interpreter.remarks();
    let told = remarks.iter().find(|remark| remark.code() == "G0591").expect("a caution").what.en.clone();
    assert!(told.contains("above 5000 rpm the thread would move axis Z"), "{told}");
}
