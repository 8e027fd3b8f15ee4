//! Good and bad programs of every control, a folder each.

use std::fs;
use std::path::{Path, PathBuf};

use rodete::gcode::control::{ALL, Control};
use rodete::gcode::interpreter::{DecimalPoint, Interpreter, Setting};

fn programs(control: &Control, folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/controls/programs").join(control.name).join(folder);
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut found: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    found.retain(|path| path.extension().is_some_and(|ending| ending == "nc"));
    found.sort();
    assert!(!found.is_empty(), "{} holds no program", folder.display());
    found
}

/// How many motions a program has, and its refusals: line and text.
fn read(control: &'static Control, path: &Path) -> (usize, String) {
    let setting = Setting { point: Some(DecimalPoint::Calculator), ..Setting::new(control) };
    let (mut motions, mut refusals) = (0, String::new());
    let text = fs::read(path).unwrap();
    for motion in Interpreter::over(&text, setting) {
        match motion {
            Ok(_) => motions += 1,
            Err(fault) => refusals.push_str(&format!("{}: {}\n", fault.line, fault.what.en)),
        }
    }
    (motions, refusals)
}

#[test]
fn good_programs_of_every_control_are_read() {
    for control in ALL {
        for path in programs(control, "good") {
            let (motions, refusals) = read(control, &path);
            assert!(motions > 0 && refusals.is_empty(), "{}: {motions} motions\n{refusals}", path.display());
        }
    }
}

#[test]
fn bad_programs_of_every_control_are_refused_with_the_text_beside_them() {
    for control in ALL {
        for path in programs(control, "bad") {
            let wanted = fs::read_to_string(path.with_extension("txt")).unwrap_or_default();
            let (_, refusals) = read(control, &path);
            assert!(!refusals.is_empty(), "{}", path.display());
            assert_eq!(refusals, wanted, "{}", path.display());
        }
    }
}
