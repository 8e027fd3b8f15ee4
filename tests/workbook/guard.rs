//! The guard of results and `check`: both compare cells as they are written.

use crate::common;
use crate::libreoffice::libreoffice;
use crate::live::{cell_of, number, range, recalculated, with_on};

use std::io::Cursor;

use calamine::{Reader, Xlsx, open_workbook_from_rs};
use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::text::Language;
use rodete::workbook::guard::SHEET;
use rodete::workbook::results::{self, Tables};

fn results_of(kind: &str, case: &str) -> Vec<u8> {
    let kind: &'static dyn Kind = *KINDS.iter().find(|one| one.form().kind == kind).expect("a kind");
    let case = kind.cases().iter().find(|one| one.name == case).expect("a case");
    let outcome = common::outcome_of(kind, case, Language::En, &[]);
    let mut out = std::io::Cursor::new(Vec::new());
    results::write(&outcome, &[], Tables::Live, Language::En, &mut out).expect("results");
    out.into_inner()
}

/// What `check` says was changed.
fn changed(bytes: &[u8]) -> Option<String> {
    let forms: Vec<_> = KINDS.iter().map(|kind| kind.form()).collect();
    rodete::workbook::read(bytes, &forms).expect("a form").stale.map(|stale| stale.what.en.into_owned())
}

/// What is spelt otherwise and means the same: the input, and what is typed into its cell.
const SPELLINGS: [(&str, &str, &str); 6] = [
    ("part", "part", "Impeller TFG 2021 "),
    ("material", "material", "Aluminium\u{a0}"),
    ("distance", "distance", "g91"),
    ("start_codes", "start_codes", "M3  M11 M13"),
    ("schema", "schema", "rodete-impeller 2 "),
    ("tol", "tip_tolerance_tol", " "),
];

fn text(text: &str) -> String {
    format!(" t=\"inlineStr\"><is><t xml:space=\"preserve\">{text}</t></is>")
}

#[test]
fn check_names_another_spelling_where_the_banner_is_red() {
    let impeller = results_of("impeller", "full");
    let lathe = results_of("lathe", "shaft");
    assert_eq!(changed(&impeller), None);
    assert_eq!(changed(&lathe), None);
    let mut books: Vec<(String, Vec<u8>)> = SPELLINGS
        .into_iter()
        .map(|(symbol, name, typed)| {
            (symbol.to_owned(), with_on(&impeller, "DATA", &cell_of(&impeller, name), &text(typed)))
        })
        .collect();
    let block = {
        let mut book: Xlsx<_> = open_workbook_from_rs(Cursor::new(lathe.clone())).expect("the results");
        let sheet = book.worksheet_range("PROGRAM").expect("the program");
        sheet.get_value((8, 0)).expect("a block").to_string()
    };
    books.push(("PROGRAM (A9)".to_owned(), with_on(&lathe, "PROGRAM", "A9", &text(&format!("{block} ")))));
    for (name, book) in &books {
        let told = changed(book).unwrap_or_default();
        assert!(told.contains(&format!("were made: {name}; out of date: ")), "{name}: {told}");
    }
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let files: Vec<_> = books.into_iter().enumerate().map(|(at, (_, book))| (format!("book-{at}"), book)).collect();
    for (at, mut book) in recalculated(folder.path(), false, &files).into_iter().enumerate() {
        let count = number(range(&mut book, SHEET).get_value((0, 2)));
        assert_eq!(count, Some(1.0), "{at}");
    }
}
