//! What F means: how it is read, and how it is written.

use crate::gcode::feed_law::FeedLaw;
use crate::machine::length_unit::LengthUnit;

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
    /// Nothing: F must be given again.
    Forgets,
    /// Its number; moving with it gets a Caution.
    KeepsStale,
}

/// What is made of a program that moves at feed before a code has said what F means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnsaidFeed {
    /// F is taken as at the start of the control.
    Taken,
    /// The same, and it is told: the machine may be set to the other meaning, and both are usual.
    Told,
}

impl UnsaidFeed {
    /// True where it is told.
    #[must_use]
    pub const fn told_of(self) -> bool {
        match self {
            Self::Taken => false,
            Self::Told => true,
        }
    }
}

/// Which axes F belongs to in a feed per minute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedPath {
    /// All that move, rotary ones too.
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
    /// G94 a minute, G95 a revolution, G93 the time of the move or its inverse.
    G94,
    /// G98 a minute, G99 a revolution.
    G98,
}

impl FeedCodes {
    /// The number of the code of a feed per minute.
    #[must_use]
    pub const fn per_minute(self) -> u32 {
        match self {
            Self::G94 => 94,
            Self::G98 => 98,
        }
    }

    /// The codes of a feed per minute, per revolution, and of the two times of G93.
    #[must_use]
    pub const fn names(self) -> [&'static str; 4] {
        match self {
            Self::G94 => ["G94", "G95", "G93", "G93"],
            Self::G98 => ["G98", "G99", "G98", "G98"],
        }
    }
}

/// The greatest F that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedLimit {
    /// 99 999.999, as a coordinate; an inverse time may be greater.
    Format,
    /// What a number holds: the control sets no limit.
    Number,
}

impl FeedLimit {
    /// True where F is refused beyond what a coordinate may be.
    #[must_use]
    pub const fn as_coordinate(self) -> bool {
        match self {
            Self::Format => true,
            Self::Number => false,
        }
    }
}

/// How F is read.
#[derive(Clone, Copy, Debug)]
pub struct FeedRule {
    /// In a move that linear and rotary axes make together.
    pub law: FeedLaw,
    /// The codes that say what F means.
    pub codes: FeedCodes,
    /// What a move at feed is to which no F was given.
    pub missing: MissingFeed,
    /// Where a code changes its meaning.
    pub change: FeedChange,
    /// The axes that it belongs to.
    pub path: FeedPath,
    /// Before a code has said what it means.
    pub unsaid: UnsaidFeed,
    /// The greatest number.
    pub limit: FeedLimit,
}
