//! Where a table stands in a workbook.

use rust_xlsxwriter::RowNum;

use crate::table::Table;

/// The first row of a table's values, from 0.
pub const FIRST: RowNum = 4;

/// A table with the name of the sheet it stands on.
#[derive(Clone, Debug)]
pub struct PlacedTable<'a> {
    /// The sheet's name.
    pub sheet: String,
    /// The table that stands on it.
    pub table: &'a Table,
}
