//! How long the way of the tip over the part is within a block, at most.
//!
//! # Derivation
//! X, Y, Z, B and C run evenly, so that between its ends the tip does not go straight: the chord is too short. With
//! p(s) = Q(s)·y(s), y the tip seen from the pivot and Q the turn of both axes, p‴ = Q‴y + 3Q″Δy, at most
//! J = ω³|y| + 3ω²|Δy| with ω = |ΔB| + |ΔC|. The velocity p′ is therefore nowhere farther than J·h²/8 from the chord between its values
//! at both ends of a piece h of the block, and the piece's way is no longer than h·((|p′₀| + |p′₁|)/2 + J·h²/8). Pieces are halved
//! until J·h²/8 is a ten-thousandth of the way.
//!
//! # Units
//! Millimetres; degrees of B and C as in programs.

use nalgebra::Vector3;
use rustc_hash::{FxBuildHasher, FxHashMap};

use crate::limits::WAY_PIECES;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::TiltingTable;
use crate::number::bisection::key;

/// What part of the way the bound of the velocity may lose.
const CLOSE: f64 = 1e-4;

/// A coordinate without what sums of increments lose: one block has one way, wherever C stands and however it was reached.
fn settled(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// All that the way of a block depends on: X, Y, Z and B of both its ends, mm and degrees, and how far C turns.
fn block(from: &Pose, to: &Pose) -> [f64; 9] {
    let end = |pose: &Pose| {
        let at = |axis| settled(pose.get(axis));
        (at(Axis::X), at(Axis::Y), at(Axis::Z), at(Axis::B))
    };
    let ((x, y, z, B), (to_x, to_y, to_z, to_B)) = (end(from), end(to));
    [x, y, z, B, to_x, to_y, to_z, to_B, settled(to.get(Axis::C) - from.get(Axis::C))]
}

/// What the way of the tip over the part from one pose to another is at most, mm.
#[must_use]
pub fn longest(machine: TiltingTable, from: &Pose, to: &Pose) -> f64 {
    of(machine, block(from, to))
}

/// The ways of a program's blocks, each found once: every blade repeats those of the first.
#[derive(Debug)]
pub struct Ways {
    machine: TiltingTable,
    found: FxHashMap<[u64; 9], f64>,
}

impl Ways {
    /// None is found yet.
    #[must_use]
    pub const fn new(machine: TiltingTable) -> Self {
        Self { machine, found: FxHashMap::with_hasher(FxBuildHasher) }
    }

    /// The same as [`longest`], looked up where the block was asked for before.
    pub fn longest(&mut self, from: &Pose, to: &Pose) -> f64 {
        let block = block(from, to);
        *self.found.entry(block.map(key)).or_insert_with(|| of(self.machine, block))
    }
}

fn of(machine: TiltingTable, [x, y, z, B, to_x, to_y, to_z, to_B, dC]: [f64; 9]) -> f64 {
    let (start, end) = (Vector3::new(x, y, z + machine.L), Vector3::new(to_x, to_y, to_z + machine.L));
    let (B, to_B, dC) = (B.to_radians(), to_B.to_radians(), dC.to_radians());
    let (by, dB) = (end - start, to_B - B);
    let speed = |s: f64| TiltingTable::tip_speed(&(start + by * s), &by, B + dB * s, [dB, dC]);
    let turn = dB.abs() + dC.abs();
    let bend = turn * turn * (turn * start.norm().max(end.norm()) + 3.0 * by.norm()) / 8.0;
    let (first, last) = (speed(0.0), speed(1.0));
    let mut pieces = 1_u32;
    while pieces < WAY_PIECES && bend > CLOSE * first.max(last) * f64::from(pieces * pieces) {
        pieces *= 2;
    }
    let h = 1.0 / f64::from(pieces);
    let inner: f64 = (1..pieces).map(|piece| speed(f64::from(piece) * h)).sum();
    h * ((first + last) / 2.0 + inner) + bend * h * h
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn pose([X, Y, Z, B, C]: [f64; 5]) -> Pose {
        let mut pose = Pose::default();
        [(Axis::X, X), (Axis::Y, Y), (Axis::Z, Z), (Axis::B, B), (Axis::C, C)]
            .into_iter()
            .for_each(|(axis, value)| pose.set(axis, value));
        pose
    }

    #[test]
    fn of_a_quarter_turn_it_is_the_arc_and_not_the_chord() {
        let machine = TiltingTable { L: 100.0 };
        let (from, to) = (pose([25.0, 0.0, 0.0, 0.0, 0.0]), pose([25.0, 0.0, 0.0, 0.0, 90.0]));
        let arc = 25.0 * std::f64::consts::FRAC_PI_2;
        let found = longest(machine, &from, &to);
        assert!(arc <= found && found < arc * 1.001, "{found} {arc}");
        let straight = longest(machine, &from, &pose([22.0, 4.0, 0.0, 0.0, 0.0]));
        assert!((straight - 5.0).abs() < 1e-12, "{straight}");
    }

    proptest! {
        #[test]
        fn no_sum_of_chords_is_longer(
            from in [-60.0..60.0_f64, -60.0..60.0, -60.0..60.0, 0.0..90.0, -400.0..400.0],
            by in [-9.0..9.0_f64, -9.0..9.0, -9.0..9.0, -25.0..25.0, -40.0..40.0], L in 0.0..300.0_f64, whole in -3.0..3.0_f64,
        ) {
            let machine = TiltingTable { L };
            let to: [f64; 5] = std::array::from_fn(|axis| from[axis] + by[axis]);
            let tip = |s: f64| {
                let at: [f64; 5] = std::array::from_fn(|axis| from[axis] + by[axis] * s);
                machine.to_part(&Vector3::new(at[0], at[1], at[2]), at[3].to_radians(), at[4].to_radians())
            };
            let found = longest(machine, &pose(from), &pose(to));
            let chords: f64 =
                (0..10_000_u32).map(|k| (tip(f64::from(k + 1) / 1e4) - tip(f64::from(k) / 1e4)).norm()).sum();
            prop_assert!(chords <= found + 1e-5, "{chords} {found}");
            prop_assert!(found <= chords * 1.02 + 0.02, "{chords} {found}");
            // The same block wherever C stands.
            let turned = |mut at: [f64; 5]| {
                at[4] += whole.round() * 360.0;
                pose(at)
            };
            prop_assert!((longest(machine, &turned(from), &turned(to)) - found).abs() < 1e-4);
            let mut ways = Ways::new(machine);
            for _ in 0..2 {
                prop_assert_eq!(ways.longest(&pose(from), &pose(to)), found);
            }
        }
    }
}
