//! What the nose makes in one uninterrupted way at feed, and whether the auxiliary edge takes it away again.
//!
//! Where a way turns inwards more steeply than the auxiliary edge stands, that edge goes ahead of the nose and cuts into the
//! surface that the nose has just made: the profile cannot be made by this tool. On the part it shows as a stretch that the
//! edge left in the place where it stood last, one end of it on that surface. A pass along a face, which the same edge may
//! cut, ends on what was there before or in the open. Derived here.

use super::outline::{Part, Role};
use crate::geometry::exact::convex::Origin;
use crate::geometry::exact::meeting::{Meeting, Stretch};
use crate::number::trig::hypot;

/// An end of a stretch lies on another one up to this, mm.
const ON: f64 = 1e-5;
/// What is taken away again up to this is none: a way as steep as the edge, mm.
const LEAST: f64 = 0.005;

/// The surfaces of one way, in order, `[z, r]` in mm.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain {
    tool: u32,
    made: Vec<Stretch>,
}

impl Chain {
    /// Begins anew.
    pub(super) fn end(&mut self) {
        self.made.clear();
    }

    /// Takes what a part of a tool met on a straight piece of the way, of a direction of length 1: how deep the auxiliary edge went into the surfaces
    /// made before, mm, and where.
    pub(super) fn take(&mut self, tool: u32, part: &Part, meeting: &Meeting, way: [f64; 2]) -> Option<(f64, [f64; 2])> {
        if self.tool != tool {
            (self.tool, self.made) = (tool, Vec::new());
        }
        let (roles, count) = (&part.roles, part.roles.len());
        let edges = meeting.inserted.iter().filter_map(|(stretch, origin)| match origin {
            Origin::Edge(edge) if roles.get(*edge) == Some(&Role::Auxiliary) => Some(stretch),
            _ => None,
        });
        let deepest = edges.filter_map(|edge| self.gouge(edge)).max_by(|one, two| one.0.total_cmp(&two.0));
        // What is drawn out along the way; the fillet in front of the nose is no surface yet.
        let nose = |stretch: &Stretch, origin: Origin| match origin {
            Origin::Edge(edge) => roles[edge % count] == Role::Nose && is_along(stretch, way),
            Origin::Corner(corner) => {
                let beside = [roles[(corner + count - 1) % count], roles[corner % count]];
                beside.contains(&Role::Nose) || beside.contains(&Role::Main) && beside.contains(&Role::Auxiliary)
            }
        };
        self.made.extend(
            meeting.inserted.iter().filter(|(stretch, origin)| nose(stretch, *origin)).map(|(stretch, _)| *stretch),
        );
        deepest
    }

    /// How deep an edge stands in what was made from the place on where it ends on it.
    fn gouge(&self, edge: &Stretch) -> Option<(f64, [f64; 2])> {
        let first = self.made.iter().position(|made| on(edge.from, made) || on(edge.to, made))?;
        let off = |point: [f64; 2]| far(point, edge);
        self.made[first..]
            .iter()
            .flat_map(|made| [made.from, made.to])
            .filter(|&point| !on(point, edge))
            .map(|point| (off(point), point))
            .filter(|(deep, _)| *deep > LEAST)
            .max_by(|one, two| one.0.total_cmp(&two.0))
    }
}

fn is_along(Stretch { from, to }: &Stretch, way: [f64; 2]) -> bool {
    let [z, r] = [to[0] - from[0], to[1] - from[1]];
    (z * way[1] - r * way[0]).abs() < 1e-6 * hypot(z, r)
}

/// How far a point lies to the right of a stretch, where the metal is gone; negative to its left.
fn far(point: [f64; 2], Stretch { from, to }: &Stretch) -> f64 {
    let [z, r] = [to[0] - from[0], to[1] - from[1]];
    -((z * (point[1] - from[1]) - r * (point[0] - from[0])) / hypot(z, r))
}

fn on(point: [f64; 2], stretch: &Stretch) -> bool {
    let Stretch { from, to } = stretch;
    let [z, r] = [to[0] - from[0], to[1] - from[1]];
    let long = hypot(z, r);
    let along = (z * (point[0] - from[0]) + r * (point[1] - from[1])) / long;
    long > ON && far(point, stretch).abs() < ON && (-ON..=long + ON).contains(&along)
}
