//! What a plan says of the part that it cuts.
//!
//! # Units
//! Millimetres and radians.

use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::floor_rest::FloorRest;
use crate::kinds::impeller::clear::pass::Cutting;
use crate::kinds::impeller::clear::root::Root;
use crate::kinds::impeller::part::Face;

/// A stretch of a pass that is not run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dropped {
    /// Of which pass.
    pub cutting: Cutting,
    /// Its tool.
    pub tool: Which,
    /// From where to where, v.
    pub v: [f64; 2],
    /// What stands in the way.
    pub by: By,
}

/// Why a pose is not run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The splitter, or its neighbour where the splitter's own pass is meant.
    Splitter,
    /// The blade on the other side of the channel, or the floor of a tube that is too narrow.
    Blade,
    /// Nothing, but neither from the hub nor from the rim does a clear way lead to it.
    Ends,
}

/// What the flank passes leave of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceError {
    /// Which face.
    pub face: Face,
    /// How much is left of it at most; nothing is cut into it by the poses themselves.
    pub rest: f64,
    /// v where that is.
    pub v: f64,
    /// |E| of the fit at most, before it is lifted and faded.
    pub fit: f64,
    /// In how many depths it is cut.
    pub levels: u32,
}

/// A tool of the plan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolTold {
    /// t*, how deep below the tops the tip stands on a lane at full depth.
    pub t: f64,
    /// How many lanes there are.
    pub lanes: u32,
    /// In how many levels.
    pub levels: u32,
    /// The stick-out that is enough for any holder, with d_s.
    pub stick_out: f64,
    /// The largest part by which the tip's feed changes within a block.
    pub feed_error: f64,
}

/// Nowhere is there room for splitters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoSplitter {
    /// The largest finishing tool of its kind for which there is, in whole hundredths; `None` where none is found.
    pub largest: Option<f64>,
}

impl PlanResults {
    /// What is said of one of the tools.
    #[must_use]
    pub const fn tool(&self, which: Which) -> &ToolTold {
        match which {
            Which::Rough => &self.rough,
            Which::Finish => &self.finish,
        }
    }
}

/// Faces that the end of the finishing tool leaves unfinished up to the turned surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unfinished {
    /// v of the line on which it was found, radians.
    pub v: f64,
    /// The most that is left of any face, from the nearest pose, mm.
    pub left: f64,
}

/// What a plan says.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanResults {
    /// The true gap at full depth: the largest tool that passes.
    pub gap: f64,
    /// The roughing tool.
    pub rough: ToolTold,
    /// The finishing tool.
    pub finish: ToolTold,
    /// The ridges between floor lanes at most.
    pub scallop: f64,
    /// What the floor lanes leave, farther from the walls than 0.4 mm.
    pub floor: FloorRest,
    /// What is left in the corner of face and floor.
    pub root: Root,
    /// Where the end of the finishing tool leaves a face that it runs along unfinished up to the tops.
    pub unfinished: Option<Unfinished>,
    /// What the flank passes leave of obverse and reverse.
    pub faces: [FaceError; 2],
    /// v from which on splitters stand; `None` without them.
    pub splitter_from: Option<f64>,
    /// Splitters are wanted, but nowhere is there room for them.
    pub no_splitter: Option<NoSplitter>,
    /// The station from which on the roughing tool cuts; 0 where it does all the way.
    pub rough_from: f64,
    /// The station from which on the finishing tool does.
    pub finish_from: f64,
    /// How much a roughing tool with a rounded end leaves of the faces at the floor at most, and how much a flat one led the same way
    /// would, mm; 0 of a flat end.
    pub rough_foot: [f64; 2],
    /// The share of the turned surface of the channels, from 0 to 1, that no pass reaches; looked at where the finishing tool does not fit
    /// all the way, or leaves a face unfinished; else 0.
    pub uncut: f64,
    /// What is not run of the passes, and no other pass takes or tells of.
    pub dropped: Vec<Dropped>,
}
