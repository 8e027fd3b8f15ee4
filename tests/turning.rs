//! Fanuc's lathe system A: every code and cycle against positions derived by hand, against LinuxCNC where it understands the
//! expanded motions, and programs that must be refused.

mod common;
#[path = "turning/contours.rs"]
mod contours;
#[path = "turning/corners.rs"]
mod corners;
#[path = "turning/corpus.rs"]
mod corpus;
#[path = "turning/cycles.rs"]
mod cycles;
#[path = "turning/judged.rs"]
mod judged;
#[path = "turning/lines.rs"]
mod lines;
#[path = "turning/linuxcnc.rs"]
mod linuxcnc;
#[path = "turning/linuxcnc_holes.rs"]
mod linuxcnc_holes;
#[path = "turning/linuxcnc_nose.rs"]
mod linuxcnc_nose;
#[path = "turning/linuxcnc_roughing.rs"]
mod linuxcnc_roughing;
#[path = "turning/linuxcnc_threads.rs"]
mod linuxcnc_threads;
#[path = "turning/machine.rs"]
mod machine;
#[path = "turning/passes.rs"]
mod passes;
#[path = "turning/point.rs"]
mod point;
#[path = "turning/soup.rs"]
mod soup;
#[path = "turning/subprograms.rs"]
mod subprograms;
#[path = "turning/times.rs"]
mod times;
