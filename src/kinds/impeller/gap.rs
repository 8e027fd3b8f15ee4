//! The true gap between two blades: the largest tool that passes between them, and the limits that follow from it.
//!
//! # Derivation
//! The published limits take the arc along the parallel at the hub for the gap. That is not how a tool passes: it stands in
//! the channel with its axis through the circle in the middle of the tube, blades cross the parallels at a slant, and they
//! are twisted. So the gap is
//!
//! > gap = 2·min over the stations of max over ψ of min(D_o, D_r),
//!
//! with D the least distance of the axis, from the tip to as high as metal stands beside it, from the obverse of one blade and from
//! the reverse of the next. The tip stands as deep as the floor lets the tool whose radius is half the gap:
//! t* = √(r_f² − a²) − r with r_f = r + a_p. A station is a part of the way from the hub to the rim, or, where it is
//! negative, a run-out of the tool out of the hub plane in radii of the design's tool; while its end still reaches into the
//! blank, the tip sinks with the floor. Faces go straight on beyond their ends and are not cut off there.
//!
//! One blade alone is taken for one of two, which leave less.
//!
//! Limits are those of the design's own tool: it is a gap at the depth of its tip that must be a third wider than it.
//!
//! Stations are close to each other at the hub, where the gap is the least. About the least of them it is followed between
//! them to its bottom, by parabolas.
//!
//! # Units
//! Millimetres and radians.
//!
//! # Proof
//! Held against a dense search.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::blade_count::{N_max, e_max, least_gap};
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::nearest::{Axis, Wall};
use crate::kinds::impeller::part::{Face, HUB, Part};
use crate::number::trig::sin_cos;

/// How far out of the hub plane the gap is looked at, in radii of the tool.
pub const RUN_OUT: f64 = 0.4;
/// Where the gap is looked at, from the hub (0) to the rim (1); negative: run out of the hub plane, in radii of the tool.
const STATIONS: [f64; 15] = [-RUN_OUT, -0.2, 0.0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.75, 1.0];

/// Most rounds in which depth and height of the axis follow the tool. Each takes the difference to about a tenth, or, of a
/// tool nearly as wide as the tube, to a half.
const ROUNDS: usize = 30;

/// How high above its tops the metal beside an axis is looked at in any case, mm.
const ABOVE: f64 = 0.3;

/// How high above the tops at its foot metal stands within a distance from an axis that passes the middle of a tube of the
/// radius r: what is metal is r from there at least.
#[must_use]
pub fn over_tops(r: f64, reach: f64) -> f64 {
    (r - (r * r - reach * reach).max(0.0).sqrt()).max(ABOVE)
}

/// A distance is that of the nearest valley to this, mm.
const SAME: f64 = 1e-6;

/// Between stations the gap is followed down to this, mm, in at most so many steps.
const BOTTOM: f64 = 1e-4;
const STEPS: u32 = 20;

/// The gap, and where it is the least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The diameter of the largest tool that passes, mm; 0 where none does.
    pub width: f64,
    /// Where: the part of the way from the hub to the rim.
    pub station: f64,
}

/// What the true gap leaves room for, by the rule that it must be a third wider than the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The gap of the design: the largest tool that passes.
    pub gap: Gap,
    /// What it must be: 4/3·d_t.
    pub least: f64,
    /// The gap at the depth of the design's own tool, which is what the rule is asked of, mm.
    pub beside: f64,
    /// The greatest number of blades of this thickness; `None` where not even one has its gap.
    pub N_max: Option<u32>,
    /// The greatest thickness of this many blades; `None` where even blades without thickness leave too little.
    pub e_max: Option<f64>,
}

impl Limits {
    /// The limits of a design, with its roughing tool.
    #[must_use]
    pub fn new(design: &Design) -> Self {
        Self::of(&Part::new(design), design.N, design.d_t)
    }

    /// The limits of N blades of a part with a tool of the diameter d_t.
    #[must_use]
    pub fn of(part: &Part, count: u32, d_t: f64) -> Self {
        let (torus, e, a_p) = (part.circle.torus, part.e, part.a_p);
        let part = &evenly_deep(torus, e, a_p);
        let least = least_gap(d_t);
        let mut near = stations();
        let own = Channel::new(part, count, d_t);
        let beside = own.least(&own.wall(), &mut near);
        // Thickness changes the widths of all stations alike.
        let spare = |e: f64| {
            let part = evenly_deep(torus, e, a_p);
            let channel = Channel::new(&part, count, d_t);
            channel.least(&channel.wall(), &mut near.clone()).width - least
        };
        let fits = |N: u32| {
            if N == count && beside.width < least {
                return false;
            }
            let channel = Channel::new(part, N, d_t);
            let wall = channel.wall();
            // Where this many are too near to each other, they mostly are at the hub.
            near.iter().all(|&(mut station)| channel.width_at(&wall, &mut station) >= least)
                && (N == count || channel.least(&wall, &mut stations()).width >= least)
        };
        // The gap is narrower than the arc on the parallel, so that the published limits are upper bounds.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held within the form's limits")]
        let most = N_max(torus, a_p, e, d_t).clamp(0.0, 1e6) as u32;
        let (gap, (N_max, e_max)) = rayon::join(
            || passing(own, beside, near.clone()),
            || rayon::join(|| greatest(most, fits), || thickest(e_max(torus, a_p, count, d_t), spare)),
        );
        Self { gap, least, beside: beside.width, N_max, e_max }
    }
}

/// The part of the limits: all of its rulings end where those between the ends of the blade do at most, at the depth
/// a_p + (e/2)²/(2(R − r − a_p)). On the straight ends of a thick blade they go deeper.
fn evenly_deep(torus: Torus, e: f64, a_p: f64) -> Part {
    Part::with(torus, e, a_p).ending_at(a_p + e * e / 8.0 / (torus.R - torus.r - a_p))
}

/// The greatest whole number from 1 to `most` for which something holds that holds for all smaller ones.
fn greatest(most: u32, holds: impl Fn(u32) -> bool) -> Option<u32> {
    let (mut low, mut high) = (0, most);
    while low < high {
        let middle = low + (high - low).div_ceil(2);
        if holds(middle) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    (low > 0).then_some(low)
}

/// The greatest thickness up to `most` that leaves `spare` not negative, rounded down to 10⁻⁵ mm or less.
fn thickest(most: f64, spare: impl Fn(f64) -> f64) -> Option<f64> {
    if most <= 0.0 {
        return None;
    }
    let mut low = (0.0, spare(0.0));
    if low.1 < 0.0 {
        return None;
    }
    let mut high = (most, spare(most));
    if high.1 >= 0.0 {
        return Some(most);
    }
    for _ in 0..30 {
        if high.0 - low.0 < 1e-5 {
            break;
        }
        // The gap falls nearly evenly with e: a little to both sides of the chord's root brackets it closely.
        let root = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
        let aside = (high.0 - low.0) * 1e-3;
        for e in [root - aside, root + aside] {
            if e > low.0 && e < high.0 {
                let spare = spare(e);
                if spare >= 0.0 {
                    low = (e, spare);
                } else {
                    high = (e, spare);
                }
            }
        }
    }
    Some(low.0)
}

/// The gap between neighbouring ones of N blades: the largest tool that passes, sought from the diameter d_t on.
#[must_use]
pub fn gap(part: &Part, N: u32, d_t: f64) -> Gap {
    let channel = Channel::new(part, N, d_t);
    let mut near = stations();
    let least = channel.least(&channel.wall(), &mut near);
    passing(channel, least, near)
}

/// The largest tool that passes a channel, from what passes beside the channel's own: its depth follows the tool's.
fn passing(mut channel: Channel<'_>, mut least: Gap, mut near: Vec<Station>) -> Gap {
    // Between a tool that passes and one that does not.
    let (mut low, mut high) = (0.0, f64::INFINITY);
    let mut before: Option<(f64, f64)> = None;
    for _ in 1..ROUNDS {
        let over = least.width / 2.0 - channel.a;
        if over.abs() < 1e-7 {
            // A station that was left out may have become the least on the way.
            if near.len() == STATIONS.len() {
                return least;
            }
            near = stations();
            let all = channel.least(&channel.wall(), &mut near);
            if all.width > least.width - BOTTOM {
                return least;
            }
            (least, near) = (all, stations());
            (low, before) = (0.0, None);
            continue;
        }
        if over > 0.0 {
            low = channel.a;
        } else {
            high = channel.a;
        }
        // The first step by what is missing, then by the secant.
        let slope = before.map_or(-1.0, |(a, at)| (over - at) / (channel.a - a));
        before = Some((channel.a, over));
        let next = channel.a - over / slope.min(-1e-3);
        channel.a = if next > low && next < high { next } else { f64::midpoint(low, high.min(2.0 * channel.a)) };
        least = channel.least(&channel.wall(), &mut near);
    }
    Gap { width: least.width.min(2.0 * channel.a), ..least }
}

/// A place where the gap is looked at.
#[derive(Clone, Copy, Debug)]
struct Station {
    /// Its place in [`STATIONS`].
    at: usize,
    /// What passed there last: of another tool, thickness or number of blades it is near.
    last: Option<Passing>,
}

/// The ψ of the largest tool that passes, and the v of obverse and reverse that are nearest to it.
type Passing = (f64, [f64; 2]);

fn stations() -> Vec<Station> {
    (0..STATIONS.len()).map(|at| Station { at, last: None }).collect()
}

/// A channel between the obverse of a blade and the reverse of the next, with the tool that is to pass.
struct Channel<'a> {
    part: &'a Part,
    pitch: f64,
    /// The tool's radius.
    a: f64,
    /// What a run-out beyond the hub is counted in, mm: the tool's radius.
    run_out: f64,
}

impl<'a> Channel<'a> {
    fn new(part: &'a Part, N: u32, d_t: f64) -> Self {
        // One blade alone leaves more than two do, but its face, gone on straight past the hub, comes round to its own back.
        Self { part, pitch: TAU / f64::from(N.max(2)), a: d_t / 2.0, run_out: d_t / 2.0 }
    }

    /// The least width over stations and between them. Those that are far above it are left out: what is not the least for
    /// one depth of the tip is not for another.
    fn least(&self, wall: &Wall, stations: &mut Vec<Station>) -> Gap {
        let widths: Vec<f64> = stations.iter_mut().map(|station| self.width_at(wall, station)).collect();
        let Some(least) = (0..widths.len()).min_by(|&one, &other| widths[one].total_cmp(&widths[other])) else {
            return Gap { width: 0.0, station: 0.0 };
        };
        let Station { at, mut last } = stations[least];
        let (mut q, mut width) = (STATIONS[at], widths[least]);
        if at > 0 && at + 1 < STATIONS.len() {
            let beside = [at - 1, at + 1].map(|at| match stations.iter().position(|one| one.at == at) {
                Some(one) => (STATIONS[at], widths[one]),
                None => (STATIONS[at], self.width(wall, STATIONS[at], &mut None)),
            });
            (q, width) = bottom([beside[0], (q, width), beside[1]], |q| self.width(wall, q, &mut last));
        }
        let mut widths = widths.into_iter();
        stations.retain(|_| widths.next().is_some_and(|one| one <= 1.2 * width + 0.1));
        Gap { width, station: q.max(0.0) }
    }

    /// The faces beside the tool.
    fn wall(&self) -> Wall {
        Wall::new(self.part, self.a)
    }

    /// The diameter of the tool that fits at a station.
    fn width_at(&self, wall: &Wall, station: &mut Station) -> f64 {
        self.width(wall, STATIONS[station.at], &mut station.last)
    }

    /// The diameter of the tool that fits at a part of the way, with its [`Passing`] there or near it.
    fn width(&self, wall: &Wall, q: f64, last: &mut Option<Passing>) -> f64 {
        let torus = self.part.circle.torus;
        let out = (-q).max(0.0) * self.run_out;
        let v = HUB + q.max(0.0) * FRAC_PI_2;
        let rho = torus.rho(v);
        let sin_alpha = torus.r / torus.R;
        let u = self.part.circle.u(v);
        let within = self.part.e / (2.0 * rho * sin_alpha);
        let between = [u - self.pitch + within, u - within];
        if between[0] >= between[1] {
            return 0.0;
        }
        let axis = self.axis(v, out);
        let seen = |psi: f64, guess: [Option<f64>; 2]| {
            [
                wall.nearest(Face::Obverse, &axis(psi), guess[0]),
                wall.nearest(Face::Reverse, &axis(psi + self.pitch), guess[1]),
            ]
        };
        // Beside both faces, each of which it leaves and nears by about as much.
        let slope = -2.0 * rho * sin_alpha;
        let start = last.map_or(f64::midpoint(between[0], between[1]), |(psi, _)| psi);
        // A face may have two valleys under the axis: what was found in one must be the least of both.
        let mut guess = last.map_or([None; 2], |(_, feet)| feet.map(Some));
        let (mut found, mut psi) = widest(between, start, slope, |psi| {
            let both = seen(psi, guess);
            guess = both.map(|(_, at)| Some(at));
            both.map(|(distance, _)| distance)
        });
        let mut both = seen(psi, [None; 2]);
        if both[0].0.min(both[1].0) <= found - SAME {
            (found, psi) = widest(between, psi, slope, |psi| {
                both = seen(psi, [None; 2]);
                both.map(|(distance, _)| distance)
            });
        }
        *last = Some((psi, both.map(|(_, at)| at)));
        2.0 * found
    }

    /// The axis of the tool at v, run out of the hub plane, by ψ.
    fn axis(&self, v: f64, out: f64) -> impl Fn(f64) -> Axis {
        let torus = self.part.circle.torus;
        let (sin_v, cos_v) = sin_cos(v);
        let rho = torus.R + torus.r * cos_v;
        let (r_f, reach) = (torus.r + self.part.a_p, (self.a - out).max(0.0));
        let depth = (r_f * r_f - reach * reach).max(0.0).sqrt() - torus.r;
        let range = [-depth, over_tops(torus.r, self.a + self.part.overhang()).max(-depth)];
        move |psi| {
            let (sin, cos) = sin_cos(psi);
            Axis {
                foot: Vector3::new(rho * cos, rho * sin, torus.r * sin_v + out),
                along: -Vector3::new(cos_v * cos, cos_v * sin, sin_v),
                range,
            }
        }
    }
}

/// The greatest over ψ, between two of them, of the lesser of the distances from obverse and reverse, and the ψ; sought from
/// a ψ on, where their difference falls with about this slope. It falls from the reverse of the next blade, where it is
/// positive, to the obverse.
fn widest(
    [mut low, mut high]: [f64; 2],
    start: f64,
    mut slope: f64,
    mut both: impl FnMut(f64) -> [f64; 2],
) -> (f64, f64) {
    let inside = |psi: f64, low: f64, high: f64| if psi > low && psi < high { psi } else { f64::midpoint(low, high) };
    let mut psi = inside(start, low, high);
    let mut found = (0.0, psi);
    let mut before: Option<(f64, f64)> = None;
    for step in 0..60 {
        let [obverse, reverse] = both(psi);
        if obverse.min(reverse) > found.0 {
            found = (obverse.min(reverse), psi);
        }
        let off = obverse - reverse;
        if off.abs() < 1e-8 || high - low < 1e-12 {
            break;
        }
        if off > 0.0 {
            low = psi;
        } else {
            high = psi;
        }
        if let Some((psi_before, off_before)) = before {
            let secant = (off - off_before) / (psi - psi_before);
            if secant < 0.0 {
                slope = secant;
            }
        }
        before = Some((psi, off));
        // Where it bends, the secant may come near from one side only.
        let next = if step % 8 == 7 { f64::midpoint(low, high) } else { psi - off / slope };
        psi = inside(next, low, high);
    }
    found
}

/// The bottom between three places of which the middle one is the lowest, each with its height: by parabolas, until neither
/// these nor the middles of both sides lead more than [`BOTTOM`] lower.
fn bottom(mut three: [(f64, f64); 3], mut value: impl FnMut(f64) -> f64) -> (f64, f64) {
    let mut aside = 0;
    for _ in 0..STEPS {
        let [(x_0, y_0), (x_1, y_1), (x_2, y_2)] = three;
        let (left, right) = ((y_0 - y_1) / (x_1 - x_0), (y_2 - y_1) / (x_2 - x_1));
        // Of the parabola through all three: slope at the middle, and half the bend.
        let bend = (left + right) / (x_2 - x_0);
        let at = (right * (x_1 - x_0) - left * (x_2 - x_1)) / (x_2 - x_0);
        let x = if at * at > 4.0 * bend * BOTTOM {
            x_1 - at / (2.0 * bend)
        } else if aside == 2 {
            break;
        } else if x_2 - x_1 > x_1 - x_0 {
            aside += 1;
            f64::midpoint(x_1, x_2)
        } else {
            aside += 1;
            f64::midpoint(x_0, x_1)
        };
        let new = (x, value(x));
        if new.1 < y_1 - BOTTOM {
            aside = 0;
        }
        three = match (new.1 < y_1, x < x_1) {
            (true, true) => [three[0], new, three[1]],
            (true, false) => [three[1], new, three[2]],
            (false, true) => [new, three[1], three[2]],
            (false, false) => [three[0], three[1], new],
        };
    }
    three[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Check designs: R, r, N, e, a_p, d_t.
    const DESIGNS: [(f64, f64, u32, f64, f64, f64); 3] =
        [(25.0, 15.0, 4, 2.0, 2.0, 6.0), (25.0, 17.0, 2, 1.0, 4.0, 6.0), (50.0, 30.0, 5, 2.0, 3.0, 6.0)];

    #[test]
    fn at_the_stations_gaps_are_those_of_the_check_values_and_between_them_a_little_less() {
        // The check values were found at stations, on rulings some tenths of a millimetre apart.
        for ((R, r, N, e, a_p, d_t), check) in DESIGNS.into_iter().zip([6.900_679, 10.043_482, 12.418_203]) {
            let part = evenly_deep(Torus { R, r }, e, a_p);
            let channel = Channel { a: check / 2.0, ..Channel::new(&part, N, d_t) };
            let wall = channel.wall();
            let widths = stations().into_iter().map(|mut station| channel.width_at(&wall, &mut station));
            let least = widths.fold(f64::INFINITY, f64::min);
            assert!((least - check).abs() < 0.0015, "{least} {check}");
            let found = gap(&part, N, d_t).width;
            assert!(found < least + 1e-4 && found > least - 0.01, "{found} {least}");
        }
    }

    #[test]
    fn a_bottom_is_found_where_it_is_round_and_where_it_is_sharp() {
        for at in (1..20).map(|step| 0.05 * f64::from(step)) {
            let round = |x: f64| (x - at) * (x - at) * (1.0 + x);
            let sharp = |x: f64| (x - at).max((at - x) * 4.0);
            let kinked = |x: f64| round(x) + (x - 0.5).max(0.0);
            for value in [&round as &dyn Fn(f64) -> f64, &sharp, &kinked] {
                let (x, y) = bottom([0.0, at * 0.9, 1.0].map(|x| (x, value(x))), value);
                assert!(y < value(at) + 1e-2, "{at} {x} {y}");
            }
        }
    }

    #[test]
    fn where_even_blades_without_thickness_are_too_near_there_is_no_greatest_thickness() {
        assert_eq!(thickest(-2.415, |_| 1.0), None);
        assert_eq!(thickest(2.0, |e| -0.5 - e), None);
        assert_eq!(thickest(2.0, |e| 3.0 - e), Some(2.0));
        assert!((thickest(2.0, |e| 1.25 - e).unwrap() - 1.25).abs() < 1e-4);
        let part = Part::with(Torus { R: 25.0, r: 17.0 }, 1.0, 4.0);
        assert_eq!(gap(&part, 1, 6.0), gap(&part, 2, 6.0));
        assert_eq!(greatest(5, |_| false), None);
        assert_eq!(greatest(0, |_| true), None);
    }
}
