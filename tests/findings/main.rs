//! Bad inputs, each with the exit code, the place, the message and the remedy.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

mod bad_workbooks;
mod choices;
mod commanded;
#[path = "../common/mod.rs"]
mod common;
mod earlier_schema;
mod given;
mod handed;
mod lathe_inputs;
mod made;
mod reference;
mod refusals;
mod rules;
mod slips;
mod title_block;
mod told;

use common::workbook;
