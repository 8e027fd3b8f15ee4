//! The way of the tool over the part, as the programs give it: X, Y, Z, B and C evenly from each point on the output grid to
//! the next, from the safe point at one end to that at the other; with bounds of how it moves.
//!
//! Where blocks are short, several are taken as one. How far the tool then is from where they put it is its `slack`.
//!
//! # Units
//! Millimetres and radians, in the part frame of the track's own blade.
//!
//! # Derivation
//! With p = (X, Y, Z + h) a point of the axis at the height h above the tip, y = p + L·k̂ and j the B axis, the
//! turned-back point is z(s) with z′ = Δp + ΔB·j×y and z″ = 2ΔB·j×Δp − ΔB²·(y_x, 0, y_z); both are linear in s, so that their
//! sizes peak at the ends. In the part, C added, a point moves by no more than |ΔC|·ρ + |z′| and is accelerated by no more
//! than ΔC²·ρ + 2|ΔC|·|z′| + |z″|.

use nalgebra::Vector3;

use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::programs::Tracks;
use crate::kinds::impeller::track::Track;
use crate::machine::axis::{Axis, Position};
use crate::machine::rotary::{TiltingTable, Turned};
use crate::number::trig::sin_cos;

/// Most slack of blocks taken as one, mm.
const SLACK: f64 = 0.0005;

/// Where all axes stand: X, Y, Z in mm, B and C in radians.
type Stand = [f64; 5];

/// A block, or some that follow each other and are taken as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    from: Stand,
    to: Stand,
    machine: TiltingTable,
    /// The point indices at its ends; −1 and n + 1 are the safe points.
    pub x: [f64; 2],
    /// How far any point of the axis up to the height [`Sweep::height`] is from where the blocks put it, at most.
    pub slack: f64,
}

/// The way along one track, or another pass.
#[derive(Clone, Debug)]
pub struct Sweep<T = Track> {
    /// The track or pass that is followed.
    pub track: T,
    /// Its stretches, from the hub to the rim.
    pub stretches: Vec<Stretch>,
    /// The height above the tip up to which its bounds hold.
    pub height: f64,
}

/// How fast the tool's axis moves over a stretch, for the whole of it as the unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// No point of the axis moves farther.
    pub speed: f64,
    /// None is accelerated more.
    pub acceleration: f64,
    /// The tool turns by no more, radians.
    pub turn: f64,
}

fn stand(position: &Position) -> Stand {
    let value = |axis: Axis| position.get(axis).value();
    [value(Axis::X), value(Axis::Y), value(Axis::Z), value(Axis::B).to_radians(), value(Axis::C).to_radians()]
}

fn between(from: &Stand, to: &Stand, part: f64) -> Stand {
    let mut at = *from;
    for (at, to) in at.iter_mut().zip(to) {
        *at += (to - *at) * part;
    }
    at
}

fn less(to: &Stand, from: &Stand) -> Stand {
    let mut by = *to;
    for (by, from) in by.iter_mut().zip(from) {
        *by -= from;
    }
    by
}

/// Tip and axis of the tool where all axes stand somewhere.
fn tool(machine: TiltingTable, [x, y, z, B, C]: &Stand) -> (Vector3<f64>, Vector3<f64>) {
    let [tip, axis] = machine.tool(&Vector3::new(*x, *y, *z), *B, *C);
    (tip, axis)
}

/// How far points of the tool's axis up to a height above the tip are at most from the axis of B, and from that of C.
fn reach(machine: TiltingTable, [x, y, z, B, _]: &Stand, height: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos(*B);
    let up = z + machine.L;
    let out = x * cos + up * sin;
    [x.abs() + up.abs() + height, (out * out + y * y).sqrt() + height]
}

/// Where all axes stand at a point, and how far the tool's axis then reaches.
struct StandReach {
    stand: Stand,
    reach: [f64; 2],
}

impl StandReach {
    fn new(machine: TiltingTable, position: &Position, height: f64) -> Self {
        let stand = stand(position);
        Self { stand, reach: reach(machine, &stand, height) }
    }
}

impl Stretch {
    /// Tip and axis of the tool at a part of the stretch.
    #[must_use]
    pub fn tool(&self, part: f64) -> (Vector3<f64>, Vector3<f64>) {
        tool(self.machine, &between(&self.from, &self.to, part))
    }

    /// The same, and two directions across the axis, square to each other.
    #[must_use]
    pub fn frame(&self, part: f64) -> (Vector3<f64>, Vector3<f64>, [Vector3<f64>; 2]) {
        let [x, y, z, B, C] = between(&self.from, &self.to, part);
        let turned = Turned::to(B, C);
        let [tip, axis] = self.machine.tool_turned(&Vector3::new(x, y, z), &turned);
        (tip, axis, [turned.direction_to_part(&Vector3::x()), turned.direction_to_part(&Vector3::y())])
    }

    /// The point index at a part of the stretch.
    #[must_use]
    pub fn index(&self, part: f64) -> f64 {
        self.x[0] + (self.x[1] - self.x[0]) * part
    }

    /// How fast the axis moves up to a height above the tip.
    #[must_use]
    pub fn pace(&self, height: f64) -> Pace {
        let by = less(&self.to, &self.from);
        let [dx, dy, dz, dB, dC] = by;
        let mut pace = Pace { speed: 0.0, acceleration: 0.0, turn: dB.abs() + dC.abs() };
        let tools = [tool(self.machine, &self.from), tool(self.machine, &self.to)];
        for above in [0.0, height] {
            let out = |(tip, axis): &(Vector3<f64>, Vector3<f64>)| {
                let point = tip + axis * above;
                (point.x * point.x + point.y * point.y).sqrt()
            };
            let moved = |at: &Stand| {
                let (y_x, y_z) = (at[0], at[2] + above + self.machine.L);
                let first = Vector3::new(dx + dB * y_z, dy, dz - dB * y_x).norm();
                let second = Vector3::new(2.0 * dB * dz - dB * dB * y_x, 0.0, -2.0 * dB * dx - dB * dB * y_z).norm();
                (first, second)
            };
            let (from, to) = (moved(&self.from), moved(&self.to));
            let (first, second) = (from.0.max(to.0), from.1.max(to.1));
            let rho = out(&tools[0]).max(out(&tools[1])) + first / 2.0;
            pace.speed = pace.speed.max(dC.abs() * rho + first);
            pace.acceleration = pace.acceleration.max(dC * dC * rho + 2.0 * dC.abs() * first + second);
        }
        pace
    }
}

impl Sweep<Track> {
    /// The way along a track of a design; `None` for a splitter's where there is none. The bounds hold up to a height above
    /// the tip.
    #[must_use]
    pub fn new(design: &Design, tracks: &Tracks, track: Track, height: f64) -> Option<Self> {
        let points = tracks.positions(track)?;
        let [entry, exit] = &tracks.safe_points(track);
        let at = std::iter::once(entry).chain(points).chain([exit]);
        let at: Vec<StandReach> = at.map(|position| StandReach::new(design.machine, position, height)).collect();
        let mut sweep = Self { track, stretches: Vec::new(), height };
        // The ways in and out stand by themselves.
        let last = at.len() - 1;
        sweep.take(design.machine, &at, 0, 1);
        sweep.take(design.machine, &at, 1, last - 1);
        sweep.take(design.machine, &at, last - 1, last);
        Some(sweep)
    }
}

impl<T> Sweep<T> {
    /// The way through some positions, block by block. The bounds hold up to a height above the tip.
    #[must_use]
    pub fn through(track: T, machine: TiltingTable, positions: &[Position], height: f64) -> Self {
        let at: Vec<StandReach> = positions.iter().map(|position| StandReach::new(machine, position, height)).collect();
        let mut sweep = Self { track, stretches: Vec::new(), height };
        if let Some(last) = at.len().checked_sub(1).filter(|last| *last > 0) {
            sweep.take(machine, &at, 0, last);
        }
        sweep
    }

    /// Takes the blocks from one point to another as one stretch, or as the two halves of them.
    fn take(&mut self, machine: TiltingTable, at: &[StandReach], low: usize, high: usize) {
        let Some(slack) = self.slack(machine, &at[low..=high]) else {
            let middle = low + (high - low) / 2;
            self.take(machine, at, low, middle);
            self.take(machine, at, middle, high);
            return;
        };
        #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
        let x = [low as f64 - 1.0, high as f64 - 1.0];
        self.stretches.push(Stretch { from: at[low].stand, to: at[high].stand, machine, x, slack });
    }

    /// How far the axis is from that of one block through all of these points; `None` where that is too much. Between two of
    /// them both run evenly, so that it is the farthest at one of them.
    fn slack(&self, machine: TiltingTable, at: &[StandReach]) -> Option<f64> {
        let (Some(from), Some(to)) = (at.first(), at.last()) else { return Some(0.0) };
        #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
        let off = |k: usize| {
            let StandReach { stand: here, reach: here_reach } = &at[k];
            let even = between(&from.stand, &to.stand, k as f64 / (at.len() - 1) as f64);
            let off = less(here, &even);
            let way = Vector3::new(off[0], off[1], off[2]).norm();
            let even_reach = reach(machine, &even, self.height);
            let turned = |axis: usize| off[axis + 3].abs() * here_reach[axis].max(even_reach[axis]);
            way + turned(0) + turned(1)
        };
        // Of blocks that are not straight the middle tells it at once.
        if off(at.len() / 2) > SLACK {
            return None;
        }
        let mut most = 0.0_f64;
        for k in 0..at.len() {
            most = most.max(off(k));
            if most > SLACK {
                return None;
            }
        }
        Some(most)
    }
}
