//! Turning: cycles, nose, metal, alarms.

#[path = "../common/mod.rs"]
mod common;
mod fagor_cycles;
mod lathe;
mod nose;
mod removal;
mod turning;
mod turning_cycles;
