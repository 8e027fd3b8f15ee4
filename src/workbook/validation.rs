//! What a value cell admits: as words for the sheet, as the cell's own validation, and as the red of what it does not admit.

use rust_xlsxwriter::{ConditionalFormatFormula, DataValidation, DataValidationRule, XlsxError};

use super::calendar;
use super::cell::shortened;
use super::style::Styles;
use super::value::DATE;
use super::words::fold;
use crate::kind::live_form::{parted, says};
use crate::parameter::{Choice, FieldKind, Parameter};
use crate::text::{Language, Text, one_of, t, true_minus};

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
        FieldKind::Choice(choices) => one_of(choices.iter().map(|choice| choice.label.clone())),
        FieldKind::Line { max } => Text::new(format!("hasta {max} caracteres"), format!("up to {max} characters")),
        FieldKind::Date => t("una fecha, como 2026-11-23", "a date, such as 2026-11-23"),
        FieldKind::Codes => t(
            "códigos M con número entero, separados por espacios",
            "codes: M with a whole number, separated by blanks",
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

/// How many cells of a range hold another text than the words of a choice, as a formula that is an error where one of them is.
pub(super) fn unknowns(choices: &[Choice], cells: &str) -> String {
    let is = |word: &String| {
        let all = format!("(TRIM({cells})=\"{word}\")");
        // As of one cell: two blanks between words count.
        if word.contains(' ') { format!("-{all}*ISNUMBER(FIND(\"{word}\",LOWER({cells})))") } else { format!("-{all}") }
    };
    let known = spellings(choices).iter().map(is).collect::<String>();
    format!("SUMPRODUCT((LEN(TRIM({cells}))>0){known})")
}

/// The words for a choice, in both languages, by its key and as an earlier rodete wrote them, as they are typed.
fn spellings(choices: &[Choice]) -> Vec<String> {
    let all = choices.iter().flat_map(Choice::words);
    let mut words: Vec<String> = all.flat_map(|word| [word.to_lowercase(), fold(word)]).collect();
    words.sort();
    words.dedup();
    words
}

/// The formula that is true where a text is not allowed; none for a parameter that is a number, or has one text alone.
pub(super) fn unknown(kind: &FieldKind, cell: &str) -> Option<String> {
    match kind {
        FieldKind::Choice(choices) => {
            let is = spellings(choices).iter().map(|word| says(cell, word)).collect::<Vec<_>>();
            Some(format!("NOT(OR({}))", is.join(",")))
        }
        // TRUE is as long as a text of four letters, and is none.
        FieldKind::Line { max } => Some(format!("OR(ISLOGICAL({cell}),LEN({cell})>{max})")),
        FieldKind::Date => {
            Some(format!("IF(OR(ISLOGICAL({cell}),LEN({cell})>{DATE}),TRUE,{})", calendar::never_in_figures(cell)))
        }
        FieldKind::Codes => Some(misspelt(cell, ["M", ""])),
        FieldKind::Block => Some(misspelt(cell, ["GM", "XYZ"])),
        FieldKind::Real { .. } | FieldKind::Whole { .. } | FieldKind::Schema => None,
    }
}

/// True as a formula where a text is not words of a letter and a number: what may follow each character is asked. After a code the
/// number is whole, alone with other codes of four digits at most; after an axis it may have a sign and decimals.
fn misspelt(cell: &str, [codes, axes]: [&str; 2]) -> String {
    const DIGITS: usize = 4;
    let most = CODES as usize;
    let blanks = parted(cell);
    let sign = |after: usize| {
        format!("MID(\" \"&UPPER({blanks})&REPT(\" \",{}),ROW($A$1:$A${})+{after},1)", most + DIGITS + 4, most + 2)
    };
    let is = |after: usize, signs: &str| format!("ISNUMBER(FIND({},\"{signs}\"))", sign(after));
    let digit = |after| is(after, "0123456789");
    let mut pairs = vec![(is(0, " "), is(1, &format!(" {codes}{axes}"))), (is(0, codes), digit(1))];
    if axes.is_empty() {
        pairs.push((digit(0), is(1, "0123456789 ")));
    } else {
        pairs.extend([(is(0, axes), is(1, "0123456789-")), (is(0, "-."), digit(1)), (digit(0), is(1, "0123456789. "))]);
    }
    let fits = pairs.iter().map(|(here, next)| format!("-{here}*{next}")).collect::<String>();
    let long = (0..=DIGITS).map(digit).collect::<Vec<_>>().join("*");
    let long = if axes.is_empty() { format!(",SUMPRODUCT({long})>0") } else { String::new() };
    format!("OR(LEN({cell})>{most},LEN(TRIM({blanks}))=0,SUMPRODUCT(1{fits})>0{long})")
}

/// Red for a cell, or the first of some, with what is not allowed there; none for a parameter that has one text alone.
#[must_use]
pub fn red(parameter: &Parameter, cell: &str, styles: &Styles) -> Option<ConditionalFormatFormula> {
    let wrong = match (beyond(&parameter.kind, cell), unknown(&parameter.kind, cell)) {
        (Some(beyond), _) => format!("IF(ISNUMBER({cell}),{beyond},LEN(TRIM({cell}))>0)"),
        (None, unknown) => format!("IF(LEN(TRIM({cell}))>0,{},FALSE)", unknown?),
    };
    let rule = format!("=IF(ISERROR({cell}),TRUE,{wrong})");
    Some(ConditionalFormatFormula::new().set_rule(rule.as_str()).set_format(styles.stale.clone()))
}

/// The allowed range and the parameter's note, for column E and the input message.
#[must_use]
pub fn range_and_note(parameter: &Parameter, language: Language) -> String {
    static MAY_BE_EMPTY: Text = t("Puede quedar vacía", "May stay empty");
    let range = range(parameter);
    let range = &*true_minus(range.get(language));
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
