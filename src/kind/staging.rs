//! A part with its programs, as it is shown.

use crate::finding::{Finding, Grade, Place, Refusal};
use crate::gcode::interpreter::Setting;
use crate::gcode::program::Program;
use crate::kind::Proved;
use crate::limits::SHOWN_MOTIONS;
use crate::machine::axis::Axis;
use crate::machine::chain::Chain;
use crate::scene::kept::{following, too_many};
use crate::scene::part::Part;
use crate::scene::program::Program as ShownProgram;
use crate::scene::{Remark, Scene};

/// The scene of a part, and every program on it, read with its setting. Programs that turn the blank are shown without it. Of each
/// is told what `findings` say of it and of the whole, and nothing else: its text has been judged.
///
/// # Errors
/// Exit 7 for a program with more lines or motions than [`SHOWN_MOTIONS`].
pub(super) fn scene(
    part: Option<Part>,
    programs: &[Proved],
    setting: impl Fn(&Program) -> Setting,
    findings: &[Finding],
) -> Result<Scene, Refusal> {
    let mut scene = Scene::default();
    let most = u64::try_from(SHOWN_MOTIONS).unwrap_or(u64::MAX);
    for program in programs {
        if program.blocks() > most {
            return Err(too_many(&program.title));
        }
        let turning = program.control.turns();
        let frame = match &part {
            Some(part) if !turning => part.frame,
            _ if turning => Chain::Turning,
            _ => Chain::Milling,
        };
        let mut shown = ShownProgram::new(program.title.clone(), program.control, frame, &program.text());
        shown.rapids = program.account.rapids;
        shown.tools.extend(part.iter().filter(|_| !turning).flat_map(|part| part.tools.clone()));
        shown.remarks.extend(
            findings
                .iter()
                .filter(|finding| belongs(finding, program.key, scene.programs.is_empty()))
                .map(Remark::from),
        );
        let mut setting = setting(program);
        if !turning && !program.finds_its_start() {
            // The machine is taken there by hand, as the set-up sheet says.
            for axis in Axis::ALL {
                setting.start.machine.set(axis, program.start.get(axis).value());
            }
            shown.known = true;
        }
        following(&mut shown, &mut program.read_back_with(setting))?;
        shown.remarks.sort_by_key(|remark| std::cmp::Reverse(remark.grade));
        scene.programs.push(shown);
    }
    if let Some(part) = part {
        scene.meshes = part.meshes;
        scene.curves = part.curves;
    }
    Ok(scene)
}

/// True for a finding about a program, or one about the whole: of these a person must see the grave ones with every program, and
/// the notes with the first.
fn belongs(finding: &Finding, key: &str, first: bool) -> bool {
    match finding.place {
        Place::Block { program, .. } => program == key,
        _ => first || finding.grade > Grade::Note,
    }
}
