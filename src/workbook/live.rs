//! Live cells: formulas over the inputs' defined names, with the values that the engine computed stored beside them.
//!
//! A column says its formula ([`Live`]); here the references in it become cells. The rows of a table that follows a count of
//! intervals are prepared beyond those that are filled, so that the count may grow: what is not reached shows nothing.

use rust_xlsxwriter::{Formula, RowNum, quote_sheet_name, utility::column_number_to_name};

use super::charts::Placed;
use super::error::WriteError;
use super::table_sheet::FIRST;
use crate::table::{Index, Live, Table};

/// More intervals than this are written as values: the sheets would grow to many megabytes and open slowly.
pub const MOST: usize = 400;

/// At least so many intervals are prepared.
const PREPARED: usize = 100;

/// What stands in a cell with a text formula that shows nothing: an empty result would be stored as 0.
pub const NOTHING: &str = " ";

/// Whether the results hold formulas or values alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Tables {
    /// Formulas with their values, up to [`MOST`] intervals.
    #[default]
    Live,
    /// Values.
    Values,
}

/// The tables of a workbook whose cells refer to one another.
#[derive(Clone, Copy, Debug)]
pub struct LiveTables<'a> {
    placed: &'a [Placed<'a>],
    on: bool,
}

impl<'a> LiveTables<'a> {
    /// The tables, live where that is wanted and none has more than [`MOST`] intervals.
    #[must_use]
    pub fn new(placed: &'a [Placed<'a>], tables: Tables) -> Self {
        let long = placed.iter().any(|one| intervals(one.table).is_some_and(|count| count > MOST));
        Self { placed, on: tables == Tables::Live && !long }
    }

    /// True where formulas are written.
    #[must_use]
    pub const fn on(&self) -> bool {
        self.on
    }

    /// How many rows of a table are prepared: those that are filled, and where they follow an input, more.
    #[must_use]
    pub fn rows(&self, table: &Table) -> usize {
        match (table.index, intervals(table)) {
            (Index::Intervals { times, more, .. }, Some(count)) if self.on => {
                times * PREPARED.max(2 * count).clamp(count, MOST) + more + 1
            }
            _ => table.rows(),
        }
    }

    /// The formula of a cell of a column, on a row from 0 of the sheet; `None` where there is none.
    ///
    /// # Errors
    /// For a reference to what is not there: a fault in rodete.
    pub fn cell(&self, table: &Table, live: Option<&Live>, row: RowNum) -> Result<Option<String>, WriteError> {
        let at = usize::try_from(row.saturating_sub(FIRST)).unwrap_or_default();
        let Some(formula) = live.filter(|_| self.on).and_then(|live| live.get(at)).filter(|one| !one.is_empty()) else {
            return Ok(None);
        };
        let formula = self.resolved(Some((table, row)), formula)?;
        Ok(Some(match table.index {
            Index::Intervals { .. } => format!("=IF($A{0}=\"\",\"\",{formula})", row + 1),
            _ => format!("={formula}"),
        }))
    }

    /// The formula of the point index on a row from 0; `None` where the rows do not follow an input.
    #[must_use]
    pub fn index(&self, table: &Table, row: RowNum) -> Option<String> {
        let last = last(table.index)?;
        let first = FIRST + 1;
        let passed = format!("ROWS($A${first}:$A{})-1", row + 1);
        self.on.then(|| format!("=IF({passed}<={last},{passed},\"\")"))
    }

    /// What stands below the last row prepared: a warning as soon as the rows do not suffice.
    #[must_use]
    pub fn end(&self, table: &Table, told: &str) -> Option<String> {
        let last = last(table.index)?;
        let most = self.rows(table).saturating_sub(1);
        self.on.then(|| format!("=IF({last}>{most},\"{told}\",\"\")"))
    }

    /// A formula outside the tables: it may refer to whole columns and their ends.
    ///
    /// # Errors
    /// For a reference to what is not there: a fault in rodete.
    pub fn outside(&self, formula: &str) -> Result<Option<String>, WriteError> {
        if self.on { Ok(Some(format!("={}", self.resolved(None, formula)?))) } else { Ok(None) }
    }

    /// The formula with its references made cells.
    fn resolved(&self, here: Option<(&Table, RowNum)>, formula: &str) -> Result<String, WriteError> {
        let mut text = String::with_capacity(2 * formula.len());
        let mut rest = formula;
        while let Some((before, after)) = rest.split_once('[') {
            let lost = || WriteError::Reference(formula.to_owned());
            let (reference, after) = after.split_once(']').ok_or_else(lost)?;
            text.push_str(before);
            text.push_str(&self.reference(here, reference).ok_or_else(lost)?);
            rest = after;
        }
        text.push_str(rest);
        Ok(text)
    }

    fn reference(&self, here: Option<(&Table, RowNum)>, reference: &str) -> Option<String> {
        if reference == "i" {
            return here.map(|(_, row)| format!("$A{}", row + 1));
        }
        let (path, place) = reference.split_once(' ').unwrap_or((reference, ""));
        let (table, symbol, sheet) = match path.split_once('.') {
            Some((key, symbol)) => {
                let placed = self.placed.iter().find(|one| one.table.key == key)?;
                (placed.table, symbol, format!("{}!", quote_sheet_name(&placed.sheet)))
            }
            None => (here?.0, path, String::new()),
        };
        let at = table.columns.iter().position(|column| column.symbol.en == symbol)?;
        let column = column_number_to_name(u16::try_from(at + usize::from(table.index.counted())).ok()?);
        let first = FIRST + 1;
        let range = || {
            let last = usize::try_from(FIRST).ok()? + self.rows(table);
            Some(format!("{sheet}${column}${first}:${column}${last}"))
        };
        match place {
            "" => here.map(|(_, row)| format!("{sheet}${column}{}", row + 1)),
            "first" => Some(format!("{sheet}${column}${first}")),
            "above" => here.map(|(_, row)| format!("{sheet}${column}{row}")),
            "last" => Some(match last(table.index) {
                Some(last) => format!("INDEX({},{last}+1)", range()?),
                None => format!("{sheet}${column}${}", usize::try_from(FIRST).ok()? + table.rows()),
            }),
            "all" => range(),
            _ => None,
        }
    }
}

/// How many intervals the rows of a table follow; `None` where they follow none.
fn intervals(table: &Table) -> Option<usize> {
    match table.index {
        Index::Intervals { times, more, .. } => table.rows().checked_sub(more + 1)?.checked_div(times),
        _ => None,
    }
}

/// The last index of a table's rows, by the input that they follow.
#[must_use]
pub fn last(index: Index) -> Option<String> {
    let Index::Intervals { name, times, more } = index else { return None };
    let rows = if times == 1 { name.to_owned() } else { format!("{times}*{name}") };
    Some(if more == 0 { rows } else { format!("{rows}+{more}") })
}

/// A formula with a number as its stored result.
///
/// # Errors
/// For a number that is not finite.
pub fn number(formula: &str, value: f64, place: impl FnOnce() -> String) -> Result<Formula, WriteError> {
    if value.is_finite() {
        // The shortest text that reads back bit for bit.
        Ok(Formula::new(formula).set_result(value.to_string()))
    } else {
        Err(WriteError::NotFinite { place: place() })
    }
}

/// A formula with a text as its stored result. A text that reads as a number would be stored as one: there is none here.
#[must_use]
pub fn text(formula: &str, value: &str) -> Formula {
    debug_assert!(value.parse::<f64>().is_err(), "{value} would be stored as a number");
    Formula::new(formula).set_result(if value.is_empty() { NOTHING } else { value })
}
