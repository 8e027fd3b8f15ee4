//! The shipped workbooks are, byte for byte, what the template writes with the values of their case.

use std::collections::BTreeSet;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::parameter::Case;
use rodete::text::Language;
use rodete::workbook::template;

use crate::common;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("workbooks")
}

/// The names of the shipped workbooks.
fn names() -> BTreeSet<String> {
    let entries = std::fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").file_name());
    entries.map(|name| name.into_string().expect("a name")).filter(|name| name.ends_with(".xlsx")).collect()
}

/// Every case of every kind with the workbook that is shipped of it: the usual one in English, as `pipe-hole.xlsx`, the
/// others, which are published ones, in Spanish. Their names go on with that of the case, as `lathe-blank-g85.xlsx`.
fn shipped() -> Vec<(String, &'static dyn Kind, &'static Case, Language)> {
    let (mut shipped, there) = (Vec::new(), names());
    for (kind, name) in KINDS.iter().map(|kind| (*kind, kind.form().kind)) {
        for (number, case) in kind.cases().iter().enumerate() {
            let begin = format!("{name}-{}", case.name);
            let file = there.iter().find(|file| file.starts_with(&begin)).filter(|_| number > 0).cloned();
            let usual = if number == 0 { format!("{name}.xlsx") } else { format!("{begin}.xlsx") };
            let language = if number == 0 { Language::En } else { Language::Es };
            shipped.push((file.unwrap_or(usual), kind, case, language));
        }
    }
    shipped
}

fn written(kind: &dyn Kind, case: &Case, language: Language) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    let (values, lists) = (case.values(language), (case.listed)(language));
    template::write(kind.form(), &values, &lists, &case.note, language, &mut out).expect("the template can be written");
    out.into_inner()
}

#[test]
fn every_case_of_every_kind_is_shipped_as_the_template_writes_it_and_nothing_else_is() {
    for (file, kind, case, language) in shipped() {
        let shipped = std::fs::read(folder().join(&file)).unwrap_or_default();
        assert!(
            shipped == written(kind, case, language),
            "workbooks/{file} differs from the template: write it again with \
             `cargo test --test workbook write_shipped -- --ignored`"
        );
    }
    assert_eq!(shipped().into_iter().map(|(file, ..)| file).collect::<BTreeSet<_>>(), names());
}

#[test]
#[ignore = "writes the shipped workbooks again; run it after a change to the form or the template"]
fn write_shipped_workbooks() {
    for (file, kind, case, language) in shipped() {
        std::fs::write(folder().join(file), written(kind, case, language)).expect("the workbook can be written");
    }
}

#[test]
fn a_new_workbook_has_the_same_bytes_every_time() {
    for (kind, case, language) in common::cases() {
        assert!(written(kind, case, language) == written(kind, case, language));
    }
}

#[test]
fn every_defined_name_is_allowed_and_unique_ignoring_case() {
    for kind in KINDS {
        let mut seen = BTreeSet::new();
        for (_, parameter) in kind.form().parameters() {
            rust_xlsxwriter::check_name(parameter.name).expect("a name that a workbook allows");
            assert!(seen.insert(parameter.name.to_lowercase()), "{} is given twice", parameter.name);
        }
    }
}

#[test]
fn a_new_workbook_is_an_input_with_the_values_of_its_case() {
    let forms: Vec<_> = KINDS.iter().map(|kind| kind.form()).collect();
    for (kind, case, language) in common::cases() {
        let filled = rodete::workbook::read(&written(kind, case, language), &forms).expect("a sound workbook");
        assert_eq!(filled.form.schema, kind.form().schema);
        assert_eq!(filled.values.values, case.values(language).into_iter().collect());
        assert!(filled.findings.is_empty(), "{:?}", filled.findings);
    }
}
