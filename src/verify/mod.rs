//! Judging programs: closure, travel, size.

pub mod closure;
pub mod travel;
