//! `rodete`: from a workbook of design parameters to checked tables, ISO programs and a report.

pub mod blank;
pub mod cli;
pub mod escape;
pub mod figure;
pub mod finding;
pub mod gcode;
pub mod geometry;
pub mod impeller;
pub mod job;
pub mod machine;
pub mod number;
pub mod parameter;
pub mod report;
pub mod store;
pub mod table;
pub mod text;
pub mod verify;
pub mod workbook;
