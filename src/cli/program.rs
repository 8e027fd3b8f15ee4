//! How the commands read a program's file: control, machine, and what stands beside it.

use std::cell::RefCell;
use std::io::BufRead;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use serde::Serialize;

use super::args::ControlOptions;
use super::rules::*;
use super::{plan, reading};
use crate::escape::printable_path;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::gcode::control::guess::guess;
use crate::gcode::control::{Control, foreign};
use crate::gcode::interpreter::tool_table;
use crate::gcode::interpreter::{Files, Interpreter, Setting, Tools};
use crate::gcode::rules::lexis::OtherControlLikely;
use crate::kinds::lathe::findings::{Reached, assumed};
use crate::kinds::lathe::parameters::FORM;
use crate::kinds::lathe::setup::Given;
use crate::limits::LEADER_LINES;
use crate::machine::length_unit::LengthUnit;
use crate::machine::var_file::VarFile;
use crate::parameter::field::Fields;
use crate::store;
use crate::text::{Language, Text};
use crate::workbook::{self, Input};

/// How the file of a workbook begins: it is a package.
pub(super) const PACKAGE: &[u8] = b"PK\x03\x04";

/// A file that was read beside a program, with its SHA-256.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(super) struct Consulted {
    /// As it was given, in characters.
    path: String,
    /// The SHA-256 of its bytes, in lower-case hexadecimal.
    sha256: String,
}

impl Consulted {
    fn new(path: &Path, bytes: &[u8]) -> Self {
        Self { path: path.to_string_lossy().into_owned(), sha256: store::sha256(bytes) }
    }
}

/// Subprograms that stand beside the program, or in other folders.
pub(super) struct SubprogramFiles {
    folders: Vec<PathBuf>,
    /// Those that were read.
    read: Rc<RefCell<Vec<Consulted>>>,
}

impl SubprogramFiles {
    /// Beside a program.
    pub(super) fn of(program: &Path) -> Self {
        Self::or_in(program, &[])
    }

    /// Beside a program, else in folders in their order.
    fn or_in(program: &Path, folders: &[PathBuf]) -> Self {
        let own = plan::beside(program).to_owned();
        Self { folders: std::iter::once(own).chain(folders.iter().cloned()).collect(), read: Rc::default() }
    }
}

impl Files for SubprogramFiles {
    #[expect(clippy::disallowed_methods, reason = "the door to the files that the command names")]
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
        for (folder, ending) in
            self.folders.iter().flat_map(|folder| [".ngc", ".nc", ""].map(|ending| (folder, ending)))
        {
            let path = folder.join(format!("{name}{ending}"));
            if path.is_file() {
                let bytes = workbook::open_as(Input::Program, &path).map_err(|refusal| refusal.reason())?;
                let found = Consulted::new(&path, &bytes);
                let mut read = self.read.borrow_mut();
                if !read.contains(&found) {
                    read.push(found);
                }
                return Ok(Some(bytes));
            }
        }
        Ok(None)
    }
}

/// What all programs of one command share.
pub(super) struct Shared<'a> {
    control: &'a ControlOptions,
    var_file: VarFile,
    tools: Option<Tools>,
    /// The lathe workbook in place of a tool table.
    workbook: Option<Given>,
    /// The language of that workbook.
    pub(super) language: Option<Language>,
    pub(super) unit: LengthUnit,
    settled: Vec<Finding>,
    /// The parameter file and the tool table.
    consulted: Vec<Consulted>,
    /// The subprograms of the program in hand.
    subprograms: Rc<RefCell<Vec<Consulted>>>,
}

impl<'a> Shared<'a> {
    /// The parameter file and the tool table, or the lathe workbook in its place, that were named.
    ///
    /// # Errors
    /// Where one of them cannot be read.
    pub(super) fn new(control: &'a ControlOptions) -> Result<Self, Refusal> {
        let beside = [&control.var, &control.tools].into_iter().flatten().map(|file| plan::beside(file));
        let settled = reading::settled(beside.chain(control.subs.iter().map(PathBuf::as_path)))?;
        let unit = if control.inch { LengthUnit::Inch } else { LengthUnit::Millimetre };
        let mut consulted = Vec::new();
        let mut bytes = |input, path: &'a Option<PathBuf>| {
            let Some(path) = path.as_deref() else { return Ok(None) };
            let bytes = workbook::open_as(input, path).map_err(|refusal| of_file(refusal, path))?;
            consulted.push(Consulted::new(path, &bytes));
            Ok(Some((path, bytes)))
        };
        let var_file = bytes(Input::VarFile, &control.var)?
            .map(|(path, bytes)| VarFile::parse(&bytes).map_err(|refusal| of_file(refusal, path)))
            .transpose()?;
        let (mut tools, mut workbook, mut language) = (None, None, None);
        match bytes(Input::ToolTable, &control.tools)? {
            Some((path, bytes)) if bytes.starts_with(PACKAGE) => {
                language = workbook::language(&bytes, &[&FORM]);
                let given = given(&bytes).map_err(|refusal| of_file(of_workbook(refusal, Some(path)), path))?;
                workbook = Some(given);
            }
            Some((path, bytes)) => {
                tools = Some(tool_table::parse(&bytes, unit).map_err(|refusal| of_file(refusal, path))?);
            }
            None => {}
        }
        Ok(Self {
            control,
            var_file: var_file.unwrap_or_default(),
            tools,
            workbook,
            language,
            unit,
            settled,
            consulted,
            subprograms: Rc::default(),
        })
    }

    /// What was done with sets that killed runs left half delivered beside the program, the parameter file and the tool
    /// table.
    ///
    /// # Errors
    /// Exit 3 where files of two sets are mixed there.
    pub(super) fn settled(&self, program: &Path) -> Result<Vec<Finding>, Refusal> {
        let mut found = self.settled.clone();
        found.extend(reading::settled([plan::beside(program)])?);
        Ok(found)
    }

    /// The control of a program: as named (true), or told from its beginning. What cannot be read is refused in its turn.
    pub(super) fn control(&self, path: &Path, file: &mut dyn BufRead) -> (bool, &'static Control) {
        let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
        match self.control.dialect {
            Some(control) => (true, control),
            None => (false, guess(file.fill_buf().unwrap_or_default(), &ending, self.workbook.is_some())),
        }
    }

    /// What was read beside the program that was read last: parameter file, tool table and subprograms.
    pub(super) fn consulted(&self) -> Vec<Consulted> {
        self.consulted.iter().chain(self.subprograms.borrow().iter()).cloned().collect()
    }

    /// Whether the tools that were named are for a control.
    ///
    /// # Errors
    /// Of a lathe workbook for a program of a milling machine.
    pub(super) fn fits(&self, control: &Control) -> Result<(), Refusal> {
        if self.workbook.is_none() || control.turns() {
            return Ok(());
        }
        Err(LatheToolsForMill { control: control.name }.refused(Exit::Refused, Place::File))
    }

    /// What the lathe workbook leaves to be assumed for a program that has been read; with a parameter file, nothing.
    pub(super) fn assumed(&self, interpreter: &Interpreter<'_>) -> Vec<Finding> {
        let Some(given) = self.workbook.as_ref().filter(|_| self.var_file.is_empty()) else { return Vec::new() };
        assumed(given, &Reached::by(interpreter))
    }

    /// What a program is read with.
    pub(super) fn setting(&self, path: &Path, control: &'static Control) -> Setting {
        let mut setting = Setting::new(control);
        setting.unit = self.unit;
        setting.var_file = self.var_file.clone();
        setting.tools = self.tools.clone();
        setting.decimal_point = self.control.decimal_point;
        setting.hole_plane = self.control.hole_r;
        setting.rotary = self.control.rotary.unwrap_or(control.rotary.delivered);
        setting.block_delete = self.control.block_delete;
        if let Some(given) = &self.workbook {
            given.lend(&mut setting);
        }
        setting.keep_g92 = !self.control.no_g92_persistence;
        self.subprograms.borrow_mut().clear();
        let beside = SubprogramFiles::or_in(path, &self.control.subs);
        setting.files = Box::new(SubprogramFiles { read: Rc::clone(&self.subprograms), ..beside });
        setting
    }
}

/// What a lathe workbook gives.
fn given(bytes: &[u8]) -> Result<Given, Refusal> {
    let filled = workbook::read(bytes, &[&FORM])?;
    Given::of(&Fields::of(&FORM, filled.values)?).map_err(|findings| Refusal { exit: Exit::Refused, findings })
}

/// A refusal of a file beside the program, with its findings in that file.
pub(super) fn of_file(refusal: Refusal, file: &Path) -> Refusal {
    let name = file.to_string_lossy();
    let findings = refusal.findings.into_iter().map(|finding| finding.beside(&name)).collect();
    Refusal { exit: refusal.exit, findings }
}

/// A refusal of the workbook beside the program, whose name its findings say: the place they are printed with is the
/// program's.
pub(super) fn of_workbook(refusal: Refusal, tools: Option<&Path>) -> Refusal {
    let findings = refusal.findings.into_iter().map(|finding| told_of(finding, tools)).collect();
    Refusal { exit: refusal.exit, findings }
}

/// The same of one finding, where it is not of a line of the program.
pub(super) fn told_of(finding: Finding, tools: Option<&Path>) -> Finding {
    let Some(tools) = tools.filter(|_| !matches!(finding.place, Place::Line { .. } | Place::Subprogram { .. })) else {
        return finding;
    };
    finding.of_file(&printable_path(tools))
}

/// The note on a control that nobody named.
pub(super) fn told_from(control: &Control) -> Finding {
    ControlGuessed { control: control.name }.at(Place::File)
}

/// The caution on a program of a guessed control that has a sign of a control that rodete does not read: the ending of its file's name, or
/// a comment. Not beside the refusal that says the same.
pub(super) fn told_other(path: &Path, head: &[u8], control: &Control) -> Option<Finding> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    let found = String::from_utf8_lossy(head)
        .lines()
        .take(LEADER_LINES)
        .find_map(foreign::sign)
        .or_else(|| foreign::of_ending(&ending));
    let foreign::Foreign { control: other, sign } = found?;
    Some(OtherControlLikely { control: other, sign, dialect: control.name }.at(Place::File))
}
