//! The machine: its axes, rotary axes B and C with their pivot length, axis travel, rapid rates, calibration of the B axis,
//! work offsets and the file in which LinuxCNC keeps them.

pub mod axis;
pub mod calibration;
pub mod chain;
pub mod length_unit;
pub mod offset_edit;
pub mod offset_parameters;
pub mod rapids;
pub mod rotary;
pub mod rules;
pub mod tip_way;
pub mod torch;
pub mod travel;
pub mod var_file;
pub mod work_offset;
