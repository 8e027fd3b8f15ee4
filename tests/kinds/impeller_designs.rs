//! Designs by chance: the true gap and the limits that follow from it against a dense search, and the clear cut of each
//! against the simulator of [`impeller_swept`](super::impeller_swept). Nothing of the search uses the geometry of the gap.
//!
//! `RODETE_DESIGNS=1000` takes so many designs, `RODETE_DESIGNS_FROM=200` others than the first; `RODETE_DESIGNS_GRID=4` takes
//! the grids that many times as fine.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};

use rayon::prelude::*;
use rodete::kinds::impeller::clear::cut::{CutStrategy, DoesNotFit, Spindle, Which};
use rodete::kinds::impeller::clear::plan::Plan;
use rodete::kinds::impeller::clear::programs::position;
use rodete::kinds::impeller::clearance::{Until, WORK, Walls};
use rodete::kinds::impeller::design::Design as Asked;
use rodete::kinds::impeller::floor_depth::within;
use rodete::kinds::impeller::gap::{Limits, gap};
use rodete::kinds::impeller::sweep::Sweep;
use rodete::number::trig::{atan2, cos, sin};
use rodete::parameter::Value;

use super::impeller_swept::{Design, Point, STEP, add, dot, norm, simulate, turned};
use crate::common;

/// How many designs.
const DESIGNS: u32 = 200;
/// By how much the dense search may differ from the gap, mm: its rulings are some tenths of a millimetre apart, and its
/// stations are not all places.
const COARSE: f64 = 0.04;
/// The widest tool that is drawn, in radii of the tube.
const WIDE: f64 = 1.6;
/// What a gap or a refusal begins with that is stricter than the search finds.
const STRICT: &str = "too strict: ";
/// What the judges admit beside the tolerance, mm.
const OVER: f64 = 0.001;

fn from_environment(name: &str, usual: u32) -> u32 {
    std::env::var(name).map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{name}={text}")))
}

/// Numbers by chance.
struct Chance(u64);

impl Chance {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn one_of<T: Copy, const K: usize>(&mut self, of: [T; K]) -> T {
        // Each in its turn, so that all are as likely.
        let mut left = of.len();
        let mut all = of.into_iter();
        loop {
            let one = all.next().expect("one of some");
            if left == 1 || self.between(0.0, left as f64) < 1.0 {
                return one;
            }
            left -= 1;
        }
    }

    fn one_in(&mut self, of: u32) -> bool {
        self.between(0.0, f64::from(of)) < 1.0
    }
}

/// The least distance between two stretches, given by a point, a direction of unit length and the range along it.
fn apart([p, d]: [Point; 2], from: [f64; 2], [q, e]: [Point; 2], to: [f64; 2]) -> f64 {
    let w = add(p, q, -1.0);
    let (b, c, f) = (dot(d, e), dot(d, w), dot(e, w));
    let square = 1.0 - b * b;
    let at_s = |s: f64| {
        let t = (b * s + f).clamp(to[0], to[1]);
        norm(add(add(w, d, s), e, -t))
    };
    let at_t = |t: f64| {
        let s = (b * t - c).clamp(from[0], from[1]);
        norm(add(add(w, d, s), e, -t))
    };
    let free = if square > 1e-12 { ((b * f - c) / square).clamp(from[0], from[1]) } else { from[0] };
    [at_s(free), at_s(from[0]), at_s(from[1]), at_t(to[0]), at_t(to[1])].into_iter().fold(f64::INFINITY, f64::min)
}

/// A ruling: its foot, its direction into the depth, and the depths at which it begins and ends.
struct Ruling {
    line: [Point; 2],
    depths: [f64; 2],
}

impl Ruling {
    fn middle(&self) -> Point {
        add(self.line[0], self.line[1], f64::midpoint(self.depths[0], self.depths[1]))
    }
}

/// How many neighbouring rulings are passed over at once where none can be the nearest.
const BUNCH: usize = 8;

/// Rulings that follow each other, in a ball.
struct Bunch {
    centre: Point,
    radius: f64,
    rulings: Vec<Ruling>,
}

impl Bunch {
    fn all(rulings: Vec<Ruling>) -> Vec<Self> {
        let mut rulings = rulings.into_iter();
        let next = || {
            let rulings: Vec<Ruling> = rulings.by_ref().take(BUNCH).collect();
            let centre = rulings.get(rulings.len() / 2)?.middle();
            let far = |one: &Ruling| norm(add(one.middle(), centre, -1.0)) + (one.depths[1] - one.depths[0]) / 2.0;
            let radius = rulings.iter().map(far).fold(0.0, f64::max);
            Some(Self { centre, radius, rulings })
        };
        std::iter::from_fn(next).collect()
    }
}

/// Where rulings end.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Edge {
    /// At the floor, and as deep as at the blank's edge beyond that.
    Floor,
    /// All at the depth that the gap is defined with.
    Even,
}

/// The rulings of both faces of blade 0, straight on beyond its ends and not cut off there, from the turned surface on.
struct Rulings {
    design: Design,
    /// Obverse and reverse.
    faces: [Vec<Bunch>; 2],
}

impl Rulings {
    fn new(design: &Design, edge: Edge, a: f64, grid: u32) -> Self {
        let Design { R, r, e, a_p, .. } = *design;
        let (sin_a, cos_a) = (r / R, (1.0 - (r / R).powi(2)).sqrt());
        let beyond = ((e / 2.0 + a) * cos_a / sin_a + a / sin_a + 0.5) / R;
        let count = 260 * grid;
        let depth = |x: Point| ((x[0].hypot(x[1]) - R).powi(2) + x[2] * x[2]).sqrt() - r;
        let face = |side: f64| {
            let ruling = |v: f64| {
                let [P, _, b, N] = design.frame(v);
                let line = [add(P, b, side * e / 2.0), N.map(|x| -x)];
                let cos_v = cos(v.clamp(PI, 1.5 * PI));
                let across = cos_a * cos_a / r + sin_a * sin_a * cos_v / (R + r * cos_v);
                let top = -e * e / 8.0 * across;
                if edge == Edge::Even {
                    return Ruling { line, depths: [top, a_p + e * e / 8.0 / (R - r - a_p)] };
                }
                // Where it first comes to the floor.
                let at = |h: f64| depth(add(line[0], line[1], h));
                let mut low = top;
                while at(low + 0.05) < a_p && low < 2.0 * R {
                    low += 0.05;
                }
                let mut high = low + 0.05;
                for _ in 0..20 {
                    let middle = f64::midpoint(low, high);
                    if at(middle) < a_p { low = middle } else { high = middle }
                }
                Ruling { line, depths: [top, low] }
            };
            let mut rulings: Vec<Ruling> = (0..=count)
                .map(|k| ruling(PI - beyond + (FRAC_PI_2 + 2.0 * beyond) * f64::from(k) / f64::from(count)))
                .collect();
            if edge == Edge::Even {
                return rulings;
            }
            let inside = |one: &Ruling| {
                let x = add(one.line[0], one.line[1], one.depths[0]);
                x[2] <= 0.0 && x[0].hypot(x[1]) <= R
            };
            let ends = [rulings.iter().position(inside), rulings.iter().rposition(inside)].map(Option::unwrap);
            let deep = ends.map(|end| rulings[end].depths[1]);
            rulings[..ends[0]].iter_mut().for_each(|one| one.depths[1] = deep[0]);
            rulings[ends[1]..].iter_mut().for_each(|one| one.depths[1] = deep[1]);
            rulings
        };
        Self { design: *design, faces: [1.0, -1.0].map(|side| Bunch::all(face(side))) }
    }

    /// The least distance of an axis from the obverse, and from the reverse of the next blade.
    fn from(&self, axis: [Point; 2], range: [f64; 2]) -> [f64; 2] {
        let pitch = self.design.pitch();
        let next = axis.map(|x| turned(x, pitch));
        let least = |axis: [Point; 2], face: &[Bunch]| {
            let middle = add(axis[0], axis[1], f64::midpoint(range[0], range[1]));
            // Stretches are no nearer than their middles less half of both lengths.
            let half = (range[1] - range[0]) / 2.0;
            let from = |bunch: &Bunch| norm(add(bunch.centre, middle, -1.0)) - bunch.radius - half;
            let mut bunches: Vec<(f64, &Bunch)> = face.iter().map(|bunch| (from(bunch), bunch)).collect();
            // With a near one first, most of the others are passed over.
            let near = (0..bunches.len()).min_by(|one, other| bunches[*one].0.total_cmp(&bunches[*other].0));
            bunches.swap(0, near.expect("rulings"));
            bunches.into_iter().fold(f64::INFINITY, |least: f64, (from, bunch)| {
                let nearer = |least: f64, one: &Ruling| {
                    let between = norm(add(one.middle(), middle, -1.0)) - (one.depths[1] - one.depths[0]) / 2.0 - half;
                    if between >= least { least } else { least.min(apart(axis, range, one.line, one.depths)) }
                };
                if from >= least { least } else { bunch.rulings.iter().fold(least, nearer) }
            })
        };
        [least(axis, &self.faces[0]), least(next, &self.faces[1])]
    }
}

/// The width of the channel at a station for a tool of the radius a, by trying many ψ.
fn width(rulings: &Rulings, q: f64, a: f64) -> f64 {
    let design = &rulings.design;
    let Design { R, r, a_p, .. } = *design;
    let (v, out) = (PI + q.max(0.0) * FRAC_PI_2, (-q).max(0.0));
    let rho = R + r * cos(v);
    let u = atan2(-(r + R * cos(v)), (R * R - r * r).sqrt() * sin(v));
    let u = if u < 0.0 { u + 2.0 * PI } else { u };
    let r_f = r + a_p;
    let depth = (r_f * r_f - (a - out).max(0.0).powi(2)).max(0.0).sqrt() - r;
    let least = |psi: f64| {
        let foot = [rho * cos(psi), rho * sin(psi), r * sin(v) + out];
        let along = [-cos(v) * cos(psi), -cos(v) * sin(psi), -sin(v)];
        let [obverse, reverse] =
            rulings.from([foot, along], [-depth, (r - (r * r - a * a).max(0.0).sqrt()).max(0.3).max(-depth)]);
        obverse.min(reverse)
    };
    // Between the two blades: inside one of them the distance from its face says nothing.
    let within = design.e / 2.0 / (rho * r / R);
    let pitch = design.pitch() - 2.0 * within;
    if pitch <= 0.0 {
        return 0.0;
    }
    let tries = 28;
    let place = |k: u32| u - within - pitch * (f64::from(k) + 0.5) / f64::from(tries);
    let tried: Vec<f64> = (0..tries).map(|k| least(place(k))).collect();
    let best = tried.iter().fold(0.0, |best: f64, one| best.max(*one));
    let step = pitch / f64::from(tries);
    let (first, last) = (place(tries - 1) - step / 2.0, place(0) + step / 2.0);
    // There may be more than one summit, and the highest may be sharp.
    let at = |k: usize| tried.get(k).copied().unwrap_or(0.0);
    let summit = |k: &u32| {
        let here = at(*k as usize);
        here >= 0.9 * best && here >= at((*k as usize).wrapping_sub(1)) && here >= at(*k as usize + 1)
    };
    let climbed = (0..tries).filter(summit).map(|k| {
        let (mut low, mut high) = ((place(k) - step).max(first), (place(k) + step).min(last));
        for _ in 0..18 {
            let (one, two) = (low + (high - low) * 0.382, low + (high - low) * 0.618);
            if least(one) < least(two) { low = one } else { high = two }
        }
        least(f64::midpoint(low, high))
    });
    2.0 * climbed.fold(best, f64::max)
}

/// Stations at which the gap is asked for: a search elsewhere alone would pass a sharp least place by.
const STATIONS: [f64; 11] = [0.025, 0.05, 0.075, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.75, 0.9];

/// The least width over stations for a tool of the diameter d, run out in radii of the diameter d_t.
fn dense(design: &Design, edge: Edge, d: f64, d_t: f64, grid: u32) -> f64 {
    let (a, rulings) = (d / 2.0, Rulings::new(design, edge, d.max(d_t) / 2.0, grid));
    let run_outs = [-0.2 * d_t, -0.1 * d_t];
    let count = 8 * grid;
    let inside = (0..=count).map(|k| (f64::from(k) / f64::from(count)).powi(2)).chain(STATIONS);
    let mut places: Vec<f64> = run_outs.into_iter().chain(inside).collect();
    places.sort_by(f64::total_cmp);
    let widths: Vec<f64> = places.iter().map(|&q| width(&rulings, q, a)).collect();
    let least = (0..widths.len()).min_by(|&one, &two| widths[one].total_cmp(&widths[two])).unwrap();
    // About the least of them, where it may be sharp.
    let [low, high] = [least.saturating_sub(1), (least + 1).min(places.len() - 1)].map(|at| places[at]);
    (1..8).map(|k| low + (high - low) * f64::from(k) / 8.0).map(|q| width(&rulings, q, a)).fold(widths[least], f64::min)
}

/// The largest tool that passes: its own width at its own depth.
fn largest(design: &Design, d_t: f64, grid: u32) -> f64 {
    let (mut d, mut low, mut high) = (d_t, 0.0_f64, 1.9 * (design.r + design.a_p));
    for _ in 0..6 {
        let next = dense(design, Edge::Even, d, d_t, grid);
        if (next - d).abs() < 0.003 {
            return next;
        }
        if next > d {
            low = low.max(d)
        } else {
            high = high.min(d)
        }
        d = if next > low && next < high { next } else { f64::midpoint(low, high) };
    }
    d
}

/// A design by chance, and how it is to be cut: its tools by what the dense search finds room for.
pub fn drawn(number: u32) -> (Design, CutStrategy) {
    let mut chance = Chance(u64::from(number) * 7_919 + 42);
    loop {
        let R = chance.between(18.0, 80.0);
        let r = R * chance.between(0.3, 0.8);
        let N = chance.one_of([2, 3, 4, 5, 6, 7]);
        let deep = if chance.one_in(3) { [0.2, 0.4] } else { [0.05, 0.18] };
        let a_p = (R - r) * chance.between(deep[0], deep[1]);
        let design = Design { R, r, N, e: chance.between(0.6, 3.2), a_p };
        if !(0.6..12.0).contains(&a_p) {
            continue;
        }
        let room = largest(&design, 0.3 * r, 1);
        let s = chance.one_of([0.0, 0.2, 0.3, 0.5]);
        // Most tools fit.
        let rough = (room - 2.0 * s) * chance.between(0.3, 1.12);
        if !(1.2..16.0).contains(&rough) || rough > WIDE * r || s >= a_p {
            continue;
        }
        let finish = if chance.one_in(2) { rough } else { rough * chance.between(0.4, 1.0) };
        let tolerance = chance.between(0.02, 0.06);
        let cut = CutStrategy {
            s,
            tolerance,
            scallop: chance.between(0.1, 0.5),
            step: chance.between(0.5, 0.9),
            spindle: if chance.one_in(2) { Spindle::Clockwise } else { Spindle::Counterclockwise },
            splitters: chance.one_in(4),
            d_s: chance.between(1.0, 5.0),
            ..CutStrategy::usual(rough, finish)
        };
        return (design, cut);
    }
}

/// What is wrong with a refusal.
fn refusal(design: &Design, cut: &CutStrategy, refused: &DoesNotFit, grid: u32) -> Vec<String> {
    let mut wrong = Vec::new();
    let (s, tool) = (cut.allowance(refused.tool), cut.tool(refused.tool));
    // The depth of roughing stays s above the floor.
    let depth = if refused.tool == Which::Rough { design.a_p - cut.s } else { design.a_p };
    let shallow = Design { a_p: depth, ..*design };
    let room = |d: f64| dense(&shallow, Edge::Floor, d, d, grid) - 2.0 * s - d;
    if tool.d < 1.8 * (design.r + depth) && room(tool.d) > COARSE {
        wrong.push(format!("{STRICT}{refused:?} but {} is free", room(tool.d)));
    }
    if let Some(largest) = refused.largest {
        let (at, beyond) = (room(largest), room(largest + 0.06));
        if at < -COARSE {
            wrong.push(format!("{refused:?}: room {at}"));
        } else if beyond > COARSE {
            wrong.push(format!("{STRICT}{refused:?}: room {at} and at 0.06 more {beyond}"));
        }
    }
    wrong
}

/// By what the judges of its programs would stop a plan: then no program is written.
fn stopped(design: &Design, cut: &CutStrategy, plan: &Plan) -> Option<&'static str> {
    let job = design.job();
    let turns: Vec<f64> = (0..design.N).map(|k| design.pitch() * f64::from(k)).collect();
    let limit = cut.tolerance + OVER;
    for pass in &plan.passes {
        let tool = cut.tool(pass.tool);
        let d = tool.d;
        let walls = Walls::new(job.part, job.machine, d / 2.0, turns.clone(), f64::MIN);
        if walls.clearance(&pass.points, Until::Decided(-limit), WORK).lower < -limit {
            return Some("cuts into a face");
        }
        let positions: Vec<_> = pass.points.iter().map(|at| position(at).unwrap()).collect();
        let sweep = Sweep::through(0, job.machine, &positions, 0.0);
        let limit = limit + job.machine.rounding(design.R);
        if within(job.part.circle.torus, design.a_p, tool, &[sweep], limit).is_some_and(|found| found.most > limit) {
            return Some("goes below the floor");
        }
    }
    None
}

/// What is wrong with a plan.
fn plan(design: &Design, cut: &CutStrategy, plan: &Plan, grid: u32) -> Vec<String> {
    let mut wrong = Vec::new();
    for which in [Which::Rough, Which::Finish] {
        let (s, d) = (cut.allowance(which), cut.tool(which).d);
        let depth = if which == Which::Rough { design.a_p - cut.s } else { design.a_p };
        let room = dense(&Design { a_p: depth, ..*design }, Edge::Floor, d, d, grid) - 2.0 * s - d;
        if room < -COARSE {
            wrong.push(format!("{which:?} is wider than the gap by {room}"));
        }
    }
    let found = simulate(design, plan, cut, [10 * grid, 3 * grid], [8 * grid, 16 * grid]);
    let told = &plan.told;
    let most = cut.tolerance + OVER + design.job().machine.rounding(design.R);
    if found.undercut > most || found.too_deep > most || found.tops > 1e-9 {
        wrong.push(format!("cut into: {found:?}"));
    }
    // Above the corner no more is left than is told.
    let cusp = STEP * STEP / (4.0 * cut.finish.d);
    if found.face_rest > told.root.above + OVER + cusp {
        wrong.push(format!("left on a face: {found:?} {:?}", told.root));
    }
    // The rest of the floor is told as found on a grid, so it is only about that.
    if told.dropped.is_empty() && found.floor_rest > 1.15 * told.floor.most + cut.tolerance {
        wrong.push(format!("left on the floor: {found:?} {:?}", told.floor));
    }
    wrong
}

/// What is wrong with the gap and with the limits of the form.
fn limits(design: &Design, d_t: f64, grid: u32) -> Vec<String> {
    let mut wrong = Vec::new();
    let part = design.job().part.ending_at(design.a_p + design.e * design.e / 8.0 / (design.R - design.r - design.a_p));
    // The tool that just passes is wider than the gap by as little as it is narrower.
    let found = gap(&part, design.N, d_t).width;
    let room = |d: f64| dense(design, Edge::Even, d, d_t, grid) - d;
    let [at, beyond] = [found - COARSE, found + COARSE].map(room);
    if at < 0.0 {
        wrong.push(format!("gap {found}: room {at}"));
    } else if beyond > 0.0 {
        wrong.push(format!("{STRICT}gap {found}: room {beyond}"));
    }
    let real = Value::Real;
    let asked = Asked::new(&common::fields(
        "full",
        &[
            ("R", real(design.R)),
            ("r", real(design.r)),
            ("N", Value::Whole(design.N)),
            ("e", real(design.e)),
            ("a_p", real(design.a_p)),
            ("d_t", real(d_t)),
            ("L_b", real(design.r + design.a_p + 30.0)),
        ],
    ));
    let Ok(asked) = asked else { return wrong };
    let told = Limits::new(&asked);
    let room = |design: Design| dense(&design, Edge::Even, d_t, d_t, grid) - told.least;
    if let Some(N) = told.N_max.filter(|&N| N >= 2) {
        let (at, beyond) = (room(Design { N, ..*design }), room(Design { N: N + 1, ..*design }));
        if at < -COARSE || beyond > COARSE {
            wrong.push(format!("N_max {N}: {at}, then {beyond}"));
        }
    }
    if let Some(e) = told.e_max {
        let at = room(Design { e, ..*design });
        if at.abs() > COARSE {
            wrong.push(format!("e_max {e}: {at}"));
        }
    }
    wrong
}

#[test]
fn designs_by_chance_are_cut_as_told_and_have_the_gaps_that_a_dense_search_finds() {
    let (count, grid) = (from_environment("RODETE_DESIGNS", DESIGNS), from_environment("RODETE_DESIGNS_GRID", 1));
    let first = from_environment("RODETE_DESIGNS_FROM", 0);
    let judged: Vec<(Option<String>, Vec<String>)> = (first..first + count)
        .into_par_iter()
        .map(|number| {
            let (design, cut) = drawn(number);
            let mut wrong = limits(&design, cut.rough.d, grid);
            let why = match Plan::new(&design.job(), &cut) {
                Ok(made) if made.told.no_splitter.is_some() => Some("no room for a splitter".to_owned()),
                Ok(made) => match stopped(&design, &cut, &made) {
                    Some(why) => Some(why.to_owned()),
                    None => {
                        wrong.extend(plan(&design, &cut, &made, grid));
                        None
                    }
                },
                Err(refused) => {
                    wrong.extend(refusal(&design, &cut, &refused, grid));
                    Some(format!("{:?} does not fit", refused.tool))
                }
            };
            let told =
                |what: String| format!("{number} {design:?} {:.3} {:.3} s {} {what}", cut.rough.d, cut.finish.d, cut.s);
            (why, wrong.into_iter().map(told).collect())
        })
        .collect();
    let (strict, wrong): (Vec<&String>, Vec<&String>) =
        judged.iter().flat_map(|one| &one.1).partition(|one| one.contains(STRICT));
    println!("{} too kind, {} too strict, of {count}", wrong.len(), strict.len());
    let mut refused: BTreeMap<&str, usize> = BTreeMap::new();
    for why in judged.iter().filter_map(|one| one.0.as_deref()) {
        *refused.entry(why).or_default() += 1;
    }
    println!("{count} designs, refused: {refused:?}");
    let all: String = wrong.iter().chain(&strict).map(|one| format!("{one}\n")).collect();
    assert!(all.is_empty(), "{} too kind, {} too strict of {count}:\n{all}", wrong.len(), strict.len());
    let count = judged.len();
    let kept = count - refused.values().sum::<usize>();
    assert!(10 * kept >= 6 * count, "{kept} of {count}: {refused:?}");
}
