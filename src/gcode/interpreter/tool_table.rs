//! LinuxCNC's tool table.
//!
//! # References
//! LinuxCNC, "Tool table format": a line for each tool, T its number, P its pocket, X to W its offsets, D its diameter, I J
//! its angles, Q its orientation, a comment after `;`. Lengths in the machine's unit. Of a tool with an orientation from 1 to
//! 9 D is twice the nose radius. No length or angle may go beyond what a coordinate may be, 99,999.999 mm or degrees.

use crate::escape::excerpt;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::gcode::interpreter::setting::{ToolOffset, Tools};
use crate::gcode::turning::nose::{Nose, Tip};
use crate::gcode::turning::rules::{NoWordOfToolTable, ToolTwiceInTable};
use crate::limits::EXCERPT;
use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;
use crate::number::grid::LIMIT;

/// Reads a tool table whose lengths are in a unit.
///
/// # Errors
/// For a line that is no tool, each with its line and column.
pub fn parse(bytes: &[u8], unit: LengthUnit) -> Result<Tools, Refusal> {
    let mut tools = Tools::new();
    let mut findings = Vec::new();
    let text = String::from_utf8_lossy(bytes);
    for (line, content) in (1..).zip(text.lines()) {
        let words = content.split(';').next().unwrap_or_default();
        if words.trim().is_empty() {
            continue;
        }
        match tool(words, unit) {
            Ok((number, tool)) => {
                if tools.insert(number, tool).is_some() {
                    findings.push(refused(line, 1, &format!("T{number}"), true));
                }
            }
            Err((column, word)) => findings.push(refused(line, column, &word, false)),
        }
    }
    if findings.is_empty() { Ok(tools) } else { Err(Refusal { exit: Exit::Refused, findings }) }
}

fn refused(line: usize, column: usize, word: &str, twice: bool) -> Finding {
    let word = excerpt(word, EXCERPT);
    let place = Place::Line { line, columns: vec![column] };
    if twice { ToolTwiceInTable { word }.at(place) } else { NoWordOfToolTable { word }.at(place) }
}

/// One tool, or the column and the word that is wrong.
fn tool(words: &str, unit: LengthUnit) -> Result<(u32, ToolOffset), (usize, String)> {
    let mut number = None;
    let mut tool = ToolOffset::default();
    let (mut orientation, mut below) = (None, None);
    for word in words.split_whitespace() {
        let column = word.as_ptr() as usize - words.as_ptr() as usize + 1;
        let wrong = || (column, word.to_owned());
        let mut letters = word.chars();
        let letter = letters.next().ok_or_else(wrong)?.to_ascii_uppercase();
        let digits = letters.as_str();
        let plain = digits.bytes().all(|byte| byte.is_ascii_digit() || b"+-.".contains(&byte));
        let value: f64 = digits.parse().ok().filter(|value: &f64| plain && value.is_finite()).ok_or_else(wrong)?;
        let bounded =
            |value: f64| Some(value).filter(|value| value.abs() <= f64::from(LIMIT) / 1000.0).ok_or_else(wrong);
        match letter {
            'T' => number = Some(digits.parse().map_err(|_| wrong())?),
            'D' => {
                tool.diameter = bounded(unit.to_mm(value))?;
                below = (value < 0.0).then(wrong);
            }
            'Q' => {
                let tip = digits.parse().ok().and_then(Tip::of_linuxcnc).ok_or_else(wrong)?;
                // 0 stands for no orientation.
                orientation = Some(tip).filter(|_| value != 0.0);
            }
            'P' | 'I' | 'J' => {}
            _ => {
                let axis = Axis::ALL.into_iter().find(|axis| axis.letter() == letter).ok_or_else(wrong)?;
                tool.offset.set(axis, bounded(if axis.rotary() { value } else { unit.to_mm(value) })?);
            }
        }
    }
    if let (Some(_), Some(below)) = (orientation, below) {
        return Err(below);
    }
    tool.nose = orientation.map(|tip| Nose { radius: tool.diameter / 2.0, tip });
    number.map(|number| (number, tool)).ok_or_else(|| (1, words.trim().to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tools_are_read_with_their_lengths_in_millimetres() {
        let tools = parse(b"T1 P1 Z+1.5 D0.25 ; drill\n\n;none\nT12 P3 X-1 Z2\n", LengthUnit::Inch).unwrap();
        let near = |one: f64, other: f64| (one - other).abs() < 1e-12;
        assert!(near(tools[&1].offset.get(Axis::Z), 38.1));
        assert!(near(tools[&1].diameter, 6.35));
        assert!(near(tools[&12].offset.get(Axis::X), -25.4));
    }

    #[test]
    fn a_tool_with_an_orientation_has_a_nose_with_x_the_way_of_the_axis() {
        let tools = parse(b"T1 Q2 D1.6\nT2 D1.6\nT3 Q0 D1.6\nT4 Q9\n", LengthUnit::Millimetre).unwrap();
        assert_eq!(tools[&1].nose, Some(Nose { radius: 0.8, tip: Tip::new(3).unwrap() }));
        assert_eq!((tools[&2].nose, tools[&3].nose), (None, None));
        assert_eq!(tools[&4].nose, Some(Nose { radius: 0.0, tip: Tip::new(9).unwrap() }));
    }

    #[test]
    fn no_length_goes_beyond_a_coordinate_in_either_unit() {
        assert!(parse(b"T1 D99999.999 Z-99999.999", LengthUnit::Millimetre).is_ok());
        assert!(parse(b"T1 D4000", LengthUnit::Inch).is_err(), "101.6 m");
        // Finite in inches, and no number in millimetres.
        let digits = "9".repeat(308);
        assert!(parse(format!("T1 D{digits}").as_bytes(), LengthUnit::Inch).is_err());
    }

    #[test]
    fn what_is_no_tool_is_refused_with_its_place() {
        for (text, place) in [
            ("T1 Z1,5", (1, 4)),
            ("T1 Z1\nT1 Z2", (2, 1)),
            ("Z5", (1, 1)),
            ("T1 Znan", (1, 4)),
            ("T1.5", (1, 1)),
            ("T1 E5", (1, 4)),
            ("T1 D2 Q10", (1, 7)),
            ("T1 Q2.5", (1, 4)),
            ("T1 D-1 Q2", (1, 4)),
            ("T1 D100000", (1, 4)),
            ("T1 Z-100000", (1, 4)),
            ("T1 P1 A100000", (1, 7)),
        ] {
            let refusal = parse(text.as_bytes(), LengthUnit::Millimetre).unwrap_err();
            assert_eq!(refusal.findings[0].place, Place::Line { line: place.0, columns: vec![place.1] }, "{text}");
        }
    }
}
