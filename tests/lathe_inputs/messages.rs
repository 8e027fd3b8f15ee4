//! What is said, and what is advised, where the general word would not fit.

use rodete::parameter::Value;
use serde_json::Value as Json;

use crate::bench::{Book, build, lines, program};

/// The first finding whose English message has a text in it.
fn finding(book: &Book, text: &str) -> Json {
    let (_folder, document, _) = build(&book.bytes());
    let findings = document["findings"].as_array().unwrap();
    let found = findings.iter().find(|one| one["what"]["en"].as_str().unwrap().contains(text));
    found.unwrap_or_else(|| panic!("{text}: {:?}", lines(&document))).clone()
}

#[test]
fn a_remedy_names_what_a_workbook_has() {
    let unmounted = Book::new(&program("T0303")).change("tools", |rows| {
        rows[2].values.remove("tools/T");
    });
    let remedy = &finding(&unmounted, "tool 3 is not in the tool table")["remedy"];
    assert!(remedy["es"].as_str().unwrap().ends_with("hoja HERRAMIENTAS, columna T"), "{remedy}");
    assert!(remedy["en"].as_str().unwrap().ends_with("on the sheet TOOLS, column T"), "{remedy}");
    let remedy = &finding(&Book::new(&program("G199")), "does not exist in the dialect")["remedy"];
    assert!(remedy["es"].as_str().unwrap().contains("la hoja DATOS"), "{remedy}");
    assert!(remedy["en"].as_str().unwrap().contains("the sheet DATA"), "{remedy}");
}

#[test]
fn who_hits_the_tailstock_is_told_to_withdraw_it() {
    let book = Book::new(&program("G0 Z20.|X10.")).put("tailstock", Value::Choice("yes"));
    let remedy = &finding(&book, "hits the tailstock")["remedy"];
    assert!(remedy["es"].as_str().unwrap().starts_with("Retire el contrapunto"), "{remedy}");
    assert!(remedy["en"].as_str().unwrap().starts_with("Withdraw the tailstock"), "{remedy}");
    let remedy = &finding(&Book::new(&program("G0 X56.|Z-95.")), "hits the jaws")["remedy"];
    assert!(remedy["en"].as_str().unwrap().starts_with("Clamp the work farther out"), "{remedy}");
}

#[test]
fn an_alarm_that_comes_back_is_counted_in_words() {
    for (times, es, en) in
        [(2, "y otra vez en la línea", "and once more on the line"), (4, "y otras 3 veces", "and 3 more times")]
    {
        let blocks = program(&format!("G0 X56.|M98 P0005 L{times}"));
        let found = finding(&Book::new(&blocks).subprogram("O0005", &["G0 Z-95.", "Z2.", "M99"]), "11");
        let what = [&found["what"]["es"], &found["what"]["en"]].map(|text| text.as_str().unwrap());
        assert!(what[0].contains(es) && what[1].contains(en), "{times}: {what:?}");
    }
}
