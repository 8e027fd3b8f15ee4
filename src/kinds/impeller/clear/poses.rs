//! The poses of a tool along its passes, in bunches of some whose tips are near each other, so that what none of a bunch can
//! reach is left out at once. A bunch is halved across the longest side of what holds its tips.
//!
//! # Derivation
//! Let no tip of a bunch be farther than δ from the mean of all, nor farther than η along their mean axis A, and no axis, as
//! a unit vector, differ from A by more than θ. Of a point w away from the mean tip the distance from any axis of the bunch
//! then does not differ by more than δ + θ·|w| from that of the mean pose: it is the length of w × A. The height over any
//! end, w·A, does not differ by more than η + θ·(|w| + δ). On a floor η is small beside δ.
//!
//! # Units
//! Millimetres and radians.

use std::cell::Cell;

use nalgebra::Vector3;

use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::clearance::Stand;
use crate::kinds::impeller::nearest::Axis;
use crate::limits::BLOCK_POSES;
use crate::machine::rotary::TiltingTable;

/// How far apart the poses of a block are at most, mm at the tip: on a flank 3 mm wide that leaves cusps of 0.003 mm.
const APART: f64 = 0.1;
/// What the tool leaves between two poses that are so far apart, beside its side, mm.
#[must_use]
pub fn cusp(tool: Tool) -> f64 {
    APART * APART / (8.0 * tool.a())
}

/// So many poses on both sides of one are looked at before all.
const NEAR: usize = 24;
/// A bunch of no more poses than this is not parted again.
const FEW: usize = 6;

/// A tool in the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Its tip, mm, in the part frame.
    pub tip: Vector3<f64>,
    /// Its axis, out of the metal.
    pub along: Vector3<f64>,
}

impl From<Axis> for Pose {
    fn from(axis: Axis) -> Self {
        Self { tip: axis.foot + axis.along * axis.range[0], along: axis.along }
    }
}

impl Pose {
    /// How far a point is from the axis, and how high over the end.
    pub(super) fn seen(&self, point: &Vector3<f64>) -> [f64; 2] {
        let from = point - self.tip;
        let up = from.dot(&self.along);
        [(from.norm_squared() - up * up).max(0.0).sqrt(), up]
    }

    /// How far a point is from a tool there; negative inside.
    #[must_use]
    pub fn apart(&self, tool: Tool, point: &Vector3<f64>) -> f64 {
        apart(tool, self.seen(point))
    }
}

/// How far a point is from a tool that it is seen from: from the axis, and over the end.
fn apart(tool: Tool, [beside, up]: [f64; 2]) -> f64 {
    let (out, down) = (beside - tool.flat_radius(), tool.r_c - up);
    let (beyond, below) = (out.max(0.0), down.max(0.0));
    // A root and not hypot: no square of a length of the part runs over.
    out.max(down).min(0.0) + (beyond * beyond + below * below).sqrt() - tool.r_c
}

/// The poses of a pass, given by its points: both ends of each block, and between them as many as are no farther apart than told,
/// mm at the tip.
#[must_use]
pub fn along(machine: TiltingTable, points: &[Stand], apart: f64) -> Vec<Pose> {
    let pose = |stand: &Stand| {
        let [tip, along] = machine.tool(&stand.at, stand.B, stand.C);
        Pose { tip, along }
    };
    let mut poses: Vec<Pose> = points.first().map(pose).into_iter().collect();
    for pair in points.windows(2) {
        let (from, to) = (poses[poses.len() - 1], pose(&pair[1]));
        let steps = ((to.tip - from.tip).norm() / apart).ceil().clamp(1.0, BLOCK_POSES);
        let mut step = 1.0;
        while step < steps {
            poses.push(pose(&pair[0].towards(&pair[1], step / steps)));
            step += 1.0;
        }
        poses.push(to);
    }
    poses
}

/// Poses near each other.
#[derive(Clone, Debug)]
pub struct Bunch {
    /// From which to which in the order of the bunches.
    of: [usize; 2],
    /// The least of their numbers.
    first: usize,
    /// The mean of them.
    middle: Pose,
    /// δ (mm), θ (the length of a difference of unit vectors) and η (mm) of the derivation.
    off: [f64; 3],
    /// The bunch after this one and its parts.
    next: usize,
}

/// What a bunch of poses looks like from a point.
#[derive(Clone, Copy, Debug)]
pub struct BunchBounds {
    /// No pose has its axis nearer than this.
    pub beside: f64,
    /// No pose has its end lower below the point than this.
    pub up: f64,
}

/// The poses of some passes.
#[derive(Clone, Debug, Default)]
pub struct Poses {
    poses: Vec<Pose>,
    /// Their numbers, in the order of the bunches.
    order: Vec<usize>,
    /// A bunch comes before its parts.
    bunches: Vec<Bunch>,
}

impl Bunch {
    /// What it looks like from a point.
    #[must_use]
    pub fn bounds(&self, point: &Vector3<f64>) -> BunchBounds {
        let [beside, up] = self.middle.seen(point);
        let ([tip, turn, along], away) = (self.off, (point - self.middle.tip).norm());
        BunchBounds { beside: beside - (tip + turn * away), up: up + along + turn * (away + tip) }
    }
}

impl Poses {
    /// Poses in the order in which they are taken.
    #[must_use]
    pub fn new(poses: Vec<Pose>) -> Self {
        let order = (0..poses.len()).collect();
        let mut made = Self { poses, order, bunches: Vec::new() };
        if !made.poses.is_empty() {
            made.bunch([0, made.poses.len()]);
        }
        made
    }

    /// Those of passes, given by their points.
    #[must_use]
    pub fn along<'p>(machine: TiltingTable, passes: impl Iterator<Item = &'p [Stand]>) -> Self {
        Self::new(passes.flat_map(|points| along(machine, points, APART)).collect())
    }

    fn bunch(&mut self, [from, to]: [usize; 2]) {
        let Self { poses, order, .. } = self;
        let of = &mut order[from..to];
        let (mut low, mut high, mut tip, mut along) =
            ([f64::MAX; 3], [f64::MIN; 3], Vector3::zeros(), Vector3::zeros());
        for &number in of.iter() {
            let pose = &poses[number];
            tip += pose.tip;
            along += pose.along;
            for axis in 0..3 {
                low[axis] = low[axis].min(pose.tip[axis]);
                high[axis] = high[axis].max(pose.tip[axis]);
            }
        }
        #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
        let tip = tip / of.len() as f64;
        // Axes all around have no mean: any one of them will do.
        let along = along.try_normalize(1e-9).unwrap_or(poses[of[0]].along);
        let off = of.iter().fold([0.0_f64; 3], |[most, turn, high], &number| {
            let (by, turned) = (poses[number].tip - tip, (poses[number].along - along).norm());
            [most.max(by.norm()), turn.max(turned), high.max(by.dot(&along).abs())]
        });
        let first = of.iter().copied().min().unwrap_or_default();
        let half = (to - from) / 2;
        if to - from > FEW {
            let longest = (0..3).max_by(|&one, &other| (high[one] - low[one]).total_cmp(&(high[other] - low[other])));
            let axis = longest.unwrap_or_default();
            let place = |number: &usize| poses[*number].tip[axis];
            of.select_nth_unstable_by(half, |one, other| place(one).total_cmp(&place(other)).then(one.cmp(other)));
        }
        let at = self.bunches.len();
        self.bunches.push(Bunch { of: [from, to], first, middle: Pose { tip, along }, off, next: 0 });
        if to - from > FEW {
            self.bunch([from, from + half]);
            self.bunch([from + half, to]);
        }
        self.bunches[at].next = self.bunches.len();
    }

    /// The pose of this number, counted in the order in which they were given; `None` beyond the last.
    #[must_use]
    pub fn get(&self, at: usize) -> Option<&Pose> {
        self.poses.get(at)
    }

    /// The poses, with their numbers, of all bunches but those that are left out; in the order of the bunches.
    pub fn of(&self, mut out: impl FnMut(&Bunch) -> bool) -> impl Iterator<Item = (usize, &Pose)> {
        let (mut at, mut left) = (0, 0..0);
        std::iter::from_fn(move || {
            loop {
                if let Some(place) = left.next() {
                    let number = *self.order.get(place)?;
                    return Some((number, self.poses.get(number)?));
                }
                let bunch = self.bunches.get(at)?;
                if out(bunch) {
                    at = bunch.next;
                    continue;
                }
                at += 1;
                let [from, to] = bunch.of;
                if to - from <= FEW {
                    left = from..to;
                }
            }
        })
    }

    /// True where one of so many first poses holds a point.
    #[must_use]
    pub fn held_before(&self, before: usize, tool: Tool, point: &Vector3<f64>) -> bool {
        let far = |bunch: &Bunch| {
            let BunchBounds { beside, up } = bunch.bounds(point);
            bunch.first >= before || apart(tool, [beside, up]) > 0.0
        };
        self.of(far).any(|(number, pose)| number < before && pose.apart(tool, point) <= 0.0)
    }

    /// A pose at which a point is no farther from a tool than `over`: the nearest of those beside one that is known to be near,
    /// else any.
    #[must_use]
    pub fn holding(&self, tool: Tool, point: &Vector3<f64>, over: f64, near: usize) -> Option<usize> {
        let beside = near.saturating_sub(NEAR)..(near + NEAR).min(self.poses.len());
        let known = |at: usize| Some((self.poses.get(at)?.apart(tool, point), at));
        let nearest = beside.filter_map(known).min_by(|one, other| one.0.total_cmp(&other.0));
        if let Some((_, at)) = nearest.filter(|(apart, _)| *apart <= over) {
            return Some(at);
        }
        let far = |bunch: &Bunch| {
            let BunchBounds { beside, up } = bunch.bounds(point);
            apart(tool, [beside, up]) > over
        };
        self.of(far).find(|(_, pose)| pose.apart(tool, point) <= over).map(|(number, _)| number)
    }

    /// How far a point is from the tool at its nearest pose, as far as that is less than `most`; else `most`.
    #[must_use]
    pub fn apart(&self, tool: Tool, point: &Vector3<f64>, most: f64) -> f64 {
        let nearest = Cell::new(most);
        let far = |bunch: &Bunch| {
            let BunchBounds { beside, up } = bunch.bounds(point);
            apart(tool, [beside, up]) >= nearest.get()
        };
        for (_, pose) in self.of(far) {
            nearest.set(nearest.get().min(pose.apart(tool, point)));
        }
        nearest.get()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Poses on a bent way, leaning more and more.
    fn bent() -> Vec<Pose> {
        (0..500_u16)
            .map(|k| {
                let (sin, cos) = crate::number::trig::sin_cos(f64::from(k) * 0.01);
                let along = Vector3::new(0.3 * sin, 0.2 * cos, 1.0).try_normalize(1e-9).unwrap();
                Pose { tip: Vector3::new(20.0 * cos, 20.0 * sin, f64::from(k % 7) * 0.1), along }
            })
            .collect()
    }

    #[test]
    fn a_point_is_held_where_one_of_all_poses_holds_it() {
        let (all, tools) = (bent(), [Tool::flat(3.0), Tool { d: 3.0, r_c: 0.4 }, Tool::ball(3.0)]);
        let poses = Poses::new(all.clone());
        let mut held = 0;
        for k in 0..600_u16 {
            let (sin, cos) = crate::number::trig::sin_cos(f64::from(k) * 0.37);
            let out = 17.0 + f64::from(k % 60) * 0.1;
            let point = Vector3::new(out * cos, out * sin, f64::from(k % 11) * 0.1 - 0.3);
            for tool in tools {
                let one = all.iter().any(|pose| pose.apart(tool, &point) <= 0.02);
                let found = poses.holding(tool, &point, 0.02, usize::from(k));
                assert_eq!(found.is_some(), one, "{k} {tool:?}");
                assert!(found.is_none_or(|at| all[at].apart(tool, &point) <= 0.02));
                let before = usize::from(k);
                let early = all.iter().take(before).any(|pose| pose.apart(tool, &point) <= 0.0);
                assert_eq!(poses.held_before(before, tool, &point), early, "{k} {tool:?}");
                let nearest = all.iter().map(|pose| pose.apart(tool, &point)).fold(1.0, f64::min);
                assert_eq!(poses.apart(tool, &point, 1.0), nearest, "{k} {tool:?}");
                held += u32::from(one);
            }
        }
        assert!((300..1500).contains(&held), "{held}");
        assert_eq!(Poses::default().holding(tools[0], &Vector3::zeros(), 99.0, 7), None);
    }
}
