//! Sheets that were put in and then renamed, hidden, deleted, edited, or are no longer made.

use rodete::finding::Exit;
use rodete::graft::Host;
use rodete::kinds::KINDS;
use rodete::workbook::names::Role;

use super::common::workbook::Parts;
use super::made::{Results, book, differing, host, parts, said, values, with_form};

const BOOK: &str = "xl/workbook.xml";

fn built() -> (Vec<u8>, Results) {
    let formed = with_form(KINDS[0], &book("h1.xlsx"));
    let results = Results::of(&formed);
    (results.put_into(&formed), results)
}

/// The name of the sheet of results of a key.
fn named(results: &Results, key: &str) -> String {
    results.made.iter().find(|one| one.role == Role::Result(key.to_owned())).expect("the sheet").name.clone()
}

#[test]
fn a_sheet_that_was_renamed_is_found_again_and_keeps_its_name() {
    let (built, results) = built();
    let name = named(&results, "summary");
    let renamed = Parts::of(&built)
        .replace(BOOK, &format!("name=\"{name}\""), "name=\"Mi resumen\"")
        .replace(BOOK, &format!("&apos;{name}&apos;!"), "&apos;Mi resumen&apos;!")
        .zip();
    let again = Results::of(&renamed);
    assert_eq!(named(&again, "summary"), "Mi resumen");
    let after = again.put_into(&renamed);
    assert_eq!(host(&after).present().taken, host(&renamed).present().taken);
    assert_eq!(values(&after, again.sheets()), values(&again.bytes, again.sheets()));
}

#[test]
fn a_sheet_that_was_hidden_stays_hidden() {
    let (built, results) = built();
    let name = named(&results, "summary");
    let from = format!("name=\"{name}\"");
    let hidden = Parts::of(&built).replace(BOOK, &from, &format!("{from} state=\"hidden\"")).zip();
    let after = Results::of(&hidden).put_into(&hidden);
    let sheets = rodete::workbook::gate(&after).expect("a book").sheets;
    assert!(sheets.iter().any(|one| one.name == name && one.hidden));
}

#[test]
fn a_sheet_that_was_deleted_is_made_anew() {
    let (built, results) = built();
    let name = named(&results, "summary");
    let text = Parts::of(&built).text(BOOK);
    let at = text.find(&format!("<sheet name=\"{name}\"")).expect("the sheet");
    let end = at + text[at..].find("/>").expect("its end") + 2;
    let sheets = rodete::workbook::gate(&built).expect("a book").sheets;
    let index = sheets.iter().position(|one| one.name == name).expect("the sheet");
    // The sheets behind it move up, and so do the numbers of their own names.
    let mut less = format!("{}{}", &text[..at], &text[end..]);
    less = less.replace(&format!("&apos;{name}&apos;!$A$1"), "#REF!");
    for number in index + 1..sheets.len() {
        less = less.replace(&format!("localSheetId=\"{number}\""), &format!("localSheetId=\"{}\"", number - 1));
    }
    let deleted = Parts::of(&built).put(BOOK, less).zip();
    let again = Results::of(&deleted);
    let after = again.put_into(&deleted);
    assert_eq!(host(&after).present().taken.last(), Some(&name));
    assert_eq!(values(&after, again.sheets()), values(&again.bytes, again.sheets()));
}

#[test]
fn a_sheet_that_no_longer_looks_like_ours_is_not_replaced() {
    let (built, results) = built();
    let part = "xl/worksheets/rodete-summary.xml";
    let other = Parts::of(&built).replace(part, ">Results<", ">My own page<").zip();
    let refused = Host::open(&other).expect_err("another title");
    assert_eq!(refused.exit, Exit::Refused);
    assert!(said(&refused).starts_with("B0111 the sheet \"SUMMARY\""), "{}", said(&refused));
    // Nor one that the mark no longer leads to.
    let name = named(&results, "summary");
    let mark = format!("&apos;{name}&apos;!$A$1");
    let moved = Parts::of(&built).replace(BOOK, &mark, "'Hoja de gráfico'!$A$1").zip();
    let refused = Host::open(&moved).expect_err("another sheet");
    assert!(said(&refused).starts_with("B0111"), "{}", said(&refused));
    // openpyxl deletes a sheet and leaves its mark: that counts as a sheet that is gone.
    let gone = Parts::of(&built).replace(BOOK, &mark, "'nowhere'!$A$1").zip();
    assert!(!host(&gone).present().ours.contains_key("summary"));
}

#[test]
fn a_sheet_that_is_no_longer_made_is_emptied_and_filled_again() {
    let (first, mut results) = built();
    let all = results.made.clone();
    let place = results.made.iter().position(|one| one.role == Role::Result("charts".to_owned())).expect("charts");
    let left = results.made.remove(place).name;
    let less = results.put_into(&first);
    let sheets = |bytes: &[u8]| host(bytes).present();
    assert_eq!(sheets(&less).taken, sheets(&first).taken, "none is removed");
    let (_, range) = values(&less, std::iter::once(left.as_str())).remove(0);
    assert_eq!(range.get_size(), (1, 1), "one line is left");
    assert!(parts(&less).keys().all(|part| !part.contains("charts/rodete")), "its charts are gone");
    results.made = all;
    let full = results.put_into(&less);
    assert_eq!(differing(&parts(&first), &parts(&full)), ["[Content_Types].xml"]);
}

#[test]
fn formulas_of_the_engineer_over_our_sheets_go_on_working() {
    let (built, _) = built();
    let part = "xl/worksheets/sheet3.xml";
    let cell = "<sheetData><row r=\"1\"><c r=\"A1\"><f>SUMMARY!A1&amp;torus_R</f><v>0</v></c></row></sheetData>";
    let own = Parts::of(&built).replace(part, "<sheetData/>", cell).zip();
    let after = Results::of(&own).put_into(&own);
    assert_eq!(parts(&own)[part], parts(&after)[part]);
    assert_eq!(host(&own).present().ours, host(&after).present().ours);
}
