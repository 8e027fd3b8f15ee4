//! The command `offsets`: LinuxCNC's work offsets, shown, edited, and exchanged with a workbook.

use std::fs;
use std::io::Write;
use std::path::Path;

use super::args::Offsets;
use super::locale::spoken;
use super::offsets_view::{self, Transfer, View};
use super::rules::*;
use super::terminal::Terminal;
use super::verdict::{Verdict, gravest};
use super::{fault, interrupt, plan, reading, refused};
use crate::escape::printable;
use crate::finding::{Exit, Place, Raise, Refusal};
use crate::gcode::offset_preamble::preamble;
use crate::machine::length_unit::LengthUnit;
use crate::machine::offset_edit::Edit;
use crate::machine::var_file::{Unfit, VarFile};
use crate::machine::work_offset::{self, ACTIVE};
use crate::store::{self, Existing, Folder, Set};
use crate::workbook::offsets_sheet;
use crate::workbook::offsets_table::OffsetsTable;
use crate::workbook::{self, Input};

/// Shows, edits or exchanges, and prints what came of it.
pub(super) fn run(arguments: &Offsets, terminal: &mut Terminal) -> Exit {
    let language = spoken(arguments.lang, None);
    let unit = if arguments.inch { LengthUnit::Inch } else { LengthUnit::Millimetre };
    let named: Vec<_> = [Some(&arguments.file), arguments.workbook.as_ref()].into_iter().flatten().cloned().collect();
    let begun = plan::twice(&named).and_then(|()| edits(&arguments.set, unit));
    let edits = match begun {
        Ok(edits) => edits,
        Err(refusal) => return refused(&refusal, language, terminal),
    };
    interrupt::listen(language);
    let mut view = View { unit, file: None, preamble: Vec::new(), sheet: None };
    let verdict = reading::verdict(&arguments.file, |verdict| work(arguments, &edits, unit, &mut view, verdict));
    let exit = verdict.exit;
    if arguments.json {
        terminal.out(&offsets_view::document(&verdict, &view));
    } else {
        let workbook = view.sheet.as_ref().and_then(|(_, sheet)| sheet.language);
        offsets_view::show(&verdict, &view, spoken(arguments.lang, workbook), terminal);
    }
    exit
}

/// The edits that were asked for.
///
/// # Errors
/// Exit 2 with everything that is wrong with them.
fn edits(set: &[String], unit: LengthUnit) -> Result<Vec<Edit>, Refusal> {
    let (mut edits, mut findings) = (Vec::new(), Vec::new());
    for words in set {
        match Edit::parse(words, unit) {
            Ok(edit) => edits.push(edit),
            Err(finding) => findings.push(*finding),
        }
    }
    if findings.is_empty() { Ok(edits) } else { Err(Refusal { exit: Exit::CommandLine, findings }) }
}

#[expect(clippy::disallowed_methods, reason = "the door to the files that the command names")]
fn work(
    arguments: &Offsets,
    edits: &[Edit],
    unit: LengthUnit,
    view: &mut View,
    verdict: &mut Verdict,
) -> Result<(), Refusal> {
    // A link that leads nowhere is something, too: it is neither read nor written through.
    let there = |path: &Path| fs::symlink_metadata(path).is_ok();
    let transfer = arguments.workbook.as_deref().map(|path| if there(path) { Transfer::In } else { Transfer::Out });
    let changes = !edits.is_empty() || arguments.active.is_some() || transfer == Some(Transfer::In);
    let mut file = VarFile::default();
    if !changes || there(&arguments.file) {
        let bytes = workbook::open_as(Input::VarFile, &arguments.file)?;
        verdict.sha256 = Some(store::sha256(&bytes));
        file = VarFile::parse(&bytes)?;
    } else {
        file.complete();
    }
    if let (Some(path), Some(Transfer::In)) = (&arguments.workbook, transfer) {
        let read = reading::verdict(path, |verdict| {
            let bytes = workbook::open(path)?;
            verdict.sha256 = Some(store::sha256(&bytes));
            verdict.schema = Some(offsets_sheet::SCHEMA);
            verdict.language = workbook::language(&bytes, &[]);
            let table = OffsetsTable::read(&bytes, unit)?;
            table.apply(&mut file).map_err(unfit)?;
            verdict.findings.extend(table.findings);
            Ok(())
        });
        verdict.exit = gravest(verdict.exit, read.exit);
        view.sheet = Some((Transfer::In, read));
        if verdict.exit != Exit::Done {
            return Ok(());
        }
    }
    for edit in edits {
        edit.apply(&mut file).map_err(unfit)?;
    }
    if let Some(system) = arguments.active {
        file.set(ACTIVE, f64::from(system.number())).map_err(unfit)?;
    }
    judge(&file, unit, view, verdict);
    write(arguments, &file, unit, changes, transfer, view, verdict)?;
    view.file = Some(file);
    Ok(())
}

/// A value that the file cannot hold: edits and sheets admit none.
fn unfit(unfit: Unfit) -> Refusal {
    fault::refusal(&unfit.to_string())
}

/// What is to say about the file's offsets, and the blocks that set them.
fn judge(file: &VarFile, unit: LengthUnit, view: &mut View, verdict: &mut Verdict) {
    verdict.findings.extend(work_offset::Offsets::read(file, unit).1);
    match preamble(file, unit) {
        Ok(blocks) => view.preamble = blocks,
        Err(parameters) => {
            let list = parameters.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
            verdict.findings.push(NoPreamble { parameters: list }.at(Place::File));
        }
    }
}

/// Writes the file, if it changes, and the workbook, if it is not there: both or none where they are in one folder, else
/// the file first.
fn write(
    arguments: &Offsets,
    file: &VarFile,
    unit: LengthUnit,
    changes: bool,
    transfer: Option<Transfer>,
    view: &mut View,
    verdict: &mut Verdict,
) -> Result<(), Refusal> {
    let path = arguments.file.as_path();
    let name = path.file_name().unwrap_or_default();
    let out = arguments.workbook.as_deref().filter(|_| transfer == Some(Transfer::Out));
    let inputs: Vec<&Path> =
        arguments.workbook.as_deref().filter(|_| transfer == Some(Transfer::In)).into_iter().collect();
    let folder_of = |path: &Path| Folder::open(path.parent().unwrap_or(Path::new("")));
    let language = spoken(arguments.lang, None);
    let origin = printable(&name.to_string_lossy());
    let beside = changes && out.is_some_and(|out| out.parent() == path.parent());
    let (folder, elsewhere) = (
        if changes { Some(folder_of(path)?) } else { None },
        if beside { None } else { out.map(folder_of).transpose()? },
    );
    // All contents are on the disk before the first name is given.
    let mut sets = Vec::new();
    if let Some(folder) = &folder {
        let mut set = Set::new(folder, &inputs, Existing::Replace);
        set.write(name, |to| to.write_all(file.text().as_bytes()))?;
        sets.push(set);
    }
    if let Some(folder) = &elsewhere {
        sets.push(Set::new(folder, &[path], Existing::Keep));
    }
    if let (Some(set), Some(out)) = (sets.last_mut(), out) {
        let name = super::new::workbook_name(out)?;
        set.write(name, |to| offsets_sheet::write(file, unit, &origin, language, to))?;
    }
    for set in sets {
        verdict.files.extend(set.commit()?);
    }
    if changes {
        verdict.findings.push(ControlRunning {}.at(Place::File));
    }
    if let Some(out) = out {
        view.sheet = Some((Transfer::Out, Verdict::new(out.to_owned())));
    }
    Ok(())
}
