//! The judges.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

#[path = "../common/mod.rs"]
mod common;
mod verification;
