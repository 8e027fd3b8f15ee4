//! The unit in which a machine counts lengths.

use crate::finding::Size;

/// The unit of a machine's lengths. Inside rodete lengths are in millimetres; a machine's files are in its own unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum LengthUnit {
    /// Inch, 25.4 mm.
    Inch,
    /// Millimetre.
    #[default]
    Millimetre,
}

impl LengthUnit {
    /// How many millimetres one of it is.
    #[must_use]
    pub const fn millimetres(self) -> f64 {
        match self {
            Self::Inch => 25.4,
            Self::Millimetre => 1.0,
        }
    }

    /// The usual sign, `in` or `mm`.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Inch => "in",
            Self::Millimetre => "mm",
        }
    }

    /// A length in this unit, in millimetres.
    #[must_use]
    pub const fn to_mm(self, length: f64) -> f64 {
        length * self.millimetres()
    }

    /// A length in millimetres, in this unit.
    #[must_use]
    pub const fn from_mm(self, length: f64) -> f64 {
        length / self.millimetres()
    }

    /// A length in millimetres as it is told in this unit, to its ten-thousandth.
    #[must_use]
    pub const fn size(self, length: f64) -> Size {
        Size { value: self.from_mm(length), unit: self.symbol(), decimals: 4 }
    }
}
