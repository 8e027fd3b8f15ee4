//! Axis travel: no position of a program may lie beyond the machine's limits.

use crate::gcode::program::Program;
use crate::machine::axis::Axis;
use crate::machine::travel::{Excess, Travel, excess};

/// Where a program leaves the travel of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beyond {
    /// The axis.
    pub axis: Axis,
    /// The greatest excess; mm or degrees.
    pub worst: Excess,
    /// The first line of the program's text that leaves the travel, counted from 1.
    pub line: usize,
}

/// Holds a program against the travel of its axes (program coordinates, mm and degrees): what leaves its travel, axis by
/// axis.
#[must_use]
pub fn travel(program: &Program, limits: &[(char, Travel)]) -> Vec<Beyond> {
    limits
        .iter()
        .filter_map(|&(letter, limit)| {
            let axis = Axis::ALL.into_iter().find(|axis| axis.letter() == letter)?;
            let mut beyond: Option<Beyond> = None;
            let mut judge = |position: f64, line: usize| {
                let Some(found) = excess(limit, position) else { return };
                let size = |one: Excess| (one.position - one.limit).abs();
                let known = beyond.get_or_insert(Beyond { axis, worst: found, line });
                if size(known.worst) < size(found) {
                    known.worst = found;
                }
            };
            judge(program.start.get(axis).value(), 1);
            program.for_each_move(&mut |each| judge(each.to.get(axis).value(), each.line));
            beyond
        })
        .collect()
}
