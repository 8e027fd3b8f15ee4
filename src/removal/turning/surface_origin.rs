//! Which surfaces the nose of an insert has made, and where another of its edges has taken them away again.
//!
//! The profile that is programmed is the one that the nose makes. Where a way goes down into the part more steeply than the edge
//! behind the nose stands, that edge goes ahead of it into the surface that the nose has just made, and leaves its own line
//! below: the profile cannot be made by this tool. Each stretch of the part's contour carries a label for it: made by a nose,
//! with the direction of its way; or a mark, with how deep it lies below what a nose had made. At the end of the program the
//! marks that are on the part are reported; what a later motion takes away has left none. Labels and marks go with a part that is
//! turned about, so that this holds over both its set-ups.
//!
//! # What counts as a mark
//! No source says it; it is chosen so. An edge's new stretch is a mark of a surface made by a nose
//! - if the way leads into the metal under that surface, and either goes on in the sense in which the surface was made, or
//!   ends the new stretch on it; or if it is the auxiliary edge's and ends on it. A pass along a face takes away what lies before
//!   it over its whole depth, and a pass along the axis leaves the slope of its main edge at a shoulder: neither is a profile
//!   that was meant otherwise;
//! - and if the nose itself does not pass below it there. The depth is what the edge has taken beyond the nose's own reach, at
//!   right angles to the surface made; what goes deeper into a mark adds to it.
//!
//! What the auxiliary edge leaves where no nose has made a surface before is a mark on a way that goes down in both axes more
//! steeply than it stands: so deep as it lies beyond the line that the nose draws beside this way. Straight in along an axis, and on
//! a way at feed in which no nose has drawn a surface, a plunge gives the part the form of the insert, which is none. The far end of an edge that drags along behind the nose leaves a mark as well, as deep as it lies below what was there, and
//! no deeper than it is behind the nose's line.

use std::f64::consts::TAU;

use super::alarm::Alarm;
use super::contact::is_nose;
use super::outline::{Part, Role};
use crate::geometry::exact::convex::Origin;
use crate::geometry::exact::meeting::{Meeting, Stretch};
use crate::number::trig::{atan2, hypot, sin_cos};

/// What is taken away again up to this is none: a way as steep as the edge, the chords of arcs, what no drawing tells; mm.
const LEAST: f64 = 0.01;
/// What adds up to a mark, mm: more than corners in floating point are off.
const STEP: f64 = 1e-5;
/// A way leads into the metal under a surface from this share of it on: 1°.
const INTO: f64 = 0.02;
/// It goes head on into a mark from this share of it on: 45°.
const HEAD_ON: f64 = 0.7;
/// It goes on in a surface's sense from this share of it on: up to 75° off.
const ONWARD: f64 = 0.25;
/// Ends of ways lie on a grid of nanometres, mm.
const GRID: f64 = 1e-6;
/// Beside a place, mm.
const HAIR: f64 = 1e-4;
/// Two ends of stretches are one up to this, mm.
const ON: f64 = 1e-5;
/// Labels of surfaces made by a nose: their sense in so many parts of a turn, from 1.
const SENSES: u32 = 256;

/// The labels of a program's surfaces.
#[derive(Clone, Debug, Default)]
pub(super) struct Chain {
    /// The first has the label `SENSES` + 1.
    marks: Vec<Mark>,
    /// How many of them a program before this one left.
    carried: usize,
    /// How many of them there were when the way at feed began.
    before: usize,
    /// The nose has drawn a surface in this way.
    drew: bool,
}

/// What a part of a tool did on a straight piece of its way: what it met, the direction of the way of length 1, and the ends of
/// the way; all `[z, r]`, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct SweptPiece<'a> {
    pub part: &'a Part,
    pub meeting: &'a Meeting,
    pub way: [f64; 2],
    pub ends: [[f64; 2]; 2],
}

impl SweptPiece<'_> {
    /// How far beyond the line that the nose draws on this way an edge has left a stretch, beside the way, on one that goes
    /// down in both axes more steeply than the edge stands; and the nose's line, from where that is.
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
        // The farther behind the end, the deeper.
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

/// A stretch that lies below what a nose had made.
#[derive(Clone, Copy, Debug)]
struct Mark {
    /// How deep, mm.
    deep: f64,
    /// The line of the surface that had been made.
    made: TakenAway,
    alarm: Alarm,
}

impl Mark {
    /// How deep it lies at a place of it.
    fn at(&self, place: [f64; 2]) -> f64 {
        self.made.of_point(place)[1].min(self.deep).max(0.0)
    }
}

/// What a label says.
enum Label {
    /// No nose made it.
    None,
    /// A nose made it on a way in this direction.
    Made([f64; 2]),
    Mark(Mark),
}

impl Chain {
    /// A way at feed has ended.
    pub(super) fn end(&mut self) {
        if !self.drew {
            self.marks.iter_mut().skip(self.before).for_each(|mark| mark.deep = 0.0);
        }
        (self.before, self.drew) = (self.marks.len(), false);
    }

    /// The marks of a motion, which was the last, are none: another alarm of it says what they follow from.
    pub(super) fn forget(&mut self, motion: usize) {
        let own = self.marks.iter_mut().skip(self.carried).rev().take_while(|mark| mark.alarm.motion == motion);
        own.for_each(|mark| mark.deep = 0.0);
    }

    /// Labels the stretches that a pass inserted; `alarm` makes the alarm of a depth at a place, and `far` tells how far behind the
    /// nose's the end of an edge has left a stretch.
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
                // What is drawn out along the way; the fillet in front of the nose is no surface yet.
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
            // What cuts a mark head on makes another surface, but for what goes on along the line that it is a mark of.
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

    /// Labels what an auxiliary edge has left where no nose had made a surface before.
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

    /// How deep an end of a stretch lies below what was taken away above it, where it is, and the line of what was there.
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

    /// For a part that is turned about, z becoming `about` - z, mm: marks keep their labels, and a way's goes to
    /// [`turned_about`].
    pub(super) fn turned_about(&self, about: f64) -> Self {
        let marks = self.marks.iter().map(|mark| Mark { made: mark.made.turned_about(about), ..*mark }).collect();
        Self { marks, carried: self.marks.len(), before: self.marks.len(), drew: false }
    }

    /// The alarms of this program's marks among labels: of one motion the deepest.
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

/// A stretch that was taken away: where it begins, its direction, the one into the metal, and how long it is.
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
        // The region lies to the left of its contour.
        let along = along.map(|part| part / long);
        (long > ON).then_some(Self { from: *from, along, into: [-along[1], along[0]], long })
    }

    /// Of a part that is turned about; its contour runs the other way then.
    fn turned_about(&self, about: f64) -> Self {
        let ([z, r], [along, up]) = (self.point(self.long), self.along);
        Self { from: [about - z, r], along: [along, -up], into: [up, along], long: self.long }
    }

    /// The line beside it, so far out of the metal.
    fn raised(self, by: f64) -> Self {
        Self { from: [0, 1].map(|axis| self.from[axis] - self.into[axis] * by), ..self }
    }

    /// Along the stretch and into the metal.
    fn of_point(&self, point: [f64; 2]) -> [f64; 2] {
        let off = [point[0] - self.from[0], point[1] - self.from[1]];
        [dot(off, self.along), dot(off, self.into)]
    }

    fn point(&self, at: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.from[axis] + self.along[axis] * at)
    }

    /// Between which places along it a stretch lies beside it.
    fn beside(&self, stretch: &Stretch) -> [f64; 2] {
        let [one, two] = [stretch.from, stretch.to].map(|end| self.of_point(end)[0]);
        [one.min(two).max(0.0), one.max(two).min(self.long)]
    }

    /// How far into the metal a stretch lies at a place along it.
    fn depth(&self, stretch: &Stretch, at: f64) -> Option<f64> {
        let ([one, high], [two, low]) = (self.of_point(stretch.from), self.of_point(stretch.to));
        let inside = at >= one.min(two) && at <= one.max(two) && one != two;
        inside.then(|| high + (low - high) * (at - one) / (two - one))
    }

    /// How deep the inserted stretch of a number lies below, where no other lies between, and from where: the deepest place.
    /// Where the nose passes between them, what is beyond it; where it does not, with what was there of a mark before.
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
        // Beside where the nose begins and ends to pass, and over the stretch.
        let inner = [0.01, 0.5, 0.99].map(|share| low + wide * share);
        let sides = nose.into_iter().flat_map(|nose| nose.sides()).flatten().flat_map(|at| [at - HAIR, at + HAIR]);
        let places = inner.into_iter().chain(sides.filter(|at| *at > low && *at < high));
        places.filter_map(below).max_by(|(one, _), (two, _)| one.total_cmp(two))
    }

    /// What a nose sweeps, in the frame of the stretch.
    fn nose(&self, (centre, radius): ([f64; 2], f64), ends: [[f64; 2]; 2]) -> Nose {
        Nose { ends: ends.map(|end| self.of_point([end[0] + centre[0], end[1] + centre[1]])), radius }
    }
}

/// A circle on a straight way, along a stretch and into the metal under it.
#[derive(Clone, Copy)]
struct Nose {
    ends: [[f64; 2]; 2],
    radius: f64,
}

impl Nose {
    /// The sides of its way, from the first to the last place.
    fn edges(&self) -> [[[f64; 2]; 2]; 2] {
        let [from, to] = self.ends;
        let way = [to[0] - from[0], to[1] - from[1]];
        let share = self.radius / hypot(way[0], way[1]).max(ON);
        [1.0, -1.0].map(|side| {
            let off = [-way[1] * share * side, way[0] * share * side];
            self.ends.map(|end| [end[0] + off[0], end[1] + off[1]])
        })
    }

    /// Between which depths it lies at a place along the stretch.
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

    /// Where along the stretch it begins and ends, and where it comes through the stretch's line.
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

/// What a straight cutting edge is for that left a stretch; `None` where it was something else.
fn edge_role(part: &Part, origin: Origin) -> Option<Role> {
    let Origin::Edge(edge) = origin else { return None };
    part.roles.get(edge).copied().filter(|role| matches!(role, Role::Main | Role::Auxiliary))
}

/// The number of a direction among the senses.
fn sense([z, r]: [f64; 2]) -> u32 {
    let part = (atan2(r, z).rem_euclid(TAU) / TAU * f64::from(SENSES)).round();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 256")]
    let part = part as u32;
    part % SENSES
}

/// A label on a part that is turned about.
pub(super) const fn turned_about(label: u32) -> u32 {
    match label {
        1..=SENSES => (SENSES + SENSES / 2 + 1 - label) % SENSES + 1,
        _ => label,
    }
}

/// True where a stretch ends where what is taken away ends too.
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
