//! What stays of a channel in which a tool does not fit as far as the hub.
//!
//! # Derivation
//! The share is that of the turned surface between two blades, without the splitter, that nothing reaches. Passes reach what lies in
//! the tool at one of their poses. Of a tool without passes it is told what its upright lanes would reach: from the station q_f on every
//! place whose distance from the axis is no more than a, the axis standing as near to it, between ψ_r and ψ_o, as may be. Along the
//! faces the tool leans, and reaches somewhat more.

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::kinds::impeller::clear::contact::Contacts;
use crate::kinds::impeller::clear::poses::Poses;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::trig::{atan2, hypot, sin_cos};

/// Places along and across the channel: what a look may be off goes with both, and stays below the thousandth that is told.
const ALONG: u16 = 300;
const ACROSS: u16 = 100;
/// The same for lanes that nobody runs, and their stations.
const COARSE: [u16; 2] = [60, 24];
const STATIONS: u8 = 120;
/// Stations behind the rim, as far as the tool still reaches into the channel from there.
const OUTSIDE: u8 = 24;
/// How near to the turned surface a ruling has come to it, mm.
const MET: f64 = 1e-6;

/// The share of a channel, `pitch` wide, with a splitter from v_s on where there is one, that no pose of its tools comes to within
/// `over`, mm.
#[must_use]
pub fn left(part: &Part, pitch: f64, v_s: Option<f64>, cuts: &[(Tool, Poses)], over: f64) -> f64 {
    let mut near = vec![0; cuts.len()];
    surface(part, pitch, v_s, [ALONG, ACROSS], |point, _| {
        cuts.iter().zip(&mut near).any(|((tool, poses), near)| {
            let found = poses.holding(*tool, point, over, *near);
            *near = found.unwrap_or(*near);
            found.is_some()
        })
    })
}

/// The share of a channel that the upright lanes of a tool do not reach from the station q_f on; all of it without one.
#[must_use]
pub fn share(part: &Part, contacts: &Contacts, q_f: Option<f64>) -> f64 {
    let Some(q_f) = q_f else { return 1.0 };
    let lane = &contacts.lane;
    let a = lane.tool.a();
    // Between hub and rim q counts in parts of the channel, outside in mm.
    let inside = (0..=STATIONS).map(|station| q_f + (1.0 - q_f) * f64::from(station) / f64::from(STATIONS));
    let outside = (1..=OUTSIDE).map(|station| 1.0 + a * f64::from(station) / f64::from(OUTSIDE));
    let stations: Vec<(f64, [f64; 2])> = inside.chain(outside).map(|q| (q, contacts.at(q))).collect();
    surface(part, contacts.pitch, None, COARSE, |point, psi| {
        stations.iter().any(|&(q, [obverse, reverse])| {
            let axis = lane.axis(q, psi.clamp(reverse.min(obverse), obverse), 0.0);
            let from: Vector3<f64> = point - axis.foot;
            (from - axis.along * from.dot(&axis.along)).norm() <= a
        })
    })
}

/// Where a face comes out of the turned surface: v, and how far ψ is beyond u(v), from the hub to the rim.
///
/// Its rulings begin beside the mean line, e/2 along b, and the thicker the blade the more the tube bends away below that.
struct Edge(Vec<[f64; 2]>);

impl Edge {
    fn of(part: &Part, face: Face) -> Self {
        let surface = Part::with(part.circle.torus, part.e, 0.0);
        let stretches = surface.stretches(face);
        let from = stretches.first().map_or(HUB, |[from, _]| *from);
        let to = stretches.last().map_or(RIM, |[_, to]| *to);
        let place = |step: u16| {
            let v = from + (to - from) * f64::from(step) / f64::from(ALONG);
            let ruling = surface.ruling(face, v);
            let point = ruling.at(surface.floor(&ruling, surface.top(v)));
            // One of a blade as thick as the tube may never come to it.
            (surface.depth(&point).abs() < MET).then(|| {
                let out = part.circle.torus.R - hypot(point.x, point.y);
                let v = PI + atan2(-point.z, out);
                let (sin, cos) = sin_cos(part.circle.u(v.clamp(HUB, RIM)));
                [v, atan2(point.y * cos - point.x * sin, point.x * cos + point.y * sin)]
            })
        };
        Self((0..=ALONG).filter_map(place).collect())
    }

    /// How far beyond u(v) it is.
    fn at(&self, v: f64) -> Option<f64> {
        let behind = self.0.partition_point(|[at, _]| *at < v).clamp(1, self.0.len().checked_sub(1)?.max(1));
        let [[from, before], [to, after]] = [*self.0.get(behind - 1)?, *self.0.get(behind)?];
        let part = if to > from { ((v - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        Some(before + (after - before) * part)
    }
}

/// The share of the turned surface of a channel, looked at in so many places along and across, that is not reached.
fn surface(
    part: &Part,
    pitch: f64,
    v_s: Option<f64>,
    [along, across]: [u16; 2],
    mut is_reached: impl FnMut(&Vector3<f64>, f64) -> bool,
) -> f64 {
    let torus = part.circle.torus;
    let edges = Face::ALL.map(|face| Edge::of(part, face));
    let nose = v_s.map(|v_s| part.frame(v_s));
    let (mut whole, mut left) = (0.0, 0.0);
    for row in 0..along {
        let v = HUB + (RIM - HUB) * (f64::from(row) + 0.5) / f64::from(along);
        let (rho, u) = (torus.rho(v), part.circle.u(v));
        let [Some(obverse), Some(reverse)] = [&edges[0], &edges[1]].map(|edge| edge.at(v)) else { continue };
        let (high, low) = (u + obverse.min(reverse), u - pitch + obverse.max(reverse));
        // The splitter's top, with the half round of its nose, stays. Before the nose's middle it is a cylinder along N.
        let is_splitter = |psi: f64| {
            nose.as_ref().is_some_and(|(P, frame)| {
                let from = torus.point(psi + pitch / 2.0, v) - P;
                let (along, beside) = (from.dot(&frame.t), psi + pitch / 2.0 - u);
                if along < 0.0 {
                    hypot(along, from.dot(&frame.b)) <= part.e / 2.0
                } else {
                    (obverse.min(reverse)..=obverse.max(reverse)).contains(&beside)
                }
            })
        };
        for column in 0..across {
            let psi = low + (high - low) * (f64::from(column) + 0.5) / f64::from(across);
            if is_splitter(psi) {
                continue;
            }
            let area = rho * (high - low).max(0.0);
            whole += area;
            left += if is_reached(&torus.point(psi, v), psi) { 0.0 } else { area };
        }
    }
    if whole > 0.0 { left / whole } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::torus::Torus;
    use crate::kinds::impeller::clear::lane::OwnNormal;
    use crate::kinds::impeller::clear::tool::Tool;

    #[test]
    fn of_parts_that_are_alike_the_same_share_is_left() {
        let share_at = |scale: f64| {
            let torus = Torus { R: 25.0 * scale, r: 15.0 * scale };
            let part = Part::with(torus, 2.0 * scale, 2.0 * scale);
            let lane = OwnNormal::new(torus, Tool::flat(8.0 * scale), torus.r + part.a_p).expect("a lane");
            let contacts = Contacts::new(&part, 4, lane, 0.3 * scale);
            share(&part, &contacts, contacts.fits_from())
        };
        let one = share_at(1.0);
        assert!(one > 0.01 && one < 0.2, "{one}");
        for scale in [2.0, 8.0] {
            assert!((share_at(scale) - one).abs() < 0.005, "{scale} {} {one}", share_at(scale));
        }
    }

    /// The rulings of a face are those points that lie e/2 along b from the mean line, seen along t from the point.
    #[test]
    fn an_edge_lies_half_the_thickness_along_b_from_the_mean_line() {
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 6.0, 2.0);
        for face in Face::ALL {
            let edge = Edge::of(&part, face);
            for step in 1..20_u16 {
                let v = HUB + (RIM - HUB) * f64::from(step) / 20.0;
                let beyond = edge.at(v).expect("an edge");
                let point = part.circle.torus.point(part.circle.u(v) + beyond, v);
                // t points on along the mean line: the place of the point along it, by halving.
                let [mut from, mut to] = [HUB - 0.5, RIM + 0.5];
                for _ in 0..60 {
                    let middle = f64::midpoint(from, to);
                    let (P, frame) = part.frame(middle);
                    if (point - P).dot(&frame.t) > 0.0 { from = middle } else { to = middle }
                }
                let (P, frame) = part.frame(from);
                let beside = (point - P).dot(&frame.b) * face.side();
                assert!((beside - part.e / 2.0).abs() < 1e-3, "{face:?} {v}: {beside}");
            }
        }
    }
}
