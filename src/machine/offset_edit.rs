//! Edits of work offsets, written as on a control: `G55 X2 Y1 Z-2 R30`, `G52 X1`, `G92.1`.
//!
//! # References
//! The LinuxCNC manual, chapter "Coordinate systems". A system takes its axis words as `G10 L2` does; `G52` writes the
//! registers that it shares with `G92` and switches them on, `G92.1` clears them, `G92.2` and `G92.3` switch them off
//! and on. `G92` with axis words takes the position of the machine, which no file knows: it is refused.

use super::rules::*;
use crate::escape::excerpt;
use crate::finding::{Finding, Place, Raise};
use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;
use crate::machine::var_file::{Unfit, VarFile};
use crate::machine::work_offset::{G92_FIRST, G92_SWITCH, System};

/// The greatest origin up or down in mm, and the greatest angle in degrees: the format of five digits and three.
const GREATEST: f64 = 99_999.999;
/// Decimals of a var file.
const DECIMALS: usize = 6;

/// The greatest size of a word in a unit: of an axis, in the machine's unit or degrees.
#[must_use]
pub const fn greatest(axis: Axis, unit: LengthUnit) -> f64 {
    match unit {
        LengthUnit::Inch if !axis.rotary() => 3_937.007,
        _ => GREATEST,
    }
}

/// The greatest rotation of a system, up or down, in degrees.
pub const GREATEST_ROTATION: f64 = 360.0;

/// One edit of a var file's offsets.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Sets what it names of one system, by parameter.
    System(Vec<(u32, f64)>),
    /// Sets the registers of G92 and G52 that it names and switches them on.
    Local(Vec<(u32, f64)>),
    /// Clears the registers and switches them off: `G92.1`.
    Clear,
    /// Switches them off: `G92.2`.
    Suspend,
    /// Switches them on: `G92.3`.
    Restore,
}

impl Edit {
    /// Reads an edit: a code and its words, in capitals or small letters, lengths in the machine's unit. A number has
    /// digits, a point and a sign, and at most six decimals.
    ///
    /// # Errors
    /// What is wrong with it: a code that edits nothing, a word given twice or of no axis, no word where one must be,
    /// a comma, an exponent, a number beyond ±99 999.999 mm, or ±360° for R.
    pub fn parse(text: &str, unit: LengthUnit) -> Result<Self, Box<Finding>> {
        let edit = || excerpt(text, 60);
        let refuse = |row: &dyn Raise| Box::new(row.at(Place::File));
        let words = words(text)?;
        let Some((('G', code), words)) = words.split_first() else {
            return Err(refuse(&EditWithoutCode { edit: edit() }));
        };
        let code = format!("G{code}");
        let bare = |kept: Self| {
            if words.is_empty() { Ok(kept) } else { Err(refuse(&EditTakesNoAxes { edit: edit(), code: code.clone() })) }
        };
        let (first, system) = match (System::from_name(&code), code.as_str()) {
            (Some(system), _) => (system.first_parameter(), true),
            (None, "G52") => (G92_FIRST, false),
            (None, "G92.1") => return bare(Self::Clear),
            (None, "G92.2") => return bare(Self::Suspend),
            (None, "G92.3") => return bare(Self::Restore),
            (None, "G92") => return Err(refuse(&EditOfG92 { edit: edit() })),
            _ => return Err(refuse(&CodeNotEdited { edit: edit(), code: excerpt(&code, 20) })),
        };
        let mut values: Vec<(u32, f64)> = Vec::new();
        for (letter, number) in words {
            let axis = (first..).zip(Axis::ALL).find(|(_, axis)| axis.letter() == *letter);
            let (parameter, most) = match axis {
                Some((parameter, axis)) => (parameter, greatest(axis, unit)),
                None if *letter == 'R' && system => (first + 9, GREATEST_ROTATION),
                None => return Err(refuse(&*no_axis(edit(), *letter, system))),
            };
            if values.iter().any(|(other, _)| *other == parameter) {
                return Err(refuse(&AxisTwice { edit: edit(), letter: *letter }));
            }
            let value = number_of(*letter, number, most, edit).map_err(|row| refuse(&*row))?;
            values.push((parameter, value));
        }
        if values.is_empty() {
            return Err(refuse(&NoAxisToSet { edit: edit() }));
        }
        Ok(if system { Self::System(values) } else { Self::Local(values) })
    }

    /// Makes the edit in a file. As on the control, G52 keeps the registers of the axes that it does not name where
    /// they are in force, and clears them where they are not.
    ///
    /// # Errors
    /// For a value that the file cannot hold.
    pub fn apply(&self, file: &mut VarFile) -> Result<(), Unfit> {
        let registers = || (G92_FIRST..).take(Axis::ALL.len());
        match self {
            Self::System(values) => values.iter().try_for_each(|(number, value)| file.set(*number, *value)),
            Self::Local(values) => {
                if file.get(G92_SWITCH).unwrap_or(0.0) == 0.0 {
                    registers().try_for_each(|number| file.set(number, 0.0))?;
                    file.set(G92_SWITCH, 1.0)?;
                }
                values.iter().try_for_each(|(number, value)| file.set(*number, *value))
            }
            Self::Clear => {
                registers().try_for_each(|number| file.set(number, 0.0))?;
                file.set(G92_SWITCH, 0.0)
            }
            Self::Suspend => file.set(G92_SWITCH, 0.0),
            Self::Restore => file.set(G92_SWITCH, 1.0),
        }
    }
}

/// A letter in capitals and what follows it up to the next letter or blank.
type Word<'t> = (char, &'t str);

/// The words of an edit, letters in capitals; refused where something does not begin with a letter.
fn words(text: &str) -> Result<Vec<Word<'_>>, Box<Finding>> {
    let mut words = Vec::new();
    let mut rest = text.trim_start();
    while let Some(letter) = rest.chars().next() {
        let tail = rest.strip_prefix(|one: char| one.is_ascii_alphabetic()).ok_or_else(|| {
            let word = excerpt(rest.split_whitespace().next().unwrap_or(rest), 20);
            Box::new(WordWithoutLetter { edit: excerpt(text, 60), word }.at(Place::File))
        })?;
        let end = tail.find(|one: char| one.is_ascii_alphabetic() || one.is_whitespace()).unwrap_or(tail.len());
        let (number, after) = tail.split_at_checked(end).unwrap_or((tail, ""));
        words.push((letter.to_ascii_uppercase(), number));
        rest = after.trim_start();
    }
    Ok(words)
}

fn no_axis(edit: String, letter: char, system: bool) -> Box<dyn Raise> {
    match letter {
        'E' => Box::new(EditExponent { edit }),
        'R' if !system => Box::new(G52WithoutRotation { edit }),
        _ => Box::new(NotAnAxis { edit, letter }),
    }
}

fn number_of(letter: char, text: &str, most: f64, edit: impl FnOnce() -> String) -> Result<f64, Box<dyn Raise>> {
    let shown = excerpt(text, 20);
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let plain = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    let value = text.parse::<f64>().ok().filter(|_| plain(whole) && plain(decimals));
    match value {
        None if text.is_empty() => Err(Box::new(AxisWithoutNumber { edit: edit(), letter })),
        None if text.contains(',') => Err(Box::new(OffsetWithComma { edit: edit(), text: shown, letter })),
        None => Err(Box::new(OffsetNotANumber { edit: edit(), text: shown, letter })),
        Some(value) if value.abs() > most => Err(Box::new(OffsetTooGreat { edit: edit(), letter, text: shown, most })),
        Some(_) if decimals.len() > DECIMALS => {
            Err(Box::new(TooManyDecimals { edit: edit(), letter, text: shown, most: DECIMALS }))
        }
        // −0 is 0.
        Some(value) => Ok(value + 0.0),
    }
}
