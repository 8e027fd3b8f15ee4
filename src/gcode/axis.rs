//! Axes and positions.

use crate::number::grid::Milli;

/// An axis of a milling machine, in the order in which blocks name them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// Linear, mm.
    X,
    /// Linear, mm.
    Y,
    /// Linear, mm.
    Z,
    /// Rotary about X, degrees.
    A,
    /// Rotary about Y, degrees.
    B,
    /// Rotary about Z, degrees.
    C,
}

impl Axis {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::X, Self::Y, Self::Z, Self::A, Self::B, Self::C];

    /// The address letter.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::X => 'X',
            Self::Y => 'Y',
            Self::Z => 'Z',
            Self::A => 'A',
            Self::B => 'B',
            Self::C => 'C',
        }
    }

    /// True for A, B and C.
    #[must_use]
    pub const fn rotary(self) -> bool {
        matches!(self, Self::A | Self::B | Self::C)
    }
}

/// A position of all axes on the output grid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Position([Milli; 6]);

impl Position {
    /// The position of one axis.
    #[must_use]
    pub const fn get(&self, axis: Axis) -> Milli {
        self.0[axis as usize]
    }

    /// The position with one axis elsewhere.
    #[must_use]
    pub const fn with(mut self, axis: Axis, value: Milli) -> Self {
        self.0[axis as usize] = value;
        self
    }

    /// The position with one axis moved on.
    #[must_use]
    pub fn moved(self, axis: Axis, by: Milli) -> Self {
        self.with(axis, self.get(axis) + by)
    }

    /// The differences to another position, in mm and degrees.
    #[must_use]
    pub fn differences(&self, from: &Self) -> [f64; 6] {
        Axis::ALL.map(|axis| (self.get(axis) - from.get(axis)).value())
    }
}
