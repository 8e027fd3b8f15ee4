//! What an absolute word of a rotary axis means, and turns at feed of more than half a turn.

use std::path::Path;

use rodete::finding::Grade;
use rodete::gcode::control::{ALL, Control, FAGOR_8055, LINUXCNC};
use rodete::gcode::interpreter::{Interpreter, RotaryMode, Setting};
use rodete::machine::axis::Axis;

/// Where C goes, counted on beyond a turn, what is refused and what is remarked.
#[derive(Debug, Default)]
struct Read {
    ends: Vec<f64>,
    refused: Vec<String>,
    cautions: Vec<String>,
}

fn read(control: &'static Control, rotary: Option<RotaryMode>, program: &str) -> Read {
    let mut setting = Setting::new(control);
    setting.rotary = rotary.unwrap_or(setting.rotary);
    let mut interpreter = Interpreter::over(program.as_bytes(), setting);
    let mut read = Read::default();
    for item in &mut interpreter {
        match item {
            Ok(motion) => read.ends.push(motion.to.get(Axis::C)),
            Err(fault) => read.refused.push(fault.what.en.to_string()),
        }
    }
    let cautions = interpreter.remarks().into_iter().filter(|remark| remark.grade == Grade::Caution);
    read.cautions = cautions.map(|remark| remark.what.en.to_string()).collect();
    read
}

fn ends(rotary: RotaryMode, program: &str) -> Vec<f64> {
    let read = read(&FAGOR_8055, Some(rotary), program);
    assert!(read.refused.is_empty(), "{read:?}");
    read.ends
}

#[test]
fn only_a_fagor_8055_has_rollover_axes_as_delivered() {
    let rollover: Vec<_> = ALL
        .into_iter()
        .filter(|control| control.rotary.delivered == RotaryMode::Rollover)
        .map(|control| control.name)
        .collect();
    assert_eq!(rollover, ["fagor-8055", "fagor-8055-t"]);
}

#[test]
fn the_sign_is_the_direction_and_the_number_the_angle() {
    let to = |from: &str, word: &str| ends(RotaryMode::Rollover, &format!("G91 G0 {from}\nG90 {word}\nM30\n"))[1];
    for (from, word, end) in [
        ("C10", "C350", 350.0),
        ("C10", "C-350", -10.0),
        ("C350", "C10", 370.0),
        ("C360", "C-90", 90.0),
        ("C370", "C20", 380.0),
        ("C370", "C5", 725.0),
        ("C-30", "C-270", -90.0),
        ("C-30", "C0", 0.0),
        ("C90", "C0", 360.0),
    ] {
        assert!((to(from, word) - end).abs() < 1e-9, "{from} {word}: {}", to(from, word));
    }
}

#[test]
fn increments_are_the_same_under_both_settings() {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let published = |name: &str| std::fs::read_to_string(golden.join(name)).expect("a published program");
    let programs = [
        "G91 G1 C-90 F100\nC720\nC-0\nG90 X5\nM30\n".to_owned(),
        published("annex-09-blade-as-printed.nc"),
        published("annex-10-splitter-as-printed.nc"),
    ];
    for program in programs {
        let [linear, rollover] = [RotaryMode::Linear, RotaryMode::Rollover].map(|rotary| ends(rotary, &program));
        assert_eq!(linear, rollover);
    }
}

#[test]
fn an_absolute_program_for_linear_axes_turns_the_other_way_where_they_are_rollover() {
    let program = "G90 G0 C-270\nG1 C-265.5 F100\nX1 C-261\nX2 C270\nX3 C265.5\nX4 C261.25\nM30\n";
    let linear = read(&FAGOR_8055, Some(RotaryMode::Linear), program);
    assert_eq!(linear.ends, [-270.0, -265.5, -261.0, 270.0, 265.5, 261.25]);
    let rollover = read(&FAGOR_8055, None, program);
    assert_eq!(rollover.ends, [-90.0, -94.5, -99.0, -90.0, 265.5, 621.25]);
    assert_eq!(
        rollover.cautions,
        ["a rotary axis makes more than half a turn in one feed block: C turns 355.75°; 2 such blocks, the \
             largest in line 6"]
    );
}

#[test]
fn a_turn_of_more_than_half_at_feed_is_told_with_its_figure_and_one_at_rapid_is_not() {
    let told = |program: &str| read(&LINUXCNC, None, program).cautions;
    assert_eq!(
        told("G21 G1 F100 A180\nA360.5\nG0 A0\nM2\n"),
        ["a rotary axis makes more than half a turn in one feed block: A turns 180.5°"]
    );
    let arc = "G21 G17 G3 X0 Y0 I5 J0 B-181 F100\nM2\n";
    assert!(told(arc).iter().any(|what| what.ends_with("B turns -181°")), "{:?}", told(arc));
    assert!(told("G21 G1 F100 A180\nA0\nM2\n").is_empty());
}

#[test]
fn a_target_beyond_the_turn_is_refused() {
    let refused = |words: &str| read(&FAGOR_8055, None, &format!("G90 G0 {words}\nM30\n")).refused;
    for words in ["C360", "C-360", "C370.5", "B-720"] {
        let refused = refused(words);
        assert!(refused.len() == 1 && refused[0].starts_with(&format!("0168: {words} in G90")), "{words}: {refused:?}");
    }
    assert!(refused("C359.9999").is_empty() && refused("X0\nG91 C720").is_empty());
    let preset = read(&FAGOR_8055, None, "G92 C-10\nG92 C350\nM30\n").refused;
    assert!(preset.len() == 1 && preset[0].starts_with("0199: C-10"), "{preset:?}");
    assert!(read(&FAGOR_8055, Some(RotaryMode::Linear), "G90 G0 C370\nM30\n").refused.is_empty());
}

#[test]
fn what_the_manuals_do_not_say_is_a_caution() {
    let cautions = |program: &str| read(&FAGOR_8055, None, program).cautions;
    let reached = "C is already at the angle of its G90 word: the control's behaviour is undefined";
    assert_eq!(cautions("G91 G0 C90\nG90 C90\nM30\n"), [reached]);
    assert_eq!(cautions("G91 G0 C-0.001\nC0.001\nG90 C0\nM30\n"), [reached]);
    let minus = cautions("G91 G0 C90\nG90 C-0\nM30\n");
    assert_eq!(minus, ["C-0 in G90: undefined on this control; rodete reads it as a turn in minus to 0"]);
    assert_eq!(ends(RotaryMode::Rollover, "G91 G0 C90\nG90 C-0\nM30\n"), [90.0, 0.0]);
}

#[test]
fn a_wrapped_axis_of_linuxcnc_is_read_by_the_same_rule() {
    let wrapped = |program: &str| read(&LINUXCNC, Some(RotaryMode::Rollover), program);
    let read = wrapped("G21 G90 G0 C350\nC10\nC10\nC-350\nM2\n");
    assert_eq!((read.ends, read.cautions), (vec![350.0, 370.0, 370.0, 350.0], Vec::<String>::new()));
    assert!(wrapped("G21 G90 G0 C360\nM2\n").refused[0].starts_with("C360 in G90"));
}
