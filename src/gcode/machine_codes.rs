//! The codes that a workbook puts into programs: M codes, and the block that takes the tool away.

use crate::finding::{Finding, Key, Raise};
use crate::gcode::code::G;
use crate::gcode::control::Control;
use crate::gcode::fields::DIALECT;
use crate::gcode::rules::codes::{
    EndMissing, EndsTooSoon, MachineCodeNotKnown, NoMachineCode, NotInRetract, RetractWithoutZ,
};
use crate::gcode::word::{Number, Word};
use crate::parameter::at;

/// What is wrong with the codes of a parameter: one that is no M code, that the control does not know, or that ends the
/// program where it must not. With `closing` the last one must end it.
#[must_use]
pub fn refused_codes(dialect: &Control, key: Key, codes: &[Word], closing: bool) -> Vec<Finding> {
    let mut findings = Vec::new();
    let both = || at([key, DIALECT.key()]);
    for word in codes {
        let Number::Whole(number) = word.number else { continue };
        if word.letter != 'M' {
            findings.push(NoMachineCode { key, letter: word.letter, number }.at(both()));
        } else if !dialect.knows_machine_code(number) {
            findings.push(MachineCodeNotKnown { control: dialect.name, number, key }.at(both()));
        } else if matches!(number, 2 | 30) && !closing {
            findings.push(EndsTooSoon { key, number }.at(both()));
        }
    }
    let ends = |word: &Word| matches!(word.number, Number::Whole(2 | 30)) && word.letter == 'M';
    if closing && !codes.last().is_some_and(ends) {
        findings.push(EndMissing { key }.at(at([key])));
    }
    findings
}

/// What is wrong with the block of a parameter that takes the tool away: a code that the control does not know or rodete does
/// not follow, one that changes how the blocks after it are read, one that ends the program, or axes without Z.
#[must_use]
pub fn refused_retract(dialect: &Control, key: Key, words: &[Word]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let place = || at([key, DIALECT.key()]);
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
            findings.push(NotInRetract { letter, number, control: dialect.name }.at(place()));
        }
    }
    let sizes: Vec<char> =
        words.iter().filter(|word| matches!(word.number, Number::Size(_))).map(|word| word.letter).collect();
    if !sizes.is_empty() && !sizes.contains(&'Z') {
        findings.push(RetractWithoutZ {}.at(place()));
    }
    findings
}
