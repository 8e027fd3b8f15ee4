//! Axes and positions.

use crate::number::grid::Milli;

/// An axis of a machine, in the order in which LinuxCNC numbers them.
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
    /// Linear, beside X, mm.
    U,
    /// Linear, beside Y, mm.
    V,
    /// Linear, beside Z, mm.
    W,
}

impl Axis {
    /// All of them.
    pub const ALL: [Self; 9] = [Self::X, Self::Y, Self::Z, Self::A, Self::B, Self::C, Self::U, Self::V, Self::W];

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
            Self::U => 'U',
            Self::V => 'V',
            Self::W => 'W',
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
pub struct Position([Milli; 9]);

impl Position {
    /// The position of one axis, mm or degrees, in whole thousandths.
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

    /// The position with one axis moved on by mm or degrees.
    #[must_use]
    pub fn moved(self, axis: Axis, by: Milli) -> Self {
        self.with(axis, self.get(axis) + by)
    }

    /// The differences to another position, in mm and degrees.
    #[must_use]
    pub fn differences(&self, from: &Self) -> [f64; 9] {
        Axis::ALL.map(|axis| (self.get(axis) - from.get(axis)).value())
    }
}

impl From<Position> for Pose {
    fn from(position: Position) -> Self {
        let mut pose = Self::default();
        for (at, size) in pose.0.iter_mut().zip(position.0) {
            *at = size.value();
        }
        pose
    }
}

/// Where all axes stand: mm for the linear axes, degrees for the rotary ones.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pose(pub [f64; 9]);

impl Pose {
    /// The position of one axis, mm or degrees.
    #[must_use]
    pub const fn get(&self, axis: Axis) -> f64 {
        self.0[axis as usize]
    }

    /// Puts one axis elsewhere.
    pub const fn set(&mut self, axis: Axis, value: f64) {
        self.0[axis as usize] = value;
    }

    /// The differences to another pose, axis by axis.
    #[must_use]
    pub fn differences(&self, from: &Self) -> [f64; 9] {
        let mut by = self.0;
        for (by, from) in by.iter_mut().zip(from.0) {
            *by -= from;
        }
        by
    }
}
