//! Nose radius compensation: tables by hand, properties of random contours, LinuxCNC's interpreter as a judge, and programs.

mod common;
#[path = "nose/contour.rs"]
mod contour;
#[path = "nose/judged.rs"]
mod judged;
#[path = "nose/programs.rs"]
mod programs;
#[path = "nose/properties.rs"]
mod properties;
#[path = "nose/refused.rs"]
mod refused;
#[path = "nose/tables.rs"]
mod tables;
