//! When the motions of rodete's interpreter are those of LinuxCNC's.

use std::f64::consts::TAU;

use rodete::gcode::motion::{self, FeedMode, Motion, Plane};
use rodete::machine::axis::Pose;
use rodete::number::trig::{atan2, hypot};

use crate::common::rs274::{self, HALF, Kind, Six};

/// Less than this is rounding of doubles: mm or degrees.
const NOTHING: f64 = 1e-6;

/// Whether the motions are the same to the last decimal that rs274 prints. Either may have a straight move to where
/// the tool is, or a dwell of 0 s, that the other leaves out.
///
/// # Errors
/// Says which motions differ, and in what.
pub fn agree(ours: &[Motion], theirs: &[rs274::Motion]) -> Result<(), String> {
    match begins(ours, theirs)? {
        [] => Ok(()),
        [their, ..] => Err(format!("ours has no motion like {their:?}")),
    }
}

/// The motions of rs274 that are left after ours, which are the same up to there. rs274 begins a cycle before it finds
/// fault with it; rodete refuses the whole block.
///
/// # Errors
/// As for [`agree`].
pub fn begins<'a>(ours: &[Motion], theirs: &'a [rs274::Motion]) -> Result<&'a [rs274::Motion], String> {
    let (mut at, mut to) = (0, 0);
    loop {
        match (ours.get(at), theirs.get(to)) {
            (None, None) => return Ok(&[]),
            (Some(our), Some(their)) => {
                let their = &after_the_operator(their, our);
                match difference(our, their) {
                    None => (at, to) = (at + 1, to + 1),
                    Some(_) if goes_nowhere(our) => at += 1,
                    Some(_) if their.goes_nowhere() => to += 1,
                    Some(why) => {
                        return Err(format!(
                            "motion {at} of ours, {to} of rs274: {why}\n  ours  {our:?}\n  rs274 {their:?}"
                        ));
                    }
                }
            }
            (Some(our), None) if goes_nowhere(our) => at += 1,
            (None, Some(their)) if their.goes_nowhere() => to += 1,
            (Some(our), None) => return Err(format!("rs274 has no motion like {our:?}")),
            (None, Some(_)) => return Ok(&theirs[to..]),
        }
    }
}

fn goes_nowhere(motion: &Motion) -> bool {
    motion.kind == motion::MotionKind::Dwell(0.0)
        || matches!(motion.kind, motion::MotionKind::Rapid | motion::MotionKind::Feed(_))
            && close(&motion.from, &six(&motion.to), NOTHING)
}

impl rs274::Motion {
    fn goes_nowhere(&self) -> bool {
        let apart = self.from.iter().zip(self.program).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        match self.kind {
            Kind::Rapid | Kind::Feed(_) => apart < 2.0 * self.doubt,
            Kind::Dwell(seconds) => seconds == 0.0,
            Kind::Arc { .. } => false,
        }
    }

    /// The length that LinuxCNC feeds along, in the active unit: X Y Z, or A B C where these stand still.
    fn length(&self) -> f64 {
        let between = |axes: [usize; 3]| {
            let apart = |axis: usize| self.program[axis] - self.from[axis];
            axes.map(|axis| apart(axis) * apart(axis)).iter().sum::<f64>().sqrt()
        };
        match self.kind {
            Kind::Arc { plane, centre, turns, .. } => arc_length(self, plane, centre, turns) / self.unit,
            _ if between([0, 1, 2]) > 2.0 * self.doubt => between([0, 1, 2]) / self.unit,
            _ => between([3, 4, 5]),
        }
    }
}

fn arc_length(motion: &rs274::Motion, plane: Plane, centre: [f64; 2], turns: i32) -> f64 {
    let [first, second, across] = plane.axes().map(|axis| axis as usize);
    let angle = |at: &Six| atan2(at[second] - centre[1], at[first] - centre[0]);
    let radius = hypot(motion.from[first] - centre[0], motion.from[second] - centre[1]);
    let swept = (angle(&motion.program) - angle(&motion.from)) * f64::from(turns.signum());
    // An end within rounding of the start is a full circle.
    let nothing = (1e-4 + 2.0 * motion.doubt) / radius.max(1e-3);
    let swept = if swept <= nothing { swept + TAU } else { swept };
    hypot(radius * (swept + TAU * f64::from(turns.abs() - 1)), motion.program[across] - motion.from[across])
}

/// A motion of rs274 from where rodete takes the operator to have left the axes: the canon does not say.
fn after_the_operator(their: &rs274::Motion, our: &Motion) -> rs274::Motion {
    let mut their = *their;
    if their.by_hand {
        their.from = six(&our.from);
        if matches!(their.kind, Kind::Dwell(_)) {
            (their.program, their.machine) = (six(&our.to), six(&our.machine));
        }
    }
    their
}

fn six(pose: &Pose) -> Six {
    std::array::from_fn(|axis| pose.0[axis])
}

fn close(ours: &Pose, theirs: &Six, within: f64) -> bool {
    six(ours).iter().zip(theirs).all(|(a, b)| (a - b).abs() <= within + NOTHING)
}

/// Same to the last decimal printed, in the active unit for X Y Z and in degrees for A B C.
fn printed_alike(ours: &Pose, their: &rs274::Motion) -> bool {
    six(ours).iter().zip(their.program).enumerate().all(|(axis, (a, b))| {
        let unit = if axis < 3 { their.unit } else { 1.0 };
        (a - b).abs() <= HALF * unit + NOTHING
    })
}

/// In what two motions differ.
fn difference(our: &Motion, their: &rs274::Motion) -> Option<String> {
    let wrong = |what: &str| Some(what.to_owned());
    if their.n.is_some() && their.n != our.n {
        return wrong("block number");
    }
    // Of a dwell the place is not printed.
    let same_end = match their.kind {
        Kind::Dwell(_) => close(&our.to, &their.program, their.doubt),
        _ => printed_alike(&our.to, their),
    };
    if !same_end {
        return wrong("end in program coordinates");
    }
    if !close(&our.machine, &their.machine, their.doubt) {
        return wrong("end in machine coordinates");
    }
    if !close(&our.from, &their.from, their.doubt) {
        return wrong("start");
    }
    let (our_feed, feed) = match (our.kind, their.kind) {
        (motion::MotionKind::Rapid, Kind::Rapid) => return None,
        (motion::MotionKind::Dwell(seconds), Kind::Dwell(theirs)) => {
            return if (seconds - theirs).abs() <= HALF + NOTHING && our.seconds == Some(seconds) {
                None
            } else {
                wrong("dwell")
            };
        }
        (motion::MotionKind::Feed(our), Kind::Feed(feed)) => (our, feed),
        (motion::MotionKind::Arc(arc, our), Kind::Arc { plane, centre, turns, feed }) => {
            if (arc.plane, arc.turns) != (plane, turns) {
                return wrong("plane or turns");
            }
            let off = arc.centre.iter().zip(centre).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            if off > HALF * their.unit + NOTHING {
                return wrong("centre");
            }
            (our, feed)
        }
        _ => return wrong("kind"),
    };
    feed_difference(our, our_feed, their, feed)
}

/// In what the feeds of two moves at feed differ, and the times that they come to.
fn feed_difference(our: &Motion, our_feed: motion::Feed, their: &rs274::Motion, feed: rs274::Feed) -> Option<String> {
    let length = their.length();
    // Relative: the rate has four decimals, the length is one of rounded ends.
    let alike = |a: f64, b: f64, rounding: f64| (a - b).abs() <= rounding + 1e-9 * b.abs();
    // What rounding has done to the ends, as often as an arc goes round its centre.
    let rounds = if let Kind::Arc { turns, .. } = their.kind { TAU * f64::from(turns.abs()) } else { 1.0 };
    let doubt = 4.0 * rounds * their.doubt / their.unit;
    // Degrees per minute where only the rotary axes turn, else lengths.
    let linear = !matches!(their.kind, Kind::Feed(_)) || (0..3).any(|axis| our.from.0[axis] != our.to.0[axis]);
    let unit = if linear { their.unit } else { 1.0 };
    let same = match (our_feed.mode, feed.mode) {
        (FeedMode::PerMinute, rs274::FeedMode::PerMinute)
        | (FeedMode::PerRevolution, rs274::FeedMode::PerRevolution) => {
            alike(our_feed.value, feed.rate * unit, HALF * unit)
                || alike(our_feed.value, feed.rate * their.unit, HALF * their.unit)
        }
        // LinuxCNC turns it into a rate, and that into no less than 0.1.
        (FeedMode::InverseTime, rs274::FeedMode::InverseTime) => {
            alike((our_feed.value * length).max(0.1), feed.rate, HALF + doubt * our_feed.value)
        }
        _ => false,
    };
    if !same {
        return Some(format!("feed: length {length}"));
    }
    let seconds = match our_feed.mode {
        FeedMode::PerMinute => 60.0 * length / feed.rate,
        FeedMode::InverseTime => 60.0 / our_feed.value,
        // The spindle speed is not in the motion.
        FeedMode::PerRevolution | FeedMode::Seconds => return None,
    };
    let rounding = seconds * (HALF / feed.rate) + 60.0 * doubt / feed.rate;
    match our.seconds {
        Some(ours) if alike(ours, seconds, rounding) => None,
        _ => Some(format!("time: {seconds} s expected")),
    }
}
