//! Turning: tools, the blank and the machine about it, and what a program's motions make of the blank.
//!
//! The part is taken as a body of revolution at every moment, so that it is one plane region: its half section in (z, r).
//! What a motion takes away is exactly what the cutter's outline sweeps: for a straight motion of a convex outline the
//! hull of its first and last place, for an arc that of its chords. See [`crate::geometry::exact`] for why passes do not
//! drift and their order does not matter.

pub mod machine;
pub mod outline;
pub mod stock;
pub mod tool;
pub mod turret;
pub mod workpiece;
