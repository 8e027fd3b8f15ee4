//! What a lathe is given that it must refuse or judge, each with exit code, place, message and remedy, and what it must make of
//! a second set-up and of subprograms.

#![allow(clippy::unwrap_used, clippy::panic, clippy::expect_used, missing_docs)]

#[path = "lathe_inputs/bench.rs"]
mod bench;
#[path = "lathe_inputs/command.rs"]
mod command;
#[path = "lathe_inputs/figures.rs"]
mod figures;
#[path = "lathe_inputs/hostile.rs"]
mod hostile;
#[path = "lathe_inputs/judged.rs"]
mod judged;
#[path = "lathe_inputs/lost.rs"]
mod lost;
#[path = "lathe_inputs/messages.rs"]
mod messages;
#[path = "lathe_inputs/parted.rs"]
mod parted;
#[path = "lathe_inputs/programs.rs"]
mod programs;
#[path = "lathe_inputs/rules.rs"]
mod rules;
#[path = "lathe_inputs/second.rs"]
mod second;
#[path = "lathe_inputs/second_marks.rs"]
mod second_marks;
#[path = "lathe_inputs/sheets.rs"]
mod sheets;
#[path = "lathe_inputs/shop.rs"]
mod shop;
#[path = "lathe_inputs/subprograms.rs"]
mod subprograms;
#[path = "lathe_inputs/turret.rs"]
mod turret;
#[path = "lathe_inputs/view.rs"]
mod view;
#[allow(dead_code, reason = "this corpus uses a part of it")]
#[path = "bad_workbooks/workbook.rs"]
mod workbook;
