//! Work offsets and LinuxCNC's parameter file, held against LinuxCNC's own interpreter where it is installed.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use proptest::prelude::*;
use rodete::finding::{Exit, Grade, Place, Refusal};
use rodete::machine::axis::{Axis, Pose};
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::{FILE, LAST, VarFile, required};
use rodete::machine::work_offset::{Frame, Offsets, System, WorkOffset};
use rodete::text::Language;

/// True where rs274 is installed. Where it is not, says so loudly; in CI that is a failure.
fn rs274_is_here() -> bool {
    let here = Command::new("rs274").arg("-h").stdin(Stdio::null()).output().is_ok();
    if !here {
        let _ = writeln!(
            std::io::stderr(),
            "\n*** rs274 is not installed: offsets are NOT JUDGED by LinuxCNC. Install linuxcnc-uspace. ***\n"
        );
        assert!(std::env::var_os("CI").is_none(), "rs274 is missing in CI");
    }
    here
}

/// Runs a program with a var file: the canonical calls, and the var file that is left behind.
fn rs274(program: &str, var: Option<&str>) -> Result<(String, String), String> {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("p.ngc"), program).unwrap();
    std::fs::write(path("t.tbl"), "").unwrap();
    if let Some(text) = var {
        std::fs::write(path("v.var"), text).unwrap();
    }
    let option = |name: &str, file: &str| [name.into(), path(file).into_os_string()];
    let mut child = Command::new("rs274")
        .arg("-g")
        .args(option("-t", "t.tbl"))
        .args(option("-v", "v.var"))
        .arg(path("p.ngc"))
        .arg(path("out"))
        .env("HOME", folder.path())
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if start.elapsed() > Duration::from_secs(30) {
            child.kill().unwrap();
            return Err("deadline".to_owned());
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    if !status.success() {
        return Err(String::from_utf8_lossy(&child.wait_with_output().unwrap().stderr).into_owned());
    }
    let text = |name: &str| std::fs::read_to_string(Path::new(&path(name))).unwrap();
    Ok((text("out"), text("v.var")))
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
        ("garbage\n", 1, vec![1], "'garbage' is not the number of a parameter"),
        ("5220\t1\n; note\n", 2, vec![1], "';' is not the number of a parameter"),
        ("\u{feff}5161\t0\n", 1, vec![1], "'\\u{feff}5161' is not the number of a parameter"),
        ("5221.5 3\n", 1, vec![1], "'5221.5' is not the number of a parameter"),
        ("+\t3\n", 1, vec![1], "'+' is not the number of a parameter"),
        ("0\t1\n", 1, vec![1], "there is no parameter of this number"),
        ("-3\t1\n", 1, vec![1], "there is no parameter of this number"),
        ("5602\t1\n", 1, vec![1], "there is no parameter of this number"),
        ("52210000000\t1\n", 1, vec![1], "there is no parameter of this number"),
        ("5221\n", 1, vec![1], "parameter 5221 has no value"),
        ("5221\t1.5 2\n", 1, vec![10], "there is text after the value: '2'"),
        ("  5221\t1,5\n", 1, vec![8], "'1,5' is not a number"),
        ("5221\t0x10\n", 1, vec![6], "'0x10' is not a number"),
        ("5221\t1_0\n", 1, vec![6], "'1_0' is not a number"),
        ("5221\t--5\n", 1, vec![6], "'--5' is not a number"),
        ("5221\t\u{2212}5\n", 1, vec![6], "'\u{2212}5' is not a number"),
        ("5221\t12.5\0\n", 1, vec![6], "'12.5\\u{0}' is not a number"),
        ("5221\t1.0\r5222\t2.0\n", 1, vec![15], "there is text after the value: '2.0'"),
        ("5221\tnan\n", 1, vec![6], "the value is too great or not finite"),
        ("5221\t-inf\n", 1, vec![6], "the value is too great or not finite"),
        ("5221\t1e400\n", 1, vec![6], "the value is too great or not finite"),
        ("5221\t1e200\n", 1, vec![6], "the value is too great or not finite"),
        ("5220\t1\n\n5161\t0\n", 3, vec![], "parameter 5161 stands after 5220 of line 1"),
        ("5220\t1\n5220\t2\n", 2, vec![], "parameter 5220 is given twice, first in line 1"),
        ("5161\t1\n5220\t1\n5161\t2\n", 3, vec![], "parameter 5161 is given twice, first in line 1"),
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
fn a_file_longer_than_any_of_linuxcnc_is_a_limit_and_not_a_fault_of_its_lines() {
    let refusal = VarFile::parse(&vec![b'x'; FILE + 1]).unwrap_err();
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
    offsets.system_mut(System::G55).origin.set(Axis::Y, 25.4);
    offsets.g92_on = false;
    offsets.write(&mut file, LengthUnit::Inch).unwrap();
    assert_eq!(
        file.text(),
        "5161\t0.12345678\n5210\t0.000000\n5220\t3\n5221\t0.3333333333\n5242\t1.000000\n5500\t7.5\n"
    );
    offsets.g28.set(Axis::Z, f64::NAN);
    offsets.system_mut(System::G55).origin.set(Axis::Y, 50.8);
    let before = file.clone();
    assert!(offsets.write(&mut file, LengthUnit::Inch).is_err());
    assert_eq!(file, before, "all or nothing");
}

#[test]
fn a_rotation_turns_the_program_and_its_g92_but_not_the_origin() {
    let mut frame = Frame::default();
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
    if !rs274_is_here() {
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
    if !rs274_is_here() {
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
    if !rs274_is_here() {
        return;
    }
    let mut offsets = Offsets { active: System::G55, g92_on: true, ..Offsets::default() };
    for (at, system) in System::ALL.into_iter().enumerate() {
        let at = f64::from(u32::try_from(at).unwrap());
        let work = offsets.system_mut(system);
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
    if !rs274_is_here() {
        return;
    }
    let mut offsets = Offsets { active: System::G56, g92_on: true, ..Offsets::default() };
    offsets.system_mut(System::G56).origin = Pose([100.0, -50.0, 25.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    offsets.system_mut(System::G56).rotation = 30.0;
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
