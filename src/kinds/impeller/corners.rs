//! What is known at the corners of a cell of time and of a face: rulings seen from the tool's tip, and the least of what lies between
//! them; see [`clearance`](super::clearance).

use nalgebra::Vector3;

use crate::kinds::impeller::limit::Limit;
use crate::kinds::impeller::part::Ruling;
use crate::machine::rotary::Turned;
use crate::number::{greater, lesser};

/// A ruling steeper than this against the end's plane is not clipped by a limit of h.
pub const STEEP: f64 = 0.02;

/// The least of the straight line from `one` to `other` less k·s(1 − s)/2.
#[inline]
fn sagging(one: f64, other: f64, k: f64) -> f64 {
    let rise = (other - one).abs();
    if 2.0 * rise >= k { lesser(one, other) } else { (one + other) / 2.0 - k / 8.0 - rise * rise / (2.0 * k) }
}

/// The least of distances that are known at the corners of a cell, by time and v, along either of which they change by no more than
/// `speeds` and bend by no more than `bends`; and how far they may sag in time and in v.
#[inline]
#[must_use]
pub fn least_between(d: &[[f64; 2]; 2], speeds: [f64; 2], bends: [f64; 2]) -> (f64, [f64; 2]) {
    let nearest = lesser(lesser(d[0][0], d[0][1]), lesser(d[1][0], d[1][1]));
    let mut bound = greater(0.0, nearest - (speeds[0] + speeds[1]) / 2.0);
    let (mut k, mut before) = ([0.0; 2], 0.0);
    for _ in 0..3 {
        if bound > before {
            before = bound;
            k = [speeds[0] * speeds[0] / bound + bends[0], speeds[1] * speeds[1] / bound + bends[1]];
            let first = sagging(sagging(d[0][0], d[0][1], k[1]), sagging(d[1][0], d[1][1], k[1]), k[0]);
            let other = sagging(sagging(d[0][0], d[1][0], k[0]), sagging(d[0][1], d[1][1], k[0]), k[1]);
            bound = greater(greater(bound, first), other);
        }
    }
    (bound, k)
}

/// Rulings at the corners of a cell, by time and v.
pub type Rulings = [[Ruling; 2]; 2];

/// Two rulings seen from the tip at two times: by the axes turned to the tool at both, and its tip there and the rulings, all from
/// the pivot.
#[inline]
#[must_use]
pub fn from_tip(turned: [&Turned; 2], tips: &[Vector3<f64>; 2], rulings: &[Ruling; 2]) -> Rulings {
    let see = |time: usize, v: usize| {
        let Ruling { foot, N } = &rulings[v];
        Ruling { foot: turned[time].direction(foot) - tips[time], N: turned[time].direction(N) }
    };
    [[see(0, 0), see(0, 1)], [see(1, 0), see(1, 1)]]
}

/// How rulings that are seen from the tip stand at the corners of a cell.
#[derive(Debug)]
pub struct Corners<'a> {
    seen: &'a Rulings,
    /// No point of them is farther from the tip.
    pub far: f64,
    /// How far they reach above the plane of the tool's end.
    pub highest: f64,
    /// The least that one of them rises with its h, or falls.
    least: f64,
    /// The first of them falls with its h.
    upright: bool,
    /// All of them do as the first.
    alike: bool,
}

/// What the plane of the tool's end leaves of the rulings.
#[derive(Debug)]
pub enum Clip {
    /// Nothing counts above this h.
    Above(Limit),
    /// Nothing counts below it.
    Below(Limit),
}

impl<'a> Corners<'a> {
    /// `beyond` is as far as limits of h may run, and `counts` from and to which h they may count.
    #[inline]
    #[must_use]
    pub fn new(seen: &'a Rulings, beyond: [f64; 2], counts: [f64; 2]) -> Self {
        let (mut far, mut highest, mut least) = (0.0_f64, f64::MIN, f64::INFINITY);
        let upright = seen[0][0].N.z > 0.0;
        let mut alike = true;
        for ruling in [&seen[0][0], &seen[0][1], &seen[1][0], &seen[1][1]] {
            far = greater(far, ruling.at(beyond[0]).norm_squared());
            far = greater(far, ruling.at(beyond[1]).norm_squared());
            let (foot, slope) = (ruling.foot.z, ruling.N.z);
            highest = greater(greater(highest, foot - slope * counts[0]), foot - slope * counts[1]);
            least = lesser(least, slope.abs());
            alike &= (slope > 0.0) == upright;
        }
        Self { seen, far: far.sqrt(), highest, least, upright, alike }
    }

    /// What the plane of the tool's end leaves, where no ruling is too steep against it. `turn` is the most that they turn against it
    /// over the cell, and `out` how far beyond the limit a point may be that counts, by the limit's changes in time and in v.
    #[inline]
    pub fn end(&self, turn: f64, out: impl FnOnce([f64; 2]) -> f64) -> Option<Clip> {
        let least = self.least - turn / 2.0;
        if least <= STEEP || !self.alike {
            return None;
        }
        let end = |ruling: &Ruling| ruling.foot.z / ruling.N.z;
        let seen = self.seen;
        let limit = Limit::through([[end(&seen[0][0]), end(&seen[0][1])], [end(&seen[1][0]), end(&seen[1][1])]]);
        let out = out(limit.changes);
        Some(if self.upright { Clip::Above(limit.moved(out / least)) } else { Clip::Below(limit.moved(-out / least)) })
    }
}
