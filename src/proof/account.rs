//! What a program comes to: how far it reaches, where it ends, how long its path is and how long it takes.

use crate::finding::{Finding, Place, Raise};
use crate::gcode::interpreter::{FromStart, Interpreter};
use crate::gcode::motion::{Motion, MotionKind};
use crate::machine::axis::{Axis, Pose};
use crate::machine::rapids::Rapids;
use crate::number::grid::HALF;
use crate::number::{shown, trig};
use crate::proof::rules::{IncrementsClose, IncrementsShift, IncrementsTurn};
use crate::proof::step::{Stage, Step};

/// How far each axis reaches; mm and degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extents {
    /// The least position of each axis.
    pub least: Pose,
    /// The greatest position of each axis.
    pub greatest: Pose,
}

impl Extents {
    const fn at(pose: Pose) -> Self {
        Self { least: pose, greatest: pose }
    }

    /// The least and the greatest position of an axis.
    #[must_use]
    pub const fn of(&self, axis: Axis) -> [f64; 2] {
        [self.least.get(axis), self.greatest.get(axis)]
    }

    fn reach(&mut self, pose: &Pose) {
        for axis in 0..pose.0.len() {
            let (at, least, greatest) = (pose.0[axis], &mut self.least.0[axis], &mut self.greatest.0[axis]);
            *least = if at < *least { at } else { *least };
            *greatest = if at > *greatest { at } else { *greatest };
        }
    }

    fn reach_along(&mut self, axis: Axis, at: f64) {
        let (least, greatest) = (self.least.get(axis), self.greatest.get(axis));
        self.least.set(axis, least.min(at));
        self.greatest.set(axis, greatest.max(at));
    }
}

/// What a program comes to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Account {
    /// How many motions there are.
    pub motions: u64,
    /// How far each axis reaches in program coordinates: to where motions end, and to where arcs pass. Where the machine stood
    /// before the first motion is no position of the program. `None` where there is no motion.
    pub program: Option<Extents>,
    /// How far each axis reaches in machine coordinates.
    pub machine: Option<Extents>,
    /// How far each axis reaches in program coordinates while it moves at feed, from where such motions begin.
    pub feed: Option<Extents>,
    /// The axes whose extents hang on where the turret of a lathe stood before the program, as who read it says.
    pub from_start: FromStart,
    /// Length of the path of X, Y and Z at feed, mm.
    pub feed_path: f64,
    /// Length of the path of X, Y and Z at rapid, mm.
    pub rapid_path: f64,
    /// The time of what moves at feed and of dwells, s.
    pub seconds: f64,
    /// True where a motion at feed has no known time.
    pub untimed: bool,
    /// How fast the machine is where it does not cut.
    pub rapids: Rapids,
    /// The time of the rapid motions whose time is known, s.
    pub rapid_seconds: f64,
    /// True where the time of a rapid motion is not known: its axis has no rate.
    pub untimed_rapids: bool,
    /// How often the tool is changed.
    pub tool_changes: u32,
    /// The tool of the last motion.
    tool: u32,
    /// It has come to its start.
    began: bool,
    /// Where axes went on the way to the start.
    positioned: Vec<(Axis, f64)>,
    /// Where the program ends, in program and machine coordinates.
    pub end: [Pose; 2],
}

impl Account {
    /// Nothing yet, on a machine that is so fast.
    #[must_use]
    pub fn on(rapids: Rapids) -> Self {
        Self { rapids, ..Self::default() }
    }

    /// Takes a motion into account. `before` is the machine position before it.
    pub fn take(&mut self, motion: &Motion, before: &Pose) {
        self.motions += 1;
        self.end = [motion.to, motion.machine];
        let seconds = motion.seconds.unwrap_or_default();
        if matches!(motion.kind, MotionKind::Dwell(_)) {
            self.seconds += seconds;
            return;
        }
        self.reach(&motion.to);
        let machine = self.machine.get_or_insert(Extents::at(motion.machine));
        machine.reach(&motion.machine);
        let by = motion.to.differences(&motion.from);
        let straight = (by[0] * by[0] + by[1] * by[1] + by[2] * by[2]).sqrt();
        if matches!(motion.kind, MotionKind::Rapid) {
            self.rapid_path += straight;
            // The slides move as the machine counts, whatever a shift of the zero does to the program's positions.
            match self.rapids.seconds(&motion.machine.differences(before)) {
                Some(seconds) => self.rapid_seconds += seconds,
                None => self.untimed_rapids = true,
            }
            return;
        }
        let feed = self.feed.get_or_insert(Extents::at(motion.from));
        feed.reach(&motion.from);
        feed.reach(&motion.to);
        if let MotionKind::Arc(arc, _) = motion.kind {
            let [_, _, across] = arc.plane.axes();
            self.feed_path += arc.length(by[across as usize]);
            let program = self.program.get_or_insert(Extents::at(motion.to));
            arc.quarters(&motion.from, &motion.to, &mut |axis, at| {
                program.reach_along(axis, at);
                feed.reach_along(axis, at);
                let offset = motion.machine.get(axis) - motion.to.get(axis);
                if arc.rotation == 0.0 || axis == Axis::Z {
                    machine.reach_along(axis, at + offset);
                }
            });
            if arc.rotation != 0.0 {
                let (sin, cos) = trig::sin_cos(arc.rotation.to_radians());
                for (axis, [x, y]) in [(Axis::X, [cos, -sin]), (Axis::Y, [sin, cos])] {
                    arc.farthest(&motion.from, &motion.to, [x, y, 0.0], &mut |at| {
                        let by = at.differences(&motion.to);
                        machine.reach_along(axis, motion.machine.get(axis) + by[0] * x + by[1] * y);
                    });
                }
            }
        } else {
            self.feed_path += straight;
        }
        self.seconds += seconds;
        self.untimed |= motion.seconds.is_none();
    }

    /// Takes a motion beside its plan into account. Where the machine comes from, and where the tool is taken away to first of
    /// all, the program does not say: of the way to its start only the axes count that it moves, and neither path nor time.
    pub(super) fn see(&mut self, step: &Step<'_>, before: &Pose) {
        let Step { motion, in_force, stage } = step;
        self.holds(in_force.tool);
        match stage {
            Stage::Still if matches!(motion.kind, MotionKind::Dwell(_)) => self.take(motion, before),
            Stage::Still => self.motions += 1,
            _ if self.on_its_way(step) => {
                self.motions += 1;
                let moved = |axis: &Axis| motion.from.get(*axis) != motion.to.get(*axis);
                self.positioned.extend(Axis::ALL.into_iter().filter(moved).map(|axis| (axis, motion.to.get(axis))));
            }
            Stage::Away | Stage::Positioning | Stage::Planned(_) | Stage::Unplanned => {
                if !self.began && matches!(stage, Stage::Planned(_)) {
                    // Where the plan begins is a position of the program, whether it goes there itself or not.
                    self.reach(&motion.from);
                }
                self.began = true;
                for (axis, at) in std::mem::take(&mut self.positioned) {
                    self.program.get_or_insert(Extents::at(motion.from)).reach_along(axis, at);
                }
                self.take(motion, before);
            }
        }
    }

    /// True for a motion to where the program starts: one that the plan says so of, or, without a plan, the rapid ones before
    /// the first feed.
    const fn on_its_way(&self, step: &Step<'_>) -> bool {
        match step.stage {
            Stage::Positioning | Stage::Away => true,
            Stage::Unplanned => !self.began && matches!(step.motion.kind, MotionKind::Rapid),
            Stage::Still | Stage::Planned(_) => false,
        }
    }

    /// Takes a position of the program into account.
    fn reach(&mut self, at: &Pose) {
        self.program.get_or_insert(Extents::at(*at)).reach(at);
    }

    /// Takes into account which tool is in the spindle during the next motion; 0 for none.
    pub fn holds(&mut self, tool: u32) {
        self.tool_changes += u32::from(tool != self.tool);
        self.tool = tool;
    }

    /// The cycle time: feed, dwells, rapid motions and changes of the tool, s; `None` where the time of a motion is not known, or no
    /// rate of rapid motions, without which a program that begins with them has no cycle time.
    /// Axes are taken to be at their speed at once: a machine that must accelerate them takes longer.
    #[must_use]
    pub fn cycle_seconds(&self) -> Option<f64> {
        let changes = f64::from(self.tool_changes) * self.rapids.tool_change.unwrap_or_default();
        let known = self.rapids.linear.or(self.rapids.rotary).is_some();
        (known && !self.untimed && !self.untimed_rapids).then_some(self.seconds + self.rapid_seconds + changes)
    }
}

/// What is to say about where a program ends whose every motion is incremental: run again, it starts there.
#[must_use]
pub fn drift(interpreter: &Interpreter<'_>, start: &Pose) -> Option<Finding> {
    if !interpreter.all_incremental() {
        return None;
    }
    let net = interpreter.position().1.differences(start);
    let moved = |axis: &Axis| net[*axis as usize].abs() >= HALF;
    let list = Axis::ALL
        .into_iter()
        .filter(|axis| moved(axis) || matches!(axis, Axis::X | Axis::Y | Axis::Z))
        .map(|axis| format!("{} {}", axis.letter(), shown(net[axis as usize], 3)))
        .collect::<Vec<_>>()
        .join("  ");
    let linear = Axis::ALL.into_iter().any(|axis| !axis.rotary() && moved(&axis));
    let turned = Axis::ALL.into_iter().any(|axis| axis.rotary() && moved(&axis));
    let finding = if linear {
        IncrementsShift {}.at(Place::File)
    } else if turned {
        IncrementsTurn {}.at(Place::File)
    } else {
        IncrementsClose {}.at(Place::File)
    };
    Some(finding.with(list, "X 0  Y 0  Z 0"))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::gcode::control::LINUXCNC;
    use crate::gcode::interpreter::Setting;
    use crate::proof::step::{Interpolation, Planned, Time};

    /// The extents of an arc in machine coordinates, from many points along it.
    fn sampled(motion: &Motion) -> Extents {
        let MotionKind::Arc(arc, _) = motion.kind else { unreachable!("an arc") };
        let (sin, cos) = trig::sin_cos(arc.rotation.to_radians());
        let [a, b, _] = arc.plane.axes();
        let mut extents: Option<Extents> = None;
        let [x, y] = [motion.from.get(a) - arc.centre[0], motion.from.get(b) - arc.centre[1]];
        let start = trig::atan2(y, x);
        for step in 0..=20_000_u16 {
            let part = f64::from(step) / 20_000.0;
            let (up, along) = trig::sin_cos(start + arc.sweep * part);
            let mut at = Pose(std::array::from_fn(|axis| {
                motion.from.0[axis] + (motion.to.0[axis] - motion.from.0[axis]) * part - motion.to.0[axis]
            }));
            at.set(a, arc.centre[0] + arc.radius * along - motion.to.get(a));
            at.set(b, arc.centre[1] + arc.radius * up - motion.to.get(b));
            let [x, y, z] = [at.0[0], at.0[1], at.0[2]];
            let mut machine = motion.machine;
            for (axis, by) in [(Axis::X, x * cos - y * sin), (Axis::Y, x * sin + y * cos), (Axis::Z, z)] {
                machine.set(axis, machine.get(axis) + by);
            }
            extents.get_or_insert(Extents::at(machine)).reach(&machine);
        }
        extents.unwrap()
    }

    #[test]
    fn where_a_plan_begins_counts_with_the_rapids_as_it_does_at_feed() {
        let mut interpreter = Interpreter::over(b"G21 G91 G1 X10 F100\nG0 X5\nM2\n", Setting::new(&LINUXCNC));
        let mut account = Account::default();
        while let Some(motion) = interpreter.next() {
            let motion = motion.unwrap();
            let (from, to) = (motion.from, motion.to);
            let planned = Planned {
                from,
                to,
                interpolation: Interpolation::Straight,
                time: Time::Free,
                line: None,
                leg: 0,
                path: None,
            };
            let step = Step { motion, in_force: *interpreter.in_force(), stage: Stage::Planned(planned) };
            account.see(&step, &from);
        }
        assert_eq!(account.feed.map(|feed| feed.of(Axis::X)), Some([0.0, 10.0]));
        assert_eq!(account.program.map(|whole| whole.of(Axis::X)), Some([0.0, 15.0]));
    }

    #[test]
    fn without_a_rate_there_is_no_cycle_time() {
        let of = |rapids| Account { seconds: 9.0, ..Account::on(rapids) }.cycle_seconds();
        assert_eq!(of(Rapids::default()), None);
        assert_eq!(of(Rapids { tool_change: Some(4.0), ..Rapids::default() }), None);
        assert_eq!(of(Rapids { linear: Some(6000.0), ..Rapids::default() }), Some(9.0));
    }

    proptest! {
        #[test]
        fn arcs_reach_as_far_as_their_points_under_any_rotation(
            plane in 17_u8..20, code in 2_u8..4, rotation in -180.0..180.0_f64, i in -50.0..50.0_f64,
            j in 1.0..50.0_f64, turn in 0.1..6.2_f64, rise in -200.0..200.0_f64, P in 1_u8..4,
        ) {
            let (sin, cos) = trig::sin_cos(turn);
            let end = [i - i * cos + j * sin, j - i * sin - j * cos];
            let [first, second, across, I, J] = match plane {
                17 => ["X", "Y", "Z", "I", "J"],
                18 => ["Z", "X", "Y", "K", "I"],
                _ => ["Y", "Z", "X", "J", "K"],
            };
            let text = format!(
                "G10 L2 P2 X5 Y-7 R{rotation:.9}\nG55 G{plane} G21 G0 X0 Y0 Z0\nG{code} {first}{:.9} {second}{:.9} \
                 {across}{rise:.9} {I}{i:.9} {J}{j:.9} P{P} F100\nM2\n",
                end[0], end[1]
            );
            let interpreter = Interpreter::over(text.as_bytes(), Setting::new(&LINUXCNC));
            let mut before = interpreter.position().1;
            let mut found = None;
            for motion in interpreter {
                let motion = motion.unwrap();
                let mut account = Account { machine: Some(Extents::at(before)), ..Account::default() };
                account.take(&motion, &before);
                before = motion.machine;
                found = Some((motion, account.machine.unwrap()));
            }
            let (motion, found) = found.unwrap();
            let expected = sampled(&motion);
            let all = [(found.least, expected.least, -1.0), (found.greatest, expected.greatest, 1.0)];
            for (found, expected, outwards) in all {
                for by in found.differences(&expected) {
                    prop_assert!((-1e-7..1e-4).contains(&(by * outwards)), "{found:?} {expected:?}\n{text}");
                }
            }
        }
    }
}
