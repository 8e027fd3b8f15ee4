//! Whether every input of a form is there and allowed, as formulas: a red cell at each, and a hidden sheet with one row for each,
//! from which the live form tells what is wrong.
//!
//! Of a number this is its range, of a choice its list, of a text its length, of machine codes their signs. What a formula does
//! not see of a block (the order of its words, the size of their numbers) is left to `rodete check`.

use rust_xlsxwriter::{ColNum, Workbook, utility::column_number_to_name};

use super::cell::uncomputed;
use super::error::WriteError;
use super::list_sheet;
use super::validation::{beyond, range, spellings, unknown};
use crate::kind::live_form::LiveForm;
use crate::parameter::list::{List, Naming};
use crate::parameter::{FieldKind, Form, Parameter, Sheet};
use crate::text::{Language, Text, t};

/// The hidden sheet: what is asked for, its state, and the words for it where it is not right. The inputs that must be there
/// before anything is computed stand first.
pub const SHEET: &str = "Ranges";
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
struct Asked {
    symbol: String,
    state: String,
    words: String,
}

impl Asked {
    /// What stands in a cell with a defined name; on which sheet, where it is not the first.
    fn cell(parameter: &Parameter, sheet: Option<&str>, wanted: bool, language: Language) -> Option<Self> {
        let (name, empty) = (parameter.name, if wanted { NO_NUMBER } else { 0 });
        let state = match (beyond(&parameter.kind, name), unknown(&parameter.kind, name)) {
            (Some(beyond), _) => {
                format!("IF(ISNUMBER({name}),IF({beyond},{OUTSIDE},0),IF(LEN(TRIM({name}))>0,{NO_NUMBER},{empty}))")
            }
            (None, unknown) => format!("IF(LEN(TRIM({name}))=0,{empty},IF({},{OUTSIDE},0))", unknown?),
        };
        Some(Self {
            symbol: parameter.symbol().to_owned(),
            state: format!("IF(ISERROR({name}),{NO_NUMBER},{state})"),
            words: words(&placed(parameter, sheet), parameter, language),
        })
    }

    /// What stands in a column of a list.
    fn column(list: &List, sheet: &str, parameter: &Parameter, language: Language) -> Option<Self> {
        let cells = || list_sheet::cells(list, &format!("{}.{}", list.key, parameter.symbol()), language);
        let symbol = format!("{sheet}, {}", parameter.symbol());
        let (min, max) = match &parameter.kind {
            FieldKind::Real { min, max } => (*min, *max),
            FieldKind::Whole { min, max } => (f64::from(*min), f64::from(*max)),
            FieldKind::Choice(choices) => {
                let cells = cells()?;
                let known =
                    spellings(choices).iter().map(|word| format!("-COUNTIF({cells},\"{word}\")")).collect::<String>();
                let words = words(&format!("\"{symbol}\""), parameter, language);
                return Some(Self { symbol, state: format!("IF(COUNTA({cells}){known}<>0,{OUTSIDE},0)"), words });
            }
            _ => return None,
        };
        let cells = cells()?;
        // The bound goes into the condition as a number: as a text it would have the decimal sign of one language.
        let beyond = format!("COUNTIF({cells},\"<\"&{min})+COUNTIF({cells},\">\"&{max})");
        let broken = match &parameter.kind {
            FieldKind::Whole { .. } => format!("{beyond}+(SUM({cells})<>INT(SUM({cells})))"),
            _ => beyond,
        };
        Some(Self {
            state: format!("IF({broken}>0,{OUTSIDE},IF(COUNTA({cells})>COUNT({cells}),{NO_NUMBER},0))"),
            words: words(&format!("\"{symbol}\""), parameter, language),
            symbol,
        })
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

/// What is asked for: what the live form needs, then every other input of the form, and numbers and choices of its lists.
fn asked(form: &Form, live: &LiveForm, language: Language) -> Vec<Asked> {
    let other = |sheet: &'static Sheet| {
        let first = form.sheets.first().is_some_and(|first| first.name == sheet.name);
        (!first).then(|| sheet.name.get(language))
    };
    let wanted = |name: &str| {
        let own = form.parameters().find(|(_, parameter)| parameter.name == name);
        own.and_then(|(sheet, parameter)| Asked::cell(parameter, other(sheet), true, language)).unwrap_or_else(|| {
            let symbol = live.rows.iter().find(|row| row.name == name).map_or(name, |row| row.symbol);
            Asked {
                symbol: symbol.to_owned(),
                state: format!("IF(ISNUMBER({name}),0,{NO_NUMBER})"),
                words: format!("\"{symbol}\""),
            }
        })
    };
    let others = form.parameters().filter(|(_, parameter)| !live.inputs.contains(&parameter.name));
    let others = others.filter_map(|(sheet, parameter)| {
        Asked::cell(parameter, other(sheet), parameter.required && !sheet.optional, language)
    });
    let listed = form.lists.iter().flat_map(|list| {
        let sheet = match &list.naming {
            Naming::One(name) => name.get(language),
            Naming::Numbered(_) => "",
        };
        list.columns.iter().filter_map(move |parameter| Asked::column(list, sheet, parameter, language))
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
        sheet.write_string(row, 0, &one.symbol)?;
        sheet.write_formula(row, 1, uncomputed(&one.state))?;
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
