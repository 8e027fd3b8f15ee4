//! The ledger: a line for every output of the program, its name and the first 16 digits of its SHA-256, held in
//! `tests/golden/ledger.txt`. It is the proof that a restructuring changes nothing: a commit that means to change nothing
//! leaves the file alone, one that means to shows its lines and says why.
//!
//! # What is in it
//! - `motions`: motions, what is in force and the parameters left behind, of every program of the tests under every control;
//! - `verify`: what is refused and remarked in them and what they come to, in both languages; `view`: their scenes; `simulate`:
//!   turning programs over their stock, with every file;
//! - one area for each kind of `KINDS`: every case in both languages for every control that the kind can be
//!   written for: the new workbook and the results part by part, programs, drawings, solid, viewer, what typst is given to
//!   set (a stand-in keeps it), and the documents of `check`, `build`, `verify` and `simulate`;
//! - `refused`: every cell of every kind spoilt, contradictions, damaged packages; `offsets`; `help`.
//!
//! # What is not
//! What is set in type (`tests/workbook/report.rs`, `tests/workbook/drawing.rs`); the messages that `tests/findings/bad_workbooks`, `tests/findings/refusals.rs`,
//! `tests/findings/lathe_inputs`, `tests/turning/removal` and `tests/commands/cli` hold word for word beside the input: those are their own ledger. Three programs
//! that loop without end are read within a small budget only (`motions`). Of blocks without motion `view` says what they put into force.
//!
//! # How it holds still
//! The program is run as a black box in a folder of its own, without the machine's environment; only `motions`, which no
//! command prints with what is in force, asks the library, and writes every number out. A document is compared with its keys sorted,
//! without its version; of a finding only what is said today. Sums of files that stand in other files are replaced by the file's
//! name, so that one changed byte does not move every line.
//!
//! # How it is used
//! `cargo test --test ledger`, or one area with its name behind it. `RODETE_LEDGER=write` accepts what has changed,
//! `RODETE_LEDGER_TEXTS=FOLDER` writes each output into a folder as it is compared, so that two runs can be held against each
//! other with `diff -r`.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic)]

#[path = "ledger/books.rs"]
mod books;
#[path = "ledger/command.rs"]
mod command;
#[path = "ledger/golden.rs"]
mod golden;
#[path = "ledger/motions.rs"]
mod motions;
#[path = "ledger/package.rs"]
mod package;
#[path = "ledger/plain.rs"]
mod plain;
#[path = "ledger/programs.rs"]
mod programs;
#[path = "ledger/refused.rs"]
mod refused;

use golden::{differing, hold, well_formed};
use rodete::kinds::KINDS;

#[test]
fn every_line_has_its_place() {
    well_formed();
}

#[test]
fn books_of_every_kind() {
    books::every_exception_is_one();
    let differing: Vec<_> = KINDS.iter().filter_map(|kind| differing(kind.form().kind, books::of(*kind))).collect();
    assert!(differing.is_empty(), "{}", differing.concat());
}

#[test]
fn help() {
    hold("help", programs::help());
}

#[test]
fn motions_under_every_control() {
    hold("motions", motions::items());
}

#[test]
fn offsets() {
    hold("offsets", programs::offsets());
}

#[test]
fn refused_inputs() {
    hold("refused", refused::items());
}

#[test]
fn simulate() {
    hold("simulate", programs::simulate());
}

#[test]
fn verify() {
    hold("verify", programs::verify());
}

#[test]
fn view() {
    hold("view", programs::view());
}
