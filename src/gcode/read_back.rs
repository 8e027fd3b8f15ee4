//! Reading a program's own text back, line by line as it is made: nothing of it is kept.

use std::io::{self, BufRead, Read, Seek, SeekFrom};

use crate::gcode::interpreter::{Interpreter, RotaryMode, Setting};
use crate::gcode::lines::Lines;
use crate::gcode::program::Program;

/// The bytes of a program's text. They cannot be read a second time: rodete writes no loops and no subprograms.
struct ProgramBytes<'a> {
    lines: Lines<'a>,
    line: String,
    at: usize,
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
    fn seek(&mut self, _to: SeekFrom) -> io::Result<u64> {
        Err(io::Error::from(io::ErrorKind::Unsupported))
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
        let text = ProgramBytes { lines: self.lines(), line: String::new(), at: 0 };
        Interpreter::new(Box::new(text), setting)
    }
}
