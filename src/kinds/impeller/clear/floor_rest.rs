//! What the floor lanes leave on the floor, some way off from the walls.
//!
//! # Derivation
//! At v a lane touches the floor from the stations v ± θ, in its ψ there: that is where nothing is left. Beyond the
//! outermost of these places, and half-way between two of them, it is the most, by the laws of the ridges. Out of hub
//! and rim the end that still reaches into the blank touches it, from a run-out of (a − r_c) − (r_f − r_c)·sin|v − v_end|.
//! The flank passes take some of that again, so that this is an upper bound. Farther from all lanes than the tool reaches,
//! the whole depth stays.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::FRAC_PI_2;

use crate::kinds::impeller::clear::contact::{Contacts, slope};
use crate::kinds::impeller::clear::scallop::Ridge;
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::number::trig::{asin, atan2, hypot, sin};

/// Stations of the floor that are looked at.
const LOOKS: u8 = 64;
/// Rulings by which a wall's foot is known.
const FEET: u16 = 160;

/// What is left on the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorRest {
    /// Farther from the walls than this, mm.
    pub beside: f64,
    /// It is no more, mm.
    pub most: f64,
    /// v where it is.
    pub v: f64,
}

/// The foot of a face of blade 0 on the floor: ψ as a function of v.
fn foot(part: &Part, face: Face) -> impl Fn(f64) -> f64 {
    let (R, beyond) = (part.circle.torus.R, (part.e + part.a_p) / part.circle.torus.r);
    let points: Vec<[f64; 2]> = (0..=FEET)
        .map(|foot| {
            let v = HUB - beyond + (RIM - HUB + 2.0 * beyond) * f64::from(foot) / f64::from(FEET);
            let ruling = part.ruling(face, v);
            let point = ruling.at(part.floor(&ruling, part.top(v)));
            let turn = |angle: f64| if angle < 0.0 { angle + std::f64::consts::TAU } else { angle };
            [turn(atan2(point.z, hypot(point.x, point.y) - R)), turn(atan2(point.y, point.x))]
        })
        .collect();
    move |v| {
        let after = points.partition_point(|point| point[0] < v).clamp(1, points.len() - 1);
        let ([v_0, psi_0], [v_1, psi_1]) = (points[after - 1], points[after]);
        psi_0 + (psi_1 - psi_0) * ((v - v_0) / (v_1 - v_0))
    }
}

/// The station from which a tool touches the floor θ hubwards (negative) or rimwards of it, if it does.
fn touching(contacts: &Contacts, v: f64, spread: f64) -> f64 {
    let lane = &contacts.lane;
    let station = v + spread;
    let out = |from_end: f64| lane.tool.flat_radius() - (lane.r_f - lane.tool.r_c) * sin(from_end);
    if station < HUB {
        -out(v - HUB).max(0.0)
    } else if station > RIM {
        1.0 + out(RIM - v).max(0.0)
    } else {
        (station - HUB) / FRAC_PI_2
    }
}

/// The rest of the lanes at the parts λ = j/K of a channel, farther from the walls than `beside`.
#[must_use]
pub fn floor_rest(part: &Part, contacts: &Contacts, K: u32, beside: f64) -> FloorRest {
    let (lane, torus) = (&contacts.lane, part.circle.torus);
    let [obverse, reverse] = Face::ALL.map(|face| foot(part, face));
    let spread = lane.spread();
    let mut rest = FloorRest { beside, most: 0.0, v: HUB };
    for look in 0..=LOOKS {
        let v = HUB + (RIM - HUB) * f64::from(look) / f64::from(LOOKS);
        let q = (v - HUB) / FRAC_PI_2;
        let mut touched: Vec<f64> = [-spread, spread]
            .into_iter()
            .flat_map(|spread| {
                let q = touching(contacts, v, spread);
                (0..=K).map(move |j| contacts.psi(f64::from(j) / f64::from(K), q))
            })
            .collect();
        touched.sort_by(f64::total_cmp);
        let rho_f = torus.R + lane.r_f * crate::number::trig::cos(v);
        let tan = slope(contacts, 0.5, q);
        let sin_l = tan / (1.0 + tan * tan).sqrt();
        let ridge = Ridge::at(lane, v, sin_l);
        // A wall crosses the parallel as the lanes do.
        let off = beside / (rho_f * sin_l);
        let (low, high) = (reverse(v) - contacts.pitch + off, obverse(v) - off);
        if low >= high {
            continue;
        }
        let reach = asin((lane.tool.a() / rho_f).min(1.0));
        let middles = touched.windows(2).map(|pair| f64::midpoint(pair[0], pair[1]));
        for psi in middles.chain([low, high]).filter(|psi| (low..=high).contains(psi)) {
            let after = touched.partition_point(|&touch| touch < psi);
            let beyond = [after.checked_sub(1), Some(after)]
                .into_iter()
                .filter_map(|at| Some((touched.get(at?)? - psi).abs()))
                .fold(f64::INFINITY, f64::min);
            let left = if beyond > reach { part.a_p } else { ridge.height(2.0 * beyond).min(part.a_p) };
            if left > rest.most {
                rest = FloorRest { most: left, v, ..rest };
            }
        }
    }
    rest
}
