//! Arcs: how well the radii at start and end agree, on the numbers as the text has them. An arc beyond the limit in mm is a
//! stop here; one beyond what the control takes is refused by the interpreter before.

use crate::finding::{Raise, Size};
use crate::gcode::interpreter::radii_tolerance;
use crate::gcode::motion::{Arc, Motion, MotionKind};
use crate::gcode::program::Program;
use crate::machine::length_unit::LengthUnit;
use crate::number::trig::hypot;
use crate::proof::check::{At, Check, Extreme, Question, mm};
use crate::proof::rules::RadiiDiffer;
use crate::proof::step::{Judge, Step};
use crate::text::{Text, t};

/// The radii of an arc at its start and at its end, mm.
#[must_use]
pub fn radii(motion: &Motion, arc: &Arc) -> [f64; 2] {
    let [first, second, _] = arc.plane.axes();
    [&motion.from, &motion.to].map(|pose| hypot(pose.get(first) - arc.centre[0], pose.get(second) - arc.centre[1]))
}

/// Watches the arcs of a program.
#[derive(Debug, Default)]
pub struct Arcs {
    worst: Extreme,
}

impl Judge for Arcs {
    fn see(&mut self, step: &Step<'_>) {
        let MotionKind::Arc(arc, _) = &step.motion.kind else { return };
        let [start, end] = radii(&step.motion, arc);
        self.worst.take((start - end).abs(), At::motion(&step.motion));
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Arcos: diferencia de los radios", "Arcs: difference of the radii");
        let most = radii_tolerance(LengthUnit::Millimetre);
        let (asked, limit) = (Question::new("arcs", name, program), Text::same(mm(most)));
        vec![if self.worst.seen() == 0 {
            // A program without arcs is asked nothing.
            asked.showing(t("sin arcos", "no arcs"), limit).informs()
        } else {
            let asked = asked.showing(Text::same(mm(self.worst.value())), limit);
            asked.within(&self.worst, most, |found, place| {
                let (difference, most, line) = (Size::length(found.value(), 4), Size::length(most, 4), found.line());
                RadiiDiffer { line, difference, most, program: program.title.clone() }.at(place)
            })
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::radii;
    use crate::gcode::motion::{Arc, Feed, Motion, MotionKind, Plane};
    use crate::machine::axis::{Axis, Pose};

    #[test]
    fn radii_are_measured_in_the_plane_of_the_arc() {
        let at = |X: f64, Z: f64| {
            let mut pose = Pose::default();
            pose.set(Axis::X, X);
            pose.set(Axis::Z, Z);
            pose
        };
        // G18: the centre is given along Z, then X.
        let arc = Arc { plane: Plane::ZX, centre: [1.0, 2.0], turns: 1, radius: 3.0, sweep: 1.0, rotation: 0.0 };
        let (from, to) = (at(2.0, 4.0), at(6.0, 1.0));
        let kind = MotionKind::Arc(arc, Feed::default());
        let motion = Motion { line: 1, n: None, kind, from, to, machine: to, seconds: None };
        assert_eq!(radii(&motion, &arc), [3.0, 4.0]);
    }
}
