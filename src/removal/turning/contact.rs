//! The contact of a swept part of a cutter with the metal: its depth, its edges, and what made the surface that is left.

use super::alarm::{Cause, TOUCH};
use super::outline::{Part, Role, beside};
use crate::geometry::exact::convex::Origin;
use crate::geometry::exact::meeting::{Meeting, Stretch};
use crate::number::trig::hypot;

/// Metal shorter along the motion than this, mm, and than this share of the longest piece, does not count as depth of cut: a pass
/// that ends at a shoulder also removes the fillet that the nose left there in the pass before, a sliver far above the pass. What is
/// higher than the nose of a large insert is no fillet, but a collar.
const SLIVER: [f64; 2] = [1.0, 0.05];
const FILLET: f64 = 2.4;

/// A cutting edge faces a path if more than this share of its normal is along it: 10°. Below that it rubs.
const FACES: f64 = 0.17;

/// The contact during one motion.
#[derive(Clone, Copy, Debug, Default)]
pub struct Contact {
    /// Metal was cut, not only touched.
    pub real: bool,
    /// How far the cut reached across the motion, slivers left out; mm.
    pub across: f64,
    /// How far the forward cutting edges reach across the motion, if a non-cutting edge entered metal beside them: the depth of cut
    /// is too large.
    pub edge: Option<f64>,
    /// The depth of a non-cutting edge in metal ahead of it.
    pub back: Option<f64>,
    /// The same beside cutting edges, in a cut that is not too wide for them.
    pub beside: Option<f64>,
    /// The far end of the auxiliary edge left a surface.
    pub dragged: bool,
    /// Where, `[z, r]`.
    pub place: [f64; 2],
    /// The alarm of a boring bar that was fed into metal without a hole.
    pub solid: Option<Cause>,
    /// From where to where a threading cutter stood as it met metal: the least and the greatest `[z, r]` of its programmed point, mm.
    pub ribs: Option<[[f64; 2]; 2]>,
}

/// The metal that a part of a cutter met on its path, more than a film; mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bite {
    /// The distance along the path to the first metal.
    pub along: f64,
    /// Its range of distances outwards from the programmed point, across the path.
    pub reach: [f64; 2],
    /// Its minimum and its maximum radius.
    pub metal: [f64; 2],
}

/// The depth of a polygon in the metal, mm, and its place: the largest distance between the removed outline and the new one, at
/// the ends and middles of their stretches. The axis bounds the half section, not the metal.
#[must_use]
pub fn depth(meeting: &Meeting) -> (f64, [f64; 2]) {
    let mut deepest = (0.0, [0.0; 2]);
    let new = || meeting.inserted.iter().map(|(stretch, _)| *stretch);
    let metal = |one: &Stretch| one.from[1] != 0.0 || one.to[1] != 0.0;
    let old = || meeting.removed.iter().copied().filter(metal);
    let mut look = |stretch: Stretch, off: &dyn Fn([f64; 2]) -> f64| {
        for point in [stretch.from, middle(stretch), stretch.to] {
            let far = off(point);
            if far > deepest.0 {
                deepest = (far, point);
            }
        }
    };
    // A piece that is covered completely leaves no new outline: its depth is its width.
    if meeting.inserted.is_empty() {
        if let Some(first) = old().next() {
            old().for_each(|stretch| look(stretch, &|[z, r]| hypot(z - first.from[0], r - first.from[1])));
        }
        return deepest;
    }
    if old().next().is_none() {
        if let Some((first, _)) = meeting.inserted.first() {
            new().for_each(|stretch| look(stretch, &|[z, r]| hypot(z - first.from[0], r - first.from[1])));
        }
        return deepest;
    }
    new().for_each(|stretch| look(stretch, &|point| off(point, old())));
    old().for_each(|stretch| look(stretch, &|point| off(point, new())));
    deepest
}

fn middle(stretch: Stretch) -> [f64; 2] {
    [f64::midpoint(stretch.from[0], stretch.to[0]), f64::midpoint(stretch.from[1], stretch.to[1])]
}

fn off(point: [f64; 2], stretches: impl Iterator<Item = Stretch>) -> f64 {
    stretches.map(|stretch| beside(point, stretch.from, stretch.to)).fold(f64::INFINITY, f64::min)
}

/// Twice the area by the length of the outline: for a thin film its thickness.
fn film(meeting: &Meeting) -> f64 {
    let (mut area, mut length) = (0.0, 0.0);
    let Some(first) = meeting.removed.first().or(meeting.inserted.first().map(|(stretch, _)| stretch)) else {
        return 0.0;
    };
    let [z0, r0] = first.from;
    let mut add = |stretch: &Stretch, sign: f64| {
        let ([z1, r1], [z2, r2]) = (stretch.from, stretch.to);
        area += sign * ((z1 - z0) * (r2 - r0) - (z2 - z0) * (r1 - r0)) / 2.0;
        length += hypot(z2 - z1, r2 - r1);
    };
    meeting.removed.iter().for_each(|stretch| add(stretch, 1.0));
    meeting.inserted.iter().for_each(|(stretch, _)| add(stretch, -1.0));
    if length > 0.0 { 2.0 * area.abs() / length } else { 0.0 }
}

/// A part of a cutter on a straight path.
#[derive(Clone, Copy, Debug)]
pub struct Ride<'a> {
    /// The convex part of the cutter that rides.
    pub part: &'a Part,
    /// Where its programmed point starts, `[z, r]`.
    pub from: [f64; 2],
    /// The direction `[dz, dr]`, of length 1.
    pub way: [f64; 2],
    /// The metal that it met is given mirrored across the axis.
    pub mirrored: bool,
}

impl Ride<'_> {
    /// The distance of a place to the left of the path.
    fn aside(&self, [z, r]: [f64; 2]) -> f64 {
        self.way[0] * (r - self.from[1]) - self.way[1] * (z - self.from[0])
    }

    fn flip(&self, [z, r]: [f64; 2]) -> [f64; 2] {
        if self.mirrored { [z, -r] } else { [z, r] }
    }

    /// The distances to the left of the path of the start and the end of a stretch.
    fn span(&self, stretch: Stretch) -> [f64; 2] {
        [stretch.from, stretch.to].map(|end| self.aside(self.flip(end)))
    }

    /// How far the removed metal reaches across the path where it is longer along the path than a sliver, mm; `None` if it is
    /// nowhere longer.
    ///
    /// At a distance s to the left of the path, the length of the metal along the path is the signed sum of the places u where
    /// its outline crosses, positive where s grows (Green's theorem: the area is ∮ u ds). Between the ends of stretches it is
    /// linear in s.
    fn reach(&self, meeting: &Meeting) -> Option<f64> {
        let along = |[z, r]: [f64; 2]| self.way[0] * (z - self.from[0]) + self.way[1] * (r - self.from[1]);
        // The range in which a stretch counts, with its place at s = 0 and its slope, both signed.
        let mut ends: Vec<[f64; 3]> = Vec::with_capacity(2 * (meeting.removed.len() + meeting.inserted.len()));
        let removed = meeting.removed.iter().map(|one| (one, 1.0));
        for (stretch, sign) in removed.chain(meeting.inserted.iter().map(|(one, _)| (one, -1.0))) {
            let sign = if self.mirrored { -sign } else { sign };
            let ([from, to], [one, two]) =
                (self.span(*stretch), [stretch.from, stretch.to].map(|end| along(self.flip(end))));
            if from == to {
                continue;
            }
            let slope = (two - one) / (to - from);
            let [place, slope] =
                [one - slope * from, slope].map(|part| if to > from { sign * part } else { -sign * part });
            ends.push([from.min(to), place, slope]);
            ends.push([from.max(to), -place, -slope]);
        }
        ends.sort_by(|one, two| one[0].total_cmp(&two[0]));
        // Between two consecutive ends: the length half-way.
        let (mut place, mut slope) = (0.0, 0.0);
        for at in 1..ends.len() {
            let [here, more, steeper] = ends[at - 1];
            place += more;
            slope += steeper;
            let next = ends[at][0];
            ends[at - 1] = [here, next, if next > here { place + slope * f64::midpoint(here, next) } else { 0.0 }];
        }
        ends.pop();
        let longest = ends.iter().map(|[.., length]| *length).fold(0.0, f64::max);
        let across = |least: f64| {
            let mut counts = ends.iter().filter(|[.., length]| *length > least);
            let first = counts.next()?;
            Some(counts.next_back().unwrap_or(first)[1] - first[0])
        };
        let [all, counted] = [TOUCH, SLIVER[0].min(SLIVER[1] * longest)].map(across);
        if all > counted.map(|counted| counted + FILLET) { all } else { counted }
    }

    /// A corner of the part at the start of the path.
    fn corner(&self, at: usize) -> [f64; 2] {
        let corners = self.part.polygon.corners();
        let [z, r] = corners[at % corners.len()].mm();
        [self.from[0] + z, self.from[1] + r]
    }

    /// The forward edges: their number, their range of distances to the left of the path, and the share of their outward normal
    /// along the path.
    fn forward(&self) -> impl Iterator<Item = (usize, [f64; 2], f64)> {
        (0..self.part.roles.len()).filter_map(|at| {
            let (from, to) = (self.corner(at), self.corner(at + 1));
            let [dz, dr] = [to[0] - from[0], to[1] - from[1]];
            let ahead = (self.way[0] * dr - self.way[1] * dz) / hypot(dz, dr);
            (ahead > 1e-9).then(|| (at, ordered([self.aside(from), self.aside(to)]), ahead))
        })
    }

    /// The depth of the metal in a strip along the path: the largest distance of the old outline from the new one; `None` for a
    /// film.
    fn metal(&self, meeting: &Meeting, [low, high]: [f64; 2]) -> Option<f64> {
        let new = || meeting.inserted.iter().map(|(stretch, _)| *stretch);
        let deepest = (meeting.removed.iter())
            .filter_map(|&stretch| {
                let [one, two] = self.span(stretch);
                let [from, to] = ordered([one, two]);
                // A stretch along the path is inside the strip or not; another one is cut at its sides.
                let part = if to - from <= TOUCH {
                    (from >= low && to <= high).then_some(0.5)
                } else {
                    let shared = [low.max(from), high.min(to)];
                    (shared[1] - shared[0] > TOUCH).then(|| (f64::midpoint(shared[0], shared[1]) - one) / (two - one))
                };
                part.map(|part| [0, 1].map(|axis| stretch.from[axis] + (stretch.to[axis] - stretch.from[axis]) * part))
            })
            .map(|point| match meeting.removed.first() {
                // A piece that is covered completely leaves no new outline.
                Some(first) if meeting.inserted.is_empty() => hypot(point[0] - first.from[0], point[1] - first.from[1]),
                _ => off(point, new()),
            })
            .fold(0.0, f64::max);
        (deepest > TOUCH).then_some(deepest)
    }
}

fn ordered([one, two]: [f64; 2]) -> [f64; 2] {
    [one.min(two), one.max(two)]
}

/// The boundary of the metal that was met: for metal wholly inside the part, the new outline alone.
pub(super) fn bounds(meeting: &Meeting) -> impl Iterator<Item = Stretch> {
    meeting.removed.iter().copied().chain(meeting.inserted.iter().map(|(stretch, _)| *stretch))
}

/// The metal that was met, with signed distances outwards.
fn bite(meeting: &Meeting, ride: &Ride) -> Bite {
    let ends = || bounds(meeting).flat_map(|one| [one.from, one.to]);
    let span = |of: &dyn Fn([f64; 2]) -> f64| {
        ends().map(of).fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
    };
    let [along, _] = span(&|end| {
        let [z, r] = ride.flip(end);
        ride.way[0] * (z - ride.from[0]) + ride.way[1] * (r - ride.from[1])
    });
    Bite { along, reach: span(&|end| ride.flip(end)[1] - ride.from[1]), metal: span(&|[_, r]| r) }
}

impl Contact {
    /// Adds the metal that a part of a cutter met on its path; `None` for a film.
    pub fn add(&mut self, meeting: &Meeting, ride: &Ride) -> Option<Bite> {
        if film(meeting) < TOUCH / 2.0 {
            return None;
        }
        let mut cut = [f64::INFINITY, f64::NEG_INFINITY];
        for stretch in bounds(meeting) {
            let [low, high] = ordered(ride.span(stretch));
            cut = [cut[0].min(low), cut[1].max(high)];
        }
        let across = ride.reach(meeting).unwrap_or(cut[1] - cut[0]);
        if !self.real || across > self.across {
            self.place = bounds(meeting).next().map_or(self.place, |one| ride.flip(one.from));
            self.across = across;
        }
        self.real = true;
        self.judge_backs(meeting, ride, cut);
        let far = (0..meeting.inserted.len()).filter_map(|at| far_end(meeting, ride, at));
        self.dragged |= far.count() > 0;
        // The normal to the left of a path [dz, dr] is [-dr, dz].
        Some(Bite { reach: ordered(cut.map(|aside| aside * ride.way[0])), ..bite(meeting, ride) })
    }

    /// Adds the metal that a threading cutter met in one place of a thread: its depth along the profile; `None` for a film.
    pub fn add_rib(&mut self, meeting: &Meeting, ride: &Ride) -> Option<Bite> {
        if film(meeting) < TOUCH / 2.0 {
            return None;
        }
        let place = bounds(meeting).next().map_or(self.place, |one| ride.flip(one.from));
        // From the tip, in the direction of the profile.
        let all = bounds(meeting).flat_map(|one| [one.from, one.to]).map(|end| ride.flip(end)[1] - ride.from[1]);
        let deep = all.fold(0.0, |deep: f64, off| deep.max(off.abs()));
        if !self.real || deep > self.across {
            (self.across, self.place) = (deep, place);
        }
        self.real = true;
        let [low, high] = self.ribs.unwrap_or([ride.from; 2]);
        let each = |of: fn(f64, f64) -> f64, one: [f64; 2]| [0, 1].map(|axis| of(one[axis], ride.from[axis]));
        self.ribs = Some([each(f64::min, low), each(f64::max, high)]);
        let roles = ride.part.roles.iter().enumerate().filter(|(_, role)| **role != Role::Back);
        let profile = roles.flat_map(|(at, _)| [ride.corner(at), ride.corner(at + 1)]);
        let profile = profile.fold(0.0, |high: f64, corner| high.max((corner[1] - ride.from[1]).abs()));
        if deep > profile + TOUCH {
            self.edge = Some(profile);
        }
        Some(Bite { along: 0.0, ..bite(meeting, ride) })
    }

    /// Forward non-cutting edges with metal ahead of them. If a cutting edge beside them faces the path and cuts, the cut is too deep
    /// for it; otherwise the tool moves back first.
    fn judge_backs(&mut self, meeting: &Meeting, ride: &Ride, cut: [f64; 2]) {
        let (mut edges, mut back) = ([f64::INFINITY, f64::NEG_INFINITY], None::<f64>);
        let mut faces = false;
        for (at, [low, high], ahead) in ride.forward() {
            let shared = [low.max(cut[0]), high.min(cut[1])];
            let met = shared[1] - shared[0] > TOUCH;
            if ride.part.roles[at] != Role::Back {
                edges = [edges[0].min(low), edges[1].max(high)];
                faces |= met && ahead > FACES;
            } else if met && let Some(deep) = ride.metal(meeting, shared) {
                back = Some(back.map_or(deep, |other| other.max(deep)));
            }
        }
        let Some(deep) = back else { return };
        if !faces {
            self.back = Some(self.back.map_or(deep, |other| other.max(deep)));
        } else if cut[1] - cut[0] > edges[1] - edges[0] {
            self.edge = Some(self.edge.unwrap_or(f64::INFINITY).min(edges[1] - edges[0]));
            // It is told beside the edge's own length, which it is more than.
            self.across = self.across.max(cut[1] - cut[0]);
        } else {
            self.beside = Some(self.beside.map_or(deep, |other| other.max(deep)));
        }
    }
}

/// True if the nose left a stretch, or the corner of both edges of a sharp tool.
pub(super) fn is_nose(part: &Part, origin: Origin) -> bool {
    let count = part.roles.len();
    match origin {
        Origin::Edge(edge) => part.roles[edge % count] == Role::Nose,
        Origin::Corner(corner) => is_tip(part, corner),
    }
}

fn is_tip(part: &Part, corner: usize) -> bool {
    let count = part.roles.len();
    let beside = [part.roles[(corner + count - 1) % count], part.roles[corner % count]];
    beside.contains(&Role::Nose) || beside.contains(&Role::Main) && beside.contains(&Role::Auxiliary)
}

/// How far behind the path of the nose the far end of the auxiliary edge has left an inserted stretch; `None` if something else
/// left it.
///
/// A surface that a corner leaves is right if the corner is the nose's, or the outer end of a main edge. If it is the far end
/// of the auxiliary edge, the surface is behind that of the nose, and the tool does not make the programmed profile.
pub(super) fn far_end(meeting: &Meeting, ride: &Ride, number: usize) -> Option<f64> {
    let (stretch, Origin::Corner(corner)) = *meeting.inserted.get(number)? else { return None };
    let (roles, count) = (&ride.part.roles, ride.part.roles.len());
    let beside = [roles[(corner + count - 1) % count], roles[corner % count]];
    if !matches!(beside, [Role::Auxiliary | Role::Back, Role::Back] | [Role::Back, Role::Auxiliary]) {
        return None;
    }
    let [dz, dr] = [stretch.to[0] - stretch.from[0], stretch.to[1] - stretch.from[1]];
    if hypot(dz, dr) <= TOUCH || off(middle(stretch), meeting.removed.iter().copied()) <= TOUCH {
        return None;
    }
    let here = ride.aside(ride.corner(corner));
    let noses = (0..count).filter(|&at| is_tip(ride.part, at)).map(|at| (ride.aside(ride.corner(at)) - here).abs());
    noses.min_by(f64::total_cmp).filter(|behind| *behind > TOUCH)
}
