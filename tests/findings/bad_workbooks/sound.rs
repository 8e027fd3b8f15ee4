//! What must be read, and how.

use rodete::finding::Grade;
use rodete::kinds::KINDS;
use rodete::kinds::impeller::cases::CASES;
use rodete::kinds::impeller::design::Design;
use rodete::kinds::impeller::fade::Fade;
use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::Value;
use rodete::parameter::field::Fields;
use rodete::text::Language;
use rodete::workbook::Filled;

use super::common;
use super::workbook::{CALIBRATION, DATA, Parts, cell, impeller, place, quick, row, sound, written};

fn line<'a>(filled: &'a Filled, key: &str) -> &'a str {
    if let Some(Value::Line(line)) = filled.values.values.get(key) { line } else { panic!("{key}") }
}

#[test]
fn the_quick_case_is_read_in_both_languages_value_for_value() {
    for language in Language::ALL {
        let filled = impeller(&sound(language)).unwrap();
        assert_eq!(filled.form.kind, "impeller");
        assert_eq!(filled.values.language, language);
        assert!(filled.findings.is_empty(), "{:?}", filled.findings);
        let expected: std::collections::BTreeMap<_, _> = quick().values(language).into_iter().collect();
        assert_eq!(filled.values.values, expected);
        assert_eq!(filled.values.cells.len(), FORM.parameters().count());
        let place = &filled.values.cells["R"];
        assert_eq!(
            (place.sheet.as_str(), place.cell.as_str()),
            (FORM.sheets[0].name.get(language), cell("R").as_str())
        );
    }
}

/// What the command for new workbooks writes is read without a finding, value for value.
#[test]
fn the_written_template_is_read_back() {
    for case in &CASES {
        for language in Language::ALL {
            let filled = impeller(&written(KINDS[0], case, language)).unwrap();
            assert!(filled.findings.is_empty(), "{:?}", filled.findings);
            assert_eq!(filled.values.language, language);
            assert_eq!(filled.values.values, case.values(language).into_iter().collect());
        }
    }
}

/// Targets with `./` and `../` are as good as plain ones.
#[test]
fn targets_that_go_through_folders_are_followed() {
    const ROOT: &str = "_rels/.rels";
    const RELATIONS: &str = "xl/_rels/workbook.xml.rels";
    let plain = impeller(&sound(Language::En)).unwrap();
    for (root, one, other) in [
        ("./xl/workbook.xml", "worksheets/sheet1.xml", "worksheets/sheet2.xml"),
        ("xl/workbook.xml", "./worksheets/sheet1.xml", "worksheets/sheet2.xml"),
        ("xl/../xl/./workbook.xml", "../xl/worksheets/sheet1.xml", "/xl/./worksheets/sheet2.xml"),
    ] {
        let parts = Parts::sound()
            .replace(ROOT, "xl/workbook.xml", root)
            .replace(RELATIONS, "\"worksheets/sheet1.xml", &format!("\"{one}"))
            .replace(RELATIONS, "\"worksheets/sheet2.xml", &format!("\"{other}"))
            // One value that is not in the workbook that the parts are of.
            .cell(DATA, &cell("R"), &format!("<c r=\"{}\"><v>27</v></c>", cell("R")));
        let filled = impeller(&parts.zip()).unwrap();
        assert!(filled.findings.is_empty(), "{:?}", filled.findings);
        assert_eq!(filled.values.values["R"], Value::Real(27.0), "{one}");
        assert_eq!(filled.values.values.len(), plain.values.values.len(), "{one}");
    }
    let outside = Parts::sound().replace(RELATIONS, "\"worksheets/sheet1.xml", "\"../../worksheets/sheet1.xml");
    let refusal = impeller(&outside.zip()).unwrap_err();
    assert_eq!(refusal.exit, rodete::finding::Exit::Unreadable);
    let said = &refusal.findings[0].what.en;
    assert!(said.contains("is in \"../../worksheets/sheet1.xml\", outside the package"), "{said}");
}

/// What a formula came to when the workbook was saved is read, and noted with its cell.
#[test]
fn the_stored_value_of_a_formula_is_noted() {
    let formula = |key: &str, text: &str| format!("<c r=\"{}\"><f>{text}</f><v>27</v></c>", cell(key));
    let parts = Parts::sound().cell(DATA, &cell("R"), &formula("R", "20+7"));
    // Formulas that are no input are none of anybody's business.
    let parts = parts.cell(DATA, "E7", "<c r=\"E7\"><f>1+1</f><v>2</v></c>");
    let filled = impeller(&parts.zip()).unwrap();
    assert_eq!(filled.values.values["R"], Value::Real(27.0));
    assert_noted(
        &parts,
        Grade::Note,
        &cell("R"),
        "input values that are results of formulas: 1; rodete reads the stored value",
    );
}

/// A sheet whose name is nearly right is told its right name in the language of the workbook.
#[test]
fn a_renamed_sheet_is_told_its_name_in_the_language_of_the_workbook() {
    let [es, en] = Language::ALL.map(|language| FORM.sheets[1].name.get(language).to_owned());
    assert_ne!(es, en);
    for (language, right, wrong) in [(Language::Es, &es, &en), (Language::En, &en, &es)] {
        let parts = Parts::of(&sound(language)).replace("xl/workbook.xml", right, &right.to_lowercase());
        let filled = impeller(&parts.zip()).unwrap();
        let [told] = filled.findings.as_slice() else { panic!("{:?}", filled.findings) };
        assert_eq!(told.remedy.es, format!("cambie el nombre de la hoja a \"{right}\" para que rodete la lea"));
        assert_eq!(told.remedy.en, format!("rename the sheet to \"{right}\" if rodete should read it"));
        assert!(!told.what.en.contains(wrong.as_str()), "{}", told.what.en);
    }
}

#[test]
fn rows_may_be_moved_because_values_are_found_by_their_symbol() {
    let data = Parts::sound().text(DATA);
    let (start, end) = (data.find("<sheetData>").unwrap() + 11, data.find("</sheetData>").unwrap());
    let mut moved = data.clone();
    // Every row 1000 rows further down.
    for number in (1..=99).rev() {
        moved = moved.replace(&format!("<row r=\"{number}\""), &format!("<row r=\"{}\"", number + 1000));
        for column in ["A", "B", "C", "D"] {
            moved = moved.replace(&format!("r=\"{column}{number}\""), &format!("r=\"{column}{}\"", number + 1000));
        }
    }
    assert_ne!(data[start..end], moved);
    let filled = impeller(&Parts::sound().put(DATA, moved).zip()).unwrap();
    assert_eq!(common::real(&filled.values, "R"), Some(25.0));
    assert_eq!(filled.values.cells["R"].cell, format!("C{}", row("R") + 1000));
}

#[test]
fn capitals_tell_symbols_apart() {
    let filled = impeller(&Parts::sound().zip()).unwrap();
    assert_eq!((common::whole(&filled.values, "n"), common::whole(&filled.values, "N")), (Some(40), Some(4)));
    assert_eq!((common::real(&filled.values, "R"), common::real(&filled.values, "r")), (Some(25.0), Some(15.0)));
}

#[test]
fn a_negative_zero_is_read_as_zero_and_digits_are_kept() {
    let filled = impeller(&Parts::sound().number("X_min", "-0").number("R", "25.000000000000004").zip()).unwrap();
    assert_eq!(common::real(&filled.values, "X_min").map(f64::to_bits), Some(0.0_f64.to_bits()));
    assert_eq!(common::real(&filled.values, "R"), Some(25.000_000_000_000_004));
}

#[test]
fn a_number_in_a_text_cell_is_its_digits_and_codes_are_set_in_order() {
    let parts = Parts::sound().number("part", "1234567").string("start_codes", " m3  M11 M13 ").number("n", "40.0");
    let filled = impeller(&parts.zip()).unwrap();
    assert_eq!(line(&filled, "part"), "1234567");
    assert_eq!(line(&filled, "start_codes"), "M3 M11 M13");
    assert_eq!(common::whole(&filled.values, "n"), Some(40));
}

#[test]
fn a_choice_is_read_in_either_language_in_capitals_and_without_its_accent() {
    for (text, key) in [("sí", "yes"), ("SI", "yes"), ("Yes", "yes"), ("No", "no"), (" yes ", "yes")] {
        let filled = impeller(&Parts::sound().string("splitters", text).zip()).unwrap();
        assert_eq!(filled.values.values.get("splitters"), Some(&Value::Choice(key)), "{text}");
    }
}

/// A workbook of the time before a row was added to the form: an optional row that is not there is an empty one.
#[test]
fn a_workbook_without_the_rows_of_optional_parameters_opens_and_fades_as_published() {
    let optional: Vec<_> = FORM.sheets[0]
        .sections
        .iter()
        .flat_map(|section| section.parameters)
        .filter(|parameter| !parameter.required)
        .map(|parameter| parameter.key)
        .collect();
    assert!(optional.contains(&"splitter_fade") && optional.contains(&"tol"));
    let without = optional.iter().fold(Parts::sound(), |parts, key| {
        ["A", "B", "C", "D"].iter().fold(parts, |parts, column| parts.cell(DATA, &format!("{column}{}", row(key)), ""))
    });
    let filled = impeller(&without.zip()).unwrap();
    assert!(filled.findings.is_empty(), "{:?}", filled.findings);
    for key in &optional {
        assert!(!filled.values.values.contains_key(key) && !filled.values.cells.contains_key(*key), "{key}");
    }
    assert_eq!(common::whole(&filled.values, "N"), Some(4));

    let without = ["A", "B", "C", "D"]
        .iter()
        .fold(Parts::sound(), |parts, column| parts.cell(DATA, &format!("{column}{}", row("splitter_fade")), ""));
    let values = impeller(&without.zip()).unwrap().values;
    assert_eq!(Design::new(&Fields::of(&FORM, values.clone()).unwrap()).unwrap().splitter_fade, Fade::Published);
    let values = impeller(&Parts::sound().zip()).unwrap().values;
    assert_eq!(Design::new(&Fields::of(&FORM, values.clone()).unwrap()).unwrap().splitter_fade, Fade::EachSide);
}

#[test]
fn an_empty_or_missing_calibration_sheet_means_no_calibration() {
    let filled = impeller(&Parts::sound().zip()).unwrap();
    assert!(filled.values.values.keys().all(|key| !key.starts_with("calibration/")));
    assert!(filled.values.cells.contains_key("calibration/H"));

    let without = Parts::sound().replace("xl/workbook.xml", "name=\"CALIBRATION\"", "name=\"Notes\"");
    let filled = impeller(&without.zip()).unwrap();
    assert!(!filled.values.cells.contains_key("calibration/H"));
}

#[test]
fn a_filled_calibration_sheet_is_read() {
    let mut parts = Parts::sound();
    for (key, value) in [("H", 50), ("d_w", 40), ("e_z", 1), ("e_x", 1), ("d_t", 6), ("x0", -200), ("z0", 3)]
        .map(|(key, value)| (key, value))
    {
        let address = cell(&format!("calibration/{key}"));
        parts = parts.cell(CALIBRATION, &address, &format!("<c r=\"{address}\"><v>{value}</v></c>"));
    }
    let filled = impeller(&parts.zip()).unwrap();
    assert_eq!(common::real(&filled.values, "calibration/x0"), Some(-200.0));
    assert_eq!(filled.values.values["calibration/d_t"], Value::Real(6.0));
}

/// What is said of a workbook that is read all the same: grade, place and the beginning of the message.
fn noted(parts: &Parts) -> Vec<(Grade, String, String)> {
    let filled = impeller(&parts.zip()).unwrap();
    filled.findings.iter().map(|finding| (finding.grade, place(finding), finding.what.en.to_string())).collect()
}

#[track_caller]
fn assert_noted(parts: &Parts, grade: Grade, at: &str, what: &str) {
    let noted = noted(parts);
    assert_eq!(noted.len(), 1, "{noted:?}");
    assert!(noted[0].0 == grade && noted[0].1 == at && noted[0].2.contains(what), "{noted:?}");
}

#[test]
fn a6_macros_are_noted_and_not_read() {
    let parts = Parts::sound().put("xl/vbaProject.bin", b"\xD0\xCF".to_vec());
    assert_noted(&parts, Grade::Note, "", "contains macros (.xlsm)");
}

#[test]
fn a12_a_cell_in_the_last_corner_is_passed_over() {
    let far = "<row r=\"1048576\"><c r=\"XFD1048576\"><v>1</v></c></row></sheetData>";
    let parts = Parts::sound().replace(DATA, "</sheetData>", far);
    assert_noted(&parts, Grade::Note, "XFD1048576", "filled cells far from the form");
}

#[test]
fn a15_a_million_empty_cells_are_passed_over() {
    let rows: String =
        (200..=1_048_576).map(|row| format!("<row r=\"{row}\"><c r=\"A{row}\" s=\"0\"/></row>")).collect();
    let parts = Parts::sound().replace(DATA, "</sheetData>", &format!("{rows}</sheetData>"));
    assert!(noted(&parts).is_empty());
}

#[test]
fn a16_a_tag_with_eighty_thousand_attributes_is_read() {
    let many: String = (0..80_000).map(|index| format!(" a{index}=\"\"")).collect();
    let parts = Parts::sound().replace(DATA, "<sheetData>", &format!("<sheetData{many}>"));
    assert!(noted(&parts).is_empty());
}

#[test]
fn a23_a_hidden_sheet_is_read_and_said_so() {
    let parts = Parts::sound().replace("xl/workbook.xml", "name=\"DATA\"", "name=\"DATA\" state=\"veryHidden\"");
    assert_noted(&parts, Grade::Note, "DATA", "is hidden; rodete reads it all the same");
}

#[test]
fn b13_a_percentage_is_read_as_stored_with_a_caution() {
    let styles = "<cellXfs count=\"2\"><xf numFmtId=\"0\"/><xf numFmtId=\"10\"/></cellXfs>";
    let text = Parts::sound().text("xl/styles.xml");
    let (start, end) = (text.find("<cellXfs").unwrap(), text.find("</cellXfs>").unwrap() + 10);
    let parts = Parts::sound().replace("xl/styles.xml", &text[start..end], styles).value("e", "s=\"1\"", "<v>2.1</v>");
    assert_noted(&parts, Grade::Caution, &cell("e"), "rodete reads 2.1, but the sheet shows 210 %");
}

#[test]
fn b14_merged_labels_do_no_harm() {
    let row = row("R");
    let merged = format!(
        "</sheetData><mergeCells count=\"1\"><mergeCell ref=\"A1:E1\"/><mergeCell ref=\"C{row}:D{row}\"/></mergeCells>"
    );
    let parts = Parts::sound().cell(DATA, &format!("D{row}"), "").replace(DATA, "</sheetData>", &merged);
    assert!(noted(&parts).is_empty());
}

#[test]
fn b18_an_angle_that_looks_like_radians_is_a_caution() {
    assert_noted(&Parts::sound().number("B_max", "1.7453"), Grade::Caution, &cell("B_max"), "very small for an angle");
}

#[test]
fn b24_hidden_characters_in_a_name_are_read_raw_and_shown_escaped() {
    let parts = Parts::sound().string("part", "A_x001B_[31m\u{202e}B");
    assert_noted(&parts, Grade::Caution, &cell("part"), "invisible characters: \"A\\u{1b}[31m\\u{202e}B\"");
    assert_eq!(line(&impeller(&parts.zip()).unwrap(), "part"), "A\u{1b}[31m\u{202e}B");
}

#[test]
fn b27_an_unknown_symbol_with_a_value_is_noted_and_a_heading_is_not() {
    let more = "<row r=\"200\"><c r=\"A200\" t=\"inlineStr\"><is><t>foo</t></is></c><c r=\"C200\"><v>1</v></c></row>\
        <row r=\"201\"><c r=\"A201\" t=\"inlineStr\"><is><t>Remarks</t></is></c></row>\
        <row r=\"202\"><c r=\"B202\" t=\"inlineStr\"><is><t>loose</t></is></c><c r=\"G202\"><v>1</v></c></row></sheetData>";
    let parts = Parts::sound().replace(DATA, "</sheetData>", more);
    assert_noted(&parts, Grade::Note, "A200", "the symbol \"foo\" does not belong to this form");
}

#[test]
fn b28_other_sheets_comments_and_derived_values_from_column_g_on_are_not_read() {
    let parts = Parts::sound().put("xl/comments1.xml", b"<!DOCTYPE x><not closed".to_vec()).cell(
        DATA,
        &format!("G{}", row("R")),
        &format!("<c r=\"G{}\" t=\"e\"><v>#DIV/0!</v></c>", row("R")),
    );
    assert!(noted(&parts).is_empty());
}

/// The results workbook holds the form, derived values beside it, and many tables behind it.
#[test]
fn a_results_workbook_of_two_thousand_intervals_is_an_input() {
    let outcome = common::outcome("full", &[("n", Value::Whole(2_000))]);
    for language in Language::ALL {
        let mut written = std::io::Cursor::new(Vec::new());
        rodete::workbook::results::write(
            &outcome,
            &[],
            rodete::workbook::results::Tables::Live,
            language,
            &mut written,
        )
        .unwrap();
        let filled = impeller(&written.into_inner()).unwrap();
        assert!(filled.findings.is_empty(), "{:?}", filled.findings);
        assert_eq!(filled.values.language, language);
        assert_eq!(filled.values.values, outcome.fields.values().values);
    }
}
