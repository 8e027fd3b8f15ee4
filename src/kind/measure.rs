//! What designs of a kind are compared by: values with key and unit, and how much must be worked out before each is known.

use crate::finding::{Datum, Finding};
use crate::kind::{Outcome, Proved, Timed};
use crate::parameter::field::choices;
use crate::proof::check::Check;
use crate::table::{Quantity, Unit};
use crate::text::Text;

choices! {
    /// What a design is judged by.
    #[derive(PartialOrd, Ord)]
    pub enum Level {
        /// The derived limits, and the programs as they are planned: nothing is read back, and what they leave or spoil is not
        /// searched for.
        Limits = "limits" ("límites", "limits"),
        /// The programs as they are read back from their text, with all checks.
        Program = "program" ("programa", "program"),
    }
}

/// Where a measure comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasureSource {
    /// The derived value of the same symbol.
    Quantity,
    /// The time of the programs with these keys, as many as there are; of one without a known time there is none.
    Time(&'static [&'static str]),
    /// The greatest number that checks with these keys measured.
    Greatest(&'static [&'static str]),
    /// The least number that checks with these keys measured.
    Least(&'static [&'static str]),
    /// How far programs enter what they must not: the number that a finding carries under a name, or what checks with these keys
    /// measured below 0; 0 where neither tells of it.
    Entered {
        /// The finding's code.
        code: &'static str,
        /// What its number is called.
        under: &'static str,
        /// The keys of the checks.
        keys: &'static [&'static str],
    },
}

/// A value that designs are compared by.
#[derive(Debug)]
pub struct Measure {
    /// Its key: what objectives and constraints call it, and the name of its column.
    pub key: &'static str,
    /// What it is: its [name](Self::name), and behind a comma or a semicolon the rest. Empty for a derived value, which the results
    /// explain.
    pub meaning: Text,
    /// Its unit.
    pub unit: Unit,
    /// From which level on it is known.
    pub level: Level,
    /// Where it comes from.
    pub source: MeasureSource,
}

impl Measure {
    /// A derived value that is known before programs are read back.
    #[must_use]
    pub const fn derived(key: &'static str, unit: Unit) -> Self {
        Self { key, meaning: crate::text::t("", ""), unit, level: Level::Limits, source: MeasureSource::Quantity }
    }

    /// A derived value that the programs give.
    #[must_use]
    pub const fn read_back(key: &'static str, unit: Unit) -> Self {
        Self { key, meaning: crate::text::t("", ""), unit, level: Level::Program, source: MeasureSource::Quantity }
    }

    /// A value of programs that are read back.
    #[must_use]
    pub const fn of_programs(key: &'static str, unit: Unit, source: MeasureSource, meaning: Text) -> Self {
        Self { key, meaning, unit, level: Level::Program, source }
    }

    /// What a chart calls it: in words, what its meaning begins with; a derived value by its symbol.
    #[must_use]
    pub fn name(&self) -> Text {
        let clause = |meaning: &str| match meaning.split([',', ';', ':']).next() {
            Some(clause) if !clause.is_empty() => clause.to_owned(),
            _ => self.key.to_owned(),
        };
        Text::new(clause(&self.meaning.es), clause(&self.meaning.en))
    }

    /// Its value; `None` where the design has none.
    #[must_use]
    pub fn of(&self, known: &MeasuredOutcome<'_>) -> Option<f64> {
        let measured = |keys: &[&str]| {
            let of_keys: Vec<f64> =
                known.checks.iter().filter(|one| keys.contains(&one.key())).filter_map(Check::measured).collect();
            of_keys.into_iter()
        };
        let value = match self.source {
            MeasureSource::Quantity => known.quantities.iter().find(|one| one.symbol == self.key).map(|one| one.value),
            MeasureSource::Time(keys) => time(known.programs.iter().filter(|one| keys.contains(&one.key))),
            MeasureSource::Greatest(keys) => measured(keys).max_by(f64::total_cmp),
            MeasureSource::Least(keys) => measured(keys).min_by(f64::total_cmp),
            MeasureSource::Entered { code, under, keys } => {
                let carried = |one: &Finding| match one.data.iter().find(|(name, _)| *name == under) {
                    Some((_, Datum::Number { value, .. })) if one.code() == code => *value,
                    _ => None,
                };
                let found = known.findings.iter().filter_map(carried);
                let depth = found.chain(measured(keys).map(|least| -least)).fold(0.0, f64::max);
                (!known.programs.is_empty()).then_some(depth)
            }
        };
        value.filter(|value| value.is_finite())
    }
}

/// The time of programs together, s; `None` where there is none, or one whose time is not known.
fn time<'a>(programs: impl Iterator<Item = &'a Proved>) -> Option<f64> {
    let mut sum = None;
    for program in programs {
        match program.time() {
            (Timed::Cycle | Timed::Feed, Some(seconds)) => sum = Some(sum.unwrap_or(0.0) + seconds),
            _ => return None,
        }
    }
    sum
}

/// What is known of a design, as measures take it.
#[derive(Clone, Copy, Debug, Default)]
pub struct MeasuredOutcome<'a> {
    /// Derived values.
    pub quantities: &'a [Quantity],
    /// The programs, with their times.
    pub programs: &'a [Proved],
    /// The checks of the programs.
    pub checks: &'a [Check],
    /// What was found.
    pub findings: &'a [Finding],
}

impl<'a> MeasuredOutcome<'a> {
    /// What an outcome holds.
    #[must_use]
    pub fn of(outcome: &'a Outcome) -> Self {
        let Outcome { quantities, programs, checks, findings, .. } = outcome;
        Self { quantities, programs, checks, findings }
    }
}

/// What is worked out of a design before its programs are read back.
#[derive(Debug, Default)]
pub struct Limits {
    /// Derived values.
    pub quantities: Vec<Quantity>,
    /// What was found, stops among them.
    pub findings: Vec<Finding>,
}

/// The rows that a new workbook's sheet of variants begins with.
#[derive(Debug)]
pub struct Suggested {
    /// The name of the case that is varied, where it is another than the usual one.
    pub case: Option<&'static str>,
    /// The inputs, each with from, to and step, or with a list of values.
    pub inputs: &'static [(&'static str, Varied)],
    /// The objectives, as they stand in their cell.
    pub objectives: &'static str,
    /// The constraints, as they stand in theirs.
    pub constraints: &'static str,
}

/// How an input is varied.
#[derive(Clone, Copy, Debug)]
pub enum Varied {
    /// From, to and step, in the unit of the input.
    Steps(f64, f64, f64),
    /// Values, as they stand in their cell.
    Values(&'static str),
}

impl Suggested {
    /// Nothing: the sheet comes empty.
    pub const NOTHING: Self = Self { case: None, inputs: &[], objectives: "", constraints: "" };
}
