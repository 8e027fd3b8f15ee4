//! Pipes: their sizes as standards give them, what cuts a branch to fit a header, and the hole in the header.

mod form;
pub mod hole;
pub mod insert;
pub mod rules;
pub mod scene;
pub mod size;
