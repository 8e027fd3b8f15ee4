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

use nalgebra::Vector3;
use rustc_hash::FxHashMap;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::sweep::{Pace, Stretch, Sweep};
use crate::kinds::impeller::track::Track;
use crate::limits::FLOOR_BOXES;
use crate::number::bisection::{Bounds, Cell, greatest_above, kept, key};
use crate::number::trig::{hypot, sin_cos};

/// How close the bound of the plan's depth is to what is found, mm.
pub const CLOSE: f64 = 0.0002;

/// How much too deep the passes are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deepest<T = Track> {
    /// It is not more, mm below the floor.
    pub most: f64,
    /// The deepest place found, mm below the floor: the true one is no less.
    pub found: f64,
    /// The pass that goes deepest.
    pub track: T,
    /// The point index along it.
    pub x: f64,
}

/// The law: √(r_f² + (a + w·cos α)²) − r_f, mm.
#[must_use]
pub fn law(Torus { R, r }: Torus, a_p: f64, e: f64, d_t: f64) -> f64 {
    let (r_f, cos_alpha) = (r + a_p, ((R - r) * (R + r)).sqrt() / R);
    hypot(r_f, d_t / 2.0 + (e + d_t) / 2.0 * cos_alpha) - r_f
}

/// The deepest point of the passes below the floor, its bound as close to what is found as it is asked for. The bounds of
/// the sweeps hold up to the tool's corner radius above the tip.
///
/// # Derivation
/// A rounded end is what a ball of the radius r_c holds whose centre goes over the disc of the radius a − r_c that far
/// above the tip. No point of that ball is more than r_c farther from the circle than its centre; and where the centre has
/// left the blank by δ, no point that is still in it more than √(r_c² − δ²).
#[must_use]
pub fn deepest<T: Copy>(torus: Torus, a_p: f64, mill: Tool, sweeps: &[Sweep<T>], close: f64) -> Option<Deepest<T>> {
    deeper(torus, a_p, mill, sweeps, close, f64::NEG_INFINITY)
}

/// The middle of the disc at a tool's end, and two directions across.
type Disc = (Vector3<f64>, [Vector3<f64>; 2]);

/// The same where only what is deeper than known so far is worth knowing: where nothing is, the answer is not deeper.
fn deeper<T: Copy>(
    Torus { R, r }: Torus,
    a_p: f64,
    mill: Tool,
    sweeps: &[Sweep<T>],
    close: f64,
    known: f64,
) -> Option<Deepest<T>> {
    let (a, r_c, r_f) = (mill.flat_radius(), mill.r_c, r + a_p);
    let stretches: Vec<_> =
        sweeps.iter().flat_map(|sweep| sweep.stretches.iter().map(|stretch| (sweep.track, stretch))).collect();
    let paces: Vec<Pace> = stretches.iter().map(|(_, stretch)| stretch.pace(r_c)).collect();
    let cells = (0..stretches.len()).map(|sheet| Cell { sheet, s: [0.0, 1.0], t: [0.0, TAU] });
    // By stretch and part of it; and sines and cosines of angles on the rim.
    let mut ends: FxHashMap<(usize, u64), Disc> = FxHashMap::default();
    let mut turned: FxHashMap<u64, (f64, f64)> = FxHashMap::default();
    let found = greatest_above(known, cells, close, FLOOR_BOXES, |cell| {
        let (_, stretch) = stretches[cell.sheet];
        let pace = paces[cell.sheet];
        let (speed, acceleration) = (pace.speed + pace.turn * a, pace.acceleration + pace.turn * pace.turn * a);
        // Distance from the axis of the part, height, depth below the floor.
        let rim = |(center, [first, second]): (Vector3<f64>, [Vector3<f64>; 2]), (sin, cos): (f64, f64)| {
            let point = center + (first * cos + second * sin) * a;
            let rho = (point.x * point.x + point.y * point.y).sqrt();
            (rho, point.z, ((rho - R) * (rho - R) + point.z * point.z).sqrt() - r_f)
        };
        let ([s_0, s_1], [low, high]) = (cell.s, cell.t);
        let (along, around) = (s_1 - s_0, high - low);
        let ways = [speed * along / 2.0, a * around / 2.0];
        let (way, first) = (ways[0] + ways[1], ways[0] > ways[1]);
        let mut end = |s: f64| {
            kept(&mut ends, (cell.sheet, key(s)), || {
                let (tip, axis, across) = stretch.frame(s);
                (tip + axis * r_c, across)
            })
        };
        let mut turn = |angle: f64| kept(&mut turned, key(angle), || sin_cos(angle));
        let (rho, z, depth) = rim(end((s_0 + s_1) / 2.0), turn((low + high) / 2.0));
        // Outside the blank there is nothing to cut.
        let outside = (z.max(rho - R) - way - stretch.slack).max(0.0);
        if outside > r_c {
            return Bounds { upper: f64::NEG_INFINITY, middle: f64::NEG_INFINITY, first };
        }
        let round = (r_c * r_c - outside * outside).sqrt();
        let turned = cell.t.map(turn);
        let corners = cell.s.into_iter().map(end).flat_map(|end| turned.map(|turned| rim(end, turned).2));
        let corners = corners.fold(f64::NEG_INFINITY, f64::max);
        let least = rho - way;
        let by_bend = if least > 0.0 {
            let bent =
                |speed: f64, acceleration: f64, side: f64| (speed * speed / least + acceleration) * side * side / 8.0;
            corners + bent(speed, acceleration, along) + bent(a, a, around)
        } else {
            f64::INFINITY
        };
        let middle = seen([rho - R, z], r_c, depth, r_f);
        Bounds { upper: by_bend.min(depth + way) + stretch.slack + round, middle, first }
    })?;
    let (track, stretch) = stretches[found.at.sheet];
    let [low, high] = found.at.s;
    let x = stretch.index((low + high) / 2.0);
    Some(Deepest { most: found.upper.max(0.0), found: found.lower.max(0.0), track, x })
}

/// How deep a point of the blank lies in a ball of the radius r_c whose centre is at the depth given, `beside` the middle
/// of the tube by as much outwards and upwards: the deepest one, or the one at the edge of the blank; none for a ball that
/// has left it.
fn seen([out, up]: [f64; 2], r_c: f64, depth: f64, r_f: f64) -> f64 {
    let far = hypot(out, up);
    let part = if far > 0.0 { r_c / far } else { 0.0 };
    if up + up * part <= 0.0 && out + out * part <= 0.0 {
        return depth + r_c;
    }
    let at_edge = |beyond: f64, along: f64| {
        let left = r_c * r_c - beyond * beyond;
        if left >= 0.0 { along.abs() + left.sqrt() - r_f } else { f64::NEG_INFINITY }
    };
    match (up > 0.0, out > 0.0) {
        (true, true) => f64::NEG_INFINITY,
        (true, false) => at_edge(up, out),
        _ => at_edge(out, up),
    }
}

/// How far a stretch of time may be from the straight line between its ends, mm.
const SAG: f64 = 0.0002;
/// How often it is halved at most for that.
const HALVINGS: u8 = 12;

/// The deepest point of passes that are made not to go below the floor: [`deepest`] looks at the stretches alone for which
/// a coarser bound does not show that they are not deeper than a limit.
///
/// # Derivation
/// At one time the disc at the tool's end lies in the ball about the point c of the tube's middle circle that is nearest to
/// the axis: with c at the distance m from the axis and the end D below c, T ≤ √(D² + (a + m)²) all round (with a rounded end, r_c more of its disc), for T is no more than
/// the distance from any point of the circle. Over time T exceeds the greater of both ends by no more than
/// (V²/ρ + W)/8, as above, whatever the place on the rim.
#[must_use]
pub fn within<T: Copy>(torus: Torus, a_p: f64, mill: Tool, sweeps: &[Sweep<T>], limit: f64) -> Option<Deepest<T>> {
    let mut most: Option<Deepest<T>> = None;
    let mut left = Vec::new();
    for sweep in sweeps {
        let mut open = Vec::new();
        for stretch in &sweep.stretches {
            let pace = stretch.pace(mill.r_c);
            match ball(torus, a_p, mill, stretch, pace, limit) {
                Some(upper) => {
                    let found = upper.max(0.0);
                    if most.is_none_or(|known| found > known.most) {
                        most = Some(Deepest { most: found, found: 0.0, track: sweep.track, x: stretch.index(0.5) });
                    }
                }
                None => open.push(*stretch),
            }
        }
        left.push(Sweep { track: sweep.track, stretches: open, height: sweep.height });
    }
    // Mostly run-outs: as deep as the floor outside of the blank, and hardly deeper than the rest inside.
    for sweep in left {
        let known = most.map_or(f64::NEG_INFINITY, |most| most.most);
        if let Some(found) = deeper(torus, a_p, mill, &[sweep], SAG, known)
            && most.is_none_or(|known| found.most > known.most)
        {
            most = Some(found);
        }
    }
    most
}

/// The coarser bound of one stretch; `None` where it does not show that the stretch keeps to the limit.
fn ball(Torus { R, r }: Torus, a_p: f64, mill: Tool, stretch: &Stretch, pace: Pace, limit: f64) -> Option<f64> {
    let (a, r_c, r_f) = (mill.flat_radius(), mill.r_c, r + a_p);
    // Depth below the floor, at most, and the least distance of the disc from the axis of the part.
    let at = |s: f64| {
        let (tip, axis) = stretch.tool(s);
        let tip = tip + axis * r_c;
        // The nearest point of the circle to the line of the axis, from the place of the axis at its height, by steps.
        let mut along = 0.0;
        let mut centre = tip;
        for _ in 0..6 {
            let point = tip + axis * along;
            let rho = (point.x * point.x + point.y * point.y).sqrt();
            centre = Vector3::new(point.x / rho * R, point.y / rho * R, 0.0);
            along = (centre - tip).dot(&axis);
        }
        let m = (tip + axis * along - centre).norm();
        let rho = (tip.x * tip.x + tip.y * tip.y).sqrt() - a;
        (hypot(along, a + m) + r_c - r_f, rho)
    };
    let (speed, acceleration) = (pace.speed + pace.turn * a, pace.acceleration + pace.turn * pace.turn * a);
    let mut pieces = vec![([0.0, 1.0], [at(0.0), at(1.0)], HALVINGS)];
    let mut most = f64::NEG_INFINITY;
    while let Some(([s_0, s_1], ends, halvings)) = pieces.pop() {
        let span = s_1 - s_0;
        let least = ends[0].1.min(ends[1].1) - speed * span / 2.0;
        if least <= 0.0 || ends.iter().any(|end| end.0.is_nan()) {
            return None;
        }
        let sag = (speed * speed / least + acceleration) * span * span / 8.0;
        let upper = ends[0].0.max(ends[1].0) + sag;
        if ends[0].0.max(ends[1].0) + stretch.slack > limit {
            return None;
        }
        if sag > SAG && upper > most && halvings > 0 {
            let middle = f64::midpoint(s_0, s_1);
            let found = at(middle);
            pieces.push(([s_0, middle], [ends[0], found], halvings - 1));
            pieces.push(([middle, s_1], [found, ends[1]], halvings - 1));
        } else {
            most = most.max(upper);
        }
    }
    Some(most + stretch.slack).filter(|most| *most <= limit)
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
