//! Taking a convex polygon away from a region.

use super::convex::Convex;
use super::index::NONE;
use super::meeting::Meeting;
use super::region::{Labelled, Region, encloses, twice_area};

/// What became of the pieces of a region.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CutEffect {
    /// Nothing was taken away.
    Missed,
    /// As many contours as before.
    Whole,
    /// Contours may have come or gone: pieces apart, or a hole.
    Apart,
}

impl Region {
    /// Takes away what [`Meeting::find`] found of a polygon. Costs as much as the edges near the polygon, and a walk along
    /// the contour where the polygon cuts through it in more than one place.
    ///
    /// The new edges get the labels of the stretches inserted, in their order, and 0 where there are fewer; one that carries on
    /// an edge that was there keeps that edge's.
    pub fn cut(&mut self, polygon: &Convex, meeting: &Meeting, labels: &[u32]) -> CutEffect {
        if meeting.is_empty() {
            return CutEffect::Missed;
        }
        // What stays of the edges that were hit: a head up to the polygon, a tail after it.
        let mut tails = vec![NONE; meeting.hits.len()];
        for (hit, tail) in meeting.hits.iter().zip(&mut tails) {
            *tail = match (hit.head, hit.tail) {
                (true, true) => {
                    let edge = self.edges[hit.edge as usize];
                    let slot = self.take(edge.line);
                    self.edges[slot as usize].label = edge.label;
                    self.link(slot, edge.next);
                    slot
                }
                (false, true) => hit.edge,
                _ => NONE,
            };
        }
        let mut joints: Vec<(u32, u32)> = (meeting.chains.iter())
            .map(|chain| {
                let (inward, outward) = (meeting.gates[chain.inward].hit, meeting.gates[chain.outward].hit);
                let (into, out) = (meeting.hits[inward], meeting.hits[outward]);
                let before = if into.head { into.edge } else { self.edges[into.edge as usize].before };
                let after = if out.tail { tails[outward] } else { self.edges[out.edge as usize].next };
                (before, after)
            })
            .collect();
        let mut changed = Vec::with_capacity(2 * joints.len());
        let mut labels = labels.iter().copied();
        for at in 0..joints.len() {
            let kept = self.join(polygon, meeting, (at, &mut labels), joints[at], &mut changed);
            // The contour that followed on the same line is one edge with what comes before it.
            if let Some((gone, one)) = kept {
                for joint in &mut joints {
                    for end in [&mut joint.0, &mut joint.1] {
                        if *end == gone {
                            *end = one;
                        }
                    }
                }
            }
        }
        for hit in &meeting.hits {
            if !hit.head && !hit.tail {
                self.release(hit.edge);
            }
        }
        for edge in changed {
            if self.edges[edge as usize].alive {
                self.place(edge);
            }
        }
        if meeting.hole {
            self.add_hole(polygon);
        }
        match joints[..] {
            [] => CutEffect::Apart,
            [_] => CutEffect::Whole,
            [(first, _), ..] => {
                let mut met = 0;
                let mut ring = Vec::new();
                self.around(first, |edge| ring.push(edge));
                ring.sort_unstable();
                for (before, _) in &joints {
                    met += usize::from(ring.binary_search(before).is_ok());
                }
                if met == joints.len() { CutEffect::Whole } else { CutEffect::Apart }
            }
        }
    }

    /// Draws a chain of new edges between two that stay. What is on one line becomes one edge; where that takes the second
    /// of them, it is given back with the edge it is now part of.
    fn join(
        &mut self,
        polygon: &Convex,
        meeting: &Meeting,
        (number, labels): (usize, &mut impl Iterator<Item = u32>),
        (before, after): (u32, u32),
        changed: &mut Vec<u32>,
    ) -> Option<(u32, u32)> {
        let (chain, count) = (&meeting.chains[number], polygon.len());
        let (start, end) = (meeting.gates[chain.inward].at, meeting.gates[chain.outward].at);
        changed.push(before);
        let (mut last, mut from) = (before, start);
        for step in 0..chain.count {
            let side = (chain.first + 2 * count - step) % count;
            let line = polygon.lines()[side].reversed();
            let label = labels.next().unwrap_or_default();
            if !self.edges[last as usize].line.same(line) {
                let edge = self.take(line);
                self.edges[edge as usize].label = label;
                self.edges[edge as usize].start = from;
                self.link(last, edge);
                changed.push(edge);
                last = edge;
            }
            from = polygon.corners()[side].mm();
        }
        if last != after && self.edges[last as usize].line.same(self.edges[after as usize].line) {
            let next = self.edges[after as usize].next;
            self.edges[last as usize].next = next;
            // What comes next may have been joined to another chain already.
            if self.edges[next as usize].before == after {
                self.edges[next as usize].before = last;
            }
            self.release(after);
            return Some((after, last));
        }
        self.edges[after as usize].start = end;
        self.link(last, after);
        changed.push(after);
        None
    }

    /// Drops every piece but the one that reaches to the least z, with the holes in them; gives back the contours of the
    /// pieces dropped.
    pub fn keep_first(&mut self) -> Vec<Labelled> {
        let mut rings: Vec<_> = self.ring_edges().into_iter().map(|edge| (edge, self.ring(edge))).collect();
        if rings.len() < 2 {
            return Vec::new();
        }
        rings.sort_by(|(_, (one, _)), (_, (two, _))| {
            one[0][0].total_cmp(&two[0][0]).then(one[0][1].total_cmp(&two[0][1]))
        });
        let (outer, holes): (Vec<_>, Vec<_>) = rings.into_iter().partition(|(_, (ring, _))| twice_area(ring) > 0.0);
        let mut dropped = Vec::new();
        for (edge, ring) in outer.into_iter().skip(1) {
            for (hole, inner) in &holes {
                if inner.0.first().is_some_and(|&point| encloses(&ring.0, point)) && self.edges[*hole as usize].alive {
                    dropped.push(inner.clone());
                    self.release_ring(*hole);
                }
            }
            dropped.push(ring);
            self.release_ring(edge);
        }
        dropped
    }
}
