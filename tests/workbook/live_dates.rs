//! A date in figures that no calendar has: the form turns red on it where `check` stops, and on no other text.

use crate::common;
use crate::libreoffice::libreoffice;
use crate::live::{cell_of, range, recalculated, with_on};
use crate::live_forms::{form, kind_of, sheet, text};

use rodete::finding::Finding;
use rodete::text::Language;
use rodete::workbook::Filled;

/// A text, whether `check` stops at it, and whether the form does: the rest is left to `check`.
const DATES: [(&str, bool, bool); 23] = [
    ("32/01/2026", true, true),
    ("31/02/2026", true, true),
    ("29/02/2100", true, true),
    (" 31.04.2026 ", true, true),
    ("02/30/2026", true, true),
    ("2026-02-30", true, true),
    ("2026/13/13", true, true),
    ("2026.31.12", true, true),
    ("26-13-01", true, true),
    ("00/05/2026", true, true),
    ("31 de febrero de 2026", true, false),
    ("Cartagena, 31/11/2026", true, false),
    ("31 / 04 / 2026", true, false),
    ("29/02/2028", false, false),
    ("29/2/00", false, false),
    ("12/31/2026", false, false),
    ("26-11-23", false, false),
    ("31-12-26", false, false),
    ("2026-11-23", false, false),
    ("31.02.2026.4", false, false),
    ("3/4/5", false, false),
    ("31/02-2026", false, false),
    ("46349", false, false),
];

#[test]
fn a_date_in_figures_is_red_where_it_is_no_day() {
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let plain = form("impeller", "full", Language::En);
    let cell = cell_of(&plain, "title_date");
    let books: Vec<(String, Vec<u8>)> = DATES
        .iter()
        .enumerate()
        .map(|(at, (date, ..))| (format!("date-{at}"), with_on(&plain, sheet(Language::En), &cell, &text(date))))
        .collect();
    let computed = recalculated(folder.path(), false, &books);
    for ((date, stops, red), ((_, bytes), mut book)) in DATES.iter().zip(books.iter().zip(computed)) {
        let read = rodete::workbook::read(bytes, &[kind_of("impeller").form()]);
        let run = |filled: Filled| rodete::kinds::run(filled.form, filled.values, common::source());
        let codes: Vec<&str> = match read.and_then(run) {
            Err(refusal) => refusal.findings.iter().map(Finding::code).collect(),
            Ok(_) => Vec::new(),
        };
        assert_eq!(!codes.is_empty(), *stops, "{date}: {codes:?}");
        let told = range(&mut book, "DATA").get_value((0, 2)).map(ToString::to_string).unwrap_or_default();
        assert_eq!(told.contains("a date, such as"), *red, "{date}: {told}");
    }
}
