//! The turret with its tools.

use std::collections::BTreeMap;

use super::tool::Tool;

/// How many places a usual turret has.
pub const PLACES: u32 = 8;

/// A turret: its tools by the number of their place, and what of its body moves with them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Turret {
    /// The tools by place, from 1.
    pub tools: BTreeMap<u32, Tool>,
    /// The turret's body as a rectangle about its reference point, `[[z, r] least, [z, r] greatest]`, mm; none where it is
    /// not to be watched.
    pub body: Option<[[f64; 2]; 2]>,
}

impl Turret {
    /// The offsets to put into the control, by place: `[X, Z]`, X as a radius, mm; with the nose radius and the number of
    /// the tip.
    pub fn offsets(&self) -> impl Iterator<Item = (u32, [f64; 2], f64, u8)> + '_ {
        self.tools.iter().map(|(&place, tool)| (place, tool.overhang, tool.nose(), tool.tip.number()))
    }
}
