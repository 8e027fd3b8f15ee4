//! The designs of a plan: each a function of the plan and its index alone.

use std::borrow::Cow;

use serde_json::json;

use super::chance::{drawn, permuted, unit};
use super::objective::{Constraint, Objective};
use super::sobol::Sobol;
use crate::finding::{Datum, Said};
use crate::kind::measure::Level;
use crate::parameter::field::{Chosen, choices};
use crate::parameter::{FieldKind, Form, Parameter, Value};
use crate::text::Language;

choices! {
    /// How the designs are chosen.
    pub enum Method {
        /// Every level with every other.
        Factorial = "factorial" ("factorial", "factorial"),
        /// Latin hypercube: every input's range is cut into as many slices as there are designs, and each is used once.
        Latin = "latin" ("latino", "latin"),
        /// The sequence of Sobol: the most even for powers of two.
        Sobol = "sobol" ("sobol", "sobol"),
        /// Two designs of the sequence of Sobol, and for each input one with that input of the second and all others of the first: what
        /// the indices of Sobol are estimated from.
        Saltelli = "saltelli" ("saltelli", "saltelli"),
        /// The designs of a sheet of their own.
        List = "list" ("lista", "list"),
    }
}

/// In a sentence the word of the cell, in JSON the key.
impl Said for Method {
    fn said(&self, language: Language) -> Cow<'_, str> {
        Cow::Borrowed(self.label().get(language))
    }

    fn datum(&self) -> Datum {
        Datum::Word(self.key().to_owned())
    }
}

/// The key in a plan of the SHA-256 of the workbook that it began with.
pub const WORKBOOK_SUM: &str = "workbook_sha256";

/// How a range is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spread {
    /// Every value is as likely as any other.
    Uniform,
    /// A normal distribution, cut at the ends of the range.
    Normal {
        /// Its mean.
        mean: f64,
        /// Its standard deviation.
        deviation: f64,
    },
}

/// The least part of the smaller tail that a cut range must hold: less is lost in the last digits.
const LEAST_PART: f64 = 1e-9;

impl Spread {
    /// True where enough of it lies in a range for its values to be told from each other.
    #[must_use]
    pub fn reaches(self, range: [f64; 2]) -> bool {
        match self {
            Self::Uniform => true,
            Self::Normal { mean, deviation } => {
                let [one, other] = range.map(|x| tail(x, range[0] > mean, mean, deviation));
                let most = one.max(other);
                most >= f64::MIN_POSITIVE && (one - other).abs() > LEAST_PART * most
            }
        }
    }
}

/// What values an input takes.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// `from + k·step` for k below `count`.
    Steps {
        /// The first.
        from: f64,
        /// From one to the next.
        step: f64,
        /// How many.
        count: u64,
    },
    /// These.
    Values(Vec<Value>),
    /// Any from one to another, both included.
    Range {
        /// The least.
        from: f64,
        /// The greatest.
        to: f64,
        /// How it is sampled.
        spread: Spread,
    },
}

impl Levels {
    /// How many there are; `None` for a range.
    #[must_use]
    pub fn count(&self) -> Option<u64> {
        match self {
            Self::Steps { count, .. } => Some(*count),
            Self::Values(values) => u64::try_from(values.len()).ok(),
            Self::Range { .. } => None,
        }
    }
}

/// The mark of an input before its symbol: so no column of one is called as a measure.
pub const INPUT: &str = "in_";

/// An input that is varied.
#[derive(Clone, Debug)]
pub struct Input {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Its values.
    pub levels: Levels,
}

impl Input {
    /// Its symbol: that of the form, with the sheet before it where it is not of the first.
    #[must_use]
    pub fn symbol(&self) -> String {
        self.parameter.key.replace('/', "_")
    }

    /// The name of its column.
    #[must_use]
    pub fn column(&self) -> String {
        format!("{INPUT}{}", self.symbol())
    }

    /// True for one of whole numbers.
    #[must_use]
    pub const fn whole(&self) -> bool {
        matches!(self.parameter.kind, FieldKind::Whole { .. })
    }

    /// The level of a number; the last one of any beyond.
    #[must_use]
    pub fn level(&self, number: u64) -> Option<Value> {
        match &self.levels {
            Levels::Steps { from, step, count } => {
                #[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
                let k = number.min(count.saturating_sub(1)) as f64;
                self.value(billionth(from + k * step))
            }
            Levels::Values(values) => {
                let at = usize::try_from(number).unwrap_or(usize::MAX).min(values.len().saturating_sub(1));
                values.get(at).cloned()
            }
            Levels::Range { .. } => None,
        }
    }

    /// The value at a place from 0 to below 1.
    #[must_use]
    pub fn sampled(&self, place: f64) -> Option<Value> {
        if let Some(count) = self.levels.count() {
            return self.level(slice(place, count));
        }
        let Levels::Range { from, to, spread } = self.levels else { return None };
        let value = match spread {
            Spread::Uniform if self.whole() => (from + place * (to - from + 1.0)).floor().min(to),
            Spread::Uniform => from + place * (to - from),
            Spread::Normal { mean, deviation } => cut_normal(place, [from, to], mean, deviation),
        };
        self.value(value.clamp(from, to))
    }

    /// A number as a value of the input.
    fn value(&self, number: f64) -> Option<Value> {
        if self.whole() { whole(number.round()).map(Value::Whole) } else { Some(Value::Real(number + 0.0)) }
    }
}

/// The slice of `count` equal ones in which a place from 0 to below 1 is.
#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "far below 2^52"
)]
pub(super) fn slice(place: f64, count: u64) -> u64 {
    ((place * count as f64).floor() as u64).min(count.saturating_sub(1))
}

/// A number to a billionth, as a person would type it: 1 + 3·0.1 is 1.3.
pub(super) fn billionth(number: f64) -> f64 {
    (number * 1e9).round() / 1e9
}

/// A whole number that a cell may hold; `None` for any other.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within its limits")]
pub(super) fn whole(number: f64) -> Option<u32> {
    (number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number)).then_some(number as u32)
}

/// How much of a normal distribution lies below a value, or above it.
fn tail(x: f64, above: bool, mean: f64, deviation: f64) -> f64 {
    let away = if above { x - mean } else { mean - x };
    0.5 * libm::erfc(away / (deviation * std::f64::consts::SQRT_2))
}

/// The value below which so much of a normal distribution lies that is cut at two ends: by halving, on the error function.
fn cut_normal(place: f64, [from, to]: [f64; 2], mean: f64, deviation: f64) -> f64 {
    // Of a range above the mean, what lies below its values is nearly all: only what lies above them keeps its digits.
    let above = from > mean;
    let part = |x: f64| tail(x, above, mean, deviation);
    let [first, last] = [from, to].map(part);
    let wanted = first + place * (last - first);
    let (mut low, mut high) = (from, to);
    for _ in 0..80 {
        let middle = f64::midpoint(low, high);
        let short = if above { part(middle) > wanted } else { part(middle) < wanted };
        if short { low = middle } else { high = middle }
    }
    f64::midpoint(low, high)
}

/// Designs of a group of a plan for indices, with so many inputs.
pub(super) fn grouped(inputs: usize) -> u64 {
    u64::try_from(inputs).unwrap_or(u64::MAX - 2) + 2
}

/// Every design that is to be judged, and by what.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The form of the workbook.
    pub form: &'static Form,
    /// The inputs that are varied; those of a list hold its values, one a design.
    pub inputs: Vec<Input>,
    /// How the designs are chosen.
    pub method: Method,
    /// What chance begins with.
    pub seed: u64,
    /// How many designs there are.
    pub count: u64,
    /// How many the plan has: a sample of which only the first are worked out is the same sample.
    pub whole: u64,
    /// What a design is judged by.
    pub level: Level,
    /// What is to be small or large.
    pub objectives: Vec<Objective>,
    /// What must hold beside the findings.
    pub constraints: Vec<Constraint>,
    sobol: Sobol,
}

impl Plan {
    /// A plan of so many designs.
    #[must_use]
    pub fn new(
        form: &'static Form,
        inputs: Vec<Input>,
        method: Method,
        (seed, count): (u64, u64),
        level: Level,
        (objectives, constraints): (Vec<Objective>, Vec<Constraint>),
    ) -> Self {
        let coordinates = if method == Method::Saltelli { 2 * inputs.len() } else { inputs.len() };
        let sobol = Sobol::new(coordinates, seed);
        Self { form, inputs, method, seed, count, whole: count, level, objectives, constraints, sobol }
    }

    /// The plan without the designs from the `most`th on.
    #[must_use]
    pub fn limited(self, most: Option<u64>) -> Self {
        let count = most.map_or(self.count, |most| self.count.min(most));
        Self { count, ..self }
    }

    /// The values of a design's inputs, in their order.
    #[must_use]
    pub fn design(&self, id: u64) -> Vec<Value> {
        match self.method {
            Method::Factorial => {
                self.inputs.iter().zip(self.digits(id)).filter_map(|(one, at)| one.level(at)).collect()
            }
            Method::List => self.inputs.iter().filter_map(|one| one.level(id)).collect(),
            Method::Latin | Method::Sobol | Method::Saltelli => {
                let places = self.inputs.iter().enumerate();
                places.filter_map(|(at, one)| one.sampled(self.place(id, at))).collect()
            }
        }
    }

    /// The level of each input of a factorial plan: the digits of the index, in as many bases as there are inputs. The last
    /// input changes first.
    fn digits(&self, id: u64) -> Vec<u64> {
        let mut rest = id;
        let mut digits: Vec<u64> = self
            .inputs
            .iter()
            .rev()
            .map(|one| {
                let count = one.levels.count().unwrap_or(1).max(1);
                let digit = rest % count;
                rest /= count;
                digit
            })
            .collect();
        digits.reverse();
        digits
    }

    /// Where a design lies in the range of an input, from 0 to below 1.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
    pub fn place(&self, id: u64, input: usize) -> f64 {
        let of = |digit: u64, count: u64| (digit as f64 + 0.5) / count.max(1) as f64;
        match self.method {
            Method::Sobol => self.sobol.at(id, input),
            Method::Saltelli => {
                let (point, design) = self.group(id);
                let of_second = design == 1 || design == input + 2;
                self.sobol.at(point, if of_second { self.inputs.len() + input } else { input })
            }
            Method::Latin => {
                let axis = u64::try_from(input).unwrap_or(u64::MAX);
                let slice = permuted(id, self.whole, drawn(self.seed, axis, 0));
                (slice as f64 + unit(drawn(self.seed, axis, id + 1))) / self.whole as f64
            }
            Method::Factorial => {
                let digit = self.digits(id).get(input).copied().unwrap_or_default();
                of(digit, self.inputs.get(input).and_then(|one| one.levels.count()).unwrap_or(1))
            }
            // In the order of the list: by its values a design has no place.
            Method::List => of(id, self.count),
        }
    }

    /// The group of a design of a plan for indices, and its place in it: 0 and 1 for the two designs, from 2 on for those that have one
    /// input of the second.
    #[must_use]
    pub fn group(&self, id: u64) -> (u64, usize) {
        let size = grouped(self.inputs.len());
        (id / size, usize::try_from(id % size).unwrap_or_default())
    }

    /// The plan in words for a program, without the folder and the chunks that it is worked in: what two runs must have in common
    /// so that their rows may stand together, but for the sum of the `workbook`: one that was only saved again has other bytes, and the
    /// same `values`, whose sum stands beside it.
    #[must_use]
    pub fn told(&self, workbook: &str, values: &str, version: &str) -> serde_json::Value {
        let number = |value: &Value| match value {
            Value::Real(value) => json!(value),
            Value::Whole(value) => json!(value),
            Value::Choice(key) => json!(key),
            Value::Line(line) => json!(line),
        };
        let inputs: Vec<_> = self
            .inputs
            .iter()
            .map(|one| {
                let levels = match &one.levels {
                    Levels::Steps { from, step, count } => json!({ "from": from, "step": step, "count": count }),
                    Levels::Values(values) => json!({ "values": values.iter().map(number).collect::<Vec<_>>() }),
                    Levels::Range { from, to, spread: Spread::Uniform } => json!({ "from": from, "to": to }),
                    Levels::Range { from, to, spread: Spread::Normal { mean, deviation } } => {
                        json!({ "from": from, "to": to, "mean": mean, "deviation": deviation })
                    }
                };
                json!({ "input": one.symbol(), "unit": one.parameter.unit.label(), "levels": levels })
            })
            .collect();
        let mut told = json!({
            "schema": "rodete-sweep 1",
            "rodete": version,
            WORKBOOK_SUM: workbook,
            "values_sha256": values,
            "kind": self.form.kind,
            "method": self.method.key(),
            "level": self.level.key(),
            "seed": self.seed,
            "count": self.count,
            "inputs": inputs,
            "objectives": self.objectives.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "constraints": self.constraints.iter().map(ToString::to_string).collect::<Vec<_>>(),
        });
        // Of a sample of as many that is whole, the designs are others.
        if self.whole != self.count {
            told["first_of"] = self.whole.into();
        }
        told
    }

    /// The designs of a chunk of several, all of about one size.
    #[must_use]
    pub fn chunk(&self, number: u64, of: u64) -> std::ops::Range<u64> {
        let cut = |at: u64| {
            let at = u128::from(self.count) * u128::from(at) / u128::from(of.max(1));
            u64::try_from(at).unwrap_or(self.count)
        };
        cut(number)..cut(number + 1)
    }
}
