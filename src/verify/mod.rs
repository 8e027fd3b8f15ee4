//! Judging programs: closure, travel, size.

pub mod account;
pub mod closure;
pub mod travel;
