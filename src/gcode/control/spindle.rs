//! What S means, and when the spindle turns.

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

/// What S means on the control.
#[derive(Clone, Copy, Debug)]
pub struct SpindleRule {
    /// What it turns.
    pub turns: Turns,
    /// Which code says its greatest speed.
    pub limit: SpeedLimit,
}
