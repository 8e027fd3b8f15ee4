//! Reading a program's own text back, line by line as it is made: nothing of it is kept.

use std::io::{self, BufRead, Read, Seek, SeekFrom};

use crate::gcode::interpreter::{Interpreter, RotaryMode, Setting};
use crate::gcode::lines::Lines;
use crate::gcode::program::Program;

/// The bytes of a program's text. Read again, they are made again from the first line on: rodete writes no loops and no subprograms, and
/// a control that looks for the first `%` of a text goes back to its beginning once.
struct ProgramBytes<'a> {
    program: &'a Program,
    lines: Lines<'a>,
    line: String,
    at: usize,
}

impl<'a> ProgramBytes<'a> {
    fn new(program: &'a Program) -> Self {
        Self { program, lines: program.lines(), line: String::new(), at: 0 }
    }
}

impl BufRead for ProgramBytes<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.at == self.line.len() {
            self.at = 0;
            self.lines.next_whole(&mut self.line);
        }
        Ok(self.line.as_bytes().get(self.at..).unwrap_or_default())
    }

    fn consume(&mut self, amount: usize) {
        self.at = (self.at + amount).min(self.line.len());
    }
}

impl Read for ProgramBytes<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(out)?;
        self.consume(count);
        Ok(count)
    }
}

impl Seek for ProgramBytes<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let SeekFrom::Start(to) = to else { return Err(io::Error::from(io::ErrorKind::Unsupported)) };
        *self = Self::new(self.program);
        let mut before = 0;
        while before < to {
            let left = usize::try_from(to - before).unwrap_or(usize::MAX);
            let passed = self.fill_buf()?.len().min(left);
            if passed == 0 {
                break;
            }
            self.consume(passed);
            before += passed as u64;
        }
        Ok(before)
    }
}

impl Program {
    /// What this program's text is read back with: millimetres, all offsets 0, no tool table. Positions count on beyond a
    /// turn, so that what is absolute in them holds where rotary axes are [`RotaryMode::Linear`]; increments hold everywhere.
    #[must_use]
    pub fn setting(&self) -> Setting {
        Setting { rotary: RotaryMode::Linear, ..Setting::new(self.control) }
    }

    /// The interpreter over this program's text, as the control reads it: from the text, not from the positions that it was
    /// made of.
    #[must_use]
    pub fn read_back(&self) -> Interpreter<'_> {
        self.read_back_with(self.setting())
    }

    /// The same with another setting.
    #[must_use]
    pub fn read_back_with(&self, setting: Setting) -> Interpreter<'_> {
        Interpreter::new(Box::new(ProgramBytes::new(self)), setting)
    }
}

#[cfg(test)]
mod tests {
    use std::io::{Read, Seek, SeekFrom};

    use super::ProgramBytes;
    use crate::gcode::program::{Part, Program};

    #[test]
    fn the_text_of_a_program_is_read_again_from_any_place() {
        let parts = ["%", "O0007", "G0 X1.000", "%"].map(|line| Part::Line(line.to_owned())).to_vec();
        let program = Program { parts, ..Program::sample("a") };
        let text = program.text();
        let mut bytes = ProgramBytes::new(&program);
        for from in [0, 1, 2, 9, 0, text.len() - 1, text.len(), 3] {
            assert_eq!(bytes.seek(SeekFrom::Start(from as u64)).unwrap(), from as u64);
            let mut read = String::new();
            bytes.read_to_string(&mut read).unwrap();
            assert_eq!(read, text[from..]);
        }
        assert_eq!(bytes.seek(SeekFrom::Start(1000)).unwrap(), text.len() as u64);
        assert!(bytes.seek(SeekFrom::End(0)).is_err());
    }
}
