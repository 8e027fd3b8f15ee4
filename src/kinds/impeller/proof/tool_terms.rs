//! With which tool, and how the spindle turns, while the tool is anywhere near the part: the two tools of a clear cut have two
//! programs, and the right path with the wrong one of them spoils the part.
//!
//! T is compared with the form at every motion of the plan, rapids included, and no length offset may be in force: the zero
//! of Z is that of the tip. The published layout calls no tool and gives no S: there the spindle alone is compared. The spindle and S are compared at every motion at feed. D is not: which offset a mill's D brings
//! is not known without the machine's table.

use crate::finding::Raise;
use crate::gcode::in_force::{InForce, Speed, Spindle};
use crate::gcode::motion::MotionKind;
use crate::gcode::program::Program;
use crate::gcode::word::Word;
use crate::kinds::impeller::clear::asked::Mill;
use crate::kinds::impeller::design::{Design, Style};
use crate::kinds::impeller::proof::rules::ClearTermsDiffer;
use crate::number::shown;
use crate::proof::check::{At, Check, Question};
use crate::proof::step::{Judge, Step};
use crate::text::{Text, t};

/// Watches tool and spindle of one program.
#[derive(Debug)]
pub struct ToolTerms {
    /// Tool and speed; `None` in the published layout.
    mill: Option<Mill>,
    /// As the codes at the start of the program turn it; `None` where they leave that to the operator.
    spindle: Option<Spindle>,
    seen: usize,
    wrong: Option<(At, Text)>,
}

impl ToolTerms {
    /// The judge of the program of a tool.
    #[must_use]
    pub fn new(design: &Design, mill: Mill) -> Self {
        let starts = |number: u32| design.start_codes.contains(&Word::whole('M', number));
        let spindle = if starts(3) { Some(Spindle::Clockwise) } else { starts(4).then_some(Spindle::CounterClockwise) };
        let mill = match design.style {
            Style::Full => Some(mill),
            Style::Annex => None,
        };
        Self { mill, spindle, seen: 0, wrong: None }
    }

    /// What is in force other than the form says.
    fn difference(&self, kind: &MotionKind, control: &InForce) -> Option<String> {
        if self.mill.is_some_and(|mill| control.tool != mill.T) {
            return Some(format!("T{}", control.tool));
        }
        // The length of the tool is in the zero of Z.
        if control.lengthened {
            return Some("G43".to_owned());
        }
        if !matches!(kind, MotionKind::Feed(_) | MotionKind::Arc(..)) {
            return None;
        }
        if self.spindle.is_some_and(|spindle| spindle != control.spindle) {
            return Some(control.spindle.code().to_owned());
        }
        let wanted = f64::from(self.mill?.S?);
        match control.speed {
            Speed::Revolutions(speed) if (speed - wanted).abs() < 0.5 => None,
            Speed::Revolutions(speed) => Some(format!("S{}", shown(speed, 3))),
            Speed::Surface(speed) => Some(format!("G96 S{}", shown(speed, 3))),
        }
    }

    fn wanted(&self) -> String {
        let mut words: Vec<String> = self.mill.map(|mill| format!("T{}", mill.T)).into_iter().collect();
        words.extend(self.spindle.map(|spindle| spindle.code().to_owned()));
        words.extend(self.mill.and_then(|mill| mill.S).map(|S| format!("S{S}")));
        words.join(" ")
    }
}

impl Judge for ToolTerms {
    fn see(&mut self, step: &Step<'_>) {
        if !step.at_work() {
            return;
        }
        self.seen += 1;
        if self.wrong.is_none() {
            let found = self.difference(&step.motion.kind, &step.in_force);
            self.wrong = found.map(|words| (At::motion(&step.motion), Text::same(words)));
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Herramienta y husillo, los del formulario", "Tool and spindle as in the form");
        let value = Text::new(format!("{} movimientos", self.seen), format!("{} motions", self.seen));
        let wanted = Text::same(self.wanted());
        let asked = Question::new("tool", name, program).showing(value, wanted.clone()).seen(self.seen);
        let asked = asked.at(self.wrong.as_ref().map(|(at, _)| *at));
        vec![asked.unless(self.wrong.map(|(at, found)| {
            let program = program.title.clone();
            move |place| ClearTermsDiffer { at: at.words(), found, wanted, program }.at(place)
        }))]
    }
}
