//! The texts that a program is read from: its own, and those of subprograms in files of their own, with what has been sought
//! in each.

use crate::gcode::control::{Lexis, LoneReturn};
use crate::gcode::interpreter::numbers::Numbers;
use crate::gcode::interpreter::refused::Result;
use crate::gcode::interpreter::source::{Bytes, Position, SourceText};
use crate::gcode::interpreter::structure::Structure;

/// Where a line begins, in one of the texts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Mark {
    /// The text, 0 for the program's own.
    pub(super) text: usize,
    /// The line in it.
    pub(super) line: Position,
}

/// The place of a block: its text, 0 for the program's own, its line, counted from 1, and its number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Spot {
    pub(super) text: usize,
    pub(super) line: usize,
    pub(super) n: Option<u32>,
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

/// The texts.
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
    pub(super) fn line(&mut self, at: Mark, line: &mut Vec<u8>) -> Result<Option<Mark>> {
        Ok(self.text(at.text).line(at.line, line)?.map(|behind| Mark { line: behind, ..at }))
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
