//! The turned stock as a solid.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::number::trig::hypot;

/// A convex piece of the stock: a cylinder about the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Its radius, mm.
    pub radius: f64,
    /// Its lower and upper end.
    pub z: [f64; 2],
}

impl Cylinder {
    /// The distance of a point, negative inside, and a direction n with |n| ≤ 1 for which that of every other point q is no
    /// less than the distance here and n·(q − point): the signed distance from a convex body is convex.
    #[inline]
    #[must_use]
    pub fn distance(&self, point: &Vector3<f64>) -> (f64, Vector3<f64>) {
        let rho = (point.x * point.x + point.y * point.y).sqrt();
        let (below, above) = (self.z[0] - point.z, point.z - self.z[1]);
        let (up, sign) = if above >= below { (above, 1.0) } else { (below, -1.0) };
        let out = rho - self.radius;
        let distance = if out > 0.0 && up > 0.0 { (out * out + up * up).sqrt() } else { out.max(up) };
        let [outwards, upwards] = if out > 0.0 && up > 0.0 {
            [out / distance, sign * up / distance]
        } else if out >= up {
            [1.0, 0.0]
        } else {
            [0.0, sign]
        };
        let radial = if rho > 0.0 { outwards / rho } else { 0.0 };
        (distance, Vector3::new(point.x * radial, point.y * radial, upwards))
    }
}

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

    /// The cylinders inside and below the tube. With what the tube leaves between them, all within R of the axis, R − r from
    /// it, below 0 and above −r, they are the whole stock.
    #[must_use]
    pub fn cylinders(&self) -> [Cylinder; 2] {
        let Torus { R, r } = self.torus;
        let bottom = -self.length.max(r);
        [Cylinder { radius: R - r, z: [bottom, 0.0] }, Cylinder { radius: R, z: [bottom, -r] }]
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

    #[test]
    fn outside_the_tube_the_distance_is_that_from_the_nearer_cylinder() {
        let stock = Stock { torus: Torus { R: 25.0, r: 15.0 }, length: 40.0 };
        for (radius, z) in [(0.0, 5.0), (30.0, -20.0), (12.0, 3.0), (27.0, -9.0), (24.0, -44.0), (33.0, -50.0)] {
            let point = Vector3::new(0.6 * radius, -0.8 * radius, z);
            let nearer = stock.cylinders().map(|piece| piece.distance(&point).0);
            assert!((nearer[0].min(nearer[1]) - stock.distance(radius, z)).abs() < 1e-12, "{radius} {z}");
        }
    }

    #[test]
    fn a_cylinder_supports_its_distance_from_below() {
        let piece = Cylinder { radius: 10.0, z: [-40.0, 0.0] };
        let points: Vec<Vector3<f64>> = (0..9_u32)
            .flat_map(|x| (0..9_u32).map(move |z| (f64::from(x), f64::from(z))))
            .map(|(x, z)| Vector3::new(4.0 * x - 16.0, 2.0 * z - x, 8.0 * z - 50.0))
            .collect();
        for one in &points {
            let (distance, normal) = piece.distance(one);
            assert!(normal.norm() <= 1.0 + 1e-15);
            for other in &points {
                let least = distance + normal.dot(&(other - one));
                assert!(piece.distance(other).0 >= least - 1e-12, "{one} {other}");
            }
        }
    }
}
