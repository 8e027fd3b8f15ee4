//! The numbers of LinuxCNC's parameters that hold offsets and positions.

/// The parameter that says which coordinate system is active, 1 to 9.
pub const ACTIVE: u32 = 5220;
/// The parameter that switches the axis offsets of G92 and G52 on: any value but 0.
pub const G92_SWITCH: u32 = 5210;
/// The axis offset of X of G92 and G52; the other axes follow.
pub const G92_FIRST: u32 = 5211;
/// X of the position of G28; the other axes follow.
pub const G28_FIRST: u32 = 5161;
/// X of the position of G30; the other axes follow.
pub const G30_FIRST: u32 = 5181;
/// How many axes there are, X to W: the parameters of a position follow each other.
pub const AXES: u32 = 9;
/// How many coordinate systems there are, G54 to G59.3.
pub const SYSTEMS: u32 = 9;

/// The origin in X of a coordinate system, 1 to 9; those of the other axes follow, and its rotation behind them.
#[must_use]
pub const fn system_first(number: u32) -> u32 {
    5201 + 20 * number
}
