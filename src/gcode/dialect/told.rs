//! Which dialect a program is in, where nobody says so.

use crate::gcode::dialect::{Dialect, FAGOR_8055, FAGOR_8070, LINUXCNC};

/// The dialect that the beginning of a program and its file's ending (without the dot) tell.
///
/// `.ngc` is LinuxCNC. A first line `%name,MX--,` is a Fagor 8055, `%number-name` a Fagor 8070. An M code from M10 to M18
/// or M20 to M29, which LinuxCNC does not have and a machine's builder gives a Fagor (clamps of rotary axes), is a Fagor
/// 8055. Everything else is LinuxCNC.
#[must_use]
pub fn told(head: &[u8], ending: &str) -> &'static Dialect {
    if ending.eq_ignore_ascii_case("ngc") {
        return &LINUXCNC;
    }
    let text = String::from_utf8_lossy(head);
    let first = text.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or_default();
    if let Some(name) = first.strip_prefix('%') {
        if name.contains(",MX") {
            return &FAGOR_8055;
        }
        if name.starts_with(|letter: char| letter.is_ascii_digit()) {
            return &FAGOR_8070;
        }
    }
    if text.lines().any(builders_code) { &FAGOR_8055 } else { &LINUXCNC }
}

/// True where a line has an M code that a machine's builder gave a Fagor.
fn builders_code(line: &str) -> bool {
    let code = line.split(['(', ';']).next().unwrap_or_default().to_ascii_uppercase();
    code.split('M').skip(1).any(|rest| {
        let digits: String = rest.trim_start().chars().take_while(char::is_ascii_digit).collect();
        matches!(digits.parse::<u32>(), Ok(10..=18 | 20..=29))
    })
}

#[cfg(test)]
mod tests {
    use super::told;

    #[test]
    fn a_dialect_is_told_from_the_beginning_of_a_program() {
        for (head, ending, name) in [
            ("G21\nG0 X1\nM2\n", "nc", "linuxcnc"),
            ("N10 G91 M3 M11 M13\n", "nc", "fagor-8055"),
            ("N10 G91 M3 M11 M13\n", "ngc", "linuxcnc"),
            ("%0001-A,MX--,\r\nG71\r\n", "nc", "fagor-8055"),
            ("%0001-A\r\nG71\r\n", "nc", "fagor-8070"),
            ("%\nG21\nM30\n%\n", "nc", "linuxcnc"),
            ("(M11)\nG0 X1\nM2\n", "nc", "linuxcnc"),
            ("G0 X1 M3 M19\nM2\n", "nc", "linuxcnc"),
        ] {
            assert_eq!(told(head.as_bytes(), ending).name, name, "{head}");
        }
    }
}
