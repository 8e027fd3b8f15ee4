//! Turning programs over their stock: what must pass clean passes clean, and each alarm is raised where it belongs.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use rodete::gcode::control::TURNING;
use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")
}

/// The programs of a folder, subprograms left out, in order.
fn programs(folder: &str) -> Vec<PathBuf> {
    let mut found: Vec<_> = fs::read_dir(root().join(folder))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "nc"))
        .filter(|path| !path.file_name().unwrap().to_string_lossy().starts_with('O'))
        .collect();
    found.sort();
    assert!(!found.is_empty(), "{folder}");
    found
}

/// What stands behind a word in a comment of the program's head.
fn head(program: &Path, word: &str) -> Option<String> {
    let text = fs::read_to_string(program).unwrap();
    text.lines().take(3).find_map(|line| {
        let comment = line.trim_start_matches(['(', ';']).trim_end_matches(')');
        comment.strip_prefix(word).map(|rest| rest.trim().to_owned())
    })
}

/// The document of a simulation and its exit code.
fn simulate(program: &Path, dialect: &str, more: &[&str]) -> (Value, i32) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
    command.arg("simulate").arg(program).args(["--dialect", dialect, "--decimal-point", "calculator", "--json"]);
    if let Some(stock) = head(program, "stock ") {
        command.args(["--stock", &stock]);
    }
    let output = command.args(more).output().unwrap();
    let document = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("{}: {}", program.display(), String::from_utf8_lossy(&output.stderr)));
    (document, output.status.code().unwrap())
}

/// Grade, line and text of every finding of some gravity.
fn grave(document: &Value, notes: bool) -> Vec<(String, u64, String)> {
    let findings = document["findings"].as_array().unwrap();
    findings
        .iter()
        .filter(|one| notes || one["grade"] != "note")
        .map(|one| {
            let line = one["place"]["line"]["line"].as_u64().unwrap_or(0);
            (one["grade"].as_str().unwrap().to_owned(), line, one["what"]["en"].as_str().unwrap().to_owned())
        })
        .collect()
}

#[test]
fn what_is_right_raises_no_alarm() {
    for dialect in TURNING.map(|control| control.name) {
        for program in programs(&format!("controls/{dialect}/clean")) {
            let given: &[&str] = if dialect == "fanuc-lathe-a" { &["--hole-r", "absolute"] } else { &[] };
            let (document, exit) = simulate(&program, dialect, given);
            assert_eq!((grave(&document, false), exit), (Vec::new(), 0), "{}", program.display());
            assert_eq!(document["totals"]["alarms"], 0, "{}", program.display());
            assert!(document["totals"]["removed_volume_mm3"].as_f64().unwrap() > 100.0, "{}", program.display());
            let apart = document["totals"]["other_library_apart_mm"].as_f64().unwrap();
            assert!((0.0..1e-9).contains(&apart), "{}: {apart}", program.display());
        }
    }
}

#[test]
fn each_alarm_is_raised_at_its_line_and_no_other_is() {
    for program in programs("lathe/alarms") {
        let fagor = program.file_name().unwrap().to_string_lossy().starts_with("fagor");
        let (document, exit) = simulate(&program, if fagor { "fagor-8055-t" } else { "fanuc-lathe-a" }, &[]);
        let numbered = |(grade, line, what): (String, u64, String)| {
            let number: u32 = what.split(' ').next()?.parse().ok()?;
            Some((grade, format!("{number}@{line}")))
        };
        assert!(document["totals"]["other_library_apart_mm"].as_f64().unwrap() < 1e-9, "{}", program.display());
        let raised: Vec<_> = grave(&document, true).into_iter().filter_map(numbered).collect();
        let mut names: Vec<_> = raised.iter().map(|(_, name)| name.clone()).collect();
        names.sort();
        let expected = head(&program, "alarms ").unwrap();
        assert_eq!(names.join(" "), expected, "{}: {raised:?}", program.display());
        let stopped = raised.iter().any(|(grade, _)| grade == "stop");
        assert_eq!(exit, if stopped { 3 } else { 0 }, "{}", program.display());
    }
}

#[test]
fn a_program_that_moves_nothing_is_a_stop_unless_a_block_of_it_is_rejected() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.nc");
    for (text, told) in
        [("O0001\nN5 G21 G40 G97 G99\nT0101\nS500 M3\nG4 X1.\nN10 M30\n", true), ("O0001\nG1 X4,5\nM30\n", false)]
    {
        fs::write(&path, text).unwrap();
        let (document, exit) = simulate(&path, "fanuc-lathe-a", &["--stock", "D30xL60"]);
        let found = document["findings"].as_array().unwrap().iter().any(|one| one["code"] == "L0229");
        assert_eq!((found, exit), (told, 3), "{text}: {}", document["findings"]);
    }
}

/// A new workbook of a case, in a folder of its own.
fn workbook(case: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("lathe.xlsx");
    let output =
        Command::new(env!("CARGO_BIN_EXE_rodete")).args(["new", "lathe", "--case", case]).arg(&path).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    (folder, path)
}

#[test]
fn the_example_workbooks_are_built_without_a_caution() {
    for case in ["shaft", "blank"] {
        let (folder, path) = workbook(case);
        let output = Command::new(env!("CARGO_BIN_EXE_rodete"))
            .arg("build")
            .arg(&path)
            .args(["--no-report", "--json"])
            .output()
            .unwrap();
        let document: Value = serde_json::from_slice(&output.stdout).unwrap();
        let one = &document["workbooks"][0];
        assert_eq!(grave(one, false), Vec::new(), "{case}");
        let mut names: Vec<_> =
            one["files"].as_array().unwrap().iter().map(|file| file["name"].as_str().unwrap().to_owned()).collect();
        names.sort();
        let expected = ["contour.dxf", "contour.svg", "part.stl", "program.nc", "results.xlsx", "viewer.html"];
        assert_eq!(names, expected.map(|name| format!("lathe-{name}")), "{case}");
        drop(folder);
    }
}

/// The published program of the blank over the stock, and with the tools, of a workbook.
fn published(workbook: &Path) -> (Value, i32) {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/lathe-g85-as-printed.nc");
    simulate(&golden, "fagor-8055-t", &["--tools", &workbook.to_string_lossy()])
}

#[test]
fn the_published_g85_gives_the_quarter_torus() {
    let (_folder, tools) = workbook("blank");
    let (document, exit) = published(&tools);
    for side in ["deviation_plus_mm", "deviation_minus_mm"] {
        let deviation = document["totals"][side].as_f64().unwrap();
        assert!((0.0..0.001).contains(&deviation), "{side} {deviation}");
    }
    // As printed it starts a right-hand tool with M4, gives G96 before its S, and has no limit of the speed.
    let stops: Vec<_> = grave(&document, false).into_iter().filter(|(grade, ..)| grade == "stop").collect();
    assert_eq!(exit, 3);
    assert_eq!(stops.len(), 1, "{stops:?}");
    assert!(stops[0].2.starts_with("154 "), "{stops:?}");
}
