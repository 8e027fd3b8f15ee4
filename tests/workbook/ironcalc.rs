//! Every formula of every shipped case, judged by IronCalc: a spreadsheet engine that shares nothing with LibreOffice, and that
//! computes with all digits.

use crate::common;
use crate::common::workbook::{Parts, quick, written};

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::Case;
use rodete::text::Language;
use rodete::workbook::results::{self, Tables};

/// Python with the package `ironcalc`; nothing where there is none. Where it must be there, its absence fails the test.
fn python() -> Option<PathBuf> {
    let named = std::env::var_os("RODETE_IRONCALC").map(PathBuf::from);
    let python = named.unwrap_or_else(|| PathBuf::from("python3"));
    let output = Command::new(&python).args(["-c", "import ironcalc"]).output();
    if output.is_ok_and(|output| output.status.success()) {
        return Some(python);
    }
    assert!(std::env::var_os("CI").is_none(), "IronCalc (pip install ironcalc) is needed here and cannot be called");
    // Not through the macros, whose output a passing test keeps to itself.
    let _ = writeln!(
        std::io::stderr(),
        "\n*** IronCalc (pip install ironcalc) is not installed: NOT TESTED that it computes what the workbooks hold ***\n"
    );
    None
}

/// What IronCalc finds in books: whether all is as it should be, and its lines.
fn judged(python: &Path, books: &[(String, Vec<u8>)]) -> (bool, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let files = books.iter().map(|(name, bytes)| {
        let path = folder.path().join(format!("{name}.xlsx"));
        std::fs::write(&path, bytes).expect("a file");
        path
    });
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/workbook/ask_ironcalc.py");
    let output = Command::new(python).arg("-B").arg(script).args(files).output().expect("Python can be called");
    let told = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(!told.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    (output.status.success(), told)
}

fn results_of(kind: &dyn Kind, case: &'static Case, language: Language) -> Vec<u8> {
    let outcome = common::shipped(kind, case, language);
    let mut out = std::io::Cursor::new(Vec::new());
    results::write(outcome, &[], Tables::Live, language, &mut out).expect("results");
    out.into_inner()
}

#[test]
fn every_stored_result_of_every_case_is_what_ironcalc_computes() {
    let Some(python) = python() else { return };
    let books: Vec<_> = common::alternating(Language::En)
        .enumerate()
        .map(|(at, (kind, case, language))| (format!("{at}-{}", case.name), results_of(kind, case, language)))
        .collect();
    let (same, told) = judged(&python, &books);
    assert!(same, "{told}");
    let count = |line: &str| line.split(": ").nth(1)?.split(' ').next()?.parse::<usize>().ok();
    let counts: Vec<usize> = told.lines().filter_map(count).collect();
    assert_eq!(counts.len(), books.len(), "{told}");
    assert!(counts.iter().sum::<usize>() > 10_000 && counts.iter().all(|count| *count >= 50), "{told}");
}

#[test]
fn ironcalc_tells_a_stored_result_that_is_wrong() {
    let Some(python) = python() else { return };
    let impeller = *KINDS.iter().find(|kind| kind.form().kind == FORM.kind).expect("the impeller");
    let bytes = results_of(impeller, quick(), Language::En);
    let parts = Parts::of(&bytes);
    let part = (1..40)
        .map(|at| format!("xl/worksheets/sheet{at}.xml"))
        .filter(|part| parts.has(part))
        .find(|part| parts.text(part).contains("(torus_R+meridian_r*COS("))
        .expect("annex 2");
    let text = parts.text(&part);
    let (at, tag) = text.match_indices("</f><v>").nth(12).expect("a formula");
    let (before, after) = text.split_at(at + tag.len());
    let (_, rest) = after.split_once('<').expect("the value's end");
    let spoilt = format!("{before}77<{rest}");
    let (same, told) = judged(&python, &[("spoilt".to_owned(), parts.put(&part, spoilt).zip())]);
    assert!(!same && told.contains(": 77.0 is ") && told.contains(", 1 differ,"), "{told}");
}

#[test]
fn no_formula_of_a_form_is_an_error_to_ironcalc() {
    let Some(python) = python() else { return };
    let forms: Vec<(String, Vec<u8>)> = common::cases()
        .enumerate()
        .map(|(at, (kind, case, language))| (format!("{at}-{}", case.name), written(kind, case, language)))
        .collect();
    let (same, told) = judged(&python, &forms);
    assert!(same, "{told}");
}
