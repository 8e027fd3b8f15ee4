//! Pages that are written from the code are what the code writes.

use std::fs;

use rodete::cli::{exit_codes, parameters};
use rodete::kinds::KINDS;
use rodete::text::Language;

use crate::markdown::root;

#[test]
fn parameters_and_exit_codes_are_those_of_the_code() {
    let write = std::env::var_os("RODETE_DOCS").is_some_and(|value| value == "write");
    let pages = [
        ("parameters.md", parameters(KINDS, Language::En).unwrap()),
        ("parametros.md", parameters(KINDS, Language::Es).unwrap()),
        ("exit-codes.md", exit_codes(Language::En)),
        ("codigos-de-salida.md", exit_codes(Language::Es)),
    ];
    for (name, page) in pages {
        let path = root().join("docs/reference").join(name);
        if write {
            fs::write(&path, &page).unwrap();
        }
        let held = fs::read_to_string(path).unwrap_or_default();
        let apart = held.lines().zip(page.lines()).find(|(held, told)| held != told);
        let how = "where that is meant: RODETE_DOCS=write cargo test --test docs pages::";
        assert!(held == page, "docs/reference/{name} is another page at {apart:?}; {how}");
    }
}

/// What does not fit stands in the manual.
#[test]
fn readme_is_a_front_page_in_both_languages() {
    let [english, spanish] = ["README.md", "README.es.md"].map(|name| fs::read_to_string(root().join(name)).unwrap());
    for text in [&english, &spanish] {
        let (lines, words) = (text.lines().count(), text.split_whitespace().count());
        assert!(lines <= 150 && words <= 1200, "{lines} lines, {words} words");
        assert_eq!(text.matches("](docs/pictures/").count(), 3, "three pictures");
    }
    let headings = |text: &str| text.lines().filter(|line| line.starts_with("## ")).count();
    assert_eq!(headings(&english), headings(&spanish));
}
