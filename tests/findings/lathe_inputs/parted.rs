//! What is parted off by the last cut is the part.

use std::f64::consts::PI;

use calamine::{Data, Reader, Xlsx, open_workbook};

use super::bench::{Book, build, lines, program, quantity};

/// A pin of 26 by 30 mm, parted off the bar.
pub const PIN: &str =
    "G0 X38.|G1 Z-75. F0.2|U14.|G0 Z2.|X26.|G1 Z-75.|U26.|G0 Z2.|T0303|G0 X60. Z-33.|X30.|G1 X-0.6 F0.08|G0 X60.";

fn cylinder(diameter: f64, length: f64) -> f64 {
    PI / 4.0 * diameter * diameter * length
}

/// The least and the greatest of a column of the results' contour.
fn extent(path: &std::path::Path, column: usize) -> [f64; 2] {
    let mut book: Xlsx<_> = open_workbook(path).unwrap();
    let range = book.worksheet_range("Contour").unwrap();
    let numbers = range.rows().filter_map(|row| match row {
        [.., Data::Float(x), Data::Float(z)] => Some([*x, *z][column]),
        _ => None,
    });
    numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
}

#[test]
fn the_piece_that_falls_off_last_is_the_part() {
    let (folder, document, exit) = build(&Book::new(&program(PIN)).sharp().bytes());
    assert_eq!(exit, 0, "{:?}", lines(&document));
    assert!((quantity(&document, "V") - cylinder(26.0, 30.0)).abs() < 0.01, "{}", quantity(&document, "V"));
    assert!((quantity(&document, "V_t") - quantity(&document, "V")).abs() < 1e-6);
    let results = folder.path().join("out/part-results.xlsx");
    for (column, wanted) in [(0, [0.0, 26.0]), (1, [-30.0, 0.0])] {
        for (found, wanted) in extent(&results, column).into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-3, "{column}: {found} {wanted}");
        }
    }
}

#[test]
fn a_program_that_goes_on_cutting_makes_what_is_left() {
    let blocks = format!("{PIN}|Z5.|T0101|G0 X30. Z-34.|G1 X-1. F0.1");
    let (_folder, document, _) = build(&Book::new(&program(&blocks)).sharp().bytes());
    let [V, V_r, V_t] = ["V", "V_r", "V_t"].map(|symbol| quantity(&document, symbol));
    assert!((V + V_r + V_t - cylinder(50.0, 120.0)).abs() < 0.01, "{V} {V_r} {V_t}");
    assert!((V_t - cylinder(26.0, 30.0)).abs() < 0.01, "{V_t}");
}

#[test]
fn the_second_set_up_turns_the_parted_piece_round() {
    // Mirrored about the middle of the bar it lies between the jaws, from Z-120 to Z-90.
    let book = Book::new(&program(PIN)).sharp().second(&program("G0 X100."));
    let (folder, document, exit) = build(&book.bytes());
    let found = lines(&document);
    assert_eq!(exit, 0, "{found:?}");
    assert!(found.iter().any(|line| line.ends_with("the jaws close on X26 and hold 30 mm")), "{found:?}");
    let [left, right] = extent(&folder.path().join("out/part-results.xlsx"), 1);
    assert!((left + 120.0).abs() < 1e-3 && (right + 90.0).abs() < 1e-3, "{left} {right}");
}
