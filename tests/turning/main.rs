//! Turning: cycles, nose, metal, alarms.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

#[path = "../common/mod.rs"]
mod common;
mod fagor_cycles;
mod lathe;
mod nose;
mod removal;
mod threads;
mod turning;
mod turning_cycles;
