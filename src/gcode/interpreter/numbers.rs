//! The block numbers and program numbers of a file, for what is called or pointed at by number.

use std::collections::BTreeMap;

use crate::finding::Raise;
use crate::gcode::control::Lexis;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::source::{Position, SourceText};
use crate::gcode::interpreter::tape::lines;
use crate::gcode::interpreter::{Reader, block_number};
use crate::gcode::rules::flow::{BlockNumbersTooMany, BlockTwice};
use crate::limits::BLOCK_NUMBERS;

/// A block that has a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Numbered {
    /// Where its line begins.
    pub(super) at: Position,
    /// The line of another block with the same number.
    pub(super) again: Option<usize>,
}

impl Numbered {
    /// Its line, counted from 1.
    pub(super) const fn line(&self) -> usize {
        self.at.lines + 1
    }
}

/// The numbers of a file. Several programs may stand in one file, each with its own block numbers.
#[derive(Debug, Default)]
pub(super) struct Numbers {
    /// By program, counted from 0, and number.
    blocks: BTreeMap<(usize, u32), Numbered>,
    /// The O numbers, in the order of the file: number, and where the line behind it begins.
    programs: Vec<(u32, Position)>,
}

impl Numbers {
    /// Looks through a file up to the second `%`.
    pub(super) fn of(source: &mut SourceText<'_>, lexis: &Lexis) -> Result<Self> {
        let mut numbers = Self::default();
        lines(source, lexis, |at, behind, mut cursor| {
            cursor.accept_delete(true);
            if cursor.accept(b'o') {
                // A bad number is refused when its line is executed.
                if let Ok(number) = block_number(&mut cursor) {
                    numbers.programs.push((number, behind));
                }
            } else if cursor.accept(b'n')
                && let Ok(number) = block_number(&mut cursor)
            {
                let key = (numbers.programs.len(), number);
                numbers
                    .blocks
                    .entry(key)
                    .and_modify(|block| {
                        block.again.get_or_insert(at.lines + 1);
                    })
                    .or_insert(Numbered { at, again: None });
                if numbers.blocks.len() > BLOCK_NUMBERS {
                    return Err(Refused::ended(&BlockNumbersTooMany { most: BLOCK_NUMBERS }));
                }
            }
            Ok(())
        })?;
        Ok(numbers)
    }

    /// The block with a number in the program that a line (counted from 1) belongs to.
    pub(super) fn block(&self, number: u32, near: usize) -> Option<Numbered> {
        let program = self.programs.partition_point(|(_, after)| after.lines < near);
        self.blocks.get(&(program, number)).copied()
    }

    /// The first O number of the file.
    pub(super) fn first_program(&self) -> Option<u32> {
        self.programs.first().map(|(number, _)| *number)
    }

    /// Where the programs with an O number begin: behind the line of the number.
    pub(super) fn programs(&self, number: u32) -> impl Iterator<Item = Position> {
        self.programs.iter().filter(move |(one, _)| *one == number).map(|(_, after)| *after)
    }
}

impl Reader<'_, '_> {
    /// The block with a number, which stands once in the program in hand; `column` is that of the word that names it, and
    /// `missing` what is reported where there is none.
    pub(super) fn block_numbered(&mut self, number: u32, column: usize, missing: &dyn Raise) -> Result<Numbered> {
        self.block_near(self.block.spot.line, number, column, missing)
    }

    /// The same for the program that a line (counted from 1) of the text in hand belongs to.
    pub(super) fn block_near(
        &mut self,
        near: usize,
        number: u32,
        column: usize,
        missing: &dyn Raise,
    ) -> Result<Numbered> {
        let text = self.memory.flow.next.text;
        let found = self.memory.library.numbers(text, &self.memory.control.lexis)?.block(number, near);
        match found {
            None => Err(Refused::of(missing, &[column]).as_alarm_of(self.alarms())),
            Some(Numbered { again: Some(again), at }) => {
                let mut fault = Refused::of(&BlockTwice { number }, &[column]);
                let file = self.memory.library.file(text).cloned();
                fault.others = [at.lines + 1, again].map(|line| (file.clone(), line)).to_vec();
                Err(fault)
            }
            Some(block) => Ok(block),
        }
    }
}
