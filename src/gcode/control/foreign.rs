//! Programs for controls that rodete does not read, told by a sign that no program of its controls has.
//!
//! # References
//! Heidenhain TNC, user's manual of Klartext and DIN/ISO programming: `BEGIN PGM`, `BLK FORM`, `TOOL CALL`, `L X+5 R0 FMAX`; `%NAME G71 *`.
//! Siemens SINUMERIK, programming manuals, Fundamentals and Job planning: `%_N_NAME_MPF`, `T="NAME"`, `R1=5`, `MSG("...")`, `CYCLE81(...)`,
//! `MCALL`, `CR=`, `X=IC(...)`, `SUPA`, `LIMS=`, `TRANS`, `TRAORI`, `PROC`, `DEF REAL`, `GOTOF`, `STOPRE`, `$TC_DP1[...]`.
//! Fagor CNC 8070, programming manual, for what is no sign: `#` and `$` begin its statements, `V.P.NAME` is a variable, `[NAME]` a label, and
//! `L NAME` and `LL NAME` call subroutines.

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

/// Words that begin a block of a Siemens: a cycle holds for the blocks to come, the origin is shifted or turned, axes are transformed.
const STATEMENTS: [&str; 9] =
    ["AMIRROR", "AROT", "ASCALE", "ATRANS", "MCALL", "TRAFOOF", "TRANS", "TRANSMIT", "TRAORI"];
/// Words anywhere in one: X is a diameter, a jump goes back or on, blocks are no longer prepared, shifts are left out.
const WORDS: [&str; 7] = ["DIAM90", "DIAMOF", "DIAMON", "GOTOB", "GOTOF", "STOPRE", "SUPA"];
/// Names of a Siemens that get a value: the radius of an arc, edges, polar words, the spindle's angle and its limit.
const NAMES: [&str; 9] = ["AP", "CHF", "CHR", "CR", "LIMS", "RND", "RNDM", "RP", "SPOS"];
/// Cycles of a Siemens by the name before their parameters, which has a number behind it.
const CYCLES: [&str; 4] = ["CYCLE", "HOLES", "POCKET", "SLOT"];
/// The same without one.
const CALLS: [&str; 5] = ["GROUP_BEGIN", "GROUP_END", "LONGHOLE", "SETAL", "WORKPIECE"];
/// What the names of a Siemens's system variables begin with: of tools, programs, axes, channels and machine data.
const VARIABLES: [&str; 14] =
    ["$A_", "$AA_", "$AC_", "$AN_", "$MA_", "$MC_", "$MN_", "$P_", "$SA_", "$SC_", "$SN_", "$TC_", "$VA_", "$VC_"];
/// How a Siemens says of one coordinate what it means: absolute, incremental, an angle by the shortest way, up or down.
const COORDINATES: [&str; 5] = ["AC", "IC", "DC", "ACP", "ACN"];
/// What a Siemens declares a name as.
const TYPES: [&str; 9] = ["AXIS", "BOOL", "CHAN", "CHAR", "FRAME", "INT", "NCK", "REAL", "STRING"];

fn digit(one: char) -> bool {
    one.is_ascii_digit()
}

/// True for a character that a name is made of, also a name that is marked as on a Fagor or in LinuxCNC: `V.P.CR`, `#<cr>`, `[TRANS]`.
fn of_name(one: char) -> bool {
    one.is_ascii_alphanumeric() || "_.$#<>[]\"%".contains(one)
}

/// The sign of another control in a line; `None` for a line that one of rodete's controls may have.
#[must_use]
pub fn sign(line: &str) -> Option<Foreign> {
    let line = line.trim().to_ascii_uppercase();
    let header = line.trim_start_matches(';').trim_start();
    if header.starts_with("%_N_") || line.starts_with(';') && header.starts_with("$PATH=") {
        return Some(Foreign::of(SIEMENS, &header[..if header.starts_with('%') { 4 } else { 6 }]));
    }
    // Without its number.
    let whole = line.trim_start_matches('/');
    let numbered = whole.strip_prefix('N').filter(|number| number.starts_with(digit));
    let block = numbered.unwrap_or(whole).trim_start_matches(digit).trim_start();
    of_klartext(block).map(|sign| Foreign::of(KLARTEXT, &sign)).or_else(|| {
        if let Some(header) = block.strip_suffix('*').map(str::trim_end)
            && block.starts_with('%')
            && (header.ends_with("G71") || header.ends_with("G70"))
        {
            return Some(Foreign::of(DIN_ISO, &format!("% {} *", &header[header.len() - 3..])));
        }
        of_siemens(block).map(|sign| Foreign::of(SIEMENS, &sign))
    })
}

/// The sign of Klartext in a block without its number.
fn of_klartext(block: &str) -> Option<String> {
    const WORDS: [&str; 8] =
        ["BEGIN PGM", "END PGM", "BLK FORM", "TOOL CALL", "TOOL DEF", "CYCL DEF", "CYCL CALL", "CALL LBL"];
    if let Some(word) = WORDS.into_iter().find(|word| block.starts_with(word)) {
        return Some(word.to_owned());
    }
    // A straight line. Behind L alone a Fagor 8070 has the name of a subroutine, which may be a letter and a number.
    let line = block.strip_prefix("L ")?.trim_start();
    let axis = line.strip_prefix('I').unwrap_or(line);
    let number = axis.strip_prefix(|axis: char| "XYZABC".contains(axis))?;
    let word = number.split_whitespace().next()?;
    let numeric = word.trim_start_matches(['+', '-']);
    // A parameter may stand in place of the number.
    let size = numeric.strip_prefix('Q').unwrap_or(numeric);
    let plain = size.starts_with(digit) && size.chars().all(|one| digit(one) || ".,".contains(one));
    let among = number.split_whitespace().nth(1).is_some_and(|next| !next.starts_with(['(', ';']));
    let sure = number.starts_with(['+', '-']) || among;
    (plain && sure).then(|| format!("L {}", &line[..line.len() - number.len()]))
}

/// The sign of a Siemens in a block without its number.
fn of_siemens(block: &str) -> Option<String> {
    // A variable, a statement, a label or a name of another control; a call of a subroutine by its name.
    if block.starts_with(['#', '%', '[', '(', ';']) || block.starts_with("L ") || block.starts_with("LL ") {
        return None;
    }
    let first = block.split(|one: char| !of_name(one)).next().unwrap_or_default();
    let behind = block[first.len()..].trim_start();
    let second = behind.split(|one: char| !of_name(one) || one == '[').next().unwrap_or_default();
    match first {
        "PROC" if behind.starts_with(|one: char| one.is_ascii_alphabetic() || one == '_') => {
            return Some("PROC".into());
        }
        "DEF" | "REDEF" if TYPES.contains(&second) => return Some(format!("{first} {second}")),
        "MSG" if behind.starts_with('(') => return Some("MSG(".into()),
        _ => {}
    }
    let numbered = |name: &str, word: &str| {
        name.strip_prefix(word).is_some_and(|number| !number.is_empty() && number.chars().all(digit))
    };
    if numbered(first, "R") && behind.starts_with('=') {
        return Some(format!("{first}="));
    }
    // Behind the first parenthesis stand comments and statements of other controls: here the parameters of a name.
    if let Some((before, _)) = block.split(';').next().and_then(|code| code.split_once('(')) {
        let cycle = CYCLES.iter().any(|cycle| numbered(first, cycle));
        // The name of a cycle of the machine's builder begins so.
        let call =
            CALLS.contains(&first) || first.starts_with('_') && first.len() > 1 && first.bytes().all(of_identifier);
        if behind.starts_with('(') && (cycle || call && before == first) {
            return Some(format!("{first}("));
        }
        let before = before.trim_end();
        let coordinate = COORDINATES
            .into_iter()
            .find(|word| before.strip_suffix(word).is_some_and(|rest| rest.trim_end().ends_with('=')));
        if let Some(word) = coordinate {
            return Some(format!("={word}("));
        }
    }
    let plain = without_parentheses(block);
    // A condition in parentheses stands in them as a whole.
    let variables = if first == "IF" { block } else { &plain };
    let variable = variables
        .split(|one: char| !(one == '$' || one == '_' || one.is_ascii_alphanumeric()))
        .find(|word| VARIABLES.iter().any(|variable| word.starts_with(variable)));
    let word = || plain.split(|one: char| !of_name(one)).find(|word| WORDS.contains(word));
    let statement = STATEMENTS.contains(&first).then_some(first);
    variable.or(statement).or_else(word).map(str::to_owned).or_else(|| named(&plain))
}

fn of_identifier(one: u8) -> bool {
    one.is_ascii_alphanumeric() || one == b'_'
}

/// The name of [`NAMES`] that gets a value, or a tool that is called by its name.
fn named(plain: &str) -> Option<String> {
    plain.match_indices('=').find_map(|(at, _)| {
        let before = plain[..at].trim_end();
        // The spindle of a Siemens has its number in brackets.
        let before =
            before.strip_suffix(']').and_then(|inside| inside.strip_suffix(digit)?.strip_suffix('[')).unwrap_or(before);
        let name = before.rsplit(|one: char| !of_name(one)).next().unwrap_or_default();
        if !name.bytes().all(of_identifier) {
            return None;
        }
        // Words may stand before it without a blank.
        let word = name.rsplit(|one: char| !one.is_ascii_uppercase()).next().unwrap_or_default();
        if word == "T" && plain[at + 1..].trim_start().starts_with('"') {
            return Some("T=\"".to_owned());
        }
        NAMES.contains(&word).then(|| format!("{word}="))
    })
}

/// A block up to its comment, without what stands in parentheses.
fn without_parentheses(block: &str) -> String {
    let mut depth = 0_usize;
    let code = block.split(';').next().unwrap_or_default();
    let plain = code.chars().map(|one| {
        match one {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            _ if depth == 0 => return one,
            _ => {}
        }
        ' '
    });
    plain.collect()
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
            ("L IX+5", KLARTEXT, "L IX"),
            ("1 L X-Q5 FMAX", KLARTEXT, "L X"),
            ("12 L X5 R0 FMAX", KLARTEXT, "L X"),
            ("CALL LBL 1", KLARTEXT, "CALL LBL"),
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
            ("G2X10Y5CR = 5", SIEMENS, "CR="),
            ("G0 SUPA Z0 D0", SIEMENS, "SUPA"),
            ("MCALL CYCLE82(5,0,2,-10,,0)", SIEMENS, "MCALL"),
            ("/N40 MCALL", SIEMENS, "MCALL"),
            ("PROC SH610", SIEMENS, "PROC"),
            ("proc _SPEEDS(Real DOD3, Real DOD2)", SIEMENS, "PROC"),
            ("Def Int BRTOC ;wheel", SIEMENS, "DEF INT"),
            ("DEF STRING[55] NAME", SIEMENS, "DEF STRING"),
            ("N10 STOPRE", SIEMENS, "STOPRE"),
            ("IF (BROJ<0) GOTOF KRAJ", SIEMENS, "GOTOF"),
            ("IF (($TC_DP1[D,1]==494))", SIEMENS, "$TC_DP1"),
            ("SPINU=$TC_TPG1[BRTOC]", SIEMENS, "$TC_TPG1"),
            ("g0 c=ic(360)", SIEMENS, "=IC("),
            ("G1 X = AC (5) F100", SIEMENS, "=AC("),
            ("WORKPIECE(,,,\"CYLINDER\",0,0,-50)", SIEMENS, "WORKPIECE("),
            ("N20 POCKET3(5,0,1,-10)", SIEMENS, "POCKET3("),
            ("_GRINDING_SETUP(1,0.01,5)", SIEMENS, "_GRINDING_SETUP("),
            ("TRANS X10 Y5", SIEMENS, "TRANS"),
            ("TRANS", SIEMENS, "TRANS"),
            ("N10 TRAORI(1)", SIEMENS, "TRAORI"),
            ("SPOS=0", SIEMENS, "SPOS="),
            ("SPOS[1]=90", SIEMENS, "SPOS="),
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
            "° = 5",
            // Names, labels and statements of a Fagor 8070 and of an 8055.
            "V.P.CR=5",
            "V.P.X1CR = 5",
            "V.P.TRANS=1 G1 X5",
            "[TRANS]",
            "$GOTO [STOPRE]",
            "$IF V.P.R1==5",
            "$ENDIF",
            "#DEF \"A\"=\"TRANS X5\"",
            "#MCALL [\"A.NC\"]",
            "#MSG [\"STOPRE\"]",
            "LL TRANS",
            "L TRANS.NC",
            "L X1",
            "L X1 (drills)",
            "L XQ5 ;mills",
            "%L SUPA",
            "%TRANS,MX--,",
            "G1 X=V.P.A1",
            "S1=500 X1=10",
            "(MCALL 1)",
            "(IF (P1 EQ 1) GOTO N10)",
            "(GOTOF)",
            "(X=IC(5))",
            // O-words and parameters of LinuxCNC, macros of a Fanuc.
            "#<cr>=5",
            "#<_trans> = 5",
            "#1=ABS[#2] (CR=5)",
            "G1 X#<cr> (=IC(5))",
            "o<trans> call [1] [2]",
            "o<_my_sub>call (a)",
            "o100 if [#<r1> EQ 5]",
            "o100 endif",
            "IF[#1EQ1]GOTO10 (GOTOF)",
            "IF [#100 EQ 5] THEN #101=2",
            "WHILE[#1LT5]DO1",
            "END1",
            "ENDIF",
            "POPEN",
            "DPRNT[X#100[53]]",
            "T0101 (ROUGH_FACE(80))",
            // No program at all.
            "12 N8 SET_SPINDLE_SPEED(0, 600.0000)",
            "CALL and MCALL subroutines",
            "cycle (G87)",
            "cd $TEST_DIR",
            "def axis_open(t):",
            "_(empty)_",
        ] {
            assert_eq!(sign(line), None, "{line}");
        }
        assert_eq!(of_ending("MPF").map(|found| found.sign), Some(".MPF".to_owned()));
        assert_eq!([of_ending("nc"), of_ending("ngc"), of_ending("pim")], [None, None, None]);
    }
}
