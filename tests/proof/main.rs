//! The judges.

#[path = "../common/mod.rs"]
mod common;
mod verification;
