//! The design of an impeller: validated parameters with units settled, and the checks of one against another.

use crate::finding::Finding;
use crate::gcode::control::{Post, RotaryMode};
use crate::gcode::fields::{TOOL_CHANGE, rapids};
pub use crate::gcode::program::Style;
use crate::gcode::word::{Distance, Retract, Word};
use crate::geometry::torus::Torus;
use crate::kinds::impeller::blank::BlankTurning;
use crate::kinds::impeller::clear::asked::{ClearCells, Mill};
use crate::kinds::impeller::clear::cut::Which;
use crate::kinds::impeller::clear::fields as cut;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::parameters as form;
use crate::kinds::impeller::tool_path::half_width;
use crate::machine::axis::Axis;
use crate::machine::calibration::Slots;
use crate::machine::rapids::Rapids;
use crate::machine::rotary::TiltingTable;
use crate::machine::travel::AxisTravel;
use crate::parameter::field::{Field, Fields, Optional};

/// A design that may be computed. Lengths in mm, angles of B in degrees (as programmed).
#[derive(Clone, Debug)]
pub struct Design {
    /// R and r.
    pub torus: Torus,
    /// n, intervals of the blade from hub to rim: n + 1 points.
    pub n: usize,
    /// Back-off of the last point, steps.
    pub eps_v: f64,
    /// N, how many blades.
    pub N: u32,
    /// e, blade thickness.
    pub e: f64,
    /// a_p, depth of cut.
    pub a_p: f64,
    /// Splitter blades are wanted.
    pub splitters: bool,
    /// Up to which point each side of a splitter fades.
    pub splitter_fade: Fade,
    /// d_t, tool diameter.
    pub d_t: f64,
    /// T, tool number.
    pub T: u32,
    /// D, offset number.
    pub D: u32,
    /// R_B, height of the work spindle's nose over the B axis.
    pub R_B: f64,
    /// H, height of the torus centre plane, the turned face, over that nose.
    pub H: f64,
    /// The rotary axes with L = R_B + H.
    pub machine: TiltingTable,
    /// Travel of X, Y, Z in mm and of B in degrees.
    pub travel: [AxisTravel; 4],
    /// F_max, greatest speed of an axis, mm/min or °/min.
    pub F_max: Option<f64>,
    /// How fast the machine is where it does not cut.
    pub rapids: Rapids,
    /// d_s, safety distance.
    pub d_s: f64,
    /// F, feed of the tip over the part, mm/min.
    pub F: Option<f64>,
    /// S, spindle speed, rpm.
    pub S: Option<u32>,
    /// tol, tolerance of the tip path between blocks.
    pub tol: Option<f64>,
    /// The part's name.
    pub part: String,
    /// The material, as typed; empty where the cell is.
    pub material: String,
    /// The program number, of a clear cut that of the roughing program.
    pub program: u32,
    /// The control that the programs are written for.
    pub post: Post,
    /// `annex`: blocks as published; `full`: complete programs.
    pub style: Style,
    /// Absolute or incremental, in full style.
    pub distance: Distance,
    /// How the machine's rotary axes count in G90, as the workbook says or, where it does not, as the control is delivered.
    pub counting: RotaryMode,
    /// M codes at the start, before anything cuts: the spindle, the clamps of the axes.
    pub start_codes: Vec<Word>,
    /// M codes for coolant.
    pub coolant: Vec<Word>,
    /// The block that takes the tool away before anything turns; empty where there is none.
    pub retract: Retract,
    /// M codes at the end, M30 as published.
    pub end_codes: Vec<Word>,
    /// By how much block numbers grow from block to block.
    pub block_step: u32,
    /// The turning of the blank, in a program of its own.
    pub blank: BlankTurning,
    /// The workbook says by which method it is cut.
    pub method_given: bool,
    /// What the clear cut is asked for; `None` where the part is cut as published.
    pub clear: Option<ClearCells>,
    /// The calibration, if asked for.
    pub calibration: Option<Slots>,
}

impl Design {
    /// Z_r, the retract height: what no part within R of the axis reaches at any B, and d_s more; rounded up, mm.
    #[must_use]
    pub fn retract_height(&self) -> f64 {
        ((self.machine.swing(self.torus.R) + self.d_s) * 1000.0).ceil() / 1000.0
    }

    /// w = (e + d_t)/2.
    #[must_use]
    pub fn w(&self) -> f64 {
        half_width(self.e, self.d_t)
    }

    /// A tool with its feed and speed: the finishing one is the roughing one where there is no other.
    #[must_use]
    pub fn mill(&self, which: Which) -> Mill {
        let own = Mill { T: self.T, D: self.D, d: self.d_t, F: self.F, S: self.S };
        self.clear.as_ref().filter(|_| which == Which::Finish).map_or(own, |asked| asked.finish)
    }

    /// The number of a milling program: of a clear cut the finishing program has the one after the form's.
    #[must_use]
    pub const fn number(&self, which: Which) -> u32 {
        match which {
            Which::Rough => self.program,
            Which::Finish => self.program + 1,
        }
    }

    /// How much of the tool over its tip is looked at, mm: from a tip within d_s of the stock no longer tool reaches more
    /// of it, for no two points of the stock are farther apart than 2·R + L_b. How long the tool is, is not asked.
    #[must_use]
    pub const fn tool_reach(&self) -> f64 {
        2.0 * (self.torus.R + self.d_s) + self.blank.L_b
    }

    /// True where a complete program says every turn as an increment and where to begin by angles inside a turn, which holds
    /// whether the rotary axes are rollover or not.
    #[must_use]
    pub fn turns_by_increments(&self) -> bool {
        let may_roll = self.post.control.rotary.delivered.rolls_over();
        self.style == Style::Full && self.distance == Distance::Incremental && may_roll
    }

    /// The design of checked values.
    ///
    /// # Errors
    /// Every check of one value against another that fails, as findings on parameters (the caller turns them into cells).
    pub fn new(fields: &Fields) -> Result<Self, Vec<Finding>> {
        let design = Self::of(fields);
        let findings = design.contradictions();
        if findings.is_empty() { Ok(design) } else { Err(findings) }
    }

    fn of(fields: &Fields) -> Self {
        let (R_B, H) = (fields.get(&form::R_B), fields.get(&form::H));
        let post = fields.get(&form::DIALECT);
        let linear = |axis, ends: [&'static Field<f64, Optional>; 2]| AxisTravel {
            axis,
            ends: ends.map(|end| fields.get(end)),
            keys: ends.map(Field::key),
        };
        let plain = Self {
            torus: Torus { R: fields.get(&form::R), r: fields.get(&form::MERIDIAN_R) },
            n: fields.get(&form::INTERVALS_N) as usize,
            eps_v: fields.get(&form::EPS_V),
            N: fields.get(&form::N),
            e: fields.get(&form::E),
            a_p: fields.get(&form::A_P),
            splitters: fields.get(&form::SPLITTERS),
            splitter_fade: fields.get(&form::SPLITTER_FADE),
            d_t: fields.get(&form::D_T),
            T: fields.get(&form::T),
            D: fields.get(&form::D),
            R_B,
            H,
            machine: TiltingTable { L: R_B + H },
            travel: [
                linear(Axis::X, [&form::X_MIN, &form::X_MAX]),
                linear(Axis::Y, [&form::Y_MIN, &form::Y_MAX]),
                linear(Axis::Z, [&form::Z_MIN, &form::Z_MAX]),
                AxisTravel {
                    axis: Axis::B,
                    ends: [&form::B_MIN, &form::B_MAX].map(|end| Some(fields.get(end))),
                    keys: [form::B_MIN.key(), form::B_MAX.key()],
                },
            ],
            F_max: fields.get(&form::F_MAX),
            rapids: Rapids { tool_change: fields.get(&TOOL_CHANGE), ..rapids(fields) },
            d_s: fields.get(&form::D_S),
            F: fields.get(&form::F),
            S: fields.get(&form::S),
            tol: fields.get(&form::TOL),
            part: fields.get(&form::PART),
            material: fields.get(&form::MATERIAL).unwrap_or_default(),
            program: fields.get(&form::NUMBER),
            post,
            counting: fields.get(&form::ROTARY).unwrap_or(post.control.rotary.delivered),
            style: fields.get(&form::STYLE),
            distance: fields.get(&form::DISTANCE),
            start_codes: fields.get(&form::START_CODES).0,
            coolant: fields.get(&form::COOLANT).unwrap_or_default().0,
            retract: fields.get(&form::RETRACT).unwrap_or_default(),
            end_codes: fields.get(&form::END_CODES).0,
            block_step: fields.get(&form::BLOCK_STEP),
            blank: BlankTurning::of(fields),
            method_given: fields.values().values.contains_key(cut::METHOD.row.key),
            clear: None,
            calibration: Self::slots(fields),
        };
        Self { clear: ClearCells::of(fields, &plain), ..plain }
    }

    fn slots(fields: &Fields) -> Option<Slots> {
        Some(Slots {
            H: fields.get(&form::CALIBRATION_H)?,
            d_w: fields.get(&form::CALIBRATION_D_W)?,
            e_z: fields.get(&form::CALIBRATION_E_Z)?,
            e_x: fields.get(&form::CALIBRATION_E_X)?,
            d_t: fields.get(&form::CALIBRATION_D_T)?,
            x0: fields.get(&form::CALIBRATION_X0)?,
            z0: fields.get(&form::CALIBRATION_Z0)?,
        })
    }
}
