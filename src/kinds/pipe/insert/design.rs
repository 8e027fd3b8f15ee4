//! The design of a branch pipe: validated parameters with units settled.

use crate::figure::Paper;
use crate::finding::{Finding, Place};
use crate::gcode::control::{Control, Writing};
use crate::gcode::program::Style;
use crate::gcode::word::{Word, codes};
use crate::geometry::pipe_pair::PipePair;
use crate::kinds::pipe::insert::outline::Outline;
use crate::kinds::pipe::size::wall;
use crate::parameter::Values;
use crate::text::Text;

/// On what the torch cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A flat sheet: X and Y.
    Flat,
    /// The pipe, turning: A and X.
    Rotary,
}

/// Which of the branch's curves rests on the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// That of its bore.
    Inside,
    /// That of its outside.
    Outside,
}

/// Outside diameter and wall of a pipe, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipe {
    /// D.
    pub D: f64,
    /// t.
    pub t: f64,
}

/// The parameters that give a pipe's size: nominal size, schedule, outside diameter, wall.
pub type SizeKeys = [&'static str; 4];

/// The parameters of the branch's size.
pub const BRANCH: SizeKeys = ["branch_size", "branch_schedule", "D_branch", "t_branch"];
/// The parameters of the header's size.
pub const HEADER: SizeKeys = ["header_size", "header_schedule", "D_header", "t_header"];

impl Pipe {
    /// The pipe of nominal size and schedule, or of outside diameter and wall.
    ///
    /// # Errors
    /// Where both are given and differ, neither is given whole, or the schedule does not exist in that size.
    pub fn from_values(values: &Values, keys: SizeKeys) -> Result<Self, Box<Finding>> {
        let [size, schedule, D, t] = keys;
        let stop = |keys: &[&'static str], es: String, en: String, remedy: Text| {
            Err(Box::new(Finding::stop(Place::Parameters(keys.to_vec()), Text::new(es, en), remedy)))
        };
        let typed = (values.real(D), values.real(t));
        let named = (values.choice(size), values.choice(schedule));
        match (named, typed) {
            ((None, None), (Some(D), Some(t))) => Ok(Self { D, t }),
            ((Some(nps), Some(number)), typed) => match (wall(nps, number), typed) {
                (None, _) => stop(
                    &[size, schedule],
                    format!("ASME B36.10 no tiene cédula {number} en el tamaño {nps}"),
                    format!("ASME B36.10 has no schedule {number} in size {nps}"),
                    Text::new(
                        format!("elija otra cédula, o escriba {D} y {t}"),
                        format!("choose another schedule, or fill in {D} and {t}"),
                    ),
                ),
                (Some((outside, thick)), (typed_D, typed_t))
                    if typed_D.is_some_and(|D| (D - outside).abs() > 1e-9)
                        || typed_t.is_some_and(|t| (t - thick).abs() > 1e-9) =>
                {
                    stop(
                        &keys,
                        format!("{size} {nps} cédula {number} es {outside} × {thick} mm, y {D} o {t} dicen otra cosa"),
                        format!(
                            "{size} {nps} schedule {number} is {outside} × {thick} mm, and {D} or {t} say otherwise"
                        ),
                        Text::new(
                            format!("deje vacíos {D} y {t}, o el tamaño nominal"),
                            format!("leave {D} and {t} empty, or the nominal size"),
                        ),
                    )
                }
                (Some((D, t)), _) => Ok(Self { D, t }),
            },
            _ => stop(
                &keys,
                format!("falta el tamaño: {size} y {schedule}, o {D} y {t}"),
                format!("the size is missing: {size} and {schedule}, or {D} and {t}"),
                Text::fixed("rellene uno de los dos pares", "fill in one of the two pairs"),
            ),
        }
    }
}

/// A design that may be computed. Lengths in mm, θ in degrees.
#[derive(Clone, Debug)]
pub struct Design {
    /// The branch.
    pub branch: Pipe,
    /// The header.
    pub header: Pipe,
    /// Which curve of the branch rests on the header.
    pub contact: Contact,
    /// θ.
    pub theta: f64,
    /// e.
    pub e: f64,
    /// Z.
    pub Z: f64,
    /// N.
    pub N: u32,
    /// r, the radius of the branch's curve.
    pub r: f64,
    /// R, the header's radius.
    pub R: f64,
    /// The radius of the development.
    pub r_dev: f64,
    /// True where r was typed, not computed.
    pub typed_r: bool,
    /// Flat or rotary.
    pub mode: Mode,
    /// The kerf.
    pub kerf: f64,
    /// F, cutting speed, mm/min.
    pub F: Option<f64>,
    /// The pierce delay, s.
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
    /// The material.
    pub material: String,
    /// The program number.
    pub program: u32,
    /// The dialect.
    pub control: &'static Control,
    /// How its programs are written.
    pub writing: &'static Writing,
    /// The style.
    pub style: Style,
    /// M codes that turn the torch on.
    pub torch_on: Vec<Word>,
    /// M codes that turn it off.
    pub torch_off: Vec<Word>,
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
    pub fn new(values: &Values) -> Result<Self, Vec<Finding>> {
        let pipes = [Pipe::from_values(values, BRANCH), Pipe::from_values(values, HEADER)];
        let (branch, header) = match pipes {
            [Ok(branch), Ok(header)] => (branch, header),
            [one, other] => {
                return Err([one.err(), other.err()].into_iter().flatten().map(|finding| *finding).collect());
            }
        };
        let Some(design) = Self::from_values(values, branch, header) else {
            return Err(vec![Finding::stop(
                Place::File,
                Text::fixed("faltan valores obligatorios", "required values are missing"),
                Text::fixed("rellene las celdas obligatorias", "fill in the required cells"),
            )]);
        };
        let findings = design.contradictions();
        if findings.is_empty() { Ok(design) } else { Err(findings) }
    }

    fn from_values(values: &Values, branch: Pipe, header: Pipe) -> Option<Self> {
        let real = |key| values.real(key);
        let contact = if values.choice("contact")? == "outside" { Contact::Outside } else { Contact::Inside };
        let outside = branch.D / 2.0;
        let bore = outside - branch.t;
        let r_dev = match values.choice("sheet")? {
            "outside" => outside,
            "mean" => outside - branch.t / 2.0,
            _ => bore,
        };
        Some(Self {
            branch,
            header,
            contact,
            theta: real("theta")?,
            e: real("e")?,
            Z: real("Z")?,
            N: values.whole("N")?,
            r: real("r").unwrap_or(if contact == Contact::Outside { outside } else { bore }),
            R: real("R").unwrap_or(header.D / 2.0),
            r_dev: real("r_dev").unwrap_or(r_dev),
            typed_r: real("r").is_some(),
            mode: if values.choice("mode")? == "rotary" { Mode::Rotary } else { Mode::Flat },
            kerf: real("kerf")?,
            F: real("F"),
            pierce_delay: real("pierce_delay")?,
            lead_in: real("lead_in")?,
            overcut: real("overcut")?,
            arc_tolerance: real("arc_tolerance")?,
            paper: values.choice("paper").and_then(Paper::of).unwrap_or(Paper::A4),
            part: values.line("part").to_owned(),
            material: values.line("material").to_owned(),
            program: values.whole("program")?,
            control: Control::milling(values.choice("dialect")?)?,
            writing: Control::milling(values.choice("dialect")?)?.written?,
            style: if values.choice("style")? == "full" { Style::Full } else { Style::Annex },
            torch_on: codes(values.line("torch_on"))?,
            torch_off: codes(values.line("torch_off"))?,
            end_codes: codes(values.line("end_codes"))?,
            block_step: values.whole("block_step")?,
        })
    }

    /// The two pipes as they meet.
    #[must_use]
    pub fn pair(&self) -> PipePair {
        PipePair::new(self.r, self.R, self.theta, self.e)
    }

    /// The template: the curve on the development of the sheet, without kerf.
    #[must_use]
    pub fn template(&self) -> Outline {
        Outline { pair: self.pair(), radius: self.r_dev, Z: self.Z, beside: 0.0 }
    }

    /// The curve and the torch's path where the torch cuts: on the sheet, or on the outside of the pipe. The published
    /// style has no kerf.
    #[must_use]
    pub fn outline(&self) -> Outline {
        let radius = if self.mode == Mode::Rotary { self.branch.D / 2.0 } else { self.r_dev };
        let beside = if self.style == Style::Annex { 0.0 } else { self.kerf / 2.0 };
        Outline { radius, beside, ..self.template() }
    }
}
