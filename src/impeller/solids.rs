//! The solids that may not meet: the tool as a cylinder with a flat end, the flanks of blades, the turned stock.
//!
//! # Units
//! Millimetres and radians, in the part frame.

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::impeller::blade::Blade;
use crate::number::root::golden;
use crate::number::trig::{hypot, sin_cos};

/// Steps of a search by golden section: the interval shrinks to 1/800.
const GOLDEN_STEPS: u32 = 14;

/// A tool in the part: tip, direction from the tip along the axis, radius. It reaches on for ever.
#[derive(Clone, Copy, Debug)]
pub struct Tool {
    /// The middle of its flat end.
    pub tip: Vector3<f64>,
    /// The unit vector along its axis.
    pub axis: Vector3<f64>,
    /// Half its diameter.
    pub radius: f64,
}

impl Tool {
    /// The distance of a point from the tool; negative inside, where it is the shortest way out.
    #[must_use]
    pub fn distance(&self, point: &Vector3<f64>) -> f64 {
        let from = point - self.tip;
        let up = from.dot(&self.axis);
        let out = (from - self.axis * up).norm() - self.radius;
        if out <= 0.0 {
            out.max(-up)
        } else if up >= 0.0 {
            out
        } else {
            hypot(out, up)
        }
    }

    /// The tool turned about the axis of the part.
    #[must_use]
    pub fn turned(&self, angle: f64) -> Self {
        let (sin, cos) = sin_cos(angle);
        let turn = |a: &Vector3<f64>| Vector3::new(a.x * cos - a.y * sin, a.x * sin + a.y * cos, a.z);
        Self { tip: turn(&self.tip), axis: turn(&self.axis), radius: self.radius }
    }
}

/// Intervals of a flank: the chord between two of its lines is within R/25 000 of the curve.
const LINES: usize = 96;

/// Both flanks of a blade of thickness e: lines P ± e/2·b + h·N with −a_p ≤ h ≤ 0, joined straight.
#[derive(Clone, Debug)]
pub struct Flanks {
    /// P ± e/2·b and N, evenly along the blade.
    sides: [Vec<(Vector3<f64>, Vector3<f64>)>; 2],
    a_p: f64,
    /// The greatest distance between neighbouring lines.
    spacing: f64,
    /// Point indices from one line to the next.
    step: f64,
}

/// A least distance and the point index of the flank where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The distance; negative where the tool is in the flank.
    pub distance: f64,
    /// The point index along the flank.
    pub x: f64,
}

impl Flanks {
    /// The flanks of a blade. The same lines are the flanks of a splitter where it stands in full.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn new(blade: &Blade, n: usize, e: f64, a_p: f64) -> Self {
        let coarse = Blade::new(blade.circle.torus, LINES, 0.0, crate::machine::rotary::Rotary { L: 0.0 });
        let lines = |side: f64| -> Vec<_> {
            (0..coarse.points()).map(|i| (coarse.P[i] + coarse.b[i] * (side * e / 2.0), coarse.N[i])).collect()
        };
        let sides = [lines(1.0), lines(-1.0)];
        let spacing = sides
            .iter()
            .flat_map(|side| side.windows(2))
            .flat_map(|pair| [0.0, a_p].map(|h| ((pair[1].0 - pair[1].1 * h) - (pair[0].0 - pair[0].1 * h)).norm()))
            .fold(0.0, f64::max);
        Self { sides, a_p, spacing, step: n as f64 / LINES as f64 }
    }

    /// The least distance of a tool from the flanks from the point index `from` on, where it is below `known`.
    ///
    /// The distance from a convex body is convex along a line, so that a golden section finds the least of each line; it
    /// changes by no more than the way between two lines, so that lines too far off are passed over.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a small count")]
    pub fn nearest(&self, tool: &Tool, from: f64, known: f64) -> Option<Nearest> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index of the flank")]
        let first = (from / self.step).ceil().max(0.0) as usize;
        // Between two lines the distance falls by less than the way between them.
        let mut best = known + self.spacing;
        let mut nearest = None;
        for side in &self.sides {
            let mut line = first;
            while let Some((foot, N)) = side.get(line) {
                let least = tool.distance(&(foot - N * (self.a_p / 2.0))) - self.a_p / 2.0;
                if least >= best {
                    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
                    let clear = ((least - best) / self.spacing).min(LINES as f64) as usize;
                    line += clear + 1;
                    continue;
                }
                let here = self.line(tool, *foot, *N);
                if here < best {
                    (best, nearest) = (here, Some((side, line)));
                }
                line += 1;
            }
        }
        let (side, line) = nearest?;
        let (distance, at) = self.refine(tool, side, line, first);
        (distance < known).then_some(Nearest { distance, x: at * self.step })
    }

    fn line(&self, tool: &Tool, foot: Vector3<f64>, N: Vector3<f64>) -> f64 {
        golden([-self.a_p, 0.0], GOLDEN_STEPS, |h| tool.distance(&(foot + N * h))).0
    }

    /// The least about a line, between its neighbours.
    #[expect(clippy::cast_precision_loss, reason = "an index of the flank")]
    fn refine(&self, tool: &Tool, side: &[(Vector3<f64>, Vector3<f64>)], line: usize, first: usize) -> (f64, f64) {
        let (low, high) = (line.saturating_sub(1).max(first), (line + 1).min(side.len() - 1));
        let at = |x: f64| {
            let below = if x < line as f64 { low } else { line.min(high) };
            let above = (below + 1).min(side.len() - 1);
            let part = (x - below as f64).clamp(0.0, 1.0);
            let ((foot, N), (next_foot, next_N)) = (side[below], side[above]);
            self.line(tool, foot + (next_foot - foot) * part, N + (next_N - N) * part)
        };
        let (distance, x) = golden([low as f64, high as f64], GOLDEN_STEPS, at);
        let own = at(line as f64);
        if own <= distance { (own, line as f64) } else { (distance, x) }
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
    fn the_distance_from_a_tool_is_that_from_a_flat_cylinder() {
        let tool = Tool { tip: Vector3::new(1.0, 2.0, 3.0), axis: Vector3::z(), radius: 3.0 };
        for (point, distance) in [
            ([6.0, 2.0, 10.0], 2.0),
            ([1.0, 2.0, 1.0], 2.0),
            ([8.0, 2.0, 0.0], 5.0),
            ([1.0, 4.0, 10.0], -1.0),
            ([1.0, 2.0, 3.5], -0.5),
            ([4.0, 2.0, 3.0], 0.0),
        ] {
            assert!((tool.distance(&Vector3::from(point)) - distance).abs() < 1e-12, "{point:?}");
        }
        let turned = tool.turned(std::f64::consts::FRAC_PI_2);
        assert!((turned.tip - Vector3::new(-2.0, 1.0, 3.0)).norm() < 1e-12);
    }

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
    fn the_nearest_point_of_a_flank_is_that_of_a_dense_search() {
        let torus = Torus { R: 25.0, r: 15.0 };
        let blade = Blade::new(torus, 40, 0.0, crate::machine::rotary::Rotary { L: 242.9 });
        let flanks = Flanks::new(&blade, 40, 2.0, 2.0);
        let dense = Blade::new(torus, 1500, 0.0, crate::machine::rotary::Rotary { L: 242.9 });
        for (i, w) in [(0, 4.0), (20, 5.5), (33, -6.0)] {
            let tool = Tool { tip: blade.P[i] + blade.b[i] * w - blade.N[i] * 2.0, axis: blade.N[i], radius: 3.0 };
            for angle in [0.7, -1.1] {
                let tool = tool.turned(angle);
                let mut least = f64::INFINITY;
                for j in 0..dense.points() {
                    for side in [1.0, -1.0] {
                        for h in 0..=40 {
                            let h = f64::from(h) * -0.05;
                            least = least.min(tool.distance(&(dense.P[j] + dense.b[j] * side + dense.N[j] * h)));
                        }
                    }
                }
                let found = flanks.nearest(&tool, 0.0, f64::INFINITY).unwrap().distance;
                assert!((found - least).abs() < 0.005, "{i} {angle}: {found} against {least}");
            }
        }
    }
}
