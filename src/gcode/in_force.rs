//! What a control has in force while it makes a motion, beside the motion itself.

use crate::gcode::motion::FeedMode;
use crate::machine::length_unit::LengthUnit;

/// Which way the spindle turns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Spindle {
    /// Not at all (M5, and at the start).
    #[default]
    Stopped,
    /// M3.
    Clockwise,
    /// M4.
    CounterClockwise,
}

impl Spindle {
    /// The word that makes it so.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::Stopped => "M5",
            Self::Clockwise => "M3",
            Self::CounterClockwise => "M4",
        }
    }
}

/// What S means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speed {
    /// G97: revolutions per minute.
    Revolutions(f64),
    /// G96: surface speed in m/min; the spindle turns at 1000 V / (π d) at the diameter d of the programmed point, mm.
    Surface(f64),
}

impl Default for Speed {
    fn default() -> Self {
        Self::Revolutions(0.0)
    }
}

/// On which side of the programmed path the nose of the tool is kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Compensation {
    /// G40: the programmed point runs along the path.
    #[default]
    Off,
    /// G41: left of the path, seen along it.
    Left,
    /// G42: right of the path.
    Right,
}

/// What is in force when a motion is made, beside where the axes stand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InForce {
    /// The tool in the spindle, or the turret's place at work; 0 for none.
    pub tool: u32,
    /// The number of the offset in force; 0 for none.
    pub offset: u32,
    /// A tool length offset is in force (G43), whatever its length.
    pub lengthened: bool,
    /// Which way the spindle turns.
    pub spindle: Spindle,
    /// What S says.
    pub speed: Speed,
    /// The greatest speed that the program allows the spindle, rpm (G50 or G92 with S).
    pub greatest_speed: Option<f64>,
    /// The coolant runs (M7, M8).
    pub coolant: bool,
    /// The work offset in force: 1 for G54, to 9 for G59.3.
    pub system: u8,
    /// What F means.
    pub feed_mode: FeedMode,
    /// The program's unit of length.
    pub unit: LengthUnit,
    /// Nose or cutter radius compensation.
    pub compensation: Compensation,
    /// The motion goes to the intermediate point of a lathe's return to reference (G28, G30), and not yet from there.
    pub to_intermediate: bool,
    /// Where the block stands: 0 in the program itself, else in a subprogram's own file; see
    /// [`Interpreter::file`](crate::gcode::interpreter::Interpreter::file).
    pub file: usize,
}
