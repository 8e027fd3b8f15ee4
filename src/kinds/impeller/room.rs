//! From which point on a splitter's tool may stand at its full offset without cutting into the neighbouring blade.
//!
//! Where two tip paths w beside their mean lines cross, a tool on either of them is as near to the other's blade as to
//! its own, if both stand upright. That is the published rule: full offset from the crossing in plan on. The tools do not
//! stand upright, though. At the crossing the splitter's tool leans along its own N, the neighbour's flank along an N′
//! turned on about the axis, and the tips, one above the other in plan, differ in height. In the published case a tool at
//! full offset reaches 0.31 mm into the neighbour where the paths at +w cross, at 19.1, and is clear of it from 20.3 on;
//! at −w it reaches 0.53 mm into it at 28.6 and is clear from 31.5 on.
//!
//! # Derivation
//! So each side asks the solids themselves. Let c(x, m) be the least distance of the tool, a cylinder of diameter d_t
//! with a flat end, from the faces of the blades, in the pose that the control gives it at the index x, between the points
//! of the path with the offset w·f_j(m): X, Y, Z, B and C linear between them; it is bounded, not sampled
//! ([`clearance`](super::clearance)). Then m is the least index, not before the crossing in plan, with
//!
//! > c(x, m) ≥ ε for all 0 ≤ x ≤ n.
//!
//! A greater m lowers f_j at every point before it and leaves it at 1 past it: the tool moves towards the middle of the
//! channel, away from the neighbour on its side, and the other one is farther off. What is met by one m is met by all
//! greater ones, and the least is found by halving. There is none where the tool does not fit through the middle, or not
//! at the exit.
//!
//! The ways from the safe points to the path and back are the same whatever m is; they are left to the judge of the
//! finished program, which stops what is too narrow for them.
//!
//! ε is what rounding to the output grid may take: 0.0005 mm on each of X, Y, Z, and 0.0005° on B and C at the distance of
//! any point of the part from the pivot, L + R at most, and from the axis, R at most.
//!
//! # Units
//! Millimetres and radians; x in steps.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;

use crate::kinds::impeller::blade::Blade;
use crate::kinds::impeller::clearance::{Stand, Until, WORK, Walls};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::fade::fraction;
use crate::kinds::impeller::part::Part;
use crate::kinds::impeller::track::Track;

/// The channel that a splitter stands in, with its walls.
#[derive(Debug)]
pub struct Room<'a> {
    design: &'a Design,
    blade: &'a Blade,
    walls: Walls,
    /// ε, what rounding to the output grid may take, mm.
    least: f64,
}

impl<'a> Room<'a> {
    /// The channel between two blades of a design.
    #[must_use]
    pub fn new(design: &'a Design, blade: &'a Blade) -> Self {
        let pitch = TAU / f64::from(design.N);
        let turns = (0..design.N).map(|k| pitch * f64::from(k) + PI / f64::from(design.N)).collect();
        let walls = Walls::new(Part::new(design), design.machine, design.d_t / 2.0, turns, f64::MIN);
        Self { design, blade, walls, least: design.machine.rounding(design.torus.R) }
    }

    /// The least m from `from` on with which the tool of a splitter's track has room; `None` where there is none.
    #[must_use]
    pub fn least(&self, track: Track, from: usize) -> Option<usize> {
        let n = self.design.n;
        // Nearly always it is the first full offset that has no room, which one block tells.
        let beginning = least(from, n, |m| self.clear(track, m, [m.saturating_sub(1), m.max(1)]))?;
        least(beginning, n, |m| self.clear(track, m, [0, n]))
    }

    /// True where the tool is proved to keep clear of the blades from one point of a path to another.
    fn clear(&self, track: Track, m: usize, [first, last]: [usize; 2]) -> bool {
        let way: Vec<Stand> = (first..=last.min(self.design.n)).map(|j| self.stand(track, m, j)).collect();
        self.walls.clearance(&way, Until::Decided(self.least), WORK).lower >= self.least
    }

    /// Where the axes stand at the point j.
    fn stand(&self, track: Track, m: usize, j: usize) -> Stand {
        let (design, blade) = (self.design, self.blade);
        let offset = track.side() * design.w() * fraction(j, m);
        let at = blade.machine[j] + blade.b_machine * offset - Vector3::new(0.0, 0.0, design.a_p);
        Stand { at, B: blade.B[j], C: blade.C[j] }
    }
}

/// The least whole number from `from` to `to` for which something holds that holds for all greater ones.
fn least(from: usize, to: usize, holds: impl Fn(usize) -> bool) -> Option<usize> {
    if from > to {
        return None;
    }
    if holds(from) {
        return Some(from);
    }
    if !holds(to) {
        return None;
    }
    let (mut low, mut high) = (from + 1, to);
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    Some(high)
}
