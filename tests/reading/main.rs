//! Programs, offsets and parameter files, read as the control would.

#[path = "../common/mod.rs"]
mod common;
mod interpreter;
mod offsets;
