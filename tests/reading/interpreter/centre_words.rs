//! The centre word of the axis across the plane of an arc, which some posts write as 0 on every arc.

use rodete::finding::Grade;
use rodete::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, LINUXCNC};
use rodete::gcode::interpreter::{Interpreter, Setting};
use rodete::gcode::motion::MotionKind;

/// How many arcs a program makes, what is refused and what is cautioned of.
fn read(control: &'static Control, arc: &str) -> (usize, Vec<String>, Vec<String>) {
    let plane = if control.turns() { "G18" } else { "G17" };
    let program = format!("{plane} G90 G94 F100\nG0 X0 Y0 Z0\n{arc}\nM30\n");
    let mut interpreter = Interpreter::over(program.as_bytes(), Setting::new(control));
    let (mut arcs, mut refused) = (0, Vec::new());
    for item in &mut interpreter {
        match item {
            Ok(motion) => arcs += usize::from(matches!(motion.kind, MotionKind::Arc(..))),
            Err(fault) => refused.push(format!("{} {}; {}", fault.line, fault.what.en, fault.remedy.en)),
        }
    }
    let cautions = interpreter.remarks().into_iter().filter(|remark| remark.grade == Grade::Caution);
    (arcs, refused, cautions.map(|remark| remark.what.en.to_string()).collect())
}

#[test]
fn a_zero_across_a_planar_arc_is_told_where_no_page_says_what_the_control_does() {
    for (control, arc, told) in [
        (&FAGOR_8070, "G2 X10 Y0 I5 J0 K0", "K0 in an arc of G17: rodete ignores it"),
        (&FAGOR_8070, "G2 X10 Y0 Z0 I5 J0 K-0.000", "K0 in an arc of G17: rodete ignores it"),
        (&FAGOR_8055_T, "G2 X0 Z10 I0 J0 K5", "J0 in an arc of G18: rodete ignores it"),
    ] {
        let (arcs, refused, cautions) = read(control, arc);
        assert_eq!((arcs, refused.as_slice()), (1, [].as_slice()), "{arc}");
        assert!(cautions.iter().any(|caution| caution.starts_with(told)), "{arc}: {cautions:?}");
    }
}

#[test]
fn a_word_across_an_arc_that_may_be_a_pitch_is_refused() {
    for (control, arc, told) in [
        (
            &FAGOR_8070,
            "G2 X10 Y0 Z1 I5 J0 K0",
            "3 K does not belong to the plane G17; use I and J, or change the plane",
        ),
        (&FAGOR_8070, "G2 X10 Y0 I5 J0 K1", "3 K does not belong to the plane G17; use I and J, or change the plane"),
        (
            &FAGOR_8055,
            "G2 X10 Y0 I5 J0 K0",
            "3 K0: K is the pitch of a helix in G17, above 0 (error 0054); take K out; \
             if the arc is in another plane, program that plane before it (G17, G18 or G19)",
        ),
        (
            &FAGOR_8055,
            "G2 X0 Y0 Z-6 I5 J0 K2",
            "3 K is the pitch of a helix in G17, which rodete does not follow; \
             write the helix turn by turn, with its Z and without K; \
             if the arc is in another plane, program that plane before it (G17, G18 or G19)",
        ),
        // An arc of another plane than the one in force: what it says of its centre is not taken out.
        (&FAGOR_8055, "G18 G2 X10 Y0 I5 J0", "3 J does not belong to the plane G18; use K and I, or change the plane"),
        (&FAGOR_8055, "G18 G2 X10 Y10 I5 J5", "3 J does not belong to the plane G18; use K and I, or change the plane"),
        (&FAGOR_8070, "G19 G2 Z10 X10 K5 I0", "3 I does not belong to the plane G19; use J and K, or change the plane"),
        // As LinuxCNC has it.
        (&LINUXCNC, "G2 X10 Y0 I5 J0 K0", "3 K does not belong to the plane G17; use I and J, or change the plane"),
    ] {
        let (arcs, refused, _) = read(control, arc);
        assert_eq!((arcs, refused), (0, vec![told.to_owned()]), "{arc}");
    }
}
