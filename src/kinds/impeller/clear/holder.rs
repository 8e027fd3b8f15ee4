//! Shank and holder against the blank.
//!
//! # Derivation
//! The axis of the tool is upright on the machine, and the blank is a body of revolution about the axis of C. So how far the
//! blank reaches above the tip hangs on B and Z alone: at B its highest point is the highest of three circles, of the radius
//! ρ about the axis at the height z,
//!
//! > ρ·|sin B| + (z + L)·cos B − L, of (R − r, 0), (R, −r) and (R, −L_b):
//!
//! what the tube leaves lies between the first two. Over a block, in which B and Z go straight, that is nowhere above a
//! straight line between its ends by more than M·ΔB²/8, M being the distance of the farthest point from the pivot. A stage
//! that begins higher above the tip is clear, whatever its radius: run-outs, where the tool has sunk or leans far, count as
//! well. For one that begins lower the distance is searched between bounds, block by block, as that of a tool
//! ([`outside`](crate::kinds::impeller::outside)). Links go up and come down with B at rest, and turn where nothing reaches.
//! Clamps, chuck and table are not in the blank.
//!
//! # Units
//! Millimetres and radians.

use rayon::prelude::*;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::outside::{Outside, WORK};
use crate::kinds::impeller::solids::Stock;
use crate::limits::HOLDER_CLEARANCE;
use crate::number::grid::HALF;
use crate::number::trig::sin_cos;

/// A stage of shank or holder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// R_k, its radius.
    pub radius: f64,
    /// l_k, how far above the tip it begins.
    pub from: f64,
}

/// The turned blank on the machine.
#[derive(Clone, Copy, Debug)]
pub struct Blank {
    /// What of it there is before it is milled.
    pub stock: Stock,
    /// L, the pivot length.
    pub L: f64,
}

impl Blank {
    /// How far above the tip the blank reaches at a position.
    fn above(&self, stand: &Stand) -> f64 {
        let (sin, cos) = sin_cos(stand.B);
        let Torus { R, r } = self.stock.torus;
        let rings = [(R - r, 0.0), (R, -r), (R, -self.stock.length.max(r))];
        let highest = rings.map(|(rho, z)| rho * sin.abs() + (z + self.L) * cos - self.L);
        highest.into_iter().fold(f64::MIN, f64::max) - stand.at.z
    }

    /// The same over a block, nowhere less.
    fn above_block(&self, [from, to]: [&Stand; 2]) -> f64 {
        let (turn, M) = (to.B - from.B, self.stock.reach(self.L));
        self.above(from).max(self.above(to)) + M * turn * turn / 8.0 + self.rounding()
    }

    /// How far rounding positions to 0.001 mm and degrees moves a point of the blank, at most: by half of that along each of three
    /// axes, and by B and C.
    fn rounding(&self) -> f64 {
        HALF * 3.0_f64.sqrt() + 2.0 * HALF.to_radians() * self.stock.reach(self.L)
    }

    /// How far above the tip of its tool the blank reaches at most while passes are run: a holder of any radius that begins
    /// there is clear.
    #[must_use]
    pub fn highest<'a>(&self, passes: impl Iterator<Item = &'a [Stand]>) -> f64 {
        let of =
            |points: &[Stand]| points.windows(2).map(|pair| self.above_block([&pair[0], &pair[1]])).fold(0.0, f64::max);
        passes.map(of).fold(0.0, f64::max)
    }

    /// How far a stage stays clear of the blank at least while passes are run; −∞ for one of any radius that begins too low.
    #[must_use]
    pub fn clearance<'a>(&self, stage: Stage, passes: impl Iterator<Item = &'a [Stand]>) -> f64 {
        let Stage { radius, from } = stage;
        let outside =
            Outside { stock: self.stock, L: self.L, radius, reach: 2.0 * self.stock.torus.R + self.stock.length };
        let raised = |stand: &Stand| {
            let mut stand = *stand;
            stand.at.z += from;
            stand
        };
        let of_block = |pair: &[Stand]| {
            let free = from - self.above_block([&pair[0], &pair[1]]);
            // Beside a narrow stage the blank may be farther off than below it.
            if free >= HOLDER_CLEARANCE || (free >= 0.0 && !radius.is_finite()) {
                return free;
            }
            if !radius.is_finite() {
                return f64::MIN;
            }
            // By so much more it would be clear: it is in the blank by no more.
            (outside.along(&raised(&pair[0]), &raised(&pair[1]), WORK).lower - self.rounding()).max(free)
        };
        let blocks: Vec<&[Stand]> = passes.flat_map(|points| points.windows(2)).collect();
        let least = blocks.into_par_iter().map(of_block).reduce(|| f64::INFINITY, f64::min);
        if least == f64::MIN { f64::NEG_INFINITY } else { least }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use nalgebra::Vector3;

    use super::*;
    use crate::machine::rotary::TiltingTable;
    use crate::number::trig::hypot;

    const BLANK: Blank = Blank { stock: Stock { torus: Torus { R: 25.0, r: 15.0 }, length: 40.0 }, L: 242.9 };

    fn stand(x: f64, y: f64, z: f64, B: f64) -> Stand {
        Stand { at: Vector3::new(x, y, z), B, C: 0.7 }
    }

    /// Points of the blank's outline turned about its axis, seen from a position: how far above the tip, and how far from the axis.
    fn seen(at: &Stand) -> Vec<[f64; 2]> {
        let Torus { R, r } = BLANK.stock.torus;
        let arc = (0..=60).map(|step| {
            let (sin, cos) = sin_cos(FRAC_PI_2 * f64::from(step) / 60.0);
            (R - r * cos, -r * sin)
        });
        let side = (0..=60).map(|step| (R, -r - (BLANK.stock.length - r) * f64::from(step) / 60.0));
        let [tip, along] = TiltingTable { L: BLANK.L }.tool(&at.at, at.B, at.C);
        let around = |(rho, z): (f64, f64)| {
            (0..720).map(move |step| {
                let (sin, cos) = sin_cos(f64::from(step).to_radians() / 2.0);
                let from_tip = Vector3::new(rho * cos, rho * sin, z) - tip;
                let up = from_tip.dot(&along);
                [up, (from_tip - along * up).norm()]
            })
        };
        arc.chain(side).flat_map(around).collect()
    }

    #[test]
    fn a_stage_above_the_highest_place_of_the_blank_is_clear_whatever_its_radius() {
        for at in [stand(10.0, 3.0, -17.0, 0.0), stand(-200.0, -30.0, -220.0, 1.2), stand(-245.0, -38.0, -243.5, 1.59)]
        {
            let highest = seen(&at).into_iter().map(|[up, _]| up).fold(f64::MIN, f64::max);
            let bound = BLANK.highest(std::iter::once([at, at].as_slice()));
            assert!(bound >= highest.max(0.0) && bound < highest.max(0.0) + 0.02, "{at:?} {bound} {highest}");
            let wide = Stage { radius: f64::INFINITY, from: bound };
            assert!(BLANK.clearance(wide, std::iter::once([at, at].as_slice())) >= 0.0);
            let low = Stage { from: bound - 1.0, ..wide };
            assert_eq!(BLANK.clearance(low, std::iter::once([at, at].as_slice())), f64::NEG_INFINITY);
        }
    }

    #[test]
    fn over_a_block_the_bound_holds_between_its_ends() {
        let ends = [stand(-200.0, -30.0, -220.0, 1.0), stand(-190.0, -28.0, -214.0, 1.25)];
        let bound = BLANK.highest(std::iter::once(ends.as_slice()));
        for part in 0..=20 {
            let at = ends[0].towards(&ends[1], f64::from(part) / 20.0);
            assert!(seen(&at).into_iter().all(|[up, _]| up <= bound), "{part}");
        }
    }

    #[test]
    fn a_narrower_stage_may_begin_lower_as_far_as_no_point_of_the_blank_is_in_it() {
        // In the tube, leaning, and in a run-out of a flank far from the tube's middle.
        for at in [stand(-160.0, 0.0, -180.0, 0.9), stand(-232.0, -38.0, -238.0, 1.55)] {
            for radius in [4.0, 10.0, 25.0] {
                for from in [6.0, 12.0, 18.0, 26.0] {
                    let found = BLANK.clearance(Stage { radius, from }, std::iter::once([at, at].as_slice()));
                    // From the stage a point is as far as it is below its face and beside its side.
                    let least = seen(&at)
                        .into_iter()
                        .map(|[up, beside]| {
                            let (below, out) = (from - up, beside - radius);
                            if below <= 0.0 && out <= 0.0 {
                                below.max(out)
                            } else {
                                hypot(below.max(0.0), out.max(0.0))
                            }
                        })
                        .fold(f64::INFINITY, f64::min);
                    // How deep a place is in the stage is measured otherwise.
                    let holds = if least < 0.0 { found < 0.0 } else { found <= least + 1e-6 };
                    assert!(holds && (found >= 0.0 || least < 0.1), "{at:?} {radius} {from}: {found} {least}");
                }
            }
        }
    }
}
