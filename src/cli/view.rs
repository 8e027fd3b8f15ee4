//! The command `view`: one HTML file that shows a program, or a workbook's part and programs.

use std::ffi::OsString;
use std::io::BufRead;
use std::path::Path;

use super::args::View;
use super::locale::spoken;
use super::program::{self, PACKAGE, Shared, told_from, told_other};
use super::rules::*;
use super::terminal::Terminal;
use super::turning::{TurningRequest, follow};
use super::verdict::{Verdict, gravest};
use super::{finding, interrupt, plan, reading, refused};
use crate::escape::{printable, printable_path};
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::gcode::control::guess::guess;
use crate::gcode::interpreter::{Interpreter, decoded};
use crate::gcode::rules::lexis::OtherControl;
use crate::kind::{Kind, Wants};
use crate::machine::chain::Chain;
use crate::scene::kept;
use crate::scene::program::Program;
use crate::scene::{Remark, Scene, Shape, ShownTool};
use crate::store::{self, Existing, Folder, Set, WrittenFile};
use crate::text::Text;
use crate::view;
use crate::workbook;

/// Writes the file and says where it is.
pub(super) fn run(arguments: &View, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    interrupt::listen(spoken(arguments.lang, None));
    let mut verdict = Verdict::new(arguments.input.clone());
    let written = match shown(arguments, kinds, &mut verdict) {
        Ok(written) => written,
        Err(refusal) if verdict.findings.is_empty() => {
            return refused(&refusal, spoken(arguments.lang, verdict.language), terminal);
        }
        Err(refusal) => {
            verdict.refuse(refusal);
            Vec::new()
        }
    };
    let language = spoken(arguments.lang, verdict.language);
    let name = printable_path(&arguments.input);
    // Cells are those of the input, or of the lathe workbook beside a program.
    let beside = arguments.control.tools.as_deref().filter(|_| verdict.schema.is_none()).map(printable_path);
    let names = finding::Names { input: &name, workbook: beside.as_ref().unwrap_or(&name) };
    finding::faults(&verdict.findings, names, language, terminal);
    for file in &written {
        let path = printable_path(&file.path);
        let text = Text::new(
            format!("{path} está listo: ábralo en un navegador\n"),
            format!("{path} is ready: open it in a browser\n"),
        );
        terminal.out(text.get(language));
    }
    verdict.exit
}

fn shown(arguments: &View, kinds: &[&dyn Kind], verdict: &mut Verdict) -> Result<Vec<WrittenFile>, Refusal> {
    let input = &arguments.input;
    let output = match &arguments.output {
        Some(output) => output.clone(),
        None => {
            plan::alone(input)?;
            input.with_file_name(store::file_name(&store::stem(input), ".html"))
        }
    };
    let name = page_name(&output)?;
    let beside = [Some(input), arguments.control.tools.as_ref(), arguments.control.var.as_ref()].into_iter().flatten();
    let delivered = plan::folder(input);
    verdict.findings.extend(reading::settled(beside.map(|file| plan::beside(file)).chain([delivered.as_path()]))?);
    let folder = Folder::open(output.parent().unwrap_or(Path::new("")))?;
    let control = &arguments.control;
    let inputs: Vec<&Path> =
        [Some(input), control.var.as_ref(), control.tools.as_ref()].into_iter().flatten().map(AsRef::as_ref).collect();
    let mut set = Set::new(&folder, &inputs, Existing::Replace);
    set.check(&name)?;
    let mut file = workbook::open_program(input)?;
    let package = file.fill_buf().is_ok_and(|head| head.starts_with(PACKAGE));
    let title = printable(&input.file_name().unwrap_or_default().to_string_lossy());
    let turned = !package && is_turned(arguments, file.fill_buf().unwrap_or_default())?;
    let given = [(arguments.stock.is_some(), "--stock"), (arguments.tailstock.is_some(), "--tailstock")];
    if let Some((_, option)) = given.into_iter().find(|(given, _)| *given && !turned) {
        return Err(StockWithoutTurning { option }.refused(Exit::CommandLine, Place::File));
    }
    let scene = if package {
        drop(file);
        placed(of_workbook(arguments, kinds, title, verdict), verdict)
    } else if turned {
        placed(of_turning(arguments, title, verdict), verdict)
    } else {
        Some(of_program(arguments, title, &mut file, verdict)?)
    };
    // A program that is refused is shown as far as it was read; one that was given up is not.
    let Some(scene) = scene.filter(|_| matches!(verdict.exit, Exit::Done | Exit::Refused)) else {
        return Ok(Vec::new());
    };
    set.write(&name, |out| view::write(&scene, out))?;
    set.commit()
}

/// The scene; what refuses it goes to the verdict, whose findings are reported with their places in the input.
fn placed(scene: Result<Option<Scene>, Refusal>, verdict: &mut Verdict) -> Option<Scene> {
    scene.unwrap_or_else(|refusal| {
        verdict.refuse(refusal);
        None
    })
}

/// True for a turning program that is to be followed over its stock; not for a milling program, nor for one that is read
/// with LinuxCNC's tables, which say nothing of a stock.
fn is_turned(arguments: &View, head: &[u8]) -> Result<bool, Refusal> {
    let control = &arguments.control;
    let machine = match &control.tools {
        Some(tools) => {
            let bytes = workbook::open_as(workbook::Input::ToolTable, tools);
            Some(bytes.map_err(|refusal| program::of_file(refusal, tools))?.starts_with(PACKAGE))
        }
        None => None,
    };
    if machine == Some(false) || control.var.is_some() || control.inch {
        return Ok(false);
    }
    let ending = arguments.input.extension().unwrap_or_default().to_string_lossy().into_owned();
    Ok(match control.dialect {
        Some(control) => control.turns(),
        // A lathe's workbook is given for a turning program alone.
        None => machine == Some(true) || guess(head, &ending, false).turns(),
    })
}

/// The scene of a turning program over its stock.
fn of_turning(arguments: &View, title: String, verdict: &mut Verdict) -> Result<Option<Scene>, Refusal> {
    let (input, control) = (&arguments.input, &arguments.control);
    let bytes = workbook::open_as(workbook::Input::Program, input)?;
    let wanted = TurningRequest {
        program: input,
        bytes: &bytes,
        control: control.dialect,
        decimal_point: control.decimal_point,
        hole_plane: control.hole_r,
        block_delete: control.block_delete,
        stock: arguments.stock,
        tailstock: arguments.tailstock,
        tools: control.tools.as_deref(),
        language: spoken(arguments.lang, None),
    };
    let scene = follow(&wanted, verdict, Wants { scene: true, ..Wants::default() })?.outcome.scene.transpose()?;
    let language = spoken(arguments.lang, verdict.language);
    Ok(scene.map(|scene| scene.titled(title, language)))
}

/// The scene of a workbook; `None` where there is nothing to show.
fn of_workbook(
    arguments: &View,
    kinds: &[&dyn Kind],
    title: String,
    verdict: &mut Verdict,
) -> Result<Option<Scene>, Refusal> {
    plan::twice(std::slice::from_ref(&arguments.input))?;
    let (_, filled) = reading::read(&arguments.input, kinds, verdict)?;
    let language = arguments.lang.unwrap_or(filled.values.language);
    let outcome =
        reading::compute(&arguments.input, filled, kinds, Wants { scene: true, ..Wants::default() }, verdict)?;
    let title = headed(outcome.part(), title);
    Ok(outcome.scene.transpose()?.map(|scene| scene.titled(title, language)))
}

/// What a page of a workbook is headed by: the part's name, or the workbook's where its form has none.
pub(super) fn headed(part: &str, workbook: String) -> String {
    if part.is_empty() { workbook } else { part.to_owned() }
}

fn of_program(
    arguments: &View,
    title: String,
    file: &mut impl BufRead,
    verdict: &mut Verdict,
) -> Result<Scene, Refusal> {
    let input = &arguments.input;
    let shared = Shared::new(&arguments.control)?;
    let (named, control) = shared.control(input, file);
    let bytes = workbook::open_as(workbook::Input::Program, input)?;
    let milling = !control.turns();
    let frame = if milling { Chain::Milling } else { Chain::Turning };
    let text = decoded(&bytes);
    let mut program = Program::new(Text::same(title.clone()), control, frame, &text);
    shared.fits(control)?;
    let setting = shared.setting(input, control);
    for (number, tool) in setting.tools.iter().flatten().filter(|(_, tool)| milling && tool.diameter > 0.0) {
        let (r, d) = (tool.diameter / 2.0, tool.diameter);
        let name = Text::same(format!("T{number} d{d}"));
        program.tools.push(ShownTool {
            number: *number,
            name,
            shape: Shape::Revolved(vec![[0.0, 0.0], [r, 0.0], [r, 4.0 * d]]),
        });
    }
    let (exit, findings) = kept::following(&mut program, &mut Interpreter::over(&bytes, setting))?;
    program.remarks.extend(findings.iter().map(Remark::from));
    verdict.exit = gravest(verdict.exit, exit);
    verdict.findings.extend(findings);
    if !named {
        let other = verdict.findings.iter().all(|one| one.code() != OtherControl::RULE.code);
        let other = told_other(input, &bytes, control).filter(|_| other);
        for told in other.into_iter().chain([told_from(control)]) {
            program.remarks.push(Remark::from(&told));
            verdict.findings.push(told);
        }
    }
    let language = spoken(arguments.lang, None);
    Ok(Scene { title, language, meshes: Vec::new(), curves: Vec::new(), programs: vec![program] })
}

/// The name of the file to write.
///
/// # Errors
/// Exit 2 where it does not end in `.html`: no browser would take it for a page.
fn page_name(file: &Path) -> Result<OsString, Refusal> {
    match (file.file_name(), file.extension()) {
        (Some(name), Some(extension)) if extension.eq_ignore_ascii_case("html") => Ok(name.to_owned()),
        _ => Err(NotAPageName { path: printable_path(file) }.refused(Exit::CommandLine, Place::File)),
    }
}
