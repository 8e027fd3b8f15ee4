//! What a plan is asked for, and when it cannot be made.
//!
//! # Units
//! Millimetres.

use crate::kinds::impeller::clear::holder::Stage;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::part::Part;
use crate::machine::rotary::TiltingTable;
use crate::machine::travel::Travel;

/// The part and the machine it is cut on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Job {
    /// What one blade is.
    pub part: Part,
    /// N, the number of blades.
    pub N: u32,
    /// The rotary axes.
    pub machine: TiltingTable,
}

/// Which of the two tools.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The one that takes the metal out of the channels.
    Rough,
    /// The one that cuts floor and flanks.
    Finish,
}

/// Which way the spindle turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spindle {
    /// M3, clockwise seen from above.
    Clockwise,
    /// M4, counter-clockwise seen from above.
    Counterclockwise,
}

/// The machining strategy: how the part is cut.
#[derive(Clone, Debug, PartialEq)]
pub struct CutStrategy {
    /// The roughing tool. Its diameter is d_t.
    pub rough: Tool,
    /// The finishing tool; the same as the roughing one where the workbook gives no other.
    pub finish: Tool,
    /// s, what roughing leaves on walls and floor.
    pub s: f64,
    /// a_k, the most that a roughing level takes; half the tool's diameter where it is not given.
    pub level: Option<f64>,
    /// κ, the part of its diameter by which the roughing tool steps sideways.
    pub step: f64,
    /// c, the ridges that floor lanes may leave.
    pub scallop: f64,
    /// ε, how far blocks may leave the way.
    pub tolerance: f64,
    /// δ, the part by which the tip's feed may change within a block; not looked at where it is not given.
    pub feed: Option<f64>,
    /// d_s, how far the tool runs clear of the blank.
    pub d_s: f64,
    /// L_b, how long the turned blank is.
    pub blank: f64,
    /// Which way the spindle turns.
    pub spindle: Spindle,
    /// A tool that does not fit all the way to the hub cuts as far as it fits.
    pub partly: bool,
    /// The part has splitters, one between two blades.
    pub splitters: bool,
    /// v_s where the splitters are to begin; at the earliest where the finishing tool
    /// has room where it is not given.
    pub splitter_from: Option<f64>,
    /// The holders behind the roughing and the finishing tool, where they are known.
    pub stages: [Option<Stage>; 2],
    /// How far B may go, degrees: a pass that leans to leave less leans no farther.
    pub tilt: Travel,
}

impl CutStrategy {
    /// The usual cut with two flat end mills.
    #[must_use]
    pub const fn usual(rough: f64, finish: f64) -> Self {
        Self {
            rough: Tool::flat(rough),
            finish: Tool::flat(finish),
            s: 0.3,
            level: None,
            step: 0.7,
            scallop: 0.02,
            tolerance: 0.01,
            feed: None,
            d_s: 5.0,
            blank: 40.0,
            spindle: Spindle::Clockwise,
            partly: false,
            splitters: false,
            splitter_from: None,
            stages: [None; 2],
            tilt: [None; 2],
        }
    }

    /// The roughing or the finishing tool.
    #[must_use]
    pub const fn tool(&self, which: Which) -> Tool {
        match which {
            Which::Rough => self.rough,
            Which::Finish => self.finish,
        }
    }

    /// The holder behind a tool.
    #[must_use]
    pub const fn stage(&self, which: Which) -> Option<Stage> {
        match which {
            Which::Rough => self.stages[0],
            Which::Finish => self.stages[1],
        }
    }

    /// What a tool leaves on the walls.
    #[must_use]
    pub const fn allowance(&self, which: Which) -> f64 {
        match which {
            Which::Rough => self.s,
            Which::Finish => 0.0,
        }
    }

    /// M: how far out of the blank a lane begins and ends.
    #[must_use]
    pub const fn run_out(&self, which: Which) -> f64 {
        self.tool(which).a() + self.d_s
    }
}

/// A tool that does not pass between the blades.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the tool of diameter {d} mm does not fit; {largest:?} mm does")]
pub struct DoesNotFit {
    /// The roughing or the finishing tool.
    pub tool: Which,
    /// Its diameter, mm.
    pub d: f64,
    /// The largest diameter that fits, with its allowance, in whole hundredths of a millimetre; `None` where none does.
    pub largest: Option<f64>,
    /// The station from which on this one fits all the way to the rim; `None` where not even there.
    pub from: Option<f64>,
    /// The share of the channels that its upright lanes would leave uncut even without an allowance, from 0 to 1; `None` where it would pass then.
    pub uncut: Option<f64>,
}
