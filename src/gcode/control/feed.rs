//! What F means where linear and rotary axes move together: how it is read, and how it is written.

use crate::limits::FEED_WORD;

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
        !matches!(self, Self::Resultant)
    }

    /// The G code that selects it.
    #[must_use]
    pub const fn code(self) -> u32 {
        match self {
            Self::Resultant => 94,
            Self::Seconds | Self::InverseTime => 93,
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

    /// The least time in seconds for which there is an F word.
    #[must_use]
    pub fn least_seconds(self, resultant: f64) -> f64 {
        match self {
            Self::Resultant => resultant * 60.0 / FEED_WORD,
            Self::Seconds => 1e-4,
            Self::InverseTime => 60.0 / FEED_WORD,
        }
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
