//! What is written and read back: sheets, drawings, reports.

#[path = "../common/mod.rs"]
mod common;
mod drawing;
mod lathe_workbook;
mod libreoffice;
mod offsets_workbook;
mod report;
mod results_workbook;
mod workbooks;
