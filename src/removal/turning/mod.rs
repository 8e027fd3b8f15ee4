//! Turning: the simulation of a program as it removes material.
//!
//! The part is a body of revolution at every moment, so one plane region describes it: its half section in (z, r).
//! A motion removes exactly what the cutter's outline sweeps: for a straight motion of a convex outline, the hull of its
//! first and last place; for an arc, that of its chords. See [`crate::geometry::exact`] for why passes do not
//! drift and their order does not matter.
//!
//! # References
//! The lathe simulator's machine, stock, tools and cycles. Where it leaves something open, the code says so, under "Derivation" or as
//! our choice.

pub mod alarm;
mod boring;
mod change;
pub mod contact;
pub mod detached;
pub mod deviation;
mod engagement;
pub mod in_force;
pub mod machine;
pub mod mesh;
mod motion_totals;
mod once;
pub mod outline;
pub mod path;
mod retraction;
pub mod rules;
pub mod second_removal;
pub mod simulation;
pub mod spindle;
mod start;
pub mod step;
pub mod stock;
mod surface_origin;
pub mod thread_groove;
mod threads;
pub mod tool;
pub mod turret;
pub mod workpiece;
