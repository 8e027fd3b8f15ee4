//! Blocks without motion: what they put into force.

use std::collections::VecDeque;

use super::{Interpreter, Reader, State};
use crate::gcode::in_force::InForce;
use crate::gcode::interpreter::library::Spot;
use crate::gcode::motion::Motion;
use crate::limits::STANDSTILL_BLOCKS;
use crate::machine::axis::Pose;

/// What is in force after a block that made no motion, or after the motions of one that changed it behind them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standstill {
    /// The line of the block.
    pub line: usize,
    /// What is in force, with the number of the block's file.
    pub control: InForce,
    /// Where the machine stands, in program coordinates.
    pub at: Pose,
    /// The same in machine coordinates.
    pub machine: Pose,
}

/// A block without motion.
#[derive(Debug)]
struct Block {
    stood: Standstill,
    /// How many motions were made before it.
    made: u64,
    /// Nose radius compensation keeps the tip aside of where the program stands.
    aside: bool,
}

/// The blocks without motion since the last motion that was handed out.
#[derive(Debug, Default)]
pub(super) struct Standing {
    kept: bool,
    last: Option<(InForce, Pose)>,
    /// Motions made, and the number of the one handed out last: nose radius compensation holds them back and can make more
    /// than one of one.
    made: u64,
    given: u64,
    /// Where the machine stands behind the motion handed out last, and behind the one before it.
    ends: [Option<Pose>; 2],
    blocks: VecDeque<Block>,
}

impl State {
    /// What is in force at a block, and where the machine stands.
    fn stands(&self, spot: Spot) -> Standstill {
        let control = InForce { file: spot.text, ..self.modal.in_force() };
        Standstill { line: spot.line, control, at: self.at, machine: self.frame.to_machine(&self.at) }
    }
}

impl Interpreter<'_> {
    /// From now on keeps what blocks without motion change; see [`Interpreter::stood`].
    pub fn keep_stood(&mut self) {
        self.memory.out.standing.kept = true;
        self.memory.out.standing.last = Some((self.state.modal.in_force(), self.state.at));
    }

    /// What is in force at the block that was read last, and where the machine stands.
    #[must_use]
    pub fn stands(&self) -> Standstill {
        self.state.stands(self.block.spot)
    }

    /// The blocks that changed what is in force without a motion, before the motion last handed out or, at the end of the
    /// program, behind it. Each is given once.
    pub fn stood(&mut self) -> Vec<Standstill> {
        let Standing { blocks, given, ends, .. } = &mut self.memory.out.standing;
        let before = blocks.iter().take_while(|block| block.made < *given).count();
        let placed = |Block { mut stood, aside, .. }: Block| {
            if let (true, Some(tip)) = (aside, ends[1]) {
                let by = tip.differences(&stood.machine);
                stood.at.0.iter_mut().zip(by).for_each(|(at, by)| *at += by);
                stood.machine = tip;
            }
            stood
        };
        blocks.drain(..before).map(placed).collect()
    }
}

impl Standing {
    /// A motion of this number was handed out; `None`: there are no more.
    pub(super) fn handed_out(&mut self, item: Option<(&Motion, u64)>) {
        if !self.kept {
            return;
        }
        let ends = &mut self.ends;
        *ends = [item.map(|(motion, _)| motion.machine).or(ends[0]), ends[0]];
        self.given = item.map_or(u64::MAX, |(_, number)| number);
    }
}

impl Reader<'_, '_> {
    /// How many motions the program has made.
    pub(super) const fn made(&self) -> u64 {
        self.memory.out.standing.made
    }

    /// A motion was made.
    pub(super) fn moved(&mut self) {
        self.memory.out.standing.made += 1;
        if self.memory.out.standing.kept {
            self.memory.out.standing.last = Some((self.state.modal.in_force(), self.state.at));
        }
    }

    /// A block was executed: what it changed without a motion is kept.
    pub(super) fn executed(&mut self) {
        if !self.memory.out.standing.kept
            || !self.memory.out.settled()
            || self.memory.out.standing.blocks.len() == STANDSTILL_BLOCKS
        {
            return;
        }
        let now = (self.state.modal.in_force(), self.state.at);
        if self.memory.out.standing.last.replace(now) != Some(now) {
            let stood = self.state.stands(self.block.spot);
            let (made, aside) = (self.memory.out.standing.made, !self.memory.out.straight());
            self.memory.out.standing.blocks.push_back(Block { stood, made, aside });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gcode::control::FANUC_LATHE_A;
    use crate::gcode::in_force::Spindle;
    use crate::gcode::interpreter::{Setting, ToolOffset, Tools};
    use crate::gcode::turning::nose::{Nose, Tip};
    use crate::machine::axis::Axis;

    #[test]
    fn a_block_without_motion_says_what_is_in_force_behind_it() {
        let text = b"O0001\nG21 G97 S1000 M3\n(nothing)\nG0 X50. Z2. M8\nG1 Z-5. F0.1\nM5\nG4 X1.\nT0202\nM4\nG0 X60. M5\nM30\n";
        let mut interpreter = Interpreter::over(text, Setting::new(&FANUC_LATHE_A));
        interpreter.keep_stood();
        assert_eq!(interpreter.stands().control.spindle, Spindle::Stopped);
        let mut seen: Vec<(usize, bool, bool, u32)> = Vec::new();
        loop {
            let item = interpreter.next();
            for stood in interpreter.stood() {
                let turns = stood.control.spindle != Spindle::Stopped;
                seen.push((stood.line, turns, stood.control.coolant, stood.control.tool));
            }
            let Some(motion) = item else { break };
            let motion = motion.unwrap();
            let control = interpreter.in_force();
            seen.push((motion.line, control.spindle != Spindle::Stopped, control.coolant, control.tool));
        }
        let lines: Vec<usize> = seen.iter().map(|one| one.0).collect();
        assert_eq!(lines, [2, 4, 5, 6, 7, 8, 9, 10, 10, 11], "a block that changes nothing is left out");
        assert_eq!(seen[0], (2, true, false, 0));
        assert_eq!(seen[3], (6, false, true, 0), "M5 behind the last motion at feed");
        assert_eq!(seen[5].3, 2, "the turret has turned");
        assert_eq!((seen[7].1, seen[8].1), (true, false), "the spindle is stopped behind the motion of its block");
        assert_eq!(interpreter.stands().at.get(Axis::Z), -5.0);
    }

    #[test]
    fn under_compensation_a_block_without_motion_stands_behind_the_motion_before_it_and_at_its_tip() {
        let text = b"O0001\nG21 G97 S1000 M3\nG0 X50. Z2. T0101\nG42 G0 X40.\nG1 Z-5. F0.1\nM8\nX50. Z-15.\nM9\nX60.\n\
                     G40 G0 X70.\nM5\nM30\n";
        let mut setting = Setting::new(&FANUC_LATHE_A);
        let nose = Some(Nose { radius: 0.8, tip: Tip::OutsideLeft });
        setting.tools = Some(Tools::from([(1, ToolOffset { nose, ..ToolOffset::default() })]));
        let mut interpreter = Interpreter::over(text, setting);
        interpreter.keep_stood();
        let (mut seen, mut tip) = (Vec::new(), None);
        loop {
            let item = interpreter.next();
            for stood in interpreter.stood() {
                seen.push((stood.line, false));
                if let Some(tip) = tip {
                    assert_eq!(stood.machine, tip, "line {}", stood.line);
                }
            }
            let Some(motion) = item else { break };
            let motion = motion.unwrap();
            tip = Some(motion.machine);
            seen.push((motion.line, true));
        }
        let still = |line| seen.iter().position(|one| *one == (line, false)).unwrap();
        let moved = |line| seen.iter().rposition(|one| *one == (line, true)).unwrap();
        assert!(moved(5) < still(6) && still(6) < moved(7), "M8: {seen:?}");
        assert!(moved(7) < still(8) && still(8) < moved(9), "M9: {seen:?}");
        assert!(moved(10) < still(11), "M5: {seen:?}");
    }

    #[test]
    fn what_nobody_asks_for_is_not_kept() {
        let mut interpreter = Interpreter::over(b"G97 S1000 M3\nM5\nM30\n", Setting::new(&FANUC_LATHE_A));
        assert!(interpreter.next().is_none() && interpreter.stood().is_empty());
    }
}
