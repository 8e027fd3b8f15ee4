//! Turning cycles of one call: from words to the parameters of the pure cycles, from their moves to motions.
//!
//! # References
//! Fanuc Series 0i-T operator's manual, multiple repetitive cycles G70 to G76: two blocks each but for G70, the words of the first
//! stay in force; after G70 the program goes on with the next block, after G71 to G73 behind the contour. P and Q of G74 to G76
//! are numbers of least input increments.
//!
//! What the first block does not give is a parameter of the control, which is not known here: it is refused.

use crate::finding::Size;
use crate::gcode::code::{G, Group, TurningCycle};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::doubt::{FIRST_BLOCK, number};
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::motion::Feed;
use crate::gcode::turning::Move;
use crate::gcode::turning::finish::finish;
use crate::gcode::turning::groove::{self, Groove};
use crate::gcode::turning::pattern_repeating::{Repeat, repeat};
use crate::gcode::turning::rough::{self, Rough};
use crate::gcode::turning::rules::{
    AllowanceIntoWall, FirstBlockMissing, FirstBlockUnused, FirstBlockWordMissing, PlungesApart, RepeatPassesNotWhole,
    ThreadFirstBlockDigits, ThreadInOnePass, ThreadWordMissing,
};
use crate::gcode::turning::thread_cycle::{Threading, thread};
use crate::gcode::turning::trouble::Trouble;
use crate::machine::axis::Axis;

/// The words of the first block of a cycle of two: of each letter of [`FIRST`] that it gave, the number as programmed.
pub(super) type First = [Option<f64>; 5];

const FIRST: [usize; 5] = [letter::P, letter::Q, letter::R, letter::U, letter::W];

/// By how much plunges may be farther apart than the blade is wide, mm: what is left by rounding.
const WIDER: f64 = 1e-6;

/// Letters that only the second block of a cycle along a contour has, and of one without.
const OF_CONTOUR: &[u8] = b"PQ";
const TO_A_POINT: &[u8] = b"XZUW";

/// The letters by which the second block of a cycle of two is told from the first; `None` of one of a single block.
const fn second_words(cycle: TurningCycle) -> Option<&'static [u8]> {
    match cycle {
        TurningCycle::Axial | TurningCycle::Radial | TurningCycle::Repeat => Some(OF_CONTOUR),
        TurningCycle::GrooveFace | TurningCycle::GrooveOutside | TurningCycle::Thread => Some(TO_A_POINT),
        TurningCycle::Finish | TurningCycle::ByLetters(_) => None,
    }
}

impl Reader<'_, '_> {
    /// True where a block of a lathe that was rejected, whatever for, calls a cycle or repeats one: the cycle cuts nothing, so that the part
    /// is from here on not what the program counts on. Its contour, none of the program's own motions, is passed over.
    pub(super) fn loses_cycle(&mut self, line: &[u8]) -> bool {
        if !self.memory.control.turns() {
            return false;
        }
        let line = self.without_comments(line);
        let line = line.as_slice();
        let words = |letter: u8| {
            line.iter().enumerate().filter(move |(_, byte)| **byte == letter).map(|(at, _)| number(line, at + 1))
        };
        let codes: Vec<G> = words(b'G')
            .filter_map(|code| usize::try_from(whole(code? * 10.0)?).ok())
            .filter_map(|tenths| self.memory.control.codes.get(tenths))
            .collect();
        let other = codes.iter().any(|code| matches!(code.group(), Group::Motion | Group::NonModal));
        let again = !other && self.state.modal.motion.is_cycle() && line.iter().any(|letter| b"XZUWR".contains(letter));
        let lost = again || codes.iter().any(|code| code.is_cycle());
        let of_two = codes.into_iter().find_map(|code| match code {
            G::Turning(cycle) => Some((cycle, second_words(cycle)?)),
            _ => None,
        });
        // The second block is there, though it was rejected.
        if let Some((cycle, _)) = of_two.filter(|(_, words)| line.iter().any(|letter| words.contains(letter))) {
            self.second_block(cycle);
        }
        if let Some((cycle, _)) = of_two.filter(|(_, words)| *words == OF_CONTOUR) {
            let block = |letter| u32::try_from(whole(words(letter).next()??)?).ok();
            if let (Some(first), Some(last)) = (block(b'P'), block(b'Q')) {
                self.pass_over_contour(cycle.number(), [first, last]);
            }
        }
        lost
    }

    /// The turning cycle of the block in hand.
    pub(super) fn turning(&mut self, cycle: TurningCycle) -> Result<()> {
        self.turn(cycle).map_err(|mut fault| {
            fault.uncut = true;
            fault
        })
    }

    fn turn(&mut self, cycle: TurningCycle) -> Result<()> {
        match cycle {
            TurningCycle::Finish => {
                let ends = self.contour_ends(cycle.number(), [letter::P, letter::Q])?;
                // What was refused once is not refused again, nor finished where it was not roughed.
                if self.state.modal.refused.contains(&(self.memory.flow.next.text, ends.first_line())) {
                    return Ok(());
                }
                let contour = self.contour(cycle.number(), ends)?;
                let moves = self.told(finish(&contour.profile))?;
                self.finish_contour(moves, contour.blocks);
                Ok(())
            }
            TurningCycle::Axial | TurningCycle::Radial | TurningCycle::Repeat => self.roughing(cycle),
            TurningCycle::GrooveFace | TurningCycle::GrooveOutside => self.grooving(cycle),
            TurningCycle::Thread => self.threading(cycle),
            TurningCycle::ByLetters(cycle) => self.letter_cycle(cycle),
        }
    }

    /// G71, G72, G73.
    fn roughing(&mut self, cycle: TurningCycle) -> Result<()> {
        if !self.block.has(letter::P) && !self.block.has(letter::Q) {
            self.keep_first(cycle);
            return Ok(());
        }
        self.second_block(cycle);
        let unit = self.state.modal.unit;
        let length = |word: Option<f64>| word.map(|word| unit.to_mm(word));
        let depth = if cycle == TurningCycle::Radial { letter::W } else { letter::U };
        let depth = unit.to_mm(self.first(cycle, depth)?);
        let retract = self.first(cycle, letter::R)?;
        let axial = if cycle == TurningCycle::Repeat { unit.to_mm(self.first(cycle, letter::W)?) } else { 0.0 };
        let ends = self.contour_ends(cycle.number(), [letter::P, letter::Q])?;
        let contour = self.contour(cycle.number(), ends)?;
        self.go_behind(cycle.number(), &contour)?;
        self.remark_passed_over(cycle.number(), &contour);
        let feed = self.feed()?;
        let U = length(self.block.get(letter::U)).unwrap_or(0.0) / 2.0;
        let W = length(self.block.get(letter::W)).unwrap_or(0.0);
        let rough = Rough { depth, retract: unit.to_mm(retract), U, W, feed: None, both_axes: Some(contour.both_axes) };
        let moves = match cycle {
            TurningCycle::Axial => rough::axial(&contour.profile, &rough),
            TurningCycle::Radial => rough::radial(&contour.profile, &rough),
            _ => {
                let passes = whole(retract).ok_or_else(|| {
                    Refused::of(&RepeatPassesNotWhole { value: retract }, &[self.block.g_column(Group::NonModal)])
                })?;
                let relief = [depth, axial];
                repeat(&contour.profile, &Repeat { relief, passes, allowance: [U, W], feed: None })
            }
        };
        let moves = self.told(moves)?;
        if let Some(line) = rough::cut_into(&contour.profile, [U, W]) {
            self.memory.remarks.row(&AllowanceIntoWall {}, Spot { line, n: None, ..self.block.spot }, None);
        }
        self.make_contour_moves(moves, feed, contour.blocks);
        Ok(())
    }

    /// G74 and G75.
    fn grooving(&mut self, cycle: TurningCycle) -> Result<()> {
        if !self.has_axes() {
            self.keep_first(cycle);
            return Ok(());
        }
        self.second_block(cycle);
        let unit = self.state.modal.unit;
        let retract = unit.to_mm(self.first(cycle, letter::R)?);
        let step = [letter::P, letter::Q].map(|word| self.increments(self.block.get(word).unwrap_or(0.0)));
        let relief = unit.to_mm(self.block.get(letter::R).unwrap_or(0.0));
        let feed = self.feed()?;
        let groove = Groove { retract, to: self.corner(), step, relief, feed: None };
        let start = self.here();
        let moves = match cycle {
            TurningCycle::GrooveFace => groove::face(start, &groove),
            _ => groove::radial(start, &groove),
        };
        let moves = self.told(moves)?;
        self.remark_step(cycle.number(), groove.spacing(start, usize::from(cycle == TurningCycle::GrooveOutside)));
        self.make_moves(moves, feed);
        Ok(())
    }

    /// Remarks plunges farther apart than the blade in force is wide, mm: metal stays between them.
    pub(super) fn remark_step(&mut self, number: u8, step: f64) {
        let blade = self.memory.tools.get(&self.state.modal.offset).and_then(|tool| tool.blade);
        if let Some(width) = blade.filter(|width| step > width + WIDER) {
            let row = PlungesApart { number, step: Size::mm(step), width: Size::mm(width) };
            self.memory.remarks.row(&row, self.block.spot, Some(self.block.g_column(Group::NonModal)));
        }
    }

    /// G76, of two blocks: the first one's words are kept for the second.
    fn threading(&mut self, cycle: TurningCycle) -> Result<()> {
        if !self.has_axes() {
            self.keep_first(cycle);
            return Ok(());
        }
        self.second_block(cycle);
        let column = self.block.g_column(Group::NonModal);
        let P = self.first(cycle, letter::P)?;
        let digits = whole(P).and_then(|digits| u32::try_from(digits).ok()).filter(|digits| *digits <= 999_999);
        let Some(digits) = digits else {
            return Err(Refused::of(&ThreadFirstBlockDigits { value: P }, &[column]));
        };
        let missing = |name: char| Refused::of(&ThreadWordMissing { letter: name }, &[column]);
        let height = self.block.get(letter::P).ok_or_else(|| missing('P'))?;
        let first = self.block.get(letter::Q).ok_or_else(|| missing('Q'))?;
        let least = self.first(cycle, letter::Q)?;
        let allowance = self.first(cycle, letter::R)?;
        let threading = Threading {
            finishing: digits / 10_000,
            chamfer: digits / 100 % 100,
            angle: f64::from(digits % 100),
            least: self.increments(least),
            allowance: self.state.modal.unit.to_mm(allowance),
            to: self.corner(),
            taper: self.state.modal.unit.to_mm(self.block.get(letter::R).unwrap_or(0.0)),
            height: self.increments(height),
            first: self.increments(first),
            lead: self.lead()?,
        };
        let moves = self.told(thread(self.here(), &threading))?;
        let Threading { first, height, .. } = threading;
        if first >= height - threading.allowance {
            let row = ThreadInOnePass { first: Size::mm(first), height: Size::mm(height) };
            self.memory.remarks.row(&row, self.block.spot, Some(self.block.column(letter::Q)));
        }
        self.make_moves(moves, Feed { mode: self.state.modal.feed_mode, value: self.state.modal.feed });
        Ok(())
    }

    /// True where the block has a turning cycle of one call.
    pub(super) fn has_turning_cycle(&self) -> bool {
        matches!(self.block.g(Group::NonModal), Some(G::Turning(_)))
    }

    /// Where the tool stands, `[X, Z]`.
    pub(super) fn here(&self) -> [f64; 2] {
        [self.state.at.get(Axis::X), self.state.at.get(Axis::Z)]
    }

    /// Where the axis words lead, `[X, Z]`.
    fn corner(&mut self) -> [f64; 2] {
        let to = self.end_point();
        [to.get(Axis::X), to.get(Axis::Z)]
    }

    /// The moves of a cycle, or its trouble as a refusal at its place.
    pub(super) fn told(&self, moves: Result<Vec<Move>, Box<Trouble>>) -> Result<Vec<Move>> {
        moves.map_err(|trouble| {
            let columns =
                if trouble.line.is_none() { vec![self.block.g_column(Group::NonModal) + 1] } else { Vec::new() };
            Box::new(Refused { columns, ..Refused::from(*trouble) }).as_alarm_of(self.alarms())
        })
    }

    /// A second block makes use of the first one before it.
    fn second_block(&mut self, cycle: TurningCycle) {
        self.memory.seen.first_blocks.retain(|(first, _)| *first != cycle);
    }

    /// Keeps the words of the first block of a cycle; those that it does not give stay.
    fn keep_first(&mut self, cycle: TurningCycle) {
        if let Some((_, spot)) = self.memory.seen.first_blocks.iter().find(|(first, _)| *first == cycle) {
            self.memory.remarks.row(&FirstBlockUnused { cycle: cycle.number() }, *spot, None);
        }
        self.second_block(cycle);
        self.memory.seen.first_blocks.push((cycle, self.block.spot));
        let given = FIRST.map(|letter| self.block.get(letter));
        match self.state.modal.first.iter_mut().find(|(of, _)| *of == cycle) {
            Some((_, kept)) => {
                for (kept, given) in kept.iter_mut().zip(given) {
                    *kept = given.or(*kept);
                }
            }
            None => self.state.modal.first.push((cycle, given)),
        }
    }

    /// A word of the first block of a cycle.
    fn first(&self, cycle: TurningCycle, letter: usize) -> Result<f64> {
        let number = cycle.number();
        let kept = self.state.modal.first.iter().find(|(of, _)| *of == cycle).map(|(_, first)| first);
        let at = FIRST.iter().position(|one| *one == letter);
        let found = kept.zip(at).and_then(|(kept, at)| kept.get(at).copied().flatten());
        found.ok_or_else(|| {
            let name = char::from(b'A' + u8::try_from(letter).unwrap_or(0));
            let at = [self.block.g_column(Group::NonModal)];
            if kept.is_none() {
                Refused::of(&FirstBlockMissing { cycle: number }, &at).hanging_on(FIRST_BLOCK)
            } else {
                Refused::of(&FirstBlockWordMissing { letter: name, cycle: number }, &at)
            }
        })
    }
}
