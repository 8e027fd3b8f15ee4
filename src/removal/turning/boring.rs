//! A boring bar that feeds along the axis: the hole in front of it, and the hole that it needs.

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
    /// Its diameter at the narrowest place, mm; 0 if there is none.
    pub diameter: f64,
    /// The minimum diameter that bar and edge need on their path, mm.
    pub least: f64,
    /// The bar's end at the start of the path: metal that it meets beyond is in front of it, not beside it; on the grid, mm.
    pub end: f64,
}

impl Hole {
    /// The hole along a straight path before the cut, `[z, r]` on the grid. `None` if the path does not lead towards the chuck, if
    /// the tool is not a boring tool on a bar between its tip and the axis, or if no metal is nearer to the axis than the tip.
    ///
    /// # Derivation
    /// With its tip at the radius r, the edge cuts the metal from r − e outwards, where e is how far its cutting edges reach
    /// towards the axis in front of the bar's end; metal nearer to the axis must be gone before. The bar, of diameter d with its
    /// centre c from the tip, reaches across the axis to c + d/2 − r on the other side, and needs a hole of at least c + d/2 in diameter.
    pub fn before(part: &mut Workpiece, tool: &TurningTool, outline: &Outline, [from, to]: Piece) -> Option<Self> {
        let (Cutter::Insert { .. }, Holder::Bar { diameter, reach, .. }) = (tool.cutter, tool.holder) else {
            return None;
        };
        let (small, great) = (from[1].min(to[1]), from[1].max(to[1]));
        if tool.tip.mirror()[1] > 0.0 || to[0] >= from[0] || small <= 0.0 {
            return None;
        }
        let end = outline.holder.iter().map(|body| body.extent().0.mm()[0]).fold(f64::INFINITY, f64::min);
        // The area that the bar's own end passes: the edge in front of it may cut into the bottom.
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

    /// True if there is no hole.
    pub fn is_solid(&self) -> bool {
        self.diameter < TOUCH
    }

    /// The alarm if the bar itself has met metal beyond its end, or if there is no hole.
    pub fn cause(&self) -> Option<Cause> {
        (self.diameter < self.least - TOUCH)
            .then_some(Cause::BoreWithoutHole { hole: self.diameter, least: self.least })
    }
}

/// How far the cutting edges reach from the programmed point towards the axis in front of the bar's end, mm: an edge that leans
/// back cuts only metal that the bar has already met.
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
