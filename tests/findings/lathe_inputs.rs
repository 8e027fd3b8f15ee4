//! What a lathe is given that it must refuse or judge, each with exit code, place, message and remedy, and what it must make of
//! a second set-up and of subprograms.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used, missing_docs)]

use crate::common::workbook;

mod bench;
mod command;
mod cycles;
mod figures;
mod hostile;
mod judged;
mod lost;
mod messages;
mod parted;
mod programs;
mod rules;
mod second;
mod second_marks;
mod sheets;
mod shop;
mod subprograms;
mod turret;
mod view;
