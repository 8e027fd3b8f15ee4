//! Standard output and standard error: colour, width, and a quiet end when nobody reads any more.

#![expect(clippy::disallowed_methods, reason = "the door to the terminal")]

use std::io::{self, ErrorKind, IsTerminal, Write};

use anstream::AutoStream;
use terminal_size::terminal_size_of;

use crate::text::Language;

/// Widest text: longer lines are hard to read.
const WIDEST: usize = 110;
/// Narrowest text that lines are broken for.
const NARROWEST: usize = 24;

/// The two streams of a command.
#[derive(Debug)]
pub(super) struct Terminal {
    out: AutoStream<io::Stdout>,
    err: AutoStream<io::Stderr>,
    /// The name of the running binary.
    pub(super) program: String,
    /// Columns for text; `None` where standard output is no terminal: lines are not broken.
    pub(super) width: Option<usize>,
    /// The first code of what needs attention that was printed, and the language that it was reported in.
    pub(super) told: Option<(&'static str, Language)>,
    /// What to do next, of one workbook.
    next: Option<String>,
    closed: bool,
    fault: Option<io::Error>,
}

impl Terminal {
    /// The process's streams for a binary of this name, with colour only where they are terminals and `NO_COLOR` is not set.
    pub(super) fn new(program: String) -> Self {
        let width = if io::stdout().is_terminal() {
            terminal_size_of(io::stdout()).map(|(columns, _)| usize::from(columns.0).clamp(NARROWEST, WIDEST))
        } else {
            None
        };
        Self {
            out: AutoStream::auto(io::stdout()),
            err: AutoStream::auto(io::stderr()),
            program,
            width,
            told: None,
            next: None,
            closed: false,
            fault: None,
        }
    }

    /// Prints to standard output. When its reader has gone, nothing more is printed and nothing is said.
    pub(super) fn out(&mut self, text: &str) {
        if self.closed || text.is_empty() {
            return;
        }
        if let Err(error) = self.out.write_all(text.as_bytes()).and_then(|()| self.out.flush()) {
            self.closed = true;
            if error.kind() != ErrorKind::BrokenPipe {
                self.fault = Some(error);
            }
        }
    }

    /// True where standard error is a terminal: a line there may be written over.
    pub(super) fn overwrites(&self) -> bool {
        io::stderr().is_terminal()
    }

    /// Keeps what to do next for the end; of several workbooks nothing is said.
    pub(super) fn next(&mut self, text: impl FnOnce() -> String) {
        self.next = Some(if self.next.is_some() { String::new() } else { text() });
    }

    /// Prints as the last line what to do next, where that is known: with the results, or with what needs attention.
    pub(super) fn end(&mut self, done: bool) {
        let text = self.next.take().unwrap_or_default();
        if done { self.out(&text) } else { self.err(&text) }
    }

    /// Prints to standard error, as far as it can be written to.
    pub(super) fn err(&mut self, text: &str) {
        let _ = self.err.write_all(text.as_bytes()).and_then(|()| self.err.flush());
    }

    /// Why standard output could not be written, if not because its reader has gone.
    pub(super) fn fault(&mut self) -> Option<io::Error> {
        self.fault.take()
    }
}
