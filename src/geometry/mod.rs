//! Geometry: the torus, its Villarceau circles, the Darboux frame along them, plane polylines.

pub mod darboux;
pub mod polyline;
pub mod torus;
pub mod villarceau;
