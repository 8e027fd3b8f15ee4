//! The design of a bevelled hole: validated parameters with units settled, and the checks of one against another.

use std::f64::consts::TAU;

use crate::figure::Paper;
use crate::finding::{Finding, Limit, Raise, Said, Size};
use crate::gcode::control::Post;
use crate::gcode::fields::rapids;
use crate::gcode::machine_codes::{CodesPlace, refused_codes};
use crate::gcode::word::Word;
use crate::geometry::pipe_pair::PipePair;
use crate::kinds::pipe::dimensions::{Pipe, or_eccentricity, solid};
use crate::kinds::pipe::form::{
    BLOCK_STEP, D_BRANCH, D_HEADER, DIALECT, E, END_CODES, MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, T_HEADER,
    THETA, TORCH_OFF, TORCH_ON,
};
use crate::kinds::pipe::hole::height::Torch;
use crate::kinds::pipe::hole::parameters::{
    ARC_TOLERANCE, B, D_MAX, D0, F, F_MAX, G0, GAMMA, H, HOLD_OFF, HOLD_ON, KERF, LEAD_IN, M, N, NOZZLE_R_G, OVERCUT,
    PSI, TORCH_BODY_RADIUS, Z_S,
};
use crate::kinds::pipe::hole::rules::{
    BodyThinner, BranchDoesNotGoIn, GapBeyondHeight, HoldUnpaired, KerfFinerThanBeam, LandBeyondWall, LeadInPastAxis,
    LimitBelowHeight,
};
use crate::kinds::pipe::hole::station::Groove;
use crate::kinds::pipe::rules::OvercutPastTurn;
use crate::kinds::pipe::switching::{on_at_end, opposed};
use crate::machine::rapids::Rapids;
use crate::parameter::at;
use crate::parameter::field::Fields;
use crate::text::Language;

/// A design that may be computed. Lengths in mm, angles in degrees.
#[derive(Clone, Debug)]
pub struct Design {
    /// The pipe that gets the hole.
    pub header: Pipe,
    /// The pipe that goes into it.
    pub branch: Pipe,
    /// θ, the angle between the axes.
    pub theta: f64,
    /// e, how far the axes pass each other.
    pub e: f64,
    /// γ, the groove angle.
    pub gamma: f64,
    /// b, the root gap.
    pub b: f64,
    /// h, the land: what of the header's wall stays unbevelled over its bore, mm.
    pub h: f64,
    /// N, places of the tables.
    pub N: u32,
    /// r_g, radius of the nozzle's tip.
    pub r_g: f64,
    /// R_g, radius of the torch's body.
    pub R_g: f64,
    /// Ψ, half angle of the nozzle's taper.
    pub Psi: f64,
    /// m, radius of the plasma beam.
    pub m: f64,
    /// d₀, the height that is wanted.
    pub d0: f64,
    /// g₀, the least distance to the pipe.
    pub g0: f64,
    /// The greatest height.
    pub D_max: f64,
    /// The width of the cut, mm: 2·m where its cell is empty.
    pub kerf: f64,
    /// F, cutting speed at the root, mm/min.
    pub F: f64,
    /// How fast the machine is where it does not cut.
    pub rapids: Rapids,
    /// F_max, greatest speed of an axis, mm/min or °/min.
    pub F_max: Option<f64>,
    /// How long the torch stands after it pierces, s.
    pub pierce_delay: f64,
    /// The way from the pierce to the curve.
    pub lead_in: f64,
    /// The way beyond the end of the curve.
    pub overcut: f64,
    /// How far the beam may leave the exact curve.
    pub arc_tolerance: f64,
    /// Height of rapid moves above the header.
    pub Z_s: f64,
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
    /// M codes that turn the torch on.
    pub torch_on: Vec<Word>,
    /// M codes that turn it off.
    pub torch_off: Vec<Word>,
    /// M codes that hold the torch height control; empty for those of the control.
    pub hold_on: Vec<Word>,
    /// M codes that let it go.
    pub hold_off: Vec<Word>,
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

    fn of(fields: &Fields, branch: Pipe, header: Pipe) -> Self {
        let m = fields.get(&M);
        Self {
            header,
            branch,
            theta: fields.get(&THETA),
            e: fields.get(&E),
            gamma: fields.get(&GAMMA),
            b: fields.get(&B),
            h: fields.get(&H),
            N: fields.get(&N),
            r_g: fields.get(&NOZZLE_R_G),
            R_g: fields.get(&TORCH_BODY_RADIUS),
            Psi: fields.get(&PSI),
            m,
            d0: fields.get(&D0),
            g0: fields.get(&G0),
            D_max: fields.get(&D_MAX),
            kerf: fields.get(&KERF).unwrap_or(2.0 * m),
            F: fields.get(&F),
            rapids: rapids(fields),
            F_max: fields.get(&F_MAX),
            pierce_delay: fields.get(&PIERCE_DELAY),
            lead_in: fields.get(&LEAD_IN),
            overcut: fields.get(&OVERCUT),
            arc_tolerance: fields.get(&ARC_TOLERANCE),
            Z_s: fields.get(&Z_S),
            paper: fields.get(&PAPER),
            part: fields.get(&PART),
            material: fields.get(&MATERIAL).unwrap_or_default(),
            program: fields.get(&NUMBER),
            post: fields.get(&DIALECT),
            torch_on: fields.get(&TORCH_ON).0,
            torch_off: fields.get(&TORCH_OFF).0,
            hold_on: fields.get(&HOLD_ON).unwrap_or_default().0,
            hold_off: fields.get(&HOLD_OFF).unwrap_or_default().0,
            end_codes: fields.get(&END_CODES).0,
            block_step: fields.get(&BLOCK_STEP),
        }
    }

    /// R_o, the header's outside radius.
    #[must_use]
    pub fn R_o(&self) -> f64 {
        self.header.D / 2.0
    }

    /// R_i, the header's bore.
    #[must_use]
    pub fn R_i(&self) -> f64 {
        self.header.D / 2.0 - self.header.t
    }

    /// The branch's outside grown by the gap, and the header's bore grown by the land.
    ///
    /// With e > 0 the branch's axis passes in front of the header's for someone who sees the branch lean to the right, as it
    /// does for a branch whose template of the same e is wrapped round it, printed face outwards (see
    /// [`crate::kinds::pipe::insert`]): here at y = −e.
    #[must_use]
    pub fn pair(&self) -> PipePair {
        PipePair::new(self.branch.D / 2.0 + self.b, self.R_i() + self.h, self.theta, -self.e)
    }

    /// How long the curve is where the branch's outside and its gap meet the bore and the land, mm, to a thousandth of it.
    fn round(&self) -> f64 {
        const STEPS: u16 = 720;
        let pair = self.pair();
        let place = |step: u16| pair.point(TAU * f64::from(step) / f64::from(STEPS));
        (0..STEPS).map(|step| (place(step + 1) - place(step)).norm()).sum()
    }

    /// The torch with Ψ in radians, lengths in mm.
    #[must_use]
    pub fn torch(&self) -> Torch {
        Torch { r_g: self.r_g, R_g: self.R_g, Psi: self.Psi.to_radians(), d0: self.d0, g0: self.g0 }
    }

    /// What the cut is made of.
    #[must_use]
    pub fn groove(&self) -> Groove {
        Groove {
            pair: self.pair(),
            R_o: self.R_o(),
            R_i: self.R_i(),
            gamma: self.gamma.to_radians(),
            beside: self.kerf / 2.0,
            torch: self.torch(),
        }
    }

    /// What is valid alone but not together. All findings are stops.
    fn contradictions(&self) -> Vec<Finding> {
        let mut findings = solid(self.branch, self.header);
        let pair = self.pair();
        let (r, e) = (Size::mm(pair.r), Size::mm(self.e));
        let (g0, d0, wall) = (Size::mm(self.g0), Size::mm(self.d0), Size::mm(self.header.t));
        if self.h >= self.header.t {
            let h = Size::mm(self.h);
            findings.push(against(
                LandBeyondWall { h, wall }.at(at([H.key(), T_HEADER.key()])),
                [h, wall],
                Limit::AtMost,
            ));
        } else if pair.overhang() >= 0.0 {
            // The hole must stay clear of the side; the last thousandth is as good as it.
            let most = ((pair.R - pair.r) * 1000.0 - 1.0).floor() / 1000.0;
            let eccentricity = (most >= 0.0 && self.e.abs() > most).then(|| Size::mm(most));
            let most = or_eccentricity(eccentricity);
            let told = BranchDoesNotGoIn { over: Size::mm(pair.overhang()), r, e, R: Size::mm(pair.R), most };
            findings.push(told.at(at([D_BRANCH.key(), B.key(), E.key(), D_HEADER.key()])));
        }
        let round = self.round();
        if findings.is_empty() && self.overcut > round {
            let told = OvercutPastTurn { overcut: Size::mm(self.overcut), round: Size::mm(round) };
            findings.push(told.at(at([OVERCUT.key()])).measuring(self.overcut, Limit::AtMost(round)));
        }
        if self.g0 >= self.d0 {
            findings.push(against(GapBeyondHeight { g0, d0 }.at(at([G0.key(), D0.key()])), [g0, d0], Limit::AtMost));
        }
        if self.R_g < self.r_g {
            let (R_g, r_g) = (Size::mm(self.R_g), Size::mm(self.r_g));
            let told = BodyThinner { R_g, r_g }.at(at([TORCH_BODY_RADIUS.key(), NOZZLE_R_G.key()]));
            findings.push(against(told, [R_g, r_g], Limit::AtLeast));
        }
        if self.D_max < self.d0 {
            let D_max = Size::mm(self.D_max);
            findings.push(against(
                LimitBelowHeight { D_max, d0 }.at(at([D_MAX.key(), D0.key()])),
                [D_max, d0],
                Limit::AtLeast,
            ));
        }
        if self.kerf < 2.0 * self.m - 1e-9 {
            let (kerf, beam) = (Size::mm(self.kerf), Size::mm(2.0 * self.m));
            let told = KerfFinerThanBeam { kerf, beam }.at(at([KERF.key(), M.key()]));
            findings.push(against(told, [kerf, beam], Limit::AtLeast));
        }
        if self.kerf / 2.0 + self.lead_in >= pair.r {
            let way = Size::mm(self.kerf / 2.0 + self.lead_in);
            let told = LeadInPastAxis { way, r }.at(at([LEAD_IN.key(), KERF.key()]));
            findings.push(against(told, [way, r], Limit::AtMost));
        }
        if self.hold_on.is_empty() != self.hold_off.is_empty() {
            let (given, missing) =
                if self.hold_on.is_empty() { (HOLD_OFF.key(), HOLD_ON.key()) } else { (HOLD_ON.key(), HOLD_OFF.key()) };
            findings.push(HoldUnpaired { given, missing }.at(at([missing, given])));
        }
        let lists = [
            (TORCH_ON.key(), &self.torch_on[..]),
            (TORCH_OFF.key(), &self.torch_off),
            (HOLD_ON.key(), &self.hold_on),
            (HOLD_OFF.key(), &self.hold_off),
        ];
        let within = CodesPlace { last: false, tooled: false };
        for (key, codes) in lists {
            findings.extend(refused_codes(self.post.control, key, codes, within));
        }
        findings.extend(opposed(&lists));
        findings.extend(refused_codes(
            self.post.control,
            END_CODES.key(),
            &self.end_codes,
            CodesPlace { last: true, ..within },
        ));
        findings.extend(on_at_end(&self.torch_on, &self.end_codes));
        findings
    }
}

/// A finding with what was found and its limit.
fn against(told: Finding, [found, limit]: [Size; 2], held: fn(f64) -> Limit) -> Finding {
    told.with(found.said(Language::En), limit.said(Language::En)).measuring(found.value, held(limit.value))
}
