//! What the manuals of Fagor's controls say of single words, header and names, block by block.

use rodete::gcode::control::guess::guess;
use rodete::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, FANUC_LATHE_A, LINUXCNC};
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::machine::axis::Axis;

/// The codes of what is rejected in a program of blocks parted by `|`, and where its motions end in X and Z.
fn read(control: &'static Control, program: &str) -> (Vec<&'static str>, Vec<[f64; 2]>) {
    let program = program.replace('|', "\n");
    let (mut codes, mut ends) = (Vec::new(), Vec::new());
    for item in Interpreter::over(program.as_bytes(), Setting::new(control)) {
        match item {
            Ok(motion) => ends.push([Axis::X, Axis::Z].map(|axis| motion.to.get(axis))),
            Err(fault) => codes.push(fault.rule.code),
        }
    }
    (codes, ends)
}

fn codes(control: &'static Control, program: &str) -> Vec<&'static str> {
    read(control, program).0
}

/// The remedies, English, of what is rejected in a program.
fn remedies(control: &'static Control, program: &str) -> String {
    let program = program.replace('|', "\n");
    let faults = Interpreter::over(program.as_bytes(), Setting::new(control)).filter_map(Result::err);
    faults.map(|fault| fault.remedy.en.into_owned()).collect::<Vec<_>>().join("|")
}

#[test]
fn g80_of_an_8055_leaves_the_motion_in_force() {
    for (program, ends) in [
        ("G71 G90 G94|G0 X1 Z5|G90 G80 Z100|M30", vec![[1.0, 5.0], [1.0, 100.0]]),
        ("G71 G90 G94 F100|G1 X1 Z5|G80|X10|M30", vec![[1.0, 5.0], [10.0, 5.0]]),
        ("G71 G90 G94|G1 F100|G80 G0 Z100|M30", vec![[0.0, 100.0]]),
    ] {
        assert_eq!(read(&FAGOR_8055, program), (vec![], ends), "{program}");
    }
    // Without a motion code before there is none behind it; of the 8070 no page says what is.
    assert_eq!(codes(&FAGOR_8055, "G71 G90 G94|G80 X1|M30"), ["G0508"]);
    assert_eq!(codes(&FAGOR_8055, "G71 G90 G94|G80|X1|M30"), ["G0511"]);
    assert_eq!(codes(&FAGOR_8070, "%A|G71 G90 G94|G0 X1|G80 X2|M30"), ["G0508"]);
}

#[test]
fn the_words_of_a_centre_stand_in_the_order_of_their_axes() {
    for (block, rejected) in [
        ("G2 X10 Y0 I5 J0", false),
        ("G2 X10 Y0 J0 I5", true),
        ("G18 G2 X10 Z0 I5 K0", false),
        ("G18 G2 X10 Z0 K0 I5", true),
        ("G19 G2 Y10 Z0 K0 J5", true),
    ] {
        let program = format!("G71 G90 G94 F100|G0 X0 Y0 Z0|{block}|M30");
        let wanted: &[&str] = if rejected { &["G0132"] } else { &[] };
        assert_eq!(codes(&FAGOR_8055, &program), wanted, "{block}");
        assert_eq!(codes(&FAGOR_8070, &format!("%A|{program}")), [""; 0], "{block}");
    }
}

#[test]
fn a_header_with_attributes_stands_in_the_first_line() {
    assert_eq!(codes(&FAGOR_8055, "%A,MX,|G71 G90 G94|G0 X1|M30"), [""; 0]);
    assert_eq!(codes(&FAGOR_8055, ";a|%A,MX,|G71 G90 G94|G0 X1|M30"), ["G0030"]);
    assert_eq!(codes(&FAGOR_8055_T, ";a|%A,MX,|G71 G90 G95|G0 X1|M30"), ["G0030"]);
}

#[test]
fn names_with_digits_parameters_and_subroutines_are_rejected_by_name() {
    for (control, program, wanted) in [
        (&FAGOR_8070, "%A|G71 G90 G94 F100|G1 X1=10|M30", "G0137"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|G1 X1 = 10|M30", "G0137"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|S1=500|M30", "G0137"),
        (&FANUC_LATHE_A, "G21 G98 F100|G1 X1=10.|M30", "G0137"),
        // A control without such names does not read "=", and no axis is called F or M.
        (&FAGOR_8055, "G71 G90 G94 F100|G1 X1=10|M30", "G0141"),
        (&FAGOR_8055_T, "G71 G90 G95 F.1|G1 X1=10|M30", "G0141"),
        (&LINUXCNC, "G21 G90 F100|G1 X1=10|M2", "G0141"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|F1=100|M30", "G0141"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|M2=3|M30", "G0141"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|G54=2|M30", "G0141"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|G1 X10=2|M30", "G0141"),
        (&FAGOR_8055, "G71 G90 G94 F100|G1 XP122 YP121|M30", "G0138"),
        (&FAGOR_8055, "G71 G90 G94 F100|G1 X-P122|M30", "G0138"),
        (&FAGOR_8055, "G71 G90 G94 FP1|M30", "G0138"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|G1 XP1|M30", "G0138"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|G1 XV.A.ORG.X|M30", "G0138"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|V.A.ORG.X=3|M30", "G0138"),
        (&FAGOR_8070, "%L CUT|G91 G1 Z-5 F100|M29|%MAIN|G0 X0|LL CUT|M30", "G0139"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|LL CUT|M30", "G0139"),
        (&FAGOR_8055, "G71 G90 G94 F100|G92|M30", "G0552"),
        (&FANUC_LATHE_A, "G21 G98|G50|M30", "G0552"),
        (&FAGOR_8070, "%A|G71 G90 G94 F100|G92|M30", "G0512"),
        (&FAGOR_8055, "G70 G90 G94 F100|G1 X3938|M30", "G0115"),
        (&FAGOR_8055, "G71 G90 G94 F100|G70 G1 X-3938|M30", "G0115"),
    ] {
        assert_eq!(codes(control, program), [wanted], "{} {program}", control.name);
    }
    // The longest name, an axis in degrees, and a length of millimetres are no such thing.
    for program in ["%LONG|G71 G90 G94|G0 X1|M30", "%L-1|G71 G90 G94|G0 X1|M30"] {
        assert_eq!(codes(&FAGOR_8070, program), [""; 0], "{program}");
    }
    for program in ["G70 G90 G94|G0 X3937|M30", "G71 G90 G94|G0 X4000|M30", "G70 G90 G94|G91 G0 U1|M30"] {
        assert_eq!(codes(&FAGOR_8055, program), [""; 0], "{program}");
    }
}

#[test]
fn no_remedy_makes_another_program() {
    assert!(!remedies(&LINUXCNC, "G21 G90 F100|G1 X1\u{2212}5|M2").contains("take it out,"));
    assert!(!remedies(&FAGOR_8055, "G71 G90 G94 F100|G1 X1 L5|M30").contains("delete"));
    assert!(!remedies(&FAGOR_8070, "%A|G71 G90 G94|G92|M30").contains("G92.1"));
    assert!(remedies(&LINUXCNC, "G21 G90 F100|G92|M2").contains("G92.1"));
    assert!(!remedies(&FAGOR_8070, "%A|G71 G90 G94 F100|G4 0.5|M30").contains("K50"));
}

#[test]
fn a_statement_behind_a_hash_is_an_8070_and_a_message_beside_a_unit_an_8055() {
    for (head, name) in [
        ("#RTCP ON\nG0 X1\n", "fagor-8070"),
        ("N10 G0 X1\n  #CS ON [1]\n", "fagor-8070"),
        ("#1=5\nG0 X1\n", "linuxcnc"),
        ("#<depth>=5\nG0 X1\n", "linuxcnc"),
        ("G71 G90\n(MSG \"HOLA\")\nG0 X1\n", "fagor-8055"),
        ("G21 G90\n(MSG \"HOLA\")\nG0 X1\n", "linuxcnc"),
        ("G71 G90\n(MSG, HOLA)\nG0 X1\n", "linuxcnc"),
    ] {
        assert_eq!(guess(head.as_bytes(), "nc", false).name, name, "{head}");
    }
}
