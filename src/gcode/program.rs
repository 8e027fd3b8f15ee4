//! A program: parts in order, and its text line by line.

use std::sync::Arc;

use crate::gcode::control::{Control, FeedLaw};
use crate::gcode::feed_word::FeedWord;
use crate::gcode::word::{Distance, Number, NumberFormat, Retract, Word};
use crate::machine::axis::{Axis, Position};
use crate::number::grid::Milli;
use crate::text::Text;

/// How programs are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// As the published annexes: blocks alone, without header and safety block.
    Annex,
    /// What a machinist expects: header, safety block, feed and speed, fixed decimals.
    Full,
}

/// The F words of a path.
#[derive(Clone, Debug)]
pub enum Feed {
    /// None: a rapid move, or a program that carries no feed.
    None,
    /// One for each move.
    Each {
        /// The F words.
        words: Arc<[FeedWord]>,
        /// The time that each move takes with its F word, s.
        seconds: Arc<[f64]>,
    },
}

/// What a path is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Clear of the part: nothing may be touched.
    Clear,
    /// Into the part and along the track of this name, point by point.
    Cut(&'static str),
    /// Out of the part, from the last point of the track of this name.
    Leave(&'static str),
}

/// Moves through positions.
#[derive(Clone, Debug)]
pub struct Path {
    /// What it is there for.
    pub role: Role,
    /// The positions to go to, one block each. Shared: the same pass is cut many times.
    pub positions: Arc<[Position]>,
    /// Run from the last to the first.
    pub backwards: bool,
    /// How far C has been turned on beyond the positions.
    pub turn: Milli,
    /// The axes that a block names; the others stand still.
    pub axes: &'static [Axis],
    /// G0 instead of G1.
    pub rapid: bool,
    /// Absolute or incremental words.
    pub distance: Distance,
    /// Words of axes that stand still are left out.
    pub moving_only: bool,
    /// The F words.
    pub feed: Feed,
}

impl Path {
    /// The time of the `step`th move at feed, s; `None` where it carries no feed.
    #[must_use]
    pub fn seconds(&self, step: usize) -> Option<f64> {
        match &self.feed {
            Feed::None => None,
            Feed::Each { seconds, .. } => seconds.get(step).copied(),
        }
    }

    /// The position of the `step`th move.
    #[must_use]
    pub fn position(&self, step: usize) -> Option<Position> {
        let at = if self.backwards { self.positions.len().checked_sub(step + 1)? } else { step };
        self.positions.get(at).map(|position| position.moved(Axis::C, self.turn))
    }
}

/// A part of a program.
#[derive(Clone, Debug)]
pub enum Part {
    /// A line of the control's opening. A program that begins with one has the control's ending behind its last part.
    Opening(String),
    /// A line as it stands: a block of a published program.
    Line(String),
    /// A comment, cleaned already.
    Comment(String),
    /// A block of words without moves, or of a turning program.
    Block(Vec<Word>),
    /// The block that takes the tool away first of all.
    Away(Retract),
    /// Moves.
    Path(Path),
}

/// A program as rodete plans it; its text is written from it line by line.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its name in files and findings, as `blade` or `hole`.
    pub key: &'static str,
    /// What it does.
    pub title: Text,
    /// The control that it is written for.
    pub control: &'static Control,
    /// What F is in its moves at feed.
    pub law: FeedLaw,
    /// How numbers are written.
    pub format: NumberFormat,
    /// First block number and step between block numbers; `None` where blocks are not numbered.
    pub block_step: Option<u32>,
    /// Where the first path starts.
    pub start: Position,
    /// Its lines, blocks and paths, in order.
    pub parts: Vec<Part>,
}

/// One move of a program.
#[derive(Clone, Copy, Debug)]
pub struct Move<'a> {
    /// The path it belongs to.
    pub path: &'a Path,
    /// Its number in the path.
    pub step: usize,
    /// Where it starts.
    pub from: Position,
    /// Where it ends.
    pub to: Position,
    /// Its line in the program's text, counted from 1.
    pub line: usize,
}

/// The moves of a program, in order.
#[derive(Clone, Debug)]
pub struct Moves<'a> {
    parts: &'a [Part],
    step: usize,
    at: Position,
    line: usize,
}

impl<'a> Iterator for Moves<'a> {
    type Item = Move<'a>;

    fn next(&mut self) -> Option<Move<'a>> {
        loop {
            let (part, rest) = self.parts.split_first()?;
            if let Part::Path(path) = part {
                while let Some(to) = path.position(self.step) {
                    let (step, from) = (self.step, self.at);
                    self.step += 1;
                    if to != from {
                        self.line += 1;
                        self.at = to;
                        return Some(Move { path, step, from, to, line: self.line });
                    }
                }
                self.step = 0;
            } else {
                self.line += 1;
            }
            self.parts = rest;
        }
    }
}

impl Program {
    /// True where it is written for a control. Each control stands at one place, so that the two are the same where they stand at the
    /// same. It tells apart two that are given: what a control does is asked of its data.
    #[must_use]
    pub fn is_for(&self, control: &'static Control) -> bool {
        std::ptr::eq(self.control, control)
    }

    /// The moves in order. Moves of no length are left out, as they are in the text.
    #[must_use]
    pub fn moves(&self) -> Moves<'_> {
        Moves { parts: &self.parts, step: 0, at: self.start, line: 0 }
    }

    /// Calls `visit` for each of the [`Self::moves`].
    pub fn for_each_move(&self, visit: &mut dyn FnMut(Move<'_>)) {
        self.moves().for_each(visit);
    }

    /// True where the text itself brings the machine to [`Self::start`]; false for a program that begins wherever the
    /// machine stands.
    #[must_use]
    pub fn finds_its_start(&self) -> bool {
        let size = |word: &Word| matches!(word.number, Number::Size(_));
        let before = self.parts.iter().take_while(|part| !matches!(part, Part::Path(_)));
        before.into_iter().any(|part| matches!(part, Part::Block(words) if words.iter().any(size)))
    }

    /// The block that takes the tool away, which stands before every move, and its line, counted from 1; `None` where there
    /// is none.
    #[must_use]
    pub fn away(&self) -> Option<(usize, &Retract)> {
        (1..).zip(&self.parts).find_map(|(line, part)| match part {
            Part::Away(retract) => Some((line, retract)),
            _ => None,
        })
    }

    /// The lines behind the last part: the control's ending, where the program begins with its opening.
    #[must_use]
    pub fn ending(&self) -> &'static [&'static str] {
        if matches!(self.parts.first(), Some(Part::Opening(_))) { self.control.text.ending } else { &[] }
    }

    /// How many blocks there are: lines that may carry a number.
    #[must_use]
    pub fn blocks(&self) -> u64 {
        let mut blocks = self.parts.iter().filter(|part| matches!(part, Part::Block(_) | Part::Away(_))).count() as u64;
        self.for_each_move(&mut |_| blocks += 1);
        blocks
    }
}

#[cfg(test)]
impl Program {
    /// A program for LinuxCNC without a title and without a block.
    pub(crate) fn sample(key: &'static str) -> Self {
        use crate::gcode::control::LINUXCNC;
        Self {
            key,
            title: Text::same(""),
            control: &LINUXCNC,
            law: LINUXCNC.feed.law,
            format: NumberFormat::Fixed,
            block_step: None,
            start: Position::default(),
            parts: Vec::new(),
        }
    }
}
