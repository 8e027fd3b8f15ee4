//! What F means: how it is read, and how it is written.

use crate::gcode::feed_word::FeedWord;
use crate::limits::{FEED_WORD, INVERSE_TIME_WORD};
use crate::machine::length_unit::LengthUnit;

/// How the control takes the F word of a move that linear and rotary axes make together. In each form the move takes
/// the time that the tool tip needs over the part at the wanted feed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedLaw {
    /// G94: F along the resultant of all axes, degrees taken as millimetres.
    Resultant,
    /// G93: F is the time of the move in seconds.
    Seconds,
    /// G93: F is the inverse of the time of the move in minutes.
    InverseTime,
}

impl FeedLaw {
    /// True where F is not modal: it belongs to its own move.
    #[must_use]
    pub const fn in_every_block(self) -> bool {
        match self {
            Self::Resultant => false,
            Self::Seconds | Self::InverseTime => true,
        }
    }

    /// True where a move writes its F behind one that wrote another, or none.
    #[must_use]
    pub fn is_written(self, last: Option<FeedWord>, word: FeedWord) -> bool {
        self.in_every_block() || last != Some(word)
    }

    /// The G codes before and behind moves that it holds for; `None` where it is that of every feed.
    #[must_use]
    pub const fn codes(self) -> Option<[u32; 2]> {
        match self {
            Self::Resultant => None,
            Self::Seconds | Self::InverseTime => Some([93, 94]),
        }
    }

    /// The F word of a move that is to take some seconds, whose resultant over all axes (mm and degrees) is given.
    #[must_use]
    pub fn word(self, seconds: f64, resultant: f64) -> f64 {
        match self {
            Self::Resultant => resultant * 60.0 / seconds,
            Self::Seconds => seconds,
            Self::InverseTime => 60.0 / seconds,
        }
    }

    /// The greatest F word.
    #[must_use]
    pub const fn greatest(self) -> f64 {
        match self {
            Self::Resultant | Self::Seconds => FEED_WORD,
            Self::InverseTime => INVERSE_TIME_WORD,
        }
    }

    /// To which side its numbers grow slower.
    #[must_use]
    pub const fn slower(self) -> Slower {
        match self {
            Self::Resultant | Self::InverseTime => Slower::Less,
            Self::Seconds => Slower::More,
        }
    }

    /// The F word of the fastest move.
    #[must_use]
    pub const fn fastest(self) -> f64 {
        match self {
            Self::Resultant | Self::InverseTime => self.greatest(),
            Self::Seconds => 1e-4,
        }
    }

    /// The least time in seconds for which there is an F word.
    #[must_use]
    pub fn least_seconds(self, resultant: f64) -> f64 {
        self.seconds(self.fastest(), resultant)
    }

    /// The time in seconds that a move takes with an F word.
    #[must_use]
    pub fn seconds(self, word: f64, resultant: f64) -> f64 {
        match self {
            Self::Resultant => resultant * 60.0 / word,
            Self::Seconds => word,
            Self::InverseTime => 60.0 / word,
        }
    }
}

/// Which number of an F word makes a move slower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slower {
    /// A greater one.
    More,
    /// A lesser one.
    Less,
}

impl Slower {
    /// The number of a move without end, which no word has.
    #[must_use]
    pub const fn endless(self) -> f64 {
        match self {
            Self::More => f64::INFINITY,
            Self::Less => 0.0,
        }
    }

    /// Of two numbers that of the slower move.
    #[must_use]
    pub const fn of(self, one: f64, other: f64) -> f64 {
        match self {
            Self::More => one.max(other),
            Self::Less => one.min(other),
        }
    }

    /// A whole number, no faster.
    #[must_use]
    pub fn whole(self, number: f64) -> f64 {
        match self {
            Self::More => number.ceil(),
            Self::Less => number.floor(),
        }
    }

    /// How far a number lies on the slower side of another.
    #[must_use]
    pub const fn by(self, number: f64, than: f64) -> f64 {
        match self {
            Self::More => number - than,
            Self::Less => than - number,
        }
    }
}

/// What a feed move without any F is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MissingFeed {
    /// An error; so is a feed per revolution of a spindle without speed.
    Refused,
    /// The control takes the F that it has: a Caution.
    Cautioned,
}

impl MissingFeed {
    /// True where the control refuses it.
    #[must_use]
    pub const fn refused(self) -> bool {
        match self {
            Self::Refused => true,
            Self::Cautioned => false,
        }
    }
}

/// What is left of F where a code changes what F means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedChange {
    /// Nothing.
    Forgets,
    /// Its number.
    Keeps,
    /// Its number; moving with it gets a Caution.
    KeepsStale,
}

/// Which axes F belongs to in a feed per minute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedPath {
    /// All that move.
    AllAxes,
    /// X, Y and Z; where they stand still U, V and W; else the rotary axes.
    LinearFirst,
}

impl FeedPath {
    /// The length that F is counted along, of a straight way by X, Y, Z, A, B, C, U, V and W, mm and degrees; a degree alone counts as
    /// one unit of length.
    #[must_use]
    pub fn length(self, by: &[f64; 9], unit: LengthUnit) -> f64 {
        let norm = |axes: &[usize]| axes.iter().map(|&axis| by[axis] * by[axis]).sum::<f64>().sqrt();
        match self {
            Self::AllAxes => norm(&[0, 1, 2, 3, 4, 5, 6, 7, 8]),
            Self::LinearFirst => {
                let (first, second) = (norm(&[0, 1, 2]), norm(&[6, 7, 8]));
                if first > 0.0 {
                    first
                } else if second > 0.0 {
                    second
                } else {
                    // Degrees per minute, which no unit of length scales.
                    norm(&[3, 4, 5]) * unit.millimetres()
                }
            }
        }
    }
}

/// The G codes of F.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedCodes {
    /// G93, G94, G95.
    G94,
    /// G98 and G99.
    G98,
}

impl FeedCodes {
    /// The codes of a feed per minute, per revolution, and of the two times of G93.
    #[must_use]
    pub const fn names(self) -> [&'static str; 4] {
        match self {
            Self::G94 => ["G94", "G95", "G93", "G93"],
            Self::G98 => ["G98", "G99", "G98", "G98"],
        }
    }
}

/// How F is read.
#[derive(Clone, Copy, Debug)]
pub struct FeedRule {
    /// In a move that linear and rotary axes make together.
    pub law: FeedLaw,
    /// Its codes.
    pub codes: FeedCodes,
    /// Without it.
    pub missing: MissingFeed,
    /// Where a code changes its meaning.
    pub change: FeedChange,
    /// The axes that it belongs to.
    pub path: FeedPath,
}
