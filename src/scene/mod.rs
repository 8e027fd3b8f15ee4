//! What is shown.

mod column;
pub mod kept;
pub mod mesh;
pub mod part;
pub mod program;
pub mod rules;
pub mod turning;

use serde::Serialize;

use super::scene::mesh::{Mesh, Paint};
use super::scene::program::Program;
use crate::finding::{Finding, Grade, Place};
use crate::gcode::in_force::{Compensation, InForce, Speed, Spindle};
use crate::gcode::motion::FeedMode;
use crate::machine::length_unit::LengthUnit;
use crate::text::{Language, Text};

/// Everything that one file shows.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Scene {
    /// What is shown: a part's name, or a file's.
    pub title: String,
    /// The language that the page begins in.
    pub language: Language,
    /// The part and what stands about it.
    pub meshes: Vec<Mesh>,
    /// Lines on the part.
    pub curves: Vec<Curve>,
    /// The programs, of which one is shown at a time.
    pub programs: Vec<Program>,
}

impl Scene {
    /// The scene under a title, in the language that its page begins in.
    #[must_use]
    pub fn titled(self, title: String, language: Language) -> Self {
        Self { title, language, ..self }
    }
}

/// A polyline in space.
#[derive(Clone, Debug, Serialize)]
pub struct Curve {
    /// What it is.
    pub name: Text,
    /// Its colour.
    pub paint: Paint,
    /// Its points, mm.
    #[serde(serialize_with = "column::points")]
    pub points: Vec<[f64; 3]>,
}

/// What is in force during motions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct State {
    /// The tool in the spindle, or the turret's place at work; 0 for none.
    pub tool: u32,
    /// The offset in force; 0 for none.
    pub offset: u32,
    /// 0 stopped, 1 clockwise (M3), 2 counter-clockwise (M4).
    pub spindle: u8,
    /// Revolutions per minute, or with `surface` metres per minute.
    pub speed: f64,
    /// S is a surface speed (G96).
    pub surface: bool,
    /// The greatest speed that the program allows, rpm.
    pub greatest: Option<f64>,
    /// The coolant runs.
    pub coolant: bool,
    /// The work offset: 1 for G54, to 9 for G59.3.
    pub system: u8,
    /// What F means: 0 per minute, 1 per revolution, 2 inverse time, 3 seconds.
    pub feed: u8,
    /// The program counts in inches.
    pub inch: bool,
    /// Nose radius compensation: 40, 41 or 42.
    pub compensation: u8,
    /// What is added to program coordinates to stand on the part, mm: see [`Program::shift`].
    pub shift: [f64; 3],
}

impl From<&InForce> for State {
    fn from(control: &InForce) -> Self {
        let (speed, surface) = match control.speed {
            Speed::Revolutions(speed) => (speed, false),
            Speed::Surface(speed) => (speed, true),
        };
        Self {
            tool: control.tool,
            offset: control.offset,
            spindle: match control.spindle {
                Spindle::Stopped => 0,
                Spindle::Clockwise => 1,
                Spindle::CounterClockwise => 2,
            },
            speed,
            surface,
            greatest: control.greatest_speed,
            coolant: control.coolant,
            system: control.system,
            feed: match control.feed_mode {
                FeedMode::PerMinute => 0,
                FeedMode::PerRevolution => 1,
                FeedMode::InverseTime => 2,
                FeedMode::Seconds => 3,
            },
            inch: control.unit == LengthUnit::Inch,
            compensation: match control.compensation {
                Compensation::Off => 40,
                Compensation::Left => 41,
                Compensation::Right => 42,
            },
            shift: [0.0; 3],
        }
    }
}

/// A tool's form.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Shape {
    /// Turned about its axis: radius and height above the tip, from the tip upwards; mm.
    Revolved(Vec<[f64; 2]>),
    /// A torch: the same, and short enough for cameras to take it in whole.
    Torch(Vec<[f64; 2]>),
    /// The same with its holder.
    Held {
        /// What cuts, with its shank.
        cutting: Vec<[f64; 2]>,
        /// The holder behind it.
        holder: Vec<[f64; 2]>,
    },
    /// A plate in the plane of a turning machine: outlines as (z, x) from the programmed point; mm.
    Flat {
        /// What cuts, in one or more parts.
        cutting: Vec<Vec<[f64; 2]>>,
        /// The holder, in one or more parts.
        holder: Vec<Vec<[f64; 2]>>,
        /// What of the turret moves with it and must touch nothing.
        turret: Vec<Vec<[f64; 2]>>,
    },
}

/// A tool.
#[derive(Clone, Debug, Serialize)]
pub struct ShownTool {
    /// Its number, or the turret's place; the first of the list also stands for numbers that are not in it.
    pub number: u32,
    /// What it is.
    pub name: Text,
    /// Its form.
    pub shape: Shape,
}

/// A finding or alarm of a program.
#[derive(Clone, Debug, Serialize)]
pub struct Remark {
    /// How grave.
    pub grade: Grade,
    /// The code by which `rodete explain` knows it.
    pub code: &'static str,
    /// The alarm's number, where it has one.
    pub number: Option<u32>,
    /// What.
    pub what: Text,
    /// The value found and the limit, with units; empty where there are none.
    pub value: String,
    /// The limit.
    pub limit: String,
    /// What to do about it.
    pub remedy: Text,
    /// The line of the program, counted from 1.
    pub line: Option<usize>,
    /// The motion, counted from 0, where one is meant that is not the line's first.
    pub motion: Option<usize>,
    /// Of a turning's alarm where it is, X as a diameter and Z in program coordinates, mm.
    pub at: Option<[f64; 2]>,
    /// Its value is how deep something goes in.
    pub deep: bool,
}

impl From<&Finding> for Remark {
    fn from(finding: &Finding) -> Self {
        let what = match &finding.place {
            // A line of another file is none of the program's.
            Place::Subprogram { file, line, .. } => {
                let told = |what: &str| format!("{file}:{line}: {what}");
                Text::new(told(&finding.what.es), told(&finding.what.en))
            }
            _ => finding.what.clone(),
        };
        Self {
            grade: finding.grade,
            code: finding.code(),
            number: None,
            what,
            value: finding.value.clone(),
            limit: finding.limit.clone(),
            remedy: finding.remedy.clone(),
            line: match finding.place {
                Place::Block { line, .. } | Place::Line { line, .. } => Some(line),
                _ => None,
            },
            motion: None,
            at: None,
            deep: false,
        }
    }
}
