//! The path of the tip between the blocks.
//!
//! The control moves X, Y, Z, B and C linearly and, with these programs, does not hold the tool centre point: between
//! two points of a track the tip leaves the track's ideal path T(v) = P ± w·b − a_p·N. The pose at a fraction of a block
//! is put back on the part; from the ideal point at the same fraction of the step the difference D is taken, and from D
//! what lies along the path, which leaves the distance to the nearest point of the path (the rest is of second order in
//! D over the radius of the path).
//!
//! D is parted into what goes *into the metal* and what does not. Metal lies on two sides of the tip: below the floor,
//! towards −N, and behind the flank of the track's own blade, towards ∓b. So −D·N is the depth past the floor, D·(∓b)
//! the depth past the flank, and the greater of both is how far the tool goes into the metal. Seen from the deepest
//! point of a block the floor gives nearly all of it: the tip cuts the corner of its own arc.
//!
//! # Between the looks
//! With P the projection across the path's slope, e = P·D has the second derivative P″D + 2P′D′ + PD″. The slope's direction turns
//! by τ ≤ |T″|/|T′| and that by τ₂ ≤ |T‴|/|T′| + 3τ², so that |P′| ≤ τ and |P″| ≤ 2τ₂ + 2τ²; |D″| is at most the acceleration of the tip
//! in the part and |T″|, for which there are bounds over a whole block ([`Ideal::bends`]). Between two looks D, D′ and T′ follow
//! from their values there and |D″|. So |e|, −e·N and e·(∓b) exceed their greater values at two looks by no more than an eighth of the
//! bound of their second derivative times the square of the span, and spans are parted until that is `FINE`. What is reported and
//! compared with a tolerance is the bound.
//!
//! The deviation falls with 1/n², down to what the grid of 0.001 mm and 0.001° leaves: half a thousandth of a degree of
//! B at the distance L of the pivot.
//!
//! # Units
//! Millimetres; x in steps.

use nalgebra::Vector3;

use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::ideal::{Ideal, Station};
use crate::kinds::impeller::track::Track;
use crate::limits::TIP_LOOKS;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::TiltingTable;
use crate::number::bound::Enclosure;
use crate::number::grid::{HALF, Milli};
use crate::proof::agreement::tip;

/// How far the tip may go into the metal before a person must judge it where the workbook states no tolerance, mm: the
/// fine class of ISO 2768-1 for lengths up to 6 mm.
pub const INTO_METAL: f64 = 0.05;
/// The deviation for which the n is named where the workbook states no tolerance, mm.
pub const NAMED: f64 = 0.01;

/// On which side of what deviation and depth into the metal must be known to be, mm.
#[must_use]
pub fn limits(design: &Design) -> [f64; 2] {
    [design.tol.unwrap_or(NAMED), INTO_METAL]
}

/// How far the tip is from its path at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// How far the tip is from the path, mm, across its direction.
    pub total: f64,
    /// Past the floor; negative above it.
    pub floor: f64,
    /// Past the flank of the track's own blade; negative away from it.
    pub flank: f64,
}

impl Deviation {
    /// How far the tool goes into the metal: the greater of floor and flank.
    #[must_use]
    pub const fn into_metal(&self) -> f64 {
        self.floor.max(self.flank)
    }
}

/// A pose at a fraction of the way from one to another.
#[must_use]
pub fn between(from: &Pose, to: &Pose, fraction: f64) -> Pose {
    Pose(std::array::from_fn(|axis| from.0[axis] + (to.0[axis] - from.0[axis]) * fraction))
}

/// The deviation of a pose from the ideal path at the index x, the pose turned back by `turn`.
#[must_use]
pub fn deviation(ideal: &Ideal, machine: TiltingTable, pose: &Pose, turn: Milli, x: f64) -> Deviation {
    let mut own = *pose;
    own.set(Axis::C, pose.get(Axis::C) - turn.value());
    let station = ideal.at(x);
    deviation_of(&station, tip(machine, &own) - station.tip)
}

/// The deviation of a tip that is off the ideal point.
fn deviation_of(station: &Station, mut off: Vector3<f64>) -> Deviation {
    let length = station.slope.norm_squared();
    if length > 0.0 {
        off -= station.slope * (off.dot(&station.slope) / length);
    }
    Deviation { total: off.norm(), floor: -off.dot(&station.N), flank: -off.dot(&station.away) }
}

/// A greatest value with its place along the track and in the program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// What was measured, mm.
    pub value: f64,
    /// The point index, continued between the points.
    pub x: f64,
    /// The line of the program's text; 0 outside a program.
    pub line: usize,
    /// The block number.
    pub n: Option<u32>,
}

impl Peak {
    fn raise(&mut self, value: f64, x: f64, block: (usize, Option<u32>)) {
        // What is no number is beyond every limit, and stays.
        if value > self.value || (value.is_nan() && !self.value.is_nan()) {
            *self = Self { value, x, line: block.0, n: block.1 };
        }
    }
}

/// Most points of a curve to be drawn.
const DRAWN: usize = 240;
/// How near the bound is brought to what is found, mm.
const FINE: f64 = 2e-6;

#[derive(Clone, Copy, Debug)]
struct TipSample {
    /// What part of the block lies before it.
    part: f64,
    /// From the ideal point to the tip.
    off: Vector3<f64>,
    /// How long the slope of the ideal path is, mm a step.
    slope: f64,
    found: Deviation,
}

/// How a block and the path beside it bend, the whole block as the unit.
#[derive(Clone, Copy, Debug)]
struct Bent {
    /// The second derivative of the tip less that of the path, at most.
    off: f64,
    /// The second and third of the path.
    path: [f64; 2],
    /// The first and second of N and of the direction away from the blade.
    frame: [f64; 2],
}

impl Bent {
    /// What distance and depth into the metal are nowhere greater than between two looks.
    fn over(&self, one: &TipSample, other: &TipSample) -> [f64; 2] {
        let h = other.part - one.part;
        let D = one.off.norm().max(other.off.norm()) + self.off * h * h / 8.0;
        let D_1 = (other.off - one.off).norm() / h + self.off * h / 2.0;
        let slope = one.slope.max(other.slope) - self.path[0] * h;
        if slope <= 0.0 {
            return [f64::INFINITY; 2];
        }
        let (turn, bend) = (self.path[0] / slope, self.path[1] / slope);
        let bend = bend + 3.0 * turn * turn;
        let across = 2.0 * (bend + turn * turn) * D + 2.0 * turn * D_1 + self.off;
        let inwards = across + 2.0 * (turn * D + D_1) * self.frame[0] + D * self.frame[1];
        let over = |found: [f64; 2], bent: f64| found[0].max(found[1]) + bent * h * h / 8.0 + ARITHMETIC;
        let looks = [one, other];
        [over(looks.map(|look| look.found.total), across), over(looks.map(|look| look.found.into_metal()), inwards)]
    }
}

/// What the arithmetic of a look may lose, mm.
const ARITHMETIC: f64 = 1e-9;

/// How much the tip of a block is accelerated in the part at most, the whole block as the unit; `out` is the distance from the
/// part's axis at its farther end. As in [`sweep`](crate::kinds::impeller::sweep).
fn acceleration(machine: TiltingTable, [from, to]: [&Pose; 2], out: f64) -> f64 {
    let by = |axis: Axis| to.get(axis) - from.get(axis);
    let (dx, dy, dz) = (by(Axis::X), by(Axis::Y), by(Axis::Z));
    let (dB, dC) = (by(Axis::B).to_radians(), by(Axis::C).to_radians());
    let (mut first, mut second) = (0.0_f64, 0.0_f64);
    for pose in [from, to] {
        let (x, z) = (pose.get(Axis::X), pose.get(Axis::Z) + machine.L);
        first = first.max(Vector3::new(dx + dB * z, dy, dz - dB * x).norm());
        second = second.max(Vector3::new(2.0 * dB * dz - dB * dB * x, 0.0, 2.0 * dB * dx + dB * dB * z).norm());
    }
    dC * dC * (out + first / 2.0) + 2.0 * dC.abs() * first + second
}

/// What is known of the tip along one track.
#[derive(Clone, Debug)]
pub struct Along {
    /// The path it should take.
    pub ideal: Ideal,
    /// The greatest distance from it that was seen.
    pub total: Peak,
    /// The farthest into the metal.
    pub metal: Peak,
    /// The greatest distance of a block's end from its exact point: what the grid of 0.001 leaves.
    pub grid: Peak,
    /// What that may be at most, where it may be most.
    pub grid_limit: f64,
    /// By how much a block's end is farther from its exact point than the grid may bring it there.
    pub past_grid: Peak,
    /// x and how far into the metal in the middle of blocks, to be drawn.
    pub curve: Vec<[f64; 2]>,
    bound: Enclosure<2>,
    stride: usize,
}

impl Along {
    /// Nothing known yet. Of distance and depth into the metal it will be known on which side of two limits they are, mm.
    #[must_use]
    pub fn new(ideal: Ideal, n: usize, limits: [f64; 2]) -> Self {
        let peak = Peak::default();
        Self {
            ideal,
            total: peak,
            metal: peak,
            grid: peak,
            grid_limit: 0.0,
            past_grid: peak,
            curve: Vec::new(),
            bound: Enclosure::new([FINE; 2], limits, TIP_LOOKS),
            stride: n.div_ceil(DRAWN).max(1),
        }
    }

    /// What distance and depth into the metal are nowhere greater than, mm.
    #[must_use]
    pub fn at_most(&self) -> [f64; 2] {
        self.bound.at_most.map(|most| most.max(0.0))
    }

    /// The block that runs from one point of the track to the next, turned on by `turn`; `block` is its line and number.
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn block(
        &mut self,
        machine: TiltingTable,
        ends: [&Pose; 2],
        points: [usize; 2],
        turn: Milli,
        block: (usize, Option<u32>),
    ) {
        let [x0, x1] = points.map(|point| point as f64);
        let (low, steps) = (points[0].min(points[1]), (x1 - x0).abs());
        let ideal = self.ideal;
        let (total, metal) = (&mut self.total, &mut self.metal);
        let mut look = |part: f64| {
            let x = x0 + (x1 - x0) * part;
            let mut pose = between(ends[0], ends[1], part);
            pose.set(Axis::C, pose.get(Axis::C) - turn.value());
            let station = ideal.within(x, low as f64 + 0.5);
            let off = tip(machine, &pose) - station.tip;
            let found = deviation_of(&station, off);
            total.raise(found.total, x, block);
            metal.raise(found.into_metal(), x, block);
            TipSample { part, off, slope: station.slope.norm() * steps, found }
        };
        let looks = [0.0, 0.5, 1.0].map(&mut look);
        let out = ends.map(|pose| {
            let point = tip(machine, pose);
            (point.x * point.x + point.y * point.y).sqrt()
        });
        let bends = ideal.bends(low as f64);
        let path = [bends.tip[0] * steps * steps, bends.tip[1] * steps * steps * steps];
        let bent = Bent {
            off: acceleration(machine, ends, out[0].max(out[1])) + path[0],
            path,
            frame: [bends.frame[0] * steps, bends.frame[1] * steps * steps],
        };
        self.bound.take(
            &looks,
            |look| [look.found.total, look.found.into_metal()],
            |one, other| bent.over(one, other),
            |one, other| look(f64::midpoint(one.part, other.part)),
        );
        // The middle of a block is where it leaves its path farthest.
        if low.is_multiple_of(self.stride) {
            self.curve.push([f64::midpoint(x0, x1), looks[1].found.into_metal()]);
        }
        self.end(machine, ends[1], points[1], turn, block);
    }

    /// A block's end: how far the grid has moved it from its exact point.
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn end(&mut self, machine: TiltingTable, pose: &Pose, point: usize, turn: Milli, block: (usize, Option<u32>)) {
        let mut own = *pose;
        own.set(Axis::C, pose.get(Axis::C) - turn.value());
        let x = point as f64;
        let at = tip(machine, &own);
        let (moved, limit) = ((at - self.ideal.at(x).tip).norm(), grid_bound(machine, &own, &at));
        self.grid.raise(moved, x, block);
        self.past_grid.raise(moved - limit, x, block);
        self.grid_limit = self.grid_limit.max(limit);
    }

    /// The track along whose ideal path the tip is measured.
    #[must_use]
    pub const fn track(&self) -> Track {
        self.ideal.track
    }
}

/// How far rounding a pose to the grid may have moved the tip from where it should be to `point`: √3·0.0005 mm in line, and half
/// a thousandth of a degree of B at the distance from the pivot, of C at the distance from the axis, both of the exact place,
/// which is so much farther out at most, for the part turns about both as a whole.
#[must_use]
pub fn grid_bound(machine: TiltingTable, pose: &Pose, point: &Vector3<f64>) -> f64 {
    let square = |axis: Axis| pose.get(axis) * pose.get(axis);
    let height = pose.get(Axis::Z) + machine.L;
    let line = HALF * 3.0_f64.sqrt();
    let pivot = (square(Axis::X) + square(Axis::Y) + height * height).sqrt() + line;
    let axis = (point.x * point.x + point.y * point.y).sqrt() + line + HALF.to_radians() * pivot;
    line + HALF.to_radians() * (pivot + axis) + ARITHMETIC
}
