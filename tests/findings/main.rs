//! Bad inputs, each with the exit code, the place, the message and the remedy.

mod bad_workbooks;
#[path = "../common/mod.rs"]
mod common;
mod earlier_schema;
mod lathe_inputs;
mod refusals;
mod rules;
