//! The design of an impeller: validated parameters with units settled, and the checks of one against another.

use crate::finding::{Finding, Place};
use crate::gcode::control::{Control, Rotary as Counting};
pub use crate::gcode::program::Style;
use crate::gcode::word::{Distance, Word, block, codes};
use crate::geometry::torus::Torus;
use crate::kinds::impeller::blank::BlankTurning;
use crate::kinds::impeller::fade::Fade;
use crate::kinds::impeller::tool_path::half_width;
use crate::machine::calibration::Slots;
use crate::machine::rotary::Rotary;
use crate::machine::travel::Travel;
use crate::parameter::Values;
use crate::text::Text;

/// A design that may be computed. Lengths in mm, angles of B in degrees (as programmed).
#[derive(Clone, Debug)]
pub struct Design {
    /// R and r.
    pub torus: Torus,
    /// n, intervals.
    pub n: usize,
    /// Back-off of the last point, steps.
    pub eps_v: f64,
    /// N, blades.
    pub N: u32,
    /// e, blade thickness.
    pub e: f64,
    /// a_p, depth of cut.
    pub a_p: f64,
    /// Splitter blades are wanted.
    pub splitters: bool,
    /// How splitters fade.
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
    pub machine: Rotary,
    /// Travel of X, Y, Z in mm and of B in degrees.
    pub travel: [(char, Travel); 4],
    /// F_max, greatest speed of an axis, mm/min or °/min.
    pub F_max: Option<f64>,
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
    /// The material.
    pub material: String,
    /// The program number.
    pub program: u32,
    /// The dialect.
    pub control: &'static Control,
    /// The style.
    pub style: Style,
    /// Absolute or incremental, in full style.
    pub distance: Distance,
    /// How the machine's rotary axes count in G90, as the workbook says or, where it does not, as the control is delivered.
    pub counting: Counting,
    /// M codes at the start.
    pub start_codes: Vec<Word>,
    /// M codes for coolant.
    pub coolant: Vec<Word>,
    /// The block that takes the tool away before anything turns; empty where there is none.
    pub retract: Vec<Word>,
    /// M codes at the end.
    pub end_codes: Vec<Word>,
    /// Step of the block numbers.
    pub block_step: u32,
    /// The turning of the blank.
    pub blank: BlankTurning,
    /// The calibration, if asked for.
    pub calibration: Option<Slots>,
}

impl Design {
    /// w = (e + d_t)/2.
    #[must_use]
    pub fn w(&self) -> f64 {
        half_width(self.e, self.d_t)
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
        let may_roll = self.control.rotary.delivered == Counting::Rollover;
        self.style == Style::Full && self.distance == Distance::Incremental && may_roll
    }

    /// The design of checked values.
    ///
    /// # Errors
    /// Every check of one value against another that fails, as findings on parameters (the caller turns them into
    /// cells). Values that are missing though required are taken as a refusal of the schema before and reported again
    /// here as one finding, so that no caller can get by without the schema.
    pub fn new(values: &Values) -> Result<Self, Vec<Finding>> {
        let Some(design) = Self::from_values(values) else {
            return Err(vec![Finding::stop(
                Place::File,
                Text::fixed("faltan valores obligatorios", "required values are missing"),
                Text::fixed("rellene las celdas obligatorias", "fill in the required cells"),
            )]);
        };
        let findings = design.contradictions();
        if findings.is_empty() { Ok(design) } else { Err(findings) }
    }

    fn from_values(values: &Values) -> Option<Self> {
        let real = |key| values.real(key);
        let (R_B, H) = (real("R_B")?, real("H")?);
        let dialect = Control::milling(values.choice("dialect")?)?;
        Some(Self {
            torus: Torus { R: real("R")?, r: real("r")? },
            n: usize::try_from(values.whole("n")?).ok()?,
            eps_v: real("eps_v")?,
            N: values.whole("N")?,
            e: real("e")?,
            a_p: real("a_p")?,
            splitters: values.choice("splitters")? == "yes",
            splitter_fade: if values.choice("splitter_fade") == Some("each-side") {
                Fade::EachSide
            } else {
                Fade::Published
            },
            d_t: real("d_t")?,
            T: values.whole("T")?,
            D: values.whole("D")?,
            R_B,
            H,
            machine: Rotary { L: R_B + H },
            travel: [
                ('X', [real("X_min"), real("X_max")]),
                ('Y', [real("Y_min"), real("Y_max")]),
                ('Z', [real("Z_min"), real("Z_max")]),
                ('B', [real("B_min"), real("B_max")]),
            ],
            F_max: real("F_max"),
            d_s: real("d_s")?,
            F: real("F"),
            S: values.whole("S"),
            tol: real("tol"),
            part: values.line("part").to_owned(),
            material: values.line("material").to_owned(),
            program: values.whole("program")?,
            control: dialect,
            counting: match values.choice("rotary") {
                Some("linear") => Counting::Linear,
                Some(_) => Counting::Rollover,
                None => dialect.rotary.delivered,
            },
            style: if values.choice("style")? == "full" { Style::Full } else { Style::Annex },
            distance: if values.choice("distance")? == "G91" { Distance::Incremental } else { Distance::Absolute },
            start_codes: codes(values.line("start_codes"))?,
            coolant: codes(values.line("coolant"))?,
            retract: block(values.line("retract"))?,
            end_codes: codes(values.line("end_codes"))?,
            block_step: values.whole("block_step")?,
            blank: BlankTurning::from_values(values)?,
            calibration: Self::slots(values),
        })
    }

    fn slots(values: &Values) -> Option<Slots> {
        let real = |key| values.real(key);
        Some(Slots {
            H: real("calibration/H")?,
            d_w: real("calibration/d_w")?,
            e_z: real("calibration/e_z")?,
            e_x: real("calibration/e_x")?,
            d_t: real("calibration/d_t")?,
            x0: real("calibration/x0")?,
            z0: real("calibration/z0")?,
        })
    }
}
