//! The turned stock as a solid.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use crate::geometry::torus::Torus;
use crate::number::trig::hypot;

/// The turned stock: a cylinder of radius R from z = −L_b up to 0, from which the tube of the torus is taken.
#[derive(Clone, Copy, Debug)]
pub struct Stock {
    /// R and r.
    pub torus: Torus,
    /// L_b, its length.
    pub length: f64,
}

impl Stock {
    /// The distance of a point from the stock, from its radius about the axis and its height; negative inside.
    #[must_use]
    pub fn distance(&self, radius: f64, z: f64) -> f64 {
        let Torus { R, r } = self.torus;
        let (out, bottom) = (radius - R, -self.length.max(r));
        // Far from overflow, the plain root serves.
        let length = |x: f64, z: f64| (x * x + z * z).sqrt();
        let tube = length(out, z);
        let inside = z <= 0.0 && z >= bottom && out <= 0.0 && tube >= r;
        // The outline: a quarter of the tube, the upper face, the side, the lower face.
        let arc = if out <= 0.0 && z <= 0.0 { (tube - r).abs() } else { f64::INFINITY };
        let upper = length((out + r).max(0.0), z);
        let side = length(out, (z + r).max(0.0).max(bottom - z));
        let lower = length(out.max(0.0), z - bottom);
        let distance = arc.min(upper).min(side).min(lower);
        if inside { -distance } else { distance }
    }

    /// The distance of its farthest point from a pivot on the axis at the distance L below the origin.
    #[must_use]
    pub fn reach(&self, L: f64) -> f64 {
        hypot(L, self.torus.R).max(hypot(L - self.length, self.torus.R))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_distance_from_the_stock_is_that_from_its_outline() {
        let stock = Stock { torus: Torus { R: 25.0, r: 15.0 }, length: 40.0 };
        for (radius, z, distance) in [
            (0.0, 5.0, 5.0),
            (30.0, -20.0, 5.0),
            (25.0, 0.0, 15.0),
            (25.0, -10.0, 5.0),
            (13.0, 4.0, 5.0),
            (0.0, -1.0, -1.0),
            (24.0, -30.0, -1.0),
            (28.0, -44.0, 5.0),
            (28.0, -11.0, 5.0),
        ] {
            assert!((stock.distance(radius, z) - distance).abs() < 1e-12, "{radius} {z}");
        }
    }
}
