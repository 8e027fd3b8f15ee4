//! The codes that turn the torch on and off, and those that hold its height: what must not stand in them.

use crate::finding::{Finding, Key, Raise};
use crate::gcode::word::{Number, Word};
use crate::kinds::pipe::form::{END_CODES, TORCH_OFF, TORCH_ON};
use crate::kinds::pipe::rules::{CodeInBoth, TorchOnAtEnd, TurnsTheOtherWay};
use crate::parameter::at;
use crate::text::{Text, t};

/// The M codes of a list.
fn machine_codes(codes: &[Word]) -> impl Iterator<Item = u32> {
    codes.iter().filter_map(|word| match word.number {
        Number::Whole(number) if word.letter == 'M' => Some(number),
        _ => None,
    })
}

/// What turns the torch on among the codes at the end of the program. Where M3 or M4 turns it on, what else torch_on holds is for
/// something else, as air.
pub(super) fn on_at_end(torch_on: &[Word], end_codes: &[Word]) -> Option<Finding> {
    let by_spindle = machine_codes(torch_on).any(|code| matches!(code, 3 | 4));
    // Stops and ends are no switches, wherever they stand.
    let switch = |code: u32| !matches!(code, 0..=2 | 30) && machine_codes(torch_on).any(|one| one == code);
    let starts = |code: &u32| matches!(code, 3 | 4) || !by_spindle && switch(*code);
    let number = machine_codes(end_codes).find(starts)?;
    Some(TorchOnAtEnd { number }.at(at([END_CODES.key(), TORCH_ON.key()])))
}

/// What is wrong with lists of codes beside each other: a code that stands in two of them, and one that does the opposite of
/// what its list is for. M3 and M4 start the spindle and M5 stops it: ISO 6983-1, and the tables of all controls.
pub(super) fn opposed(lists: &[(Key, &[Word])]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (at_one, (one, codes)) in lists.iter().enumerate() {
        for (other, others) in &lists[at_one + 1..] {
            if let Some(number) = machine_codes(codes).find(|code| machine_codes(others).any(|one| one == *code)) {
                let told = CodeInBoth { one: *one, other: *other, number };
                findings.push(told.at(at([*one, *other])));
            }
        }
        let opposite = |number: &u32| match number {
            3 | 4 => *one == TORCH_OFF.key(),
            5 => *one == TORCH_ON.key(),
            _ => false,
        };
        if let Some(number) = machine_codes(codes).find(opposite) {
            let does: Text = if number == 5 { t("quita", "off") } else { t("pone", "on") };
            findings.push(TurnsTheOtherWay { key: *one, number, does }.at(at([*one])));
        }
    }
    findings
}
