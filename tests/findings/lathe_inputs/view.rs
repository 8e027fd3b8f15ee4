//! `view` of a lathe workbook and of a turning program: the metal that goes, and why it does not.

use std::fs;

use rodete::parameter::Value;
use rodete::text::Language;

use super::bench::{Book, program, run};
use super::parted::PIN;

const TURNS: &str = "G0 X46.|G1 Z-20. F0.2|U8.|G0 Z2.";

/// The page that a command wrote, and its exit code.
fn page(folder: &std::path::Path, arguments: &[&str], name: &str) -> (String, i32) {
    let said = run(folder, arguments);
    (fs::read_to_string(folder.join(name)).unwrap_or_else(|_| panic!("{}", said.err)), said.exit)
}

fn turned(page: &str) -> bool {
    page.contains("\"turning\":{\"stock\"")
}

#[test]
fn a_lathe_workbook_is_shown_with_the_metal_going() {
    let folder = tempfile::tempdir().unwrap();
    let book = Book::new(&program(TURNS)).second(&program(TURNS));
    fs::write(folder.path().join("part.xlsx"), book.bytes()).unwrap();
    let (page, exit) = page(folder.path(), &["view", "part.xlsx"], "part.html");
    assert_eq!(exit, 0);
    assert_eq!(page.matches("\"turning\":{\"stock\"").count(), 2);
    assert!(page.contains("Program of the second set-up") && page.contains("G1 Z-20. F0.2"));
}

#[test]
fn the_turrets_body_is_shown_with_its_tools_where_it_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let shown = |book: Book| {
        fs::write(folder.path().join("part.xlsx"), book.bytes()).unwrap();
        page(folder.path(), &["view", "part.xlsx"], "part.html").0
    };
    let body = [("BX_min", -30.0), ("BX_max", 60.0), ("BZ_min", -45.0), ("BZ_max", 50.0)];
    let given = body.into_iter().fold(Book::new(&program(TURNS)), |book, (key, size)| book.put(key, Value::Real(size)));
    // About T1, whose tip stands 60 mm from the reference point along X and 40 mm along Z.
    let drawn = "\"turret\":[[[-5.0,30.0],[90.0,30.0],[90.0,120.0],[-5.0,120.0]]]";
    assert!(shown(given).contains(drawn));
    let empty = shown(Book::new(&program(TURNS)));
    assert!(!empty.contains(drawn) && empty.contains("\"turret\":[]"));
}

#[test]
fn a_rapid_motion_along_both_axes_bends_where_each_axis_keeps_its_rate() {
    let folder = tempfile::tempdir().unwrap();
    let bends = |path: &'static str| {
        let book = Book::new(&program(TURNS)).put("rapid", Value::Choice(path));
        fs::write(folder.path().join("part.xlsx"), book.bytes()).unwrap();
        let (page, exit) = page(folder.path(), &["view", "part.xlsx"], "part.html");
        assert_eq!(exit, 0);
        !page.contains("\"bends\":\"\",\"bend_parts\":\"\"")
    };
    assert_eq!(["bent", "straight"].map(bends), [true, false]);
}

#[test]
fn a_workbook_that_an_alarm_stops_is_shown_with_the_alarm() {
    let folder = tempfile::tempdir().unwrap();
    let book = Book::new(&program("G0 X40. Z-10.|G0 X54."));
    fs::write(folder.path().join("part.xlsx"), book.bytes()).unwrap();
    let (page, exit) = page(folder.path(), &["view", "part.xlsx"], "part.html");
    assert_eq!(exit, 3);
    assert!(turned(&page) && page.contains("\"number\":101") && page.contains("Rapid motion through metal"));
}

#[test]
fn a_fault_in_a_cell_is_shown_at_its_block() {
    let folder = tempfile::tempdir().unwrap();
    let book = Book::new(&program("M98 P0005|G1 X")).subprogram("O0005", &["G1 Z", "M99"]);
    fs::write(folder.path().join("part.xlsx"), book.bytes()).unwrap();
    let (page, exit) = page(folder.path(), &["view", "part.xlsx"], "part.html");
    assert_eq!(exit, 3);
    // The blocks of the subprogram follow the nine of the program.
    for wanted in ["the number is missing", "\"line\":7,", "O0005:1: the number is missing", "\"line\":10,"] {
        assert!(page.contains(wanted), "{wanted}");
    }
}

#[test]
fn a_workbook_with_contradictions_is_not_shown() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("part.xlsx"), Book::new(&program(TURNS)).without("point").bytes()).unwrap();
    let said = run(folder.path(), &["view", "part.xlsx"]);
    assert_eq!((said.exit, said.out.as_str()), (3, ""));
    assert!(said.err.contains("sheet \"DATA\", cell C12"), "{}", said.err);
    assert!(!folder.path().join("part.html").exists());
}

#[test]
fn a_turning_program_is_shown_over_its_stock() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), program(TURNS).join("\n")).unwrap();
    fs::write(folder.path().join("part.xlsx"), Book::of(Language::En).bytes()).unwrap();
    let stock = |more: &[&str]| {
        let arguments = [&["view", "p.nc", "--dialect", "fanuc-lathe-a"], more].concat();
        let (page, exit) = page(folder.path(), &arguments, "p.html");
        assert_eq!(exit, 0, "{more:?}");
        assert!(turned(&page), "{more:?}");
        let at = page.find("\"stock\":").unwrap();
        page[at..at + 120].to_owned()
    };
    let [given, other, of_workbook] =
        [&["--stock", "D50xL120"][..], &["--stock", "D51xL120"], &["--tools", "part.xlsx"]].map(stock);
    assert!(given != other && given != of_workbook && other != of_workbook);
    stock(&[]);
    // Named or told: a T of four digits turns.
    let (page, exit) = page(folder.path(), &["view", "p.nc", "--stock", "D50xL120"], "p.html");
    assert_eq!(exit, 0);
    assert!(turned(&page));
}

#[test]
fn a_piece_that_is_parted_off_is_shown_and_said() {
    let folder = tempfile::tempdir().unwrap();
    for (blocks, wanted) in [(TURNS, false), (PIN, true)] {
        fs::write(folder.path().join("part.xlsx"), Book::new(&program(blocks)).bytes()).unwrap();
        let (page, exit) = page(folder.path(), &["view", "part.xlsx"], "part.html");
        assert_eq!(exit, 0, "{blocks}");
        assert_eq!(page.contains("The program parts the piece off"), wanted, "{blocks}");
        assert_eq!(page.contains("\"parted\":{\"motion\":"), wanted, "{blocks}");
    }
}

#[test]
fn a_subprogram_follows_a_program_whose_last_line_has_no_end() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), program("M98 P0007").join("\r")).unwrap();
    fs::write(folder.path().join("O0007.nc"), "O0007\nG0 X46.\nM99").unwrap();
    let (page, exit) = page(folder.path(), &["view", "p.nc", "--stock", "D50xL120"], "p.html");
    assert_eq!(exit, 0);
    assert!(page.contains("\"M30\",\"O0007\",\"G0 X46.\",\"M99\"]"), "the lines stand one below another");
}

#[test]
fn a_stock_for_what_is_not_turned_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("p.nc"), "G21 G90\nG0 X1\nM2\n").unwrap();
    fs::write(folder.path().join("part.xlsx"), Book::of(Language::En).bytes()).unwrap();
    for input in ["p.nc", "part.xlsx"] {
        for [option, value] in [["--stock", "D50xL120"], ["--tailstock", "no"]] {
            let said = run(folder.path(), &["view", input, option, value]);
            assert_eq!((said.exit, said.out.as_str()), (2, ""), "{input}");
            assert!(said.err.contains(&format!("{option} is for a turning program")), "{}", said.err);
        }
    }
    assert!(!folder.path().join("p.html").exists() && !folder.path().join("part.html").exists());
}
