//! Where a pose of the axes stands on the part.

use nalgebra::Vector3;

use crate::machine::axis::{Axis, Pose};
use crate::machine::rotary::TiltingTable;
use crate::machine::torch::TorchAxes;

/// How the axes of a program bring the tool to the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Chain {
    /// X, Y and Z are coordinates of the part, and the tool stands along Z.
    Milling,
    /// The same with X as a radius: it is shown as a diameter, and the part turns about Z.
    Turning,
    /// C turns the part and B tilts it: see [`TiltingTable`].
    Tilting(TiltingTable),
    /// A torch over a turning pipe: see [`TorchAxes`].
    Torch,
    /// A torch square to a turning pipe of this radius, mm, with axes A and X.
    Pipe(f64),
}

/// A tool on the part: its point, mm, and the direction from there along its axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stand {
    pub(crate) point: Vector3<f64>,
    pub(crate) axis: Vector3<f64>,
}

impl Chain {
    /// True where a straight motion of the axes is straight on the part, and X, Y, Z are its coordinates.
    pub(crate) const fn straight(self) -> bool {
        matches!(self, Self::Milling | Self::Turning)
    }

    /// Where the tool stands in a pose.
    pub(crate) fn stand(self, pose: &Pose) -> Stand {
        let at = |axis: Axis| pose.get(axis);
        let turn = |axis: Axis| pose.get(axis).to_radians();
        let torch = |axes: TorchAxes| {
            let pose = axes.pose();
            Stand { point: pose.tip, axis: pose.axis }
        };
        match self {
            Self::Milling | Self::Turning => {
                Stand { point: Vector3::new(at(Axis::X), at(Axis::Y), at(Axis::Z)), axis: Vector3::z() }
            }
            Self::Tilting(machine) => {
                let (B, C) = (turn(Axis::B), turn(Axis::C));
                let point = Vector3::new(at(Axis::X), at(Axis::Y), at(Axis::Z));
                Stand {
                    point: machine.to_part(&point, B, C),
                    axis: TiltingTable::direction_to_part(&Vector3::z(), B, C),
                }
            }
            Self::Torch => torch(TorchAxes {
                A: turn(Axis::A),
                X: at(Axis::X),
                Z: at(Axis::Z),
                B: turn(Axis::B),
                C: turn(Axis::C),
            }),
            Self::Pipe(radius) => {
                torch(TorchAxes { A: turn(Axis::A), X: at(Axis::X), Z: radius, ..TorchAxes::default() })
            }
        }
    }
}
