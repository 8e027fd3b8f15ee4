//! The viewer: one HTML file that shows what programs do.
//!
//! The input is a [`Scene`](crate::scene::Scene): the part as triangles, the programs with their lines, motions and modes, and for
//! turning the metal after each cut. The output is one file ([`write()`]) that opens in any browser without a network: it contains its
//! style and scripts, and its numbers as base64. The same scene gives the same bytes.
//!
//! # Units
//! Millimetres, degrees and seconds. A turned part has its axis along Z; X of a turning program is a radius.

mod page;

pub use page::{html, write, write_live};
