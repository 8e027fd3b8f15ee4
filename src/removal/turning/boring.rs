//! A boring bar that is fed along the axis: the hole that lies before it, and the one that it needs.

use super::alarm::{Cause, TOUCH};
use super::contact::bounds;
use super::outline::{Outline, Role};
use super::path::Piece;
use super::tool::{Cutter, Holder, TurningTool};
use super::workpiece::Workpiece;
use crate::geometry::exact::convex::Convex;

/// A hole that a boring bar is fed into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hole {
    /// Its diameter at its narrowest, mm; 0 where there is none.
    pub diameter: f64,
    /// The least diameter that bar and edge need on their way, mm.
    pub least: f64,
    /// Where the bar's end stands as the way begins: what it meets past it lies before it, and not beside; on the grid, mm.
    pub end: f64,
}

impl Hole {
    /// The hole along a straight way, before it is cut, `[z, r]` on the grid; `None` where the way does not lead towards the
    /// chuck, the tool is none for turning on a bar between its tip and the axis, and where no metal lies nearer to the axis
    /// than the tip.
    ///
    /// # Derivation
    /// With its tip at the radius r the edge takes what lies out from r − e, where e is how far its cutting edges reach towards
    /// the axis before the bar's end comes; what is nearer to it has to be gone before. The bar of diameter d with its centre c from the tip reaches over
    /// the axis to c + d/2 − r on the other side, and goes into no hole of less than c + d/2.
    pub fn before(part: &mut Workpiece, tool: &TurningTool, outline: &Outline, [from, to]: Piece) -> Option<Self> {
        let (Cutter::Insert { .. }, Holder::Bar { diameter, reach, .. }) = (tool.cutter, tool.holder) else {
            return None;
        };
        let (small, great) = (from[1].min(to[1]), from[1].max(to[1]));
        if tool.tip.mirror()[1] > 0.0 || to[0] >= from[0] || small <= 0.0 {
            return None;
        }
        let end = outline.holder.iter().map(|body| body.extent().0.mm()[0]).fold(f64::INFINITY, f64::min);
        // What the bar's own end passes: the edge before it may go on into the bottom.
        let [deep, high] = [to[0] + end, from[0] + end];
        let corners = [[deep, -great], [high, -great], [high, great], [deep, great]];
        let mut narrowest = f64::INFINITY;
        part.probe(&Convex::hull_mm(&corners)?, |meeting, _| {
            let radii = bounds(meeting).flat_map(|one| [one.from[1].abs(), one.to[1].abs()]);
            narrowest = radii.fold(narrowest, f64::min);
        });
        let bar = reach + diameter / 2.0;
        let least = (2.0 * (great - depth(outline, end)).max(bar - small)).max(bar);
        narrowest.is_finite().then(|| Self { diameter: 2.0 * narrowest, least, end: from[0] + end })
    }

    /// True where there is none.
    pub fn is_solid(&self) -> bool {
        self.diameter < TOUCH
    }

    /// What is wrong where the bar itself has met metal at a place past its end, or there is no hole.
    pub fn cause(&self) -> Option<Cause> {
        (self.diameter < self.least - TOUCH)
            .then_some(Cause::BoreWithoutHole { hole: self.diameter, least: self.least })
    }
}

/// How far the cutting edges reach from the programmed point towards the axis before the bar's end, mm: an edge that leans back
/// cuts behind it what the bar has met already.
fn depth(outline: &Outline, end: f64) -> f64 {
    let mut deepest = 0.0_f64;
    for part in &outline.cutter {
        let corners = part.polygon.corners();
        for (at, _) in part.roles.iter().enumerate().filter(|(_, role)| **role != Role::Back) {
            let [from, to] = [corners[at], corners[(at + 1) % corners.len()]].map(|corner| corner.mm());
            let crossing = (end - from[0]) / (to[0] - from[0]);
            let across = from[1] + (to[1] - from[1]) * crossing;
            let clipped = [from, to].into_iter().filter(|[z, _]| *z <= end).map(|[_, r]| r);
            let crossed = (0.0..=1.0).contains(&crossing).then_some(across);
            deepest = clipped.chain(crossed).fold(deepest, |deepest, r| deepest.max(-r));
        }
    }
    deepest
}
