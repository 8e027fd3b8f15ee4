//! What the passes leave standing in the channels: ribs between the two flanks.
//!
//! The plan cuts along both sides of each blade, and along both of a splitter. Where the channel is wider than that, metal
//! stays in between. What is measured is the turned surface between two blades: the share of its area that no pass takes away,
//! and how wide the widest rib is at the rim.
//!
//! # Derivation
//! Points of the surface are named by v and by x = u(v) − ψ, how far they lie behind the blade about the axis. The surface is
//! taken in strips of v. Over a strip a point of fixed x runs along a circle of radius R with R a radian, so that its distance
//! from the axis of a tool that stands still exceeds the greater of those at both ends by no more than R·Δv²/8. What is within
//! the radius with that, and above the tool's end by as much, is cut in the whole strip, whatever else cuts it too. What a pass
//! cuts reaches from the farthest of its poses on the one side to the farthest on the other, and is one piece where every pose
//! between them cuts the strip; where one does not, the pass is taken as cutting nothing there. So the area told is not less than
//! the true one. It is given as a share of the surface between two mean lines less e times the length of one.
//!
//! Beside a blade nothing is counted: the tool touches the face there. A grid of nodes comes out 0.1 to 0.4 % of the channel above:
//! it counts slivers of hundredths of a millimetre between the tool and an edge of the blade taken to the first order, and in full
//! the strips at the hub and at the rim, of which half lies on the part.
//!
//! # Units
//! Millimetres and radians.
//!
//! # Proof
//! Held against a dense grid.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::ops::Range;

use nalgebra::Vector3;
use rustc_hash::FxHashMap;

use crate::geometry::torus::Torus;
use crate::kinds::impeller::part::{HUB, Part, RIM};
use crate::kinds::impeller::sweep::Sweep;
use crate::kinds::impeller::track::Track;
use crate::number::trig::{atan2, sin_cos};

/// The steps along the blade, in radii of the tool.
const STEP: f64 = 0.1;

/// What Newton's last step may leave, mm.
const NEWTON: f64 = 1e-6;

/// Every so many strips the poses are looked through anew.
const FRESH: u16 = 16;

/// How many poses to either side are then tried for one that reaches the strip.
const SCAN: usize = 40;

/// Fewest and most strips.
const STRIPS: [f64; 2] = [48.0, 600.0];

/// What stays in a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ribs {
    /// The share of the channel's turned surface that is not cut: at most.
    pub share: f64,
    /// How wide the widest rib is at the rim, along the rim, mm: at most.
    pub width: f64,
    /// Where ribs begin: the part of the way from the hub to the rim.
    pub from: Option<f64>,
}

/// What the sweeps of a blade and its splitter leave in a channel between two of N blades.
#[must_use]
pub fn ribs(part: &Part, N: u32, d_t: f64, sweeps: &[Sweep]) -> Ribs {
    let a = d_t / 2.0;
    let torus = part.circle.torus;
    let pitch = TAU / f64::from(N);
    let strips = (torus.R * FRAC_PI_2 / (a * STEP)).ceil().clamp(STRIPS[0], STRIPS[1]);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held between two small counts")]
    let count = strips as u16;
    let step = FRAC_PI_2 / strips;
    let sin_alpha = torus.r / torus.R;
    let channel = torus.r * (pitch * (torus.R * FRAC_PI_2 - torus.r) - part.e * FRAC_PI_2 / sin_alpha);
    let bands: Vec<Band<'_>> = sweeps.iter().map(|sweep| Band::new(part, sweep, a, pitch)).collect();
    let (mut from, mut left) = (None, 0.0);
    let mut memos = vec![BandMemo::default(); bands.len()];
    let mut lines = [Parallel::new(part, HUB), Parallel::new(part, HUB)];
    for strip in 0..count {
        let v = [HUB + step * f64::from(strip), HUB + step * f64::from(strip + 1)];
        lines = [lines[1], Parallel::new(part, v[1])];
        let stands = standing(part, pitch, &bands, &lines, &mut memos, strip % FRESH == 0).0;
        if stands > 0.0 {
            from.get_or_insert(f64::from(strip) / strips);
        }
        // The area of the strip for each radian about the axis: ∫ρ·r dv.
        let [area_0, area_1] = v.map(|v| torus.r * (torus.R * v + torus.r * sin_cos(v).0));
        left += stands * (area_1 - area_0);
    }
    let share = if channel > 0.0 { (left / channel).clamp(0.0, 1.0) } else { 0.0 };
    let mut memos = vec![BandMemo::default(); bands.len()];
    let (_, widest) = standing(part, pitch, &bands, &[Parallel::new(part, RIM); 2], &mut memos, true);
    Ribs { share, width: widest * torus.R, from }
}

/// How much of x stands in a strip, all ribs together and the widest.
fn standing(
    part: &Part,
    pitch: f64,
    bands: &[Band<'_>],
    lines: &[Parallel; 2],
    memos: &mut [BandMemo],
    fresh: bool,
) -> (f64, f64) {
    let torus = part.circle.torus;
    // The blade's own edge; its half thickness lies across the mean line.
    let [one, other] = [&lines[0], &lines[1]].map(|line| part.e / 2.0 / (line.rho * torus.r / torus.R));
    let (near, far) = (one.min(other), pitch - one.min(other));
    // Blades so thick that they meet leave no channel here.
    if near >= far {
        return (0.0, 0.0);
    }
    let found: Vec<Option<[f64; 2]>> =
        bands.iter().zip(memos).map(|(band, memo)| band.cut(lines, memo, fresh)).collect();
    let of = |track: Track| bands.iter().zip(&found).find(|(band, _)| band.track == track).and_then(|(_, cut)| *cut);
    // The splitter itself, between the passes on both of its sides, is meant to stand.
    let splitter = of(Track::Out).zip(of(Track::Back)).map(|([_, low], [high, _])| [low, low.max(high)]);
    let mut cut: Vec<[f64; 2]> = found.iter().flatten().copied().chain(splitter).collect();
    cut.sort_by(|one, other| one[0].total_cmp(&other[0]));
    let (mut at, mut all, mut widest) = (near, 0.0_f64, 0.0_f64);
    for [low, high] in cut.into_iter().chain([[far, far]]) {
        let (low, high) = (low.clamp(near, far), high.clamp(near, far));
        if low > at {
            all += low - at;
            widest = widest.max(low - at);
        }
        at = at.max(high);
    }
    (all, widest)
}

/// A parallel of the turned surface.
#[derive(Clone, Copy)]
struct Parallel {
    v: f64,
    rho: f64,
    z: f64,
    u: f64,
}

impl Parallel {
    fn new(part: &Part, v: f64) -> Self {
        let torus = part.circle.torus;
        Self { v, rho: torus.rho(v), z: torus.r * sin_cos(v).0, u: part.circle.u(v.clamp(HUB, RIM)) }
    }
}

struct Pose {
    tip: Vector3<f64>,
    axis: Vector3<f64>,
    /// Where the axis comes out of the turned surface.
    v: f64,
    psi: f64,
    /// Sine and cosine of ψ.
    turned: (f64, f64),
}

impl Pose {
    /// `None` where the axis does not meet the surface.
    fn new(part: &Part, tip: Vector3<f64>, axis: Vector3<f64>) -> Option<Self> {
        let Torus { R, r } = part.circle.torus;
        let at = |up: f64| {
            let point = tip + axis * up;
            (point, (point.x * point.x + point.y * point.y).sqrt() - R)
        };
        // The axis stands nearly upright in the surface, so that what is missing to it is nearly the way.
        let mut up = 0.0;
        for _ in 0..20 {
            let (point, out) = at(up);
            up += (out * out + point.z * point.z).sqrt() - r;
        }
        let (point, out) = at(up);
        let v = atan2(point.z, out).rem_euclid(TAU);
        let met = ((out * out + point.z * point.z).sqrt() - r).abs() < 1e-6 * r;
        met.then(|| {
            let psi = atan2(point.y, point.x);
            Self { tip, axis, v, psi, turned: sin_cos(psi) }
        })
    }

    /// Of the point of a line beside the pose's own angle, by the sine and cosine of how far in x: the square of its distance
    /// from the axis, how that changes with x, and the height above the tip.
    fn apart(&self, line: &Parallel, (sin_x, cos_x): (f64, f64)) -> [f64; 3] {
        let (sin_psi, cos_psi) = self.turned;
        let (sin, cos) = (sin_psi * cos_x - cos_psi * sin_x, cos_psi * cos_x + sin_psi * sin_x);
        let from = Vector3::new(line.rho * cos, line.rho * sin, line.z) - self.tip;
        let up = from.dot(&self.axis);
        let across = from - self.axis * up;
        [across.norm_squared(), 2.0 * line.rho * (across.x * sin - across.y * cos), up]
    }
}

/// What is known of a band in the strip before.
#[derive(Clone)]
struct BandMemo {
    /// The poses that reached farthest.
    farthest: [usize; 2],
    /// Where poses end on both lines, by pose and side: the next strip begins with the second line.
    ends: [FxHashMap<(usize, bool), Option<f64>>; 2],
    /// The poses that are known to cut the second line.
    cutting: Range<usize>,
}

impl Default for BandMemo {
    fn default() -> Self {
        Self { farthest: [usize::MAX; 2], ends: Default::default(), cutting: 0..0 }
    }
}

/// What one pass cuts in the channel.
struct Band<'a> {
    part: &'a Part,
    a: f64,
    poses: Vec<Pose>,
    /// The pass is this far behind the blade at which the channel begins.
    behind: f64,
    track: Track,
    /// Which end of what it cuts is the face of the blade that it makes: there nothing is left.
    own: Option<usize>,
    /// What the tool may be off its poses.
    slack: f64,
}

impl<'a> Band<'a> {
    fn new(band: &'a Part, sweep: &Sweep, a: f64, pitch: f64) -> Self {
        let behind = match sweep.track {
            Track::Obverse => 0.0,
            Track::Reverse => pitch,
            Track::Out | Track::Back => pitch / 2.0,
        };
        let (mut poses, mut slack) = (Vec::new(), 0.0_f64);
        for (at, stretch) in sweep.stretches.iter().enumerate() {
            let pace = stretch.pace(sweep.height);
            let parts = (pace.speed / (a * STEP)).ceil().clamp(1.0, 4096.0);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "held between two small counts"
            )]
            let count = parts as u16;
            slack = slack.max(stretch.slack);
            for k in u16::from(at > 0)..=count {
                let part = f64::from(k) / parts;
                let (tip, axis) = stretch.tool(part);
                poses.extend(Pose::new(band, tip, axis));
            }
        }
        let own = match sweep.track {
            Track::Obverse => Some(0),
            Track::Reverse => Some(1),
            Track::Out | Track::Back => None,
        };
        Self { part: band, a, poses, behind, track: sweep.track, own, slack }
    }

    /// From where to where the pass cuts two lines and what is between them; `None` where it does not.
    fn cut(&self, lines: &[Parallel; 2], memo: &mut BandMemo, fresh: bool) -> Option<[f64; 2]> {
        let BandMemo { farthest, ends, cutting } = memo;
        let known = std::mem::take(cutting);
        let R = self.part.circle.torus.R;
        let step = lines[1].v - lines[0].v;
        // What the strip and the tool may be off the lines and the poses.
        let off = self.slack + R * step * step / 8.0 + NEWTON;
        let beside = self.poses.partition_point(|pose| pose.v < lines[0].v);
        ends.swap(0, 1);
        ends[1].clear();
        let (mut found, mut between) = ([0.0; 2], [0; 2]);
        for ((end, (found, guess)), between) in
            [-1.0, 1.0].into_iter().zip(found.iter_mut().zip(farthest)).zip(&mut between)
        {
            let mut reach = |at: usize| self.end(at, lines, ends, off, end);
            let mut climb = |start: usize| {
                let (mut at, mut best) = (start, reach(start)?);
                for way in [1_usize.wrapping_neg(), 1] {
                    loop {
                        let next = at.wrapping_add(way);
                        match reach(next) {
                            Some(farther) if (farther - best) * end > 0.0 => (best, at) = (farther, next),
                            _ => break,
                        }
                    }
                }
                Some((best, at))
            };
            // From the pose that reached farthest in the strip before; now and then also from the one beside this strip: the
            // run-in and the blade may each have a pose that reaches farther than its neighbours.
            let known = if fresh { None } else { climb(*guess) };
            let (best, at) = match known {
                Some(known) => known,
                // A tool that runs in beside a round hub stands clear of it for a while.
                None => {
                    [climb(*guess), (0..SCAN).flat_map(|k| [beside + k, beside.wrapping_sub(k)]).find_map(&mut climb)]
                        .into_iter()
                        .flatten()
                        .max_by(|(one, _), (other, _)| (one * end).total_cmp(&(other * end)))?
                }
            };
            (*found, *guess, *between) = (best, at, at);
        }
        let [one, other] = between;
        let between = one.min(other)..one.max(other) + 1;
        let cuts = |at: usize, line: &Parallel| self.beside(&self.poses[at], line, off).is_some();
        if !between.clone().all(|at| (known.contains(&at) || cuts(at, &lines[0])) && cuts(at, &lines[1])) {
            return None;
        }
        *cutting = between;
        let mut found = found.map(|x| x + self.behind);
        if let Some(own) = self.own {
            found[own] = if own == 0 { f64::NEG_INFINITY } else { f64::INFINITY };
        }
        Some(found)
    }

    /// How far a pose cuts both lines towards −x (`end` −1) or +x (1).
    fn end(
        &self,
        at: usize,
        lines: &[Parallel; 2],
        ends: &mut [FxHashMap<(usize, bool), Option<f64>>; 2],
        off: f64,
        end: f64,
    ) -> Option<f64> {
        let pose = self.poses.get(at)?;
        let mut on = |line: usize| {
            *ends[line].entry((at, end > 0.0)).or_insert_with(|| self.on_line(pose, &lines[line], off, end))
        };
        let (one, other) = (on(0)?, on(1)?);
        Some(if (one - other) * end < 0.0 { one } else { other })
    }

    /// The square of the distance of a pose from a line, if it cuts it at its own angle about the axis of the part: there the
    /// middle of the tool is nearest to the line.
    fn beside(&self, pose: &Pose, line: &Parallel, off: f64) -> Option<f64> {
        let [square, _, up] = pose.apart(line, (0.0, 1.0));
        let radius = self.a - off;
        (square <= radius * radius && up >= off).then_some(square)
    }

    /// The end of what a pose cuts on one line: where the distance from its axis is the radius, or the line falls away to the
    /// tool's end.
    fn on_line(&self, pose: &Pose, line: &Parallel, less: f64, end: f64) -> Option<f64> {
        let least = self.beside(pose, line, less)?;
        let radius = self.a - less;
        let off = |x: f64| {
            let [square, slope, up] = pose.apart(line, sin_cos(x));
            (square - radius * radius, slope, up - less)
        };
        // In x, from the angle of the pose on.
        let far = end * (1.5 * radius / line.rho).min(FRAC_PI_2);
        let (beyond, _, mut up) = off(far);
        let mut x = far;
        if beyond > 0.0 {
            let (mut inside, mut outside) = (0.0, x);
            // As if the square of the distance grew with the square of the way.
            let missing = radius * radius - least;
            x = far * (missing / (beyond + missing)).sqrt();
            for _ in 0..60 {
                let (above, slope, height) = off(x);
                up = height;
                if above > 0.0 {
                    outside = x
                } else {
                    inside = x
                }
                let step = above / slope;
                // A step that leaves what is known to hold the end is halved into it.
                let next = x - step;
                let held = (next - inside) * end > 0.0 && (outside - next) * end > 0.0;
                let next = if held { next } else { inside + (outside - inside) / 2.0 };
                let moved = (next - x).abs() * line.rho;
                x = next;
                if moved < 1e-9 {
                    break;
                }
            }
        }
        // Where the line falls away below the tool's end, it ends there.
        if up < 0.0 {
            let (mut over, mut below) = (0.0, x);
            for _ in 0..30 {
                let between = over + (below - over) / 2.0;
                if off(between).2 >= 0.0 { over = between } else { below = between }
            }
            x = over;
        }
        (x * end >= 0.0).then(|| remainder(line.u - pose.psi) + x)
    }
}

/// The angle, radians, turned by whole turns to between −π and π.
fn remainder(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
