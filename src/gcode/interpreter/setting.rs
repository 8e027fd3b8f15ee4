//! What a program is read with: control, machine unit, var file, tools, switches, budgets.

use std::collections::{BTreeMap, BTreeSet};

use crate::gcode::control::{Control, DecimalPoint, RotaryMode};
use crate::gcode::letters::Letters;
use crate::gcode::turning::nose::Nose;
use crate::machine::axis::Pose;
use crate::machine::length_unit::LengthUnit;
use crate::machine::var_file::VarFile;
use crate::text::Text;

/// A tool of the tool table; lengths in mm, angles in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ToolOffset {
    /// The offset that G43 puts into force.
    pub offset: Pose,
    /// The diameter of a mill, from which the radius compensation is made.
    pub diameter: f64,
    /// Of a turning tool its nose; `None` where the table gives none: it cannot be compensated then.
    pub nose: Option<Nose>,
    /// Of a tool for grooves the width of its blade, mm; `None` of any other, and where the table gives none.
    pub blade: Option<f64>,
}

/// The tools by their number.
pub type Tools = BTreeMap<u32, ToolOffset>;

/// Finds the files of subprograms that stand in files of their own.
pub trait Files {
    /// The text of the subprogram file with a name (without folder and ending); `None` where there is none.
    ///
    /// # Errors
    /// Where the file is there and cannot be read: the reason.
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text>;
}

/// No subprogram has a file of its own.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn find(&mut self, _name: &str) -> Result<Option<Vec<u8>>, Text> {
        Ok(None)
    }
}

/// What R of the drilling cycles of Fanuc's system A is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HolePlane {
    /// The Z of the plane, as the lathe simulator's figure has it.
    Absolute,
    /// How far the plane is from where the tool stands at the cycle, with its sign.
    Incremental,
}

/// How much a program may ask of the interpreter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Blocks executed more than once: loops and subprograms. Each block of the file may be executed once besides.
    pub repeated_blocks: u64,
    /// Calls of subprograms inside one another.
    pub call_depth: usize,
}

impl Default for Budget {
    fn default() -> Self {
        Self { repeated_blocks: 10_000_000, call_depth: 10 }
    }
}

/// How a machine stands when a program begins.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Start {
    /// Where, in machine coordinates.
    pub machine: Pose,
    /// The tool in the spindle or the turret's place at work; 0 for none.
    pub tool: u32,
    /// Of a lathe, the number of the tool offset in force; 0 for none. It must be in the tool table.
    pub offset: u32,
}

/// What a program is read with.
pub struct Setting {
    /// The control whose program it is.
    pub control: &'static Control,
    /// The machine's unit: of the var file, of parameters that hold lengths, and of a program that does not say its own.
    pub unit: LengthUnit,
    /// How the machine stands at the start.
    pub start: Start,
    /// The control's parameters at the start.
    pub var_file: VarFile,
    /// The tool table; `None` where it is not known: every tool is then taken as one of length 0, and said so.
    pub tools: Option<Tools>,
    /// The offsets of the tools that the program's own header names: no table is asked for where they are called.
    pub headed: BTreeSet<u32>,
    /// The places of a turret, where they are known beside the table, whose numbers are then those of the offsets alone.
    pub places: Option<BTreeSet<u32>>,
    /// The letters of the axes that a lathe has; `None` where the machine is not known.
    pub axes: Option<Letters>,
    /// Of a lathe the rapid rates of X (of the slide, so of the radius) and Z, mm/min; `None` where the machine is not known.
    pub rapid: Option<[f64; 2]>,
    /// The maximum speed of a lathe's spindle, rpm; `None` where the machine is not known.
    pub greatest_speed: Option<f64>,
    /// What a dimension without a decimal point is; where it is not known a lathe program that has one is refused.
    pub decimal_point: Option<DecimalPoint>,
    /// What R of a lathe's drilling cycles is; where it is not known it is taken as absolute, and said so.
    pub hole_plane: Option<HolePlane>,
    /// What an absolute word of a rotary axis means.
    pub rotary: RotaryMode,
    /// Blocks that begin with `/` are skipped.
    pub block_delete: bool,
    /// G92 and G52 outlive the program; else they are cleared at its start and its end.
    pub keep_g92: bool,
    /// The text is a part of a program: it needs no end.
    pub part: bool,
    /// Subprograms in files of their own.
    pub files: Box<dyn Files>,
    /// How many repeated blocks and calls the program may ask for.
    pub budget: Budget,
}

impl Setting {
    /// A control with nothing else known: millimetres, all offsets 0, no tool table, rotary axes as the control is delivered.
    #[must_use]
    pub fn new(control: &'static Control) -> Self {
        Self {
            control,
            unit: LengthUnit::Millimetre,
            start: Start::default(),
            var_file: VarFile::default(),
            tools: None,
            headed: BTreeSet::new(),
            places: None,
            axes: None,
            rapid: None,
            greatest_speed: None,
            decimal_point: None,
            hole_plane: None,
            rotary: control.rotary.delivered,
            block_delete: false,
            keep_g92: true,
            part: false,
            files: Box::new(NoFiles),
            budget: Budget::default(),
        }
    }
}
