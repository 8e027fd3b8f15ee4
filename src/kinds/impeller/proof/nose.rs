//! Clearance to the half round with which a splitter begins: a lower and an upper bound, never a sample.
//!
//! # Derivation
//! The half round is that half of the cylinder of radius e/2 about the ruling at v_s which lies on the side of −t. Where a
//! tool's axis is on the other side, the edge of the half round is nearest to it, and that is a ruling of a face. So at each
//! depth h of the ruling the axis counts only on the side of −t, both where it is nearest to the ruling and where it goes
//! through the plane across it. The distance of the axis from the ruling less e/2 is then no more than that from the half
//! round, and as much where both are parallel.
//!
//! Points of the half round are up to (e/2)·sin β higher over the tool's end than those of the ruling, β being the angle
//! between axis and ruling: the end is taken as much lower.
//!
//! Over a piece of a stretch no point of the axis moves farther than V·Δs; the limits of h are moved out by as much, and the
//! distance in the middle less V·Δs/2 holds for all of it. Pieces that may be the least are halved.
//!
//! # Units
//! Millimetres and radians.

use nalgebra::Vector3;

use crate::kinds::impeller::clear::body::turn;
use crate::kinds::impeller::clearance::{Bounds, Place};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::part::Part;
use crate::kinds::impeller::sweep::Stretch;

/// How often a stretch is halved at most.
const HALVINGS: u8 = 24;
/// A ruling no steeper than this against the end's plane is level.
const LEVEL: f64 = 1e-6;
/// What the arithmetic may lose, mm.
const ARITHMETIC: f64 = 1e-9;

/// The half round of the splitter of blade 0, and the tool that is to keep clear of it.
#[derive(Clone, Copy, Debug)]
pub struct Nose {
    v_s: f64,
    P: Vector3<f64>,
    N: Vector3<f64>,
    t: Vector3<f64>,
    /// e/2, the radius of the half round, mm.
    half: f64,
    /// The tool's radius.
    a: f64,
    /// The depths between which it stands.
    depths: [f64; 2],
}

impl Nose {
    /// The half round of a design's splitters at v_s, for a tool of the radius a.
    #[must_use]
    pub fn new(design: &Design, v_s: f64, a: f64) -> Self {
        let part = Part::new(design);
        let (P, frame) = part.frame(v_s);
        let [top, bottom] = part.noses_ends(v_s);
        Self { v_s, P, N: frame.N, t: frame.t, half: part.e / 2.0, a, depths: [top, bottom.max(part.a_p)] }
    }

    /// How far above its tip a tool may meet it.
    #[must_use]
    pub fn reach(&self) -> f64 {
        2.0 * (self.depths[1] - self.depths[0]) + self.half + self.a
    }

    /// How far the tool goes on each of some stretches, up to where it may meet it.
    #[must_use]
    pub fn ways(&self, stretches: &[Stretch]) -> Vec<f64> {
        let way = |stretch: &Stretch| {
            let pace = stretch.pace(self.reach());
            pace.speed + pace.turn * self.reach()
        };
        stretches.iter().map(way).collect()
    }

    /// The clearance along some stretches, with [`ways`](Self::ways) along them, it being turned about the axis of the part:
    /// not looked at closer where it is `enough`, else to `close`. `None` where it is never beside the tool.
    #[must_use]
    pub fn clearance(
        &self,
        (stretches, ways): (&[Stretch], &[f64]),
        turned: f64,
        [enough, close]: [f64; 2],
    ) -> Option<Bounds> {
        let mut seen = (f64::INFINITY, None);
        let mut least = f64::INFINITY;
        let mut work = 0;
        let about = turn(-turned);
        let mut left: Vec<(&Stretch, f64, [f64; 2], u8)> =
            stretches.iter().zip(ways).map(|(stretch, &way)| (stretch, way, [0.0, 1.0], HALVINGS)).collect();
        while let Some((stretch, way, [from, to], halvings)) = left.pop() {
            work += 1;
            let middle = f64::midpoint(from, to);
            let out = way * (to - from) / 2.0 + stretch.slack;
            let (tip, axis) = stretch.tool(middle);
            let (tip, axis) = (about(&tip), about(&axis));
            let found = self.apart(&tip, &axis, 0.0);
            if found < seen.0 {
                seen = (found, Some(Place { along: (stretch.index(middle) + 1.0).max(0.0), v: self.v_s }));
            }
            let bound = self.apart(&tip, &axis, out) - out - ARITHMETIC;
            if bound >= enough || bound >= seen.0 - close || halvings == 0 {
                least = least.min(bound);
            } else {
                left.push((stretch, way, [from, middle], halvings - 1));
                left.push((stretch, way, [middle, to], halvings - 1));
            }
        }
        (least < f64::INFINITY).then_some(Bounds { lower: least.min(seen.0), upper: seen.0, place: seen.1, work })
    }

    /// How far a tool is from it, limits moved out; infinite where it is on the other side.
    fn apart(&self, tip: &Vector3<f64>, axis: &Vector3<f64>, out: f64) -> f64 {
        let from = self.P - tip;
        let (along, up) = (self.N.dot(axis), from.dot(axis));
        let lean = (1.0 - along * along).max(0.0).sqrt();
        let end = out + self.half * lean;
        let [mut top, mut bottom] = self.depths;
        // Above the end: up − h·along ≥ −end. On the other side of the part the ruling stands the other way.
        if along > LEVEL {
            bottom = bottom.min((up + end) / along);
        } else if along < -LEVEL {
            top = top.max((up + end) / along);
        } else if up + end + self.reach() * LEVEL < 0.0 {
            return f64::INFINITY;
        }
        let (first, second) = (from - axis * up, self.N - axis * along);
        let (ahead, slope) = (-self.t.dot(&from), self.t.dot(axis));
        // On the side of −t: ahead + height·slope ≤ out, the height being that of the axis nearest to the ruling, up −
        // h·along, or that at which it goes through the plane across it, (N·from − h)/along.
        let through = if along.abs() > LEVEL { (self.N.dot(&from) / along, 1.0 / along) } else { (up, along) };
        [(up, along), through]
            .into_iter()
            .map(|(height, fall)| {
                let (constant, linear) = (ahead + height * slope - out, -fall * slope);
                let (mut low, mut high) = (top, bottom);
                if linear > 1e-12 {
                    high = high.min(-constant / linear);
                } else if linear < -1e-12 {
                    low = low.max(-constant / linear);
                } else if constant > 0.0 {
                    return f64::INFINITY;
                }
                if low > high {
                    return f64::INFINITY;
                }
                let square = second.norm_squared();
                let h = if square > 0.0 { (first.dot(&second) / square).clamp(low, high) } else { low };
                (first - second * h).norm() - self.half - self.a
            })
            .fold(f64::INFINITY, f64::min)
    }
}
