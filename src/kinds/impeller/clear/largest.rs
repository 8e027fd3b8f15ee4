//! The largest flat finishing tool that leaves no more in the corner of face and floor than is allowed.
//!
//! # Derivation
//! Tools are tried in steps of 1/20 mm, each with all of its passes. Of tools from the smallest on, first come those that cannot be used
//! since their programs are too long or their holder, nearer to the part, hits the blank; then those that leave little; then
//! those that leave more; at last those that have no room. So a trial says on which side of it to go on. The first one is
//! the tool that leaves as little by its passes along the faces alone: the floor's passes take of the corner, too, and at the
//! nose of a splitter more is left. What is named has been tried itself.
//!
//! # Units
//! Millimetres.

use crate::kinds::impeller::clear::cut::{CutStrategy, Job, Which};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clear::root::largest_that_leaves;
use crate::kinds::impeller::clear::tool::Tool;
use crate::limits::CLEAR_BLOCKS;
use crate::number::root::last_whole;

/// The steps in which the tool is sought.
const STEPS_A_MM: f64 = 20.0;

/// What is known of the largest tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Largest {
    /// It is this one.
    Tool(f64),
    /// None is found: even the smallest one that can be used leaves more.
    LeavesMore {
        /// Its diameter.
        d: f64,
        /// How much it leaves, up the face.
        left: f64,
    },
    /// None is found: even the smallest one that could be used has no room.
    NoRoom,
}

/// What a trial of a tool says.
enum Tried {
    TooSmall,
    Keeps,
    LeavesMore(f64),
    NoRoom,
}

fn tried(job: &Job, cut: &CutStrategy, allowed: f64) -> Tried {
    let Ok(plan) = Plan::new(job, cut) else { return Tried::NoRoom };
    if plan.told.no_splitter.is_some() {
        return Tried::NoRoom;
    }
    let too_long = |which| plan.all_blocks(which) as u64 > CLEAR_BLOCKS;
    let hits = |which| plan.holder_clearance(job, cut, which).is_some_and(|clearance| clearance < 0.0);
    if [Which::Rough, Which::Finish].into_iter().any(|which| too_long(which) || hits(which)) {
        return Tried::TooSmall;
    }
    let left = plan.told.root.height;
    if left <= allowed { Tried::Keeps } else { Tried::LeavesMore(left) }
}

/// The largest flat finishing tool, no wider than the roughing tool, that can be used and leaves no more than `allowed` up a
/// face; of the cut's own finishing tool nothing counts but its holder.
#[must_use]
pub fn largest(job: &Job, cut: &CutStrategy, allowed: f64) -> Largest {
    let at = |step: f64| tried(job, &CutStrategy { finish: Tool::flat(step / STEPS_A_MM), ..cut.clone() }, allowed);
    let keeps = |step: f64| matches!(at(step), Tried::Keeps);
    let most = (cut.rough.d * STEPS_A_MM).floor().max(1.0);
    let first = largest_that_leaves(job, allowed, cut.rough.d, cut.scallop);
    let (mut small, mut large, mut none) = (0.0, most + 1.0, Largest::NoRoom);
    let mut good = first.map_or(most / 2.0, |d| d * STEPS_A_MM).floor().clamp(1.0, most);
    loop {
        match at(good) {
            Tried::Keeps => break,
            Tried::TooSmall => small = good,
            Tried::LeavesMore(left) => (large, none) = (good, Largest::LeavesMore { d: good / STEPS_A_MM, left }),
            Tried::NoRoom => (large, none) = (good, Largest::NoRoom),
        }
        if large - small <= 1.0 {
            return none;
        }
        good = f64::midpoint(small, large).floor();
    }
    // Longer and longer steps from there, until one tool leaves more.
    let mut step = 1.0;
    while good + step < large && keeps(good + step) {
        (good, step) = (good + step, 2.0 * step);
    }
    Largest::Tool(last_whole([good, large.min(good + step)], keeps) / STEPS_A_MM)
}
