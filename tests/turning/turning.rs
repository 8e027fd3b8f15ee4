//! Fanuc's lathe system A: every code and cycle against positions derived by hand, against LinuxCNC where it understands the
//! expanded motions, and programs that must be refused.

use crate::common;

mod axes;
mod contours;
mod corners;
mod cycles;
mod judged;
mod lines;
mod linuxcnc;
mod linuxcnc_holes;
mod linuxcnc_nose;
mod linuxcnc_roughing;
mod linuxcnc_threads;
mod machine;
mod passes;
mod point;
mod soup;
mod subprograms;
mod times;
