//! What puts a program out of step with its part is told once, and not again in what follows from it.

use rodete::parameter::Value;

use super::bench::{Book, bilingual, build, lines, program, quantity, run};

const UNJUDGED: &str = "motions after this rejected block are not checked";

/// The findings of a workbook's build, and its exit code.
fn built(book: &Book) -> (Vec<String>, i32) {
    let (_folder, document, exit) = build(&book.bytes());
    bilingual(&document);
    (lines(&document), exit)
}

fn stops(found: &[String]) -> Vec<&str> {
    found.iter().map(String::as_str).filter(|line| line.starts_with("stop")).collect()
}

#[test]
fn a_system_whose_zero_is_not_filled_in_is_refused_once_with_its_cells() {
    let blocks = program("G55|G1 X48. F0.2|Z-10.|G56|Z-20.|G55|X60.");
    let (found, exit) = built(&Book::new(&blocks));
    assert_eq!(exit, 3);
    assert_eq!(
        stops(&found),
        [
            "stop PROGRAM!A12 the program uses G55, but W2 is empty in the workbook: DATA!C42, DATA!C43",
            "stop PROGRAM!A15 the program uses G56, but W3 is empty in the workbook: DATA!C44, DATA!C45",
        ]
    );
    assert!(found.contains(&format!("note PROGRAM!A12 {UNJUDGED}")), "{found:?}");
    // An X that is not given is 0, on the axis.
    let (found, _) = built(&Book::new(&program("G55|G1 X48. F0.2|G54")).put("W2_X", Value::Real(0.0)));
    assert_eq!(stops(&found), ["stop PROGRAM!A12 the program uses G55, but W2 is empty in the workbook: DATA!C43"]);
}

#[test]
fn a_zero_that_is_filled_in_or_set_by_the_program_is_none_to_refuse() {
    // W2 where W1 is.
    let zero = Value::Real(quantity(&build(&Book::new(&program("")).bytes()).1, "Z_W1"));
    let (found, exit) = built(&Book::new(&program("G55|G1 X48. F0.2|Z-10.|U6.|G54")).put("W2_Z", zero));
    assert_eq!((stops(&found), exit), (vec![], 0), "{found:?}");
    for set in ["G55 X0. Z0.", "G55|G50 X54. Z2."] {
        let (found, _) = built(&Book::new(&program(&format!("{set}|G1 X48. F0.2|Z-10.|U6.|G54"))));
        assert!(found.iter().all(|line| !line.contains("is empty")), "{set}: {found:?}");
    }
}

#[test]
fn without_a_workbook_only_the_first_system_has_a_zero() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.nc"), program("G55|G1 X48. F0.2|U6.").join("\n")).unwrap();
    let arguments = ["simulate", "p.nc", "--stock", "D50xL120", "--dialect", "fanuc-lathe-a", "--json"];
    let said = run(folder.path(), &arguments);
    let document = serde_json::from_str(&said.out).unwrap();
    bilingual(&document);
    let found = lines(&document);
    assert_eq!(stops(&found), ["stop 7 the program uses G55, but without a workbook the place of W2 is not known"]);
    assert_eq!(said.exit, 3);
    // With one that has no W2 its cells are named.
    std::fs::write(folder.path().join("tools.xlsx"), Book::new(&program("")).bytes()).unwrap();
    let said = run(folder.path(), &[&arguments[..], &["--tools", "tools.xlsx"]].concat());
    let found = lines(&serde_json::from_str(&said.out).unwrap());
    assert_eq!(stops(&found), ["stop 7 the program uses G55, but W2 is empty in the workbook: DATA!C42, DATA!C43"]);
}

#[test]
fn a_refused_block_is_told_once_and_raises_no_alarms_behind_it() {
    // The block stands in the contour that G71 and G70 read; without it the contour is another.
    let blocks =
        "G71 U2. R0.5|G71 P10 Q30 U0.4 W0.1 F0.25|N10 G0 X20.|G1 X20,5 Z-3.|Z-30.|N30 X54.|G70 P10 Q30|G0 X40. Z-50.";
    let (found, exit) = built(&Book::new(&program(blocks)));
    assert_eq!(exit, 3);
    assert_eq!(stops(&found), ["stop PROGRAM!A14 character ',' is not allowed"], "{found:?}");
    assert_eq!(found.iter().filter(|line| line.ends_with(UNJUDGED)).count(), 1, "{found:?}");
    // What comes before it is judged.
    let (found, _) = built(&Book::new(&program("G0 X48. Z-10.|X54.|G1 X4,5|G0 X40.")));
    assert_eq!(stops(&found).len(), 3, "{found:?}");
    assert!(found.iter().any(|line| line.starts_with("stop PROGRAM!A11 101 ")), "{found:?}");
}

#[test]
fn a_second_program_is_not_judged_on_a_part_that_the_first_has_not_made() {
    let book = Book::new(&program("G1 X4,5")).second(&program("G0 X40. Z-20.|X54."));
    let (found, _) = built(&book);
    assert_eq!(stops(&found).len(), 1, "{found:?}");
    assert!(
        found.iter().any(|line| line.starts_with("note file the motions of this program are not checked")),
        "{found:?}"
    );
}
