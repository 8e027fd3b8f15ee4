//! A plan in the making: lanes, levels, contours and flanks, each placed and linked to the one before.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;
use rayon::prelude::*;

use crate::kinds::impeller::clear::body::{Body, Obstacles, turned};
use crate::kinds::impeller::clear::contact::{Contacts, slope};
use crate::kinds::impeller::clear::contour::{self, Contour};
use crate::kinds::impeller::clear::cut::{CutStrategy, Job, Spindle, Which};
use crate::kinds::impeller::clear::fit::FADES;
use crate::kinds::impeller::clear::flank::FlankWay;
use crate::kinds::impeller::clear::holder::Blank;
use crate::kinds::impeller::clear::lane::{OwnNormal, v_at};
use crate::kinds::impeller::clear::link::{End, link, up};
use crate::kinds::impeller::clear::pass::{Cutting, Direction, Mode, Move, Pass, SLOT_FEED};
use crate::kinds::impeller::clear::pieces::parts;
use crate::kinds::impeller::clear::placement::Tolerance;
use crate::kinds::impeller::clear::root::BESIDE;
use crate::kinds::impeller::clear::round::Round;
use crate::kinds::impeller::clear::scallop::{LAPPED, Ridge};
use crate::kinds::impeller::clear::told::{By, Dropped, ToolTold};
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::gap::over_tops;
use crate::kinds::impeller::nearest::Axis;
use crate::kinds::impeller::part::{Face, HUB, RIM};
use crate::kinds::impeller::solids::Stock;
use crate::limits::CLEAR_BLOCKS;
use crate::number::trig::{atan2, hypot, sin_cos};

/// Pairs of lanes that are looked at side by side.
const AHEAD: usize = 16;
/// Places along a face at which its error is looked at.
pub(super) const SAMPLES: u8 = 48;

/// A count of steps no longer than one, of a length that may be none.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held from 1 to 10⁶")]
pub(super) fn steps(length: f64) -> u32 {
    length.ceil().clamp(1.0, 1e6) as u32
}

/// The station at which lanes begin that are run from another one on: out of the hub where they go all the way.
pub(super) fn begin(from: f64) -> f64 {
    if from > 0.0 { from } else { f64::NEG_INFINITY }
}

/// The ridges that a tool leaves at a station.
pub(super) fn ridge(contacts: &Contacts, q: f64) -> Ridge {
    let tan = slope(contacts, 0.5, q);
    Ridge::at(&contacts.lane, v_at(q), tan / (1.0 + tan * tan).sqrt())
}

/// The steps between lanes that leave ridges no higher than c, and no strip between the ends of two neighbours.
fn ridges(contacts: &Contacts, c: f64) -> u32 {
    steps(contacts.greatest(|q| contacts.room(q) / ridge(contacts, q).turn(c)) - 1e-9)
}

/// The sine of the greatest angle of the lanes to the parallel at a station.
fn steepness(contacts: &Contacts, q: f64) -> f64 {
    let tan = [0.0, 0.5, 1.0].map(|lambda| slope(contacts, lambda, q).abs()).into_iter().fold(0.0, f64::max);
    if tan.is_finite() { tan / (1.0 + tan * tan).sqrt() } else { 1.0 }
}

/// How high above its tip a tool cuts on the way along a face, mm.
fn highest(way: &FlankWay) -> f64 {
    (0..=SAMPLES)
        .map(|look| way.beside(HUB + (RIM - HUB) * f64::from(look) / f64::from(SAMPLES)).range)
        .map(|[low, high]| high - low)
        .fold(0.0, f64::max)
}

/// The station of a tool's tip.
pub(super) fn station(tip: &Vector3<f64>, R: f64) -> f64 {
    let v = atan2(tip.z, hypot(tip.x, tip.y) - R);
    (if v < 0.0 { v + TAU } else { v } - HUB) / FRAC_PI_2
}

/// A plan in the making.
pub(super) struct Draft<'a> {
    pub(super) job: &'a Job,
    pub(super) cut: &'a CutStrategy,
    pub(super) pitch: f64,
    pub(super) v_s: Option<f64>,
    /// The station from which on the finishing tool cuts; 0 where it does all the way.
    pub(super) finish_from: f64,
    /// Those from which on it runs along obverse and reverse.
    pub(super) flanks_from: [f64; 2],
    pub(super) Z_r: f64,
    pub(super) passes: Vec<Pass>,
    /// How many blocks they take.
    pub(super) blocks: usize,
    /// Where the last pass has ended.
    pub(super) last: Option<End>,
    /// The last pass ended at the rim, not at the hub.
    pub(super) at_rim: bool,
    pub(super) dropped: Vec<Dropped>,
    pub(super) feed_error: [f64; 2],
}

/// Lanes that are run one after the other.
#[derive(Clone, Copy)]
struct Lanes {
    tool: Which,
    /// The steps between them.
    K: u32,
    /// What they leave on the walls.
    s: f64,
    roughing: bool,
    /// The station from which on they are run.
    from: f64,
}

/// A curve that passes are placed on.
struct PassCurve<F> {
    stand: F,
    /// Where its pieces end, from the hub to the rim.
    breaks: Vec<f64>,
    /// From where to where it is in the part.
    inside: [f64; 2],
    /// How high above its tip the tool cuts, mm.
    height: f64,
    /// v, radians, of a place along it.
    to_v: fn(f64) -> f64,
}

/// A pass to be placed.
pub(super) struct Wanted {
    pub(super) cutting: Cutting,
    pub(super) tool: Which,
    pub(super) direction: Direction,
    pub(super) mode: Mode,
    pub(super) feed: f64,
    pub(super) points: Vec<Stand>,
    /// It ends inside the part and goes back out along itself.
    pub(super) dead_end: bool,
    /// It begins and ends with run-outs of lanes.
    pub(super) on_lane: bool,
    /// A piece that comes from the rim alone goes into the full.
    pub(super) rim_slot: bool,
    /// Nothing of it is run before this station.
    pub(super) from: f64,
}

impl Wanted {
    /// A pass at the full feed that climbs, from end to end.
    pub(super) const fn new(cutting: Cutting, tool: Which, direction: Direction, points: Vec<Stand>) -> Self {
        Self {
            cutting,
            tool,
            direction,
            mode: Mode::Climb,
            feed: 1.0,
            points,
            dead_end: false,
            on_lane: false,
            rim_slot: false,
            from: f64::NEG_INFINITY,
        }
    }
}

impl Draft<'_> {
    /// True where no program may have so many blocks: the rest is not planned, the plan is refused.
    pub(super) fn full(&self) -> bool {
        self.blocks as u64 * u64::from(self.job.N) > 2 * CLEAR_BLOCKS
    }

    /// How many points a pass may have before that is so.
    pub(super) fn most(&self) -> usize {
        let most = 2 * CLEAR_BLOCKS / u64::from(self.job.N.max(1)) + 2;
        usize::try_from(most).unwrap_or(usize::MAX).saturating_sub(self.blocks).max(2)
    }

    /// How high above its tip an own-normal tool that goes so deep cuts.
    pub(super) fn height(&self, tool: Which, depth: f64) -> f64 {
        let part = &self.job.part;
        depth + over_tops(part.circle.torus.r, self.cut.tool(tool).a() + part.overhang())
    }

    pub(super) fn tolerance(&self, tool: Which, height: f64) -> Tolerance {
        Tolerance {
            machine: self.job.machine,
            epsilon: self.cut.tolerance,
            delta: self.cut.feed,
            height,
            tool: self.cut.tool(tool),
            torus: self.job.part.circle.torus,
        }
    }

    /// The way on which a tool climbs along the walls of one side.
    const fn climbing(&self, face: Face) -> Direction {
        match (face, self.cut.spindle) {
            (Face::Obverse, Spindle::Clockwise) | (Face::Reverse, Spindle::Counterclockwise) => Direction::Inwards,
            (Face::Reverse, Spindle::Clockwise) | (Face::Obverse, Spindle::Counterclockwise) => Direction::Outwards,
        }
    }

    pub(super) fn mode(&self, face: Face, direction: Direction) -> Mode {
        if direction == self.climbing(face) { Mode::Climb } else { Mode::Conventional }
    }

    pub(super) fn add(&mut self, wanted: Wanted) {
        let Wanted { cutting, tool, direction, mode, feed, points, dead_end, on_lane, .. } = wanted;
        let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return };
        let begin = End { at: first, run_out: on_lane };
        let approach = link(self.last, begin, self.Z_r);
        let mut leave = Vec::new();
        if dead_end {
            leave.extend(points.iter().rev().skip(1).map(|&to| Move { rapid: false, to }));
        }
        let end = if dead_end { begin } else { End { at: last, run_out: on_lane } };
        let of_tool = usize::from(tool == Which::Finish);
        let tolerance = self.tolerance(tool, self.job.part.a_p);
        let worst = points.windows(2).map(|pair| tolerance.feed_error([&pair[0], &pair[1]])).fold(0.0, f64::max);
        self.feed_error[of_tool] = self.feed_error[of_tool].max(worst);
        self.at_rim = match direction {
            Direction::Round => true,
            Direction::Inwards => dead_end,
            Direction::Outwards => !dead_end,
        };
        self.last = Some(end);
        let pass = Pass { cutting, tool, direction, mode, feed, approach, points, leave };
        self.blocks += pass.blocks();
        self.passes.push(pass);
    }

    /// The tool leaves the part.
    pub(super) fn done(&mut self) {
        if let (Some(end), Some(pass)) = (self.last.take(), self.passes.last_mut()) {
            pass.leave.push(up(end, self.Z_r));
        }
        self.at_rim = false;
    }

    /// Runs what is clear of a way; true where a piece of it begins at the rim and ends inside.
    fn run(&mut self, wanted: &Wanted, way: &PassCurve<impl Fn(f64) -> Stand>, kept: &[[f64; 2]], by: By) -> bool {
        if self.full() {
            return false;
        }
        let PassCurve { stand: way, breaks, inside, height, to_v } = way;
        let (inside, height) = (*inside, *height);
        let (Some(&begin), Some(&end)) = (breaks.first(), breaks.last()) else { return false };
        let tolerance = self.tolerance(wanted.tool, height);
        let mut from_rim = false;
        // What is run of it, or told apart.
        let mut run = Vec::new();
        for &[from, to] in kept {
            let (at_hub, at_rim) = (from <= begin, to >= end);
            let direction = match (at_hub, at_rim) {
                (true, true) => wanted.direction,
                (true, false) if to > inside[0] => Direction::Outwards,
                (false, true) if from < inside[1] => Direction::Inwards,
                (false, false) => {
                    self.leave_out(wanted, [from.max(inside[0]), to.min(inside[1])].map(*to_v), By::Ends);
                    run.push([from, to]);
                    continue;
                }
                // Outside of the part.
                (true, false) | (false, true) => continue,
            };
            run.push([from, to]);
            let mut pieces = vec![from];
            pieces.extend(breaks.iter().copied().filter(|&x| x > from && x < to));
            pieces.push(to);
            if direction == Direction::Inwards {
                pieces.reverse();
            }
            let slot = wanted.rim_slot && !at_hub;
            from_rim |= !at_hub;
            let (mode, feed) = match wanted.mode {
                _ if slot => (Mode::Slot, SLOT_FEED),
                Mode::Climb if direction != wanted.direction => (Mode::Conventional, wanted.feed),
                Mode::Conventional if direction != wanted.direction => (Mode::Climb, wanted.feed),
                mode => (mode, wanted.feed),
            };
            let placed = tolerance.place(way, &pieces, self.most());
            let points = placed.into_iter().map(|(_, stand)| stand).collect();
            self.add(Wanted { direction, mode, feed, points, dead_end: !(at_hub && at_rim), ..*wanted });
        }
        // What lies between, as far as it is in the part.
        let mut open = begin;
        for [from, to] in run.into_iter().chain([[end, end]]) {
            let gap = [open.max(inside[0]), from.min(inside[1])];
            self.leave_out(wanted, gap.map(*to_v), by);
            open = to;
        }
        from_rim
    }

    /// Keeps in mind that a stretch of a pass is not run, if it is one.
    fn leave_out(&mut self, &Wanted { cutting, tool, .. }: &Wanted, v: [f64; 2], by: By) {
        if v[1] > v[0] {
            self.dropped.push(Dropped { cutting, tool, v, by });
        }
    }

    /// From where to where a lane at the part λ of the way from obverse to reverse keeps clear of the splitter.
    fn clear_of_splitter(
        &self,
        contacts: &Contacts,
        lambda: f64,
        lanes: &Lanes,
        splitter: Option<&Body>,
    ) -> Vec<[f64; 2]> {
        let (lane, m) = (contacts.lane, self.cut.run_out(lanes.tool));
        let whole = [(-m).max(lanes.from), 1.0 + m];
        let Some(splitter) = splitter else { return vec![whole] };
        let room = lane.tool.a() + lanes.s;
        let reach = room + self.job.part.overhang();
        let inside: Vec<f64> = [0.0, 0.5, 1.0].into_iter().filter(|q| (whole[0]..whole[1]).contains(q)).collect();
        let ends: Vec<f64> = [whole[0]].into_iter().chain(inside).chain([whole[1]]).collect();
        // A half round on a twisted blade stands out of the faces by (e/2)(hτ)²/2: less than half of e/2.
        let torus = self.job.part.circle.torus;
        let nose = self.job.part.e / 4.0 / (torus.r / torus.R * (torus.R - torus.r));
        parts(&ends, |q| {
            let psi = contacts.psi(lambda, q);
            let [reverse, obverse] = contacts.beside_splitter(q);
            // Clear of a splitter as long as the blade, nose and all, or of the one that is there.
            psi >= reverse + nose || psi <= obverse - nose || splitter.keeps(&lane.axis(q, psi, reach), room)
        })
    }

    /// Runs what is kept of a lane at the part λ of the way from obverse to reverse.
    fn lane(&mut self, contacts: &Contacts, lambda: f64, kept: &[[f64; 2]], wanted: &Wanted) -> bool {
        let lane = contacts.lane;
        let (m, a) = (self.cut.run_out(wanted.tool), lane.tool.a());
        let flat = lane.tool.flat_radius();
        let mut breaks = vec![-m, -a, -flat, 0.0, 1.0, 1.0 + flat, 1.0 + a, 1.0 + m];
        breaks.dedup();
        let machine = self.job.machine;
        let way = |q: f64| lane.stand(machine, q, contacts.psi(lambda, q));
        let height = self.height(wanted.tool, lane.r_f - lane.torus.r);
        let way = PassCurve { stand: way, breaks, inside: [wanted.from.max(0.0), 1.0], height, to_v: v_at };
        self.run(wanted, &way, kept, By::Splitter)
    }

    /// All lanes of a channel, from the middle outwards, with s left on the walls; `from` a station on. Roughing goes into
    /// the full first.
    fn lanes(&mut self, contacts: &Contacts, lanes: &Lanes, cutting: impl Fn(u32) -> Cutting) {
        let Lanes { tool, K, s, roughing, from } = *lanes;
        let part = &self.job.part;
        let splitter = self.v_s.map(|v_s| Body::new(part, v_s, -self.pitch / 2.0, contacts.lane.tool.a() + s));
        let side = |j: u32| if 2 * j < K { Face::Obverse } else { Face::Reverse };
        let part_of = |j: u32| f64::from(j) / f64::from(K);
        let mut first = roughing;
        let mut open = [roughing; 2];
        let pair = |off: u32| if off == 0 { vec![K / 2] } else { vec![(K - off) / 2, K.midpoint(off)] };
        let pairs: Vec<u32> = (K % 2..=K).step_by(2).collect();
        for next in pairs.chunks(AHEAD) {
            // Looked at side by side before they are run; not all of them at once, as the plan may be full before.
            let look = |j: u32| (j, self.clear_of_splitter(contacts, part_of(j), lanes, splitter.as_ref()));
            let looked: Vec<Vec<(u32, Vec<[f64; 2]>)>> =
                next.par_iter().map(|&off| pair(off).into_iter().map(look).collect()).collect();
            for mut pair in looked {
                // Where the tool is decides which one of a pair comes first.
                if pair.len() == 2 && (self.climbing(side(pair[0].0)) == Direction::Inwards) != self.at_rim {
                    pair.reverse();
                }
                for (j, kept) in pair {
                    if self.full() {
                        return;
                    }
                    let direction = if 2 * j == K {
                        if self.at_rim { Direction::Inwards } else { Direction::Outwards }
                    } else {
                        self.climbing(side(j))
                    };
                    let mode = if first { Mode::Slot } else { self.mode(side(j), direction) };
                    let half = usize::from(side(j) == Face::Reverse);
                    let wanted = Wanted {
                        mode,
                        feed: if first { SLOT_FEED } else { 1.0 },
                        on_lane: true,
                        rim_slot: open[half],
                        from,
                        ..Wanted::new(cutting(j), tool, direction, Vec::new())
                    };
                    if self.lane(contacts, part_of(j), &kept, &wanted) {
                        open[half] = false;
                    }
                    first = false;
                }
            }
        }
    }

    /// Roughs a channel with one of the tools, from a station on; the steps between its lanes, and its levels.
    pub(super) fn rough(&mut self, contacts: &Contacts, tool: Which, from: f64) -> (u32, u32) {
        let (torus, mill, s) = (self.job.part.circle.torus, self.cut.tool(tool), self.cut.s);
        let sin_alpha = torus.r / torus.R;
        let along = |q: f64| contacts.room(q) * (torus.R + contacts.lane.below(q) * sin_cos(v_at(q)).1);
        let across = contacts.greatest(|q| along(q) * sin_alpha);
        // Deep down lanes cross the parallels more steeply than the tops do: there, too, the tool must reach from one to the next.
        let deep = contacts.greatest(|q| along(q) * steepness(contacts, q));
        let K = steps(across / (self.cut.step * mill.d)).max(steps(deep / (LAPPED * mill.d)));
        // A round end leaves ridges on the level: no more of them than there is to finish.
        let K = if mill.r_c > 0.0 { K.max(ridges(contacts, s.max(self.cut.scallop))) } else { K };
        let depth = contacts.lane.r_f - torus.r;
        if depth <= 0.0 {
            return (K, 0);
        }
        let levels = steps(depth / self.cut.level.unwrap_or(f64::INFINITY).min(mill.d / 2.0) - 1e-9);
        for level in 0..levels {
            if self.full() {
                break;
            }
            let deep = depth * f64::from(level + 1) / f64::from(levels);
            // Higher up the same lanes only touch less.
            let Some(lane) = OwnNormal::new(torus, mill, torus.r + deep) else { continue };
            let contacts = contacts.at_depth(lane);
            let lanes = Lanes { tool, K, s, roughing: true, from };
            self.lanes(&contacts, &lanes, |lane| match tool {
                Which::Rough => Cutting::Rough { level, lane },
                Which::Finish => Cutting::Rest { level, lane },
            });
            let contour = match tool {
                Which::Rough => Cutting::RoughContour { level },
                Which::Finish => Cutting::RestContour { level },
            };
            self.contour(&contacts, tool, s, contour);
        }
        (K, levels)
    }

    /// Cuts the floor; the steps between its lanes.
    pub(super) fn floor(&mut self, contacts: &Contacts) -> u32 {
        let K = ridges(contacts, self.cut.scallop);
        let lanes = Lanes { tool: Which::Finish, K, s: 0.0, roughing: false, from: begin(self.finish_from) };
        self.lanes(contacts, &lanes, |lane| Cutting::Floor { lane });
        K
    }

    /// The station from which on a roughing tool that has no room round the splitter may have left metal.
    pub(super) fn left_from(&self, v_s: f64) -> f64 {
        let reach = 2.0 * self.cut.rough.a() + self.cut.s + self.job.part.e / 2.0;
        (v_s - HUB - reach / self.job.part.circle.torus.r) / FRAC_PI_2
    }

    /// Goes round the splitter, where there is room for that.
    pub(super) fn contour(&mut self, contacts: &Contacts, tool: Which, s: f64, cutting: Cutting) {
        let Some(v_s) = self.v_s.filter(|_| !self.full()) else { return };
        let (part, m) = (&self.job.part, self.cut.run_out(tool));
        if contour::room(part, contacts, s, v_s) < 0.0 {
            self.dropped.push(Dropped { cutting, tool, v: [v_s, RIM], by: By::Blade });
            return;
        }
        let contour = Contour::new(part, contacts, s, v_s);
        let machine = self.job.machine;
        let height = self.height(tool, contacts.lane.r_f - contacts.lane.torus.r);
        self.go_round(cutting, tool, true, contour.pieces(m), height, |x| contour.stand(machine, x, m));
    }

    /// Runs the flanks of a blade along one face: the obverse of this channel's, the reverse of the next.
    pub(super) fn flanks(&mut self, ways: &[FlankWay]) {
        let a = self.cut.finish.a();
        let obstacles = Obstacles::new(&self.job.part, self.pitch, a, self.v_s);
        for (level, way) in (0..).zip(ways) {
            if self.full() {
                return;
            }
            let face = way.face();
            let (turn, from) = match face {
                Face::Obverse => (0.0, self.flanks_from[0]),
                Face::Reverse => (-self.pitch, self.flanks_from[1]),
            };
            let from_blade = |axis: &Axis| {
                let tip = axis.foot + axis.along * axis.range[0];
                let long = from <= 0.0 || station(&tip, self.job.part.circle.torus.R) >= from;
                long && match face {
                    Face::Obverse => obstacles.keeps_reverse(axis, a),
                    Face::Reverse => obstacles.keeps_obverse(axis, a),
                }
            };
            let axis = |v: f64| turned(&way.beside(v), turn);
            let fits = |v: f64| !(HUB..=RIM).contains(&v) || way.fits(v);
            let kept = parts(&way.v, |v| {
                let axis = axis(v);
                fits(v) && from_blade(&axis) && obstacles.keeps_splitter(&axis, a)
            });
            let whole = parts(&way.v, |v| fits(v) && from_blade(&axis(v))) == [way.v];
            let by = if whole { By::Splitter } else { By::Blade };
            self.flank(way, Cutting::Flank { face, level }, turn, way.v[0], &kept, by);
        }
    }

    /// Runs the flanks of the splitter and its nose.
    pub(super) fn splitter_flanks(&mut self, ways: &[Vec<FlankWay>; 2]) {
        let Some(v_s) = self.v_s else { return };
        let (machine, turn) = (self.job.machine, -self.pitch / 2.0);
        for (level, (obverse, reverse)) in (0..).zip(ways[0].iter().zip(&ways[1])) {
            if self.full() {
                return;
            }
            let round = Round::new(&self.job.part, self.cut, [obverse, reverse], v_s);
            let (cutting, tool) = (Cutting::SplitterFlanks { level }, Which::Finish);
            if !round.is_clear(self.pitch, turn) {
                self.dropped.push(Dropped { cutting, tool, v: [v_s, RIM], by: By::Blade });
                continue;
            }
            let height = highest(obverse).max(highest(reverse));
            self.go_round(cutting, tool, false, round.pieces(), height, |x| round.stand(machine, x, turn));
        }
    }

    /// A pass in along the obverse of the splitter and out along its reverse, or the other way with the other spindle.
    fn go_round(
        &mut self,
        cutting: Cutting,
        tool: Which,
        on_lane: bool,
        mut pieces: Vec<f64>,
        height: f64,
        way: impl Fn(f64) -> Stand,
    ) {
        if self.cut.spindle == Spindle::Counterclockwise {
            pieces.reverse();
        }
        let placed = self.tolerance(tool, height).place(&way, &pieces, self.most());
        let points = placed.into_iter().map(|(_, stand)| stand).collect();
        self.add(Wanted { on_lane, ..Wanted::new(cutting, tool, Direction::Round, points) });
    }

    fn flank(&mut self, way: &FlankWay, cutting: Cutting, turn: f64, from: f64, kept: &[[f64; 2]], by: By) {
        let machine = self.job.machine;
        let direction = self.climbing(way.face());
        let wanted = Wanted::new(cutting, Which::Finish, direction, Vec::new());
        // A splitter's way has no open end at the hub.
        let begin = if from > HUB { f64::NEG_INFINITY } else { from };
        let mut breaks = vec![begin];
        breaks.extend([HUB, RIM - FADES[0], RIM - FADES[1], RIM].into_iter().filter(|&v| v > from));
        breaks.push(way.v[1]);
        let way = PassCurve {
            stand: |v| way.stand(machine, v, turn),
            breaks,
            inside: [from.max(HUB), RIM],
            height: highest(way),
            to_v: |v| v,
        };
        self.run(&wanted, &way, kept, by);
    }

    /// From which distance to the faces on a rest counts as one on the floor.
    pub(super) fn beside(&self) -> f64 {
        BESIDE + self.cut.finish.r_c
    }

    /// The turned blank on the machine.
    pub(super) fn blank(&self) -> Blank {
        let stock = Stock { torus: self.job.part.circle.torus, length: self.cut.blank };
        Blank { stock, L: self.job.machine.L }
    }

    pub(super) fn tool(&self, which: Which, lane: &OwnNormal, lanes: u32, levels: u32) -> ToolTold {
        let (r, r_t) = (lane.torus.r, lane.below(0.0));
        let passes = self.passes.iter().filter(|pass| pass.tool == which).map(|pass| pass.points.as_slice());
        ToolTold {
            t: r_t - r,
            lanes,
            levels,
            stick_out: self.blank().highest(passes) + self.cut.d_s,
            feed_error: self.feed_error[usize::from(which == Which::Finish)],
        }
    }
}
