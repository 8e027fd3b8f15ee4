//! A pass of the plan: what it is, with which tool, which way, and where the axes stand.

use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::part::Face;

/// The feed into the full metal, as a part of F: both sides of the tool cut there, its teeth are in metal over half a turn, and the
/// chips have no open side to leave by.
pub const SLOT_FEED: f64 = 0.5;

/// What a pass cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cutting {
    /// A lane of a roughing level.
    Rough {
        /// Which level, from 0 at the top.
        level: u32,
        /// Which lane, from 0 at the obverse.
        lane: u32,
    },
    /// Round the splitter at a roughing level.
    RoughContour {
        /// Which level, from 0 at the top.
        level: u32,
    },
    /// A lane of a level that the finishing tool roughs where the roughing tool has no room beside a splitter.
    Rest {
        /// Which level, from 0 at the top.
        level: u32,
        /// Which lane, from 0 at the obverse.
        lane: u32,
    },
    /// Round the splitter at such a level.
    RestContour {
        /// Which level, from 0 at the top.
        level: u32,
    },
    /// A lane of the floor.
    Floor {
        /// Which lane, from 0 at the obverse.
        lane: u32,
    },
    /// A lane of the floor, the tool leaning off a wall.
    Leaning {
        /// The face off which it leans.
        face: Face,
    },
    /// A flank of a blade: the obverse of this channel's blade, or the reverse of the next one.
    Flank {
        /// The face that is cut.
        face: Face,
        /// Which depth, from 0 at the top.
        level: u32,
    },
    /// Round the splitter at full depth.
    Contour,
    /// The flanks of the splitter and its nose.
    SplitterFlanks {
        /// Which depth, from 0 at the top.
        level: u32,
    },
}

impl Cutting {
    /// True of what roughs, with either tool.
    #[must_use]
    pub const fn is_roughing(self) -> bool {
        match self {
            Self::Rough { .. } | Self::RoughContour { .. } | Self::Rest { .. } | Self::RestContour { .. } => true,
            Self::Floor { .. }
            | Self::Leaning { .. }
            | Self::Flank { .. }
            | Self::Contour
            | Self::SplitterFlanks { .. } => false,
        }
    }
}

/// Which way a pass goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From the hub to the rim.
    Outwards,
    /// From the rim to the hub.
    Inwards,
    /// In along the obverse of a splitter and out along its reverse.
    Round,
}

impl Direction {
    /// The other way.
    #[must_use]
    pub const fn back(self) -> Self {
        match self {
            Self::Outwards => Self::Inwards,
            Self::Inwards => Self::Outwards,
            Self::Round => Self::Round,
        }
    }
}

/// How the teeth meet the metal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// The metal is on the side on which the teeth go against the feed: the chip begins thick.
    Climb,
    /// It is on the other side.
    Conventional,
    /// Metal on both sides.
    Slot,
}

/// One move of all axes, from where they stand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// At rapid; else at the feed of the pass.
    pub rapid: bool,
    /// Where the axes stand at its end.
    pub to: Stand,
}

/// A pass: the way in, the cut and the way out, as the axes stand.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// What it cuts.
    pub cutting: Cutting,
    /// The tool that it is cut with.
    pub tool: Which,
    /// The way that it is run in the channel.
    pub direction: Direction,
    /// How the teeth meet the metal on that way.
    pub mode: Mode,
    /// The part of the feed that it may be run at.
    pub feed: f64,
    /// From the end of the pass before it, or from above the part, to its first point, without cutting; the last move ends
    /// at that point.
    pub approach: Vec<Move>,
    /// Where the axes stand at its first point and at the end of each block that cuts.
    pub points: Vec<Stand>,
    /// Back out along the same points where it ends inside the part; up to above the part where a tool is done.
    pub leave: Vec<Move>,
}

impl Pass {
    /// How many blocks it takes.
    #[must_use]
    pub fn blocks(&self) -> usize {
        // The approach ends at the first point.
        self.approach.len() + self.points.len().saturating_sub(1) + self.leave.len()
    }

    /// All stands of the pass in order, links and all.
    pub fn stands(&self) -> impl Iterator<Item = Stand> {
        let approach = self.approach.iter().map(|one| one.to);
        approach.chain(self.points.iter().skip(1).copied()).chain(self.leave.iter().map(|one| one.to))
    }
}
