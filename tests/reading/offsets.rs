//! Work offsets and LinuxCNC's parameter file, held against LinuxCNC's own interpreter where it is installed.

use crate::common;

use common::rs274::{self, Refused};
use proptest::prelude::*;
use rodete::finding::{Exit, Grade, Place, Refusal};
use rodete::gcode::offset_preamble::preamble;
use rodete::limits::VAR_FILE_BYTES;
use rodete::machine::axis::{Axis, Pose};
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::offset_edit::Edit;
use rodete::machine::var_file::{LAST, VarFile, required};
use rodete::machine::work_offset::{ActiveOffsets, Offsets, System, WorkOffset};
use rodete::text::Language;

/// Runs a program with a var file: the canonical calls, and the var file that is left behind.
fn rs274(program: &str, var: Option<&str>) -> Result<(String, String), String> {
    match rs274::run(program.as_bytes(), var, None) {
        Ok(canon) => Ok((canon.text, canon.var)),
        Err(Refused::Error(message, _)) => Err(message),
        Err(Refused::Deadline) => Err("deadline".to_owned()),
    }
}

/// The numbers of every call of a name in a list of canonical calls.
fn calls(canon: &str, name: &str) -> Vec<Vec<f64>> {
    canon
        .lines()
        .filter_map(|line| line.split_once(name)?.1.strip_prefix('('))
        .map(|rest| rest.trim_end_matches(')').split(',').map(|number| number.trim().parse().unwrap()).collect())
        .collect()
}

fn read(text: &str) -> VarFile {
    VarFile::parse(text.as_bytes()).unwrap()
}

fn english(refusal: &Refusal) -> Vec<(Place, String)> {
    assert_eq!(refusal.exit, Exit::Refused);
    refusal
        .findings
        .iter()
        .map(|finding| {
            assert_eq!(finding.grade, Grade::Stop);
            assert!(!finding.remedy.es.is_empty() && !finding.remedy.en.is_empty(), "{finding:?}");
            (finding.place.clone(), finding.what.get(Language::En).to_owned())
        })
        .collect()
}

#[test]
fn every_bad_line_is_refused_with_its_place_and_reason() {
    for (text, line, columns, what) in [
        ("garbage\n", 1, vec![1], "'garbage' is not a parameter number"),
        ("5220\t1\n; note\n", 2, vec![1], "';' is not a parameter number"),
        ("\u{feff}5161\t0\n", 1, vec![1], "'\\u{feff}5161' is not a parameter number"),
        ("5221.5 3\n", 1, vec![1], "'5221.5' is not a parameter number"),
        ("+\t3\n", 1, vec![1], "'+' is not a parameter number"),
        ("0\t1\n", 1, vec![1], "there is no parameter with this number"),
        ("-3\t1\n", 1, vec![1], "there is no parameter with this number"),
        ("5602\t1\n", 1, vec![1], "there is no parameter with this number"),
        ("52210000000\t1\n", 1, vec![1], "there is no parameter with this number"),
        ("5221\n", 1, vec![1], "parameter 5221 has no value"),
        ("5221\t1.5 2\n", 1, vec![10], "there is text after the value: '2'"),
        ("  5221\t1,5\n", 1, vec![8], "'1,5' is not a number"),
        ("5221\t0x10\n", 1, vec![6], "'0x10' is not a number"),
        ("5221\t1_0\n", 1, vec![6], "'1_0' is not a number"),
        ("5221\t--5\n", 1, vec![6], "'--5' is not a number"),
        ("5221\t\u{2212}5\n", 1, vec![6], "'\u{2212}5' is not a number"),
        ("5221\t12.5\0\n", 1, vec![6], "'12.5\\u{0}' is not a number"),
        ("5221\t1.0\r5222\t2.0\n", 1, vec![15], "there is text after the value: '2.0'"),
        ("5221\tnan\n", 1, vec![6], "the value is too large or not finite"),
        ("5221\t-inf\n", 1, vec![6], "the value is too large or not finite"),
        ("5221\t1e400\n", 1, vec![6], "the value is too large or not finite"),
        ("5221\t1e200\n", 1, vec![6], "the value is too large or not finite"),
        ("5220\t1\n\n5161\t0\n", 3, vec![], "parameter 5161 comes after 5220 in line 1"),
        ("5220\t1\n5220\t2\n", 2, vec![], "parameter 5220 appears twice, first in line 1"),
        ("5161\t1\n5220\t1\n5161\t2\n", 3, vec![], "parameter 5161 appears twice, first in line 1"),
    ] {
        let refusal = VarFile::parse(text.as_bytes()).expect_err(text);
        assert_eq!(english(&refusal), [(Place::Line { line, columns }, what.to_owned())], "{text:?}");
    }
    let long = format!("5221\t0.{}\n", "0".repeat(300));
    assert_eq!(
        english(&VarFile::parse(long.as_bytes()).unwrap_err())[0].1,
        "the line is too long: LinuxCNC would read it as two"
    );
    let bytes = VarFile::parse(b"5221\t\xff\n").unwrap_err();
    assert_eq!(english(&bytes)[0].1, "'\u{fffd}' is not a number");
    let all = VarFile::parse(b"x\n5220\t1,0\n5161\t0\n5161\t0\n").unwrap_err();
    assert_eq!(all.findings.len(), 3, "all faults at once: {all:?}");
}

#[test]
fn a_workbook_in_place_of_the_file_is_told_in_one_sentence() {
    let refusal = VarFile::parse(b"PK\x03\x04\n\n\n5220\t1\nx\n").unwrap_err();
    let [told] = refusal.findings.as_slice() else { panic!("{refusal:?}") };
    assert_eq!(told.what.en, "this is a workbook (a zip package), not a .var parameter file");
    assert!(told.remedy.en.contains("--workbook"), "{}", told.remedy.en);
}

#[test]
fn a_file_longer_than_any_of_linuxcnc_is_a_limit_and_not_a_fault_of_its_lines() {
    let refusal = VarFile::parse(&vec![b'x'; VAR_FILE_BYTES + 1]).unwrap_err();
    assert_eq!((refusal.exit, refusal.findings.len()), (Exit::Limit, 1));
    let full: String = (1..=LAST).map(|number| format!("{number}\t-123456.123456\n")).collect();
    assert_eq!(read(&full).text(), full);
}

#[test]
fn harmless_forms_are_taken() {
    let file = read("\n  5161 \t 1\r\n+5162\t.5\n5163 -5.\n05164 +1.5e1  \n\n5601 0");
    let values: Vec<_> = file.iter().collect();
    assert_eq!(values, [(5161, 1.0), (5162, 0.5), (5163, -5.0), (5164, 15.0), (5601, 0.0)]);
    assert!(read("").is_empty());
}

#[test]
fn what_is_not_set_keeps_every_digit_and_foreign_parameters_stay() {
    let mut file = read("31\t1.23456789\n5221\t0.1234567891\n5222\t-0.0000004\n5599\t1\n");
    file.set(5221, 0.123_456_789_1).unwrap();
    file.set(5222, -0.000_000_3).unwrap();
    file.set(5223, 1.0 / 3.0).unwrap();
    assert_eq!(file.text(), "31\t1.23456789\n5221\t0.1234567891\n5222\t0.000000\n5223\t0.333333\n5599\t1\n");
    assert_eq!(file.get(5223), Some(0.333_333));
    assert_eq!(read(&file.text()), file);
    for (number, value) in [(0, 1.0), (5602, 1.0), (5221, f64::NAN), (5221, f64::INFINITY), (5221, 1e100)] {
        assert!(file.set(number, value).is_err());
    }
}

#[test]
fn an_active_system_that_is_none_means_the_first_and_is_said() {
    for value in ["", "5220\t0\n", "5220\t10\n", "5220\t-1\n", "5220\t3.5\n", "5220\t2.99995\n"] {
        let (offsets, findings) = Offsets::read(&read(value), LengthUnit::Millimetre);
        assert_eq!(offsets.active, System::G54);
        assert_eq!(findings.iter().map(|finding| finding.grade).collect::<Vec<_>>(), [Grade::Caution], "{value:?}");
    }
    for system in System::ALL {
        let (offsets, findings) =
            Offsets::read(&read(&format!("5220 {}.000000", system.number())), LengthUnit::Millimetre);
        assert_eq!((offsets.active, findings.len()), (system, 0));
    }
}

#[test]
fn systems_are_numbered_as_in_the_manual() {
    let table: Vec<_> = System::ALL.map(|system| (system.name(), system.number(), system.first_parameter())).into();
    assert_eq!(table[0], ("G54", 1, 5221));
    assert_eq!(table[1], ("G55", 2, 5241));
    assert_eq!(table[8], ("G59.3", 9, 5381));
    assert_eq!(System::G59_3.rotation_parameter(), 5390);
    for system in System::ALL {
        assert_eq!(System::from_number(system.number()), Some(system));
        assert_eq!(System::from_name(&system.name().to_lowercase()), Some(system));
    }
    assert_eq!((System::from_number(0), System::from_number(10), System::from_name("G59.4")), (None, None, None));
}

#[test]
fn lengths_are_in_the_machines_unit_and_angles_in_degrees() {
    let file = read("5220\t2\n5241\t2.000000\n5242\t1.000000\n5243\t-2.000000\n5244\t90.000000\n5250\t30.000000\n");
    for (unit, factor) in [(LengthUnit::Inch, 25.4), (LengthUnit::Millimetre, 1.0)] {
        let (offsets, _) = Offsets::read(&file, unit);
        let work = offsets.system(System::G55);
        assert_eq!(work.origin.0[..4], [2.0 * factor, factor, -2.0 * factor, 90.0]);
        assert_eq!(work.rotation, 30.0);
        assert_eq!(offsets.frame(Pose::default()).work, *work);
    }
}

#[test]
fn writing_touches_only_what_has_changed() {
    let text = "5161\t0.12345678\n5210\t2.0\n5220\t3\n5221\t0.3333333333\n5500\t7.5\n";
    let mut file = read(text);
    let (mut offsets, _) = Offsets::read(&file, LengthUnit::Inch);
    offsets.write(&mut file, LengthUnit::Inch).unwrap();
    assert_eq!(file.text(), text, "nothing was changed");
    offsets.systems[System::G55 as usize].origin.set(Axis::Y, 25.4);
    offsets.g92_on = false;
    offsets.write(&mut file, LengthUnit::Inch).unwrap();
    assert_eq!(
        file.text(),
        "5161\t0.12345678\n5210\t0.000000\n5220\t3\n5221\t0.3333333333\n5242\t1.000000\n5500\t7.5\n"
    );
    offsets.g28.set(Axis::Z, f64::NAN);
    offsets.systems[System::G55 as usize].origin.set(Axis::Y, 50.8);
    let before = file.clone();
    assert!(offsets.write(&mut file, LengthUnit::Inch).is_err());
    assert_eq!(file, before, "all or nothing");
}

#[test]
fn a_rotation_turns_the_program_and_its_g92_but_not_the_origin() {
    let mut frame = ActiveOffsets::default();
    frame.work.origin = Pose([100.0, 50.0, 10.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    frame.work.rotation = 90.0;
    frame.g92.set(Axis::X, 5.0);
    frame.tool.set(Axis::Z, 7.0);
    // (10 + 5, 2) turned by 90° is (−2, 15).
    let machine = frame.to_machine(&Pose([10.0, 2.0, 3.0, 0.0, 0.0, 0.0, 20.0, 30.0, 0.0]));
    let expected = [98.0, 65.0, 20.0, 1.0, 2.0, 3.0, 24.0, 35.0, 6.0];
    for (got, expected) in machine.0.iter().zip(expected) {
        assert!((got - expected).abs() < 1e-12, "{machine:?}");
    }
}

prop_compose! {
    fn pose(most: f64)(values in prop::array::uniform9(-most..most)) -> Pose {
        Pose(values)
    }
}

prop_compose! {
    fn offsets()(
        origins in prop::array::uniform9(pose(2000.0)),
        rotations in prop::array::uniform9(-360.0..360.0_f64),
        active in 0_usize..9,
        g92 in pose(500.0),
        g92_on in any::<bool>(),
        g28 in pose(500.0),
        g30 in pose(500.0),
    ) -> Offsets {
        let systems = std::array::from_fn(|at| WorkOffset { origin: origins[at], rotation: rotations[at] });
        Offsets { systems, active: System::ALL[active], g92, g92_on, g28, g30 }
    }
}

proptest! {
    #[test]
    fn both_directions_agree(offsets in offsets(), tool in pose(300.0), program in pose(5000.0)) {
        let frame = offsets.frame(tool);
        let back = frame.to_program(&frame.to_machine(&program));
        for difference in back.differences(&program) {
            prop_assert!(difference.abs() < 1e-8, "{program:?} came back as {back:?}");
        }
    }

    #[test]
    fn offsets_survive_a_file_within_its_six_decimals(offsets in offsets(), inch in any::<bool>()) {
        let unit = if inch { LengthUnit::Inch } else { LengthUnit::Millimetre };
        let mut file = VarFile::default();
        offsets.write(&mut file, unit).unwrap();
        file.complete();
        let (back, findings) = Offsets::read(&read(&file.text()), unit);
        prop_assert!(findings.is_empty());
        prop_assert_eq!((back.active, back.g92_on), (offsets.active, offsets.g92_on));
        let near = |one: &Pose, other: &Pose| one.differences(other).iter().all(|miss| miss.abs() < 25.4 * 0.51e-6);
        prop_assert!(near(&back.g92, &offsets.g92) && near(&back.g28, &offsets.g28) && near(&back.g30, &offsets.g30));
        for (back, work) in back.systems.iter().zip(&offsets.systems) {
            prop_assert!(near(&back.origin, &work.origin) && (back.rotation - work.rotation).abs() < 0.51e-6);
        }
    }

    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Ok(file) = VarFile::parse(&bytes) {
            prop_assert_eq!(VarFile::parse(file.text().as_bytes()).unwrap(), file);
        }
    }

    #[test]
    fn no_lines_of_numbers_panic(text in "([0-9]{1,5}[ \t]?[-+.0-9e]{1,6}\r?\n){0,6}") {
        if let Ok(file) = VarFile::parse(text.as_bytes()) {
            prop_assert_eq!(VarFile::parse(file.text().as_bytes()).unwrap(), file);
        }
    }
}

#[test]
fn linuxcnc_writes_the_same_file() {
    if !rs274::is_here() {
        return;
    }
    let (_, fresh) = rs274("M2\n", None).unwrap();
    let mut file = VarFile::default();
    file.complete();
    assert_eq!(file.text(), fresh, "an empty file, completed");
    assert_eq!(read(&fresh).text(), fresh);
    assert_eq!(required().count(), fresh.lines().count());
    let (_, kept) = rs274("#31=1.5\n#5599=2\nG10 L2 P3 X12.7 R30\nM2\n", Some("31\t0\n5599 0\n")).unwrap();
    assert_eq!(read(&kept).text(), kept);
    assert_eq!(read(&kept).get(5261), Some(0.5));
}

#[test]
fn linuxcnc_refuses_the_files_that_are_refused_for_its_sake() {
    if !rs274::is_here() {
        return;
    }
    for (text, message) in [
        ("5220\t1\n5161\t0\n", "Parameter file out of order"),
        ("5220\t1\n5220\t2\n", "Parameter file out of order"),
        ("0\t1\n", "Parameter number out of range"),
        ("5602\t1\n", "Parameter number out of range"),
    ] {
        assert!(VarFile::parse(text.as_bytes()).is_err());
        assert!(rs274("M2\n", Some(text)).unwrap_err().contains(message), "{text:?}");
    }
}

#[test]
fn linuxcnc_reads_our_offsets_as_they_were_meant() {
    if !rs274::is_here() {
        return;
    }
    let mut offsets = Offsets { active: System::G55, g92_on: true, ..Offsets::default() };
    for (at, system) in System::ALL.into_iter().enumerate() {
        let at = f64::from(u32::try_from(at).unwrap());
        let work = &mut offsets.systems[system as usize];
        work.origin = Pose([10.0 + at, -20.0 * at, 0.125, 5.0 * at, -3.0, at, 0.0, 0.0, 0.0]);
        work.rotation = 15.0 * at;
    }
    offsets.g92 = Pose([1.5, -2.5, 3.5, 4.0, 5.0, 6.0, 0.0, 0.0, 0.0]);
    let mut file = VarFile::default();
    offsets.write(&mut file, LengthUnit::Inch).unwrap();
    file.complete();
    for system in System::ALL {
        let program = format!("G21 G90 {} G0 X7 Y11 Z13\nM2\n", system.name());
        let (canon, _) = rs274(&program, Some(&file.text())).unwrap();
        // First the system that the file makes active, then the one that the program selects.
        let origins = calls(&canon, "SET_G5X_OFFSET");
        assert_eq!(origins[0][0], 2.0);
        let selected = if system == System::G55 { &origins[0] } else { &origins[1] };
        assert_eq!(selected[0], f64::from(system.number()));
        let work = offsets.system(system);
        let near = |got: &[f64], expected: &[f64]| got.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4);
        assert!(near(&selected[1..], &work.origin.0), "{selected:?}");
        assert!(near(&calls(&canon, "SET_G92_OFFSET")[0], &offsets.g92.0));
        let rotations = calls(&canon, "SET_XY_ROTATION");
        let rotation = if system == System::G55 { rotations[0][0] } else { rotations[1][0] };
        assert!((rotation - work.rotation).abs() < 1e-4);
    }
}

/// The machine position is not in the canonical calls; G28.1 stores it in the var file.
#[test]
fn linuxcnc_agrees_on_the_machine_position() {
    if !rs274::is_here() {
        return;
    }
    let mut offsets = Offsets { active: System::G56, g92_on: true, ..Offsets::default() };
    offsets.systems[System::G56 as usize].origin = Pose([100.0, -50.0, 25.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    offsets.systems[System::G56 as usize].rotation = 30.0;
    offsets.g92 = Pose([3.0, 4.0, 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let mut file = VarFile::default();
    offsets.write(&mut file, LengthUnit::Inch).unwrap();
    file.complete();
    let (_, left) = rs274("G21 G90 G0 X7 Y11 Z13\nG28.1\nM2\n", Some(&file.text())).unwrap();
    let (after, _) = Offsets::read(&read(&left), LengthUnit::Inch);
    let machine = offsets.frame(Pose::default()).to_machine(&Pose([7.0, 11.0, 13.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
    for difference in after.g28.differences(&machine) {
        assert!(difference.abs() < 2e-5, "{:?} against {machine:?}", after.g28);
    }
}

#[test]
fn an_edit_sets_what_it_names_and_nothing_else() {
    for (text, changed) in [
        ("G55 X2 Y1 Z-2", "5241\t2.000000\n5242\t1.000000\n5243\t-2.000000\n"),
        ("g59.3x+1.5w.25r-30", "5381\t1.500000\n5389\t0.250000\n5390\t-30.000000\n"),
        (" G54  A90. B-0 C0.123456 ", "5224\t90.000000\n5225\t0.000000\n5226\t0.123456\n"),
        ("G92.2", "5210\t0.000000\n"),
        ("G92.3", "5210\t1.000000\n"),
        ("G54 X99999.999 R360", "5221\t99999.999000\n5230\t360.000000\n"),
    ] {
        let mut file = VarFile::default();
        Edit::parse(text, LengthUnit::Millimetre).expect(text).apply(&mut file).unwrap();
        assert_eq!(file.text(), changed, "{text}");
    }
    let mut file = read("5210\t2.5\n5211\t1\n5212\t2\n5241\t0.12345678\n5242\t3\n");
    Edit::parse("G52 Y5", LengthUnit::Millimetre).unwrap().apply(&mut file).unwrap();
    Edit::parse("G55 Y4", LengthUnit::Millimetre).unwrap().apply(&mut file).unwrap();
    assert_eq!(file.text(), "5210\t2.5\n5211\t1\n5212\t5.000000\n5241\t0.12345678\n5242\t4.000000\n");
}

#[test]
fn every_bad_edit_is_refused_with_its_reason_and_a_hint() {
    let codes = "write G54 to G59.3 with X Y Z A B C U V W R, like 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone";
    for (text, what, hint) in [
        ("", "the code is missing", codes),
        ("X2 Y1", "the code is missing", codes),
        ("G55", "there is no axis to set", codes),
        ("G52", "there is no axis to set", codes),
        ("G53 X1", "G53 cannot be set", codes),
        ("G59.4 X1", "G59.4 cannot be set", codes),
        ("G055 X1", "G055 cannot be set", codes),
        ("G92.1 X1", "G92.1 takes no axis words", codes),
        (
            "G92 X1",
            "G92 depends on the machine's position, which the file does not contain",
            "write G52 with the offsets, which use the same registers, or G92.1 to clear them",
        ),
        ("G55 X1,5", "'1,5' is not a number", "write the decimal of X with a point, not a comma"),
        ("G55 X1e3", "exponents are not allowed", "write the number in full, like 1000"),
        ("G55 X--5", "'--5' is not a number", "write the number next to the letter, like X-12.5"),
        ("G55 X1.2.3", "'1.2.3' is not a number", "write the number next to the letter, like X-12.5"),
        ("G55 X.", "'.' is not a number", "write the number next to the letter, like X-12.5"),
        ("G55 X\u{2212}5", "'\u{2212}5' is not a number", "write the number next to the letter, like X-12.5"),
        ("G55 X", "X has no number", "write the number next to the letter, like X-12.5"),
        ("G55 X 5", "'5' does not begin with a letter", "write each word without spaces, like X2.5"),
        ("G55 X1 x2", "X appears twice", "keep one of the two"),
        ("G55 Q1", "Q is not an axis", "use the axes X Y Z A B C U V W, or R for the rotation"),
        ("G52 R1", "G52 has no rotation", "give R with a work offset, like 'G55 R30'"),
        ("G55 X100000", "X100000 is beyond \u{b1}99999.999", "check the number and the unit"),
        ("G55 R361", "R361 is beyond \u{b1}360", "check the number and the unit"),
        ("G55 X0.1234567", "X0.1234567 has more decimals than the file's 6", "round the number"),
        ("G55 X1\u{1b}[2J", "'1\\u{1b}[2' is not a number", "write the number next to the letter, like X-12.5"),
    ] {
        let finding = Edit::parse(text, LengthUnit::Millimetre).expect_err(text);
        assert!(finding.what.en.ends_with(&format!(": {what}")), "{text:?}: {}", finding.what.en);
        assert_eq!(finding.remedy.en, hint, "{text:?}");
        assert!(!finding.what.es.is_empty() && !finding.remedy.es.is_empty());
    }
    assert!(Edit::parse("G55 X3937", LengthUnit::Inch).is_ok() && Edit::parse("G55 X3938", LengthUnit::Inch).is_err());
}

#[test]
fn edits_of_g92_do_what_linuxcnc_does() {
    if !rs274::is_here() {
        return;
    }
    let registers = |file: &VarFile| -> Vec<f64> { (5210..5220).map(|number| file.get(number).unwrap()).collect() };
    for switch in [0, 1] {
        let mut before = read(&format!("5210\t{switch}\n5211\t1\n5212\t2\n5216\t30\n"));
        before.complete();
        for edit in ["G52 X3 C45", "G52 Y0", "G92.1", "G92.2", "G92.3"] {
            let mut ours = before.clone();
            Edit::parse(edit, LengthUnit::Inch).unwrap().apply(&mut ours).unwrap();
            let (_, theirs) = rs274(&format!("G20 {edit}\nM2\n"), Some(&before.text())).unwrap();
            assert_eq!(registers(&ours), registers(&read(&theirs)), "{edit} with the switch at {switch}");
        }
    }
}

#[test]
fn the_blocks_give_linuxcnc_the_offsets_of_the_file() {
    if !rs274::is_here() {
        return;
    }
    let mut offsets = Offsets { active: System::G58, ..Offsets::default() };
    for (system, at) in System::ALL.into_iter().zip(1_u8..) {
        let at = f64::from(at);
        offsets.systems[system as usize].origin = Pose([at / 7.0, -30.0 * at, 0.0, 5.5 * at, 0.0, -at, 0.0, 0.0, 0.0]);
        offsets.systems[system as usize].rotation = 11.25 * at;
    }
    // What another program left on the control must be gone afterwards. B is in no block, since no system uses it.
    let stale: String =
        (5211..=5216).chain(5221..=5224).chain([5226]).map(|number| format!("{number}\t77\n")).collect();
    let stale = format!("5210\t1\n{stale}");
    for unit in [LengthUnit::Inch, LengthUnit::Millimetre] {
        for (g92, g92_on) in [([0.0; 9], false), ([1.5, 0.0, -2.0, 30.0, 0.0, 0.0, 0.0, 0.0, 0.0], true)] {
            offsets.g92 = Pose(g92);
            for g92_on in [g92_on, false] {
                offsets.g92_on = g92_on;
                let mut file = VarFile::default();
                offsets.write(&mut file, unit).unwrap();
                let blocks = preamble(&file, unit).unwrap();
                // Behind it there is G92 alone.
                let before = blocks.iter().rfind(|block| !block.starts_with("G52") && *block != "G92.2");
                assert_eq!(before.map(String::as_str), Some("G58"));
                let (canon, left) = rs274(&format!("{}\nM2\n", blocks.join("\n")), Some(&stale)).unwrap();
                let (theirs, _) = Offsets::read(&read(&left), LengthUnit::Inch);
                let near =
                    |one: &Pose, other: &Pose| one.differences(other).iter().all(|difference| difference.abs() < 2e-5);
                for (ours, theirs) in offsets.systems.iter().zip(&theirs.systems) {
                    assert!(near(&ours.origin, &theirs.origin), "{ours:?} against {theirs:?}");
                    assert!((ours.rotation - theirs.rotation).abs() < 1e-6);
                }
                assert!(near(&offsets.g92, &theirs.g92), "{:?} against {:?}", offsets.g92, theirs.g92);
                assert_eq!(offsets.g92_on, theirs.g92_on);
                // M2 goes back to G54; the system before that is the file's.
                let selected: Vec<_> = calls(&canon, "SET_G5X_OFFSET").iter().map(|call| call[0]).collect();
                assert_eq!(selected[selected.len() - 2..], [5.0, 1.0]);
            }
        }
    }
}

#[test]
fn no_blocks_are_made_of_values_that_no_program_carries() {
    let file = read("5220\t1\n5222\t100000\n5230\t1e50\n5242\t99999.999\n");
    assert_eq!(preamble(&file, LengthUnit::Millimetre), Err(vec![5222, 5230]));
    assert_eq!(preamble(&file, LengthUnit::Inch), Err(vec![5222, 5242, 5230]));
}

#[test]
fn blocks_carry_at_least_three_decimals_and_all_that_the_file_has() {
    let file = read("5220\t2\n5221\t-0.0000001\n5222\t0.1\n5223\t2.123456\n5227\t-5\n5241\t1234.5678\n");
    let blocks = preamble(&file, LengthUnit::Millimetre).unwrap();
    assert_eq!(
        blocks[..4],
        [
            "G21 G90",
            "G92.1",
            "G10 L2 P1 X0.000 Y0.100 Z2.123456 U-5.000 R0.000",
            "G10 L2 P2 X1234.5678 Y0.000 Z0.000 U0.000 R0.000",
        ]
    );
    assert_eq!((blocks.len(), blocks[11].as_str()), (12, "G55"));
    assert_eq!(preamble(&file, LengthUnit::Inch).unwrap()[0], "G20 G90");
}
