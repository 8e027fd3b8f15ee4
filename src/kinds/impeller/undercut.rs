//! How far the passes of a blade cut into its own faces.
//!
//! # Derivation
//! The tool stands along N of the mean line. At the depth h the trace of a face is turned against the mean line by θ(h), since
//! the rulings are twisted, so that a cylinder along N cuts into the face by about a(1 − cos θ(a_p)), with
//! tan θ = a_p·τ_0/(1 − a_p/R) and τ_0 = √((R + r)/(R − r))/R at the hub, where it is the most. The law leaves out the
//! thickness and what the blocks add, and may come out some per cent too small; so what is reported is an upper bound over both
//! faces, block by block, down to the floor. The published maxima, 0.050 mm in the shipped design, are greater than that of the
//! same tool without blocks (0.045 mm): they count what lies below the tool's end and below the floor.
//!
//! The distance of a point of a face from the axis has, along the way of the tool and along the face, a second derivative of
//! V²/D + W at most, with V the speed and W the acceleration: over a box of both it is less than the least of its corners by
//! no more than an eighth of that, times the square of the sides. Points below the tool's end do not count.
//!
//! # Units
//! Millimetres and radians.

use crate::geometry::torus::Torus;
use nalgebra::Vector3;
use rustc_hash::FxHashMap;

use crate::kinds::impeller::part::{Change, Face, Part, Piece, Ruling};
use crate::kinds::impeller::sweep::{Pace, Stretch, Sweep};
use crate::kinds::impeller::track::Track;
use crate::limits::UNDERCUT_BOXES;
use crate::number::bisection::{Bounds, Cell, greatest};

/// How close the bound is to what is found, mm.
const CLOSE: f64 = 0.0002;

/// The undercut of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undercut {
    /// It is not more, mm.
    pub most: f64,
    /// It is this at least.
    pub found: f64,
    /// The point index of the tool where it is.
    pub x: f64,
}

/// The law: a(1 − cos θ) at the hub, mm.
#[must_use]
pub fn law(Torus { R, r }: Torus, a_p: f64, d_t: f64) -> f64 {
    let tan = a_p * ((R + r) / (R - r)).sqrt() / R / (1.0 - a_p / R);
    d_t / 2.0 * (1.0 - 1.0 / (1.0 + tan * tan).sqrt())
}

/// The height above the tip up to which a sweep must hold for [`undercut`]: no face comes near the axis above it.
#[must_use]
pub fn height(a_p: f64, d_t: f64) -> f64 {
    a_p + 2.0 * d_t
}

/// How far the tool of a blade's pass goes into the face that it cuts; `None` for a splitter's.
#[must_use]
pub fn undercut(part: &Part, sweep: &Sweep, d_t: f64) -> Option<Undercut> {
    let face = match sweep.track {
        Track::Obverse => Face::Obverse,
        Track::Reverse => Face::Reverse,
        Track::Out | Track::Back => return None,
    };
    let pieces = part.pieces(face);
    let paces: Vec<Pace> = sweep.stretches.iter().map(|stretch| stretch.pace(sweep.height)).collect();
    let cells = (0..sweep.stretches.len() * pieces.len()).map(|sheet| Cell {
        sheet,
        s: [0.0, 1.0],
        t: pieces[sheet % pieces.len()].v,
    });
    // The same strips of the face stand beside many stretches, and the tool at the same places beside many strips.
    let mut strips: FxHashMap<(usize, [u64; 2]), Strip> = FxHashMap::default();
    let mut tools: FxHashMap<(usize, u64), (Vector3<f64>, Vector3<f64>)> = FxHashMap::default();
    let found = greatest(cells, CLOSE, UNDERCUT_BOXES, |cell| {
        let (at, piece) = (cell.sheet / pieces.len(), cell.sheet % pieces.len());
        let strip =
            strips.entry((piece, cell.t.map(f64::to_bits))).or_insert_with(|| Strip::new(part, &pieces[piece], cell.t));
        let [s_0, s_1] = cell.s;
        let tool = |s: f64| *tools.entry((at, s.to_bits())).or_insert_with(|| sweep.stretches[at].tool(s));
        let tools = [s_0, s_1, f64::midpoint(s_0, s_1)].map(tool);
        let beside = Beside { part, stretch: &sweep.stretches[at], tools, pace: &paces[at], strip, a: d_t / 2.0 };
        beside.bounds(cell)
    })?;
    let stretch = &sweep.stretches[found.at.sheet / pieces.len()];
    let [low, high] = found.at.s;
    Some(Undercut { most: found.upper.max(0.0), found: found.lower.max(0.0), x: stretch.index((low + high) / 2.0) })
}

/// A strip of a face between two v.
struct Strip {
    /// The rulings at both v and in the middle.
    rulings: [Ruling; 3],
    /// None begins higher.
    top: f64,
    /// None ends deeper.
    deep: f64,
    /// Where that in the middle ends.
    end: f64,
    change: Change,
}

impl Strip {
    fn new(part: &Part, piece: &Piece, [v_0, v_1]: [f64; 2]) -> Self {
        let v = f64::midpoint(v_0, v_1);
        // h_0 does not grow with v.
        let top = part.top(v_1);
        let change = part.change([v_0, v_1], piece.bottom.max(-top));
        let rulings = [v_0, v_1, v].map(|v| part.ruling(piece.face, v));
        let [at_0, at_1, ruling] = rulings;
        let [h_1, h_2] = part.floors(piece, [v_0, v_1], &[at_0, at_1], &change);
        let end = part.floor(&ruling, part.top(v));
        Self { rulings, top, deep: h_1.max(h_2), end, change }
    }
}

/// A stretch of the tool's way beside a strip of a face.
struct Beside<'a> {
    part: &'a Part,
    stretch: &'a Stretch,
    /// Tip and axis at both ends of a part of it, and in the middle.
    tools: [(Vector3<f64>, Vector3<f64>); 3],
    pace: &'a Pace,
    strip: &'a Strip,
    a: f64,
}

impl Beside<'_> {
    fn bounds(&self, cell: &Cell) -> Bounds {
        let (a, pace) = (self.a, self.pace);
        let Strip { rulings, top, deep: h_1, end, change } = self.strip;
        let (top, h_1) = (*top, *h_1);
        let [s_0, s_1] = cell.s;
        let (along, over) = (s_1 - s_0, cell.t[1] - cell.t[0]);
        let ruling = &rulings[2];
        // What the tool's end and a point of the face beside it move against each other.
        let ways = [(pace.speed + pace.turn * 2.0 * a) * along / 2.0, change.speed * over / 2.0];
        let way = ways[0] + ways[1];
        let first = ways[0] > ways[1];
        let low = ruling.at(h_1);
        let R = self.part.circle.torus.R;
        if low.z - ways[1] > 0.0 || (low.x * low.x + low.y * low.y).sqrt() - ways[1] > R {
            return Bounds { upper: f64::NEG_INFINITY, middle: f64::NEG_INFINITY, first };
        }
        // Down to which depth points may be above the tool's end, and the distance from the axis down to there.
        let tools = self.tools;
        let (tip, axis) = tools[2];
        let up = (ruling.foot - tip).dot(&axis);
        let fall = ruling.N.dot(&axis);
        let deepest = |margin: f64| if fall > 0.1 { ((up + margin) / fall).min(h_1) } else { h_1 };
        let distance = |s: usize, v: usize, deepest: f64| {
            let ((tip, axis), ruling) = (tools[s], rulings[v]);
            let (from, down) = (ruling.foot - tip, -ruling.N);
            let (from, down) = (from - axis * from.dot(&axis), down - axis * down.dot(&axis));
            let square = down.norm_squared();
            let h = if square > 1e-18 { (-from.dot(&down) / square).clamp(top.min(deepest), deepest) } else { deepest };
            ((from + down * h).norm(), ruling.at(h))
        };
        let lowest = deepest(way);
        if lowest < top {
            return Bounds { upper: f64::NEG_INFINITY, middle: f64::NEG_INFINITY, first };
        }
        let corners = [(0, 0), (0, 1), (1, 0), (1, 1)]
            .map(|(s, v)| distance(s, v, lowest).0)
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let by_way = distance(2, 2, lowest).0 - pace.speed * along / 2.0 - ways[1];
        let least = (corners - way).max(by_way);
        let bent =
            |speed: f64, acceleration: f64, side: f64| (speed * speed / least + acceleration) * side * side / 8.0;
        let by_bend = if least > 0.1 * a {
            corners - bent(pace.speed, pace.acceleration, along) - bent(change.speed, change.acceleration, over)
        } else {
            f64::NEG_INFINITY
        };
        let exact = deepest(0.0).min(*end);
        let middle = if exact >= top {
            let (distance, point) = distance(2, 2, exact);
            if self.part.trimmed(&point) { a - distance } else { f64::NEG_INFINITY }
        } else {
            f64::NEG_INFINITY
        };
        Bounds { upper: a - by_way.max(by_bend).max(0.0) + self.stretch.slack, middle, first }
    }
}

#[cfg(test)]
mod tests {
    use super::law;
    use crate::geometry::torus::Torus;

    #[test]
    fn the_law_is_that_of_the_check_values() {
        let found = [(25.0, 15.0, 2.0), (25.0, 17.0, 4.0), (50.0, 30.0, 3.0)]
            .map(|(R, r, a_p)| format!("{:.6}", law(Torus { R, r }, a_p, 6.0)));
        assert_eq!(found, ["0.044365", "0.250455", "0.024151"]);
    }
}
