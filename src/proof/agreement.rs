//! Agreement: the text says what was planned, motion by motion.
//!
//! Every motion must end at the planned position in every axis, run as planned, straight at feed, at rapid or along the planned
//! arc, and take the planned time. On a machine whose forward kinematics are known the tip, put back on the part, must be
//! within 0.001 mm of where the plan has it. The first difference ends the comparison: after it, nothing fits any more.

use nalgebra::Vector3;

use crate::finding::Raise;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::Program;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::TiltingTable;
use crate::number::shown;
use crate::proof::check::{At, Check, Extreme, Question, mm};
use crate::proof::rules::NotAsPlanned;
use crate::proof::step::{Interpolation, Judge, Planned, SAME, Stage, Step, Time};
use crate::proof::three_axes::Route;
use crate::text::{Text, t};

/// How far the tip may be from the plan, mm.
pub const LIMIT: f64 = 0.001;
/// By what fraction the time of a motion may differ: what the arithmetic of a control loses.
const TIME: f64 = 1e-6;
/// How far a position may be from the plan where the tip is not compared: what the decimals of a published program leave.
const DECIMALS: f64 = 1e-6;

/// The point of the part at which the tip stands in a pose, mm.
#[must_use]
pub fn tip(machine: TiltingTable, pose: &Pose) -> Vector3<f64> {
    let point = Vector3::new(pose.get(Axis::X), pose.get(Axis::Y), pose.get(Axis::Z));
    machine.to_part(&point, pose.get(Axis::B).to_radians(), pose.get(Axis::C).to_radians())
}

/// What a program is compared by.
#[derive(Clone, Copy, Debug)]
enum By {
    /// All axes, and the tip over the part.
    Tip(TiltingTable),
    /// These axes alone.
    Axes(&'static [Axis]),
}

/// Holds a program against its plan.
#[derive(Debug)]
pub struct Agreement {
    by: By,
    planned: usize,
    /// How many of them are rapid moves that are not reported.
    untold: usize,
    /// How many rapid moves may bring the machine to the start.
    approach: Option<usize>,
    positioned: usize,
    agreed: usize,
    told: usize,
    farthest: Extreme,
    different: Option<(At, Text)>,
}

impl Agreement {
    /// The judge of a program on a machine that turns tool and part.
    #[must_use]
    pub fn of_the_tip(machine: TiltingTable, program: &Program) -> Self {
        Self::new(By::Tip(machine), program.moves().count(), 0)
    }

    /// The judge of a torch's program by the axes that it moves, with so many moves of which some are rapid.
    #[must_use]
    pub const fn of_the_torch(axes: &'static [Axis], planned: usize, rapid: usize) -> Self {
        Self::new(By::Axes(axes), planned, rapid)
    }

    /// The judge of a program that should run a route: every axis of every motion, rapid moves too.
    #[must_use]
    pub const fn along(route: &Route) -> Self {
        Self::new(By::Axes(&Axis::ALL), route.motions(), 0)
    }

    /// The judge, where the number of rapid moves to the start is known.
    #[must_use]
    pub const fn approached_by(mut self, rapid: usize) -> Self {
        self.approach = Some(rapid);
        self
    }

    const fn new(by: By, planned: usize, untold: usize) -> Self {
        let farthest = Extreme::nothing();
        Self { by, planned, untold, approach: None, positioned: 0, agreed: 0, told: 0, farthest, different: None }
    }

    /// In what a motion is other than planned.
    fn difference(&mut self, motion: &Motion, planned: &Planned<'_>) -> Option<Text> {
        let first = self.agreed == 0;
        if first && self.approach.is_some_and(|approach| approach != self.positioned) {
            return Some(t("no va en rápido a la perforación", "it is not a rapid move to the pierce"));
        }
        // A motion that begins elsewhere than planned was noticed where the last one ended, but for the first.
        let ends = [(&motion.to, &planned.to), (&motion.from, &planned.from)];
        for (read, plan) in ends.into_iter().take(if first { 2 } else { 1 }) {
            let (axes, close): (&[Axis], f64) = match self.by {
                By::Tip(machine) => {
                    let distance = (tip(machine, read) - tip(machine, plan)).norm();
                    self.farthest.take(distance, At::motion(motion));
                    if distance.is_nan() || distance > LIMIT {
                        return Some(position(read, plan, &Axis::ALL));
                    }
                    (&Axis::ALL, SAME)
                }
                By::Axes(axes) => (axes, DECIMALS),
            };
            if !axes.iter().all(|axis| (read.get(*axis) - plan.get(*axis)).abs() <= close) {
                return Some(position(read, plan, axes));
            }
        }
        if !runs(&motion.kind, planned.interpolation) {
            return Some(t(
                "no va como dice el plan: en rápido, recto o en arco",
                "it does not run as planned: rapid, straight or along an arc",
            ));
        }
        let agrees = match (motion.seconds, planned.time) {
            (_, Time::Free) | (None, Time::Unknown) => true,
            (Some(read), Time::Seconds(plan)) => (read - plan).abs() <= TIME * plan,
            (Some(_), Time::Unknown) | (None, Time::Seconds(_)) => false,
        };
        (!agrees).then(|| time(motion.seconds, planned.time))
    }
}

/// True where a motion runs as planned.
fn runs(kind: &MotionKind, interpolation: Interpolation) -> bool {
    match (kind, interpolation) {
        (MotionKind::Rapid, Interpolation::Rapid) | (MotionKind::Feed(_), Interpolation::Straight) => true,
        // A radius given to three or six decimals moves the centre, and so the radius read back, by rounding only.
        (MotionKind::Arc(arc, _), Interpolation::Arc { clockwise, radius }) => {
            (arc.turns < 0) == clockwise && (arc.radius - radius).abs() <= 1e-6 * radius.max(1.0)
        }
        _ => false,
    }
}

/// The axis in which two poses differ most.
fn position(read: &Pose, plan: &Pose, axes: &[Axis]) -> Text {
    let off = |axis: &Axis| (read.get(*axis) - plan.get(*axis)).abs();
    let worst = axes.iter().copied().max_by(|one, other| off(one).total_cmp(&off(other))).unwrap_or(Axis::X);
    let (letter, unit) = (worst.letter(), if worst.rotary() { "°" } else { " mm" });
    let (read, plan) = (shown(read.get(worst), 4), shown(plan.get(worst), 4));
    Text::new(
        format!("{letter} llega a {read}{unit} y el plan dice {plan}{unit}"),
        format!("{letter} goes to {read}{unit} where the plan has {plan}{unit}"),
    )
}

fn time(read: Option<f64>, plan: Time) -> Text {
    let seconds = |time: Option<f64>| time.map_or_else(|| "–".to_owned(), |time| format!("{} s", shown(time, 4)));
    let plan = if let Time::Seconds(plan) = plan { Some(plan) } else { None };
    let (read, plan) = (seconds(read), seconds(plan));
    Text::new(
        format!("el movimiento dura {read} y el plan dice {plan}"),
        format!("the motion takes {read} where the plan has {plan}"),
    )
}

impl Judge for Agreement {
    fn see(&mut self, step: &Step<'_>) {
        if self.different.is_some() {
            return;
        }
        let what = match &step.stage {
            Stage::Still | Stage::Away => return,
            Stage::Positioning => {
                self.positioned += 1;
                return;
            }
            Stage::Planned(planned) => self.difference(&step.motion, planned),
            Stage::Unplanned => {
                Some(t("hay un movimiento que no está en el plan", "there is a motion beyond the plan"))
            }
        };
        self.different = what.map(|what| (At::motion(&step.motion), what));
        if self.different.is_none() {
            self.agreed += 1;
            self.told += usize::from(self.untold == 0 || !matches!(step.motion.kind, MotionKind::Rapid));
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let Self { planned, agreed, told, .. } = *self;
        let different = self.different.or_else(|| {
            (agreed != planned).then(|| {
                let what = Text::new(
                    format!("el texto acaba tras {agreed} movimientos de {planned}"),
                    format!("the text ends after {agreed} of {planned} motions"),
                );
                (At::line(1), what)
            })
        });
        let wanted = planned - self.untold.min(planned);
        let (name, value, limit) = match self.by {
            By::Tip(_) => {
                let (far, most) = (mm(self.farthest.value()), mm(LIMIT));
                let value = Text::new(format!("{told} movimientos; {far}"), format!("{told} motions; {far}"));
                (t("Cada punto, como en el plan", "Every point as planned"), value, format!("{wanted}; {most}"))
            }
            By::Axes(_) => {
                let value = Text::new(format!("{told} movimientos"), format!("{told} motions"));
                (t("Cada movimiento, como en el plan", "Every motion as planned"), value, wanted.to_string())
            }
        };
        let asked = Question::new("agreement", name, program).showing(value, Text::same(limit)).seen(planned);
        vec![asked.at(different.as_ref().map(|(at, _)| *at)).unless(different.map(|(at, difference)| {
            let (at, program) = (at.words(), program.title.clone());
            move |place| NotAsPlanned { at, difference, program }.at(place)
        }))]
    }
}
