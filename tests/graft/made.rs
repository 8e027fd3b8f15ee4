//! Books, what is put into them, and what they are compared by.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

use calamine::{Data, Range, Reader, Xlsx};
use rodete::finding::Refusal;
use rodete::graft::{Donor, Host};
use rodete::kind::{Kind, Outcome, Provenance, Wants};
use rodete::kinds::KINDS;
use rodete::parameter::Form;
use rodete::parameter::field::Fields;
use rodete::text::Language;
use rodete::workbook::names::{Made, Present, Role, quoted};
use rodete::workbook::{self, Filled, results, template};

use super::common::workbook::quick_of;

/// The hard books; `books/make.py` says what each has.
pub const BOOKS: [&str; 5] = ["h1.xlsx", "h2.xlsm", "h3.xlsx", "h4.xlsx", "h5.xlsx"];

pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/graft/books").join(name)
}

pub fn book(name: &str) -> Vec<u8> {
    std::fs::read(path(name)).expect("a hard book")
}

/// The parts of a package by their names.
pub fn parts(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).expect("a package");
    (0..archive.len())
        .map(|index| {
            let mut entry = archive.by_index(index).expect("an entry");
            let mut content = Vec::new();
            entry.read_to_end(&mut content).expect("its contents");
            (entry.name().expect("a name").into_owned(), content)
        })
        .collect()
}

pub fn forms() -> Vec<&'static Form> {
    KINDS.iter().map(|kind| kind.form()).collect()
}

pub fn read(bytes: &[u8]) -> Filled {
    workbook::read(bytes, &forms()).unwrap_or_else(|refusal| panic!("{}", said(&refusal)))
}

pub fn said(refusal: &Refusal) -> String {
    refusal.findings.iter().map(|one| format!("{} {}\n", one.code(), one.what.en)).collect()
}

pub fn host(bytes: &[u8]) -> Host<'_> {
    Host::open(bytes).unwrap_or_else(|refusal| panic!("{}", said(&refusal)))
}

/// A book with the form of a kind in it.
pub fn with_form(kind: &'static dyn Kind, bytes: &[u8]) -> Vec<u8> {
    let host = host(bytes);
    let (case, mut out) = (quick_of(kind), Cursor::new(Vec::new()));
    let (values, lists) = (case.values(Language::En), (case.listed)(Language::En));
    let made = template::write_into(kind, (&values, &lists, None), &case.note, Language::En, &host.present(), &mut out);
    let made = made.expect("a form");
    let donor = Donor { bytes: &out.into_inner(), sheets: &made, inputs: Vec::new(), source: "" };
    host.put(&donor).unwrap_or_else(|refusal| panic!("{}", said(&refusal)))
}

/// What came of a form.
pub fn outcome(filled: Filled) -> Outcome {
    let kind = KINDS.iter().find(|kind| kind.form().schema == filled.form.schema).expect("its kind");
    let source = Provenance { workbook: "book.xlsx".to_owned(), sha256: "0".repeat(64), version: "0.0.0" };
    let fields = Fields::of(filled.form, filled.values).expect("all that the form requires");
    kind.run(fields, filled.findings, source, Wants::default()).expect("an outcome")
}

/// Results as they are put into a book, with the sheets and the cells of the inputs.
pub struct Results {
    pub bytes: Vec<u8>,
    pub made: Vec<Made>,
    pub inputs: Vec<(&'static str, String)>,
}

impl Results {
    /// Those of the form that a book has.
    pub fn of(bytes: &[u8]) -> Self {
        let filled = read(bytes);
        let mut present: Present = host(bytes).present();
        present.copies = filled.copies.clone();
        let inputs = filled.form.parameters().filter_map(|(_, one)| {
            let cell = filled.values.cells.get(one.key)?;
            let digits = cell.cell.find(|one: char| one.is_ascii_digit())?;
            let (letters, digits) = cell.cell.split_at(digits);
            Some((one.name, format!("{}!${letters}${digits}", quoted(&cell.sheet))))
        });
        let inputs = inputs.collect();
        for (index, sheet) in filled.form.sheets.iter().enumerate() {
            let mut all = sheet.sections.iter().flat_map(|section| section.parameters);
            if let Some(cell) = all.find_map(|one| filled.values.cells.get(one.key)) {
                present.forms.insert(index, cell.sheet.clone());
            }
        }
        let mut out = Cursor::new(Vec::new());
        let outcome = outcome(filled);
        let made = results::write_into(&outcome, &[], results::Tables::Live, Language::En, &present, &mut out)
            .expect("results");
        Self { bytes: out.into_inner(), made, inputs }
    }

    pub fn donor(&self) -> Donor<'_> {
        Donor { bytes: &self.bytes, sheets: &self.made, inputs: self.inputs.clone(), source: "0" }
    }

    pub fn put_into(&self, bytes: &[u8]) -> Vec<u8> {
        host(bytes).put(&self.donor()).unwrap_or_else(|refusal| panic!("{}", said(&refusal)))
    }

    /// The names of the sheets that go in.
    pub fn sheets(&self) -> impl Iterator<Item = &str> {
        self.made.iter().filter(|one| one.role != Role::Form).map(|one| one.name.as_str())
    }
}

/// The values of sheets of a book.
pub fn values<'s>(bytes: &[u8], sheets: impl Iterator<Item = &'s str>) -> Vec<(String, Range<Data>)> {
    let mut book = Xlsx::new(Cursor::new(bytes)).expect("a workbook");
    sheets.map(|sheet| (sheet.to_owned(), book.worksheet_range(sheet).expect("a sheet"))).collect()
}

/// The parts of a book by what they are to a graft: those that keep their bytes.
pub fn kept(bytes: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let edited = |name: &str| {
        let name = name.to_lowercase();
        let own = name.contains("rodete-") || name.contains("calcchain");
        let lists = [
            "[content_types].xml",
            "styles.xml",
            "st%20yles.xml",
            "workbook.xml",
            "workbook.xml.rels",
            "main.part",
            "main.part.rels",
        ];
        own || lists.iter().any(|one| name.rsplit('/').next() == Some(one))
    };
    parts(bytes).into_iter().filter(|(name, _)| !edited(name)).collect()
}

/// Parts that are not the same, by name.
pub fn differing(before: &BTreeMap<String, Vec<u8>>, after: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let names: std::collections::BTreeSet<_> = before.keys().chain(after.keys()).collect();
    names.into_iter().filter(|name| before.get(*name) != after.get(*name)).cloned().collect()
}
