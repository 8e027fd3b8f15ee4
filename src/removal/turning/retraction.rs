//! What a tool meets of metal as it leaves its work in rapid.
//!
//! # Units
//! Millimetres, `[z, r]`.

use super::alarm::{Cause, SCRAPE, TOUCH};
use super::engagement::near;
use super::outline::side_relief;
use super::path::Piece;
use super::tool::{Cutter, TurningTool};
use super::workpiece::section;
use crate::gcode::in_force::InForce;
use crate::geometry::exact::meeting::Meeting;

/// The metal that a rapid motion meets.
#[derive(Clone, Copy, Debug)]
pub struct Scraped {
    /// The section of all of it, mm².
    section: f64,
    /// How deep it is at most.
    pub deep: f64,
    /// Where it is the deepest, `[z, r]`.
    pub place: [f64; 2],
}

impl Scraped {
    /// Takes one more meeting in, so deep at a place.
    pub fn take(scraped: &mut Option<Self>, meeting: &Meeting, deep: f64, place: [f64; 2]) {
        let of = scraped.get_or_insert(Self { section: 0.0, deep, place });
        of.section += section(meeting).abs();
        if deep > of.deep {
            *of = Self { deep, place, ..*of };
        }
    }

    /// What it is to be called. Only the inclined edge of an insert that leaves its work has left a wedge, no longer than the edge is and
    /// half as thick in the mean as at most: see [`SCRAPE`]. A blade that turned sideways leaves one, too: that is a stop
    /// as any other metal, with a remedy of its own.
    pub fn cause(&self, tool: &TurningTool, leaves: bool, pieces: &[Piece], control: &InForce) -> Cause {
        let wedge = match tool.cutter {
            Cutter::Insert { circle, .. } if leaves => SCRAPE * circle / 2.0,
            _ => 0.0,
        };
        if self.deep <= SCRAPE && self.section <= wedge {
            Cause::RetractionInMetal
        } else if leaves && self.deep <= blade_wedge(tool, pieces) {
            Cause::BladeWedge
        } else if control.to_intermediate {
            Cause::IntermediateInMetal
        } else {
            Cause::RapidInMetal
        }
    }
}

/// How deep a blade can scrape what its own inclined sides have left, mm: 0 where it is no blade, or does not go straight back.
///
/// # Derivation
/// Where a blade stands, all that it covers is free of metal. Straight back its widest part, the front edge, goes where the blade was
/// narrower: what it meets there is beside a side, and no thicker than this side is drawn in.
fn blade_wedge(tool: &TurningTool, pieces: &[Piece]) -> f64 {
    let Cutter::Groover { width, depth, face, .. } = tool.cutter else { return 0.0 };
    let across = usize::from(face);
    let straight = pieces.iter().all(|[from, to]| (to[across] - from[across]).abs() < TOUCH);
    if straight { side_relief(width, depth) * depth + TOUCH } else { 0.0 }
}

/// True where a blade goes straight back. Behind that, too, all that it covers is free of metal: what it met, it took away.
pub fn straight_back(tool: &TurningTool, pieces: &[Piece]) -> bool {
    blade_wedge(tool, pieces) > 0.0
}

/// True where a tool goes from where it has worked towards the side on which its own body lies.
pub fn retracts(tool: &TurningTool, (stands, at): (u32, [f64; 2]), place: u32, pieces: &[Piece]) -> bool {
    let body = tool.tip.mirror();
    let aside = |[from, to]: &Piece| (0..2).all(|axis| (to[axis] - from[axis]) * body[axis] >= 0.0);
    stands == place && pieces.first().is_some_and(|piece| near(at, piece[0])) && pieces.iter().all(aside)
}
