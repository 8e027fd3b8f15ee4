//! Workbooks: reading a filled-in form, writing forms and results.

pub mod cell;
pub mod error;
pub mod form_sheet;
pub mod page;
pub mod style;
pub mod template;
pub mod validation;
