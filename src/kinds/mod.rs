//! The workbook kinds, a folder each: form, design, model, programs, proof, tables, figures and scene.

pub mod impeller;
pub mod lathe;
pub mod pipe;

use crate::finding::{Exit, Finding, Grade, Place, Refusal};
use crate::kind::{Outcome, Provenance};
use crate::limits::SHOWN_MOTIONS;
use crate::machine::chain::Chain;
use crate::parameter::field::Fields;
use crate::parameter::{Form, Values};
use crate::scene::kept::{following, too_many};
use crate::scene::program::Program;
use crate::scene::{Remark, Scene};
use crate::text::{Language, Text};

/// Computes a filled-in form.
///
/// # Errors
/// A refusal with every contradiction between values.
pub fn run(form: &'static Form, values: Values, source: Provenance) -> Result<Outcome, Refusal> {
    let fields = Fields::of(form, values)?;
    match form.kind {
        "impeller" => impeller::run(fields, source),
        "lathe" => lathe::run(fields, source),
        "pipe-hole" => pipe::hole::run(fields, source),
        "pipe-insert" => pipe::insert::run(fields, source),
        _ => Err(Refusal::new(
            Exit::Fault,
            Finding::fault(
                Place::File,
                Text::new(
                    format!("no hay cálculo para el esquema {}", form.schema),
                    format!("there is no computation for schema {}", form.schema),
                ),
            ),
        )),
    }
}

/// The scene of a workbook's outcome: its part, and every program on it.
///
/// # Errors
/// Exit 7 for a program with more lines or motions than [`SHOWN_MOTIONS`].
pub fn scene(outcome: &Outcome, title: String, language: Language) -> Result<Scene, Refusal> {
    let mut scene = Scene { title, language, meshes: Vec::new(), curves: Vec::new(), programs: Vec::new() };
    let most = u64::try_from(SHOWN_MOTIONS).unwrap_or(u64::MAX);
    let part = match outcome.fields.form().kind {
        "impeller" => impeller::scene::part(&outcome.fields),
        "pipe-hole" => pipe::scene::hole(&outcome.fields),
        "pipe-insert" => pipe::scene::insert(&outcome.fields),
        _ => None,
    };
    for program in &outcome.programs {
        if program.blocks() > most {
            return Err(too_many(&program.title));
        }
        let turning = program.control.turns();
        let frame = match &part {
            Some(part) if !turning => part.frame,
            _ if turning => Chain::Turning,
            _ => Chain::Milling,
        };
        let mut shown = Program::new(program.title.clone(), program.control, frame, &program.text());
        shown.tools.extend(part.iter().filter(|_| !turning).map(|part| part.tool.clone()));
        shown.remarks.extend(outcome.findings.iter().filter(|finding| belongs(finding, program.key)).map(Remark::from));
        following(&mut shown, &mut program.read_back())?;
        shown.remarks.sort_by_key(|remark| std::cmp::Reverse(remark.grade));
        scene.programs.push(shown);
    }
    if let Some(part) = part {
        scene.meshes = part.meshes;
        scene.curves = part.curves;
    }
    Ok(scene)
}

/// True for a finding about a program, or one about the whole that a person must judge.
fn belongs(finding: &Finding, key: &str) -> bool {
    match finding.place {
        Place::Block { program, .. } => program == key,
        _ => finding.grade > Grade::Note,
    }
}
