//! Turning on a lathe: what the tool takes away, against closed forms.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod alarms;
mod blades;
mod bodies;
mod boring;
mod collisions;
mod exact;
mod judged;
mod lathe;
mod marks;
mod part;
mod raised;
mod repeated;
mod tools;
mod volumes;
