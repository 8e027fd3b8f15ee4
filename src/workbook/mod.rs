//! Workbooks: reading a filled-in form, writing forms and results.
//!
//! Reading an input workbook: from a path to checked values, or to a refusal that lists everything found.
//!
//! [`open`] is the only place that opens a path for reading; [`mod@gate`] walks the package under caps and refuses what is
//! damaged, hostile or not an `.xlsx`; the cells of the form's sheets are then streamed, and [`schema`] turns them into
//! [`Values`](crate::parameter::Values).
//!
//! # Limits
//! See [`limits`]. Whatever the bytes are, reading ends in bounded time and memory.

pub mod address;
mod book;
mod calculated;
mod calendar;
pub mod cell;
mod chart_sheet;
pub mod charts;
pub mod checks_sheet;
pub mod comparison_book;
mod curves;
pub mod drawn;
pub mod error;
pub mod form_sheet;
mod formula;
pub mod gate;
pub mod guard;
pub mod limits;
mod list_rows;
pub mod list_sheet;
pub mod listing;
pub mod live;
mod live_form;
mod live_ranges;
pub mod long_rows;
pub mod names;
pub mod offsets_sheet;
pub mod offsets_table;
mod open;
pub mod package;
pub mod page;
mod passed_over;
mod placed;
pub mod program_sheet;
mod raw_value;
pub mod results;
pub mod rules;
pub mod save;
pub mod schema;
mod shared_tables;
mod sheet_cells;
mod sheet_names;
mod spoken;
pub mod stamp;
pub mod style;
mod summary_sheet;
mod survey;
pub mod sweep_book;
mod sweep_charts;
mod sweep_effects;
pub mod sweep_sheet;
pub mod table_sheet;
pub mod template;
mod typed_number;
mod unit;
pub mod validation;
mod value;
mod verified;
mod words;
pub mod xml;

pub use gate::gate;
pub use open::{Input, open, open_as, open_program, unopened};
pub use schema::{Filled, read};
pub use spoken::language;
