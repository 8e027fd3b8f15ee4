//! How the commands read a program's file: dialect, machine, and what stands beside it.

use std::io::BufRead;
use std::path::{Path, PathBuf};

use super::args::Control;
use super::reading;
use super::turning::of_workbook;
use crate::finding::{Exit, Finding, Place, Refusal};
use crate::gcode::dialect::Dialect;
use crate::gcode::dialect::told::told;
use crate::gcode::interpreter::tool_table;
use crate::gcode::interpreter::{Files, Setting, Tools};
use crate::lathe::parameters::FORM;
use crate::lathe::setup::Given;
use crate::machine::length_unit::LengthUnit;
use crate::machine::var_file::VarFile;
use crate::text::Text;
use crate::workbook::{self, Input};

/// How the file of a workbook begins: it is a package.
pub(super) const PACKAGE: &[u8] = b"PK\x03\x04";

/// Subprograms that stand beside the program, or in other folders.
pub(super) struct Beside(Vec<PathBuf>);

impl Beside {
    /// Beside a program.
    pub(super) fn of(program: &Path) -> Self {
        Self::or_in(program, &[])
    }

    /// Beside a program, else in folders in their order.
    fn or_in(program: &Path, folders: &[PathBuf]) -> Self {
        let own = program.parent().unwrap_or(Path::new("")).to_owned();
        Self(std::iter::once(own).chain(folders.iter().cloned()).collect())
    }
}

impl Files for Beside {
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, String> {
        for (folder, ending) in self.0.iter().flat_map(|folder| [".ngc", ".nc", ""].map(|ending| (folder, ending))) {
            let path = folder.join(format!("{name}{ending}"));
            if path.is_file() {
                return workbook::open_as(Input::Program, &path).map(Some).map_err(|refusal| {
                    refusal.findings.first().map_or_else(String::new, |finding| finding.what.en.to_string())
                });
            }
        }
        Ok(None)
    }
}

/// What all programs of one command share.
pub(super) struct Shared<'a> {
    control: &'a Control,
    var_file: VarFile,
    tools: Option<Tools>,
    /// The lathe workbook in place of a tool table.
    workbook: Option<Given>,
    unit: LengthUnit,
    settled: Vec<Finding>,
}

impl<'a> Shared<'a> {
    /// The parameter file and the tool table, or the lathe workbook in its place, that were named.
    ///
    /// # Errors
    /// Where one of them cannot be read.
    pub(super) fn new(control: &'a Control) -> Result<Self, Refusal> {
        let settled =
            reading::settled([&control.var, &control.tools].into_iter().flatten().map(|file| reading::beside(file)))?;
        let unit = if control.inch { LengthUnit::Inch } else { LengthUnit::Millimetre };
        let bytes =
            |input, path: &Option<PathBuf>| path.as_deref().map(|path| workbook::open_as(input, path)).transpose();
        let var_file = bytes(Input::VarFile, &control.var)?.map(|bytes| VarFile::parse(&bytes)).transpose()?;
        let (mut tools, mut workbook) = (None, None);
        match bytes(Input::ToolTable, &control.tools)? {
            Some(bytes) if bytes.starts_with(PACKAGE) => {
                let given = given(&bytes).map_err(|refusal| of_workbook(refusal, control.tools.as_deref()))?;
                workbook = Some(given);
            }
            Some(bytes) => tools = Some(tool_table::parse(&bytes, unit)?),
            None => {}
        }
        Ok(Self { control, var_file: var_file.unwrap_or_default(), tools, workbook, unit, settled })
    }

    /// What was done with sets that killed runs left half delivered beside the program, the parameter file and the tool
    /// table.
    ///
    /// # Errors
    /// Exit 3 where files of two sets are mixed there.
    pub(super) fn settled(&self, program: &Path) -> Result<Vec<Finding>, Refusal> {
        let mut found = self.settled.clone();
        found.extend(reading::settled([reading::beside(program)])?);
        Ok(found)
    }

    /// The dialect of a program: as named (true), or told from its beginning. What cannot be read is refused in its turn.
    pub(super) fn dialect(&self, path: &Path, file: &mut dyn BufRead) -> (bool, &'static Dialect) {
        let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
        match self.control.dialect.as_deref().and_then(Dialect::named) {
            Some(dialect) => (true, dialect),
            None => (false, told(file.fill_buf().unwrap_or_default(), &ending)),
        }
    }

    /// Whether the tools that were named are for a dialect.
    ///
    /// # Errors
    /// Of a lathe workbook for a program of a milling machine.
    pub(super) fn fits(&self, dialect: &Dialect) -> Result<(), Refusal> {
        if self.workbook.is_none() || dialect.reading.diameter {
            return Ok(());
        }
        let name = dialect.name;
        let what = Text::new(
            format!("--tools es un libro de torno, y el programa se lee como {name}"),
            format!("--tools is a lathe workbook, and the program is read as {name}"),
        );
        let remedy = Text::fixed(
            "indique el control del torno con --dialect, o una tabla de herramientas de LinuxCNC",
            "name the lathe's control with --dialect, or a tool table of LinuxCNC",
        );
        Err(Refusal::new(Exit::Refused, Finding::stop(Place::File, what, remedy)))
    }

    /// What a program is read with.
    pub(super) fn setting(&self, path: &Path, dialect: &'static Dialect) -> Setting {
        let mut setting = Setting::new(dialect);
        setting.unit = self.unit;
        setting.var_file = self.var_file.clone();
        setting.tools = self.tools.clone();
        setting.point = self.control.decimal_point;
        setting.rotary = self.control.rotary.unwrap_or(dialect.rotary);
        setting.block_delete = self.control.block_delete;
        if let Some(given) = &self.workbook {
            given.lend(&mut setting);
        }
        setting.keep_g92 = !self.control.no_g92_persistence;
        setting.files = Box::new(Beside::or_in(path, &self.control.subs));
        setting
    }
}

/// What a lathe workbook gives.
fn given(bytes: &[u8]) -> Result<Given, Refusal> {
    let filled = workbook::read(bytes, &[&FORM])?;
    Given::of(&filled.values).map_err(|findings| Refusal { exit: Exit::Refused, findings })
}

/// The note on a dialect that nobody named.
pub(super) fn told_from(dialect: &Dialect) -> Finding {
    Finding::note(
        Place::File,
        Text::new(
            format!("dialecto no indicado: leído como {}", dialect.name),
            format!("dialect not named: read as {}", dialect.name),
        ),
    )
}
