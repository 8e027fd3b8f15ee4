//! LinuxCNC's parameter file, also called var file: the numbered parameters that outlive a program and a restart.
//!
//! One parameter a line, its number, white space and its value, in ascending order:
//!
//! ```text
//! 5220 1.000000
//! 5221 12.500000
//! ```
//!
//! # References
//! The behaviour of LinuxCNC's interpreter (`rs274`, 2.9): it writes a tab and six decimals, refuses numbers outside of
//! 1 to 5601 and lines that are not in ascending order, a parameter given twice among them. What it cannot read it
//! skips or reads in part, without a word: `5221 1,5` as 1, `5221 0x10` as 16, `5221.5 3` as 0.5, `5221 inf` as
//! infinity. All of this is refused here.

use std::collections::BTreeMap;

use super::rules::*;
use crate::escape::excerpt;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::limits::VAR_FILE_BYTES;
use crate::machine::offset_parameters::{ACTIVE, AXES, G28_FIRST, G30_FIRST, G92_SWITCH, SYSTEMS, system_first};

/// How a workbook begins, as every zip package does: none of its lines is one of parameters.
const PACKAGE: &[u8] = b"PK\x03\x04";

/// The greatest number of a parameter.
pub const LAST: u32 = 5601;

/// The longest line, in bytes without its end: LinuxCNC reads a longer one as two.
pub const LINE: usize = 254;

/// The greatest value, up or down: with six decimals it fills less than half a line.
pub const GREATEST: f64 = 1e99;

/// A parameter that the file cannot hold.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("parameter {number} cannot be set to {value}: numbers go from 1 to 5601, values up to 1e99")]
pub struct Unfit {
    /// The parameter's number.
    pub number: u32,
    /// The value it was to get.
    pub value: f64,
}

/// The parameters of a file. What was read stays, digit by digit, until it is set.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VarFile(BTreeMap<u32, Entry>);

/// A value as it stands in the file. The number is always that of the text.
#[derive(Clone, Debug, PartialEq)]
struct Entry {
    value: f64,
    text: String,
}

impl VarFile {
    /// Reads a file.
    ///
    /// Empty lines, lines that end in CR LF and a missing last line end are taken; so are all number forms that stand for
    /// the same value in every reader: `1`, `+1.5`, `.5`, `-5.`, `1.5e3`. A file without any parameter is an empty one.
    ///
    /// # Errors
    /// [`Exit::Limit`] for more than [`VAR_FILE_BYTES`] bytes. [`Exit::Refused`], with every fault by line and column, for a line
    /// that is no `number value` pair or is longer than [`LINE`], a number outside of 1 to [`LAST`], a value that is no
    /// decimal number within ±[`GREATEST`], a parameter given twice or out of order.
    pub fn parse(bytes: &[u8]) -> Result<Self, Refusal> {
        if bytes.starts_with(PACKAGE) {
            return Err(ParameterFileIsPackage {}.refused(Exit::Refused, Place::File));
        }
        if bytes.len() > VAR_FILE_BYTES {
            let finding = ParameterFileTooLong {}
                .at(Place::File)
                .with(format!("{} bytes", bytes.len()), format!("≤ {VAR_FILE_BYTES} bytes"));
            return Err(Refusal::new(Exit::Limit, finding));
        }
        let mut file = Self::default();
        let mut findings = Vec::new();
        // Where each parameter stands; the last key is the greatest so far.
        let mut lines = BTreeMap::new();
        for (index, bytes) in bytes.split(|&byte| byte == b'\n').enumerate() {
            let line = index + 1;
            match read_line(line, bytes) {
                Ok(None) => {}
                Ok(Some((number, entry))) => match order(line, number, &lines) {
                    Some(finding) => findings.push(finding),
                    None => {
                        lines.insert(number, line);
                        file.0.insert(number, entry);
                    }
                },
                Err(finding) => findings.push(*finding),
            }
        }
        if findings.is_empty() { Ok(file) } else { Err(Refusal { exit: Exit::Refused, findings }) }
    }

    /// The value of a parameter, if the file holds it.
    #[must_use]
    pub fn get(&self, number: u32) -> Option<f64> {
        self.0.get(&number).map(|entry| entry.value)
    }

    /// Sets a parameter. The file carries six decimals, so the value is rounded to them, and [`get`](Self::get) then
    /// gives the rounded one; where the parameter already has exactly this value, its digits stay as they are.
    ///
    /// # Errors
    /// For a number outside of 1 to [`LAST`] and a value that is not finite or beyond ±[`GREATEST`].
    pub fn set(&mut self, number: u32, value: f64) -> Result<(), Unfit> {
        if !(1..=LAST).contains(&number) || !value.is_finite() || value.abs() > GREATEST {
            return Err(Unfit { number, value });
        }
        #[expect(clippy::float_cmp, reason = "only the very same value leaves the digits alone")]
        let same = self.get(number).is_some_and(|held| held == value);
        if !same {
            let text = format!("{value:.6}");
            let text = if text == "-0.000000" { "0.000000".to_owned() } else { text };
            // What was formatted is a number.
            let value = text.parse().unwrap_or(value);
            self.0.insert(number, Entry { value, text });
        }
        Ok(())
    }

    /// Adds the parameters that LinuxCNC's own files always hold and that are missing here: 0, and 1 for 5220.
    pub fn complete(&mut self) {
        for number in required() {
            let value = if number == ACTIVE { 1.0 } else { 0.0 };
            self.0.entry(number).or_insert_with(|| Entry { value, text: format!("{value:.6}") });
        }
    }

    /// The parameters in ascending order.
    pub fn iter(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.0.iter().map(|(&number, entry)| (number, entry.value))
    }

    /// True where there is no parameter.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The file's text as LinuxCNC writes it: a tab between number and value, ascending, each line ended by LF.
    #[must_use]
    pub fn text(&self) -> String {
        self.0.iter().map(|(number, entry)| format!("{number}\t{}\n", entry.text)).collect()
    }
}

/// The parameters that LinuxCNC writes into every file: G28 and G30 positions, G92 with its switch, the active
/// coordinate system, and nine origins with their rotation. 5231 to 5240 and their like are in no file of its own.
pub fn required() -> impl Iterator<Item = u32> {
    let systems = (1..=SYSTEMS).map(system_first).flat_map(|first| first..=first + AXES);
    let positions = [G28_FIRST, G30_FIRST].into_iter().flat_map(|first| first..first + AXES);
    positions.chain(G92_SWITCH..=ACTIVE).chain(systems)
}

/// Reads a line without its LF: nothing where it is empty.
fn read_line(line: usize, bytes: &[u8]) -> Result<Option<(u32, Entry)>, Box<Finding>> {
    let text = String::from_utf8_lossy(bytes.strip_suffix(b"\r").unwrap_or(bytes));
    if text.len() > LINE {
        let finding = ParameterLineTooLong {}.at(Place::Line { line, columns: Vec::new() });
        return Err(Box::new(finding.with(format!("{} bytes", text.len()), format!("≤ {LINE} bytes"))));
    }
    let place = |column| Place::Line { line, columns: vec![column] };
    let mut words = words(&text);
    let (Some((at, number)), value, rest) = (words.next(), words.next(), words.next()) else { return Ok(None) };
    let number = read_number(place(at), number)?;
    match (value, rest) {
        (None, _) => Err(Box::new(ParameterWithoutValue { parameter: number }.at(place(at)))),
        (Some(_), Some((at, rest))) => Err(Box::new(TextAfterValue { text: excerpt(rest, 20) }.at(place(at)))),
        (Some((at, text)), None) => {
            let value = read_value(place(at), text)?;
            Ok(Some((number, Entry { value, text: text.to_owned() })))
        }
    }
}

/// The words of a line with their columns, counted from 1 in characters.
fn words(line: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut column = 1;
    line.split([' ', '\t']).filter_map(move |word| {
        let at = column;
        column += word.chars().count() + 1;
        (!word.is_empty()).then_some((at, word))
    })
}

fn read_number(place: Place, text: &str) -> Result<u32, Box<Finding>> {
    let shown = excerpt(text, 20);
    let whole = text.strip_prefix(['+', '-']).unwrap_or(text);
    if whole.is_empty() || !whole.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(Box::new(NoParameterNumber { text: shown }.at(place)));
    }
    text.parse()
        .ok()
        .filter(|number| (1..=LAST).contains(number))
        .ok_or_else(|| Box::new(NoSuchParameter {}.at(place).with(shown, format!("1 … {LAST}"))))
}

fn read_value(place: Place, text: &str) -> Result<f64, Box<Finding>> {
    let shown = excerpt(text, 30);
    let plain = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    let finding = match text.parse::<f64>() {
        Ok(value) if plain && value.abs() <= GREATEST => return Ok(value),
        Ok(value) if plain || !value.is_finite() => {
            ParameterTooGreat {}.at(place).with(shown, format!("±{GREATEST:e}"))
        }
        _ if text.contains(',') => ParameterWithComma { text: shown }.at(place),
        _ => ParameterNoNumber { text: shown }.at(place),
    };
    Err(Box::new(finding))
}

/// Why a parameter may not come after those read before it, as LinuxCNC judges.
fn order(line: usize, number: u32, before: &BTreeMap<u32, usize>) -> Option<Finding> {
    let place = Place::Line { line, columns: Vec::new() };
    if let Some(first) = before.get(&number) {
        return Some(ParameterTwice { parameter: number, first: *first }.at(place));
    }
    let (last, first) = before.last_key_value().filter(|(last, _)| **last > number)?;
    Some(ParameterOutOfOrder { parameter: number, last: *last, first: *first }.at(place))
}

#[cfg(test)]
mod tests {
    use super::required;

    #[test]
    fn a_file_of_linuxcnc_holds_positions_registers_and_nine_origins() {
        let origins =
            [5221..=5230, 5241..=5250, 5261..=5270, 5281..=5290, 5301..=5310, 5321..=5330, 5341..=5350, 5361..=5370];
        let held = [5161..=5169, 5181..=5189, 5210..=5220].into_iter().chain(origins).chain([5381..=5390]).flatten();
        assert_eq!(required().collect::<Vec<u32>>(), held.collect::<Vec<u32>>());
    }
}
