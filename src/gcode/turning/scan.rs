//! The contour as the passes of a roughing cycle see it.
//!
//! # The cycle's frame
//! All roughing is brought to one drawing: u along the passes, v across them, the tool coming from great u and great v, so
//! that passes go towards −u and the infeed towards −v. Outside turning towards the chuck is that drawing as it stands
//! (u = Z, v = X); inside, away from the chuck, and facing are its mirror images. A contour that a control accepts then
//! never goes back towards +u.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use crate::gcode::turning::profile::{Element, Profile};
use crate::number::trig;

/// Lengths below which two points are the same, mm.
pub(super) const EPS: f64 = 1e-9;
/// Places at which a contour is held against itself moved, between two ends of its parts.
const CUT_LOOKS: u8 = 16;
const CUT_LOOK_LAST: u8 = CUT_LOOKS - 1;

/// The mirrors between program coordinates and the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PassFrame {
    /// Which of `[X, Z]` u and v are.
    pub axes: [usize; 2],
    /// Their signs.
    pub signs: [f64; 2],
}

impl PassFrame {
    /// From `[X, Z]` to `[u, v]`.
    pub fn inward(self, p: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|at| self.signs[at] * p[self.axes[at]] + 0.0)
    }

    /// From `[u, v]` to `[X, Z]`.
    pub fn outward(self, p: [f64; 2]) -> [f64; 2] {
        let mut out = [0.0; 2];
        for (at, &axis) in self.axes.iter().enumerate() {
            out[axis] = self.signs[at] * p[at] + 0.0;
        }
        out
    }

    /// Whether the drawing is a mirror image of the one with Z to the right and X up.
    pub fn mirrors(self) -> bool {
        (self.axes == [0, 1]) ^ (self.signs[0] < 0.0) ^ (self.signs[1] < 0.0)
    }
}

/// The arc of a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Round {
    pub centre: [f64; 2],
    pub counter: bool,
}

/// A line, or an arc within one quarter: monotone in u and in v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Part {
    pub from: [f64; 2],
    pub to: [f64; 2],
    pub round: Option<Round>,
    /// The element of the profile that it belongs to.
    pub element: usize,
}

impl Part {
    /// u where the part has a v, held within the part.
    fn u_at(&self, v: f64) -> f64 {
        let [low, high] = [self.from[0].min(self.to[0]), self.from[0].max(self.to[0])];
        let u = match self.round {
            None if self.to[1] == self.from[1] => self.to[0],
            None => self.from[0] + (self.to[0] - self.from[0]) * ((v - self.from[1]) / (self.to[1] - self.from[1])),
            Some(Round { centre, .. }) => {
                let radius = trig::hypot(self.from[0] - centre[0], self.from[1] - centre[1]);
                let across = v - centre[1];
                let half = (radius * radius - across * across).max(0.0).sqrt();
                // A quarter lies on one side of its centre.
                if self.from[0] + self.to[0] < 2.0 * centre[0] { centre[0] - half } else { centre[0] + half }
            }
        };
        u.clamp(low, high)
    }

    /// v where the part has a u strictly between its ends.
    fn v_at(&self, u: f64) -> Option<f64> {
        let [low, high] = [self.from[0].min(self.to[0]), self.from[0].max(self.to[0])];
        if !(low < u && u < high) {
            return None;
        }
        Some(match self.round {
            None => self.from[1] + (self.to[1] - self.from[1]) * ((u - self.from[0]) / (self.to[0] - self.from[0])),
            Some(Round { centre, .. }) => {
                let radius = trig::hypot(self.from[0] - centre[0], self.from[1] - centre[1]);
                let across = u - centre[0];
                let half = (radius * radius - across * across).max(0.0).sqrt();
                if self.from[1] + self.to[1] < 2.0 * centre[1] { centre[1] - half } else { centre[1] + half }
            }
        })
    }

    fn is_point(&self) -> bool {
        same(self.from, self.to)
    }
}

/// Whether two points are the same.
pub(super) fn same(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).abs() < EPS && (a[1] - b[1]).abs() < EPS
}

/// The parts of one element that begins at `from`, all in the drawing.
fn split(from: [f64; 2], to: [f64; 2], round: Option<Round>, element: usize, parts: &mut Vec<Part>) {
    let mut at = from;
    if let Some(Round { centre, counter }) = round {
        let angle = |p: [f64; 2]| trig::atan2(p[1] - centre[1], p[0] - centre[0]);
        let radius = trig::hypot(from[0] - centre[0], from[1] - centre[1]);
        let sign = if counter { 1.0 } else { -1.0 };
        let sweep = (sign * (angle(to) - angle(from))).rem_euclid(TAU);
        // The quarter points at the angles 0, 90, 180 and 270 degrees, in the order in which the arc passes them.
        let mut passed: Vec<(f64, [f64; 2])> = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]
            .into_iter()
            .map(|[a, b]: [f64; 2]| {
                let way = (sign * (trig::atan2(b, a) - angle(from))).rem_euclid(TAU);
                (way, [centre[0] + radius * a, centre[1] + radius * b])
            })
            .filter(|(way, point)| *way < sweep && !same(*point, from) && !same(*point, to))
            .collect();
        passed.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, point) in passed {
            parts.push(Part { from: at, to: point, round, element });
            at = point;
        }
    }
    let last = Part { from: at, to, round, element };
    if !last.is_point() {
        parts.push(last);
    }
}

/// A place on the contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Loc {
    pub part: usize,
    pub at: [f64; 2],
}

/// A way at one v that the contour leaves free, from great u to small u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Where the contour falls below v; none where the way begins at the start of the passes.
    pub open: Option<Loc>,
    /// Where it rises above v again; none where the way goes to the end of the contour.
    pub close: Option<Loc>,
}

/// A piece of the contour that the tool follows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Leg {
    pub to: [f64; 2],
    pub round: Option<Round>,
    pub element: usize,
}

/// The contour in the drawing.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Path {
    pub parts: Vec<Part>,
}

impl Path {
    /// The contour of a profile (all but its first element, which leads to it), moved by `shift` (in the drawing).
    pub fn of(profile: &Profile, frame: PassFrame, shift: [f64; 2]) -> Self {
        let place = |p: [f64; 2]| {
            let [u, v] = frame.inward(p);
            [u + shift[0], v + shift[1]]
        };
        let mut parts = Vec::new();
        let mut at = profile.elements.first().map_or(profile.start, |first| first.to);
        for (index, element) in profile.elements.iter().enumerate().skip(1) {
            let round = element
                .arc
                .map(|(centre, clockwise)| Round { centre: place(centre), counter: clockwise == frame.mirrors() });
            split(place(at), place(element.to), round, index, &mut parts);
            at = element.to;
        }
        Self { parts }
    }

    /// The contour with a straight way before it: what stands between the starting point and its first point is not to be
    /// cut below that point.
    pub fn with_lead(mut self, u: f64) -> Self {
        if let Some(first) = self.parts.first()
            && u - first.from[0] > EPS
        {
            let lead = Part { from: [u, first.from[1]], to: first.from, round: None, element: first.element };
            self.parts.insert(0, lead);
        }
        self
    }

    /// The contour with a straight way across the passes behind it, up to a v.
    pub fn with_wall(mut self, v: f64) -> Self {
        if let Some(last) = self.parts.last()
            && v - last.to[1] > EPS
        {
            let wall = Part { from: last.to, to: [last.to[0], v], round: None, element: last.element };
            self.parts.push(wall);
        }
        self
    }

    /// All of the contour.
    pub fn whole(&self) -> Vec<Leg> {
        self.parts.iter().map(|part| Leg { to: part.to, round: part.round, element: part.element }).collect()
    }

    /// The last point.
    pub fn end(&self) -> Option<[f64; 2]> {
        self.parts.last().map(|part| part.to)
    }

    /// The least v among parts.
    pub fn bottom(&self, range: RangeInclusive<usize>) -> f64 {
        self.within(range).fold(f64::INFINITY, |low, part| low.min(part.from[1]).min(part.to[1]))
    }

    /// The least and the greatest of u and of v.
    pub fn reach(&self) -> [[f64; 2]; 2] {
        let mut reach = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for part in &self.parts {
            for p in [part.from, part.to] {
                for (bounds, value) in reach.iter_mut().zip(p) {
                    *bounds = [bounds[0].min(value), bounds[1].max(value)];
                }
            }
        }
        reach
    }

    /// How many times the contour turns from rising to falling: the walls between pockets.
    pub fn crests(&self) -> usize {
        let mut rising = false;
        let mut crests = 0;
        for part in &self.parts {
            let rise = part.to[1] - part.from[1];
            if rise > EPS {
                rising = true;
            } else if rise < -EPS && rising {
                (rising, crests) = (false, crests + 1);
            }
        }
        crests
    }

    /// The first element that goes back along an axis of the drawing by more than `tolerance`: towards +u for axis 0,
    /// towards −v for axis 1.
    pub fn goes_back(&self, axis: usize, tolerance: f64) -> Option<usize> {
        let sign = if axis == 0 { -1.0 } else { 1.0 };
        let mut farthest = f64::NEG_INFINITY;
        self.parts.iter().find_map(|part| {
            farthest = farthest.max(sign * part.from[axis]);
            let back = farthest - sign * part.to[axis] > tolerance;
            back.then_some(part.element)
        })
    }

    /// The first element of a contour into which the same contour, moved, would be cut by more than `tolerance`. Both go one way
    /// along u; where one of them has no v nothing is asked.
    ///
    /// Between two u at which a part of either begins or ends both are smooth: they are held against each other next to those and at
    /// some places between.
    pub fn cut_by(&self, moved: &Self, tolerance: f64) -> Option<usize> {
        let ends = |path: &Self| path.parts.iter().flat_map(|part| [part.from[0], part.to[0]]).collect::<Vec<_>>();
        let mut breaks = [ends(self), ends(moved)].concat();
        breaks.sort_by(|one, other| other.total_cmp(one));
        let highest = |path: &Self, u: f64| {
            let over = path.parts.iter().filter_map(|part| Some((part.v_at(u)?, part.element)));
            over.max_by(|one, other| one.0.total_cmp(&other.0))
        };
        breaks.windows(2).filter(|pair| pair[0] - pair[1] > tolerance).find_map(|pair| {
            (1..CUT_LOOKS).find_map(|look| {
                let part = match look {
                    1 => EPS,
                    CUT_LOOK_LAST => 1.0 - EPS,
                    _ => f64::from(look) / f64::from(CUT_LOOKS),
                };
                let u = pair[0] + (pair[1] - pair[0]) * part;
                let ((own, element), (other, _)) = (highest(self, u)?, highest(moved, u)?);
                (own - other > tolerance).then_some(element)
            })
        })
    }

    fn within(&self, range: RangeInclusive<usize>) -> impl Iterator<Item = &Part> {
        self.parts.iter().skip(*range.start()).take((range.end() + 1).saturating_sub(*range.start()))
    }

    /// The free ways at a v among some parts.
    pub fn spans(&self, v: f64, range: RangeInclusive<usize>) -> Vec<Span> {
        let first = *range.start();
        let free = |p: [f64; 2]| p[1] <= v + EPS;
        let mut spans = Vec::new();
        let mut open: Option<Option<Loc>> = None;
        for (index, part) in self.within(range).enumerate().map(|(at, part)| (first + at, part)) {
            if index == first && free(part.from) {
                open = Some(None);
            }
            match (free(part.from), free(part.to)) {
                (true, false) => {
                    let close = Some(Loc { part: index, at: [part.u_at(v), v] });
                    spans.extend(open.take().map(|open| Span { open, close }));
                }
                (false, true) => open = Some(Some(Loc { part: index, at: [part.u_at(v), v] })),
                _ => {}
            }
        }
        spans.extend(open.map(|open| Span { open, close: None }));
        spans
    }

    /// The way along the contour from a place where it rises, up to a v or to where it falls again.
    pub fn rise(&self, from: Loc, v: f64) -> Vec<Leg> {
        let mut legs = Vec::new();
        let mut at = from.at;
        for part in self.parts.iter().skip(from.part) {
            if part.to[1] < part.from[1] - EPS || at[1] >= v - EPS {
                break;
            }
            let to = if part.to[1] > v { [part.u_at(v), v] } else { part.to };
            if !same(at, to) {
                legs.push(Leg { to, round: part.round, element: part.element });
                at = to;
            }
        }
        legs
    }

    /// The way along the contour down to a place where it falls, from a v or from where it last rose: where that begins,
    /// and the legs.
    pub fn fall(&self, to: Loc, v: f64) -> ([f64; 2], Vec<Leg>) {
        let mut legs: Vec<Leg> = Vec::new();
        let mut begin = to.at;
        let mut end = to.at;
        for part in self.parts.iter().take(to.part + 1).rev() {
            if part.to[1] > part.from[1] + EPS || begin[1] >= v - EPS {
                break;
            }
            begin = if part.from[1] > v { [part.u_at(v), v] } else { part.from };
            if !same(begin, end) {
                legs.push(Leg { to: end, round: part.round, element: part.element });
            }
            end = begin;
        }
        legs.reverse();
        (begin, legs)
    }
}

/// An element with every point moved.
pub(super) fn moved(element: &Element, by: [f64; 2]) -> Element {
    let place = |p: [f64; 2]| [p[0] + by[0], p[1] + by[1]];
    Element {
        to: place(element.to),
        arc: element.arc.map(|(centre, clockwise)| (place(centre), clockwise)),
        ..*element
    }
}
