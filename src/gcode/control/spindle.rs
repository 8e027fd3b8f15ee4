//! What S means, what the spindle turns, and at which of its angles a thread begins.

use crate::gcode::letters::Letters;

/// Which code says the greatest speed under constant surface speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpeedLimit {
    /// G96 itself, by D.
    Word,
    /// G50 or G92 with S alone.
    Code,
}

/// What the spindle turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turns {
    /// The tool: its speed is that of S, and G96 wants S beside it.
    Tool,
    /// The part: the speed follows X under G96, whose S may come later and is feet a minute where the unit is the inch; G97
    /// alone keeps the speed that the spindle has.
    Part,
}

impl Turns {
    /// True where the part turns.
    #[must_use]
    pub const fn part(self) -> bool {
        match self {
            Self::Tool => false,
            Self::Part => true,
        }
    }
}

/// What the Q of a thread counts: the spindle's angle at which a pass begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreadAngle {
    /// No thread has one.
    None,
    /// Thousandths of a degree.
    Thousandth,
}

impl ThreadAngle {
    /// The letter of a block that says it.
    #[must_use]
    pub const fn letters(self) -> Letters {
        match self {
            Self::None => Letters::of(""),
            Self::Thousandth => Letters::of("Q"),
        }
    }

    /// How many are a degree; `None` where no thread has a Q.
    #[must_use]
    pub const fn per_degree(self) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Thousandth => Some(1000.0),
        }
    }
}

/// What S means on the control, and where threads begin.
#[derive(Clone, Copy, Debug)]
pub struct SpindleRule {
    /// What it turns.
    pub turns: Turns,
    /// Which code says its greatest speed.
    pub limit: SpeedLimit,
    /// What the Q of a thread counts.
    pub thread_angle: ThreadAngle,
}
