//! The guard in a workbook of somebody else's: it watches the form and the lists where they stand and as they are written.

use calamine::Data;
use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::text::Language;
use rodete::workbook::guard;

use super::common::workbook::{Parts, written};
use super::libreoffice::{libreoffice, saved};
use super::made::{Results, read, values};

fn kind(name: &str) -> &'static dyn Kind {
    *KINDS.iter().find(|kind| kind.form().kind == name).expect("a kind")
}

/// The part of a sheet of a book that the library wrote.
fn part(parts: &Parts, sheet: &str) -> String {
    let listed = parts.text("xl/workbook.xml");
    let (before, _) = listed.split_once(&format!("<sheet name=\"{sheet}\"")).expect("the sheet");
    format!("xl/worksheets/sheet{}.xml", before.matches("<sheet name=").count() + 1)
}

/// A cell with what is typed: a text after `'`, nothing, or a number.
fn typed(book: &[u8], sheet: &str, address: &str, text: &str) -> Vec<u8> {
    let parts = Parts::of(book);
    let part = part(&parts, sheet);
    let cell = match text.strip_prefix('\'') {
        Some(text) => {
            format!("<c r=\"{address}\" t=\"inlineStr\"><is><t xml:space=\"preserve\">{text}</t></is></c>")
        }
        None if text.is_empty() => String::new(),
        None => format!("<c r=\"{address}\"><v>{text}</v></c>"),
    };
    parts.cell(&part, address, &cell).zip()
}

/// The cell of an input.
fn cell(book: &[u8], key: &str) -> String {
    read(book).values.cells[key].cell.clone()
}

/// A book with an input of its form typed otherwise.
fn input(book: &[u8], key: &str, text: &str) -> Vec<u8> {
    typed(book, "DATA", &cell(book, key), text)
}

/// A book with the results of its own form.
fn built(book: &[u8]) -> (Vec<u8>, String) {
    let results = Results::of(book);
    let guard = results.sheets().find(|name| name.starts_with(guard::SHEET)).expect("the guard").to_owned();
    (results.put_into(book), guard)
}

/// What `check` names as changed.
fn changed(book: &[u8]) -> Option<String> {
    read(book).stale.map(|finding| finding.what.en.into_owned())
}

/// What is typed into a lathe's workbook after the build: sheet and cell are what `check` names.
const EDITS: [(&str, &str, &str); 6] = [
    ("TOOLS", "F7", "12.8"),
    ("TOOLS", "F8", "9.525000001"),
    ("PROGRAM", "A8", "'N10 G50 S2600"),
    ("PROGRAM", "A7", ""),
    // Below the last block, and on a list that was empty.
    ("PROGRAM", "A58", "'N900 G0 X100."),
    ("PROGRAM 2", "A6", "'G0 X1."),
];

#[test]
fn check_sees_every_change_of_a_list_in_the_owners_workbook() {
    let lathe = kind("lathe");
    let book = written(lathe, &lathe.cases()[0], Language::En);
    // A gap in a program stays where its owner left it.
    let book = typed(&book, "PROGRAM", "A56", "'M30");
    let (built, _) = built(&book);
    assert_eq!(changed(&built), None);
    for (sheet, address, text) in EDITS {
        let told = changed(&typed(&built, sheet, address, text)).unwrap_or_default();
        assert!(told.contains(&format!("were made: {sheet} ({address})")), "{sheet}!{address} = {text}: {told}");
    }
}

/// Inputs as a person writes them: other capitals, blanks, a date as a spreadsheet holds it.
fn as_typed() -> Vec<u8> {
    let impeller = kind("impeller");
    let case = impeller.cases().iter().find(|case| case.name == "full").expect("the case");
    let book = written(impeller, case, Language::En);
    let book = input(&book, "splitters", "'Yes");
    let book = input(&book, "style", "'FULL");
    let book = input(&book, "part", "' My part ");
    dated(&book, 46349)
}

/// What is typed otherwise without another meaning: symbol and text. The banner compares the cells, and so does `check`.
const SPELLINGS: [(&str, &str); 4] =
    [("splitters", "'yes"), ("style", "'FULL "), ("part", "'My part"), ("distance", "'g91")];

#[test]
fn another_spelling_is_a_change_as_the_banner_says() {
    let (built, _) = built(&as_typed());
    for (symbol, text) in SPELLINGS {
        let told = changed(&input(&built, symbol, text)).unwrap_or_default();
        assert!(told.contains(&format!("were made: {symbol};")), "{symbol} = {text}: {told}");
    }
}

/// A book with a day as a spreadsheet holds it: a number in a cell formatted as a date.
fn dated(book: &[u8], day: u32) -> Vec<u8> {
    let parts = Parts::of(book);
    let styles = parts.text("xl/styles.xml");
    let (head, rest) = styles.split_once("<cellXfs count=\"").expect("the formats");
    let (count, rest) = rest.split_once('"').expect("their number");
    let format = "<xf numFmtId=\"14\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\" applyNumberFormat=\"1\"/>";
    let more: usize = count.parse::<usize>().expect("a number") + 1;
    let styles =
        format!("{head}<cellXfs count=\"{more}\"{}", rest.replacen("</cellXfs>", &format!("{format}</cellXfs>"), 1));
    let date = cell(book, "date");
    let date_cell = format!("<c r=\"{date}\" s=\"{count}\"><v>{day}</v></c>");
    let part = part(&parts, "DATA");
    parts.put("xl/styles.xml", styles).cell(&part, &date, &date_cell).zip()
}

#[test]
fn inputs_as_a_person_writes_them_are_verified_until_they_change() {
    let book = as_typed();
    assert_eq!(read(&book).values.values["date"], rodete::parameter::Value::Line("2026-11-23".into()));
    let (built, _) = built(&book);
    assert_eq!(changed(&built), None);
    let told = changed(&input(&built, "N", "3")).expect("a change");
    assert!(told.contains("were made: N;"), "{told}");
}

#[test]
fn a_spreadsheet_finds_no_change_after_the_build_and_each_one_later() {
    if !libreoffice() {
        return;
    }
    let lathe = kind("lathe");
    let book = typed(&written(lathe, &lathe.cases()[0], Language::En), "PROGRAM", "A56", "'M30");
    let (turned, guard) = built(&book);
    let (cut, of_cut) = built(&as_typed());
    let mut books = vec![("turned".to_owned(), turned.clone(), 0.0, guard.clone())];
    for (at, (sheet, address, text)) in EDITS.into_iter().enumerate() {
        books.push((format!("edit-{at}"), typed(&turned, sheet, address, text), 1.0, guard.clone()));
    }
    books.push(("number-as-text".to_owned(), typed(&turned, "TOOLS", "F7", "'12.7"), 1.0, guard));
    books.push(("cut".to_owned(), cut.clone(), 0.0, of_cut.clone()));
    books.push(("other-word".to_owned(), input(&cut, "splitters", "'yes"), 1.0, of_cut.clone()));
    books.push(("other-day".to_owned(), dated(&cut, 46350), 1.0, of_cut));
    let given: Vec<(&str, Vec<u8>)> = books.iter().map(|(name, bytes, ..)| (name.as_str(), bytes.clone())).collect();
    for (bytes, (name, _, wanted, guard)) in saved(&given).iter().zip(&books) {
        let sheets = values(bytes, std::iter::once(guard.as_str()));
        let count = sheets[0].1.get_value((0, 2)).cloned();
        assert_eq!(count, Some(Data::Float(*wanted)), "{name}");
    }
}
