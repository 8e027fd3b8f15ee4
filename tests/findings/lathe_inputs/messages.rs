//! What is said, and what is advised, where the general word would not fit.

use rodete::parameter::Value;
use serde_json::Value as Json;

use super::bench::{Book, build, lines, program};

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
    assert!(remedy["en"].as_str().unwrap().ends_with("sheet TOOLS, column T"), "{remedy}");
    let remedy = &finding(&Book::new(&program("G43")), "is not known to rodete in the dialect")["remedy"];
    assert!(remedy["es"].as_str().unwrap().contains("la hoja DATOS"), "{remedy}");
    assert!(remedy["en"].as_str().unwrap().contains("the sheet DATA"), "{remedy}");
}

#[test]
fn who_hits_the_tailstock_is_told_to_withdraw_it() {
    let book = Book::new(&program("G0 Z20.|X10.")).put("tailstock", Value::Choice("yes"));
    let remedy = &finding(&book, "hits the tailstock")["remedy"];
    assert!(remedy["es"].as_str().unwrap().starts_with("retire el contrapunto"), "{remedy}");
    assert!(remedy["en"].as_str().unwrap().starts_with("withdraw the tailstock"), "{remedy}");
    let remedy = &finding(&Book::new(&program("G0 X56.|Z-95.")), "hits the jaws")["remedy"];
    assert!(remedy["en"].as_str().unwrap().starts_with("clamp the work farther out"), "{remedy}");
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
        assert_eq!((&found["count"], &found["data"]["more"]), (&times.into(), &(times - 1).into()), "{found}");
    }
}

#[test]
fn a_block_number_that_stands_twice_is_shown_in_its_cells() {
    // Head in A6 to A10; a row without a block, which is no line of the program: the cells are told, not the lines.
    let blocks = program("G71 U2. R1.||G71 P10 Q20|N10 G0 X30.|G1 Z-10. F.1|N20 X52.||N10 G0 X60.");
    let (_folder, document, exit) = build(&Book::new(&blocks).bytes());
    let stops: Vec<_> = lines(&document).into_iter().filter(|line| line.starts_with("stop")).collect();
    assert_eq!(
        (exit, stops),
        (3, vec!["stop PROGRAM!A13 PROGRAM!A14 PROGRAM!A18 two blocks have the number N10".to_owned()])
    );
    // In a subprogram's sheet, its cells.
    let lines_of = ["M97 P5", "M99", "N5 G0 X60.", "M99", "N5 G0 X61.", "M99"];
    let (_folder, document, _) = build(&Book::new(&program("M98 P0005")).subprogram("O0005", &lines_of).bytes());
    let stops: Vec<_> = lines(&document).into_iter().filter(|line| line.starts_with("stop")).collect();
    assert_eq!(stops, ["stop O0005!A6 O0005!A8 O0005!A10 two blocks have the number N5"]);
    // Of M99 in a subprogram's sheet, its cell there and those of the blocks in the program's.
    let blocks = program("M98 P0005|N5 G0 X60.|N5 G0 X61.");
    let (_folder, document, _) = build(&Book::new(&blocks).subprogram("O0005", &["G4 X1.", "M99 P5"]).bytes());
    let stops: Vec<_> = lines(&document).into_iter().filter(|line| line.starts_with("stop")).collect();
    assert_eq!(stops, ["stop O0005!A7 PROGRAM!A12 PROGRAM!A13 two blocks have the number N5"]);
}
