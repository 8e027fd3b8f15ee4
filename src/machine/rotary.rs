//! The rotary axes: C turns the part about its own axis, B tilts it about an axis at the pivot length L below the
//! origin of the part, until the normal of the surface points along Z, where the tool stands.
//!
//! # Units
//! Millimetres and radians.
//!
//! # References
//! The thesis, equations (8) to (19), corrected against its tables: M1 is applied with −C, M2 with +B, and points turn
//! about the pivot: P″ = M2(B)·(M1(−C)·P + L·k̂) − L·k̂.

use nalgebra::Vector3;

use crate::number::grid::HALF;
use crate::number::trig::sin_cos;

/// A rotary table that tilts under a tool that stands along Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltingTable {
    /// L, the pivot length: from the B axis to the origin of the part frame.
    pub L: f64,
}

/// M2(B)·M1(−C), for many directions at one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    /// sin B and cos B.
    B: (f64, f64),
    /// sin C and cos C.
    C: (f64, f64),
}

impl Turned {
    /// The axes turned to B and C, radians.
    #[must_use]
    pub fn to(B: f64, C: f64) -> Self {
        Self { B: sin_cos(B), C: sin_cos(C) }
    }

    /// The axes turned on from here by as much as `step` has them turned: from step to step that takes no sine.
    #[must_use]
    pub fn on_by(&self, step: &Self) -> Self {
        let on = |(sin, cos): (f64, f64), (sin_by, cos_by): (f64, f64)| {
            (sin * cos_by + cos * sin_by, cos * cos_by - sin * sin_by)
        };
        Self { B: on(self.B, step.B), C: on(self.C, step.C) }
    }

    /// A direction of the part frame in machine axes.
    #[inline]
    #[must_use]
    pub fn direction(&self, a: &Vector3<f64>) -> Vector3<f64> {
        let ((sin_B, cos_B), (sin_C, cos_C)) = (self.B, self.C);
        let x = a.x * cos_C + a.y * sin_C;
        let y = a.y * cos_C - a.x * sin_C;
        Vector3::new(x * cos_B - a.z * sin_B, y, x * sin_B + a.z * cos_B)
    }

    /// A direction in machine axes in the part frame.
    #[inline]
    #[must_use]
    pub fn direction_to_part(&self, a: &Vector3<f64>) -> Vector3<f64> {
        let ((sin_B, cos_B), (sin_C, cos_C)) = (self.B, self.C);
        let x = a.x * cos_B + a.z * sin_B;
        Vector3::new(x * cos_C - a.y * sin_C, x * sin_C + a.y * cos_C, a.z * cos_B - a.x * sin_B)
    }
}

impl TiltingTable {
    /// M2(B)·M1(−C)·a: a direction of the part frame in machine axes.
    #[must_use]
    pub fn direction_to_machine(a: &Vector3<f64>, B: f64, C: f64) -> Vector3<f64> {
        Turned::to(B, C).direction(a)
    }

    /// M1(−C)ᵀ·M2(B)ᵀ·a: a direction in machine axes in the part frame.
    #[must_use]
    pub fn direction_to_part(a: &Vector3<f64>, B: f64, C: f64) -> Vector3<f64> {
        Turned::to(B, C).direction_to_part(a)
    }

    /// Inverse kinematics: the machine position P″ at which the tool tip stands on the point P of the part.
    #[must_use]
    pub fn to_machine(self, P: &Vector3<f64>, B: f64, C: f64) -> Vector3<f64> {
        let pivot = Vector3::new(0.0, 0.0, self.L);
        // C turns about the axis on which the pivot stands, so that L may be added before both turns.
        Self::direction_to_machine(&(P + pivot), B, C) - pivot
    }

    /// Forward kinematics: the point of the part at which the tool tip stands.
    #[must_use]
    pub fn to_part(self, machine: &Vector3<f64>, B: f64, C: f64) -> Vector3<f64> {
        let pivot = Vector3::new(0.0, 0.0, self.L);
        Self::direction_to_part(&(machine + pivot), B, C) - pivot
    }

    /// The tool in the part: the point at which its tip stands, and the direction of its axis.
    #[must_use]
    pub fn tool(self, machine: &Vector3<f64>, B: f64, C: f64) -> [Vector3<f64>; 2] {
        self.tool_turned(machine, &Turned::to(B, C))
    }

    /// The same where the axes are turned already.
    #[must_use]
    pub fn tool_turned(self, machine: &Vector3<f64>, turned: &Turned) -> [Vector3<f64>; 2] {
        let ((sin_B, cos_B), (sin_C, cos_C)) = (turned.B, turned.C);
        let z = machine.z + self.L;
        let x = machine.x * cos_B + z * sin_B;
        let tip =
            Vector3::new(x * cos_C - machine.y * sin_C, x * sin_C + machine.y * cos_C, z * cos_B - machine.x * sin_B);
        [tip - Vector3::new(0.0, 0.0, self.L), Vector3::new(sin_B * cos_C, sin_B * sin_C, cos_B)]
    }

    /// How fast the tip moves over the part where all axes move evenly: y is where it stands, seen from the pivot, `by` how
    /// it moves, and B and C turn by so much in the same time.
    ///
    /// # Derivation
    /// In the frame that turns with C, the tip is at M2(B)ᵀ·y; that of ẏ and of Ḃ about the pivot turn with it, and Ċ turns
    /// the part under it. How far C has turned does not change the size.
    #[must_use]
    pub fn tip_speed(y: &Vector3<f64>, by: &Vector3<f64>, B: f64, [dB, dC]: [f64; 2]) -> f64 {
        let (sin, cos) = sin_cos(B);
        let turned = |a: &Vector3<f64>| Vector3::new(a.x * cos + a.z * sin, a.y, a.z * cos - a.x * sin);
        let point = turned(y);
        (turned(&(by + Vector3::new(y.z, 0.0, -y.x) * dB)) + Vector3::new(-point.y, point.x, 0.0) * dC).norm()
    }

    /// The height above the origin that no point of a part within the radius R about the axis and below the origin
    /// reaches at any B: √(L² + R²) − L.
    ///
    /// # Derivation
    /// The part turns about the pivot, L below the origin. A point below the origin, as far as 2L down, is no more than L from
    /// the pivot along the axis and R across, √(L² + R²) in all; no turn takes it higher above the pivot.
    #[must_use]
    pub fn swing(self, R: f64) -> f64 {
        (self.L * self.L + R * R).sqrt() - self.L
    }

    /// How far rounding to the output grid may move a point of the tool over a part within the radius R: half a step in each of
    /// X, Y and Z, and of B and C at the distance of any point of the part from the pivot, L + R at most, and from the axis, R at
    /// most.
    #[must_use]
    pub fn rounding(self, R: f64) -> f64 {
        HALF * 3.0_f64.sqrt() + HALF.to_radians() * (self.L + 2.0 * R)
    }
}
