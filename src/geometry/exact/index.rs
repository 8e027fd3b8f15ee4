//! Where the edges of a region lie: a loose quadtree, that is one in which every edge is in one place.

use super::grid::{Line, Point};

/// No edge, no square.
pub(super) const NONE: u32 = u32::MAX;

/// The finest squares are 2^14 units wide, about 0.016 mm.
const FINEST: u32 = 14;

/// The least and the greatest coordinates of what lies somewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bounds {
    pub low: Point,
    pub high: Point,
}

impl Bounds {
    const fn meets(&self, other: &Self) -> bool {
        self.low.z <= other.high.z
            && other.low.z <= self.high.z
            && self.low.r <= other.high.r
            && other.low.r <= self.high.r
    }

    /// Extends these bounds over others; false where they held them already.
    fn extend(&mut self, other: &Self) -> bool {
        let before = *self;
        self.low = Point { z: self.low.z.min(other.low.z), r: self.low.r.min(other.low.r) };
        self.high = Point { z: self.high.z.max(other.high.z), r: self.high.r.max(other.high.r) };
        *self != before
    }
}

/// A square holds edges that begin in it, with the least of their coordinates, and are no longer than its side, but longer
/// than half of it. What it and its quarters hold lies within twice its side.
#[derive(Clone, Debug)]
struct Square {
    low: Point,
    level: u32,
    /// Where everything lies that it and its quarters hold, and have held.
    reach: Bounds,
    parent: u32,
    quarters: [u32; 4],
    /// The first of the edges that it holds itself.
    first: u32,
    /// How many edges it and its quarters hold.
    count: u32,
}

/// An edge in the square that holds it.
#[derive(Clone, Copy, Debug)]
struct IndexedEdge {
    square: u32,
    before: u32,
    next: u32,
    bounds: Bounds,
}

const NOWHERE: IndexedEdge = IndexedEdge {
    square: NONE,
    before: NONE,
    next: NONE,
    bounds: Bounds { low: Point { z: 0, r: 0 }, high: Point { z: 0, r: 0 } },
};

/// The edges of a region, by number. The first square is the whole; a square without edges is given up.
#[derive(Clone, Debug, Default)]
pub(super) struct Index {
    squares: Vec<Square>,
    free: Vec<u32>,
    held: Vec<IndexedEdge>,
}

const fn side(level: u32) -> i64 {
    1 << (FINEST + level)
}

/// The least level at which a square is as wide as a length.
fn level(length: i64) -> u32 {
    let bits = i64::BITS - (length - 1).max(0).leading_zeros();
    bits.saturating_sub(FINEST)
}

impl Index {
    /// An index for edges within bounds.
    pub(super) fn new(all: Bounds) -> Self {
        let mut index = Self::default();
        let length = (all.high.z - all.low.z).max(all.high.r - all.low.r);
        index.add(all.low, level(length), NONE, all);
        index
    }

    fn add(&mut self, low: Point, level: u32, parent: u32, reach: Bounds) -> u32 {
        let square = Square { low, level, reach, parent, quarters: [NONE; 4], first: NONE, count: 0 };
        if let Some(slot) = self.free.pop() {
            self.squares[slot as usize] = square;
            return slot;
        }
        self.squares.push(square);
        u32::try_from(self.squares.len() - 1).unwrap_or(NONE)
    }

    /// Puts an edge where it lies, which is elsewhere if it was in the index before.
    pub(super) fn put(&mut self, edge: u32, bounds: Bounds) {
        let slot = edge as usize;
        if self.held.len() <= slot {
            self.held.resize(slot + 1, NOWHERE);
        }
        let (low, high) = (bounds.low, bounds.high);
        let level = level((high.z - low.z).max(high.r - low.r)).min(self.squares[0].level);
        if let Some(square) = self.squares.get(self.held[slot].square as usize) {
            let within = |at: i64, from: i64| at >= from && at < from + side(level);
            if square.level == level && within(low.z, square.low.z) && within(low.r, square.low.r) {
                self.held[slot].bounds = bounds;
                let mut at = self.held[slot].square;
                while at != NONE && self.squares[at as usize].reach.extend(&bounds) {
                    at = self.squares[at as usize].parent;
                }
                return;
            }
            self.take(edge);
        }
        let mut at = 0;
        loop {
            let square = &mut self.squares[at as usize];
            square.count += 1;
            square.reach.extend(&bounds);
            if square.level <= level {
                break;
            }
            let half = side(square.level - 1);
            let (right, upper) = (low.z >= square.low.z + half, low.r >= square.low.r + half);
            let quarter = usize::from(right) + 2 * usize::from(upper);
            let (next, below) = (square.quarters[quarter], square.level - 1);
            if next == NONE {
                let corner = Point {
                    z: square.low.z + if right { half } else { 0 },
                    r: square.low.r + if upper { half } else { 0 },
                };
                let made = self.add(corner, below, at, bounds);
                self.squares[at as usize].quarters[quarter] = made;
                at = made;
            } else {
                at = next;
            }
        }
        let next = std::mem::replace(&mut self.squares[at as usize].first, edge);
        if next != NONE {
            self.held[next as usize].before = edge;
        }
        self.held[slot] = IndexedEdge { square: at, before: NONE, next, bounds };
    }

    /// Takes an edge out, if it is in.
    pub(super) fn take(&mut self, edge: u32) {
        let Some(held) = self.held.get_mut(edge as usize).filter(|held| held.square != NONE) else { return };
        let IndexedEdge { square, before, next, .. } = std::mem::replace(held, NOWHERE);
        match before {
            NONE => self.squares[square as usize].first = next,
            before => self.held[before as usize].next = next,
        }
        if next != NONE {
            self.held[next as usize].before = before;
        }
        let mut at = square;
        while at != NONE {
            let Square { parent, count, .. } = &mut self.squares[at as usize];
            *count -= 1;
            let (parent, empty) = (*parent, *count == 0);
            if empty && parent != NONE {
                for quarter in &mut self.squares[parent as usize].quarters {
                    if *quarter == at {
                        *quarter = NONE;
                    }
                }
                self.free.push(at);
            }
            at = parent;
        }
    }

    /// Visits the edges whose bounds meet a box and are not to the right of one of some lines as a whole. Gives back how many
    /// squares and edges it has looked at.
    pub(super) fn near(&self, within: Bounds, lines: &[Line], visit: impl FnMut(u32)) -> usize {
        let mut search = Search { index: self, within, lines, beyond: 0, looked: 0, visit };
        if !self.squares.is_empty() {
            search.open(0);
        }
        search.looked
    }
}

struct Search<'a, F> {
    index: &'a Index,
    within: Bounds,
    lines: &'a [Line],
    /// The line that had the last of what was passed over to its right: neighbours lie there too.
    beyond: usize,
    looked: usize,
    visit: F,
}

impl<F: FnMut(u32)> Search<'_, F> {
    fn is_out(&mut self, bounds: &Bounds) -> bool {
        self.looked += 1;
        let beyond = |line: &Line| line.has_right(bounds.low, bounds.high);
        if !bounds.meets(&self.within) || self.lines.get(self.beyond).is_some_and(beyond) {
            return true;
        }
        let found = self.lines.iter().position(beyond);
        self.beyond = found.unwrap_or(self.beyond);
        found.is_some()
    }

    fn open(&mut self, number: u32) {
        let index = self.index;
        let square = &index.squares[number as usize];
        if square.count == 0 || self.is_out(&square.reach) {
            return;
        }
        let mut edge = square.first;
        while edge != NONE {
            let held = &index.held[edge as usize];
            if !self.is_out(&held.bounds) {
                (self.visit)(edge);
            }
            edge = held.next;
        }
        for quarter in square.quarters {
            if quarter != NONE {
                self.open(quarter);
            }
        }
    }
}
