//! A region of the plane, held as the lines that bound it.

use super::convex::Convex;
use super::grid::{Line, Point, UNITS};

/// No edge.
pub(super) const NONE: u32 = u32::MAX;

/// The finest strips of the index are 2^19 units wide, about 0.5 mm.
const FINEST: u32 = 19;
/// From there to strips that hold any edge on the grid.
const LEVELS: usize = 13;

/// An edge runs from where the edge before meets its line to where the next one does; the region is to its left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub line: Line,
    /// Where it starts, `[z, r]` in mm: worked out from the lines.
    pub start: [f64; 2],
    pub before: u32,
    pub next: u32,
    /// Bounds in grid units, rounded outwards.
    low: Point,
    high: Point,
    /// Where the index has it.
    level: u8,
    strip: u32,
    pub alive: bool,
}

/// A closed contour of a region, `[z, r]` in mm.
pub type Ring = Vec<[f64; 2]>;

/// Twice the area that a ring goes round, positive counter-clockwise; mm².
#[must_use]
pub fn twice_area(ring: &[[f64; 2]]) -> f64 {
    let Some(&[z0, r0]) = ring.first() else { return 0.0 };
    let ends = ring.iter().cycle().skip(1);
    ring.iter().zip(ends).map(|(one, two)| (one[0] - z0) * (two[1] - r0) - (two[0] - z0) * (one[1] - r0)).sum()
}

/// A bounded region of the half-plane or plane, of any number of pieces with any number of holes.
///
/// Edges lie in an index by strips of z: at the level whose strips are just wider than the edge, in the strip where it
/// begins, so that each edge is in one place and a search looks at few strips besides those with edges near.
#[derive(Clone, Debug, Default)]
pub struct Region {
    pub(super) edges: Vec<Edge>,
    free: Vec<u32>,
    /// By level, then by strip from `first` on.
    strips: Vec<Vec<Vec<u32>>>,
    /// How many edges a level has.
    counts: [usize; LEVELS],
    /// The least z, below which no edge begins.
    first: i64,
    alive: usize,
    /// The greatest r that there was at the start, mm.
    top: f64,
}

fn strip(first: i64, z: i64, level: usize) -> usize {
    usize::try_from((z - first).max(0) >> (FINEST as usize + level)).unwrap_or(0)
}

impl Region {
    /// The region inside simple polygons on the grid that do not touch one another: counter-clockwise for pieces,
    /// clockwise for holes. Corners on a line with their neighbours are dropped. A ring of fewer than three corners is
    /// none.
    #[must_use]
    pub fn new(rings: &[Vec<Point>]) -> Self {
        let mut region = Self::default();
        let all = || rings.iter().flatten();
        let Some(first) = all().map(|point| point.z).min() else { return region };
        // Edges' bounds are rounded outwards by a unit or two.
        region.first = first - 8;
        let last = all().map(|point| point.z).max().unwrap_or(first);
        region.strips = (0..LEVELS).map(|level| vec![Vec::new(); strip(region.first, last, level) + 1]).collect();
        for ring in rings {
            region.add_ring(ring);
        }
        region.top = all().map(|point| point.mm()[1]).fold(f64::NEG_INFINITY, f64::max);
        region
    }

    /// Adds a ring of grid points.
    pub(super) fn add_ring(&mut self, ring: &[Point]) {
        let mut lines: Vec<Line> = Vec::new();
        for (&from, &to) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            if from != to {
                let line = Line::through(from, to);
                if lines.last().is_none_or(|last| !last.same(line)) {
                    lines.push(line);
                }
            }
        }
        while let [first, .., last] = lines[..]
            && first.same(last)
        {
            lines.pop();
        }
        if lines.len() < 3 {
            return;
        }
        let slots: Vec<u32> = lines.iter().map(|&line| self.take(line)).collect();
        let count = slots.len();
        for at in 0..count {
            let (edge, before) = (slots[at], slots[(at + count - 1) % count]);
            self.link(before, edge);
            let start = self.edges[before as usize].line.meets(self.edges[edge as usize].line);
            self.edges[edge as usize].start = start;
        }
        for edge in slots {
            self.place(edge);
        }
    }

    /// A new edge on a line, not yet linked nor in the index.
    pub(super) fn take(&mut self, line: Line) -> u32 {
        let edge = Edge {
            line,
            start: [0.0; 2],
            before: NONE,
            next: NONE,
            low: Point::default(),
            high: Point::default(),
            level: u8::MAX,
            strip: 0,
            alive: true,
        };
        self.alive += 1;
        if let Some(slot) = self.free.pop() {
            self.edges[slot as usize] = edge;
            slot
        } else {
            self.edges.push(edge);
            u32::try_from(self.edges.len() - 1).unwrap_or(NONE)
        }
    }

    /// Takes an edge out.
    pub(super) fn release(&mut self, edge: u32) {
        self.unplace(edge);
        self.edges[edge as usize].alive = false;
        self.alive -= 1;
        self.free.push(edge);
    }

    pub(super) fn link(&mut self, before: u32, next: u32) {
        self.edges[before as usize].next = next;
        self.edges[next as usize].before = before;
    }

    fn unplace(&mut self, edge: u32) {
        let Edge { level, strip, .. } = self.edges[edge as usize];
        if level == u8::MAX {
            return;
        }
        let held = &mut self.strips[usize::from(level)][strip as usize];
        if let Some(at) = held.iter().position(|&other| other == edge) {
            held.swap_remove(at);
            self.counts[usize::from(level)] -= 1;
        }
        self.edges[edge as usize].level = u8::MAX;
    }

    /// Works out an edge's bounds and puts it into the index, anew where it has to be elsewhere.
    pub(super) fn place(&mut self, edge: u32) {
        let [from, to] = self.ends(edge);
        // A unit outwards: corners in floating point are right to far less.
        #[expect(clippy::cast_possible_truncation, reason = "corners of polygons on the grid")]
        let bound = |axis: usize| {
            let (low, high) = (from[axis].min(to[axis]) * UNITS, from[axis].max(to[axis]) * UNITS);
            (low.floor() as i64 - 1, high.ceil() as i64 + 1)
        };
        let (z, r) = (bound(0), bound(1));
        let wide = (z.1 - z.0) >> FINEST;
        let level = (0..LEVELS - 1).find(|&level| wide >> level == 0).unwrap_or(LEVELS - 1);
        let strip = strip(self.first, z.0, level).min(self.strips[level].len() - 1);
        let at = &mut self.edges[edge as usize];
        (at.low, at.high) = (Point { z: z.0, r: r.0 }, Point { z: z.1, r: r.1 });
        if usize::from(at.level) == level && at.strip as usize == strip {
            return;
        }
        self.unplace(edge);
        let at = &mut self.edges[edge as usize];
        at.level = u8::try_from(level).unwrap_or(u8::MAX);
        at.strip = u32::try_from(strip).unwrap_or(u32::MAX);
        self.strips[level][strip].push(edge);
        self.counts[level] += 1;
    }

    /// Where an edge starts and ends, mm.
    pub(super) fn ends(&self, edge: u32) -> [[f64; 2]; 2] {
        let at = &self.edges[edge as usize];
        [at.start, self.edges[at.next as usize].start]
    }

    /// The least and the greatest coordinates of an edge, in grid units, rounded outwards.
    pub(super) fn bounds(&self, edge: u32) -> (Point, Point) {
        let at = &self.edges[edge as usize];
        (at.low, at.high)
    }

    /// Visits every edge whose bounds meet a box.
    pub(super) fn near(&self, low: Point, high: Point, mut visit: impl FnMut(u32)) {
        if high.z < self.first {
            return;
        }
        for (level, strips) in self.strips.iter().enumerate() {
            if self.counts[level] == 0 {
                continue;
            }
            let from = strip(self.first, low.z, level).saturating_sub(1).min(strips.len());
            let to = strip(self.first, high.z, level).min(strips.len() - 1);
            for held in strips.get(from..=to).into_iter().flatten() {
                for &edge in held {
                    let at = &self.edges[edge as usize];
                    if at.low.z <= high.z && low.z <= at.high.z && at.low.r <= high.r && low.r <= at.high.r {
                        visit(edge);
                    }
                }
            }
        }
    }

    /// True where a point of the plane, `[z, r]` in mm, lies in the region; undecided on its edge.
    ///
    /// Edges above the point are counted, each with its lower end and without its higher one along z.
    #[must_use]
    pub fn contains(&self, [z, r]: [f64; 2]) -> bool {
        let Some(at) = Point::near([z, r]).filter(|_| r <= self.top) else { return false };
        let (low, high) = (Point { z: at.z - 1, r: -super::grid::LIMIT }, Point { z: at.z + 1, r: super::grid::LIMIT });
        let mut inside = false;
        self.near(low, high, |edge| {
            let [from, to] = self.ends(edge);
            if (from[0] > z) != (to[0] > z) && r < from[1] + (to[1] - from[1]) * (z - from[0]) / (to[0] - from[0]) {
                inside = !inside;
            }
        });
        inside
    }

    /// The number of edges.
    #[must_use]
    pub fn len(&self) -> usize {
        self.alive
    }

    /// True where nothing is left.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.alive == 0
    }

    /// The least and greatest `[z, r]`, mm; `None` where nothing is left.
    #[must_use]
    pub fn extent(&self) -> Option<([f64; 2], [f64; 2])> {
        let starts = || self.edges.iter().filter(|edge| edge.alive).map(|edge| edge.start);
        let mut all = starts();
        let first = all.next()?;
        Some(all.fold((first, first), |(low, high), point| {
            ([low[0].min(point[0]), low[1].min(point[1])], [high[0].max(point[0]), high[1].max(point[1])])
        }))
    }

    /// One edge of each ring.
    pub(super) fn ring_edges(&self) -> Vec<u32> {
        let mut seen = vec![false; self.edges.len()];
        let mut found = Vec::new();
        for edge in 0..self.edges.len() {
            if self.edges[edge].alive && !seen[edge] {
                let edge = u32::try_from(edge).unwrap_or(NONE);
                found.push(edge);
                self.around(edge, |edge| seen[edge as usize] = true);
            }
        }
        found
    }

    /// Visits the edges of a ring, from one of them on.
    pub(super) fn around(&self, edge: u32, mut visit: impl FnMut(u32)) {
        let mut at = edge;
        loop {
            visit(at);
            at = self.edges[at as usize].next;
            if at == edge {
                return;
            }
        }
    }

    /// The ring of an edge.
    pub(super) fn ring(&self, edge: u32) -> Ring {
        let mut ring = Ring::new();
        self.around(edge, |edge| ring.push(self.edges[edge as usize].start));
        let first =
            (0..ring.len()).min_by(|&a, &b| ring[a][0].total_cmp(&ring[b][0]).then(ring[a][1].total_cmp(&ring[b][1])));
        ring.rotate_left(first.unwrap_or(0));
        ring
    }

    /// All contours: pieces counter-clockwise, holes clockwise, each from its corner of least z (and among those, of least
    /// r) on; those that begin at less z first.
    #[must_use]
    pub fn rings(&self) -> Vec<Ring> {
        let mut rings: Vec<_> = self.ring_edges().into_iter().map(|edge| self.ring(edge)).collect();
        rings.sort_by(|one, two| one[0][0].total_cmp(&two[0][0]).then(one[0][1].total_cmp(&two[0][1])));
        rings
    }

    /// Takes a whole ring out.
    pub(super) fn release_ring(&mut self, edge: u32) {
        let mut slots = Vec::new();
        self.around(edge, |edge| slots.push(edge));
        for slot in slots {
            self.release(slot);
        }
    }

    /// Adds a hole: the outline of a convex polygon that lies inside the region.
    pub(super) fn add_hole(&mut self, hole: &Convex) {
        let ring: Vec<_> = hole.corners().iter().rev().copied().collect();
        self.add_ring(&ring);
    }
}
