//! The codes that a workbook puts into programs: M codes, and the block that takes the tool away.

use crate::finding::{Finding, Place};
use crate::gcode::code::G;
use crate::gcode::control::Control;
use crate::gcode::word::{Number, Word};
use crate::text::{Text, t};

/// What is wrong with the codes of a parameter: one that is no M code, that the control does not know, or that ends the
/// program where it must not. With `closing` the last one must end it.
#[must_use]
pub fn refused_codes(dialect: &Control, key: &'static str, codes: &[Word], closing: bool) -> Vec<Finding> {
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
                t("quite el código G", "take the G code out"),
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
            t("escriba M30 al final", "put M30 at the end"),
        );
    }
    findings
}

/// What is wrong with the block that takes the tool away: a code that the control does not know or rodete does not follow, one
/// that changes how the blocks after it are read, one that ends the program, or axes without Z.
#[must_use]
pub fn refused_retract(dialect: &Control, words: &[Word]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut stop = |es: String, en: String, remedy: Text| {
        findings.push(Finding::stop(Place::Parameters(vec!["retract", "dialect"]), Text::new(es, en), remedy));
    };
    for word in words {
        let Number::Whole(number) = word.number else { continue };
        let letter = word.letter;
        let tenths = usize::try_from(number).unwrap_or(usize::MAX).saturating_mul(10);
        let known = match letter {
            'G' => matches!(
                dialect.codes.get(tenths),
                Some(G::Rapid | G::MachineCoordinates | G::Reference(_) | G::Absolute)
            ),
            _ => dialect.knows_machine_code(number) && !matches!(number, 2 | 30),
        };
        if !known {
            stop(
                format!("retract lleva {letter}{number}: el dialecto {} no lo admite ahí", dialect.name),
                format!("retract holds {letter}{number}: dialect {} does not take it there", dialect.name),
                t(
                    "escriba el bloque con el que su máquina sube Z, o deje la celda vacía y retire la herramienta a mano",
                    "write the block with which your machine raises Z, or leave the cell empty and take the tool away by hand",
                ),
            );
        }
    }
    let sizes: Vec<char> =
        words.iter().filter(|word| matches!(word.number, Number::Size(_))).map(|word| word.letter).collect();
    if !sizes.is_empty() && !sizes.contains(&'Z') {
        stop(
            "retract mueve ejes y no Z: la herramienta no se retira de la pieza".to_owned(),
            "retract moves axes and not Z: the tool is not taken away from the part".to_owned(),
            t("escriba también Z", "write Z as well"),
        );
    }
    findings
}
