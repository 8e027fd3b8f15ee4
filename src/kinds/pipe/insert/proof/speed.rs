//! How fast the torch goes along the cut.

use super::{Moves, Surface};
use crate::finding::{Figures, Limit, Raise, Size};
use crate::gcode::control::FeedLaw;
use crate::gcode::feed_word::step as least_step;
use crate::gcode::motion::MotionKind;
use crate::gcode::program::{Program, Style};
use crate::kinds::pipe::insert::design::{Design, Mode};
use crate::kinds::pipe::insert::proof::rules::CutOffSpeed;
use crate::number::shown;
use crate::proof::check::{At, Check, Extreme, Question, mm};
use crate::proof::feed::{feed_word, timely};
use crate::proof::rules::CutWithoutFeed;
use crate::proof::step::{Judge, Step};
use crate::text::{Text, t};

/// Adds up length and time of the cut: is each motion run at F, as near as its word allows?
pub(super) struct CutSpeed<'a> {
    pub(super) surface: Surface<'a>,
    pub(super) moves: &'a Moves,
    pub(super) fastest: Extreme,
    pub(super) slowest: Option<f64>,
    pub(super) off: Option<(f64, At)>,
    pub(super) rounded: Extreme,
    pub(super) untimed: Option<At>,
    pub(super) length: f64,
    pub(super) seen: usize,
}

impl Judge for CutSpeed<'_> {
    fn see(&mut self, step: &Step<'_>) {
        if self.moves.follows(step).is_none() {
            return;
        }
        let (motion, design) = (&step.motion, self.surface.design);
        let ((length, _), at) = (self.surface.run(motion), At::motion(motion));
        self.seen += 1;
        self.length += length;
        let Some(seconds) = motion.seconds.filter(|seconds| *seconds > 0.0) else {
            self.untimed.get_or_insert(at);
            return;
        };
        let speed = length * 60.0 / seconds;
        self.fastest.take(speed, at);
        self.slowest = Some(self.slowest.map_or(speed, |least: f64| least.min(speed)));
        let word = match motion.kind {
            MotionKind::Feed(feed) | MotionKind::Arc(_, feed) => feed.value,
            MotionKind::Rapid | MotionKind::Thread(_) | MotionKind::Dwell(_) => 0.0,
        };
        let F = design.F.unwrap_or(speed);
        let planned = length * 60.0 / F;
        let good = match design.mode {
            // F is the speed over the sheet itself; a word within a billionth of a whole step is that step.
            Mode::Flat => (F - least_step(FeedLaw::Resultant, F)..=F * (1.0 + 1e-9)).contains(&word),
            Mode::Rotary => timely(design.post.control.feed.law, motion, word, planned),
        };
        if !good || seconds < planned * (1.0 - 1e-6) {
            self.off.get_or_insert((speed, at));
        }
        self.rounded.take(seconds / planned - 1.0, at);
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        let name = t("Longitud del corte", "Length of the cut");
        let length = Question::new("length", name, program).showing(Text::same(mm(self.length)), Text::same(""));
        let fed = fed(self.surface.design).is_some();
        vec![length.informs(), self.feed(program), feed_word(program, &self.rounded, fed)]
    }
}

/// F of a program that carries one, mm/min: the published one has none.
pub(super) fn fed(design: &Design) -> Option<f64> {
    design.F.filter(|_| design.style == Style::Full)
}

impl CutSpeed<'_> {
    fn feed(&self, program: &Program) -> Check {
        let (name, design) = (t("Velocidad de corte", "Cutting speed"), self.surface.design);
        let asked = Question::new("feed", name, program).seen(self.seen);
        let Some(F) = fed(design) else {
            return asked.showing(t("sin palabra F", "no F word"), Text::same("")).informs();
        };
        let most = self.fastest.value();
        let show = |speed: f64| shown(speed, 1);
        let value = Text::same(format!("{} … {} mm/min", show(self.slowest.unwrap_or(most)), show(most)));
        let asked = asked.showing(value, Text::same(format!("{} mm/min", shown(F, 3)))).at(self.fastest.at());
        let found = Some([self.slowest.unwrap_or(most), most]);
        let asked = asked.comparing(Figures { found, limit: Some(Limit::Exactly(F)) });
        match (self.off, self.untimed) {
            (None, None) => asked.passes(),
            (None, Some(at)) => asked
                .at(Some(at))
                .holds(false, |place| CutWithoutFeed { line: at.line, program: program.title.clone() }.at(place)),
            (Some((speed, at)), _) => asked.at(Some(at)).holds(false, |place| {
                let (speed, F) = (Size::feed(speed, 1), Size::number(F, 3));
                CutOffSpeed { speed, line: at.line, F }.at(place)
            }),
        }
    }
}
