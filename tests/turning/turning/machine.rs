//! Turret, coordinate systems, reference points, and what is in force during a motion.

use rodete::finding::Grade;
use rodete::gcode::control::FAGOR_8055_T;
use rodete::gcode::in_force::{Speed, Spindle};
use rodete::gcode::interpreter::Setting;
use rodete::gcode::motion::Motion;
use rodete::machine::axis::Axis;

use super::lines::{machine, moves, read, read_with, refusal, refusal_with, remarked, setting};

#[test]
fn the_offset_moves_the_machine_under_the_same_program_point() {
    // Offset 2 is X 10, Z −5; 00 takes it off again; the tool stays.
    let positions = machine("T0101\nG0 X50. Z5.\nT0202\nX50. Z5.\nT0200\nX50. Z5.\nT0102 X40.");
    assert_eq!(positions, [[50.0, 5.0], [60.0, 0.0], [50.0, 5.0], [50.0, 5.0]]);
}

#[test]
fn a_change_of_offset_makes_no_motion_and_changes_the_coordinates() {
    let read = read("T0101\nG0 X50. Z5.\nT0202\nG0 U0 W-1.");
    // The machine stands at X50 Z5; with the offset that point is X40 Z10.
    assert_eq!(read.motions.len(), 2);
    let last: &Motion = &read.motions[1];
    assert!((last.from.get(Axis::X) - 20.0).abs() < 1e-12 && (last.from.get(Axis::Z) - 10.0).abs() < 1e-12);
}

#[test]
fn t_names_place_and_offset() {
    for (word, tool, offset) in [("T0101", 1, 1), ("T101", 1, 1), ("T0302", 3, 2), ("T0300", 3, 0), ("T0", 0, 0)] {
        let read = read(&format!("{word}\nG0 X1."));
        assert_eq!((read.controls[0].tool, read.controls[0].offset), (tool, offset), "{word}");
    }
    for (word, message) in [
        ("T0701", "tool 7 is not in the tool table"),
        ("T0107", "offset 7 is not in the tool table"),
        (
            "T1",
            "T1 gives no turret place, only offset 1; write two digits for the place and two for the offset: T0101 is place 1 with \
             offset 1",
        ),
        (
            "T22",
            "T22 gives no turret place, only offset 22; write two digits for the place and two for the offset: T2222 is place 22 with \
             offset 22 or T0202 is place 2 with offset 2",
        ),
        (
            "T20",
            "T20 gives no turret place, only offset 20; write two digits for the place and two for the offset: T2020 is place 20 with \
             offset 20 or T0200 is place 2 without an offset",
        ),
        ("T10101", "T10101 is not a turret place with its offset"),
        ("T1.5", "T1.5 has a decimal point"),
    ] {
        let refused = refusal(&format!("{word}\nM30\n"));
        assert!(refused.starts_with(&format!("1:1 {message}")), "{refused}");
    }
}

#[test]
fn a_fagor_lathe_takes_tool_and_offset_by_t_and_d() {
    let mut with = setting();
    with.control = &FAGOR_8055_T;
    let read = read_with("G71 G90 T1 D2\nG0 X50 Z5\nT3\nX40\nD1\nX30\nM30\n", with);
    let control: Vec<_> = read.controls.iter().map(|control| (control.tool, control.offset)).collect();
    assert_eq!(control, [(1, 2), (3, 3), (3, 1)]);
    assert!((read.motions[0].machine.get(Axis::X) - 30.0).abs() < 1e-12, "the offset of D2");
    // An offset has a number of its own: it is looked for among the offsets, not in the turret.
    let only = |places: [u32; 1]| Setting { control: &FAGOR_8055_T, places: Some(places.into()), ..setting() };
    let read = read_with("G71 G90 T7 D2\nG0 X50 Z5\nM30\n", only([7]));
    assert_eq!((read.controls[0].tool, read.controls[0].offset), (7, 2));
    for (words, message) in [("T7 D9", "offset 9"), ("T7", "offset 7"), ("T1 D2", "tool 1")] {
        let refused = refusal_with(&format!("G71 G90 {words}\nM30\n"), only([7]));
        assert!(refused.contains(&format!("{message} is not in the tool table")), "{words}: {refused}");
    }
}

#[test]
fn work_offsets_are_selected_and_shifted_from_the_first_zero() {
    // G55 lies at X20 Z100. G54 X30 Z15 lies that far from the zero W1, which is the machine's; G54 alone lies there again.
    let positions = machine("G0 X50. Z5.\nG55 X50. Z5. G0\nG54 X30. Z15.\nX50. Z5.\nG54\nX50. Z5.\nG54 G0 X1. Z2.");
    assert_eq!(positions, [[50.0, 5.0], [70.0, 105.0], [80.0, 20.0], [50.0, 5.0], [1.0, 2.0]]);
    let shifted = read("G54 X30. Z15.\nG0 X0");
    assert!(remarked(&shifted, "this shifts the system from zero W1"));
    assert_eq!(shifted.motions.len(), 1);
    // G56 lies at the machine's zero; shifted it still counts from W1.
    assert_eq!(machine("G55 X10. Z1.\nG0 X0 Z0"), [[10.0, 1.0]]);
}

#[test]
fn g53_is_in_machine_coordinates_for_its_block() {
    let positions = machine("T0202\nG55\nG0 X50. Z5.\nG53 G0 X0 Z120.\nX50. Z5.");
    assert_eq!(positions, [[80.0, 100.0], [0.0, 120.0], [80.0, 100.0]]);
}

#[test]
fn g53_is_made_at_rapid_whatever_is_in_force_and_that_is_in_force_again_afterwards() {
    // The zero is the machine's: program and machine coordinates are one.
    moves("G1 X40. F.3\nG53 X100. Z100.\nX90.", &["G1 X40 Z5 F0.3", "G0 X100 Z100", "G1 X90 Z100 F0.3"]);
    moves("G2 X60. Z0 R5.\nG53 X100. Z100.", &["G2 X60 Z0 C60,5 F0.2", "G0 X100 Z100"]);
    moves("G0 G53 X100.\nX90.", &["G0 X100 Z5", "G0 X90 Z5"]);
}

#[test]
fn a_motion_code_beside_a_one_shot_code_is_in_force_from_there_on() {
    moves("G1 X40. F.3\nG00 G28 U0 W0\nX90.", &["G1 X40 Z5 F0.3", "G0 X300 Z400", "G0 X90 Z400"]);
    moves("G28 G00 U0\nG28 W0", &["G0 X300 Z5", "G0 X300 Z400"]);
    moves("G0 G50 S2000\nG30 P2 U0 W0", &["G0 X200 Z250"]);
    let refused = refusal("G30 P3 U0\nM30\n");
    assert!(
        refused.starts_with("1:5 G30 P3: rodete does not follow the third and fourth reference points"),
        "{refused}"
    );
}

#[test]
fn x_beyond_the_axis_is_told_of_increments_too() {
    for (block, grade) in [("G1 U-51.", Grade::Note), ("G1 U-80.", Grade::Caution), ("G1 X-30.", Grade::Caution)] {
        let read = read(&format!("G21 T0101 M3 S1000 F0.2\nG0 X50. Z5.\n{block}"));
        let found: Vec<_> = read.remarks.iter().map(|remark| (remark.grade, remark.what.en.as_ref())).collect();
        assert_eq!(found, [(grade, "negative X: the programmed point is beyond the axis")], "{block}");
    }
}

#[test]
fn codes_of_the_builder_are_noted_and_not_run() {
    let read = read("G21 M41\nG0 X1. M19\nM13");
    assert_eq!(read.remarks.len(), 3);
    assert!(remarked(&read, "M41 is a machine builder's code: rodete does not run it"));
}

#[test]
fn g50_sets_the_position_or_the_limit() {
    moves("G50 X100. Z50.\nG0 X100. Z50.\nX90.", &["G0 X100 Z50", "G0 X90 Z50"]);
    assert_eq!(machine("G0 X50. Z5.\nG50 X100. Z50.\nG0 X90. Z40."), [[50.0, 5.0], [40.0, -5.0]]);
    // U and W: the coordinates grow by so much.
    assert_eq!(machine("G0 X50. Z5.\nG50 U10. W-3.\nG0 X60. Z2."), [[50.0, 5.0], [50.0, 5.0]]);
    let read = read("G50 S2500\nG96 S180 M3\nG0 X50.");
    assert_eq!(read.controls[0].greatest_speed, Some(2500.0));
    assert_eq!(read.controls[0].speed, Speed::Surface(180.0));
}

#[test]
fn g28_and_g30_go_over_a_point_to_the_reference_point() {
    assert_eq!(machine("G0 X50. Z5.\nG28 U0 W0"), [[50.0, 5.0], [300.0, 400.0]]);
    assert_eq!(machine("G0 X50. Z5.\nG28 U0\nG28 W0"), [[50.0, 5.0], [300.0, 5.0], [300.0, 400.0]]);
    assert_eq!(machine("T0202\nG0 X50. Z5.\nG28 X80. Z10."), [[60.0, 0.0], [90.0, 5.0], [300.0, 400.0]]);
    assert_eq!(machine("G30 U0 W0"), [[200.0, 250.0]]);
    let read = read("T0202\nG0 X50. Z5.\nG28 X80. Z10.\nG28 U0 W0\nG0 X50. Z5.");
    let over: Vec<bool> = read.controls.iter().map(|control| control.to_intermediate).collect();
    assert_eq!(
        over,
        [false, true, false, false, false],
        "the way to the point alone, and none where the return begins at once"
    );
    let mut unknown = setting();
    unknown.var_file = Default::default();
    let read = read_with("G28 U0\nM30\n", unknown);
    assert!(remarked(&read, "the reference point of G28 is not known"));
}

#[test]
fn the_spindle_starts_before_the_motion_and_stops_after_it() {
    let read = read("G0 X50. Z5. M3 M8 S500\nX49. M5 M9\nX48.\nM4\nX47. M5\nG4 P10 M3\nX46.");
    let state: Vec<_> = read.controls.iter().map(|control| (control.spindle, control.coolant)).collect();
    let (cw, ccw, still) = (Spindle::Clockwise, Spindle::CounterClockwise, Spindle::Stopped);
    assert_eq!(state, [(cw, true), (cw, true), (still, false), (ccw, false), (cw, false), (cw, false)]);
}

#[test]
fn what_stops_after_a_cycle_stops_after_its_last_motion() {
    let read = read("S500 M3 F.2\nG0 X50. Z5.\nG90 X40. Z-10. M5\nG0 X60.");
    let state: Vec<_> = read.controls.iter().map(|control| control.spindle).collect();
    assert_eq!(state[..5], [Spindle::Clockwise; 5]);
    assert_eq!(state[5], Spindle::Stopped);
}

#[test]
fn doors_and_stops_are_known_and_silent() {
    let read = read("G21 M38\nM39\nM0\nM1\nG0 X1. M38");
    assert!(read.remarks.is_empty(), "{:?}", read.remarks);
}

#[test]
fn a_comment_stands_in_parentheses_or_behind_a_semicolon() {
    moves(
        "G0 X40. (near) Z1. ; the start of it all\n(alone)\n; alone\nG0 X30. ;\n/G0 X20.",
        &["G0 X40 Z1", "G0 X30 Z1", "G0 X20 Z1"],
    );
    let mut skipping = setting();
    skipping.block_delete = true;
    let read = read_with("G0 X40.\n/G0 X20.\nM30\n", skipping);
    assert_eq!(read.motions.len(), 1);
    let refused = refusal("G0 X40. ; Z5.\nM30\n");
    assert!(refused.starts_with("1:9 there is a block after ';'"), "{refused}");
    for text in ["T1 roughing", "Z0 face", "N10", "", " G0 fast"] {
        moves(&format!("G0 X40. ; {text}"), &["G0 X40 Z5"]);
    }
    moves("/1 G0 X40.\n/9G0X30.", &["G0 X40 Z5", "G0 X30 Z5"]);
    let refused = refusal("G0 X40. /Z5.\nM30\n");
    assert!(refused.starts_with("1:9 character '/' is not allowed"), "{refused}");
}

#[test]
fn a_tape_has_percent_signs_and_a_program_number() {
    moves_of("%\nO0012 (PART)\nN10 G0 X40.\nN20 M30\n%\n", 1);
    moves_of("O0012\nG0 X40.\nM02\n", 1);
}

fn moves_of(program: &str, count: usize) {
    let read = read_with(program, setting());
    assert!(read.faults.is_empty(), "{:?}", read.faults);
    assert_eq!(read.motions.len(), count);
}
