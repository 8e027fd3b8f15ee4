//! What has been seen of a program so far that a later block, a finding or the caller asks for. Nothing of it is in force.

use crate::gcode::code::TurningCycle;
use crate::gcode::interpreter::Interpreter;
use crate::gcode::interpreter::contour::TurnedContour;
use crate::gcode::interpreter::cutting::SpindleSeen;
use crate::gcode::interpreter::from_start::{FromStart, Placed};
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::turned::TurnedSeen;
use crate::gcode::interpreter::units::UnitsSeen;

/// What has been seen of a program.
#[derive(Default)]
pub(super) struct Seen {
    /// M66 has read an input.
    pub(super) input_read: bool,
    /// A sign of another control has been looked for.
    pub(super) foreign_sought: bool,
    /// First blocks of turning cycles of two that no second one has followed yet.
    pub(super) first_blocks: Vec<(TurningCycle, Spot)>,
    /// A cycle of a lathe was refused.
    pub(super) uncut: bool,
    pub(super) units: UnitsSeen,
    /// Which axes of a lathe the program has given a place.
    pub(super) placed: Placed,
    /// A block of a lathe has given the place where the turret stands coordinates.
    pub(super) position_set: bool,
    /// A block of a lathe has gone to a reference point, and one has moved in machine coordinates.
    pub(super) referred: bool,
    pub(super) in_machine: bool,
    /// G92 has given coordinates to the place where the program began, which the text does not say.
    pub(super) start_preset: bool,
    pub(super) spindle: SpindleSeen,
    pub(super) turned: TurnedSeen,
    /// The contours that cycles have read.
    pub(super) contours: Vec<TurnedContour>,
    /// An absolute motion has been made, and an incremental one.
    pub(super) distances: [bool; 2],
    /// A word of a rotary axis has meant something else on a rollover axis than on a linear one.
    pub(super) rotary_differs: bool,
}

impl Interpreter<'_> {
    /// Whether a motion has been made in inches.
    #[must_use]
    pub const fn in_inches(&self) -> bool {
        self.memory.seen.units.inches
    }

    /// Whether a block of a lathe has given coordinates to the place where the turret stands (G50 X Z).
    #[must_use]
    pub const fn sets_position(&self) -> bool {
        self.memory.seen.position_set
    }

    /// Whether a block of a lathe has gone to the first reference point (G28).
    #[must_use]
    pub const fn returns_to_reference(&self) -> bool {
        self.memory.seen.referred
    }

    /// Which axes of a lathe have made motions that hang on where the turret stood before the program.
    #[must_use]
    pub fn from_start(&self) -> FromStart {
        self.memory.seen.placed.told()
    }

    /// Whether a block has moved in machine coordinates (G53).
    #[must_use]
    pub const fn moves_in_machine(&self) -> bool {
        self.memory.seen.in_machine
    }

    /// True behind a refused block of a lathe whose cycle is not made, also where that refusal follows from another and is not told: what
    /// comes after it meets another part than the program counts on.
    #[must_use]
    pub const fn uncut(&self) -> bool {
        self.memory.seen.uncut
    }

    /// The contours of a lathe's cycles that have been read so far, each once.
    #[must_use]
    pub fn contours(&self) -> &[TurnedContour] {
        &self.memory.seen.contours
    }

    /// True where no word so far has meant something else on a rollover axis than on a linear one: what was read so far reads
    /// alike under each [`Setting::rotary`](super::Setting::rotary).
    #[must_use]
    pub const fn any_rotary(&self) -> bool {
        !self.memory.seen.rotary_differs
    }

    /// True where every motion so far was programmed by increments.
    #[must_use]
    pub const fn all_incremental(&self) -> bool {
        matches!(self.memory.seen.distances, [false, true])
    }
}
