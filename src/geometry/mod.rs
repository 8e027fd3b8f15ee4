//! Geometry: the torus, its Villarceau circles, the Darboux frame along them, plane polylines and circles, two pipes that
//! meet, regions of a plane and what they come to when turned about an axis, and views of solids.

pub mod chords;
pub mod circle;
pub mod darboux;
pub mod exact;
mod pipe_jets;
pub mod pipe_pair;
pub mod pipe_wall;
pub mod polyline;
pub mod revolution;
pub mod scene;
pub mod torus;
pub mod villarceau;
