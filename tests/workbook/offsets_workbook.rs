//! The sheet of work offsets: written, read back, and refused with the cell where it is wrong.

use std::io::{Cursor, Read, Write};

use proptest::prelude::*;
use rodete::finding::{Exit, Finding, Grade, Place, Refusal};
use rodete::machine::length_unit::LengthUnit;
use rodete::machine::var_file::VarFile;
use rodete::machine::work_offset::System;
use rodete::text::Language;
use rodete::workbook::offsets_sheet;
use rodete::workbook::offsets_table::OffsetsTable;
use rust_xlsxwriter::{ExcelDateTime, Format, Formula, Workbook, Worksheet};

const MM: LengthUnit = LengthUnit::Millimetre;

fn written(file: &VarFile, unit: LengthUnit, language: Language) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    offsets_sheet::write(file, unit, "a.var", language, &mut out).unwrap();
    out.into_inner()
}

fn read_var(text: &str) -> VarFile {
    VarFile::parse(text.as_bytes()).unwrap()
}

fn blank(sheet: &mut Worksheet, row: u32, column: u16) {
    sheet.write_blank(row, column, &Format::new()).unwrap();
}

/// A sound sheet as a user might type it, with `change` made to it: headings in row 3, units in 4, G54 in 5, G92 in 14.
fn sheet(change: impl FnOnce(&mut Worksheet)) -> Vec<u8> {
    named("OFFSETS", change)
}

fn named(name: &str, change: impl FnOnce(&mut Worksheet)) -> Vec<u8> {
    let mut workbook = Workbook::new();
    let sheet = workbook.add_worksheet();
    sheet.set_name(name).unwrap();
    sheet.write(0, 0, "schema").unwrap();
    sheet.write(0, 1, offsets_sheet::SCHEMA).unwrap();
    let heads = ["System", "X", "Y", "Z", "A", "B", "C", "U", "V", "W", "R", "Active"];
    let units = ["", "mm", "mm", "mm", "°", "°", "°", "mm", "mm", "mm", "°", ""];
    for (column, (head, unit)) in (0..).zip(heads.into_iter().zip(units)) {
        sheet.write(2, column, head).unwrap();
        sheet.write(3, column, unit).unwrap();
    }
    for (row, name) in (4..).zip(System::ALL.map(System::name).into_iter().chain(["G92"])) {
        sheet.write(row, 0, name).unwrap();
        for column in 1..=9 {
            sheet.write(row, column, 0.5).unwrap();
        }
        if name != "G92" {
            sheet.write(row, 10, 1.5).unwrap();
        }
        sheet.write(row, 11, if name == "G55" { "yes" } else { "no" }).unwrap();
    }
    change(sheet);
    workbook.save_to_buffer().unwrap()
}

fn read(bytes: &[u8]) -> Result<OffsetsTable, Refusal> {
    OffsetsTable::read(bytes, MM)
}

/// A finding's cells and its sentence.
fn said(finding: &Finding) -> (String, String) {
    let place = match &finding.place {
        Place::Cells(cells) => cells.iter().map(|cell| cell.cell.clone()).collect::<Vec<_>>().join(" "),
        Place::Sheet(name) => format!("sheet {name}"),
        _ => String::new(),
    };
    assert!(!finding.what.es.is_empty());
    assert_eq!(finding.remedy.es.is_empty(), finding.remedy.en.is_empty());
    (place, finding.what.en.clone().into_owned())
}

#[test]
fn a_sheet_goes_out_and_comes_back_in_both_languages_and_units() {
    let mut file = VarFile::default();
    file.complete();
    let numbers: Vec<u32> = file.iter().map(|(number, _)| number).filter(|number| *number > 5210).collect();
    for (number, at) in numbers.into_iter().zip(1..) {
        file.set(number, f64::from(at) / 3.0 - 20.0).unwrap();
    }
    file.set(5210, 1.0).unwrap();
    file.set(5220, 9.0).unwrap();
    for language in Language::ALL {
        for unit in [LengthUnit::Inch, MM] {
            let bytes = written(&file, unit, language);
            assert_eq!(bytes, written(&file, unit, language), "the same bytes");
            let table = OffsetsTable::read(&bytes, unit).unwrap();
            assert!(table.findings.is_empty(), "{:?}", table.findings);
            assert_eq!((table.active, table.g92_on), (Some(System::G59_3), Some(true)));
            let mut back = VarFile::default();
            back.complete();
            table.apply(&mut back).unwrap();
            assert_eq!(back.text(), file.text());
        }
    }
}

#[test]
fn an_unedited_sheet_changes_no_digit() {
    let text =
        "31\t1.23456789\n5161\t7.5\n5210\t2.5\n5211\t0.12345678912\n5220\t3\n5241\t-0.3333333333333\n5600\t1e3\n";
    let mut file = read_var(text);
    let table = OffsetsTable::read(&written(&file, LengthUnit::Inch, Language::Es), LengthUnit::Inch).unwrap();
    table.apply(&mut file).unwrap();
    let written = file.text();
    let kept = text.lines().filter(|line| written.lines().filter(|other| other == line).count() == 1).count();
    assert_eq!(kept, 7, "{written}");
}

#[test]
fn what_a_sheet_holds_is_read_by_its_labels() {
    let table = read(&sheet(|_| {})).unwrap();
    assert_eq!((table.values.len(), table.active, table.g92_on), (99, Some(System::G55), Some(false)));
    // Moved, reordered, in part, in other letters: only X and R of G59.1 and G54.
    let bytes = named("ORIGENES", |sheet| {
        for row in 0..14 {
            for column in 0..12 {
                blank(sheet, row, column);
            }
        }
        sheet.write(5, 0, "esquema").unwrap().write(5, 1, offsets_sheet::SCHEMA).unwrap();
        for (column, (head, unit)) in (0..).zip([("SISTEMA", ""), ("r", "º"), ("Fecha", ""), ("x", "MM")]) {
            sheet.write(8, column, head).unwrap().write(9, column, unit).unwrap();
        }
        sheet.write(10, 0, "g59.1").unwrap().write(10, 1, -3).unwrap().write(10, 3, 4.25).unwrap();
        sheet.write(12, 0, "G54").unwrap().write(12, 1, 0).unwrap().write(12, 3, -0.0).unwrap();
        sheet.write(13, 0, "Nota").unwrap();
    });
    let table = read(&bytes).unwrap();
    let mut values = table.values.clone();
    values.sort_by_key(|(number, _)| *number);
    assert_eq!(values, [(5221, 0.0), (5230, 0.0), (5341, 4.25), (5350, -3.0)]);
    assert_eq!((table.active, table.g92_on), (None, None));
    let notes: Vec<_> = table.findings.iter().map(said).collect();
    let note = |place: &str, what: &str| (place.to_owned(), what.to_owned());
    assert_eq!(
        notes,
        [
            note("C9", "rodete does not read \"Fecha\": it does not belong to this table"),
            note("sheet ORIGENES", "not on the sheet, so unchanged in the file: Y, Z, A, B, C, U, V, W, Activo"),
            note("A14", "rodete does not read \"Nota\": it does not belong to this table"),
            note(
                "sheet ORIGENES",
                "not on the sheet, so unchanged in the file: G55, G56, G57, G58, G59, G59.2, G59.3, G92"
            ),
        ]
    );
    assert!(table.findings.iter().all(|finding| finding.grade == Grade::Note));
    let mut file = read_var("5220\t4\n5222\t8\n5241\t9\n");
    table.apply(&mut file).unwrap();
    assert_eq!((file.get(5220), file.get(5222), file.get(5241)), (Some(4.0), Some(8.0), Some(9.0)));
}

type Change = fn(&mut Worksheet);

#[test]
fn every_bad_cell_is_refused_with_its_place_and_reason() {
    let cases: &[(Change, &str, &str)] = &[
        (|s| drop(s.write(4, 1, "1,5")), "B5", "X (linear axis, mm) is the text \"1,5\", not a number"),
        (|s| drop(s.write(4, 1, "12.5")), "B5", "X (linear axis, mm) is the text \"12.5\", not a number"),
        (|s| drop(s.write(4, 1, "12 mm")), "B5", "X (linear axis, mm) is the text \"12 mm\", not a number"),
        (|s| drop(s.write(5, 4, true)), "E6", "A (rotary axis, °) is the truth value TRUE"),
        (|s| blank(s, 6, 3), "D7", "Z (linear axis, mm) is missing"),
        (
            |s| drop(s.write(7, 2, 100_000)),
            "C8",
            "Y (linear axis, mm) is 100000; it must be from -99999.999 to 99999.999",
        ),
        (|s| drop(s.write(7, 10, 400)), "K8", "R (rotation about Z, °) is 400; it must be from -360 to 360"),
        (
            |s| drop(s.write_formula(4, 1, Formula::new("=1/0").set_result("#DIV/0!"))),
            "B5",
            "X (linear axis, mm) is the error #DIV/0!",
        ),
        (
            |s| {
                let date = ExcelDateTime::from_ymd(2021, 6, 1).unwrap();
                drop(s.write_datetime_with_format(4, 1, date, &Format::new().set_num_format("yyyy-mm-dd")));
            },
            "B5",
            "X (linear axis, mm): its cell is formatted as a date",
        ),
        (
            |s| drop(s.merge_range(4, 1, 5, 1, "", &Format::new()).and_then(|s| s.write(4, 1, 1.0))),
            "B6",
            "X (linear axis, mm): its cell is inside the merged cells B5:B6, whose value is in B5",
        ),
        (|s| drop(s.write(13, 10, 0)), "K14", "G92 has no rotation"),
        (|s| drop(s.write(4, 11, "yes")), "L5 L6", "several work offsets are active: G54, G55"),
        (|s| drop(s.write(5, 11, "no")), "L5 L6 L7 L8 L9 L10 L11 L12 L13", "no work offset is active"),
        (
            |s| drop(s.write(5, 11, "perhaps")),
            "L6",
            "Active (active system; G92 in force) is \"perhaps\"; it must be one of: yes, no",
        ),
        (|s| drop(s.write(6, 0, "G54")), "A5 A7", "\"G54\" appears twice"),
        (|s| drop(s.write(2, 2, "X")), "B3 C3", "\"X\" appears twice"),
        (|s| drop(s.write(3, 1, "in")), "B4", "X is in \"in\", but the file is in mm"),
        (|s| blank(s, 3, 1), "B4", "X does not give its unit"),
        (|s| drop(s.write(3, 4, "mm")), "E4", "A is in \"mm\", but the file is in °"),
        (
            |s| drop(s.write(2, 0, "Systems")),
            "sheet OFFSETS",
            "the row of headings, which begins with \"System\" in column A, is missing",
        ),
        (|s| drop(s.write(20, 0, "System")), "A3 A21", "there are several rows of headings"),
        (
            |s| drop(s.write(0, 1, "rodete-offsets 2")),
            "B1",
            "the schema is \"rodete-offsets 2\"; rodete reads \"rodete-offsets 1\"",
        ),
        (|s| blank(s, 0, 0), "sheet OFFSETS", "the sheet does not name its schema; rodete reads \"rodete-offsets 1\""),
    ];
    for (change, place, what) in cases {
        let refusal = read(&sheet(*change)).expect_err(what);
        assert_eq!(refusal.exit, Exit::Refused, "{what}");
        let stops: Vec<_> = refusal.findings.iter().filter(|finding| finding.grade == Grade::Stop).map(said).collect();
        let hit = stops.iter().any(|stop| *stop == ((*place).to_owned(), (*what).to_owned()));
        assert!(hit, "{place}: {what}: {stops:#?}");
    }
}

#[test]
fn a_formula_that_was_never_calculated_is_refused() {
    let bytes = sheet(|sheet| drop(sheet.write_formula(4, 1, Formula::new("=1+1").set_result("7"))));
    // The writer stores a value with every formula: it is taken out of the package.
    let mut package = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut changed = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for index in 0..package.len() {
        let mut part = package.by_index(index).unwrap();
        let name = part.name().unwrap().into_owned();
        let mut text = String::new();
        part.read_to_string(&mut text).unwrap();
        if name.ends_with("sheet1.xml") {
            assert!(text.contains("</f><v>7</v>"), "{text}");
            text = text.replace("</f><v>7</v>", "</f>");
        }
        changed.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        changed.write_all(text.as_bytes()).unwrap();
    }
    let refusal = read(&changed.finish().unwrap().into_inner()).unwrap_err();
    let what = "X (linear axis, mm): B5 holds a formula without a stored value";
    assert_eq!(refusal.findings.iter().map(said).collect::<Vec<_>>(), [("B5".to_owned(), what.to_owned())]);
}

#[test]
fn all_faults_are_told_at_once() {
    let bytes = sheet(|sheet| {
        sheet.write(4, 1, "1,5").unwrap().write(5, 2, "x").unwrap().write(3, 9, "in").unwrap();
    });
    let refusal = read(&bytes).unwrap_err();
    let places: Vec<_> = refusal.findings.iter().map(|finding| said(finding).0).collect();
    assert_eq!(places, ["J4", "B5", "C6"]);
    let remedies: Vec<_> = refusal.findings.iter().map(|finding| finding.remedy.en.as_ref()).collect();
    assert_eq!(
        remedies,
        [
            "give --inch if the machine works in inches; otherwise convert the values and write mm in J4",
            "set the cell's format to General if it is Text, and type the number 1.5, with the decimal sign of your spreadsheet",
            "type a number, such as 12.5, with the decimal sign of your spreadsheet"
        ]
    );
}

#[test]
fn the_machines_unit_must_be_that_of_the_sheet() {
    let file = read_var("5220\t1\n");
    for (sheet, machine) in [(LengthUnit::Inch, MM), (MM, LengthUnit::Inch)] {
        let bytes = written(&file, sheet, Language::Es);
        assert!(OffsetsTable::read(&bytes, sheet).is_ok());
        let refusal = OffsetsTable::read(&bytes, machine).unwrap_err();
        assert_eq!(refusal.findings.len(), 6, "six axes of lengths: {refusal:?}");
        assert!(refusal.findings.iter().all(|finding| finding.remedy.en.contains("--inch")));
    }
}

#[test]
fn a_workbook_without_the_sheet_is_refused_with_what_to_do() {
    let refusal = read(&named("Offsets", |_| {})).unwrap_err();
    assert_eq!(refusal.findings[0].remedy.en, "rename the sheet \"Offsets\" to \"OFFSETS\"");
    let refusal = read(&named("DATA", |_| {})).unwrap_err();
    assert_eq!(refusal.findings[0].what.en, "sheet \"ORIGENES\" or \"OFFSETS\" not found; there are: \"DATA\"");
    assert!(refusal.findings[0].remedy.en.contains("does not exist"));
    assert_eq!(read(b"no workbook").unwrap_err().exit, Exit::Unreadable);
    let mut workbook = Workbook::new();
    workbook.add_worksheet().set_name("OFFSETS").unwrap();
    let refusal = read(&workbook.save_to_buffer().unwrap()).unwrap_err();
    assert_eq!(refusal.findings[0].what.en, "the sheet \"OFFSETS\" has no cells");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn any_offsets_survive_the_sheet(values in prop::collection::vec(-3000.0..3000.0_f64, 81), active in 1_u8..10) {
        let mut file = VarFile::default();
        file.complete();
        let numbers = System::ALL.into_iter().flat_map(|system| (system.first_parameter()..).take(9));
        for (number, value) in numbers.zip(values) {
            file.set(number, value).unwrap();
        }
        file.set(5220, f64::from(active)).unwrap();
        let mut back = VarFile::default();
        back.complete();
        read(&written(&file, MM, Language::En)).unwrap().apply(&mut back).unwrap();
        prop_assert_eq!(back.text(), file.text());
    }
}
