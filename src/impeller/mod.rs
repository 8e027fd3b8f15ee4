//! The impeller: blades along Villarceau circles of a torus, milled on five axes.

pub mod parameters;
