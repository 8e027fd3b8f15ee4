//! What a workbook asks of a clear cut.
//!
//! # Units
//! Millimetres.

use crate::gcode::word::Word;
use crate::kinds::impeller::clear::cut::{CutStrategy, Job, Spindle};
use crate::kinds::impeller::clear::fields::{self, Method};
use crate::kinds::impeller::clear::holder::Stage;
use crate::kinds::impeller::clear::tool::Tool;
use crate::kinds::impeller::design::Design;
use crate::kinds::impeller::part::Part;
use crate::machine::axis::Axis;
use crate::parameter::field::Fields;

/// ε where the workbook states none.
pub const TOLERANCE: f64 = 0.01;

/// A tool with its feed and speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mill {
    /// T, its number in the magazine, as the programs call it.
    pub T: u32,
    /// D, the number of its offset.
    pub D: u32,
    /// d_t or d_f, its diameter, mm.
    pub d: f64,
    /// F, feed of the tip over the part, mm/min.
    pub F: Option<f64>,
    /// S, spindle speed, rpm.
    pub S: Option<u32>,
}

/// The cells of the clear cut, with defaults filled in. Lengths in mm.
#[derive(Clone, Debug)]
pub struct ClearCells {
    /// The cut. Its tolerance is what is left of ε beside what rounding to the output grid takes.
    pub cut: CutStrategy,
    /// ε as the form has it, mm: [`TOLERANCE`] where its cell is empty.
    pub tolerance: f64,
    /// The finishing tool: with diameter, T and D of the roughing one where d_f is not given.
    pub finish: Mill,
    /// d_f, T_f and D_f as they stand in the form.
    pub given: (Option<f64>, Option<u32>, Option<u32>),
    /// r_cf as it stands there.
    pub given_corner: Option<f64>,
    /// h_r, the height of rest that is allowed in the corners; `None` where it is not asked about.
    pub root: Option<f64>,
}

impl ClearCells {
    /// What a workbook asks; `None` where the part is cut as published. `plain` is the rest of the design.
    #[must_use]
    pub(in crate::kinds::impeller) fn of(fields: &Fields, plain: &Design) -> Option<Self> {
        match fields.get(&fields::METHOD) {
            Method::Published => return None,
            Method::Clear => {}
        }
        let given = (fields.get(&fields::D_F), fields.get(&fields::T_F), fields.get(&fields::OFFSET_F));
        let finish = Mill {
            T: given.1.filter(|_| given.0.is_some()).unwrap_or(plain.T),
            D: given.2.filter(|_| given.0.is_some()).unwrap_or(plain.D),
            d: given.0.unwrap_or(plain.d_t),
            F: fields.get(&fields::F_F).or(plain.F),
            S: fields.get(&fields::S_F).or(plain.S),
        };
        let tolerance = plain.tol.unwrap_or(TOLERANCE);
        let (r_c, r_cf) = (fields.get(&fields::CORNER), fields.get(&fields::CORNER_F));
        let counterclockwise = plain.start_codes.contains(&Word::whole('M', 4));
        let stick_out = fields.get(&fields::STICK_OUT);
        // One tool for both sticks out alike.
        let alike = stick_out.filter(|_| given.0.is_none());
        // A holder is of any width where its diameter is not given, and not known where its tool's stick-out is not.
        let radius = fields.get(&fields::HOLDER).map_or(f64::INFINITY, |d_h| d_h / 2.0);
        let stages = [stick_out, fields.get(&fields::STICK_OUT_F).or(alike)];
        let stages = stages.map(|from| from.map(|from| Stage { radius, from }));
        let cut = CutStrategy {
            rough: Tool { d: plain.d_t, r_c },
            finish: Tool { d: finish.d, r_c: if given.0.is_some() { r_cf.unwrap_or(0.0) } else { r_c } },
            s: fields.get(&fields::ALLOWANCE),
            level: fields.get(&fields::LEVEL),
            step: fields.get(&fields::STEP),
            scallop: fields.get(&fields::SCALLOP),
            tolerance: tolerance - plain.machine.rounding(plain.torus.R),
            feed: fields.get(&fields::FEED_CHANGE),
            d_s: plain.d_s,
            blank: plain.blank.L_b,
            spindle: if counterclockwise { Spindle::Counterclockwise } else { Spindle::Clockwise },
            partly: fields.get(&fields::PARTLY),
            splitters: plain.splitters,
            splitter_from: None,
            stages,
            tilt: plain.travel.iter().find(|one| one.axis == Axis::B).map_or([None; 2], |one| one.ends),
        };
        let root = fields.get(&fields::ROOT);
        Some(Self { cut, tolerance, finish, given, given_corner: r_cf, root })
    }
}

impl Job {
    /// The blades of a design and the machine that cuts them.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        Self { part: Part::new(design), N: design.N, machine: design.machine }
    }
}
