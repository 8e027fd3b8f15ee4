//! What a program comes to: how far it reaches, where it ends, how long its path is and how long it takes.

use crate::finding::{Finding, Grade, Place};
use crate::gcode::interpreter::Interpreter;
use crate::gcode::motion::{Kind, Motion};
use crate::machine::axis::{Axis, Pose};
use crate::number::shown;
use crate::text::Text;

/// Least and greatest position of each axis; mm and degrees.
pub type Extents = [[f64; 2]; 9];

/// What a program comes to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Account {
    /// How many motions there are.
    pub motions: u64,
    /// How far each axis reaches in program coordinates; `None` where there is no motion.
    pub program: Option<Extents>,
    /// How far each axis reaches in machine coordinates.
    pub machine: Option<Extents>,
    /// Length of the path of X, Y and Z at feed, mm.
    pub feed_path: f64,
    /// Length of the path of X, Y and Z at rapid, mm.
    pub rapid_path: f64,
    /// The time of what moves at feed and of dwells, s.
    pub seconds: f64,
    /// True where a motion at feed has no known time.
    pub untimed: bool,
    /// Where the program ends, in program and machine coordinates.
    pub end: [Pose; 2],
}

fn reach(extents: &mut Option<Extents>, pose: &Pose) {
    let extents = extents.get_or_insert_with(|| pose.0.map(|at| [at, at]));
    for (extent, at) in extents.iter_mut().zip(pose.0) {
        extent[0] = extent[0].min(at);
        extent[1] = extent[1].max(at);
    }
}

impl Account {
    /// Takes a motion into account. `before` is the machine position before it.
    pub fn take(&mut self, motion: &Motion, before: &Pose) {
        self.motions += 1;
        reach(&mut self.program, &motion.from);
        reach(&mut self.program, &motion.to);
        reach(&mut self.machine, before);
        reach(&mut self.machine, &motion.machine);
        let by = motion.to.differences(&motion.from);
        let straight = (by[0] * by[0] + by[1] * by[1] + by[2] * by[2]).sqrt();
        match motion.kind {
            Kind::Rapid => self.rapid_path += straight,
            Kind::Feed(_) => self.feed_path += straight,
            Kind::Arc(arc, _) => {
                self.feed_path += {
                    let [_, _, across] = arc.plane.axes();
                    arc.length(by[across as usize])
                };
                let program = &mut self.program;
                let machine = &mut self.machine;
                // The offsets between program and machine coordinates are those at the end of the arc; where the system is
                // rotated the quarter points are not the farthest of the machine's axes and only its ends count.
                let offset = motion.machine.differences(&motion.to);
                let start = before.differences(&motion.from);
                let level = offset.iter().zip(start).all(|(one, other)| (one - other).abs() < 1e-9);
                arc.quarters(&motion.from, &motion.to, &mut |at| {
                    reach(program, at);
                    if level {
                        reach(machine, &Pose(std::array::from_fn(|axis| at.0[axis] + offset[axis])));
                    }
                });
            }
            Kind::Dwell(_) => {}
        }
        match motion.seconds {
            Some(seconds) => self.seconds += seconds,
            None => self.untimed |= !matches!(motion.kind, Kind::Rapid),
        }
        self.end = [motion.to, motion.machine];
    }
}

/// What is to say about where a program ends whose every motion is incremental: run again, it starts there.
#[must_use]
pub fn drift(interpreter: &Interpreter<'_>, start: &Pose) -> Option<Finding> {
    if !interpreter.all_incremental() {
        return None;
    }
    let net = interpreter.position().1.differences(start);
    let moved = |axis: &Axis| net[*axis as usize].abs() >= 0.0005;
    let list = Axis::ALL
        .into_iter()
        .filter(|axis| moved(axis) || matches!(axis, Axis::X | Axis::Y | Axis::Z))
        .map(|axis| format!("{} {}", axis.letter(), shown(net[axis as usize], 3)))
        .collect::<Vec<_>>()
        .join("  ");
    let linear = Axis::ALL.into_iter().any(|axis| !axis.rotary() && moved(&axis));
    let turned = Axis::ALL.into_iter().any(|axis| axis.rotary() && moved(&axis));
    let finding = if linear {
        Finding::new(
            Grade::Caution,
            Place::File,
            Text::fixed(
                "el programa incremental no vuelve a donde empieza: cada ejecución se desplaza",
                "the incremental program does not come back to where it starts: each run is shifted",
            ),
            Text::fixed(
                "haga que la suma de los incrementos sea 0 en cada eje lineal",
                "make the increments of each linear axis sum up to 0",
            ),
        )
    } else {
        let turns = if turned {
            Text::fixed(
                "el programa incremental vuelve a donde empieza, con los ejes giratorios en otro ángulo",
                "the incremental program comes back to where it starts, the rotary axes at another angle",
            )
        } else {
            Text::fixed(
                "el programa incremental vuelve a donde empieza",
                "the incremental program comes back to where it starts",
            )
        };
        Finding::note(Place::File, turns)
    };
    Some(finding.with(list, "X 0  Y 0  Z 0"))
}
