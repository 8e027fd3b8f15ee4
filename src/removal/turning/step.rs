//! What one motion comes to, and what all of them do.

use std::collections::BTreeMap;

use super::alarm::Alarm;
use super::workpiece::Removed;
use crate::gcode::in_force::InForce;
use crate::gcode::motion::{Motion, MotionKind};
use crate::geometry::exact::region::Ring;

/// A change of the part's outer contour: of its points, counted from the corner of least Z and on counter-clockwise, some
/// go and others come in their place.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// The index of the first point that goes.
    pub at: usize,
    /// How many go.
    pub deleted: usize,
    /// What comes, `[z, r]` from W1, mm.
    pub inserted: Vec<[f64; 2]>,
}

impl Edit {
    /// The change from one contour to another; `None` where there is none.
    #[must_use]
    pub fn between(before: &[[f64; 2]], after: &[[f64; 2]]) -> Option<Self> {
        let same = before.iter().zip(after).take_while(|(one, two)| one == two).count();
        if same == before.len() && same == after.len() {
            return None;
        }
        let most = before.len().min(after.len()) - same;
        let tail = before.iter().rev().zip(after.iter().rev()).take(most).take_while(|(one, two)| one == two).count();
        Some(Self { at: same, deleted: before.len() - same - tail, inserted: after[same..after.len() - tail].to_vec() })
    }

    /// Makes the change.
    pub fn apply(&self, ring: &mut Ring) {
        let from = self.at.min(ring.len());
        let to = (self.at + self.deleted).min(ring.len());
        ring.splice(from..to, self.inserted.iter().copied());
    }
}

/// What one motion comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The number of the motion, from 0.
    pub index: usize,
    /// The motion as the interpreter gave it.
    pub motion: Motion,
    /// What was in force.
    pub control: InForce,
    /// Where the programmed point went, `[z, r]` from W1, mm, with the chords of an arc and the bend of a rapid motion;
    /// empty where nothing moved.
    pub way: Vec<[f64; 2]>,
    /// How long it takes, s; `None` where feed or spindle leave it open.
    pub seconds: Option<f64>,
    /// The spindle's speed at the start and at the end, rpm.
    pub speed: [f64; 2],
    /// The maximum cutting speed, m/min; 0 out of the cut.
    pub cutting_speed: f64,
    /// The depth of cut, mm: how far the cut reaches across the motion, slivers left out. 0 out
    /// of the cut.
    pub depth: f64,
    /// What was taken away.
    pub removed: Removed,
    /// How many chips a minute, cm³/min; `None` where the time is not known.
    pub rate: Option<f64>,
    /// What went wrong.
    pub alarms: Vec<Alarm>,
    /// How the part's outer contour changed, where that is recorded.
    pub edit: Option<Edit>,
}

impl Step {
    /// True of a motion that cuts: it takes metal away, and not at rapid, which is an alarm and no cut.
    #[must_use]
    pub fn cuts(&self) -> bool {
        self.motion.kind != MotionKind::Rapid && self.removed.volume > 0.0
    }
}

/// A sum over motions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Total {
    /// How many motions.
    pub motions: usize,
    /// The time whose length is known, s.
    pub seconds: f64,
    /// Of it at rapid, s.
    pub rapid_seconds: f64,
    /// Of it in the cut, s.
    pub cutting_seconds: f64,
    /// How many motions have no known time.
    pub timeless: usize,
    /// Cut to chips, mm³.
    pub volume: f64,
    /// Cut off in pieces, mm³.
    pub parted: f64,
    /// The maximum depth of cut, mm.
    pub depth: f64,
    /// The greatest rate, cm³/min.
    pub rate: f64,
    /// The maximum cutting speed, m/min.
    pub cutting_speed: f64,
}

impl Total {
    /// Adds a motion; its depth, rate and cutting speed count only where it cuts.
    pub fn add(&mut self, step: &Step) {
        self.motions += 1;
        match step.seconds {
            Some(seconds) => {
                self.seconds += seconds;
                if step.motion.kind == MotionKind::Rapid {
                    self.rapid_seconds += seconds;
                } else if step.cuts() {
                    self.cutting_seconds += seconds;
                }
            }
            None => self.timeless += 1,
        }
        self.volume += step.removed.volume;
        self.parted += step.removed.parted;
        if step.cuts() {
            self.depth = self.depth.max(step.depth);
            self.rate = self.rate.max(step.rate.unwrap_or(0.0));
            self.cutting_speed = self.cutting_speed.max(step.cutting_speed);
        }
    }
}

impl Total {
    /// Adds another sum.
    pub fn join(&mut self, other: &Self) {
        self.motions += other.motions;
        self.seconds += other.seconds;
        self.rapid_seconds += other.rapid_seconds;
        self.cutting_seconds += other.cutting_seconds;
        self.timeless += other.timeless;
        self.volume += other.volume;
        self.parted += other.parted;
        self.depth = self.depth.max(other.depth);
        self.rate = self.rate.max(other.rate);
        self.cutting_speed = self.cutting_speed.max(other.cutting_speed);
    }
}

/// The sums of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Totals {
    /// The sum over all motions.
    pub all: Total,
    /// By the line of the program's file and the block number.
    pub blocks: BTreeMap<(usize, Option<u32>), Total>,
    /// By the place of the tool in the turret.
    pub tools: BTreeMap<u32, Total>,
}

impl Totals {
    /// Adds a motion to all three.
    pub fn add(&mut self, step: &Step) {
        self.all.add(step);
        self.blocks.entry((step.motion.line, step.motion.n)).or_default().add(step);
        self.tools.entry(step.control.tool).or_default().add(step);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edit_leads_from_one_contour_to_the_other() {
        let ring = |points: &[i32]| points.iter().map(|&at| [f64::from(at), 0.0]).collect::<Ring>();
        for (before, after) in [
            (vec![1, 2, 3, 4], vec![1, 2, 9, 4]),
            (vec![1, 2, 3, 4], vec![1, 4]),
            (vec![1, 2], vec![1, 5, 6, 2]),
            (vec![1, 1, 1], vec![1, 1]),
            (vec![1, 2], vec![]),
            (vec![], vec![3]),
            (vec![1, 2, 1, 2], vec![1, 2, 1, 2, 1, 2]),
        ] {
            let (mut before, after) = (ring(&before), ring(&after));
            Edit::between(&before, &after).unwrap().apply(&mut before);
            assert_eq!(before, after);
            assert_eq!(Edit::between(&before, &after), None);
        }
    }
}
