//! Edits of work offsets, written as on a control: `G55 X2 Y1 Z-2 R30`, `G52 X1`, `G92.1`.
//!
//! # References
//! The LinuxCNC manual, chapter "Coordinate systems". A system takes its axis words as `G10 L2` does; `G52` writes the
//! registers that it shares with `G92` and switches them on, `G92.1` clears them, `G92.2` and `G92.3` switch them off
//! and on. `G92` with axis words takes the position of the machine, which no file knows: it is refused.

use crate::escape::excerpt;
use crate::finding::{Finding, Place};
use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;
use crate::machine::var_file::{Unfit, VarFile};
use crate::machine::work_offset::{G92_FIRST, G92_SWITCH, System};
use crate::text::Text;

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
        let refuse = |what: Text, remedy: Text| Box::new(Finding::stop(Place::File, quoted(text, &what), remedy));
        let words = words(text).map_err(|(what, remedy)| refuse(what, remedy))?;
        let Some((('G', code), words)) = words.split_first() else {
            return Err(refuse(Text::fixed("falta el código", "the code is missing"), codes()));
        };
        let code = format!("G{code}");
        let bare = |edit: Self| {
            if words.is_empty() {
                return Ok(edit);
            }
            let what = Text::new(format!("{code} no lleva palabras de ejes"), format!("{code} takes no axis words"));
            Err(refuse(what, codes()))
        };
        let (first, system) = match (System::from_name(&code), code.as_str()) {
            (Some(system), _) => (system.first_parameter(), true),
            (None, "G52") => (G92_FIRST, false),
            (None, "G92.1") => return bare(Self::Clear),
            (None, "G92.2") => return bare(Self::Suspend),
            (None, "G92.3") => return bare(Self::Restore),
            (None, "G92") => {
                return Err(refuse(
                    Text::fixed(
                        "G92 parte de la posición de la máquina, que el archivo no conoce",
                        "G92 starts from the position of the machine, which the file does not know",
                    ),
                    Text::fixed(
                        "escriba G52 con los desplazamientos, que ocupan los mismos registros, o G92.1 para borrarlos",
                        "write G52 with the offsets, which are kept in the same registers, or G92.1 to clear them",
                    ),
                ));
            }
            _ => {
                let code = excerpt(&code, 20);
                let what = Text::new(format!("{code} no se puede fijar"), format!("{code} cannot be set"));
                return Err(refuse(what, codes()));
            }
        };
        let mut values: Vec<(u32, f64)> = Vec::new();
        for (letter, number) in words {
            let axis = (first..).zip(Axis::ALL).find(|(_, axis)| axis.letter() == *letter);
            let (parameter, most) = match axis {
                Some((parameter, axis)) => (parameter, greatest(axis, unit)),
                None if *letter == 'R' && system => (first + 9, GREATEST_ROTATION),
                None => {
                    let (what, remedy) = no_axis(*letter, system);
                    return Err(refuse(what, remedy));
                }
            };
            if values.iter().any(|(other, _)| *other == parameter) {
                let what = Text::new(format!("{letter} se da dos veces"), format!("{letter} is given twice"));
                return Err(refuse(what, Text::fixed("deje una de las dos", "leave one of the two")));
            }
            let value = number_of(*letter, number, most).map_err(|(what, remedy)| refuse(what, remedy))?;
            values.push((parameter, value));
        }
        if values.is_empty() {
            return Err(refuse(Text::fixed("no hay ningún eje que fijar", "there is no axis to set"), codes()));
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

fn codes() -> Text {
    Text::fixed(
        "escriba de G54 a G59.3 con X Y Z A B C U V W R, como «G55 X2 Y1 Z-2», G52 con los ejes, o solo G92.1, G92.2 o \
         G92.3",
        "write G54 to G59.3 with X Y Z A B C U V W R, as 'G55 X2 Y1 Z-2', G52 with axes, or G92.1, G92.2 or G92.3 alone",
    )
}

fn quoted(text: &str, what: &Text) -> Text {
    let text = excerpt(text, 60);
    Text::new(format!("«{text}»: {}", what.es), format!("'{text}': {}", what.en))
}

/// A letter in capitals and what follows it up to the next letter or blank.
type Word<'t> = (char, &'t str);

/// The words of an edit.
fn words(text: &str) -> Result<Vec<Word<'_>>, (Text, Text)> {
    let mut words = Vec::new();
    let mut rest = text.trim_start();
    while let Some(letter) = rest.chars().next() {
        let tail = rest.strip_prefix(|one: char| one.is_ascii_alphabetic()).ok_or_else(|| {
            let found = excerpt(rest.split_whitespace().next().unwrap_or(rest), 20);
            (
                Text::new(
                    format!("«{found}» no empieza por una letra"),
                    format!("'{found}' does not begin with a letter"),
                ),
                Text::fixed("escriba cada palabra junta, como X2.5", "write every word together, as X2.5"),
            )
        })?;
        let end = tail.find(|one: char| one.is_ascii_alphabetic() || one.is_whitespace()).unwrap_or(tail.len());
        let (number, after) = tail.split_at_checked(end).unwrap_or((tail, ""));
        words.push((letter.to_ascii_uppercase(), number));
        rest = after.trim_start();
    }
    Ok(words)
}

fn no_axis(letter: char, system: bool) -> (Text, Text) {
    match letter {
        'E' => (
            Text::fixed("no se admiten exponentes", "exponents are not taken"),
            Text::fixed("escriba el número entero, como 1000", "write the number out, as 1000"),
        ),
        'R' if !system => (
            Text::fixed("G52 no tiene giro", "G52 has no rotation"),
            Text::fixed("dé R a un sistema, como «G55 R30»", "give R to a system, as 'G55 R30'"),
        ),
        _ => (
            Text::new(format!("{letter} no es un eje"), format!("{letter} is no axis")),
            Text::fixed(
                "los ejes son X Y Z A B C U V W; R es el giro",
                "axes are X Y Z A B C U V W; R is the rotation",
            ),
        ),
    }
}

fn number_of(letter: char, text: &str, most: f64) -> Result<f64, (Text, Text)> {
    let shown = excerpt(text, 20);
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let plain = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    let value = text.parse::<f64>().ok().filter(|_| plain(whole) && plain(decimals));
    match value {
        None => {
            let what = if text.is_empty() {
                Text::new(format!("{letter} no tiene número"), format!("{letter} has no number"))
            } else {
                Text::new(format!("«{shown}» no es un número"), format!("'{shown}' is not a number"))
            };
            let remedy = if text.contains(',') {
                Text::new(
                    format!("el separador decimal es el punto: {letter}1.5"),
                    format!("the decimal separator is the point: {letter}1.5"),
                )
            } else {
                Text::new(
                    format!("escriba el número junto a la letra, como {letter}-12.5"),
                    format!("write the number next to the letter, as {letter}-12.5"),
                )
            };
            Err((what, remedy))
        }
        Some(value) if value.abs() > most => Err((
            Text::new(format!("{letter}{shown} pasa de ±{most}"), format!("{letter}{shown} is beyond ±{most}")),
            Text::fixed("compruebe el número y la unidad", "check the number and the unit"),
        )),
        Some(_) if decimals.len() > DECIMALS => Err((
            Text::new(
                format!("{letter}{shown} tiene más decimales que los {DECIMALS} del archivo"),
                format!("{letter}{shown} has more decimals than the file's {DECIMALS}"),
            ),
            Text::fixed("redondéelo", "round it"),
        )),
        // −0 is 0.
        Some(value) => Ok(value + 0.0),
    }
}
