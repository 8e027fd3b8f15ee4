//! A table of the method: named, with its source, its columns with symbols and units, and the values.
//!
//! Sheets, JSON and the report's tables are views of it. Values are shared, never copied per view.

use std::borrow::Cow;
use std::sync::Arc;

use nalgebra::Vector3;
use serde::Serialize;

use crate::text::{Text, t};

/// The unit of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Unit {
    /// A pure number.
    One,
    /// A whole number of things.
    Count,
    /// Text: no unit.
    None,
    /// A length, mm.
    Millimetre,
    /// An angle, rad.
    Radian,
    /// An angle, °.
    Degree,
    /// Intervals of the discretisation, h.
    Step,
    /// A speed or a feed, mm/min.
    MillimetrePerMinute,
    /// The speed of a rotary axis, °/min.
    DegreePerMinute,
    /// A feed or a lead, mm/rev.
    MillimetrePerRevolution,
    /// A cutting speed, m/min.
    MetrePerMinute,
    /// A spindle speed, rpm.
    RevolutionPerMinute,
    /// A time, s.
    Second,
    /// An area, mm².
    SquareMillimetre,
    /// A volume, mm³.
    CubicMillimetre,
    /// A rate of metal removal, cm³/min.
    CubicCentimetrePerMinute,
}

impl Unit {
    /// What stands in a unit cell; empty for a pure number and for text.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::One | Self::Count | Self::None => "",
            Self::Millimetre => "mm",
            Self::Radian => "rad",
            Self::Degree => "°",
            Self::Step => "h",
            Self::MillimetrePerMinute => "mm/min",
            Self::DegreePerMinute => "°/min",
            Self::MillimetrePerRevolution => "mm/rev",
            Self::MetrePerMinute => "m/min",
            Self::RevolutionPerMinute => "rpm",
            Self::Second => "s",
            Self::SquareMillimetre => "mm²",
            Self::CubicMillimetre => "mm³",
            Self::CubicCentimetrePerMinute => "cm³/min",
        }
    }
}

/// The values of a column, one for each row.
#[derive(Clone, Debug)]
pub enum Cells {
    /// A number for each row, in the column's unit.
    Numbers(Arc<[f64]>),
    /// One component (0, 1, 2) of a list of vectors.
    Component(Arc<[Vector3<f64>]>, usize),
    /// A text for each row.
    Texts(Arc<[Text]>),
}

/// One cell of a table.
#[derive(Clone, Copy, Debug)]
pub enum Entry<'a> {
    /// A number, in the column's unit.
    Number(f64),
    /// A text in both languages.
    Text(&'a Text),
}

impl Cells {
    /// How many rows there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Component(values, _) => values.len(),
            Self::Texts(values) => values.len(),
        }
    }

    /// True for a column without rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The entry of one row.
    ///
    /// # Panics
    /// For a row that is not there.
    #[must_use]
    pub fn get(&self, row: usize) -> Entry<'_> {
        match self {
            Self::Numbers(values) => Entry::Number(values[row]),
            Self::Component(values, axis) => Entry::Number(values[row][*axis]),
            Self::Texts(values) => Entry::Text(&values[row]),
        }
    }
}

/// How the values of a column come about: every column says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// The program computes them as this says, in the source's letters.
    Told(&'static str),
    /// No formula of the column's own stands behind them: they are words, counts, what was given, or what a program comes to.
    None,
}

impl Law {
    /// What is said of it; `None` where there is nothing to say.
    #[must_use]
    pub const fn told(self) -> Option<&'static str> {
        match self {
            Self::Told(told) => Some(told),
            Self::None => None,
        }
    }
}

/// The formula of a cell in a spreadsheet: a second statement of its value, computed anew as soon as an input changes.
///
/// Inputs and derived values stand by their defined names, as `torus_R` and `derived_k`. Cells of tables stand in brackets:
/// `[v]` is the column v of the same table on the same row, `[annex-1.v]` that of another table, `[i]` the point index;
/// `[v above]` is the row before. `[annex-6.x first]` and `[annex-6.x last]` are the column's ends, `[annex-6.x all]` is the whole of it. The functions are
/// those of every spreadsheet since 2003; `ATAN2` takes x before y.
pub type Formula = Cow<'static, str>;

/// The formulas of a column.
#[derive(Clone, Debug)]
pub enum Live {
    /// One for all rows.
    Rows(Formula),
    /// Each row has its own, as many as there are values.
    Cells(Vec<Formula>),
}

impl Live {
    /// The formula of a row; `None` for a row that is not there.
    #[must_use]
    pub fn get(&self, row: usize) -> Option<&str> {
        match self {
            Self::Rows(formula) => Some(formula),
            Self::Cells(formulas) => formulas.get(row).map(|formula| &**formula),
        }
    }
}

/// A column of a table.
#[derive(Clone, Debug)]
pub struct Column {
    /// The symbol, as in the source.
    pub symbol: Text,
    /// The unit of its values.
    pub unit: Unit,
    /// How the values come about.
    pub law: Law,
    /// What a spreadsheet computes them by; `None` where they stand as values: what is searched for, or read back.
    pub live: Option<Live>,
    /// The formulas take a value that stands as it is: when an input changes they follow it only in part.
    pub in_part: bool,
    /// The values, one for each row.
    pub values: Cells,
}

impl Column {
    /// A column of numbers.
    #[must_use]
    pub fn numbers(symbol: &'static str, unit: Unit, law: Law, values: impl Into<Arc<[f64]>>) -> Self {
        Self { symbol: t(symbol, symbol), unit, law, live: None, in_part: false, values: Cells::Numbers(values.into()) }
    }

    /// The column under another name.
    #[must_use]
    pub fn named(mut self, symbol: Text) -> Self {
        self.symbol = symbol;
        self
    }

    /// The column computed by one formula in every row.
    #[must_use]
    pub fn by(mut self, formula: impl Into<Formula>) -> Self {
        self.live = Some(Live::Rows(formula.into()));
        self
    }

    /// The column computed by a formula of its own in each row.
    #[must_use]
    pub fn by_each(mut self, formulas: impl IntoIterator<Item = impl Into<Formula>>) -> Self {
        self.live = Some(Live::Cells(formulas.into_iter().map(Into::into).collect()));
        self
    }

    /// The column whose formulas take a value that stands as it is.
    #[must_use]
    pub const fn in_part(mut self) -> Self {
        self.in_part = true;
        self
    }

    /// Three columns from a list of vectors.
    #[must_use]
    pub fn vectors(symbols: [&'static str; 3], unit: Unit, law: Law, values: &Arc<[Vector3<f64>]>) -> [Self; 3] {
        [0, 1, 2].map(|axis| Self {
            symbol: t(symbols[axis], symbols[axis]),
            unit,
            law,
            live: None,
            in_part: false,
            values: Cells::Component(Arc::clone(values), axis),
        })
    }

    /// A column of texts.
    #[must_use]
    pub fn texts(symbol: Text, law: Law, values: Vec<Text>) -> Self {
        Self { symbol, unit: Unit::None, law, live: None, in_part: false, values: Cells::Texts(values.into()) }
    }
}

/// What stands in column A of a table's sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Index {
    /// The point index i, from 0.
    Point,
    /// The index i, from 0 to `times` the count of intervals that an input holds, and `more`. Rows come and go with it.
    Intervals {
        /// The defined name of the input's cell.
        name: &'static str,
        /// Rows for each interval.
        times: usize,
        /// Rows beside them, the first not counted.
        more: usize,
    },
    /// Nothing is counted: the first column is the table's own. There is at most one row for each of the intervals that an input
    /// holds; the columns say where they end.
    Within {
        /// The defined name of the input's cell.
        name: &'static str,
        /// How many intervals it holds.
        intervals: usize,
    },
    /// Nothing is counted: the first column is the table's own.
    None,
}

impl Index {
    /// True where points are counted.
    #[must_use]
    pub const fn counted(self) -> bool {
        matches!(self, Self::Point | Self::Intervals { .. })
    }
}

/// How much of a table is printed; its sheet has all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Print {
    /// All of it: it is read row by row.
    Whole,
    /// The head and the tail, where it is long.
    Short,
    /// Nothing: it is of the sheets alone.
    No,
    /// Nothing, and it is a sheet only where that has formulas: they put together again what was verified elsewhere.
    Formulas,
}

/// A table of the method.
#[derive(Clone, Debug)]
pub struct Table {
    /// The name in JSON and in findings, as `annex-1`.
    pub key: &'static str,
    /// The sheet's name.
    pub name: Text,
    /// The title above it.
    pub title: Text,
    /// Equation and annex; "derived here" where the columns' own formulas are the derivation.
    pub source: Text,
    /// What column A holds.
    pub index: Index,
    /// How much of it the report prints.
    pub print: Print,
    /// The columns, all of one length.
    pub columns: Vec<Column>,
}

impl Table {
    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// The first value that is not finite, as column and row: a table with one is a fault in rodete.
    #[must_use]
    pub fn not_finite(&self) -> Option<(usize, usize)> {
        self.columns.iter().enumerate().find_map(|(at, column)| {
            (0..column.values.len())
                .find(|&row| matches!(column.values.get(row), Entry::Number(value) if !value.is_finite()))
                .map(|row| (at, row))
        })
    }

    /// The column with this symbol, as it is in English; `None` where there is none.
    #[must_use]
    pub fn column(&self, symbol: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.symbol.en == symbol)
    }
}

/// A single derived value: a limit, an angle, a length of the design.
#[derive(Clone, Debug, Serialize)]
pub struct Quantity {
    /// The symbol, as in the source; also the name in JSON.
    pub symbol: &'static str,
    /// What it is.
    pub meaning: Text,
    /// The value, in the unit.
    pub value: f64,
    /// The unit of the value.
    pub unit: Unit,
    /// Equation or derivation.
    pub source: Text,
    /// The defined name of its cell, and what a spreadsheet computes it by.
    #[serde(skip)]
    pub cell: Option<QuantityCell>,
}

/// The cell of a derived value in the results workbook.
#[derive(Clone, Debug)]
pub struct QuantityCell {
    /// Its defined name, as `derived_k`.
    pub name: &'static str,
    /// Its formula; `None` for a value that is searched for or read back.
    pub live: Option<Formula>,
}

impl Quantity {
    /// The value computed by a formula in a cell with a defined name.
    #[must_use]
    pub fn by(mut self, name: &'static str, formula: impl Into<Formula>) -> Self {
        self.cell = Some(QuantityCell { name, live: Some(formula.into()) });
        self
    }

    /// The value in a cell with a defined name: formulas refer to it.
    #[must_use]
    pub fn named(mut self, name: &'static str) -> Self {
        self.cell = Some(QuantityCell { name, live: None });
        self
    }
}
