//! What each kind makes: the published figures, and what must hold for every design.

#[path = "../common/mod.rs"]
mod common;
mod impeller_shortfalls;
mod pipe_designs;
mod pipe_hole;
mod pipe_insert;
mod properties;
mod published;
mod slips;
mod ties;
