//! Alarms that last: each is reported once, when it begins.

use super::alarm::{Cause, TOUCH};
use super::motion_totals::Tally;
use super::path::Piece;
use super::spindle::{extent, revolutions};
use super::tool::{Cutter, TurningTool};
use crate::gcode::in_force::{Compensation, InForce};
use crate::gcode::motion::{FeedMode, MotionKind, Thread};
use crate::number::trig::{hypot, sin, tan};

/// A pass of a thread.
#[derive(Clone, Copy, Debug)]
struct ThreadPass {
    /// Where it went along z, and along r.
    z: [f64; 2],
    r: [f64; 2],
    lead: f64,
}

/// Remembers which lasting alarms hold.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    /// The alarm's number and the tool.
    holding: Vec<(u16, u32)>,
    passes: Vec<ThreadPass>,
}

/// Passes of threads farther apart than this across are different threads, mm: more than any thread is deep.
const APART: f64 = 6.0;

/// The maximum feed per revolution, as a share of the nose radius: the ridges between two turns are then arcs of the nose,
/// f²/(8 R) high. A common rule; our choice.
const SMOOTHS: f64 = 0.8;

/// The run-in of a thread of lead L at n rpm is L n (−1 − ln a)/1800, with a the allowed error of the lead in its first
/// turn: 3.2 for 0.015. The formula of Fanuc's lathe manuals, as programmers quote it.
const SHARE: f64 = 3.2;

/// True if G41 or G42 keeps the nose on the side of a straight path to which the tip of the tool points, instead of the side
/// of its body.
///
/// # Derivation
/// With G41 the centre of the nose is to the left of the path. On the tool it is from the tip, against the direction in which
/// the tip points. If the tip points within 17° of the path, either side may be meant.
fn nose_ahead(tool: &TurningTool, control: &InForce, &[from, to]: &Piece) -> bool {
    let side = match control.compensation {
        Compensation::Off => return false,
        Compensation::Left => 1.0,
        Compensation::Right => -1.0,
    };
    let [dz, dr] = [to[0] - from[0], to[1] - from[1]];
    let [z, r] = tool.tip.vector();
    let size = hypot(dz, dr) * hypot(z, r);
    size > 0.0 && side * (dz * r - dr * z) / size > 0.3
}

impl Watch {
    /// True when an alarm begins with a tool; false while it lasts, or if there is none.
    pub fn begins(&mut self, cause: Cause, holds: bool, tool: u32) -> bool {
        let key = (cause.number(), tool);
        match self.holding.iter().position(|held| *held == key) {
            Some(_) if holds => false,
            Some(at) => {
                self.holding.swap_remove(at);
                false
            }
            None if holds => {
                self.holding.push(key);
                true
            }
            None => false,
        }
    }

    /// Notes a pass of a thread; returns the lead of an earlier pass in the same place if it differs.
    pub fn lead(&mut self, [from, to]: Piece, lead: f64) -> Option<f64> {
        let [z, r] = [0, 1].map(|axis| [from[axis].min(to[axis]), from[axis].max(to[axis])]);
        let meets = |one: [f64; 2], two: [f64; 2], apart: f64| one[0] < two[1] + apart && two[0] < one[1] + apart;
        let near = |pass: &&mut ThreadPass| {
            // Along the thread they must share more than a lead, so that a run-out does not count.
            let along = if z[1] - z[0] >= r[1] - r[0] { (-lead, APART) } else { (APART, -lead) };
            meets(pass.z, z, along.0) && meets(pass.r, r, along.1)
        };
        if let Some(pass) = self.passes.iter_mut().find(near) {
            if (pass.lead - lead).abs() > 1e-6 {
                return Some(pass.lead);
            }
            for (held, new) in [(&mut pass.z, z), (&mut pass.r, r)] {
                *held = [held[0].min(new[0]), held[1].max(new[1])];
            }
            return None;
        }
        self.passes.push(ThreadPass { z, r, lead });
        None
    }

    /// The alarms of a cut about the tool's edge: the side of its nose, its feed, a thread's depth.
    pub(super) fn edge(
        &mut self,
        tool: &TurningTool,
        control: &InForce,
        pieces: &[Piece],
        deep: f64,
        tally: &mut Tally,
    ) {
        let Some(&[start, _]) = pieces.first() else { return };
        let place = tally.begins.unwrap_or(start);
        let mut causes = Vec::new();
        if !matches!(tally.motion.kind, MotionKind::Thread(_)) {
            let cause = Cause::NoseInTheWork(control.compensation);
            causes.push((cause, tool.nose() > 0.0 && pieces.iter().any(|piece| nose_ahead(tool, control, piece))));
        }
        if let (MotionKind::Feed(feed) | MotionKind::Arc(_, feed), Cutter::Insert { .. }) =
            (tally.motion.kind, tool.cutter)
        {
            let slowest =
                pieces.iter().flatten().map(|at| tally.turning.at(at[1] + tally.shift[1])).fold(f64::MAX, f64::min);
            let most = SMOOTHS * tool.nose();
            let feed = match feed.mode {
                FeedMode::PerRevolution => feed.value,
                FeedMode::PerMinute if slowest > 0.0 => feed.value / slowest,
                _ => 0.0,
            };
            causes.push((Cause::CoarseFeed { feed, most }, most > 0.0 && feed > most + 1e-9));
        }
        if let (MotionKind::Thread(thread), Cutter::Threader { angle, nose, .. }) = (tally.motion.kind, tool.cutter) {
            let half = angle.to_radians() / 2.0;
            let most = thread.lead / (2.0 * tan(half)) - nose * (1.0 / sin(half) - 1.0);
            causes.push((Cause::ThreadTooDeep { depth: deep, most }, deep > most + TOUCH));
        }
        for (cause, holds) in causes {
            if self.begins(cause, holds, control.tool) {
                tally.raise(cause, place, None);
            }
        }
    }

    /// The alarm of the run-in of a thread's pass that begins in this motion: see [`SHARE`].
    pub(super) fn run_in(&mut self, place: u32, pieces: &[Piece], tally: &mut Tally) {
        let (MotionKind::Thread(thread), Some(&[start, _]), Some(metal)) =
            (tally.motion.kind, pieces.first(), tally.begins)
        else {
            return;
        };
        let least = SHARE * thread.lead * tally.turning.at(start[1] + tally.shift[1]) / 1800.0;
        let length = extent([start, metal]);
        let cause = Cause::ShortRunIn { length, least };
        if self.begins(cause, length < least - TOUCH, place) {
            tally.raise(cause, start, None);
        }
    }

    /// How many passes of threads a new one is compared with.
    pub const fn passes(&self) -> usize {
        self.passes.len()
    }

    /// The alarms of a thread's pass as programmed, with the tool's place in the turret and its cutter.
    pub(super) fn thread(
        &mut self,
        thread: Thread,
        [start, end]: Piece,
        (place, cutter): (u32, Option<&Cutter>),
        cuts: bool,
        tally: &mut Tally,
    ) {
        if revolutions(thread, extent([start, end])).is_none() {
            tally.raise(Cause::NoLead, start, None);
            return;
        }
        let Some(cutter) = cutter else { return };
        let lead = thread.lead;
        match *cutter {
            Cutter::Threader { leads, .. } => {
                let other = lead < leads[0] - 1e-9 || lead > leads[1] + 1e-9;
                if self.begins(Cause::Lead { lead, leads }, other, place) {
                    tally.raise(Cause::Lead { lead, leads }, start, None);
                }
            }
            _ => {
                if self.begins(Cause::NoThreader, cuts, place) {
                    tally.raise(Cause::NoThreader, start, None);
                }
            }
        }
        if cuts && let Some(before) = self.lead([start, end], lead) {
            tally.raise(Cause::LeadDiffers { lead, before }, start, None);
        }
    }
}
