//! The imaginary tip: the point of the tool that the program moves.

use crate::gcode::turning::nose::element::Point;

/// Where the imaginary tip lies, seen from the centre of the nose: the number that stands beside the nose radius in the
/// control's offset table.
///
/// | number | X | Z | such as |
/// |---|---|---|---|
/// | 0, 9 | 0 | 0 | the centre itself is programmed |
/// | 1 | + | + | boring towards the tailstock |
/// | 2 | + | − | boring towards the chuck |
/// | 3 | − | − | turning towards the chuck |
/// | 4 | − | + | turning towards the tailstock |
/// | 5 | 0 | + | facing from behind |
/// | 6 | + | 0 | a round insert in a bore |
/// | 7 | 0 | − | facing |
/// | 8 | − | 0 | a round insert on the outside |
///
/// The signs are those of the axes, whatever side of the spindle the turret is on: Fanuc Series 0i-T operator's manual,
/// imaginary tool nose; the same table stands in Haas's lathe operator's manual, imaginary tool tip and direction. Fagor's
/// location codes F0 to F9 keep the tool's position to the axes likewise and are read by the same table. LinuxCNC's
/// orientations have X the other way round: its 2 is 3 here, its 1 is 4, its 6 is 8, and back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tip(u8);

impl Tip {
    /// The orientation with a number, 0 to 9.
    #[must_use]
    pub const fn new(number: u8) -> Option<Self> {
        if number <= 9 { Some(Self(number)) } else { None }
    }

    /// The orientation that LinuxCNC's tool table gives by a number, 0 to 9.
    #[must_use]
    pub const fn of_linuxcnc(number: u8) -> Option<Self> {
        match number {
            1 => Some(Self(4)),
            2 => Some(Self(3)),
            3 => Some(Self(2)),
            4 => Some(Self(1)),
            6 => Some(Self(8)),
            8 => Some(Self(6)),
            other => Self::new(other),
        }
    }

    /// The number.
    #[must_use]
    pub const fn number(self) -> u8 {
        self.0
    }

    /// From the centre of the nose to the tip, in nose radii, `[Z, X]`.
    #[must_use]
    pub const fn vector(self) -> Point {
        match self.0 {
            1 => [1.0, 1.0],
            2 => [-1.0, 1.0],
            3 => [-1.0, -1.0],
            4 => [1.0, -1.0],
            5 => [1.0, 0.0],
            6 => [0.0, 1.0],
            7 => [-1.0, 0.0],
            8 => [0.0, -1.0],
            _ => [0.0, 0.0],
        }
    }
}

/// The nose of a tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Nose {
    /// Its radius R, 0 or more; mm.
    pub radius: f64,
    /// Where its imaginary tip lies.
    pub tip: Tip,
}

impl Nose {
    /// From the centre of the nose to the tip, `[Z, X]`; mm.
    #[must_use]
    pub fn to_tip(&self) -> Point {
        self.tip.vector().map(|share| share * self.radius)
    }
}
