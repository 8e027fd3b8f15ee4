//! Turning cycles whose letters are all their own: from words to the parameters of the pure cycles.
//!
//! # References
//! Fagor Automation, CNC 8055 T programming manual, G81 to G89: X, Z, Q and R are absolute coordinates, X and Q (of G82, G85,
//! G87 and G89 too) as the axis is programmed, on the diameter; all distances on the radius; K of G83, G88 and G89 in
//! hundredths of a second. The cycles are not modal, and F in their blocks is theirs alone.

use crate::gcode::code::{Group, LetterCycle};
use crate::gcode::interpreter::Reader;
use crate::gcode::interpreter::block::letter;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::rules::words::DwellNotWhole;
use crate::gcode::turning::Move;
use crate::gcode::turning::fagor::Along;
use crate::gcode::turning::fagor::drill::{Drill, drill};
use crate::gcode::turning::fagor::groove::{Groove, groove};
use crate::gcode::turning::fagor::section::{Section, section};
use crate::gcode::turning::fagor::thread::{Threading, thread};
use crate::gcode::turning::rules::{
    FagorGroovePoint, FagorGrooveStepMissing, FagorLetterMissing, FagorLetterNotSupported, FagorTapping, FagorTaps,
};
use crate::machine::axis::Axis;
use crate::text::{Text, t};

/// The angle of a thread's flank where A does not give it, degrees.
const FLANK: f64 = 30.0;

/// The words of diameters of a cycle with one point, and of one with two.
const FIRST: &[usize] = &[letter::X];
const BOTH: &[usize] = &[letter::X, letter::Q];

impl Reader<'_, '_> {
    /// A cycle of the block in hand.
    pub(super) fn letter_cycle(&mut self, cycle: LetterCycle) -> Result<()> {
        self.letters_of_cycle(cycle)?;
        let (moves, points) = match cycle {
            LetterCycle::Straight(along) => (self.section(along, None)?, BOTH),
            LetterCycle::Curved(along) => {
                let centre = [self.length(letter::I), self.length(letter::K)];
                (self.section(along, Some(centre))?, BOTH)
            }
            LetterCycle::Drilling => (self.drilling_in_axis(cycle)?, FIRST),
            LetterCycle::Thread(along) => (self.thread_of_letters(along)?, BOTH),
            LetterCycle::Groove(along) => (self.groove_of_letters(cycle, along)?, BOTH),
        };
        self.remark_points(points);
        // F of the block is not the feed of the passes.
        self.block.take(letter::F);
        let feed = self.feed_of(&moves)?;
        self.make_moves(moves, feed);
        Ok(())
    }

    /// Refuses a cycle that lacks a word, or has one that is not followed.
    fn letters_of_cycle(&self, cycle: LetterCycle) -> Result<()> {
        let (number, needed, may) = (cycle.number(), cycle.needed(), cycle.optional());
        let name = |index: u8| char::from(b'A' + index);
        for index in 0..26_u8 {
            let at = usize::from(index);
            if needed.has(index) && !self.block.has(at) {
                let (letter, at) = (name(index), [self.block.g_column(Group::NonModal)]);
                return Err(if matches!(cycle, LetterCycle::Groove(_)) && letter == 'C' {
                    Refused::of(&FagorGrooveStepMissing { number }, &at)
                } else {
                    Refused::of(&FagorLetterMissing { letter, number }, &at)
                });
            }
            let parameter = LetterCycle::LETTERS.has(index);
            if parameter && self.block.has(at) && !needed.has(index) && !may.has(index) {
                let letter = name(index);
                return Err(Refused::of(&FagorLetterNotSupported { letter, number }, &[self.block.column(at)]));
            }
        }
        Ok(())
    }

    /// A length of the block, mm; 0 where it is not given.
    fn length(&self, letter: usize) -> f64 {
        self.length_given(letter).unwrap_or(0.0)
    }

    fn length_given(&self, letter: usize) -> Option<f64> {
        self.block.get(letter).map(|word| self.state.modal.unit.to_mm(word))
    }

    /// The initial point (X, Z), X the radius.
    fn initial(&self) -> [f64; 2] {
        [Axis::X, Axis::Z].map(|axis| self.axis_word(axis).unwrap_or(0.0))
    }

    /// The final point (Q, R), Q a diameter as X is.
    fn last_point(&self) -> [f64; 2] {
        let Q = self.length(letter::Q);
        [self.memory.control.axes.x.coordinate(Q), self.length(letter::R)]
    }

    /// K, the dwell of a cycle, s.
    fn dwell_of_cycle(&self, cycle: LetterCycle) -> Result<f64> {
        let (K, unit) = (self.block.get(letter::K).unwrap_or(0.0), self.memory.control.lexis.cycle_dwell);
        if K.fract() == 0.0 || !unit.whole() {
            return Ok(K * unit.seconds());
        }
        let row = DwellNotWhole { letter: 'K', value: K, unit: unit.seconds(), number: cycle.number() };
        Err(Refused::of(&row, &[self.block.column(letter::K)]))
    }

    /// X and Q, the diameters of the points, beyond the axis: the cycle goes there as a motion does.
    fn remark_points(&mut self, words: &[usize]) {
        for &word in words {
            let radius = self.memory.control.axes.x.coordinate(self.length(word));
            if radius < 0.0 {
                self.remark_word_beyond_axis(radius, word);
            }
        }
    }

    /// G81, G82 and, with the centre of the arc, G84, G85.
    fn section(&self, along: Along, centre: Option<[f64; 2]>) -> Result<Vec<Move>> {
        let parameters = Section {
            from: self.initial(),
            to: self.last_point(),
            centre,
            step: self.length(letter::C),
            back: self.length_given(letter::D),
            stock: [self.length(letter::L), self.length(letter::M)],
            roughing: self.length_given(letter::F),
            finishing: self.length_given(letter::H),
        };
        self.told(section(self.here(), along, &parameters))
    }

    /// G83: drilling, or tapping with B0, which is told; refused where the words of a tapping mean something else.
    fn drilling_in_axis(&mut self, cycle: LetterCycle) -> Result<Vec<Move>> {
        let step = self.length(letter::B);
        if step == 0.0 {
            // Written with 0, as the examples of the control do, they say nothing. C is a distance of pecking alone.
            let says = |word: usize| self.block.has(word) && (word == letter::R || self.length(word) != 0.0);
            if let Some(word) = [letter::H, letter::L, letter::R].into_iter().find(|&word| says(word)) {
                let name = char::from(b'A' + u8::try_from(word).unwrap_or(0));
                return Err(Refused::of(&FagorTapping { letter: name }, &[self.block.column(word)]));
            }
            let with = match self.state.modal.tool {
                0 => t("", ""),
                tool => Text::new(format!(", con T{tool}"), format!(", with T{tool}")),
            };
            let (spot, column) = (self.block.spot, self.block.column(letter::B));
            self.memory.remarks.row(&FagorTaps { with }, spot, Some(column));
        }
        let parameters = Drill {
            at: self.initial(),
            depth: self.length(letter::I),
            step,
            safety: self.length(letter::D),
            dwell: self.dwell_of_cycle(cycle)?,
            back: self.length_given(letter::H),
            near: self.length_given(letter::C),
            least: self.length(letter::L),
            factor: self.block.get(letter::R).unwrap_or(1.0),
        };
        self.told(drill(self.here(), &parameters))
    }

    /// G86, G87.
    fn thread_of_letters(&self, along: Along) -> Result<Vec<Move>> {
        let parameters = Threading {
            from: self.initial(),
            to: self.last_point(),
            depth: self.length(letter::I),
            step: self.length(letter::B),
            least: self.length(letter::E),
            safety: self.length(letter::D),
            finishing: self.length(letter::L),
            lead: self.length(letter::C),
            exit: self.length(letter::J),
            angle: self.block.get(letter::A).unwrap_or(FLANK),
        };
        self.told(thread(self.here(), along, &parameters))
    }

    /// G88, G89.
    fn groove_of_letters(&mut self, cycle: LetterCycle, along: Along) -> Result<Vec<Move>> {
        let number = cycle.number();
        let parameters = Groove {
            from: self.initial(),
            to: self.last_point(),
            step: self.length(letter::C),
            safety: self.length(letter::D),
            dwell: self.dwell_of_cycle(cycle)?,
        };
        let moves = self.told(groove(self.here(), along, &parameters))?;
        self.remark_step(number, parameters.spacing(along));
        let (spot, column) = (self.block.spot, self.block.g_column(Group::NonModal));
        self.memory.remarks.row(&FagorGroovePoint { number }, spot, Some(column));
        Ok(moves)
    }
}
