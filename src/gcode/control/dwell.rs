//! The time of a dwell, read and written.

use crate::gcode::word::Word;
use crate::number::grid::{Milli, OutOfFormat};

/// An address of G4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DwellWord {
    /// The letter of the word, as P or X.
    pub letter: char,
    /// What its number counts.
    pub unit: DwellUnit,
    /// True where another code of the block may read the same word, as the P of LinuxCNC, which one check of its interpreter
    /// allows where any of the codes that use P stands.
    pub shared: bool,
}

/// What the number of a dwell counts.
///
/// # References
/// Fanuc 15i/150i-MA, programming manual (B-63324EN/03), p. 759, names G4 X and P, and a dwell by revolutions, which no control here
/// has. Fagor 8055 M, programming manual, p. 162 and 177: K of a cycle in hundredths, a whole number; of G4 K itself no page was at
/// hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DwellUnit {
    /// Seconds, with decimals.
    Second,
    /// Hundredths of a second, a whole number.
    Hundredth,
    /// Milliseconds, a whole number.
    Millisecond,
}

impl DwellUnit {
    /// How many seconds one is.
    #[must_use]
    pub const fn seconds(self) -> f64 {
        match self {
            Self::Second => 1.0,
            Self::Hundredth => 0.01,
            Self::Millisecond => 0.001,
        }
    }

    /// True where the number has no decimals: it counts parts of a second.
    #[must_use]
    pub const fn whole(self) -> bool {
        match self {
            Self::Second => false,
            Self::Hundredth | Self::Millisecond => true,
        }
    }
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
        number * self.unit.seconds()
    }

    /// The word of a time in seconds: with three decimals where it counts seconds, else a whole number.
    ///
    /// # Errors
    /// For a time that no program may carry.
    pub fn word(self, seconds: f64) -> Result<Word, OutOfFormat> {
        if !self.unit.whole() {
            return Ok(Word::size(self.letter, Milli::round(seconds)?));
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a delay within a minute")]
        let whole = (seconds / self.unit.seconds()).round() as u32;
        Ok(Word::whole(self.letter, whole))
    }
}
