//! The lathe: a turning program watched as it removes material.
//!
//! The part is taken as a body of revolution at every moment, so that it is one plane region: its half section in (z, r).
//! What a motion takes away is exactly what the cutter's outline sweeps: for a straight motion of a convex outline the
//! hull of its first and last place, for an arc that of its chords. See [`crate::geometry::exact`] for why passes do not
//! drift and their order does not matter.
//!
//! # References
//! The lathe simulator's machine, stock, tools and cycles; what it leaves open is derived here and says so.

pub mod alarm;
mod boring;
pub mod cases;
pub mod catalogue;
mod chain;
mod change;
pub mod contact;
mod cover;
pub mod deviation;
pub mod figures;
pub mod in_force;
pub mod loose;
pub mod machine;
pub mod mesh;
pub mod outline;
pub mod parameters;
pub mod path;
pub mod repeat;
pub mod rules;
pub mod setup;
pub mod simulation;
pub mod spindle;
mod start;
pub mod step;
pub mod stock;
mod tally;
pub mod text;
pub mod tool;
pub mod tool_sheet;
pub mod turret;
mod watch;
pub mod workpiece;
