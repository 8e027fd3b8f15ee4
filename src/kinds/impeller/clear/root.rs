//! What is left in the corner between faces and floor: looked for on a grid, with the blocks as they are; and about
//! the largest tool that leaves no more than is allowed.
//!
//! # Derivation
//! On a flank the axis is parallel to the face and the end lies in the ball of radius r_f. At the rim, where the tube is
//! bent the most across the blade, the end so stands above the floor at the face by
//!
//! > c_r = √(r_f² − ((e/2)·cos α)²) − √(r_f² − (a + w·cos α)²), w = e/2 + a.
//!
//! Own-normal lanes reach the floor but lean against the top edge by about w·κ_b; where κ_b < 0 they touch the root first.
//! Both passes leave only what both miss. That law is no bound: at the hub end of the obverse more may be left. So the rest
//! is looked for: down each line of a face, from the tops, as far as no more than a limit is left to the nearest pose of
//! the finishing tool; and on the floor towards each foot likewise. The poses are some of those that the tool takes, and
//! each line is left at the last place that holds, so that what is told of a line is no less than what is left on
//! it. Between the lines it is not looked at.
//!
//! Above the corner's height the faces are looked at too. Just above it nearly as much is left as counts as the corner's;
//! and where the end of a flank's tool stands high, what is left beside it may be less than counts as the corner's and
//! more than the fit leaves.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::Vector3;

use crate::kinds::impeller::clear::body::turn;
use crate::kinds::impeller::clear::contact::ToolBesideFaces;
use crate::kinds::impeller::clear::cut::Job;
use crate::kinds::impeller::clear::flank::FlankWay;
use crate::kinds::impeller::clear::lane::OwnNormal;
use crate::kinds::impeller::clear::poses::{Pose, Poses};
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM, Ruling};
use crate::number::root::{halved, last_whole};
use crate::number::trig::{hypot, sin_cos};

/// The rest of the floor is told farther from the walls than this and the corner radius, mm.
pub const BESIDE: f64 = 0.4;

/// Lines of a face, and of a half-round nose, that are looked at.
const LINES: u16 = 160;
const NOSE_LINES: u16 = 24;
/// Lines of each straight end of a face, and how far inside of its edge the last one is, radians of v.
const END_LINES: u16 = 16;
const EDGE: f64 = 1e-6;
/// Steps down a line, mm.
const DOWN: f64 = 0.01;
/// Steps along the floor, mm.
const ALONG: f64 = 0.02;
/// Halvings towards the half of the height.
const HALF_WAY: u8 = 24;
/// Halvings of the last step down a line.
const HALVINGS: u8 = 4;
/// Stations from which a tool's rest is known before there is a plan: at least, and at most.
const STATIONS: [f64; 2] = [240.0, 4_000.0];
/// The largest tool is sought in whole hundredths, from the smallest on.
const SMALLEST: f64 = 10.0;

/// What is left in the corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// Where more than this is left, mm.
    pub over: f64,
    /// Up the face, from the floor.
    pub height: f64,
    /// v of the line on which `height` was found, radians.
    pub v: f64,
    /// How thick it is there half-way up.
    pub thick: f64,
    /// Along the floor, from the face.
    pub width: f64,
    /// v of the line on which `width` was found, radians.
    pub width_v: f64,
    /// The most that is left of the faces higher up.
    pub above: f64,
}

/// A line of a face down to the floor.
#[derive(Clone, Copy, Debug)]
pub struct FaceLine {
    ruling: Ruling,
    /// From which depth on.
    top: f64,
    /// Out of the face.
    out: Vector3<f64>,
    v: f64,
    /// By how much it is turned about the axis of the part.
    turn: f64,
}

impl FaceLine {
    /// v of its ruling, radians.
    #[must_use]
    pub const fn v(&self) -> f64 {
        self.v
    }

    /// Where it comes to the floor; `None` outside the blank.
    #[must_use]
    pub fn foot(&self, part: &Part) -> Option<Vector3<f64>> {
        let foot = self.ruling.at(part.floor(&self.ruling, self.top));
        part.trimmed(&foot).then(|| turn(self.turn)(&foot))
    }
}

/// The lines of a face of a blade turned about the axis of the part, from v on, as far as it is in the blank.
#[must_use]
pub fn face_lines(part: &Part, face: Face, turn: f64, from: f64) -> Vec<FaceLine> {
    let pieces = part.pieces(face);
    // At its very edges a face is not in the blank but on it.
    let begin = pieces.first().map_or(HUB, |piece| piece.v[0] + EDGE).max(from);
    let end = pieces.last().map_or(RIM, |piece| piece.v[1] - EDGE);
    let evenly = |[low, high]: [f64; 2], lines: u16| {
        (0..=lines).map(move |line| low + (high - low) * f64::from(line) / f64::from(lines))
    };
    // Straight ends are short, and what is left of them changes most.
    let ends = [[begin, HUB], [RIM, end]].into_iter().filter(|[low, high]| low < high);
    evenly([begin, end], LINES)
        .chain(ends.flat_map(|end| evenly(end, END_LINES)))
        .chain([HUB, RIM].into_iter().filter(|v| (begin..=end).contains(v)))
        .map(|v| {
            let out = part.frame(v).1.b * face.side();
            FaceLine { ruling: part.ruling(face, v), top: part.top(v), out, v, turn }
        })
        .collect()
}

/// The lines of the half-round nose of a splitter that begins at v_s.
#[must_use]
pub fn nose_lines(part: &Part, v_s: f64, turn: f64) -> Vec<FaceLine> {
    let frame = part.frame(v_s).1;
    (0..=NOSE_LINES)
        .map(|line| {
            let f = PI * f64::from(line) / f64::from(NOSE_LINES) - FRAC_PI_2;
            let (sin, cos) = sin_cos(f);
            let out = frame.b * sin - frame.t * cos;
            FaceLine { ruling: part.nose(v_s, f), top: part.nose_top(v_s, f), out, v: v_s, turn }
        })
        .collect()
}

/// What the poses of a tool leave along some lines: where it is more than `over`.
#[must_use]
pub fn root(part: &Part, lines: &[FaceLine], poses: &Poses, tool: Tool, over: f64) -> Root {
    let torus = part.circle.torus;
    let r_f = torus.r + part.a_p;
    let mut root = Root { over, height: 0.0, v: HUB, thick: 0.0, width: 0.0, width_v: HUB, above: over };
    let (mut last, mut highest) = (0, None);
    for line in lines {
        let turn = turn(line.turn);
        // How far inside of what is held a point is. The pose that has held the last place usually holds the next one.
        let mut held = |point: &Vector3<f64>| {
            let point = turn(point);
            let inside = |pose: &Pose| Some(over - pose.apart(tool, &point)).filter(|&inside| inside >= 0.0);
            poses.get(last).and_then(inside).or_else(|| {
                last = poses.holding(tool, &point, over, last)?;
                poses.get(last).and_then(inside)
            })
        };
        let bottom = part.floor(&line.ruling, line.top);
        let (mut height, mut last_held) = (None, None);
        let mut h = line.top;
        while h < bottom {
            let point = line.ruling.at(h);
            let depth = part.depth(&point);
            let mut step = DOWN;
            // What is no higher than the highest known is not looked at.
            let high = (part.a_p - depth + DOWN).min(part.a_p);
            if depth >= 0.0 && high > root.height && part.trimmed(&point) {
                let Some(inside) = held(&point) else {
                    height = Some(last_held.map_or(high, |held_at: f64| {
                        let last = halved([held_at, h], HALVINGS, |h| held(&line.ruling.at(h)).is_some());
                        part.a_p - part.depth(&line.ruling.at(last))
                    }));
                    break;
                };
                last_held = Some(h);
                // What is nearer to the point than that is held by the same pose.
                step = step.max(inside);
            }
            h += step;
        }
        if let Some(height) = height.filter(|height| *height > root.height) {
            root = Root { height, v: line.v, ..root };
            highest = Some(line);
        }
        let foot = line.ruling.at(bottom);
        // Along the floor, out of the face.
        let mut clear = |aside: f64| {
            let place = foot + line.out * aside;
            let rho = hypot(place.x, place.y);
            let c = Vector3::new(place.x / rho, place.y / rho, 0.0) * torus.R;
            let point = c + (place - c).try_normalize(1e-9).unwrap_or(line.out) * r_f;
            !part.trimmed(&point) || held(&point).is_some()
        };
        // Farther out than `BESIDE` it is the floor's rest; where the corner's goes on beyond, it counts as the corner's.
        let mut width = BESIDE + tool.r_c;
        if clear(width) {
            // Nor is what is no wider than the widest known.
            let known = (root.width - ALONG).max(0.0);
            while width > known && clear(width) {
                width -= ALONG;
            }
            width = if width > known { width + ALONG } else { 0.0 };
        } else {
            while width < BESIDE + tool.a() && !clear(width) {
                width += ALONG;
            }
        }
        if width > root.width {
            root = Root { width, width_v: line.v, ..root };
        }
    }
    let thick = highest.map_or(0.0, |line| {
        let below = |h: f64| part.a_p - part.depth(&line.ruling.at(h)) < root.height / 2.0;
        let half_way = halved([line.top, part.floor(&line.ruling, line.top)], HALF_WAY, |h| !below(h));
        poses.apart(tool, &turn(line.turn)(&line.ruling.at(half_way)), part.a_p)
    });
    Root { thick, ..root }
}

/// The most that the poses of a tool leave along some lines higher above the floor than the corner; `None` where it is nowhere
/// more than `most`.
#[must_use]
pub fn left_above(part: &Part, lines: &[FaceLine], poses: &Poses, tool: Tool, [corner, most]: [f64; 2]) -> Option<f64> {
    let mut found = None;
    let (mut most, mut last) = (most, 0);
    for line in lines {
        let turn = turn(line.turn);
        // From the corner up: there the most is left.
        let mut h = part.floor(&line.ruling, line.top) - DOWN;
        while h >= line.top {
            let point = line.ruling.at(h);
            let depth = part.depth(&point);
            let mut step = DOWN;
            if depth >= 0.0 && part.a_p - depth >= corner && part.trimmed(&point) {
                let point = turn(&point);
                let apart = |pose: &Pose| pose.apart(tool, &point);
                let mut here = poses.get(last).map_or(f64::INFINITY, apart);
                if here > most {
                    if let Some(held) = poses.holding(tool, &point, most, last) {
                        last = held;
                        here = poses.get(last).map_or(f64::INFINITY, apart);
                    } else {
                        most = poses.apart(tool, &point, f64::INFINITY);
                        (found, here) = (Some(most), most);
                    }
                }
                // What is nearer to the point than that is held by the same pose.
                step = step.max(most - here);
            }
            h -= step;
        }
    }
    found
}

/// c_r, how high the end of a flank's tool stands above the floor at the face at the rim.
#[must_use]
pub fn law(part: &Part, tool: Tool) -> f64 {
    let torus = part.circle.torus;
    let (r_f, cos_alpha) = (torus.r + part.a_p, part.circle.k / torus.R);
    let w = part.e / 2.0 + tool.a();
    let inner = part.e / 2.0 * cos_alpha;
    let (ball, reach) = (r_f - tool.r_c, tool.flat_radius() + w * cos_alpha);
    let floor = (r_f * r_f - inner * inner).max(0.0).sqrt();
    let end = (ball * ball - reach * reach).max(0.0).sqrt() + tool.r_c;
    (floor - end).max(0.0) + tool.r_c
}

/// What a tool leaves in the corners of a blade, by its ways along both faces and the lanes that touch them.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held from 240 to 4,000")]
fn left(job: &Job, tool: Tool, over: f64) -> Option<f64> {
    let part = &job.part;
    let torus = part.circle.torus;
    let lane = OwnNormal::new(torus, tool, torus.r + part.a_p)?;
    let beside = ToolBesideFaces::new(part, lane, 0.0);
    // Between two of its places s apart a tool leaves s²/(4 d): a quarter of what counts at most, on the longest way there is.
    let apart = (tool.d * over).sqrt();
    let count = ((torus.R + part.a_p) * 2.0 / apart).clamp(STATIONS[0], STATIONS[1]).ceil();
    let mut most: f64 = 0.0;
    for face in Face::ALL {
        let way = FlankWay::new(part, face, tool, [0.0, part.a_p], 0.0);
        let stations = || (0..=count as u16).map(|station| f64::from(station) / count);
        let at = |q: f64| Pose::from(lane.axis(q, beside.psi(face, q), 0.0));
        let along = stations().map(|part| Pose::from(way.axis(way.v[0] + (way.v[1] - way.v[0]) * part)));
        // The run-outs are longer than what lies between them: it is looked at as often as they are.
        let out = stations().map(|part| at(-tool.a() + (1.0 + 2.0 * tool.a()) * part));
        let poses = Poses::new(along.chain(out).chain(stations().map(at)).collect());
        most = most.max(root(part, &face_lines(part, face, 0.0, f64::NEG_INFINITY), &poses, tool, over).height);
    }
    Some(most)
}

/// The largest flat end mill up to a diameter that by these passes alone leaves more than `over` nowhere higher up a face than
/// `height`, in whole hundredths; `None` where even the smallest leaves more.
#[must_use]
pub fn largest_that_leaves(job: &Job, height: f64, up_to: f64, over: f64) -> Option<f64> {
    let d = |hundredths: f64| hundredths / 100.0;
    let keeps = |hundredths: f64| left(job, Tool::flat(d(hundredths)), over).is_some_and(|left| left <= height);
    let most = (up_to * 100.0).floor();
    if most >= SMALLEST && keeps(most) {
        return Some(d(most));
    }
    (most >= SMALLEST && keeps(SMALLEST)).then(|| d(last_whole([SMALLEST, most], keeps)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::torus::Torus;

    #[test]
    fn lines_of_a_face_reach_from_the_plane_of_the_hub_to_the_cylinder_of_the_rim() {
        let part = Part::with(Torus { R: 41.144, r: 27.296 }, 2.541, 5.901);
        let at = |face: Face| {
            let lines = face_lines(&part, face, 0.0, f64::NEG_INFINITY);
            let points = lines.iter().map(|line| line.ruling.at(line.top + 1.0)).filter(|point| part.trimmed(point));
            points.map(|point| [point.z, hypot(point.x, point.y)]).collect::<Vec<_>>()
        };
        // The straight ends stand on the obverse at the hub, and on the reverse at the rim.
        let hub = at(Face::Obverse).iter().map(|[z, _]| *z).fold(f64::NEG_INFINITY, f64::max);
        let rim = at(Face::Reverse).iter().map(|[_, rho]| *rho).fold(0.0, f64::max);
        assert!(hub > -1e-4 && rim > part.circle.torus.R - 1e-4, "{hub} {rim}");
    }

    #[test]
    fn heights_are_those_of_the_check_values() {
        for (R, r, e, a_p, height) in
            [(25.0, 15.0, 2.0, 2.0, 1.152_079), (25.0, 17.0, 1.0, 4.0, 0.747_925), (50.0, 30.0, 2.0, 3.0, 0.577_958)]
        {
            let found = law(&Part::with(Torus { R, r }, e, a_p), Tool::flat(6.0));
            assert!((found - height).abs() < 5.1e-7, "{found:?}");
        }
    }
}
