//! The commands as whole processes: what they print, what they write, how they end.

#![allow(clippy::expect_used)]

mod coded;
mod common;
mod compare;
mod delivered;
mod environment;
mod faults;
mod made_from;
mod offsets;
mod outputs;
mod spoken;
mod usage;
mod verify;
mod view;
mod watch;
mod work;
