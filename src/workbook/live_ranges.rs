//! Whether every number of a form is within its allowed range, as formulas: a red cell at each, and a hidden sheet with one row
//! for each, from which the live form tells what is wrong.

use rust_xlsxwriter::Workbook;

use super::cell::uncomputed;
use super::error::WriteError;
use super::list_sheet;
use super::validation::{beyond, range};
use crate::kind::live_form::LiveForm;
use crate::parameter::list::{List, Naming};
use crate::parameter::{FieldKind, Form, Parameter};
use crate::text::{Language, Text, t};

/// The hidden sheet: what is asked for, its state, and the words for it where it is not right. The inputs that must be there
/// before anything is computed stand first.
pub const SHEET: &str = "Ranges";
/// A number that is not within its range; what is missing, or is no number where one belongs.
const OUTSIDE: u8 = 1;
const NO_NUMBER: u8 = 2;

/// How many numbers are outside their ranges, as a formula.
#[must_use]
pub fn outside() -> String {
    format!("COUNTIF({SHEET}!$B:$B,{OUTSIDE})")
}

/// How many numbers are missing or are none, as a formula.
#[must_use]
pub fn missing() -> String {
    format!("COUNTIF({SHEET}!$B:$B,{NO_NUMBER})")
}

/// True where so many of the first are numbers within their ranges, as a formula.
#[must_use]
pub fn given(count: usize) -> String {
    format!("SUM({SHEET}!$B$1:$B${count})=0")
}

/// The words for the first number outside its range, as a formula that holds where there is one.
#[must_use]
pub fn first_outside() -> String {
    format!("INDEX({SHEET}!$C:$C,MATCH({OUTSIDE},{SHEET}!$B:$B,0))")
}

/// The symbol of the first one that is missing, as a formula that holds where there is one.
#[must_use]
pub fn first_missing() -> String {
    format!("INDEX({SHEET}!$A:$A,MATCH({NO_NUMBER},{SHEET}!$B:$B,0))")
}

/// A number that is asked for.
struct Asked {
    symbol: String,
    state: String,
    words: String,
}

impl Asked {
    /// The number in a cell with a defined name.
    fn cell(parameter: &Parameter, wanted: bool, language: Language) -> Option<Self> {
        let name = parameter.name;
        let (beyond, empty) = (beyond(&parameter.kind, name)?, if wanted { NO_NUMBER } else { 0 });
        Some(Self {
            symbol: parameter.symbol().to_owned(),
            state: format!(
                "IF(ISERROR({name}),{NO_NUMBER},IF(ISNUMBER({name}),IF({beyond},{OUTSIDE},0),IF(LEN(TRIM({name}))>0,{NO_NUMBER},{empty})))"
            ),
            words: words(parameter.symbol(), parameter, language),
        })
    }

    /// The numbers in a column of a list.
    fn column(list: &List, sheet: &str, parameter: &Parameter, language: Language) -> Option<Self> {
        let (min, max) = match &parameter.kind {
            FieldKind::Real { min, max } => (*min, *max),
            FieldKind::Whole { min, max } => (f64::from(*min), f64::from(*max)),
            _ => return None,
        };
        let cells = list_sheet::cells(list, &format!("{}.{}", list.key, parameter.symbol()), language)?;
        let symbol = format!("{sheet}, {}", parameter.symbol());
        // The bound goes into the condition as a number: as a text it would have the decimal sign of one language.
        let beyond = format!("COUNTIF({cells},\"<\"&{min})+COUNTIF({cells},\">\"&{max})");
        let broken = match &parameter.kind {
            FieldKind::Whole { .. } => format!("{beyond}+(SUM({cells})<>INT(SUM({cells})))"),
            _ => beyond,
        };
        Some(Self {
            state: format!("IF({broken}>0,{OUTSIDE},IF(COUNTA({cells})>COUNT({cells}),{NO_NUMBER},0))"),
            words: words(&symbol, parameter, language),
            symbol,
        })
    }
}

/// What is said of a number outside its range.
fn words(symbol: &str, parameter: &Parameter, language: Language) -> String {
    static OUT: Text = t("fuera del intervalo admitido", "outside the allowed range");
    let (range, unit) = (range(parameter), parameter.unit.label());
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    format!("{symbol}: {} ({}{unit})", OUT.get(language), range.get(language))
}

/// What is asked for: what the live form needs, then every other number of the form and of its lists.
fn asked(form: &Form, live: &LiveForm, language: Language) -> Vec<Asked> {
    let wanted = |name: &str| {
        let own = form.parameters().find(|(_, parameter)| parameter.name == name);
        own.and_then(|(_, parameter)| Asked::cell(parameter, true, language)).unwrap_or_else(|| {
            let symbol = live.rows.iter().find(|row| row.name == name).map_or(name, |row| row.symbol);
            Asked {
                symbol: symbol.to_owned(),
                state: format!("IF(ISNUMBER({name}),0,{NO_NUMBER})"),
                words: symbol.to_owned(),
            }
        })
    };
    let others = form.parameters().filter(|(_, parameter)| !live.inputs.contains(&parameter.name));
    let others =
        others.filter_map(|(sheet, parameter)| Asked::cell(parameter, parameter.required && !sheet.optional, language));
    let listed = form.lists.iter().flat_map(|list| {
        let sheet = match &list.naming {
            Naming::One(name) => name.get(language),
            Naming::Numbered(_) => "",
        };
        list.columns.iter().filter_map(move |parameter| Asked::column(list, sheet, parameter, language))
    });
    live.inputs.iter().map(|name| wanted(name)).chain(others).chain(listed).collect()
}

/// Writes the hidden sheet.
///
/// # Errors
/// For more inputs than a sheet has rows.
pub fn write(workbook: &mut Workbook, form: &Form, live: &LiveForm, language: Language) -> Result<(), WriteError> {
    let sheet = workbook.add_worksheet().set_name(SHEET)?;
    sheet.set_hidden(true);
    for (row, one) in (0..).zip(asked(form, live, language)) {
        sheet.write_string(row, 0, &one.symbol)?;
        sheet.write_formula(row, 1, uncomputed(&one.state))?;
        sheet.write_string(row, 2, &one.words)?;
    }
    Ok(())
}
