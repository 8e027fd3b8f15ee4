//! A surface that another edge takes away again (132), where the part is turned about: told of the first program where its mark
//! is on the part when the second one has ended, and of the second where it is the second that takes a surface away.

use std::fs;

use calamine::{Data, Reader, Xlsx, open_workbook};
use rodete::parameter::Value;

use super::bench::{Book, build, lines, program, run};

/// A land of 48 mm up to Z-60, and down from it at 45° in A13: from there the mark goes back, rising 5°, to Z-52.7. Turned about
/// it lies between Z-67.3 and Z-59, behind the neck.
const FIRST: &str = "G0 X48.|G1 Z-60. F0.2|X46.6 Z-61.5|Z-80.|U8.|G0 Z2.";

/// The programs' blocks told of with 132, as `PROGRAM!A13`, and the build's exit code.
fn told(book: &Book) -> (Vec<String>, i32) {
    let (folder, document, exit) = build(&book.bytes());
    let found = lines(&document);
    let marks: Vec<&String> = found.iter().filter(|line| line.contains(" 132 ")).collect();
    // As often in the alarms' table as among the findings.
    let results = folder.path().join("out/part-results.xlsx");
    if results.exists() {
        let mut results: Xlsx<_> = open_workbook(results).unwrap();
        let range = results.worksheet_range("Alarms").unwrap();
        let rows =
            range.rows().filter(|row| row.contains(&Data::Float(132.0)) || row.contains(&Data::Int(132))).count();
        assert_eq!(rows, marks.len(), "{marks:?}");
    }
    let place = |line: &&String| line.strip_prefix("caution ").unwrap().split(" 132").next().unwrap().to_owned();
    (marks.iter().map(place).collect(), exit)
}

fn of(second: &str) -> (Vec<String>, i32) {
    told(&Book::new(&program(FIRST)).second(&program(second)))
}

fn places(places: &[&str]) -> (Vec<String>, i32) {
    (places.iter().map(|place| (*place).to_owned()).collect(), 0)
}

#[test]
fn a_mark_that_the_second_program_takes_away_is_not_told() {
    assert_eq!(told(&Book::new(&program(FIRST))), places(&["PROGRAM!A13"]));
    // Past the whole of it, 0.3 mm below.
    assert_eq!(of("G0 X46.|G1 Z-70. F0.2|U8.|G0 Z10."), places(&[]));
}

#[test]
fn a_mark_that_the_second_program_leaves_is_told_once_at_the_first_ones_block() {
    for second in ["G0 X100.", "G0 X44.|G1 Z-40. F0.2|U12.|G0 Z10."] {
        assert_eq!(of(second), places(&["PROGRAM!A13"]), "{second}");
    }
}

#[test]
fn a_mark_of_which_the_second_program_takes_a_part_is_told() {
    for second in ["G0 X46.|G1 Z-62. F0.2|U8.|G0 Z10.", "G0 X46.9|G1 Z-70. F0.2|U8.|G0 Z10."] {
        assert_eq!(of(second), places(&["PROGRAM!A13"]), "{second}");
    }
}

#[test]
fn a_mark_goes_with_the_part_as_far_as_it_is_shifted() {
    let shifted =
        |second: &str| told(&Book::new(&program(FIRST)).second(&program(second)).put("Z_s", Value::Real(8.0)));
    assert_eq!(shifted("G0 Z10.|X46.|G1 Z-62. F0.2|U8.|G0 Z10."), places(&[]));
}

#[test]
fn a_surface_of_the_first_program_that_the_second_takes_away_with_another_edge_is_told_of_the_second() {
    // A land without a mark; turned about, the second tool goes down from it at Z-60.
    let first = program("G0 X48.|G1 Z-80. F0.2|U8.|G0 Z2.");
    let second = |blocks: &str| told(&Book::new(&first).second(&program(blocks)));
    assert_eq!(second("G0 X48.|G1 Z-60. F0.2|X46.6 Z-61.5|Z-75.|U8.|G0 Z10."), places(&["PROGRAM 2!A13"]));
    // As flat as the edge leans nothing of the land goes.
    assert_eq!(second("G0 X48.|G1 Z-60. F0.2|X46.6 Z-76.|U8.|G0 Z10."), places(&[]));
}

/// As [`FIRST`], of a pin of 26 mm with its mark from Z-50 back, parted off at Z-70: it lies between Z-120 and Z-50 then, and its
/// mark between Z-77.3 and Z-69.
const PINNED: &str = "G0 X38.|G1 Z-80. F0.2|U14.|G0 Z2.|X28.|G1 Z-80.|U24.|G0 Z2.|X26.|G1 Z-50.|X24.6 Z-51.5|Z-80.|U28.|G0 Z2.|\
    T0303|G0 X60. Z-73.|X30.|G1 X-0.6 F0.08|G0 X60.";
/// Its block that leaves the mark.
const DOWN: &str = "PROGRAM!A21";

#[test]
fn a_mark_on_a_parted_piece_is_told_until_the_second_program_has_taken_all_of_it() {
    let after = |second: &str| told(&Book::new(&program(PINNED)).second(&program(second)));
    assert_eq!(told(&Book::new(&program(PINNED))), places(&[DOWN]));
    assert_eq!(after("G0 X100."), places(&[DOWN]));
    assert_eq!(after("G0 X60. Z-48.|X24.|G1 Z-72. F0.2|U40.|G0 Z10."), places(&[DOWN]));
    assert_eq!(after("G0 X60. Z-48.|X24.|G1 Z-80. F0.2|U40.|G0 Z10."), places(&[]));
}

/// The same program, and it goes on: the part is what stays in the chuck, and its end turned about.
fn rest(second: &str) -> (Vec<String>, i32) {
    let first = format!("{PINNED}|Z5.|T0101|G0 X44. Z-70.|G1 Z-85. F0.2|U10.|G0 Z5.");
    told(&Book::new(&program(&first)).second(&program(second)).put("Z_s", Value::Real(-60.0)))
}

#[test]
fn a_mark_on_what_is_not_turned_about_is_told_whatever_the_second_program_does() {
    assert_eq!(rest("G0 X60. Z-58.|X40.|G1 Z-75. F0.2|U20.|G0 Z10."), places(&[DOWN]));
}

#[test]
fn what_a_refused_block_left_undone_may_have_taken_the_mark_away() {
    assert_eq!(of("G5 X1.|G0 X100."), (Vec::new(), 3));
    // Of what did not go on there is no doubt.
    assert_eq!(rest("G5 X1.|G0 X100."), (vec![DOWN.to_owned()], 3));
}

#[test]
fn a_mark_of_the_first_programs_subprogram_is_told_in_its_cell_and_shown_with_the_first_program() {
    let book = Book::new(&program("G0 X48.|G1 Z-60. F0.2|M98 P0005|Z-80.|U8.|G0 Z2."))
        .subprogram("O0005", &["X46.6 Z-61.5", "M99"])
        .second(&program("G0 X100."));
    let (found, _) = told(&book);
    assert!(found.len() == 1 && found[0].starts_with("O0005!A"), "{found:?}");
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("part.xlsx"), book.bytes()).unwrap();
    assert_eq!(run(folder.path(), &["view", "part.xlsx"]).exit, 0);
    let page = fs::read_to_string(folder.path().join("part.html")).unwrap();
    let (shown, second) = (page.find("\"number\":132").unwrap(), page.find("Program of the second set-up").unwrap());
    assert!(shown < second && page.matches("\"number\":132").count() == 1);
    // The subprogram's first block follows the thirteen of the program.
    assert!(
        page[shown.saturating_sub(400)..shown + 400].contains("\"line\":14,"),
        "{}",
        &page[shown - 400..shown + 400]
    );
    let motions = |sheet: &str| {
        let (folder, ..) = build(&book.bytes());
        let mut results: Xlsx<_> = open_workbook(folder.path().join("out/part-results.xlsx")).unwrap();
        let range = results.worksheet_range(sheet).unwrap();
        let row = range.rows().find(|row| row.last() == Some(&Data::String("132".to_owned())));
        row.map(|row| row.iter().any(|cell| *cell == Data::String("X46.6 Z-61.5".to_owned())))
    };
    assert_eq!([motions("Motions"), motions("Motions 2")], [Some(true), None]);
}
