//! The viewer: one HTML file that shows what programs do.
//!
//! A [`Scene`](crate::scene::Scene) goes in: the part as triangles, the programs with their lines, motions and what is in force, for turning the
//! metal as it is cut away. Out comes one file ([`write()`]) that opens in any browser without a network: its style and
//! scripts are in it, its numbers as base64. The same scene gives the same bytes.
//!
//! # Units
//! Millimetres, degrees and seconds. A turned part has its axis along Z; X of a turning program is held as a radius.

mod page;

pub use page::{html, write};
