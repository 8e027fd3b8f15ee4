//! The branch pipe cut to fit a header at any angle, concentric or eccentric.
//!
//! The template is equation 9 of the published source (see [`crate::geometry::pipe_pair`]) on a development of a chosen
//! radius; the cut runs half the kerf beside it on the side of the waste, as arcs through triples on a flat sheet or as
//! short straight moves on the turning pipe.
//!
//! # Which side
//! The template is wrapped round the branch with its printed face outwards, its y towards the header. For someone who sees
//! the branch lean to the right (θ < 90°), an e > 0 has the branch's axis pass in front of the header's. On the turning pipe
//! A counts how the torch goes round it by the right hand about +X, as ISO 841 has it, and X grows towards the header: that
//! is the same side.
//!
//! # References
//! Martínez, Ledesma, Vega: "Creación de códigos G para las trayectorias de corte de tuberías con plasma", Universidad de
//! Guanajuato; equations 1 to 19, tables 1 and 2, figure 15. Slips of the source are named where they matter.

pub mod arcs;
pub mod bounds;
pub mod cases;
pub mod contradictions;
pub mod cut;
pub mod design;
pub mod figures;
pub mod outline;
pub mod parameters;
pub mod program;
pub mod tables;
