//! The impeller: blades along Villarceau circles of a torus, milled on five axes.
//!
//! Each file holds one family of formulas; [`blade::Blade`] is the whole geometry of one blade, [`splitter::Splitter`]
//! that of the blade between two, [`tables`] shows both as the annexes set them and [`programs`] as ISO programs.

pub mod assembly;
pub mod blade;
pub mod blade_count;
pub mod cases;
pub mod clearance;
pub mod contradictions;
pub mod design;
pub mod discretisation;
pub mod fade;
pub mod figures;
pub mod floor_depth;
pub mod gap;
pub mod header;
pub mod ideal;
pub mod outside;
pub mod parameters;
pub mod part;
pub mod programs;
pub mod ribs;
pub mod room;
pub mod safety;
pub mod slips;
pub mod solids;
pub mod splitter;
pub mod sweep;
pub mod tables;
pub mod tip_way;
pub mod tool_path;
pub mod track;
pub mod undercut;
