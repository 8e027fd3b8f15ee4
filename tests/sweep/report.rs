//! The report of a sweep: what it is set from, what it says in both languages, and what there is without it.

#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use calamine::{Reader, Xlsx, open_workbook};
use rodete::parameter;
use rodete::text::Language;
use serde_json::Value;

use crate::common::workbook::{Parts, quick, thick, with_variants_of};

/// A folder with a workbook of 24 designs of two objectives, some of them refused, around a design.
fn folder(around: &[(&'static str, parameter::Value)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let settings = [("method", "factorial"), ("objectives", "time_s min; clearance_mm max")];
    let inputs =
        [["N", "", "", "", "4; 5; 6", ""], ["e", "1", "4", "1", "", ""], ["splitters", "", "", "", "yes; no", ""]];
    fs::write(folder.path().join("a.xlsx"), with_variants_of(around, &settings, &inputs, &[])).unwrap();
    folder
}

/// Sweeps with a typst: the one inside the binary where `None`.
fn sweep(folder: &Path, typst: Option<&str>, words: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rodete"));
    command.current_dir(folder).env("LC_ALL", "C").env("KEPT", folder.join("kept"));
    match typst {
        Some(typst) => command.env("RODETE_TYPST", typst),
        None => command.env_remove("RODETE_TYPST"),
    };
    command.args(["sweep", "a.xlsx", "-o", "s", "--top", "3", "--report"]).args(words.split_whitespace());
    command.output().unwrap()
}

fn keeps() -> String {
    format!("{}/tests/typst/keeps.sh", env!("CARGO_MANIFEST_DIR"))
}

/// What typst was given to set.
fn contents(folder: &Path) -> Value {
    let kept = folder.join("kept");
    let main = fs::read_dir(&kept).unwrap().next().unwrap().unwrap().path();
    serde_json::from_slice(&fs::read(main.join("contents.json")).unwrap()).unwrap()
}

#[test]
fn the_report_is_set_from_the_plan_its_rows_and_the_title_block() {
    for (language, title, front) in [("es", "Informe del barrido", "frente"), ("en", "Report of the sweep", "front")] {
        let folder = folder(&quick().values(Language::En));
        let output = sweep(folder.path(), Some(&keeps()), &format!("--lang {language}"));
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let told = String::from_utf8(output.stdout).unwrap();
        assert!(told.ends_with("s: summary.parquet, a-sweep.xlsx, a-sweep.pdf\n"), "{told}");
        assert!(fs::read(folder.path().join("s/a-sweep.pdf")).unwrap().starts_with(b"%PDF"));
        let contents = contents(folder.path());
        assert_eq!((&contents["title"], &contents["language"]), (&title.into(), &language.into()));
        assert!(told.starts_with(contents["verdict"].as_str().unwrap()), "{told}");
        let chapters = contents["chapters"].as_array().unwrap();
        let rows = |at: usize, table: usize| chapters[at]["tables"][table]["rows"].as_array().unwrap();
        let symbols: Vec<&str> = rows(0, 0).iter().map(|row| row[0].as_str().unwrap()).collect();
        assert_eq!(symbols, ["N", "e", "splitters"]);
        assert_eq!((&rows(0, 0)[0][4], &rows(0, 0)[0][2]), (&"4; 5; 6".into(), &"4".into()));
        // As many as were not feasible, each by its code with the sentence of its row.
        let why: u64 = rows(1, 0).iter().map(|row| row[1].as_str().unwrap().parse::<u64>().unwrap()).sum();
        let refused =
            told.split([':', ',']).find(|part| part.contains(if language == "es" { "rechazados" } else { "refused" }));
        let refused: u64 = refused.unwrap().trim().split(' ').next().unwrap().parse().unwrap();
        assert!(why > 0 && why == refused, "{why} {told}");
        assert!(rows(1, 0).iter().all(|row| !row[3].as_str().unwrap().contains(['{', '}'])), "{:?}", rows(1, 0));
        let said = rows(1, 0)[0][3].as_str().unwrap().to_owned();
        assert!(!said.contains('…') && (said.starts_with("design ") || said.starts_with("diseño ")), "{said}");
        // The sheets say the same in the language of the workbook; its rows keep their keys.
        let mut book: Xlsx<_> = open_workbook(folder.path().join("s/a-sweep.xlsx")).unwrap();
        let (all, words) = if language == "es" {
            ("TODOS", ["estado", "válido", "precauciones", "códigos", "motivo", "frente", "rechazado"])
        } else {
            ("ALL", ["state", "feasible", "caution", "codes", "reason", "front", "refused"])
        };
        let sheet = book.worksheet_range(all).unwrap();
        let seen: Vec<String> = sheet.used_cells().map(|(.., cell)| cell.to_string()).collect();
        assert!(words.iter().all(|word| seen.iter().any(|cell| cell == word)), "{words:?}");
        // The best, with the front marked, over each other in a figure that is there.
        let best = &chapters[2];
        assert_eq!(rows(2, 0).len(), 3);
        let column =
            best["tables"][0]["columns"].as_array().unwrap().iter().position(|one| one["name"] == front).unwrap();
        assert_eq!(rows(2, 0)[0][column], "●");
        let file = best["figures"][0]["file"].as_str().unwrap();
        let kept = fs::read_dir(folder.path().join("kept")).unwrap().next().unwrap().unwrap().path();
        let picture = fs::read_to_string(kept.join(file)).unwrap();
        assert!(picture.matches("<circle").count() >= 3, "{picture}");
        // In the colours of the workbook's charts.
        let charts = Parts::of(&fs::read(folder.path().join("s/a-sweep.xlsx")).unwrap());
        let charts = (1..).map(|number| format!("xl/charts/chart{number}.xml")).take_while(|part| charts.has(part));
        let book = Parts::of(&fs::read(folder.path().join("s/a-sweep.xlsx")).unwrap());
        let charts: String = charts.map(|part| book.text(&part).to_lowercase()).collect();
        let legend = best["figures"][0]["legend"].as_array().unwrap();
        assert!(legend.len() >= 2);
        for entry in legend {
            let colour = entry[0].as_str().unwrap();
            assert!(charts.contains(&colour[1..]) && picture.contains(colour), "{colour}");
        }
        // Tolerances, then what each input does to each objective.
        assert_eq!(chapters[3]["tables"].as_array().unwrap().len(), 3);
        assert_eq!(rows(3, 0).len(), 3);
        assert_eq!((&rows(3, 0)[1][0], &rows(3, 0)[1][2]), (&"e".into(), &"2".into()));
        assert!(!rows(3, 0)[1][4].as_str().unwrap().is_empty(), "how far e may go up: {:?}", rows(3, 0)[1]);
        let text = contents.to_string();
        assert!(!text.contains(&folder.path().to_string_lossy().into_owned()), "no folder is named");
    }
}

#[test]
fn a_report_that_cannot_be_set_keeps_nothing_else_from_being_written() {
    let folder = folder(&thick(quick()));
    let output = sweep(folder.path(), Some("/no/such/typst"), "");
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(6), "{told}");
    assert!(told.contains("the report of the sweep could not be typeset"), "{told}");
    assert!(String::from_utf8(output.stdout).unwrap().ends_with("s: summary.parquet, a-sweep.xlsx\n"));
    assert!(folder.path().join("s/a-sweep.xlsx").is_file() && !folder.path().join("s/a-sweep.pdf").exists());
    // Run again, it is there, and is removed with the rest.
    assert_eq!(sweep(folder.path(), Some(&keeps()), "--merge").status.code(), Some(0));
    assert!(folder.path().join("s/a-sweep.pdf").is_file());
}

/// Over a range as narrow as the rounding of the programs a slope is noise.
#[test]
fn a_change_within_the_rounding_is_a_dash_with_a_note_and_lengths_end_at_a_thousandth() {
    let swept = |from: &str, to: &str| {
        let folder = tempfile::tempdir().unwrap();
        let settings = [("method", "latin"), ("samples", "4"), ("objectives", "clearance_mm max")];
        let around = quick().values(Language::En);
        let book = with_variants_of(&around, &settings, &[["e", from, to, "", "", ""]], &[]);
        fs::write(folder.path().join("a.xlsx"), book).unwrap();
        let output = sweep(folder.path(), Some(&keeps()), "--lang en");
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let contents = contents(folder.path());
        let chapters = contents["chapters"].as_array().unwrap().clone();
        let told = chapters.iter().find(|one| one["title"] == "What each input does").unwrap().clone();
        let row = told["tables"][1]["rows"][0].as_array().unwrap().clone();
        let note = told["paragraphs"].to_string().contains("no more than its rounding");
        let mut book: Xlsx<_> = open_workbook(folder.path().join("s/a-sweep.xlsx")).unwrap();
        let sheet = book.worksheet_range("SENSITIVITY").unwrap();
        let dash = sheet.used_cells().any(|(.., cell)| *cell == "–");
        (row, note, dash, chapters)
    };
    let (row, note, dash, chapters) = swept("2", "2.0001");
    assert_eq!((row[1].as_str(), note, dash), (Some("–"), true, true), "{row:?}");
    let best = chapters.iter().find(|one| one["title"] == "The best designs").unwrap();
    let columns = best["tables"][0]["columns"].as_array().unwrap();
    let at = columns.iter().position(|one| one["name"] == "clearance_mm").unwrap();
    for row in best["tables"][0]["rows"].as_array().unwrap() {
        let decimals = row[at].as_str().unwrap().split_once('.').map_or(0, |(_, decimals)| decimals.len());
        assert!(decimals <= 3, "{row}");
    }
    let (row, note, dash, _) = swept("1", "3");
    assert!(row[1].as_str().unwrap().starts_with('\u{2212}') && !note && !dash, "{row:?}");
}

/// An empty cell of a tolerance could be taken for none that is needed: in its place stands why there is none.
#[test]
fn where_there_is_no_tolerance_it_says_why() {
    let constrained = |constraints: &str| {
        let folder = tempfile::tempdir().unwrap();
        let settings = [("method", "factorial"), ("objectives", "time_s min"), ("constraints", constraints)];
        let inputs =
            [["N", "", "", "", "4; 5", ""], ["e", "", "", "", "2", ""], ["splitters", "", "", "", "yes; no", ""]];
        let values = quick().values(Language::En);
        fs::write(folder.path().join("a.xlsx"), with_variants_of(&values, &settings, &inputs, &[])).unwrap();
        folder
    };
    let own = "No tolerances: the workbook's own design";
    for (folder, language, sheet, told, words) in [
        (
            folder(&thick(quick())),
            "en",
            "SENSITIVITY",
            format!("{own} is refused, P"),
            ["not feasible", "not feasible", "no number"],
        ),
        (
            constrained("time_s <= 1"),
            "en",
            "SENSITIVITY",
            format!("{own} breaks time_s <= 1 ("),
            ["not feasible", "one value", "no number"],
        ),
        (
            constrained("time_s <= 1"),
            "es",
            "SENSIBILIDAD",
            "Sin tolerancias: el propio diseño del libro incumple time_s <= 1 (".to_owned(),
            ["no válido", "un solo valor", "no es número"],
        ),
    ] {
        let output = sweep(folder.path(), Some(&keeps()), &format!("--lang {language}"));
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let mut book: Xlsx<_> = open_workbook(folder.path().join("s/a-sweep.xlsx")).unwrap();
        let cells = book.worksheet_range(sheet).unwrap();
        let note = cells.get_value((2, 0)).unwrap().to_string();
        assert!(note.starts_with(&told), "{note}");
        let contents = contents(folder.path());
        assert!(contents["chapters"][3]["paragraphs"][0].as_str().unwrap().starts_with(&told));
        let head = (0..9).find(|row| {
            cells.get_value((*row, 1)).is_some_and(|one| ["value", "valor"].contains(&one.to_string().as_str()))
        });
        for ((row, word), at) in (head.unwrap() + 1..).zip(words).zip(0..) {
            let there =
                [3, 4].map(|column| cells.get_value((row, column)).map(ToString::to_string).unwrap_or_default());
            assert_eq!(there, [word, word], "{language} {row}");
            assert_eq!(contents["chapters"][3]["tables"][0]["rows"][at][3], word);
        }
    }
}

#[cfg(feature = "embedded-typst")]
#[test]
fn the_compiler_inside_sets_the_report_in_both_languages() {
    for (language, words) in [
        ("es", ["Informe del barrido", "Qué varía", "Los mejores diseños", "Qué hace cada entrada", "Página 1 de"]),
        ("en", ["Report of the sweep", "What varies", "The best designs", "What each input does", "Page 1 of"]),
    ] {
        let folder = folder(&thick(quick()));
        let output = sweep(folder.path(), None, &format!("--lang {language}"));
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let text = Command::new("pdftotext").arg(folder.path().join("s/a-sweep.pdf")).arg("-").output();
        let Ok(text) = text else {
            assert!(std::env::var_os("CI").is_none(), "pdftotext (poppler-utils) is missing");
            eprintln!("skipped: pdftotext is missing");
            return;
        };
        let text = String::from_utf8(text.stdout).unwrap();
        for word in words {
            assert!(text.contains(word), "{word}: {text}");
        }
    }
}
