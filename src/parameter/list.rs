//! Sheets that hold a list: one row for each tool, block or point.
//!
//! As with the parameters of a form, sheet, validation, refusals and documentation follow from one table of columns.

use std::collections::BTreeMap;

use crate::finding::CellPlace;
use crate::parameter::field::{Field, Stated, Typed};
use crate::parameter::{Cell, Parameter, Value};
use crate::text::Text;

/// What a list's sheets are called.
#[derive(Debug)]
pub enum Naming {
    /// One sheet of this name.
    One(Text),
    /// Any number of sheets, each called `O` and a number of one to four digits: subprograms. The text says so.
    Numbered(Text),
}

/// A list of a workbook kind.
#[derive(Debug)]
pub struct List {
    /// Unique in its form.
    pub key: &'static str,
    /// What its sheets are called.
    pub naming: Naming,
    /// The title in the first row.
    pub title: Text,
    /// How it is filled in.
    pub note: Text,
    /// It holds a program that the engineer has written; not one that another calls.
    pub is_program: bool,
    /// The sheet may be missing, or present without rows, which means the same.
    pub optional: bool,
    /// The columns, at most 24; keys as `tools/R`. The first one's heading finds the row of headings. A column that is
    /// required must be filled in every row that holds something.
    pub columns: &'static [&'static Parameter],
    /// The widths of the columns in characters.
    pub widths: &'static [f64],
    /// Most rows.
    pub most: usize,
}

/// One row: the values by the keys of their columns, and all cells of the row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// The values; an empty cell has none.
    pub values: BTreeMap<&'static str, Value>,
    /// The cells of the columns that the sheet has.
    pub cells: BTreeMap<&'static str, CellPlace>,
}

impl Row {
    /// A row with these cells and without places in a workbook; of two of one column the later counts.
    #[must_use]
    pub fn of(cells: impl IntoIterator<Item = Cell>) -> Self {
        Self { values: cells.into_iter().collect(), cells: BTreeMap::new() }
    }

    /// Puts a value into the cell of a column.
    pub fn put<T: Stated, P>(&mut self, field: &Field<T, P>, value: T) {
        self.values.insert(field.row.key, value.stated());
    }

    /// The value of a column before it is proved to be there; `None` where it is not, or of another type.
    #[must_use]
    pub fn found<T: Typed, P>(&self, field: &Field<T, P>) -> Option<T> {
        self.values.get(field.row.key).and_then(T::typed)
    }

    /// The cell of a column, as the place of a finding; none where the sheet has no such column.
    #[must_use]
    pub fn cell(&self, key: &str) -> Vec<CellPlace> {
        self.cells.get(key).cloned().into_iter().collect()
    }
}

/// The rows of one sheet of a list.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// The list's key.
    pub list: &'static str,
    /// The sheet's name as it stands in the workbook; empty for the one sheet of a list in a new workbook.
    pub sheet: String,
    /// The rows that hold something, in order.
    pub rows: Vec<Row>,
}
