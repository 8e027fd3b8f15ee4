//! The plan of a channel: every pass, in order, with its links.
//!
//! # Order
//! 1. Rough, level by level: the middle lane first, into the full, at half the feed; then pairs outwards. A level ends with
//!    the splitter's contour. 2. The floor at full depth, from the middle outwards, the contact lanes last. 3. The flanks of
//!    both faces. 4. The splitter: its contour, and its flanks. 5. Floor lanes with the tool leaning, where they
//!    take away what upright ones leave. With a right-hand spindle the tool climbs where the metal is
//!    to the right of the feed: on the obverse side from the rim to the hub, on the reverse side from the hub to the rim.
//!
//! What does not fit is not run, and told. A lane that a splitter cuts in two is run from its open ends, and back out along
//! itself.
//!
//! # Units
//! Millimetres and radians. All channels are alike: channel i is this one with C less by i·2π/N.

use std::f64::consts::TAU;

use crate::kinds::impeller::clear::contact::{Contacts, ToolBesideFaces};
use crate::kinds::impeller::clear::contour;
use crate::kinds::impeller::clear::cut::{CutStrategy, DoesNotFit, Job, Which};
use crate::kinds::impeller::clear::draft::{Draft, SAMPLES, begin, ridge, steps};
use crate::kinds::impeller::clear::engagement::engage;
use crate::kinds::impeller::clear::entered::Begins;
use crate::kinds::impeller::clear::fit::Flank;
use crate::kinds::impeller::clear::flank::FlankWay;
use crate::kinds::impeller::clear::holder::Blank;
use crate::kinds::impeller::clear::lane::OwnNormal;
use crate::kinds::impeller::clear::pass::{Cutting, Pass};
use crate::kinds::impeller::clear::poses::Poses;
use crate::kinds::impeller::clear::rests::Rests;
use crate::kinds::impeller::clear::round::Round;
use crate::kinds::impeller::clear::told::{By, Dropped, FaceError, NoSplitter, PlanResults};
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::clear::uncut;
use crate::kinds::impeller::gap::{RUN_OUT, gap};
use crate::kinds::impeller::part::{Face, HUB, Part, RIM};
use crate::kinds::impeller::solids::Stock;
use crate::number::root::last_whole;
use crate::number::trig::pow;

/// How often a splitter's beginning is moved on at most, and by how much, radians of v.
const STARTS: u8 = 40;
const START: f64 = 0.01;
/// The same beside each of its ends.
const ENDS: u8 = 16;
/// How often passes are begun farther out at most.
const ROUNDS: u8 = 8;
/// Stations at which a smaller tool is tried, in radii where it has run out: where the gap is the least comes first.
const TRIED: [f64; 21] = [
    0.1, 0.0, 0.05, 0.15, 0.2, -0.2, -RUN_OUT, 0.025, 0.075, 0.125, 0.175, 0.225, 0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.75,
    0.9, 1.0,
];
/// Room that it must have there, radians: between two of them there may be less.
const TRIED_ROOM: f64 = 2e-4;

/// The plan of one channel; all are alike.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The passes, in order: those of the roughing tool, then those of the finishing tool. Each tool begins and ends above
    /// the part.
    pub passes: Vec<Pass>,
    /// How many channels there are: N.
    pub channels: u32,
    /// Above this height of Z no point of the part comes, d_s included.
    pub Z_r: f64,
    /// What it leaves, and what it does not run.
    pub told: PlanResults,
}

impl Plan {
    /// The plan of a cut.
    ///
    /// # Errors
    /// Where one of the tools does not pass between the blades all the way.
    pub fn new(job: &Job, cut: &CutStrategy) -> Result<Self, DoesNotFit> {
        let mut begins = Begins::default();
        let mut plan = Self::beginning(job, cut, begins)?;
        for _ in 0..if cut.partly { ROUNDS } else { 0 } {
            let Some(later) = begins.later(&plan, job, cut) else { break };
            begins = later;
            plan = Self::beginning(job, cut, begins)?;
        }
        engage(job, cut, &mut plan.passes);
        if plan.told.finish_from > 0.0 || plan.told.unfinished.is_some() {
            plan.told.uncut = plan.uncut(job, cut);
        }
        Ok(plan)
    }

    /// The plan whose passes begin at some stations or farther out.
    fn beginning(job: &Job, cut: &CutStrategy, begins: Begins) -> Result<Self, DoesNotFit> {
        let part = &job.part;
        let pitch = TAU / f64::from(job.N);
        let found = rayon::join(|| contacts(job, cut, Which::Rough), || contacts(job, cut, Which::Finish));
        let ((rough, rough_from), (finish, finish_from)) = (found.0?, found.1?);
        let (rough_from, finish_from) = (rough_from.max(begins.rough), finish_from.max(begins.finish));
        // What the finishing tool roughs where the roughing tool has no room.
        let wanted = cut.splitters || rough_from > 0.0;
        let rest = || if wanted { contacts_of(job, cut.finish, part.a_p - cut.s, cut.s) } else { None };
        let (rest, ways) = rayon::join(rest, || ways(job, cut));
        let rest_from = rest.as_ref().and_then(Contacts::fits_from).map_or(rough_from, |from| from.max(begins.finish));
        // It finishes nothing that is not roughed.
        let finish_from = finish_from.max(rough_from.min(rest_from));
        let v_s = match (&rest, cut.splitter_from) {
            (None, _) => None,
            (Some(_), _) if !cut.splitters => None,
            (Some(_), Some(from)) => Some(from),
            (Some(rest), None) => splitter_start(job, cut, rest, &ways),
        };
        let mut draft = Draft {
            job,
            cut,
            pitch,
            v_s,
            finish_from,
            flanks_from: begins.flanks.map(|from| from.max(finish_from)),
            Z_r: job.machine.swing(part.circle.torus.R) + cut.d_s,
            passes: Vec::new(),
            blocks: 0,
            last: None,
            at_rim: false,
            dropped: Vec::new(),
            feed_error: [0.0; 2],
        };
        let (rough_lanes, levels) = draft.rough(&rough, Which::Rough, begin(rough_from));
        draft.done();
        if let Some(rest) = &rest {
            let beside =
                v_s.filter(|&v_s| contour::room(part, &rough, cut.s, v_s) < 0.0).map(|v_s| draft.left_from(v_s));
            let at_hub = (rough_from > rest_from).then(|| begin(rest_from));
            if let Some(from) = [beside, at_hub].into_iter().flatten().min_by(f64::total_cmp) {
                draft.rough(rest, Which::Finish, from.max(begin(rest_from)));
            }
        }
        let floor_lanes = draft.floor(&finish);
        for ways in &ways {
            draft.flanks(ways);
        }
        if v_s.is_some() {
            draft.contour(&finish, Which::Finish, 0.0, Cutting::Contour);
            draft.splitter_flanks(&ways);
        }
        draft.done();

        let steps = f64::from(floor_lanes);
        let faces = [face_error(&ways[0]), face_error(&ways[1])];
        // The corners are those that stay without the leaning pass: it takes no more than they tell.
        let Rests { floor: mut look, root, unfinished, rough: rough_foot } = draft.rests(floor_lanes, faces);
        let floor = draft.lean(&finish, &mut look);
        let floor = look.as_ref().map_or(floor, |look| look.with_nose(floor));
        // Where nothing but ridges is left of the floor, the lanes beside have cut what one did not come to.
        let ridges = cut.scallop + cut.tolerance;
        let is_cut = |v: [f64; 2]| finish_from == 0.0 && look.as_ref().is_some_and(|look| look.is_cut(v, ridges));
        let told = PlanResults {
            gap: gap(part, job.N, cut.finish.d).width,
            rough: draft.tool(Which::Rough, &rough.lane, rough_lanes + 1, levels),
            finish: draft.tool(Which::Finish, &finish.lane, floor_lanes + 1, 1),
            scallop: finish.greatest(|q| ridge(&finish, q).height(finish.room(q).max(0.0) / steps)),
            floor,
            root,
            rough_foot,
            unfinished,
            faces,
            splitter_from: v_s,
            no_splitter: (cut.splitters && v_s.is_none())
                .then(|| NoSplitter { largest: largest_round_splitters(job, cut) }),
            rough_from,
            finish_from,
            uncut: 0.0,
            dropped: lost(draft.dropped, &draft.passes, is_cut),
        };
        Ok(Self { passes: draft.passes, channels: job.N, Z_r: draft.Z_r, told })
    }

    /// The share of the turned surface that no pass reaches. What is thinner than the tolerance is not counted.
    fn uncut(&self, job: &Job, cut: &CutStrategy) -> f64 {
        let cuts = [Which::Rough, Which::Finish].map(|which| {
            let poses = Poses::along(job.machine, self.of(which).map(|pass| pass.points.as_slice()));
            (cut.tool(which), poses)
        });
        uncut::left(&job.part, TAU / f64::from(job.N), self.told.splitter_from, &cuts, cut.tolerance)
    }

    /// By how much C of a channel is turned from the first one.
    #[must_use]
    pub fn turn(&self, channel: u32) -> f64 {
        -TAU * f64::from(channel) / f64::from(self.channels)
    }

    /// The passes of a tool in one channel.
    pub fn of(&self, tool: Which) -> impl Iterator<Item = &Pass> {
        self.passes.iter().filter(move |pass| pass.tool == tool)
    }

    /// How many blocks a tool takes in one channel.
    #[must_use]
    pub fn blocks(&self, tool: Which) -> usize {
        self.of(tool).map(Pass::blocks).sum()
    }

    /// How many it takes in all channels.
    #[must_use]
    pub fn all_blocks(&self, tool: Which) -> usize {
        self.blocks(tool) * self.channels as usize
    }

    /// How far the holder behind a tool stays clear of the blank at least; `None` where it is not known, −∞ for one of any
    /// radius that begins too low.
    #[must_use]
    pub fn holder_clearance(&self, job: &Job, cut: &CutStrategy, tool: Which) -> Option<f64> {
        let stock = Stock { torus: job.part.circle.torus, length: cut.blank };
        let blank = Blank { stock, L: job.machine.L };
        let passes = self.of(tool).map(|pass| pass.points.as_slice());
        cut.stage(tool).map(|stage| blank.clearance(stage, passes))
    }
}

/// Of the stretches that are not run, those whose metal no other pass takes or tells of.
///
/// What a splitter stands in the way of is cut by the passes round it, what the roughing tool leaves beside it by the passes
/// over the rest; and what these do not come to, the floor passes of the same tool cut, or tell.
fn lost(dropped: Vec<Dropped>, passes: &[Pass], is_cut: impl Fn([f64; 2]) -> bool) -> Vec<Dropped> {
    let rest = passes.iter().any(|pass| matches!(pass.cutting, Cutting::Rest { .. }));
    let is_lost = |one: &Dropped| match one.by {
        By::Splitter => false,
        By::Blade | By::Ends if rest && one.tool == Which::Rough => false,
        By::Blade => true,
        By::Ends => !is_cut(one.v) && !matches!(one.cutting, Cutting::Rest { .. }),
    };
    dropped.into_iter().filter(is_lost).collect()
}

/// How deep a tool of the cut goes below the tops.
fn depth(job: &Job, cut: &CutStrategy, which: Which) -> f64 {
    job.part.a_p - cut.allowance(which)
}

/// The part as far as a tool that cuts to a depth can reach: its end stays in the tube that deep, so that what of the faces
/// lies deeper does not stand in its way.
fn down_to(part: &Part, depth: f64) -> Part {
    Part::with(part.circle.torus, part.e, depth)
}

/// The contacts of a tool that cuts to a depth, with s left on the walls; `None` where it is wider than the tube.
fn contacts_of(job: &Job, tool: Tool, depth: f64, s: f64) -> Option<Contacts> {
    let torus = job.part.circle.torus;
    let lane = OwnNormal::new(torus, tool, torus.r + depth)?;
    Some(Contacts::new(&down_to(&job.part, depth), job.N, lane, s))
}

/// The share of a channel that upright lanes of a tool alone, with nothing left on the walls, do not reach; none where it passes then.
fn uncut_by(job: &Job, tool: Tool) -> Option<f64> {
    let Some(contacts) = contacts_of(job, tool, job.part.a_p, 0.0) else { return Some(1.0) };
    let from = contacts.fits_from();
    (from != Some(0.0)).then(|| uncut::share(&job.part, &contacts, from))
}

/// The contacts of a tool of the cut, where it fits: all the way, or, if the cut admits it, from a station on.
fn contacts(job: &Job, cut: &CutStrategy, which: Which) -> Result<(Contacts, f64), DoesNotFit> {
    let (tool, s, depth) = (cut.tool(which), cut.allowance(which), depth(job, cut, which));
    let contacts = contacts_of(job, tool, depth, s);
    let from = contacts.as_ref().and_then(Contacts::fits_from);
    match (contacts, from) {
        (Some(contacts), Some(from)) if from == 0.0 || cut.partly => Ok((contacts, from)),
        (_, from) => Err(DoesNotFit {
            tool: which,
            d: tool.d,
            largest: largest_that_passes(job, cut, which),
            from,
            uncut: uncut_by(job, tool),
        }),
    }
}

/// The largest tool of a kind that passes as a tool of the cut, in whole hundredths: as both where it is both. What is told has passed
/// as one of the form would.
fn largest_that_passes(job: &Job, cut: &CutStrategy, which: Which) -> Option<f64> {
    let tool = cut.tool(which);
    let jobs: &[Which] = if cut.rough == cut.finish { &[Which::Rough, Which::Finish] } else { &[which] };
    let passes = |hundredths: f64| {
        let d = hundredths / 100.0;
        let tool = Tool { d, r_c: corner(tool, d) };
        jobs.iter().all(|&which| {
            let contacts = contacts_of(job, tool, depth(job, cut, which), cut.allowance(which));
            contacts.and_then(|contacts| contacts.fits_from()) == Some(0.0)
        })
    };
    let estimates = jobs.iter().map(|&which| estimate(job, tool, depth(job, cut, which), cut.allowance(which)));
    // What thick blades whose straight ends close their gap leave free, is not known from their faces.
    let first = estimates.collect::<Option<Vec<f64>>>()?.into_iter().fold(f64::INFINITY, f64::min);
    let first = (first * 100.0).round();
    // Longer and longer steps from there, until one tool passes and the other does not.
    let (mut small, mut large, mut step) = (0.0, (tool.d * 100.0).ceil(), 1.0);
    if passes(first) {
        small = first;
        while small + step < large && passes(small + step) {
            (small, step) = (small + step, 2.0 * step);
        }
        large = large.min(small + step);
    } else {
        large = large.min(first);
        while large > step && !passes(large - step) {
            (large, step) = (large - step, 2.0 * step);
        }
        small = (large - step).max(small);
    }
    let small = last_whole([small, large], passes);
    (small > 0.0).then_some(small / 100.0)
}

/// About the largest tool of a kind that fits with s on both walls, in whole hundredths: by some stations alone.
fn estimate(job: &Job, tool: Tool, depth: f64, s: f64) -> Option<f64> {
    let part = &down_to(&job.part, depth);
    let torus = part.circle.torus;
    let width = gap(part, job.N, tool.d).width - 2.0 * s;
    let fits = |d: f64| {
        OwnNormal::new(torus, Tool { d, r_c: corner(tool, d) }, torus.r + depth).is_some_and(|lane| {
            let beside = ToolBesideFaces::new(part, lane, s);
            TRIED.iter().all(|&q| {
                let q = if q < 0.0 { q * d / 2.0 } else { q };
                beside.psi(Face::Obverse, q) - beside.psi(Face::Reverse, q) + TAU / f64::from(job.N) >= TRIED_ROOM
            })
        })
    };
    // A tool as wide as the gap stands at another depth than this one: the last hundredths are tried.
    (0..200_u8)
        .map(|less| ((width * 100.0).floor() + 10.0 - f64::from(less)) / 100.0)
        .find(|&d| d > 0.0 && d < tool.d && fits(d))
}

/// The ways along both faces: one each, or as many as it takes to keep their errors within the tolerance.
fn ways(job: &Job, cut: &CutStrategy) -> [Vec<FlankWay>; 2] {
    let (part, tool) = (&job.part, cut.finish);
    let error = |face: Face| {
        let whole = Flank::new(part, face, tool.a(), [0.0, part.a_p]);
        (0..=SAMPLES)
            .map(|look| whole.full(HUB + (RIM - HUB) * f64::from(look) / f64::from(SAMPLES)).E.abs())
            .fold(0.0, f64::max)
    };
    // The error goes with the third power of the depth of the fit.
    let error = Face::ALL.map(error).into_iter().fold(0.0, f64::max);
    let levels = steps(pow(2.0 * error / cut.tolerance, 1.0 / 3.0));
    let deep = |level: u32| part.a_p * f64::from(level) / f64::from(levels);
    let way = |face, level| FlankWay::new(part, face, tool, [deep(level), deep(level + 1)], cut.d_s);
    Face::ALL.map(|face| (0..levels).map(|level| way(face, level)).collect())
}

/// v_s from which on the finishing tool has room round a splitter, on its contour and along its flanks.
fn splitter_start(job: &Job, cut: &CutStrategy, rest: &Contacts, ways: &[Vec<FlankWay>; 2]) -> Option<f64> {
    let first = contour::start(&job.part, rest, cut.s)?;
    let (obverse, reverse) = (ways[0].last()?, ways[1].last()?);
    let pitch = TAU / f64::from(job.N);
    (0..STARTS).map(|start| first + START * f64::from(start)).filter(|&v_s| v_s < RIM).find(|&v_s| {
        contour::room(&job.part, rest, cut.s, v_s) >= 0.0
            && Round::new(&job.part, cut, [obverse, reverse], v_s).is_clear(pitch, -pitch / 2.0)
    })
}

/// The largest finishing tool of the same kind that has room round splitters somewhere, in whole hundredths.
fn largest_round_splitters(job: &Job, cut: &CutStrategy) -> Option<f64> {
    let fits = |hundredths: f64| {
        let d = hundredths / 100.0;
        let finish = Tool { d, r_c: corner(cut.finish, d) };
        let cut = CutStrategy { finish, ..*cut };
        let rest = contacts_of(job, finish, job.part.a_p - cut.s, cut.s);
        let rest = rest.filter(|rest| rest.fits_from().is_some_and(|from| from == 0.0 || cut.partly));
        rest.is_some_and(|rest| splitter_start(job, &cut, &rest, &ways(job, &cut)).is_some())
    };
    // A smaller one has more room; what is told has passed as a tool of the form would.
    let small = last_whole([0.0, (cut.finish.d * 100.0).ceil()], fits);
    (small > 0.0).then_some(small / 100.0)
}

/// The corner radius of a tool of another diameter and the same kind.
fn corner(tool: Tool, d: f64) -> f64 {
    if tool.flat_radius() == 0.0 { d / 2.0 } else { tool.r_c.min(d / 2.0) }
}

/// What the ways along a face leave of it.
fn face_error(ways: &[FlankWay]) -> FaceError {
    let face = ways.first().map_or(Face::Obverse, FlankWay::face);
    let levels = u32::try_from(ways.len()).unwrap_or(u32::MAX);
    let mut error = FaceError { face, rest: 0.0, v: HUB, fit: 0.0, levels };
    for way in ways {
        // The straight ends, too, are in the blank for a bit.
        let [begin, end] = way.in_blank();
        let all = (0..=SAMPLES).map(|look| begin + (end - begin) * f64::from(look) / f64::from(SAMPLES));
        // Where the face goes over into its straight ends the fit changes within less than a radius of the tool.
        let beside = |v: f64| {
            let reach = way.tool().a() / way.part().circle.torus.R;
            (0..=ENDS).map(move |look| v + reach * (2.0 * f64::from(look) / f64::from(ENDS) - 1.0))
        };
        let looks = all.chain(beside(HUB)).chain(beside(RIM)).filter(|v| (begin..=end).contains(v));
        for v in looks {
            error.fit = error.fit.max(way.flank().full(v.clamp(HUB, RIM)).E.abs());
            let rest = way.rest(v);
            if rest > error.rest {
                error = FaceError { rest, v, ..error };
            }
        }
    }
    error
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::torus::Torus;
    use crate::kinds::impeller::clear::told::Unfinished;
    use crate::machine::rotary::TiltingTable;

    fn job(r: f64, e: f64) -> Job {
        Job { part: Part::with(Torus { R: 25.0, r }, e, 2.0), N: 4, machine: TiltingTable { L: 242.9 } }
    }

    #[test]
    fn the_largest_tool_round_splitters_has_room_and_the_next_one_has_none() {
        let cut = |d: f64| CutStrategy { splitters: true, scallop: 0.2, ..CutStrategy::usual(6.0, d) };
        let told = |d: f64| Plan::new(&job(15.0, 2.0), &cut(d)).expect("a plan").told;
        let NoSplitter { largest } = told(6.0).no_splitter.expect("no room");
        let largest = largest.expect("a tool");
        assert!(told(largest).splitter_from.is_some(), "{largest}");
        assert!(told(largest + 0.01).no_splitter.is_some(), "{largest}");
    }

    #[test]
    fn a_tool_that_passes_is_run_all_the_way_where_a_part_of_it_would_do() {
        let part = Part::with(Torus { R: 102.46, r: 21.97 }, 5.061, 4.74);
        let wide = Job { part, N: 2, machine: TiltingTable { L: 346.86 } };
        let tolerance = 0.01 - wide.machine.rounding(102.46);
        let cut = |partly: bool| CutStrategy {
            partly,
            tolerance,
            s: 0.849,
            scallop: 0.1,
            ..CutStrategy::usual(26.364, 23.728)
        };
        let [partly, whole] = [true, false].map(|partly| Plan::new(&wide, &cut(partly)).expect("a plan"));
        assert_eq!(partly, whole);
    }

    #[test]
    fn what_lies_before_a_splitter_and_is_not_reached_is_told() {
        let cut = CutStrategy { splitters: true, partly: true, scallop: 0.1, ..CutStrategy::usual(6.0, 6.0) };
        let told = Plan::new(&job(18.0, 1.0), &cut).expect("a plan").told;
        let v_s = told.splitter_from.expect("splitters");
        let lost: Vec<_> = told.dropped.iter().filter(|one| one.by == By::Ends).collect();
        assert!(lost.iter().any(|one| matches!(one.cutting, Cutting::Floor { .. })), "{:?}", told.dropped);
        assert!(lost.iter().all(|one| one.v[0] >= HUB && one.v[0] < one.v[1] && one.v[0] < v_s));
    }

    #[test]
    fn stretches_that_other_passes_cut_are_not_lost() {
        let v = [HUB, RIM];
        let of = |tool, cutting, by| Dropped { cutting, tool, v, by };
        let lane = Cutting::Floor { lane: 3 };
        let all = vec![
            of(Which::Finish, lane, By::Blade),
            of(Which::Finish, lane, By::Ends),
            of(Which::Finish, lane, By::Splitter),
        ];
        let by = |whole: bool| lost(all.clone(), &[], |_| whole).iter().map(|one| one.by).collect::<Vec<_>>();
        assert_eq!((by(false), by(true)), (vec![By::Blade, By::Ends], vec![By::Blade]));
    }

    #[test]
    fn an_end_above_the_depth_leaves_the_faces_unfinished_flat_or_not() {
        // The corner's height by the derivation of the root, at the rim.
        let c_r = |r_f: f64, a: f64| r_f - (r_f * r_f - 4.0 * a * a).sqrt();
        assert!(c_r(15.8, 3.0) > 0.8 && c_r(17.0, 3.0) < 2.0);
        let told = |a_p: f64| {
            let job = Job { part: Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, a_p), ..job(15.0, 2.0) };
            Plan::new(&job, &CutStrategy { s: 0.1, scallop: 0.02, ..CutStrategy::usual(6.0, 6.0) })
                .expect("a plan")
                .told
        };
        let shallow = told(0.8);
        let Unfinished { left, .. } = shallow.unfinished.expect("unfinished");
        // By an independent simulation of the shipped form at that depth 0.093 mm stays at the top edge of the reverse, and more
        // towards the floor.
        assert!((0.093..0.25).contains(&left), "{left}");
        assert_eq!(shallow.root.height, 0.8);
        assert!(told(2.0).unfinished.is_none());
    }

    #[test]
    fn a_rounded_end_is_named_only_where_the_face_is_cut() {
        let cut = |d: f64, r_c: f64, partly: bool| {
            let tool = Tool { d, r_c };
            CutStrategy { rough: tool, finish: tool, partly, scallop: 0.1, ..CutStrategy::usual(d, d) }
        };
        let told = |cut: CutStrategy| Plan::new(&job(15.0, 2.0), &cut).expect("a plan").told;
        let partly = told(cut(8.0, 1.0, true));
        assert!(partly.finish_from > 0.0 && partly.root.height >= 2.0 && partly.unfinished.is_none());
        assert!(told(cut(6.0, 3.0, false)).unfinished.is_some());
    }
}
