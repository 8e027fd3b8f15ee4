//! Words that a lathe has no use for: other axes than X and Z, polar words, repetitions; and an F whose meaning no code has said.

use rodete::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FANUC_LATHE_A};
use rodete::gcode::interpreter::{DecimalPoint, Interpreter, Setting};
use rodete::gcode::letters::Letters;

/// What is found in line 3 of a program of which it is a block: the codes of stops, and of remarks.
fn found(control: &'static Control, begin: &str, block: &str, axes: Option<Letters>) -> [Vec<&'static str>; 2] {
    let text = format!("{begin}\nG0 X50. Z5.\n{block}\nM30\n");
    let mut setting = Setting::new(control);
    setting.axes = axes;
    setting.decimal_point = Some(DecimalPoint::Calculator);
    let mut interpreter = Interpreter::over(text.as_bytes(), setting);
    let stops = interpreter.by_ref().filter_map(Result::err).map(|fault| {
        assert_eq!(fault.line, 3, "{block}: {fault:?}");
        fault.rule.code
    });
    let stops = stops.collect();
    [stops, interpreter.remarks().iter().map(|finding| finding.rule().code).collect()]
}

const FAGOR: &str = "G71 G90 G95 F0.2 S500 T1 D1 M3";
const LATHE: Option<Letters> = Some(Letters::of("XZ"));

#[test]
fn words_of_axes_that_a_lathe_lacks_stop_where_it_is_known_and_are_cautioned_where_not() {
    for block in ["G1 X48 W-2", "G1 U-2", "G1 X48 Y5", "G0 C20", "G1 Z-5 A10", "G0 X60 V3", "G0 B3", "G53 G0 W0"] {
        let [stops, _] = found(&FAGOR_8055_T, FAGOR, block, LATHE);
        // U and W may be meant as increments.
        let [stopped, cautioned] = if block.contains(['U', 'W']) { ["G0838", "G0839"] } else { ["G0836", "G0837"] };
        assert_eq!(stops, [stopped], "{block}");
        let [stops, remarks] = found(&FAGOR_8055_T, FAGOR, block, None);
        assert_eq!(stops, Vec::<&str>::new(), "{block}");
        assert!(remarks.contains(&cautioned), "{block}: {remarks:?}");
    }
    // U and W are increments of X and Z there; letters of a cycle are its parameters.
    for (control, begin, block) in [
        (&FANUC_LATHE_A, "T0101 S500 M3 F.2", "G1 U-2. W-3."),
        (&FANUC_LATHE_A, "T0101 S500 M3 F.2", "G4 U1."),
        (&FAGOR_8055_T, FAGOR, "G83 X0 Z0 I10 B5 D1 C1"),
        (&FAGOR_8055_T, FAGOR, "G86 X40 Z0 Q40 R-20 I1 B0.3 D3 C2 A0"),
        (&FAGOR_8055, FAGOR, "G1 Y5 C20"),
    ] {
        for axes in [LATHE, None] {
            let [stops, remarks] = found(control, begin, block, axes);
            assert_eq!(stops, Vec::<&str>::new(), "{block}");
            assert!(!remarks.iter().any(|code| ["G0837", "G0839"].contains(code)), "{block}: {remarks:?}");
        }
    }
}

#[test]
fn polar_words_and_repetitions_of_a_fagor_are_refused_by_what_they_are() {
    for (control, block, code) in [
        (&FAGOR_8055_T, "G1 Z-10 Q150", "G0134"),
        (&FAGOR_8055_T, "G1 X40 Q-170", "G0134"),
        (&FAGOR_8055_T, "G1 R20 Q45", "G0134"),
        (&FAGOR_8055_T, "G1 R20", "G0134"),
        (&FAGOR_8055, "G1 R20 Q45", "G0134"),
        (&FAGOR_8055, "G1 X40 Q-45", "G0134"),
        (&FAGOR_8055_T, "G1 X40 N5", "G0135"),
        (&FAGOR_8055, "G1 X40 N5 ;repeat", "G0135"),
        // Neither: a slip.
        (&FAGOR_8055_T, "G1 X40 R5", "G0515"),
        (&FAGOR_8055, "G1 N5 X40", "G0118"),
    ] {
        assert_eq!(found(control, FAGOR, block, None)[0], [code], "{block}");
    }
}

#[test]
fn a_lathe_that_may_start_with_either_feed_is_told_where_no_code_has_said_it() {
    let told = |control, begin, block| found(control, begin, block, None)[1].contains(&"G0537");
    let unsaid = "G71 G90 F0.2 S500 T1 D1 M3";
    assert!(told(&FAGOR_8055_T, unsaid, "G1 X48"));
    assert!(told(&FAGOR_8055_T, unsaid, "G81 X20 Z0 Q20 R-20 C5 D1"));
    assert!(!told(&FAGOR_8055_T, FAGOR, "G1 X48"));
    assert!(!told(&FAGOR_8055_T, unsaid, "G0 X48"), "nothing goes at feed");
    assert!(!told(&FAGOR_8055, unsaid, "G1 X48"), "a mill");
    assert!(!told(&FANUC_LATHE_A, "T0101 S500 M3 F.2", "G1 X48."), "per revolution, as its list of codes has it");
}
