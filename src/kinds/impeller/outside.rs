//! How near a tool that moves comes to the turned stock: a lower and an upper bound, never a sample.
//!
//! The tool is a cylinder with a flat end. The stock is a body of revolution about the axis of C, so that C does not matter;
//! motions are straight in X, Y, Z and B. The distance is that of the nearest point of the tool's end and side.
//!
//! # The bound
//! The stock is two cylinders about its axis and what the tube leaves between them ([`Stock::cylinders`]). A point q of the
//! tool is away from the stock by the least of its distances from the three:
//!
//! - From a convex body the distance is convex: known at p with its slope n, it is at q no less than d(p) + n·(q − p).
//! - In the tube the distance is r − T, T being that from the circle in the tube's middle. With k the point of that circle
//!   nearest to p, T(q) ≤ |q − k|, and |q − k| ≤ T(p) + n·(q − p) + |q − p|²/2(T(p) − |q − p|), for its second derivative along
//!   a line is no more than one over its value.
//! - No distance falls by more than |q − p|.
//!
//! A cell is a span of time and a piece of end or side. Over the piece at one time n·(q − p) is least at a place that has a
//! closed form, for the angle enters by one cosine and the other coordinate linearly; from there the distance is asked again,
//! which leads to the nearest point in few steps. Over time a point of the tool moves in the part by
//! n·v·δ, v = Δp + ΔB·J·m, and no more than |ΔB|·(way over the piece)·δ and half of (ΔB²|m| + 2|ΔB||Δp|)·δ² beside, m being
//! the point seen from the pivot and J the quarter turn about the B axis.
//!
//! The cell with the least bound is halved first, across what it loses most by; the search ends when the bounds are
//! [`CLOSE`], of a tool that is in the stock a hundredth of its depth apart. Where the work ends before, the lower one still holds.
//!
//! # Units
//! Millimetres and radians.

use std::collections::BinaryHeap;
use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::solids::Stock;
use crate::limits::MOVE_CELLS;
use crate::number::queue::Waiting;
use crate::number::trig::{atan2, cos, hypot, sin_cos};

/// How close the bounds are brought to each other, mm.
pub const CLOSE: f64 = 2e-5;
/// Cells that are evaluated at most for a move; a usual one takes some tens.
pub const WORK: usize = MOVE_CELLS;
/// Of a tool that is in the stock the depth is worth knowing to this part of it.
const COARSE: f64 = 0.01;
/// What the arithmetic may lose, mm.
const ARITHMETIC: f64 = 1e-9;
/// Places on the tool from which a cell is bounded, each where the one before it led.
const PLACES: usize = 4;

/// A tool and the stock on a machine.
#[derive(Clone, Copy, Debug)]
pub struct Outside {
    /// The turned blank, in the part frame.
    pub stock: Stock,
    /// L, the pivot length.
    pub L: f64,
    /// The tool's radius, mm.
    pub radius: f64,
    /// How much of the tool over its tip is looked at.
    pub reach: f64,
}

/// What is known of the distance over a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// It is nowhere less.
    pub lower: f64,
    /// Somewhere it is no more; negative where a point of the tool is in the stock, by how much.
    pub upper: f64,
    /// How many cells were evaluated.
    pub work: usize,
}

/// A span of time and a piece of the tool: angles about its axis and, of the end, parts of the radius, of the side, parts of
/// the reach.
#[derive(Clone, Copy, Debug)]
struct Cell {
    end: bool,
    /// Time, angle and part, from and to.
    sides: [[f64; 2]; 3],
}

/// A lower bound, and what time, angle and part take from it.
type Least = (f64, [f64; 3]);

/// By how much something falls over a cell, by time, angle and part, and at which angle and part it is the least.
type Fall = ([f64; 3], [f64; 2]);

/// The angle between two at which a cosine about another is least, that cosine, and the cosine at `angle`.
fn least_cosine([low, high]: [f64; 2], about: f64, angle: f64) -> (f64, f64, f64) {
    let opposite = about + PI;
    let at = opposite + ((low - opposite) / TAU).ceil() * TAU;
    if at <= high {
        return (at, -1.0, cos(angle - about));
    }
    let ends = [low, high].map(|angle| (angle, cos(angle - about)));
    let least = if ends[0].1 <= ends[1].1 { ends[0] } else { ends[1] };
    // Mostly the angle is one of the ends.
    let known = ends.iter().find(|end| end.0 == angle);
    (least.0, least.1, known.map_or_else(|| cos(angle - about), |end| end.1))
}

impl Outside {
    /// The stock of a design and its roughing tool, of the diameter d_t.
    #[must_use]
    pub const fn new(design: &Design) -> Self {
        Self::of(design, design.d_t)
    }

    /// That of a design with a tool of a diameter.
    #[must_use]
    pub const fn of(design: &Design, d: f64) -> Self {
        Self {
            stock: Stock { torus: design.torus, length: design.blank.L_b },
            L: design.machine.L,
            radius: d / 2.0,
            reach: design.tool_reach(),
        }
    }

    /// The distance along a straight move of all axes.
    #[must_use]
    pub fn along(&self, from: &Stand, to: &Stand, budget: usize) -> Bounds {
        let mut search = Search::new(self, [*from, *to]);
        let lower = search.run(budget).min(search.upper) - ARITHMETIC;
        Bounds { lower, upper: search.upper + ARITHMETIC, work: search.work }
    }

    /// True where the distance along a straight move is found to be so much greater than another one's lower bound that its own
    /// would be, too.
    #[must_use]
    pub fn is_farther(&self, from: &Stand, to: &Stand, lower: f64, budget: usize) -> bool {
        let far = lower + 3.0 * CLOSE.max(-lower * COARSE);
        let mut search = Search { far, ..Search::new(self, [*from, *to]) };
        search.run(budget).min(search.upper) - ARITHMETIC >= far
    }
}

struct Search<'a> {
    outside: &'a Outside,
    way: [Stand; 2],
    upper: f64,
    work: usize,
    /// It need not be known what is farther than this, mm.
    far: f64,
}

impl<'a> Search<'a> {
    const fn new(outside: &'a Outside, way: [Stand; 2]) -> Self {
        Self { outside, way, upper: f64::INFINITY, work: 0, far: f64::INFINITY }
    }

    /// Halves the worst cell until the end; the least bound that is left.
    fn run(&mut self, budget: usize) -> f64 {
        let (mut heap, mut cells) = (BinaryHeap::new(), Vec::new());
        let wait = |search: &mut Self, cells: &mut Vec<Cell>, cell: Cell| {
            let (bound, across) = search.evaluate(&cell);
            cells.push(cell);
            Waiting { bound, order: cells.len() - 1, what: across }
        };
        for end in [true, false] {
            heap.push(wait(self, &mut cells, Cell { end, sides: [[0.0, 1.0], [0.0, TAU], [0.0, 1.0]] }));
        }
        while let Some(Waiting { bound, order: cell, what: across }) = heap.pop() {
            // Of a move that comes nearer than it was asked for no more is asked.
            let nearer = self.far < f64::INFINITY && self.upper < self.far;
            if bound >= self.enough() || nearer || self.work >= budget {
                return bound;
            }
            let [low, high] = cells[cell].sides[across];
            let middle = low + (high - low) / 2.0;
            for half in [[low, middle], [middle, high]] {
                let mut part = cells[cell];
                part.sides[across] = half;
                heap.push(wait(self, &mut cells, part));
            }
        }
        f64::INFINITY
    }

    /// Cells with a bound like this need not be parted.
    const fn enough(&self) -> f64 {
        (self.upper - CLOSE.max(-self.upper * COARSE)).min(self.far)
    }

    /// The lower bound of a cell, and which side of it to halve.
    fn evaluate(&mut self, cell: &Cell) -> (f64, usize) {
        self.work += 1;
        let [time, angles, parts] = cell.sides;
        let [from, to] = &self.way;
        let stand = from.towards(to, (time[0] + time[1]) / 2.0);
        let mid = MidStand {
            half: (time[1] - time[0]) / 2.0,
            by: to.at - from.at,
            way: (to.at - from.at).norm(),
            turn: to.B - from.B,
            B: sin_cos(stand.B),
            tip: stand.at + Vector3::new(0.0, 0.0, self.outside.L),
        };
        let (mut least, mut lost) = (f64::INFINITY, [0.0; 3]);
        // All pieces are first seen from the same place.
        let mut middle = self.point(cell, &mid, [angles, parts].map(|[low, high]| low + (high - low) / 2.0));
        for piece in 0..3 {
            let mut best: Least = (f64::NEG_INFINITY, [0.0; 3]);
            let (mut found, mut next) = self.from(cell, &mid, piece, &mut middle);
            let mut place = middle.place;
            for left in (0..PLACES).rev() {
                if found.0 > best.0 {
                    best = found;
                }
                if best.0 >= self.enough() || next == place || left == 0 {
                    break;
                }
                place = next;
                let mut point = self.point(cell, &mid, place);
                (found, next) = self.from(cell, &mid, piece, &mut point);
            }
            if best.0 < least {
                (least, lost) = best;
            }
        }
        let across = (0..3).fold(0, |most, side| if lost[side] > lost[most] { side } else { most });
        (least, across)
    }

    /// The point of the tool at one place of a cell, and how far the others are from it.
    fn point(&mut self, cell: &Cell, mid: &MidStand, [angle, part]: [f64; 2]) -> Point {
        let Outside { stock, L, radius, reach } = *self.outside;
        let [_, angles, parts] = cell.sides;
        let (sine, cosine) = sin_cos(angle);
        let (wide, high) = if cell.end { (radius * part, 0.0) } else { (radius, reach * part) };
        let m = mid.tip + Vector3::new(wide * cosine, wide * sine, high);
        let (sin_B, cos_B) = mid.B;
        let at = Vector3::new(m.x * cos_B + m.z * sin_B, m.y, m.z * cos_B - m.x * sin_B - L);
        let rho = (at.x * at.x + at.y * at.y).sqrt();
        self.upper = self.upper.min(stock.distance(rho, at.z));

        // How far the points of the piece are from this one, by angle and by part, and how far they move.
        let farthest = |[low, high]: [f64; 2], at: f64| (at - low).max(high - at);
        let (around, along) = (farthest(angles, angle).min(2.0) * wide, farthest(parts, part));
        let along = along * if cell.end { radius } else { reach };
        let extent = if cell.end { around + along } else { hypot(around, along) };
        let v = mid.by + Vector3::new(m.z, 0.0, -m.x) * mid.turn;
        let (turn, by) = (mid.turn.abs(), mid.way);
        let beside = if turn == 0.0 {
            0.0
        } else {
            let far = hypot(m.x, m.z) + extent + mid.half * by;
            mid.half * (turn * extent + mid.half * turn * (turn * far + 2.0 * by) / 2.0)
        };
        let way = extent + mid.half * v.norm() + beside;
        Point { place: [angle, part], at, rho, wide, around, along, extent, v, beside, way, fall: None }
    }

    /// By how much n·q may be less over a cell than at a point, by time, angle and part, and the place where it is.
    fn fall(&self, cell: &Cell, mid: &MidStand, point: &mut Point, n: &Vector3<f64>) -> Fall {
        let bits = n.map(f64::to_bits);
        if let Some((known, fall)) = point.fall
            && known == bits
        {
            return fall;
        }
        let Outside { radius, reach, .. } = *self.outside;
        let ([_, angles, parts], [angle, part], (sin_B, cos_B)) = (cell.sides, point.place, mid.B);
        let turned = Vector3::new(n.x * cos_B - n.z * sin_B, n.y, n.x * sin_B + n.z * cos_B);
        let (flat, about) = (hypot(turned.x, turned.y), atan2(turned.y, turned.x));
        let (at, least, here) = least_cosine(angles, about, angle);
        let by_angle = point.wide * flat * (here - least);
        let rise = if cell.end { radius * flat * least } else { reach * turned.z };
        let to = if rise < 0.0 { parts[1] } else { parts[0] };
        let by_part = rise * (part - to);
        let by_time = mid.half * turned.dot(&point.v).abs() + point.beside;
        let fall = ([by_time, by_angle.max(0.0), by_part.max(0.0)], [at, to]);
        point.fall = Some((bits, fall));
        fall
    }

    /// What the distance from a piece of the stock is nowhere less than over a cell, seen from one place of the tool, and the
    /// place to which that leads.
    fn from(&self, cell: &Cell, mid: &MidStand, piece: usize, view: &mut Point) -> (Least, [f64; 2]) {
        let Outside { stock, .. } = *self.outside;
        let Point { place, at: point, rho, around, along, extent, way, .. } = *view;
        let mut most = |n: &Vector3<f64>| self.fall(cell, mid, view, n).0.iter().sum::<f64>();

        let torus = stock.torus;
        let (distance, n, tube) = if piece < 2 {
            let (distance, n) = stock.cylinders()[piece].distance(&point);
            (distance, n, None)
        } else {
            let [out, up] = [rho - torus.R, point.z];
            // On the axis every direction leads to the circle.
            let radial = if rho > 0.0 { Vector3::new(point.x / rho, point.y / rho, 0.0) } else { Vector3::x() };
            // Nothing of the cell in the tube's quarter: this is not what it is near to. Distance from the axis and height
            // are convex, too.
            let upwards = Vector3::new(point.x * 0.0, point.y * 0.0, 1.0);
            if out + way < -torus.r
                || out > 0.0 && rho > 0.0 && out > most(&radial)
                || up > 0.0 && up > most(&upwards)
                || up < -torus.r && -torus.r - up > most(&-upwards)
            {
                return ((f64::INFINITY, [0.0; 3]), place);
            }
            let T = (out * out + up * up).sqrt();
            let n = if T > 0.0 { -(radial * out + upwards * up) / T } else { Vector3::zeros() };
            (torus.r - T, n, Some(T))
        };
        let (lost, place) = self.fall(cell, mid, view, &n);
        let straight = distance - lost.iter().sum::<f64>();
        let bent = match tube {
            None => 0.0,
            Some(T) if T > way => way * way / (2.0 * (T - way)),
            Some(_) => f64::INFINITY,
        };
        let ways = [way - extent, around, along];
        let least = if straight - bent >= distance - way {
            let share = bent / way.max(f64::MIN_POSITIVE);
            (straight - bent, std::array::from_fn(|side| lost[side] + share * ways[side]))
        } else {
            (distance - way, ways)
        };
        (least, place)
    }
}

/// The machine in the middle of a cell's time.
struct MidStand {
    /// Half of the cell's span of time.
    half: f64,
    by: Vector3<f64>,
    way: f64,
    turn: f64,
    /// Sine and cosine of B.
    B: (f64, f64),
    /// The tip, seen from the pivot.
    tip: Vector3<f64>,
}

/// A point of the tool in the middle of a cell's time.
#[derive(Clone, Copy)]
struct Point {
    /// Its angle and part.
    place: [f64; 2],
    /// Where it is in the part.
    at: Vector3<f64>,
    /// How far from the axis of the part.
    rho: f64,
    /// How far from that of the tool.
    wide: f64,
    /// How far other points of the cell are, by angle, by part and by both.
    around: f64,
    along: f64,
    extent: f64,
    /// How fast it moves, what moves beside that, and how far any point is from it at any time.
    v: Vector3<f64>,
    beside: f64,
    way: f64,
    /// What was last asked of it, and the answer: pieces of the stock often lie the same way.
    fall: Option<(Vector3<u64>, Fall)>,
}
