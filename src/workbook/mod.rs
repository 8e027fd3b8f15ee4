//! Workbooks: reading a filled-in form, writing forms and results.

pub mod cell;
pub mod charts;
pub mod checks_sheet;
pub mod derived;
pub mod error;
pub mod form_sheet;
pub mod long_rows;
pub mod names;
pub mod page;
pub mod program_sheet;
pub mod results;
pub mod style;
pub mod table_sheet;
pub mod template;
pub mod validation;
