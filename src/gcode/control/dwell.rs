//! The time of a dwell, read and written.

use crate::gcode::word::Word;
use crate::number::grid::{Milli, OutOfFormat};

/// An address of G4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DwellWord {
    /// The letter of the word, as P or X.
    pub letter: char,
    /// What its number counts, seconds.
    pub unit: f64,
}

/// What G4 without a time is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoneDwell {
    /// Nothing: it is rejected.
    Rejected,
    /// The control stops preparing blocks ahead, cancels the compensation of radius and length that is in force, and does not dwell.
    StopsPreparation,
}

impl LoneDwell {
    /// True where a block of G4 alone runs.
    #[must_use]
    pub const fn runs(self) -> bool {
        match self {
            Self::Rejected => false,
            Self::StopsPreparation => true,
        }
    }
}

impl DwellWord {
    /// The address, counted from A = 0.
    #[must_use]
    pub const fn index(self) -> usize {
        (self.letter as u8 - b'A') as usize
    }

    /// The seconds that the word's number says.
    #[must_use]
    pub fn seconds(self, number: f64) -> f64 {
        number * self.unit
    }

    /// True where the number is the seconds themselves.
    #[must_use]
    pub fn counts_seconds(self) -> bool {
        self.unit == 1.0
    }

    /// The word of a time in seconds: with three decimals where it counts seconds, else a whole number.
    ///
    /// # Errors
    /// For a time that no program may carry.
    pub fn word(self, seconds: f64) -> Result<Word, OutOfFormat> {
        if self.counts_seconds() {
            return Ok(Word::size(self.letter, Milli::round(seconds)?));
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a delay within a minute")]
        let whole = (seconds / self.unit).round() as u32;
        Ok(Word::whole(self.letter, whole))
    }
}
