//! What the text of a program amounts to: blocks, bytes, and the positions that it names.

use crate::gcode::program::{Part, Program};
use crate::gcode::word::{Number, Retract, Word};
use crate::number::grid::Milli;

/// What the text of a program amounts to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// How many lines may carry a block number.
    pub blocks: u64,
    /// How long the text is, in bytes.
    pub bytes: u64,
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
            // G53 counts from machine zero.
            let (Part::Block(words) | Part::Away(Retract(words))) = part else { continue };
            if words.contains(&Word::whole('G', 53)) {
                continue;
            }
            for word in words.iter().filter(|word| matches!(word.letter, 'X' | 'Y' | 'Z' | 'B')) {
                if let Number::Size(size) = word.number {
                    reach(word.letter, size);
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

    /// What its text amounts to.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let mut bytes = 0;
        let end_of_line = self.control.text.end_of_line.len();
        let mut lines = self.lines();
        while let Some((number, text)) = lines.next() {
            let digits = number.map_or(0, |number| number.checked_ilog10().unwrap_or(0) as usize + 1 + "N ".len());
            bytes += (digits + text.len() + end_of_line) as u64;
        }
        Summary { blocks: self.blocks(), bytes }
    }
}
