//! The design of a branch pipe: validated parameters with units settled.

use crate::figure::Paper;
use crate::finding::{Finding, Key};
use crate::gcode::control::Post;
use crate::gcode::fields::rapids;
use crate::gcode::program::Style;
use crate::gcode::word::Word;
use crate::geometry::pipe_pair::PipePair;
use crate::geometry::pipe_wall::{PipeWall, Seat};
use crate::kinds::pipe::dimensions::Pipe;
use crate::kinds::pipe::form::{
    BLOCK_STEP, DIALECT, E, END_CODES, MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, THETA, TORCH_OFF, TORCH_ON,
};
use crate::kinds::pipe::insert::outline::Outline;
use crate::kinds::pipe::insert::parameters::{
    ARC_TOLERANCE, CONTACT, EXPERT_BRANCH_R, F, KERF, LEAD_IN, MODE, N, OVERCUT, R, R_DEV, SHEET, STYLE, Surface, Z,
};
pub use crate::kinds::pipe::insert::parameters::{Contact, Mode};
use crate::machine::rapids::Rapids;
use crate::parameter::field::Fields;

/// What a program may add to the tolerance of a path by the rounding of ends and radii to 0.001, mm.
pub const ROUNDING: f64 = 0.002;

/// A radius that was typed in place of the one that the pipe gives, both in mm.
#[derive(Clone, Copy, Debug)]
pub struct Typed {
    /// The parameter in whose cell it was typed.
    pub key: Key,
    /// What was typed.
    pub typed: f64,
    /// What the pipe gives.
    pub derived: f64,
}

/// A design that may be computed. Lengths in mm, θ in degrees.
#[derive(Clone, Debug)]
pub struct Design {
    /// The pipe whose end is cut.
    pub branch: Pipe,
    /// The pipe that it meets.
    pub header: Pipe,
    /// What of the branch rests on the header.
    pub contact: Contact,
    /// θ, the angle between the axes.
    pub theta: f64,
    /// e, how far the axes pass each other; signed.
    pub e: f64,
    /// Z, from the template's edge to the curve at φ = 0.
    pub Z: f64,
    /// N, divisions of the circumference.
    pub N: u32,
    /// r, the radius of the branch's curve; of the envelope, that of the bore.
    pub r: f64,
    /// R, the header's radius.
    pub R: f64,
    /// Which surface the template is developed on.
    pub sheet: Surface,
    /// The radius of the development.
    pub r_dev: f64,
    /// The radii that were typed in place of those that the pipes give.
    pub typed: Vec<Typed>,
    /// Flat or rotary.
    pub mode: Mode,
    /// The width of the cut; 0 for no compensation.
    pub kerf: f64,
    /// F, cutting speed, mm/min.
    pub F: Option<f64>,
    /// How fast the machine is where it does not cut.
    pub rapids: Rapids,
    /// How long the torch stands after it pierces, s.
    pub pierce_delay: f64,
    /// The way from the pierce to the curve.
    pub lead_in: f64,
    /// The way beyond the end of the curve.
    pub overcut: f64,
    /// How far the path may leave the exact curve.
    pub arc_tolerance: f64,
    /// The paper that the template is printed on.
    pub paper: Paper,
    /// The part's name.
    pub part: String,
    /// The material, as typed; empty where the cell is.
    pub material: String,
    /// The number in the program's header.
    pub program: u32,
    /// The control that the programs are written for.
    pub post: Post,
    /// `annex`: a part of a program, as published; `full`: a complete program with kerf.
    pub style: Style,
    /// M codes that turn the torch on.
    pub torch_on: Vec<Word>,
    /// M codes that turn it off.
    pub torch_off: Vec<Word>,
    /// M codes at the end, as M30.
    pub end_codes: Vec<Word>,
    /// By how much block numbers grow from block to block.
    pub block_step: u32,
}

impl Design {
    /// The design of checked values.
    ///
    /// # Errors
    /// Every check of one value against another that fails, as findings on parameters (the caller turns them into cells).
    pub fn new(fields: &Fields) -> Result<Self, Vec<Finding>> {
        let [branch, header] = Pipe::both(fields)?;
        let design = Self::of(fields, branch, header);
        let findings = design.contradictions();
        if findings.is_empty() { Ok(design) } else { Err(findings) }
    }

    /// True where the radius of this field was typed.
    #[must_use]
    pub fn is_typed(&self, key: Key) -> bool {
        self.typed.iter().any(|one| one.key == key)
    }

    fn of(fields: &Fields, branch: Pipe, header: Pipe) -> Self {
        let contact = fields.get(&CONTACT);
        let outside = branch.D / 2.0;
        let bore = outside - branch.t;
        let r = match contact {
            Contact::Outside => outside,
            Contact::Inside | Contact::Envelope => bore,
        };
        let r_dev = match fields.get(&SHEET) {
            Surface::Outside => outside,
            Surface::Mean => outside - branch.t / 2.0,
            Surface::Inside => bore,
        };
        let R_header = header.D / 2.0;
        let typed = [(&EXPERT_BRANCH_R, r), (&R, R_header), (&R_DEV, r_dev)];
        let typed = typed
            .into_iter()
            .filter_map(|(field, derived)| fields.get(field).map(|typed| Typed { key: field.key(), typed, derived }));
        Self {
            branch,
            header,
            contact,
            theta: fields.get(&THETA),
            e: fields.get(&E),
            Z: fields.get(&Z),
            N: fields.get(&N),
            r: fields.get(&EXPERT_BRANCH_R).unwrap_or(r),
            R: fields.get(&R).unwrap_or(R_header),
            sheet: fields.get(&SHEET),
            r_dev: fields.get(&R_DEV).unwrap_or(r_dev),
            typed: typed.collect(),
            mode: fields.get(&MODE),
            kerf: fields.get(&KERF),
            F: fields.get(&F),
            rapids: rapids(fields),
            pierce_delay: fields.get(&PIERCE_DELAY),
            lead_in: fields.get(&LEAD_IN),
            overcut: fields.get(&OVERCUT),
            arc_tolerance: fields.get(&ARC_TOLERANCE),
            paper: fields.get(&PAPER),
            part: fields.get(&PART),
            material: fields.get(&MATERIAL).unwrap_or_default(),
            program: fields.get(&NUMBER),
            post: fields.get(&DIALECT),
            style: fields.get(&STYLE),
            torch_on: fields.get(&TORCH_ON).0,
            torch_off: fields.get(&TORCH_OFF).0,
            end_codes: fields.get(&END_CODES).0,
            block_step: fields.get(&BLOCK_STEP),
        }
    }

    /// The two pipes as they meet.
    #[must_use]
    pub fn pair(&self) -> PipePair {
        PipePair::new(self.r, self.R, self.theta, self.e)
    }

    /// The branch's wall over the header.
    #[must_use]
    pub fn wall(&self) -> PipeWall {
        let outside = self.branch.D / 2.0;
        PipeWall::new([outside - self.branch.t, outside], self.R, self.theta, self.e)
    }

    /// The template: the curve on the development of the sheet, without kerf.
    #[must_use]
    pub fn template(&self) -> Outline {
        let wall = self.wall();
        let seat = match self.contact {
            Contact::Inside | Contact::Outside => Seat::Edge(self.pair()),
            Contact::Envelope => Seat::Envelope(wall),
        };
        Outline { seat, wall, radius: self.r_dev, Z: self.Z, beside: 0.0 }
    }

    /// The curve and the torch's path where the torch cuts: on the sheet, or on the outside of the pipe. The published
    /// style has no kerf.
    #[must_use]
    pub fn outline(&self) -> Outline {
        let radius = if self.mode == Mode::Rotary { self.branch.D / 2.0 } else { self.r_dev };
        let beside = if self.style == Style::Annex { 0.0 } else { self.kerf / 2.0 };
        Outline { radius, beside, ..self.template() }
    }

    /// How much farther from the edge on the outside the bore is cut back than straight to the axis, at most, mm: the kerf is as wide
    /// there, and counts for more of the turn. A flat sheet is cut square and rolled afterwards.
    ///
    /// # Derivation
    /// The jet, as wide as the kerf all along, takes from the development of a radius ρ what is within half a kerf of the torch's path. Seen on
    /// the outside's development that is an ellipse r_o/ρ times as long round the pipe: it holds the circle of the outside, and
    /// reaches beyond it by half a kerf times r_o/ρ − 1. So the wall is nowhere longer inside than straight to the axis.
    #[must_use]
    pub fn cut_back(&self) -> f64 {
        let [bore, outside] = self.wall().ends();
        if self.mode == Mode::Rotary { self.outline().beside * (outside / bore - 1.0) } else { 0.0 }
    }
}
