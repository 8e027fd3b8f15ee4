//! The proof: every motion as planned, from the design alone, and hole i at its angle.

use rodete::finding::{Raise, Size};
use rodete::gcode::motion::MotionKind;
use rodete::gcode::program::Program;
use rodete::machine::axis::Axis;
use rodete::proof::check::{At, Check, Extreme, Question, mm};
use rodete::proof::step::{Judge, Step};
use rodete::proof::three_axes::Route;
use rodete::text::Text;
use rodete::text::t;

use crate::design::{BoltCircle, CLEAR};
use crate::rules::Astray;

/// How far a hole may be from its place: the grid of the program's numbers, mm.
const MOST: f64 = 0.001;

/// What the drill should do: up, and over each hole in turn down at F and up again.
pub fn route(circle: &BoltCircle) -> Route {
    let mut route = Route::default();
    route.rapid([(Axis::Z, CLEAR)]);
    for hole in 0..circle.N {
        let [x, y] = circle.at(hole);
        route.rapid([(Axis::X, x), (Axis::Y, y)]);
        route.feed([(Axis::Z, -circle.h)], circle.F);
        route.rapid([(Axis::Z, CLEAR)]);
    }
    route
}

/// Looks at each motion that drills.
pub struct HolesAtAngles<'a> {
    circle: &'a BoltCircle,
    drilled: u32,
    worst: Extreme,
    /// The hole that is the farthest off.
    hole: u32,
}

impl<'a> HolesAtAngles<'a> {
    /// That of a circle, before anything is seen.
    pub const fn of(circle: &'a BoltCircle) -> Self {
        Self { circle, drilled: 0, worst: Extreme::nothing(), hole: 0 }
    }
}

impl Judge for HolesAtAngles<'_> {
    fn see(&mut self, step: &Step<'_>) {
        if matches!(step.motion.kind, MotionKind::Feed(_)) {
            let [x, y] = self.circle.at(self.drilled);
            let (to, deep) = (&step.motion.to, step.motion.to.get(Axis::Z) + self.circle.h);
            let by = (to.get(Axis::X) - x).hypot(to.get(Axis::Y) - y).max(deep.abs());
            self.drilled += 1;
            let before = self.worst;
            self.worst.take(by, At::motion(&step.motion));
            if before.seen() == 0 || self.worst.value() > before.value() {
                self.hole = self.drilled;
            }
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let by = self.worst.value();
        let value = Text::new(
            format!("{} agujeros, a {}", self.drilled, mm(by)),
            format!("{} holes, within {}", self.drilled, mm(by)),
        );
        let limit = Text::same(format!("{}, {}", self.circle.N, mm(MOST)));
        let name = t("Cada agujero en su ángulo", "Every hole at its angle");
        let asked = Question::new("angles", name, program).showing(value, limit).of(&self.worst);
        vec![asked.holds(self.drilled == self.circle.N && by <= MOST, |place| {
            Astray { hole: self.hole, by: Size::mm(by) }.at(place)
        })]
    }
}
