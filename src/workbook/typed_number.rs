//! Numbers typed as text: what was probably meant, said as a hint and never taken as the value.

use crate::finding::Raise;
use crate::number::decimal;
use crate::parameter::FieldKind;
use crate::table::Unit;
use crate::text::{Text, t};

use super::rules::value::*;

/// What is told of a text that stands where a number of that kind must: `name` is the parameter's, `unit` its unit.
#[must_use]
pub fn told(name: Text, text: &str, shown: String, unit: Unit, kind: &FieldKind) -> Box<dyn Raise> {
    let (plain, foreign) = plain(text);
    let plain = plain.trim();
    let fits = |number: &str| number.parse().is_ok_and(|number: f64| within(kind, number));
    let two = grouped(plain) && fits(&plain.replace('.', ""));
    if foreign.is_none() && strict(plain) && !two {
        return Box::new(NumberFormattedAsText { name, text: shown, number: plain.to_owned() });
    }
    let none = t("", "");
    let sign = foreign.map_or(none.clone(), |character| {
        let (Text { es, en }, code) = (self::name(character), u32::from(character));
        Text::new(
            format!(" (el texto lleva el carácter U+{code:04X}, {es})"),
            format!(" (the text has the character U+{code:04X}, {en})"),
        )
    });
    let suffix_at = plain.rfind(|character: char| character.is_ascii_digit()).map_or(0, |last| last + 1);
    let (number, suffix) = plain.split_at_checked(suffix_at).unwrap_or((plain, ""));
    let suffix = suffix.trim();
    // Letters after the digits are a unit typed into the value cell; a lone separator is part of the number.
    let number = if suffix.chars().all(|character| ".,".contains(character)) { plain } else { number };
    let typed_unit = suffix.chars().any(|character| character.is_alphabetic() || "°\"'%/″”“′".contains(character));
    let factor = match suffix {
        _ if !typed_unit => Some(1.0),
        // No cell of a form counts in per cent, and of millimetres or degrees there is none.
        "%" => unit.label().is_empty().then_some(0.01),
        suffix => super::unit::in_this(unit, suffix),
    };
    // Before inches a mark is that of feet, and not between thousands.
    let feet = number.contains('\'') && factor == Some(25.4);
    let factor = factor.filter(|_| !feet);
    let without = match (typed_unit, unit.label()) {
        (false, _) => none,
        (true, "") => t(" y sin unidad", " and without a unit"),
        (true, unit) => Text::new(
            format!(" y sin unidad: rodete lo lee en {unit}"),
            format!(" and without the unit: rodete reads it in {unit}"),
        ),
    };
    match read(number) {
        reading if factor.is_none() && (feet || reading.is_some()) => {
            let unit =
                if unit.label().is_empty() { t("sin unidad", "without a unit") } else { Text::same(unit.label()) };
            Box::new(NumberInOtherUnit { name, text: shown, unit })
        }
        Some(NumberMeaning::One(number)) => {
            let number = counted(number, factor);
            Box::new(NumberWithMarks { name, text: shown, number, unit: without, sign })
        }
        Some(NumberMeaning::Either(one, other)) => {
            let [one, other] = [one, other].map(|number| counted(number, factor));
            // Of two readings that one is meant which the cell takes.
            match [fits(&one), fits(&other)] {
                [true, false] => Box::new(NumberWithMarks { name, text: shown, number: one, unit: without, sign }),
                [false, true] => Box::new(NumberWithMarks { name, text: shown, number: other, unit: without, sign }),
                _ => Box::new(NumberOfTwoReadings { name, text: shown, one, other, sign }),
            }
        }
        None => Box::new(NotANumber { name, text: shown, example: example(kind), sign }),
    }
}

/// True for a number that a cell takes.
fn within(kind: &FieldKind, number: f64) -> bool {
    match *kind {
        FieldKind::Whole { min, max } => number.fract() == 0.0 && (f64::from(min)..=f64::from(max)).contains(&number),
        FieldKind::Real { min, max } => (min..=max).contains(&number),
        _ => false,
    }
}

/// A number that the cell takes.
fn example(kind: &FieldKind) -> String {
    let (min, max, usual): (_, _, &[f64]) = match *kind {
        FieldKind::Whole { min, max } => (f64::from(min), f64::from(max), &[12.0, 2.0, 1.0, 120.0]),
        FieldKind::Real { min, max } => (min, max, &[12.5, 1.5, 0.5, 0.05, 0.005, 125.0]),
        _ => return String::new(),
    };
    decimal(usual.iter().copied().find(|one| (min..=max).contains(one)).unwrap_or(max))
}

/// A point before three digits, which may stand between thousands, too.
fn grouped(text: &str) -> bool {
    let parts = text.trim_start_matches(['+', '-']).split_once('.');
    parts.is_some_and(|(whole, digits)| {
        (1..=3).contains(&whole.len()) && !whole.starts_with('0') && digits.len() == 3 && digits.parse::<u16>().is_ok()
    })
}

/// What a text may mean as a number.
#[derive(Debug, PartialEq, Eq)]
enum NumberMeaning {
    One(String),
    /// One mark that may stand before decimals or between thousands.
    Either(String, String),
}

/// Digits with an optional sign, point and exponent, giving a finite number.
fn strict(text: &str) -> bool {
    !text.is_empty()
        && text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte))
        && text.parse::<f64>().is_ok_and(f64::is_finite)
}

fn read(text: &str) -> Option<NumberMeaning> {
    let text = text.trim();
    if grouped(text) {
        return Some(NumberMeaning::Either(text.to_owned(), text.replace('.', "")));
    }
    if strict(text) {
        return Some(NumberMeaning::One(text.to_owned()));
    }
    let (sign, digits) = match text.strip_prefix('-') {
        Some(rest) => ("-", rest.trim_start()),
        None => ("", text.strip_prefix('+').unwrap_or(text)),
    };
    let well_formed = digits.starts_with(|character: char| character.is_ascii_digit())
        && digits.ends_with(|character: char| character.is_ascii_digit())
        && digits.chars().all(|character| character.is_ascii_digit() || " '_.,".contains(character));
    if !well_formed || digits.starts_with("0x") {
        return None;
    }
    if let Some(joined) = joined(digits) {
        let joined = format!("{sign}{joined}");
        // One mark alone may stand before decimals, too.
        let [whole, fraction] = digits.split_once([',', '\'']).map(<[&str; 2]>::from).unwrap_or_default();
        let either = !whole.is_empty() && fraction.len() == 3;
        return Some(if either {
            NumberMeaning::Either(format!("{sign}{whole}.{fraction}"), joined)
        } else {
            NumberMeaning::One(joined)
        });
    }
    let (whole, fraction) = digits.rsplit_once([',', '.', '\''])?;
    let plain = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let whole = if plain(whole) { whole.to_owned() } else { joined(whole)? };
    plain(fraction).then(|| NumberMeaning::One(format!("{sign}{whole}.{fraction}")))
}

/// The digits of a number with one mark between its thousands: a group of one to three digits, and all others of three.
fn joined(digits: &str) -> Option<String> {
    let mark = digits.chars().find(|character| !character.is_ascii_digit())?;
    let groups: Vec<&str> = digits.split(mark).collect();
    let of_digits = groups.iter().all(|group| group.bytes().all(|byte| byte.is_ascii_digit()));
    let first = groups.first().filter(|first| (1..=3).contains(&first.len()) && !first.starts_with('0'));
    let whole = first.is_some() && groups.iter().skip(1).all(|group| group.len() == 3);
    (of_digits && whole).then(|| groups.concat())
}

/// A number as typed, or in another unit to the digits that anybody types.
fn counted(number: String, factor: Option<f64>) -> String {
    match (factor, number.parse::<f64>()) {
        (Some(factor), Ok(typed)) if factor != 1.0 => crate::number::shown(typed * factor, 6),
        _ => number,
    }
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
                0x066c | 0x00b4 | 0x2019 | 0x02bc => Some('\''),
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
        0x2212 => t("signo menos tipográfico", "MINUS SIGN"),
        0x2013 => t("semirraya", "EN DASH"),
        0x2014 => t("raya", "EM DASH"),
        0x2010..=0x2015 | 0xfe63 | 0xff0d => t("guion que no es el signo menos", "a dash, not a minus sign"),
        0x00a0 => t("espacio de no separación", "NO-BREAK SPACE"),
        0x202f => t("espacio estrecho de no separación", "NARROW NO-BREAK SPACE"),
        0x2000..=0x200a | 0x3000 => t("espacio tipográfico", "a typographic space"),
        0x0660..=0x0669 | 0x06f0..=0x06f9 => t("cifra arábiga oriental", "an Arabic-Indic digit"),
        0x0966..=0x096f => t("cifra devanagari", "a Devanagari digit"),
        0xff10..=0xff19 => t("cifra de anchura completa", "a full-width digit"),
        0xff0b | 0xff0c | 0xff0e => t("signo de anchura completa", "a full-width sign"),
        0x066b => t("separador decimal arábigo", "ARABIC DECIMAL SEPARATOR"),
        0x066c => t("separador de millares arábigo", "ARABIC THOUSANDS SEPARATOR"),
        0x00b7 => t("punto medio", "MIDDLE DOT"),
        0x00b4 => t("acento agudo", "ACUTE ACCENT"),
        0x2019 | 0x02bc => t("apóstrofo tipográfico", "a typographic apostrophe"),
        _ => t("carácter invisible", "an invisible character"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const REAL: FieldKind = FieldKind::Real { min: -1e9, max: 1e9 };

    #[test]
    fn of_two_readings_the_cell_decides_where_it_takes_one() {
        let angle = FieldKind::Real { min: 0.0, max: 80.0 };
        for (text, hinted) in [
            ("12.500", "set the cell's format to General if it is Text, and retype 12.500"),
            ("12,500", "set the cell's format to General if it is Text, and type the number 12.500"),
            ("1'500", "set the cell's format to General if it is Text, and type the number 1.500"),
        ] {
            let remedy = told(Text::same("γ"), text, String::new(), Unit::Degree, &angle).remedy().en;
            assert_eq!(remedy, format!("{hinted}, with the decimal sign of your spreadsheet"), "{text}");
        }
        let number = FieldKind::Whole { min: 1, max: 9999 };
        let remedy = told(Text::same("S"), "1.500", String::new(), Unit::One, &number).remedy().en;
        assert_eq!(
            remedy,
            "set the cell's format to General if it is Text, and type the number 1500, with the decimal sign of your spreadsheet"
        );
    }

    #[test]
    fn the_example_is_a_number_that_the_cell_takes() {
        for (kind, example) in [
            (REAL, "12.5"),
            (FieldKind::Real { min: 0.0005, max: 1.0 }, "0.5"),
            (FieldKind::Real { min: 0.001, max: 0.01 }, "0.005"),
            (FieldKind::Whole { min: 1, max: 9999 }, "12"),
            (FieldKind::Whole { min: 1, max: 4 }, "2"),
            (FieldKind::Whole { min: 500, max: 600 }, "600"),
        ] {
            let remedy = told(Text::same("R"), "many", String::new(), Unit::One, &kind).remedy().en;
            let hinted = format!("type a number, such as {example}, with the decimal sign of your spreadsheet");
            assert_eq!(remedy, hinted);
        }
    }

    #[test]
    fn the_hint_names_the_number_that_was_meant() {
        for (text, unit, hinted) in [
            ("12.5", Unit::Millimetre, "set the cell's format to General if it is Text, and retype 12.5"),
            ("0.125", Unit::Millimetre, "set the cell's format to General if it is Text, and retype 0.125"),
            // As typed into a spreadsheet that has the comma before decimals: two or two thousand.
            ("2.000", Unit::MillimetrePerMinute, "number 2.000 or 2000, whichever is meant"),
            ("1,5", Unit::Millimetre, "number 1.5"),
            ("-0,25", Unit::Millimetre, "number -0.25"),
            ("1 234,5", Unit::Millimetre, "number 1234.5"),
            ("1.234,5", Unit::Millimetre, "number 1234.5"),
            ("1,234.5", Unit::Millimetre, "number 1234.5"),
            ("1.234.567", Unit::Millimetre, "number 1234567"),
            ("1,234", Unit::Millimetre, "number 1.234 or 1234, whichever is meant"),
            ("0,125", Unit::Millimetre, "number 0.125"),
            ("1,234,567", Unit::Millimetre, "number 1234567"),
            ("1'234.5", Unit::Millimetre, "number 1234.5"),
            ("1 234'5", Unit::Millimetre, "number 1234.5"),
            ("1234,567", Unit::Millimetre, "number 1234.567"),
            // The apostrophe stands before decimals in Spain, and between thousands elsewhere.
            ("2'5", Unit::Millimetre, "number 2.5"),
            ("-12'75", Unit::Millimetre, "number -12.75"),
            ("0'4", Unit::Millimetre, "number 0.4"),
            ("0'025", Unit::Millimetre, "number 0.025"),
            ("3'1416", Unit::Millimetre, "number 3.1416"),
            ("1'234", Unit::Millimetre, "number 1.234 or 1234, whichever is meant"),
            ("1'234'567", Unit::Millimetre, "number 1234567"),
            ("2\u{b4}5", Unit::Millimetre, "number 2.5 (the text has the character U+00B4, ACUTE ACCENT)"),
            // Marks that are neither before decimals nor between thousands.
            ("2..5", Unit::Millimetre, "type a number, such as 12.5"),
            ("1.5.3", Unit::Millimetre, "type a number, such as 12.5"),
            ("2 5", Unit::Millimetre, "type a number, such as 12.5"),
            ("1'2'5", Unit::Millimetre, "type a number, such as 12.5"),
            ("12.34,5", Unit::Millimetre, "type a number, such as 12.5"),
            ("1_000", Unit::One, "number 1000"),
            ("0x10", Unit::One, "type a number, such as 12.5"),
            ("nan", Unit::Millimetre, "type a number, such as 12.5"),
            ("inf", Unit::Millimetre, "type a number, such as 12.5"),
            ("1e400", Unit::Millimetre, "type a number, such as 12.5"),
            ("\u{2212}1.5", Unit::Millimetre, "number -1.5 (the text has the character U+2212, MINUS SIGN)"),
            ("1\u{a0}234", Unit::Millimetre, "number 1234 (the text has the character U+00A0, NO-BREAK SPACE)"),
            ("\u{ff11}\u{ff12}", Unit::Millimetre, "number 12 (the text has the character U+FF11, a full-width digit)"),
            (
                "\u{661}\u{662}\u{66b}\u{665}",
                Unit::Millimetre,
                "number 12.5 (the text has the character U+0661, an Arabic-Indic digit)",
            ),
            ("\u{200b}12", Unit::Millimetre, "number 12 (the text has the character U+200B, an invisible character)"),
        ] {
            let remedy = told(Text::same("R"), text, String::new(), unit, &REAL).remedy().en;
            let hinted = match hinted.strip_prefix("number ") {
                Some(number) => format!("set the cell's format to General if it is Text, and type the number {number}"),
                None => hinted.to_owned(),
            };
            assert_eq!(remedy, format!("{hinted}, with the decimal sign of your spreadsheet"), "{text:?}");
        }
    }

    #[test]
    fn a_typed_unit_is_left_out_and_a_percentage_is_divided() {
        for (text, unit, hinted) in [
            (
                "12 mm",
                Unit::Millimetre,
                "12, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm",
            ),
            (
                "12mm",
                Unit::Millimetre,
                "12, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm",
            ),
            (
                "30°",
                Unit::Degree,
                "30, with the decimal sign of your spreadsheet and without the unit: rodete reads it in °",
            ),
            // Another unit is counted over; one that rodete does not know gets no number.
            (
                "2 in",
                Unit::Millimetre,
                "50.8, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm",
            ),
            (
                "0,3 m/min",
                Unit::MillimetrePerMinute,
                "300, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm/min",
            ),
            (
                "11.8 in/min",
                Unit::MillimetrePerMinute,
                "299.72, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm/min",
            ),
            (
                "2\u{201d}",
                Unit::Millimetre,
                "50.8, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm",
            ),
            (
                "12 MM",
                Unit::Millimetre,
                "12, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm",
            ),
            (
                "1'250'000 mm.",
                Unit::Millimetre,
                "1250000, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm",
            ),
            (
                "300 mm / min",
                Unit::MillimetrePerMinute,
                "300, with the decimal sign of your spreadsheet and without the unit: rodete reads it in mm/min",
            ),
            ("7 álabes", Unit::Count, "7, with the decimal sign of your spreadsheet and without a unit"),
            (
                "1,250 in",
                Unit::Millimetre,
                "31.75 or 31750, whichever is meant, with the decimal sign of your spreadsheet",
            ),
            ("10 %", Unit::One, "0.1, with the decimal sign of your spreadsheet and without a unit"),
            ("-2,5%", Unit::One, "-0.025, with the decimal sign of your spreadsheet and without a unit"),
        ] {
            let remedy = told(Text::same("R"), text, String::new(), unit, &REAL).remedy().en;
            let hinted = format!("set the cell's format to General if it is Text, and type the number {hinted}");
            assert_eq!(remedy, hinted, "{text:?}");
        }
        for other in ["12 furlong", "5' 3\"", "5 %"] {
            let other = told(Text::same("R"), other, String::new(), Unit::Millimetre, &REAL);
            assert_eq!(other.remedy().en, "convert it, and type the number alone; the unit of the cell: mm");
        }
    }
}
