//! Feed: no axis faster than F_max, and the tip over the part no faster than F.
//!
//! The speed of an axis is its way over the time of the motion (mm/min, °/min); that of the tip is its way over the
//! part over that time, an upper bound of it and not the chord ([`tip_way`](crate::machine::tip_way)): the mean over the motion,
//! which is what an F word settles. F words are rounded to the slower side; by how much that
//! slows the most is a check of its own, here and for pipes.

use crate::gcode::control::FeedLaw;
use crate::gcode::feed_word::step;
use crate::gcode::motion::{Motion, MotionKind};
use crate::gcode::program::Program;
use crate::machine::axis::Axis;
use crate::machine::rotary::Rotary;
use crate::machine::tip_way::longest;
use crate::number::shown;
use crate::proof::check::{At, Check, FAULT, Verdict};
use crate::proof::step::{Judge, Stage, Step};
use crate::text::Text;

/// By what part rounding the F word may slow a motion before a person must judge it.
const SLOWER: f64 = 0.05;

/// The check of what rounding the F words costs: by what part it slows a motion the most, and where; `None` for a program
/// without F words.
#[must_use]
pub fn feed_word(program: &Program, worst: Option<(f64, At)>) -> Check {
    let name = Text::fixed("Palabra F: lo más que frena el redondeo", "F word: the most that rounding slows");
    let Some((slower, at)) = worst else {
        let none = Text::fixed("sin palabra F", "no F word");
        return Check::passed("feed-word", name, program, none, Text::same("")).informing();
    };
    let law = program.control.feed.law;
    let part = |part: f64| format!("{} %", shown(part * 100.0, 3));
    let limit = part(SLOWER);
    let limit = match law {
        FeedLaw::Seconds => {
            Text::new(format!("{limit}; F a 0.0001 s, supuesto"), format!("{limit}; F to 0.0001 s, assumed"))
        }
        FeedLaw::Resultant | FeedLaw::InverseTime => Text::same(limit),
    };
    let check = Check::passed("feed-word", name, program, Text::same(part(slower)), limit).at(Some(at));
    if slower > SLOWER {
        let (slower, line) = (part(slower), at.line);
        return check.found(
            Verdict::Caution,
            Text::new(
                format!("los decimales de F frenan la línea {line} de «{}» un {slower}", program.title.es),
                format!("the decimals of F slow line {line} of \"{}\" by {slower}", program.title.en),
            ),
            Text::fixed("menos F, o tramos más largos", "a smaller F, or longer moves"),
        );
    }
    if law != FeedLaw::Seconds {
        return check;
    }
    check.found(
        Verdict::Note,
        Text::fixed(
            "F en G93 va a 0.0001 s, un supuesto: la página del manual del 8070 no da formato; un control de tres decimales acortaría un bloque hasta 0.0009 s",
            "F in G93 goes to 0.0001 s, an assumption: the page of the 8070's manual gives no format; a control with three decimals would shorten a block by up to 0.0009 s",
        ),
        Text::fixed("pruébelo en el control antes de cortar", "try it on the control before cutting"),
    )
}

/// True where the F word of a motion lets it take the time that was planned, or longer by what rounding the word takes.
#[must_use]
pub fn timely(law: FeedLaw, motion: &Motion, word: f64, planned: f64) -> bool {
    let by = motion.to.differences(&motion.from);
    let wanted = law.word(planned, by.iter().map(|by| by * by).sum::<f64>().sqrt());
    let slower = if law == FeedLaw::Seconds { word - wanted } else { wanted - word };
    (-1e-8 * wanted..=step(law, wanted) * (1.0 + 1e-6)).contains(&slower)
}

/// What the arithmetic of a control may lose.
const SLACK: f64 = 1.0 + 1e-6;

/// Watches the speed of axes and tip.
#[derive(Debug)]
pub struct Feeds {
    machine: Rotary,
    F: Option<f64>,
    F_max: Option<f64>,
    axis: Option<(f64, Axis, At)>,
    tip: Option<(f64, At)>,
    rounded: Option<(f64, At)>,
    without: Option<At>,
}

impl Feeds {
    /// The judge of programs on a machine with a feed at the tip, mm/min, and the greatest of an axis, mm/min and °/min.
    #[must_use]
    pub const fn new(machine: Rotary, F: Option<f64>, F_max: Option<f64>) -> Self {
        Self { machine, F, F_max, axis: None, tip: None, rounded: None, without: None }
    }
}

impl Judge for Feeds {
    fn see(&mut self, step: &Step<'_>) {
        let motion = &step.motion;
        if matches!(motion.kind, MotionKind::Rapid) || matches!(step.stage, Stage::Positioning) {
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
        let way = longest(self.machine, &motion.from, &motion.to);
        if let Some(F) = self.F {
            let greatest = by.iter().fold(0.0_f64, |most, by| most.max(by.abs()));
            let wanted = (way * 60.0 / F).max(self.F_max.map_or(0.0, |F_max| greatest * 60.0 / F_max));
            let slower = seconds / wanted - 1.0;
            if wanted > 0.0 && self.rounded.is_none_or(|(most, _)| slower > most) {
                self.rounded = Some((slower, at));
            }
        }
        let speed = way * 60.0 / seconds;
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
        checks.push(feed_word(program, self.rounded));
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
