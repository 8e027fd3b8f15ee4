//! The ledger: a line for everything that a machine reads, its name and the first 16 digits of its SHA-256, held in
//! `tests/golden/ledger.txt`. It is the proof that nothing moves by accident: a commit that means to change no motion leaves the
//! file alone, one that means to shows its lines and says why.
//!
//! # What is in it
//! - `motions`: motions, what is in force and the parameters left behind, of every program of the tests under every control.
//!   Three programs that loop without end are read within a small budget only;
//! - one area for each kind of `KINDS`: programs, drawings and solids of every case in both languages for every control that
//!   the kind can be written for.
//!
//! # How it holds still
//! The program is run as a black box in a folder of its own, without the machine's environment; only `motions`, which no
//! command prints with what is in force, asks the library, and writes every number out. Sums of files that stand in other files
//! are replaced by the file's name, so that one changed word of a form does not move every line.
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
fn motions_under_every_control() {
    hold("motions", motions::items());
}
