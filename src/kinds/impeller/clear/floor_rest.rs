//! What the passes leave on the floor, some way off from the walls: looked for on a grid, with the blocks as they are.
//!
//! # Derivation
//! The law of the ridges says what lanes leave between them. Beside the walls and round a splitter it says nothing: a floor
//! point at v is touched from the stations v ± θ alone, and where both are shut by a wall it stays higher. So along each
//! line from K through a floor point the lowest place is looked for that the tools of the passes hold, close to each other; what
//! is left is the greatest of what is lacking to a_p. From where most is left the rest is climbed to its top. It is a greatest of
//! samples, not a bound: where the rest has several tops of one height, a higher one may lie between the stations.
//!
//! # Units
//! Millimetres and radians.

use std::cell::Cell;

use nalgebra::Vector3;
use rayon::prelude::*;

use crate::kinds::impeller::clear::floor_feet::{ARITHMETIC, Floor, psi_at};
use crate::kinds::impeller::clear::poses::{BunchBounds, Pose, Poses};
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::part::{Part, RIM};
use crate::number::root::halved;
use crate::number::trig::sin_cos;

/// How many stations of the floor are looked at between its ends: so many for each radius of the tool, and within these limits.
const ALONG_A_RADIUS: f64 = 2.0;
const ALONG: [f64; 2] = [48.0, 480.0];
/// Steps and halvings for the end of a tool that is not flat.
const STEPS: u8 = 8;
const HALVINGS: u8 = 12;
/// Halvings for the place at a distance from a wall.
const EDGES: u8 = 8;
/// So many places across a channel, of which those before a nose are looked at.
const BEFORE_NOSE: u16 = 160;
/// So many of the places at which more is left than beside them are looked at more closely, in so many steps at most, which are halved so
/// often.
const TOPS: usize = 16;
const CLIMBS: u8 = 60;
const HALVED: u8 = 8;
/// Aslant as well: so the ridges run, and the edge of a nose.
const AROUND: [(f64, f64); 8] =
    [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)];
/// Where it looks closer: so many times the stations, and so many times the places across.
const CLOSER: u8 = 6;
const ACROSS: u8 = 2;
/// How far a wall's edge may shift aside from one step to the next, in steps of ψ.
const WIDER: f64 = 2.0;

/// What is left on the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorRest {
    /// Farther from the walls than this, mm.
    pub beside: f64,
    /// It is this much, mm.
    pub most: f64,
    /// v of that place of the floor, radians.
    pub v: f64,
    /// ψ of that place, its angle about the axis of the part, radians.
    pub psi: f64,
}

/// The lowest place along the line from c, between r and r_f, that a tool holds; r where it holds none.
fn reach(tool: Tool, pose: &Pose, c: &Vector3<f64>, out: &Vector3<f64>, [r, r_f]: [f64; 2]) -> f64 {
    let from = c - pose.tip;
    let (along, up) = (out.dot(&pose.along), from.dot(&pose.along));
    let (d, f) = (out - pose.along * along, from - pose.along * up);
    let (square, half, rest) = (d.norm_squared(), d.dot(&f), f.norm_squared() - tool.a() * tool.a());
    let root = half * half - square * rest;
    if root < 0.0 || along > -1e-9 {
        return r;
    }
    // A cylinder is left through its side or through its end.
    let through = |side: f64| (-half + side * root.sqrt()) / square;
    let (enter, leave) = if square > 1e-14 { (through(-1.0), through(1.0)) } else { (r, r_f) };
    let (low, high) = (enter.max(r), leave.min(up / -along).min(r_f));
    if tool.r_c == 0.0 || high <= low {
        return if high > low { high } else { r };
    }
    // With a round end the place lies higher.
    let inside = |T: f64| {
        let from = from + out * T;
        let up = from.dot(&pose.along);
        let down = (tool.r_c - up).max(0.0);
        let wide = tool.flat_radius() + (tool.r_c * tool.r_c - down * down).max(0.0).sqrt();
        from.norm_squared() - up * up <= wide * wide
    };
    let step = (high - low) / f64::from(STEPS);
    let Some(held) = (0..=STEPS).map(|k| high - step * f64::from(k)).find(|&T| inside(T)) else { return r };
    halved([held, (held + step).min(high)], HALVINGS, inside)
}

/// A place of the floor, and what is left there.
#[derive(Clone, Copy, Debug)]
struct Sample {
    rest: f64,
    v: f64,
    psi: f64,
    /// Towards which ψ the wall is, at a place that is just as far from it as asked; else 0.
    wall: f64,
}

/// The places of a station that are looked at, from which ψ on, and how far apart they are.
#[derive(Clone, Debug)]
struct Row {
    v: f64,
    low: f64,
    step: f64,
    seen: Vec<Sample>,
}

impl Row {
    /// The most that is left within a step and a half of a place that is so many steps from the row's beginning.
    fn about(&self, steps: f64) -> f64 {
        let [from, to] = [-1.5, 1.5].map(|off| self.low + self.step * (steps + off));
        let first = self.seen.partition_point(|one| one.psi < from);
        self.seen[first..].iter().take_while(|one| one.psi <= to).map(|one| one.rest).fold(0.0, f64::max)
    }

    /// The places at which no less is left than beside them, in this row and in others beside it.
    fn tops<'r>(&'r self, beside: impl Iterator<Item = &'r Self> + Clone + 'r) -> impl Iterator<Item = Sample> + 'r {
        let is_top = move |one: &Sample| {
            let steps = (one.psi - self.low) / self.step;
            one.rest >= beside.clone().map(|row| row.about(steps)).fold(self.about(steps), f64::max)
        };
        self.seen.iter().copied().filter(is_top)
    }
}

/// What stands on the floor, and how far from it the floor is looked at.
struct Ground {
    floor: Floor,
    beside: f64,
    R: f64,
    /// r and r_f.
    depths: [f64; 2],
    tool: Tool,
}

impl Ground {
    /// K and the direction away from it, of the floor point at v and ψ.
    fn line(&self, v: f64, psi: f64) -> (Vector3<f64>, Vector3<f64>) {
        let ((sin_v, cos_v), (sin, cos)) = (sin_cos(v), sin_cos(psi));
        (Vector3::new(self.R * cos, self.R * sin, 0.0), Vector3::new(cos_v * cos, cos_v * sin, sin_v))
    }

    /// True for a place between the walls, no nearer than asked to them and to a splitter.
    fn is_free(&self, v: f64, psi: f64) -> bool {
        let (c, out) = self.line(v, psi);
        let [high, low] = self.floor.sides.each_ref().map(|side| psi_at(side, v));
        (low..=high).contains(&psi) && self.floor.is_free(&(c + out * self.depths[1]), self.beside)
    }

    /// What some poses leave at a place, as far as that is more than told; else any that is no less and not more than told. The one that
    /// held the deepest place of the last line usually does for the next.
    fn left(&self, poses: &Poses, last: &Cell<Option<usize>>, [v, psi]: [f64; 2], over: f64) -> f64 {
        let ((c, out), [r, r_f]) = (self.line(v, psi), self.depths);
        let held = |pose: &Pose| reach(self.tool, pose, &c, &out, self.depths);
        let deepest = Cell::new(last.get().and_then(|last| poses.get(last)).map_or(r, held));
        let enough = |deepest: f64| r_f - deepest <= over;
        if enough(deepest.get()) {
            return r_f - deepest.get();
        }
        // Only what is deeper is looked for: from the middle of it no tool that holds some of it has its axis farther away than
        // this, nor its end higher up.
        let middle = || {
            let deepest = deepest.get();
            (c + out * f64::midpoint(deepest, r_f), (r_f - deepest) / 2.0 + ARITHMETIC)
        };
        let misses = |beside: f64, up: f64, half: f64| beside > self.tool.a() + half || up < -half;
        let near = poses.of(|bunch| {
            let (middle, half) = middle();
            let BunchBounds { beside, up } = bunch.bounds(&middle);
            misses(beside, up, half)
        });
        for (number, pose) in near {
            let (middle, half) = middle();
            let [beside, up] = pose.seen(&middle);
            if misses(beside, up, half) {
                continue;
            }
            let found = held(pose);
            if found > deepest.get() {
                deepest.set(found);
                last.set(Some(number));
                if enough(found) {
                    break;
                }
            }
        }
        r_f - deepest.get()
    }
}

/// Looks at places one after the other.
struct Eye<'a> {
    ground: &'a Ground,
    cutters: &'a [Poses],
    /// The pose of each cutter that held the deepest place of the last line.
    last: Vec<Cell<Option<usize>>>,
}

impl<'a> Eye<'a> {
    fn new(ground: &'a Ground, cutters: &'a [Poses]) -> Self {
        Self { ground, cutters, last: vec![Cell::new(None); cutters.len()] }
    }

    /// What is left at a place, as far as that is more than told; else any that is no less and not more than told.
    fn rest(&self, place: [f64; 2], over: f64) -> f64 {
        let [r, r_f] = self.ground.depths;
        let mut rest = r_f - r;
        for (poses, last) in self.cutters.iter().zip(&self.last) {
            if rest > over {
                rest = rest.min(self.ground.left(poses, last, place, over));
            }
        }
        rest
    }

    /// The places across the floor at v.
    fn row(&self, v: f64, across: u32) -> Row {
        let [high, low] = [0, 1].map(|side: usize| psi_at(&self.ground.floor.sides[side], v));
        let step = (high - low) / f64::from(across);
        let mut seen: Vec<Sample> = Vec::new();
        let mut before: Option<(f64, bool)> = None;
        for at in 0..=across {
            let psi = low + step * f64::from(at);
            let here = self.ground.is_free(v, psi);
            // What stays in the corner of a wall falls off steeply: the place at just that distance from it is looked at.
            if let Some((last, there)) = before
                && there != here
            {
                seen.push(self.edge(v, if there { [last, psi] } else { [psi, last] }));
            }
            if here {
                seen.push(self.at(v, psi, 0.0));
            }
            before = Some((psi, here));
        }
        Row { v, low, step, seen }
    }

    fn at(&self, v: f64, psi: f64, wall: f64) -> Sample {
        Sample { rest: self.rest([v, psi], 0.0), v, psi, wall }
    }

    /// The place at v that is just as far from a wall as asked, between one that is free and one that is not.
    fn edge(&self, v: f64, [open, shut]: [f64; 2]) -> Sample {
        let wall = (shut - open).signum();
        self.at(v, halved([open, shut], EDGES, |psi| self.ground.is_free(v, psi)), wall)
    }

    /// The greatest rest about a sample, by steps in v and ψ that become smaller. What is just as far from a wall as asked stays so.
    fn climbed(&self, mut top: Sample, [mut by_v, mut by_psi]: [f64; 2], within: [f64; 2]) -> Sample {
        let mut halved = 0;
        for _ in 0..CLIMBS {
            let mut best = top;
            for (up, aside) in AROUND {
                let v = (top.v + up * by_v).clamp(within[0], within[1]);
                let one = if top.wall == 0.0 {
                    // Most have less left, which is known long before how much.
                    let psi = top.psi + aside * by_psi;
                    let rest = self.rest([v, psi], best.rest);
                    (rest > best.rest && self.ground.is_free(v, psi)).then_some(Sample { rest, v, psi, wall: 0.0 })
                } else {
                    let sides = [-1.0, 1.0].map(|side| top.psi + side * top.wall * by_psi * WIDER);
                    (aside == 0.0 && self.ground.is_free(v, sides[0]) && !self.ground.is_free(v, sides[1]))
                        .then(|| self.edge(v, sides))
                };
                best = one.filter(|one| one.rest > best.rest).unwrap_or(best);
            }
            if best.rest > top.rest {
                top = best;
            } else if halved < HALVED {
                (by_v, by_psi) = (by_v / 2.0, by_psi / 2.0);
                halved += 1;
            } else {
                break;
            }
        }
        top
    }
}

/// The floor of a channel as the passes of a tool leave it.
pub struct FloorLook {
    ground: Ground,
    cutters: Vec<Poses>,
    /// v from which on it is looked at, and how far apart the stations are.
    from: f64,
    apart: f64,
    rows: Vec<Row>,
}

impl FloorLook {
    /// Looks at what the poses of a tool leave, farther from the walls than `beside`, from v on; in a channel of the pitch,
    /// with a splitter from v_s on, in so many places across.
    #[must_use]
    pub fn new(
        part: &Part,
        [pitch, beside]: [f64; 2],
        v_s: Option<f64>,
        tool: Tool,
        (poses, from): (Poses, f64),
        across: u32,
    ) -> Self {
        let torus = part.circle.torus;
        let floor = Floor::new(part, pitch, tool.a(), v_s);
        let ground = Ground { floor, beside, R: torus.R, depths: [torus.r, torus.r + part.a_p], tool };
        let wanted = torus.R * (RIM - from) / tool.a() * ALONG_A_RADIUS;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the limits")]
        let along = wanted.ceil().clamp(ALONG[0], ALONG[1]) as u16;
        let (cutters, apart) = (vec![poses], (RIM - from) / f64::from(along));
        // At the ends of the floor a ridge is often highest, and runs aslant: they are looked at themselves.
        let between = (0..along).map(|station| from + apart * (f64::from(station) + 0.5));
        let stations: Vec<f64> = std::iter::once(from).chain(between).chain([RIM]).collect();
        let rows = stations.par_iter().map(|&v| Eye::new(&ground, &cutters).row(v, across)).collect();
        Self { ground, cutters, from, apart, rows }
    }

    /// What some more poses leave at a place.
    #[must_use]
    pub fn left_by(&self, poses: &Poses, place: &FloorRest) -> f64 {
        self.ground.left(poses, &Cell::new(None), [place.v, place.psi], 0.0)
    }

    /// Looks at the same places when some more poses have cut. Where they have taken away more than told, what stays beside them
    /// may be narrower than the places are apart: there it looks closer.
    pub fn cut_by(&mut self, poses: Poses, over: f64) {
        let last = Cell::new(None);
        let mut cut: Option<[usize; 2]> = None;
        for (number, row) in self.rows.iter_mut().enumerate() {
            for one in &mut row.seen {
                let left = self.ground.left(&poses, &last, [one.v, one.psi], 0.0);
                if left < one.rest {
                    if one.rest > over {
                        cut = Some([cut.map_or(number, |[first, _]| first), number]);
                    }
                    one.rest = left;
                }
            }
        }
        self.cutters.push(poses);
        if let Some([first, last]) = cut {
            self.look_closer([first.saturating_sub(1), last + 1]);
        }
    }

    /// Looks at more places between some rows.
    fn look_closer(&mut self, [first, last]: [usize; 2]) {
        let gaps = self.rows.windows(2).skip(first).take(last - first);
        let wide = gaps.filter(|pair| pair[1].v - pair[0].v > self.apart / 2.0);
        let stations: Vec<(f64, f64)> = wide
            .flat_map(|pair| {
                let (from, to) = (pair[0].v, pair[1].v);
                (1..CLOSER).map(move |k| (from + (to - from) * f64::from(k) / f64::from(CLOSER), pair[0].step))
            })
            .collect();
        let row = |&(v, step): &(f64, f64)| {
            let [high, low] = [0, 1].map(|side: usize| psi_at(&self.ground.floor.sides[side], v));
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "some times the places of a row"
            )]
            let across = (f64::from(ACROSS) * (high - low) / step).ceil().clamp(1.0, 1e4) as u32;
            Eye::new(&self.ground, &self.cutters).row(v, across)
        };
        let closer: Vec<Row> = stations.par_iter().map(row).collect();
        self.rows.extend(closer);
        self.rows.sort_by(|one, other| one.v.total_cmp(&other.v));
    }

    /// True where no more than told is left at the places that are looked at between two v, and at those just beside them.
    #[must_use]
    pub fn is_cut(&self, [from, to]: [f64; 2], over: f64) -> bool {
        let seen = self.rows.iter().flat_map(|row| &row.seen);
        seen.filter(|one| one.v >= from - self.apart && one.v <= to + self.apart).all(|one| one.rest <= over)
    }

    /// What is left of the floor, or just as far before a nose as asked if that is more. There rests fall off steeply along the
    /// floor, and the places of the rows lie across.
    #[must_use]
    pub fn with_nose(&self, floor: FloorRest) -> FloorRest {
        let Some(v_s) = self.ground.floor.splitter.as_ref().map(|body| body.v_s) else { return floor };
        let [high, low] = [0, 1].map(|side: usize| psi_at(&self.ground.floor.sides[side], v_s));
        let before = |at: u16| {
            let psi = low + (high - low) * f64::from(at) / f64::from(BEFORE_NOSE);
            let mut shut = v_s;
            if self.ground.is_free(shut, psi) {
                return None;
            }
            let mut open = shut;
            while !self.ground.is_free(open, psi) {
                (open, shut) = (open - self.apart, open);
                if open < self.from {
                    return None;
                }
            }
            let open = halved([open, shut], 2 * EDGES, |v| self.ground.is_free(v, psi));
            Some(Eye::new(&self.ground, &self.cutters).at(open, psi, 0.0))
        };
        let found: Vec<Sample> = (0..=BEFORE_NOSE).into_par_iter().filter_map(before).collect();
        found.into_iter().fold(
            floor,
            |most, Sample { rest, v, psi, .. }| {
                if rest > most.most { FloorRest { most: rest, v, psi, ..most } } else { most }
            },
        )
    }

    /// The most that is left: about the greatest of the places it is looked for more closely.
    #[must_use]
    pub fn most(&self) -> FloorRest {
        let row = |at: usize| self.rows.get(at);
        let tops = self.rows.iter().enumerate().flat_map(|(at, one)| {
            let beside = [at.checked_sub(1), Some(at + 1)].into_iter().flatten().filter_map(row);
            one.tops(beside).map(|top| (top, one.step))
        });
        let mut tops: Vec<(Sample, f64)> = tops.collect();
        tops.sort_by(|one, other| other.0.rest.total_cmp(&one.0.rest));
        tops.truncate(TOPS);
        let climbed = |&(top, step): &(Sample, f64)| {
            let by = [self.apart, step].map(|by| by / 2.0);
            Eye::new(&self.ground, &self.cutters).climbed(top, by, [self.from, RIM])
        };
        let climbed: Vec<Sample> = tops.par_iter().map(climbed).collect();
        let most = climbed.into_iter().reduce(|one, other| if other.rest > one.rest { other } else { one });
        let beside = self.ground.beside;
        most.filter(|most| most.rest > 0.0).map_or(
            FloorRest { beside, most: 0.0, v: self.from, psi: 0.0 },
            |Sample { rest, v, psi, .. }| FloorRest { beside, most: rest, v, psi },
        )
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::geometry::torus::Torus;
    use crate::kinds::impeller::clear::cut::{CutStrategy, Job, Which};
    use crate::kinds::impeller::clear::lane::v_at;
    use crate::kinds::impeller::clear::plan::Plan;
    use crate::kinds::impeller::part::HUB;
    use crate::machine::rotary::TiltingTable;

    #[test]
    fn a_tool_is_left_through_its_side_or_its_end() {
        let pose = Pose { tip: Vector3::new(0.0, 0.0, -16.0), along: Vector3::z() };
        let (c, down) = (Vector3::zeros(), -Vector3::z());
        let slant = Vector3::new(0.1, 0.0, -(1.0_f64 - 0.01).sqrt());
        for tool in [Tool::flat(6.0), Tool::ball(6.0)] {
            assert!((reach(tool, &pose, &c, &down, [15.0, 17.0]) - 16.0).abs() < 1e-4);
        }
        let end = reach(Tool::flat(6.0), &pose, &c, &slant, [15.0, 17.0]);
        assert!((end - 16.0 / (1.0_f64 - 0.01).sqrt()).abs() < 1e-12, "{end}");
        let side = reach(Tool::flat(3.1), &pose, &c, &slant, [15.0, 17.0]);
        assert!((side - 15.5).abs() < 1e-9, "{side}");
        assert_eq!(reach(Tool::flat(2.0), &pose, &c, &slant, [15.0, 17.0]), 15.0);
    }

    /// Steps across a large part are wider than the strip beside a wall that is left out: what lies beyond it is the blade.
    #[test]
    fn places_in_a_blade_are_no_floor() {
        let part = Part::with(Torus { R: 100.0, r: 60.0 }, 8.0, 8.0);
        let floor = Floor::new(&part, PI / 2.0, 6.0, None);
        let ground = Ground { floor, beside: 0.4, R: 100.0, depths: [60.0, 68.0], tool: Tool::flat(12.0) };
        for v in [3.3, 4.0, 4.6] {
            let [high, low] = [0, 1].map(|side: usize| psi_at(&ground.floor.sides[side], v));
            let middle = f64::midpoint(low, high);
            assert!(ground.is_free(v, middle), "{v}");
            for step in 1..40_u8 {
                let off = f64::from(step) * 0.001;
                assert!(!ground.is_free(v, high + off) && !ground.is_free(v, low - off), "{v} {off}");
            }
        }
    }

    /// A simulation of a plan found 0.136 mm at the rim itself, 0.01 mm more than the stations between the ends had shown.
    #[test]
    fn the_ends_of_the_floor_are_looked_at() {
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0);
        let look = FloorLook::new(&part, [PI / 2.0, 0.4], None, Tool::flat(3.0), (Poses::default(), HUB), 20);
        for v in [HUB, RIM] {
            assert!(look.rows.iter().flat_map(|row| &row.seen).filter(|one| one.v == v).count() > 10, "{v}");
        }
    }

    /// Before the nose of a splitter and on large parts a sixth more was left than told.
    #[test]
    fn no_more_is_left_at_ten_times_as_many_places() {
        let designs = [
            ([75.6, 52.2], 2, [6.1, 6.2], [17.7, 15.2], true),
            ([139.1, 94.3], 5, [6.8, 7.5], [10.7, 7.0], false),
            ([57.8, 39.3], 4, [4.4, 3.8], [7.6, 4.8], true),
        ];
        for ([R, r], N, [e, a_p], [rough, finish], splitters) in designs {
            let job = Job { part: Part::with(Torus { R, r }, e, a_p), N, machine: TiltingTable { L: 242.9 } };
            let cut = CutStrategy { splitters, blank: 1.6 * R, partly: true, ..CutStrategy::usual(rough, finish) };
            let plan = Plan::new(&job, &cut).expect("a plan");
            let finishing = plan.passes.iter().filter(|pass| pass.tool == Which::Finish);
            let poses = Poses::along(job.machine, finishing.map(|pass| pass.points.as_slice()));
            let (told, from) = (plan.told.floor, v_at(plan.told.finish_from));
            let around = [TAU / f64::from(N), told.beside];
            let look = FloorLook::new(&job.part, around, plan.told.splitter_from, cut.finish, (poses, from), 40);
            let row =
                |k: u16| Eye::new(&look.ground, &look.cutters).row(from + (RIM - from) * f64::from(k) / 300.0, 120);
            let rows: Vec<Row> = (0..=300_u16).into_par_iter().map(row).collect();
            let most = rows.iter().flat_map(|row| &row.seen).map(|one| one.rest).fold(0.0, f64::max);
            assert!(most > 0.0 && most <= told.most * 1.05 + 1e-3, "{R}: {most} where {} is told", told.most);
        }
    }

    #[test]
    fn without_a_pass_the_whole_depth_is_left() {
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0);
        let look = FloorLook::new(&part, [PI / 2.0, 0.4], None, Tool::flat(3.0), (Poses::default(), HUB), 20);
        assert_eq!(look.most().most, 2.0);
    }
}
