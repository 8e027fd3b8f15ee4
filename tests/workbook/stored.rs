//! What a form stores with its formulas: what LibreOffice computes, for the values as they are written.

use crate::common::workbook::Parts;
use crate::libreoffice::libreoffice;
use crate::live::{Book, place_of, range, recalculated};

use std::collections::BTreeMap;
use std::io::Cursor;

use calamine::{Data, Reader, Xlsx, open_workbook_from_rs};
use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::parameter::{Case, Value};
use rodete::text::{Language, t};
use rodete::workbook::template;

/// What LibreOffice keeps of a number in its file.
const TOLERANCE: f64 = 1e-12;

/// A form with other values in place of some of a case's, or none in place of them.
fn form(kind: &dyn Kind, case: &Case, language: Language, changes: &[(&'static str, Option<Value>)]) -> Vec<u8> {
    let mut values = case.values(language);
    values.retain(|(key, _)| changes.iter().all(|(changed, _)| changed != key));
    values.extend(changes.iter().filter_map(|(key, value)| Some((*key, value.clone()?))));
    let mut out = Cursor::new(Vec::new());
    template::write(kind, &values, &(case.listed)(language), &t("", ""), language, &mut out).expect("a form");
    out.into_inner()
}

/// A form by its kind, its case and what is changed of that.
type Changed = (&'static dyn Kind, &'static Case, Vec<(&'static str, Option<Value>)>);

/// Every shipped form; each kind's with nothing but the schema; and some that are wrong, each in another way.
fn all() -> Vec<Changed> {
    let mut forms: Vec<Changed> = Vec::new();
    for kind in KINDS {
        forms.extend(kind.cases().iter().map(|case| (*kind, case, Vec::new())));
        let case = &kind.cases()[0];
        let empty = case.values(Language::En).iter().map(|(key, _)| (*key, None)).collect();
        forms.push((*kind, case, empty));
    }
    let mut wrong = |kind: &str, case: &str, changes: &[(&'static str, Option<Value>)]| {
        let kind = *KINDS.iter().find(|one| one.form().kind == kind).expect("a kind");
        let case = kind.cases().iter().find(|one| one.name == case).expect("a case");
        forms.push((kind, case, changes.to_vec()));
    };
    let line = |text: &str| Some(Value::Line(text.to_owned()));
    wrong("impeller", "full", &[("e", Some(Value::Real(11.0))), ("N", Some(Value::Whole(9)))]);
    wrong("impeller", "full", &[("R", Some(Value::Real(10.0))), ("start_codes", line("M3 hello"))]);
    wrong("impeller", "full", &[("retract", line("G1 X")), ("F", None), ("S", None)]);
    wrong("impeller", "clear", &[("e", Some(Value::Real(11.0))), ("B_min", Some(Value::Real(200.0)))]);
    wrong("pipe-insert", "square", &[("branch_schedule", None), ("D_branch", Some(Value::Real(88.9)))]);
    wrong("pipe-insert", "square", &[("e", Some(Value::Real(200.0))), ("branch_size", Some(Value::Choice("1/8")))]);
    wrong("pipe-hole", "set-in", &[("gamma", Some(Value::Real(44.0))), ("hold_on", line("M10"))]);
    wrong("lathe", "shaft", &[("L4", Some(Value::Real(400.0))), ("BX_min", Some(Value::Real(5.0)))]);
    forms
}

/// The forms that are asked in a language: of each kind every second one.
fn forms(language: Language) -> Vec<(String, Vec<u8>)> {
    let mut counts = BTreeMap::new();
    let mut turn = |(kind, ..): &Changed| {
        let count: &mut usize = counts.entry(kind.form().kind).or_default();
        *count += 1;
        Language::ALL[*count % Language::ALL.len()] == language
    };
    let of = |(kind, case, changes): Changed| {
        (format!("{} {} {changes:?}", kind.form().kind, case.name), form(kind, case, language, &changes))
    };
    all().into_iter().filter(|one| turn(one)).map(of).collect()
}

/// The sheets of a form with their parts.
fn sheets(parts: &Parts) -> Vec<(String, String)> {
    let listed = parts.text("xl/workbook.xml");
    let names = listed.split("<sheet name=\"").skip(1).filter_map(|one| one.split_once('"'));
    let part = |(at, (name, _)): (usize, (&str, &str))| {
        (name.to_owned(), parts.text(&format!("xl/worksheets/sheet{}.xml", at + 1)))
    };
    names.enumerate().map(part).collect()
}

/// What is not the same in a cell.
fn differs(stored: &Data, computed: &Data) -> bool {
    match (stored, computed) {
        (Data::Float(one), Data::Float(other)) => (one - other).abs() > TOLERANCE * one.abs().max(1.0),
        (Data::Empty, Data::String(text)) | (Data::String(text), Data::Empty) => !text.is_empty(),
        _ => stored != computed,
    }
}

#[test]
fn a_form_stores_with_every_formula_what_libreoffice_computes() {
    for language in Language::ALL {
        let mut forms = forms(language);
        for (name, bytes) in &forms {
            let parts = Parts::of(bytes);
            for (sheet, xml) in sheets(&parts) {
                let bare = xml.split("<c r=\"").find(|cell| cell.contains("<f>") && !cell.contains("</f><v>"));
                assert_eq!(bare, None, "{name}, {sheet}: nothing is stored");
            }
            let chart = parts.text("xl/charts/chart1.xml");
            for series in chart.split("<c:ptCount val=\"").skip(1) {
                let (count, series) = series.split_once('"').expect("a count");
                let points = series.split("</c:numCache>").next().expect("its end").matches("<c:pt ").count();
                assert_eq!(points.to_string(), count, "{name}: points of a series");
            }
        }
        if !libreoffice() {
            continue;
        }
        // Were nothing computed, a wrong value would stay.
        let wrong = Parts::of(&forms[0].1).text("xl/worksheets/sheet1.xml");
        let (before, after) = wrong.split_once("</f><v>").expect("a formula");
        let (_, after) = after.split_once("</v>").expect("its end");
        let wrong = format!("{before}</f><v>7</v>{after}");
        let wrong = Parts::of(&forms[0].1).put("xl/worksheets/sheet1.xml", wrong).zip();
        let sound = std::mem::replace(&mut forms[0].1, wrong);
        let folder = tempfile::tempdir().expect("a folder");
        let files: Vec<(String, Vec<u8>)> =
            forms.iter().enumerate().map(|(at, (_, bytes))| (format!("form-{at}"), bytes.clone())).collect();
        let some = files.chunks(24).flat_map(|some| recalculated(folder.path(), language == Language::Es, some));
        let computed: Vec<Book> = some.collect();
        forms[0].1 = sound;
        let mut compared = 0;
        for ((name, bytes), mut computed) in forms.iter().zip(computed) {
            let mut stored: Xlsx<_> = open_workbook_from_rs(Cursor::new(bytes.clone())).expect("the form");
            for (sheet, xml) in sheets(&Parts::of(bytes)) {
                let stored = stored.worksheet_range(&sheet).expect("a sheet");
                let computed = range(&mut computed, &sheet);
                for cell in xml.split("<c r=\"").skip(1).filter(|cell| cell.contains("<f>")) {
                    let place = place_of(cell.split('"').next().expect("an address"));
                    let [one, other] =
                        [&stored, &computed].map(|range| range.get_value(place).cloned().unwrap_or(Data::Empty));
                    let address = cell.split('"').next().expect("an address");
                    assert!(!differs(&one, &other), "{name}, {sheet}!{address}: {one:?}, LibreOffice {other:?}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 12_000, "{compared} cells only");
    }
}
