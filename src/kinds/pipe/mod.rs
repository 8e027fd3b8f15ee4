//! Pipes: their sizes as standards give them, what cuts a branch to fit a header, and the hole in the header.

pub mod dimensions;
mod form;
mod form_sketch;
pub mod hole;
pub mod insert;
mod live_form;
pub mod rules;
pub mod scene;
pub mod size;
mod sketch;
mod switching;

use crate::gcode::control::Rotary;
use crate::gcode::word::Distance;
use crate::kind::{Proved, Shown};
use crate::kinds::pipe::dimensions::Pipe;
use crate::proof::account::Account;

/// How a program turns its rotary axes: where those of the control are rollover as delivered, the number of an absolute word
/// would be an angle from 0 to 360 and its sign the direction. Increments are the same motions on either axis.
const fn counted(rotary: Rotary) -> Distance {
    match rotary {
        Rotary::Rollover => Distance::Incremental,
        Rotary::Linear => Distance::Absolute,
    }
}

/// Both pipes as they are measured before the start, whatever standard they come from, for the set-up sheet.
fn sizes(branch: Pipe, header: Pipe) -> Vec<(&'static str, Shown)> {
    let of = |[D, t]: [&'static str; 2], pipe: Pipe| [(D, Shown::Length(pipe.D)), (t, Shown::Length(pipe.t))];
    [of(["D_branch", "t_branch"], branch), of(["D_header", "t_header"], header)].into_iter().flatten().collect()
}

/// What the program of a pipe comes to.
fn account(programs: &[Proved]) -> Account {
    programs.last().map(|program| program.account.clone()).unwrap_or_default()
}
