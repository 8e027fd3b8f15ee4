//! Which control a program is in, where nobody says so.

use std::collections::BTreeSet;

use crate::gcode::control::{Control, FAGOR_8055, FAGOR_8055_T, FAGOR_8070, FANUC_LATHE_A, LINUXCNC};

/// The control that the beginning of a program and its file's ending (without the dot) tell.
///
/// The header of a program that rodete wrote names it. `.ngc` is LinuxCNC. A first line `%name,MX--,` is a Fagor 8055, or 8055 T
/// where a block has G96 with S; `%number-name` is a Fagor 8070. An M code from M10 to M18
/// or M20 to M29, which LinuxCNC does not have and a machine's builder gives a Fagor (clamps of rotary axes), is a Fagor
/// 8055. A T of four digits, place and offset as in `T0101`, is a Fanuc lathe of system A. Everything else is LinuxCNC.
#[must_use]
pub fn guess(head: &[u8], ending: &str) -> &'static Control {
    let text = String::from_utf8_lossy(head);
    if let Some(dialect) = text.lines().find_map(headed) {
        return dialect;
    }
    if ending.eq_ignore_ascii_case("ngc") {
        return &LINUXCNC;
    }
    let first = text.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or_default();
    if let Some(name) = first.strip_prefix('%') {
        if name.contains(",MX") {
            return if text.lines().any(surface_speed) { &FAGOR_8055_T } else { &FAGOR_8055 };
        }
        if name.starts_with(|letter: char| letter.is_ascii_digit()) {
            return &FAGOR_8070;
        }
    }
    if text.lines().any(place_and_offset) {
        return &FANUC_LATHE_A;
    }
    if text.lines().any(builders_code) { &FAGOR_8055 } else { &LINUXCNC }
}

/// The same of a turning program. A first line `%name,MX--,`, or a tool with its offset as `T1 D1` or `T1.1`, is a Fagor
/// 8055 T; everything else is a Fanuc of system A, whose T carries both numbers.
#[must_use]
pub fn guess_turning(head: &[u8]) -> &'static Control {
    let text = String::from_utf8_lossy(head);
    let named = text.lines().any(|line| line.trim_start().starts_with('%') && line.contains(",MX"));
    if named || text.lines().any(tool_and_offset) { &FAGOR_8055_T } else { &FANUC_LATHE_A }
}

/// The dialect that a header of rodete's names, as `;RODETE 0.1.0 - DIALECT FAGOR-8055-T`.
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

/// True where a line has G96 and S: constant surface speed, which no milling program has.
fn surface_speed(line: &str) -> bool {
    let code = code(line);
    let g96 = code.split("G96").nth(1).is_some_and(|rest| !rest.starts_with(|one: char| one.is_ascii_digit()));
    g96 && code.split('S').skip(1).any(|rest| rest.starts_with(|one: char| one.is_ascii_digit()))
}

/// A line without its comment and its blanks.
fn code(line: &str) -> String {
    line.split(['(', ';']).next().unwrap_or_default().to_ascii_uppercase().replace([' ', '\t'], "")
}

/// True where a line has a T with four digits.
fn place_and_offset(line: &str) -> bool {
    code(line).split('T').skip(1).any(|rest| rest.chars().take_while(char::is_ascii_digit).count() == 4)
}

/// True where a line has a T with a D or a point behind its number.
fn tool_and_offset(line: &str) -> bool {
    code(line).split_once('T').is_some_and(|(_, rest)| {
        let behind = rest.trim_start_matches(|letter: char| letter.is_ascii_digit());
        behind.len() < rest.len() && behind.starts_with(['D', '.'])
    })
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
    use super::{guess, guess_turning, tools_headed};

    #[test]
    fn a_dialect_is_told_from_the_beginning_of_a_program() {
        for (head, ending, name) in [
            ("G21\nG0 X1\nM2\n", "nc", "linuxcnc"),
            ("N10 G91 M3 M11 M13\n", "nc", "fagor-8055"),
            ("N10 G91 M3 M11 M13\n", "ngc", "linuxcnc"),
            ("%0001-A,MX--,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%0001-A\r\nG71\r\n", "nc", "fagor-8070"),
            ("%0001-A,MX--,\r\n;RODETE 0.1.0 - DIALECTO FAGOR-8055-T\r\nG71\r\n", "nc", "fagor-8055-t"),
            ("(RODETE 0.1.0 - DIALECT FAGOR-8070)\nG71\n", "nc", "fagor-8070"),
            ("%0001-A,MX--,\r\nG71\r\nN40 G96 S300 M4\r\n", "nc", "fagor-8055-t"),
            ("%0001-A,MX--,\r\nG71\r\n;G96 S300\r\nS960\r\n", "nc", "fagor-8055"),
            ("%\nG21\nM30\n%\n", "nc", "linuxcnc"),
            ("O0001\nN10 G50 S2500\nN20 T0101 M41\n", "nc", "fanuc-lathe-a"),
            ("O0001\nN20 T0101\n", "ngc", "linuxcnc"),
            ("T12 M6 (T0101)\nG0 X1\n", "nc", "linuxcnc"),
            ("(M11)\nG0 X1\nM2\n", "nc", "linuxcnc"),
            ("G0 X1 M3 M19\nM2\n", "nc", "linuxcnc"),
        ] {
            assert_eq!(guess(head.as_bytes(), ending).name, name, "{head}");
        }
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
