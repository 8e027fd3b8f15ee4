//! Feed: no axis faster than F_max, and the tip over the part no faster than F.
//!
//! The speed of an axis is its way over the time of the motion (mm/min, °/min); that of the tip is the way between the
//! points of the part at which it stands before and after the motion.

use nalgebra::Vector3;

use crate::gcode::motion::Kind;
use crate::gcode::program::Program;
use crate::impeller::design::Design;
use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::Rotary;
use crate::number::shown;
use crate::text::Text;
use crate::verify::agreement::tip;
use crate::verify::check::{At, Check, FAULT, Verdict};
use crate::verify::step::{Judge, Stage, Step, same};

/// What the arithmetic of a control may lose.
const SLACK: f64 = 1.0 + 1e-6;

/// Watches the speed of axes and tip.
#[derive(Debug)]
pub struct Feeds {
    machine: Rotary,
    F: Option<f64>,
    F_max: Option<f64>,
    last: Option<(Pose, Vector3<f64>)>,
    axis: Option<(f64, Axis, At)>,
    tip: Option<(f64, At)>,
    without: Option<At>,
}

impl Feeds {
    /// The judge of a design's programs.
    #[must_use]
    pub const fn new(design: &Design) -> Self {
        let (machine, F, F_max) = (design.machine, design.F, design.F_max);
        Self { machine, F, F_max, last: None, axis: None, tip: None, without: None }
    }
}

impl Judge for Feeds {
    fn see(&mut self, step: &Step<'_>) {
        let motion = &step.motion;
        if matches!(motion.kind, Kind::Rapid) || matches!(step.stage, Stage::Positioning) {
            return;
        }
        let Some(seconds) = motion.seconds else {
            self.without.get_or_insert(At::motion(motion));
            return;
        };
        let at = At::motion(motion);
        let by = motion.to.differences(&motion.from);
        for axis in Axis::ALL {
            let speed = by[axis as usize].abs() * 60.0 / seconds;
            if self.axis.is_none_or(|(most, ..)| speed > most) {
                self.axis = Some((speed, axis, at));
            }
        }
        let from = match self.last {
            Some((pose, point)) if same(&pose, &motion.from) => point,
            _ => tip(self.machine, &motion.from),
        };
        let to = tip(self.machine, &motion.to);
        self.last = Some((motion.to, to));
        let speed = (to - from).norm() * 60.0 / seconds;
        if self.tip.is_none_or(|(most, _)| speed > most) {
            self.tip = Some((speed, at));
        }
    }

    fn checks(&mut self, program: &Program) -> Vec<Check> {
        let axis_name = Text::fixed("Velocidad del eje más rápido", "Speed of the fastest axis");
        let tip_name = Text::fixed("Avance de la punta sobre la pieza", "Feed of the tip over the part");
        let speed = |speed: f64, unit: &str| Text::same(format!("{} {unit}", shown(speed, 2)));
        let limit = |limit: Option<f64>, unit: &str| limit.map_or_else(|| Text::same(""), |limit| speed(limit, unit));
        let unit = |axis: Axis| if axis.rotary() { "°/min" } else { "mm/min" };
        let none = Text::fixed("sin palabra F", "no F word");
        let (Some((fastest, axis, axis_at)), Some((greatest, tip_at))) = (self.axis, self.tip) else {
            let check = Check::passed("feed", tip_name, program, none, Text::same(""));
            return vec![check.at(self.without).informing()];
        };
        let value = Text::same(format!("{} {} {}", axis.letter(), shown(fastest, 2), unit(axis)));
        let by_axis = Check::passed("feed-axis", axis_name, program, value, limit(self.F_max, unit(axis)));
        let by_axis = by_axis.at(Some(axis_at));
        let tip = Check::passed("feed-tip", tip_name, program, speed(greatest, "mm/min"), limit(self.F, "mm/min"));
        let tip = tip.at(Some(tip_at));
        let mut checks = vec![
            match self.F_max {
                None => by_axis.informing(),
                Some(most) if fastest <= most * SLACK => by_axis,
                Some(most) => {
                    let (letter, unit) = (axis.letter(), unit(axis));
                    let (fastest, most, line) = (shown(fastest, 2), shown(most, 2), axis_at.line);
                    by_axis.found(
                        Verdict::Stop,
                        Text::new(
                            format!(
                                "{letter} va a {fastest} {unit} en la línea {line} de «{}»; F_max es {most}",
                                program.title.es
                            ),
                            format!(
                                "{letter} runs at {fastest} {unit} at line {line} of \"{}\"; F_max is {most}",
                                program.title.en
                            ),
                        ),
                        FAULT,
                    )
                }
            },
            match self.F {
                None => tip.informing(),
                Some(most) if greatest <= most * SLACK => tip,
                Some(most) => {
                    let (greatest, most, line) = (shown(greatest, 2), shown(most, 2), tip_at.line);
                    tip.found(
                        Verdict::Stop,
                        Text::new(
                            format!(
                                "la punta va a {greatest} mm/min en la línea {line} de «{}»; F es {most}",
                                program.title.es
                            ),
                            format!(
                                "the tip runs at {greatest} mm/min at line {line} of \"{}\"; F is {most}",
                                program.title.en
                            ),
                        ),
                        FAULT,
                    )
                }
            },
        ];
        if let Some(at) = self.without {
            let name = Text::fixed("Movimiento de corte sin avance", "Cutting motion without feed");
            let check = Check::passed("feed", name, program, none, Text::same("")).at(Some(at));
            checks.push(check.found(
                Verdict::Stop,
                Text::new(
                    format!("hay un movimiento de corte sin avance en la línea {} de «{}»", at.line, program.title.es),
                    format!("there is a cutting motion without feed at line {} of \"{}\"", at.line, program.title.en),
                ),
                FAULT,
            ));
        }
        checks
    }
}
