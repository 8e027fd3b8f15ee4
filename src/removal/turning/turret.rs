//! The turret with its tools.

use std::collections::BTreeMap;

use super::tool::{Cutter, Holder, TurningTool};
use crate::geometry::exact::convex::Convex;

/// The most a body may reach from a tool's programmed point, mm: with the ways of tools it stays on the grid.
const REACH: f64 = 290.0;

/// How many places a usual turret has.
pub const PLACES: u32 = 8;

/// A turret: its tools by the number of their place, and what of its body moves with them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Turret {
    /// The tools by the number of their place, from 1.
    pub tools: BTreeMap<u32, TurningTool>,
    /// The turret's body, with what the tools beside the one in the cut reach, as a rectangle about its reference point,
    /// `[[z, r] least, [z, r] greatest]`, mm; none where it is not to be watched.
    pub body: Option<[[f64; 2]; 2]>,
}

impl Turret {
    /// What of the turret moves with a tool and has to touch nothing, about the tool's programmed point: what holds a boring
    /// bar behind its free length, and the turret's body, as far as it lies within 290 mm of the point.
    ///
    /// # Derivation
    /// About a tool along Z there is no other tool's room up to where it is held, at its own length or at the reference
    /// point, whichever is nearer to its point: a drill, a bar or a shank with a blade for faces goes as deep as that, and
    /// the body counts from there on.
    #[must_use]
    pub fn bodies(&self, tool: &TurningTool) -> Vec<Convex> {
        let body = self.body.and_then(|[low, high]| {
            let [x, z] = tool.overhang;
            let own = match (tool.holder, tool.cutter) {
                (Holder::Bar { length, .. }, _)
                | (Holder::Shank { length, .. }, Cutter::Groover { face: true, .. }) => length.min(z),
                (Holder::Shank { .. }, _) => -REACH,
            };
            let (z, r) = ([(low[0] + z).max(own), high[0] + z], [low[1] + x, high[1] + x]);
            let [z, r] = [z, r].map(|ends| ends.map(|end| end.clamp(-REACH, REACH)));
            let corners = [[z[0], r[0]], [z[1], r[0]], [z[1], r[1]], [z[0], r[1]]];
            (z[0] < z[1] && r[0] < r[1]).then(|| Convex::hull_mm(&corners))?
        });
        body.into_iter().chain(tool.clamp()).collect()
    }

    /// The offsets to put into the control, by place: `[X, Z]`, X as a radius, mm; with the nose radius and the number of
    /// the tip.
    pub fn offsets(&self) -> impl Iterator<Item = (u32, [f64; 2], f64, u8)> + '_ {
        self.tools.iter().map(|(&place, tool)| (place, tool.overhang, tool.nose(), tool.tip.number()))
    }
}
