//! The turret's body and the spindle's way of a tool, from the workbook: what is told, and its near twin in silence.
//!
//! The bar of D 50 stands 90 mm out of the jaws, its face at Z0; the jaws go from Z−130 to Z−90 and up to r 65, the chuck to r
//! 125 behind them. The tip of T1 stands 60 mm from the reference point along X and 40 mm along Z.

use rodete::parameter::Value;
use rodete::text::Language;

use super::bench::{Book, bilingual, blocks, build, lines, program};
use super::workbook::Parts;

const KEYS: [&str; 4] = ["BX_min", "BX_max", "BZ_min", "BZ_max"];

/// The program of these blocks with the turret's body.
fn with(body: [f64; 4], lines: &str) -> Book {
    let book = Book::new(&program(lines));
    KEYS.into_iter().zip(body).fold(book, |book, (key, size)| book.put(key, Value::Real(size)))
}

/// The numbers of the alarms that stop, each once.
fn stops(book: &Book) -> Vec<String> {
    let (_folder, document, exit) = build(&book.bytes());
    let mut found: Vec<String> = lines(&document)
        .iter()
        .filter_map(|line| line.strip_prefix("stop "))
        .map(|line| line.split(' ').nth(1).unwrap_or_default().to_owned())
        .collect();
    found.sort();
    found.dedup();
    assert_eq!(exit, if found.is_empty() { 0 } else { 3 }, "{:?}", lines(&document));
    found
}

#[test]
fn the_turrets_body_is_told_from_what_stands_beside_it() {
    let none: [&str; 0] = [];
    // Facing to the middle the body comes as near to the axis as it stands behind the tip, 20 mm to its left.
    let face = "G0 Z-0.5|G1 X0. F0.1|G0 Z2.|X54.";
    assert_eq!(stops(&with([-40.0, 100.0, -60.0, 50.0], face)), ["104"]);
    assert_eq!(stops(&with([-34.9, 100.0, -60.0, 50.0], face)), none);
    // Above the jaws, 80 mm to the left of the tip.
    let left = |z: &str| format!("G1 Z{z} F0.2|G0 Z2.");
    assert_eq!(stops(&with([10.0, 100.0, -120.0, 50.0], &left("-51."))), ["117"]);
    assert_eq!(stops(&with([10.0, 100.0, -120.0, 50.0], &left("-50."))), none);
    // Below their top, 40 mm to the left.
    assert_eq!(stops(&with([-30.0, 100.0, -80.0, 50.0], &left("-51."))), ["118"]);
    assert_eq!(stops(&with([-30.0, 100.0, -80.0, 50.0], &left("-50."))), none);
    // Over the quill of r 30, 50 mm to the right of a tip at r 32.
    let over = ["T0101", "G0 X64. Z2.", "G0 X100. Z50.", "M30"].map(str::to_owned);
    let supported = |low: f64| with([low, 100.0, 10.0, 60.0], "").program(&over).put("tailstock", Value::Choice("yes"));
    assert_eq!(stops(&supported(-63.0)), ["119"]);
    assert_eq!(stops(&supported(-61.9)), none);
}

#[test]
fn the_shipped_program_goes_with_a_body_that_its_tools_stand_out_of() {
    let book = Book::of(Language::En);
    let body = KEYS.into_iter().zip([-30.0, 150.0, -40.0, 150.0]);
    let book = body.fold(book, |book, (key, size)| book.put(key, Value::Real(size)));
    let (_folder, document, exit) = build(&book.bytes());
    assert_eq!(exit, 0, "{:?}", lines(&document));
    assert!(lines(&document).iter().all(|line| line.starts_with("note")), "{:?}", lines(&document));
}

#[test]
fn a_body_is_given_whole_or_not_at_all() {
    let book = with([-30.0, 100.0, -40.0, 50.0], "G4 X1.").without("BX_max").without("BZ_min");
    let (_folder, document, exit) = build(&book.bytes());
    let wanted = "stop DATA!C38 DATA!C39 the turret's body needs all four sizes; missing: BX_max, BZ_min".to_owned();
    assert_eq!((lines(&document), exit), (vec![wanted], 3));
    bilingual(&document);
    let (_folder, document, exit) = build(&with([100.0, 100.0, 50.0, -40.0], "G4 X1.").bytes());
    let wanted = [
        "stop DATA!C37 DATA!C38 BX_min is 100; it must be less than BX_max = 100",
        "stop DATA!C39 DATA!C40 BZ_min is 50; it must be less than BZ_max = -40",
    ];
    assert_eq!((lines(&document), exit), (wanted.map(str::to_owned).to_vec(), 3));
    bilingual(&document);
}

#[test]
fn the_cell_m_says_which_way_a_tool_cuts_and_the_alarm_names_it() {
    // A left-hand groover in front: face up with M3 unless its cell says that it lies face down.
    let groove = |spindle: &str, cell: Option<&'static str>| {
        let all = ["G50 S2500", "T0303", &format!("G97 S800 {spindle}"), "M8", "G0 X54. Z-20.", "G1 X46. F0.06"];
        let all = all.into_iter().chain(["G0 X54.", "G0 X100. Z50.", "M30"]).map(str::to_owned).collect::<Vec<_>>();
        Book::of(Language::En).list(blocks("program", "", &all)).change("tools", |rows| {
            rows[2].values.insert("tools/hand", Value::Choice("L"));
            if let Some(cell) = cell {
                rows[2].values.insert("tools/M", Value::Choice(cell));
            }
        })
    };
    let none: [&str; 0] = [];
    for (spindle, cell, wanted) in [
        ("M3", None, &none[..]),
        ("M4", None, &["154"]),
        ("M3", Some("M3"), &none),
        ("M4", Some("M3"), &["154"]),
        ("M3", Some("M4"), &["154"]),
        ("M4", Some("M4"), &none),
    ] {
        assert_eq!(stops(&groove(spindle, cell)), wanted, "{spindle} {cell:?}");
    }
    let (_folder, document, _) = build(&groove("M4", None).bytes());
    let stop = document["findings"].as_array().unwrap().iter().find(|one| one["grade"] == "stop").unwrap();
    for (language, cell, sheet) in [("es", "celda M", "HERRAMIENTAS"), ("en", "cell M", "TOOLS")] {
        let remedy = stop["remedy"][language].as_str().unwrap();
        assert!(remedy.contains(cell) && remedy.contains(sheet), "{remedy}");
    }
}

#[test]
fn a_workbook_without_the_cells_of_the_body_and_the_column_m_is_read_as_before() {
    let old = |book: &Book| {
        let mut parts = Parts::of(&book.bytes());
        for row in 36..=40 {
            for column in ["A", "B", "C", "D", "E"] {
                parts = parts.cell("xl/worksheets/sheet1.xml", &format!("{column}{row}"), "");
            }
        }
        for row in 3..=30 {
            parts = parts.cell("xl/worksheets/sheet2.xml", &format!("Q{row}"), "");
        }
        parts
    };
    for language in Language::ALL {
        let book = Book::of(language);
        let parts = old(&book);
        let data = parts.text("xl/worksheets/sheet1.xml");
        assert!(!data.contains("r=\"A37\"") && data.contains("r=\"A35\""), "the rows are gone");
        assert!(!parts.text("xl/worksheets/sheet2.xml").contains("r=\"Q5\""), "the column is gone");
        let (folder, document, exit) = build(&parts.zip());
        assert_eq!(exit, 0, "{:?}", lines(&document));
        let (new, again, _) = build(&book.bytes());
        assert_eq!((&document["quantities"], lines(&document)), (&again["quantities"], lines(&again)));
        let stl = |folder: &tempfile::TempDir| std::fs::read(folder.path().join("out/part-part.stl")).unwrap();
        assert_eq!(stl(&folder), stl(&new));
    }
}
