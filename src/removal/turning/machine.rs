//! The lathe: its travel, its speeds, and the bodies about the part.
//!
//! # Coordinates
//! Machine zero M is where the spindle's axis meets the end plane of its nose. Z runs from there to the tailstock, X away from the
//! axis, here always as a radius.

/// A lathe with a turret on two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Lathe {
    /// The zero of the control's machine coordinates, X as a radius, and Z; from M, mm.
    pub origin: [f64; 2],
    /// Where the turret's reference point may be along X, as a radius; mm.
    pub travel_x: [f64; 2],
    /// Along Z, mm.
    pub travel_z: [f64; 2],
    /// The rapid rates of X (of the slide, so of the radius) and Z, mm/min.
    pub rapid: [f64; 2],
    /// In rapid each axis moves at its own rate, so the path has a bend; otherwise it is straight.
    pub bent_rapid: bool,
    /// The maximum speed of the spindle, rpm.
    pub greatest_speed: f64,
    /// The turret is behind the axis, seen from the operator.
    pub turret_behind: bool,
    /// The chuck that holds the part.
    pub chuck: Chuck,
    /// The support on the right, if the part needs one.
    pub tailstock: Tailstock,
}

/// A three-jaw chuck, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chuck {
    /// L1: from M to the front of its body.
    pub body: f64,
    /// L2: how far the jaws project from there.
    pub jaws: f64,
    /// The diameter of the chuck's body.
    pub diameter: f64,
    /// How far the jaws project from the part, in radius.
    pub jaw_height: f64,
}

/// A tailstock's quill with a centre of 60°, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tailstock {
    /// The quill's diameter.
    pub diameter: f64,
    /// Its free length, from the point of the centre.
    pub length: f64,
    /// How deep the centre is in the part.
    pub depth: f64,
    /// The part is supported if it sticks out of the chuck by more than this many diameters.
    pub beyond: f64,
}

impl Lathe {
    /// Whether +X points up where the machine is seen with its spindle on the left: away from the operator, to a turret behind the
    /// axis. To a turret in front of it +X points down, to the operator.
    #[must_use]
    pub const fn x_up(&self) -> bool {
        self.turret_behind
    }
}

impl Default for Lathe {
    /// A medium lathe with a turret in front of the axis.
    fn default() -> Self {
        Self {
            origin: [0.0, 0.0],
            travel_x: [-40.0, 400.0],
            travel_z: [0.0, 1000.0],
            rapid: [5000.0, 10_000.0],
            bent_rapid: true,
            greatest_speed: 3000.0,
            turret_behind: false,
            chuck: Chuck { body: 100.0, jaws: 40.0, diameter: 250.0, jaw_height: 40.0 },
            tailstock: Tailstock { diameter: 60.0, length: 200.0, depth: 3.0, beyond: 3.0 },
        }
    }
}
