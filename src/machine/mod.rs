//! The machine: its axes, rotary axes B and C with their pivot length, axis travel, calibration of the B axis.

pub mod axis;
pub mod calibration;
pub mod rotary;
pub mod travel;
