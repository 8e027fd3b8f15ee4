//! Sweeps: plans, rows, and the command in whole processes.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]
#![allow(clippy::unwrap_used, clippy::panic)]

mod command;
#[path = "../common/mod.rs"]
mod common;
mod faults;
mod interrupted;
mod measures;
mod plans;
mod readers;
mod report;
mod sensitivity;
mod submitted;
mod whole;
