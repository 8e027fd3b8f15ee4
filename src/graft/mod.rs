//! Sheets of `rodete` in an engineer's own workbook.
//!
//! What comes in: the bytes of a workbook ([`Host`]) and the bytes of one that `rodete` wrote ([`Donor`]). What comes out: the bytes
//! of the workbook with some of the donor's sheets in it, or a refusal. All other parts keep their bytes: sheets, charts, macros,
//! pivots, images, protection. Four parts are edited at places, not written anew: the workbook part, its relationships, the content
//! types and the formats of cells. The order of calculation is left out: a spreadsheet makes it again.
//!
//! A sheet that was put in is known by a hidden name, `rodete_sheet_…`, which follows renaming and moving, and by what its
//! first cell says. The next time it is replaced where it stands. None is ever removed: formulas may lead to it.
//!
//! # Refused
//! Signed, locked, shared and strict workbooks, templates, custom views, see [`rules`]; what the
//! [gate](mod@crate::workbook::gate) refuses, too.
//!
//! # References
//! ECMA-376 part 1, 12 and 18 (SpreadsheetML), part 2 (packages).

mod book;
mod donor;
mod expected;
mod host;
mod marks;
mod parts;
mod put;
pub mod rules;
mod sheet;
mod styles;
mod tree;

pub use donor::Donor;
pub use host::{Host, made_from};
