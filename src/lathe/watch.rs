//! What was said already: a state that lasts is reported once, when it begins.

use super::alarm::Cause;
use super::path::Piece;
use super::spindle::{extent, revolutions};
use super::tally::Tally;
use super::tool::Cutter;
use crate::gcode::motion::Thread;

/// A pass of a thread.
#[derive(Clone, Copy, Debug)]
struct Pass {
    /// Where it went along z, and along r.
    z: [f64; 2],
    r: [f64; 2],
    lead: f64,
}

/// Remembers which lasting alarms hold.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    /// The alarm's number and the tool.
    holding: Vec<(u16, u32)>,
    passes: Vec<Pass>,
}

/// Passes of threads farther apart than this across are different threads, mm: more than any thread is deep.
const APART: f64 = 6.0;

impl Watch {
    /// True where an alarm begins to hold with a tool; false while it holds on or does not hold.
    pub fn begins(&mut self, cause: Cause, holds: bool, tool: u32) -> bool {
        let key = (cause.number(), tool);
        match self.holding.iter().position(|held| *held == key) {
            Some(_) if holds => false,
            Some(at) => {
                self.holding.swap_remove(at);
                false
            }
            None if holds => {
                self.holding.push(key);
                true
            }
            None => false,
        }
    }

    /// Notes a pass of a thread; the lead of an earlier one in the same place, if it was another.
    pub fn lead(&mut self, [from, to]: Piece, lead: f64) -> Option<f64> {
        let [z, r] = [0, 1].map(|axis| [from[axis].min(to[axis]), from[axis].max(to[axis])]);
        let meets = |one: [f64; 2], two: [f64; 2], apart: f64| one[0] < two[1] + apart && two[0] < one[1] + apart;
        let near = |pass: &&mut Pass| {
            // Along the thread they must share more than a lead, so that a run-out does not count.
            let along = if z[1] - z[0] >= r[1] - r[0] { (-lead, APART) } else { (APART, -lead) };
            meets(pass.z, z, along.0) && meets(pass.r, r, along.1)
        };
        if let Some(pass) = self.passes.iter_mut().find(near) {
            if (pass.lead - lead).abs() > 1e-6 {
                return Some(pass.lead);
            }
            for (held, new) in [(&mut pass.z, z), (&mut pass.r, r)] {
                *held = [held[0].min(new[0]), held[1].max(new[1])];
            }
            return None;
        }
        self.passes.push(Pass { z, r, lead });
        None
    }

    /// How many passes of threads are held against a new one.
    pub const fn passes(&self) -> usize {
        self.passes.len()
    }

    /// What is wrong with a thread's pass as it is programmed; with the place of the tool in the turret and what cuts.
    pub(super) fn thread(
        &mut self,
        thread: Thread,
        [start, end]: Piece,
        (place, cutter): (u32, Option<&Cutter>),
        cuts: bool,
        tally: &mut Tally,
    ) {
        if revolutions(thread, extent([start, end])).is_none() {
            tally.raise(Cause::NoLead, start, None);
            return;
        }
        let Some(cutter) = cutter else { return };
        let lead = thread.lead;
        match *cutter {
            Cutter::Threader { leads, .. } => {
                let other = lead < leads[0] - 1e-9 || lead > leads[1] + 1e-9;
                if self.begins(Cause::Lead { lead, leads }, other, place) {
                    tally.raise(Cause::Lead { lead, leads }, start, None);
                }
            }
            _ => {
                if self.begins(Cause::NoThreader, cuts, place) {
                    tally.raise(Cause::NoThreader, start, None);
                }
            }
        }
        if cuts && let Some(before) = self.lead([start, end], lead) {
            tally.raise(Cause::LeadDiffers { lead, before }, start, None);
        }
    }
}
