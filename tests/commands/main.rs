//! The commands as whole processes, the store, and the house.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

mod cli;
mod house;
mod store;
