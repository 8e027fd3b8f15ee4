//! Blocks as a control wants them: one way for every kind that writes programs.
//!
//! What a control has a form of its own for is asked of its [`Writing`](crate::gcode::control::Writing) or of the rule by which it is read.

use crate::gcode::control::{Control, FeedLaw, Post};
use crate::gcode::feed_word::FeedWord;
use crate::gcode::program::{Part, Program};
use crate::gcode::word::{Distance, NumberFormat, Word};
use crate::machine::axis::{Axis, Position};
use crate::number::grid::{Milli, OutOfFormat};
use crate::text::Text;

/// A program being written.
#[derive(Debug)]
pub struct Writer {
    post: Post,
    law: FeedLaw,
    last: Option<FeedWord>,
    parts: Vec<Part>,
}

impl Writer {
    /// A program that begins with some parts, its header.
    #[must_use]
    pub const fn new(post: Post, parts: Vec<Part>) -> Self {
        Self { post, law: post.control.feed.law, last: None, parts }
    }

    /// The same, with F along the path in mm a minute whatever the control's law for rotary axes.
    #[must_use]
    pub fn along_the_path(self) -> Self {
        Self { law: FeedLaw::Resultant, ..self }
    }

    /// What F is in the moves at feed.
    #[must_use]
    pub const fn law(&self) -> FeedLaw {
        self.law
    }

    /// Appends a part as it is.
    pub fn part(&mut self, part: Part) {
        self.parts.push(part);
    }

    /// Appends a block of these words.
    pub fn block(&mut self, words: impl Into<Vec<Word>>) {
        self.parts.push(Part::Block(words.into()));
    }

    /// The block that puts the control into a known state.
    pub fn safety(&mut self) {
        self.block(self.post.writing.safety_block());
    }

    /// The blocks that bring a tool and its offset D to work.
    pub fn tool(&mut self, T: u32, D: u32) {
        for words in self.post.writing.tool.blocks(T, D) {
            self.block(words);
        }
    }

    /// The word that says a coordinate of an axis, mm or degrees.
    #[must_use]
    pub fn coordinate(&self, axis: Axis, coordinate: Milli) -> Word {
        let word = if axis == Axis::X { self.post.control.axes.x.word(coordinate) } else { coordinate };
        Word::size(axis.letter(), word)
    }

    /// The word of X that says a diameter, mm.
    ///
    /// # Errors
    /// For a diameter that no program may carry.
    pub fn diameter(&self, diameter: f64) -> Result<Word, OutOfFormat> {
        Ok(Word::size('X', Milli::round(self.post.control.axes.x.of_diameter(diameter))?))
    }

    /// The control that the program is written for.
    #[must_use]
    pub const fn control(&self) -> &'static Control {
        self.post.control
    }

    /// Appends a rapid move: G0 before these words, of which none is a motion code.
    pub fn rapid(&mut self, words: impl IntoIterator<Item = Word>) {
        self.block(std::iter::once(Word::whole('G', 0)).chain(words).collect::<Vec<_>>());
    }

    /// Absolute or incremental words from here on.
    pub fn distance(&mut self, distance: Distance) {
        let code = match distance {
            Distance::Absolute => 90,
            Distance::Incremental => 91,
        };
        self.block([Word::whole('G', code)]);
    }

    /// A dwell in seconds.
    ///
    /// # Errors
    /// For a time that no program may carry.
    pub fn dwell(&mut self, seconds: f64) -> Result<(), OutOfFormat> {
        let time = self.post.control.lexis.dwell.first().map(|dwell| dwell.word(seconds)).transpose()?;
        self.block(std::iter::once(Word::whole('G', 4)).chain(time).collect::<Vec<_>>());
        Ok(())
    }

    /// What F is, before the first move at feed.
    pub fn begin_feed(&mut self) {
        if let Some(code) = self.law.code() {
            self.block([Word::whole('G', code)]);
        }
    }

    /// F is a speed again, behind the last move at feed.
    pub fn end_feed(&mut self) {
        if self.law.code().is_some() {
            self.block([Word::whole('G', self.post.control.feed.codes.per_minute())]);
        }
    }

    /// A move at feed, with the motion code that the caller puts first among the words: G1 for a line, G2 or G3 for an arc; none is
    /// added, for a kind may leave out a code that is in force. F is left out where it is in force already.
    pub fn feed(&mut self, words: impl IntoIterator<Item = Word>, F: FeedWord) {
        let mut words: Vec<Word> = words.into_iter().collect();
        if F.is_written(self.law, self.last) {
            words.push(Word::feed(F));
            self.last = Some(F);
        }
        self.block(words);
    }

    /// The program's parts.
    #[must_use]
    pub fn finish(self) -> Vec<Part> {
        self.parts
    }

    /// The program, for the control and by the law that it was written for, with three decimals and blocks numbered by tens.
    /// It begins anywhere.
    #[must_use]
    pub fn program(self, key: &'static str, title: Text) -> Program {
        Program {
            key,
            title,
            control: self.post.control,
            law: self.law,
            format: NumberFormat::Fixed,
            block_step: Some(10),
            start: Position::default(),
            parts: self.parts,
        }
    }
}
