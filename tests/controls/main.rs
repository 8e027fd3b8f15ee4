//! Programs as each control takes them.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

#[path = "../common/mod.rs"]
mod common;
mod fagor;
mod linuxcnc;
mod lists;
mod page;
mod pipe_rollover;
mod points;
mod programs;
mod rotary_axes;
mod round_trip;
mod word_order;
