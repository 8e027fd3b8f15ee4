//! The blank: the torus turned before the blades are milled.

pub mod turning;
