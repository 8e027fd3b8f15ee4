//! What axis words and the words of an arc say.

use crate::gcode::letters::Letters;
use crate::machine::axis::Axis;
use crate::number::grid::Milli;

/// What a word of X is. That the machine is a lathe, [`Class`](super::Class) says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AcrossWord {
    /// The coordinate itself.
    Radius,
    /// Twice the coordinate.
    Diameter,
}

impl AcrossWord {
    /// The coordinate that a word of X, or of its increment, says.
    #[must_use]
    pub fn coordinate(self, word: f64) -> f64 {
        match self {
            Self::Radius => word,
            Self::Diameter => word / 2.0,
        }
    }

    /// The number of a word of X that says a diameter.
    #[must_use]
    pub fn of_diameter(self, diameter: f64) -> f64 {
        match self {
            Self::Radius => diameter / 2.0,
            Self::Diameter => diameter,
        }
    }

    /// The word of X that says a coordinate.
    #[must_use]
    pub fn word(self, coordinate: Milli) -> Milli {
        match self {
            Self::Radius => coordinate,
            Self::Diameter => coordinate + coordinate,
        }
    }
}

/// How increments are programmed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Increments {
    /// By G91.
    ByMode,
    /// By U and W, the increments of X and Z; G91 is no code.
    ByLetters,
}

/// How axis words are read.
#[derive(Clone, Copy, Debug)]
pub struct AxisWords {
    /// X.
    pub x: AcrossWord,
    /// By G91, or by U and W.
    pub increments: Increments,
}

impl AxisWords {
    /// The coordinate that a word of an axis says, in the unit of the word.
    #[must_use]
    pub fn coordinate(self, axis: Axis, word: f64) -> f64 {
        if axis == Axis::X { self.x.coordinate(word) } else { word }
    }

    /// The axis that a letter moves by an increment, whatever the mode.
    #[must_use]
    pub const fn increment(self, letter: Axis) -> Option<Axis> {
        match (self.increments, letter) {
            (Increments::ByLetters, Axis::U) => Some(Axis::X),
            (Increments::ByLetters, Axis::W) => Some(Axis::Z),
            (Increments::ByLetters, Axis::X | Axis::Y | Axis::Z | Axis::A | Axis::B | Axis::C | Axis::V)
            | (Increments::ByMode, _) => None,
        }
    }

    /// True where U and W are increments.
    #[must_use]
    pub const fn by_letters(self) -> bool {
        match self.increments {
            Increments::ByLetters => true,
            Increments::ByMode => false,
        }
    }
}

/// What the centre word of the axis across the plane says in an arc, as K in G17.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// It belongs to no arc of the plane.
    Foreign,
    /// The pitch of a helix, above 0.
    Pitch,
    /// Not known. 0 in an arc that does not leave its plane comes to nothing, whether it is a centre or a pitch.
    Unknown,
}

/// What a negative R of an arc says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NegativeRadius {
    /// The arc of more than half a circle.
    LongArc,
    /// Nothing: the block is rejected. Fanuc 16/18-C for Lathe, operator's manual p. 67: with R "an arc with a sector angle of
    /// 180° or wider cannot be specified".
    Refused,
}

impl NegativeRadius {
    /// True where R makes no arc of half a circle or more.
    #[must_use]
    pub const fn refused(self) -> bool {
        match self {
            Self::LongArc => false,
            Self::Refused => true,
        }
    }
}

/// Which words an arc takes, and what they say.
#[derive(Clone, Copy, Debug)]
pub struct ArcWords {
    /// Beside the axes.
    pub letters: Letters,
    /// The centre word of the axis across the plane.
    pub across: Across,
    /// What an R below 0 says.
    pub negative: NegativeRadius,
    /// How much the radii at start and end may differ.
    pub radii: Radii,
}

/// How much the radii of an arc with a centre may differ at its start and its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Radii {
    /// As LinuxCNC has it.
    LinuxCnc,
    /// As a parameter of the machine says, which rodete does not know: LinuxCNC's limit is kept, and more than a hundredth of a
    /// millimetre is told (Fagor 8055 M, programming manual, p. 89: general parameter CIRINERR).
    Parameter,
}
