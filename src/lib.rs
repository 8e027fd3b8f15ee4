//! `rodete`: from a workbook of design parameters to checked tables, ISO programs and a report.

pub mod figure;
pub mod finding;
pub mod gcode;
pub mod impeller;
pub mod job;
pub mod parameter;
pub mod report;
pub mod table;
pub mod text;
