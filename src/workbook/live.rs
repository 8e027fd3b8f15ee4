//! Live cells: formulas over the inputs' defined names, with the values that the engine computed stored beside them.
//!
//! A column says its formula ([`Live`]); here the references in it become cells. The rows of a table that follows a count of
//! intervals are prepared beyond those that are filled, so that the count may grow: what is not reached shows nothing.

use rust_xlsxwriter::{Formula, RowNum, quote_sheet_name, utility::column_number_to_name};

use super::error::WriteError;
use super::placed::{FIRST, PlacedTable};
use crate::limits::LIVE_INTERVALS;
use crate::table::{Index, Live, Print, Table};
use crate::text::{Text, t};

/// At least so many intervals are prepared.
const PREPARED: usize = 100;

/// What stands in a cell with a text formula that shows nothing: an empty result would be stored as 0.
pub const NOTHING: &str = " ";

/// Whether the results hold formulas or values alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Tables {
    /// Formulas with their values, up to [`LIVE_INTERVALS`] intervals.
    #[default]
    Live,
    /// Values alone.
    Values,
}

/// The tables of a workbook whose cells refer to one another.
#[derive(Clone, Copy, Debug)]
pub struct LiveTables<'a> {
    placed: &'a [PlacedTable<'a>],
    liveness: Liveness,
}

/// Whether the tables of a workbook are live, and why not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Liveness {
    /// As formulas, with their values.
    Formulas,
    /// As values, because that was asked for.
    Asked,
    /// As values, because there are more than [`LIVE_INTERVALS`] intervals.
    Long,
}

impl Liveness {
    /// Whether these tables are live.
    #[must_use]
    pub fn of<'a>(mut all: impl Iterator<Item = &'a Table>, tables: Tables) -> Self {
        match tables {
            Tables::Values => Self::Asked,
            Tables::Live if all.any(|table| intervals(table).is_some_and(|count| count > LIVE_INTERVALS)) => Self::Long,
            Tables::Live => Self::Formulas,
        }
    }

    /// True for a table that has a sheet.
    #[must_use]
    pub fn has(self, table: &Table) -> bool {
        self == Self::Formulas || table.print != Print::Formulas
    }

    /// What is said of values, of a table that would have formulas.
    fn told(self) -> Text {
        match self {
            Self::Formulas => t("", ""),
            Self::Asked => t(
                "Valores (--values): no siguen a los datos; vuelva a generar",
                "Values (--values): they do not follow the inputs; build again",
            ),
            Self::Long => Text::new(
                format!("Valores (más de {LIVE_INTERVALS} intervalos): no siguen a los datos; vuelva a generar"),
                format!("Values (more than {LIVE_INTERVALS} intervals): they do not follow the inputs; build again"),
            ),
        }
    }
}

impl<'a> LiveTables<'a> {
    /// The tables that have a sheet, and whether they are live.
    #[must_use]
    pub const fn new(placed: &'a [PlacedTable<'a>], liveness: Liveness) -> Self {
        Self { placed, liveness }
    }

    /// True where formulas are written.
    #[must_use]
    pub fn on(&self) -> bool {
        self.liveness == Liveness::Formulas
    }

    /// What the source of a table says beside it: that values stand where formulas would.
    #[must_use]
    pub fn source(&self, table: &Table) -> Text {
        let live = table.columns.iter().any(|column| column.live.is_some());
        let told = if live { self.liveness.told() } else { t("", "") };
        let with = |source: &str, told: &str| match (source.is_empty(), told.is_empty()) {
            (_, true) => source.to_owned(),
            (true, false) => told.to_owned(),
            (false, false) => format!("{told} · {source}"),
        };
        Text::new(with(&table.source.es, &told.es), with(&table.source.en, &told.en))
    }

    /// What is said of all tables together; nothing while they follow the inputs, or none would.
    #[must_use]
    pub fn note(&self) -> Option<Text> {
        let live = self.placed.iter().any(|one| one.table.columns.iter().any(|column| column.live.is_some()));
        (live && !self.on()).then(|| self.liveness.told())
    }

    /// How many rows of a table are prepared: those that are filled, and where they follow an input, more.
    #[must_use]
    pub fn rows(&self, table: &Table) -> usize {
        let prepared = |count: usize| PREPARED.max(2 * count).clamp(count, LIVE_INTERVALS);
        match (table.index, intervals(table)) {
            (Index::Intervals { times, more, .. }, Some(count)) if self.on() => times * prepared(count) + more + 1,
            (Index::Within { intervals, .. }, _) if self.on() => prepared(intervals),
            _ => table.rows(),
        }
    }

    /// The formula of a cell of a column, on a row from 0 of the sheet; `None` where there is none.
    ///
    /// # Errors
    /// For a reference to what is not there: a fault in rodete.
    pub fn cell(&self, table: &Table, live: Option<&Live>, row: RowNum) -> Result<Option<String>, WriteError> {
        let at = usize::try_from(row.saturating_sub(FIRST)).unwrap_or_default();
        let Some(formula) = live.filter(|_| self.on()).and_then(|live| live.get(at)).filter(|one| !one.is_empty())
        else {
            return Ok(None);
        };
        let formula = self.resolved(Some((table, row)), formula)?;
        Ok(Some(match (table.index, self.asks(table)) {
            (Index::Intervals { .. }, _) => format!("=IF($A{0}=\"\",\"\",{formula})", row + 1),
            (_, Some(of)) => format!("=IF({},{formula},\"\")", self.reached(of)),
            (_, None) => format!("={formula}"),
        }))
    }

    /// The formula of the point index on a row from 0; `None` where the rows do not follow an input.
    #[must_use]
    pub fn index(&self, table: &Table, row: RowNum) -> Option<String> {
        let last = last(table.index)?;
        let first = FIRST + 1;
        let passed = format!("ROWS($A${first}:$A{})-1", row + 1);
        // Where columns are looked up, rows that are missing would be looked up, too.
        let counts = if looks_up(table) { self.reached(table) } else { counts(table.index).unwrap_or_default() };
        self.on().then(|| format!("=IF({counts},IF({passed}<={last},{passed},\"\"),\"\")"))
    }

    /// The table whose rows cells of a table look up: they show nothing where it has not the rows. The table itself, where its
    /// own rows follow an input.
    fn asks<'t>(&self, table: &'t Table) -> Option<&'t Table>
    where
        'a: 't,
    {
        if intervals(table).is_some() {
            return Some(table);
        }
        let of = |formula: &str| self.looked_up(formula).filter(|one| intervals(one).is_some());
        formulas(table).find_map(of)
    }

    /// The first table that a formula looks up by its whole columns, or their ends.
    fn looked_up(&self, formula: &str) -> Option<&'a Table> {
        formula.split('[').skip(1).find_map(|rest| {
            let (path, _) = rest.split_once(']')?.0.split_once(' ')?;
            let (key, _) = path.split_once('.')?;
            self.placed.iter().find(|one| one.table.key == key).map(|one| one.table)
        })
    }

    /// The formula that is true where an input is a count of intervals for which a table has rows.
    fn reached(&self, table: &Table) -> String {
        let Some(counts) = counts(table.index) else { return "TRUE".to_owned() };
        let rows = self.rows(table);
        let (name, most) = match table.index {
            Index::Intervals { name, times, more } => {
                (name, rows.saturating_sub(more + 1).checked_div(times).unwrap_or_default())
            }
            Index::Within { name, .. } => (name, rows),
            Index::Point | Index::None => return counts,
        };
        format!("IF({counts},N({name})<={most},FALSE)")
    }

    /// What stands below the last row prepared: a warning as soon as the rows do not suffice.
    #[must_use]
    pub fn end(&self, table: &Table, told: &str) -> Option<String> {
        let (counts, reached) = (counts(table.index)?, self.reached(table));
        self.on().then(|| format!("=IF({counts},IF({reached},\"\",\"{told}\"),\"\")"))
    }

    /// True, as a formula, where an input asks for more rows than there were when the sheet was written; `None` where the rows
    /// follow none.
    #[must_use]
    pub fn grown(&self, table: &Table) -> Option<String> {
        let (counts, rows) = (counts(table.index).filter(|_| self.on())?, table.rows());
        Some(match last(table.index) {
            Some(last) => format!("IF({counts},{last}>{},FALSE)", rows.saturating_sub(1)),
            None => {
                let (first, end) = (FIRST + 1, usize::try_from(FIRST).ok()? + self.rows(table));
                format!("COUNT($A${first}:$A${end})>{rows}")
            }
        })
    }

    /// A formula outside the tables: it may refer to whole columns and their ends. Where the rows of those are not there, it is
    /// `otherwise`.
    ///
    /// # Errors
    /// For a reference to what is not there: a fault in rodete.
    pub fn outside(&self, formula: &str, otherwise: &str) -> Result<Option<String>, WriteError> {
        if !self.on() {
            return Ok(None);
        }
        let resolved = self.resolved(None, formula)?;
        let asked = self.looked_up(formula).and_then(|table| self.asks(table));
        Ok(Some(match asked {
            Some(of) => format!("=IF({},{resolved},{otherwise})", self.reached(of)),
            None => format!("={resolved}"),
        }))
    }

    /// A formula over the rows of a table outside of it, which is `otherwise` where those are not there.
    ///
    /// # Errors
    /// As [`LiveTables::outside`].
    pub fn along(&self, table: &Table, formula: &str, otherwise: &str) -> Result<Option<String>, WriteError> {
        if !self.on() {
            return Ok(None);
        }
        Ok(Some(format!("=IF({},{},{otherwise})", self.reached(table), self.resolved(None, formula)?)))
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
        Index::Within { intervals, .. } => Some(intervals),
        Index::Point | Index::None => None,
    }
}

/// The formulas of a table.
fn formulas(table: &Table) -> impl Iterator<Item = &str> {
    let all = table.columns.iter().filter_map(|column| column.live.as_ref());
    all.flat_map(|live| match live {
        Live::Rows(one) => std::slice::from_ref(one),
        Live::Cells(each) => each,
    })
    .map(|one| &**one)
}

/// True for a table with cells that look up whole columns, or their ends.
fn looks_up(table: &Table) -> bool {
    formulas(table).any(|formula| formula.contains(" all]") || formula.contains(" last]"))
}

/// The formula that is true where the input that rows follow is a count: neither empty, nor a text, nor 0, nor a fraction.
fn counts(index: Index) -> Option<String> {
    let (Index::Intervals { name, .. } | Index::Within { name, .. }) = index else { return None };
    Some(format!("AND(N({name})>=1,N({name})=INT(N({name})))"))
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
