//! What of a turning program's positions hangs on where the turret stood before it: the program does not say where that was.
//!
//! An axis has a place once the program has sent it to an absolute position or to the reference point. A motion before that which
//! leaves it where it stood, or moves it by an increment, ends somewhere that hangs on the start.

use crate::gcode::code::{G, Group};
use crate::gcode::interpreter::Reader;
use crate::gcode::motion::MotionKind;
use crate::machine::axis::{Axis, Pose};

/// The axes of a lathe's turret.
const TURRET: [Axis; 2] = [Axis::X, Axis::Z];
/// A position that is the word's own, mm.
const SAME: f64 = 1e-9;

/// The axes whose extents hang on where the turret stood before the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FromStart {
    /// In program coordinates, at feed and in all.
    pub program: Vec<Axis>,
    /// In machine coordinates.
    pub machine: Vec<Axis>,
}

/// What is known of X and Z, one bit each by their place in [`Axis`].
#[derive(Debug, Default)]
pub(super) struct Placed {
    /// They have a place in program and in machine coordinates.
    known: [u16; 2],
    /// Their program zero was set from where the turret stood (G50, G92).
    zero: u16,
    /// A motion has counted on the start in program and in machine coordinates.
    counted: [u16; 2],
}

impl Placed {
    /// An axis gets a place in program coordinates, or in those of the machine; in the others too where its zero is known.
    const fn place(&mut self, axis: Axis, machine: bool) {
        let bit = 1 << axis as u16;
        self.known[machine as usize] |= bit;
        if self.zero & bit == 0 {
            self.known[!machine as usize] |= bit;
        }
    }

    /// The place where an axis stands gets a coordinate.
    const fn preset(&mut self, axis: Axis) {
        let bit = 1 << axis as u16;
        self.zero |= bit & !self.known[1];
        self.known[0] |= bit;
    }

    /// The zeros that were set so end.
    pub(super) const fn preset_ends(&mut self) {
        self.known[0] &= !self.zero | self.known[1];
        self.zero = 0;
    }

    /// What hangs on the start so far.
    pub(super) fn told(&self) -> FromStart {
        let of = |mask: u16| TURRET.into_iter().filter(|axis| mask & (1 << *axis as u16) != 0).collect();
        let [program, machine] = self.counted.map(of);
        FromStart { program, machine }
    }
}

impl Reader<'_, '_> {
    /// Sees where a motion ends, before it is made.
    pub(super) fn see_start(&mut self, kind: MotionKind, to: &Pose) {
        if !self.memory.control.turns() || matches!(kind, MotionKind::Dwell(_)) {
            return;
        }
        let both = TURRET.into_iter().fold(0, |mask, axis| mask | 1 << axis as u16);
        // A motion at feed begins at a position of the program.
        let feed = kind != MotionKind::Rapid;
        let begins = if feed { both & !self.memory.seen.placed.known[0] } else { 0 };
        let machine = self.block.g(Group::NonModal) == Some(G::MachineCoordinates);
        let reached = if machine { self.state.frame.to_machine(to) } else { *to };
        for axis in TURRET {
            let own = |value: f64| (reached.get(axis) - value).abs() < SAME;
            if self.axis_word(axis).is_some_and(own) && (machine || !self.state.modal.incremental) {
                self.memory.seen.placed.place(axis, machine);
            }
        }
        if *to != self.state.at {
            let placed = &mut self.memory.seen.placed;
            placed.counted[0] |= begins;
            for side in 0..2 {
                placed.counted[side] |= both & !placed.known[side];
            }
        }
    }

    /// An axis goes to the reference point.
    pub(super) const fn place_at_reference(&mut self, axis: Axis) {
        self.memory.seen.placed.place(axis, true);
    }

    /// The position gets coordinates by the axis words of the block.
    pub(super) fn see_preset(&mut self) {
        for axis in TURRET {
            if self.axis_word(axis).is_some() {
                self.memory.seen.placed.preset(axis);
            }
        }
    }
}
