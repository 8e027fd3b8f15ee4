//! Work offsets: where the program's zero lies on the machine.
//!
//! # Units
//! Millimetres and degrees inside; a var file is in the machine's own unit.
//!
//! # References
//! The LinuxCNC manual, chapter "Coordinate systems": nine coordinate systems G54 to G59.3, each with nine origins and a
//! rotation about Z, the axis offsets of G92 and G52, which share their registers, and the positions of G28 and G30.

use super::rules::*;
use crate::finding::{Finding, Place, Raise};
use crate::machine::axis::{Axis, Pose};
use crate::machine::length_unit::LengthUnit;
use crate::machine::offset_parameters::system_first;
pub use crate::machine::offset_parameters::{ACTIVE, G28_FIRST, G30_FIRST, G92_FIRST, G92_SWITCH};
use crate::machine::var_file::{Unfit, VarFile};
use crate::number::shown;
use crate::number::trig::sin_cos;

/// A coordinate system of the workpiece.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum System {
    /// System 1, the one that is active after a start.
    #[default]
    G54,
    /// System 2.
    G55,
    /// System 3.
    G56,
    /// System 4.
    G57,
    /// System 5.
    G58,
    /// System 6.
    G59,
    /// System 7.
    G59_1,
    /// System 8.
    G59_2,
    /// System 9.
    G59_3,
}

impl System {
    /// All of them, in the order of their numbers.
    pub const ALL: [Self; 9] =
        [Self::G54, Self::G55, Self::G56, Self::G57, Self::G58, Self::G59, Self::G59_1, Self::G59_2, Self::G59_3];

    /// The number that G10 takes as P, 1 to 9.
    #[must_use]
    pub const fn number(self) -> u32 {
        self as u32 + 1
    }

    /// The system of a number from 1 to 9; `None` for any other.
    #[must_use]
    pub fn from_number(number: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|system| system.number() == number)
    }

    /// The code that selects it, as `G59.1`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::G54 => "G54",
            Self::G55 => "G55",
            Self::G56 => "G56",
            Self::G57 => "G57",
            Self::G58 => "G58",
            Self::G59 => "G59",
            Self::G59_1 => "G59.1",
            Self::G59_2 => "G59.2",
            Self::G59_3 => "G59.3",
        }
    }

    /// The system that a code selects, in capitals or small letters.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|system| system.name().eq_ignore_ascii_case(name))
    }

    /// The parameter that holds its origin in X; those of the other axes follow.
    #[must_use]
    pub const fn first_parameter(self) -> u32 {
        system_first(self.number())
    }

    /// The parameter that holds its rotation about Z, in degrees.
    #[must_use]
    pub const fn rotation_parameter(self) -> u32 {
        self.first_parameter() + 9
    }
}

/// Origin and rotation of a coordinate system.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorkOffset {
    /// Where the system's zero lies in machine coordinates.
    pub origin: Pose,
    /// Rotation about Z in degrees, counter-clockwise seen from +Z.
    pub rotation: f64,
}

/// What stands between program and machine coordinates at one moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ActiveOffsets {
    /// The active coordinate system.
    pub work: WorkOffset,
    /// The axis offsets of G92 or G52 that are in force; zero where they are off.
    pub g92: Pose,
    /// The tool offset that is in force.
    pub tool: Pose,
}

impl ActiveOffsets {
    /// The machine position of a program position: Rz(rotation)·(program + g92) + origin + tool. The rotation acts on X
    /// and Y alone, not on U and V.
    #[must_use]
    pub fn to_machine(&self, program: &Pose) -> Pose {
        let mut local = *program;
        for (at, g92) in local.0.iter_mut().zip(self.g92.0) {
            *at += g92;
        }
        let mut machine = turned(local, self.work.rotation);
        for ((at, origin), tool) in machine.0.iter_mut().zip(self.work.origin.0).zip(self.tool.0) {
            *at = *at + origin + tool;
        }
        machine
    }

    /// The program position of a machine position, the reverse of [`ActiveOffsets::to_machine`].
    #[must_use]
    pub fn to_program(&self, machine: &Pose) -> Pose {
        let turned_local =
            Pose(std::array::from_fn(|axis| machine.0[axis] - self.tool.0[axis] - self.work.origin.0[axis]));
        let local = turned(turned_local, -self.work.rotation);
        Pose(std::array::from_fn(|axis| local.0[axis] - self.g92.0[axis]))
    }
}

/// The pose turned about Z; the angle in degrees.
fn turned(mut pose: Pose, angle: f64) -> Pose {
    if angle != 0.0 {
        let (sin, cos) = sin_cos(angle.to_radians());
        let (x, y) = (pose.get(Axis::X), pose.get(Axis::Y));
        pose.set(Axis::X, x * cos - y * sin);
        pose.set(Axis::Y, x * sin + y * cos);
    }
    pose
}

/// What a var file holds of coordinate systems.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Offsets {
    /// Origin and rotation of each system, in the order of [`System::ALL`].
    pub systems: [WorkOffset; 9],
    /// The system that is active after a start.
    pub active: System,
    /// The axis offsets of G92 and G52, in force or not.
    pub g92: Pose,
    /// True where [`Offsets::g92`] is in force.
    pub g92_on: bool,
    /// The machine position of G28.
    pub g28: Pose,
    /// The machine position of G30.
    pub g30: Pose,
}

/// What a parameter measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Measure {
    Length,
    Angle,
}

impl Offsets {
    /// One system's origin and rotation.
    #[must_use]
    pub const fn system(&self, system: System) -> &WorkOffset {
        &self.systems[system as usize]
    }

    /// The frame of the active system with a tool offset, G92 in it where it is on.
    #[must_use]
    pub fn frame(&self, tool: Pose) -> ActiveOffsets {
        let g92 = if self.g92_on { self.g92 } else { Pose::default() };
        ActiveOffsets { work: *self.system(self.active), g92, tool }
    }

    /// Reads the offsets of a file whose lengths are in the machine's unit. A parameter that the file does not hold is
    /// 0. What is found besides: a caution where parameter 5220 is missing or no whole number from 1 to 9, which means
    /// system 1.
    #[must_use]
    pub fn read(file: &VarFile, unit: LengthUnit) -> (Self, Vec<Finding>) {
        let mut offsets = Self::default();
        offsets.each(&mut |number, measure, value| {
            let held = file.get(number).unwrap_or(0.0);
            // Adding 0 takes the sign of a negative zero away.
            *value = 0.0 + if measure == Measure::Length { unit.to_mm(held) } else { held };
        });
        offsets.g92_on = file.get(G92_SWITCH).unwrap_or(0.0) != 0.0;
        let active = file.get(ACTIVE);
        let system = System::ALL.into_iter().find(|system| active == Some(f64::from(system.number())));
        offsets.active = system.unwrap_or_default();
        let findings = if system.is_none() { vec![no_active_system(active)] } else { Vec::new() };
        (offsets, findings)
    }

    /// Writes the offsets into a file whose lengths are in the machine's unit. Only what differs from the file is set,
    /// so that all other digits stay as they are; parameters that are not named here are left alone.
    ///
    /// # Errors
    /// For a value that is not finite or too great for the file; nothing is written then.
    pub fn write(&self, file: &mut VarFile, unit: LengthUnit) -> Result<(), Unfit> {
        let mut changed = file.clone();
        let mut before = Vec::new();
        Self::read(file, unit).0.each(&mut |_, _, value| before.push(*value));
        let mut before = before.into_iter();
        let mut all = Ok(());
        // Each visits by a mutable reference; the copy is what it may touch.
        let mut copy = *self;
        copy.each(&mut |number, measure, value| {
            if before.next() != Some(*value) && all.is_ok() {
                let held = if measure == Measure::Length { unit.from_mm(*value) } else { *value };
                all = changed.set(number, held);
            }
        });
        all?;
        changed.set(ACTIVE, f64::from(self.active.number()))?;
        if self.g92_on != (file.get(G92_SWITCH).unwrap_or(0.0) != 0.0) {
            changed.set(G92_SWITCH, f64::from(u8::from(self.g92_on)))?;
        }
        *file = changed;
        Ok(())
    }

    /// Visits every length and angle with the number of its parameter, always in the same order.
    fn each(&mut self, visit: &mut dyn FnMut(u32, Measure, &mut f64)) {
        let mut pose = |first: u32, pose: &mut Pose| {
            for ((axis, value), number) in Axis::ALL.into_iter().zip(&mut pose.0).zip(first..) {
                visit(number, if axis.rotary() { Measure::Angle } else { Measure::Length }, value);
            }
        };
        pose(G28_FIRST, &mut self.g28);
        pose(G30_FIRST, &mut self.g30);
        pose(G92_FIRST, &mut self.g92);
        for (system, work) in System::ALL.into_iter().zip(&mut self.systems) {
            pose(system.first_parameter(), &mut work.origin);
        }
        for (system, work) in System::ALL.into_iter().zip(&mut self.systems) {
            visit(system.rotation_parameter(), Measure::Angle, &mut work.rotation);
        }
    }
}

fn no_active_system(held: Option<f64>) -> Finding {
    match held {
        None => NoActiveSystemGiven {}.at(Place::File),
        Some(value) => ActiveSystemNotOne {}.at(Place::File).with(shown(value, 6), "1 … 9"),
    }
}
