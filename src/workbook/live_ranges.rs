//! Whether every input of a form is there and allowed, as formulas: a red cell at each, and a hidden sheet with one row for each,
//! from which the live form tells what is wrong.
//!
//! Of a number this is its range, of a choice its list, of a text its length, of a date in figures its day, of machine codes their
//! signs; of a list, that no cell is empty that a row needs. What a formula does not see of a block (the order of its words, the size of
//! their numbers) is left to `rodete check`.

use rust_xlsxwriter::{ColNum, Workbook, utility::column_number_to_name};

use super::cell::uncomputed;
use super::error::WriteError;
use super::list_sheet::{self, Gap};
use super::validation::{beyond, range, unknown, unknowns};
use crate::kind::live_form::LiveForm;
use crate::parameter::list::{List, Naming};
use crate::parameter::{FieldKind, Form, Parameter, Sheet};
use crate::text::{Language, Text, t};

/// The hidden sheet: what is asked for, its state, and the words for it where it is not right. The inputs that must be there
/// before anything is computed stand first.
pub const SHEET: &str = "Ranges";
/// The column, from 0, that tells where a cell of a list is empty in a row that is used.
const GAPS: ColNum = 3;
/// The column of what the live form asks of all inputs together, from 0.
const ANSWERS: ColNum = 4;
/// The columns of the derived values that have limits: 1 where one is broken, and what is said of it.
const BROKEN: ColNum = 5;
const TOLD: ColNum = 6;
/// What is not allowed; what is missing, or is no number where one belongs.
const OUTSIDE: u8 = 1;
const NO_NUMBER: u8 = 2;

/// The cell of an answer on a row, from 1, as a defined name refers to it.
#[must_use]
pub fn answer(row: usize) -> String {
    format!("={SHEET}!${}${row}", column_number_to_name(ANSWERS))
}

/// How many inputs are not allowed, as a formula.
#[must_use]
pub fn outside() -> String {
    format!("COUNTIF({SHEET}!$B:$B,{OUTSIDE})")
}

/// How many inputs are missing or are no numbers, as a formula.
#[must_use]
pub fn missing() -> String {
    format!("COUNTIF({SHEET}!$B:$B,{NO_NUMBER})")
}

/// True where so many of the first are numbers within their ranges, as a formula.
#[must_use]
pub fn given(count: usize) -> String {
    format!("SUM({SHEET}!$B$1:$B${count})=0")
}

/// The words for the first input that is not allowed, as a formula that holds where there is one.
#[must_use]
pub fn first_outside() -> String {
    format!("INDEX({SHEET}!$C:$C,MATCH({OUTSIDE},{SHEET}!$B:$B,0))")
}

/// How many derived values break a limit, as a formula.
#[must_use]
pub fn broken() -> String {
    let column = column_number_to_name(BROKEN);
    format!("COUNTIF({SHEET}!${column}:${column},1)")
}

/// The words for the first of them, as a formula that holds where there is one.
#[must_use]
pub fn first_broken() -> String {
    let [told, broken] = [TOLD, BROKEN].map(column_number_to_name);
    format!("INDEX({SHEET}!${told}:${told},MATCH(1,{SHEET}!${broken}:${broken},0))")
}

/// The symbol of the first one that is missing, as a formula that holds where there is one.
#[must_use]
pub fn first_missing() -> String {
    format!("INDEX({SHEET}!$A:$A,MATCH({NO_NUMBER},{SHEET}!$B:$B,0))")
}

/// The symbol of an input with its cell, as a formula: `N (C11)`, on the sheet of the form that is named where it is not the first.
pub fn placed(input: &Parameter, sheet: Option<&str>) -> String {
    let (symbol, name, sheet) = (input.symbol(), input.name, sheet.map_or_else(String::new, |name| format!("{name}!")));
    format!("\"{symbol} ({sheet}\"&ADDRESS(ROW({name}),COLUMN({name}),4)&\")\"")
}

/// An input that is asked for: its symbol, and the formulas of its state and of the words for it.
struct CheckedInput {
    symbol: String,
    state: String,
    words: String,
    /// Of a column that must be filled in every row that is used, where it is not.
    gap: Option<Gap>,
}

impl CheckedInput {
    /// What stands in a cell with a defined name; on which sheet, where it is not the first. `empty` is the state of an empty cell.
    fn cell(parameter: &Parameter, sheet: Option<&str>, empty: &str, language: Language) -> Option<Self> {
        let name = parameter.name;
        let state = match (beyond(&parameter.kind, name), unknown(&parameter.kind, name)) {
            (Some(beyond), _) => {
                format!("IF(ISNUMBER({name}),IF({beyond},{OUTSIDE},0),IF(LEN(TRIM({name}))>0,{NO_NUMBER},{empty}))")
            }
            (None, unknown) => format!("IF(LEN(TRIM({name}))=0,{empty},IF({},{OUTSIDE},0))", unknown?),
        };
        Some(Self {
            symbol: sheet.map_or_else(String::new, |sheet| format!("{sheet}, ")) + parameter.symbol(),
            state: format!("IF(ISERROR({name}),{NO_NUMBER},{state})"),
            words: told(name, &placed(parameter, sheet), parameter, language),
            gap: None,
        })
    }

    /// What stands in a column of a list.
    fn column(list: &List, sheet: &str, parameter: &Parameter, language: Language) -> Option<Self> {
        let cells = list_sheet::cells(list, &format!("{}.{}", list.key, parameter.symbol()), language)?;
        let symbol = format!("{sheet}, {}", parameter.symbol());
        // The bound goes into the condition as a number: as a text it would have the decimal sign of one language.
        let beyond = |min: f64, max: f64| format!("COUNTIF({cells},\"<\"&{min})+COUNTIF({cells},\">\"&{max})");
        let number =
            |broken: &str| format!("IF({broken}>0,{OUTSIDE},IF(COUNTA({cells})>COUNT({cells}),{NO_NUMBER},0))");
        let state = match &parameter.kind {
            FieldKind::Real { min, max } => number(&beyond(*min, *max)),
            FieldKind::Whole { min, max } => {
                let beyond = beyond(f64::from(*min), f64::from(*max));
                number(&format!("{beyond}+(SUM({cells})<>INT(SUM({cells})))"))
            }
            FieldKind::Choice(choices) => {
                let unknown = unknowns(choices, &cells);
                format!("IF(SUMPRODUCT(1*ISERROR({cells}))>0,{OUTSIDE},IF({unknown}<>0,{OUTSIDE},0))")
            }
            FieldKind::Line { .. } if !list.is_program => {
                format!(
                    "IF(SUMPRODUCT(1*ISERROR({cells}))>0,{NO_NUMBER},IF(SUMPRODUCT(1*ISLOGICAL({cells}))>0,{OUTSIDE},0))"
                )
            }
            _ => return None,
        };
        let gap = list_sheet::gap(list, parameter, language).filter(|_| parameter.required && list.columns.len() > 1);
        Some(Self { words: words(&format!("\"{symbol}\""), parameter, language), symbol, state, gap })
    }
}

/// What is said of an input that is not allowed, as a formula; `symbol` is one.
fn words(symbol: &str, parameter: &Parameter, language: Language) -> String {
    static OUT: Text = t("fuera del intervalo admitido", "outside the allowed range");
    static LISTED: Text = t("no es de la lista", "not one of the list");
    match parameter.kind {
        FieldKind::Real { .. } | FieldKind::Whole { .. } => {}
        FieldKind::Choice(_) => return format!("{symbol}&\": {}\"", LISTED.get(language)),
        _ => return format!("{symbol}&\": {}\"", range(parameter).get(language)),
    }
    let (range, unit) = (range(parameter), parameter.unit.label());
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    format!("{symbol}&\": {} ({}{unit})\"", OUT.get(language), range.get(language))
}

/// The same of an input in a cell with a defined name.
fn told(name: &str, symbol: &str, parameter: &Parameter, language: Language) -> String {
    static LOGICAL: Text = t("VERDADERO y FALSO no son texto", "TRUE and FALSE are no text");
    let words = words(symbol, parameter, language);
    match parameter.kind {
        FieldKind::Line { .. } | FieldKind::Date => {
            format!("IF(ISLOGICAL({name}),{symbol}&\": {}\",{words})", LOGICAL.get(language))
        }
        _ => words,
    }
}

/// True as a formula where a cell of a sheet that may stay empty is filled: then the others are missing.
fn begun(sheet: &Sheet) -> String {
    let parameters = sheet.sections.iter().flat_map(|section| section.parameters);
    let filled = parameters.map(|one| format!("LEN(TRIM({}))", one.name)).collect::<Vec<_>>().join("+");
    format!("IF(ISERROR({filled}),TRUE,{filled}>0)")
}

/// What is asked for: what the live form needs, then every other input of the form, and numbers and choices of its lists.
fn asked(form: &Form, live: &LiveForm, language: Language) -> Vec<CheckedInput> {
    let other = |sheet: &'static Sheet| {
        let first = form.sheets.first().is_some_and(|first| first.name == sheet.name);
        (!first).then(|| sheet.name.get(language))
    };
    let missing = NO_NUMBER.to_string();
    let wanted = |name: &str| {
        let own = form.parameters().find(|(_, parameter)| parameter.name == name);
        own.and_then(|(sheet, parameter)| CheckedInput::cell(parameter, other(sheet), &missing, language))
            .unwrap_or_else(|| {
                let symbol = live.rows.iter().find(|row| row.name == name).map_or(name, |row| row.symbol);
                CheckedInput {
                    symbol: symbol.to_owned(),
                    state: format!("IF(ISNUMBER({name}),0,{NO_NUMBER})"),
                    words: format!("\"{symbol}\""),
                    gap: None,
                }
            })
    };
    let others = form.parameters().filter(|(_, parameter)| !live.inputs.contains(&parameter.name));
    let others = others.filter_map(|(sheet, parameter)| {
        let empty = match (parameter.required, sheet.optional) {
            (false, _) => "0".to_owned(),
            (true, false) => missing.clone(),
            (true, true) => format!("IF({},{NO_NUMBER},0)", begun(sheet)),
        };
        CheckedInput::cell(parameter, other(sheet), &empty, language)
    });
    let listed = form.lists.iter().flat_map(|list| {
        let sheet = match &list.naming {
            Naming::One(name) => name.get(language),
            Naming::Numbered(_) => "",
        };
        list.columns.iter().filter_map(move |parameter| CheckedInput::column(list, sheet, parameter, language))
    });
    live.inputs.iter().map(|name| wanted(name)).chain(others).chain(listed).collect()
}

/// Writes the hidden sheet, with what the live form asks all of it; `broken` are, of each derived value with limits, the formula that is
/// true where one is broken and that of the words.
///
/// # Errors
/// For more inputs than a sheet has rows.
pub fn write<const N: usize>(
    workbook: &mut Workbook,
    (form, live): (&Form, &LiveForm),
    broken: &[(String, String)],
    answers: [String; N],
    language: Language,
) -> Result<(), WriteError> {
    let sheet = workbook.add_worksheet().set_name(SHEET)?;
    sheet.set_hidden(true);
    for (row, one) in (0..).zip(asked(form, live, language)) {
        match &one.gap {
            None => {
                sheet.write_string(row, 0, &one.symbol)?;
                sheet.write_formula(row, 1, uncomputed(&one.state))?;
            }
            Some(gap) => {
                let cell = format!("${}${}", column_number_to_name(GAPS), row + 1);
                // An error stands in a list with one, and the column that holds it tells that.
                let is = format!("IF(ISNUMBER({cell}),{cell}>0,FALSE)");
                let symbol = format!("IF({is},\"{0} (\"&{1}&\")\",\"{0}\")", one.symbol, gap.address(&cell));
                sheet.write_formula(row, 0, uncomputed(&symbol))?;
                sheet.write_formula(row, 1, uncomputed(&format!("IF({is},{NO_NUMBER},{})", one.state)))?;
                sheet.write_formula(row, GAPS, uncomputed(&gap.found))?;
            }
        }
        sheet.write_formula(row, 2, uncomputed(&one.words))?;
    }
    for (row, (broken, told)) in (0..).zip(broken) {
        sheet.write_formula(row, BROKEN, uncomputed(&format!("IF({broken},1,0)")))?;
        sheet.write_formula(row, TOLD, uncomputed(told))?;
    }
    for (row, answer) in (0..).zip(answers) {
        sheet.write_formula(row, ANSWERS, uncomputed(&answer))?;
    }
    Ok(())
}
