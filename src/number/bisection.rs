//! The greatest value of a function over boxes, bounded: by halving those that may hold it.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::hash::Hash;

use rustc_hash::FxHashMap;

/// A box of two coordinates on one of several sheets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// The number of the sheet.
    pub sheet: usize,
    /// The first coordinate, from and to.
    pub s: [f64; 2],
    /// The second coordinate, from and to.
    pub t: [f64; 2],
}

/// What is known of a function over a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// It is nowhere greater.
    pub upper: f64,
    /// It is as great as this in the middle; −∞ where the middle does not count.
    pub middle: f64,
    /// True where the box is to be halved in its first coordinate, false in its second.
    pub first: bool,
}

/// The greatest value over all boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Greatest {
    /// It is not greater.
    pub upper: f64,
    /// It is at least this.
    pub lower: f64,
    /// The box in whose middle it is that great.
    pub at: Cell,
}

struct Open(f64, Cell);

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Open {}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }

    // What a heap asks.
    fn le(&self, other: &Self) -> bool {
        self.cmp(other).is_le()
    }
}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// The greatest value over boxes, until upper and lower bound are within a tolerance or `most` boxes were looked at; the
/// upper bound holds in either case. `None` without boxes that count.
#[must_use]
pub fn greatest(
    cells: impl IntoIterator<Item = Cell>,
    tolerance: f64,
    most: usize,
    bounds: impl FnMut(&Cell) -> Bounds,
) -> Option<Greatest> {
    greatest_above(f64::NEG_INFINITY, cells, tolerance, most, bounds)
}

/// The same where only what is greater than `known` is worth knowing: where nothing is, the upper bound is that.
#[must_use]
pub fn greatest_above(
    known: f64,
    cells: impl IntoIterator<Item = Cell>,
    tolerance: f64,
    most: usize,
    mut bounds: impl FnMut(&Cell) -> Bounds,
) -> Option<Greatest> {
    let mut open = BinaryHeap::new();
    let mut best: Option<(f64, Cell)> = None;
    let mut looked = 0;
    let mut look = |cell: Cell, open: &mut BinaryHeap<(Open, bool)>, best: &mut Option<(f64, Cell)>| {
        looked += 1;
        let found = bounds(&cell);
        if best.is_none_or(|(value, _)| found.middle > value) {
            *best = Some((found.middle, cell));
        }
        let least = best.map_or(known, |(value, _)| known.max(value + tolerance));
        // What cannot hold the greatest is forgotten. What is no number may.
        if found.upper > least || found.upper.is_nan() {
            open.push((Open(found.upper, cell), found.first));
        }
        looked
    };
    for cell in cells {
        look(cell, &mut open, &mut best);
    }
    let mut upper = f64::NEG_INFINITY;
    while let Some((Open(above, cell), first)) = open.pop() {
        let (value, _) = best?;
        upper = above;
        if above <= known.max(value + tolerance) {
            break;
        }
        upper = f64::NEG_INFINITY;
        let middle = |[low, high]: [f64; 2]| low + (high - low) / 2.0;
        let (mut below, mut beyond) = (cell, cell);
        if first {
            (below.s[1], beyond.s[0]) = (middle(cell.s), middle(cell.s));
        } else {
            (below.t[1], beyond.t[0]) = (middle(cell.t), middle(cell.t));
        }
        look(below, &mut open, &mut best);
        if look(beyond, &mut open, &mut best) >= most {
            upper = open.peek().map_or(f64::NEG_INFINITY, |(Open(above, _), _)| *above);
            break;
        }
    }
    let (lower, at) = best?;
    // Everything forgotten is within the tolerance of what was the best then.
    Some(Greatest { upper: upper.max(lower + tolerance).max(known), lower, at })
}

/// A coordinate as a key. Halves of a whole have nothing in their low bits, but a hash needs something there.
#[must_use]
pub const fn key(coordinate: f64) -> u64 {
    coordinate.to_bits().rotate_left(32)
}

/// What is kept by a key, or is found out now. Mostly it is kept, and this asks for that first: an entry that may have to be
/// filled costs more.
#[inline]
pub fn kept<K: Eq + Hash, V: Copy>(all: &mut FxHashMap<K, V>, key: K, found: impl FnOnce() -> V) -> V {
    if let Some(found) = all.get(&key) {
        return *found;
    }
    let found = found();
    all.insert(key, found);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3 − (s − 0.3)² − 2(t − 0.6)² on sheet 1, 2 less on sheet 0; second derivatives −2 and −4.
    fn hill(cell: &Cell) -> Bounds {
        let value = |s: f64, t: f64| {
            let (s, t) = (s - 0.3, t - 0.6);
            let lift = if cell.sheet == 1 { 3.0 } else { 1.0 };
            lift - s * s - 2.0 * t * t
        };
        let (width, height) = (cell.s[1] - cell.s[0], cell.t[1] - cell.t[0]);
        let corners = cell.s.iter().flat_map(|&s| cell.t.map(|t| value(s, t))).fold(f64::NEG_INFINITY, f64::max);
        Bounds {
            upper: corners + 2.0 * width * width / 8.0 + 4.0 * height * height / 8.0,
            middle: value((cell.s[0] + cell.s[1]) / 2.0, (cell.t[0] + cell.t[1]) / 2.0),
            first: width > height,
        }
    }

    #[test]
    fn the_greatest_value_is_bracketed() {
        let cells = [0, 1].map(|sheet| Cell { sheet, s: [0.0, 1.0], t: [0.0, 1.0] });
        let found = greatest(cells, 1e-6, 100_000, hill).unwrap();
        assert!(found.lower <= 3.0 && found.upper >= 3.0 && found.upper - found.lower < 2.1e-6, "{found:?}");
        assert_eq!(found.at.sheet, 1);
        let hasty = greatest(cells, 1e-6, 10, hill).unwrap();
        assert!(
            hasty.upper >= 3.0 && hasty.upper > found.upper,
            "the bound holds when the work is cut short: {hasty:?}"
        );
        assert_eq!(greatest([], 1e-6, 10, hill), None);
    }

    #[test]
    fn what_is_known_is_not_sought_again() {
        let cells = || [0, 1].map(|sheet| Cell { sheet, s: [0.0, 1.0], t: [0.0, 1.0] });
        let count = std::cell::Cell::new(0);
        let counted = |cell: &Cell| {
            count.set(count.get() + 1);
            hill(cell)
        };
        let above = greatest_above(3.5, cells(), 1e-6, 100_000, counted).unwrap();
        assert!(above.upper == 3.5 && count.get() < 20, "{above:?} {}", count.get());
        let below = greatest_above(2.5, cells(), 1e-6, 100_000, hill).unwrap();
        assert!(below.lower <= 3.0 && below.upper >= 3.0 && below.upper < 3.0 + 2.1e-6, "{below:?}");
    }
}
