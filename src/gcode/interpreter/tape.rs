//! Where the text of a file ends for a control: at the second `%`. What stands behind it is neither run nor looked through.

use crate::gcode::control::{Comments, Lexis, Percent};
use crate::gcode::interpreter::block_number;
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::refused::Result;
use crate::gcode::interpreter::source::{Position, SourceText};

/// The lines of a file as they come by.
#[derive(Debug)]
struct Tape {
    comments: Comments,
    percent: Percent,
    /// A line of the program has come by.
    begun: bool,
    /// The first `%` has come by.
    opened: bool,
}

/// True where a line holds a code, as no text before the first `%` may.
pub(super) fn has_code(line: &[u8]) -> bool {
    let code = |two: &[u8]| b"GMOTN".contains(&two[0].to_ascii_uppercase()) && two[1].is_ascii_digit();
    line.windows(2).any(code)
}

/// True for a line of an O number and nothing but a comment behind it.
pub(super) fn numbers_program(line: &[u8], comments: Comments) -> bool {
    let mut cursor = Cursor::new(line, comments);
    cursor.accept(b'o') && block_number(&mut cursor).is_ok() && cursor.peek() == 0
}

/// True for a line of a `%` alone, or with a title in letters and no code behind it: a Fanuc passes over what stands there up to the
/// end of the block (B-62694EN/03, page 88). A number or a comma behind it is another control's first line.
pub(super) fn titled(line: &[u8]) -> bool {
    let title = line.trim_ascii().strip_prefix(b"%").map(<[u8]>::trim_ascii);
    title.is_some_and(|title| {
        title.first().is_none_or(u8::is_ascii_alphabetic) && !title.contains(&b',') && !has_code(title)
    })
}

/// Goes over the lines of a file up to the second `%`: each with where it begins and where the next one does, before its first
/// character.
///
/// # Errors
/// Where the file cannot be read, and the first that `each` gives.
pub(super) fn lines(
    source: &mut SourceText<'_>,
    lexis: &Lexis,
    mut each: impl FnMut(Position, Position, Cursor<'_>) -> Result<()>,
) -> Result<()> {
    let mut tape = Tape::new(lexis);
    let mut line = Vec::new();
    let mut at = Position::START;
    while let Some(behind) = source.line(at, &mut line)?
        && !tape.ends(&line)
    {
        each(at, behind, Cursor::new(&line, lexis.comments))?;
        at = behind;
    }
    Ok(())
}

impl Tape {
    /// The beginning of a file.
    const fn new(lexis: &Lexis) -> Self {
        Self { comments: lexis.comments, percent: lexis.percent, begun: false, opened: false }
    }

    /// True where the text ends with this line.
    #[deny(clippy::wildcard_enum_match_arm)]
    fn ends(&mut self, line: &[u8]) -> bool {
        let line = line.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(line);
        let mut cursor = Cursor::new(line, self.comments);
        let percent =
            if self.percent.bare() { line.trim_ascii() == b"%" } else { cursor.accept(b'%') && cursor.peek() == 0 };
        let percent = percent || self.percent.leader() && titled(line);
        let begun = match self.percent {
            Percent::Named => return false,
            // A `%` that none has opened is refused where it is executed.
            Percent::Pair if percent && self.begun && !self.opened => return false,
            Percent::Pair => !line.trim_ascii().is_empty(),
            // The number of a program before the first `%` is passed over like a text.
            Percent::Leader => has_code(line) && !numbers_program(line, self.comments),
        };
        if percent && (self.begun || self.opened) {
            return true;
        }
        if percent {
            self.opened = true;
        } else {
            self.begun |= begun;
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::{Control, FANUC_LATHE_A, LINUXCNC};
    use crate::gcode::interpreter::{Interpreter, Setting};

    /// How many motions a program makes, or its first error.
    fn motions(program: &str, control: &'static Control) -> Result<usize, String> {
        let found: Result<Vec<_>, _> = Interpreter::over(program.as_bytes(), Setting::new(control)).collect();
        found.map(|motions| motions.len()).map_err(|fault| fault.what.en.into_owned())
    }

    #[test]
    fn behind_the_second_percent_nothing_is_looked_for() {
        let behind = "o100 sub\nG0 X5\no100 endsub\n";
        assert_eq!(motions(&format!("%\no100 call\nG0 X1\nM2\n{behind}%\n"), &LINUXCNC), Ok(2));
        let missed = motions(&format!("%\no100 call\nG0 X1\n%\n{behind}"), &LINUXCNC);
        assert_eq!(missed, Err("there is no subprogram O100".to_owned()));
        // Nor does what does not belong together there spoil the program.
        assert_eq!(motions(&format!("\n%\n{behind}o100 call\n%\no100 sub\no200 if [1]\n"), &LINUXCNC), Ok(1));
        assert_eq!(motions(&format!(" %\n{behind}o100 call\n%\no100 endif\n"), &LINUXCNC), Ok(1));

        let behind = "O1000\nG0 X5.\nM99\n";
        assert_eq!(motions(&format!("%\nO0001\nM98 P1000\nM30\n{behind}%\n"), &FANUC_LATHE_A), Ok(1));
        assert_eq!(motions(&format!("FROM THE CAM\n%\nO0001\nM98 P1000\nM30\n{behind}%\n"), &FANUC_LATHE_A), Ok(1));
        for head in ["", "%\n", "FROM THE CAM\n%\n"] {
            let missed = motions(&format!("{head}O0001\nM98 P1000\nM30\n%\n{behind}"), &FANUC_LATHE_A);
            assert_eq!(missed, Err("PS0078: there is no subprogram O1000".to_owned()), "{head}");
        }
        // A program's number before the first `%` is passed over with what else stands there.
        let program = "O0001\nM98 P1000\nM30\n";
        for head in ["O0090 (CONE)\n%\n", "O0090\n\n%\n\n", "CONE\nO0090\n%\n"] {
            assert_eq!(motions(&format!("{head}{program}{behind}%\n"), &FANUC_LATHE_A), Ok(1), "{head}");
        }
        assert_eq!(motions("O0090 (CONE)\n%\nG21 G98\nG0 X10. Z1.\nM30\n%\n", &FANUC_LATHE_A), Ok(1));
        // Where nothing stands behind that `%`, it is the end.
        assert_eq!(motions("O0090\n%\n%\n", &FANUC_LATHE_A), Ok(0));
        assert_eq!(motions("O0090\nG0 X10. Z1.\n%\n", &FANUC_LATHE_A), Ok(1));
        let once = format!("%\nO0001\nM98 P1000\nM30\n{behind}%\n{behind}");
        assert_eq!(motions(&once, &FANUC_LATHE_A), Ok(1), "one of the two is not read");
    }
}
