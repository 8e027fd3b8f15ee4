//! Which surfaces the nose of an insert has made, and where another of its edges has cut into them.
//!
//! The nose makes the programmed profile. If a path goes down into the part more steeply than the edge behind the nose, that edge
//! cuts into the surface that the nose has just made and leaves its own line below it: this tool cannot make the profile. Each
//! stretch of the part's contour has a label: made by a nose, with the direction of its path; or a mark, with its depth below the
//! surface of the nose. At the end of the program, the marks that are on the part are reported; marks that a later motion has
//! removed are not. Labels and marks stay with a part that is turned round, so this holds over both set-ups.
//!
//! # What counts as a mark
//! No source defines it; this is our definition. A new stretch that an edge leaves is a mark on a surface made by a nose if both hold:
//! - The path leads into the metal under that surface, and it either continues in the direction in which the surface was made
//!   or ends the new stretch on it. For the auxiliary edge it is enough that the new stretch ends on the surface. A pass
//!   along a face removes its whole depth, and a pass along the axis leaves the slope of its main edge at a shoulder: neither is
//!   a mark.
//! - The nose itself does not pass below the stretch there. The depth is what the edge has removed beyond the reach of the nose,
//!   at right angles to the surface. A cut that goes deeper into a mark adds to its depth.
//!
//! A stretch that the auxiliary edge leaves where no nose has made a surface is a mark if the path goes down in both axes more
//! steeply than that edge. Its depth is measured from the line that the nose draws along this path. A straight plunge along an
//! axis, and a path at feed in which no nose has drawn a surface, give the part the form of the insert: that is not a mark. The
//! far end of an edge that trails behind the nose also leaves a mark. Its depth is measured from the surface that was there, and
//! is at most its distance behind the line of the nose.

use std::f64::consts::TAU;

use super::alarm::Alarm;
use super::contact::is_nose;
use super::outline::{Part, Role};
use crate::geometry::exact::convex::Origin;
use crate::geometry::exact::meeting::{Meeting, Stretch};
use crate::number::trig::{atan2, hypot, sin_cos};

/// Up to this depth there is no mark, mm: paths as steep as the edge, chords of arcs, less than any drawing shows.
const LEAST: f64 = 0.01;
/// The least depth that adds to a mark, mm: above the floating-point error of corners.
const STEP: f64 = 1e-5;
/// A path leads into the metal under a surface from this sine on: 1°.
const INTO: f64 = 0.02;
/// It goes head on into a mark from this sine on: 45°.
const HEAD_ON: f64 = 0.7;
/// It continues in a surface's direction from this cosine on: up to 75° off.
const ONWARD: f64 = 0.25;
/// Ends of paths are on a grid of nanometres, mm.
const GRID: f64 = 1e-6;
/// Distance to the places next to a point, mm.
const HAIR: f64 = 1e-4;
/// Two ends of stretches are the same point up to this distance, mm.
const ON: f64 = 1e-5;
/// Labels of surfaces made by a nose: their direction in this many parts of a turn, from 1.
const SENSES: u32 = 256;

/// The labels of a program's surfaces.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain {
    /// The first has the label `SENSES` + 1.
    marks: Vec<Mark>,
    /// How many of them an earlier program left.
    carried: usize,
    /// How many of them there were when the path at feed began.
    before: usize,
    /// The nose has drawn a surface on this path.
    drew: bool,
}

/// What a part of a tool did on a straight piece of its path: what it met, the unit direction, and the ends; all `[z, r]`, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct SweptPiece<'a> {
    pub part: &'a Part,
    pub meeting: &'a Meeting,
    pub way: [f64; 2],
    pub ends: [[f64; 2]; 2],
}

impl SweptPiece<'_> {
    /// How far beyond the line of the nose an edge has left a stretch, if the path goes down in both axes more steeply than the
    /// edge; and the line of the nose, from that place on.
    fn beyond(&self, edge: &Stretch) -> Option<(f64, TakenAway)> {
        let (way, left) = (self.way, TakenAway::of(edge)?);
        if way.iter().any(|part| part.abs() < INTO) || dot(way, left.into) < INTO {
            return None;
        }
        let side = [way[1], -way[0]];
        let into = if dot(side, left.into) < 0.0 { side.map(|part| -part) } else { side };
        let (centre, radius) = self.part.nose.unwrap_or_default();
        let [first, last] = self.ends.map(|end| [0, 1].map(|axis| end[axis] + centre[axis] + into[axis] * radius));
        let of_point = |[z, r]: [f64; 2]| {
            let off = [z - last[0], r - last[1]];
            [-dot(off, way), dot(off, into)]
        };
        // The depth grows with the distance behind the end.
        let (mut near, mut far) = (of_point(edge.from), of_point(edge.to));
        if near[0] > far[0] {
            (near, far) = (far, near);
        }
        let behind = far[0].min(hypot(last[0] - first[0], last[1] - first[1]));
        if behind <= near[0].max(0.0) {
            return None;
        }
        let deep = near[1] + (far[1] - near[1]) * (behind - near[0]) / (far[0] - near[0]);
        let from = [0, 1].map(|axis| last[axis] - way[axis] * behind);
        Some((deep, TakenAway { from, along: [into[1], -into[0]], into, long: behind }))
    }
}

/// A stretch below a surface that a nose had made.
#[derive(Clone, Copy, Debug)]
struct Mark {
    /// How deep, mm.
    deep: f64,
    /// The line of the surface that had been made.
    made: TakenAway,
    alarm: Alarm,
}

impl Mark {
    /// Its depth at a place, mm: 0 where it does not reach.
    fn at(&self, place: [f64; 2]) -> f64 {
        self.made.of_point(place)[1].min(self.deep).max(0.0)
    }
}

/// What a label says.
enum Label {
    /// No nose made it.
    None,
    /// A nose made it on a path in this direction.
    Made([f64; 2]),
    Mark(Mark),
}

impl Chain {
    /// A path at feed has ended.
    pub(super) fn end(&mut self) {
        if !self.drew {
            self.marks.iter_mut().skip(self.before).for_each(|mark| mark.deep = 0.0);
        }
        (self.before, self.drew) = (self.marks.len(), false);
    }

    /// Drops the marks of the last motion: another alarm of that motion gives their cause.
    pub(super) fn forget(&mut self, motion: usize) {
        let own = self.marks.iter_mut().skip(self.carried).rev().take_while(|mark| mark.alarm.motion == motion);
        own.for_each(|mark| mark.deep = 0.0);
    }

    /// Labels the stretches that a pass inserted. `alarm` makes the alarm for a depth and a place; `far` gives how far behind the
    /// line of the nose the end of an edge has left a stretch.
    pub(super) fn label(
        &mut self,
        pass: SweptPiece,
        alarm: impl Fn(f64, [f64; 2]) -> Alarm,
        far: impl Fn(usize) -> Option<f64>,
        labels: &mut [u32],
    ) {
        let SweptPiece { part, meeting, way, .. } = pass;
        let mut own = None;
        for (at, ((stretch, origin), new)) in meeting.inserted.iter().zip(&mut *labels).enumerate() {
            if is_nose(part, *origin) {
                // Only stretches along the path; the fillet in front of the nose is not yet a surface.
                if is_along(stretch, way) {
                    *new = *own.get_or_insert_with(|| 1 + sense(way));
                    self.drew = true;
                }
            } else if let (Some(behind), Some(line)) = (far(at), TakenAway::of(stretch)) {
                let (deep, place, made) =
                    self.under(stretch, meeting).unwrap_or_else(|| (behind, middle(stretch), line.raised(behind)));
                let deep = deep.min(behind);
                *new = self.mark(Mark { deep, made, alarm: alarm(deep, place) });
                self.drew = true;
            }
        }
        for (removed, label) in meeting.removed.iter().zip(&meeting.labels) {
            let Some(frame) = TakenAway::of(removed) else { continue };
            let (before, made) = match self.read(*label) {
                Label::None => continue,
                Label::Made(made) => (None, Some(made)),
                Label::Mark(mark) if mark.deep > 0.0 => (Some(mark), None),
                Label::Mark(_) => continue,
            };
            let lead = dot(way, frame.into);
            // A path that cuts a mark head on makes another surface, unless it continues along the marked surface.
            if let Some(mark) = before
                && (lead < 0.0 || lead >= HEAD_ON && dot(way, mark.made.along).abs() < HEAD_ON)
            {
                continue;
            }
            let onward = made.is_none_or(|made| lead >= INTO && dot(way, made) >= ONWARD);
            for (at, ((edge, origin), new)) in meeting.inserted.iter().zip(&mut *labels).enumerate() {
                let Some(role) = edge_role(part, *origin) else { continue };
                let ends = || (lead >= INTO || role == Role::Auxiliary) && joins(edge, removed);
                if !onward && !ends() {
                    continue;
                }
                let Some((deep, place)) = frame.below(at, pass, before.as_ref()) else { continue };
                let known = if let Label::Mark(known) = self.read(*new) { known.deep } else { 0.0 };
                if deep > known.max(STEP) {
                    let made = before.map_or(frame, |mark| mark.made);
                    *new = self.mark(Mark { deep, made, alarm: alarm(deep, place) });
                }
            }
        }
        self.label_bare(pass, alarm, labels);
    }

    /// Labels stretches of an auxiliary edge where no nose had made a surface.
    fn label_bare(&mut self, pass: SweptPiece, alarm: impl Fn(f64, [f64; 2]) -> Alarm, labels: &mut [u32]) {
        if pass.meeting.labels.iter().any(|label| matches!(self.read(*label), Label::Made(_))) {
            return;
        }
        for ((edge, origin), new) in pass.meeting.inserted.iter().zip(labels) {
            let known = if let Label::Mark(known) = self.read(*new) { known.deep } else { 0.0 };
            if edge_role(pass.part, *origin) == Some(Role::Auxiliary)
                && let Some((deep, made)) = pass.beyond(edge).filter(|(deep, _)| *deep > known.max(STEP))
            {
                let place = [0, 1].map(|axis| made.from[axis] + made.into[axis] * deep);
                *new = self.mark(Mark { deep, made, alarm: alarm(deep, place) });
            }
        }
    }

    /// The depth of an end of a stretch below what was removed above it, its place, and the line of what was there.
    fn under(&self, stretch: &Stretch, meeting: &Meeting) -> Option<(f64, [f64; 2], TakenAway)> {
        let found = meeting.removed.iter().zip(&meeting.labels).filter_map(|(removed, label)| {
            let frame = TakenAway::of(removed)?;
            let before = if let Label::Mark(mark) = self.read(*label) { Some(mark) } else { None };
            let ends = [stretch.from, stretch.to].into_iter();
            ends.map(|end| (end, frame.of_point(end)))
                .filter(|(_, [along, deep])| (-ON..=frame.long + ON).contains(along) && *deep > 0.0)
                .map(|(end, [along, deep])| {
                    let more = before.map_or(0.0, |mark| mark.at(frame.point(along)));
                    (deep + more, end, before.map_or(frame, |mark| mark.made))
                })
                .max_by(|(one, ..), (two, ..)| one.total_cmp(two))
        });
        found.max_by(|(one, ..), (two, ..)| one.total_cmp(two))
    }

    fn mark(&mut self, mark: Mark) -> u32 {
        self.marks.push(mark);
        u32::try_from(self.marks.len()).unwrap_or(0).saturating_add(SENSES)
    }

    fn read(&self, label: u32) -> Label {
        match label {
            0 => Label::None,
            1..=SENSES => {
                let (sin, cos) = sin_cos(f64::from(label - 1) * (TAU / f64::from(SENSES)));
                Label::Made([cos, sin])
            }
            _ => self.marks.get((label - SENSES - 1) as usize).map_or(Label::None, |mark| Label::Mark(*mark)),
        }
    }

    /// The chain of a part that is turned round, z becoming `about` - z, mm: marks keep their labels, and the label of a path
    /// becomes [`turned_about`].
    pub(super) fn turned_about(&self, about: f64) -> Self {
        let marks = self.marks.iter().map(|mark| Mark { made: mark.made.turned_about(about), ..*mark }).collect();
        Self { marks, carried: self.marks.len(), before: self.marks.len(), drew: false }
    }

    /// The alarms of this program's marks among labels: the deepest of each motion.
    pub(super) fn alarms(&self, labels: impl Iterator<Item = u32>) -> Vec<Alarm> {
        let number = |label: u32| label.checked_sub(SENSES + 1).map(|number| number as usize);
        let own = labels.filter_map(number).filter(|number| *number >= self.carried);
        let marks = own.filter_map(|number| self.marks.get(number));
        let mut found: Vec<Alarm> = marks.filter(|mark| mark.deep > LEAST).map(|mark| mark.alarm).collect();
        found.sort_by(|one, two| {
            one.motion.cmp(&two.motion).then(two.depth.partial_cmp(&one.depth).unwrap_or(std::cmp::Ordering::Equal))
        });
        found.dedup_by_key(|alarm| alarm.motion);
        found
    }
}

/// A removed stretch: its start, its direction, the direction into the metal, and its length.
#[derive(Clone, Copy, Debug)]
struct TakenAway {
    from: [f64; 2],
    along: [f64; 2],
    into: [f64; 2],
    long: f64,
}

impl TakenAway {
    fn of(Stretch { from, to }: &Stretch) -> Option<Self> {
        let along = [to[0] - from[0], to[1] - from[1]];
        let long = hypot(along[0], along[1]);
        // The region is to the left of its contour.
        let along = along.map(|part| part / long);
        (long > ON).then_some(Self { from: *from, along, into: [-along[1], along[0]], long })
    }

    /// The same on a part that is turned round, whose contour runs the other way.
    fn turned_about(&self, about: f64) -> Self {
        let ([z, r], [along, up]) = (self.point(self.long), self.along);
        Self { from: [about - z, r], along: [along, -up], into: [up, along], long: self.long }
    }

    /// The parallel line, this far out of the metal.
    fn raised(self, by: f64) -> Self {
        Self { from: [0, 1].map(|axis| self.from[axis] - self.into[axis] * by), ..self }
    }

    /// A point's coordinates along the stretch and into the metal.
    fn of_point(&self, point: [f64; 2]) -> [f64; 2] {
        let off = [point[0] - self.from[0], point[1] - self.from[1]];
        [dot(off, self.along), dot(off, self.into)]
    }

    fn point(&self, at: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.from[axis] + self.along[axis] * at)
    }

    /// The span along it that a stretch covers.
    fn beside(&self, stretch: &Stretch) -> [f64; 2] {
        let [one, two] = [stretch.from, stretch.to].map(|end| self.of_point(end)[0]);
        [one.min(two).max(0.0), one.max(two).min(self.long)]
    }

    /// The depth of a stretch in the metal at a place along it.
    fn depth(&self, stretch: &Stretch, at: f64) -> Option<f64> {
        let ([one, high], [two, low]) = (self.of_point(stretch.from), self.of_point(stretch.to));
        let inside = at >= one.min(two) && at <= one.max(two) && one != two;
        inside.then(|| high + (low - high) * (at - one) / (two - one))
    }

    /// The greatest depth of an inserted stretch below this one, and the place, if no other stretch is between. If the nose passes
    /// between them, only the depth beyond the nose counts; if not, the depth of an earlier mark is added.
    fn below(&self, number: usize, pass: SweptPiece, before: Option<&Mark>) -> Option<(f64, [f64; 2])> {
        let (stretch, _) = pass.meeting.inserted.get(number)?;
        let [low, high] = self.beside(stretch);
        let wide = high - low;
        if wide <= ON {
            return None;
        }
        let nose = pass.part.nose.map(|nose| self.nose(nose, pass.ends));
        let others = || pass.meeting.inserted.iter().enumerate().filter(|(at, _)| *at != number);
        let below = |at: f64| {
            let deep = self.depth(stretch, at).filter(|deep| *deep > 0.0)?;
            let mut between = others().filter_map(|(_, (other, _))| self.depth(other, at));
            if between.any(|other| other > 0.0 && other < deep) {
                return None;
            }
            let place = self.point(at);
            let deep = match nose.and_then(|nose| nose.within(at)) {
                Some([first, last]) if last > 0.0 && first < deep => deep - last,
                _ => deep + before.map_or(0.0, |mark| mark.at(place)),
            };
            Some((deep, place))
        };
        // Next to where the nose begins and ends to pass, and along the stretch.
        let inner = [0.01, 0.5, 0.99].map(|share| low + wide * share);
        let sides = nose.into_iter().flat_map(|nose| nose.sides()).flatten().flat_map(|at| [at - HAIR, at + HAIR]);
        let places = inner.into_iter().chain(sides.filter(|at| *at > low && *at < high));
        places.filter_map(below).max_by(|(one, _), (two, _)| one.total_cmp(two))
    }

    /// The area that a nose sweeps, in the frame of the stretch.
    fn nose(&self, (centre, radius): ([f64; 2], f64), ends: [[f64; 2]; 2]) -> Nose {
        Nose { ends: ends.map(|end| self.of_point([end[0] + centre[0], end[1] + centre[1]])), radius }
    }
}

/// A circle on a straight path, in coordinates along a stretch and into the metal under it.
#[derive(Clone, Copy)]
struct Nose {
    ends: [[f64; 2]; 2],
    radius: f64,
}

impl Nose {
    /// The sides of its path, from the first to the last place.
    fn edges(&self) -> [[[f64; 2]; 2]; 2] {
        let [from, to] = self.ends;
        let way = [to[0] - from[0], to[1] - from[1]];
        let share = self.radius / hypot(way[0], way[1]).max(ON);
        [1.0, -1.0].map(|side| {
            let off = [-way[1] * share * side, way[0] * share * side];
            self.ends.map(|end| [end[0] + off[0], end[1] + off[1]])
        })
    }

    /// The depths that it covers at a place along the stretch.
    fn within(&self, at: f64) -> Option<[f64; 2]> {
        let discs = self.ends.into_iter().flat_map(|[along, deep]| {
            let half = self.radius * self.radius - (at - along) * (at - along);
            (half >= 0.0).then(|| [deep - half.sqrt(), deep + half.sqrt()]).into_iter().flatten()
        });
        let edges = self.edges().into_iter().filter_map(|[[one, high], [two, low]]| {
            let inside = one != two && at >= one.min(two) && at <= one.max(two);
            inside.then(|| high + (low - high) * (at - one) / (two - one))
        });
        discs.chain(edges).fold(None, |found, deep| {
            Some(found.map_or([deep; 2], |[low, high]: [f64; 2]| [low.min(deep), high.max(deep)]))
        })
    }

    /// Where along the stretch it begins and ends, and where it crosses the line of the stretch.
    fn sides(&self) -> [Option<f64>; 10] {
        let [one, two] = self.ends;
        let through = |[along, deep]: [f64; 2], side: f64| {
            let half = self.radius * self.radius - deep * deep;
            (half >= 0.0).then(|| along + side * half.sqrt())
        };
        let crosses = |[[one, high], [two, low]]: [[f64; 2]; 2]| {
            ((high > 0.0) != (low > 0.0)).then(|| one + (two - one) * high / (high - low))
        };
        let [left, right] = self.edges();
        [
            Some(one[0] - self.radius),
            Some(one[0] + self.radius),
            Some(two[0] - self.radius),
            Some(two[0] + self.radius),
            through(one, -1.0),
            through(one, 1.0),
            through(two, -1.0),
            through(two, 1.0),
            crosses(left),
            crosses(right),
        ]
    }
}

fn dot(one: [f64; 2], two: [f64; 2]) -> f64 {
    one[0] * two[0] + one[1] * two[1]
}

fn middle(stretch: &Stretch) -> [f64; 2] {
    [0, 1].map(|axis| f64::midpoint(stretch.from[axis], stretch.to[axis]))
}

/// The role of the straight cutting edge that left a stretch; `None` if something else left it.
fn edge_role(part: &Part, origin: Origin) -> Option<Role> {
    let Origin::Edge(edge) = origin else { return None };
    part.roles.get(edge).copied().filter(|role| matches!(role, Role::Main | Role::Auxiliary))
}

/// The number of a direction, from 0 to `SENSES` - 1.
fn sense([z, r]: [f64; 2]) -> u32 {
    let part = (atan2(r, z).rem_euclid(TAU) / TAU * f64::from(SENSES)).round();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 256")]
    let part = part as u32;
    part % SENSES
}

/// A label on a part that is turned round.
pub(super) const fn turned_about(label: u32) -> u32 {
    match label {
        1..=SENSES => (SENSES + SENSES / 2 + 1 - label) % SENSES + 1,
        _ => label,
    }
}

/// True if two stretches share an end.
fn joins(one: &Stretch, other: &Stretch) -> bool {
    [one.from, one.to]
        .into_iter()
        .any(|end| [other.from, other.to].into_iter().any(|place| hypot(end[0] - place[0], end[1] - place[1]) < ON))
}

fn is_along(Stretch { from, to }: &Stretch, way: [f64; 2]) -> bool {
    let [z, r] = [to[0] - from[0], to[1] - from[1]];
    let long = hypot(z, r);
    long > HAIR && (z * way[1] - r * way[0]).abs() < 4.0 * GRID + 1e-6 * long
}
