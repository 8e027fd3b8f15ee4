//! The viewer: one HTML file that shows what programs do.
//!
//! A [`Scene`] goes in: the part as triangles, the programs with their lines, motions and what is in force, for turning the
//! metal as it is cut away. Out comes one file ([`write()`]) that opens in any browser without a network: its style and
//! scripts are in it, its numbers as base64. The same scene gives the same bytes.
//!
//! # Units
//! Millimetres, degrees and seconds. A turned part has its axis along Z; X of a turning program is held as a radius.

mod column;
mod frame;
pub mod impeller;
mod kept;
pub mod lathe;
mod mesh;
mod page;
pub mod pipe;
mod program;
mod scene;
mod turning;

pub use frame::Chain;
pub use kept::{following, outcome};
pub use mesh::{Mesh, Paint};
pub use page::{html, write};
pub use program::{FEED, Program, RAPID};
pub use scene::{Curve, Remark, Scene, Shape, ShownTool, State};
pub use turning::{Contour, Fixture, ShownTurning};
