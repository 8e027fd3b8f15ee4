//! What stays of a channel in which a tool does not fit as far as the hub.
//!
//! # Derivation
//! From the station q_f on the tool reaches every place whose distance from the axis is no more than a, the axis standing
//! as near to it, between ψ_r and ψ_o, as may be. The share is that of the turned surface between two blades that no
//! station reaches.

use nalgebra::Vector3;

use crate::kinds::impeller::clear::contact::Contacts;
use crate::kinds::impeller::part::{HUB, Part, RIM};

/// Places along and across the channel, and stations of the tool.
const ALONG: u8 = 60;
const ACROSS: u8 = 24;
const STATIONS: u8 = 120;
/// Stations behind the rim, as far as the tool still reaches into the channel from there.
const OUTSIDE: u8 = 24;

/// The share of a channel that the tool does not reach from the station q_f on; all of it without one.
#[must_use]
pub fn share(part: &Part, contacts: &Contacts, q_f: Option<f64>) -> f64 {
    let Some(q_f) = q_f else { return 1.0 };
    let (torus, lane) = (part.circle.torus, &contacts.lane);
    let a = lane.tool.a();
    // Between hub and rim q counts in parts of the channel, outside in mm.
    let inside = (0..=STATIONS).map(|station| q_f + (1.0 - q_f) * f64::from(station) / f64::from(STATIONS));
    let outside = (1..=OUTSIDE).map(|station| 1.0 + a * f64::from(station) / f64::from(OUTSIDE));
    let stations: Vec<(f64, [f64; 2])> = inside.chain(outside).map(|q| (q, contacts.at(q))).collect();
    let (mut whole, mut left) = (0.0, 0.0);
    for along in 0..ALONG {
        let v = HUB + (RIM - HUB) * (f64::from(along) + 0.5) / f64::from(ALONG);
        let rho = torus.rho(v);
        let half = part.e / 2.0 / (rho * torus.r / torus.R);
        let (high, low) = (part.circle.u(v) - half, part.circle.u(v) - contacts.pitch + half);
        for across in 0..ACROSS {
            let psi = low + (high - low) * (f64::from(across) + 0.5) / f64::from(ACROSS);
            let point = torus.point(psi, v);
            let area = rho * (high - low).max(0.0);
            let reached = stations.iter().any(|&(q, [obverse, reverse])| {
                let axis = lane.axis(q, psi.clamp(reverse.min(obverse), obverse), 0.0);
                let from: Vector3<f64> = point - axis.foot;
                (from - axis.along * from.dot(&axis.along)).norm() <= a
            });
            whole += area;
            left += if reached { 0.0 } else { area };
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
