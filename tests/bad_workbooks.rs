//! The corpus of workbooks that must be refused, each with the exit code, the place, the message and the remedy
//! expected, and of odd ones that must be read. The rows carry the names of the list of bad inputs.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

#[path = "bad_workbooks/cells.rs"]
mod cells;
mod common;
#[path = "bad_workbooks/files.rs"]
mod files;
#[path = "bad_workbooks/paths.rs"]
mod paths;
#[path = "bad_workbooks/random.rs"]
mod random;
#[path = "bad_workbooks/sound.rs"]
mod sound;
#[path = "bad_workbooks/workbook.rs"]
mod workbook;
