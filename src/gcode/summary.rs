//! What a program amounts to: blocks, bytes, extents, path, time.

use crate::gcode::program::{Part, Program};
use crate::gcode::word::Number;
use crate::machine::axis::{Axis, Position};
use crate::number::grid::Milli;

/// What a program amounts to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Numbered blocks.
    pub blocks: u64,
    /// Bytes of the text.
    pub bytes: u64,
    /// Least and greatest position of each axis that the program names, by letter; mm or degrees, on the output grid.
    pub extents: Vec<(char, f64, f64)>,
    /// Length of the path of the linear axes in mm; 0 where the program has no paths (a turning cycle).
    pub path: f64,
    /// Estimated time of the moves at feed in seconds; `None` where the program carries no feed.
    pub seconds: Option<f64>,
}

impl Program {
    /// Least and greatest position of each axis that the program names, X Y Z first.
    #[must_use]
    pub fn extents(&self) -> Vec<(char, Milli, Milli)> {
        let mut extents: Vec<(char, Milli, Milli)> = Vec::new();
        let mut reach = |letter: char, value: Milli| match extents.iter_mut().find(|extent| extent.0 == letter) {
            Some(extent) => (extent.1, extent.2) = (extent.1.min(value), extent.2.max(value)),
            None => extents.push((letter, value, value)),
        };
        for part in &self.parts {
            if let Part::Block(words) = part {
                for word in words.iter().filter(|word| matches!(word.letter, 'X' | 'Y' | 'Z' | 'B')) {
                    if let Number::Size(size) = word.number {
                        reach(word.letter, size);
                    }
                }
            }
        }
        self.for_each_move(&mut |each| {
            for &axis in each.path.axes {
                reach(axis.letter(), each.from.get(axis));
                reach(axis.letter(), each.to.get(axis));
            }
        });
        // X Y Z before A B C, as a machinist reads them.
        extents.sort_by_key(|extent| (!matches!(extent.0, 'X' | 'Y' | 'Z'), extent.0));
        extents
    }

    /// What the program amounts to.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let mut summary = Summary::default();
        let end_of_line = self.control.text.end_of_line.len();
        let mut lines = self.lines();
        while let Some((number, text)) = lines.next() {
            let digits = number.map_or(0, |number| number.checked_ilog10().unwrap_or(0) as usize + 1 + "N ".len());
            summary.bytes += (digits + text.len() + end_of_line) as u64;
        }
        summary.blocks = self.blocks();
        let (mut seconds, mut timed) = (0.0, false);
        self.for_each_move(&mut |each| {
            summary.path += linear_length(&each.from, &each.to);
            if let Some(time) = each.path.seconds(each.step) {
                timed = true;
                seconds += time;
            }
        });
        summary.seconds = timed.then_some(seconds);
        summary.extents =
            self.extents().into_iter().map(|(letter, low, high)| (letter, low.value(), high.value())).collect();
        summary
    }
}

/// Length of a move of the linear axes, mm.
#[must_use]
pub fn linear_length(from: &Position, to: &Position) -> f64 {
    let differences = to.differences(from);
    let square = |axis: Axis| differences[axis as usize] * differences[axis as usize];
    (square(Axis::X) + square(Axis::Y) + square(Axis::Z)).sqrt()
}
