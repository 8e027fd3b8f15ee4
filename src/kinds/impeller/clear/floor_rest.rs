//! What the passes leave on the floor, some way off from the walls: looked for on a grid, with the blocks as they are.
//!
//! # Derivation
//! The law of the ridges says what lanes leave between them. Beside the walls and round a splitter it says nothing: a floor
//! point at v is touched from the stations v ± θ alone, and where both are shut by a wall it stays higher. So along each
//! line from K through a floor point the lowest place is looked for that the tools of the passes hold, close to each other; what
//! is left is the greatest of what is lacking to a_p. It is a greatest of samples, not a bound: between them it may be a little more.
//!
//! # Units
//! Millimetres and radians.

use std::cell::Cell;
use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::kinds::impeller::clear::body::{Body, turn};
use crate::kinds::impeller::clear::poses::{Pose, Poses};
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::nearest::Axis;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::trig::{atan2, hypot, sin_cos};

/// Stations of the floor that are looked at.
const ALONG: u8 = 48;
/// Rulings by which a wall's foot is known.
const FEET: u16 = 200;
/// What the arithmetic may lose, mm.
const ARITHMETIC: f64 = 1e-9;
/// Steps and halvings for the end of a tool that is not flat.
const STEPS: u8 = 8;
const HALVINGS: u8 = 12;
/// Halvings for the place at a distance from a wall.
const EDGES: u8 = 8;

/// What is left on the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorRest {
    /// Farther from the walls than this, mm.
    pub beside: f64,
    /// It is this much, mm.
    pub most: f64,
    /// v where it is.
    pub v: f64,
}

/// The floor of a channel, and the feet of what stands on it.
struct Floor {
    /// The feet of the two walls as points, and how far two of them that follow each other are apart at most.
    walls: [(Vec<Vector3<f64>>, f64); 2],
    /// v and ψ of the two blades' feet.
    sides: [Vec<[f64; 2]>; 2],
    splitter: Option<Body>,
}

/// The foot of a face turned about the axis of the part: its points on the floor.
fn foot(part: &Part, face: Face, by: f64) -> Vec<Vector3<f64>> {
    let turn = turn(by);
    let beyond = (part.e + part.a_p) / part.circle.torus.r;
    (0..=FEET)
        .map(|foot| HUB - beyond + (RIM - HUB + 2.0 * beyond) * f64::from(foot) / f64::from(FEET))
        .map(|v| {
            let ruling = part.ruling(face, v);
            turn(&ruling.at(part.floor(&ruling, part.top(v))))
        })
        .collect()
}

/// v and ψ of points, ψ near that of the channel.
fn chart(part: &Part, points: &[Vector3<f64>], turn: f64) -> Vec<[f64; 2]> {
    let R = part.circle.torus.R;
    let positive = |angle: f64| if angle < 0.0 { angle + TAU } else { angle };
    let angles = |point: &Vector3<f64>| {
        let v = positive(atan2(point.z, hypot(point.x, point.y) - R));
        let u = part.circle.u(v.clamp(HUB, RIM)) + turn;
        let psi = atan2(point.y, point.x);
        [v, psi - ((psi - u) / TAU).round() * TAU]
    };
    points.iter().map(angles).collect()
}

/// ψ of a foot at v.
fn psi_at(foot: &[[f64; 2]], v: f64) -> f64 {
    let after = foot.partition_point(|point| point[0] < v).clamp(1, foot.len().max(2) - 1);
    match (foot.get(after - 1), foot.get(after)) {
        (Some([v_0, psi_0]), Some([v_1, psi_1])) => psi_0 + (psi_1 - psi_0) * ((v - v_0) / (v_1 - v_0)),
        _ => 0.0,
    }
}

impl Floor {
    fn new(part: &Part, pitch: f64, a: f64, v_s: Option<f64>) -> Self {
        let turns = [0.0, -pitch];
        let walls = [0, 1].map(|side: usize| foot(part, Face::ALL[side], turns[side]));
        let sides = [0, 1].map(|side: usize| chart(part, &walls[side], turns[side]));
        let walls = walls.map(|feet| {
            let apart = feet.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(ARITHMETIC, f64::max) + ARITHMETIC;
            (feet, apart)
        });
        Self { walls, sides, splitter: v_s.map(|v_s| Body::new(part, v_s, -pitch / 2.0, a)) }
    }

    /// True where a point of the floor is no nearer than asked to what stands on it.
    fn is_free(&self, point: &Vector3<f64>, asked: f64) -> bool {
        let here = Axis { foot: *point, along: Vector3::z(), range: [0.0, 0.0] };
        self.walls.iter().all(|(feet, apart)| clear_of(feet, *apart, point, asked))
            && self.splitter.as_ref().is_none_or(|body| body.keeps(&here, asked))
    }
}

/// True where a point is no nearer than asked to any of a row of points, two of which that follow each other are no farther
/// apart than told: what is far from one is far from the next ones as well.
fn clear_of(row: &[Vector3<f64>], apart: f64, point: &Vector3<f64>, asked: f64) -> bool {
    let mut next = 0;
    while let Some(one) = row.get(next) {
        let spare = (point - one).norm() - asked;
        if spare < 0.0 {
            return false;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count, not negative")]
        let over = (spare / apart).min(1e6) as usize;
        next += over.max(1);
    }
    true
}

/// The lowest place along the line from c, between r and r_f, that a tool holds; r where it holds none.
fn reach(tool: Tool, pose: &Pose, c: &Vector3<f64>, out: &Vector3<f64>, [r, r_f]: [f64; 2]) -> f64 {
    let from = c - pose.tip;
    let (along, up) = (out.dot(&pose.along), from.dot(&pose.along));
    let (d, f) = (out - pose.along * along, from - pose.along * up);
    let (square, half, rest) = (d.norm_squared(), d.dot(&f), f.norm_squared() - tool.a() * tool.a());
    let root = half * half - square * rest;
    if root < 0.0 || along > -1e-9 {
        return r;
    }
    // A cylinder is left through its side or through its end.
    let [enter, leave] =
        if square > 1e-14 { [-1.0, 1.0].map(|side| (-half + side * root.sqrt()) / square) } else { [r, r_f] };
    let (low, high) = (enter.max(r), leave.min(up / -along).min(r_f));
    if tool.r_c == 0.0 || high <= low {
        return if high > low { high } else { r };
    }
    // With a round end the place lies higher.
    let inside = |T: f64| {
        let from = from + out * T;
        let up = from.dot(&pose.along);
        let down = (tool.r_c - up).max(0.0);
        let wide = tool.flat_radius() + (tool.r_c * tool.r_c - down * down).max(0.0).sqrt();
        from.norm_squared() - up * up <= wide * wide
    };
    let step = (high - low) / f64::from(STEPS);
    let Some(held) = (0..=STEPS).map(|k| high - step * f64::from(k)).find(|&T| inside(T)) else { return r };
    let (mut low, mut high) = (held, (held + step).min(high));
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if inside(middle) { low = middle } else { high = middle }
    }
    low
}

/// The rest that the poses of a tool leave, farther from the walls than `beside`, from v on; in a channel of the pitch, with
/// a splitter from v_s on, looked at in so many places across.
#[must_use]
pub fn floor_rest(
    part: &Part,
    [pitch, beside]: [f64; 2],
    v_s: Option<f64>,
    tool: Tool,
    (poses, from): (&Poses, f64),
    across: u32,
) -> FloorRest {
    let torus = part.circle.torus;
    let (r, r_f) = (torus.r, torus.r + part.a_p);
    let floor = Floor::new(part, pitch, tool.a(), v_s);
    let mut rest = FloorRest { beside, most: 0.0, v: from };
    let mut last = None;
    for look in 0..ALONG {
        let v = from + (RIM - from) * (f64::from(look) + 0.5) / f64::from(ALONG);
        let (sin_v, cos_v) = sin_cos(v);
        let [high, low] = [0, 1].map(|side: usize| psi_at(&floor.sides[side], v));
        let place = |psi: f64| {
            let (sin, cos) = sin_cos(psi);
            let c = Vector3::new(torus.R * cos, torus.R * sin, 0.0);
            (c, Vector3::new(cos_v * cos, cos_v * sin, sin_v))
        };
        let free = |psi: f64| {
            let (c, out) = place(psi);
            floor.is_free(&(c + out * r_f), beside)
        };
        let mut look = |psi: f64| {
            let (c, out) = place(psi);
            // Of tools whose axis passes farther from the middle of the line than this, none holds a place of it.
            let middle = c + out * f64::midpoint(r, r_f);
            let wide = tool.a() + (r_f - r) / 2.0;
            // The pose that holds the deepest place usually does so for the next line.
            let held = |pose: &Pose| reach(tool, pose, &c, &out, [r, r_f]);
            let deepest = Cell::new(last.and_then(|last| poses.get(last)).map_or(r, held));
            // Nor does one hold a deeper place whose end is above that known.
            let far =
                poses.of(|bunch| bunch.seen(&middle).beside > wide || bunch.seen(&(c + out * deepest.get())).up < 0.0);
            for (number, pose) in far {
                let found = held(pose);
                if found > deepest.get() {
                    deepest.set(found);
                    last = Some(number);
                }
            }
            let deepest = deepest.get();
            if r_f - deepest > rest.most {
                rest = FloorRest { most: r_f - deepest, v, ..rest };
            }
        };
        let mut before: Option<(f64, bool)> = None;
        for step in 0..=across {
            let psi = low + (high - low) * f64::from(step) / f64::from(across);
            let here = free(psi);
            // What stays in the corner of a wall falls off steeply: the place at just that distance from it is looked at.
            if let Some((last, there)) = before
                && there != here
            {
                let (mut shut, mut open) = if there { (psi, last) } else { (last, psi) };
                for _ in 0..EDGES {
                    let middle = f64::midpoint(shut, open);
                    if free(middle) { open = middle } else { shut = middle }
                }
                look(open);
            }
            if here {
                look(psi);
            }
            before = Some((psi, here));
        }
    }
    rest
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::geometry::torus::Torus;

    #[test]
    fn a_tool_is_left_through_its_side_or_its_end() {
        let pose = Pose { tip: Vector3::new(0.0, 0.0, -16.0), along: Vector3::z() };
        let (c, down) = (Vector3::zeros(), -Vector3::z());
        let slant = Vector3::new(0.1, 0.0, -(1.0_f64 - 0.01).sqrt());
        for tool in [Tool::flat(6.0), Tool::ball(6.0)] {
            assert!((reach(tool, &pose, &c, &down, [15.0, 17.0]) - 16.0).abs() < 1e-4);
        }
        let end = reach(Tool::flat(6.0), &pose, &c, &slant, [15.0, 17.0]);
        assert!((end - 16.0 / (1.0_f64 - 0.01).sqrt()).abs() < 1e-12, "{end}");
        let side = reach(Tool::flat(3.1), &pose, &c, &slant, [15.0, 17.0]);
        assert!((side - 15.5).abs() < 1e-9, "{side}");
        assert_eq!(reach(Tool::flat(2.0), &pose, &c, &slant, [15.0, 17.0]), 15.0);
    }

    #[test]
    fn a_row_of_points_is_as_far_as_its_nearest() {
        let row: Vec<Vector3<f64>> = (0..100_u8).map(|k| Vector3::new(f64::from(k) * 0.1, 0.0, 0.0)).collect();
        for k in 0..50_u8 {
            let point = Vector3::new(f64::from(k) * 0.31 - 2.0, 0.4, 0.1);
            let nearest = row.iter().map(|one| (point - one).norm()).fold(f64::INFINITY, f64::min);
            for asked in [0.3, 0.45, 1.0, 3.0] {
                assert_eq!(clear_of(&row, 0.1 + ARITHMETIC, &point, asked), nearest >= asked, "{k} {asked}");
            }
        }
    }

    #[test]
    fn without_a_pass_the_whole_depth_is_left() {
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0);
        let rest = floor_rest(&part, [PI / 2.0, 0.4], None, Tool::flat(3.0), (&Poses::default(), HUB), 20);
        assert_eq!(rest.most, 2.0);
    }
}
