//! The page of all findings, and their codes for ever.

#![allow(clippy::unwrap_used, clippy::disallowed_methods, missing_docs)]

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use rodete::cli::{reference, rows};
use rodete::kinds::KINDS;
use rodete::text::Language;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// True where page and codes are to be brought up to date: `RODETE_FINDINGS=write`.
pub fn write() -> bool {
    std::env::var_os("RODETE_FINDINGS").is_some_and(|value| value == "write")
}

pub const HOW: &str =
    "where that is meant: RODETE_FINDINGS=write cargo test --test findings, and again with reference::";

#[test]
fn the_page_of_the_findings_is_what_explain_writes() {
    let page = reference(KINDS, Language::En);
    let path = file("docs/reference/findings.md");
    if write() {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, &page).unwrap();
    }
    let held = fs::read_to_string(path).unwrap();
    let apart = held.lines().zip(page.lines()).find(|(held, told)| held != told);
    assert!(held == page, "docs/reference/findings.md is another page at {apart:?}; {HOW}");
}

#[test]
fn both_languages_explain_every_code() {
    for language in [Language::Es, Language::En] {
        let page = reference(KINDS, language);
        for rule in rows(KINDS) {
            assert!(page.contains(&format!("\n### {} {}\n", rule.code, rule.name())), "{}", rule.code);
        }
    }
}

/// Every file of Rust in a folder.
fn sources(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, files);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
}

/// A list of rows that `explain` does not know would be told under codes that nobody can look up.
#[test]
fn every_list_of_rows_in_src_is_one_that_explain_knows() {
    let mut files = Vec::new();
    sources(&file("src"), &mut files);
    let known: BTreeMap<&str, &str> = rows(KINDS).into_iter().map(|rule| (rule.code, rule.ident)).collect();
    let mut seen = 0;
    for path in files {
        let text = fs::read_to_string(&path).unwrap();
        // Rows of tests are no findings of rodete.
        let text = text.split("#[cfg(test)]\nmod tests").next().unwrap();
        if path.ends_with("finding/sample.rs") || !text.contains("rules! {") {
            continue;
        }
        for line in text.lines() {
            let mut words = line.split_whitespace();
            let [Some(code), Some(name), Some(grade)] = [(); 3].map(|()| words.next()) else { continue };
            let Some(code) = code.strip_prefix('"').and_then(|code| code.strip_suffix('"')) else { continue };
            if ["Stop", "Caution", "Note"].contains(&grade) && !line.contains("$(") {
                assert_eq!(known.get(code), Some(&name), "{}: add its list to RULES of explain", path.display());
                seen += 1;
            }
        }
    }
    assert_eq!(seen, known.len());
}

/// Codes that are no longer told, and never given again: they wrapped what another code tells now by itself, or nothing could raise
/// them.
const RETIRED: [&str; 5] = ["V0003", "V0004", "V0409", "W0219", "W0262"];

/// A code once given keeps its name, and none goes but the retired.
#[test]
fn no_code_vanishes_or_changes_its_meaning() {
    let path = file("tests/golden/codes.txt");
    let held = fs::read_to_string(&path).unwrap_or_default();
    let now: BTreeMap<&str, String> = rows(KINDS).into_iter().map(|rule| (rule.code, rule.name())).collect();
    assert!(RETIRED.iter().all(|code| !now.contains_key(code)), "a retired code is given again");
    let mut frozen = BTreeMap::new();
    for line in held.lines() {
        let (code, name) = line.split_once(' ').unwrap();
        assert_eq!(now.get(code).map(String::as_str), Some(name), "{code} was given as {name}");
        frozen.insert(code, name.to_owned());
    }
    if write() {
        let text = now.iter().fold(String::new(), |mut text, (code, name)| {
            let _ = writeln!(text, "{code} {name}");
            text
        });
        fs::write(path, text).unwrap();
        return;
    }
    assert!(frozen.len() > 150, "{} codes", frozen.len());
    assert_eq!(frozen, now, "a code that is new is not written down; {HOW}");
}
