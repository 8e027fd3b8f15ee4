//! The commands as whole processes, the store, and the house.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

mod cli;
#[path = "../common/every_kind.rs"]
mod every_kind;
mod house;
mod store;
