//! The form stands on a sheet of another name, among others, in columns that were moved.

use rodete::kinds::impeller::parameters::FORM;
use rodete::parameter::{FieldKind, Value, Values};
use rodete::text::Language;
use rust_xlsxwriter::Workbook;

use super::common::workbook::{Parts, quick, written};
use super::made::{forms, read, said};

/// A book whose form stands on sheets of these names, its columns A to D at these places; `named`: with defined names.
fn moved(language: Language, sheets: [&str; 2], columns: [u16; 4], named: bool) -> Vec<u8> {
    let values = quick().values(language);
    let mut workbook = Workbook::new();
    let own = workbook.add_worksheet().set_name("DATA 0").expect("a name");
    own.write(0, 0, "own notes").expect("a text");
    let [symbol, meaning, value, unit] = columns;
    let mut names = Vec::new();
    for (described, name) in FORM.sheets.iter().zip(sheets) {
        let sheet = workbook.add_worksheet().set_name(name).expect("a name");
        let headings = match language {
            Language::Es => ["Símbolo", "Significado", "Valor", "Unidad"],
            Language::En => ["Symbol", "Meaning", "Value", "Unit"],
        };
        for (column, heading) in columns.into_iter().zip(headings) {
            sheet.write(4, column, heading).expect("a heading");
        }
        let parameters = described.sections.iter().flat_map(|section| section.parameters);
        for (row, parameter) in (6..).zip(parameters) {
            sheet.write(row, symbol, parameter.symbol()).expect("a symbol");
            sheet.write(row, meaning, parameter.meaning.get(language)).expect("a meaning");
            sheet.write(row, unit, parameter.unit.label()).expect("a unit");
            match values.iter().find(|one| one.0 == parameter.key).map(|one| &one.1) {
                None => {}
                Some(Value::Real(number)) => drop(sheet.write(row, value, *number).expect("a number")),
                Some(Value::Whole(number)) => drop(sheet.write(row, value, *number).expect("a number")),
                Some(Value::Line(line)) => drop(sheet.write(row, value, line).expect("a line")),
                Some(Value::Choice(key)) => {
                    let FieldKind::Choice(choices) = parameter.kind else { panic!("{key}") };
                    let choice = choices.iter().find(|choice| choice.key == *key).expect("a choice");
                    sheet.write(row, value, choice.label.get(language)).expect("a choice");
                }
            }
            let column = char::from(b'A' + u8::try_from(value).expect("a column"));
            names.push((parameter.name, format!("='{}'!${column}${}", name.replace('\'', "''"), row + 1)));
        }
    }
    for (name, formula) in names.into_iter().filter(|_| named) {
        workbook.define_name(name, &formula).expect("a name");
    }
    workbook.save_to_buffer().expect("a workbook")
}

fn plain(values: &Values) -> impl PartialEq + std::fmt::Debug {
    values.values.clone()
}

#[test]
fn the_defined_names_lead_to_the_form_wherever_it_stands() {
    for language in Language::ALL {
        let names = FORM.sheets.iter().map(|sheet| sheet.name.get(language)).collect::<Vec<_>>();
        let written = read(&moved(language, [names[0], names[1]], [0, 1, 2, 3], false));
        for sheets in [["Mis datos", "Máquina's"], [names[0], names[1]], ["DATA 2", names[1]]] {
            for columns in [[0, 1, 2, 3], [3, 4, 5, 6], [1, 2, 6, 8], [20, 21, 25, 26]] {
                let found = read(&moved(language, sheets, columns, true));
                assert_eq!(plain(&found.values), plain(&written.values), "{sheets:?} {columns:?}");
                assert_eq!(found.values.language, language, "{sheets:?} {columns:?}");
                let cell = &found.values.cells["R"];
                assert_eq!(cell.sheet, sheets[0]);
                assert!(
                    cell.cell.starts_with(char::from(b'A' + u8::try_from(columns[2]).expect("a column"))),
                    "{cell:?}"
                );
            }
        }
    }
}

/// The names lead to one of two filled-in forms, and a person may have filled in the other. A sheet that has the name alone is no form.
#[test]
fn of_two_forms_none_is_read_whatever_the_names_lead_to() {
    let sheets = "xl/worksheets/sheet1.xml";
    let calibration = "xl/worksheets/sheet2.xml";
    let book = || Parts::of(&written(rodete::kinds::KINDS[0], quick(), Language::En));
    let renamed = |parts: Parts| parts.replace("xl/workbook.xml", "name=\"CALIBRATION\"", "name=\"DATOS\"");
    let form = book().text(sheets);
    let refused =
        rodete::workbook::read(&renamed(book().put(calibration, form)).zip(), &forms()).expect_err("two forms");
    assert!(said(&refused).starts_with("W0508"), "{}", said(&refused));
    rodete::workbook::read(&renamed(book()).zip(), &forms()).expect("one form");
}

#[test]
fn without_names_a_form_of_another_name_is_refused_as_before() {
    let book = moved(Language::En, ["Mis datos", "X"], [0, 1, 2, 3], false);
    let refused = rodete::workbook::read(&book, &forms()).expect_err("no form");
    assert!(said(&refused).starts_with("W05"), "{}", said(&refused));
}

#[test]
fn a_name_that_leads_to_no_form_changes_nothing() {
    let mut workbook = Workbook::new();
    workbook.add_worksheet().set_name("Notes").expect("a name").write(0, 0, "x").expect("a text");
    workbook.define_name("schema", "=Notes!$C$3").expect("a name");
    let book = workbook.save_to_buffer().expect("a workbook");
    let refused = rodete::workbook::read(&book, &forms()).expect_err("no form");
    assert!(said(&refused).contains("Notes"), "{}", said(&refused));
}
