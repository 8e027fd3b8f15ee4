//! What is in force during a motion and does not fit it, whether metal is met or not.

use std::collections::{BTreeMap, BTreeSet};

use super::alarm::{Alarm, Cause};
use super::step::Step;
use crate::gcode::motion::{Feed, FeedMode, Kind};
use crate::machine::axis::Axis;

/// Watches the offset of the tool and the feed per revolution over the steps of a program.
#[derive(Clone, Debug, Default)]
pub struct InForce {
    /// The offset of each tool's own, by its place.
    own: BTreeMap<u32, u32>,
    /// Tools with the offsets that were told of.
    told: BTreeSet<(u32, u32)>,
    /// The spindle stands still in a feed per revolution, and that was told.
    stands: bool,
}

impl InForce {
    /// With the offset of each tool's own, by its place in the turret.
    #[must_use]
    pub fn new(own: BTreeMap<u32, u32>) -> Self {
        Self { own, ..Self::default() }
    }

    /// Adds to a step what it gives rise to: each state once, when it begins.
    pub fn judge(&mut self, step: &mut Step) {
        let (motion, control) = (&step.motion, &step.control);
        let feed = match motion.kind {
            Kind::Feed(feed) | Kind::Arc(_, feed) => Some(feed),
            Kind::Thread(_) => None,
            Kind::Rapid | Kind::Dwell(_) => return,
        };
        let mut causes = Vec::new();
        let pair = (control.tool, control.offset);
        if let Some(&own) = self.own.get(&control.tool)
            && own != control.offset
            && self.told.insert(pair)
        {
            causes.push(Cause::OtherOffset { offset: control.offset, own });
        }
        if let Some(Feed { mode: FeedMode::PerRevolution, value }) = feed
            && value > 0.0
        {
            // No time can be told: the spindle does not turn.
            let stopped = step.seconds.is_none();
            let cutting = step.alarms.iter().any(|alarm| alarm.cause == Cause::SpindleStopped);
            if stopped && !cutting && !self.stands {
                causes.push(Cause::FeedStands);
            }
            self.stands = stopped;
        }
        let place = [2.0 * motion.to.get(Axis::X), motion.to.get(Axis::Z)];
        let alarm = |cause| Alarm { cause, motion: step.index, line: motion.line, n: motion.n, place, depth: None };
        let alarms: Vec<Alarm> = causes.into_iter().map(alarm).collect();
        step.alarms.extend(alarms);
    }
}
