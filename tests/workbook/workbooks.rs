//! The shipped workbooks are, byte for byte, what the template writes with the values of their case.

use std::collections::BTreeSet;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use rodete::kinds::impeller::parameters as impeller;
use rodete::kinds::lathe::parameters as lathe;
use rodete::kinds::pipe::hole::parameters as hole;
use rodete::kinds::pipe::insert::parameters as insert;
use rodete::parameter::Form;
use rodete::text::Language;
use rodete::workbook::template;

/// File, kind, case and language of every shipped workbook.
const SHIPPED: [(&str, &Form, &str, Language); 7] = [
    ("impeller.xlsx", &impeller::FORM, "full", Language::En),
    ("impeller-tfg-2021.xlsx", &impeller::FORM, "tfg-2021", Language::Es),
    ("pipe-insert.xlsx", &insert::FORM, "square", Language::En),
    ("pipe-insert-3on4-2023.xlsx", &insert::FORM, "3on4-2023", Language::Es),
    ("pipe-hole.xlsx", &hole::FORM, "set-in", Language::En),
    ("lathe.xlsx", &lathe::FORM, "shaft", Language::En),
    ("lathe-blank-g85.xlsx", &lathe::FORM, "blank", Language::Es),
];

fn path(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("workbooks").join(file)
}

fn written(form: &'static Form, case: &str, language: Language) -> Vec<u8> {
    let case = form.cases.iter().find(|one| one.name == case).expect("the case is listed");
    let mut out = Cursor::new(Vec::new());
    template::write(form, &case.values(language), &(case.listed)(language), &case.note, language, &mut out)
        .expect("the template can be written");
    out.into_inner()
}

#[test]
fn shipped_workbooks_are_what_the_template_writes() {
    for (file, form, case, language) in SHIPPED {
        let shipped = std::fs::read(path(file)).expect("the workbook is there");
        assert!(
            shipped == written(form, case, language),
            "workbooks/{file} differs from the template: write it again with \
             `cargo test --test workbook workbooks -- --ignored`"
        );
    }
}

#[test]
#[ignore = "writes the shipped workbooks again; run it after a change to the form or the template"]
fn write_shipped_workbooks() {
    for (file, form, case, language) in SHIPPED {
        std::fs::write(path(file), written(form, case, language)).expect("the workbook can be written");
    }
}

#[test]
fn a_new_workbook_has_the_same_bytes_every_time() {
    for (_, form, case, language) in SHIPPED {
        assert!(written(form, case, language) == written(form, case, language));
    }
}

#[test]
fn every_defined_name_is_allowed_and_unique_ignoring_case() {
    for form in [&impeller::FORM, &insert::FORM, &hole::FORM] {
        let mut seen = BTreeSet::new();
        for (_, parameter) in form.parameters() {
            rust_xlsxwriter::check_name(parameter.name).expect("a name that a workbook allows");
            assert!(seen.insert(parameter.name.to_lowercase()), "{} is given twice", parameter.name);
        }
    }
}

#[test]
fn a_new_workbook_is_an_input_with_the_values_of_its_case() {
    for (_, form, case, language) in SHIPPED {
        let filled = rodete::workbook::read(&written(form, case, language), &[form]).expect("a sound workbook");
        let case = form.cases.iter().find(|one| one.name == case).expect("the case is listed");
        assert_eq!(filled.values.values.into_iter().collect::<Vec<_>>(), {
            let mut values = case.values(language);
            values.sort_by_key(|(key, _)| *key);
            values
        });
        assert!(filled.findings.is_empty(), "{:?}", filled.findings);
    }
}
