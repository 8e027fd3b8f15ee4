//! The results workbook holds what was computed, bit for bit, and nothing that could act.

use crate::common;

use std::collections::BTreeMap;
use std::io::{Cursor, Read};

use calamine::{Data, Range, Reader, Xlsx};
use rodete::finding::rules::ValueNotFinite;
use rodete::finding::{Grade, Place, Raise};
use rodete::kind::{Outcome, checks};
use rodete::kinds::impeller::parameters::FORM;
use rodete::kinds::impeller::rules::NoRetract;
use rodete::parameter::{FieldKind, Value};
use rodete::table::{Column, Entry, Index, Law, Print, Table, Unit};
use rodete::text::{Language, Text, t};
use rodete::workbook::error::WriteError;
use rodete::workbook::guard::Guard;
use rodete::workbook::program_sheet::ProgramSheet;
use rodete::workbook::results::{self, Tables};
use rodete::workbook::save::{Additions, save};
use zip::ZipArchive;

fn written(outcome: &Outcome, language: Language) -> Vec<u8> {
    let mut out = Cursor::new(Vec::new());
    results::write(outcome, &[], Tables::Live, language, &mut out).expect("the results can be written");
    out.into_inner()
}

fn opened(bytes: Vec<u8>) -> Xlsx<Cursor<Vec<u8>>> {
    Xlsx::new(Cursor::new(bytes)).expect("a workbook")
}

fn sheet(workbook: &mut Xlsx<Cursor<Vec<u8>>>, name: &str) -> Range<Data> {
    workbook.worksheet_range(name).unwrap_or_else(|error| panic!("sheet {name}: {error}"))
}

fn at(range: &Range<Data>, row: usize, column: usize) -> Data {
    let place = (u32::try_from(row).expect("a row"), u32::try_from(column).expect("a column"));
    range.get_value(place).cloned().unwrap_or_default()
}

fn text(range: &Range<Data>, row: usize, column: usize) -> String {
    match at(range, row, column) {
        Data::String(text) => text,
        Data::Empty => String::new(),
        other => panic!("row {row}, column {column} holds {other:?}"),
    }
}

/// The XML of every sheet, by name.
fn parts(bytes: Vec<u8>) -> BTreeMap<String, String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).expect("a package");
    (0..archive.len())
        .map(|index| {
            let mut part = archive.by_index(index).expect("a part");
            let mut xml = String::new();
            part.read_to_string(&mut xml).expect("text");
            (String::from_utf8_lossy(part.name_raw()).into_owned(), xml)
        })
        .collect()
}

/// Every table of the outcome stands on its sheet: head, index, and values with the same bits.
fn assert_tables_read_back(outcome: &Outcome, language: Language) {
    let mut workbook = opened(written(outcome, language));
    for table in &outcome.tables {
        let range = sheet(&mut workbook, table.name.get(language));
        let offset = usize::from(table.index.counted());
        assert_eq!(text(&range, 0, 0), table.title.get(language));
        // The guard's words stand behind the source, and what values are before it.
        let source = text(&range, 1, 0);
        assert!(source.contains(table.source.get(language)) && source.contains(" · "), "{source}");
        // Rows that are prepared for more points show nothing.
        for below in table.rows() + 4..range.height() {
            for column in 0..range.width() {
                assert!(at(&range, below, column).to_string().trim().is_empty(), "{} {below} {column}", table.key);
            }
        }
        for (column, values) in table.columns.iter().enumerate() {
            assert_eq!(text(&range, 2, column + offset), values.symbol.get(language));
            assert_eq!(text(&range, 3, column + offset), values.unit.label());
            for row in 0..table.rows() {
                match (values.values.get(row), at(&range, row + 4, column + offset)) {
                    (Entry::Number(value), Data::Float(read)) => {
                        assert_eq!(value.to_bits(), read.to_bits(), "{} {column} {row}", table.key);
                    }
                    (Entry::Text(text), Data::String(read)) if values.live.is_some() => {
                        assert_eq!(text.get(language), read.trim());
                    }
                    (Entry::Text(text), Data::String(read)) => assert_eq!(text.get(language), read),
                    (Entry::Text(text), Data::Empty) => assert!(text.get(language).is_empty()),
                    (entry, read) => panic!("{} {column} {row}: {entry:?} reads back as {read:?}", table.key),
                }
            }
        }
        if offset == 1 {
            for row in 0..table.rows() {
                assert_eq!(at(&range, row + 4, 0), Data::Float(f64::from(u32::try_from(row).expect("small"))));
            }
        }
    }
}

#[test]
fn every_table_reads_back_bit_for_bit_in_both_languages() {
    for case in ["tfg-2021", "full"] {
        let outcome = common::outcome(case, &[]);
        assert!(outcome.tables.len() >= 10);
        for language in Language::ALL {
            assert_tables_read_back(&outcome, language);
        }
    }
}

#[test]
fn a_long_table_is_streamed_and_reads_back_bit_for_bit() {
    let outcome = common::outcome("full", &[("n", Value::Whole(3_000))]);
    assert!(outcome.tables.iter().any(|table| table.rows() > 2_000));
    assert_tables_read_back(&outcome, Language::Es);
}

#[test]
fn a_long_table_of_numbers_and_texts_keeps_the_smallest_and_largest_of_each() {
    let mut outcome = common::outcome("full", &[]);
    let numbers: Vec<f64> = (0..2_500)
        .map(|row| match row % 5 {
            0 => f64::MAX,
            1 => f64::MIN_POSITIVE / 4.0,
            2 => -0.1 - 0.2,
            3 => 1e-5,
            _ => f64::from(row),
        })
        .collect();
    let texts = (0..2_500).map(|row| Text::same(["<a & b>", "=1+1", " blank ", "_x001B_", "é\t"][row % 5])).collect();
    outcome.tables = vec![Table {
        key: "mixed",
        name: Text::same("Mixed"),
        title: Text::same("=title"),
        source: Text::same("@source"),
        index: Index::Point,
        print: Print::Short,
        columns: vec![
            Column::numbers("x", Unit::Millimetre, Law::None, numbers),
            Column::texts(Text::same("word"), Law::None, texts),
        ],
    }];
    outcome.charts.clear();
    // Derived values ask for the tables that are gone.
    outcome.quantities.clear();
    assert_tables_read_back(&outcome, Language::En);
}

#[test]
fn programs_stand_side_by_side_line_for_line() {
    for case in ["tfg-2021", "full"] {
        let outcome = common::outcome(case, &[]);
        let range = sheet(&mut opened(written(&outcome, Language::Es)), "INCR");
        for (key, column) in [("blade", 0), ("splitter", 3), ("impeller", 6), ("blank", 9)] {
            let program = outcome.programs.iter().find(|program| program.key == key).expect("the program");
            let mut lines = program.lines();
            let mut row = 0;
            while let Some((number, line)) = lines.next() {
                let number = number.map_or_else(String::new, |number| format!("N{number}"));
                assert_eq!(text(&range, row, column), number, "{key} {row}");
                assert_eq!(text(&range, row, column + 1), line, "{key} {row}");
                row += 1;
            }
            assert!(row > 3);
            for below in row..range.height() {
                assert_eq!(at(&range, below, column + 1), Data::Empty);
            }
        }
    }
}

#[test]
fn a_program_longer_than_a_sheet_goes_on_to_the_right() {
    let outcome = common::outcome("tfg-2021", &[]);
    let programs =
        ProgramSheet::new(outcome.programs.iter().map(|proved| &proved.program), outcome.fields.form().programs, 50)
            .expect("programs");
    assert_eq!(programs.rows(), 50);
    let mut book = rust_xlsxwriter::Workbook::new();
    let page = rodete::workbook::page::Page { part: "", origin: "", repeat: (0, 0), landscape: false, single: false };
    let styles = rodete::workbook::style::Styles::default();
    programs.write(book.add_worksheet(), Language::En, &styles, &page, &Guard::default()).expect("columns");
    let mut out = Cursor::new(Vec::new());
    let rows = programs.rows();
    let long = rodete::workbook::long_rows::LongRows {
        sheet: 0,
        name: String::new(),
        first: 0,
        count: rows,
        source: programs.source(),
    };
    save(&mut book, Additions { long: vec![long], ..Additions::default() }, &mut out).expect("a workbook");
    let range = sheet(&mut opened(out.into_inner()), "Sheet1");

    // Further pairs come after those of the form, in the programs' order.
    let mut further = 18;
    for (key, first) in [("blade", 0), ("splitter", 3), ("impeller", 6), ("blank", 9)] {
        let program = outcome.programs.iter().find(|program| program.key == key).expect("the program");
        let (mut lines, mut row, mut column) = (program.lines(), 0, first);
        while let Some((_, line)) = lines.next() {
            if row == 50 {
                (row, column) = (0, further);
                further += 3;
            }
            assert_eq!(text(&range, row, column + 1), line, "{key}");
            row += 1;
        }
    }
    assert!(further > 18 + 3);
}

/// The areas of a sheet that are printed; none where all of it is.
fn printed(parts: &BTreeMap<String, String>, sheet: &str) -> Vec<String> {
    let book = &parts["xl/workbook.xml"];
    let areas = book.split("<definedName name=\"_xlnm.Print_Area\"").skip(1);
    let mut areas = areas.map(|rest| rest.split(['>', '<']).nth(1).expect("areas").to_owned());
    let own = areas.find(|areas| areas.starts_with(&format!("{sheet}!")));
    own.map_or_else(Vec::new, |areas| areas.split(',').map(str::to_owned).collect())
}

#[test]
fn of_long_programs_and_tables_both_ends_are_printed_and_the_sheets_name_the_files() {
    let outcome = common::outcome("full", &[("n", Value::Whole(1_500))]);
    for language in Language::ALL {
        let files: Vec<_> =
            outcome.programs.iter().map(|one| (format!("a-{}.nc", one.key), one.title.clone())).collect();
        let mut out = Cursor::new(Vec::new());
        results::write(&outcome, &files, results::Tables::Live, language, &mut out).expect("a workbook");
        let parts = parts(out.get_ref().clone());
        let areas = printed(&parts, "INCR");
        // Blade, splitter and impeller from both ends, the blank whole.
        assert_eq!(areas.len(), 7, "{areas:?}");
        for (key, column, next) in [("blade", "A", "B"), ("splitter", "D", "E"), ("impeller", "G", "H")] {
            let lines = outcome.programs.iter().find(|program| program.key == key).expect("the program");
            let (mut lines, mut count) = (lines.lines(), 0);
            while lines.next().is_some() {
                count += 1;
            }
            let ends =
                [format!("INCR!${column}$1:${next}$45"), format!("INCR!${column}${}:${next}${count}", count - 44)];
            assert!(ends.iter().all(|end| areas.contains(end)), "{areas:?} {ends:?}");
        }
        assert_eq!(areas.iter().filter(|area| area.starts_with("INCR!$J$1:$K$")).count(), 1);
        let annex = outcome.tables.iter().find(|table| table.rows() == 1_501).expect("a long table");
        let name = rust_xlsxwriter::quote_sheet_name(annex.name.get(language));
        let areas = printed(&parts, &name);
        assert!(areas[0].ends_with("$49") && areas[1].contains("$1461:") && areas[1].ends_with("$1505"), "{areas:?}");
        let names = "a-blade.nc, a-splitter.nc, a-impeller.nc";
        let sheets: Vec<_> = parts.iter().filter(|(name, _)| name.contains("worksheets")).collect();
        let headers = sheets.iter().filter(|(_, xml)| xml.contains(&format!("{names}&amp;R&amp;A")));
        assert_eq!(headers.count(), 1, "the header of the programs names them");
        let range = sheet(&mut opened(out.into_inner()), "INCR");
        let note = text(&range, 0, 12);
        assert!(note.contains("45") && note.ends_with(names), "{note}");
    }
    let short = parts(written(&common::outcome("tfg-2021", &[]), Language::En));
    assert!(printed(&short, "INCR").is_empty());
}

#[test]
fn the_form_stands_behind_the_first_sheet_with_the_values() {
    for (language, name) in [(Language::Es, "DATOS"), (Language::En, "DATA")] {
        let outcome = common::outcome("tfg-2021", &[]);
        let mut workbook = opened(written(&outcome, language));
        assert_eq!(workbook.sheet_names().get(1).map(String::as_str), Some(name));
        let range = sheet(&mut workbook, name);
        let row = |symbol: &str, column: usize| {
            (0..range.height()).find(|&row| at(&range, row, column) == Data::String(symbol.to_owned()))
        };
        for (key, value) in &outcome.fields.values().values {
            let row = row(key, 0).unwrap_or_else(|| panic!("{key} has no row"));
            match (value, at(&range, row, 2)) {
                (Value::Real(value), Data::Float(read)) => assert_eq!(value.to_bits(), read.to_bits()),
                (Value::Whole(value), Data::Float(read)) => assert_eq!(f64::from(*value).to_bits(), read.to_bits()),
                (Value::Line(line), Data::String(read)) => assert_eq!(*line, read),
                (Value::Choice(choice), Data::String(read)) => {
                    let word = FORM.parameters().find_map(|(_, one)| match &one.kind {
                        FieldKind::Choice(all) if one.key == *key => all.iter().find(|it| it.key == *choice),
                        _ => None,
                    });
                    assert_eq!(word.map(|word| word.label.get(language)), Some(read.as_str()), "{key}");
                }
                (value, read) => panic!("{key}: {value:?} reads back as {read:?}"),
            }
        }
    }
}

/// The first sheet, and the row of a label or a symbol on it.
fn summary(outcome: &Outcome, files: &[results::File], language: Language) -> (Range<Data>, Vec<String>) {
    let mut out = Cursor::new(Vec::new());
    results::write(outcome, files, Tables::Live, language, &mut out).expect("the results can be written");
    let mut workbook = opened(out.into_inner());
    let names = workbook.sheet_names();
    (sheet(&mut workbook, names.first().expect("a sheet")), names)
}

fn row_of(range: &Range<Data>, label: &str) -> usize {
    (0..range.height())
        .find(|&row| at(range, row, 0) == Data::String(label.to_owned()))
        .unwrap_or_else(|| panic!("{label} has no row"))
}

#[test]
fn the_first_sheet_says_what_came_out_what_to_look_at_and_where_the_files_are() {
    let outcome = common::outcome("full", &[]);
    let files =
        [("a-blade.nc".to_owned(), t("Un álabe", "One blade")), ("a-report.pdf".to_owned(), t("Informe", "Report"))];
    for (language, first, labels) in [
        (Language::Es, "RESUMEN", ["Pieza", "Resultado", "Qué revisar", "Programas", "Archivos"]),
        (Language::En, "SUMMARY", ["Part", "Verdict", "What to check", "Programs", "Files"]),
    ] {
        let (range, names) = summary(&outcome, &files, language);
        assert_eq!(names.first().map(String::as_str), Some(first));
        let [part, verdict, look, programs, delivered] = labels.map(|label| text(&range, row_of(&range, label), 1));
        assert!(part.contains(outcome.part()) && part.contains(outcome.material()), "{part}");
        let style = t("fagor-8055, estilo completo", "fagor-8055, style full");
        assert_eq!(text(&range, row_of(&range, "Control"), 1), style.get(language));
        let (words, _) = checks::verdict(false, &outcome.findings);
        let passed = checks::passed(&outcome.checks);
        assert_eq!(verdict, format!("{}. {}", words.get(language), passed.get(language)));
        let cautions: Vec<_> = outcome.findings.iter().filter(|one| one.grade == Grade::Caution).collect();
        assert!(!cautions.is_empty());
        for caution in &cautions {
            assert!(look.contains(caution.code()) && look.contains(caution.what.get(language)), "{look}");
        }
        assert_eq!(programs.lines().count(), outcome.programs.len());
        for program in &outcome.programs {
            let line = programs.lines().find(|line| line.contains(&format!("({})", program.key))).expect("a line");
            assert!(line.contains(&format!(" {} ", rodete::number::grouped(program.blocks()))), "{line}");
        }
        // The blank is turned before anything is milled.
        assert!(programs.lines().next().is_some_and(|line| line.contains("(blank)")), "{programs}");
        for (name, what) in &files {
            assert!(delivered.contains(&format!("{name}: {}", what.get(language))), "{delivered}");
        }
        for quantity in &outcome.quantities {
            let row = row_of(&range, quantity.symbol);
            assert_eq!(at(&range, row, 2), Data::Float(quantity.value), "{}", quantity.symbol);
            assert_eq!(text(&range, row, 3), quantity.unit.label());
        }
        // Every other sheet is named, with what it holds, and can be gone to.
        for name in names.iter().skip(1).filter(|name| !["Verified", "Curves"].contains(&name.as_str())) {
            assert!(!text(&range, row_of(&range, name), 1).is_empty(), "{name}");
        }
        let xml = parts(written(&outcome, language));
        let links = xml["xl/worksheets/sheet1.xml"].matches("<hyperlink ").count();
        let hidden = ["Verified", "Curves"];
        assert_eq!(links, names.iter().skip(1).filter(|name| !hidden.contains(&name.as_str())).count());
    }
}

#[test]
fn the_first_sheet_has_a_line_for_what_does_not_stand_on_it() {
    let mut outcome = common::outcome("full", &[]);
    let caution = NoRetract {}.at(Place::File).graded(Grade::Caution);
    outcome.findings = vec![caution; 7];
    let (range, _) = summary(&outcome, &[], Language::En);
    let look = text(&range, row_of(&range, "What to check"), 1);
    assert!(
        look.lines().count() == 5 && look.ends_with("And further 3. Remedies and places: sheet Findings."),
        "{look}"
    );
    outcome.findings.clear();
    let (range, _) = summary(&outcome, &[], Language::En);
    assert_eq!(text(&range, row_of(&range, "What to check"), 1), "Nothing in particular.");
    assert!(text(&range, row_of(&range, "Verdict"), 1).starts_with("No cautions. rodete read back"));
    outcome.end = rodete::kind::End::Stopped;
    let (range, _) = summary(&outcome, &[], Language::En);
    assert!(text(&range, row_of(&range, "Verdict"), 1).starts_with("Rejected: rodete delivers no program."));
}

#[test]
fn values_are_shown_to_the_digits_of_their_unit_and_kept_whole() {
    let mut outcome = common::outcome("full", &[]);
    let third = vec![1.0 / 3.0; 3];
    let columns = [("x", Unit::Millimetre), ("v", Unit::Radian), ("t", Unit::Second), ("n", Unit::Count)];
    outcome.tables[0].columns =
        columns.map(|(symbol, unit)| Column::numbers(symbol, unit, Law::None, third.clone())).into();
    outcome.charts.clear();
    // As values: other tables would ask for the columns that are gone.
    let mut out = Cursor::new(Vec::new());
    results::write(&outcome, &[], Tables::Values, Language::En, &mut out).expect("the results can be written");
    let xml = parts(out.get_ref().clone());
    let name = outcome.tables[0].name.get(Language::En);
    let sheets = opened(out.into_inner()).sheet_names();
    let number = sheets.iter().position(|sheet| sheet == name).expect("the table's sheet") + 1;
    let rows = &xml[&format!("xl/worksheets/sheet{number}.xml")];
    assert_eq!(rows.matches("<v>0.3333333333333333</v>").count(), 12);
    for code in ["0.0000", "0.000000", "0.00"] {
        assert!(xml["xl/styles.xml"].contains(&format!("formatCode=\"{code}\"")), "{code}");
    }
}

#[test]
fn every_finding_stands_on_the_sheet_of_checks_even_when_the_work_is_stopped() {
    let mut outcome = common::outcome("full", &[]);
    let mut high = NoRetract {}
        .at(Place::Parameters(vec![FORM.parameter("F").unwrap().key()]))
        .graded(Grade::Stop)
        .with("7000 mm/min", "6000 mm/min");
    high.what = t("=el avance es alto", "=feed is high");
    outcome.findings.insert(0, high);
    let coded = ValueNotFinite {}.at(Place::File);
    outcome.findings.insert(1, coded);
    outcome.programs.clear();
    let mut workbook = opened(written(&outcome, Language::Es));
    assert!(!workbook.sheet_names().iter().any(|name| name == "INCR"));
    let range = sheet(&mut workbook, "Avisos");
    let table = checks::table(&outcome.findings);
    assert_eq!(table.rows(), outcome.findings.len());
    assert_eq!(range.height(), table.rows() + 3);
    for (at, column) in table.columns.iter().enumerate() {
        for row in 0..table.rows() {
            let Entry::Text(entry) = column.values.get(row) else { panic!("a number among the checks") };
            assert_eq!(text(&range, row + 3, at), entry.es);
        }
    }
    assert_eq!(text(&range, 3, 0), "Parada");
    assert_eq!(text(&range, 3, 3), "=el avance es alto");
    assert_eq!([text(&range, 2, 1), text(&range, 3, 1), text(&range, 4, 1)], ["Código", NoRetract::RULE.code, "X0005"]);
}

#[test]
fn the_same_outcome_gives_the_same_bytes() {
    let outcome = common::outcome("full", &[("n", Value::Whole(2_500))]);
    assert!(written(&outcome, Language::Es) == written(&outcome, Language::Es));
    assert!(
        written(&common::outcome("full", &[]), Language::En) == written(&common::outcome("full", &[]), Language::En)
    );
}

#[test]
fn no_text_of_the_user_becomes_a_formula_or_breaks_a_sheet() {
    for part in [
        "=cmd|' /C calc'!A0",
        "+1+1",
        "-1",
        "@SUM(A1)",
        "\t=1",
        "nul \0 bell \u{7} esc \u{1B}[2J",
        "</v></c><c><f>1+1</f></c>",
        "_x003D_1",
        "&A&P\"&\"",
        "\u{202E}abc",
    ] {
        let outcome = common::outcome("full", &[("part", Value::Line(part.to_owned()))]);
        let bytes = written(&outcome, Language::En);
        for (name, xml) in parts(bytes.clone()) {
            let mut reader = quick_xml::Reader::from_str(&xml);
            loop {
                match reader.read_event().unwrap_or_else(|error| panic!("{part:?}, {name}: {error}")) {
                    quick_xml::events::Event::Eof => break,
                    quick_xml::events::Event::Start(tag) if tag.name().as_ref() == "f" => {
                        let formula = reader.read_text(tag.name()).expect("a formula");
                        let formula = quick_xml::escape::unescape(&formula).expect("a text").into_owned();
                        // A subtraction of one is not the user's.
                        assert!(part == "-1" || !formula.contains(part), "{part:?}: {formula} in {name}");
                    }
                    _ => {}
                }
            }
            assert!(!xml.contains('\0') && !xml.contains('\u{1B}'), "{part:?}, {name}: a control character");
        }
        let range = sheet(&mut opened(bytes), "DATA");
        let row = (0..range.height()).find(|&row| at(&range, row, 0) == Data::String("part".to_owned()));
        assert_eq!(text(&range, row.expect("the row of the part"), 2), part);
    }
}

#[test]
fn no_sheet_has_a_number_that_is_not_one() {
    for (name, xml) in parts(written(&common::outcome("full", &[]), Language::En)) {
        for word in ["NaN", "NAN", "INF", "inf"] {
            assert!(!xml.contains(&format!("<v>{word}")) && !xml.contains(&format!(">{word}<")), "{word} in {name}");
        }
    }
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for rows in [10, 3_000] {
            let mut outcome = common::outcome("full", &[]);
            let mut values = vec![1.0; rows];
            values[rows - 1] = value;
            outcome.tables[0].columns = vec![Column::numbers("x", Unit::One, Law::None, values)];
            let written = results::write(&outcome, &[], Tables::Live, Language::En, Cursor::new(Vec::new()));
            assert!(matches!(written, Err(WriteError::NotFinite { .. })), "{value} in {rows} rows: {written:?}");
        }
    }
}

#[test]
fn every_chart_finds_all_its_curves() {
    let outcome = common::outcome("full", &[]);
    let xml = parts(written(&outcome, Language::Es));
    let charts: Vec<&String> =
        xml.iter().filter(|(name, _)| name.starts_with("xl/charts/chart")).map(|(_, xml)| xml).collect();
    assert!(!outcome.charts.is_empty());
    assert_eq!(charts.len(), outcome.charts.len());
    let curves: usize = charts.iter().map(|xml| xml.matches("<c:ser>").count()).sum();
    assert_eq!(curves, outcome.charts.iter().map(|chart| chart.series.len()).sum::<usize>());
    // In black, too, a second curve is told from the first.
    let mut dashed = 0;
    for chart in &charts {
        for (at, curve) in chart.split("<c:ser>").skip(1).enumerate() {
            let line = curve.contains("<a:prstDash");
            assert!(!line || at % 2 == 1, "curve {at}");
            dashed += usize::from(line);
        }
    }
    assert!(dashed > 1, "{dashed}");
    // All on one sheet, each of a size of its own that no width of a column changes, and printed two to a page.
    let drawings: Vec<&String> =
        xml.values().filter(|xml| xml.contains("<xdr:wsDr") && xml.contains("<xdr:graphicFrame")).collect();
    let [drawing] = drawings[..] else { panic!("{} drawings with charts", drawings.len()) };
    assert_eq!(drawing.matches("<xdr:oneCellAnchor>").count(), outcome.charts.len());
    assert!(!drawing.contains("twoCellAnchor") && !drawing.contains("<xdr:to>"));
    let sheets = opened(written(&outcome, Language::Es)).sheet_names();
    let number = sheets.iter().position(|sheet| sheet == "GRAFICOS").expect("a sheet of charts") + 1;
    let breaks = xml[&format!("xl/worksheets/sheet{number}.xml")].matches("<brk ").count();
    assert_eq!(breaks, outcome.charts.len().div_ceil(2) - 1);
}

#[test]
fn charts_of_a_long_table_reach_to_its_last_row() {
    let outcome = common::outcome("full", &[("n", Value::Whole(2_999))]);
    for (language, sheet) in [(Language::Es, "'Anexo 4'"), (Language::En, "'Annex 4'")] {
        let xml = parts(written(&outcome, language));
        let charts: Vec<&String> =
            xml.iter().filter(|(name, _)| name.starts_with("xl/charts/chart")).map(|(_, xml)| xml).collect();
        let references: Vec<&str> = charts
            .iter()
            .flat_map(|xml| xml.split("<c:f>").skip(1))
            .map(|rest| rest.split("</c:f>").next().unwrap_or_default())
            .collect();
        for column in ["B", "C"] {
            let whole = format!("{sheet}!${column}$5:${column}$3004");
            assert!(references.contains(&whole.as_str()), "{whole} is not in {references:?}");
        }
        // Only the table of safe points is short.
        let short = |reference: &&&str| !reference.ends_with("$3004");
        assert!(references.iter().filter(short).all(|reference| reference.ends_with("$8")), "{references:?}");
        for chart in &charts {
            let mut reader = quick_xml::Reader::from_str(chart);
            while reader.read_event().expect("well-formed") != quick_xml::events::Event::Eof {}
        }
    }
}

/// The slots of a calibration that has a solution.
fn calibration() -> Vec<(&'static str, Value)> {
    [("H", 60.0), ("d_w", 50.0), ("e_z", 3.0), ("e_x", 4.0), ("d_t", 6.0), ("x0", -200.0), ("z0", -150.0)]
        .into_iter()
        .map(|(symbol, value)| {
            let (_, parameter) = FORM
                .parameters()
                .find(|(_, parameter)| parameter.key == format!("calibration/{symbol}"))
                .expect("a parameter");
            (parameter.key, Value::Real(value))
        })
        .collect()
}

#[test]
fn the_results_workbook_is_an_input_with_the_same_values() {
    for language in Language::ALL {
        for case in ["tfg-2021", "full"] {
            for changes in [Vec::new(), calibration(), vec![("part", Value::Line("=1+1 «álabe»".to_owned()))]] {
                let outcome = common::outcome(case, &changes);
                let filled = rodete::workbook::read(&written(&outcome, language), &[&FORM])
                    .unwrap_or_else(|refusal| panic!("{case} {changes:?}: {:?}", refusal.findings));
                assert_eq!(filled.values.values, outcome.fields.values().values);
                assert_eq!(filled.values.language, language);
                assert!(filled.findings.is_empty(), "{:?}", filled.findings);
            }
        }
    }
}

#[test]
fn results_say_whether_they_can_be_read_again_and_are_right() {
    for (n, small) in [(40, true), (5_000, true), (40_000, false)] {
        let outcome = common::outcome("full", &[("n", Value::Whole(n))]);
        let bytes = written(&outcome, Language::En);
        let read = rodete::workbook::read(&bytes, &[&FORM]);
        let range = sheet(&mut opened(bytes), "SUMMARY");
        let said = text(&range, row_of(&range, "To change something"), 1);
        assert_eq!(said.contains("valid input"), small, "{n}: {said}");
        assert_eq!(said.contains("too large"), !small, "{n}: {said}");
        assert_eq!(read.is_ok(), small, "{n}");
    }
}
