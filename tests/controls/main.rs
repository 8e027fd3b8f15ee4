//! Programs as each control takes them.

#[path = "../common/mod.rs"]
mod common;
mod linuxcnc;
mod pipe_rollover;
mod rotary_axes;
