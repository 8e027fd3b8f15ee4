//! The floor of a channel, and the feet of what stands on it.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::kinds::impeller::clear::body::{Body, turn};
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::trig::{atan2, hypot};

/// Rulings by which a wall's foot is known.
const FEET: u16 = 200;
/// What the arithmetic may lose, mm.
pub(super) const ARITHMETIC: f64 = 1e-9;

/// The floor of a channel, and the feet of what stands on it.
pub(super) struct Floor {
    /// The feet of the two walls as points, and how far two of them that follow each other are apart at most.
    walls: [(Vec<Vector3<f64>>, f64); 2],
    /// v and ψ of the two blades' feet.
    pub(super) sides: [Vec<[f64; 2]>; 2],
    /// The splitter, where there is one.
    pub(super) splitter: Option<Body>,
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

/// The points about the middle of a foot whose v goes on from each to the next: far out on the straight ends of a thick blade it
/// turns back.
fn onwards(foot: &[[f64; 2]]) -> std::ops::Range<usize> {
    let middle = foot.len() / 2;
    let on = |at: usize| foot[at + 1][0] > foot[at][0];
    let first = (0..middle).rev().find(|&at| !on(at)).map_or(0, |at| at + 1);
    let last = (middle..foot.len().saturating_sub(1)).find(|&at| !on(at)).unwrap_or(foot.len().saturating_sub(1));
    first..(last + 1).min(foot.len())
}

/// ψ of a foot at v, radians, straight between its points; 0 for a foot of fewer than two points.
pub(super) fn psi_at(foot: &[[f64; 2]], v: f64) -> f64 {
    let after = foot.partition_point(|point| point[0] < v).clamp(1, foot.len().max(2) - 1);
    match (foot.get(after - 1), foot.get(after)) {
        (Some([v_0, psi_0]), Some([v_1, psi_1])) => psi_0 + (psi_1 - psi_0) * ((v - v_0) / (v_1 - v_0)),
        _ => 0.0,
    }
}

impl Floor {
    /// Of a channel of the pitch, with tools of the radius a and a splitter from v_s on.
    pub(super) fn new(part: &Part, pitch: f64, a: f64, v_s: Option<f64>) -> Self {
        let turns = [0.0, -pitch];
        let walls = [0, 1].map(|side: usize| foot(part, Face::ALL[side], turns[side]));
        let sides = [0, 1].map(|side: usize| chart(part, &walls[side], turns[side]));
        let stretches = sides.each_ref().map(|side| onwards(side));
        let walls = [0, 1].map(|side: usize| walls[side][stretches[side].clone()].to_vec());
        let sides = [0, 1].map(|side: usize| sides[side][stretches[side].clone()].to_vec());
        let walls = walls.map(|feet| {
            let apart = feet.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(ARITHMETIC, f64::max) + ARITHMETIC;
            (feet, apart)
        });
        Self { walls, sides, splitter: v_s.map(|v_s| Body::new(part, v_s, -pitch / 2.0, a)) }
    }

    /// True where a point of the floor is no nearer than asked to what stands on it.
    pub(super) fn is_free(&self, point: &Vector3<f64>, asked: f64) -> bool {
        self.walls.iter().all(|(feet, apart)| clear_of(feet, *apart, point, asked))
            && self.splitter.as_ref().is_none_or(|body| body.keeps_point(point, asked))
    }
}

/// True where a point is no nearer than asked to a line of straight pieces, given by their ends, none of which is longer than told:
/// what is far from one end is far from the next ones as well.
fn clear_of(row: &[Vector3<f64>], apart: f64, point: &Vector3<f64>, asked: f64) -> bool {
    let mut next = 0;
    while let Some(one) = row.get(next) {
        let spare = (point - one).norm() - asked;
        if spare < 0.0 {
            return false;
        }
        // The pieces on both sides of an end that is nearer than their length may come nearer than it does.
        if spare < apart {
            let ends = [next.checked_sub(1), Some(next + 1)];
            let beside = ends.into_iter().flatten().filter_map(|other| row.get(other));
            if beside.map(|other| from_piece(point, [one, other])).any(|off| off < asked) {
                return false;
            }
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count, not negative")]
        let over = (spare / apart).min(1e6) as usize;
        next += over.max(1);
    }
    true
}

/// How far a point is from a straight piece.
fn from_piece(point: &Vector3<f64>, [one, other]: [&Vector3<f64>; 2]) -> f64 {
    let (along, from) = (other - one, point - one);
    let square = along.norm_squared();
    let part = if square > 0.0 { (from.dot(&along) / square).clamp(0.0, 1.0) } else { 0.0 };
    (from - along * part).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_as_far_as_its_nearest_point_however_far_apart_its_ends_are() {
        for (count, apart) in [(100_u8, 0.1), (5, 2.5)] {
            let row: Vec<Vector3<f64>> = (0..count).map(|k| Vector3::new(f64::from(k) * apart, 0.0, 0.0)).collect();
            let length = f64::from(count - 1) * apart;
            for k in 0..50_u8 {
                let point = Vector3::new(f64::from(k) * 0.31 - 2.0, 0.4, 0.1);
                let beyond = (point.x - point.x.clamp(0.0, length)).abs();
                let nearest = Vector3::new(beyond, point.y, point.z).norm();
                for asked in [0.3, 0.45, 1.0, 3.0] {
                    assert_eq!(clear_of(&row, apart + ARITHMETIC, &point, asked), nearest >= asked, "{k} {asked}");
                }
            }
        }
    }
}
