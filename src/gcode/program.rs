//! A program: blocks of words in a dialect.

use std::io;

use crate::text::Text;

/// What a program amounts to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Numbered blocks.
    pub blocks: u64,
    /// Bytes of the text.
    pub bytes: u64,
    /// Least and greatest position of each axis that moves, by letter; mm or degrees.
    pub extents: Vec<(char, f64, f64)>,
    /// Length of the path of the linear axes in mm.
    pub path: f64,
    /// Estimated time in seconds; `None` where the program carries no feed.
    pub seconds: Option<f64>,
}

/// A program.
#[derive(Debug)]
pub struct Program {
    /// Its name in files and findings: `blade`, `splitter`, `impeller`, `blank`.
    pub key: &'static str,
    /// What it does.
    pub title: Text,
}

impl Program {
    /// Calls `line` for each line of the program in order, with its block number and its text without number and end
    /// of line. The text is borrowed: nothing is kept.
    ///
    /// # Errors
    /// Passes on the error of `line`.
    pub fn for_each(&self, line: &mut dyn FnMut(Option<u32>, &str) -> io::Result<()>) -> io::Result<()> {
        let _ = line;
        Ok(())
    }

    /// Writes the program's text as the control reads it.
    ///
    /// # Errors
    /// Passes on the error of `out`.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let _ = out;
        Ok(())
    }

    /// What the program amounts to.
    #[must_use]
    pub fn summary(&self) -> Summary {
        Summary::default()
    }
}
