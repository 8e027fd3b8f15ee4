//! The modal state: what codes of earlier blocks leave in force.

use crate::gcode::code::{Cycle, G, TurningCycle};
use crate::gcode::control::Control;
use crate::gcode::in_force::{Compensation, InForce, Speed, Spindle};
use crate::gcode::interpreter::length::{Left, Offset};
use crate::gcode::interpreter::turning::First;
use crate::gcode::interpreter::units::FeedEarlier;
use crate::gcode::motion::{FeedMode, Plane};
use crate::machine::length_unit::LengthUnit;

/// The words of a canned cycle that stay in force while its code does.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sticky {
    /// R as it was programmed.
    pub(super) r: f64,
    /// The bottom word as it was programmed.
    pub(super) bottom: f64,
    pub(super) p: f64,
    pub(super) q: f64,
    pub(super) ijk: [f64; 3],
    /// The height that the first cycle of a series started from.
    pub(super) initial: Option<f64>,
}

/// The modal state.
#[derive(Clone, Debug)]
pub(super) struct Modal {
    /// The motion or cycle in force; [`G::Cancel`] where there is none.
    pub(super) motion: G,
    pub(super) plane: Plane,
    pub(super) unit: LengthUnit,
    pub(super) incremental: bool,
    pub(super) centre_absolute: bool,
    pub(super) feed_mode: FeedMode,
    /// F in mm or degrees, 0 where none is in force.
    pub(super) feed: f64,
    /// F as it was given.
    pub(super) feed_word: f64,
    /// Whether canned cycles return to the height they started from, else to R; `None` before the program has said so.
    pub(super) return_initial: Option<bool>,
    pub(super) speed: f64,
    pub(super) constant_surface_speed: bool,
    pub(super) greatest_speed: Option<f64>,
    pub(super) spindle: Spindle,
    /// The tool that T has selected.
    pub(super) selected: Option<u32>,
    /// The tool in the spindle.
    pub(super) tool: u32,
    /// The number of the tool's offset in force.
    pub(super) offset: u32,
    /// The offset whose length G43 takes up where it waits for a motion.
    pub(super) tool_offset: Offset,
    /// A tool length offset is in force, or waits for the next motion of Z.
    pub(super) lengthened: bool,
    /// What a lone G4 has left of the length in force.
    pub(super) length_left: Left,
    /// The tool whose length it is, where G43 took it from the tool table; where G43 waits, the offset taken up.
    pub(super) length_of: Option<u32>,
    /// Z stands at the machine's 0, where G53 or G28 has brought it.
    pub(super) z_home: bool,
    pub(super) coolant: bool,
    pub(super) compensation: Compensation,
    /// The motion in hand goes to the intermediate point of a return to reference.
    pub(super) to_intermediate: bool,
    pub(super) sticky: Sticky,
    /// The motion code in force before the cycle in force.
    pub(super) under: G,
    /// The turning cycle of one pass in force: its end `[X, Z]`, X the radius, and its R.
    pub(super) pass: Option<([f64; 2], f64)>,
    /// The ends `X` of the passes of the thread cycle in force that had a start angle, until a pass begins at 0.
    pub(super) angled: Option<Vec<f64>>,
    /// The lead of threads, mm; `None` before a block of a thread has given F.
    pub(super) lead: Option<f64>,
    /// The change of the lead with each revolution, mm.
    pub(super) lead_change: f64,
    /// What F means has changed since F was given.
    pub(super) feed_stale: bool,
    /// F was given beside a code that changes the unit, and no source says in which it counts: the line, and the code.
    pub(super) feed_unit: Option<(usize, G)>,
    /// F was given beside a code that changes the unit, and the control has taken it before that code; no motion has gone at it yet.
    pub(super) feed_earlier: Option<FeedEarlier>,
    /// The work offset in force is shifted by its own block.
    pub(super) shifted: bool,
    /// The first blocks of turning cycles of two blocks.
    pub(super) first: Vec<(TurningCycle, First)>,
    /// The work offset in force, 1 to 9.
    pub(super) system: u8,
    /// The sources and the lines where contours begin whose cycle was refused.
    pub(super) refused: Vec<(usize, usize)>,
}

impl Modal {
    pub(super) fn new(control: &Control, unit: LengthUnit, system: u8) -> Self {
        Self {
            motion: control.start.motion,
            plane: control.start.plane,
            unit,
            incremental: false,
            centre_absolute: false,
            feed_mode: control.start.feed,
            feed: 0.0,
            feed_word: 0.0,
            return_initial: None,
            speed: 0.0,
            constant_surface_speed: false,
            greatest_speed: None,
            spindle: Spindle::Stopped,
            selected: None,
            tool: 0,
            offset: 0,
            tool_offset: Offset::default(),
            lengthened: false,
            length_left: Left::Whole,
            length_of: None,
            z_home: false,
            coolant: false,
            compensation: Compensation::Off,
            to_intermediate: false,
            sticky: Sticky::default(),
            under: G::Cancel,
            pass: None,
            angled: None,
            lead: None,
            lead_change: 0.0,
            feed_stale: false,
            feed_unit: None,
            feed_earlier: None,
            shifted: false,
            first: Vec::new(),
            system,
            refused: Vec::new(),
        }
    }

    /// What is in force, for those who follow the motions.
    pub(super) const fn in_force(&self) -> InForce {
        InForce {
            tool: self.tool,
            offset: self.offset,
            lengthened: self.lengthened,
            spindle: self.spindle,
            speed: if self.constant_surface_speed {
                Speed::Surface(self.speed)
            } else {
                Speed::Revolutions(self.speed)
            },
            greatest_speed: self.greatest_speed,
            coolant: self.coolant,
            system: self.system,
            feed_mode: self.feed_mode,
            unit: self.unit,
            compensation: self.compensation,
            to_intermediate: self.to_intermediate,
            file: 0,
        }
    }

    /// The motion code that is in force once no canned cycle is.
    pub(super) const fn under_cycle(&self) -> G {
        if matches!(self.motion, G::Cycle(_)) { self.under } else { self.motion }
    }

    /// True where a cycle is in force.
    pub(super) fn is_cycle(&self, cycle: Cycle) -> bool {
        self.motion == G::Cycle(cycle)
    }
}
