//! Geometry: the torus, its Villarceau circles, the Darboux frame along them, plane polylines and circles, two pipes that
//! meet, and views of solids.

pub mod circle;
pub mod darboux;
pub mod exact;
pub mod pipe_pair;
pub mod polyline;
pub mod scene;
pub mod torus;
pub mod villarceau;
