//! Numbers without a decimal point (X100: 100 mm, or 0.1 mm).

use rodete::gcode::interpreter::DecimalPoint;
use rodete::machine::axis::Axis;

use super::lines::{Read, line, read_with, refusal, refusal_with, remarked, setting};

fn read(program: &str, point: DecimalPoint) -> Read {
    let mut setting = setting();
    setting.decimal_point = Some(point);
    let read = read_with(&format!("{program}\nM30\n"), setting);
    assert!(read.faults.is_empty(), "{program}\n{:?}", read.faults);
    read
}

fn lines(program: &str, point: DecimalPoint) -> Vec<String> {
    read(program, point).motions.iter().map(line).collect()
}

#[test]
fn without_the_setting_such_a_dimension_is_refused() {
    let refused = refusal("G0 X100\nM30\n");
    assert!(
        refused.starts_with(
            "1:4 X100 has no decimal point: the control reads it as mm or µm, depending on its setting; write X100."
        ),
        "{refused}"
    );
    assert!(refused.contains("--decimal-point"), "{refused}");
    let refused = refusal("G0 X0 Z0\nG1 Z-5. F2\nM30\n");
    assert!(refused.starts_with("2:9 F2 has no decimal point"), "{refused}");
    // A feed a minute, zero and the number of passes of G73 are what they are.
    assert!(read_with("G98 G0 X0\nG1 Z-5. F100\nG73 U2. W1. R3\nM30\n", setting()).faults.is_empty());
}

#[test]
fn each_rule_reads_it_in_its_own_way_and_counts_it() {
    let program = "G0 X100 Z-2500\nU10.5 W-500\nG2 X104 Z-4000 R2000";
    let calculator = read("G0 X100 Z-25\nU10.5 W-5", DecimalPoint::Calculator);
    assert!((calculator.motions[1].to.get(Axis::Z) + 30.0).abs() < 1e-12);
    let note = calculator.remarks.iter().find(|remark| remark.what.en.contains("read as mm")).unwrap();
    assert_eq!(note.value, "3 ×");
    let micrometre = lines(program.trim_end_matches("\nG2 X104 Z-4000 R2000"), DecimalPoint::Micrometre);
    assert_eq!(micrometre, ["G0 X0.1 Z-2.5", "G0 X10.6 Z-3"]);
    let read = read("G0 X100", DecimalPoint::Micrometre);
    assert!(remarked(&read, "read as least increments"));
}

#[test]
fn inches_and_dwells_have_increments_of_their_own() {
    assert_eq!(lines("G20 G0 X10000", DecimalPoint::Micrometre), ["G0 X25.4 Z0"]);
    assert_eq!(lines("G20\nG4 X1500", DecimalPoint::Micrometre), ["G4 1.5"]);
    assert_eq!(lines("G4 X2", DecimalPoint::Calculator), ["G4 2"]);
    for (program, point, said) in [
        (
            "G20 G0 X10000",
            DecimalPoint::Micrometre,
            "dimensions without decimal point, read as least increments (0.0001 inch)",
        ),
        ("G20 G0 X1", DecimalPoint::Calculator, "dimensions without decimal point, read as inches"),
        ("G20\nG4 X1500", DecimalPoint::Micrometre, "dwell times without a decimal point, read as ms"),
        ("G4 U2", DecimalPoint::Calculator, "dwell times without a decimal point, read as s"),
    ] {
        let remarks = read(program, point).remarks;
        assert!(remarks.iter().any(|remark| remark.what.en == said), "{program} {remarks:?}");
    }
    assert!(
        refusal("G20 G0 X1\nM30\n")
            .contains("X1 has no decimal point: the control reads it as inches or ten-thousandths")
    );
    assert!(refusal("G4 X1\nM30\n").contains("X1 has no decimal point: the control reads it as s or ms"));
}

#[test]
fn what_has_no_decimal_point_in_a_contour_is_read_by_the_feed_code_in_force_there() {
    // F120 behind G98 is mm a minute, and what it is in roughing does not matter; behind G99 F1 is a length again.
    let contour = "N10 G0 X30.\nG1 Z-10. F.1\nG98 X40. F100\nZ-20. F120\nN20 G99 Z-30. F.2\n";
    let head = "T0101 M3 S1000 F.2\nG0 X50. Z5.\n";
    let program = format!("{head}G73 U0. W0. R1\nG73 P10 Q20 F.3\n{contour}G70 P10 Q20\nG1 X60.\nM30\n");
    let read = read_with(&program, setting());
    assert!(read.faults.is_empty(), "{:?}", read.faults);
    let finished: Vec<String> = read.motions.iter().rev().take(6).rev().map(line).collect();
    let wanted =
        ["G1 X30 Z-10 F0.1", "G1 X40 Z-10 F100", "G1 X40 Z-20 F120", "G1 X40 Z-30 F0.2", "G0 X50 Z5", "G1 X60 Z5 F0.2"];
    assert_eq!(finished, wanted);
    let refused = refusal(&format!("{head}G98\nG70 P10 Q20\nM30\nN10 G0 G99 X30.\nN20 G1 Z-10. F1\n"));
    assert!(refused.starts_with("7:14 F1 has no decimal point"), "{refused}");
}

#[test]
fn a_number_with_blanks_is_told_in_a_contour_too() {
    let contour = "N10 G0 X3 0.\nN20 G1 Z-10. F.1\n";
    let read = read_with(&format!("T0101 M3 S1000 F.2\nG0 X50. Z5.\nG70 P10 Q20\nM30\n{contour}"), setting());
    assert!(read.faults.is_empty() && remarked(&read, "number with blanks inside"), "{:?}", read.faults);
}

#[test]
fn a_feed_per_revolution_without_a_point_is_refused_where_the_control_counts_increments() {
    let mut setting = setting();
    setting.decimal_point = Some(DecimalPoint::Micrometre);
    let refused = refusal_with("G0 X0\nG1 Z-1. F2\nM30\n", setting);
    assert!(refused.starts_with("2:9 F2 has no decimal point: the unit of a feed per revolution"), "{refused}");
    assert_eq!(lines("G0 X0 Z0\nG1 Z-1. F2", DecimalPoint::Calculator), ["G0 X0 Z0", "G1 X0 Z-1 F2"]);
}
