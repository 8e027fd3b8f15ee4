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
//! The deviation falls with 1/n², down to what the grid of 0.001 mm and 0.001° leaves: half a thousandth of a degree of
//! B at the distance L of the pivot.
//!
//! # Units
//! Millimetres; x in steps.

use crate::impeller::ideal::Ideal;
use crate::impeller::track::Track;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::Rotary;
use crate::number::grid::Milli;
use crate::verify::agreement::tip;

/// How far the tip is from its path at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// The distance.
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
pub fn deviation(ideal: &Ideal, machine: Rotary, pose: &Pose, turn: Milli, x: f64) -> Deviation {
    let mut own = *pose;
    own.set(Axis::C, pose.get(Axis::C) - turn.value());
    let station = ideal.at(x);
    let mut off = tip(machine, &own) - station.tip;
    let length = station.slope.norm_squared();
    if length > 0.0 {
        off -= station.slope * (off.dot(&station.slope) / length);
    }
    Deviation { total: off.norm(), floor: -off.dot(&station.N), flank: -off.dot(&station.away) }
}

/// A greatest value with its place along the track and in the program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// The value.
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
        if value > self.value {
            *self = Self { value, x, line: block.0, n: block.1 };
        }
    }
}

/// Fractions of a block at which the tip is looked at: eighths where there are few blocks, quarters where there are many.
const FEW: usize = 400;

/// Most points of a curve to be drawn.
const DRAWN: usize = 240;

/// What is known of the tip along one track.
#[derive(Clone, Debug)]
pub struct Along {
    /// The path it should take.
    pub ideal: Ideal,
    /// The greatest distance from it.
    pub total: Peak,
    /// The farthest into the metal.
    pub metal: Peak,
    /// The greatest distance of a block's end from its exact point: what the grid of 0.001 leaves.
    pub grid: Peak,
    /// x and how far into the metal in the middle of blocks, to be drawn.
    pub curve: Vec<[f64; 2]>,
    parts: u16,
    stride: usize,
}

impl Along {
    /// Nothing known yet.
    #[must_use]
    pub fn new(ideal: Ideal, n: usize) -> Self {
        let parts: u16 = if n <= FEW { 8 } else { 4 };
        let stride = n.div_ceil(DRAWN).max(1);
        let peak = Peak::default();
        Self { ideal, total: peak, metal: peak, grid: peak, curve: Vec::new(), parts, stride }
    }

    /// The block that runs from one point of the track to the next, turned on by `turn`; `block` is its line and number.
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn block(
        &mut self,
        machine: Rotary,
        ends: [&Pose; 2],
        points: [usize; 2],
        turn: Milli,
        block: (usize, Option<u32>),
    ) {
        let [x0, x1] = points.map(|point| point as f64);
        let least = points[0].min(points[1]);
        let drawn = least.is_multiple_of(self.stride);
        for part in 1..=self.parts {
            let fraction = f64::from(part) / f64::from(self.parts);
            let x = x0 + (x1 - x0) * fraction;
            let at = deviation(&self.ideal, machine, &between(ends[0], ends[1], fraction), turn, x);
            self.total.raise(at.total, x, block);
            self.metal.raise(at.into_metal(), x, block);
            // The middle of a block is where it leaves its path farthest.
            if drawn && 2 * part == self.parts {
                self.curve.push([x, at.into_metal()]);
            }
        }
        self.end(machine, ends[1], points[1], turn, block);
    }

    /// A block's end: how far the grid has moved it from its exact point.
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    pub fn end(&mut self, machine: Rotary, pose: &Pose, point: usize, turn: Milli, block: (usize, Option<u32>)) {
        let mut own = *pose;
        own.set(Axis::C, pose.get(Axis::C) - turn.value());
        let x = point as f64;
        self.grid.raise((tip(machine, &own) - self.ideal.at(x).tip).norm(), x, block);
    }

    /// The track.
    #[must_use]
    pub const fn track(&self) -> Track {
        self.ideal.track
    }
}

/// How far rounding a pose to the grid may move the tip: √3·0.0005 mm in line, and half a thousandth of a degree of B at
/// the distance from the pivot, of C at the distance from the axis. Derived here: the part turns about both as a whole.
#[must_use]
pub fn grid_bound(machine: Rotary, pose: &Pose) -> f64 {
    let half = 0.0005_f64;
    let square = |axis: Axis| pose.get(axis) * pose.get(axis);
    let height = pose.get(Axis::Z) + machine.L;
    let pivot = (square(Axis::X) + square(Axis::Y) + height * height).sqrt();
    let point = tip(machine, pose);
    let axis = (point.x * point.x + point.y * point.y).sqrt();
    half * 3.0_f64.sqrt() + half.to_radians() * (pivot + axis)
}
