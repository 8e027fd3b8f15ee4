//! Alarms on what is in force during a motion, whether it cuts or not.

use std::collections::{BTreeMap, BTreeSet};

use super::alarm::{Alarm, Cause};
use super::step::Step;
use crate::gcode::in_force::InForce;
use crate::gcode::motion::{Feed, FeedMode, MotionKind};
use crate::machine::axis::Axis;

/// The plausible feed per revolution in the cut, mm: below it any insert rubs, above it any insert breaks. Finishing goes down to
/// a few hundredths; roughing and large wiper inserts go up to 2 mm. A value far outside is F in the other unit, 0.2 in mm/min or
/// 200 in mm per revolution. Our choice.
const FEEDS: [f64; 2] = [0.001, 3.0];
/// The greatest for drills and for blades that groove or part, mm: the largest drills take 0.6, blades 0.4. Our choice.
const FED_SLOWLY: f64 = 1.0;

/// Watches the offset of the tool and its feed over the steps of a program.
#[derive(Clone, Debug, Default)]
pub struct InForceWatch {
    /// The offset of each tool's own, by its place.
    own: BTreeMap<u32, u32>,
    /// Tools with the offsets that were reported.
    told: BTreeSet<(u32, u32)>,
    /// A feed per revolution with the spindle stopped was reported.
    stands: bool,
    /// The places of drills and of blades that groove or part.
    slow: BTreeSet<u32>,
    /// Tools with implausible feeds that were reported.
    fed: BTreeSet<(u32, u64)>,
}

impl InForceWatch {
    /// With the offset of each tool's own, by its place in the turret, and the places of drills and of blades that groove or part.
    #[must_use]
    pub fn new(own: BTreeMap<u32, u32>, slow: BTreeSet<u32>) -> Self {
        Self { own, slow, ..Self::default() }
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
        causes.extend(feed.and_then(|feed| self.fed(step, feed)));
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
        let [low, widest] = FEEDS;
        let high = if self.slow.contains(&step.control.tool) { FED_SLOWLY } else { widest };
        let feed = if most < low { most } else { least };
        let implausible = step.cuts() && value > 0.0 && (most < low || least > high);
        (implausible && self.fed.insert((step.control.tool, value.to_bits())))
            .then_some(Cause::ImplausibleFeed { feed, limits: [low, high] })
    }
}
