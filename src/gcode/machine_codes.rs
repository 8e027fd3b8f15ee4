//! The M codes that a workbook puts into programs.

use crate::finding::{Finding, Place};
use crate::gcode::dialect::Dialect;
use crate::gcode::word::{Number, Word};
use crate::text::Text;

/// What is wrong with the codes of a parameter: one that is no M code, that the dialect does not know, or that ends the
/// program where it must not. With `closing` the last one must end it.
#[must_use]
pub fn refused_codes(dialect: &Dialect, key: &'static str, codes: &[Word], closing: bool) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut stop = |keys: &[&'static str], es: String, en: String, remedy| {
        findings.push(Finding::stop(Place::Parameters(keys.to_vec()), Text::new(es, en), remedy));
    };
    for word in codes {
        let Number::Whole(number) = word.number else { continue };
        if word.letter != 'M' {
            stop(
                &[key, "dialect"],
                format!("{key} lleva {}{number}: aquí solo valen códigos M", word.letter),
                format!("{key} holds {}{number}: only M codes may stand here", word.letter),
                Text::fixed("quite el código G", "take the G code out"),
            );
        } else if !dialect.knows_machine_code(number) {
            stop(
                &[key, "dialect"],
                format!("el dialecto {} no conoce M{number}", dialect.name),
                format!("dialect {} does not know M{number}", dialect.name),
                Text::new(
                    format!("quite M{number} de {key}, o elija el dialecto del control"),
                    format!("take M{number} out of {key}, or choose the control's dialect"),
                ),
            );
        } else if matches!(number, 2 | 30) && !closing {
            stop(
                &[key, "dialect"],
                format!("{key} lleva M{number}, que termina el programa"),
                format!("{key} holds M{number}, which ends the program"),
                Text::new(format!("quite M{number}"), format!("take M{number} out")),
            );
        }
    }
    let ends = |word: &Word| matches!(word.number, Number::Whole(2 | 30)) && word.letter == 'M';
    if closing && !codes.last().is_some_and(ends) {
        stop(
            &[key],
            format!("{key} no acaba con M2 ni M30: el programa no tendría fin"),
            format!("{key} does not close with M2 or M30: the program would have no end"),
            Text::fixed("escriba M30 al final", "put M30 at the end"),
        );
    }
    findings
}
