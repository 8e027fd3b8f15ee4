//! What a form says of an input that is missing under a condition, or in a row of a list: never that the limits hold where `check` stops.

use crate::common;
use crate::libreoffice::libreoffice;
use crate::live::{cell_of, range, recalculated, with_on};
use crate::live_forms::{form, kind_of, sheet, text, typed};

use rodete::finding::{Finding, Grade};
use rodete::text::Language;
use rodete::workbook::Filled;

/// The codes of the stops with which `rodete check` rejects a form.
fn stops(bytes: &[u8], kind: &str) -> Vec<&'static str> {
    let read = rodete::workbook::read(bytes, &[kind_of(kind).form()]);
    let run = |filled: Filled| rodete::kinds::run(filled.form, filled.values, common::source());
    let findings = match read.and_then(run) {
        Err(refusal) => refusal.findings,
        Ok(outcome) => outcome.findings,
    };
    findings.iter().filter(|one| one.grade == Grade::Stop).map(Finding::code).collect()
}

/// A kind and its case; the sheet in both languages, of the first one none, and the cell or its name; what is typed; what is said of
/// it, nothing where it is taken; the code of the stop.
type Case =
    (&'static str, &'static str, [&'static str; 2], &'static str, &'static str, [&'static str; 2], &'static str);

const FIRST: [&str; 2] = ["", ""];
const TOOLS: [&str; 2] = ["TOOLS", "HERRAMIENTAS"];
const PROFILE: [&str; 2] = ["PROFILE", "PERFIL"];
const CALIBRATION: [&str; 2] = ["CALIBRATION", "CALIBRACION"];
const TAKEN: [&str; 2] = ["The limits hold", "Los límites se cumplen"];

const CASES: [Case; 13] = [
    (
        "lathe",
        "shaft",
        FIRST,
        "decimal_point",
        "",
        ["point (#): this control needs it", "point (#): este control"],
        "P4008",
    ),
    ("impeller", "full", CALIBRATION, "C6", "95", ["6 (CALIBRATION, d_w)", "6 (CALIBRACION, d_w)"], "W0403"),
    ("lathe", "shaft", TOOLS, "D6", "", ["1 (TOOLS, type (D6))", "1 (HERRAMIENTAS, type (D6))"], "W0403"),
    ("lathe", "shaft", TOOLS, "D8", "", ["1 (TOOLS, type (D8))", "1 (HERRAMIENTAS, type (D8))"], "W0403"),
    ("lathe", "shaft", TOOLS, "R7", "", ["1 (TOOLS, b (R7))", "1 (HERRAMIENTAS, b (R7))"], "W0403"),
    ("lathe", "shaft", PROFILE, "A6", "1", ["2 (PROFILE, X (B6))", "2 (PERFIL, X (B6))"], "W0403"),
    ("lathe", "shaft", PROFILE, "D6", "5", ["3 (PROFILE, G (A6))", "3 (PERFIL, G (A6))"], "W0403"),
    ("lathe", "shaft", TOOLS, "D6", "internal  groove", ["TOOLS, type: not one", "HERRAMIENTAS, type: no es"], "W0415"),
    ("lathe", "shaft", TOOLS, "D6", " External ", TAKEN, ""),
    ("pipe-hole", "set-in", FIRST, "torch_on", "M3\u{a0}", TAKEN, ""),
    ("pipe-hole", "set-in", FIRST, "torch_on", "M3\u{a0}M7", TAKEN, ""),
    ("pipe-hole", "set-in", FIRST, "torch_on", "\u{a0}", ["torch_on (#): codes", "torch_on (#): códigos"], "W0403"),
    ("pipe-hole", "set-in", FIRST, "torch_on", "M3\u{a0}x", ["torch_on (#): codes", "torch_on (#): códigos"], "W0416"),
];

#[test]
fn a_form_is_never_green_where_check_misses_an_input() {
    if !libreoffice() {
        return;
    }
    for (at, language) in [Language::En, Language::Es].into_iter().enumerate() {
        let folder = tempfile::tempdir().expect("a folder");
        let books: Vec<(String, Vec<u8>)> = CASES
            .iter()
            .enumerate()
            .map(|(number, (kind, case, sheets, cell, value, ..))| {
                let bytes = form(kind, case, language);
                let inner = if value.is_empty() || value.parse::<f64>().is_ok() { typed(value) } else { text(value) };
                let changed = match sheets[at] {
                    "" => with_on(&bytes, sheet(language), &cell_of(&bytes, cell), &inner),
                    name => with_on(&bytes, name, cell, &inner),
                };
                (format!("missing-{number}"), changed)
            })
            .collect();
        let computed = recalculated(folder.path(), language == Language::Es, &books);
        for ((kind, _, sheets, cell, value, words, code), ((_, bytes), mut book)) in
            CASES.iter().zip(books.iter().zip(computed))
        {
            let told = range(&mut book, sheet(language)).get_value((0, 2)).map(ToString::to_string).unwrap_or_default();
            let named = if sheets[at].is_empty() { cell_of(bytes, cell) } else { String::new() };
            let wanted = words[at].replace('#', &named);
            assert!(told.contains(&wanted), "{kind} {cell} = {value:?}: {wanted} is not in: {told}");
            let stops = stops(bytes, kind);
            assert_eq!(stops.is_empty(), code.is_empty(), "{kind} {cell} = {value:?}: {stops:?}");
            assert!(code.is_empty() || stops.contains(code), "{kind} {cell} = {value:?}: {stops:?}");
        }
    }
}
