//! The imaginary tip: the point of the tool that the program moves.

use crate::gcode::turning::nose::element::Point;

/// Where the imaginary tip lies, seen from the centre of the nose: the number that stands beside the nose radius in the
/// control's offset table.
///
/// The imaginary tip is where the tangents to the nose meet that are parallel to the axes. For 5 to 8 it is on the tangent
/// across the way the tip points, level with the nose's centre; for 9, and for 0, it is that centre.
///
/// The signs are those of the axes, whatever side of the spindle the turret is on: Fanuc Series 0i-T operator's manual,
/// imaginary tool nose; the same table stands in Haas's lathe operator's manual, imaginary tool tip and direction. Fagor's
/// location codes F0 to F9 keep the tool's position to the axes likewise and are read by the same table. LinuxCNC's
/// orientations have X the other way round: its 2 is 3 here, its 1 is 4, its 6 is 8, and back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tip {
    /// 1: to +X and +Z, boring away from the chuck.
    InsideRight,
    /// 2: to +X and −Z, boring towards the chuck.
    InsideLeft,
    /// 3: to −X and −Z, turning towards the chuck.
    #[default]
    OutsideLeft,
    /// 4: to −X and +Z, turning away from the chuck.
    OutsideRight,
    /// 5: to +Z, facing from behind.
    Right,
    /// 6: to +X, grooves and threads inside.
    Inside,
    /// 7: to −Z, drills, facing.
    Left,
    /// 8: to −X, grooves and threads outside.
    Outside,
    /// 9, also 0: the nose's centre is programmed.
    Centre,
}

impl Tip {
    /// All of them, by number.
    pub const ALL: [Self; 9] = [
        Self::InsideRight,
        Self::InsideLeft,
        Self::OutsideLeft,
        Self::OutsideRight,
        Self::Right,
        Self::Inside,
        Self::Left,
        Self::Outside,
        Self::Centre,
    ];

    /// The tip of a number, 0 to 9; 0 is 9.
    #[must_use]
    pub fn new(number: u8) -> Option<Self> {
        if number == 0 { Some(Self::Centre) } else { Self::ALL.get(usize::from(number) - 1).copied() }
    }

    /// The tip that LinuxCNC's tool table gives by an orientation, 0 to 9.
    #[must_use]
    pub fn of_linuxcnc(orientation: u8) -> Option<Self> {
        Self::new(turned_over(orientation))
    }

    /// The orientation that LinuxCNC's tool table gives it, 1 to 9.
    #[must_use]
    pub const fn in_linuxcnc(self) -> u8 {
        turned_over(self.number())
    }

    /// The number under which tool tables have it, 1 to 9, as on Fanuc's controls.
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8 + 1
    }

    /// From the centre of the nose to the tip, in nose radii, `[Z, X]`.
    #[must_use]
    pub const fn vector(self) -> Point {
        match self {
            Self::InsideRight => [1.0, 1.0],
            Self::InsideLeft => [-1.0, 1.0],
            Self::OutsideLeft => [-1.0, -1.0],
            Self::OutsideRight => [1.0, -1.0],
            Self::Right => [1.0, 0.0],
            Self::Inside => [0.0, 1.0],
            Self::Left => [-1.0, 0.0],
            Self::Outside => [0.0, -1.0],
            Self::Centre => [0.0, 0.0],
        }
    }

    /// The signs by which `[Z, X]` of a tool of tip 3 is turned into this one.
    #[must_use]
    pub fn mirror(self) -> Point {
        self.vector().map(|share| if share > 0.0 { -1.0 } else { 1.0 })
    }

    /// True along Z and along X where the tip is level with the nose's centre.
    #[must_use]
    pub fn level(self) -> [bool; 2] {
        self.vector().map(|share| share == 0.0)
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

/// A tip's number with X the other way round, from LinuxCNC's and to it.
const fn turned_over(number: u8) -> u8 {
    match number {
        1 => 4,
        2 => 3,
        3 => 2,
        4 => 1,
        6 => 8,
        8 => 6,
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tips_have_the_numbers_of_the_controls() {
        for (at, tip) in Tip::ALL.into_iter().enumerate() {
            assert_eq!(usize::from(tip.number()), at + 1);
            assert_eq!(Tip::new(tip.number()), Some(tip));
        }
        assert_eq!(Tip::new(0), Some(Tip::Centre));
        assert_eq!(Tip::new(10), None);
        assert_eq!(Tip::OutsideLeft.number(), 3);
    }
}
