//! From the sheet of variants to a plan, or to everything that is wrong with the sheet.

use crate::escape::excerpt;
use crate::finding::{CellPlace, Finding, Key, Place, Raise, Typed};
use crate::kind::Kind;
use crate::kind::measure::{Level, Measure};
use crate::limits::SWEEP_DESIGNS;
use crate::number::decimal;
use crate::parameter::field::{Entry, Fields};
use crate::parameter::{FieldKind, Form, Parameter, Value, at};
use crate::sweep::form::{
    CONSTRAINTS, DESIGNS, DISTRIBUTION, FROM, INPUT, LEVEL, METHOD, NAME, OBJECTIVES, SAMPLES, SEED, STEP, TO, VALUES,
};
use crate::sweep::objective::{Constraint, Objective, bound, direction, pieces};
use crate::sweep::plan::{Input, Levels, Method, Plan, Spread, billionth, grouped, whole};
use crate::sweep::rules::*;
use crate::sweep::sobol;
use crate::text::{Language, Text};

/// Characters of a text that are shown.
const SHOWN: usize = crate::limits::EXCERPT;

/// The designs of a list.
#[derive(Clone, Debug)]
pub struct Designs {
    /// The name of their sheet.
    pub sheet: String,
    /// The inputs, as the row of symbols names them.
    pub inputs: Vec<&'static Parameter>,
    /// The values, one design a row.
    pub rows: Vec<Vec<Value>>,
}

/// The input that a cell names: its key, or its symbol.
#[must_use]
pub fn input(form: &Form, symbol: &str) -> Option<&'static Parameter> {
    form.parameter(symbol).or_else(|| form.parameters().map(|(_, one)| one).find(|one| one.symbol() == symbol))
}

/// True for an input that can be varied: a number, or one of a list of words.
#[must_use]
pub const fn varies(parameter: &Parameter) -> bool {
    matches!(parameter.kind, FieldKind::Real { .. } | FieldKind::Whole { .. } | FieldKind::Choice(_))
}

/// The plan of a sheet, with what a person should know of it.
///
/// # Errors
/// Everything that is wrong with it, each at its cells.
pub fn plan(kind: &dyn Kind, fields: &Fields, designs: Option<Designs>) -> Result<(Plan, Vec<Finding>), Vec<Finding>> {
    let mut reader = PlanReader { kind, fields, method: fields.get(&METHOD), findings: Vec::new(), notes: Vec::new() };
    let level = fields.get(&LEVEL);
    let inputs = reader.inputs(designs);
    let (objectives, constraints) = reader.measured(level);
    let count = reader.count(&inputs);
    if reader.method == Method::Saltelli && objectives.is_empty() {
        reader.wrong(OBJECTIVES.key(), &NothingExplained {});
    }
    let PlanReader { method, findings, notes, .. } = reader;
    let Some(count) = count.filter(|_| findings.is_empty()) else { return Err(findings) };
    let seed = fields.get(&SEED).map_or(1, u64::from);
    Ok((Plan::new(kind.form(), inputs, method, (seed, count), level, (objectives, constraints)), notes))
}

struct PlanReader<'a> {
    kind: &'a dyn Kind,
    fields: &'a Fields,
    method: Method,
    findings: Vec<Finding>,
    notes: Vec<Finding>,
}

impl PlanReader<'_> {
    /// A finding at the cell of a setting.
    fn wrong(&mut self, key: Key, row: &dyn Raise) {
        let finding = self.fields.locate(row.at(at([key])));
        self.findings.push(finding);
    }

    fn inputs(&mut self, designs: Option<Designs>) -> Vec<Input> {
        let rows: Vec<Entry<'_>> = self.fields.rows("inputs").collect();
        if self.method == Method::List {
            let Some(designs) = designs else {
                self.wrong(METHOD.key(), &NoDesignsSheet { sheet: DESIGNS });
                return Vec::new();
            };
            if designs.rows.is_empty() {
                self.findings.push(NoDesigns { sheet: DESIGNS }.at(Place::Sheet(designs.sheet)));
                return Vec::new();
            }
            if !rows.is_empty() {
                self.notes.push(ListAndInputs { sheet: NAME }.at(Place::Cells(cells(&rows, &INPUT.row))));
            }
            let values = |at: usize| designs.rows.iter().filter_map(|row| row.get(at).cloned()).collect();
            let inputs = designs.inputs.iter().enumerate();
            return inputs.map(|(at, one)| Input { parameter: one, levels: Levels::Values(values(at)) }).collect();
        }
        if rows.is_empty() {
            self.wrong(METHOD.key(), &NothingVaries { sheet: NAME });
        }
        let mut inputs: Vec<Input> = Vec::new();
        for row in &rows {
            match self.input(row) {
                Ok(input) if inputs.iter().any(|one| one.parameter.key == input.parameter.key) => {
                    let symbol = input.parameter.key();
                    self.findings.push(InputTwice { symbol }.at(Place::Cells(row.cell(&INPUT.row))));
                }
                Ok(input) => inputs.push(input),
                Err(finding) => self.findings.push(*finding),
            }
        }
        let sampled = matches!(self.method, Method::Latin | Method::Sobol | Method::Saltelli);
        if !sampled && self.fields.get(&SAMPLES).is_some() {
            self.unread_samples();
        }
        // A plan for indices takes two points of the sequence side by side.
        let most = match self.method {
            Method::Sobol => sobol::MOST,
            Method::Saltelli => sobol::MOST / 2,
            Method::Factorial | Method::Latin | Method::List => usize::MAX,
        };
        if inputs.len() > most {
            let row = TooManySampled { count: inputs.len(), method: self.method, most };
            self.wrong(METHOD.key(), &row);
        }
        inputs
    }

    /// An input of a row.
    fn input(&mut self, row: &Entry<'_>) -> Result<Input, Box<Finding>> {
        let at = |columns: &[&Parameter]| {
            let cells: Vec<CellPlace> = columns.iter().flat_map(|column| row.cell(column)).collect();
            Place::Cells(cells)
        };
        let name = row.get(&INPUT);
        let Some(parameter) = input(self.kind.form(), &name) else {
            return Err(Box::new(NoSuchInput { symbol: excerpt(&name, SHOWN) }.at(at(&[&INPUT.row]))));
        };
        let symbol = parameter.key();
        if !varies(parameter) {
            return Err(Box::new(InputNotVaried { symbol }.at(at(&[&INPUT.row]))));
        }
        let (from, to, step) = (row.get(&FROM), row.get(&TO), row.get(&STEP));
        let distribution = row.get(&DISTRIBUTION);
        let levels = match (from, to, row.get(&VALUES)) {
            (None, None, Some(values)) if step.is_none() && pieces(&values).next().is_some() => {
                if distribution.is_some() {
                    let told = DistributionWithoutRange { symbol }.at(at(&[&DISTRIBUTION.row]));
                    return Err(Box::new(told));
                }
                let read = |text: &str| {
                    value(parameter, text).ok_or_else(|| {
                        let expected = expected(parameter);
                        let told = ValueUnread { symbol, text: excerpt(text, SHOWN), expected };
                        Box::new(told.at(at(&[&VALUES.row])))
                    })
                };
                let read: Vec<Value> = pieces(&values).map(read).collect::<Result<_, _>>()?;
                if let Some((_, twice)) = pieces(&values).enumerate().find(|(at, _)| read[..*at].contains(&read[*at])) {
                    let told = ValueTwice { symbol, text: excerpt(twice, SHOWN) };
                    return Err(Box::new(told.at(at(&[&VALUES.row]))));
                }
                Levels::Values(read)
            }
            (Some(from), Some(to), None) if !matches!(parameter.kind, FieldKind::Choice(_)) => {
                self.range(parameter, [from, to], step, distribution, &at)?
            }
            _ => {
                let columns = [&INPUT.row, &FROM.row, &TO.row, &VALUES.row];
                return Err(Box::new(RangeOrValues { symbol }.at(at(&columns))));
            }
        };
        Ok(Input { parameter, levels })
    }

    fn range(
        &mut self,
        parameter: &'static Parameter,
        [from, to]: [f64; 2],
        step: Option<f64>,
        distribution: Option<String>,
        at: &dyn Fn(&[&Parameter]) -> Place,
    ) -> Result<Levels, Box<Finding>> {
        let symbol = parameter.key();
        let typed = |value: f64| Typed { value, unit: parameter.unit.label() };
        if from >= to {
            let told = RangeReversed { symbol, from: typed(from), to: typed(to) };
            return Err(Box::new(told.at(at(&[&FROM.row, &TO.row]))));
        }
        let (min, max) = match parameter.kind {
            FieldKind::Whole { min, max } => (f64::from(min), f64::from(max)),
            FieldKind::Real { min, max } => (min, max),
            _ => (f64::MIN, f64::MAX),
        };
        for (value, column) in [(from, &FROM.row), (to, &TO.row)] {
            if !(min..=max).contains(&value) {
                let told = BeyondLimits { symbol, value: typed(value), min: typed(min), max: typed(max) };
                return Err(Box::new(told.at(at(&[column]))));
            }
        }
        if matches!(parameter.kind, FieldKind::Whole { .. }) {
            let numbers = [(Some(from), &FROM.row), (Some(to), &TO.row), (step, &STEP.row)];
            let broken = numbers.iter().find(|(number, _)| number.is_some_and(|number| whole(number).is_none()));
            if let Some((Some(value), column)) = broken {
                let told = RangeNotWhole { symbol, value: Typed { value: *value, unit: "" } };
                return Err(Box::new(told.at(at(&[column]))));
            }
        }
        let Some(step) = step else {
            if self.method == Method::Factorial {
                return Err(Box::new(StepNeeded { symbol }.at(at(&[&STEP.row]))));
            }
            let spread = match distribution {
                None => Spread::Uniform,
                Some(text) => {
                    let shown = excerpt(&text, SHOWN);
                    let Some(spread) = spread(&text) else {
                        return Err(Box::new(DistributionUnread { text: shown }.at(at(&[&DISTRIBUTION.row]))));
                    };
                    if !spread.reaches([from, to]) {
                        let columns = [&FROM.row, &TO.row, &DISTRIBUTION.row];
                        return Err(Box::new(DistributionElsewhere { text: shown }.at(at(&columns))));
                    }
                    spread
                }
            };
            return Ok(Levels::Range { from, to, spread });
        };
        if distribution.is_some() {
            return Err(Box::new(DistributionWithoutRange { symbol }.at(at(&[&DISTRIBUTION.row]))));
        }
        // The last one counts though rounding leaves it a billionth short.
        let steps = ((to - from) / step + 1e-9).floor() + 1.0;
        if !(step > 0.0 && steps >= 2.0) {
            let told = WrongStep { symbol, step: typed(step), range: typed(billionth(to - from)) };
            return Err(Box::new(told.at(at(&[&STEP.row]))));
        }
        let levels = Levels::Steps { from, step, count: floor(steps) };
        let last = billionth(from + (steps - 1.0) * step);
        if to - last > 1e-6 * step {
            let told = LastBeforeTo { symbol, last: typed(last), to: typed(to) };
            self.notes.push(told.at(at(&[&TO.row, &STEP.row])));
        }
        Ok(levels)
    }

    /// How many designs there are; `None` where that is not known, or too many.
    fn count(&mut self, inputs: &[Input]) -> Option<u64> {
        let count = match self.method {
            Method::List => inputs.first().and_then(|one| one.levels.count()).map(u128::from),
            Method::Factorial => Some(
                inputs
                    .iter()
                    .filter_map(|one| one.levels.count())
                    .fold(1_u128, |all, one| all.saturating_mul(one.into())),
            ),
            Method::Latin | Method::Sobol | Method::Saltelli => {
                let samples = self.fields.get(&SAMPLES);
                if samples.is_none() {
                    let method = self.method;
                    self.wrong(SAMPLES.key(), &SamplesNeeded { method });
                }
                let group = if self.method == Method::Saltelli { grouped(inputs.len()) } else { 1 };
                samples.map(|samples| u128::from(samples) * u128::from(group))
            }
        }?;
        if count > u128::from(SWEEP_DESIGNS) {
            self.wrong(METHOD.key(), &TooManyDesigns { count: count.to_string(), most: SWEEP_DESIGNS.into() });
        }
        u64::try_from(count).ok().filter(|count| *count > 0 && *count <= SWEEP_DESIGNS.into())
    }

    /// A caution that a plan which samples nothing does not read how many designs are sampled.
    fn unread_samples(&mut self) {
        let told = SamplesUnread { method: self.method }.at(Place::Parameters(vec![SAMPLES.key()]));
        self.notes.push(self.fields.locate(told));
    }

    /// What is asked of the designs.
    fn measured(&mut self, level: Level) -> (Vec<Objective>, Vec<Constraint>) {
        let asked = self.fields.get(&OBJECTIVES).is_some() || self.fields.get(&CONSTRAINTS).is_some();
        if asked && self.kind.measures().iter().all(|one| one.level > level) {
            self.wrong(LEVEL.key(), &LevelWithoutMeasures {});
            return (Vec::new(), Vec::new());
        }
        (self.objectives(level), self.constraints(level))
    }

    fn objectives(&mut self, level: Level) -> Vec<Objective> {
        let text = self.fields.get(&OBJECTIVES).unwrap_or_default();
        let mut objectives: Vec<Objective> = Vec::new();
        for piece in pieces(&text) {
            match direction(piece) {
                None => self.wrong(OBJECTIVES.key(), &ObjectiveUnread { text: excerpt(piece, SHOWN) }),
                Some((key, most)) => {
                    let measure = self.measure(OBJECTIVES.key(), key, level);
                    if let Some(twice) = measure.filter(|one| objectives.iter().any(|it| it.measure.key == one.key)) {
                        self.wrong(OBJECTIVES.key(), &ObjectiveTwice { key: twice.key });
                    }
                    objectives.extend(measure.map(|measure| Objective { measure, most }));
                }
            }
        }
        objectives
    }

    fn constraints(&mut self, level: Level) -> Vec<Constraint> {
        let text = self.fields.get(&CONSTRAINTS).unwrap_or_default();
        let mut constraints = Vec::new();
        for piece in pieces(&text) {
            match bound(piece) {
                None => self.wrong(CONSTRAINTS.key(), &ConstraintUnread { text: excerpt(piece, SHOWN) }),
                Some((key, least, bound)) => {
                    let measure = self.measure(CONSTRAINTS.key(), key, level);
                    constraints.extend(measure.map(|measure| Constraint { measure, least, bound }));
                }
            }
        }
        constraints
    }

    /// The measure of a key that the level gives.
    fn measure(&mut self, cell: Key, key: &str, level: Level) -> Option<&'static Measure> {
        let measures = self.kind.measures();
        let Some(measure) = measures.iter().find(|one| one.key == key) else {
            let known = measures.iter().filter(|one| one.level <= level).map(|one| one.key).collect::<Vec<_>>();
            self.wrong(cell, &NoSuchMeasure { key: excerpt(key, SHOWN), known: known.join(", ") });
            return None;
        };
        if measure.level > level {
            self.wrong(cell, &MeasureAboveLevel { key: measure.key });
            return None;
        }
        Some(measure)
    }
}

/// The cells of a column in several rows.
fn cells(rows: &[Entry<'_>], column: &Parameter) -> Vec<CellPlace> {
    rows.iter().flat_map(|row| row.cell(column)).take(10).collect()
}

/// A positive number without its fraction.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast stays within the type")]
const fn floor(number: f64) -> u64 {
    number as u64
}

/// A value of an input, as it stands in a list of values.
fn value(parameter: &'static Parameter, text: &str) -> Option<Value> {
    let number = || text.parse::<f64>().ok().filter(|number| number.is_finite());
    match &parameter.kind {
        FieldKind::Real { min, max } => {
            number().filter(|number| (*min..=*max).contains(number)).map(|number| Value::Real(number + 0.0))
        }
        FieldKind::Whole { min, max } => {
            number().and_then(whole).filter(|number| (*min..=*max).contains(number)).map(Value::Whole)
        }
        FieldKind::Choice(choices) => {
            let said = text.to_lowercase();
            let is = |word: &str| word.to_lowercase() == said;
            let choice = choices.iter().find(|one| is(one.key) || is(&one.label.es) || is(&one.label.en));
            choice.map(|one| Value::Choice(one.key))
        }
        _ => None,
    }
}

/// What a value must be, as the end of a sentence.
fn expected(parameter: &Parameter) -> Text {
    match &parameter.kind {
        FieldKind::Real { min, max } => {
            let (min, max) = (decimal(*min), decimal(*max));
            Text::new(format!("un número de {min} a {max}"), format!("a number from {min} to {max}"))
        }
        FieldKind::Whole { min, max } => {
            Text::new(format!("un número entero de {min} a {max}"), format!("a whole number from {min} to {max}"))
        }
        FieldKind::Choice(choices) => {
            let list = |language| choices.iter().map(|one| one.label.get(language)).collect::<Vec<_>>().join(", ");
            Text::new(
                format!("una de estas palabras: {}", list(Language::Es)),
                format!("one of: {}", list(Language::En)),
            )
        }
        _ => Text::same(""),
    }
}

/// The distribution that a cell says; `None` where it says none.
fn spread(text: &str) -> Option<Spread> {
    let words: Vec<&str> = text.split_whitespace().collect();
    match words.as_slice() {
        ["uniform" | "uniforme"] => Some(Spread::Uniform),
        ["normal", mean, deviation] => {
            let (mean, deviation): (f64, f64) = (mean.parse().ok()?, deviation.parse().ok()?);
            (mean.is_finite() && deviation.is_finite() && deviation > 0.0).then_some(Spread::Normal { mean, deviation })
        }
        _ => None,
    }
}
