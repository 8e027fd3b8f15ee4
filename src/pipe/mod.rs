//! Pipes: their sizes as standards give them.

pub mod size;
