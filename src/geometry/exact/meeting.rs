//! Where a convex polygon meets a region: what of the region's edges is inside it, and what of its own are inside the
//! region.

use std::cmp::Ordering;

use super::convex::{Convex, Origin};
use super::grid::{Line, Point};
use super::index::NONE;
use super::region::Region;

/// A stretch of an edge, `[z, r]` in mm, with the region to its left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Where it starts.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
}

/// An edge of the region of which a stretch is in the polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub edge: u32,
    /// The polygon's edges over which its line gets in and out.
    into: usize,
    out: usize,
    /// Its start is out yet: it has a head that stays.
    pub head: bool,
    /// Its end is out again: it has a tail that stays.
    pub tail: bool,
    /// Its line runs along the polygon's edge of this number.
    along: Option<usize>,
}

/// A place where the region's contour gets into the polygon or out of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gate {
    pub hit: usize,
    /// In, not out.
    pub inward: bool,
    /// The polygon's edge it lies on.
    side: usize,
    /// It is the first corner of that edge.
    corner: bool,
    /// A line across that edge through the place.
    across: Line,
    /// The way of what is taken away, from the place.
    way: Point,
    /// The place, mm.
    pub at: [f64; 2],
}

/// A stretch of the polygon's outline in the region, clockwise: the new contour from a gate in to a gate out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chain {
    pub inward: usize,
    pub outward: usize,
    /// The polygon's edge it begins on, and how many it runs along, each less by one.
    pub first: usize,
    pub count: usize,
}

/// What a convex polygon and a region have in common, as stretches of both outlines. Kept and filled again, it allocates
/// nothing more.
#[derive(Clone, Debug, Default)]
pub struct Meeting {
    pub(super) hits: Vec<Hit>,
    /// The hit of an edge by its number.
    hit_of: Vec<u32>,
    pub(super) gates: Vec<Gate>,
    pub(super) chains: Vec<Chain>,
    /// The stretches of the region's contour inside the polygon.
    pub removed: Vec<Stretch>,
    /// The label of the edge that each of them is of.
    pub labels: Vec<u32>,
    /// The stretches of the polygon's outline inside the region, clockwise, with what made the edge.
    pub inserted: Vec<(Stretch, Origin)>,
    /// How many edges of the region, and squares that hold some, were looked at to find it.
    pub looked: usize,
    /// The polygon lies inside the region as a whole.
    pub(super) hole: bool,
    around: Vec<i64>,
    main: Vec<Line>,
}

impl Meeting {
    /// True where polygon and region have no area in common.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.hits.is_empty() && !self.hole
    }

    /// Finds what a polygon has in common with a region. Outlines that touch have nothing in common.
    pub fn find(&mut self, region: &Region, polygon: &Convex) {
        for hit in &self.hits {
            self.hit_of[hit.edge as usize] = NONE;
        }
        self.hits.clear();
        self.gates.clear();
        self.chains.clear();
        self.removed.clear();
        self.labels.clear();
        self.inserted.clear();
        (self.looked, self.hole) = (0, false);
        if polygon.is_empty() {
            return;
        }
        self.hit_of.resize(region.edges.len().max(self.hit_of.len()), NONE);
        let (low, high) = polygon.extent();
        // Most of what is near lies beyond one of the long edges, or beyond one in four of those that make an arc.
        let long = (high.z - low.z).max(high.r - low.r) / 16;
        let some = |&(at, line): &(usize, &Line)| at % 4 == 0 || line.direction().size() > long;
        self.main.clear();
        self.main.extend(polygon.lines().iter().enumerate().filter(some).map(|(_, line)| line));
        let (hits, around) = (&mut self.hits, &mut self.around);
        self.looked = region.near(low, high, &self.main, |edge| hits.extend(hit(region, polygon, edge, around)));
        for (at, hit) in self.hits.iter().enumerate() {
            self.hit_of[hit.edge as usize] = u32::try_from(at).unwrap_or(NONE);
        }
        self.find_gates(region, polygon);
        if self.gates.is_empty() {
            self.find_hole(region, polygon);
        } else {
            self.find_chains(polygon);
        }
        self.draw(region, polygon);
    }

    /// Gates are where, along the contour, what is out is followed by what is in or the other way.
    fn find_gates(&mut self, region: &Region, polygon: &Convex) {
        let (hit_of, hits) = (&self.hit_of, &self.hits);
        let other = |edge: u32| hits.get(hit_of[edge as usize] as usize);
        for (number, hit) in hits.iter().enumerate() {
            let edge = &region.edges[hit.edge as usize];
            for inward in [true, false] {
                let (crossed, neighbour) = if inward { (hit.head, edge.before) } else { (hit.tail, edge.next) };
                let beside = other(neighbour);
                let goes_on = beside.is_some_and(|beside| if inward { !beside.tail } else { !beside.head });
                if !crossed && goes_on {
                    continue;
                }
                let neighbour = region.edges[neighbour as usize].line;
                let (side, corner, across) = place(polygon, hit, edge.line, (crossed, inward), neighbour);
                let way = edge.line.direction();
                let way = if inward { way } else { Point { z: -way.z, r: -way.r } };
                let at = match (corner, crossed) {
                    (true, _) => polygon.corners()[side].mm(),
                    (false, true) => edge.line.meets(polygon.lines()[side]),
                    (false, false) if inward => edge.start,
                    (false, false) => region.edges[edge.next as usize].start,
                };
                self.gates.push(Gate { hit: number, inward, side, corner, across, way, at });
            }
        }
        self.gates.sort_by(|one, two| order(polygon, one, two));
    }

    /// Clockwise along the polygon, each gate in is followed by a gate out: between them the polygon's outline is in the
    /// region and becomes its contour.
    fn find_chains(&mut self, polygon: &Convex) {
        let (gates, count) = (&self.gates, polygon.len());
        for (inward, gate) in gates.iter().enumerate().filter(|(_, gate)| gate.inward) {
            let outward = (inward + gates.len() - 1) % gates.len();
            let to = &gates[outward];
            debug_assert!(!to.inward, "a contour gets in twice");
            let first = if gate.corner { (gate.side + count - 1) % count } else { gate.side };
            // The gate out comes before the gate in, counter-clockwise, unless the chain goes round past corner 0.
            let round = outward > inward;
            let edges = match (gate.corner, to.corner) {
                (false, false) if gate.side == to.side => match (round, order_along(polygon, gate, to)) {
                    (true, _) => count + 1,
                    (false, Ordering::Equal) => 0,
                    (false, _) => 1,
                },
                (true, true) if gate.side == to.side => {
                    if round {
                        count
                    } else {
                        0
                    }
                }
                _ => (first + count - to.side) % count + 1,
            };
            self.chains.push(Chain { inward, outward, first, count: edges });
        }
    }

    /// Without a gate, the polygon lies inside the region or outside it, but for rings that it covers.
    fn find_hole(&mut self, region: &Region, polygon: &Convex) {
        let corners = polygon.corners();
        #[expect(clippy::cast_precision_loss, reason = "a count of corners")]
        let share = 1.0 / corners.len() as f64;
        let centre = corners
            .iter()
            .map(|corner| corner.mm())
            .fold([0.0; 2], |sum, [z, r]| [sum[0] + z * share, sum[1] + r * share]);
        // Rings that the polygon covers do not count: what is taken away of them is no edge any more.
        let mut covered = false;
        for hit in &self.hits {
            let [from, to] = region.ends(hit.edge);
            let [z, r] = centre;
            if (from[0] > z) != (to[0] > z) && r < from[1] + (to[1] - from[1]) * (z - from[0]) / (to[0] - from[0]) {
                covered = !covered;
            }
        }
        self.hole = region.contains(centre) != covered;
    }

    fn draw(&mut self, region: &Region, polygon: &Convex) {
        for hit in &self.hits {
            let [start, end] = region.ends(hit.edge);
            let line = region.edges[hit.edge as usize].line;
            let from = if hit.head { line.meets(polygon.lines()[hit.into]) } else { start };
            let to = if hit.tail { line.meets(polygon.lines()[hit.out]) } else { end };
            self.removed.push(Stretch { from, to });
            self.labels.push(region.edges[hit.edge as usize].label);
        }
        let count = polygon.len();
        let mut insert = |from: [f64; 2], to: [f64; 2], side: usize| {
            self.inserted.push((Stretch { from, to }, polygon.origins()[side]));
        };
        for chain in &self.chains {
            let mut from = self.gates[chain.inward].at;
            for step in 0..chain.count {
                let side = (chain.first + 2 * count - step) % count;
                let to =
                    if step + 1 == chain.count { self.gates[chain.outward].at } else { polygon.corners()[side].mm() };
                insert(from, to, side);
                from = to;
            }
        }
        if self.hole {
            for side in (0..count).rev() {
                insert(polygon.corners()[(side + 1) % count].mm(), polygon.corners()[side].mm(), side);
            }
        }
    }
}

/// What of an edge is taken away with a polygon, if anything.
///
/// The polygon's corners lie on both sides of the edge's line, and then the line gets in over one of its edges and out
/// over another; or the line only touches it, and then nothing inside is on the line. A line that runs along an edge of
/// the polygon has the region and the polygon on one side, and then the region beside that edge is taken away and the
/// stretch of the edge with it; or on two sides, and then the stretch stays.
fn hit(region: &Region, polygon: &Convex, number: u32, around: &mut Vec<i64>) -> Option<Hit> {
    let edge = &region.edges[number as usize];
    let (line, lines, count) = (edge.line, polygon.lines(), polygon.len());
    around.clear();
    around.extend(polygon.corners().iter().map(|&corner| line.at(corner).signum()));
    if !around.contains(&1) {
        return None;
    }
    let (mut into, mut out, mut along) = (None, None, None);
    // Each edge goes from the corner before, which has its number.
    let (mut side, mut here) = (count - 1, around[count - 1]);
    for (at, &then) in around.iter().enumerate() {
        match (here, then) {
            (1, 0 | -1) => into = Some(side),
            (-1, 0 | 1) => out = Some(side),
            (0, 0) => along = Some(side),
            _ => {}
        }
        (side, here) = (at, then);
    }
    let (into, out, along) = match (into, out, along) {
        (Some(into), Some(out), _) => (into, out, None),
        // Only the edge that it runs along touches it, and the polygon is to its left.
        (_, _, Some(along)) => ((along + count - 1) % count, (along + 1) % count, Some(along)),
        _ => return None,
    };
    let (before, next) = (region.edges[edge.before as usize].line, region.edges[edge.next as usize].line);
    // The polygon is to the left of its edges: an end to the left of the first has got in, to the left of the second is
    // not yet out.
    let start_in = lines[into].side(before, line);
    let end_in = lines[into].side(line, next);
    let start_out = lines[out].side(before, line);
    let end_out = lines[out].side(line, next);
    (end_in.is_gt() && start_out.is_gt()).then(|| Hit {
        edge: number,
        into,
        out,
        head: start_in.is_lt(),
        tail: end_out.is_lt(),
        along,
    })
}

/// On which edge of the polygon a gate lies, whether at its first corner, and a line across that edge through it.
fn place(
    polygon: &Convex,
    hit: &Hit,
    line: Line,
    (crossed, inward): (bool, bool),
    neighbour: Line,
) -> (usize, bool, Line) {
    let count = polygon.len();
    if let Some(along) = hit.along {
        let corner = if inward { along } else { (along + 1) % count };
        let lines = polygon.lines();
        let at_corner = crossed || {
            // An end of the edge within the polygon's edge, or at its corner.
            let beyond = if inward { lines[(along + count - 1) % count] } else { lines[corner] };
            beyond.side(line, neighbour).is_eq()
        };
        return if at_corner { (corner, true, line) } else { (along, false, neighbour) };
    }
    let side = if inward { hit.into } else { hit.out };
    let next = (side + 1) % count;
    if line.at(polygon.corners()[next]) == 0 { (next, true, line) } else { (side, false, line) }
}

/// The order of two gates inside one edge of the polygon.
fn order_along(polygon: &Convex, one: &Gate, two: &Gate) -> Ordering {
    let line = polygon.lines()[one.side];
    // Along the edge, the first gate's line across goes from one sign to the other.
    let side = one.across.side(two.across, line);
    if one.across.direction().cross(line.direction()) > 0 { side.reverse() } else { side }
}

/// The order of gates counter-clockwise along the polygon. Gates at one place go by where they cross an outline a hair
/// further in: the more backward their way, the earlier.
fn order(polygon: &Convex, one: &Gate, two: &Gate) -> Ordering {
    one.side
        .cmp(&two.side)
        .then_with(|| two.corner.cmp(&one.corner))
        .then_with(|| if one.corner { Ordering::Equal } else { order_along(polygon, one, two) })
        .then_with(|| match one.way.cross(two.way).cmp(&0) {
            Ordering::Equal if one.way.dot(two.way) < 0 => one.way.dot(polygon.lines()[one.side].direction()).cmp(&0),
            turn => turn,
        })
}
