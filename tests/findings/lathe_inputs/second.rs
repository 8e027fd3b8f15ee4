//! The second set-up: the part turned round, a program of its own.

use std::f64::consts::PI;
use std::fs;

use calamine::{Data, Reader, Xlsx, open_workbook};
use rodete::parameter::Value;

use super::bench::{Book, build, lines, program, quantity};

const FIRST: &str = "G0 X40.|G1 Z-60. F0.2|U14.|G0 Z2.";
const SECOND: &str = "G0 Z10.|X44.|G1 Z-40. F0.2|U12.|G0 Z10.";

/// What is taken off a bar from one diameter to another along a length, mm³.
fn ring(from: f64, to: f64, length: f64) -> f64 {
    PI / 4.0 * (from * from - to * to) * length
}

fn near(value: f64, wanted: f64) {
    assert!((value - wanted).abs() < 0.01, "{value} {wanted}");
}

/// The corners of the contour of the results, X as a diameter.
fn corners(path: &std::path::Path) -> Vec<[f64; 2]> {
    let mut book: Xlsx<_> = open_workbook(path).unwrap();
    let range = book.worksheet_range("Contour").unwrap();
    let numbers = |row: &[Data]| match row {
        [.., Data::Float(x), Data::Float(z)] => Some([*x, *z]),
        _ => None,
    };
    range.rows().filter_map(numbers).collect()
}

#[test]
fn the_part_is_mirrored_about_the_middle_of_the_stock_and_shifted() {
    for shift in [0.0, -7.0, 5.0] {
        let book = Book::new(&program(FIRST)).sharp().second(&program(SECOND)).put("Z_s", Value::Real(shift));
        let (folder, document, exit) = build(&book.bytes());
        assert_eq!(exit, 0, "{:?}", lines(&document));
        // The bar's other end lies at Z = shift, and the neck of the first set-up from the chuck to Z = shift - 60.
        let removed = ring(50.0, 40.0, 60.0) + ring(50.0, 44.0, 40.0 + shift);
        near(quantity(&document, "V_r"), removed);
        near(quantity(&document, "V"), ring(50.0, 0.0, 120.0) - removed);
        let corners = corners(&folder.path().join("out/part-results.xlsx"));
        for wanted in [
            [44.0, shift],
            [44.0, -40.0],
            [50.0, -40.0],
            [50.0, shift - 60.0],
            [40.0, shift - 60.0],
            [40.0, shift - 120.0],
        ] {
            let there = corners.iter().any(|[x, z]| (x - wanted[0]).abs() < 1e-3 && (z - wanted[1]).abs() < 1e-3);
            assert!(there, "{wanted:?} {corners:?}");
        }
    }
}

#[test]
fn an_empty_shift_is_none() {
    let with = |book: Book| quantity(&build(&book.sharp().second(&program(SECOND)).bytes()).1, "V_r");
    let new = || Book::new(&program(FIRST));
    near(with(new()), with(new().put("Z_s", Value::Real(0.0))));
    assert!((with(new()) - with(new().put("Z_s", Value::Real(1.0)))).abs() > 100.0);
}

#[test]
fn both_programs_are_delivered_and_both_have_their_motions() {
    let book = Book::new(&program(FIRST)).second(&program(SECOND));
    let (folder, _, exit) = build(&book.bytes());
    assert_eq!(exit, 0);
    for (name, blocks) in [("part-program.nc", FIRST), ("part-program-2.nc", SECOND)] {
        let text = fs::read_to_string(folder.path().join("out").join(name)).unwrap();
        assert_eq!(text.lines().collect::<Vec<_>>(), program(blocks), "{name}");
    }
    let mut results: Xlsx<_> = open_workbook(folder.path().join("out/part-results.xlsx")).unwrap();
    for (sheet, block) in [("Motions", "G1 Z-60. F0.2"), ("Motions 2", "G1 Z-40. F0.2")] {
        let range = results.worksheet_range(sheet).unwrap();
        let cell = |text: &Data| *text == Data::String(block.to_owned());
        assert!(range.rows().any(|row| row.iter().any(cell)), "{sheet}");
    }
    assert!(results.worksheet_range("PROGRAM 2").is_ok());
}

#[test]
fn nothing_is_made_of_the_second_program_where_the_first_one_lacks_a_cycle() {
    let first = "G71 U0. R0.5|G71 P10 Q20 U0.5 F0.2|N10 G0 X30.|N20 G1 Z-40.";
    let second = program("G0 X40. Z10.|Z-10.|G5 X1.");
    let (_folder, document, exit) = build(&Book::new(&program(first)).second(&second).bytes());
    let stops: Vec<_> = lines(&document).into_iter().filter(|line| !line.starts_with("note")).collect();
    assert_eq!((exit, stops.len()), (3, 2), "{stops:?}");
    assert!(stops[0].starts_with("stop PROGRAM!") && stops[0].contains(" PS0062: "), "{stops:?}");
    assert!(stops[1].starts_with("stop PROGRAM 2!"), "{stops:?}");
}

#[test]
fn an_alarm_of_the_second_program_stands_in_its_own_sheet() {
    let second = program("G0 X40. Z-10.|G0 X54.|Z2.");
    let (_folder, document, exit) = build(&Book::new(&program(FIRST)).second(&second).bytes());
    assert_eq!(exit, 3);
    let stops: Vec<_> = lines(&document).into_iter().filter(|line| line.starts_with("stop")).collect();
    assert!(!stops.is_empty() && stops.iter().all(|stop| stop.starts_with("stop PROGRAM 2!A1")), "{stops:?}");
    assert!(
        stops.iter().any(|stop| stop.starts_with("stop PROGRAM 2!A11 101 Rapid motion through metal")),
        "{stops:?}"
    );
    assert_eq!(document["files"].as_array().unwrap().len(), 0);
}

#[test]
fn what_the_second_program_says_wrong_stands_in_its_own_sheet() {
    let (_folder, document, exit) = build(&Book::new(&program(FIRST)).second(&program("G0 X50|G1 X")).bytes());
    assert_eq!(exit, 3);
    let found = lines(&document);
    for wanted in
        ["stop PROGRAM 2!A12 the number is missing", "note PROGRAM 2!A11 dimensions without decimal point, read as mm"]
    {
        assert!(found.iter().any(|line| line == wanted), "{wanted} {found:?}");
    }
}

#[test]
fn the_second_set_up_takes_away_nothing_that_is_gone() {
    // The neck of 40 mm lies under the pass at 44 mm from Z -60 on.
    let book = Book::new(&program(FIRST)).sharp().second(&program("G0 X44.|G1 Z-80. F0.2|U12.|G0 Z2."));
    let (_folder, document, _) = build(&book.bytes());
    near(quantity(&document, "V_r"), ring(50.0, 40.0, 60.0) + ring(50.0, 44.0, 60.0));
}

/// The findings on how the jaws hold the part in the second set-up.
fn held(book: &Book) -> (Vec<String>, Vec<String>, i32) {
    let (_folder, document, exit) = build(&book.bytes());
    let (held, others) = lines(&document).into_iter().partition(|line| line.contains("second set-up"));
    (held, others, exit)
}

#[test]
fn the_jaws_close_on_what_is_left_of_the_part() {
    let new = || Book::new(&program(FIRST)).sharp().second(&program("G0 X100."));
    // Between the jaws, from Z-130 to Z-90, is the neck of 40 mm up to its end at Z-120.
    let (found, _, exit) = held(&new());
    assert_eq!(
        (found, exit),
        (vec!["note DATA!C53 DATA!C19 in the second set-up the jaws close on X40 and hold 30 mm".to_owned()], 0)
    );
    // At the end of the bar they hold 2 mm, and a part pushed out of them they do not hold.
    let (found, _, exit) = held(&new().put("Z_s", Value::Real(28.0)));
    assert_eq!(
        found,
        ["caution DATA!C53 DATA!C19 in the second set-up the jaws, closed on X40, hold hardly any length along Z"]
    );
    assert_eq!(exit, 0);
    let (found, _, exit) = held(&new().put("Z_s", Value::Real(29.5)));
    assert!(
        found[0].starts_with("stop DATA!C53 DATA!C19 in the second set-up the jaws, closed on X40, hold hardly"),
        "{found:?}"
    );
    assert_eq!(exit, 3);
    let (found, others, exit) = held(&new().put("Z_s", Value::Real(500.0)));
    assert_eq!(
        found,
        ["stop DATA!C53 DATA!C19 in the second set-up there is no metal between the jaws: nothing holds the part"]
    );
    assert_eq!(exit, 3);
    assert!(!others.iter().any(|line| line.starts_with("stop")), "what follows is not judged: {others:?}");
}

/// What a program would cut of a part that nothing holds is no part of what comes out.
#[test]
fn nothing_is_derived_from_a_shift_that_is_refused() {
    let book = || Book::new(&program(FIRST)).sharp().second(&program(SECOND));
    let (_folder, document, exit) = build(&book().put("Z_s", Value::Real(29.5)).bytes());
    assert_eq!(exit, 3);
    near(quantity(&document, "V_r"), ring(50.0, 40.0, 60.0));
    let alone = build(&Book::new(&program(FIRST)).sharp().bytes()).1;
    for symbol in ["t", "t_c", "V", "a_p"] {
        near(quantity(&document, symbol), quantity(&alone, symbol));
    }
    let (_folder, held, exit) = build(&book().put("Z_s", Value::Real(5.0)).bytes());
    assert_eq!(exit, 0);
    assert!(quantity(&held, "V_r") > quantity(&document, "V_r") + 1000.0);
}

#[test]
fn collisions_are_judged_with_the_jaws_where_they_close() {
    // The neck is 40 mm wide and 100 long: the jaws, from X40 to X120 in front of Z-90, are closed farther in than on the bar.
    let first = program("G0 X46.|G1 Z-80. F0.2|U8.|G0 Z2.|X42.|G1 Z-80.|U12.|G0 Z2.");
    let at = |z: f64, jaws: f64| {
        let second = program(&format!("G0 X{}. Z5.|G1 Z{z} F0.2|G0 X100.", jaws));
        held(&Book::new(&first).second(&second).put("Z_s", Value::Real(0.0))).1
    };
    // At X46 a tool that goes past the jaws' face would have passed under jaws open at 50 mm.
    let through = at(-91.0, 46.0);
    assert!(through.iter().any(|line| line.contains(" 112 ")), "{through:?}");
    let short = at(-88.0, 46.0);
    assert!(!short.iter().any(|line| line.contains(" 112 ")), "{short:?}");
}
