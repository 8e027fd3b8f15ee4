//! Sheets of a lathe workbook that are wrong: the cells, the message, the remedy; and what comes back of a sound one.

use std::fs;

use rodete::kinds::lathe::cases::CASES;
use rodete::kinds::lathe::parameters::{PROFILE_KEY, PROGRAM_KEY, TOOLS_KEY};
use rodete::parameter::Value;
use rodete::parameter::list::Row;
use rodete::text::Language;

use super::bench::{Book, bilingual, build, lines, program, run};
use super::workbook::Parts;

const DATA: &str = "xl/worksheets/sheet1.xml";
const TOOLS: &str = "xl/worksheets/sheet2.xml";
const PROGRAM: &str = "xl/worksheets/sheet3.xml";

fn sound() -> Book {
    Book::of(Language::En)
}

fn parts(book: &Book) -> Parts {
    Parts::of(&book.bytes())
}

/// A cell with a text in it.
fn text(address: &str, text: &str) -> String {
    format!("<c r=\"{address}\" t=\"inlineStr\"><is><t>{text}</t></is></c>")
}

/// Builds a workbook and compares its stops: place and message, and a part of the first one's remedy.
fn stops(row: &str, bytes: &[u8], wanted: &[&str], remedy: &str) {
    let (folder, document, exit) = build(bytes);
    let found: Vec<_> = lines(&document).into_iter().filter(|line| line.starts_with("stop ")).collect();
    let wanted: Vec<_> = wanted.iter().map(|one| format!("stop {one}")).collect();
    assert_eq!((&found, exit), (&wanted, 3), "{row}");
    bilingual(&document);
    let first = document["findings"].as_array().unwrap().iter().find(|one| one["grade"] == "stop").unwrap();
    let said = first["remedy"]["en"].as_str().unwrap();
    assert!(said.contains(remedy), "{row}: {said}");
    assert!(!folder.path().join("out").exists(), "{row}");
}

#[test]
fn a_sound_workbook_raises_nothing_and_so_everything_below_is_its_change() {
    let (_folder, document, exit) = build(&sound().bytes());
    assert_eq!(exit, 0, "{:?}", lines(&document));
    let (_folder, document, exit) = build(&parts(&sound()).zip());
    assert_eq!(exit, 0, "{:?}", lines(&document));
}

#[test]
fn contradictions_name_all_their_cells() {
    let real = |values: &[(&'static str, f64)]| {
        values.iter().fold(sound(), |book, (key, value)| book.put(key, Value::Real(*value))).bytes()
    };
    for (values, what, remedy) in [
        (&[("L4", 120.0)][..], "DATA!C19 DATA!C17 L4 is 120 mm; it must be less than L = 120 mm", "use a smaller L4"),
        (&[("L4", 200.0)], "DATA!C19 DATA!C17 L4 is 200 mm; it must be less than L = 120 mm", "longer stock"),
        (
            &[("L", 60.0), ("L5", 30.0)],
            "DATA!C20 DATA!C17 DATA!C19 L5 is 30 mm; it must be less than the stick-out of 30 mm",
            "a smaller facing allowance",
        ),
        (&[("d", 50.0)], "DATA!C18 DATA!C16 the bore d is 50 mm; it must be less than D = 50 mm", "correct d or D"),
        (
            &[("X_min", 100.0), ("X_max", 50.0)],
            "DATA!C27 DATA!C28 X_min is 100; it must be less than X_max = 50",
            "travel",
        ),
        (
            &[("Z_min", 100.0), ("Z_max", 100.0)],
            "DATA!C29 DATA!C30 Z_min is 100; it must be less than Z_max = 100",
            "travel",
        ),
    ] {
        stops(what, &real(values), &[what], remedy);
    }
    let all = sound().put("L4", Value::Real(120.0)).put("d", Value::Real(60.0)).without("point");
    let all = all.change(TOOLS_KEY, |rows| {
        rows[1].values.insert("tools/T", Value::Whole(1));
    });
    stops(
        "all at once",
        &all.bytes(),
        &[
            "DATA!C19 DATA!C17 L4 is 120 mm; it must be less than L = 120 mm",
            "DATA!C18 DATA!C16 the bore d is 60 mm; it must be less than D = 50 mm",
            "TOOLS!A7 two tools are in place 1 of the turret",
            "DATA!C12 the form does not say how the control reads a dimension without a decimal point",
        ],
        "use a smaller L4",
    );
}

#[test]
fn the_rule_for_bare_numbers_is_asked_for_by_its_cell_where_the_control_has_one() {
    let what = "DATA!C12 the form does not say how the control reads a dimension without a decimal point";
    stops(
        "D41",
        &sound().without("point").bytes(),
        &[what],
        "write 'calculator (X100 = 100 mm)' or 'micrometre (X100 = 0.1 mm)'",
    );
    let spanish = Book::of(Language::Es).without("point").bytes();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("t.xlsx"), spanish).unwrap();
    let said = run(folder.path(), &["build", "t.xlsx", "--no-report", "--lang", "es"]);
    assert_eq!(said.exit, 3);
    for wanted in [
        "falta decir cómo lee el control una cota sin punto decimal",
        "hoja \"DATOS\", celda C12",
        "escriba «calculadora (X100 = 100 mm)» o «micras (X100 = 0.1 mm)»",
    ] {
        assert!(said.err.contains(wanted), "{}", said.err);
    }
    // Fagor's numbers are millimetres with or without a point.
    let fagor = ["N5 G92 S2500", "N10 T1 D1", "N20 G97 S900 M3", "N30 G0 X54 Z2", "N40 M30"].map(str::to_owned);
    let book = sound().put("dialect", Value::Choice("fagor-8055-t")).without("point").program(&fagor);
    assert_eq!(build(&book.bytes()).2, 0);
}

/// The workbook's commands take no option for the control: the remedy names the sheet that says it.
#[test]
fn the_remedy_for_a_program_of_another_control_names_the_sheet_of_the_workbook() {
    let what = "PROGRAM!A11 rodete does not follow letter Y of the dialect fanuc-lathe-a";
    stops("another control", &sound().program(&program("G0 Y5.")).bytes(), &[what], "on the sheet DATA of a workbook");
}

/// Both programs have one layout: nothing says which of them a third sheet of it may replace, and the remedy exchanges none.
#[test]
fn a_third_program_is_taken_for_a_copy_of_neither_of_the_two() {
    let with = |name: &str| {
        let parts = parts(&sound());
        let program = parts.text(PROGRAM);
        parts.put("xl/worksheets/sheet5.xml", program).replace(
            "xl/workbook.xml",
            "name=\"PROFILE\"",
            &format!("name=\"{name}\""),
        )
    };
    let told = |name: &str, code: &str| {
        let (_folder, document, _) = build(&with(name).zip());
        let found = document["findings"].as_array().unwrap().iter().find(|one| one["code"] == code).cloned();
        let found = found.unwrap_or_else(|| panic!("{:?}", lines(&document)));
        [&found["what"]["en"], &found["remedy"]["en"]].map(|text| text.as_str().unwrap().to_owned())
    };
    let [what, remedy] = told("PROGRAM 3", "W0523");
    assert!(what.ends_with("laid out like \"PROGRAM\" or \"PROGRAM 2\""), "{what}");
    assert!(remedy.starts_with("if it is the one that counts, decide which of them it replaces"), "{remedy}");
    let [what, remedy] = told("PROGRAM (2)", "W0522");
    assert!(what.ends_with("laid out like \"PROGRAM\""), "{what}");
    assert!(remedy.contains("delete the sheet \"PROGRAM\" and give this one its name"), "{remedy}");
}

#[test]
fn places_and_offsets_are_given_once() {
    let with = |key, row: usize, value| {
        sound().change(TOOLS_KEY, |rows| {
            rows[row].values.insert(key, Value::Whole(value));
        })
    };
    stops(
        "two T",
        &with("tools/T", 1, 1).bytes(),
        &["TOOLS!A7 two tools are in place 1 of the turret"],
        "give each tool its own place",
    );
    stops(
        "two D",
        &with("tools/D", 1, 1).bytes(),
        &["TOOLS!B7 TOOLS!A7 two tools have offset 1"],
        "give each tool its own offset",
    );
    stops(
        "D of another",
        &with("tools/D", 0, 2).bytes(),
        &["TOOLS!B7 TOOLS!A7 two tools have offset 2"],
        "give each tool its own offset",
    );
    stops(
        "T 9",
        &with("tools/T", 1, 9).bytes(),
        &["TOOLS!A7 T (place in the turret; empty: not mounted) is 9; it must be from 1 to 8"],
        "from 1 to 8",
    );
}

#[test]
fn a_tool_says_what_it_needs_and_cannot_be() {
    let without = |row: usize, key: &'static str| {
        sound().change(TOOLS_KEY, |rows| {
            rows[row].values.remove(key);
        })
    };
    stops(
        "IC",
        &without(0, "tools/IC").bytes(),
        &["TOOLS!F6 tool 1 needs IC (inscribed circle; body of a centre drill)"],
        "fill in the cell",
    );
    stops("shape", &without(0, "tools/shape").bytes(), &["TOOLS!E6 tool 1 needs shape"], "ISO 1832");
    stops(
        "psi",
        &without(3, "tools/psi").bytes(),
        &["TOOLS!L9 tool 4 needs psi (thread or point angle)"],
        "fill in the cell",
    );
    let with = |key: &'static str, value| {
        sound().change(TOOLS_KEY, |rows| {
            rows[0].values.insert(key, Value::Real(value));
        })
    };
    let cells = "TOOLS!D6 TOOLS!E6 TOOLS!F6 TOOLS!G6 TOOLS!H6 TOOLS!I6";
    for (key, value, what) in [
        ("tools/phi2", 150.0, "tool 1: φ1 + φ2 + the insert's angle are not 180°"),
        ("tools/R", 20.0, "tool 1: the nose radius is too large for the insert"),
    ] {
        stops(key, &with(key, value).bytes(), &[&format!("{cells} {what}")], "check the sizes of the tool");
    }
    // The cells are those of the sizes that its type has, or of its holder.
    for (row, key, value, said) in [
        (2, "tools/R", 5.0, "TOOLS!D8 TOOLS!G8 TOOLS!J8 TOOLS!K8 tool 3: the nose radius is too large for the insert"),
        (
            3,
            "tools/p_min",
            3.5,
            "TOOLS!D9 TOOLS!G9 TOOLS!K9 TOOLS!L9 TOOLS!M9 TOOLS!N9 tool 4: a size of the tool is not possible",
        ),
        (4, "tools/h", 2.0, "TOOLS!D10 TOOLS!J10 TOOLS!K10 TOOLS!L10 tool 5: a size of the tool is not possible"),
        (5, "tools/c", 1.0, "TOOLS!R11 TOOLS!S11 TOOLS!T11 tool 6: the bar reaches past the tip"),
    ] {
        let book = sound().change(TOOLS_KEY, |rows| {
            rows[row].values.insert(key, Value::Real(value));
        });
        stops(key, &book.bytes(), &[said], "check the sizes of the tool");
    }
    stops(
        "p_min",
        &without(3, "tools/p_min").bytes(),
        &["TOOLS!M9 tool 4 needs p_min (minimum lead)"],
        "fill in the cell",
    );
    stops(
        "c",
        &without(5, "tools/c").bytes(),
        &["TOOLS!T11 tool 6 needs c (from the tip to the centre of the bar)"],
        "fill in the cell",
    );
    let comma = sound().change(TOOLS_KEY, |rows| {
        rows[0].values.insert("tools/R", Value::Line("0,8".to_owned()));
    });
    stops("B3", &comma.bytes(), &["TOOLS!G6 R (nose radius) is the text \"0,8\", not a number"], "type the number 0.8");
}

#[test]
fn a_profile_that_cannot_be_drawn_is_refused() {
    let profile = |rows: &[(&'static str, f64, f64, Option<f64>)]| {
        let row = |&(g, x, z, r): &(&'static str, f64, f64, Option<f64>)| Row {
            values: [("profile/G", Value::Choice(g)), ("profile/X", Value::Real(x)), ("profile/Z", Value::Real(z))]
                .into_iter()
                .chain(r.map(|r| ("profile/R", Value::Real(r))))
                .collect(),
            ..Row::default()
        };
        let rows: Vec<Row> = rows.iter().map(row).collect();
        Book { lists: sound().lists, ..sound() }.list(rodete::parameter::list::Rows {
            list: PROFILE_KEY,
            sheet: String::new(),
            rows,
        })
    };
    let start = ("1", 20.0, 0.0, None);
    for (rows, what, remedy) in [
        (
            vec![start, ("2", 50.0, -20.0, Some(5.0))],
            "PROFILE!D7 the profile's arc has a radius of 5 mm and a chord of 25 mm: it does not reach its end",
            "at least 12.5 mm",
        ),
        (vec![start, ("3", 50.0, -15.0, None)], "PROFILE!D7 the arc of the profile has no radius", "write the radius"),
        (
            vec![start, ("1", 30.0, -5.0, None), ("2", 30.0, -5.0, Some(5.0))],
            "PROFILE!D8 the profile's arc has a radius of 5 mm and a chord of 0 mm: it does not reach its end",
            "the arc ends where it begins",
        ),
        (vec![start], "PROFILE!A6 the profile has only one point", "add the end point"),
    ] {
        stops(what, &profile(&rows).bytes(), &[what], remedy);
    }
    let (_folder, document, exit) = build(&profile(&[start, ("2", 50.0, -15.0, Some(15.0))]).bytes());
    assert_eq!(exit, 0, "{:?}", lines(&document));
    let (_folder, document, exit) = build(&profile(&[start, ("2", 50.0, -20.0, Some(12.5))]).bytes());
    assert_eq!(exit, 0, "a half circle: {:?}", lines(&document));
}

#[test]
fn an_emptied_unit_of_a_list_is_told_with_its_cell_also_where_the_whole_row_is() {
    let units = [
        ("F", "IC", "mm"),
        ("G", "R", "mm"),
        ("H", "phi1", "°"),
        ("I", "phi2", "°"),
        ("J", "w", "mm"),
        ("K", "h", "mm"),
        ("L", "psi", "°"),
        ("M", "p_min", "mm"),
        ("N", "p_max", "mm"),
        ("R", "b", "mm"),
        ("S", "l", "mm"),
        ("T", "c", "mm"),
        ("U", "Q_x", "mm"),
        ("V", "Q_z", "mm"),
    ];
    let empty = |columns: &[(&str, &str, &str)]| {
        columns.iter().fold(parts(&sound()), |parts, (column, ..)| parts.cell(TOOLS, &format!("{column}4"), "")).zip()
    };
    let told = |&(column, symbol, unit): &(&str, &str, &str)| {
        format!("TOOLS!{column}4 {symbol} is given in {unit}, but {column}4 is empty")
    };
    stops("one", &empty(&units[2..3]), &[&told(&units[2])], "convert the values to ° and write ° in H4");
    let all: Vec<String> = units.iter().map(told).collect();
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    stops("all", &empty(&units), &all, "convert the values to mm and write mm in F4");
    // A list that may be left out and holds nothing has nothing to be read in another unit; what has no unit needs none.
    let profile = "xl/worksheets/sheet5.xml";
    let bare = |book: &Book| {
        ["B4", "C4", "D4"].into_iter().fold(parts(book), |parts, cell| parts.cell(profile, cell, "")).zip()
    };
    let (_folder, document, exit) = build(&bare(&sound()));
    assert_eq!(exit, 0, "{:?}", lines(&document));
    let row = |X: f64, Z: f64| Row {
        values: [("profile/G", Value::Choice("1")), ("profile/X", Value::Real(X)), ("profile/Z", Value::Real(Z))]
            .into(),
        ..Row::default()
    };
    let rows = vec![row(20.0, 0.0), row(20.0, -20.0)];
    let filled = sound().list(rodete::parameter::list::Rows { list: PROFILE_KEY, sheet: String::new(), rows });
    let told = ["B4 X", "C4 Z", "D4 R"].map(|one| {
        let (cell, symbol) = one.split_once(' ').unwrap();
        format!("PROFILE!{cell} {symbol} is given in mm, but {cell} is empty")
    });
    stops("a profile", &bare(&filled), &told.each_ref().map(String::as_str), "convert the values to mm");
}

#[test]
fn headings_and_sheets_that_are_missing_are_named() {
    let renamed = |part, address, to: &str| parts(&sound()).cell(part, address, &text(address, to)).zip();
    stops(
        "BLOCK",
        &renamed(PROGRAM, "A5", "BLOQUES"),
        &["PROGRAM the row of headings, which begins with \"BLOCK\" in column A, is missing"],
        "write \"BLOCK\" in column A",
    );
    stops(
        "b",
        &renamed(TOOLS, "R5", "breadth"),
        &["TOOLS the column \"b\" is missing"],
        "write \"b\" in the row of headings",
    );
    stops(
        "R",
        &renamed(TOOLS, "G5", "Radius"),
        &["TOOLS!A6 tool 1 needs R", "TOOLS!A7 tool 2 needs R", "TOOLS!A11 tool 6 needs R"],
        "the sheet has no column R: write its heading",
    );
    stops(
        "a unit",
        &renamed(TOOLS, "G4", "inch"),
        &["TOOLS!G4 R is given in mm, but G4 says \"inch\""],
        "convert the values to mm",
    );
    let called = |from: &str, to: &str| {
        let from = format!("<sheet name=\"{from}\"");
        parts(&sound()).replace("xl/workbook.xml", &from, &format!("<sheet name=\"{to}\"")).zip()
    };
    stops(
        "no TOOLS",
        &called("TOOLS", "OTHER"),
        &["file the sheet \"TOOLS\" is missing"],
        "under another name, call it \"TOOLS\"",
    );
    stops(
        "no PROGRAM",
        &called("PROGRAM", "OTHER"),
        &["file the sheet \"PROGRAM\" is missing"],
        "under another name, call it \"PROGRAM\"",
    );
    let (_folder, document, exit) = build(&called("PROGRAM", "Program "));
    assert_eq!(exit, 3);
    let found = lines(&document);
    let hint = "caution Program  rodete does not read the sheet \"Program \": its name is not \"PROGRAM\"";
    assert!(found.iter().any(|line| line == hint), "{found:?}");
    let (_folder, document, exit) = build(&called("PROFILE", "OTHER"));
    assert_eq!(exit, 0, "{:?}", lines(&document));
}

#[test]
fn a_block_must_be_a_text() {
    let with = |inner: &str| parts(&sound()).cell(PROGRAM, "A8", inner).zip();
    let text = "in A8 write a text of up to 200 characters";
    let block = "PROGRAM!A8 BLOCK (one block per row)";
    stops("a truth", &with("<c r=\"A8\" t=\"b\"><v>1</v></c>"), &[&format!("{block} is the truth value TRUE")], text);
    stops(
        "an error",
        &with("<c r=\"A8\" t=\"e\"><v>#DIV/0!</v></c>"),
        &[&format!("{block} is the error #DIV/0!")],
        text,
    );
    stops(
        "a formula",
        &with("<c r=\"A8\"><f>1+1</f></c>"),
        &[&format!("{block}: A8 holds a formula without a stored value")],
        "open the workbook in Excel or LibreOffice and save it",
    );
    // A number is taken as it stands, and no block begins with one.
    let number = with("<c r=\"A8\"><v>5</v></c>");
    let (_folder, document, exit) = build(&number);
    assert_eq!(exit, 3);
    assert!(
        lines(&document).contains(&"stop PROGRAM!A8 character '5' is not allowed".to_owned()),
        "{:?}",
        lines(&document)
    );
}

#[test]
fn a_block_formatted_as_a_date_is_refused() {
    let parts = parts(&sound());
    let styles = parts.text("xl/styles.xml");
    // A cell format of the built-in date form behind all others.
    let at = styles.find("</cellXfs>").unwrap();
    let count = styles[styles.find("<cellXfs").unwrap()..at].matches("<xf ").count();
    let styles = format!(
        "{}<xf numFmtId=\"14\" fontId=\"0\" fillId=\"0\" borderId=\"0\" xfId=\"0\" applyNumberFormat=\"1\"/>{}",
        &styles[..at],
        &styles[at..]
    );
    let styles = styles.replace(&format!("<cellXfs count=\"{count}\""), &format!("<cellXfs count=\"{}\"", count + 1));
    let cell = format!("<c r=\"A8\" s=\"{count}\"><v>45000</v></c>");
    let bytes = parts.put("xl/styles.xml", styles).cell(PROGRAM, "A8", &cell).zip();
    stops(
        "B12",
        &bytes,
        &["PROGRAM!A8 BLOCK (one block per row): its cell is formatted as a date"],
        "set the format of A8 to General and retype the value",
    );
}

#[test]
fn merged_cells_hide_no_value() {
    let merged = |part: &str, range: &str| {
        let parts = parts(&sound());
        let sheet = parts.text(part);
        let merge = format!("<mergeCell ref=\"{range}\"/>");
        let sheet = match sheet.find("<mergeCells count=\"1\">") {
            Some(_) => sheet
                .replace("<mergeCells count=\"1\">", "<mergeCells count=\"2\">")
                .replace("</mergeCells>", &format!("{merge}</mergeCells>")),
            None => sheet.replace("</sheetData>", &format!("</sheetData><mergeCells count=\"1\">{merge}</mergeCells>")),
        };
        parts.put(part, sheet)
    };
    let block = "BLOCK (one block per row): its cell is inside the merged cells A8:A9, whose value is in A8";
    stops("over a block", &merged(PROGRAM, "A8:A9").zip(), &[&format!("PROGRAM!A9 {block}")], "unmerge A8:A9");
    // As a spreadsheet leaves it: what stood there is gone, and the row would be missing.
    let emptied = merged(PROGRAM, "A8:A9").cell(PROGRAM, "A9", "").zip();
    stops("over a row that is gone", &emptied, &[&format!("PROGRAM!A9 {block}")], "unmerge A8:A9");
    stops(
        "over a radius",
        &merged(TOOLS, "G6:H6").zip(),
        &["TOOLS!H6 phi1 (cutting-edge angle φ1): its cell is inside the merged cells G6:H6, whose value is in G6"],
        "unmerge G6:H6",
    );
    stops(
        "over the diameter",
        &merged(DATA, "B16:C16").zip(),
        &["DATA!C16 D (Stock diameter D): its cell is inside the merged cells B16:C16, whose value is in B16"],
        "unmerge B16:C16",
    );
    // Merged cells with nothing in them below the last block are none of the program's.
    let (_folder, document, exit) = build(&merged(PROGRAM, "A60:A61").zip());
    assert_eq!(exit, 0, "{:?}", lines(&document));
}

#[test]
fn the_results_are_an_input_that_comes_to_the_same() {
    let second = program("G0 X44.|G1 Z-20. F0.2|U12.|G0 Z2.");
    let book = Book::new(&program("G0 X46.|G1 Z-30. F0.2|U8.|G0 Z2.|M98 P0005"))
        .second(&second)
        .subprogram("O0005", &["G0 X48. Z2.", "G1 Z-40. F0.2", "U6.", "G0 Z2.", "M99"])
        .put("Z_s", Value::Real(-2.0));
    let (folder, document, exit) = build(&book.bytes());
    assert_eq!(exit, 0, "{:?}", lines(&document));
    let results = fs::read(folder.path().join("out/part-results.xlsx")).unwrap();
    let (again, repeated, exit) = build(&results);
    assert_eq!(exit, 0, "{:?}", lines(&repeated));
    for name in ["program.nc", "program-2.nc", "part.stl"] {
        let read = |folder: &tempfile::TempDir| fs::read(folder.path().join(format!("out/part-{name}"))).unwrap();
        assert_eq!(read(&folder), read(&again), "{name}");
    }
    assert_eq!(document["quantities"], repeated["quantities"]);
    for case in &CASES {
        for language in Language::ALL {
            let book = Book { values: case.values(language), lists: (case.listed)(language), language };
            let (folder, first, exit) = build(&book.bytes());
            assert_eq!(exit, 0, "{} {:?}", case.name, lines(&first));
            let (again, second, exit) = build(&fs::read(folder.path().join("out/part-results.xlsx")).unwrap());
            assert_eq!(exit, 0, "{} {:?}", case.name, lines(&second));
            let read = |folder: &tempfile::TempDir| fs::read(folder.path().join("out/part-program.nc")).unwrap();
            assert_eq!((read(&folder), &first["quantities"]), (read(&again), &second["quantities"]), "{}", case.name);
        }
    }
}

#[test]
fn a_program_without_blocks_is_refused_by_its_sheet() {
    let book = sound().change(PROGRAM_KEY, Vec::clear);
    stops("no block", &book.bytes(), &["PROGRAM there are no rows below the headings"], "write at least one row");
}
