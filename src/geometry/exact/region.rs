//! A region of the plane, held as the lines that bound it.

use super::convex::Convex;
use super::grid::{Line, Point, UNITS};
use super::index::{Bounds, Index, NONE};

/// An edge runs from where the edge before meets its line to where the next one does; the region is to its left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub line: Line,
    /// Where it starts, `[z, r]` in mm: worked out from the lines.
    pub start: [f64; 2],
    pub before: u32,
    pub next: u32,
    pub alive: bool,
    /// What the caller has said of it when it was cut; 0 of the first outline.
    pub label: u32,
}

/// A closed contour of a region, `[z, r]` in mm.
pub type Ring = Vec<[f64; 2]>;

/// A closed contour, and the labels of the edges that begin at its corners.
pub type Labelled = (Ring, Vec<u32>);

/// Twice the area that a ring goes round, positive counter-clockwise; mm².
#[must_use]
pub fn twice_area(ring: &[[f64; 2]]) -> f64 {
    let Some(&[z0, r0]) = ring.first() else { return 0.0 };
    let ends = ring.iter().cycle().skip(1);
    ring.iter().zip(ends).map(|(one, two)| (one[0] - z0) * (two[1] - r0) - (two[0] - z0) * (one[1] - r0)).sum()
}

/// True where a ring goes round a point, `[z, r]` in mm, by the number of its edges above.
#[must_use]
pub fn encloses(ring: &[[f64; 2]], [z, r]: [f64; 2]) -> bool {
    let edges = ring.iter().zip(ring.iter().cycle().skip(1));
    edges
        .filter(|(from, to)| {
            (from[0] > z) != (to[0] > z) && r < from[1] + (to[1] - from[1]) * (z - from[0]) / (to[0] - from[0])
        })
        .count()
        % 2
        == 1
}

/// A bounded region of the half-plane or plane, of any number of pieces with any number of holes.
#[derive(Clone, Debug, Default)]
pub struct Region {
    pub(super) edges: Vec<Edge>,
    free: Vec<u32>,
    index: Index,
    alive: usize,
    /// The greatest r that there was at the start, mm.
    top: f64,
}

impl Region {
    /// The region inside simple polygons on the grid that do not touch one another: counter-clockwise for pieces,
    /// clockwise for holes. Corners on a line with their neighbours are dropped. A ring of fewer than three corners is
    /// none.
    #[must_use]
    pub fn new(rings: &[Vec<Point>]) -> Self {
        Self::labelled(rings, &[])
    }

    /// The same, with the labels of the edges that begin at the corners of each ring; 0 where there are fewer. Of edges on one
    /// line the greatest label stays.
    #[must_use]
    pub fn labelled(rings: &[Vec<Point>], labels: &[Vec<u32>]) -> Self {
        let mut region = Self::default();
        let all = || rings.iter().flatten();
        let Some(&first) = all().next() else { return region };
        let (low, high) = all().fold((first, first), |(low, high), point| {
            (
                Point { z: low.z.min(point.z), r: low.r.min(point.r) },
                Point { z: high.z.max(point.z), r: high.r.max(point.r) },
            )
        });
        // Edges' bounds are rounded outwards by a unit or two.
        let margin = Point { z: 8, r: 8 };
        region.index = Index::new(Bounds { low: margin.to(low), high: high.plus(margin) });
        let labels = labels.iter().map(Vec::as_slice).chain(std::iter::repeat(&[][..]));
        for (ring, labels) in rings.iter().zip(labels) {
            region.add_ring(ring, labels);
        }
        region.top = all().map(|point| point.mm()[1]).fold(f64::NEG_INFINITY, f64::max);
        region
    }

    /// Adds a ring of grid points, with the labels of the edges that begin at them.
    pub(super) fn add_ring(&mut self, ring: &[Point], labels: &[u32]) {
        let mut lines: Vec<(Line, u32)> = Vec::new();
        let labels = labels.iter().copied().chain(std::iter::repeat(0));
        for ((&from, &to), label) in ring.iter().zip(ring.iter().cycle().skip(1)).zip(labels) {
            if from != to {
                let line = Line::through(from, to);
                match lines.last_mut() {
                    Some((last, of)) if last.same(line) => *of = label.max(*of),
                    _ => lines.push((line, label)),
                }
            }
        }
        while let [(first, of), .., (last, label)] = &mut lines[..]
            && first.same(*last)
        {
            *of = (*label).max(*of);
            lines.pop();
        }
        if lines.len() < 3 {
            return;
        }
        let slots: Vec<u32> = lines.iter().map(|&(line, _)| self.take(line)).collect();
        let count = slots.len();
        for at in 0..count {
            let (edge, before) = (slots[at], slots[(at + count - 1) % count]);
            self.edges[edge as usize].label = lines[at].1;
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
        let edge = Edge { line, start: [0.0; 2], before: NONE, next: NONE, alive: true, label: 0 };
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
        self.index.take(edge);
        self.edges[edge as usize].alive = false;
        self.alive -= 1;
        self.free.push(edge);
    }

    pub(super) fn link(&mut self, before: u32, next: u32) {
        self.edges[before as usize].next = next;
        self.edges[next as usize].before = before;
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
        self.index.put(edge, Bounds { low: Point { z: z.0, r: r.0 }, high: Point { z: z.1, r: r.1 } });
    }

    /// Where an edge starts and ends, mm.
    pub(super) fn ends(&self, edge: u32) -> [[f64; 2]; 2] {
        let at = &self.edges[edge as usize];
        [at.start, self.edges[at.next as usize].start]
    }

    /// Visits the edges near the inside of some lines within a box: see [`Index::near`].
    pub(super) fn near(&self, low: Point, high: Point, lines: &[Line], visit: impl FnMut(u32)) -> usize {
        self.index.near(Bounds { low, high }, lines, visit)
    }

    /// True where a point of the plane, `[z, r]` in mm, lies in the region; undecided on its edge.
    ///
    /// Edges above the point are counted, each with its lower end and without its higher one along z.
    #[must_use]
    pub fn contains(&self, [z, r]: [f64; 2]) -> bool {
        let Some(at) = Point::near([z, r]).filter(|_| r <= self.top) else { return false };
        let (low, high) = (Point { z: at.z - 1, r: -super::grid::LIMIT }, Point { z: at.z + 1, r: super::grid::LIMIT });
        let mut inside = false;
        self.near(low, high, &[], |edge| {
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

    /// One edge of each ring that is left, by which [`Self::around`] visits it.
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

    /// The ring of an edge with its labels, from its corner of least z (and among those, of least r) on.
    pub(super) fn ring(&self, edge: u32) -> Labelled {
        let (mut ring, mut labels) = Labelled::default();
        self.around(edge, |edge| {
            ring.push(self.edges[edge as usize].start);
            labels.push(self.edges[edge as usize].label);
        });
        let first =
            (0..ring.len()).min_by(|&a, &b| ring[a][0].total_cmp(&ring[b][0]).then(ring[a][1].total_cmp(&ring[b][1])));
        ring.rotate_left(first.unwrap_or(0));
        labels.rotate_left(first.unwrap_or(0));
        (ring, labels)
    }

    /// All contours: pieces counter-clockwise, holes clockwise, each from its corner of least z (and among those, of least
    /// r) on; those that begin at less z first.
    #[must_use]
    pub fn rings(&self) -> Vec<Ring> {
        self.labelled_rings().into_iter().map(|(ring, _)| ring).collect()
    }

    /// The same, with the labels of their edges.
    #[must_use]
    pub fn labelled_rings(&self) -> Vec<Labelled> {
        let mut rings: Vec<_> = self.ring_edges().into_iter().map(|edge| self.ring(edge)).collect();
        rings.sort_by(|(one, _), (two, _)| one[0][0].total_cmp(&two[0][0]).then(one[0][1].total_cmp(&two[0][1])));
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
        self.add_ring(&ring, &[]);
    }
}
