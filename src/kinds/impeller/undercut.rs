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
//! Depth is what is gone from the blade, square to the face. In a plane across the axis, w is the way from the axis to a
//! point of the face and n_a the part of the normal n that lies in the plane: along n the tool ends at
//! (√(a² − x²) − √(w² − x²))/|n_a|, x being what of w lies along the face, |w·(axis × n)|/|n_a|. It grows with x and falls
//! with w. Where the face goes on beside the tool, the most is where x = 0; at the floor and at the cut-off ends it is
//! elsewhere, and more than a − w, the distance from the tool's side.
//!
//! w has, along the way of the tool and along the face, a second derivative of V²/D + W at most, with V the speed and W the
//! acceleration: over a box of both it is less than the least of its corners by no more than an eighth of that, times the
//! square of the sides. x and n_a are taken from the middle, as far off as point, normal and axis may be. Points below the
//! tool's end do not count.
//!
//! # Units
//! Millimetres and radians.

use std::collections::BinaryHeap;

use crate::geometry::darboux::opposite;
use crate::geometry::torus::Torus;
use nalgebra::Vector3;
use rustc_hash::FxHashMap;

use crate::kinds::impeller::part::{Change, Face, Part, Piece, Ruling};
use crate::kinds::impeller::sweep::{Pace, Stretch, Sweep};
use crate::kinds::impeller::track::Track;
use crate::kinds::impeller::twist::Twist;
use crate::limits::UNDERCUT_BOXES;
use crate::number::bisection::{Bounds, Cell, greatest, kept, key};
use crate::number::queue::Waiting;
use crate::number::root::quadratic;
use crate::number::{greater, lesser};

/// How close the bound is to what is found, mm.
const CLOSE: f64 = 0.0004;
/// The shortest piece of a ruling that is looked at by itself, mm; and how much longer each above it is.
const SHORT: f64 = 0.01;
const LONGER: f64 = 4.0;

/// How far a pass cuts into the face beside which it runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undercut {
    /// It is not more, mm.
    pub most: f64,
    /// The deepest place found, mm: the true one is no less.
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
    let mut best = f64::NEG_INFINITY;
    let found = greatest(cells, CLOSE, UNDERCUT_BOXES, |cell| {
        let (at, piece) = (cell.sheet / pieces.len(), cell.sheet % pieces.len());
        let strip = &kept(&mut strips, (piece, cell.t.map(key)), || Strip::new(part, &pieces[piece], cell.t));
        let [s_0, s_1] = cell.s;
        let tool = |s: f64| kept(&mut tools, (at, key(s)), || sweep.stretches[at].tool(s));
        let [before, after, tool] = [s_0, s_1, f64::midpoint(s_0, s_1)].map(tool);
        let [low, high, ruling] = &strip.rulings;
        let rulings = [(before, low), (before, high), (after, low), (after, high), (tool, ruling)];
        let rulings = rulings.map(|(tool, ruling)| ProjectedRuling::new(tool, ruling));
        let (pace, a, sides) = (&paces[at], d_t / 2.0, [s_1 - s_0, cell.t[1] - cell.t[0]]);
        let ways = [(pace.speed + pace.turn * 2.0 * a) * sides[0] / 2.0, strip.change.speed * sides[1] / 2.0];
        let stretch = &sweep.stretches[at];
        let beside =
            ToolBesideStrip { part, stretch, height: sweep.height, tool, rulings, pace, strip, a, ways, sides };
        let bounds = beside.bounds(best + CLOSE);
        best = best.max(bounds.middle);
        bounds
    })?;
    let stretch = &sweep.stretches[found.at.sheet / pieces.len()];
    let [low, high] = found.at.s;
    Some(Undercut { most: found.upper.max(0.0), found: found.lower.max(0.0), x: stretch.index((low + high) / 2.0) })
}

/// A strip of a face between two v.
#[derive(Clone, Copy)]
struct Strip {
    /// The rulings at both v and in the middle.
    rulings: [Ruling; 3],
    /// How the face lies along that in the middle.
    twist: Twist,
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
        Self { rulings, twist: Twist::new(part, piece.face, v), top, deep: h_1.max(h_2), end, change }
    }
}

/// A ruling seen along the tool's axis.
#[derive(Clone, Copy)]
struct ProjectedRuling {
    /// From the axis to its foot.
    beside: Vector3<f64>,
    /// What it goes on by for each millimetre of depth.
    down: Vector3<f64>,
    /// The depth of the point nearest to the axis, if it went on for ever; of one along the axis the deepest.
    nearest: f64,
}

impl ProjectedRuling {
    fn new((tip, axis): (Vector3<f64>, Vector3<f64>), ruling: &Ruling) -> Self {
        let (beside, down) = (ruling.foot - tip, opposite(ruling.N));
        let (beside, down) = (beside - axis * beside.dot(&axis), down - axis * down.dot(&axis));
        let square = down.norm_squared();
        let nearest = if square > 1e-18 { -beside.dot(&down) / square } else { f64::INFINITY };
        Self { beside, down, nearest }
    }

    /// The distance of its nearest point between two depths from the axis, with the depth.
    fn nearest(&self, [from, to]: [f64; 2]) -> (f64, f64) {
        let h = self.nearest.clamp(lesser(from, to), to);
        ((self.beside + self.down * h).norm(), h)
    }
}

/// A stretch of the tool's way beside a strip of a face.
struct ToolBesideStrip<'a> {
    part: &'a Part,
    stretch: &'a Stretch,
    /// [`Sweep::height`], mm.
    height: f64,
    /// Tip and axis in the middle of a part of it.
    tool: (Vector3<f64>, Vector3<f64>),
    /// The rulings at both v, seen from both ends, and that in the middle from there.
    rulings: [ProjectedRuling; 5],
    pace: &'a Pace,
    strip: &'a Strip,
    a: f64,
    /// How far the tool's end and a point of the face beside it move from the middles, each by itself, mm.
    ways: [f64; 2],
    /// How long the parts of way and face are.
    sides: [f64; 2],
}

impl ToolBesideStrip<'_> {
    /// Bounds of the depth; what is no more than is known already is not looked at closer.
    fn bounds(&self, known: f64) -> Bounds {
        let Strip { rulings, top, deep: h_1, end, .. } = self.strip;
        let (top, h_1, ways) = (*top, *h_1, self.ways);
        let ruling = &rulings[2];
        let way = ways[0] + ways[1];
        let first = ways[0] > ways[1];
        let nowhere = Bounds { upper: f64::NEG_INFINITY, middle: f64::NEG_INFINITY, first };
        let low = ruling.at(h_1);
        let R = self.part.circle.torus.R;
        if low.z - ways[1] > 0.0 || (low.x * low.x + low.y * low.y).sqrt() - ways[1] > R {
            return nowhere;
        }
        // Down to which depth points may be above the tool's end.
        let (tip, axis) = self.tool;
        let up = (ruling.foot - tip).dot(&axis);
        let fall = ruling.N.dot(&axis);
        let deepest = |margin: f64| if fall > 0.1 { ((up + margin) / fall).min(h_1) } else { h_1 };
        let lowest = deepest(way);
        if lowest < top {
            return nowhere;
        }
        let exact = deepest(0.0).min(*end);
        let middle = if exact >= top { self.found([top, exact]) } else { f64::NEG_INFINITY };
        let least = self.least([top, lowest]);
        if least >= self.a {
            return Bounds { upper: self.a - least, middle, first };
        }
        // The normals turn along a ruling: its pieces are the longer, the farther they are from where the tool goes in deepest.
        // Of those that may hold more than is known the one that may hold most is halved, until it is as short as any.
        let long = way.max(SHORT);
        // The heap gives the least first, and the greatest is wanted: bounds wait with their sign turned.
        let mut open = BinaryHeap::new();
        let mut looked = 0;
        let mut look = |open: &mut BinaryHeap<Waiting<[f64; 2]>>, what: [f64; 2], near: f64| {
            let bound = self.at_most(what, near);
            if bound > known {
                open.push(Waiting { bound: -bound, order: looked, what });
            }
            looked += 1;
        };
        let (mut bottom, mut piece) = (lowest, long);
        while bottom > top {
            let from = if bottom - top > 2.0 * piece { bottom - piece } else { top };
            let near = if from == top && bottom == lowest { least } else { self.least([from, bottom]) };
            look(&mut open, [from, bottom], near);
            (bottom, piece) = (from, LONGER * piece);
        }
        let mut upper = known;
        while let Some(Waiting { bound, what: [from, to], .. }) = open.pop() {
            if to - from <= long {
                upper = -bound;
                break;
            }
            let middle = f64::midpoint(from, to);
            for half in [[middle, to], [from, middle]] {
                look(&mut open, half, self.least(half));
            }
        }
        Bounds { upper, middle, first }
    }

    /// No point between two depths is nearer to the axis, wherever the blocks have it.
    fn least(&self, depths: [f64; 2]) -> f64 {
        let (pace, change, [along, over]) = (self.pace, &self.strip.change, self.sides);
        let [one, two, three, four, middle] = self.rulings.each_ref().map(|ruling| ruling.nearest(depths).0);
        let corners = lesser(lesser(one, two), lesser(three, four));
        let by_way = middle - pace.speed * along / 2.0 - self.ways[1];
        let least = greater(corners - self.ways[0] - self.ways[1], by_way);
        let bent =
            |speed: f64, acceleration: f64, side: f64| (speed * speed / least + acceleration) * side * side / 8.0;
        let by_bend = if least > 0.1 * self.a {
            corners - bent(pace.speed, pace.acceleration, along) - bent(change.speed, change.acceleration, over)
        } else {
            f64::NEG_INFINITY
        };
        greater(0.0, greater(by_way, by_bend)) - self.stretch.slack
    }

    /// How deep the tool in the middle is below the face, along its normal at a depth of the ruling in the middle.
    fn under(&self, h: f64) -> f64 {
        let ((tip, axis), ruling) = (self.tool, &self.strip.rulings[2]);
        let point = ruling.at(h);
        if !self.part.trimmed(&point) {
            return f64::NEG_INFINITY;
        }
        let normal = self.strip.twist.normal(h);
        let normal = normal / normal.norm();
        let (from, up) = (point - tip, normal.dot(&axis));
        let height = from.dot(&axis);
        let (beside, across) = (from - axis * height, normal - axis * up);
        let lacking = beside.norm_squared() - self.a * self.a;
        if lacking >= 0.0 {
            return f64::NEG_INFINITY;
        }
        // |beside − across·x| = a, but for where the tool's end comes before.
        let end = if up > 0.0 { height / up } else { f64::INFINITY };
        quadratic(across.norm_squared(), -2.0 * beside.dot(&across), lacking).map_or(end, |[_, out]| out.min(end))
    }

    /// The depth below the face that is there, between two depths of the ruling in the middle.
    fn found(&self, depths: [f64; 2]) -> f64 {
        let (distance, h) = self.rulings[4].nearest(depths);
        if distance >= self.a {
            let point = self.strip.rulings[2].at(h);
            return if self.part.trimmed(&point) { self.a - distance } else { f64::NEG_INFINITY };
        }
        self.under(h).max(self.under(depths[1]))
    }

    /// No point between two depths of a ruling is deeper below the face, along the normal there; none is nearer to the axis
    /// than `near`.
    fn at_most(&self, depths: [f64; 2], near: f64) -> f64 {
        let (a, Strip { rulings, twist, change, .. }) = (self.a, self.strip);
        if near >= a {
            return a - near;
        }
        let ((tip, axis), h, half) = (self.tool, f64::midpoint(depths[0], depths[1]), (depths[1] - depths[0]) / 2.0);
        let [along, over] = self.sides;
        let normal = twist.normal(h);
        // How far normal and axis turn from the middle, and what a point moves beside the axis.
        let (long, turned) =
            (normal.norm(), (change.acceleration + change.speed * change.turn) * over / 2.0 + change.turn * half);
        let slack = self.stretch.slack;
        let tilt = self.pace.turn * along / 2.0 + 2.0 * slack / self.height;
        if long <= 2.0 * turned {
            return 2.0 * a;
        }
        let (normal, turned) = (normal / long, turned / (long - turned));
        let slide = self.ways[0] + self.ways[1] + half * rulings[2].N.cross(&axis).norm() + slack;
        let loose = slide + a * (turned + tilt);
        let upright = normal.dot(&axis).abs() + turned + tilt;
        let from = rulings[2].at(h) - tip;
        let out = -(from - axis * from.dot(&axis)).dot(&normal) - loose;
        if upright >= 1.0 || out <= 0.0 {
            return 2.0 * a;
        }
        let level = (1.0 - upright * upright).sqrt();
        let aside = (from.dot(&axis.cross(&normal)).abs() + loose) / level;
        let square = (aside * aside).min(near * near);
        ((a * a - square).sqrt() - (near * near - square).sqrt()) / level
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
