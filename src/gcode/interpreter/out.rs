//! The motions that blocks have made, on their way out: what is held back for the next block, what is led aside, what waits to be asked for.

use std::collections::VecDeque;

use crate::gcode::control::RadiusRule;
use crate::gcode::in_force::InForce;
use crate::gcode::interpreter::State;
use crate::gcode::interpreter::compensation::Compensator;
use crate::gcode::interpreter::corner::Corner;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::interpreter::milling::Milling;
use crate::gcode::interpreter::refused::Result;
use crate::gcode::interpreter::run::Pending;
use crate::gcode::interpreter::standstill::Standing;
use crate::gcode::motion::Motion;
use crate::machine::axis::Pose;

/// A motion on its way through a stage that leads it aside.
#[derive(Clone)]
pub(super) struct NumberedMotion {
    pub(super) motion: Motion,
    /// What was in force.
    pub(super) control: InForce,
    /// Its number among the motions that the program has made.
    pub(super) number: u64,
}

impl NumberedMotion {
    /// The block that made it.
    pub(super) const fn spot(&self) -> Spot {
        Spot { text: self.control.file, line: self.motion.line, n: self.motion.n, again: false }
    }
}

/// The motions between the block that makes them and whoever asks for them.
pub(super) struct Out {
    /// Motions with what was in force, and their numbers among those that the program has made.
    pub(super) queue: VecDeque<Result<(Motion, InForce, u64)>>,
    /// What the block in hand has still to make.
    pub(super) run: Option<Pending>,
    /// The line whose end is to be broken once the next block says how the path goes on.
    pub(super) corner: Option<Corner>,
    /// Leads the nose of a turning tool aside.
    pub(super) compensator: Compensator,
    /// Leads a cutter aside.
    pub(super) milling: Milling,
    /// Blocks without motion, between those of the queue.
    pub(super) standing: Standing,
}

impl Out {
    /// Nothing has been made; paths are led aside by a rule.
    pub(super) fn new(radius: RadiusRule) -> Self {
        Self {
            queue: VecDeque::new(),
            run: None,
            corner: None,
            compensator: Compensator::new(radius),
            milling: Milling::default(),
            standing: Standing::default(),
        }
    }

    /// True where the block in hand has made all its motions and none of them waits for the next block.
    pub(super) const fn settled(&self) -> bool {
        self.run.is_none() && self.corner.is_none()
    }

    /// True where no motion is led aside.
    pub(super) fn straight(&self) -> bool {
        self.compensator.idle() && self.milling.idle()
    }

    /// Where the tip is that stands at a state, in program coordinates.
    #[deny(clippy::wildcard_enum_match_arm)]
    pub(super) fn tip(&self, radius: RadiusRule, state: &State) -> Pose {
        match radius {
            RadiusRule::Cutter => self.milling.cutter(state),
            RadiusRule::Nose(_) | RadiusRule::None => self.compensator.tip(&state.at),
        }
    }
}
