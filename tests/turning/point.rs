//! Numbers without a decimal point (X100: 100 mm, or 0.1 mm).

use rodete::gcode::interpreter::DecimalPoint;
use rodete::machine::axis::Axis;

use crate::lines::{Read, line, read_with, refusal, refusal_with, remarked, setting};

fn read(program: &str, point: DecimalPoint) -> Read {
    let mut setting = setting();
    setting.point = Some(point);
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
        refused.starts_with("1:4 X100 has no decimal point: mm or µm, depending on the control; write X100."),
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
}

#[test]
fn a_feed_per_revolution_without_a_point_is_refused_where_the_control_counts_increments() {
    let mut setting = setting();
    setting.point = Some(DecimalPoint::Micrometre);
    let refused = refusal_with("G0 X0\nG1 Z-1. F2\nM30\n", setting);
    assert!(refused.starts_with("2:9 F2 has no decimal point: the increment of a feed per revolution"), "{refused}");
    assert_eq!(lines("G0 X0 Z0\nG1 Z-1. F2", DecimalPoint::Calculator), ["G0 X0 Z0", "G1 X0 Z-1 F2"]);
}
