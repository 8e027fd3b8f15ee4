//! The texts that a program is read from: its own, and those of subprograms in files of their own, with what has been sought
//! in each.

use crate::gcode::control::{Lexis, LoneReturn};
use crate::gcode::interpreter::numbers::Numbers;
use crate::gcode::interpreter::refused::Result;
use crate::gcode::interpreter::source::{Bytes, Position, SourceText};
use crate::gcode::interpreter::structure::Structure;

/// Where a line begins, in one of the texts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct LineStart {
    /// The text, 0 for the program's own.
    pub(super) text: usize,
    /// Where the line begins in that text.
    pub(super) line: Position,
}

/// The place of a block: its text, 0 for the program's own, its line, counted from 1, and its number; and who reads it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Spot {
    pub(super) text: usize,
    pub(super) line: usize,
    pub(super) n: Option<u32>,
    /// It is read as a block of a contour that a cycle before this one has read: what is remarked of it has been counted.
    pub(super) again: bool,
}

/// A text with its indices, each made when it is first asked for.
struct Indexed<'a> {
    source: SourceText<'a>,
    structure: Option<Structure>,
    numbers: Option<Numbers>,
}

impl<'a> Indexed<'a> {
    const fn new(source: SourceText<'a>) -> Self {
        Self { source, structure: None, numbers: None }
    }
}

pub(super) struct Library<'a> {
    texts: Vec<Indexed<'a>>,
    lone_return: LoneReturn,
}

impl<'a> Library<'a> {
    /// The program's own text.
    pub(super) fn new(bytes: Box<dyn Bytes + 'a>, lone_return: LoneReturn) -> Self {
        Self { texts: vec![Indexed::new(SourceText::new(bytes, None, lone_return))], lone_return }
    }

    /// A text. There is always the program's own, and no number is handed out for one that is not there.
    pub(super) fn text(&mut self, text: usize) -> &mut SourceText<'a> {
        let last = self.texts.len() - 1;
        &mut self.texts[text.min(last)].source
    }

    /// How many lines the texts have as far as they have been read.
    pub(super) fn lines(&self) -> usize {
        self.texts.iter().map(|text| text.source.furthest()).sum()
    }

    /// The name of a text that is a subprogram's own file.
    pub(super) fn file(&self, text: usize) -> Option<&String> {
        self.texts.get(text)?.source.file.as_ref()
    }

    /// The text of the first file whose name fits.
    pub(super) fn find(&self, fits: impl Fn(&str) -> bool) -> Option<usize> {
        self.texts.iter().position(|text| text.source.file.as_deref().is_some_and(&fits))
    }

    /// Takes in the file of a subprogram; returns the number of its text.
    pub(super) fn add(&mut self, bytes: Vec<u8>, name: String) -> usize {
        let bytes = Box::new(std::io::Cursor::new(bytes));
        self.texts.push(Indexed::new(SourceText::new(bytes, Some(name), self.lone_return)));
        self.texts.len() - 1
    }

    /// Reads the line at a mark into `line`, without its end; gives the mark behind it, `None` where there is none.
    pub(super) fn line(&mut self, at: LineStart, line: &mut Vec<u8>) -> Result<Option<LineStart>> {
        Ok(self.text(at.text).line(at.line, line)?.map(|behind| LineStart { line: behind, ..at }))
    }

    /// The O-words of a text.
    pub(super) fn structure(&mut self, text: usize, lexis: &Lexis) -> Result<&Structure> {
        let Indexed { source, structure, .. } = &mut self.texts[text];
        match structure {
            Some(known) => Ok(known),
            unknown => Ok(unknown.insert(Structure::of(source, lexis)?)),
        }
    }

    /// The O-words of the program's own text, where any has been met.
    pub(super) fn known_structure(&self) -> Option<&Structure> {
        self.texts.first()?.structure.as_ref()
    }

    /// The block numbers and program numbers of a text.
    pub(super) fn numbers(&mut self, text: usize, lexis: &Lexis) -> Result<&Numbers> {
        let Indexed { source, numbers, .. } = &mut self.texts[text];
        match numbers {
            Some(known) => Ok(known),
            unknown => Ok(unknown.insert(Numbers::of(source, lexis)?)),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::interpreter::{Files, Interpreter, Setting};
    use crate::text::Text;

    /// A folder with `50.ngc`, which holds the program O50.
    struct Beside;

    impl Files for Beside {
        fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
            Ok((name == "50").then(|| b"O50\nG0 X5\nM99\n".to_vec()))
        }
    }

    #[test]
    fn lines_count_up_to_the_last_one_that_was_read_however_often_it_was() {
        let passed = "G21 G90\no100 sub\nG1 X1 F100\no100 endsub\no100 call\no100 call\nM2\n\n";
        let called = "G21 G90\nM98 P2 L3\nM30\nO2\nG0 Y1\nM99\nG0 Y9\n";
        let own_file = "G21 G90\nM98 P50 L2\nM2\n";
        for (program, lines) in [(passed, 7), (called, 6), ("G21 G90\nM2\nG0 X1\n", 2), (own_file, 3 + 3)] {
            let mut setting = Setting::new(&LINUXCNC);
            setting.files = Box::new(Beside);
            let mut interpreter = Interpreter::over(program.as_bytes(), setting);
            assert!(interpreter.by_ref().all(|motion| motion.is_ok()), "{program}");
            assert_eq!(interpreter.lines(), lines, "{program}");
        }
    }
}
