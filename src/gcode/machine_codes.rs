//! The codes that a workbook puts into programs: M codes, and the block that takes the tool away.

use crate::finding::{Finding, Key, Raise};
use crate::gcode::code::G;
use crate::gcode::control::Control;
use crate::gcode::fields::DIALECT;
use crate::gcode::interpreter::{Interpreter, Setting};
use crate::gcode::rules::codes::{
    CodesRefused, EndMissing, EndsTooSoon, MachineCodeNotKnown, NoMachineCode, NotInRetract, RetractInProgram,
    RetractRefused, RetractWithoutZ, SpindleCode,
};
use crate::gcode::word::{Number, NumberFormat, Retract, Word};
use crate::parameter::at;
use crate::text::Text;

/// Where the codes of a parameter stand in a program.
#[derive(Clone, Copy, Debug)]
pub struct CodesPlace {
    /// They are the last, and must end it.
    pub last: bool,
    /// It calls a tool before them.
    pub tooled: bool,
}

/// What is wrong with the codes of a parameter: one that is no M code, that the control does not know, or that ends the
/// program where it must not. What the control refuses of them in one block, as they are written, is told with the parameter: the
/// program's line would not say which cell it came from.
#[must_use]
pub fn refused_codes(control: &'static Control, key: Key, codes: &[Word], place: CodesPlace) -> Vec<Finding> {
    let CodesPlace { last, tooled } = place;
    let mut findings = Vec::new();
    let both = || at([key, DIALECT.key()]);
    for word in codes {
        let Number::Whole(number) = word.number else { continue };
        if word.letter != 'M' {
            findings.push(NoMachineCode { key, letter: word.letter, number }.at(both()));
        } else if !control.knows_machine_code(number) {
            findings.push(MachineCodeNotKnown { control: control.name, number, key }.at(both()));
        } else if matches!(number, 2 | 30) && !last {
            findings.push(EndsTooSoon { key, number }.at(both()));
        }
    }
    let ends = |word: &Word| matches!(word.number, Number::Whole(2 | 30)) && word.letter == 'M';
    if last && !codes.last().is_some_and(ends) {
        findings.push(EndMissing { key }.at(at([key])));
    }
    if findings.is_empty() && !codes.is_empty() {
        let tool = if tooled { "T1\n" } else { "" };
        findings.extend(refused_block(control, tool, codes).map(|why| CodesRefused { key, why }.at(both())));
    }
    findings
}

/// What the control refuses of a block behind the lines `before`.
fn refused_block(control: &'static Control, before: &str, words: &[Word]) -> Option<Text> {
    let mut text = String::new();
    words.iter().for_each(|word| word.write(NumberFormat::Trimmed, &mut text));
    let setting = Setting { part: true, ..Setting::new(control) };
    text.insert_str(0, before);
    Interpreter::over(text.as_bytes(), setting).find_map(Result::err).map(|fault| fault.message())
}

/// The M codes that turn the spindle, stop it or hold it at an angle.
const SPINDLE: [u32; 4] = [3, 4, 5, 19];

/// The codes of a parameter that change how the spindle turns: with `starts`, all but M3 or M4 alone.
#[must_use]
pub fn refused_spindle(key: Key, codes: &[Word], starts: bool) -> Vec<Finding> {
    let turning: Vec<u32> = codes
        .iter()
        .filter_map(|word| match word.number {
            Number::Whole(number) if word.letter == 'M' && SPINDLE.contains(&number) => Some(number),
            _ => None,
        })
        .collect();
    if starts && matches!(turning.as_slice(), [] | [3 | 4]) {
        return Vec::new();
    }
    turning.last().map(|&number| SpindleCode { key, number }.at(at([key]))).into_iter().collect()
}

/// What is wrong with the block of a parameter that takes the tool away: a code that the control does not know or rodete does
/// not follow, one that changes how the blocks after it are read, one that ends the program, axes without Z, or Z in program
/// coordinates where the control has G53. What else the control refuses of it, as G53 without a motion, is told with the parameter,
/// as of its codes. A return to a reference point goes over a point in program coordinates (the
/// LinuxCNC manual, G28).
#[must_use]
pub fn refused_retract(control: &'static Control, key: Key, retract: &Retract) -> Vec<Finding> {
    let mut findings = Vec::new();
    let place = || at([key, DIALECT.key()]);
    for word in &retract.0 {
        let Number::Whole(number) = word.number else { continue };
        let letter = word.letter;
        let tenths = usize::try_from(number).unwrap_or(usize::MAX).saturating_mul(10);
        let known = match letter {
            'G' => matches!(control.codes.get(tenths), Some(G::Rapid | G::MachineCoordinates | G::Absolute)),
            _ => control.knows_machine_code(number) && !matches!(number, 2 | 30),
        };
        if !known {
            findings.push(NotInRetract { letter, number, control: control.name }.at(place()));
        }
    }
    let moves = retract.sizes().next().is_some();
    if moves && retract.z().is_none() {
        findings.push(RetractWithoutZ {}.at(place()));
    }
    let has_machine_zero = control.codes.has(G::MachineCoordinates);
    if findings.is_empty() && moves && !retract.by_machine() && has_machine_zero {
        findings.push(RetractInProgram {}.at(place()));
    }
    if findings.is_empty() && !retract.0.is_empty() {
        findings.extend(refused_block(control, "", &retract.0).map(|why| RetractRefused { why }.at(place())));
    }
    findings
}
