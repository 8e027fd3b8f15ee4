//! The page of the controls.

use std::fs;
use std::path::Path;

use rodete::cli::controls;
use rodete::gcode::control::{ALL, CODE_LIMIT, code_name};
use rodete::text::Language;

const HOW: &str = "where that is meant: RODETE_CONTROLS=write cargo test --test controls page::";

#[test]
fn the_page_of_the_controls_is_what_explain_writes() {
    let page = controls(Language::En);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference/controls.md");
    if std::env::var_os("RODETE_CONTROLS").is_some_and(|value| value == "write") {
        fs::write(&path, &page).unwrap();
    }
    let held = fs::read_to_string(path).unwrap();
    let apart = held.lines().zip(page.lines()).find(|(held, told)| held != told);
    assert!(held == page, "docs/reference/controls.md is another page at {apart:?}; {HOW}");
}

/// The cells of a row.
fn cells(row: &str) -> Vec<String> {
    let row = row.strip_prefix("| ").and_then(|row| row.strip_suffix(" |")).unwrap_or(row);
    row.replace("\\|", "\0").split(" | ").map(|cell| cell.trim().replace('\0', "\\|")).collect()
}

/// A row of each feature, with a cell for each control, in either language.
#[test]
fn every_row_has_a_cell_for_every_control_in_both_languages() {
    let rows = |language| {
        let page = controls(language);
        let mut all = Vec::new();
        let mut controls = 0;
        for table in page.split("\n### ").filter(|part| part.contains("\n| ")) {
            let rows: Vec<_> = table.lines().filter(|line| line.starts_with("| ")).map(str::to_owned).collect();
            let width = cells(&rows[0]).len();
            assert!(rows.iter().all(|row| cells(row).len() == width), "{table}");
            controls += width - 1;
            all.extend(rows);
        }
        // Behaviour, G codes and M codes, each of mills and of lathes.
        assert_eq!(controls, 3 * ALL.len());
        all
    };
    let (es, en) = (rows(Language::Es), rows(Language::En));
    assert_eq!(es.len(), en.len());
    let [first, others @ ..] =
        ALL.map(|control| control.features().into_iter().map(|feature| feature.of).collect::<Vec<_>>());
    assert!(first.len() > 50, "{} features", first.len());
    assert!(others.iter().all(|other| *other == first), "every control has the same features");
}

/// What a table has, the page says: the meaning of each code, and where one is refused its name.
#[test]
fn the_page_tells_every_code_of_every_table() {
    for language in Language::ALL {
        let page = controls(language);
        let page = page.split("\n## ").nth(2).unwrap();
        for control in ALL {
            let (table, place) = page
                .split("\n### ")
                .find_map(|table| {
                    let head = table.lines().find(|line| line.starts_with("| "))?;
                    Some((table, cells(head).iter().position(|name| name == control.name)?))
                })
                .unwrap();
            let mut codes = 0;
            for tenths in 0..CODE_LIMIT {
                let name = code_name(tenths);
                let row = table.lines().find(|line| line.starts_with(&format!("| {name} |")));
                let cell = row.map(|row| cells(row)[place].clone()).filter(|cell| !cell.is_empty());
                let meaning = control.codes.get(tenths).map(|code| code.told());
                codes += usize::from(meaning.is_some());
                let meaning = meaning.as_ref().map(|meaning| meaning.get(language).to_owned());
                assert_eq!(cell, meaning, "{name} of {}", control.name);
            }
            assert!(codes > 12, "{} has but the codes of all: {codes}", control.name);
            assert!(!control.sources.is_empty(), "{} has no source", control.name);
            // Taken over from another control with `..`, they would be claims of manuals that nobody has read for this one.
            let taken = ALL
                .iter()
                .find(|other| other.name != control.name && other.sources.as_ptr() == control.sources.as_ptr());
            assert!(taken.is_none(), "{} has the sources of {:?}", control.name, taken.map(|other| other.name));
        }
    }
}
