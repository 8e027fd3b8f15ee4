//! Corners, radius compensation, drilling.

use crate::gcode::code::Cycle;
use crate::gcode::letters::Letters;

/// How corners between two lines are broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corners {
    /// Not by words of the line.
    None,
    /// As on a drawing: `,C` and `,R`, or I, K and R of a line along an axis.
    Drawing,
}

impl Corners {
    /// True where words of a line break its corner.
    #[must_use]
    pub const fn by_words(self) -> bool {
        match self {
            Self::None => false,
            Self::Drawing => true,
        }
    }
}

/// How an outer corner is gone round under nose compensation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoseCorner {
    /// Straight, whatever its angle.
    Straight,
    /// Straight up to a turn of 120°, else round.
    StraightTo120,
}

/// Whose radius G41 and G42 keep off the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RadiusRule {
    /// Nothing's: G41 and G42 are refused.
    None,
    /// The cutter's, its diameter from the table or the block.
    Cutter,
    /// The nose's of a turning tool.
    Nose(NoseCorner),
}

impl RadiusRule {
    /// True for the cutter of a mill.
    #[must_use]
    pub const fn cutter(self) -> bool {
        match self {
            Self::Cutter => true,
            Self::None | Self::Nose(_) => false,
        }
    }

    /// How many blocks the control sees beside the one that it makes under nose compensation, where a manual says so: Fanuc 16i,
    /// operator's manual for lathes, B-62754EN page 225.
    #[must_use]
    pub const fn sees(self) -> Option<u32> {
        match self {
            Self::Nose(NoseCorner::Straight) => Some(2),
            Self::Nose(NoseCorner::StraightTo120) | Self::Cutter | Self::None => None,
        }
    }
}

/// How holes are drilled by cycles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drilling {
    /// By no cycle that rodete follows.
    None,
    /// Along the axis across the plane, with R and L.
    Rs274,
    /// Along Z or X of a lathe, with R.
    Lathe,
}

impl Drilling {
    /// The letters that a cycle uses beside the axes.
    #[must_use]
    pub const fn letters(self, cycle: Cycle) -> Letters {
        match (self, cycle) {
            (Self::None, _) => Letters::of(""),
            (Self::Lathe, Cycle::Peck) => Letters::of("RPQ"),
            (Self::Lathe, Cycle::DrillDwell) => Letters::of("RP"),
            (Self::Lathe, _) => Letters::of("R"),
            (Self::Rs274, Cycle::ChipBreak | Cycle::Peck) => Letters::of("RLQ"),
            (
                Self::Rs274,
                Cycle::TapLeft
                | Cycle::TapRight
                | Cycle::DrillDwell
                | Cycle::BoreStop
                | Cycle::BoreManual
                | Cycle::BoreDwell,
            ) => Letters::of("RLP"),
            (Self::Rs274, Cycle::BackBore) => Letters::of("RLIJK"),
            (Self::Rs274, Cycle::Drill | Cycle::Bore) => Letters::of("RL"),
        }
    }
}

/// Where canned cycles return to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Retract {
    /// The height that they started from.
    Initial,
    /// R.
    R,
}

impl Retract {
    /// True for the height that they started from.
    #[must_use]
    pub const fn initial(self) -> bool {
        match self {
            Self::Initial => true,
            Self::R => false,
        }
    }
}
