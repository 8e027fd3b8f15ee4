//! `rodete`: from a workbook of design parameters to checked tables, ISO programs and a report.

pub mod finding;
pub mod impeller;
pub mod parameter;
pub mod table;
pub mod text;
