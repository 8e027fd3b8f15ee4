//! What a value cell admits: as words for the sheet, as the cell's own validation, and as the red of what it does not admit.

use rust_xlsxwriter::{ConditionalFormatFormula, DataValidation, DataValidationRule, XlsxError};

use super::cell::shortened;
use super::style::Styles;
use super::value::DATE;
use crate::parameter::{FieldKind, Parameter};
use crate::text::{Language, Text, t};

/// Excel's limits for titles and messages, in UTF-16 units.
const TITLE: usize = 32;
const MESSAGE: usize = 255;

/// The most characters of a line of machine codes.
pub(super) const CODES: u32 = 200;

/// The allowed range in words, as `5 to 1000`; empty for the schema.
#[must_use]
pub fn range(parameter: &Parameter) -> Text {
    match &parameter.kind {
        FieldKind::Real { min, max } => Text::new(format!("de {min} a {max}"), format!("{min} to {max}")),
        FieldKind::Whole { min, max } => {
            Text::new(format!("entero de {min} a {max}"), format!("whole number, {min} to {max}"))
        }
        FieldKind::Choice(choices) => {
            let join = |language: Language, or: &str| {
                let labels: Vec<&str> = choices.iter().map(|choice| choice.label.get(language)).collect();
                match labels.split_last() {
                    Some((last, rest)) if !rest.is_empty() => format!("{} {or} {last}", rest.join(", ")),
                    _ => labels.concat(),
                }
            };
            Text::new(join(Language::Es, "o"), join(Language::En, "or"))
        }
        FieldKind::Line { max } => Text::new(format!("hasta {max} caracteres"), format!("up to {max} characters")),
        FieldKind::Date => t("una fecha, como 2026-11-23", "a date, such as 2026-11-23"),
        FieldKind::Codes => t(
            "códigos G o M con número entero, separados por espacios",
            "codes G or M with a whole number, separated by blanks",
        ),
        FieldKind::Block => t(
            "un bloque: códigos G, luego X, Y, Z con su número, luego códigos M",
            "one block: G codes, then X, Y, Z with their numbers, then M codes",
        ),
        FieldKind::Schema => t("", ""),
    }
}

/// The formula that is true where a number is not within its range; none for a parameter that is no number.
pub(super) fn beyond(kind: &FieldKind, cell: &str) -> Option<String> {
    match kind {
        FieldKind::Real { min, max } => Some(format!("OR({cell}<{min},{cell}>{max})")),
        FieldKind::Whole { min, max } => Some(format!("OR({cell}<{min},{cell}>{max},{cell}<>INT({cell}))")),
        _ => None,
    }
}

/// Red for a cell, or the first of some, with a number outside its range or with a text; none for a parameter that is no number.
#[must_use]
pub fn red(parameter: &Parameter, cell: &str, styles: &Styles) -> Option<ConditionalFormatFormula> {
    let beyond = beyond(&parameter.kind, cell)?;
    let rule = format!("=IF(ISERROR({cell}),TRUE,IF(ISNUMBER({cell}),{beyond},LEN(TRIM({cell}))>0))");
    Some(ConditionalFormatFormula::new().set_rule(rule.as_str()).set_format(styles.stale.clone()))
}

/// The allowed range and the parameter's note, for column E and the input message.
#[must_use]
pub fn range_and_note(parameter: &Parameter, language: Language) -> String {
    static MAY_BE_EMPTY: Text = t("Puede quedar vacía", "May stay empty");
    let range = range(parameter);
    let range = range.get(language);
    let mut note = parameter.note.get(language);
    if note.is_empty() && !parameter.required {
        note = MAY_BE_EMPTY.get(language);
    }
    match (range.is_empty(), note.is_empty() || note == range) {
        (_, true) => range.to_owned(),
        (true, false) => note.to_owned(),
        (false, false) => format!("{range}. {note}"),
    }
}

/// The validation of a parameter's value cell, with its messages; `optional` says that the cell may be left empty.
///
/// # Errors
/// For a choice whose labels together are longer than a cell's list may be.
pub fn validation(parameter: &Parameter, optional: bool, language: Language) -> Result<DataValidation, XlsxError> {
    static WRONG: Text = t("Valor no admitido", "Value not allowed");
    let rule = DataValidation::new();
    let rule = match &parameter.kind {
        FieldKind::Real { min, max } => rule.allow_decimal_number(DataValidationRule::Between(*min, *max)),
        FieldKind::Whole { min, max } => {
            let bound = |limit: u32| i32::try_from(limit).unwrap_or(i32::MAX);
            rule.allow_whole_number(DataValidationRule::Between(bound(*min), bound(*max)))
        }
        FieldKind::Choice(choices) => {
            let labels: Vec<&str> = choices.iter().map(|choice| choice.label.get(language)).collect();
            rule.allow_list_strings(&labels)?
        }
        FieldKind::Line { max } => {
            rule.allow_text_length(DataValidationRule::Between(1, u32::try_from(*max).unwrap_or(u32::MAX)))
        }
        FieldKind::Date => {
            rule.allow_text_length(DataValidationRule::Between(1, u32::try_from(DATE).unwrap_or(u32::MAX)))
        }
        FieldKind::Codes | FieldKind::Block => rule.allow_text_length(DataValidationRule::Between(1, CODES)),
        FieldKind::Schema => rule.allow_any_value(),
    };
    let meaning = parameter.meaning.get(language);
    let unit = parameter.unit.label();
    let admitted = range_and_note(parameter, language);
    let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
    let shown = format!("{meaning}{unit}\n{admitted}");
    let refused = format!("{}: {admitted}{unit}", parameter.symbol());
    rule.ignore_blank(optional)
        .set_input_title(shortened(parameter.symbol(), TITLE))?
        .set_input_message(shortened(&shown, MESSAGE))?
        .set_error_title(shortened(WRONG.get(language), TITLE))?
        .set_error_message(shortened(&refused, MESSAGE))
}
