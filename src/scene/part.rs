//! A part with what cuts it.

use crate::machine::chain::Chain;
use crate::scene::mesh::Mesh;
use crate::scene::{Curve, ShownTool};

/// A part with what cuts it.
#[derive(Clone, Debug)]
pub struct Part {
    /// Its bodies.
    pub meshes: Vec<Mesh>,
    /// Lines on it.
    pub curves: Vec<Curve>,
    /// The tools.
    pub tools: Vec<ShownTool>,
    /// How the axes bring the tool to it.
    pub frame: Chain,
}
