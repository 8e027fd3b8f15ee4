//! What puts a program out of step with its part is told once, and not again in what follows from it.

use rodete::parameter::Value;

use crate::bench::{Book, bilingual, build, lines, program, quantity, run};

const UNJUDGED: &str = "from this block on motions are not judged: their alarms would follow from it";

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
        found.iter().any(|line| line.starts_with("note file the motions of this program are not judged")),
        "{found:?}"
    );
}
