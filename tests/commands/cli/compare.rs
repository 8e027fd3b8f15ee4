//! The command `compare`: what differs between two workbooks of one kind.

use std::fs::{self, File};

use predicates::prelude::*;
use rodete::kinds::KINDS;
use rodete::parameter::Value;
use rodete::text::{Language, Text};
use rodete::workbook::template;
use serde_json::{Value as Json, json};
use tempfile::TempDir;

use super::common::{names, rodete, with_impeller, workbook};

/// A folder with `impeller.xlsx` and `other.xlsx`, with some values changed.
fn two(changes: &[(&'static str, Value)]) -> TempDir {
    let folder = with_impeller();
    workbook(&folder.path().join("other.xlsx"), changes);
    folder
}

fn document(folder: &TempDir, one: &str, other: &str) -> Json {
    let output = rodete(folder).args(["compare", one, other, "--json"]).output().expect("it runs");
    assert_eq!(output.status.code(), Some(0));
    serde_json::from_slice(&output.stdout).expect("a document")
}

#[test]
fn equal_inputs_make_equal_programs_whatever_the_files_are_called() {
    let folder = two(&[]);
    let read = document(&folder, "impeller.xlsx", "other.xlsx");
    assert_eq!((&read["same"], &read["inputs"]), (&json!(true), &json!([])));
    let programs = read["programs"].as_array().expect("programs");
    assert!(!programs.is_empty());
    for program in programs {
        assert_eq!((&program["same"], &program["first"]), (&json!(true), &Json::Null));
        assert!(program["motions"][0].as_u64() > Some(10) && program["motions"][0] == program["motions"][1]);
    }
    rodete(&folder)
        .args(["compare", "impeller.xlsx", "other.xlsx"])
        .assert()
        .code(0)
        .stdout(predicate::str::ends_with("no difference\n"));
}

#[test]
fn what_one_input_changes_is_shown_in_cells_values_findings_and_motions() {
    let folder = two(&[("N", Value::Whole(3))]);
    let read = document(&folder, "impeller.xlsx", "other.xlsx");
    assert_eq!(read["same"], json!(false));
    assert_eq!(read["inputs"].as_array().map(Vec::len), Some(1));
    assert_eq!((&read["inputs"][0]["symbol"], &read["inputs"][0]["values"]), (&json!("N"), &json!([4.0, 3.0])));
    assert_eq!(read["inputs"][0]["cells"], json!(["DATA!C11", "DATA!C11"]));
    let changed = |one: &&Json| one["values"][0] != one["values"][1];
    assert!(read["quantities"].as_array().expect("quantities").iter().any(|one| changed(&one)));
    let program = read["programs"].as_array().expect("programs").iter().find(|one| one["program"] == json!("impeller"));
    let program = program.expect("the whole impeller");
    assert_eq!(program["same"], json!(false));
    assert!(program["first"]["motion"].as_u64() >= Some(1), "{program}");
    assert_ne!(program["motions"][0], program["motions"][1]);
    rodete(&folder)
        .args(["compare", "impeller.xlsx", "other.xlsx", "--lang", "es"])
        .assert()
        .code(0)
        .stdout(predicate::str::contains("Entradas que difieren"))
        .stdout(predicate::str::contains("DATA!C11"))
        .stdout(predicate::str::ends_with("hay diferencias\n"));
}

#[test]
fn a_small_change_is_found_at_its_first_motion_with_its_greatest_distance() {
    let folder = two(&[("e", Value::Real(2.001))]);
    let read = document(&folder, "impeller.xlsx", "other.xlsx");
    let program = read["programs"].as_array().expect("programs").iter().find(|one| one["same"] == json!(false));
    let program = program.expect("a program that differs");
    assert_eq!(program["motions"][0], program["motions"][1]);
    let apart = program["apart"][0]["by"].as_f64().expect("a distance");
    assert!((0.0005..0.1).contains(&apart), "{program}");
}

/// A workbook of the lathe's shaft in a language, with a block in place of another.
fn shaft(folder: &TempDir, name: &str, language: Language, [from, to]: [&str; 2]) {
    let kind = KINDS.iter().find(|kind| kind.form().kind == "lathe").expect("the lathe");
    let case = &kind.cases()[0];
    let mut lists = (case.listed)(language);
    let blocks = lists.iter_mut().flat_map(|rows| &mut rows.rows).flat_map(|row| row.values.values_mut());
    let block = Value::Line(from.to_owned());
    let mut found: Vec<_> = blocks.filter(|value| **value == block).collect();
    **found.first_mut().expect("the block") = Value::Line(to.to_owned());
    let file = File::create(folder.path().join(name)).expect("a workbook to write");
    template::write(*kind, &case.values(language), &lists, &Text::same(""), language, file).expect("a workbook");
}

/// They had been the same, whatever their blocks said: cycles look for their contours in a text that was read once.
#[test]
fn turning_programs_are_compared_by_their_motions_and_x_is_a_diameter() {
    let folder = super::common::folder();
    let last = "N230 G0 X100. M5";
    shaft(&folder, "one.xlsx", Language::En, [last, last]);
    shaft(&folder, "other.xlsx", Language::En, [last, "N230 G0 X104. Z53. M5"]);
    let read = document(&folder, "one.xlsx", "other.xlsx");
    let program = &read["programs"][0];
    assert_eq!((&program["same"], &program["end"][0]["X"]), (&json!(false), &json!(100.0)), "{program}");
    assert_eq!((&program["apart"][0]["axis"], &program["apart"][0]["by"]), (&json!("X"), &json!(4.0)), "{program}");
    assert_eq!(program["words"][1]["text"], json!("N230 G0 X104. Z53. M5"));
    rodete(&folder).args(["compare", "one.xlsx", "other.xlsx"]).assert().stdout(
        predicate::str::contains("end X (diameter)").and(predicate::str::contains("greatest apart, mm: X (diameter)")),
    );
}

#[test]
fn findings_are_matched_whatever_the_language_of_their_sheets() {
    let folder = super::common::folder();
    let facing = "N30 G1 X-1.6 F0.15";
    shaft(&folder, "one.xlsx", Language::Es, [facing, facing]);
    shaft(&folder, "other.xlsx", Language::En, [facing, facing]);
    let read = document(&folder, "one.xlsx", "other.xlsx");
    let codes = |side: &str| -> Vec<String> {
        let found = read[side]["findings"].as_array().expect("findings");
        found.iter().map(|one| one["code"].to_string()).collect()
    };
    assert!(!codes("both").is_empty() && codes("only_a").is_empty() && codes("only_b").is_empty(), "{read}");
}

#[test]
fn another_tool_speed_or_code_is_other_words_and_no_other_motion() {
    for (key, value, block) in [
        ("T", Value::Whole(7), "N30 T7 D1"),
        ("S", Value::Whole(7000), "S7000"),
        ("start_codes", Value::Line("M4 M11 M13".to_owned()), "M4"),
        ("end_codes", Value::Line("M2".to_owned()), "M2"),
    ] {
        let folder = two(&[(key, value)]);
        let read = document(&folder, "impeller.xlsx", "other.xlsx");
        // The blank is turned with a tool and a speed of its own.
        let programs = read["programs"].as_array().expect("programs").iter();
        for program in programs.filter(|program| program["program"] != json!("blank")) {
            assert_eq!(program["same"], json!(true), "{program}");
            assert!(program["words"][1]["text"].as_str().is_some_and(|text| text.contains(block)), "{program}");
        }
        rodete(&folder)
            .args(["compare", "impeller.xlsx", "other.xlsx"])
            .assert()
            .stdout(predicate::str::contains("the same motions, other words").and(predicate::str::contains(block)));
    }
    // The number of a block and the header are no words.
    let folder = two(&[("block_step", Value::Whole(5)), ("part", Value::Line("Another".to_owned()))]);
    let read = document(&folder, "impeller.xlsx", "other.xlsx");
    for program in read["programs"].as_array().expect("programs") {
        assert_eq!((&program["same"], &program["words"]), (&json!(true), &Json::Null), "{program}");
    }
}

#[test]
fn results_are_compared_as_the_inputs_that_they_are() {
    let folder = two(&[("N", Value::Whole(3))]);
    rodete(&folder).args(["build", "impeller.xlsx", "--no-report"]).assert().code(0);
    let results = "impeller-out/impeller-results.xlsx";
    let read = document(&folder, "impeller.xlsx", results);
    assert_eq!(read["same"], json!(true), "{read}");
    assert_eq!(document(&folder, results, "other.xlsx")["inputs"][0]["symbol"], json!("N"));
}

#[test]
fn a_rejected_workbook_is_compared_by_its_inputs_and_findings() {
    let folder = two(&[("N", Value::Whole(40))]);
    let read = document(&folder, "impeller.xlsx", "other.xlsx");
    assert_eq!(read["inputs"][0]["symbol"], json!("N"));
    assert!(read["only_b"]["findings"][0]["code"].as_str().is_some_and(|code| code.starts_with('P')), "{read}");
    assert_eq!(read["workbooks"][1]["exit"], json!(3));
}

#[test]
fn two_kinds_are_refused_and_what_cannot_be_read_says_why() {
    let folder = with_impeller();
    rodete(&folder).args(["new", "lathe"]).assert().code(0);
    rodete(&folder)
        .args(["compare", "impeller.xlsx", "lathe.xlsx"])
        .assert()
        .code(3)
        .stderr(predicate::str::contains("U0117: impeller.xlsx is a workbook of impeller, lathe.xlsx of lathe"));
    let output = rodete(&folder).args(["compare", "impeller.xlsx", "lathe.xlsx", "--json"]).output().expect("it runs");
    let read: Json = serde_json::from_slice(&output.stdout).expect("a document");
    assert_eq!((&read["exit"], &read["programs"]), (&json!(3), &Json::Null));
    assert_eq!((&read["findings"][0]["code"], &read["files"]), (&json!("U0117"), &json!([])));
    rodete(&folder).args(["compare", "impeller.xlsx", "no.xlsx"]).assert().code(4);
    fs::write(folder.path().join("bad.xlsx"), "x").expect("a file");
    rodete(&folder).args(["compare", "bad.xlsx", "impeller.xlsx", "--json"]).assert().code(4);
}

#[test]
fn the_comparison_is_written_as_a_workbook_with_the_same_bytes_each_time() {
    let folder = two(&[("N", Value::Whole(3))]);
    let write = |name: &str| {
        rodete(&folder).args(["compare", "impeller.xlsx", "other.xlsx", "-o", name]).assert().code(0);
        fs::read(folder.path().join(name)).expect("a workbook")
    };
    assert_eq!(write("a.xlsx"), write("b.xlsx"));
    let mut book = calamine::open_workbook_auto(folder.path().join("a.xlsx")).expect("a workbook");
    let sheets = calamine::Reader::sheet_names(&book);
    assert_eq!(sheets, ["Inputs", "Derived", "Findings", "Programs"]);
    let inputs = calamine::Reader::worksheet_range(&mut book, "Inputs").expect("a sheet");
    let row: Vec<String> = inputs.rows().nth(4).expect("a row").iter().map(ToString::to_string).collect();
    assert_eq!(row[..5], ["N", "4", "3", "", "DATA!C11"].map(str::to_owned));
    // An input is not replaced, nor is another name than a workbook's taken; nothing is compared.
    for name in ["other.xlsx", "a.txt"] {
        for form in [&[][..], &["--json"]] {
            let line = ["compare", "impeller.xlsx", "other.xlsx", "-o", name];
            rodete(&folder).args(line).args(form).assert().code(2).stdout("");
        }
    }
    assert_eq!(names(folder.path()), ["a.xlsx", "b.xlsx", "impeller.xlsx", "other.xlsx"]);
}

#[test]
fn the_document_has_the_file_that_was_written_or_why_it_was_not() {
    let folder = two(&[("N", Value::Whole(3))]);
    let write = |name: &str| {
        let line = ["compare", "impeller.xlsx", "other.xlsx", "-o", name, "--json"];
        let output = rodete(&folder).args(line).output().expect("it runs");
        (output.status.code(), serde_json::from_slice::<Json>(&output.stdout).expect("a document"))
    };
    let (exit, read) = write("a.xlsx");
    let file = &read["files"][0];
    let written = fs::read(folder.path().join("a.xlsx")).expect("a workbook");
    assert_eq!((exit, &file["path"], &read["findings"]), (Some(0), &json!("a.xlsx"), &json!([])));
    assert_eq!((&file["bytes"], &file["sha256"]), (&json!(written.len()), &json!(rodete::store::sha256(&written))));
    fs::create_dir(folder.path().join("b.xlsx")).expect("a folder in the way");
    let (exit, read) = write("b.xlsx");
    assert_eq!((exit, &read["exit"], &read["same"], &read["files"]), (Some(5), &json!(5), &json!(false), &json!([])));
    assert_eq!(read["findings"][0]["grade"], json!("stop"), "{}", read["findings"]);
}

#[cfg(feature = "embedded-typst")]
#[test]
fn the_comparison_is_written_as_a_pdf_that_names_both_workbooks_and_what_differs() {
    let folder = two(&[("N", Value::Whole(3))]);
    for (language, title, verdict) in [
        ("en", "Comparison of two workbooks", "The two differ"),
        ("es", "Comparación de dos libros", "Hay diferencias"),
    ] {
        let line = ["compare", "impeller.xlsx", "other.xlsx", "-o", "a.pdf", "-o", "a.xlsx", "--lang", language];
        rodete(&folder).args(line).assert().code(0);
        let pdf = fs::read(folder.path().join("a.pdf")).expect("a PDF");
        assert!(pdf.starts_with(b"%PDF"));
        rodete(&folder)
            .args(["compare", "impeller.xlsx", "other.xlsx", "-o", "b.pdf", "--lang", language])
            .assert()
            .code(0);
        assert!(pdf == fs::read(folder.path().join("b.pdf")).expect("a PDF"), "the same bytes each time");
        let text =
            std::process::Command::new("pdftotext").args(["-layout", "a.pdf", "-"]).current_dir(folder.path()).output();
        let Ok(text) = text else {
            assert!(std::env::var_os("CI").is_none(), "pdftotext (poppler-utils) is needed here and cannot be called");
            return;
        };
        let text = String::from_utf8(text.stdout).expect("UTF-8");
        for told in [title, verdict, "impeller.xlsx", "other.xlsx", "DATA!C11", "SHA-256"] {
            assert!(text.contains(told), "{told}: {text}");
        }
    }
    assert_eq!(names(folder.path()), ["a.pdf", "a.xlsx", "b.pdf", "impeller.xlsx", "other.xlsx"]);
}

/// What is said of a program that one workbook alone has is not held against what the other says of another program.
#[test]
fn findings_about_programs_are_paired_by_the_program() {
    let folder = two(&[("splitters", Value::Choice("no"))]);
    let read = document(&folder, "impeller.xlsx", "other.xlsx");
    let passed = |side: &str| -> Vec<String> {
        let all = read[side]["findings"].as_array().expect("findings").iter();
        all.filter(|one| one["code"] == "V0019").map(|one| one["what"]["en"].to_string()).collect()
    };
    assert!(passed("only_a").iter().all(|what| what.contains("splitter")), "{:?}", passed("only_a"));
    assert!(passed("only_b").is_empty(), "{:?}", passed("only_b"));
    assert!(passed("both").iter().any(|what| what.contains("blank")), "{:?}", passed("both"));
}
