//! Lines that are passed over: of a clause, a loop or a subprogram that is not run.
//!
//! # References
//! LinuxCNC reads them all the same, as far as the word that ends what it passes over may stand in them: their length, comments, block numbers and
//! O-words, whose labels it computes. At one that it cannot read so it stops.

use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block_number;
use crate::gcode::interpreter::cursor::{Cursor, comments};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::library::LineStart;
use crate::gcode::interpreter::pass_fraction;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::source::Position;
use crate::gcode::interpreter::structure::{Word, label, word};
use crate::gcode::rules::flow::{LabelNotWhole, OWordUnknown, WithoutCounterpart};
use crate::gcode::rules::lexis::LineTooLong;

impl Reader<'_, '_> {
    /// Goes on with a line of the text in hand; those before it are passed over.
    ///
    /// # Errors
    /// Of a line among them that the control cannot read even so.
    pub(super) fn pass_to(&mut self, to: Position) -> Result<()> {
        self.read_passed(self.memory.flow.next, to)?;
        self.go_to(to);
        Ok(())
    }

    /// Reads the lines between two places as the control does that passes over them.
    pub(super) fn read_passed(&mut self, from: LineStart, to: Position) -> Result<()> {
        let structure = self.memory.library.structure(from.text, &self.memory.control.lexis)?;
        let unread = structure.unread_between(from.line, to).to_vec();
        let mut line = Vec::new();
        for at in unread {
            if let Some(behind) = self.memory.library.line(LineStart { line: at, ..from }, &mut line)? {
                self.pass_line(&line).map_err(|mut fault| {
                    fault.line = behind.line.lines;
                    fault.fatal()
                })?;
            }
        }
        Ok(())
    }

    fn pass_line(&mut self, line: &[u8]) -> Result<()> {
        let (form, most) = (self.memory.control.lexis.comments, self.memory.control.lexis.longest_line);
        if line.len() > most {
            return Err(Refused::of(&LineTooLong { most }, &[most]));
        }
        comments(line, form)?;
        let mut cursor = Cursor::new(line, form);
        cursor.accept_delete(false);
        if cursor.accept(b'n') {
            block_number(&mut cursor)?;
            pass_fraction(&mut cursor);
        }
        let column = cursor.column();
        if !cursor.accept(b'o') || label(&mut cursor)?.is_some() {
            return Ok(());
        }
        self.computed_label(&mut cursor, column)?;
        let place = cursor.column();
        match word(&mut cursor) {
            Some(Word::Call) => Ok(()),
            Some(_) => Err(Refused::of(&WithoutCounterpart {}, &[column])),
            None => Err(Refused::of(&OWordUnknown {}, &[place])),
        }
    }

    /// A label that is computed; the cursor stands behind the O of a column.
    pub(super) fn computed_label(&mut self, cursor: &mut Cursor<'_>, column: usize) -> Result<String> {
        let value = self.value(cursor)?.value;
        whole(value)
            .map(|label| label.to_string())
            .ok_or_else(|| Refused::of(&LabelNotWhole { label: value }, &[column]))
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::interpreter::{Interpreter, Setting};

    /// Where X goes, or the code, the line and the sentence's place of the first refusal.
    fn read(program: &str) -> Result<Vec<f64>, (&'static str, usize)> {
        let program = format!("G21 G90\n{}\nG0 X9\nM2\n", program.replace('|', "\n"));
        let read: Result<Vec<f64>, _> = Interpreter::over(program.as_bytes(), Setting::new(&LINUXCNC))
            .map(|item| item.map(|motion| motion.to.0[0]))
            .collect();
        read.map_err(|fault| (fault.rule.code, fault.line))
    }

    #[test]
    fn a_label_in_brackets_is_its_number() {
        for (program, places) in [
            ("#1=0|O7 IF [#1 EQ 1]|G0 X1|O[7] ELSE|G0 X5|O7 ENDIF", &[5.0, 9.0][..]),
            ("#1=1|O7 IF [#1 EQ 1]|G0 X1|O[7] ELSE|G0 X5|O7 ENDIF", &[1.0, 9.0]),
            ("#1=0|O[7] IF [#1 EQ 1]|G0 X1|O[ 7 ] ELSEIF [#1 EQ 0]|G0 X5|O[7] ENDIF", &[5.0, 9.0]),
            ("#1=0|O[2] REPEAT [2]|#1=[#1+1]|G0 X#1|O2 ENDREPEAT", &[1.0, 2.0, 9.0]),
            ("O[2] DO|#1=[#1+1]|G0 X#1|O[2] WHILE [#1 LT 2]", &[1.0, 2.0, 9.0]),
            ("O[2] SUB|G0 X1|O[2] ENDSUB|O[2] CALL|O[1+1] CALL", &[1.0, 1.0, 9.0]),
        ] {
            assert_eq!(read(program), Ok(places.to_vec()), "{program}");
        }
    }

    #[test]
    fn what_cannot_be_read_in_lines_passed_over_ends_the_program() {
        for (line, code) in [
            ("(probe here", "G0005"),
            ("G1 X1 (MSG unclosed", "G0005"),
            ("G1 X1 (a (b) c)", "G0006"),
            ("O", "G0304"),
            ("OO7 ELSE", "G0304"),
            ("OENDIF", "G0304"),
            ("O<a", "G0001"),
            ("O[1+6] ELSE", "G0311"),
            ("O#2 ELSE", "G0311"),
            ("O[1.5] CALL", "G0312"),
            ("O[1+6] JUMP", "G0313"),
            ("NX5", "G0342"),
            (&"X".repeat(252), "G0019"),
        ] {
            for (program, at) in [
                (format!("O7 IF [0]|G0 X1|{line}|O7 ENDIF"), 4),
                (format!("O7 IF [1]|G0 X1|O7 ELSE|{line}|O7 ENDIF"), 5),
                (format!("O7 WHILE [0]|{line}|O7 ENDWHILE"), 3),
                (format!("O7 REPEAT [0]|{line}|O7 ENDREPEAT"), 3),
                (format!("O7 WHILE [1]|O7 BREAK|{line}|O7 ENDWHILE"), 4),
                (format!("O5 SUB|{line}|O5 ENDSUB"), 3),
                (format!("O5 CALL|M2|{line}|O5 SUB|O5 ENDSUB"), 4),
                (format!("M98 P5|M2|{line}|O5|M99"), 4),
            ] {
                assert_eq!(read(&program), Err((code, at)), "{program}");
            }
        }
        // A call by a computed label is passed over, and so are words, whatever they are.
        for line in ["O#2 CALL", "O[1+6] CALL", "G1 X--", "X[1", "/G1 X1 (a)", "N5 G0 X"] {
            assert_eq!(read(&format!("O7 IF [0]|{line}|O7 ENDIF")), Ok(vec![9.0]), "{line}");
        }
        // In a SUB a name that nothing has set is 0; elsewhere it ends the program.
        assert_eq!(read("O5 SUB|#<s>=9|O#<s> CALL|O5 ENDSUB"), Ok(vec![9.0]));
        assert_eq!(read("O7 IF [0]|O#<s> CALL|O7 ENDIF"), Err(("G0212", 3)));
        // Behind the end of the program nothing is read, nor is what a call goes back over.
        assert_eq!(read("G0 X1|M2|(open"), Ok(vec![1.0]));
        assert_eq!(read("O5 SUB|G0 X1|O5 ENDSUB|O5 CALL|G0 X2|O5 CALL|M2|OO"), Ok(vec![1.0, 2.0, 1.0]));
        assert_eq!(read("M98 P5 (x|M2|O5|M99"), Err(("G0005", 2)));
        assert_eq!(read("M98 P5|M2|O5(x|M99"), Err(("G0005", 4)));
    }
}
