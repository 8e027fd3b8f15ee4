//! What is written and read back: sheets, drawings, reports.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

#[path = "../common/mod.rs"]
mod common;
mod drawing;
mod guard;
mod ironcalc;
mod lathe_workbook;
mod libreoffice;
mod live;
mod live_dates;
mod live_forms;
mod missing;
mod offsets_workbook;
mod report;
mod results_workbook;
mod stored;
mod workbooks;
