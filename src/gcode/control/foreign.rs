//! Programs for controls that rodete does not read, told by a sign that no program of its controls has.
//!
//! # References
//! Heidenhain TNC, user's manual of Klartext and DIN/ISO programming: `BEGIN PGM`, `BLK FORM`, `TOOL CALL`, `L X+5 R0 FMAX`; `%NAME G71 *`.
//! Siemens SINUMERIK, programming manual: `%_N_NAME_MPF`, `T="NAME"`, `R1=5`, `MSG("...")`, `CYCLE81(...)`, `CR=`, `SUPA`, `LIMS=`.

use crate::text::{Text, t};

const KLARTEXT: Text = t("Heidenhain (Klartext)", "Heidenhain (Klartext)");
const DIN_ISO: Text = t("Heidenhain (DIN/ISO)", "Heidenhain (DIN/ISO)");
const SIEMENS: Text = t("Siemens SINUMERIK", "Siemens SINUMERIK");

/// A control that rodete does not read, and the sign of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Foreign {
    /// The control.
    pub control: Text,
    /// What the program has that no program of rodete's controls has.
    pub sign: String,
}

impl Foreign {
    fn of(control: Text, sign: &str) -> Self {
        Self { control, sign: sign.to_owned() }
    }
}

/// The sign of another control in a line; `None` for a line that one of rodete's controls may have.
#[must_use]
pub fn sign(line: &str) -> Option<Foreign> {
    const WORDS: [&str; 6] = ["BEGIN PGM", "END PGM", "BLK FORM", "TOOL CALL", "TOOL DEF", "CYCL DEF"];
    let line = line.trim().to_ascii_uppercase();
    let digit = |one: char| one.is_ascii_digit();
    let header = line.trim_start_matches(';').trim_start();
    if header.starts_with("%_N_") || line.starts_with(';') && header.starts_with("$PATH=") {
        return Some(Foreign::of(SIEMENS, &header[..if header.starts_with('%') { 4 } else { 6 }]));
    }
    // Without its number.
    let block = line.strip_prefix('N').unwrap_or(&line).trim_start_matches(digit).trim_start();
    if let Some(word) = WORDS.into_iter().find(|word| block.starts_with(word)) {
        return Some(Foreign::of(KLARTEXT, word));
    }
    if let Some(behind) = block.strip_prefix("L ").map(str::trim_start)
        && behind.starts_with(|axis: char| "XYZABC".contains(axis))
        && behind[1..].starts_with(|one: char| digit(one) || "+-".contains(one))
    {
        return Some(Foreign::of(KLARTEXT, &format!("L {}", &behind[..1])));
    }
    if let Some(header) = block.strip_suffix('*').map(str::trim_end)
        && block.starts_with('%')
        && (header.ends_with("G71") || header.ends_with("G70"))
    {
        return Some(Foreign::of(DIN_ISO, &format!("% {} *", &header[header.len() - 3..])));
    }
    // Behind the first parenthesis or semicolon stand comments and statements of other controls.
    let plain = block.split(['(', ';']).next().unwrap_or_default();
    let numbered = |word: &str, end: &str| {
        let behind = block.strip_prefix(word)?;
        let rest = behind.trim_start_matches(digit);
        (rest.len() < behind.len() && rest.trim_start().starts_with(end))
            .then(|| block[..block.len() - rest.len()].to_owned())
    };
    let sign = if block.strip_prefix("MSG").is_some_and(|rest| rest.trim_start().starts_with('(')) {
        "MSG(".to_owned()
    } else if let Some(cycle) = numbered("CYCLE", "(") {
        format!("{cycle}(")
    } else if let Some(parameter) = numbered("R", "=") {
        format!("{parameter}=")
    } else {
        ["T=\"", "CR=", "LIMS=", "SUPA"].into_iter().find(|sign| plain.contains(sign))?.to_owned()
    };
    Some(Foreign::of(SIEMENS, &sign))
}

/// The control whose files have an ending (without the dot); `None` for one that rodete's controls have too.
#[must_use]
pub fn of_ending(ending: &str) -> Option<Foreign> {
    let control = match ending.to_ascii_lowercase().as_str() {
        "mpf" | "spf" => SIEMENS,
        "h" => KLARTEXT,
        "i" => DIN_ISO,
        _ => return None,
    };
    Some(Foreign { control, sign: format!(".{ending}") })
}

#[cfg(test)]
mod tests {
    use super::{DIN_ISO, KLARTEXT, SIEMENS, of_ending, sign};

    #[test]
    fn a_sign_is_one_that_no_program_of_rodetes_controls_has() {
        for (line, control, shown) in [
            ("0 BEGIN PGM W5269 MM", KLARTEXT, "BEGIN PGM"),
            ("19 BLK FORM 0.1 Z X-498 Y-184 Z-46", KLARTEXT, "BLK FORM"),
            ("24 L Z+0 R0 FMAX M92", KLARTEXT, "L Z"),
            ("L X-5,5 FMAX", KLARTEXT, "L X"),
            ("%NEU G71 *", DIN_ISO, "% G71 *"),
            ("N99999999 %NEU G71*", DIN_ISO, "% G71 *"),
            ("N30 T=\"ROUGH_FACE\" D1 ; CNMG", SIEMENS, "T=\""),
            ("N40 LIMS=1500", SIEMENS, "LIMS="),
            ("n10 msg (\"hello\")", SIEMENS, "MSG("),
            ("N60 CYCLE81(25.0, 0.0)", SIEMENS, "CYCLE81("),
            ("R12 = 5", SIEMENS, "R12="),
            ("%_N_SHAFT_12_MPF", SIEMENS, "%_N_"),
            (";%_N_SHAFT_12_MPF", SIEMENS, "%_N_"),
            (";$PATH=/_N_MPF_DIR", SIEMENS, "$PATH="),
            ("G2 X10 Y5 CR=5", SIEMENS, "CR="),
        ] {
            let found = sign(line).map(|found| (found.control, found.sign));
            assert_eq!(found, Some((control, shown.to_owned())), "{line}");
        }
        for line in [
            "",
            "%",
            "%0001-A,MX--,",
            "%4711 G71",
            "N10 G1 X5 R1",
            "(MSG, hello)",
            "(MSG \"hello\")",
            "(T=\"1\")",
            "; R1=5 is the radius",
            "M98 P1 L3",
            "L3 X5",
            "G1 X5 (CR=5)",
            "#1=5",
            "(P1=5)",
            "(BEGIN PGM)",
            "G84 R1 P2",
        ] {
            assert_eq!(sign(line), None, "{line}");
        }
        assert_eq!(of_ending("MPF").map(|found| found.sign), Some(".MPF".to_owned()));
        assert_eq!([of_ending("nc"), of_ending("ngc"), of_ending("pim")], [None, None, None]);
    }
}
