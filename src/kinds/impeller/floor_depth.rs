//! How much deeper than a_p the passes cut beside the blade.
//!
//! # Derivation
//! The floor is a_p below the torus: hollow, of the radius r_f = r + a_p across a meridian. The flat end of a tool that stands
//! w beside the mean line, in the mean line's tangent plane, reaches below it: with α the angle at which the mean line cuts
//! the parallels, its farthest point lies a + w·cos α to the side in the meridian plane, so that it is
//!
//! > √(r_f² + (a + w·cos α)²) − r_f
//!
//! too deep. That is the law for a tube that is straight along the parallel; the torus and the blocks add some hundredths. So
//! the rim is also followed block by block over all passes, inside the blank, with an upper bound.
//!
//! The distance T from the circle in the middle of the tube is bent by no less than −1/ρ along any line, ρ being the distance
//! from the axis of the part: over a box of the way and of the angle on the rim T exceeds the greatest of the corners by no
//! more than an eighth of V²/ρ + W, times the square of the sides.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::sweep::{Pace, Sweep};
use crate::kinds::impeller::track::Track;
use crate::limits::FLOOR_BOXES;
use crate::number::bisection::{Bounds, Cell, greatest};
use crate::number::trig::{hypot, sin_cos};

/// How close the bound is to what is found, mm.
const CLOSE: f64 = 0.0002;

/// How much too deep the passes are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deepest {
    /// It is not more, mm below the floor.
    pub most: f64,
    /// It is this at least.
    pub found: f64,
    /// The pass.
    pub track: Track,
    /// The point index along it.
    pub x: f64,
}

/// The law: √(r_f² + (a + w·cos α)²) − r_f, mm.
#[must_use]
pub fn law(Torus { R, r }: Torus, a_p: f64, e: f64, d_t: f64) -> f64 {
    let (r_f, cos_alpha) = (r + a_p, ((R - r) * (R + r)).sqrt() / R);
    hypot(r_f, d_t / 2.0 + (e + d_t) / 2.0 * cos_alpha) - r_f
}

/// The deepest point of the passes below the floor.
#[must_use]
pub fn deepest(Torus { R, r }: Torus, a_p: f64, d_t: f64, sweeps: &[Sweep]) -> Option<Deepest> {
    let (a, r_f) = (d_t / 2.0, r + a_p);
    let stretches: Vec<_> =
        sweeps.iter().flat_map(|sweep| sweep.stretches.iter().map(|stretch| (sweep.track, stretch))).collect();
    let paces: Vec<Pace> = stretches.iter().map(|(_, stretch)| stretch.pace(0.0)).collect();
    let cells = (0..stretches.len()).map(|sheet| Cell { sheet, s: [0.0, 1.0], t: [0.0, TAU] });
    let found = greatest(cells, CLOSE, FLOOR_BOXES, |cell| {
        let (_, stretch) = stretches[cell.sheet];
        let pace = paces[cell.sheet];
        let (speed, acceleration) = (pace.speed + pace.turn * a, pace.acceleration + pace.turn * pace.turn * a);
        // Distance from the axis of the part, height, depth below the floor.
        let rim = |s: f64, angle: f64| {
            let (tip, _) = stretch.tool(s);
            let [first, second] = stretch.across(s);
            let (sin, cos) = sin_cos(angle);
            let point = tip + (first * cos + second * sin) * a;
            let rho = (point.x * point.x + point.y * point.y).sqrt();
            (rho, point.z, ((rho - R) * (rho - R) + point.z * point.z).sqrt() - r_f)
        };
        let ([s_0, s_1], [low, high]) = (cell.s, cell.t);
        let (along, around) = (s_1 - s_0, high - low);
        let ways = [speed * along / 2.0, a * around / 2.0];
        let (way, first) = (ways[0] + ways[1], ways[0] > ways[1]);
        let (rho, z, depth) = rim((s_0 + s_1) / 2.0, (low + high) / 2.0);
        // Outside the blank there is nothing to cut.
        if z - way > stretch.slack || rho - way > R + stretch.slack {
            return Bounds { upper: f64::NEG_INFINITY, middle: f64::NEG_INFINITY, first };
        }
        let corners = [(s_0, low), (s_0, high), (s_1, low), (s_1, high)]
            .map(|(s, angle)| rim(s, angle).2)
            .into_iter()
            .fold(f64::NEG_INFINITY, f64::max);
        let least = rho - way;
        let by_bend = if least > 0.0 {
            let bent =
                |speed: f64, acceleration: f64, side: f64| (speed * speed / least + acceleration) * side * side / 8.0;
            corners + bent(speed, acceleration, along) + bent(a, a, around)
        } else {
            f64::INFINITY
        };
        let middle = if z <= 0.0 && rho <= R { depth } else { f64::NEG_INFINITY };
        Bounds { upper: by_bend.min(depth + way) + stretch.slack, middle, first }
    })?;
    let (track, stretch) = stretches[found.at.sheet];
    let [low, high] = found.at.s;
    let x = stretch.index((low + high) / 2.0);
    Some(Deepest { most: found.upper.max(0.0), found: found.lower.max(0.0), track, x })
}

#[cfg(test)]
mod tests {
    use super::law;
    use crate::geometry::torus::Torus;

    #[test]
    fn the_law_is_that_of_the_check_values() {
        let found = [(25.0, 15.0, 2.0, 2.0), (25.0, 17.0, 1.0, 4.0), (50.0, 30.0, 2.0, 3.0)]
            .map(|(R, r, e, a_p)| format!("{:.6}", law(Torus { R, r }, a_p, e, 6.0)));
        assert_eq!(found, ["1.095303", "0.725171", "0.577373"]);
    }
}
