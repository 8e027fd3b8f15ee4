//! The proof: hole i stands at its angle.

use rodete::finding::{Place, Raise, Size};
use rodete::gcode::motion::MotionKind;
use rodete::gcode::program::Program;
use rodete::machine::axis::Axis;
use rodete::parameter::t;
use rodete::proof::check::{At, Check, Verdict, mm};
use rodete::proof::step::{Judge, Step, watch};
use rodete::proof::verification::reading;
use rodete::text::Text;

use crate::design::BoltCircle;
use crate::rules::Astray;

/// How far a hole may be from its place: the grid of the program's numbers, mm.
const MOST: f64 = 0.001;

/// Looks at each motion that drills.
struct HolesAtAngles<'a> {
    circle: &'a BoltCircle,
    drilled: u32,
    worst: (f64, u32, Option<At>),
}

impl Judge for HolesAtAngles<'_> {
    fn see(&mut self, step: &Step<'_>) {
        if matches!(step.motion.kind, MotionKind::Feed(_)) {
            let [x, y] = self.circle.at(self.drilled);
            let (to, deep) = (&step.motion.to, step.motion.to.get(Axis::Z) + self.circle.h);
            let by = (to.get(Axis::X) - x).hypot(to.get(Axis::Y) - y).max(deep.abs());
            self.drilled += 1;
            if by >= self.worst.0 {
                self.worst = (by, self.drilled, Some(At::motion(&step.motion)));
            }
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
        let (by, hole, at) = self.worst;
        let value = Text::new(
            format!("{} agujeros, a {}", self.drilled, mm(by)),
            format!("{} holes, within {}", self.drilled, mm(by)),
        );
        let limit = Text::same(format!("{}, {}", self.circle.N, mm(MOST)));
        let name = t("Cada agujero en su ángulo", "Every hole at its angle");
        let check = Check::passed("angles", name, program, value, limit).at(at);
        if self.drilled == self.circle.N && by <= MOST {
            return vec![check];
        }
        let found = Astray { hole, by: Size::mm(by) }.at(Place::File);
        vec![check.found(Verdict::Stop, found.what, found.remedy)]
    }
}

pub fn judge(circle: &BoltCircle, program: &Program) -> Vec<Check> {
    let mut text = program.read_back();
    let mut holes = HolesAtAngles { circle, drilled: 0, worst: (0.0, 0, None) };
    let read = watch(program, &mut text, &mut [&mut holes]);
    let mut checks = vec![reading(program, &text, read.as_ref().err().map(Box::as_ref))];
    if read.is_ok() {
        checks.extend(holes.checks(program));
    }
    checks
}
