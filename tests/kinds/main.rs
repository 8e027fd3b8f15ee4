//! What each kind makes: the published figures, and what must hold for every design.

#![allow(clippy::disallowed_methods, reason = "tests read and write files, and ask other programs")]

#[path = "../common/mod.rs"]
mod common;
mod fields;
mod impeller_bodies;
mod impeller_clear;
mod impeller_cut;
mod impeller_designs;
mod impeller_gap;
mod impeller_lean;
mod impeller_passes;
mod impeller_shortfalls;
mod impeller_swept;
mod laws;
mod own_kind;
mod pipe_designs;
mod pipe_hole;
mod pipe_insert;
mod pipe_seat;
mod properties;
mod published;
mod slips;
mod ties;
