//! Where the points of a pass lie: as few as the tolerance allows, each block with the same error.
//!
//! # Derivation
//! Between two points the axes run evenly (X, Y, Z, B, C), the tip therefore not along the way that is wanted. The error
//! of a block is the largest deviation, across the direction of travel, of two points of the tool's axis, the tip and one
//! above the tops, between the even motion and the exact one, at eight places inside; to that comes what the end's rim
//! gains by a deviation of the axis' direction, and how much deeper the end may reach. That is bounded by the ball: with m
//! the distance of the axis from the point c of K nearest to it, and D how far below c the end stands, no point of it lies
//! deeper in the tube than √(D² + (a + m)²). The block is made as long as the error allows. For smooth passes the
//! greatest of eight is within 4 % of the true one; that much is kept back.
//!
//! The axes run evenly, the tip does not either: where a feed deviation δ is asked for, its speed at both ends of a block may
//! differ from its mean by no more than that.
//!
//! # Units
//! Millimetres and radians.

use nalgebra::{Vector2, Vector3};

use crate::geometry::torus::Torus;
use crate::kinds::impeller::clear::flank::{Passing, passing_near};
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::clearance::Stand;
use crate::machine::rotary::{TiltingTable, Turned};
use crate::number::trig::hypot;

/// Inner places at which a block is looked at.
const PLACES: u8 = 8;
/// What eight places may miss of the greatest error.
const KEPT: f64 = 0.96;
/// The longest block is looked for in halvings of the last difference.
const HALVINGS: u8 = 7;
/// No block is shorter than this part of a piece.
const SHORTEST: f64 = 1e-6;

/// What a pass is held to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The machine whose axes run evenly over a block.
    pub machine: TiltingTable,
    /// ε, how far blocks may leave the way.
    pub epsilon: f64,
    /// δ, the part by which the feed of the tip may change within a block.
    pub delta: Option<f64>,
    /// How far above the tip the tool still cuts.
    pub height: f64,
    /// The tool whose end and side are watched.
    pub tool: Tool,
    /// The torus of the part, about whose circle K depths are counted.
    pub torus: Torus,
}

/// A tool in the part: the tip, and the direction of its axis.
fn tool(machine: TiltingTable, stand: &Stand) -> [Vector3<f64>; 2] {
    machine.tool(&stand.at, stand.B, stand.C)
}

/// The tool at the ends of so many even steps of a block, from its beginning on.
fn evenly(machine: TiltingTable, ends: [&Stand; 2], steps: u8) -> impl Iterator<Item = [Vector3<f64>; 2]> {
    let [&from, &to] = ends;
    let step = Turned::to((to.B - from.B) / f64::from(steps), (to.C - from.C) / f64::from(steps));
    let by = (to.at - from.at) / f64::from(steps);
    let turned = std::iter::successors(Some(Turned::to(from.B, from.C)), move |turned| Some(turned.on_by(&step)));
    (0..=steps).zip(turned).map(move |(k, turned)| machine.tool_turned(&(from.at + by * f64::from(k)), &turned))
}

/// The size of what is across a direction of travel.
fn across(off: Vector3<f64>, travel: Vector3<f64>) -> f64 {
    travel.try_normalize(1e-12).map_or(off, |travel| off - travel * off.dot(&travel)).norm()
}

impl Tolerance {
    /// How deep in the tube the end of a tool reaches at most.
    fn reach(&self, [tip, along]: &[Vector3<f64>; 2]) -> f64 {
        let near = tip + along * self.torus.r;
        let out = near.xy().try_normalize(0.0).unwrap_or_else(Vector2::x);
        let Passing { m, at, .. } = passing_near(tip, along, self.torus.R, (out.y, out.x));
        hypot(at - self.tool.r_c, self.tool.flat_radius() + m) + self.tool.r_c
    }

    /// By how much a block from x_0 to x_1 of a way leaves it, mm.
    #[must_use]
    pub fn error(&self, way: &impl Fn(f64) -> Stand, [x_0, x_1]: [f64; 2]) -> f64 {
        self.deviation(way, [x_0, x_1], [&way(x_0), &way(x_1)], PLACES)
    }

    /// The same, looked at in more or fewer places.
    #[must_use]
    pub fn deviation(&self, way: &impl Fn(f64) -> Stand, x: [f64; 2], ends: [&Stand; 2], places: u8) -> f64 {
        self.looked_at(way, x, ends, places, None)
    }

    /// The same; or, where it is only asked whether it is more than enough, any that tells.
    fn looked_at(
        &self,
        way: &impl Fn(f64) -> Stand,
        [x_0, x_1]: [f64; 2],
        ends: [&Stand; 2],
        places: u8,
        enough: Option<f64>,
    ) -> f64 {
        let exact = |part: f64| tool(self.machine, &way(x_0 + (x_1 - x_0) * part));
        let mut evenly = evenly(self.machine, ends, places + 1);
        let Some(mut last) = evenly.next() else { return 0.0 };
        let mut most: f64 = 0.0;
        for (place, even) in (1..=places).zip(evenly) {
            let here = exact(f64::from(place) / f64::from(places + 1));
            let (tip, turn) = (even[0] - here[0], even[1] - here[1]);
            let (travel, over) = (here[0] - last[0], here[0] - last[0] + (here[1] - last[1]) * self.height);
            let off = across(tip, travel).max(across(tip + turn * self.height, over));
            let a = self.tool.a();
            let rim = tip.dot(&here[1]).abs() + turn.norm() * a;
            most = most.max(off).max(rim);
            // The end reaches no deeper by more than it has moved.
            if tip.norm() + turn.norm() * (a + self.height) > most.max(enough.unwrap_or(0.0)) {
                most = most.max(self.reach(&even) - self.reach(&here));
            }
            if enough.is_some_and(|enough| most > enough) {
                break;
            }
            last = here;
        }
        most
    }

    /// The greatest part by which the speed of the tip at the ends of a block differs from its mean.
    #[must_use]
    pub fn feed_error(&self, ends: [&Stand; 2]) -> f64 {
        let mut places = evenly(self.machine, ends, PLACES).map(|[tip, _]| tip);
        let Some(mut last) = places.next() else { return 0.0 };
        let mut mean = 0.0;
        for place in places {
            mean += (place - last).norm();
            last = place;
        }
        if mean < 1e-9 {
            return 0.0;
        }
        let [from, to] = ends;
        let (by, turn) = (to.at - from.at, [to.B - from.B, to.C - from.C]);
        let pivot = Vector3::new(0.0, 0.0, self.machine.L);
        let error = |end: &Stand| (TiltingTable::tip_speed(&(end.at + pivot), &by, end.B, turn) / mean - 1.0).abs();
        error(from).max(error(to)).max(0.0)
    }

    fn holds(&self, way: &impl Fn(f64) -> Stand, x: [f64; 2], ends: [&Stand; 2]) -> bool {
        let enough = self.epsilon * KEPT;
        let near = self.looked_at(way, x, ends, PLACES, Some(enough)) <= enough;
        near && self.delta.is_none_or(|delta| self.feed_error(ends) <= delta)
    }

    /// The points of a way that consists of pieces, given by where they end: every such place, and between as few as hold
    /// the tolerance, up to so many. With each the x at which it lies.
    #[must_use]
    pub fn place(&self, way: &impl Fn(f64) -> Stand, pieces: &[f64], most: usize) -> Vec<(f64, Stand)> {
        let Some(&first) = pieces.first() else { return Vec::new() };
        let mut points = vec![(first, way(first))];
        let mut length = f64::INFINITY;
        for piece in pieces.windows(2) {
            let [begin, end] = [piece[0], piece[1]];
            let whole = end - begin;
            if whole == 0.0 {
                continue;
            }
            let mut x = begin;
            let mut here = way(begin);
            while x != end && points.len() < most {
                let left = (end - x).abs();
                let towards = whole.signum();
                let at = |length: f64| if length >= left { end } else { x + towards * length };
                let try_length = |length: f64| {
                    let to = at(length);
                    let stand = way(to);
                    self.holds(way, [x, to], [&here, &stand]).then_some(stand)
                };
                // From the last length, longer or shorter by halves until it is known between which two it lies.
                let mut good = (0.0, None);
                let mut bad = f64::INFINITY;
                let mut guess = length.min(left);
                for _ in 0..60 {
                    match try_length(guess) {
                        Some(stand) => {
                            good = (guess, Some(stand));
                            if guess >= left || bad.is_finite() {
                                break;
                            }
                            guess = (guess * 1.5).min(left);
                        }
                        None => {
                            bad = guess;
                            if good.1.is_some() || guess < whole.abs() * SHORTEST {
                                break;
                            }
                            guess *= 0.6;
                        }
                    }
                }
                if bad.is_finite() && good.1.is_some() {
                    for _ in 0..HALVINGS {
                        let middle = f64::midpoint(good.0, bad);
                        match try_length(middle) {
                            Some(stand) => good = (middle, Some(stand)),
                            None => bad = middle,
                        }
                    }
                }
                // A way that jumps has no block that holds; it is left by the shortest.
                let (step, stand) = match good {
                    (step, Some(stand)) => (step, stand),
                    (..) => (guess, way(at(guess))),
                };
                (x, here) = (at(step), stand);
                length = step;
                points.push((x, stand));
            }
        }
        points
    }
}
