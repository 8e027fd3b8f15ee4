//! What stays of a channel in which a tool does not fit as far as the hub.
//!
//! # Derivation
//! The share is that of the turned surface between two blades, without the splitter, that nothing reaches. Passes reach what lies in
//! the tool at one of their poses. Of a tool without passes it is told what its upright lanes would reach: from the station q_f on every
//! place whose distance from the axis is no more than a, the axis standing as near to it, between ψ_r and ψ_o, as may be. Along the
//! faces the tool leans, and reaches somewhat more.

use nalgebra::Vector3;

use crate::kinds::impeller::clear::contact::Contacts;
use crate::kinds::impeller::clear::poses::Poses;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::part::{HUB, Part, RIM};
use crate::number::trig::hypot;

/// Places along and across the channel: what a look may be off goes with both, and stays below the thousandth that is told.
const ALONG: u16 = 300;
const ACROSS: u16 = 100;
/// The same for lanes that nobody runs, and their stations.
const COARSE: [u16; 2] = [60, 24];
const STATIONS: u8 = 120;
/// Stations behind the rim, as far as the tool still reaches into the channel from there.
const OUTSIDE: u8 = 24;

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

/// The share of the turned surface of a channel, looked at in so many places along and across, that is not reached.
fn surface(
    part: &Part,
    pitch: f64,
    v_s: Option<f64>,
    [along, across]: [u16; 2],
    mut is_reached: impl FnMut(&Vector3<f64>, f64) -> bool,
) -> f64 {
    let (torus, e) = (part.circle.torus, part.e);
    let (mut whole, mut left) = (0.0, 0.0);
    for row in 0..along {
        let v = HUB + (RIM - HUB) * (f64::from(row) + 0.5) / f64::from(along);
        let rho = torus.rho(v);
        let half = e / 2.0 / (rho * torus.r / torus.R);
        let (high, low) = (part.circle.u(v) - half, part.circle.u(v) - pitch + half);
        // The splitter's top, with its half-round nose, stays.
        let is_splitter = |psi: f64| {
            v_s.is_some_and(|v_s| {
                let beside = |v: f64| psi - part.circle.u(v) + pitch / 2.0;
                let before = [rho * beside(v_s), torus.r * (v - v_s)];
                if v < v_s { hypot(before[0], before[1]) <= e / 2.0 } else { beside(v).abs() <= half }
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
}
