//! Alarms that last: each is reported once, when it begins.

use super::alarm::{Alarm, Cause, TOUCH};
use super::motion_totals::Tally;
use super::path::Piece;
use super::spindle::{extent, revolutions};
use super::thread_groove::ThreadGroove;
use super::threads::{DEEPEST_PASS, ThreadPass, Threads};
use super::tool::{Cutter, TurningTool};
use crate::gcode::in_force::{Compensation, InForce};
use crate::gcode::motion::{FeedMode, MotionKind, Thread};
use crate::number::trig::{hypot, sin, tan};

/// How deep the metal is that a pass cuts, mm, and from where to where the tool stands there: the least and the greatest `[z, r]`.
pub(super) type Met = (f64, [[f64; 2]; 2]);

/// Remembers which lasting alarms hold.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    /// The alarm's number and the tool.
    holding: Vec<(u16, u32)>,
    threads: Threads,
    /// Of the passes that cut metal, on the grid.
    grooves: Vec<ThreadGroove>,
}

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

    /// The alarms of a cut about the tool's edge: the side of its nose, its feed, a thread's depth.
    pub(super) fn edge(
        &mut self,
        tool: &TurningTool,
        control: &InForce,
        pieces: &[Piece],
        (deep, deepest): (f64, [f64; 2]),
        tally: &mut Tally,
    ) {
        let Some(&[start, _]) = pieces.first() else { return };
        let place = tally.begins.unwrap_or(start);
        let mut causes = Vec::new();
        if !matches!(tally.motion.kind, MotionKind::Thread(_)) {
            let cause = Cause::NoseInTheWork(control.compensation);
            causes.push((
                cause,
                place,
                tool.nose() > 0.0 && pieces.iter().any(|piece| nose_ahead(tool, control, piece)),
            ));
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
            causes.push((Cause::CoarseFeed { feed, most }, place, most > 0.0 && feed > most + 1e-9));
        }
        if let (MotionKind::Thread(thread), Cutter::Threader { angle, nose, .. }) = (tally.motion.kind, tool.cutter) {
            let half = angle.to_radians() / 2.0;
            let most = thread.lead / (2.0 * tan(half)) - nose * (1.0 / sin(half) - 1.0);
            causes.push((Cause::ThreadTooDeep { depth: deep, most }, deepest, deep > most + TOUCH));
        }
        for (cause, place, holds) in causes {
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
    pub fn passes(&self) -> usize {
        self.threads.passes()
    }

    /// The grooves of the passes of threads that cut metal, on the grid.
    pub fn grooves(&self) -> &[ThreadGroove] {
        &self.grooves
    }

    /// The part comes with these grooves.
    pub fn begin_with(&mut self, grooves: Vec<ThreadGroove>) {
        self.grooves = grooves;
    }

    /// The alarms of passes that left the groove of their thread; see [`Threads::off_groove`].
    pub fn off_groove(&self) -> Vec<Alarm> {
        self.threads.off_groove()
    }

    /// The alarms of a thread's pass as programmed, with the tool and its place in the turret; `begins` where it does not go on
    /// from another block of the thread; `met` is the metal that it cuts.
    pub(super) fn thread(
        &mut self,
        thread: Thread,
        [start, end]: Piece,
        (place, tool): (u32, Option<&TurningTool>),
        (begins, met): (bool, Option<Met>),
        tally: &mut Tally,
    ) {
        let Some(turns) = revolutions(thread, extent([start, end])) else {
            tally.raise(Cause::NoLead, start, None);
            return;
        };
        let turned = self.threads.turn(&thread, turns, begins);
        let Some(tool) = tool else { return };
        let lead = thread.lead;
        match tool.cutter {
            Cutter::Threader { leads, .. } => {
                let other = lead < leads[0] - 1e-9 || lead > leads[1] + 1e-9;
                if self.begins(Cause::Lead { lead, leads }, other, place) {
                    tally.raise(Cause::Lead { lead, leads }, start, None);
                }
            }
            _ => {
                if self.begins(Cause::NoThreader, met.is_some(), place) {
                    tally.raise(Cause::NoThreader, start, None);
                }
            }
        }
        if let Some((deep, metal)) = met {
            self.grooves.extend(ThreadGroove::new([start, end], lead, tool));
            let pass = ThreadPass { thread, way: [start, end], turned, place, tool, deep, metal };
            let most = DEEPEST_PASS;
            if let Some((depth, first)) =
                self.threads.judge(&pass, tally).filter(|_| matches!(tool.cutter, Cutter::Threader { .. }))
            {
                let cause = Cause::ThreadPassTooDeep { depth, most };
                let holds = depth > most + TOUCH;
                // The alarm of a pass does not end with its pull-out, which is shallow.
                if (holds || first) && self.begins(cause, holds, place) {
                    tally.raise(cause, start, None);
                }
            }
        }
    }
}
