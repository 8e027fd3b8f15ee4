//! Programs of three axes that are written block by block: what they should do, and judges that any of them can have.
//!
//! A kind says its motions once more, from its design alone: the [`Route`]. Its plan is that of
//! [`Method::plan`](crate::kind::method::Method::plan); [`Agreement::along`](crate::proof::agreement::Agreement::along) compares
//! every motion of the text with it, rapid moves too: where it goes, how it runs and how long it takes. The judges here ask what
//! does not follow from a route.
//!
//! # Units
//! Millimetres, mm/min, revolutions per minute.

use crate::finding::Raise;
use crate::gcode::feed_law::FeedLaw;
use crate::gcode::feed_word::FeedWord;
use crate::gcode::in_force::{InForce, Speed, Spindle};
use crate::gcode::motion::MotionKind;
use crate::gcode::program::Program;
use crate::machine::axis::{Axis, Pose};
use crate::number::grid::Milli;
use crate::number::shown;
use crate::proof::check::{At, Check, Question};
use crate::proof::rules::NotAsPlanned;
use crate::proof::step::{Interpolation, Judge, Plan, Planned, SAME, Step, Time, same};
use crate::text::{Text, t};

/// The motions that a program should make, in order, rapid moves too.
///
/// The first one begins where the reading does: at zero in each axis. Places are those of the program's numbers, in steps of
/// 0.001 mm; a place that no program may carry agrees with no motion.
#[derive(Clone, Debug, Default)]
pub struct Route {
    at: Pose,
    moves: Vec<Planned<'static>>,
}

impl Route {
    /// A rapid move to these coordinates, mm; the other axes stand still. One to where the tool is already is no motion.
    pub fn rapid(&mut self, to: impl IntoIterator<Item = (Axis, f64)>) {
        let from = self.go(to);
        if !same(&from, &self.at) {
            self.push(from, Interpolation::Rapid, Time::Free);
        }
    }

    /// A straight move at F, mm/min along the path, with the F word that is no faster.
    pub fn feed(&mut self, to: impl IntoIterator<Item = (Axis, f64)>, F: f64) {
        let from = self.go(to);
        let way = self.at.differences(&from).iter().map(|by| by * by).sum::<f64>().sqrt();
        let word = FeedWord::lasting(FeedLaw::Resultant, 60.0 * way / F, way).map_or(f64::NAN, FeedWord::value);
        self.push(from, Interpolation::Straight, Time::Seconds(60.0 * way / word));
    }

    /// Goes on to a place; where the tool was.
    fn go(&mut self, to: impl IntoIterator<Item = (Axis, f64)>) -> Pose {
        let from = self.at;
        for (axis, place) in to {
            self.at.set(axis, Milli::round(place).map_or(f64::NAN, Milli::value));
        }
        from
    }

    fn push(&mut self, from: Pose, interpolation: Interpolation, time: Time) {
        let (to, leg) = (self.at, self.moves.len());
        self.moves.push(Planned { from, to, interpolation, time, line: None, leg, path: None });
    }

    /// How many motions there are.
    #[must_use]
    pub const fn motions(&self) -> usize {
        self.moves.len()
    }

    /// The moves so far as the plan of a program; every axis begins at zero.
    #[must_use]
    pub fn plan<'a>(self) -> Plan<'a> {
        let moves: Vec<Planned<'a>> = self.moves;
        Plan::from_zero(moves.into_iter())
    }
}

/// What was first found other than planned.
#[derive(Debug, Default)]
struct First {
    seen: usize,
    found: Option<(At, Text)>,
}

impl First {
    fn take(&mut self, step: &Step<'_>, difference: impl FnOnce() -> Option<Text>) {
        self.seen += 1;
        if self.found.is_none() {
            self.found = difference().map(|difference| (At::motion(&step.motion), difference));
        }
    }

    fn check(self, asked: Question, program: &Program) -> Check {
        let asked = asked.seen(self.seen).at(self.found.as_ref().map(|(at, _)| *at));
        asked.unless(self.found.map(|(at, difference)| {
            let (at, program) = (at.words(), program.title.clone());
            move |place| NotAsPlanned { at, difference, program }.at(place)
        }))
    }
}

/// Asks that no rapid move is below a plane, but for one straight up.
#[derive(Debug)]
pub struct RapidsAbove {
    plane: f64,
    first: First,
}

impl RapidsAbove {
    /// The judge of a program whose rapid moves keep to Z `plane`, mm, and above.
    #[must_use]
    pub fn the_plane(plane: f64) -> Self {
        Self { plane, first: First::default() }
    }
}

impl Judge for RapidsAbove {
    fn see(&mut self, step: &Step<'_>) {
        if !matches!(step.motion.kind, MotionKind::Rapid) {
            return;
        }
        let plane = self.plane;
        self.first.take(step, || {
            let by = step.motion.to.differences(&step.motion.from);
            let straight = Axis::ALL.into_iter().all(|axis| axis == Axis::Z || by[axis as usize].abs() < SAME);
            let low = step.ends().map(|pose| pose.get(Axis::Z)).find(|z| *z < plane - SAME || z.is_nan())?;
            (!straight || by[Axis::Z as usize] < 0.0).then(|| {
                let [low, plane] = [low, plane].map(|z| shown(z, 3));
                Text::new(
                    format!("el movimiento en rápido pasa por Z {low} mm, bajo el plano de seguridad, Z {plane} mm"),
                    format!("the rapid move is at Z {low} mm, below the clearance plane, Z {plane} mm"),
                )
            })
        });
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("En rápido, sobre el plano de seguridad", "Rapid moves above the clearance plane");
        let value =
            Text::new(format!("{} movimientos en rápido", self.first.seen), format!("{} rapid moves", self.first.seen));
        let limit = Text::same(format!("Z {} mm", shown(self.plane, 3)));
        vec![self.first.check(Question::new("clearance", name, program).showing(value, limit), program)]
    }
}

/// Asks that the spindle turns as it should in every motion at feed.
#[derive(Debug)]
pub struct SpindleTurns {
    spindle: Spindle,
    /// Revolutions per minute.
    S: f64,
    first: First,
}

impl SpindleTurns {
    /// The judge of a program that cuts with the spindle turning so, at S, rpm.
    #[must_use]
    pub fn at(spindle: Spindle, S: u32) -> Self {
        Self { spindle, S: f64::from(S), first: First::default() }
    }
}

/// How a spindle turns, as a program says so.
fn words(spindle: Spindle, speed: Speed) -> String {
    match speed {
        Speed::Revolutions(S) => format!("{} S{}", spindle.code(), shown(S, 3)),
        Speed::Surface(V) => format!("{} G96 S{}", spindle.code(), shown(V, 3)),
    }
}

impl Judge for SpindleTurns {
    fn see(&mut self, step: &Step<'_>) {
        if !matches!(step.motion.kind, MotionKind::Feed(_) | MotionKind::Arc(..)) {
            return;
        }
        let InForce { spindle, speed, .. } = step.in_force;
        let (planned, S) = (self.spindle, self.S);
        let turns = matches!(speed, Speed::Revolutions(read) if (read - S).abs() < 0.5) && spindle == planned;
        self.first.take(step, || {
            (!turns).then(|| {
                let [read, plan] = [words(spindle, speed), words(planned, Speed::Revolutions(S))];
                Text::new(
                    format!("el husillo va con {read} y el plan dice {plan}"),
                    format!("the spindle runs with {read} where the plan has {plan}"),
                )
            })
        });
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Husillo en cada movimiento de corte", "Spindle in every cutting motion");
        let seen = self.first.seen;
        let value = Text::new(format!("{seen} movimientos"), format!("{seen} motions"));
        let limit = Text::same(words(self.spindle, Speed::Revolutions(self.S)));
        vec![self.first.check(Question::new("spindle", name, program).showing(value, limit), program)]
    }
}
