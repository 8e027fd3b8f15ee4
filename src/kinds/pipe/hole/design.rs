//! The design of a bevelled hole: validated parameters with units settled, and the checks of one against another.

use crate::figure::Paper;
use crate::finding::{Finding, Place};
use crate::gcode::control::{Control, Written};
use crate::gcode::machine_codes::refused_codes;
use crate::gcode::word::Word;
use crate::geometry::pipe_pair::PipePair;
use crate::kinds::pipe::form::{
    BLOCK_STEP, DIALECT, E, END_CODES, MATERIAL, NUMBER, PAPER, PART, PIERCE_DELAY, THETA, TORCH_OFF, TORCH_ON,
};
use crate::kinds::pipe::hole::height::Torch;
use crate::kinds::pipe::hole::parameters::{
    ARC_TOLERANCE, B, D_MAX, D0, F, F_MAX, G0, GAMMA, H, HOLD_OFF, HOLD_ON, KERF, LEAD_IN, M, N, NOZZLE_R_G, OVERCUT,
    PSI, TORCH_BODY_RADIUS, Z_S,
};
use crate::kinds::pipe::hole::station::Groove;
use crate::kinds::pipe::insert::design::{BRANCH, HEADER, Pipe};
use crate::number::shown;
use crate::parameter::field::Fields;
use crate::text::Text;

/// A design that may be computed. Lengths in mm, angles in degrees.
#[derive(Clone, Debug)]
pub struct Design {
    /// The header.
    pub header: Pipe,
    /// The branch.
    pub branch: Pipe,
    /// θ, the angle between the axes.
    pub theta: f64,
    /// e, how far the axes pass each other.
    pub e: f64,
    /// γ, the groove angle.
    pub gamma: f64,
    /// b, the root gap.
    pub b: f64,
    /// h, the land.
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
    /// The kerf.
    pub kerf: f64,
    /// F, cutting speed at the root, mm/min.
    pub F: f64,
    /// F_max, greatest speed of an axis, mm/min or °/min.
    pub F_max: Option<f64>,
    /// The pierce delay, s.
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
    /// The material.
    pub material: String,
    /// The program number.
    pub program: u32,
    /// The dialect.
    pub control: &'static Control,
    /// How it is written for.
    pub written: Written,
    /// M codes that turn the torch on.
    pub torch_on: Vec<Word>,
    /// M codes that turn it off.
    pub torch_off: Vec<Word>,
    /// M codes that hold the torch height control; empty for those of the dialect.
    pub hold_on: Vec<Word>,
    /// M codes that let it go.
    pub hold_off: Vec<Word>,
    /// M codes at the end.
    pub end_codes: Vec<Word>,
    /// Step of the block numbers.
    pub block_step: u32,
}

impl Design {
    /// The design of checked values.
    ///
    /// # Errors
    /// Every check of one value against another that fails, as findings on parameters (the caller turns them into cells).
    pub fn new(fields: &Fields) -> Result<Self, Vec<Finding>> {
        let pipes = [Pipe::of(fields, BRANCH), Pipe::of(fields, HEADER)];
        let (branch, header) = match pipes {
            [Ok(branch), Ok(header)] => (branch, header),
            [one, other] => {
                return Err([one.err(), other.err()].into_iter().flatten().map(|finding| *finding).collect());
            }
        };
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
            control: fields.get(&DIALECT).control,
            written: fields.get(&DIALECT),
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

    /// The torch.
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
            gamma: self.gamma.to_radians(),
            beside: self.kerf / 2.0,
            torch: self.torch(),
        }
    }

    /// What is valid alone but not together. All findings are stops.
    fn contradictions(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        let mm = |value: f64| format!("{} mm", shown(value, 3));
        let mut stop = |keys: &[&'static str], es: String, en: String, remedy: Text| {
            findings.push(Finding::stop(Place::Parameters(keys.to_vec()), Text::new(es, en), remedy));
        };
        for (pipe, keys, es, en) in [
            (self.branch, ["D_branch", "t_branch"], "del injerto", "of the branch"),
            (self.header, ["D_header", "t_header"], "del tubo base", "of the header"),
        ] {
            let (t, radius) = (mm(pipe.t), mm(pipe.D / 2.0));
            if pipe.t >= pipe.D / 2.0 {
                stop(
                    &keys,
                    format!("la pared {es} es {t} y debe ser menor que su radio, {radius}"),
                    format!("the wall {en} is {t}, must be below its radius, {radius}"),
                    Text::fixed("compruebe diámetro y pared", "check diameter and wall"),
                );
            }
        }
        let pair = self.pair();
        let (r, R, e) = (mm(pair.r), mm(pair.R), mm(self.e));
        if self.h >= self.header.t {
            let (h, t) = (mm(self.h), mm(self.header.t));
            stop(
                &["h", "t_header"],
                format!("el talón h es {h} y debe ser menor que la pared, {t}"),
                format!("the land h is {h}, must be below the wall, {t}"),
                Text::fixed("un talón menor", "a smaller land"),
            );
        } else if pair.overhang() >= 0.0 {
            stop(
                &["D_branch", "b", "e", "D_header"],
                format!(
                    "el injerto con su holgura no cabe en el tubo base: le sobran {}: r + b = {r}, e = {e}, radio {R}",
                    mm(pair.overhang())
                ),
                format!(
                    "the branch with its gap does not go into the header, by {}: r + b = {r}, e = {e}, radius {R}",
                    mm(pair.overhang())
                ),
                Text::fixed("un injerto menor o menos excentricidad", "a smaller branch or less eccentricity"),
            );
        }
        if self.g0 >= self.d0 {
            let (g0, d0) = (mm(self.g0), mm(self.d0));
            stop(
                &["g0", "d0"],
                format!("la distancia mínima g0 es {g0} y debe ser menor que la altura d0, {d0}"),
                format!("the least distance g0 is {g0}, must be below the height d0, {d0}"),
                Text::fixed("menos g0, o más d0", "a smaller g0, or a greater d0"),
            );
        }
        if self.R_g < self.r_g {
            let (r_g, R_g) = (mm(self.r_g), mm(self.R_g));
            stop(
                &["R_g", "r_g"],
                format!("el cuerpo R_g = {R_g} es más fino que la boquilla r_g = {r_g}"),
                format!("the body R_g = {R_g} is thinner than the nozzle r_g = {r_g}"),
                Text::fixed("compruebe los dos radios", "check both radii"),
            );
        }
        if self.D_max < self.d0 {
            let (D_max, d0) = (mm(self.D_max), mm(self.d0));
            stop(
                &["D_max", "d0"],
                format!("la altura máxima D_max es {D_max}, menor que la deseada, {d0}"),
                format!("the greatest height D_max is {D_max}, below the wanted one, {d0}"),
                Text::fixed("más D_max, o menos d0", "a greater D_max, or a smaller d0"),
            );
        }
        if self.kerf < 2.0 * self.m - 1e-9 {
            let (kerf, beam) = (mm(self.kerf), mm(2.0 * self.m));
            stop(
                &["kerf", "m"],
                format!("el corte de {kerf} es más fino que el chorro, {beam}"),
                format!("the kerf of {kerf} is finer than the beam, {beam}"),
                Text::fixed("deje kerf vacío para 2·m", "leave kerf empty for 2·m"),
            );
        }
        if self.kerf / 2.0 + self.lead_in >= pair.r {
            let (way, r) = (mm(self.kerf / 2.0 + self.lead_in), mm(pair.r));
            stop(
                &["lead_in", "kerf"],
                format!("la entrada llega más allá del eje del agujero: {way} y su radio es {r}"),
                format!("the lead-in reaches past the hole's axis: {way}, and its radius is {r}"),
                Text::fixed("una entrada más corta", "a shorter lead-in"),
            );
        }
        if self.hold_on.is_empty() != self.hold_off.is_empty() {
            let (given, missing) =
                if self.hold_on.is_empty() { ("hold_off", "hold_on") } else { ("hold_on", "hold_off") };
            stop(
                &[missing, given],
                format!("{given} sin {missing}: el control de altura no se bloquearía y soltaría"),
                format!("{given} without {missing}: the height control would not be held and let go"),
                Text::new(
                    format!("escriba {missing}, o deje vacíos los dos"),
                    format!("fill in {missing}, or leave both empty"),
                ),
            );
        }
        for (key, codes) in [
            ("torch_on", &self.torch_on),
            ("torch_off", &self.torch_off),
            ("hold_on", &self.hold_on),
            ("hold_off", &self.hold_off),
        ] {
            findings.extend(refused_codes(self.control, key, codes, false));
        }
        findings.extend(refused_codes(self.control, "end_codes", &self.end_codes, true));
        findings
    }
}
