//! What the F word of a move that linear and rotary axes make together is.

#![deny(clippy::wildcard_enum_match_arm)]

use crate::limits::{FEED_WORD, INVERSE_TIME_WORD};

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

    /// The G code before moves that it holds for; `None` where it is that of every feed.
    #[must_use]
    pub const fn code(self) -> Option<u32> {
        match self {
            Self::Resultant => None,
            Self::Seconds | Self::InverseTime => Some(93),
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

    /// The greatest number that an F word may have; where it is a time, that of the slowest move.
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
    /// A greater number: it is a time.
    More,
    /// A lesser number: it is a speed, or the inverse of a time.
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
