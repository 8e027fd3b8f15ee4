//! Turning tools by their catalogue values.

use crate::gcode::in_force::Spindle;
pub use crate::gcode::turning::nose::Tip;
use crate::text::Text;

/// The shape of an indexable insert, by its letter in ISO 1832.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Rhombus, 80°.
    C,
    /// Rhombus, 55°.
    D,
    /// Rhombus, 35°.
    V,
    /// Triangle, 60°.
    T,
    /// Square, 90°.
    S,
    /// Trigon, 80°.
    W,
    /// Round.
    R,
    /// Parallelogram, 55°.
    K,
}

impl Shape {
    /// All of them.
    pub const ALL: [Self; 8] = [Self::C, Self::D, Self::V, Self::T, Self::S, Self::W, Self::R, Self::K];

    /// Its letter in ISO 1832.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::C => 'C',
            Self::D => 'D',
            Self::V => 'V',
            Self::T => 'T',
            Self::S => 'S',
            Self::W => 'W',
            Self::R => 'R',
            Self::K => 'K',
        }
    }

    /// The shape of a letter, capital or small; `None` for any other.
    #[must_use]
    pub fn of(letter: char) -> Option<Self> {
        Self::ALL.into_iter().find(|shape| shape.letter() == letter.to_ascii_uppercase())
    }

    /// The angle at the cutting corner, degrees; 0 for a round insert.
    #[must_use]
    pub const fn angle(self) -> f64 {
        match self {
            Self::C | Self::W => 80.0,
            Self::D | Self::K => 55.0,
            Self::V => 35.0,
            Self::T => 60.0,
            Self::S => 90.0,
            Self::R => 0.0,
        }
    }
}

/// Which hand a tool is: seen from above with the tip towards the onlooker, a right-hand tool has its cutting edge on the
/// right; in front of the axis with its face up it feeds towards the chuck.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hand {
    /// R.
    #[default]
    Right,
    /// L.
    Left,
    /// N.
    Neutral,
}

/// What cuts. Lengths in mm, angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cutter {
    /// An indexable insert for turning or boring.
    Insert {
        /// Its shape, from which the angle at the corner follows.
        shape: Shape,
        /// The diameter of its inscribed circle, D.
        circle: f64,
        /// The cutting-edge angle φ1, between the main edge and the feed along Z: above 90° the nose leads.
        main: f64,
        /// The minor cutting-edge angle φ2, between the other edge and the turned surface.
        auxiliary: f64,
        /// The nose radius R.
        nose: f64,
    },
    /// An insert for grooving or parting. The programmed point is its corner at the side to which the tip points, the
    /// left one for tip 3; its middle for tips 5 to 8.
    Groover {
        /// The width of its front edge.
        width: f64,
        /// How deep it reaches.
        depth: f64,
        /// The radius of its two corners.
        corner: f64,
        /// It cuts along Z into a face, not along X.
        face: bool,
    },
    /// An insert for threads; the programmed point is level with the middle of its tip.
    Threader {
        /// The angle between the flanks of the profile, as 60.
        angle: f64,
        /// The radius of the tip.
        nose: f64,
        /// How deep the profile is.
        depth: f64,
        /// The least and the greatest lead it is made for.
        leads: [f64; 2],
    },
    /// A twist drill; the programmed point is its point.
    Drill {
        /// The diameter of the hole that it drills.
        diameter: f64,
        /// The angle of the point; 180° for a flat one.
        point: f64,
        /// How long the flutes are, from the point.
        length: f64,
    },
    /// A centre drill with a countersink of 60°; the programmed point is its point.
    CentreDrill {
        /// The pilot's diameter.
        pilot: f64,
        /// The pilot's length, from the point.
        reach: f64,
        /// The body's diameter.
        diameter: f64,
        /// The length from the point to the end of the body.
        length: f64,
    },
}

/// What holds the cutter. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Holder {
    /// A square shank along X.
    Shank {
        /// Its width along Z.
        width: f64,
        /// From the tip to its end.
        length: f64,
    },
    /// A round bar along Z; for a drill, the chuck behind its flutes.
    Bar {
        /// The diameter of the bar.
        diameter: f64,
        /// From the tip to its end.
        length: f64,
        /// From the tip to its centre line, across the axis; of no account for a drill.
        reach: f64,
    },
}

/// A tool as it stands in the turret.
#[derive(Clone, Debug, PartialEq)]
pub struct TurningTool {
    /// What it is called.
    pub name: Text,
    /// What cuts.
    pub cutter: Cutter,
    /// Whether it is a right-hand, a left-hand or a neutral tool.
    pub hand: Hand,
    /// Where the tip points.
    pub tip: Tip,
    /// What holds it.
    pub holder: Holder,
    /// The way the spindle turns for it to cut, where that is given; never stopped. Where it is not, see [`TurningTool::spindle`].
    pub turns: Option<Spindle>,
    /// From the programmed point to the turret's reference point along X (as a radius) and Z: what stands as the tool's
    /// offset in the control.
    pub overhang: [f64; 2],
}

impl TurningTool {
    /// True for drills, which work on the axis.
    #[must_use]
    pub const fn axial(&self) -> bool {
        matches!(self.cutter, Cutter::Drill { .. } | Cutter::CentreDrill { .. })
    }

    /// True for tools that are fed slowly: drills, and blades that groove or part.
    #[must_use]
    pub const fn fed_slowly(&self) -> bool {
        self.axial() || matches!(self.cutter, Cutter::Groover { .. })
    }

    /// The nose radius that nose-radius compensation counts on, mm; 0 for drills.
    #[must_use]
    pub const fn nose(&self) -> f64 {
        match self.cutter {
            Cutter::Insert { shape: Shape::R, circle, .. } => circle / 2.0,
            Cutter::Insert { nose, .. } | Cutter::Threader { nose, .. } => nose,
            Cutter::Groover { corner, .. } => corner,
            Cutter::Drill { .. } | Cutter::CentreDrill { .. } => 0.0,
        }
    }

    /// The way the spindle has to turn for the tool to cut, where the turret stands in front of the axis (towards the
    /// operator) or behind it: as it is given for the tool, and where it is not, as such a tool usually lies. `None` where
    /// either way may be right.
    ///
    /// # Derivation
    /// M3 turns the work clockwise seen from behind the headstock, so that in front of the axis its surface comes down
    /// upon a tool whose face looks up. A right-hand tool that feeds towards the chuck lies face up in front of the axis,
    /// and behind it face down, where the surface comes up: M3 for both. A left-hand tool that feeds towards the chuck is
    /// the mirror image: M4. Feeding away from the chuck turns each about. Boring bars follow the same rule. Drills are
    /// right-hand: M3. A neutral tool is its own mirror image and cuts the same either face up: what is not given for it
    /// may be either. Beyond the axis, where most of a cut lies there, the surface goes the other way.
    ///
    /// Of a blade for grooves, parting or threads the tip says which corner is programmed, and not how it lies. On a bar its
    /// edge is at the end that goes ahead to the chuck: M3 for a right-hand one, M4 for a left-hand one. On a shank the rule
    /// is that of inserts (see [`TurningTool::ahead`]), and either hand may lie either way up. A right-hand one has its edge at the
    /// chuck's side, as it is parted off there: M3. A left-hand one lies face up, to be seen and changed: M3 in front, with
    /// its body towards the chuck; M4 behind, with its edge there.
    #[must_use]
    pub const fn spindle(&self, behind: bool, beyond: bool) -> Option<Spindle> {
        let Some(clockwise) = self.clockwise(behind) else { return None };
        Some(if clockwise != (beyond && !self.axial()) { Spindle::Clockwise } else { Spindle::CounterClockwise })
    }

    /// True where the spindle has to turn clockwise, M3, this side of the axis; `None` where it may turn either way.
    const fn clockwise(&self, behind: bool) -> Option<bool> {
        match self.turns {
            Some(Spindle::Clockwise) => return Some(true),
            Some(Spindle::CounterClockwise) => return Some(false),
            Some(Spindle::Stopped) | None => {}
        }
        let away = matches!(self.tip, Tip::InsideRight | Tip::OutsideRight | Tip::Right);
        match (self.cutter, self.hand) {
            (Cutter::Drill { .. } | Cutter::CentreDrill { .. }, _) => Some(true),
            (_, Hand::Neutral) => None,
            (Cutter::Insert { .. }, Hand::Right) => Some(!away),
            (Cutter::Insert { .. }, Hand::Left) => Some(away),
            (_, Hand::Right) => Some(true),
            (_, Hand::Left) => Some(matches!(self.holder, Holder::Shank { .. }) && !behind),
        }
    }

    /// Of a blade on a shank, whether its edge lies at the chuck's side of the shank, and of one that cuts into a face at the
    /// side away from the axis; `None` where it is neutral, in the middle.
    ///
    /// # Derivation
    /// Seen from above, the turret in front: the tip of a tool along X points up the page, and the chuck is to the left. A
    /// right-hand tool that lies face up has its edge to the left, and cuts with M3. Laid face down it has its edge to the
    /// right, and cuts with M4; moved behind the axis, where its tip points down the page, too. So either turns about both
    /// edge and spindle, the hand the edge alone: M3 cuts where the edge is at the chuck's side of a right-hand tool or at the
    /// other side of a left-hand one, in front of the axis and behind it alike. For a tool along Z that cuts into a face the
    /// page is turned: its tip points to the left, and its edge is at the bottom, away from the axis, where it was to the
    /// left; moved behind, that is at the axis.
    #[must_use]
    pub const fn ahead(&self, behind: bool) -> Option<bool> {
        match (self.hand, self.clockwise(behind)) {
            (Hand::Right, Some(clockwise)) => Some(clockwise),
            (Hand::Left, Some(clockwise)) => Some(!clockwise),
            (Hand::Neutral, _) | (_, None) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_known_by_their_letters() {
        for shape in Shape::ALL {
            assert_eq!(Shape::of(shape.letter()), Some(shape));
        }
        assert_eq!(Shape::of('c'), Some(Shape::C));
        assert_eq!(Shape::of('X'), None);
    }
}
