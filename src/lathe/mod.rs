//! The lathe: a turning program watched as it removes material.
//!
//! # References
//! The lathe simulator's machine, stock, tools and cycles; what it leaves open is derived here and says so.

pub mod cases;
pub mod figures;
pub mod parameters;
pub mod text;
