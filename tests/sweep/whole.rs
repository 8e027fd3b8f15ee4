//! The best designs built whole: what only a program shows is told wherever the best are.

#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use calamine::{Reader, Xlsx, open_workbook};
use rodete::text::Language;
use serde_json::Value;

use crate::common::workbook::{Parts, quick, with_variants_of};

/// Blades of three thicknesses, all good by the derived limits; between the thick ones the tool cuts.
fn book(level: &str, thicknesses: &str) -> Vec<u8> {
    let settings = [("method", "factorial"), ("level", level), ("objectives", "w max")];
    let inputs = [["e", "", "", "", thicknesses, ""], ["splitters", "", "", "", "no", ""]];
    with_variants_of(&quick().values(Language::En), &settings, &inputs, &[])
}

/// Sweeps with a typst that keeps what it is given.
fn sweep(folder: &Path, words: &str) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_rodete"))
        .current_dir(folder)
        .env("LC_ALL", "C")
        .env("KEPT", folder.join("kept"))
        .env("RODETE_TYPST", format!("{}/tests/typst/keeps.sh", env!("CARGO_MANIFEST_DIR")))
        .args(["sweep", "a.xlsx", "-o", "s"])
        .args(words.split_whitespace())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    output
}

fn swept(level: &str, thicknesses: &str, words: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.xlsx"), book(level, thicknesses)).unwrap();
    let told = String::from_utf8(sweep(folder.path(), words).stderr).unwrap();
    (folder, told)
}

/// The rows of the sheet of the best, from its line on; and how many of its cells are filled as a stop.
fn best(folder: &Path) -> (String, Vec<Vec<String>>, Parts) {
    let path = folder.join("s/a-sweep.xlsx");
    let mut book: Xlsx<_> = open_workbook(&path).unwrap();
    let sheet = book.worksheet_range("TOP").unwrap();
    let rows = sheet.rows().skip(4).map(|row| row.iter().map(ToString::to_string).collect()).collect();
    (sheet.get_value((2, 0)).unwrap().to_string(), rows, Parts::of(&fs::read(path).unwrap()))
}

#[test]
fn a_best_design_that_is_rejected_when_it_is_built_whole_is_told_in_the_top_the_report_and_on_the_screen() {
    let (folder, told) = swept("limits", "2; 4; 4.25", "--report");
    assert!(
        told.starts_with("caution D0209: rodete rejects 2 of the 3 best designs when it builds them whole"),
        "{told}"
    );
    assert!(told.contains("V0107") && told.contains("set level = program"), "{told}");
    let (line, rows, parts) = best(folder.path());
    assert!(line.contains("rodete rejects 2 of the 3 that it built whole.") && line.contains("In red, "), "{line}");
    let column = |name: &str| rows[0].iter().position(|one| one == name).unwrap_or_else(|| panic!("{name}: {rows:?}"));
    let (link, built, codes) = (column("workbook"), column("built"), column("codes"));
    assert_eq!(rows.len(), 4, "{rows:?}");
    for row in &rows[1..3] {
        assert!(row[built].starts_with("V0107: the tool cuts into the neighbouring blade"), "{row:?}");
        assert!(row[codes].contains("V0107") && !row[link].ends_with("-results.xlsx"), "{row:?}");
    }
    assert_eq!(rows[3][built], "yes");
    assert!(rows[3][link].ends_with("-results.xlsx"), "{rows:?}");
    // The cautions of the whole build are those of the program, not those of the limits.
    let results = folder.path().join("s/top").join(&rows[3][link]);
    assert!(results.is_file() && rows[3][codes].contains("P1044"), "{:?}", rows[3]);
    assert!(parts.text("xl/styles.xml").contains("FFF8D4D0"), "coloured as a stop");
    let kept = fs::read_dir(folder.path().join("kept")).unwrap().next().unwrap().unwrap().path();
    let contents: Value = serde_json::from_slice(&fs::read(kept.join("contents.json")).unwrap()).unwrap();
    assert_eq!(contents["grade"], "caution");
    assert!(contents["verdict"].as_str().unwrap().ends_with(". rodete rejects 2 of the 3 that it built whole."));
    let tables = contents["chapters"][2]["tables"].as_array().unwrap();
    assert_eq!((&tables[0]["rows"][0][0], &tables[0]["rows"][0][1]), (&"V0107".into(), &"2".into()));
    let built: Vec<&str> = tables[1]["rows"].as_array().unwrap().iter().map(|row| row[1].as_str().unwrap()).collect();
    assert_eq!(built, ["V0107", "V0107", "yes"]);
}

#[test]
fn where_every_best_design_is_built_nothing_is_said_of_rejected_ones() {
    for (level, thicknesses) in [("limits", "2"), ("program", "2; 4; 4.25")] {
        let (folder, told) = swept(level, thicknesses, "");
        assert!(!told.contains("D0209"), "{told}");
        let (line, rows, _) = best(folder.path());
        assert!(
            line.ends_with("Each link opens a workbook that is built already, and can be edited and built again."),
            "{line}"
        );
        assert!(rows.len() == 2 && rows[1].iter().any(|cell| cell == "yes"), "{rows:?}");
    }
    // Nothing is built: nothing is said of links.
    let (folder, _) = swept("limits", "2; 4", "--top 0");
    assert!(!best(folder.path()).0.contains("link"));
}

#[test]
fn sensitivities_name_the_level_that_they_were_worked_out_at() {
    for (level, told) in [("limits", "level = limits"), ("program", "level = program")] {
        let (folder, _) = swept(level, "2", "--top 0");
        let mut book: Xlsx<_> = open_workbook(folder.path().join("s/a-sweep.xlsx")).unwrap();
        let note = book.worksheet_range("SENSITIVITY").unwrap().get_value((2, 0)).unwrap().to_string();
        assert!(note.contains(&format!("Judged with {told}")), "{note}");
    }
}
