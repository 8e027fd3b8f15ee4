//! What of a track a motion cuts.

use crate::gcode::program::Role;
use crate::kinds::impeller::track::Track;
use crate::number::grid::Milli;
use crate::proof::step::{Stage, Step};

/// A motion that cuts.
#[derive(Clone, Copy, Debug)]
pub struct TrackStep {
    /// The track that the motion cuts or leaves.
    pub track: Track,
    /// How far C is turned on beyond the track's own position.
    pub turn: Milli,
    /// The point index from which it runs and that to which it runs; `None` for the safe point.
    pub points: [Option<usize>; 2],
}

impl TrackStep {
    /// What of a track a motion cuts, or leaves.
    #[must_use]
    pub fn of(step: &Step<'_>) -> Option<Self> {
        let Stage::Planned(planned) = &step.stage else { return None };
        let (path, number) = planned.path?;
        let index = |step: usize| if path.backwards { path.positions.len().checked_sub(step + 1) } else { Some(step) };
        let (key, points) = match path.role {
            Role::Clear => return None,
            Role::Cut(key) => (key, [number.checked_sub(1).and_then(index), index(number)]),
            Role::Leave(key) => (key, [None, None]),
        };
        Some(Self { track: Track::from_key(key)?, turn: path.turn, points })
    }

    /// True where the motion takes the tool out of the part, at the end of a pass.
    #[must_use]
    pub fn leaves(&self) -> bool {
        self.points == [None, None]
    }
}

/// True for a motion that should be clear of the part.
#[must_use]
pub fn clear(step: &Step<'_>) -> bool {
    let Stage::Planned(planned) = &step.stage else { return false };
    planned.path.is_some_and(|(path, _)| matches!(path.role, Role::Clear))
}
