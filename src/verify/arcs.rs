//! Arcs by LinuxCNC's rule, on the numbers as the text has them.
//!
//! # References
//! LinuxCNC's interpreter: an arc given by its centre is refused where the radii at its start and its end differ by more
//! than 0.0283 mm and more than 0.1 % of the greater, or by more than 2.83 mm whatever their size.

use crate::gcode::motion::{Arc, Kind, Motion};
use crate::gcode::program::Program;
use crate::number::trig::hypot;
use crate::text::Text;
use crate::verify::check::{At, Check, FAULT, Verdict, mm};
use crate::verify::step::{Judge, Step};

/// The difference of the radii that is always taken, mm.
pub const ABSOLUTE: f64 = 0.0283;
/// The difference that is taken in proportion to the greater radius.
pub const RELATIVE: f64 = 0.001;
/// The difference that is never taken, mm.
pub const GREATEST: f64 = 2.83;

/// The radii of an arc at its start and at its end, mm.
#[must_use]
pub fn radii(motion: &Motion, arc: &Arc) -> [f64; 2] {
    let [first, second, _] = arc.plane.axes();
    [&motion.from, &motion.to].map(|pose| hypot(pose.get(first) - arc.centre[0], pose.get(second) - arc.centre[1]))
}

/// True where LinuxCNC takes an arc with these radii. A radius of 0 is no arc.
#[must_use]
pub fn taken([start, end]: [f64; 2]) -> bool {
    let difference = (start - end).abs();
    let greater = start.max(end);
    greater > 0.0 && difference <= GREATEST && (difference <= ABSOLUTE || difference <= RELATIVE * greater)
}

/// Watches the arcs of a program.
#[derive(Debug, Default)]
pub struct Arcs {
    count: usize,
    worst: Option<([f64; 2], At)>,
    refused: Option<([f64; 2], At)>,
}

impl Judge for Arcs {
    fn see(&mut self, step: &Step<'_>) {
        let Kind::Arc(arc, _) = &step.motion.kind else { return };
        self.count += 1;
        let found = (radii(&step.motion, arc), At::motion(&step.motion));
        let difference = |[start, end]: [f64; 2]| (start - end).abs();
        if self.worst.is_none_or(|(worst, _)| difference(found.0) > difference(worst)) {
            self.worst = Some(found);
        }
        if !taken(found.0) {
            self.refused.get_or_insert(found);
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
        let name = Text::fixed("Arcos: diferencia de los radios", "Arcs: difference of the radii");
        let limit = Text::same(mm(ABSOLUTE));
        let Some(([start, end], at)) = self.refused.or(self.worst) else {
            return vec![Check::passed("arcs", name, program, Text::fixed("sin arcos", "no arcs"), limit)];
        };
        let check = Check::passed("arcs", name, program, Text::same(mm((start - end).abs())), limit).at(Some(at));
        vec![if self.refused.is_none() {
            check
        } else {
            let (start, end) = (mm(start), mm(end));
            check.found(
                Verdict::Stop,
                Text::new(
                    format!(
                        "los radios del arco de la línea {} de «{}» son {start} y {end}",
                        at.line, program.title.es
                    ),
                    format!(
                        "the radii of the arc at line {} of \"{}\" are {start} and {end}",
                        at.line, program.title.en
                    ),
                ),
                FAULT,
            )
        }]
    }
}

#[cfg(test)]
mod tests {
    use super::{radii, taken};
    use crate::gcode::motion::{Arc, Feed, Kind, Motion, Plane};
    use crate::machine::axis::{Axis, Pose};

    #[test]
    fn radii_are_taken_up_to_linuxcncs_limits() {
        for (radii, expected) in [
            ([10.0, 10.0], true),
            ([10.0, 10.0282], true),
            ([10.0, 10.0284], false),
            ([1000.0, 1000.9], true),
            ([1000.0, 1001.1], false),
            ([10_000.0, 10_002.82], true),
            ([10_000.0, 10_002.84], false),
            ([0.0, 0.0], false),
            ([f64::NAN, 1.0], false),
        ] {
            assert_eq!(taken(radii), expected, "{radii:?}");
        }
    }

    #[test]
    fn radii_are_measured_in_the_plane_of_the_arc() {
        let at = |X: f64, Z: f64| {
            let mut pose = Pose::default();
            pose.set(Axis::X, X);
            pose.set(Axis::Z, Z);
            pose
        };
        // G18: the centre is given along Z, then X.
        let arc = Arc { plane: Plane::ZX, centre: [1.0, 2.0], turns: 1, radius: 3.0, start: 0.0, sweep: 1.0 };
        let (from, to) = (at(2.0, 4.0), at(6.0, 1.0));
        let kind = Kind::Arc(arc, Feed::default());
        let motion = Motion { line: 1, n: None, kind, from, to, machine: to, seconds: None };
        assert_eq!(radii(&motion, &arc), [3.0, 4.0]);
    }
}
