//! Subprograms of Fanuc's system A: M97 to a block of the same program, M98 to a program of its own number.
//!
//! # Form
//! `M97 P100 L3` runs the blocks from N100 to M99 three times. `M98 P30005`, or `M98 P0005 L3`, runs program O0005 three times: the
//! last four digits of P are the number, those before them how often. It is looked for in the same file and then beside it, in a
//! file O0005, 0005 or 5. `M99 P50` goes back to block N50 of the caller.
//!
//! # References
//! The lathe simulator's description of M97 to M99; Fanuc Series 0i-T operator's manual, subprograms: four deep.

use crate::finding::clause::InTheCaller;
use crate::gcode::code::M;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::flow::Call;
use crate::gcode::interpreter::library::LineStart;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::source::Position;
use crate::gcode::rules::flow::{
    BlockCallWithoutP, BlockMissing, CallWithoutP, FileOfAnother, MainJumps, MainReturns, NotAProgramNumber,
    ProgramNowhere, ProgramTwice, RepeatsOfP, RepeatsTooMany, RepeatsTwice, SubprogramTooLarge, SubprogramUnreadable,
};
use crate::limits::{CALL_REPEATS, SUBPROGRAM_BYTES};

impl Reader<'_, '_> {
    /// M97, M98 and M99 of the block in hand.
    pub(super) fn call_by_number(&mut self) -> Result<()> {
        match self.block.m(4) {
            Some((M::CallBlock, _)) => self.call_block(),
            Some((M::Call, _)) => self.call_numbered_program(),
            _ => self.return_to_caller(),
        }
    }

    /// P of a call, a whole number from 1 on.
    fn called(&self, code: u8) -> Result<u32> {
        let Some(P) = self.block.get(letter::P) else {
            let column = &[self.block.m_column(4)];
            return Err(if code == 97 {
                Refused::of(&BlockCallWithoutP {}, column)
            } else {
                Refused::of(&CallWithoutP {}, column)
            });
        };
        whole(P)
            .and_then(|number| u32::try_from(number).ok())
            .filter(|&number| number > 0)
            .ok_or_else(|| Refused::of(&NotAProgramNumber { number: P }, &[self.block.column(letter::P)]))
    }

    /// L of a call.
    fn repeats(&self) -> Result<Option<i64>> {
        let Some(L) = self.block.get(letter::L) else { return Ok(None) };
        let repeats = whole(L).filter(|repeats| (0..=CALL_REPEATS).contains(repeats));
        repeats.map(Some).ok_or_else(|| {
            Refused::of(&RepeatsTooMany { repeats: L, most: CALL_REPEATS }, &[self.block.column(letter::L)])
        })
    }

    fn call_block(&mut self) -> Result<()> {
        let number = self.called(97)?;
        let repeats = self.repeats()?.unwrap_or(1);
        let block = self.block_numbered(number, self.block.column(letter::P), &BlockMissing { number })?;
        if repeats == 0 {
            return Ok(());
        }
        let back = self.memory.flow.next;
        let start = LineStart { line: block.at, ..back };
        self.enter(Call::of(format!("N{number}"), back, repeats, start))?;
        self.open(start);
        Ok(())
    }

    fn call_numbered_program(&mut self) -> Result<()> {
        let P = self.called(98)?;
        let L = self.repeats()?;
        let (number, repeats) = match (L, P / 10_000) {
            (Some(repeats), 0) => (P, repeats),
            (None, 0) => (P, 1),
            (None, times) => (P % 10_000, times.into()),
            (Some(_), _) => {
                return Err(Refused::of(
                    &RepeatsTwice { number: P },
                    &[self.block.column(letter::P), self.block.column(letter::L)],
                ));
            }
        };
        if !(0..=CALL_REPEATS).contains(&repeats) {
            return Err(Refused::of(
                &RepeatsOfP { number: P, repeats, most: CALL_REPEATS },
                &[self.block.column(letter::P)],
            ));
        }
        let back = self.memory.flow.next;
        let start = self.program_numbered(number)?;
        if repeats == 0 {
            return Ok(());
        }
        self.enter(Call::of(number.to_string(), back, repeats, start))?;
        self.open(start);
        Ok(())
    }

    /// Where a program begins: behind the line of its number.
    fn program_numbered(&mut self, number: u32) -> Result<LineStart> {
        let column = self.block.column(letter::P);
        let twice = |places: String| Refused::of(&ProgramTwice { number: format!("{number:04}"), places }, &[column]);
        // The file in hand, then the program's own file.
        for text in [self.memory.flow.next.text, 0] {
            let found: Vec<_> =
                self.memory.library.numbers(text, &self.memory.control.lexis)?.programs(number).collect();
            match *found.as_slice() {
                [] => {}
                [line] => return Ok(LineStart { text, line }),
                [one, two, ..] => return Err(twice(format!("{}, {}", one.lines, two.lines))),
            }
        }
        let mut names =
            vec![format!("O{number:04}"), format!("o{number:04}"), format!("{number:04}"), number.to_string()];
        names.dedup();
        if let Some(known) = self.memory.library.find(|file| names.iter().any(|name| name == file)) {
            return self.beginning(known, number);
        }
        let mut found: Option<(String, Vec<u8>)> = None;
        for name in names {
            let bytes = self
                .memory
                .setting
                .files
                .find(&name)
                .map_err(|reason| Refused::of(&SubprogramUnreadable { name: name.clone(), reason }, &[column]))?;
            match (bytes, &found) {
                (None, _) => {}
                (Some(bytes), None) => found = Some((name, bytes)),
                // A file system that does not tell capitals from small letters gives the same file twice.
                (Some(bytes), Some((first, same))) if *same == bytes && first.eq_ignore_ascii_case(&name) => {}
                (Some(_), Some((first, _))) => return Err(twice(format!("{first}, {name}"))),
            }
        }
        let Some((name, bytes)) = found else {
            let nowhere = ProgramNowhere { number: format!("{number:04}") };
            return Err(Refused::of(&nowhere, &[column]).as_alarm_of(self.alarms()));
        };
        if bytes.len() > SUBPROGRAM_BYTES {
            return Err(Refused::ended(&SubprogramTooLarge { name }));
        }
        let text = self.memory.library.add(bytes, name);
        self.beginning(text, number)
    }

    /// Where the program of a file of its own begins: behind its number, or behind `%`, or with its first line.
    fn beginning(&mut self, text: usize, number: u32) -> Result<LineStart> {
        let numbers = self.memory.library.numbers(text, &self.memory.control.lexis)?;
        if let Some(line) = numbers.programs(number).next() {
            return Ok(LineStart { text, line });
        }
        if let Some(other) = numbers.first_program() {
            let name = self.memory.library.file(text).cloned().unwrap_or_default();
            return Err(Refused::of(
                &FileOfAnother { name, other: format!("{other:04}"), number: format!("{number:04}") },
                &[self.block.column(letter::P)],
            ));
        }
        let mut line = Vec::new();
        let start = LineStart { text, line: Position::START };
        let behind = self.memory.library.line(start, &mut line)?;
        Ok(behind.filter(|_| line.trim_ascii() == b"%").unwrap_or(start))
    }

    /// M99: again, or back to the caller.
    fn return_to_caller(&mut self) -> Result<()> {
        let P = if self.block.has(letter::P) { Some(self.called(99)?) } else { None };
        // A main program has been read as a whole.
        if self.memory.flow.frames.is_empty() {
            self.end_spindle(true);
        }
        match (self.memory.flow.frames.last_mut(), P) {
            (None, None) => Err(Refused::ended(&MainReturns {})),
            (None, Some(block)) => Err(Refused::of(&MainJumps { block }, &[self.block.column(letter::P)])),
            (Some(call), None) => match call.repeat() {
                Some(start) => {
                    self.open(start);
                    Ok(())
                }
                None => {
                    self.leave();
                    Ok(())
                }
            },
            (Some(_), Some(number)) => {
                let column = self.block.column(letter::P);
                self.leave();
                // The number is one of the caller's program.
                let near = self.memory.flow.next.line.lines.max(1);
                let block = self.block_near(near, number, column, &BlockMissing { number });
                let there = self.memory.flow.next.text;
                let block = block.map_err(|fault| {
                    // M99 stands here, and the blocks it may mean there.
                    let elsewhere = there != self.block.spot.text && fault.others.is_empty();
                    if elsewhere { fault.with_clause(&InTheCaller {}) } else { fault }
                })?;
                self.go_to(block.at);
                Ok(())
            }
        }
    }
}
