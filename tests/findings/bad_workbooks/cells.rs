//! Section B: cells, units and symbols.

use rodete::finding::Exit;
use rodete::finding::Exit::{Refused, Unreadable};
use rodete::gcode::control::MILLING;
use rodete::text::Language;

use super::workbook::{CALIBRATION, DATA, Expected, Parts, cell, compare, impeller, place, row, sound};

fn at(
    row: &'static str,
    parts: &Parts,
    exit: Exit,
    place: impl Into<String>,
    what: &'static str,
    remedy: &'static str,
) -> Expected {
    Expected { row, bytes: parts.zip(), exit, place: place.into(), what, remedy }
}

/// A fault of one parameter's value cell.
fn value(row: &'static str, key: &str, parts: &Parts, what: &'static str, remedy: &'static str) -> Expected {
    at(row, parts, Refused, cell(key), what, remedy)
}

#[test]
fn every_faulty_value_is_refused_with_its_cell_and_its_remedy() {
    let sound = Parts::sound;
    let text_of_40000 = "x".repeat(40_000);
    let controls = MILLING.map(|control| control.name).join(", ");
    let one_of_the_controls: &'static str = format!("write one of: {controls}").leak();
    compare(vec![
        value(
            "B1 empty",
            "R",
            &sound().cell(DATA, &cell("R"), ""),
            "R (Torus radius, axis to the centre of the meridian) is missing",
            "in C7 write a number from 5 to 1000 mm",
        ),
        value(
            "B1 empty choice",
            "dialect",
            &sound().cell(DATA, &cell("dialect"), ""),
            "is missing",
            one_of_the_controls,
        ),
        value(
            "B1 blanks only",
            "part",
            &sound().string("part", "   "),
            "part (Part) is missing",
            "write a text of up to 200 characters",
        ),
        value(
            "B2 text",
            "R",
            &sound().string("R", "12.5"),
            "R (Torus radius, axis to the centre of the meridian) is the text \"12.5\", not a number",
            "set the cell's format to General if it is Text, and retype 12.5, with the decimal sign of your spreadsheet",
        ),
        value("B3 comma", "e", &sound().string("e", "1,5"), "is the text \"1,5\", not a number", "type the number 1.5"),
        value("B4 groups", "R", &sound().string("R", "1 234,5"), "not a number", "type the number 1234.5"),
        value("B4 points", "R", &sound().string("R", "1.234,5"), "not a number", "type the number 1234.5"),
        value("B4 underscore", "R", &sound().string("R", "1_000"), "not a number", "type the number 1000"),
        value(
            "B4 unit",
            "R",
            &sound().string("R", "12 mm"),
            "not a number",
            "and without the unit: rodete reads it in mm",
        ),
        value(
            "B4 hexadecimal",
            "R",
            &sound().string("R", "0x10"),
            "not a number",
            "type a number, such as 12.5, with the decimal sign",
        ),
        value("B5 nan", "R", &sound().string("R", "nan"), "is the text \"nan\"", "type a number, such as 12.5"),
        value("B5 inf", "R", &sound().string("R", "inf"), "is the text \"inf\"", "type a number, such as 12.5"),
        value("B5 1e400", "R", &sound().string("R", "1e400"), "is the text \"1e400\"", "type a number, such as 12.5"),
        value(
            "B6 NaN",
            "R",
            &sound().number("R", "NaN"),
            "cell C7 holds NaN, which is not a finite number",
            "clear cell C7",
        ),
        value(
            "B6 INF",
            "R",
            &sound().value("R", "t=\"n\"", "<v>INF</v>"),
            "holds INF, which is not a finite number",
            "clear cell C7",
        ),
        value(
            "B6 1e400",
            "R",
            &sound().number("R", "1e400"),
            "holds 1e400, which is not a finite number",
            "clear cell C7",
        ),
        value(
            "B7 abc",
            "R",
            &sound().number("R", "abc"),
            "cell C7 stores \"abc\" as a number",
            "clear cell C7, retype its value",
        ),
        value("B7 12x", "R", &sound().value("R", "t=\"n\"", "<v>12x</v>"), "stores \"12x\" as a number", "clear"),
        value("B7 blanks", "R", &sound().number("R", " 12 "), "stores \" 12 \" as a number", "clear"),
        value(
            "B7 plus",
            "R",
            &sound().value("R", "t=\"n\"", "<v>+infinity</v>"),
            "holds +infinity, which is not a finite number",
            "clear",
        ),
        at(
            "B7 reference",
            &sound().number("R", "1&#50;"),
            Unreadable,
            cell("R"),
            "written in a way that cannot be read safely",
            "clear",
        ),
        at("B7 comment", &sound().number("R", "1<!-- -->2"), Unreadable, cell("R"), "cannot be read safely", "clear"),
        at("B7 CDATA", &sound().number("R", "<![CDATA[12]]>"), Unreadable, cell("R"), "cannot be read safely", "clear"),
        at("B7 two values", &sound().number("R", "1</v><v>2"), Unreadable, cell("R"), "cannot be read safely", "clear"),
        at(
            "B7 value before formula",
            &sound().value("R", "", "<v>25</v><f>20+5</f>"),
            Unreadable,
            cell("R"),
            "cannot be read safely",
            "clear",
        ),
        at(
            "B7 unknown type",
            &sound().value("R", "t=\"q\"", "<v>25</v>"),
            Unreadable,
            cell("R"),
            "is of the unknown type q",
            "clear",
        ),
        value(
            "B8 full width",
            "R",
            &sound().string("R", "\u{ff12}\u{ff15}"),
            "not a number",
            "type the number 25 (the text has the character U+FF12, a full-width digit)",
        ),
        value(
            "B8 Arabic",
            "R",
            &sound().string("R", "\u{662}\u{665}"),
            "not a number",
            "type the number 25 (the text has the character U+0662, an Arabic-Indic digit)",
        ),
        value(
            "B8 minus",
            "B_min",
            &sound().string("B_min", "\u{2212}10"),
            "not a number",
            "type the number -10 (the text has the character U+2212, MINUS SIGN)",
        ),
        value(
            "B8 NBSP",
            "F",
            &sound().string("F", "1\u{a0}200"),
            "not a number",
            "type the number 1200 (the text has the character U+00A0, NO-BREAK SPACE)",
        ),
        value(
            "B9 #DIV/0!",
            "R",
            &sound().value("R", "t=\"e\"", "<f>1/0</f><v>#DIV/0!</v>"),
            "is the error #DIV/0!",
            "in C7 write a number from 5 to 1000 mm",
        ),
        value(
            "B9 #N/A",
            "dialect",
            &sound().value("dialect", "t=\"e\"", "<v>#N/A</v>"),
            "is the error #N/A",
            "write one of",
        ),
        value(
            "B9 #REF!",
            "n",
            &sound().value("n", "t=\"e\"", "<v>#REF!</v>"),
            "is the error #REF!",
            "write a whole number from 2 to 100000",
        ),
        value(
            "B9 #SPILL!",
            "n",
            &sound().value("n", "t=\"e\"", "<v>#SPILL!</v>"),
            "holds the error #SPILL!",
            "clear cell",
        ),
        value(
            "B11 TRUE",
            "R",
            &sound().value("R", "t=\"b\"", "<v>1</v>"),
            "is the truth value TRUE",
            "in C7 write a number from 5 to 1000 mm",
        ),
        value(
            "B11 FALSE choice",
            "splitters",
            &sound().value("splitters", "t=\"b\"", "<v>0</v>"),
            "is the truth value FALSE",
            "write one of: yes, no",
        ),
        value(
            "B12 ISO date",
            "R",
            &sound().value("R", "t=\"d\"", "<v>2023-03-15T00:00:00</v>"),
            "its cell is formatted as a date",
            "set the format of C7 to General",
        ),
        value(
            "B15 twice",
            "R",
            &sound().value("R", "", "<v>25</v></c><c r=\"C7\"><v>26</v>"),
            "the file contains cell C7 twice",
            "clear cell C7",
        ),
        at(
            "B16 inch",
            &sound().cell(DATA, "D7", "<c r=\"D7\" t=\"str\"><v>inch</v></c>"),
            Refused,
            "D7",
            "is given in mm, but its unit cell says \"inch\"",
            "convert the value to mm and write mm in D7",
        ),
        at(
            "B16 emptied",
            &sound().cell(DATA, "D7", ""),
            Refused,
            "D7",
            "cell D7 does not give the unit; the value is in mm",
            "check that the value is in mm and write mm in D7",
        ),
        at(
            "B16 unit of a count",
            &sound().cell(DATA, &format!("D{}", row("N")), &format!("<c r=\"D{}\" t=\"str\"><v>mm</v></c>", row("N"))),
            Refused,
            format!("D{}", row("N")),
            "has no unit, but its unit cell says \"mm\"",
            "empty cell D",
        ),
        value(
            "B17 metres",
            "R",
            &sound().number("R", "0.025"),
            "is 0.025 mm; it must be from 5 to 1000 mm",
            "did you mean 25 mm (typed in metres)?",
        ),
        value(
            "B17 inches",
            "R_B",
            &sound().number("R_B", "0.5"),
            "is 0.5 mm; it must be from 1 to 5000 mm",
            "did you mean 500 mm (typed in metres) or 12.7 mm (typed in inches)?",
        ),
        value(
            "C19 micrometres",
            "R",
            &sound().number("R", "25000"),
            "is 25000 mm; it must be from 5 to 1000 mm",
            "did you mean 25 mm (typed in micrometres)?",
        ),
        value(
            "B19 large",
            "R",
            &sound().number("R", "1e308"),
            "is 1e308 mm; it must be from 5 to 1000 mm",
            "in C7 write a number from 5 to 1000 mm",
        ),
        value(
            "B19 subnormal",
            "R",
            &sound().number("R", "1e-320"),
            "is 1e-320 mm; it must be from 5 to 1000 mm",
            "write a number",
        ),
        value(
            "B19 negative",
            "R",
            &sound().number("R", "-25"),
            "is -25 mm; it must be from 5 to 1000 mm",
            "write a number",
        ),
        value(
            "B21 fraction",
            "n",
            &sound().number("n", "39.5"),
            "is 39.5; it must be a whole number",
            "write a whole number from 2 to 100000",
        ),
        value(
            "B21 huge",
            "N",
            &sound().number("N", "1e12"),
            "is 1000000000000; it must be from 1 to 60",
            "write a whole number from 1 to 60",
        ),
        value(
            "B21 negative",
            "N",
            &sound().number("N", "-1"),
            "is -1; it must be from 1 to 60",
            "write a whole number",
        ),
        value("C3 zero", "n", &sound().number("n", "0"), "is 0; it must be from 2 to 100000", "write a whole number"),
        value(
            "B22 long",
            "part",
            &sound().string("part", &text_of_40000),
            "is more than 32767 characters long",
            "shorten it to 200 characters",
        ),
        value(
            "B22 long choice",
            "style",
            &sound().string("style", &text_of_40000),
            "must be one of: annex, full",
            "write one of",
        ),
        value(
            "choice misspelt",
            "dialect",
            &sound().string("dialect", "Fagor 8055"),
            "is \"Fagor 8055\"; it must be one of",
            "did you mean fagor-8055?",
        ),
        value(
            "choice and a blank that does not break",
            "style",
            &sound().string("style", "full\u{a0}"),
            "is \"full\" with a character that looks like a blank and is none (U+00A0)",
            "type the word anew in",
        ),
        value(
            "choice and the end of a line",
            "style",
            &sound().string("style", "annex\n"),
            "is \"annex\" with a character that looks like a blank and is none (U+000A)",
            "type the word anew in",
        ),
        value(
            "codes",
            "start_codes",
            &sound().string("start_codes", "M3 X100"),
            "has \"X100\", which is not a machine code",
            "write M codes with whole numbers, separated by blanks",
        ),
        value(
            "codes with a bracket",
            "end_codes",
            &sound().string("end_codes", "M30)G0"),
            "has \"M30)G0\", which is not a machine code",
            "write M codes with whole numbers",
        ),
        value(
            "codes with a fraction",
            "end_codes",
            &sound().string("end_codes", "G54.1"),
            "has \"G54.1\"",
            "write M codes with whole numbers",
        ),
    ]);
}

#[test]
fn a_date_format_is_refused_whatever_the_number() {
    let styles = "<cellXfs count=\"2\"><xf numFmtId=\"0\"/><xf numFmtId=\"14\"/></cellXfs>";
    let text = Parts::sound().text("xl/styles.xml");
    let (start, end) = (text.find("<cellXfs").unwrap(), text.find("</cellXfs>").unwrap() + 10);
    let parts = Parts::sound().replace("xl/styles.xml", &text[start..end], styles);
    compare(vec![value(
        "B12",
        "R",
        &parts.value("R", "s=\"1\"", "<v>45000</v>"),
        "its cell is formatted as a date",
        "set the format of C7 to General",
    )]);
}

#[test]
fn a_value_inside_merged_cells_is_refused_with_their_corner() {
    let merged = |range: &str| {
        Parts::sound().replace(
            DATA,
            "</sheetData>",
            &format!("</sheetData><mergeCells count=\"1\"><mergeCell ref=\"{range}\"/></mergeCells>"),
        )
    };
    compare(vec![
        value(
            "B14 across",
            "R",
            &merged("B7:C7"),
            "its cell is inside the merged cells B7:C7, whose value is in B7",
            "unmerge B7:C7 and write the value in C7",
        ),
        value(
            "B14 down",
            "r",
            &merged("C7:C8"),
            "its cell is inside the merged cells C7:C8, whose value is in C7",
            "unmerge C7:C8 and write the value in C8",
        ),
    ]);
}

#[test]
fn symbols_must_be_there_once() {
    let parts = Parts::sound();
    let doubled = "<row r=\"300\"><c r=\"A300\" t=\"str\"><v>R</v></c><c r=\"C300\"><v>26</v></c></row></sheetData>";
    let renamed = parts.clone().cell(DATA, "A7", "<c r=\"A7\" t=\"str\"><v>radius</v></c>");
    compare(vec![
        at(
            "B27 twice",
            &parts.clone().replace(DATA, "</sheetData>", doubled),
            Refused,
            "A7,A300",
            "2 rows have the symbol R",
            "keep only one row R",
        ),
        at(
            "B27 missing",
            &renamed,
            Refused,
            "DATA",
            "the row R (Torus radius, axis to the centre of the meridian) is missing",
            "add a row with R in column A and a number from 5 to 1000 mm in column C",
        ),
        at(
            "B27 other case",
            &parts.clone().cell(
                DATA,
                &format!("A{}", row("eps_v")),
                &format!("<c r=\"A{}\" t=\"str\"><v>EPS_V</v></c>", row("eps_v")),
            ),
            Refused,
            format!("A{}", row("eps_v")),
            "the row eps_v",
            "which says \"EPS_V\", to \"eps_v\"; if that row is another one, add a row with eps_v",
        ),
        at(
            "B27 mistyped",
            &parts.clone().cell(DATA, "A7", "<c r=\"A7\" t=\"str\"><v>RR</v></c>"),
            Refused,
            "A7",
            "the row R (",
            "correct A7, which says \"RR\", to \"R\"; if that row is another one, add a row with R in column A",
        ),
    ]);
}

#[test]
fn a_half_filled_calibration_sheet_lacks_the_rest() {
    let address = cell("calibration/H");
    let parts = Parts::sound().cell(CALIBRATION, &address, &format!("<c r=\"{address}\"><v>50</v></c>"));
    let refusal = impeller(&parts.zip()).unwrap_err();
    assert_eq!(refusal.exit, Refused);
    let missing: Vec<_> = refusal.findings.iter().map(place).collect();
    let expected: Vec<_> =
        ["d_w", "e_z", "e_x", "d_t", "x0", "z0"].iter().map(|key| cell(&format!("calibration/{key}"))).collect();
    assert_eq!(missing, expected);
}

#[test]
fn all_faults_are_listed_at_once_gravest_first() {
    let parts = Parts::sound()
        .number("R", "0.025")
        .string("e", "1,5")
        .number("n", "39.5")
        .number("N", "abc")
        .string("dialect", "?")
        .number("B_max", "0.52")
        .value("F", "", "<f>1+1</f>");
    let refusal = impeller(&parts.zip()).unwrap_err();
    let places: Vec<_> = refusal.findings.iter().map(place).collect();
    let expected: Vec<_> = ["N", "R", "n", "e", "F", "dialect", "B_max"].into_iter().map(cell).collect();
    assert_eq!(places, expected);
    assert!(refusal.findings.is_sorted_by_key(|finding| std::cmp::Reverse(finding.grade)));
}

#[test]
fn a_damaged_second_sheet_is_told_beside_the_faults_of_the_first() {
    let parts = Parts::sound().number("R", "0.025").replace(CALIBRATION, "</worksheet>", "");
    let refusal = impeller(&parts.zip()).unwrap_err();
    assert_eq!(refusal.exit, Unreadable);
    assert_eq!(refusal.findings.iter().map(place).collect::<Vec<_>>(), ["C7", CALIBRATION]);
}

#[test]
fn a_wrong_unit_is_told_beside_a_wrong_value() {
    let parts = Parts::sound().number("R", "1").cell(DATA, "D7", "<c r=\"D7\" t=\"str\"><v>in</v></c>");
    let refusal = impeller(&parts.zip()).unwrap_err();
    assert_eq!(refusal.findings.iter().map(place).collect::<Vec<_>>(), ["C7", "D7"]);
    let empty = Parts::sound().cell(DATA, "D7", "<c r=\"D7\" t=\"str\"><v>in</v></c>").cell(DATA, "C7", "");
    let refusal = impeller(&empty.zip()).unwrap_err();
    assert_eq!(refusal.findings.iter().map(place).collect::<Vec<_>>(), ["C7"]);
}

#[test]
fn a_spanish_workbook_is_refused_in_spanish_words() {
    let parts = Parts::of(&sound(Language::Es)).number("R", "0.025").string("splitters", "quizá");
    let refusal = impeller(&parts.zip()).unwrap_err();
    let said: Vec<_> = refusal.findings.iter().map(|one| (one.what.es.as_ref(), one.remedy.es.as_ref())).collect();
    assert_eq!(
        said,
        [
            (
                "R (Radio del toro, del eje al centro del meridiano) es 0.025 mm y debe estar entre 5 y 1000 mm",
                "¿quiere decir 25 mm (escrito en metros)?"
            ),
            (
                "splitters (Álabes intermedios) es \"quizá\" y debe ser una de estas palabras: sí, no",
                "escriba en C14 una de estas palabras: sí, no"
            ),
        ]
    );
    assert_eq!((refusal.findings[0].value.as_str(), refusal.findings[0].limit.as_str()), ("0.025 mm", "5 … 1000 mm"));
}
