//! Travel of the linear and rotary axes in program coordinates.

use crate::finding::Key;
use crate::machine::axis::Axis;

/// The travel of one axis: least and greatest position; `None` where it is not known and so not checked.
pub type Travel = [Option<f64>; 2];

/// The travel of an axis, with the parameters that say it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisTravel {
    /// The axis that is limited.
    pub axis: Axis,
    /// Its least and greatest position, mm or degrees.
    pub ends: Travel,
    /// The parameters of the lower and the upper end.
    pub keys: [Key; 2],
}

impl AxisTravel {
    /// True where an end of it is known, so that it is checked.
    #[must_use]
    pub fn is_known(&self) -> bool {
        self.ends.iter().any(Option::is_some)
    }
}

/// Where an axis leaves its travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excess {
    /// Where the axis would stand, mm or degrees.
    pub position: f64,
    /// The end of the travel that it leaves, mm or degrees.
    pub limit: f64,
}

/// By how much a sum of thousandths may be off its place, mm or degrees: a limit that is just reached is kept.
const SUMMED: f64 = 1e-6;

/// Holds a position against a travel.
#[must_use]
pub fn excess(travel: Travel, position: f64) -> Option<Excess> {
    match travel {
        [Some(limit), _] if position < limit - SUMMED => Some(Excess { position, limit }),
        [_, Some(limit)] if position > limit + SUMMED => Some(Excess { position, limit }),
        _ => None,
    }
}
