//! Numbers typed as text: what was probably meant, said as a hint and never taken as the value.

use crate::text::Text;

/// A number in the fewest digits that give it back; with an exponent where it is very large or very small.
#[must_use]
pub fn decimal(number: f64) -> String {
    let size = number.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if (1e-4..1e15).contains(&size) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}

/// What to write instead of a text that stands where a number must: `unit` is the label of the parameter's unit.
#[must_use]
pub fn hint(text: &str, unit: &str) -> Text {
    let (plain, foreign) = plain(text);
    let plain = plain.trim();
    let named = foreign.map(|character| {
        let (name, code) = (name(character), u32::from(character));
        say!(
            " (el texto lleva el carácter U+{code:04X}, {name})",
            " (the text has the character U+{code:04X}, {name})",
            name = name
        )
    });
    let named = named.unwrap_or(Text::fixed("", ""));
    if foreign.is_none() && strict(plain) {
        return say!(
            "la celda tiene formato de texto: dele formato General y escriba de nuevo {plain}",
            "the cell is formatted as text: set its format to General and type {plain} again"
        );
    }
    let suffix_at = plain.rfind(|character: char| character.is_ascii_digit()).map_or(0, |last| last + 1);
    let (number, suffix) = plain.split_at_checked(suffix_at).unwrap_or((plain, ""));
    let suffix = suffix.trim();
    // Letters after the digits are a unit typed into the value cell; a lone separator is part of the number.
    let number = if suffix.chars().all(|character| ".,".contains(character)) { plain } else { number };
    let unit = if suffix.chars().any(|character| character.is_alphabetic() || "°\"'%/".contains(character)) {
        if unit.is_empty() {
            Text::fixed(", sin unidad", ", without a unit")
        } else {
            say!(", sin unidad: la columna D ya dice {unit}", ", without the unit: column D says {unit}")
        }
    } else {
        Text::fixed("", "")
    };
    match read(number) {
        Some(Reading::One(number)) => {
            say!("escriba {number}{unit}{named}", "use {number}{unit}{named}", unit = unit, named = named)
        }
        Some(Reading::Either(one, other)) => say!(
            "escriba {one} o {other}, según lo que quiera decir{named}",
            "use {one} or {other}, whichever is meant{named}",
            named = named
        ),
        None => say!(
            "escriba un número decimal con punto, como 12.5{named}",
            "write a decimal number with a point, such as 12.5{named}",
            named = named
        ),
    }
}

/// What a text may mean as a number.
#[derive(Debug, PartialEq, Eq)]
enum Reading {
    One(String),
    /// One separator that may stand before decimals or between thousands.
    Either(String, String),
}

/// Digits with an optional sign, point and exponent, giving a finite number.
fn strict(text: &str) -> bool {
    !text.is_empty()
        && text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte))
        && text.parse::<f64>().is_ok_and(f64::is_finite)
}

fn read(text: &str) -> Option<Reading> {
    let text = text.trim();
    if strict(text) {
        return Some(Reading::One(text.to_owned()));
    }
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => ("-", rest.trim_start()),
        None => ("", text.strip_prefix('+').unwrap_or(text)),
    };
    let clean = |text: &str| -> String { text.chars().filter(char::is_ascii_digit).collect() };
    let well_formed = digits.starts_with(|character: char| character.is_ascii_digit())
        && digits.ends_with(|character: char| character.is_ascii_digit())
        && digits.chars().all(|character| character.is_ascii_digit() || " '_.,".contains(character));
    if !well_formed || digits.starts_with("0x") {
        return None;
    }
    let marks: Vec<(usize, char)> = digits.char_indices().filter(|(_, one)| !one.is_ascii_digit()).collect();
    let &(last, mark) = marks.last()?;
    let (whole, fraction) = (digits.get(..last)?, digits.get(last + 1..)?);
    let repeated = marks.iter().filter(|(_, one)| *one == mark).count() > 1;
    let joined = format!("{sign}{}", clean(digits));
    let parted = format!("{sign}{}.{fraction}", clean(whole));
    let thousands = fraction.len() == 3 && whole.len() <= 3 && whole != "0";
    Some(match mark {
        ',' | '.' if repeated => Reading::One(joined),
        ',' if marks.len() == 1 && thousands => Reading::Either(parted, joined),
        ',' | '.' => Reading::One(parted),
        _ => Reading::One(joined),
    })
}

/// The text with the digits, signs and blanks of other scripts replaced by plain ones, and the first such character.
fn plain(text: &str) -> (String, Option<char>) {
    let mut foreign = None;
    let plain = text
        .chars()
        .filter_map(|character| {
            let same = match u32::from(character) {
                code @ (0x0660..=0x0669 | 0x06f0..=0x06f9) => char::from_digit(code & 0xf, 10),
                code @ 0x0966..=0x096f => char::from_digit(code - 0x0966, 10),
                code @ 0xff10..=0xff19 => char::from_digit(code - 0xff10, 10),
                0x2010..=0x2015 | 0x2212 | 0xfe63 | 0xff0d => Some('-'),
                0xff0b => Some('+'),
                0x066b | 0xff0e | 0x00b7 => Some('.'),
                0xff0c => Some(','),
                0x066c | 0x2019 | 0x02bc => Some('\''),
                0x00a0 | 0x2000..=0x200a | 0x202f | 0x3000 => Some(' '),
                0x200b..=0x200f | 0x2060 | 0xfeff | 0x00ad => None,
                _ => return Some(character),
            };
            foreign = foreign.or(Some(character));
            same
        })
        .collect();
    (plain, foreign)
}

/// The name of a character that looks like a part of a number and is none.
fn name(character: char) -> Text {
    match u32::from(character) {
        0x2212 => Text::fixed("signo menos tipográfico", "MINUS SIGN"),
        0x2013 => Text::fixed("semirraya", "EN DASH"),
        0x2014 => Text::fixed("raya", "EM DASH"),
        0x2010..=0x2015 | 0xfe63 | 0xff0d => Text::fixed("guion que no es el signo menos", "a dash, not a minus sign"),
        0x00a0 => Text::fixed("espacio de no separación", "NO-BREAK SPACE"),
        0x202f => Text::fixed("espacio estrecho de no separación", "NARROW NO-BREAK SPACE"),
        0x2000..=0x200a | 0x3000 => Text::fixed("espacio tipográfico", "a typographic space"),
        0x0660..=0x0669 | 0x06f0..=0x06f9 => Text::fixed("cifra arábiga oriental", "an Arabic-Indic digit"),
        0x0966..=0x096f => Text::fixed("cifra devanagari", "a Devanagari digit"),
        0xff10..=0xff19 => Text::fixed("cifra de anchura completa", "a full-width digit"),
        0xff0b | 0xff0c | 0xff0e => Text::fixed("signo de anchura completa", "a full-width sign"),
        0x066b => Text::fixed("separador decimal arábigo", "ARABIC DECIMAL SEPARATOR"),
        0x066c => Text::fixed("separador de millares arábigo", "ARABIC THOUSANDS SEPARATOR"),
        0x00b7 => Text::fixed("punto medio", "MIDDLE DOT"),
        0x2019 | 0x02bc => Text::fixed("apóstrofo tipográfico", "a typographic apostrophe"),
        _ => Text::fixed("carácter invisible", "an invisible character"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hint_names_the_number_that_was_meant() {
        for (text, unit, hinted) in [
            ("12.5", "mm", "the cell is formatted as text: set its format to General and type 12.5 again"),
            ("1,5", "mm", "use 1.5"),
            ("-0,25", "mm", "use -0.25"),
            ("1 234,5", "mm", "use 1234.5"),
            ("1.234,5", "mm", "use 1234.5"),
            ("1,234.5", "mm", "use 1234.5"),
            ("1.234.567", "mm", "use 1234567"),
            ("1,234", "mm", "use 1.234 or 1234, whichever is meant"),
            ("0,125", "mm", "use 0.125"),
            ("1_000", "", "use 1000"),
            ("12 mm", "mm", "use 12, without the unit: column D says mm"),
            ("12mm", "mm", "use 12, without the unit: column D says mm"),
            ("30°", "°", "use 30, without the unit: column D says °"),
            ("0x10", "", "write a decimal number with a point, such as 12.5"),
            ("nan", "mm", "write a decimal number with a point, such as 12.5"),
            ("inf", "mm", "write a decimal number with a point, such as 12.5"),
            ("1e400", "mm", "write a decimal number with a point, such as 12.5"),
            ("\u{2212}1.5", "mm", "use -1.5 (the text has the character U+2212, MINUS SIGN)"),
            ("1\u{a0}234", "mm", "use 1234 (the text has the character U+00A0, NO-BREAK SPACE)"),
            ("\u{ff11}\u{ff12}", "mm", "use 12 (the text has the character U+FF11, a full-width digit)"),
            (
                "\u{661}\u{662}\u{66b}\u{665}",
                "mm",
                "use 12.5 (the text has the character U+0661, an Arabic-Indic digit)",
            ),
            ("\u{200b}12", "mm", "use 12 (the text has the character U+200B, an invisible character)"),
        ] {
            assert_eq!(hint(text, unit).en, hinted, "{text:?}");
        }
    }

    #[test]
    fn a_number_is_shown_in_its_shortest_form() {
        for (number, shown) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1e308, "1e308"),
            (1e-320, "1e-320"),
            (0.1 + 0.2, "0.30000000000000004"),
            (-25.0, "-25"),
        ] {
            assert_eq!(decimal(number), shown);
        }
    }
}
