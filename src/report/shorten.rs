//! Long tables and listings, shortened to their head and tail.

use std::collections::VecDeque;
use std::io;

use serde::Serialize;

use crate::gcode::program::Program;

/// Tables up to this many rows are printed whole.
pub(super) const TABLE_ROWS: usize = 60;
/// Rows kept of a longer table at each end.
pub(super) const TABLE_ENDS: usize = 20;
/// Lines kept at the head of a long listing.
const LISTING_HEAD: usize = 140;
/// Lines kept at its tail.
const LISTING_TAIL: usize = 20;

/// The rows of a table to print: head, how many are left out, tail.
pub(super) fn rows(count: usize) -> (std::ops::Range<usize>, usize, std::ops::Range<usize>) {
    if count <= TABLE_ROWS {
        (0..count, 0, count..count)
    } else {
        (0..TABLE_ENDS, count - 2 * TABLE_ENDS, count - TABLE_ENDS..count)
    }
}

/// A program's lines to print.
#[derive(Debug, Default, Serialize)]
pub(super) struct Listing {
    /// The first lines; all of them if nothing is left out.
    pub head: Vec<String>,
    /// How many lines are left out.
    pub omitted: usize,
    /// The last lines.
    pub tail: Vec<String>,
}

impl Listing {
    /// The listing of a program.
    pub(super) fn of(program: &Program) -> io::Result<Self> {
        let mut listing = Self::default();
        let mut tail: VecDeque<String> = VecDeque::with_capacity(LISTING_TAIL + 1);
        program.for_each(&mut |number, text| {
            let line = match number {
                Some(number) if text.is_empty() => format!("N{number}"),
                Some(number) => format!("N{number} {text}"),
                None => text.to_owned(),
            };
            if listing.head.len() < LISTING_HEAD {
                listing.head.push(line);
            } else {
                tail.push_back(line);
                if tail.len() > LISTING_TAIL {
                    tail.pop_front();
                    listing.omitted += 1;
                }
            }
            Ok(())
        })?;
        if listing.omitted == 0 {
            listing.head.extend(tail);
        } else {
            listing.tail = tail.into();
        }
        Ok(listing)
    }

    /// The longest line in characters.
    pub(super) fn widest(&self) -> usize {
        self.head.iter().chain(&self.tail).map(|line| line.chars().count()).max().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::rows;

    #[test]
    fn only_tables_above_sixty_rows_lose_their_middle() {
        assert_eq!(rows(60), (0..60, 0, 60..60));
        assert_eq!(rows(61), (0..20, 21, 41..61));
        assert_eq!(rows(0), (0..0, 0, 0..0));
    }
}
