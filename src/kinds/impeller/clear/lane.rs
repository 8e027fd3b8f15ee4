//! The own-normal tool: its axis goes through the circle K in the middle of the tube, in the meridian plane of that point.
//!
//! # Derivation
//! Let the axis pass through a point c of K in its meridian plane, at the angle v, the tip r_t below c. With
//! r_t = √((r_f − r_c)² − (a − r_c)²) + r_c the whole end of the tool lies in the ball of radius r_f = r + a_p about c and
//! touches it along a circle. That ball lies in the tube T ≤ r_f: the floor is nowhere deeper than a_p, whatever such pose
//! the tool takes. K turns into itself with C, so that of the machine's axes only B and Z, X with it, know where on the
//! meridian the tool stands, and C alone where about the axis:
//!
//! > B = 3π/2 − v, C = ψ − 2π, X = R·cos B − L·sin B, Y = 0, Z = R·sin B + L(cos B − 1) − r_t.
//!
//! # Stations
//! q says how far along the channel the tool stands: from 0 at the hub plane to 1 at the rim, evenly in v. Beyond, it has
//! run out by −q mm (hub: B = 90° stays, the tip goes towards −X, out of the hub plane) or by q − 1 mm (rim: B = 0 stays,
//! the tip goes towards +X). As long as its end still reaches into the blank the tip sinks with the floor.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::gap::over_tops;
use crate::kinds::impeller::nearest::Axis;
use crate::kinds::impeller::part::{HUB, RIM};
use crate::machine::rotary::TiltingTable;
use crate::number::trig::sin_cos;

/// v at a station, radians: [`HUB`] up to q = 0, [`RIM`] from q = 1 on.
#[must_use]
pub fn v_at(q: f64) -> f64 {
    HUB + q.clamp(0.0, 1.0) * FRAC_PI_2
}

/// How far out of the blank a station is, mm; 0 between hub and rim.
#[must_use]
pub fn out_at(q: f64) -> f64 {
    (-q).max(q - 1.0).max(0.0)
}

/// A tool that clears a tube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnNormal {
    /// The torus of the part: K is the circle of the radius R.
    pub torus: Torus,
    /// The end mill, no wider than the tube.
    pub tool: Tool,
    /// The radius of the tube that it may not leave: r plus the depth that it cuts.
    pub r_f: f64,
}

impl OwnNormal {
    /// The tool in the tube of radius r_f; `None` where it is wider than that.
    #[must_use]
    pub fn new(torus: Torus, tool: Tool, r_f: f64) -> Option<Self> {
        tool.below(r_f, 0.0).map(|_| Self { torus, tool, r_f })
    }

    /// r_t at a station, mm: how far below K the tip stands.
    #[must_use]
    pub fn below(&self, q: f64) -> f64 {
        self.tool.below(self.r_f, -out_at(q)).unwrap_or(self.r_f)
    }

    /// θ: a floor point at v is touched by the flat end from the stations v ± θ.
    #[must_use]
    pub fn spread(&self) -> f64 {
        crate::number::trig::asin((self.tool.flat_radius() / (self.r_f - self.tool.r_c)).min(1.0))
    }

    /// Where the machine's axes stand at a station, in the meridian plane ψ.
    #[must_use]
    pub fn stand(&self, machine: TiltingTable, q: f64, psi: f64) -> Stand {
        let (R, L) = (self.torus.R, machine.L);
        let B = RIM - v_at(q);
        let (sin, cos) = sin_cos(B);
        let out = if q < 0.0 { -out_at(q) } else { out_at(q) };
        let at = Vector3::new(R * cos - L * sin + out, 0.0, R * sin + L * (cos - 1.0) - self.below(q));
        Stand { at, B, C: psi - TAU }
    }

    /// The tool's axis at a station, in the part, from the tip as high as metal stands within a distance from it.
    #[must_use]
    pub fn axis(&self, q: f64, psi: f64, reach: f64) -> Axis {
        let ((sin_v, cos_v), (sin, cos)) = (sin_cos(v_at(q)), sin_cos(psi));
        let r = self.torus.r;
        // Out of the hub plane along the axis of the part, out of the rim away from it.
        let (up, away) = if q < 0.0 { (out_at(q), 0.0) } else { (0.0, out_at(q)) };
        let rho = self.torus.R + r * cos_v + away;
        Axis {
            foot: Vector3::new(rho * cos, rho * sin, r * sin_v + up),
            along: -Vector3::new(cos_v * cos, cos_v * sin, sin_v),
            range: [r - self.below(q), over_tops(r, reach).max(r - self.below(q))],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const L: f64 = 242.9;

    fn lane(R: f64, r: f64, a_p: f64, tool: Tool) -> OwnNormal {
        OwnNormal::new(Torus { R, r }, tool, r + a_p).unwrap()
    }

    #[test]
    fn machine_positions_are_those_of_the_check_values() {
        for (R, r, a_p, X, Z) in [
            (25.0, 15.0, 2.0, -154.078_568, -70.199_294),
            (25.0, 17.0, 4.0, -154.078_568, -74.250_703),
            (50.0, 30.0, 3.0, -136.400_898, -68.651_777),
        ] {
            let at = lane(R, r, a_p, Tool::flat(6.0)).stand(TiltingTable { L }, 0.5, 3.0).at;
            assert!((at.x - X).abs() < 5.1e-7 && at.y == 0.0 && (at.z - Z).abs() < 5.1e-7, "{at}");
        }
    }

    #[test]
    fn machine_positions_put_the_tip_where_the_axis_says() {
        let (machine, lane) = (TiltingTable { L }, lane(25.0, 15.0, 2.0, Tool { d: 6.0, r_c: 1.0 }));
        for q in [-8.0, -2.0, 0.0, 0.3, 1.0, 2.5, 9.0] {
            let (stand, axis) = (lane.stand(machine, q, 2.0), lane.axis(q, 2.0, 3.0));
            let tip = machine.to_part(&stand.at, stand.B, stand.C);
            assert!((tip - axis.foot - axis.along * axis.range[0]).norm() < 1e-11, "{q}");
            assert!((TiltingTable::direction_to_part(&Vector3::z(), stand.B, stand.C) - axis.along).norm() < 1e-12);
        }
    }

    #[test]
    fn no_point_of_the_end_is_below_the_floor_and_some_are_on_it() {
        for tool in [Tool::flat(6.0), Tool { d: 6.0, r_c: 1.0 }, Tool::ball(6.0)] {
            let lane = lane(25.0, 15.0, 2.0, tool);
            for q in [-0.9, -0.3, 0.0, 0.4, 1.0, 1.7] {
                // With its flat out of the blank it is as deep as it may be, and higher at the corner.
                let flat_inside = q >= -tool.flat_radius() && q <= 1.0 + tool.flat_radius();
                let axis = lane.axis(q, 1.3, 3.0);
                let tip = axis.foot + axis.along * axis.range[0];
                let side = Vector3::z().cross(&axis.along).try_normalize(1e-9).unwrap_or_else(Vector3::x);
                let other = axis.along.cross(&side);
                let mut deepest = f64::MIN;
                for turn in 0..720 {
                    let (sin, cos) = sin_cos(f64::from(turn).to_radians() / 2.0);
                    let out = side * cos + other * sin;
                    for step in 0..=20 {
                        let (sin, cos) = sin_cos(f64::from(step) * FRAC_PI_2 / 20.0);
                        let across = tool.flat_radius() + tool.r_c * sin;
                        let point = tip + out * across + axis.along * (tool.r_c * (1.0 - cos));
                        let rho = crate::number::trig::hypot(point.x, point.y);
                        if point.z <= 0.0 && rho <= 25.0 {
                            deepest = deepest.max(crate::number::trig::hypot(rho - 25.0, point.z) - 17.0);
                        }
                    }
                }
                assert!(deepest <= 1e-9 && (deepest > -0.01 || !flat_inside), "{tool:?} {q} {deepest}");
            }
        }
    }
}
