//! A sheet's part, looked at as it is written: where each cell stands and what it is said to hold.
//!
//! calamine gives a cell's value and hides how it came about: a text in a number cell, a formula never calculated, a
//! cell given twice, an address outside the grid. This walk sees them, and nothing it finds unsound reaches calamine.

use std::collections::BTreeSet;

use quick_xml::events::{BytesStart, Event};

use crate::escape::excerpt;
use crate::finding::{CellPlace, Exit, Finding, Place, Raise, Refusal};
use crate::limits::{EXCERPT, SHEET_FINDINGS};

use super::address::{self, Position, Range};
use super::limits;
use super::raw_value;
use super::rules::cell::*;
use super::xml::{self, damaged, raw};

/// Columns A to E: all that is read of a form's sheet.
pub const COLUMNS: u32 = 5;
/// The most columns that are read of any sheet, from A on: the bits of one mark.
const MARKS: u32 = u64::BITS;
/// Cells beyond this row or column, and beyond the columns that are read, are so far out that they are mentioned.
const FAR: Position = (10_000, 26);

/// What the walk over a sheet's part saw.
#[derive(Debug, Default)]
pub struct Survey {
    /// What is wrong with cells.
    pub findings: Vec<Finding>,
    /// Cells that a finding is about already.
    pub judged: BTreeSet<Position>,
    /// Cells with a formula and no value stored with it.
    pub uncalculated: BTreeSet<Position>,
    /// Cells with a formula and the value that was stored with it.
    pub formulas: BTreeSet<Position>,
    /// Merged cells that reach into the columns that are read.
    pub merges: Vec<Range>,
    /// True where calamine must not read the sheet.
    pub unsound: bool,
    /// True where the package is damaged and not only a value wrong.
    pub damaged: bool,
    /// The first cell beyond the columns that are read that holds something.
    pub beyond: Option<Position>,
    /// True where at least one cell holds something.
    pub filled: bool,
}

impl Survey {
    /// The exit code of a refusal of this sheet.
    #[must_use]
    pub const fn exit(&self) -> Exit {
        if self.damaged { Exit::Unreadable } else { Exit::Refused }
    }

    /// The merged cells that cover a cell without it being their corner.
    #[must_use]
    pub fn covering(&self, position: Position) -> Option<&Range> {
        self.merges.iter().find(|range| range.start != position && range.holds(position))
    }
}

/// Walks a sheet's part, of which so many columns are read, from A on.
///
/// # Errors
/// [`Exit::Unreadable`](crate::finding::Exit::Unreadable) where the part is no sound XML or no sheet; faults of single cells are
/// listed in the survey instead.
pub fn survey(sheet: &str, part: &str, text: &str, strings: usize, columns: u32) -> Result<Survey, Refusal> {
    let mut walk = Walk { sheet, part, strings, columns: columns.min(MARKS), ..Walk::default() };
    xml::walk(part, text, |depth, event| {
        walk.visit(depth, event)?;
        if walk.survey.findings.len() < SHEET_FINDINGS {
            return Ok(());
        }
        // Nothing is gained by reading on.
        Err(Refusal { exit: walk.survey.exit(), findings: std::mem::take(&mut walk.survey.findings) })
    })?;
    if let Some(first) = walk.far {
        let finding = CellsFarOut { cell: address::format(first) }.at(walk.place(first));
        walk.survey.findings.push(finding);
    }
    Ok(walk.survey)
}

/// A cell while its element is open.
#[derive(Default)]
struct Open {
    position: Position,
    kind: Option<String>,
    formula: bool,
    /// The value's raw text, as far as one unbroken text gives it.
    value: Option<String>,
    inline: bool,
    /// Written in a way that calamine reads differently from what stands there.
    twisted: bool,
}

#[derive(Default)]
struct Walk<'s> {
    sheet: &'s str,
    part: &'s str,
    strings: usize,
    columns: u32,
    survey: Survey,
    state: State,
    row: u32,
    column: u32,
    cell: Open,
    /// One bit for each column that is read, by row.
    seen: Vec<u64>,
    far: Option<Position>,
}

#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum State {
    /// Before the cells.
    #[default]
    Before,
    /// Among the rows; the element of all cells has depth 2.
    Rows,
    /// In a row.
    Row,
    /// In a cell.
    Cell,
    /// In a cell's value.
    Value,
    /// In another part of a cell: formula, inline text.
    Inside,
    /// After the cells.
    After,
}

impl Walk<'_> {
    fn visit(&mut self, depth: usize, event: &Event<'_>) -> Result<(), Refusal> {
        match event {
            Event::Start(start) => self.start(depth, start),
            Event::End(_) => {
                self.end(depth);
                Ok(())
            }
            Event::Text(text) if self.state == State::Value => {
                let kept: String = text.chars().take(401).collect();
                self.cell.value.get_or_insert_default().push_str(&kept);
                Ok(())
            }
            // calamine takes the first text of a value alone: 1&#50; would be 1.
            Event::CData(_) | Event::GeneralRef(_) | Event::Comment(_) | Event::PI(_) if self.state == State::Value => {
                let whole = matches!(self.cell.kind.as_deref(), Some("str" | "d")) && !matches!(event, Event::CData(_));
                self.cell.twisted |= !whole;
                if self.cell.value.as_ref().is_none_or(String::is_empty) {
                    self.cell.value = Some("?".to_owned());
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn start(&mut self, depth: usize, start: &BytesStart<'_>) -> Result<(), Refusal> {
        let name = start.local_name();
        let name = name.as_ref();
        match (self.state, name) {
            (State::Before, "dimension") if raw(start, "ref").is_none_or(|range| Range::parse(&range).is_none()) => {
                return Err(damaged(self.part, &DimensionNotValid { sheet: self.name() }));
            }
            (State::Before, "sheetData") if depth == 2 => self.state = State::Rows,
            (State::Rows, "row") => {
                if let Some(number) = raw(start, "r") {
                    match address::row(&number) {
                        Some(row) => self.row = row,
                        None => self.outside(&number),
                    }
                }
                self.state = State::Row;
            }
            (State::Row, "c") => {
                self.open(start);
                self.state = State::Cell;
            }
            (State::Cell, "v") => {
                self.cell.twisted |= self.cell.value.is_some();
                self.cell.value = Some(String::new());
                self.state = State::Value;
            }
            (State::Cell, "f") => {
                // calamine forgets a value that stands before its formula.
                self.cell.twisted |= self.cell.value.is_some() || self.cell.inline;
                self.cell.formula = true;
                self.state = State::Inside;
            }
            (State::Cell, "is") => {
                self.cell.twisted |= self.cell.inline;
                self.cell.inline = true;
                self.state = State::Inside;
            }
            (State::Rows | State::Row | State::Cell | State::Value, _) => {
                let element = excerpt(name, EXCERPT);
                return Err(damaged(self.part, &ForeignElement { sheet: self.name(), element }));
            }
            (_, "sheetData") => {
                return Err(damaged(self.part, &CellsGivenTwice { sheet: self.name() }));
            }
            (State::After, "mergeCell") => self.merge(start)?,
            _ => {}
        }
        Ok(())
    }

    fn end(&mut self, depth: usize) {
        self.state = match (self.state, depth) {
            (State::Rows, 2) => State::After,
            (State::Row, 3) => {
                self.row = self.row.saturating_add(1);
                self.column = 0;
                State::Rows
            }
            (State::Cell, 4) => {
                self.close();
                self.column = self.column.saturating_add(1);
                State::Row
            }
            (State::Value | State::Inside, 5) => State::Cell,
            (state, _) => state,
        };
    }

    fn open(&mut self, start: &BytesStart<'_>) {
        self.cell = Open { kind: raw(start, "t").map(std::borrow::Cow::into_owned), ..Open::default() };
        let mut position = (self.row, self.column);
        if let Some(written) = raw(start, "r") {
            match address::parse(&written) {
                Some(given) => position = given,
                None => self.outside(&written),
            }
        }
        self.column = position.1;
        self.cell.position = position;
        if position.0 >= limits::GRID_ROWS || position.1 >= limits::GRID_COLUMNS {
            self.outside(&address::format(position));
        }
        if position.0 != self.row {
            let row = u64::from(self.row) + 1;
            self.fault(position, false, &CellInOtherRow { cell: address::format(position), row });
        }
        self.mark();
    }

    /// Refuses a cell that is read and given twice.
    fn mark(&mut self) {
        let (row, column) = self.cell.position;
        let Ok(index) = usize::try_from(row) else { return };
        if column >= self.columns || row >= limits::GRID_ROWS {
            return;
        }
        if self.seen.len() <= index {
            self.seen.resize(index + 1, 0);
        }
        let bit = 1_u64 << column;
        if let Some(bits) = self.seen.get_mut(index) {
            let twice = *bits & bit != 0;
            *bits |= bit;
            if twice {
                let position = self.cell.position;
                self.fault(position, false, &CellGivenTwice { cell: address::format(position) });
            }
        }
    }

    /// Judges a cell when all of it is known.
    fn close(&mut self) {
        let cell = std::mem::take(&mut self.cell);
        let position = cell.position;
        let value = cell.value.as_deref().unwrap_or_default();
        if cell.twisted {
            self.survey.damaged = true;
            return self.fault(position, true, &CellNotSafelyRead { cell: address::format(position) });
        }
        let filled = !value.is_empty() || cell.inline || cell.formula;
        self.survey.filled |= filled;
        if filled && (position.0 >= FAR.0 || position.1 >= FAR.1.max(self.columns)) && self.far.is_none() {
            self.far = Some(position);
        }
        let near = position.1 < self.columns;
        if filled && !near {
            self.survey.beyond.get_or_insert(position);
        }
        let kind = cell.kind.as_deref();
        if near && cell.formula && value.is_empty() && !cell.inline && !(kind == Some("str") && cell.value.is_some()) {
            self.survey.uncalculated.insert(position);
        } else if near && cell.formula {
            self.survey.formulas.insert(position);
        }
        if let Some(fault) = raw_value::judge(kind, value, self.strings, || address::format(position))
            && (near || fault.unsound)
        {
            self.survey.damaged |= fault.damaged;
            self.fault(position, fault.unsound, &*fault.row);
        }
    }

    fn merge(&mut self, start: &BytesStart<'_>) -> Result<(), Refusal> {
        let range = raw(start, "ref")
            .and_then(|range| Range::parse(&range))
            .ok_or_else(|| damaged(self.part, &MergedRangeNotValid { sheet: self.name() }))?;
        if range.start.1 < self.columns {
            self.survey.merges.push(range);
        }
        Ok(())
    }

    fn place(&self, position: Position) -> Place {
        Place::Cells(vec![CellPlace { sheet: self.sheet.to_owned(), cell: address::format(position) }])
    }

    /// A fault of a cell.
    fn fault(&mut self, position: Position, unsound: bool, row: &dyn Raise) {
        self.survey.unsound |= unsound;
        self.survey.judged.insert(position);
        let finding = row.at(self.place(position));
        self.survey.findings.push(finding);
    }

    /// A cell or row whose address lies outside of the grid.
    fn outside(&mut self, written: &str) {
        let address = excerpt(written, EXCERPT);
        self.survey.unsound = true;
        self.survey.findings.push(CellOutsideGrid { address }.at(Place::Sheet(self.sheet.to_owned())));
    }

    /// The sheet's name as a message says it.
    fn name(&self) -> String {
        excerpt(self.sheet, 80)
    }
}
