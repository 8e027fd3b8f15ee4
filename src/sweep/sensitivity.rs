//! How much the result follows each input: around the design of the workbook, and over the whole plan.

use rayon::prelude::*;

use crate::kind::Kind;
use crate::number::decimal;
use crate::number::root::last_whole;
use crate::parameter::{FieldKind, Value, Values};
use crate::sweep::indices::Index;
use crate::sweep::objective::Objective;
use crate::sweep::plan::{Input, Levels, Method, Plan, billionth, slice};
use crate::sweep::row::{Row, State};
use crate::sweep::table::{FEASIBLE, ID, Table, whole};
use crate::table::Unit;
use crate::text::{Text, t};

/// The part of an input's range by which it is moved for its slope.
const PART: f64 = 0.01;
/// How many distances are looked at to each side, evenly, for where a design is no longer good.
pub const SAMPLES: u32 = 32;
/// How often the first of them is halved towards the design: what is spoilt close by is found in a narrow band, too.
const NEAR: u32 = 5;
/// A distance is told in steps of one part of so many: the fourth decimal is the last that is shown.
const GRAINS: f64 = 10_000.0;
/// The most slices of a range for the shares.
const SLICES: u64 = 32;
/// The fewest designs in a slice, in the mean.
const IN_SLICE: u64 = 8;
/// The fewest feasible designs from which a share is told, and the fewest in each slice that has any, in the mean.
pub const SHARES_LEAST: u32 = 64;
const FEASIBLE_LEAST: f64 = 4.0;

/// Why an input has no tolerance.
#[derive(Clone, Debug, PartialEq)]
pub enum NoRoom {
    /// The workbook's own design is not good: what is said of it.
    Design(Text),
    /// Its cell is empty.
    Empty,
    /// It is no number.
    NoNumber,
    /// The plan has one value of it.
    OneValue,
}

impl NoRoom {
    /// The words for it in place of the tolerance.
    #[must_use]
    pub const fn words(&self) -> Text {
        match self {
            Self::Design(_) => t("no válido", "not feasible"),
            Self::Empty => t("celda vacía", "empty cell"),
            Self::NoNumber => t("no es número", "no number"),
            Self::OneValue => t("un solo valor", "one value"),
        }
    }

    /// Of a design that is not good, by its row.
    fn of(row: &Row) -> Self {
        let reason = row.reason.as_deref().unwrap_or_default();
        let value =
            row.value.map_or_else(String::new, |value| format!(" ({})", decimal((value * GRAINS).round() / GRAINS)));
        Self::Design(match (row.state, row.limit) {
            (State::Refused, _) => Text::new(
                format!("Sin tolerancias: el propio diseño del libro se rechaza, {reason}."),
                format!("No tolerances: the workbook's own design is refused, {reason}."),
            ),
            (State::Failed, _) => t(
                "Sin tolerancias: rodete falla en el propio diseño del libro.",
                "No tolerances: rodete fails on the workbook's own design.",
            ),
            (State::Done, Some(_)) => Text::new(
                format!("Sin tolerancias: el propio diseño del libro incumple {reason}{value}."),
                format!("No tolerances: the workbook's own design breaks {reason}{value}."),
            ),
            (State::Done, None) => Text::new(
                format!("Sin tolerancias: el propio diseño del libro no da valor para {reason}."),
                format!("No tolerances: the workbook's own design has no value for {reason}."),
            ),
        })
    }
}

/// How much an objective changes for one unit of an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slope {
    /// The objective has no value on either side.
    Unknown,
    /// The change that was looked at is no more than the objective's rounding: by the width of a step it would be noise.
    Rounding,
    /// In the objective's unit by that of the input.
    Known(f64),
}

impl Slope {
    /// What stands in its place where it is lost in the rounding.
    pub const ROUNDING: &'static str = "–";

    /// From one value of the input, with the objective's, to another.
    fn between(from: (f64, f64), to: (f64, f64), unit: Unit) -> Self {
        let change = to.1 - from.1;
        match to.0 > from.0 {
            false => Self::Unknown,
            true if change.abs() <= rounding(unit) => Self::Rounding,
            true => Self::Known(change / (to.0 - from.0)),
        }
    }

    /// The number, where there is one.
    #[must_use]
    pub const fn known(self) -> Option<f64> {
        match self {
            Self::Known(slope) => Some(slope),
            Self::Unknown | Self::Rounding => None,
        }
    }
}

/// The rounding of a measure, in its unit: programs are written to 0.001 mm and 0.001°, times are told to 0.01 s. Below 0 for what is
/// counted, which is not rounded.
const fn rounding(unit: Unit) -> f64 {
    match unit {
        Unit::Count => -1.0,
        Unit::Millimetre | Unit::SquareMillimetre | Unit::Degree | Unit::MillimetrePerRevolution => 0.001,
        Unit::Second => 0.01,
        Unit::MillimetrePerMinute | Unit::DegreePerMinute | Unit::MetrePerMinute | Unit::CubicCentimetrePerMinute => {
            0.1
        }
        Unit::RevolutionPerMinute | Unit::CubicMillimetre => 1.0,
        Unit::One | Unit::None | Unit::Radian | Unit::Step => 1e-6,
    }
}

/// What an input does.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// Its symbol.
    pub symbol: String,
    /// Its unit.
    pub unit: &'static str,
    /// Its value in the workbook; `None` where it has none, or is no number.
    pub value: Option<f64>,
    /// How much each objective changes for one unit of it, around the workbook's design.
    pub slopes: Vec<Slope>,
    /// The least and greatest value of the plan; `None` where it is no number.
    pub ends: Option<[f64; 2]>,
    /// How much each objective changes when this input alone goes there; `None` where the objective has no value there.
    pub changes: Vec<[Option<f64>; 2]>,
    /// How far it may be smaller and larger until the design is refused or breaks a constraint, everything else unchanged; else why
    /// it has no such tolerance. As far as the plan's range is wide, at [`SAMPLES`] even distances; what lies between
    /// two of them is not looked at. Never more than what was judged good, to the digits that are shown.
    pub room: Result<[f64; 2], NoRoom>,
    /// The room ends at the width of the plan's range, not at a limit or at the bound of the input's cell.
    pub open: [bool; 2],
    /// The share of each objective's variance that follows this input alone, over the feasible designs of the plan.
    pub shares: Vec<Option<f64>>,
    /// The indices of Sobol by objective, of a plan that was made for them; then the shares are not estimated.
    pub indices: Vec<Option<Index>>,
}

/// The slopes and the room of every input around the design of a workbook, input by input side by side. `judge` works a design out.
#[must_use]
pub fn around(kind: &dyn Kind, base: &Values, plan: &Plan, judge: &(dyn Fn(&Values) -> Row + Sync)) -> Vec<Effect> {
    let own = judge(base);
    let good = |row: &Row| row.state == State::Done && row.feasible;
    let measures = kind.measures();
    let of = |row: &Row, objective: &Objective| {
        let at = measures.iter().position(|one| one.key == objective.measure.key)?;
        row.measures.get(at).copied().flatten()
    };
    let effect = |input: &Input| {
        let plain = Effect {
            symbol: input.symbol(),
            unit: input.parameter.unit.label(),
            value: None,
            slopes: vec![Slope::Unknown; plan.objectives.len()],
            ends: None,
            changes: vec![[None; 2]; plan.objectives.len()],
            room: Err(NoRoom::Empty),
            open: [false; 2],
            shares: vec![None; plan.objectives.len()],
            indices: vec![None; plan.objectives.len()],
        };
        // Around a cell that is empty there is nothing to look at.
        let Some(typed) = base.values.get(input.parameter.key) else { return plain };
        let (Some(value), Some([low, high])) = (number(typed), limits(input)) else {
            return Effect { room: Err(NoRoom::NoNumber), ..plain };
        };
        let Some(ends) = span(input) else {
            return Effect { value: Some(value), room: Err(NoRoom::OneValue), ..plain };
        };
        let moved = |to: f64| {
            let mut values = base.clone();
            let to = if input.whole() { to.round() } else { billionth(to) }.clamp(low, high);
            let value = if input.whole() { super::plan::whole(to).map(Value::Whole) } else { Some(Value::Real(to)) };
            if let Some(value) = value {
                values.values.insert(input.parameter.key, value);
            }
            (to, judge(&values))
        };
        let width = ends[1] - ends[0];
        let step = if input.whole() { 1.0 } else { PART * width };
        let (below, above) = (moved(value - step), moved(value + step));
        let slope = |objective: &Objective| {
            let [left, middle, right] = [&below.1, &own, &above.1].map(|row| of(row, objective));
            let (from, to) = match (left, middle, right) {
                (Some(left), _, Some(right)) => ((below.0, left), (above.0, right)),
                (None, Some(middle), Some(right)) => ((value, middle), (above.0, right)),
                (Some(left), Some(middle), None) => ((below.0, left), (value, middle)),
                _ => return Slope::Unknown,
            };
            Slope::between(from, to, objective.measure.unit)
        };
        let slopes = plan.objectives.iter().map(slope).collect();
        let at_ends = ends.map(|end| moved(end).1);
        let change = |objective: &Objective| {
            at_ends.each_ref().map(|row| of(row, objective).zip(of(&own, objective)).map(|(there, here)| there - here))
        };
        let changes = plan.objectives.iter().map(change).collect();
        let (mut room, mut open) = (Err(NoRoom::of(&own)), [false; 2]);
        if good(&own) {
            let ends = [-1.0, 1.0].map(|side| {
                let bound = if side < 0.0 { value - low } else { high - value };
                reach([bound, width], input.whole(), &|by| good(&moved(value + side * by).1))
            });
            room = Ok(ends.map(|(by, _)| by));
            open = ends.map(|(_, open)| open);
        }
        Effect { value: Some(value), slopes, ends: Some(ends), changes, room, open, ..plain }
    };
    plan.inputs.par_iter().map(effect).collect()
}

/// How many designs are worked out for that at most, beside the workbook's own: of each input that has a tolerance.
#[must_use]
pub fn most(base: &Values, plan: &Plan) -> Vec<u64> {
    let looks = |input: &Input| {
        base.values.get(input.parameter.key).and_then(number)?;
        limits(input)?;
        let [from, to] = span(input)?;
        let grains = if input.whole() { 1.0 } else { GRAINS };
        // The widest interval between two looks is halved until it is one grain.
        let mut widest = ((to - from) * grains / f64::from(SAMPLES)).ceil();
        let mut halvings = 0;
        while widest > 1.0 {
            widest = (widest / 2.0).ceil();
            halvings += 1;
        }
        // Its slope and its ends, and to each side what is looked at and halved.
        Some(4 + 2 * (u64::from(NEAR + SAMPLES) + halvings))
    };
    plan.inputs.iter().filter_map(looks).collect()
}

/// How far one may go, at most so far, and whether it is good to the end: in steps of the last digit that is shown, so that what is
/// read off was judged itself. Looks at distances that double, then at even ones, up to the first that is not good, and halves the
/// interval before it.
fn farthest(most: f64, whole: bool, good: &dyn Fn(f64) -> bool) -> (f64, bool) {
    let grains = if whole { 1.0 } else { GRAINS };
    // A distance whose last digit rounding has spoilt counts whole.
    let end = (most * grains + 1e-6).floor().max(0.0);
    let good = |at: f64| good(at / grains);
    let mut kept = 0.0;
    let near = (1..=NEAR).rev().map(|halved| 1.0 / f64::from(SAMPLES << halved));
    for part in near.chain((1..=SAMPLES).map(|look| f64::from(look) / f64::from(SAMPLES))) {
        let here = (end * part).floor();
        if here <= kept {
            continue;
        }
        if !good(here) {
            return (last_whole([kept, here], good) / grains, false);
        }
        kept = here;
    }
    (end / grains, true)
}

/// How far one may go, as far as the plan's range is wide or to the bound of the cell; and whether it might be farther: not where the
/// cell admits no more.
fn reach([bound, width]: [f64; 2], whole: bool, good: &dyn Fn(f64) -> bool) -> (f64, bool) {
    let (by, open) = farthest(bound.min(width), whole, good);
    (by, open && bound > width * (1.0 + 1e-9))
}

fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Real(number) => Some(*number),
        Value::Whole(whole) => Some(f64::from(*whole)),
        Value::Choice(_) | Value::Line(_) => None,
    }
}

/// The limits of an input's cell.
fn limits(input: &Input) -> Option<[f64; 2]> {
    match input.parameter.kind {
        FieldKind::Real { min, max } => Some([min, max]),
        FieldKind::Whole { min, max } => Some([min, max].map(f64::from)),
        _ => None,
    }
}

/// The least and greatest value of an input in the plan; `None` where they are the same.
#[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
fn span(input: &Input) -> Option<[f64; 2]> {
    let [from, to] = match &input.levels {
        Levels::Steps { from, step, count } => [*from, from + step * count.saturating_sub(1) as f64],
        Levels::Range { from, to, .. } => [*from, *to],
        Levels::Values(values) => {
            let numbers = || values.iter().filter_map(number);
            [numbers().fold(f64::MAX, f64::min), numbers().fold(f64::MIN, f64::max)]
        }
    };
    (to > from && (to - from).is_finite()).then_some([from, to])
}

/// The slice of each design of a list by the value of one input: as many designs in each, but equal values in the same one.
#[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
fn by_value(input: &Input, count: u64, slices: u64) -> Vec<u64> {
    let values: Vec<Value> = (0..count).filter_map(|id| input.level(id)).collect();
    let text = |value: &Value| match value {
        Value::Choice(key) => (*key).to_owned(),
        Value::Line(line) => line.clone(),
        Value::Real(_) | Value::Whole(_) => String::new(),
    };
    let order = |one: &usize, other: &usize| {
        let [one, other] = [one, other].map(|at| &values[*at]);
        let [a, b] = [one, other].map(|value| number(value).unwrap_or_default());
        a.total_cmp(&b).then_with(|| text(one).cmp(&text(other)))
    };
    let mut sorted: Vec<usize> = (0..values.len()).collect();
    sorted.sort_by(order);
    let mut slots = vec![0; values.len()];
    let mut first = 0;
    for (rank, at) in sorted.iter().enumerate() {
        if order(&sorted[first], at).is_ne() {
            first = rank;
        }
        slots[*at] = slice(first as f64 / values.len() as f64, slices);
    }
    slots
}

/// Sums of an objective in a slice of an input's range.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    count: f64,
    mean: f64,
    squares: f64,
}

impl Sums {
    /// Takes a value in (Welford).
    fn take(&mut self, value: f64) {
        self.count += 1.0;
        let off = value - self.mean;
        self.mean += off / self.count;
        self.squares += off * (value - self.mean);
    }
}

/// The shares of variance: the first-order indices of Sobol, from the rows of a plan that are there anyway. The range of an input is
/// cut into slices of equal likelihood, and the variance of the slices' means is compared with that of all.
///
/// # Derivation
/// S = Var(E(y | x))/Var(y); with B slices and n designs, what chance alone gives, (B − 1)/(n − B) of the variance inside the
/// slices, is taken off (the estimate ω² of the analysis of variance). Of an input that does nothing, the estimate then has a standard
/// deviation of about √(2·(B − 1))/n; with n at least 64 and at least 4·B that is at most 9 %, from fewer designs nothing is told.
/// Inputs are taken to be independent, which refused designs may spoil: then shares may sum to more than 1.
#[derive(Debug)]
pub struct Shares<'a> {
    plan: &'a Plan,
    /// Slices of each input.
    slices: Vec<u64>,
    /// Of a list, the slice of each design by input: they are cut by value, in whatever order they are listed.
    listed: Vec<Vec<u64>>,
    /// By input, then objective, then slice.
    sums: Vec<Vec<Vec<Sums>>>,
    all: Vec<Sums>,
}

impl<'a> Shares<'a> {
    /// Of no rows yet.
    #[must_use]
    pub fn new(plan: &'a Plan) -> Self {
        let most = (plan.count / IN_SLICE).clamp(2, SLICES);
        let of_list = plan.method == Method::List;
        let levels = |one: &Input| if of_list { None } else { one.levels.count() };
        let slices: Vec<u64> =
            plan.inputs.iter().map(|one| levels(one).map_or(most, |count| count.min(SLICES))).collect();
        let listed = if of_list {
            plan.inputs.iter().zip(&slices).map(|(one, count)| by_value(one, plan.count, *count)).collect()
        } else {
            Vec::new()
        };
        let sums = slices.iter().map(|count| {
            let slices = vec![Sums::default(); usize::try_from(*count).unwrap_or_default()];
            vec![slices; plan.objectives.len()]
        });
        Self { plan, sums: sums.collect(), slices, listed, all: vec![Sums::default(); plan.objectives.len()] }
    }

    /// Takes rows in, in the order of their indices.
    pub fn take(&mut self, rows: &Table) {
        let (Some(id), Some(feasible)) = (rows.column(ID), rows.column(FEASIBLE)) else { return };
        let objectives: Vec<_> = self.plan.objectives.iter().map(|one| rows.column(one.measure.key)).collect();
        for row in (0..rows.rows()).filter(|row| feasible.truth(*row)) {
            let Some(id) = id.number(row).map(whole) else { continue };
            let values: Vec<Option<f64>> =
                objectives.iter().map(|cells| cells.and_then(|cells| cells.number(row))).collect();
            for (all, value) in self.all.iter_mut().zip(&values) {
                value.iter().for_each(|value| all.take(*value));
            }
            for (input, (count, of_input)) in self.slices.iter().zip(&mut self.sums).enumerate() {
                let listed = self.listed.get(input).and_then(|slots| slots.get(usize::try_from(id).ok()?));
                let slot = listed.copied().unwrap_or_else(|| slice(self.plan.place(id, input), *count));
                let slot = usize::try_from(slot).unwrap_or_default();
                for (sums, value) in of_input.iter_mut().zip(&values) {
                    if let (Some(sums), Some(value)) = (sums.get_mut(slot), value) {
                        sums.take(*value);
                    }
                }
            }
        }
    }

    /// The shares by input, then objective; `None` where there are too few designs, or nothing varies.
    #[must_use]
    pub fn end(&self) -> Vec<Vec<Option<f64>>> {
        let share = |slices: &[Sums], all: &Sums| {
            let filled = || slices.iter().filter(|one| one.count > 0.0);
            let between: f64 = filled().map(|one| one.count * (one.mean - all.mean) * (one.mean - all.mean)).sum();
            let within: f64 = filled().map(|one| one.squares).sum();
            let groups = filled().fold(0.0, |sum, _| sum + 1.0);
            let free = all.count - groups;
            let few = all.count < f64::from(SHARES_LEAST) || all.count < FEASIBLE_LEAST * groups;
            if few || groups < 2.0 || all.squares <= 0.0 {
                return None;
            }
            let noise = within / free;
            Some(((between - (groups - 1.0) * noise) / (all.squares + noise)).clamp(0.0, 1.0))
        };
        self.sums
            .iter()
            .map(|of_input| of_input.iter().zip(&self.all).map(|(slices, all)| share(slices, all)).collect())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_within_the_rounding_of_what_is_judged_gives_no_slope() {
        let of = |by: f64, change: f64, unit| Slope::between((2.0, 0.5), (2.0 + by, 0.5 + change), unit);
        // A millionth of a millimetre over as short a way is no slope of 1.
        assert_eq!(of(1e-6, 1e-6, Unit::Millimetre), Slope::Rounding);
        assert_eq!(of(0.1, 0.000_9, Unit::Degree), Slope::Rounding);
        assert_eq!(of(0.1, 0.0, Unit::Second), Slope::Rounding);
        let known = of(0.5, -0.25, Unit::Millimetre).known().expect("a slope");
        assert!((known + 0.5).abs() < 1e-12, "{known}");
        // What is counted is not rounded.
        assert_eq!(of(0.5, 0.0, Unit::Count), Slope::Known(0.0));
        assert_eq!(of(0.5, 1.0, Unit::Count), Slope::Known(2.0));
        assert_eq!(of(0.0, 1.0, Unit::Millimetre), Slope::Unknown);
    }

    #[test]
    fn a_tolerance_as_it_is_shown_is_never_more_than_what_is_good() {
        for limit in [0.000_05, 0.013, 0.012_19, 0.4, 0.099_499_9, 7.0] {
            let (by, open) = farthest(10.0, false, &|by| by <= limit);
            let shown: f64 = format!("{by:.4}").parse().expect("a number");
            assert!(shown.to_bits() == by.to_bits() && by <= limit && by > limit - 0.000_1 && !open, "{limit}: {by}");
        }
        assert_eq!(farthest(1.0 / 3.0, false, &|_| true), (0.333_3, true));
        assert_eq!(farthest(2.0 - 0.01, false, &|_| true), (1.99, true));
        assert_eq!(farthest(5.0, true, &|by| by <= 3.0), (3.0, false));
        assert_eq!(farthest(5.0, true, &|_| false), (0.0, false));
        assert_eq!(farthest(0.0, false, &|_| false), (0.0, true));
        assert_eq!(farthest(400.0, true, &|by| by < 257.0), (256.0, false));
    }

    #[test]
    fn a_tolerance_that_ends_at_the_bound_of_its_cell_is_not_told_as_one_that_may_be_larger() {
        let open = |bound, width| reach([bound, width], false, &|_| true);
        assert_eq!((open(3.0, 10.0), open(0.0, 10.0)), ((3.0, false), (0.0, false)));
        assert_eq!((open(10.0, 3.0), open(4.0 - 1.0, 3.0)), ((3.0, true), (3.0, false)));
        assert_eq!(reach([10.0, 3.0], false, &|by| by <= 1.5), (1.5, false));
    }

    #[test]
    fn a_narrow_band_close_to_the_design_ends_the_tolerance() {
        // Good again before the first of the even distances.
        let (by, open) = farthest(4.0, false, &|by| !(0.011_6..0.1).contains(&by));
        assert!(!open && by < 0.011_6 && by > 0.011_4, "{by}");
    }

    #[test]
    fn a_band_that_spoils_the_part_ends_the_tolerance_though_it_is_good_again_beyond() {
        // As wide as a 32nd of the way, anywhere: distances that double would jump over it.
        for from in [0.3, 1.17, 3.0, 5.5, 8.7] {
            let (by, open) = farthest(10.0, false, &|by| !(from..from + 0.313).contains(&by));
            assert!(!open && by < from && by > from - 0.000_2, "{from}: {by}");
        }
    }
}
