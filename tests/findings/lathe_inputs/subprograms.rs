//! Subprograms on sheets of their own and in files beside the program.

use std::fs;

use serde_json::Value as Json;

use super::bench::{Book, bilingual, build, lines, program, run};

const CALL: &str = "M98 P0005";
const GOOD: [&str; 5] = ["G0 X46. Z2.", "G1 Z-20. F0.2", "U6.", "G0 Z2.", "M99"];
const RAPID: [&str; 3] = ["G0 X40. Z-10.", "G0 X54. Z2.", "M99"];

/// The document and the exit code of a simulation with files beside the program.
fn beside(blocks: &str, files: &[(&str, &[&str])]) -> (Json, i32) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), program(blocks).join("\n")).unwrap();
    for (name, lines) in files {
        fs::write(folder.path().join(name), lines.join("\n")).unwrap();
    }
    let arguments = ["simulate", "p.nc", "--dialect", "fanuc-lathe-a", "--stock", "D50xL120", "--json"];
    let said = run(folder.path(), &[&arguments[..], &["--decimal-point", "calculator"]].concat());
    (serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{}", said.err)), said.exit)
}

fn has(document: &Json, wanted: &str) {
    let found = lines(document);
    assert!(found.iter().any(|line| line.starts_with(wanted)), "{wanted}: {found:#?}");
    bilingual(document);
}

#[test]
fn a_sheet_and_a_file_make_the_same_part() {
    let (_folder, sheet, exit) = build(&Book::new(&program(CALL)).subprogram("O0005", &GOOD).bytes());
    assert_eq!(exit, 0, "{:?}", lines(&sheet));
    let (file, exit) = beside(CALL, &[("O0005.nc", &GOOD)]);
    assert_eq!(exit, 0);
    let removed = super::bench::quantity(&sheet, "V_r");
    assert_eq!(file["totals"]["removed_volume_mm3"].as_f64(), Some(removed));
    assert!(removed > 6000.0, "{removed}");
}

#[test]
fn an_alarm_in_a_subprogram_stands_in_the_subprogram() {
    let (_folder, sheet, exit) = build(&Book::new(&program(CALL)).subprogram("O0005", &RAPID).bytes());
    assert_eq!(exit, 3);
    has(&sheet, "stop O0005!A6 101 Rapid motion through metal");
    let (file, exit) = beside(CALL, &[("O0005.nc", &RAPID)]);
    assert_eq!(exit, 3);
    has(&file, "stop O0005 1 101 Rapid motion through metal");
}

#[test]
fn what_a_subprogram_says_wrong_stands_in_the_subprogram() {
    let wrong = ["G0 X52", "G1 X", "M99"];
    let (_folder, sheet, exit) = build(&Book::new(&program(CALL)).subprogram("O0005", &wrong).bytes());
    assert_eq!(exit, 3);
    has(&sheet, "stop O0005!A7 the number is missing");
    has(&sheet, "note O0005!A6 dimensions without decimal point, read as mm");
    let (file, exit) = beside(CALL, &[("O0005.nc", &wrong)]);
    assert_eq!(exit, 3);
    has(&file, "stop O0005 2:5 the number is missing");
    has(&file, "note O0005 1:4 dimensions without decimal point, read as mm");
}

#[test]
fn the_text_for_people_names_the_file_and_the_line() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), program(CALL).join("\n")).unwrap();
    fs::write(folder.path().join("O0005.nc"), RAPID.join("\n")).unwrap();
    let arguments = ["simulate", "p.nc", "--dialect", "fanuc-lathe-a", "--stock", "D50xL120"];
    for (language, place) in [("en", "--> p.nc, subprogram O0005:1"), ("es", "--> p.nc, subprograma O0005:1")] {
        let said = run(folder.path(), &[&arguments[..], &["--lang", language]].concat());
        assert_eq!(said.exit, 3);
        assert!(said.err.contains(place), "{}", said.err);
    }
}

#[test]
fn the_same_line_of_two_subprograms_is_two_places() {
    let deeper = ["G0 X30. Z-10.", "G0 X54. Z2.", "M99"];
    let book = Book::new(&program("M98 P0005|M98 P0006")).subprogram("O0005", &RAPID).subprogram("O0006", &deeper);
    let (_folder, document, _) = build(&book.bytes());
    has(&document, "stop O0005!A6 101 Rapid motion through metal");
    has(&document, "stop O0006!A6 101 Rapid motion through metal");
}

#[test]
fn a_subprogram_that_is_missing_or_there_twice_is_refused() {
    let (_folder, document, exit) = build(&Book::new(&program(CALL)).bytes());
    assert_eq!(exit, 3);
    has(&document, "stop PROGRAM!A11 PS0078: there is no subprogram O0005");
    let remedy = document["findings"][0]["remedy"]["en"].as_str().unwrap();
    assert!(remedy.contains("on a sheet O0005"), "{remedy}");
    let book = Book::new(&program(CALL)).subprogram("O0005", &GOOD).subprogram("O5", &RAPID);
    let (_folder, document, exit) = build(&book.bytes());
    assert_eq!(exit, 3);
    has(&document, "stop O5 there are two subprograms O0005: on the sheets \"O0005\" and \"O5\"");
    let (document, exit) = beside(CALL, &[("O0005.nc", &GOOD), ("5.nc", &RAPID)]);
    assert_eq!(exit, 3);
    has(&document, "stop 6:5 O0005 is defined twice: O0005, 5");
}

#[test]
fn a_program_is_delivered_with_the_subprograms_that_it_calls() {
    let unused = ["G0 X1.", "M99"];
    let book = Book::new(&program("M98 P0005|M98 P0006"))
        .subprogram("O0005", &GOOD)
        .subprogram("O6", &["O0006", "G0 W1.", "M99"])
        .subprogram("O0007", &unused);
    let (folder, document, exit) = build(&book.bytes());
    assert_eq!(exit, 0, "{:?}", lines(&document));
    let text = fs::read_to_string(folder.path().join("out/part-program.nc")).unwrap();
    let mut wanted = program("M98 P0005|M98 P0006");
    wanted.extend(["O0005"].iter().chain(&GOOD).chain(&["O0006", "G0 W1.", "M99"]).map(|line| (*line).to_owned()));
    assert_eq!(text.lines().collect::<Vec<_>>(), wanted);
    // It stands alone: read by itself it takes away the same.
    fs::write(folder.path().join("alone.nc"), &text).unwrap();
    let arguments = ["simulate", "alone.nc", "--dialect", "fanuc-lathe-a", "--tools", "part.xlsx", "--json"];
    let alone: Json = serde_json::from_str(&run(folder.path(), &arguments).out).unwrap();
    assert_eq!(alone["totals"]["removed_volume_mm3"].as_f64(), Some(super::bench::quantity(&document, "V_r")));
}

#[test]
fn recursion_ends_with_the_calls_that_led_to_it() {
    let (document, exit) = beside(CALL, &[("O0005.nc", &["M98 P0005", "M99"])]);
    assert_eq!(exit, 7);
    has(&document, "stop O0005 1 more than 4 nested calls: O5 → O5 → O5 → O5 → O5");
}
