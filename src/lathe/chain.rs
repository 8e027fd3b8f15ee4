//! What the nose makes in one uninterrupted way at feed, and whether the auxiliary edge takes it away again.
//!
//! Where a way turns inwards more steeply than the auxiliary edge stands, that edge goes ahead of the nose and cuts into the
//! surface that the nose has just made: the profile cannot be made by this tool. On the part it shows as a stretch that the
//! edge left in the place where it stood last, one end of it on that surface. A pass along a face, which the same edge may
//! cut, ends on what was there before or in the open. What a later motion takes away has left no stretch: whether the edge's
//! mark is on the part is asked at the end of the program. Derived here.

use super::alarm::Alarm;
use super::outline::{Part, Role};
use crate::geometry::exact::convex::Origin;
use crate::geometry::exact::meeting::{Meeting, Stretch};
use crate::number::trig::hypot;

/// An end of a stretch lies on another one up to this, mm.
const ON: f64 = 1e-5;
/// What is taken away again up to this is none: a way as steep as the edge, mm.
const LEAST: f64 = 0.005;

/// The metal beside a mark is looked for this far from it, mm: more than the grid of nanometres, less than what shows.
const BESIDE: f64 = 1e-4;

/// The surfaces of one way, in order, `[z, r]` in mm.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain {
    tool: u32,
    made: Vec<Stretch>,
}

/// A stretch that the auxiliary edge left in what the nose had made.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    stretch: Stretch,
    /// How deep it is, mm.
    pub deep: f64,
    /// Where it is deepest, `[z, r]`.
    pub place: [f64; 2],
}

impl Mark {
    /// True where there is metal beside it still, of what is asked for a place in it.
    pub(super) fn stands(&self, is_metal: impl Fn([f64; 2]) -> bool) -> bool {
        let Stretch { from, to } = self.stretch;
        let [z, r] = [to[0] - from[0], to[1] - from[1]];
        let off = BESIDE / hypot(z, r);
        [0.02, 0.25, 0.5, 0.75, 0.98]
            .into_iter()
            .any(|part| is_metal([from[0] + z * part - r * off, from[1] + r * part + z * off]))
    }
}

/// The marks of a program, each with its alarm.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks {
    marks: Vec<(Mark, Alarm)>,
    /// How many of them were looked at when their way ended.
    settled: usize,
}

impl Marks {
    /// Adds one.
    pub(super) fn push(&mut self, mark: Mark, alarm: Alarm) {
        self.marks.push((mark, alarm));
    }

    /// A way has ended: most of its marks it has taken away itself.
    pub(super) fn settle(&mut self, is_metal: impl Fn([f64; 2]) -> bool) {
        let mut new = self.marks.split_off(self.settled);
        new.retain(|(mark, _)| mark.stands(&is_metal));
        self.marks.append(&mut new);
        self.settled = self.marks.len();
    }

    /// The alarms of those on the part: of one motion the deepest.
    pub(super) fn alarms(&self, is_metal: impl Fn([f64; 2]) -> bool) -> Vec<Alarm> {
        let mut alarms: Vec<Alarm> = Vec::new();
        for (_, alarm) in self.marks.iter().filter(|(mark, _)| mark.stands(&is_metal)) {
            match alarms.last_mut().filter(|last| last.motion == alarm.motion) {
                Some(last) if alarm.depth > last.depth => *last = *alarm,
                Some(_) => {}
                None => alarms.push(*alarm),
            }
        }
        alarms
    }
}

impl Chain {
    /// Begins anew.
    pub(super) fn end(&mut self) {
        self.made.clear();
    }

    /// Takes what a part of a tool met on a straight piece of the way, of a direction of length 1: the deepest mark that the
    /// auxiliary edge left in the surfaces made before.
    pub(super) fn take(&mut self, tool: u32, part: &Part, meeting: &Meeting, way: [f64; 2]) -> Option<Mark> {
        if self.tool != tool {
            (self.tool, self.made) = (tool, Vec::new());
        }
        let (roles, count) = (&part.roles, part.roles.len());
        let edges = meeting.inserted.iter().filter_map(|(stretch, origin)| match origin {
            Origin::Edge(edge) if roles.get(*edge) == Some(&Role::Auxiliary) => Some(stretch),
            _ => None,
        });
        let deepest = edges.filter_map(|edge| self.gouge(edge)).max_by(|one, two| one.deep.total_cmp(&two.deep));
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
    fn gouge(&self, edge: &Stretch) -> Option<Mark> {
        let first = self.made.iter().position(|made| on(edge.from, made) || on(edge.to, made))?;
        let off = |point: [f64; 2]| far(point, edge);
        self.made[first..]
            .iter()
            .flat_map(|made| [made.from, made.to])
            .filter(|&point| !on(point, edge))
            .map(|point| Mark { stretch: *edge, deep: off(point), place: point })
            .filter(|mark| mark.deep > LEAST)
            .max_by(|one, two| one.deep.total_cmp(&two.deep))
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
