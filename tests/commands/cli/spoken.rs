//! The language of messages: that of the workbook, unless another is asked for.

use std::fs;
use std::path::Path;

use predicates::prelude::*;
use rodete::parameter::Value;
use rodete::text::Language;
use tempfile::TempDir;

use super::common::{folder, rodete, workbook_in};

/// A folder with a Spanish and an English workbook, both refused, and a file that is no workbook.
fn refused() -> TempDir {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    workbook_in(Language::Es, &path("es.xlsx"), &[("N", Value::Whole(40))]);
    workbook_in(Language::En, &path("en.xlsx"), &[("N", Value::Whole(40))]);
    fs::write(path("none.xlsx"), "no workbook").expect("a file");
    folder
}

fn said(folder: &TempDir, locale: &str, arguments: &[&str]) -> String {
    let done = rodete(folder).env("LC_ALL", locale).args(arguments).output().expect("run");
    [done.stderr, done.stdout].map(|text| String::from_utf8_lossy(&text).into_owned()).concat()
}

const ES: &str = "no se puede generar";
const EN: &str = "cannot be built";

#[test]
fn each_workbook_is_answered_in_its_own_language() {
    let folder = refused();
    for locale in ["C", "es_ES.UTF-8"] {
        let text = said(&folder, locale, &["check", "es.xlsx", "en.xlsx"]);
        assert!(text.contains(&format!("es.xlsx: {ES}")) && text.contains(&format!("en.xlsx: {EN}")), "{text}");
        for (lang, end) in [("es", ES), ("en", EN)] {
            let text = said(&folder, locale, &["check", "es.xlsx", "en.xlsx", "--lang", lang]);
            assert_eq!(text.matches(end).count(), 2, "{text}");
        }
    }
    // Values that are refused when they are read do not hide the language.
    workbook_in(Language::Es, &folder.path().join("es.xlsx"), &[("N", Value::Whole(0))]);
    assert!(said(&folder, "C", &["check", "es.xlsx"]).contains("debe estar entre 1 y 60"));
    let text = said(&folder, "C", &["view", "es.xlsx"]);
    assert!(text.contains("debe estar entre 1 y 60"), "{text}");
}

#[test]
fn what_is_no_workbook_is_answered_in_the_language_of_the_locale() {
    let folder = refused();
    for (locale, end) in [("C", EN), ("es_ES.UTF-8", ES), ("es", ES), ("de_DE.UTF-8", EN), ("", EN)] {
        let text = said(&folder, locale, &["check", "none.xlsx", "missing.xlsx"]);
        assert_eq!(text.matches(end).count(), 2, "{locale}: {text}");
    }
    let twice = ["build", "es.xlsx", "es.xlsx"];
    rodete(&folder)
        .env("LC_ALL", "es_ES.UTF-8")
        .args(twice)
        .assert()
        .code(2)
        .stderr(predicate::str::contains("se da dos veces"));
}

#[test]
fn the_document_for_scripts_holds_both_languages_whatever_the_locale() {
    let folder = refused();
    let documents = ["C", "es_ES.UTF-8"].map(|locale| said(&folder, locale, &["check", "es.xlsx", "--json"]));
    assert_eq!(documents[0], documents[1]);
    assert!(documents[0].contains("\"es\":") && documents[0].contains("\"en\":"));
    assert!(Path::new(&folder.path().join("es.xlsx")).exists());
}

#[test]
fn what_is_written_without_a_workbook_is_in_the_language_of_the_locale() {
    let forms: Vec<_> = rodete::kinds::KINDS.iter().map(|kind| kind.form()).collect();
    for (locale, language) in [("C", Language::En), ("es_ES.UTF-8", Language::Es)] {
        let folder = folder();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("plate.ngc"), "G21 G90 G94\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM2\n").expect("a program");
        fs::write(path("step.nc"), "T0101\nG99 G97 S500 M3\nG0 X48. Z2.\nG1 Z-20. F0.2\nM30\n").expect("a program");
        fs::write(path("linuxcnc.var"), "5220\t1.000000\n5221\t120.000000\n").expect("a file of offsets");
        for words in [
            &["view", "plate.ngc"][..],
            &["view", "step.nc"],
            &["simulate", "step.nc", "-o", "out"],
            &["offsets", "linuxcnc.var", "--workbook", "offsets.xlsx"],
        ] {
            rodete(&folder).env("LC_ALL", locale).args(words).assert().code(0);
        }
        for name in ["plate.html", "step.html", "out/step-viewer.html"] {
            let page = fs::read_to_string(path(name)).expect("a page");
            assert!(page.contains(&format!("<html lang=\"{}\">", language.code())), "{name} with {locale}");
        }
        for name in ["out/step-results.xlsx", "offsets.xlsx"] {
            let bytes = fs::read(path(name)).expect("a workbook");
            assert_eq!(rodete::workbook::language(&bytes, &forms), Some(language), "{name} with {locale}");
        }
    }
}
