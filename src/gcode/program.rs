//! A program: parts in order, and its text line by line.

use std::sync::Arc;

use crate::gcode::dialect::Dialect;
use crate::gcode::word::{Distance, NumberFormat, Word};
use crate::machine::axis::{Axis, Position};
use crate::number::grid::Milli;
use crate::text::Text;

/// The F words of a path.
#[derive(Clone, Debug)]
pub enum Feed {
    /// None: a rapid move, or a program that carries no feed.
    None,
    /// One for each move.
    Each {
        /// The F words.
        words: Arc<[Milli]>,
        /// The time that each move takes with its F word, s.
        seconds: Arc<[f64]>,
    },
}

/// Moves through positions.
#[derive(Clone, Debug)]
pub struct Path {
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
    /// A line as it stands: the dialect's first line.
    Opening(String),
    /// A comment, cleaned already.
    Comment(String),
    /// A block of words without moves, or of a turning program.
    Block(Vec<Word>),
    /// Moves.
    Path(Path),
}

/// A program.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its name in files and findings: `blade`, `splitter`, `impeller`, `blank`.
    pub key: &'static str,
    /// What it does.
    pub title: Text,
    /// The dialect.
    pub dialect: &'static Dialect,
    /// How numbers are written.
    pub format: NumberFormat,
    /// First block number and step between block numbers; `None` where blocks are not numbered.
    pub block_step: Option<u32>,
    /// Where the first path starts.
    pub start: Position,
    /// The parts.
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

impl Program {
    /// Calls `visit` for each move in order. Moves of no length are left out, as they are in the text.
    pub fn for_each_move(&self, visit: &mut dyn FnMut(Move<'_>)) {
        let mut at = self.start;
        let mut line = 0;
        for part in &self.parts {
            let Part::Path(path) = part else {
                line += 1;
                continue;
            };
            for step in 0..path.positions.len() {
                let Some(to) = path.position(step) else { continue };
                if to != at {
                    line += 1;
                    visit(Move { path, step, from: at, to, line });
                    at = to;
                }
            }
        }
    }

    /// How many blocks there are: lines that may carry a number.
    #[must_use]
    pub fn blocks(&self) -> u64 {
        let mut blocks = self.parts.iter().filter(|part| matches!(part, Part::Block(_))).count() as u64;
        self.for_each_move(&mut |_| blocks += 1);
        blocks
    }
}
