//! Which control a program is in, where nobody says so.

use std::collections::BTreeSet;

use crate::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, FANUC_LATHE_A, LINUXCNC};

/// The control that the beginning of a program and its file's ending (without the dot) tell.
///
/// The header of a program that rodete wrote names it. `.pim` is a Fagor 8055, `.pit` an 8055 T, `.ngc` LinuxCNC. A first line of a name
/// and attributes, `%name,MX--,`, is a Fagor 8055, or 8055 T where a block has G96 with S, or where one has G95 and none as far as the end
/// has Y; `%number-name` is a Fagor 8070, or 8055 where a block has G43 or limits the spindle by G92 with S alone, which an 8070 has not.
/// That is an 8055 T where no block has Y, and one has G96 with S or G92 with S alone, or as above G95. An M code from M10 to M18 or M20 to M29, which LinuxCNC does not have and a machine's builder gives
/// a Fagor (clamps of rotary axes), is a Fagor 8055, unless a line is written as for a Fanuc or a Haas, whose builders have such codes
/// too: with an O number, a `%` alone, G43 H, G28 or G30, or a number that begins or ends with its decimal point. So is a line that is a
/// statement in parentheses, as `(CALL 1)` or `(P100=5)`: another control would pass over it as a comment, and make another part; and so is
/// `(MSG "…")` in a text with G70 or G71. A line that begins with `#` and a word, as `#RTCP ON`, is a statement of a Fagor 8070: a parameter
/// of another control has a number or a name in `<>`. A Fanuc lathe of system A is told by a T of place and offset, `T0101`, or `T101` in a
/// text without M6; by `G50 S`; and by
/// G71, G72 or G73 with P, Q and U or W; by G28 or G30 with U or W; and by G92 with F, a thread. U and W alone tell nothing: they are
/// axes of LinuxCNC. Everything else is LinuxCNC.
///
/// With a lathe's workbook (`turned`), what no header names is a control that turns; see [`guess_turning`].
#[must_use]
pub fn guess(head: &[u8], ending: &str, turned: bool) -> &'static Control {
    let text = String::from_utf8_lossy(head);
    if let Some(control) = text.lines().find_map(headed) {
        return control;
    }
    if ending.eq_ignore_ascii_case("pit") {
        return &FAGOR_8055_T;
    }
    if ending.eq_ignore_ascii_case("pim") {
        return &FAGOR_8055;
    }
    if turned {
        return guess_turning(head);
    }
    if ending.eq_ignore_ascii_case("ngc") {
        return &LINUXCNC;
    }
    let first = text.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or_default();
    let fagor_8055 =
        || if text.lines().any(surface_speed) || turns_without_y(&text) { &FAGOR_8055_T } else { &FAGOR_8055 };
    if attributed(first) {
        return fagor_8055();
    }
    if first.strip_prefix('%').is_some_and(|name| name.starts_with(|letter: char| letter.is_ascii_digit())) {
        return numbered(&text);
    }
    let short = || text.lines().any(short_place_and_offset) && !text.lines().any(|line| has(&code(line), "M", "6"));
    if text.lines().any(|line| place_and_offset(line) || speed_limit(line) || roughs(line) || home_or_thread(line))
        || short()
    {
        return &FANUC_LATHE_A;
    }
    if text.lines().any(hash_statement) {
        return &FAGOR_8070;
    }
    if text.lines().any(statement) || text.lines().any(message) && text.lines().any(fagor_unit) {
        return fagor_8055();
    }
    if text.lines().any(builders_code) && !text.lines().any(of_fanuc) { &FAGOR_8055 } else { &LINUXCNC }
}

/// The Fagor of a program whose first line is `%number`.
fn numbered(text: &str) -> &'static Control {
    // G192 limits the spindle of an 8070.
    if text.lines().any(|line| hash_statement(line) || has(&code(line), "G", "192")) {
        return &FAGOR_8070;
    }
    // An 8070 has no G43, which takes up the tool's length on an 8055.
    if text.lines().any(|line| has(&code(line), "G", "43")) {
        return &FAGOR_8055;
    }
    let limited = text.lines().any(fagor_speed_limit);
    let without_y = !text.lines().skip_while(|line| line.trim().is_empty()).skip(1).any(|line| word(&code(line), 'Y'));
    if without_y && (limited || text.lines().any(surface_speed)) || turns_without_y(text) {
        return &FAGOR_8055_T;
    }
    if limited { &FAGOR_8055 } else { &FAGOR_8070 }
}

/// The same of a turning program. A line of a name and attributes, `%name,MX--,`, a statement in parentheses, or a tool with its offset
/// as `T1 D1` or `T1.1`, is a Fagor 8055 T; everything else is a Fanuc of system A, whose T carries both numbers.
#[must_use]
pub fn guess_turning(head: &[u8]) -> &'static Control {
    let text = String::from_utf8_lossy(head);
    let told = |line: &str| attributed(line.trim()) || statement(line) || tool_and_offset(line);
    if text.lines().any(told) { &FAGOR_8055_T } else { &FANUC_LATHE_A }
}

/// True where a program is a mill's for certain: the header of rodete names a mill's control; or the program is read as a mill's, and
/// ends in `.pim`, or beside words of Y it changes its tool by M6 or takes up a tool's length by G43. A lathe that has Y or live tools calls them by T alone.
#[must_use]
pub fn mills(head: &[u8], ending: &str) -> bool {
    if guess(head, ending, false).turns() {
        return false;
    }
    let text = String::from_utf8_lossy(head);
    let codes = || text.lines().map(code);
    ending.eq_ignore_ascii_case("pim")
        || text.lines().find_map(headed).is_some()
        || codes().any(|line| word(&line, 'Y')) && codes().any(|line| has(&line, "M", "6") || has(&line, "G", "43"))
}

/// The control that a header of rodete's names, as `;RODETE 0.1.0 - DIALECT FAGOR-8055-T`.
fn headed(line: &str) -> Option<&'static Control> {
    let comment = line.trim().trim_start_matches([';', '(']).trim_end_matches(')').to_ascii_lowercase();
    let (_, named) = comment.strip_prefix("rodete ")?.split_once(" - dialect")?;
    Control::named(named.trim_start_matches('o').trim())
}

/// The offsets D of the tools that a header of rodete's names, as `;TOOL T1 D1`; none of another program.
#[must_use]
pub fn tools_headed(head: &[u8]) -> BTreeSet<u32> {
    let text = String::from_utf8_lossy(head);
    if text.lines().find_map(headed).is_none() {
        return BTreeSet::new();
    }
    let named = |line: &str| {
        let comment = line.trim().strip_prefix([';', '('])?;
        let mut words = comment.trim_end_matches(')').split_whitespace();
        let of_tools = matches!(words.next()?, "TOOL" | "HERRAMIENTA") && words.next()?.starts_with('T');
        words.next()?.strip_prefix('D').filter(|_| of_tools)?.parse().ok()
    };
    text.lines().filter_map(named).collect()
}

/// True for `%name,attributes,` of a Fagor 8055, the attributes of M, X, H, O and dashes: also where they do not let the program run, which
/// is refused by its name.
fn attributed(line: &str) -> bool {
    let Some((_, attributes)) = line.strip_prefix('%').and_then(|line| line.split_once(',')) else { return false };
    let attributes = attributes.trim_end().trim_end_matches(',').trim();
    !attributes.is_empty() && attributes.bytes().all(|letter| b"MXHO-".contains(&letter.to_ascii_uppercase()))
}

/// True where a line is a statement of a Fagor 8055 in parentheses: a call, a subprogram, a repetition, a jump, or a parameter or an origin
/// that gets a value.
fn statement(line: &str) -> bool {
    let line = line.trim_start().trim_start_matches('/').to_ascii_uppercase();
    let line = line.trim_start_matches(|one: char| one == 'N' || one.is_ascii_digit() || one.is_whitespace());
    let Some(inside) = line.strip_prefix('(').map(str::trim_start) else { return false };
    let digit = |rest: &str| rest.trim_start().starts_with(|one: char| one.is_ascii_digit());
    let numbered = |word: &str| inside.strip_prefix(word).is_some_and(digit);
    let label = |word: &str| {
        let rest = inside.strip_prefix(word).and_then(|rest| rest.trim_start().strip_prefix('N'));
        rest.is_some_and(digit)
    };
    let alone = |word: &str| inside.strip_prefix(word).is_some_and(|rest| rest.trim_start().starts_with(')'));
    let assigned = |letters: &str| {
        let rest =
            inside.strip_prefix(letters).map(|rest| rest.trim_start_matches(|one: char| "XYZUVWABC".contains(one)));
        rest.is_some_and(|rest| {
            digit(rest) && rest.trim_start_matches(|one: char| one.is_ascii_digit()).trim_start().starts_with('=')
        })
    };
    ["CALL", "PCALL", "MCALL", "SUB"].into_iter().any(numbered)
        || ["RPT", "GOTO"].into_iter().any(label)
        || ["RET", "MDOFF"].into_iter().any(alone)
        || ["P", "ORG"].into_iter().any(assigned)
        || inside.starts_with("IF") && ["GOTO", "CALL", "RPT"].into_iter().any(|word| inside.contains(word))
}

/// True where a line is a statement of a Fagor 8070: `#` with a word of two letters or more behind it.
fn hash_statement(line: &str) -> bool {
    let line = line.trim_start().strip_prefix('#').unwrap_or_default();
    line.bytes().take_while(u8::is_ascii_alphabetic).count() > 1
}

/// True where a line shows a text as a Fagor 8055 does, `(MSG "text")`: LinuxCNC has a comma behind MSG.
fn message(line: &str) -> bool {
    let line = line.trim_start().to_ascii_uppercase();
    let text = line.strip_prefix('(').and_then(|line| line.trim_start().strip_prefix("MSG"));
    text.is_some_and(|text| text.trim_start().starts_with('"'))
}

/// True where a line says a Fagor's unit, G70 or G71, and has no word of a turning cycle.
fn fagor_unit(line: &str) -> bool {
    let code = code(line);
    ["70", "71"].into_iter().any(|number| has(&code, "G", number))
        && !['P', 'Q', 'U', 'W'].into_iter().any(|letter| word(&code, letter))
}

/// True where a line has G96 and S: constant surface speed, which no milling program has.
fn surface_speed(line: &str) -> bool {
    let code = code(line);
    has(&code, "G", "96") && word(&code, 'S')
}

/// True where a program feeds per revolution and has no word of Y, as far as its end. One that sets the plane XY is a mill's.
fn turns_without_y(text: &str) -> bool {
    let (mut per_turn, mut ends) = (false, false);
    for line in text.lines().skip_while(|line| line.trim().is_empty()).skip(1) {
        let code = code(line);
        if word(&code, 'Y') || has(&code, "G", "17") {
            return false;
        }
        per_turn |= has(&code, "G", "95");
        ends |= has(&code, "M", "30") || has(&code, "M", "2");
    }
    per_turn && ends
}

/// True where a line has G50 and S, the limit of the spindle's speed of a Fanuc lathe.
fn speed_limit(line: &str) -> bool {
    let code = code(line);
    has(&code, "G", "50") && word(&code, 'S')
}

/// True where a line has G92 and S without an axis, the limit of the spindle's speed of a Fagor 8055.
fn fagor_speed_limit(line: &str) -> bool {
    let code = code(line);
    has(&code, "G", "92") && word(&code, 'S') && !"XYZUVWABC".chars().any(|axis| word(&code, axis))
}

/// True where a line has the second block of a roughing cycle of a Fanuc lathe: the first and the last block of its contour, and the
/// finishing allowance.
fn roughs(line: &str) -> bool {
    let code = code(line);
    ["71", "72", "73"].into_iter().any(|number| has(&code, "G", number))
        && word(&code, 'P')
        && word(&code, 'Q')
        && (word(&code, 'U') || word(&code, 'W'))
}

/// True where a line goes to a reference point by increments, as G28 U0 W0, or threads by G92 with F.
fn home_or_thread(line: &str) -> bool {
    let code = code(line);
    let home = ["28", "30"].into_iter().any(|number| has(&code, "G", number));
    home && (word(&code, 'U') || word(&code, 'W'))
        || has(&code, "G", "92") && word(&code, 'F') && (word(&code, 'X') || word(&code, 'Z'))
}

/// True where a line without comment and blanks has a letter with a number, with or without a leading zero.
fn has(code: &str, letter: &str, number: &str) -> bool {
    code.split(letter).skip(1).any(|rest| {
        let end = rest.find(|one: char| !one.is_ascii_digit() && one != '.').unwrap_or(rest.len());
        rest[..end].trim_start_matches('0') == number
    })
}

/// True where a line without comment and blanks has a letter with a number.
fn word(code: &str, letter: char) -> bool {
    code.split(letter).skip(1).any(|rest| rest.starts_with(|one: char| one.is_ascii_digit() || "+-.".contains(one)))
}

/// A line without its comment and its blanks.
fn code(line: &str) -> String {
    line.split(['(', ';']).next().unwrap_or_default().to_ascii_uppercase().replace([' ', '\t'], "")
}

/// True where a line has a T with four digits.
fn place_and_offset(line: &str) -> bool {
    code(line).split('T').skip(1).any(|rest| rest.chars().take_while(char::is_ascii_digit).count() == 4)
}

/// True where a line has a T of three digits for a place and its own offset, as T101.
fn short_place_and_offset(line: &str) -> bool {
    code(line).split('T').skip(1).any(|rest| {
        let digits: Vec<u8> = rest.bytes().take_while(u8::is_ascii_digit).collect();
        matches!(digits[..], [place, b'0', offset] if place == offset)
    })
}

/// True where a line has a T with a D or a point behind its number.
fn tool_and_offset(line: &str) -> bool {
    code(line).split_once('T').is_some_and(|(_, rest)| {
        let behind = rest.trim_start_matches(|letter: char| letter.is_ascii_digit());
        behind.len() < rest.len() && behind.starts_with(['D', '.'])
    })
}

/// True where a line is written as for a Fanuc or a Haas, whose builders have M codes of those numbers too: an O number, a `%` alone, G43
/// with H, G28 or G30, a number with a decimal point at its end or its beginning.
fn of_fanuc(line: &str) -> bool {
    let code = code(line);
    let numbered = code.strip_prefix('O').is_some_and(|rest| rest.starts_with(|one: char| one.is_ascii_digit()));
    let bytes = code.as_bytes();
    let digit = |at: Option<usize>| at.and_then(|at| bytes.get(at)).is_some_and(u8::is_ascii_digit);
    let open = |at: usize| bytes[at] == b'.' && digit(at.checked_sub(1)) != digit(Some(at + 1));
    numbered
        || code == "%"
        || has(&code, "G", "43") && word(&code, 'H')
        || ["28", "30"].into_iter().any(|number| has(&code, "G", number))
        || (0..bytes.len()).any(open)
}

/// True where a line has an M code that a machine's builder gave a Fagor.
fn builders_code(line: &str) -> bool {
    code(line).split('M').skip(1).any(|rest| {
        let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
        matches!(digits.parse::<u32>(), Ok(10..=18 | 20..=29))
    })
}

#[cfg(test)]
mod tests {
    use super::{guess, guess_turning, mills, tools_headed};

    #[test]
    fn a_milling_program_is_told_from_a_lathes_with_y_and_live_tools() {
        for (head, ending, mill) in [
            ("T1 M6\nG43 H1\nG0 X1 Y2\n", "nc", true),
            ("N10 T1\nN20 M06\nN30 G0 X1 Y2\n", "ngc", true),
            ("G43 H1 Z50\nG1 Y-2 F100\n", "nc", true),
            ("%0001-A,MX--,\r\nT1 D1\r\nM6\r\nG1 X20 Y0\r\n", "nc", true),
            (";RODETE 0.1.0 - DIALECT FAGOR-8055\nG1 X20\n", "nc", true),
            ("T1 D1\nG1 X20\n", "pim", true),
            (";RODETE 0.1.0 - DIALECT FAGOR-8055-T\nM6\nG1 X20 Y1\n", "nc", false),
            ("T0101\nM6\nG0 X1 Y2\n", "nc", false),
            ("G50 S2000\nT1 M6\nG0 X1 Y2\n", "nc", false),
            ("T1 M6\nG43\nG0 X1 Z2\n", "ngc", false),
            ("G0 X1 Y2\nM2\n", "nc", false),
            ("(T1 M6 Y2)\nG0 X1 Y2 (M6)\n", "nc", false),
        ] {
            assert_eq!(mills(head.as_bytes(), ending), mill, "{head}");
        }
    }

    #[test]
    fn a_dialect_is_told_from_the_beginning_of_a_program() {
        for (head, ending, name) in [
            ("G21\nG0 X1\nM2\n", "nc", "linuxcnc"),
            ("N10 G91 M3 M11 M13\n", "nc", "fagor-8055"),
            ("N10 G91 M3 M11 M13\n", "ngc", "linuxcnc"),
            // The builders of other controls have such codes too.
            ("O1000\nG90 G54 G94\nT1 M6\nM10\nG1 Z-1 F100\nM11\n", "nc", "linuxcnc"),
            ("G90 G54 G94\nT1 M6\nM10\nG1 Z-1. F100.\nM11\n", "nc", "linuxcnc"),
            ("G90 G54\nM29 S500\nG1 Z-1 F.2\n", "nc", "linuxcnc"),
            ("%\nG90 G54\nM10\nG0 A90\n%\n", "nc", "linuxcnc"),
            ("G90 G43 H1 Z50\nM17\n", "nc", "linuxcnc"),
            ("G91 G28 Z0\nM10\n", "nc", "linuxcnc"),
            ("G90 G1 X1.5 Z-0.25\nM10\n", "nc", "fagor-8055"),
            ("%PLATE,X,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%PLATE,XM,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%PLATE, MX,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%PLATE,M,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%1001.PIM,M,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%PLATE,MX\r\nG71\r\nN40 G96 S300 M4\r\n", "nc", "fagor-8055-t"),
            ("%PLATE, A PART\nG71\n", "nc", "linuxcnc"),
            ("G71\nG0 X1\n", "pim", "fagor-8055"),
            ("G71\nG0 X1\n", "PIT", "fagor-8055-t"),
            ("G0 X1\n(CALL 1)\nM30\n(SUB 1)\n(RET)\n", "nc", "fagor-8055"),
            ("G0 X1\nN20 (RPT N1, N2) N5\nM30\n", "nc", "fagor-8055"),
            ("(P100 = 5)\nG0 X1\nM30\n", "nc", "fagor-8055"),
            ("(ORGX54=0)\nG0 X1\nM30\n", "nc", "fagor-8055"),
            ("(IF (P1 EQ 1) GOTO N10)\nG0 X1\nM30\n", "nc", "fagor-8055"),
            ("(RET)\nG96 S200\nG0 X1\nM30\n", "nc", "fagor-8055-t"),
            ("(CALL 1)\nG0 X1\nM2\n", "ngc", "linuxcnc"),
            ("(CALL THE FOREMAN)\n(P1 PLATE)\n(RETURN)\n(SUBPART 2)\n(IF IN DOUBT)\nG0 X1\nM2\n", "nc", "linuxcnc"),
            ("%0001-A,MX--,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%0001-A\r\nG71\r\n", "nc", "fagor-8070"),
            ("%00203\r\nN0 T1.1\r\nN10 M6\r\nN20 G0 G90 G43 Z10 F100 S1000 M3\r\n", "nc", "fagor-8055"),
            ("%0001-A\r\n#RTCP ON\r\nG43 Z10\r\n", "nc", "fagor-8070"),
            ("%0001-A\r\nG71 (G43)\r\nG430\r\n", "nc", "fagor-8070"),
            // A lathe's: the speed limit of an 8055, or a surface speed in a program without Y.
            (
                "%00000\r\n;A\r\nG92 S1300\r\nG0 G90 G95 G96 X200 Z200 F0.15 S130 M3 M42\r\nM30\r\n",
                "nc",
                "fagor-8055-t",
            ),
            ("%00000\r\nN0000 G92 S1300\r\nN0010 G0 G90 G95 G96 X200 Z200 F0.15 S180 M3\r\n", "nc", "fagor-8055-t"),
            ("%00000\r\nG92 S1300\r\nG0 X200 Z200\r\n", "nc", "fagor-8055-t"),
            ("%00042\r\n(A)\r\nG0 G90 G96 X32 Z0 S120 T1.1 M3 M41\r\nG1 X-0.8 F0.05\r\n", "nc", "fagor-8055-t"),
            ("%200-Y1\r\nG0 G90 G96 X32 Z0 S120\r\n", "nc", "fagor-8055-t"),
            ("%200\r\nG0 G90 G95 X32 Z0 F.1\r\nM30\r\n", "nc", "fagor-8055-t"),
            ("%200\r\nG0 G90 G95 X32 Z0 F.1\r\n", "nc", "fagor-8070"),
            ("%200\r\nG92 S1300\r\nG0 X200 Y5 Z200\r\n", "nc", "fagor-8055"),
            ("%200\r\nG92 X0 S1300\r\nG0 X200 Z200\r\n", "nc", "fagor-8070"),
            ("%200\r\nG0 G90 G96 X32 Y0 Z0 S120\r\n", "nc", "fagor-8070"),
            ("%200\r\nG0 G90 G95 X32 Y1 F.1\r\nM30\r\n", "nc", "fagor-8070"),
            ("%200\r\nG71 G90 G17\r\nM6\r\nS500 M3\r\nG95 F.1\r\nG1 Z-5\r\nM30\r\n", "nc", "fagor-8070"),
            ("%200\r\nG192 S2000\r\nG96 S120\r\nG0 X32 Z0\r\nM30\r\n", "nc", "fagor-8070"),
            ("%200\r\n#RTCP ON\r\nG96 S120\r\nG0 X32 Z0\r\nM30\r\n", "nc", "fagor-8070"),
            ("%0001-A,MX--,\r\n;RODETE 0.1.0 - DIALECTO FAGOR-8055-T\r\nG71\r\n", "nc", "fagor-8055-t"),
            ("(RODETE 0.1.0 - DIALECT FAGOR-8070)\nG71\n", "nc", "fagor-8070"),
            ("%0001-A,MX--,\r\nG71\r\nN40 G96 S300 M4\r\n", "nc", "fagor-8055-t"),
            ("%0001-A,MX--,\r\nG71\r\n;G96 S300\r\nS960\r\n", "nc", "fagor-8055"),
            ("%0001-A,MX--,\r\nG71 G95 F.2\r\nG1 X20 Z-5\r\nM30\r\n", "nc", "fagor-8055-t"),
            ("%0001-A,MX--,\r\nG71 G95 F.2\r\nG1 X20 Z-5\r\n", "nc", "fagor-8055"),
            ("%0001-Y1,MX--,\r\nG71 G95 F.2\r\nG1 X20 Y0\r\n", "nc", "fagor-8055"),
            ("%\nG21\nM30\n%\n", "nc", "linuxcnc"),
            ("O0001\nN10 G50 S2500\nN20 T0101 M41\n", "nc", "fanuc-lathe-a"),
            ("O0001\nN20 T0101\n", "ngc", "linuxcnc"),
            ("T12 M6 (T0101)\nG0 X1\n", "nc", "linuxcnc"),
            ("O00012\nG18 G20 G99\nT101\nG0 X1.8 Z.1\n", "nc", "fanuc-lathe-a"),
            ("T101\nG0 X1 Y2\nT202 M06\n", "nc", "linuxcnc"),
            ("T150\nG0 X1\n", "nc", "linuxcnc"),
            ("G50 S2500\nT1\n", "nc", "fanuc-lathe-a"),
            ("(G50 S2500)\nG500 S1\n", "nc", "linuxcnc"),
            ("G71 U2. R1.\nG71 P10 Q20 U.4 W.1 F.3\n", "nc", "fanuc-lathe-a"),
            ("G71 P10 Q20 U.4 W.1 F.3\n", "ngc", "linuxcnc"),
            ("G71 Q100 X20 Z0 D1\nG70 Q100 P2 U1\n", "nc", "linuxcnc"),
            ("O0001\nG28 U0 W0\nG0 X50. Z2.\n", "nc", "fanuc-lathe-a"),
            ("G97 S800 M3\nG92 X29. Z-20. F1.5\nX28.4\n", "nc", "fanuc-lathe-a"),
            ("G28 Z0\nG92 X0 Y0\nG92.1 F100 X1\n", "nc", "linuxcnc"),
            ("G0 U1 W2\n", "nc", "linuxcnc"),
            ("(M11)\nG0 X1\nM2\n", "nc", "linuxcnc"),
            ("G0 X1 M3 M19\nM2\n", "nc", "linuxcnc"),
        ] {
            assert_eq!(guess(head.as_bytes(), ending, false).name, name, "{head}");
        }
        // With a lathe's workbook a program turns, unless its header names another control.
        assert_eq!(guess(b"G0 X1\n", "ngc", true).name, "fanuc-lathe-a");
        assert_eq!(guess(b"T1 D1\n", "nc", true).name, "fagor-8055-t");
        assert_eq!(guess(b"(CALL 1)\n", "nc", true).name, "fagor-8055-t");
        assert_eq!(guess(b"T1 D1\n", "pim", true).name, "fagor-8055");
        assert_eq!(guess(b"(RODETE 0.1.0 - DIALECT FAGOR-8070)\n", "nc", true).name, "fagor-8070");
    }

    #[test]
    fn the_tools_of_a_header_are_those_that_rodete_named() {
        let header = ";RODETE 0.1.0 - DIALECT FAGOR-8055-T\r\n;TOOL T1 D4\r\nN10 T2 D2\r\n";
        assert_eq!(tools_headed(header.as_bytes()).into_iter().collect::<Vec<_>>(), [4]);
        let spanish = header.replace("DIALECT ", "DIALECTO ").replace("TOOL", "HERRAMIENTA");
        assert_eq!(tools_headed(spanish.as_bytes()).into_iter().collect::<Vec<_>>(), [4]);
        assert!(tools_headed(b";TOOL T1 D4\r\nN10 T1 D4\r\n").is_empty(), "of another program");
        assert!(tools_headed(b"(RODETE 0.1.0 - DIALECT FAGOR-8070)\nN10 T1 D4 (TOOL T1 D4)\n").is_empty());
    }

    #[test]
    fn a_control_that_turns_is_told_by_its_first_line_or_by_how_it_calls_tools() {
        for (head, name) in [
            ("%\nO0001\nT0101\n", "fanuc-lathe-a"),
            ("G71 U2. R0.5 (T1 D1)\nM24\n", "fanuc-lathe-a"),
            ("N10 T1 D1\n", "fagor-8055-t"),
            ("N10 T2.2 M6\n", "fagor-8055-t"),
            (";D50\n%0001-A,MX--,\nG90\n", "fagor-8055-t"),
            ("", "fanuc-lathe-a"),
        ] {
            assert_eq!(guess_turning(head.as_bytes()).name, name, "{head}");
        }
    }
}
