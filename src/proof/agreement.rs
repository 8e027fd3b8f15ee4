//! Agreement: the text says what was planned, motion by motion.
//!
//! Every position must be the planned one in every axis, on the grid of 0.001; and the tip, put back on the part by the
//! forward kinematics, must be within 0.001 mm of where the plan has it. The time of each motion must be the planned
//! one, and every blade and splitter must be cut once on both sides. The first difference ends the comparison: after
//! it, nothing fits any more.

use nalgebra::Vector3;

use crate::gcode::program::{Move, Program};
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::Rotary;
use crate::number::shown;
use crate::proof::check::{At, Check, FAULT, Verdict, mm};
use crate::proof::step::{Judge, Stage, Step, same};
use crate::proof::track::Track;
use crate::text::Text;

/// How far the tip may be from the plan, mm.
pub const LIMIT: f64 = 0.001;
/// By what fraction the time of a motion may differ: what the arithmetic of a control loses.
const TIME: f64 = 1e-6;

/// The point of the part at which the tip stands in a pose, mm.
#[must_use]
pub fn tip(machine: Rotary, pose: &Pose) -> Vector3<f64> {
    let point = Vector3::new(pose.get(Axis::X), pose.get(Axis::Y), pose.get(Axis::Z));
    machine.to_part(&point, pose.get(Axis::B).to_radians(), pose.get(Axis::C).to_radians())
}

/// How many passes of each track a program should make.
pub type PassCount = [usize; 4];

/// Holds a program against its plan.
#[derive(Debug)]
pub struct Agreement {
    machine: Rotary,
    expected: PassCount,
    made: PassCount,
    motions: usize,
    farthest: f64,
    different: Option<(At, Text)>,
}

impl Agreement {
    /// The judge of a program that should make these passes.
    #[must_use]
    pub fn new(machine: Rotary, expected: PassCount) -> Self {
        Self { machine, expected, made: [0; 4], motions: 0, farthest: 0.0, different: None }
    }

    fn compare(&mut self, step: &Step<'_>, planned: &Move<'_>) {
        let (motion, to) = (&step.motion, Pose::from(planned.to));
        let ends = [(&motion.to, to), (&motion.from, Pose::from(planned.from))];
        // A motion that begins elsewhere than planned was noticed where the last one ended, but for the first.
        for (read, plan) in ends.iter().take(if self.motions == 0 { 2 } else { 1 }) {
            let distance = (tip(self.machine, read) - tip(self.machine, plan)).norm();
            self.farthest = self.farthest.max(distance);
            if !same(read, plan) || distance > LIMIT {
                self.different = Some((At::motion(motion), position(read, plan)));
                return;
            }
        }
        let planned_time = planned.path.seconds(planned.step);
        let agree = match (motion.seconds, planned_time) {
            (Some(read), Some(plan)) => (read - plan).abs() <= TIME * plan,
            (None, None) => true,
            // A rapid move takes the time that the machine needs.
            _ => planned.path.rapid,
        };
        if !agree {
            self.different = Some((At::motion(motion), time(motion.seconds, planned_time)));
        }
    }
}

/// The first axis in which two poses differ.
fn position(read: &Pose, plan: &Pose) -> Text {
    let differences = read.differences(plan);
    let worst = Axis::ALL
        .into_iter()
        .max_by(|one, other| differences[*one as usize].abs().total_cmp(&differences[*other as usize].abs()))
        .unwrap_or(Axis::X);
    let (letter, unit) = (worst.letter(), if worst.rotary() { "°" } else { " mm" });
    let (read, plan) = (shown(read.get(worst), 4), shown(plan.get(worst), 4));
    Text::new(
        format!("{letter} llega a {read}{unit} y el plan dice {plan}{unit}"),
        format!("{letter} goes to {read}{unit} where the plan has {plan}{unit}"),
    )
}

fn time(read: Option<f64>, plan: Option<f64>) -> Text {
    let seconds = |time: Option<f64>| time.map_or_else(|| "–".to_owned(), |time| format!("{} s", shown(time, 4)));
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
        match &step.stage {
            Stage::Positioning => return,
            Stage::Planned(planned) => self.compare(step, planned),
            Stage::Unplanned => {
                let what = Text::fixed("hay un movimiento que no está en el plan", "there is a motion beyond the plan");
                self.different = Some((At::motion(&step.motion), what));
            }
        }
        self.motions += 1;
        if let Some(cut) = step.cut()
            && cut.points == [None, None]
            && let Some(made) = Track::ALL.iter().position(|track| *track == cut.track)
        {
            self.made[made] += 1;
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
        let planned = program.moves().count();
        if self.different.is_none() && self.motions != planned {
            let what = Text::new(
                format!("el texto acaba tras {} movimientos de {planned}", self.motions),
                format!("the text ends after {} of {planned} motions", self.motions),
            );
            self.different = Some((At { line: 1, n: None, point: None }, what));
        }
        let name = Text::fixed("Cada punto, como en el plan", "Every point as planned");
        let value = Text::new(
            format!("{} movimientos; {}", self.motions, mm(self.farthest)),
            format!("{} motions; {}", self.motions, mm(self.farthest)),
        );
        let limit = Text::new(format!("{planned}; {}", mm(LIMIT)), format!("{planned}; {}", mm(LIMIT)));
        let points = Check::passed("agreement", name, program, value, limit);
        let points = match self.different.take() {
            None => points,
            Some((at, what)) => points.at(Some(at)).found(
                Verdict::Stop,
                Text::new(
                    format!("«{}» no es lo planeado en la {}: {}", program.title.es, at.words().es, what.es),
                    format!("\"{}\" is not what was planned at {}: {}", program.title.en, at.words().en, what.en),
                ),
                FAULT,
            ),
        };
        let list = |passes: PassCount| passes.map(|count| count.to_string()).join(" + ");
        let name = Text::fixed(
            "Pasadas: anverso + reverso + intermedio, ida + vuelta",
            "Passes: obverse + reverse + splitter, out + back",
        );
        let (made, expected) = (list(self.made), list(self.expected));
        let passes = Check::passed("passes", name, program, Text::same(made.as_str()), Text::same(expected.as_str()));
        let passes = if self.made == self.expected {
            passes
        } else {
            passes.found(
                Verdict::Stop,
                Text::new(
                    format!("«{}» hace {made} pasadas y deben ser {expected}", program.title.es),
                    format!("\"{}\" makes {made} passes where {expected} are due", program.title.en),
                ),
                FAULT,
            )
        };
        vec![points, passes]
    }
}
