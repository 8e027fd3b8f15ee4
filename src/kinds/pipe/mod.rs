//! Pipes: their sizes as standards give them, what cuts a branch to fit a header, and the hole in the header.

mod form;
mod form_sketch;
pub mod hole;
pub mod insert;
mod live_form;
pub mod rules;
pub mod scene;
pub mod size;
mod sketch;

use crate::kind::Proved;
use crate::proof::account::Account;

/// The formula of a size that may be typed, or else comes from a standard's table by its nominal size, which no formula asks.
fn typed_or(name: &str, value: f64) -> String {
    format!("IF(ISNUMBER({name}),{name},{value})")
}

/// What the program of a pipe comes to.
fn account(programs: &[Proved]) -> Account {
    programs.last().map(|program| program.account.clone()).unwrap_or_default()
}
