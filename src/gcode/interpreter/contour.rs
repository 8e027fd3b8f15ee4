//! The contour that a turning cycle names by the numbers of its first and its last block.
//!
//! # What its blocks may say beside their motions
//! F, S, T, G96 and G97, G98 and G99, G4 and M codes that call nothing and end nothing: roughing (G71 to G73) passes them over
//! and works with what is in force in the cycle's block; finishing (G70) obeys each in its place. T stands before the contour's
//! first motion or in its block: behind it the turret would turn in the cut, and what the offset then does to the arcs that follow
//! is said nowhere. A block without motion is no point of the contour.
//!
//! # References
//! Fanuc Series 0i-T operator's manual, multiple repetitive cycles: the first block of the contour has G0 or G1; its blocks call
//! no subprogram; block numbers between P and Q stand once; F, S, T and M of its blocks are passed over in roughing and obeyed in
//! finishing, and so are G96 and G97. Yaskawa LX3, operator's manual, G70: F and S alike. Schools teach the same of F, S, T and
//! the compensation.

use crate::finding::AlarmFamily;
use crate::gcode::code::{G, Group, M};
use crate::gcode::in_force::Compensation;
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::{AXES, Block, EdgeWord, letter};
use crate::gcode::interpreter::cursor::Cursor;
use crate::gcode::interpreter::expression::whole;
use crate::gcode::interpreter::library::{LineStart, Spot};
use crate::gcode::interpreter::numbers::Numbered;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::source::Position;
use crate::gcode::letters::Letters;
use crate::gcode::rules::flow::ContourBlockMissing;
use crate::gcode::rules::turned::{ContourLegInRapid, ContourWithoutCut};
use crate::gcode::turning::profile::{Element, Profile};
use crate::gcode::turning::rules::{
    BlocksBeforeContour, ContourBegins, ContourBlockNotNamed, ContourDwellAndMotion, ContourEndsBeforeItBegins,
    ContourEndsWithCorner, ContourStandsStill, ContourTooLong, ContourToolChange, ContourWithoutEnd,
    ContourWordsPassedOver, CornerInContour, NoBlockNumber, NotInContour,
};
use crate::limits::{CONTOUR_BLOCKS, REMARKS};
use crate::machine::axis::{Axis, Pose};
use crate::text::{Text, t};

/// Letters that a block of a contour may have.
const LETTERS: Letters = Letters::of("FIKRSTUWXZ");
const MOVES: Letters = Letters::of("IKRUWXZ");

#[derive(Clone, Debug)]
pub(super) struct ContourBlock {
    /// Its words, where they stand.
    pub(super) words: Block,
    /// The compensation in force in it.
    pub(super) side: Compensation,
}

impl ContourBlock {
    /// Its line, counted from 1.
    pub(super) const fn line(&self) -> usize {
        self.words.spot.line
    }
}

/// A contour as its blocks say.
#[derive(Clone, Debug)]
pub(super) struct Contour {
    /// Its geometry.
    pub(super) profile: Profile,
    /// Its blocks, in the order of their lines.
    pub(super) blocks: Vec<ContourBlock>,
    /// Its first motion names both axes.
    pub(super) both_axes: bool,
    /// The corner at the end of its last line, which the next one breaks, with the line of its block.
    edge: Option<(EdgeWord, usize)>,
    /// The line of its last block.
    last: usize,
    /// Where the block behind it begins.
    behind: Position,
}

/// A contour as a cycle has read it, in machine coordinates of the tool in force at the cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnedContour {
    /// The text that it stands in: 0 for the program, else as in [`InForce::file`](crate::gcode::in_force::InForce::file).
    pub file: usize,
    /// The numbers of its first and its last block.
    pub ends: [u32; 2],
    /// The turret's place at work.
    pub tool: u32,
    /// Its blocks at feed, each with its line and its two ends; the first block that moves, which leads to the contour, left out. An
    /// arc is told by its ends.
    pub legs: Vec<(usize, [Pose; 2])>,
}

/// The first and last block of a contour, with the columns of the words that name them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ends {
    first: Numbered,
    last: Numbered,
    numbers: [u32; 2],
}

impl Ends {
    /// The line of the first block.
    pub(super) const fn first_line(&self) -> usize {
        self.first.line()
    }
}

impl Reader<'_, '_> {
    /// The blocks that two words of the block in hand name, P and Q of Fanuc's cycles, S and E of Fagor's.
    pub(super) fn contour_ends(&mut self, cycle: u8, letters: [usize; 2]) -> Result<Ends> {
        let mut numbers = [0; 2];
        for (number, letter) in numbers.iter_mut().zip(letters) {
            *number = self.number_of_block(cycle, letter)?;
        }
        self.ends_numbered(cycle, numbers, letters.map(|letter| self.block.column(letter)))
    }

    /// The blocks with two numbers; `columns` are those of the words that name them.
    fn ends_numbered(&mut self, cycle: u8, numbers: [u32; 2], columns: [usize; 2]) -> Result<Ends> {
        let missing = |at: usize| ContourBlockMissing { number: numbers[at] };
        let first = self.block_numbered(numbers[0], columns[0], &missing(0))?;
        let last = self.block_numbered(numbers[1], columns[1], &missing(1))?;
        if last.line() < first.line() {
            return Err(Refused::of(
                &ContourEndsBeforeItBegins { cycle, last: numbers[1], first: numbers[0] },
                &[columns[1], columns[0]],
            )
            .as_alarm_of(self.alarms()));
        }
        Ok(Ends { first, last, numbers })
    }

    fn number_of_block(&self, cycle: u8, letter: usize) -> Result<u32> {
        let name = char::from(b'A' + u8::try_from(letter).unwrap_or(0));
        let Some(value) = self.block.get(letter) else {
            return Err(Refused::of(
                &ContourBlockNotNamed { letter: name, cycle },
                &[self.block.g_column(Group::NonModal)],
            )
            .as_alarm_of(self.alarms()));
        };
        whole(value)
            .and_then(|number| u32::try_from(number).ok())
            .ok_or_else(|| Refused::of(&NoBlockNumber { letter: name, value }, &[self.block.column(letter)]))
    }

    /// Reads the contour of a cycle from where the tool stands, on a state of its own. The program stays where it is.
    pub(super) fn contour(&mut self, cycle: u8, ends: Ends) -> Result<Contour> {
        let (mut block, mut probe) = (Block::at(self.block.spot), self.state.clone());
        let mut reader = Reader { memory: &mut *self.memory, block: &mut block, state: &mut probe };
        let read = reader.read_contour(cycle, ends);
        if let Ok(contour) = &read {
            self.see_contour(contour, ends, block.spot);
        }
        read.map_err(|mut fault| {
            fault.line = if fault.line == 0 { block.spot.line } else { fault.line };
            fault
        })
    }

    /// Keeps a contour for those who follow the program, and tells one that has no motion at feed, as its reader does, who
    /// stands in its `last` block: G71 and G70 tell it once.
    fn see_contour(&mut self, contour: &Contour, ends: Ends, last: Spot) {
        let Contour { profile, blocks, .. } = contour;
        let (file, line) = (self.block.spot.text, ends.first_line());
        if profile.elements.iter().all(|element| element.rapid) {
            let n = blocks.first().and_then(|block| block.words.spot.n);
            self.memory.remarks.row(&ContourWithoutCut {}, Spot { text: file, line, n, ..last }, None);
        } else {
            for line in profile.along_in_rapid() {
                let spot = blocks.iter().map(|block| block.words.spot).find(|spot| spot.line == line);
                let n = spot.and_then(|spot| spot.n);
                self.memory.remarks.row(&ContourLegInRapid {}, Spot { text: file, line, n, ..last }, None);
            }
        }
        let kept = &self.memory.seen.contours;
        // A file of nothing but contours must not fill the memory.
        let full = kept.len() >= REMARKS
            || kept.iter().map(|one| one.legs.len()).sum::<usize>() + profile.elements.len() > CONTOUR_BLOCKS;
        if full || kept.iter().any(|known| known.file == file && known.ends == ends.numbers) {
            return;
        }
        let machine = |[x, z]: [f64; 2]| {
            let mut at = self.state.at;
            at.set(Axis::X, x);
            at.set(Axis::Z, z);
            self.state.frame.to_machine(&at)
        };
        let legs = profile.elements.windows(2).filter(|pair| !pair[1].rapid);
        let legs = legs.map(|pair| (pair[1].line, [machine(pair[0].to), machine(pair[1].to)])).collect();
        let tool = self.state.modal.tool;
        self.memory.seen.contours.push(TurnedContour { file, ends: ends.numbers, tool, legs });
    }

    fn read_contour(&mut self, cycle: u8, ends: Ends) -> Result<Contour> {
        let start = [self.state.at.get(Axis::X), self.state.at.get(Axis::Z)];
        let mut contour = Contour {
            profile: Profile { start, elements: Vec::new() },
            blocks: Vec::new(),
            both_axes: false,
            edge: None,
            last: ends.last.line(),
            behind: ends.last.at,
        };
        let mut line = Vec::new();
        let mut next = LineStart { line: ends.first.at, ..self.memory.flow.next };
        while next.line.lines < ends.last.line() {
            let Some(behind) = self.memory.library.line(next, &mut line)? else { break };
            next = behind;
            self.count_line(behind)?;
            self.block.spot.again = self.memory.remarks.counted(self.block.spot);
            let Some(mut cursor) = self.open_line(&line)? else { continue };
            if matches!(cursor.peek(), b'%' | b'o') {
                return Err(Refused::of(&ContourWithoutEnd { cycle }, &[cursor.column()]));
            }
            self.read_words(&mut cursor)?;
            self.contour_block(cycle, &mut contour)?;
            if contour.blocks.len() > CONTOUR_BLOCKS {
                return Err(Refused::of(&ContourTooLong { cycle, most: CONTOUR_BLOCKS }, &[]));
            }
        }
        contour.behind = next.line;
        if let Some((word, line)) = contour.edge {
            return Err(word.refusal(line, &ContourEndsWithCorner { cycle, word: word.name }, self.alarms()));
        }
        if contour.profile.elements.is_empty() {
            let [P, Q] = ends.numbers;
            return Err(Refused::of(&ContourStandsStill { cycle, first: P, last: Q }, &[]).as_alarm_of(self.alarms()));
        }
        Ok(contour)
    }

    /// One block of a contour, in hand.
    fn contour_block(&mut self, cycle: u8, contour: &mut Contour) -> Result<()> {
        let first = contour.profile.elements.is_empty();
        self.contour_refuses(cycle, first)?;
        let dwell = self.contour_dwell()?;
        self.one_word_an_axis()?;
        let before = contour.blocks.last().map_or(self.state.modal.compensation, |block| block.side);
        let side = match self.block.g(Group::CutterCompensation) {
            Some(G::Compensation(side)) => side,
            _ => before,
        };
        let ns = contour.blocks.is_empty();
        let mut words = self.block.clone();
        words.spot.again = false;
        contour.blocks.push(ContourBlock { words, side });
        if let Some(motion) = self.block.g(Group::Motion) {
            self.state.modal.motion = motion;
        }
        if let Some(G::Feed(mode)) = self.block.g(Group::Feed) {
            self.state.modal.feed_mode = mode;
        }
        if self.block.present & MOVES.mask() & !dwell == 0 {
            self.edge_fits(None)?;
            if let Some((word, line)) = contour.edge.filter(|_| !self.block.says_nothing()) {
                return Err(word.alone(line, false, self.alarms()));
            }
            // The manual says so of the roughing cycles.
            return if ns && cycle != 70 && self.block.g(Group::Motion).is_none() {
                Err(self.contour_begins(cycle, t("bloque", "block")))
            } else {
                Ok(())
            };
        }
        let motion = self.state.modal.motion;
        self.take_square_edge(Some(motion))?;
        self.edge_fits(Some(motion))?;
        if first {
            let named = |letters: [usize; 2]| letters.into_iter().any(|letter| self.block.has(letter));
            contour.both_axes = named([letter::X, letter::U]) && named([letter::Z, letter::W]);
        }
        if first && !matches!(self.block.g(Group::Motion), Some(G::Rapid | G::Linear)) {
            return Err(self.contour_begins(cycle, t("movimiento", "motion")));
        }
        let arc = match motion {
            G::Arc(clockwise) => {
                let (centre, to) = self.arc_geometry(clockwise)?;
                self.state.at = to;
                Some(([centre[1], centre[0]], clockwise))
            }
            _ => {
                if let Some(letter) =
                    [letter::I, letter::K, letter::R].into_iter().find(|&letter| self.block.has(letter))
                {
                    return Err(self.unused(1 << letter));
                }
                self.state.at = self.end_point();
                None
            }
        };
        let to = [self.state.at.get(Axis::X), self.state.at.get(Axis::Z)];
        if let Some((word, line)) = contour.edge.take() {
            if motion != G::Linear {
                return Err(word.alone(line, true, self.alarms()));
            }
            contour
                .profile
                .break_edge(to, word.edge(self.state.modal.unit), word.square)
                .map_err(|trouble| word.trouble(line, &trouble, self.alarms()))?;
        }
        contour.edge = self.block.edge.map(|word| (word, self.block.spot.line));
        if let Some(word) = self.block.edge.filter(|word| word.square.is_none()) {
            let spot = self.block.spot;
            self.memory.remarks.row(&CornerInContour {}, spot, Some(word.column));
        }
        contour.profile.elements.push(Element { to, arc, rapid: motion == G::Rapid, line: self.block.spot.line });
        Ok(())
    }

    /// A contour that begins with neither G0 nor G1.
    fn contour_begins(&self, cycle: u8, part: Text) -> Box<Refused> {
        Refused::of(&ContourBegins { part, cycle }, &[]).as_alarm_of(self.alarms())
    }

    /// The letter of the time of a dwell in a contour, one bit; a dwell stands without a motion.
    fn contour_dwell(&self) -> Result<u32> {
        if self.block.g(Group::NonModal) != Some(G::Dwell) {
            return Ok(0);
        }
        let time = 1 << self.dwell_time()?.0.index();
        if self.block.present & MOVES.mask() & !time != 0 {
            return Err(Refused::of(&ContourDwellAndMotion {}, &[self.block.g_column(Group::NonModal)]));
        }
        Ok(time)
    }

    /// Says which words of a contour a roughing cycle passes over, beside F and S.
    pub(super) fn remark_passed_over(&mut self, cycle: u8, contour: &Contour) {
        let other = 1 << Group::Speed as u16 | 1 << Group::Feed as u16 | 1 << Group::NonModal as u16;
        let says = |block: &ContourBlock| {
            block.words.machine_codes > 0 || block.words.groups & other != 0 || block.words.has(letter::T)
        };
        let Some(block) = contour.blocks.iter().find(|block| says(block)) else { return };
        self.memory.remarks.row(&ContourWordsPassedOver { cycle }, block.words.spot, None);
    }

    /// Refuses what may not stand in a contour.
    fn contour_refuses(&self, cycle: u8, first: bool) -> Result<()> {
        let refuse = |column: usize, code: Text| {
            Err(Refused::of(&NotInContour { code, cycle }, &[column]).as_alarm_of(self.alarms()))
        };
        let block = &self.block;
        if let Some((M::Call | M::CallBlock | M::Return, _)) = block.m(4) {
            return refuse(block.m_column(4), t("llamada a un subprograma", "call of a subprogram"));
        }
        if let Some((M::End, _)) = block.m(4) {
            return refuse(block.m_column(4), t("fin del programa", "end of the program"));
        }
        self.turret_place()?;
        if block.has(letter::T) && !first {
            return Err(Refused::of(&ContourToolChange { cycle }, &[block.column(letter::T)]));
        }
        let groups = block.groups & !(1 << Group::Motion as u16) & !(1 << Group::CutterCompensation as u16);
        let odd = match block.g(Group::Motion) {
            None | Some(G::Rapid | G::Linear | G::Arc(_)) => groups,
            Some(_) => groups | 1 << Group::Motion as u16,
        };
        let dwell = block.g(Group::NonModal) == Some(G::Dwell);
        let obeyed = 1 << Group::Speed as u16 | 1 << Group::Feed as u16 | u16::from(dwell) << Group::NonModal as u16;
        if odd & !obeyed != 0 {
            return refuse(block.group_column(odd & !obeyed), t("código G", "G code"));
        }
        let time = if dwell { 1 << self.dwell_time()?.0.index() } else { 0 };
        let idle = block.present & !LETTERS.mask() & !time;
        if idle != 0 { Err(self.unused(idle)) } else { Ok(()) }
    }

    /// Goes on behind a contour that stands behind its cycle; a contour that has been read before stays where it is, as
    /// going on behind it would repeat the program without end.
    pub(super) fn go_behind(&mut self, cycle: u8, contour: &Contour) -> Result<()> {
        if contour.last <= self.block.spot.line {
            return Ok(());
        }
        let first = contour.blocks.first().map_or(contour.last, ContourBlock::line);
        let mut line = Vec::new();
        let mut skipped = 0;
        let mut next = self.memory.flow.next;
        while next.line.lines + 1 < first
            && let Some(behind) = self.memory.library.line(next, &mut line)?
        {
            let comments = self.memory.control.lexis.comments;
            skipped += usize::from(Cursor::new(&line, comments).peek() != 0);
            next = behind;
        }
        if skipped > 0 {
            self.memory.remarks.row(&BlocksBeforeContour { blocks: skipped, cycle }, self.block.spot, None);
        }
        self.go_to(contour.behind);
        Ok(())
    }

    /// Goes on behind the contour of a cycle that was refused, between the blocks with two numbers: its blocks are none of the program's
    /// own motions.
    pub(super) fn pass_over_contour(&mut self, cycle: u8, numbers: [u32; 2]) {
        // Where the blocks are not found there is no contour to pass over.
        let Ok(ends) = self.ends_numbered(cycle, numbers, [0; 2]) else { return };
        let next = self.memory.flow.next;
        let contour = (next.text, ends.first_line());
        if !self.state.modal.refused.contains(&contour) {
            self.state.modal.refused.push(contour);
        }
        if ends.last.line() > next.line.lines {
            let last = LineStart { line: ends.last.at, ..next };
            // A last block that cannot be read is refused where it stands.
            let behind = self.memory.library.line(last, &mut Vec::new());
            self.memory.flow.next = behind.ok().flatten().unwrap_or(last);
        }
    }

    /// Whose alarms the control raises; none where its numbers are not known.
    pub(super) fn alarms(&self) -> Option<AlarmFamily> {
        self.memory.control.alarms
    }

    /// True where the block has an axis word.
    pub(super) fn has_axes(&self) -> bool {
        AXES.into_iter().any(|axis| self.block.has(axis))
    }
}
