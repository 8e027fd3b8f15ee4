//! Corners: how the path of the nose's centre goes on from one element's offset to the next one's.
//!
//! # Inner corners: derivation
//! The path turns towards the tool: the offsets of both elements meet before the corner, and the nose touches both there.
//!
//! With u the way from the corner to a point, n the unit vector left of the travel at the corner, κ the curvature (positive
//! to the left, 0 for a line), s = 1 for left and −1 for right, the offset of an element by the nose radius R is
//!
//! κ (u² − R²)/2 = u·n − s R
//!
//! for a line at once, and for an arc because its centre is n/κ and its offset's radius |1/κ − s R|. With h = (u² − R²)/2 two
//! of these are linear in u. Along the mean normal N and the mean tangent T of the corner, turned by φ, S = sin(φ/2),
//! C = cos(φ/2), k = (κ₁ + κ₂)/2 and δ = (κ₁ − κ₂)/2,
//!
//! u·N = (s R + k h)/C, u·T = δ h/S
//!
//! and with h = S² ζ the definition of h becomes
//!
//! (δ² + k² S²/C²) ζ² − 2 (1 − s R k/C²) ζ + R²/C² = 0
//!
//! whose smaller root belongs to the crossing near the corner. Nothing in it grows without bound where the elements are
//! tangent. For two lines it comes to the well-known R tan(φ/2) before the corner.
//!
//! # Outer corners
//! The path turns away from the tool by the angle φ. Up to a quarter turn the offsets go on straight along the tangents to
//! their intersection, R tan(φ/2) beyond; past it, both go on by R and a straight line joins them (Fanuc, linear connection
//! of acute outer corners). Beyond the control's limit an arc about the corner takes their place.

use std::f64::consts::PI;

use crate::gcode::turning::nose::element::{Element, End, Path, Point, cross, distance, dot, plus};
use crate::gcode::turning::nose::{Misfit, ROUNDING};
use crate::number::trig;

/// A turn smaller than this, or one this near to half a turn, is rounding of doubles; radians.
const TINY: f64 = 1e-9;
/// How far beyond the corner an intersection may lie by rounding, mm.
const BEYOND: f64 = 1e-6;

/// The way of the nose's centre round a corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// The end of the first element's offset, the points between, the start of the second one's.
    points: [Point; 4],
    count: usize,
    /// An arc about a centre by an angle in place of straight lines.
    around: Option<(Point, f64)>,
    /// By how much the offset of the first element ends before its own end, and that of the second begins after its own
    /// start: mm for lines, radians for arcs; negative where it goes on beyond.
    pub trims: [f64; 2],
}

impl Corner {
    fn at(point: Point, trims: [f64; 2]) -> Self {
        Self { points: [point; 4], count: 1, around: None, trims }
    }

    /// From one point straight to another.
    pub(super) fn straight(from: Point, to: Point) -> Self {
        Self { points: [from, to, to, to], count: 2, around: None, trims: [0.0; 2] }
    }

    /// The end of the first element's offset.
    pub(super) const fn first(&self) -> Point {
        self.points[0]
    }

    /// The start of the second element's offset.
    pub(super) fn last(&self) -> Point {
        self.points.get(self.count.saturating_sub(1)).copied().unwrap_or(self.points[0])
    }

    /// The moves from the first to the last.
    pub(super) fn between(&self) -> impl Iterator<Item = Element> {
        let (points, around) = (self.points, self.around);
        (1..self.count).map(move |next| Element {
            from: points[next - 1],
            to: points[next],
            path: around.map_or(Path::Line, |(centre, sweep)| Path::Arc { centre, sweep }),
        })
    }
}

/// The corner between the end of one element and the start of the next, with the nose of radius `R` on the side `s`, 1 for
/// left and −1 for right. Outer corners turning by more than `straight` go along an arc.
pub(super) fn corner(before: &End, after: &End, s: f64, R: f64, straight: f64) -> Result<Corner, Misfit> {
    let turn = trig::atan2(cross(before.along, after.along), dot(before.along, after.along));
    let starts = [before, after].map(|end| plus(end.at, end.left(), s * R));
    if turn.abs() <= TINY {
        return Ok(Corner::at(starts[1], [0.0; 2]));
    }
    let inner = if PI - turn.abs() <= TINY {
        // The path goes back on itself. Where both sides bend apart the tool's side is outside.
        if s * (before.curvature + after.curvature) < -TINY {
            return Err(Misfit::Corner { radius: R, turn: turn.abs() });
        }
        false
    } else {
        s * turn > 0.0
    };
    if inner {
        inside(before, after, s, R, turn)
    } else {
        Ok(outside(before, after, starts, s * R, turn.abs(), straight))
    }
}

fn outside(before: &End, after: &End, starts: [Point; 2], offset: f64, turn: f64, straight: f64) -> Corner {
    if turn > straight {
        let sweep = -turn.copysign(offset);
        return Corner {
            points: [starts[0], starts[1], starts[1], starts[1]],
            count: 2,
            around: Some((before.at, sweep)),
            trims: [0.0; 2],
        };
    }
    let beyond = offset.abs() * trig::tan(turn.min(PI / 2.0) / 2.0);
    let mut corner = Corner { points: [starts[0]; 4], count: 0, around: None, trims: [0.0; 2] };
    let mut add = |point: Point| {
        // At most four are added.
        if let Some(place) = corner.points.get_mut(corner.count) {
            *place = point;
            corner.count += 1;
        }
    };
    let lines = [before.curvature == 0.0, after.curvature == 0.0];
    if !lines[0] {
        add(starts[0]);
    }
    add(plus(starts[0], before.along, beyond));
    if turn > PI / 2.0 {
        add(plus(starts[1], after.along, -beyond));
    }
    if !lines[1] {
        add(starts[1]);
    }
    corner.trims = lines.map(|line| if line { -beyond } else { 0.0 });
    corner
}

fn inside(before: &End, after: &End, s: f64, R: f64, turn: f64) -> Result<Corner, Misfit> {
    let misfit = Misfit::Corner { radius: R, turn: turn.abs() };
    let (S, C) = trig::sin_cos(turn / 2.0);
    let N = plus(before.left(), after.left(), 1.0).map(|share| share / (2.0 * C));
    let T = [N[1], -N[0]];
    let k = f64::midpoint(before.curvature, after.curvature);
    let delta = (before.curvature - after.curvature) / 2.0;
    let a = delta * delta + k * k * S * S / (C * C);
    let b = 1.0 - s * R * k / (C * C);
    let c = R * R / (C * C);
    let root = b * b - a * c;
    if b <= 0.0 {
        return Err(misfit);
    }
    let zeta = c / (b + root.max(0.0).sqrt());
    let u = plus(N.map(|share| share * (s * R + k * S * S * zeta) / C), T, delta * S * zeta);
    if !u.iter().all(|share| share.is_finite()) {
        return Err(misfit);
    }
    let sides = [before, after];
    // Where the offsets do not meet, they may still pass within the rounding of the program's coordinates.
    if root < 0.0 && sides.iter().any(|side| off(side, u, s, R) > ROUNDING) {
        return Err(misfit);
    }
    let trims = [trim(before, u, s, R, -1.0), trim(after, u, s, R, 1.0)];
    if trims.iter().any(|&trim| trim < -BEYOND) {
        return Err(misfit);
    }
    Ok(Corner::at(plus(before.at, u, 1.0), trims))
}

/// How far the point `u` from the corner is off an element's offset.
fn off(side: &End, u: Point, s: f64, R: f64) -> f64 {
    if side.curvature == 0.0 {
        return (dot(u, side.left()) - s * R).abs();
    }
    let centre = side.left().map(|share| share / side.curvature);
    (distance(u, centre) - offset_radius(side.curvature, s, R).abs()).abs()
}

/// How far the point `u` lies from the corner along an element's offset, counted `forwards` (1) or backwards (−1): mm for a
/// line, radians for an arc.
fn trim(side: &End, u: Point, s: f64, R: f64, forwards: f64) -> f64 {
    if side.curvature == 0.0 {
        return forwards * dot(u, side.along);
    }
    if offset_radius(side.curvature, s, R) <= ROUNDING {
        return 0.0;
    }
    let out = side.left().map(|share| -share / side.curvature);
    let there = plus(u, out, 1.0);
    forwards * sign(side.curvature) * trig::atan2(cross(out, there), dot(out, there))
}

fn sign(value: f64) -> f64 {
    if value < 0.0 { -1.0 } else { 1.0 }
}

/// The radius of an arc's offset; negative where the nose is larger than the arc.
pub(super) fn offset_radius(curvature: f64, s: f64, R: f64) -> f64 {
    1.0 / curvature.abs() - s * R * sign(curvature)
}
