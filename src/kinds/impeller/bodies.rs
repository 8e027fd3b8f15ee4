//! Blades and splitters as closed bodies with plane facets, to be shown and drawn: the part as [`part`](super::part) defines
//! it, ends cut off by the blank.
//!
//! # Derivation
//! A face is followed at depths T = r + s·a_p, s from 0 at the tops to 1 on the floor. At each of them v runs from where the
//! face comes into the blank, z = 0, to where it leaves it, x² + y² = R². So the first row of a body lies in the hub plane, the
//! last on the rim cylinder, its top on the turned surface and its foot on the floor. Between both faces of a row, points lie on
//! the torus of their depth. A splitter that is cut clear begins at v_s with a half round about its mean ruling; one that is cut
//! as published begins where its two passes leave something.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::kinds::impeller::splitter::Splitter;
use crate::number::root::halved;
use crate::number::trig::{atan2, hypot, sin_cos};

/// Steps of Newton's method down a ruling: it stands nearly upright in the surface.
const NEWTON: u8 = 8;
/// Halvings to where a face comes out of the blank.
const HALVINGS: u8 = 50;
/// Places at which the beginning of a published splitter is looked for.
const STARTS: u16 = 480;

/// How finely a body is parted.
#[derive(Clone, Copy, Debug)]
pub struct Steps {
    /// From the hub to the rim.
    pub along: u16,
    /// From the tops to the floor.
    pub deep: u16,
    /// From the obverse to the reverse.
    pub across: u16,
}

/// On which side of a body a facet lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// On the turned surface.
    Top,
    /// On the floor, T = r + a_p.
    Foot,
    /// On the side of +b.
    Obverse,
    /// On the side of −b.
    Reverse,
    /// The end at the hub, or where a published splitter begins.
    Begin,
    /// The half round of a splitter.
    Nose,
    /// The end at the rim, x² + y² = R².
    End,
}

/// A facet: its corners counter-clockwise from outside, two of which may be one.
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    /// Indices of points.
    pub corners: [usize; 4],
    /// Where it lies.
    pub side: Side,
}

/// A blade or a splitter.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its corners, mm, in the part frame.
    pub points: Vec<Vector3<f64>>,
    /// Its facets: every edge belongs to two.
    pub facets: Vec<Facet>,
    /// Its outline on the turned surface and on the floor, from the obverse at its beginning round to there.
    pub outlines: [Vec<Vector3<f64>>; 2],
}

/// The bodies of a part: the first blade, and the splitter that stands half a pitch beside it.
#[derive(Clone, Debug)]
pub struct Bodies {
    /// Blade 0; blade i stands 2π·i/N further about Z.
    pub blade: Body,
    /// `None` where the design has no splitters.
    pub splitter: Option<Body>,
}

/// How a body begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Beginning {
    /// In the hub plane, z = 0.
    Hub,
    /// At v, with a flat end.
    Flat(f64),
    /// At v, with a half round.
    Round(f64),
}

impl Bodies {
    /// Those of a design: its splitters as the plan of a clear cut has them, or as the published passes leave them.
    #[must_use]
    pub fn new(design: &Design, blade: &Blade, splitter: Option<&Splitter>, plan: Option<&Plan>, steps: Steps) -> Self {
        let part = Part::new(design);
        let full = [part.e / 2.0; 2];
        let turn = -PI / f64::from(design.N);
        let v_s = plan.and_then(|plan| plan.told.splitter_from);
        let between = match (v_s, splitter) {
            (Some(v_s), _) => Some(Body::new(&part, |_| full, Beginning::Round(v_s), steps)),
            (None, Some(splitter)) => {
                let halves = |v: f64| splitter_halves(design, blade, splitter, v);
                let place = |start: u16| HUB + FRAC_PI_2 * f64::from(start) / f64::from(STARTS);
                let begin = (0..STARTS).map(place).find(|&v| halves(v).iter().sum::<f64>() > 0.0);
                begin.map(|begin| Body::new(&part, halves, Beginning::Flat(begin), steps))
            }
            (None, None) => None,
        };
        Self {
            blade: Body::new(&part, |_| full, Beginning::Hub, steps),
            splitter: between.map(|body| body.turned(turn)),
        }
    }
}

/// What the published passes leave of a splitter at v between them: how far towards +b and towards −b.
fn splitter_halves(design: &Design, blade: &Blade, splitter: &Splitter, v: f64) -> [f64; 2] {
    let last = blade.points().saturating_sub(1);
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    let position = (v - PI) / FRAC_PI_2 * last as f64;
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    let position = position.clamp(0.0, last as f64);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the last index")]
    let below = position as usize;
    #[expect(clippy::cast_precision_loss, reason = "an index of a point")]
    let part = position - below as f64;
    // Between two points the fraction is a power of a straight line: a straight line serves a drawing.
    [&splitter.back, &splitter.out].map(|side| {
        let at = |index: usize| side.fraction.get(index).copied().unwrap_or(1.0);
        let fraction = at(below) + (at(below + 1) - at(below)) * part;
        design.w() * fraction - design.d_t / 2.0
    })
}

/// A point turned about the axis of the part.
#[must_use]
pub fn about_axis(point: &Vector3<f64>, angle: f64) -> Vector3<f64> {
    let (sin, cos) = sin_cos(angle);
    Vector3::new(point.x * cos - point.y * sin, point.x * sin + point.y * cos, point.z)
}

impl Body {
    /// The body between two faces so far from the mean surface towards +b and −b at each v.
    #[must_use]
    pub fn new(part: &Part, halves: impl Fn(f64) -> [f64; 2], beginning: Beginning, steps: Steps) -> Self {
        let Steps { along, deep, across } = steps;
        let share = |at: u16, of: u16| f64::from(at) / f64::from(of.max(1));
        let walls = Walls { part, halves };
        // Round a nose the steps across are even in angle; where there is none they serve as well.
        let aside = |k: u16| (1.0 - sin_cos(PI * share(k, across)).1) / 2.0;
        let level = |s: u16| {
            let depth = part.a_p * share(s, deep);
            let ends = Face::ALL.map(|face| walls.ends(face, depth, beginning));
            (depth, ends)
        };
        let levels: Vec<_> = (0..=deep).map(level).collect();
        let row = |p: u16| -> Vec<Vec<Vector3<f64>>> {
            let at = |(depth, ends): &(f64, [[f64; 2]; 2])| {
                let sides = [0, 1].map(|side: usize| {
                    let [from, to] = ends[side];
                    walls.at(Face::ALL[side], from + (to - from) * share(p, along), *depth)
                });
                (0..=across).map(|k| part.between(&sides, aside(k))).collect()
            };
            levels.iter().map(at).collect()
        };
        let mut rows: Vec<_> = Vec::new();
        if let Beginning::Round(v) = beginning {
            let nose = |(depth, _): &(f64, _)| {
                (0..=across).map(|k| walls.nose(v, PI * (0.5 - share(k, across)), *depth)).collect()
            };
            rows.push(levels.iter().map(nose).collect::<Vec<Vec<_>>>());
        }
        rows.extend((0..=along).map(row));
        Self::of(&rows, matches!(beginning, Beginning::Round(_)))
    }

    /// The body over a net of points: rows from its beginning to its end, of levels from its top to its foot, of points from
    /// the obverse to the reverse. With a nose the ends of each level of the first row are those of the second.
    fn of(rows: &[Vec<Vec<Vector3<f64>>>], nose: bool) -> Self {
        let (length, depth) = (rows.len(), rows.first().map_or(0, Vec::len));
        let width = rows.first().and_then(|row| row.first()).map_or(0, Vec::len);
        let (Some(end), Some(foot), Some(side)) = (length.checked_sub(1), depth.checked_sub(1), width.checked_sub(1))
        else {
            return Self { points: Vec::new(), facets: Vec::new(), outlines: [Vec::new(), Vec::new()] };
        };
        let at = |p: usize, s: usize, k: usize| {
            let p = if nose && p == 0 && (k == 0 || k == side) { 1 } else { p };
            (p * depth + s) * width + k
        };
        let mut facets = Vec::new();
        let mut add = |side: Side, corners: [usize; 4]| facets.push(Facet { corners, side });
        for p in 0..end {
            for k in 0..side {
                add(Side::Top, [at(p, 0, k), at(p + 1, 0, k), at(p + 1, 0, k + 1), at(p, 0, k + 1)]);
                add(Side::Foot, [at(p, foot, k), at(p, foot, k + 1), at(p + 1, foot, k + 1), at(p + 1, foot, k)]);
            }
            for s in 0..foot {
                add(Side::Obverse, [at(p, s, 0), at(p, s + 1, 0), at(p + 1, s + 1, 0), at(p + 1, s, 0)]);
                add(Side::Reverse, [at(p, s, side), at(p + 1, s, side), at(p + 1, s + 1, side), at(p, s + 1, side)]);
            }
        }
        let begin = if nose { Side::Nose } else { Side::Begin };
        for s in 0..foot {
            for k in 0..side {
                add(begin, [at(0, s, k), at(0, s, k + 1), at(0, s + 1, k + 1), at(0, s + 1, k)]);
                add(Side::End, [at(end, s, k), at(end, s + 1, k), at(end, s + 1, k + 1), at(end, s, k + 1)]);
            }
        }
        // Where both faces meet a nose nothing is left of a facet beside it.
        facets.retain(|facet| {
            let [a, b, c, d] = facet.corners;
            !(a == b && c == d || b == c && d == a)
        });
        let all: Vec<Vector3<f64>> = rows.iter().flatten().flatten().copied().collect();
        let outline = |s: usize| {
            let out = (0..=end).map(|p| at(p, s, 0));
            let rim = (1..side).map(|k| at(end, s, k));
            let back = (0..=end).rev().map(|p| at(p, s, side));
            let round = (0..side).rev().map(|k| at(0, s, k));
            out.chain(rim).chain(back).chain(round).filter_map(|index| all.get(index).copied()).collect()
        };
        let outlines = [outline(0), outline(foot)];
        // Only what lies on the outside is kept.
        let (mut points, mut known) = (Vec::new(), vec![usize::MAX; all.len()]);
        for corner in facets.iter_mut().flat_map(|facet| &mut facet.corners) {
            if let (Some(place), Some(point)) = (known.get_mut(*corner), all.get(*corner)) {
                if *place == usize::MAX {
                    *place = points.len();
                    points.push(*point);
                }
                *corner = *place;
            }
        }
        Self { points, facets, outlines }
    }

    /// The body turned about the axis of the part.
    #[must_use]
    pub fn turned(&self, angle: f64) -> Self {
        let turn = |points: &Vec<Vector3<f64>>| points.iter().map(|point| about_axis(point, angle)).collect();
        let [top, foot] = &self.outlines;
        Self { points: turn(&self.points), facets: self.facets.clone(), outlines: [turn(top), turn(foot)] }
    }
}

/// Two faces so far from the mean surface towards +b and −b.
struct Walls<'a, F> {
    part: &'a Part,
    halves: F,
}

impl<F: Fn(f64) -> [f64; 2]> Walls<'_, F> {
    /// The point of a face at v and a depth below the tops.
    fn at(&self, face: Face, v: f64, depth: f64) -> Vector3<f64> {
        let (P, frame) = self.part.frame(v);
        let [plus, minus] = (self.halves)(v);
        let half = if face == Face::Obverse { plus } else { minus };
        self.part.down(&(P + frame.b * (face.side() * half)), &frame.N, depth)
    }

    /// The point of the half round about the ruling at v, at an angle from −t towards +b.
    fn nose(&self, v: f64, angle: f64, depth: f64) -> Vector3<f64> {
        let (P, frame) = self.part.frame(v);
        let (sin, cos) = sin_cos(angle);
        let half = (self.halves)(v)[0];
        self.part.down(&(P + (frame.b * sin - frame.t * cos) * half), &frame.N, depth)
    }

    /// Between which v a face is in the blank at a depth.
    fn ends(&self, face: Face, depth: f64, beginning: Beginning) -> [f64; 2] {
        let Torus { R, r } = self.part.circle.torus;
        let near = (1.5 * self.part.e * self.part.circle.k / r / R).clamp(1e-3, FRAC_PI_4);
        let begin = match beginning {
            Beginning::Hub => border([HUB - near, HUB + near], |v| self.at(face, v, depth).z),
            Beginning::Flat(v) | Beginning::Round(v) => v,
        };
        let end = border([RIM + near, RIM - near], |v| {
            let point = self.at(face, v, depth);
            hypot(point.x, point.y) - R
        });
        [begin, end.max(begin)]
    }
}

/// Where a function that is positive at the first place and negative at the second is 0; the nearer of the places where it is
/// not so.
fn border([out, inside]: [f64; 2], over: impl Fn(f64) -> f64) -> f64 {
    let is_out = |v: f64| over(v) > 0.0;
    halved([inside, out], HALVINGS, |v| !is_out(v))
}

impl Part {
    /// The point at a depth below the tops on a line from near them along −N; where the line does not come so deep, its point
    /// nearest to the axis of the part.
    fn down(&self, foot: &Vector3<f64>, N: &Vector3<f64>, depth: f64) -> Vector3<f64> {
        let R = self.circle.torus.R;
        let level = N.xy().norm_squared();
        let far = if level > 1e-12 { foot.xy().dot(&N.xy()) / level } else { R };
        let far = if far > 0.0 { far } else { R };
        let mut h = depth;
        for _ in 0..NEWTON {
            let point = foot - N * h;
            let rho = hypot(point.x, point.y).max(1e-9);
            let beside = (rho - R) / rho;
            let from = Vector3::new(point.x * beside, point.y * beside, point.z);
            let slope = -from.dot(N) / from.norm();
            h = (h + (depth - self.depth(&point)) / slope.max(0.2)).min(far);
        }
        foot - N * h
    }

    /// A point at a share of the way between two, on the torus of their depth.
    fn between(&self, [one, other]: &[Vector3<f64>; 2], share: f64) -> Vector3<f64> {
        if share <= 0.0 {
            return *one;
        }
        if share >= 1.0 {
            return *other;
        }
        let R = self.circle.torus.R;
        let place = |point: &Vector3<f64>| {
            let beside = hypot(point.x, point.y) - R;
            Vector3::new(atan2(point.y, point.x), atan2(point.z, beside).rem_euclid(TAU), hypot(beside, point.z))
        };
        let (from, mut to) = (place(one), place(other));
        to.x -= ((to.x - from.x) / TAU).round() * TAU;
        let [psi, v, T] = (from + (to - from) * share).into();
        Torus { R, r: T }.point(psi, v)
    }
}
