//! The shipped workbooks are, byte for byte, what the template writes with the values of their case.

use std::collections::BTreeSet;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::parameter::{Case, Parameter};
use rodete::text::Language;
use rodete::workbook::template;

use crate::common;
use crate::common::workbook::{written, written_with_variants};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("workbooks")
}

/// The names of the shipped workbooks.
fn names() -> BTreeSet<String> {
    let entries = std::fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").file_name());
    let names = entries.map(|name| name.into_string().expect("a name"));
    names.filter(|name| name.ends_with(".xlsx") && !name.ends_with(VARIANTS)).collect()
}

/// How the names of workbooks with a sheet of variants end.
const VARIANTS: &str = "-sweep.xlsx";

/// The kinds of which a workbook with variants is shipped, in English.
fn with_variants() -> Vec<(String, Vec<u8>)> {
    let kinds = KINDS.iter().filter(|kind| ["impeller", "pipe-insert"].contains(&kind.form().kind));
    kinds.map(|kind| (format!("{}{VARIANTS}", kind.form().kind), written_with_variants(*kind, Language::En))).collect()
}

#[test]
fn workbooks_with_variants_are_shipped_as_new_writes_them() {
    for (file, bytes) in with_variants() {
        let shipped = std::fs::read(folder().join(&file)).unwrap_or_default();
        assert!(shipped == bytes, "workbooks/{file} differs from what `rodete new --sweep` writes");
    }
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
    for (file, bytes) in with_variants() {
        std::fs::write(folder().join(file), bytes).expect("the workbook can be written");
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

/// The XML of a part of a package.
fn part(bytes: &[u8], name: &str) -> String {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).expect("a package");
    let mut xml = String::new();
    archive.by_name(name).expect("the part").read_to_string(&mut xml).expect("text");
    xml
}

/// Words of the sketches that are no symbols of a form, yet the same in both languages.
const WORDS: [&str; 3] = ["M", "W1", "φ = 0"];

#[test]
fn every_symbol_of_a_sketch_is_one_of_its_form() {
    for kind in KINDS {
        let sketch = kind.sketch().expect("a sketch");
        let (form, mut symbols) = (kind.form(), BTreeSet::new());
        for label in &sketch.labels {
            let text = &label.text;
            if text.es != text.en || WORDS.contains(&&*text.en) {
                continue;
            }
            let symbol = text.en.trim_start_matches("⌀ ").trim_start_matches("2·π·");
            assert!(form.parameters().any(|(_, one)| one.symbol() == symbol), "{kind:?}: {symbol}");
            symbols.insert(symbol.to_owned());
        }
        assert!(symbols.len() >= 10, "{kind:?}: {symbols:?}");
        assert!(sketch.strokes.iter().flat_map(|one| &one.points).flatten().all(|one| one.is_finite()), "{kind:?}");
    }
}

#[test]
fn the_sketch_is_drawn_beside_the_form_in_its_own_size() {
    for (kind, case, language) in common::cases() {
        let sketch = kind.sketch().expect("a sketch");
        let xml = part(&written(kind, case, language), "xl/drawings/drawing1.xml");
        let (mut reader, mut ids, mut words) = (quick_xml::Reader::from_str(&xml), BTreeSet::new(), Vec::new());
        loop {
            match reader.read_event().expect("well-formed") {
                quick_xml::events::Event::Eof => break,
                quick_xml::events::Event::Start(tag) | quick_xml::events::Event::Empty(tag)
                    if tag.name().as_ref() == "xdr:cNvPr" =>
                {
                    let id = tag.try_get_attribute("id").expect("attributes").expect("an id").value.into_owned();
                    assert!(ids.insert(id), "an id twice in {kind:?}");
                }
                quick_xml::events::Event::Text(text) => words.push(text.into_owned()),
                _ => {}
            }
        }
        assert!(xml.contains("<xdr:oneCellAnchor>") && !xml.contains("twoCellAnchor"), "{kind:?}");
        assert_eq!(xml.matches("<xdr:grpSp>").count(), 1);
        assert!(ids.len() > sketch.strokes.len() + sketch.labels.len(), "{kind:?}");
        for line in sketch.labels.iter().flat_map(|label| label.text.get(language).lines()) {
            let line = line.replace('>', "&gt;");
            assert!(xml.contains(&format!("<a:t>{line}</a:t>")), "{kind:?}: {line}");
        }
    }
}

/// Every row of a sheet: its number, whether it folds, and whether it is hidden.
fn rows(xml: &str) -> Vec<(usize, bool, bool)> {
    let tags = xml.split("<row r=\"").skip(1).map(|rest| rest.split('>').next().unwrap_or_default());
    let number = |tag: &str| tag.split('"').next().and_then(|number| number.parse().ok()).expect("a number");
    tags.map(|tag| (number(tag), tag.contains("outlineLevel=\"1\""), tag.contains("hidden=\"1\""))).collect()
}

#[test]
fn groups_fold_and_only_those_that_are_optional_and_empty_come_folded() {
    for (kind, case, language) in common::cases() {
        let (form, values) = (kind.form(), case.values(language));
        let bytes = written(kind, case, language);
        let xml = part(&bytes, "xl/worksheets/sheet1.xml");
        assert!(xml.contains("summaryBelow=\"0\""), "the sign does not stand at the heading");
        // A spreadsheet does not fold on a protected sheet.
        assert!(!xml.contains("<sheetProtection"));
        let layout = &template::layouts(form, &case.note, language).expect("a layout")[0];
        let found = rows(&xml);
        let sheet = &form.sheets[0];
        for section in sheet.sections {
            let empty = section.parameters.iter().all(|one| !values.iter().any(|(key, _)| *key == one.key));
            for parameter in section.parameters {
                let (_, row) = layout.names.iter().find(|(name, _)| *name == parameter.name).expect("a row");
                let (_, folds, hidden) =
                    found.iter().find(|(number, ..)| *number == *row as usize + 1).expect("the row is there");
                assert!(folds, "{kind:?}: {} does not fold", parameter.key);
                assert_eq!(*hidden, section.optional && empty, "{kind:?}: {}", parameter.key);
            }
            assert!(!section.optional || section.parameters.iter().all(|one| !one.required), "{kind:?}");
        }
        let inputs: usize = sheet.sections.iter().map(|section| section.parameters.len()).sum();
        assert_eq!(found.iter().filter(|(_, folds, _)| *folds).count(), inputs, "{kind:?}: headings do not fold");
    }
}

#[test]
fn an_optional_cell_says_what_it_is_when_it_stays_empty() {
    let told = |parameter: &Parameter, language: Language, words: &[&str]| {
        let note = rodete::workbook::validation::range_and_note(parameter, language).to_lowercase();
        words.iter().any(|word| note.contains(word))
    };
    let optional = KINDS.iter().flat_map(|kind| kind.form().parameters()).filter(|(_, one)| !one.required);
    let silent: BTreeSet<&str> = optional
        .filter(|(_, one)| {
            !told(one, Language::Es, &["vacía", "vacío", "vacías"]) || !told(one, Language::En, &["empty"])
        })
        .map(|(_, one)| one.symbol())
        .collect();
    assert_eq!(silent, BTreeSet::new());
}
