//! Where the passes of a plan enter a blade, and from which station on they do not.
//!
//! Lanes and flank passes are laid out beside the two faces of their channel. At a narrow hub other blades come in, too: the
//! straight end of a thick blade reaches past its neighbour, faces that pass the axis of the part come out on its other side,
//! and a tool thinner than a blade finds no face in the middle of it. A cut that may be made partly then begins farther out,
//! where its passes keep clear of all blades by the bounds that judge the programs.
//!
//! # Units
//! Millimetres and radians.

use std::f64::consts::TAU;

use crate::kinds::impeller::clear::cut::{CutStrategy, Job, Which};
use crate::kinds::impeller::clear::draft::station;
use crate::kinds::impeller::clear::pass::{Cutting, Direction, Pass};
use crate::kinds::impeller::clear::plan::Plan;
use crate::kinds::impeller::clearance::{Stand, Until, WORK, Walls};
use crate::kinds::impeller::part::{Face, Part};
use crate::limits::CLEAR_BLOCKS;
use crate::number::grid::HALF;
use crate::number::root::halved;

/// What the judge of the programs allows beside the tolerance, mm.
const OVER: f64 = 0.001;
/// How often a block is halved to find where it begins to enter.
const HALVINGS: u8 = 6;
/// How much farther out a pass then begins, in parts of the way: its blocks lie otherwise.
const MORE: f64 = 0.005;
/// A stand on the grid may lie this much before the station at which its pass begins.
const SAME: f64 = 1e-4;

/// The stations before which passes are not run, by what they cut: 0 where they are run all the way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Begins {
    /// Lanes of the roughing tool.
    pub(super) rough: f64,
    /// Lanes of the finishing tool.
    pub(super) finish: f64,
    /// Flank passes along obverse and reverse.
    pub(super) flanks: [f64; 2],
}

/// The face along which a flank pass is run.
const fn flank(pass: &Pass) -> Option<Face> {
    match pass.cutting {
        Cutting::Flank { face, .. } => Some(face),
        _ => None,
    }
}

/// A stand as a program has it: in thousandths.
fn on_grid(stand: &Stand) -> Stand {
    let milli = |value: f64| (value * 1000.0).round() / 1000.0;
    let angle = |angle: f64| milli(angle.to_degrees()).to_radians();
    Stand { at: stand.at.map(milli), B: angle(stand.B), C: angle(stand.C) }
}

/// All blades, as a tool must keep clear of them.
struct Blades<'a> {
    job: &'a Job,
    /// By how much more than this no program may enter one, mm.
    limit: f64,
    faces: Walls,
    /// Their mean surfaces.
    middles: Walls,
}

impl Begins {
    /// Those of a plan that was made with these: the same, or later ones where passes enter a blade; `None` where none does, or
    /// none would if it began later.
    pub(super) fn later(self, plan: &Plan, job: &Job, cut: &CutStrategy) -> Option<Self> {
        if [Which::Rough, Which::Finish].into_iter().any(|tool| plan.all_blocks(tool) as u64 > CLEAR_BLOCKS) {
            return None;
        }
        let of = |tool: Which, face: Option<Face>, begun: f64| {
            let blades = Blades::new(job, cut, tool);
            plan.of(tool).filter(|pass| flank(pass) == face).fold(begun, |from, pass| blades.clear_from(pass, from))
        };
        let flanks = || {
            rayon::join(
                || of(Which::Finish, Some(Face::Obverse), self.flanks[0]),
                || of(Which::Finish, Some(Face::Reverse), self.flanks[1]),
            )
        };
        let (rough, (finish, flanks)) = rayon::join(
            || of(Which::Rough, None, self.rough),
            || rayon::join(|| of(Which::Finish, None, self.finish), flanks),
        );
        let later = Self { rough, finish, flanks: flanks.into() };
        (later != self).then_some(later)
    }
}

impl<'a> Blades<'a> {
    fn new(job: &'a Job, cut: &CutStrategy, tool: Which) -> Self {
        let turns = || (0..job.N).map(|blade| TAU * f64::from(blade) / f64::from(job.N)).collect();
        let Part { circle, a_p, .. } = job.part;
        let (middle, R) = (Part::with(circle.torus, 0.0, a_p), circle.torus.R);
        Self {
            job,
            // As the programs are judged: with what rounding takes of ε, and the other channels may be turned otherwise by it.
            limit: cut.tolerance + job.machine.rounding(R) + OVER - HALF.to_radians() * R,
            faces: Walls::new(job.part, job.machine, cut.tool(tool).a(), turns(), f64::MIN),
            middles: Walls::new(middle, job.machine, 0.0, turns(), f64::MIN),
        }
    }

    /// True where a way enters a blade by more than that, for certain.
    fn hold(&self, way: &[Stand]) -> bool {
        let half = self.job.part.e / 2.0;
        self.faces.clearance(way, Until::Decided(-self.limit), WORK).upper < -self.limit
            || self.middles.clearance(way, Until::Decided(half), WORK).upper < half
    }

    fn station(&self, stand: &Stand) -> f64 {
        station(&self.job.machine.to_part(&stand.at, stand.B, stand.C), self.job.part.circle.torus.R)
    }

    /// The station from which on a pass enters no blade, no less than one from which on it is run in any case.
    fn clear_from(&self, pass: &Pass, from: f64) -> f64 {
        let mut way: Vec<Stand> = pass.points.iter().map(on_grid).collect();
        match pass.direction {
            Direction::Inwards => {}
            Direction::Outwards => way.reverse(),
            Direction::Round => return from,
        }
        if from > 0.0 {
            way.retain(|stand| self.station(stand) >= from - SAME);
        }
        if !self.hold(&way) {
            return from;
        }
        // So many of its points, from the rim on, are clear, and so many are not.
        let (mut clear, mut entered) = (1, way.len());
        while entered - clear > 1 {
            let middle = usize::midpoint(clear, entered);
            if self.hold(&way[..middle]) { entered = middle } else { clear = middle }
        }
        let ([.., last], Some(next)) = (&way[..clear], way.get(clear)) else { return from };
        let good = halved([0.0, 1.0], HALVINGS, |part| !self.hold(&[*last, last.towards(next, part)]));
        let begin = self.station(&last.towards(next, good)) + MORE;
        // One that is in a blade at the rim is not mended by that.
        if begin < 1.0 { begin.max(from) } else { from }
    }
}
