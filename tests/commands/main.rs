//! The commands as whole processes, the store, and the house.

mod cli;
mod house;
mod store;
