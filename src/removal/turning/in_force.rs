//! Alarms on what is in force during a motion, whether it cuts or not.

use std::collections::{BTreeMap, BTreeSet};

use super::alarm::{Alarm, Cause};
use super::step::Step;
use crate::gcode::in_force::{InForce, Speed};
use crate::gcode::motion::{Feed, FeedMode, MotionKind};
use crate::machine::axis::Axis;

/// The plausible feed per revolution in the cut, mm: below it any insert rubs, above it any insert breaks. Finishing goes down to
/// a few hundredths; roughing and large wiper inserts go up to 2 mm. A value far outside is F in the other unit, 0.2 in mm/min or
/// 200 in mm per revolution. Our choice.
const FEEDS: [f64; 2] = [0.001, 3.0];

/// Spindle speeds that differ by no more than this share count as equal. Fanuc Series 0i-T operator's manual, threading: the spindle
/// speed must stay the same from roughing to finishing, because the lag of the tool depends on it; hence G97.
const SAME_SPEED: f64 = 1e-3;

/// Watches the offset of the tool, its feed and the speed of threads over the steps of a program.
#[derive(Clone, Debug, Default)]
pub struct InForceWatch {
    /// The offset of each tool's own, by its place.
    own: BTreeMap<u32, u32>,
    /// Tools with the offsets that were reported.
    told: BTreeSet<(u32, u32)>,
    /// A feed per revolution with the spindle stopped was reported.
    stands: bool,
    /// Tools with implausible feeds that were reported.
    fed: BTreeSet<(u32, u64)>,
    /// The tool of the thread in hand, and the speed of its first pass.
    thread: Option<(u32, f64)>,
    /// Tools whose change of speed in a thread was reported.
    threads: BTreeSet<u32>,
}

impl InForceWatch {
    /// With the offset of each tool's own, by its place in the turret.
    #[must_use]
    pub fn new(own: BTreeMap<u32, u32>) -> Self {
        Self { own, ..Self::default() }
    }

    /// The tool's place and the offset in force, if it is not the tool's own.
    #[must_use]
    pub fn other_offset(&self, control: &InForce) -> Option<(u32, u32)> {
        let own = self.own.get(&control.tool)?;
        (*own != control.offset).then_some((control.tool, control.offset))
    }

    /// Adds its alarms to a step: each state once, when it begins.
    pub fn judge(&mut self, step: &mut Step) {
        let (motion, control) = (&step.motion, &step.control);
        let feed = match motion.kind {
            MotionKind::Feed(feed) | MotionKind::Arc(_, feed) => Some(feed),
            MotionKind::Thread(_) => None,
            MotionKind::Rapid | MotionKind::Dwell(_) => return,
        };
        let mut causes = Vec::new();
        match feed {
            Some(feed) => {
                self.thread = None;
                causes.extend(self.fed(step, feed));
            }
            None => causes.extend(self.threaded(step)),
        }
        if let Some(pair) = self.other_offset(control)
            && let Some(&own) = self.own.get(&control.tool)
            && self.told.insert(pair)
        {
            causes.push(Cause::OtherOffset { offset: control.offset, own });
        }
        if let Some(Feed { mode: FeedMode::PerRevolution, value }) = feed
            && value > 0.0
        {
            // No time can be reported: the spindle does not turn.
            let stopped = step.seconds.is_none();
            let cutting = step.alarms.iter().any(|alarm| alarm.cause == Cause::SpindleStopped);
            if stopped && !cutting && !self.stands {
                causes.push(Cause::FeedStands);
            }
            self.stands = stopped;
        }
        let place = [2.0 * motion.to.get(Axis::X), motion.to.get(Axis::Z)];
        let (file, line, n) = (control.file, motion.line, motion.n);
        let alarm = |cause| Alarm { cause, motion: step.index, file, line, n, place, depth: None };
        let alarms: Vec<Alarm> = causes.into_iter().map(alarm).collect();
        step.alarms.extend(alarms);
    }

    /// The alarm of a cut at an implausible feed, per revolution at the spindle's speed in that cut.
    fn fed(&mut self, step: &Step, Feed { mode, value }: Feed) -> Option<Cause> {
        let [slow, fast] = [step.speed[0].min(step.speed[1]), step.speed[0].max(step.speed[1])];
        let [least, most] = match mode {
            FeedMode::PerRevolution => [value, value],
            FeedMode::PerMinute if slow > 0.0 => [value / fast, value / slow],
            _ => return None,
        };
        let [low, high] = FEEDS;
        let feed = if most < low { most } else { least };
        let implausible = step.cuts() && value > 0.0 && (most < low || least > high);
        (implausible && self.fed.insert((step.control.tool, value.to_bits())))
            .then_some(Cause::ImplausibleFeed { feed, limits: FEEDS })
    }

    /// The alarm of a thread in which the spindle changes its speed with the diameter, in a pass or from one pass to the next.
    fn threaded(&mut self, step: &Step) -> Option<Cause> {
        if !step.cuts() || !matches!(step.control.speed, Speed::Surface(_)) {
            return None;
        }
        let tool = step.control.tool;
        let first = match self.thread {
            Some((other, speed)) if other == tool => speed,
            _ => step.speed[0],
        };
        self.thread = Some((tool, first));
        let differs = |speed: &&f64| (**speed - first).abs() > SAME_SPEED * first;
        let speed = *step.speed.iter().find(differs)?;
        self.threads.insert(tool).then_some(Cause::ThreadSpeed { speed, before: first })
    }
}
