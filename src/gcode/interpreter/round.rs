//! Loops that come to nothing: one block refused again and again, rounds in which nothing happens, cycles without an end.

use std::collections::BTreeMap;

use crate::gcode::in_force::InForce;
use crate::gcode::interpreter::refused::{Refused, Result};
use crate::gcode::interpreter::{Reader, Stage};
use crate::gcode::turning::rules::{EndlessLoop, RefusedInLoop, TooManyCycleMotions};
use crate::limits::{BLOCK_REFUSALS, IDLE_ROUNDS, REFUSED_LINES};

/// What is watched of the rounds of loops.
#[derive(Debug, Default)]
pub(super) struct Rounds {
    /// How often the blocks of a source and line were refused.
    refusals: BTreeMap<(usize, usize), u32>,
    /// Motions made, parameters changed and what was in force at the end of the last round.
    last: Option<(u64, u64, InForce)>,
    idle: u32,
    /// Motions that cycles have made.
    cycled: u64,
}

impl Reader<'_, '_> {
    /// A refusal as it is to be reported: what follows from one before is not; a block that is refused once more in a loop is not, and one too often ends the program.
    pub(super) fn told_once(&mut self, fault: Box<Refused>, line: &[u8]) -> Option<Box<Refused>> {
        let key = (self.block.spot.text, fault.line);
        if fault.fatal {
            return Some(fault);
        }
        let follows = self.follows(&fault, line);
        if self.memory.flow.loops.refusals.len() >= REFUSED_LINES && !self.memory.flow.loops.refusals.contains_key(&key)
        {
            return (!follows).then_some(fault);
        }
        let times = self.memory.flow.loops.refusals.entry(key).or_insert(0);
        *times += 1;
        match *times {
            1 => (!follows).then_some(fault),
            BLOCK_REFUSALS => {
                self.memory.flow.stage = Stage::Ended;
                let mut limit = Refused::ended(&RefusedInLoop { times: BLOCK_REFUSALS });
                (limit.line, limit.file) = (fault.line, fault.file);
                Some(limit)
            }
            _ => None,
        }
    }

    /// A loop goes round again because of its condition: where nothing has happened since it did so last, it never ends.
    pub(super) fn round_again(&mut self) -> Result<()> {
        let now = (self.made(), self.memory.parameters.changes(), self.state.modal.in_force());
        let rounds = &mut self.memory.flow.loops;
        rounds.idle = if rounds.last.replace(now) == Some(now) { rounds.idle + 1 } else { 0 };
        if rounds.idle < IDLE_ROUNDS {
            return Ok(());
        }
        Err(Refused::ended(&EndlessLoop { rounds: IDLE_ROUNDS }))
    }

    /// A cycle has gone on, from so many motions made.
    pub(super) fn cycle_went_on(&mut self, before: u64) {
        self.memory.flow.loops.cycled += self.made() - before;
        let most = self.memory.setting.budget.repeated_blocks;
        if self.memory.flow.loops.cycled <= most || self.memory.out.run.is_none() {
            return;
        }
        self.memory.out.run = None;
        self.memory.flow.stage = Stage::Ended;
        let mut limit = Refused::ended(&TooManyCycleMotions { most });
        limit.line = self.block.spot.line;
        self.memory.out.queue.push_back(Err(limit));
    }
}
