//! On which sides of its way a tool meets metal.
//!
//! # Derivation
//! Metal is what lies in the blank and no pass before has taken. At places along a pass it is looked for just inside the tool's side, to
//! the left and to the right of the way, at some heights over its end. With metal on both sides at one height the tool cuts its
//! whole width there; with metal on one side it climbs or not, as its spindle turns. Lanes are looked at; along the flanks and round a
//! splitter the metal is on the side of the wall. Looked at in places: a short stretch may be missed.
//!
//! # Units
//! Millimetres and radians.

use nalgebra::Vector3;
use rayon::prelude::*;

use crate::kinds::impeller::clear::cut::{CutStrategy, Job, Spindle, Which};
use crate::kinds::impeller::clear::pass::{Cutting, Mode, Pass, SLOT_FEED};
use crate::kinds::impeller::clear::poses::{Pose, Poses, along};
use crate::kinds::impeller::clear::tool::Tool;

/// How far apart poses are at most, in parts of the radius.
const APART: f64 = 0.25;
/// Places of a pass are as far apart, but there are no more than this.
const PLACES: f64 = 160.0;
/// The part of a tool's width at which metal is looked for beside its axis.
const BESIDE: f64 = 0.97;
/// The least height over the end, in diameters; it is doubled up to the depth of the channel. A cut less deep than a twentieth of
/// the diameter loads a tool little, however wide it is.
const LOWEST: f64 = 0.05;
/// A pass that cuts its whole width no farther than this, in radii, is none into the full.
const SHORT: f64 = 1.0;

/// The poses of a tool and, for each pass of the plan, how many of them come before it.
struct Taken {
    tool: Tool,
    poses: Poses,
    before: Vec<usize>,
}

/// How far along a pass metal is on the left alone, on the right alone, and on both sides, mm. Where it cuts its whole width farther than a
/// short way, the rest is not looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Sides {
    left: f64,
    right: f64,
    both: f64,
}

impl Taken {
    fn new(job: &Job, cut: &CutStrategy, which: Which, passes: &[Pass]) -> Self {
        let tool = cut.tool(which);
        let (mut all, mut before) = (Vec::new(), Vec::with_capacity(passes.len()));
        for pass in passes {
            before.push(all.len());
            if pass.tool == which {
                all.extend(along(job.machine, &pass.points, tool.a() * APART));
            }
        }
        Self { tool, poses: Poses::new(all), before }
    }
}

/// How wide the end of a tool is at a height over it.
fn width(tool: Tool, height: f64) -> f64 {
    let below = (tool.r_c - height).max(0.0);
    tool.flat_radius() + (tool.r_c * tool.r_c - below * below).max(0.0).sqrt()
}

/// Where a pass meets metal.
fn sides(job: &Job, cut: &CutStrategy, taken: &[Taken; 2], passes: &[Pass], at: usize) -> Sides {
    let (pass, part) = (&passes[at], &job.part);
    let tool = cut.tool(pass.tool);
    let way = along(job.machine, &pass.points, tool.a() * APART);
    let length: f64 = way.windows(2).map(|pair| (pair[1].tip - pair[0].tip).norm()).sum();
    let step = (tool.a() * APART).max(length / PLACES);
    let metal = |point: &Vector3<f64>| {
        part.trimmed(point)
            && part.depth(point) > 0.0
            && !taken.iter().any(|taken| taken.poses.held_before(taken.before[at], taken.tool, point))
    };
    let deepest = 1.5 * part.a_p;
    let heights: Vec<f64> = std::iter::successors(Some(LOWEST * tool.d), |height| Some(2.0 * height))
        .take_while(|&height| height < deepest)
        .collect();
    let mut sides = Sides::default();
    // One place in each step of the way: blocks may be far shorter.
    let mut last = f64::INFINITY;
    for pair in way.windows(2) {
        let Pose { tip, along } = pair[1];
        let travel = tip - pair[0].tip;
        let Some(right) = travel.cross(&along).try_normalize(1e-9) else { continue };
        last += travel.norm();
        if last < step {
            continue;
        }
        last = 0.0;
        let (mut left_cut, mut right_cut, mut both_cut) = (false, false, false);
        for &height in &heights {
            let (middle, beside) = (tip + along * height, right * (BESIDE * width(tool, height)));
            let [on_left, on_right] = [middle - beside, middle + beside].map(|point| metal(&point));
            left_cut |= on_left;
            right_cut |= on_right;
            both_cut |= on_left && on_right;
        }
        if both_cut {
            sides.both += step;
            if sides.both >= SHORT * tool.a() {
                break;
            }
        } else if left_cut != right_cut {
            *(if left_cut { &mut sides.left } else { &mut sides.right }) += step;
        }
    }
    sides
}

/// Gives the passes the mode that they are cut in, and those into the full the feed for it.
pub(super) fn engage(job: &Job, cut: &CutStrategy, passes: &mut [Pass]) {
    let taken = [Which::Rough, Which::Finish].map(|which| Taken::new(job, cut, which, passes));
    let found: Vec<Option<Sides>> = {
        let passes = &*passes;
        let look = |at: usize| match passes[at].cutting {
            Cutting::Rough { .. } | Cutting::Rest { .. } | Cutting::Floor { .. } => {
                (passes[at].mode != Mode::Slot).then(|| sides(job, cut, &taken, passes, at))
            }
            Cutting::RoughContour { .. }
            | Cutting::RestContour { .. }
            | Cutting::Leaning { .. }
            | Cutting::Flank { .. }
            | Cutting::SplitterFlanks { .. }
            | Cutting::Contour => None,
        };
        (0..passes.len()).into_par_iter().map(look).collect()
    };
    for (pass, found) in passes.iter_mut().zip(found) {
        let Some(Sides { left, right, both }) = found else { continue };
        if both >= SHORT * cut.tool(pass.tool).a() {
            pass.mode = Mode::Slot;
            pass.feed = pass.feed.min(SLOT_FEED);
        } else if left != right {
            // With a spindle that turns clockwise the tool climbs where the metal is on its right.
            let climbs = (right > left) == (cut.spindle == Spindle::Clockwise);
            pass.mode = if climbs { Mode::Climb } else { Mode::Conventional };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::torus::Torus;
    use crate::kinds::impeller::clear::pass::Direction;
    use crate::kinds::impeller::clear::plan::Plan;
    use crate::kinds::impeller::part::Part;
    use crate::machine::rotary::TiltingTable;

    fn planned(splitters: bool, spindle: Spindle) -> (Job, CutStrategy, Vec<Pass>) {
        let part = Part::with(Torus { R: 25.0, r: 15.0 }, 2.0, 2.0);
        let job = Job { part, N: 4, machine: TiltingTable { L: 242.9 } };
        let cut = CutStrategy { splitters, spindle, ..CutStrategy::usual(6.0, 3.0) };
        let passes = Plan::new(&job, &cut).expect("a plan").passes;
        (job, cut, passes)
    }

    #[test]
    fn a_lane_is_a_slot_where_nothing_was_cut_before_and_none_beside_what_was() {
        let (job, cut, passes) = planned(false, Spindle::Clockwise);
        let mut alone = vec![Pass { mode: Mode::Climb, feed: 1.0, ..passes[0].clone() }];
        engage(&job, &cut, &mut alone);
        assert_eq!((alone[0].mode, alone[0].feed), (Mode::Slot, SLOT_FEED));
        // The one beside it is half in the air.
        assert!(matches!(passes[1].cutting, Cutting::Rough { level: 0, .. }) && passes[1].mode != Mode::Slot);
    }

    #[test]
    fn a_lane_climbs_with_one_spindle_where_it_does_not_with_the_other() {
        let (job, cut, passes) = planned(false, Spindle::Clockwise);
        let other = CutStrategy { spindle: Spindle::Counterclockwise, ..cut };
        let turned = {
            let mut passes = passes.clone();
            engage(&job, &other, &mut passes);
            passes
        };
        let mut seen = 0;
        for (one, two) in passes.iter().zip(&turned).filter(|(one, _)| matches!(one.cutting, Cutting::Rough { .. })) {
            if one.mode != Mode::Slot && one.direction != Direction::Round {
                assert!(one.mode != two.mode, "{:?}", one.cutting);
                seen += 1;
            }
        }
        assert!(seen > 1, "{seen}");
    }

    /// A simulation found the whole width cut in lanes beside splitters that were told to climb at the full feed.
    #[test]
    fn lanes_past_the_nose_of_a_splitter_are_slots() {
        let (_, _, passes) = planned(true, Spindle::Clockwise);
        let slots = passes.iter().filter(|pass| pass.mode == Mode::Slot);
        let rest = slots.clone().filter(|pass| matches!(pass.cutting, Cutting::Rest { .. })).count();
        assert!(rest >= 4, "{rest}");
        assert!(slots.clone().all(|pass| pass.feed == SLOT_FEED && pass.key().ends_with("-slot")));
        let rest_of = passes.iter().filter(|pass| pass.mode != Mode::Slot);
        assert!(rest_of.clone().all(|pass| pass.feed == 1.0), "the full feed");
    }
}
