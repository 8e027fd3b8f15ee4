//! Pipes: their sizes as standards give them, what cuts a branch to fit a header, and the hole in the header.

mod form;
mod form_sketch;
pub mod hole;
pub mod insert;
pub mod rules;
pub mod scene;
pub mod size;
mod sketch;

use crate::kind::Proved;
use crate::proof::account::Account;

/// What the program of a pipe comes to.
fn account(programs: &[Proved]) -> Account {
    programs.last().map(|program| program.account.clone()).unwrap_or_default()
}
