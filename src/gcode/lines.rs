//! The text of a program, line by line.

use std::io;

use crate::gcode::control::{CommentForm, Control};
use crate::gcode::digits::push_whole;
use crate::gcode::feed_word::FeedWord;
use crate::gcode::program::{Feed, Part, Path, Program};
use crate::gcode::word::{Distance, NumberFormat, Retract, Word};
use crate::machine::axis::{Axis, Position};

/// The lines of a program. Lends each line from one buffer, so that a program of any length needs no memory for its
/// text; that is why it is not an `Iterator`.
#[derive(Debug)]
pub struct Lines<'a> {
    program: &'a Program,
    part: usize,
    step: usize,
    at: Position,
    feed: Option<FeedWord>,
    number: u32,
    line: String,
    /// The words of the block in hand.
    words: Vec<Word>,
}

impl Program {
    /// The lines, one after another; see [`Lines::next`].
    #[must_use]
    pub fn lines(&self) -> Lines<'_> {
        Lines::new(self)
    }

    /// Calls `line` for each line of the program in order, with its block number and its text without number and end
    /// of line. The text is borrowed: nothing is kept.
    ///
    /// # Errors
    /// Passes on the error of `line`.
    pub fn for_each(&self, line: &mut dyn FnMut(Option<u32>, &str) -> io::Result<()>) -> io::Result<()> {
        let mut lines = self.lines();
        while let Some((number, text)) = lines.next() {
            line(number, text)?;
        }
        Ok(())
    }

    /// Calls `line` for each line of the program in order, as the control reads it but without the end of line.
    ///
    /// # Errors
    /// Passes on the error of `line`.
    pub fn for_each_line(&self, line: &mut dyn FnMut(&str) -> io::Result<()>) -> io::Result<()> {
        let mut whole = String::new();
        self.for_each(&mut |number, text| {
            whole.clear();
            if let Some(number) = number {
                whole.push('N');
                push_whole(&mut whole, number);
                whole.push(' ');
            }
            whole.push_str(text);
            line(&whole)
        })
    }

    /// Writes the program's text as the control reads it.
    ///
    /// # Errors
    /// Passes on the error of `out`.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        let mut lines = self.lines();
        let mut line = String::new();
        while lines.next_whole(&mut line) {
            out.write_all(line.as_bytes())?;
        }
        Ok(())
    }

    /// The program's text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut bytes = Vec::new();
        // A Vec takes every write.
        let _ = self.write(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    }
}

impl<'a> Lines<'a> {
    fn new(program: &'a Program) -> Self {
        Self {
            program,
            part: 0,
            step: 0,
            at: program.start,
            feed: None,
            number: 0,
            line: String::new(),
            words: Vec::new(),
        }
    }

    /// The next line: block number, and the text without number and end of line.
    #[expect(clippy::should_implement_trait, reason = "lends its buffer, which Iterator cannot")]
    pub fn next(&mut self) -> Option<(Option<u32>, &str)> {
        let program = self.program;
        self.line.clear();
        loop {
            let Some(part) = program.parts.get(self.part) else {
                let line = program.ending().get(self.part - program.parts.len())?;
                self.part += 1;
                self.line.push_str(line);
                return Some((None, &self.line));
            };
            match part {
                Part::Opening(text) | Part::Line(text) => {
                    self.part += 1;
                    self.line.push_str(text);
                    return Some((None, &self.line));
                }
                Part::Comment(text) => {
                    self.part += 1;
                    match program.control.text.comment {
                        CommentForm::Semicolon => {
                            self.line.push(';');
                            self.line.push_str(text);
                        }
                        CommentForm::Parentheses => {
                            self.line.push('(');
                            self.line.push_str(text);
                            self.line.push(')');
                        }
                    }
                    return Some((None, &self.line));
                }
                Part::Block(words) | Part::Away(Retract(words)) => {
                    self.part += 1;
                    self.words.clear();
                    self.words.extend_from_slice(words);
                    self.write_words();
                    return Some((self.count(), &self.line));
                }
                Part::Path(path) => match path.position(self.step) {
                    None => {
                        self.part += 1;
                        self.step = 0;
                    }
                    Some(to) => {
                        let step = self.step;
                        self.step += 1;
                        if to != self.at {
                            self.write_move(path, step, to);
                            return Some((self.count(), &self.line));
                        }
                    }
                },
            }
        }
    }

    /// Puts the next line, with its number and its end, into `line`; false where there is none.
    pub fn next_whole(&mut self, line: &mut String) -> bool {
        line.clear();
        let end_of_line = self.program.control.text.end_of_line;
        let Some((number, text)) = self.next() else { return false };
        if let Some(number) = number {
            line.push('N');
            push_whole(line, number);
            line.push(' ');
        }
        line.push_str(text);
        line.push_str(end_of_line);
        true
    }

    fn count(&mut self) -> Option<u32> {
        let step = self.program.block_step?;
        self.number = self.number.saturating_add(step);
        Some(self.number)
    }

    fn write_move(&mut self, path: &Path, step: usize, to: Position) {
        self.words.clear();
        self.words.push(Word::whole('G', u32::from(!path.rapid)));
        for &axis in path.axes {
            if path.moving_only && to.get(axis) == self.at.get(axis) {
                continue;
            }
            let size = match path.distance {
                Distance::Absolute => to.get(axis),
                Distance::Incremental => to.get(axis) - self.at.get(axis),
            };
            self.words.push(Word::size(axis.letter(), size));
        }
        debug_assert!(
            Axis::ALL.into_iter().all(|axis| path.axes.contains(&axis) || to.get(axis) == self.at.get(axis)),
            "an axis moves that the block does not name"
        );
        if let Feed::Each { words, .. } = &path.feed
            && let Some(&feed) = words.get(step)
            && feed.is_written(self.program.control.feed.law, self.feed)
        {
            self.words.push(Word::feed(feed));
            self.feed = Some(feed);
        }
        self.at = to;
        self.write_words();
    }

    /// The words of the block in hand, in the order that the control wants.
    fn write_words(&mut self) {
        let Program { control, format, .. } = self.program;
        write_block(control, &mut self.words, *format, &mut self.line);
    }
}

/// Appends a block to a text, its words in the order in which a control takes them. All that rodete writes goes through here.
pub fn write_block(control: &Control, words: &mut [Word], format: NumberFormat, text: &mut String) {
    control.lexis.words.arrange(words);
    words.iter().for_each(|word| word.write(format, text));
}
