//! The guard of results and `check`: both compare cells as they are written.

use crate::common;
use crate::common::workbook::Parts;
use crate::libreoffice::libreoffice;
use crate::live::{cell_of, number, range, recalculated, with_on};

use std::io::Cursor;

use calamine::{Reader, Xlsx, open_workbook_from_rs};
use rodete::finding::{CellPlace, Place};
use rodete::kind::Kind;
use rodete::kinds::KINDS;
use rodete::parameter::Value;
use rodete::text::Language;
use rodete::workbook::guard::SHEET;
use rodete::workbook::results::{self, Tables};
use rodete::workbook::stamp;

fn results_of(kind: &str, case: &str) -> Vec<u8> {
    results_with(kind, case, Language::En, &[])
}

fn results_with(kind: &str, case: &str, language: Language, changes: &[(&'static str, Value)]) -> Vec<u8> {
    let kind: &'static dyn Kind = *KINDS.iter().find(|one| one.form().kind == kind).expect("a kind");
    let case = kind.cases().iter().find(|one| one.name == case).expect("a case");
    let outcome = common::outcome_of(kind, case, language, changes);
    let mut out = std::io::Cursor::new(Vec::new());
    results::write(&outcome, &[], Tables::Live, language, &mut out).expect("results");
    out.into_inner()
}

/// What `check` says was changed.
fn changed(bytes: &[u8]) -> Option<String> {
    let forms: Vec<_> = KINDS.iter().map(|kind| kind.form()).collect();
    rodete::workbook::read(bytes, &forms).expect("a form").stale.map(|stale| stale.what.en.into_owned())
}

/// What is spelt otherwise and means the same: the input, and what is typed into its cell.
const SPELLINGS: [(&str, &str, &str); 6] = [
    ("part", "part", "Impeller TFG 2021 "),
    ("material", "material", "Aluminium\u{a0}"),
    ("distance", "distance", "g91"),
    ("start_codes", "start_codes", "M3  M11 M13"),
    ("schema", "schema", "rodete-impeller 2 "),
    ("tol", "tip_tolerance_tol", " "),
];

fn text(text: &str) -> String {
    format!(" t=\"inlineStr\"><is><t xml:space=\"preserve\">{text}</t></is>")
}

#[test]
fn check_names_another_spelling_where_the_banner_is_red() {
    let impeller = results_of("impeller", "full");
    let lathe = results_of("lathe", "shaft");
    assert_eq!(changed(&impeller), None);
    assert_eq!(changed(&lathe), None);
    let mut books: Vec<(String, Vec<u8>)> = SPELLINGS
        .into_iter()
        .map(|(symbol, name, typed)| {
            (symbol.to_owned(), with_on(&impeller, "DATA", &cell_of(&impeller, name), &text(typed)))
        })
        .collect();
    let block = {
        let mut book: Xlsx<_> = open_workbook_from_rs(Cursor::new(lathe.clone())).expect("the results");
        let sheet = book.worksheet_range("PROGRAM").expect("the program");
        sheet.get_value((8, 0)).expect("a block").to_string()
    };
    books.push(("PROGRAM (A9)".to_owned(), with_on(&lathe, "PROGRAM", "A9", &text(&format!("{block} ")))));
    for (name, book) in &books {
        let told = changed(book).unwrap_or_default();
        assert!(told.contains(&format!("were made: {name}; out of date: ")), "{name}: {told}");
    }
    if !libreoffice() {
        return;
    }
    // Each input has a flag of its own: one book holds all spellings of the impeller's.
    let spelt = |book: Vec<u8>, (_, name, typed): (&str, &str, &str)| {
        with_on(&book, "DATA", &cell_of(&impeller, name), &text(typed))
    };
    let all = SPELLINGS.into_iter().fold(impeller.clone(), spelt);
    let (_, lathe) = books.pop().expect("the book of the lathe");
    let folder = tempfile::tempdir().expect("a folder");
    let files = [("impeller".to_owned(), all), ("lathe".to_owned(), lathe)];
    let mut computed = recalculated(folder.path(), false, &files);
    let sheets = [0, 1].map(|at| range(&mut computed[at], SHEET));
    for (_, name, typed) in SPELLINGS {
        let row = sheets[0].rows().find(|row| row[0] == *name).expect("the input's row");
        assert_eq!(number(row.get(2)), Some(1.0), "{name} {typed}");
    }
    assert_eq!(number(sheets[0].get_value((0, 2))), Some(6.0));
    assert_eq!(number(sheets[1].get_value((0, 2))), Some(1.0));
}

#[test]
fn an_input_that_cannot_be_read_is_named_with_the_others_that_were_changed() {
    let results = results_of("impeller", "full");
    let thicker = with_on(&results, "DATA", &cell_of(&results, "thickness_e"), "><v>2.2</v>");
    let spoilt = with_on(&thicker, "DATA", &cell_of(&results, "blades_N"), &text("4"));
    let forms: Vec<_> = KINDS.iter().map(|kind| kind.form()).collect();
    let refused = rodete::workbook::read(&spoilt, &forms).expect_err("N is a text");
    let told = |code: &str| {
        let found = refused.findings.iter().find(|finding| finding.code() == code);
        found.map(|finding| finding.what.en.clone().into_owned()).unwrap_or_default()
    };
    assert!(told("W0409").contains('N'), "{:?}", refused.findings);
    assert!(told("W0519").contains("were made: N, e; out of date: "), "{}", told("W0519"));
}

/// The part of a sheet.
fn part_of(parts: &Parts, sheet: &str) -> String {
    let listed = parts.text("xl/workbook.xml");
    let before = listed.split(&format!("<sheet name=\"{sheet}\"")).next().expect("a list of sheets");
    parts.text(&format!("xl/worksheets/sheet{}.xml", before.matches("<sheet name=").count() + 1))
}

/// A results workbook with a sheet of another one in place of its own, as somebody copies it beside or over the new one.
fn copied(book: &[u8], from: &[u8], sheet: &str) -> Vec<u8> {
    let (parts, other) = (Parts::of(book), Parts::of(from));
    let listed = parts.text("xl/workbook.xml");
    let before = listed.split(&format!("<sheet name=\"{sheet}\"")).next().expect("a list of sheets");
    let part = format!("xl/worksheets/sheet{}.xml", before.matches("<sheet name=").count() + 1);
    let text = other.text(&part);
    parts.put(&part, text).zip()
}

/// The sheets that `check` names as copies of another build.
fn of_another(bytes: &[u8]) -> Option<String> {
    stamp::others(bytes).expect("a workbook").map(|found| format!("{} {}", found.code(), found.what.en))
}

/// What a spreadsheet leaves when an input's cell is cut and pasted beside the form, and another number is typed where it was; and
/// when a row is put in between the headings of a list and its first row.
#[test]
fn an_input_that_was_moved_and_a_row_above_a_list_turn_the_line_red() {
    if !libreoffice() {
        return;
    }
    let results = results_of("impeller", "full");
    let cell = cell_of(&results, "thickness_e");
    let row = cell.trim_start_matches('C');
    let parts = Parts::of(&results);
    let listed = parts.text("xl/workbook.xml");
    let name = format!("<definedName name=\"thickness_e\">DATA!$C${row}<");
    assert!(listed.contains(&name), "{listed}");
    let led = |to: String| listed.replace(&name, &format!("<definedName name=\"thickness_e\">DATA!${to}<"));
    let moved = |to: &str, led: String| {
        let moved = with_on(&parts.put("xl/workbook.xml", led).zip(), "DATA", to, "><v>2</v>");
        with_on(&moved, "DATA", &cell, "><v>3</v>")
    };
    let beside = moved(&format!("D{row}"), led(format!("D${row}")));
    let lathe = results_of("lathe", "shaft");
    let parts = Parts::of(&lathe);
    let guard = part_of(&parts, SHEET);
    let above = guard.replace("-ROW(PROGRAM!$A$5)-1)", "-ROW(PROGRAM!$A$4)-1)");
    let aside = guard.replace("-COLUMN(TOOLS!$G$5))", "-COLUMN(TOOLS!$F$5))");
    assert_ne!(guard, aside, "{guard}");
    assert_ne!(guard, above, "{guard}");
    let listed = parts.text("xl/workbook.xml");
    let before = listed.split(&format!("<sheet name=\"{SHEET}\"")).next().expect("a list of sheets");
    let part = format!("xl/worksheets/sheet{}.xml", before.matches("<sheet name=").count() + 1);
    let files = [
        ("as built".to_owned(), results.clone(), 0.0),
        ("beside".to_owned(), beside, 1.0),
        ("list".to_owned(), lathe.clone(), 0.0),
        ("above".to_owned(), Parts::of(&lathe).put(&part, above).zip(), 1.0),
        ("aside".to_owned(), Parts::of(&lathe).put(&part, aside).zip(), 1.0),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    let books: Vec<_> = files.iter().map(|(name, book, _)| (name.clone(), book.clone())).collect();
    for ((name, _, wanted), mut book) in files.iter().zip(recalculated(folder.path(), false, &books)) {
        assert_eq!(number(range(&mut book, SHEET).get_value((0, 2))), Some(*wanted), "{name}");
    }
}

#[test]
fn a_sheet_of_another_build_says_so() {
    for (language, sheets, red, green) in [
        (
            Language::En,
            ["Annex 2", "DATA", "SUMMARY", "Findings"],
            "NOT VERIFIED: this sheet is not of the workbook's last build",
            "Verified inputs",
        ),
        (
            Language::Es,
            ["Anexo 2", "DATOS", "RESUMEN", "Avisos"],
            "NO VERIFICADO: esta hoja no es de la última generación del libro",
            "Datos verificados",
        ),
    ] {
        let results = |R| results_with("impeller", "full", language, &[("R", Value::Real(R))]);
        let (new, old) = (results(26.0), results(25.0));
        assert_eq!(of_another(&new), None);
        // Built again of the same inputs, a copy has the same figures.
        assert_eq!(of_another(&copied(&results(26.0), &new, sheets[0])), None);
        let mut mixed = new.clone();
        for sheet in sheets {
            let wanted = format!(
                "W0520 these sheets are not of the workbook's last build: {sheet}; their figures are of another one"
            );
            assert_eq!(of_another(&copied(&new, &old, sheet)), Some(wanted));
            mixed = copied(&mixed, &old, sheet);
        }
        // Nobody knows of which build a sheet is when the stamp is gone.
        let parts = Parts::of(&new);
        let listed = parts.text("xl/workbook.xml");
        let (before, rest) = listed.split_once("<definedName name=\"build_stamp\">").expect("the stamp's name");
        let (_, after) = rest.split_once("</definedName>").expect("its end");
        let nameless = parts.put("xl/workbook.xml", format!("{before}{after}")).zip();
        let emptied = with_on(&new, SHEET, "B1", ">");
        assert!(of_another(&emptied).is_some());
        if !libreoffice() {
            continue;
        }
        let (folder, mut files, mut lines) = (tempfile::tempdir().expect("a folder"), Vec::new(), Vec::new());
        for (name, book, line) in
            [("new", new, green), ("mixed", mixed, red), ("nameless", nameless, red), ("emptied", emptied, red)]
        {
            files.push((name.to_owned(), book));
            lines.push(line);
        }
        for (at, mut book) in recalculated(folder.path(), language == Language::Es, &files).into_iter().enumerate() {
            for sheet in sheets {
                let line = range(&mut book, sheet).get_value((1, 0)).map(ToString::to_string).unwrap_or_default();
                assert!(line.ends_with(lines[at]), "{}, {sheet}: {line}", files[at].0);
            }
        }
    }
}

/// The stamp counts as it was written, in a cell of its own: whatever else shows the same is no stamp, for `check` and for the sheets.
#[test]
fn only_the_stamp_that_was_written_is_one() {
    let new = results_of("impeller", "full");
    let parts = Parts::of(&new);
    let stamp = {
        let mut book: Xlsx<_> = open_workbook_from_rs(Cursor::new(new.clone())).expect("the results");
        book.worksheet_range(SHEET).expect("the guard").get_value((0, 1)).expect("the stamp").to_string()
    };
    let capitals = stamp.to_uppercase();
    assert_ne!(capitals, stamp, "a stamp without letters shows nothing");
    let typed = |inner: &str| with_on(&new, SHEET, "B1", inner);
    let listed = parts.text("xl/workbook.xml");
    let (before, rest) = listed.split_once("<definedName name=\"build_stamp\">").expect("the stamp's name");
    let (_, after) = rest.split_once('<').expect("its end");
    let constant = format!("{before}<definedName name=\"build_stamp\">\"{stamp}\"<{after}");
    let books = [
        ("capitals", typed(&text(&capitals))),
        ("blank", typed(&text(&format!("{stamp} ")))),
        ("number", typed("><v>1234567890123456</v>")),
        ("formula", typed(&format!(" t=\"str\"><f>\"{stamp}\"</f><v>{stamp}</v>"))),
        ("uncalculated", typed(&format!("><f>\"{stamp}\"</f>"))),
        ("constant", parts.put("xl/workbook.xml", constant).zip()),
    ];
    assert_eq!(of_another(&typed(&text(&stamp))), None);
    for (name, book) in &books {
        let told = of_another(book).unwrap_or_default();
        assert!(told.contains("Annex 2") || told.contains(", …"), "{name}: {told}");
    }
    if !libreoffice() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let mut files = books.map(|(name, book)| (name.to_owned(), book)).to_vec();
    files.push(("same".to_owned(), typed(&text(&stamp))));
    for ((name, _), mut book) in files.iter().zip(recalculated(folder.path(), false, &files)) {
        for sheet in ["DATA", "Annex 2"] {
            let line = range(&mut book, sheet).get_value((1, 0)).map(ToString::to_string).unwrap_or_default();
            assert_eq!(line.starts_with("NOT VERIFIED: this sheet"), name != "same", "{name}, {sheet}: {line}");
        }
    }
}

/// Row and column of an address, from 0.
fn place(address: &str) -> (u32, u32) {
    let split = address.find(|one: char| one.is_ascii_digit()).expect("a row");
    let (letters, row) = address.split_at(split);
    let column = letters.bytes().fold(0, |sum, letter| 26 * sum + u32::from(letter - b'A') + 1);
    (row.parse::<u32>().expect("a row") - 1, column - 1)
}

/// The ranges that a format is set on while inputs differ, without that of the line above.
fn struck(sheet: &str) -> Vec<[(u32, u32); 2]> {
    let formats = sheet.split("<conditionalFormatting sqref=\"").skip(1);
    formats
        .filter(|one| one.split("</conditionalFormatting>").next().is_some_and(|rule| rule.contains("stale_inputs")))
        .map(|one| {
            let range = one.split('"').next().expect("a range");
            let (first, last) = range.split_once(':').unwrap_or((range, range));
            [place(first), place(last)]
        })
        .filter(|[(row, _), _]| *row > 1)
        .collect()
}

#[test]
fn values_are_struck_out_and_formulas_are_not_as_soon_as_an_input_differs() {
    let mut count = [0; 2];
    for (kind, case, sheets) in [
        ("impeller", "full", &["Annex 6", "Blank", "Splitter", "SUMMARY"][..]),
        ("impeller", "tfg-2021", &["Lines blade"]),
        ("pipe-hole", "set-in", &["Pose", "Height", "Curve", "SUMMARY"]),
        ("pipe-insert", "square", &["Arcs", "Template", "SUMMARY"]),
    ] {
        let parts = Parts::of(&results_of(kind, case));
        for name in sheets {
            let sheet = part_of(&parts, name);
            let ranges = struck(&sheet);
            for cell in sheet.split("<c r=\"").skip(1) {
                let (address, cell) = cell.split_once('"').expect("an address");
                let cell = cell.split("</c>").next().expect("its end");
                let at @ (row, column) = place(address);
                let number = cell.contains("<v>") && !cell.contains("t=\"s\"");
                // Below the headings; of the summary the column of values.
                let value = if *name == "SUMMARY" { column == 2 } else { row > 3 && (column > 0 || *name == "Arcs") };
                if !(number && value) {
                    continue;
                }
                let hit = ranges
                    .iter()
                    .any(|[first, last]| (first.0..=last.0).contains(&at.0) && (first.1..=last.1).contains(&at.1));
                let formula = cell.contains("<f>");
                // The m of a splitter is a value.
                let in_part = *name == "Splitter" && (1..=8).contains(&column);
                assert_eq!(hit, !formula || in_part, "{kind} {case}, {name}!{address}");
                count[usize::from(formula)] += 1;
            }
        }
    }
    assert!(count[0] > 300 && count[1] > 1_000, "{count:?}");
    // Words that come of the inputs, too.
    let parts = Parts::of(&results_of("pipe-hole", "set-in"));
    assert!(struck(&part_of(&parts, "Height")).iter().any(|[first, _]| first.1 == 6), "the rule of the height");
}

/// The rows of a sheet that hold something in a column, with what they say.
fn said(book: &[u8], sheet: &str, column: u32) -> Vec<(u32, String)> {
    let mut book: Xlsx<_> = open_workbook_from_rs(Cursor::new(book.to_vec())).expect("the results");
    let sheet = book.worksheet_range(sheet).expect("the sheet");
    let (first, last) = (sheet.start().expect("a cell").0, sheet.end().expect("a cell").0);
    let told =
        |row| Some((row, sheet.get_value((row, column)).map(ToString::to_string).filter(|one| !one.is_empty())?));
    (first..=last).filter_map(told).collect()
}

/// Verdicts, places and words of tables are of the inputs, too.
#[test]
fn words_that_came_out_are_struck_out_as_soon_as_an_input_differs() {
    for (language, [summary, verification, findings, passes], lines) in [
        (Language::En, ["SUMMARY", "Verification", "Findings", "Passes"], ["Verdict", "What to check", "Programs"]),
        (Language::Es, ["RESUMEN", "Verificación", "Avisos", "Pasadas"], ["Resultado", "Qué revisar", "Programas"]),
    ] {
        let book = results_with("impeller", "clear", language, &[]);
        let parts = Parts::of(&book);
        let hit = |sheet: &str, at: (u32, u32)| {
            struck(&part_of(&parts, sheet))
                .iter()
                .any(|[first, last]| (first.0..=last.0).contains(&at.0) && (first.1..=last.1).contains(&at.1))
        };
        let mut labels = 0;
        for (row, label) in said(&book, summary, 0).into_iter().filter(|(row, _)| (2..12).contains(row)) {
            let computed = lines.contains(&label.as_str());
            assert_eq!([1, 4].map(|column| hit(summary, (row, column))), [computed; 2], "{label}");
            labels += usize::from(computed);
        }
        assert_eq!(labels, lines.len());
        for (sheet, headings) in [(verification, 3), (findings, 2), (passes, 3)] {
            let mut count = 0;
            for column in 0..5 {
                for (row, told) in said(&book, sheet, column).into_iter().filter(|(row, _)| *row > headings) {
                    assert!(hit(sheet, (row, column)), "{sheet}, row {}, column {column}: {told}", row + 1);
                    count += 1;
                }
            }
            assert!(count > 10, "{sheet}: {count} cells");
        }
    }
    // Where a value that is struck out is reached.
    let book = results_of("pipe-insert", "square");
    let ranges = struck(&part_of(&Parts::of(&book), "SUMMARY"));
    let places: Vec<_> =
        said(&book, "SUMMARY", 4).into_iter().filter(|(_, told)| told.starts_with("at φ = ")).collect();
    assert!(!places.is_empty());
    for (row, told) in places {
        assert!(ranges.contains(&[(row, 2), (row, 4)]), "{told}");
    }
}

#[test]
fn check_names_the_input_whose_name_is_gone_or_leads_elsewhere() {
    let astray = |bytes: &[u8]| {
        let forms: Vec<_> = KINDS.iter().map(|kind| kind.form()).collect();
        let found = rodete::workbook::read(bytes, &forms).expect("a form").astray;
        found.map(|found| (found.code(), found.what.en.into_owned(), found.place))
    };
    let results = results_of("impeller", "full");
    assert_eq!(astray(&results), None);
    let parts = Parts::of(&results);
    let listed = parts.text("xl/workbook.xml");
    let (before, rest) = listed.split_once("<definedName name=\"thickness_e\">").expect("the name");
    let (own, after) = rest.split_once("</definedName>").expect("its end");
    let with = |name: &str| Parts::of(&results).put("xl/workbook.xml", format!("{before}{name}{after}")).zip();
    let led = |to: &str| with(&format!("<definedName name=\"thickness_e\">{to}</definedName>"));
    let cell = own.rsplit_once('!').expect("a sheet").1.replace('$', "");
    for book in [with(""), led("#REF!"), led("DATA!$C$14"), led(&own.replace("DATA", "SUMMARY"))] {
        let (code, told, place) = astray(&book).expect("a caution");
        assert_eq!(code, "W0521");
        assert!(told.contains("another cell: thickness_e; "), "{told}");
        assert_eq!(place, Place::Cells(vec![CellPlace { sheet: "DATA".to_owned(), cell: cell.clone() }]));
    }
    assert_eq!(astray(&led(&own.replace("DATA", "data"))), None);
}
