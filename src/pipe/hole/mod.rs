//! The bevelled hole in the header, and the height of the torch that cuts it.
//!
//! # References
//! Patent of Shandong University, published 2017: height control of a plasma torch cutting a header hole with a welding
//! groove. Its displayed formulas are lost; the height is derived in [`height`], the curve in [`station`].

pub mod bounds;
pub mod cases;
pub mod cut;
pub mod design;
pub mod figures;
pub mod height;
pub mod parameters;
pub mod program;
pub mod station;
pub mod tables;
