//! Metal that goes: what a turning program takes away, as exact plane regions.

pub mod turning;
