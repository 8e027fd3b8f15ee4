//! The title block: every form has it, a workbook from before it is read as it was, and a date is one however it was typed.

use rodete::kinds::KINDS;
use rodete::parameter::title_block::{self, DATE};
use rodete::text::Language;

use crate::workbook::{DATA, Parts, impeller, row, sound};

#[test]
fn every_form_ends_its_first_sheet_with_the_title_block_and_asks_for_none_of_it() {
    for form in KINDS.iter().map(|kind| kind.form()) {
        let last = form.sheets[0].sections.last().expect("a section");
        assert!(last.parameters.iter().all(|one| title_block::holds(one) && !one.required), "{}", form.kind);
        assert_eq!(last.parameters.len(), title_block::PARAMETERS.len(), "{}", form.kind);
    }
}

#[test]
fn a_workbook_without_its_rows_is_read_as_before() {
    let whole = impeller(&sound(Language::En)).expect("a sound workbook");
    let bare = title_block::PARAMETERS
        .iter()
        .fold(Parts::sound(), |parts, parameter| parts.cell(DATA, &format!("A{}", row(parameter.key)), ""));
    let read = impeller(&bare.zip()).expect("a workbook of before");
    assert_eq!((read.values.values, read.findings), (whole.values.values, whole.findings));
}

#[test]
fn a_date_that_no_calendar_has_is_refused_and_named_with_its_cell() {
    for date in ["31/02/2026", "29/02/2026", "2026-02-30", "2026-13-01", "31 de febrero de 2026", "Feb 30, 2026"] {
        let refusal = impeller(&Parts::sound().string("date", date).zip()).expect_err(date);
        let [finding] = refusal.findings.as_slice() else { panic!("{date}: {:?}", refusal.findings) };
        assert_eq!(finding.code(), "W0540", "{date}");
        assert!(finding.what.es.contains(&format!("\"{date}\", un día que no existe")), "{}", finding.what.es);
        let cell = format!("C{}", row("date"));
        assert!(finding.remedy.es.starts_with(&format!("escriba en {cell} ")), "{}", finding.remedy.es);
        assert!(finding.remedy.en.starts_with(&format!("in {cell} write ")), "{}", finding.remedy.en);
    }
    for date in ["29/02/2028", "12/31/2026", "noviembre de 2026", "a determinar", "26-11-23"] {
        let filled = impeller(&Parts::sound().string("date", date).zip()).expect(date);
        assert_eq!(filled.values.line(&DATE), date);
    }
}

#[test]
fn a_date_is_a_text_or_a_cell_formatted_as_one() {
    let told = |parts: Parts| {
        let filled = impeller(&parts.zip()).expect("a sound workbook");
        assert!(filled.findings.is_empty(), "{:?}", filled.findings);
        filled.values.line(&DATE).to_owned()
    };
    assert_eq!(told(Parts::sound().string("date", " Nov 23rd, 2026 ")), "Nov 23rd, 2026");
    assert_eq!(told(Parts::sound().value("date", "t=\"d\"", "<v>2026-11-23T00:00:00</v>")), "2026-11-23");
    assert_eq!(told(dated("46349")), "2026-11-23");
}

/// A sound workbook with a number in the cell of the date, which is formatted as one.
fn dated(number: &str) -> Parts {
    let styles = Parts::sound().text("xl/styles.xml");
    let from = styles.find("<cellXfs").expect("cell formats");
    let to = styles[from..].find("</cellXfs>").expect("their end") + from;
    let formats = "<cellXfs count=\"2\"><xf numFmtId=\"0\"/><xf numFmtId=\"14\"/>";
    let parts = Parts::sound().replace("xl/styles.xml", &styles[from..to], formats);
    parts.value("date", "s=\"1\"", &format!("<v>{number}</v>"))
}

#[test]
fn a_number_that_is_no_day_is_refused_and_not_printed_as_the_nearest_one() {
    for (number, said) in [("60", "1900-02-29"), ("0", "0"), ("-5", "-5"), ("1E7", "10000000")] {
        let refusal = impeller(&dated(number).zip()).expect_err(number);
        let [finding] = refusal.findings.as_slice() else { panic!("{number}: {:?}", refusal.findings) };
        assert_eq!(finding.code(), "W0540", "{number}");
        assert!(finding.what.en.contains(&format!("\"{said}\", a day that no calendar has")), "{}", finding.what.en);
    }
}
