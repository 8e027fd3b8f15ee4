//! Axis travel: no position of a program may lie beyond the machine's limits. Program coordinates, mm and degrees.

use crate::finding::{Figures, Key, Limit, Raise, Said, Size};
use crate::gcode::program::Program;
use crate::machine::travel::{AxisTravel, Excess, excess};
use crate::number::shown;
use crate::proof::check::{At, Check, Question};
use crate::proof::rules::AxisLeavesTravel;
use crate::proof::step::{Judge, Step};
use crate::text::{Language, Text, t};

/// What is known of one axis.
#[derive(Clone, Copy, Debug)]
struct AxisRange {
    travel: AxisTravel,
    /// Least and greatest position.
    ends: Option<[f64; 2]>,
    /// Where the lower and the upper limit were first left, and the greatest excess over each.
    left: [Option<(At, Excess)>; 2],
    /// How many positions were looked at.
    seen: usize,
}

/// Holds a program against the travel of its axes.
#[derive(Debug)]
pub struct Axes(Vec<AxisRange>);

impl Axes {
    /// The judge for the travel of some axes, of each in turn.
    #[must_use]
    pub fn new(axes: impl IntoIterator<Item = AxisTravel>) -> Self {
        let run = |travel| AxisRange { travel, ends: None, left: [None; 2], seen: 0 };
        Self(axes.into_iter().map(run).collect())
    }
}

impl Judge for Axes {
    fn see(&mut self, step: &Step<'_>) {
        for pose in step.ends() {
            for run in &mut self.0 {
                let position = pose.get(run.travel.axis);
                run.seen += 1;
                let [low, high] = run.ends.get_or_insert([position; 2]);
                (*low, *high) = (low.min(position), high.max(position));
                let Some(found) = excess(run.travel.ends, position) else { continue };
                let left = run.left[upper(&found)].get_or_insert_with(|| (At::motion(&step.motion), found));
                if by(&left.1) < by(&found) {
                    left.1 = found;
                }
            }
        }
    }

    fn checks(self: Box<Self>, program: &Program) -> Vec<Check> {
        self.0.iter().map(|run| run.check(program)).collect()
    }
}

impl AxisRange {
    fn check(&self, program: &Program) -> Check {
        let AxisTravel { axis, ends, .. } = self.travel;
        let (letter, unit) = (axis.letter(), if axis.rotary() { "°" } else { " mm" });
        let range = |[low, high]: [Option<f64>; 2]| {
            let end = |end: Option<f64>| end.map_or_else(|| "–".to_owned(), |end| shown(end, 3));
            format!("{} … {}{unit}", end(low), end(high))
        };
        let name = Text::new(format!("Recorrido de {letter}"), format!("Travel of {letter}"));
        let value = range(self.ends.map_or([None, None], |ends| ends.map(Some)));
        let known = self.travel.is_known();
        let limit = if known { range(ends) } else { String::new() };
        let asked =
            Question::new("travel", name, program).showing(Text::same(value), Text::same(limit)).seen(self.seen);
        let [least, most] = ends;
        let asked = asked.comparing(Figures { found: self.ends, limit: Some(Limit::Between { least, most }) });
        if !known {
            return asked.informs();
        }
        // The end that is left by more comes first; at the other one the axis would stop as well.
        let mut left: Vec<(At, Excess)> = self.left.into_iter().flatten().collect();
        left.sort_by(|(_, one), (_, other)| by(other).total_cmp(&by(one)));
        let asked = match left.first() {
            None => asked,
            Some((at, _)) => asked.at(Some(*at)).of_parameters(left.iter().map(|(_, excess)| self.key(excess))),
        };
        let size = |value: f64| Size { value, unit: unit.trim_start(), decimals: 3 };
        let (beyond, and) = left.get(1).map_or((t("", ""), t("", "")), |(at, other)| {
            let (to, limit, line) = (size(other.position), size(other.limit), at.line);
            let told = |language: Language| [to.said(language), limit.said(language)].map(|one| one.into_owned());
            let ([es, es_limit], [en, en_limit]) = (told(Language::Es), told(Language::En));
            let key = self.key(other).symbol();
            (
                Text::new(
                    format!("; y llega a {es} desde la línea {line}, con {es_limit} de límite por ese lado"),
                    format!("; and it goes to {en} from line {line} on, with {en_limit} as the limit at that end"),
                ),
                Text::new(format!(" y {key}"), format!(" and {key}")),
            )
        });
        asked.unless(left.first().map(|(at, worst)| {
            let (position, limit, key) = (size(worst.position), size(worst.limit), self.key(worst));
            let (axis, program, line) = (letter, program.title.clone(), at.line);
            move |place| AxisLeavesTravel { axis, position, limit, key, line, program, beyond, and }.at(place)
        }))
    }

    /// The parameter of the limit that is left.
    fn key(&self, worst: &Excess) -> Key {
        self.travel.keys[upper(worst)]
    }
}

/// By how much a limit is passed, mm or degrees.
fn by(excess: &Excess) -> f64 {
    (excess.position - excess.limit).abs()
}

/// The end of the travel that is left: 0 the lower one, 1 the upper one.
fn upper(excess: &Excess) -> usize {
    usize::from(excess.position > excess.limit)
}
