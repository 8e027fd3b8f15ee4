//! Nose radius compensation: tables by hand, properties of random contours, LinuxCNC's interpreter as a judge, and programs.

use crate::common;

mod contour;
mod judged;
mod programs;
mod properties;
mod refused;
mod tables;
