//! The lines of a program, one at a time, with the way back that loops and subprograms need.

use std::borrow::Cow;
use std::io::{self, BufRead, Seek, SeekFrom};

use crate::finding::answer::answer;
use crate::gcode::control::LoneReturn;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::rules::lexis::{LineEndless, LoneReturnRejected, ProgramTooLarge, Unreadable};
use crate::limits::{LINE_BYTES, PROGRAM_BYTES};

/// Bytes that can be read again from an earlier place.
pub trait Bytes: BufRead + Seek {}

impl<T: BufRead + Seek> Bytes for T {}

/// Where a line begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Position {
    /// Bytes before it.
    pub(super) offset: u64,
    /// Lines before it.
    pub(super) lines: usize,
    /// The line before it ended with a carriage return: a line feed right there belongs to that end.
    after_return: bool,
}

impl Position {
    /// The beginning of a text.
    pub(super) const START: Self = Self { offset: 0, lines: 0, after_return: false };
}

/// A program's text. Where it is read is the reader's to say: a line is asked for by its place.
pub(super) struct SourceText<'a> {
    bytes: Box<dyn Bytes + 'a>,
    /// Where the bytes stand.
    at: Position,
    /// The last line in the text that has been read.
    furthest: usize,
    /// The name of a subprogram's own file.
    pub(super) file: Option<String>,
    lone_return: LoneReturn,
}

impl<'a> SourceText<'a> {
    pub(super) fn new(bytes: Box<dyn Bytes + 'a>, file: Option<String>, lone_return: LoneReturn) -> Self {
        Self { bytes, at: Position::START, furthest: 0, file, lone_return }
    }

    /// True where a line is read for the first time.
    pub(super) const fn first_time(&mut self, line: usize) -> bool {
        let first = line > self.furthest;
        if first {
            self.furthest = line;
        }
        first
    }

    /// The last line that has been read for the first time.
    pub(super) const fn furthest(&self) -> usize {
        self.furthest
    }

    /// Reads the line at a place into `line`, without its end; gives where the next one begins, `None` where there is none.
    /// Lines end with a line feed, a carriage return, or both; a control may not take the return alone.
    pub(super) fn line(&mut self, at: Position, line: &mut Vec<u8>) -> Result<Option<Position>> {
        line.clear();
        if self.at != at {
            self.bytes.seek(SeekFrom::Start(at.offset)).map_err(|error| unreadable(&error))?;
            self.at = at;
        }
        loop {
            let buffer = self.bytes.fill_buf().map_err(|error| unreadable(&error))?;
            if self.at.after_return && buffer.first() == Some(&b'\n') {
                self.at.after_return = false;
                self.bytes.consume(1);
                self.at.offset += 1;
                continue;
            }
            if buffer.is_empty() {
                if line.is_empty() {
                    return Ok(None);
                }
                self.at.lines += 1;
                return Ok(Some(self.at));
            }
            self.at.after_return = false;
            let end = memchr::memchr2(b'\n', b'\r', buffer);
            let taken = end.unwrap_or(buffer.len());
            if line.len() + taken > LINE_BYTES {
                return Err(too_long_a_line());
            }
            line.extend_from_slice(&buffer[..taken]);
            let used = taken + usize::from(end.is_some());
            self.at.after_return = end.is_some_and(|end| buffer[end] == b'\r');
            self.bytes.consume(used);
            self.at.offset += used as u64;
            if self.at.offset > PROGRAM_BYTES {
                return Err(too_large());
            }
            if end.is_some() {
                self.at.lines += 1;
                self.see_return(line.len())?;
                return Ok(Some(self.at));
            }
        }
    }
}

impl SourceText<'_> {
    /// Refuses a carriage return, at a column of the line that it has just ended, that no line feed follows, where the control takes
    /// it for a blank: what stands behind it would be read as another block than the control's, or as no comment.
    fn see_return(&mut self, column: usize) -> Result<()> {
        if !self.at.after_return || !self.lone_return.rejected() {
            return Ok(());
        }
        let next = self.bytes.fill_buf().map_err(|error| unreadable(&error))?;
        if next.first() == Some(&b'\n') {
            return Ok(());
        }
        self.first_time(self.at.lines);
        let mut fault = Refused::of(&LoneReturnRejected {}, &[column]).fatal();
        (fault.line, fault.file) = (self.at.lines, self.file.clone());
        Err(fault)
    }
}

/// True where a file begins as a text in UTF-16 does.
#[must_use]
pub fn wide(head: &[u8]) -> bool {
    head.starts_with(b"\xFF\xFE") || head.starts_with(b"\xFE\xFF")
}

/// A program's text: UTF-8, or where it is none, Latin-1, in which older editors write comments.
#[must_use]
pub fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    str::from_utf8(bytes).map_or_else(|_| bytes.iter().copied().map(char::from).collect(), Cow::Borrowed)
}

/// A program's text with a line feed at each end of line, as the interpreter counts lines: behind a return, a line feed, or
/// both.
#[must_use]
pub fn line_feeds(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n")
}

fn unreadable(error: &io::Error) -> Box<Refused> {
    let mut fault = Refused::of(&Unreadable { reason: answer(error) }, &[]).fatal();
    fault.exit = crate::finding::Exit::Unreadable;
    fault
}

fn too_long_a_line() -> Box<Refused> {
    Refused::ended(&LineEndless { most: LINE_BYTES })
}

fn too_large() -> Box<Refused> {
    Refused::ended(&ProgramTooLarge { most: PROGRAM_BYTES / 1_000_000 })
}
