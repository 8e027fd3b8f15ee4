//! Axis travel: no position of a program may lie beyond the machine's limits. Program coordinates, mm and degrees.

use crate::finding::{Key, Raise, Size};
use crate::gcode::program::Program;
use crate::machine::travel::{AxisTravel, Excess, excess};
use crate::number::shown;
use crate::proof::check::{At, Check, Question};
use crate::proof::rules::AxisLeavesTravel;
use crate::proof::step::{Judge, Step};
use crate::text::Text;

/// What is known of one axis.
#[derive(Clone, Copy, Debug)]
struct AxisRange {
    travel: AxisTravel,
    /// Least and greatest position.
    ends: Option<[f64; 2]>,
    /// Where the limit was first left, and the greatest excess.
    left: Option<(At, Excess)>,
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
        let run = |travel| AxisRange { travel, ends: None, left: None, seen: 0 };
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
                let size = |one: &Excess| (one.position - one.limit).abs();
                let left = run.left.get_or_insert_with(|| (At::motion(&step.motion), found));
                if size(&left.1) < size(&found) {
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
        let known = ends.iter().any(Option::is_some);
        let limit = if known { range(ends) } else { String::new() };
        let asked =
            Question::new("travel", name, program).showing(Text::same(value), Text::same(limit)).seen(self.seen);
        if !known {
            return asked.informs();
        }
        let asked = match self.left {
            None => asked,
            Some((at, worst)) => asked.at(Some(at)).of_parameters([self.key(&worst)]),
        };
        asked.unless(self.left.map(|(at, worst)| {
            let size = |value: f64| Size { value, unit: unit.trim_start(), decimals: 3 };
            let (position, limit, key) = (size(worst.position), size(worst.limit), self.key(&worst));
            let (axis, program) = (letter, program.title.clone());
            move |place| AxisLeavesTravel { axis, position, limit, key, line: at.line, program }.at(place)
        }))
    }

    /// The parameter of the limit that is left.
    fn key(&self, worst: &Excess) -> Key {
        self.travel.keys[usize::from(worst.position > worst.limit)]
    }
}
