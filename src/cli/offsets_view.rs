//! Work offsets as a person and as a script reads them.

use std::collections::BTreeMap;

use anstyle::Style;
use serde::Serialize;

use super::terminal::Terminal;
use super::verdict::{Verdict, code, status};
use super::{OFFSETS, finding, json, show};
use crate::escape::printable_path;
use crate::finding::{Exit, Finding};
use crate::gcode::offset_preamble::{axes, decimals, value};
use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;
use crate::machine::var_file::VarFile;
use crate::machine::work_offset::{G28_FIRST, G30_FIRST, G92_FIRST, Offsets, System};
use crate::text::{Language, Text, t};

/// Which way offsets went between the file and the workbook that was named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Transfer {
    /// It was read into the file.
    In,
    /// It was written from the file.
    Out,
}

/// What there is to show.
#[derive(Debug)]
pub(super) struct View {
    /// The unit of the machine's lengths.
    pub(super) unit: LengthUnit,
    /// The file as it stands in the end; none where the command was refused.
    pub(super) file: Option<VarFile>,
    /// The blocks that set the same offsets.
    pub(super) preamble: Vec<String>,
    /// The workbook that was named, and which way it went.
    pub(super) sheet: Option<(Transfer, Verdict)>,
}

/// The rows besides the systems, with their first parameter.
const OTHERS: [(&str, u32); 3] = [("G92", G92_FIRST), ("G28", G28_FIRST), ("G30", G30_FIRST)];

/// Prints the offsets, the blocks, what was found in the file and in the workbook, and what was written. Stops and
/// cautions go to standard error, the rest to standard output.
pub(super) fn show(verdict: &Verdict, view: &View, language: Language, terminal: &mut Terminal) {
    let name = printable_path(&verdict.workbook);
    let width = terminal.width;
    if let Some(file) = &view.file {
        let bold = Style::new().bold();
        let unit = view.unit.symbol();
        terminal.out(&format!("{bold}{name}{bold:#}  {unit}, °\n\n{}\n", table(file, view.unit, language)));
        let blocks: String = view.preamble.iter().map(|block| format!("{block}\n")).collect();
        terminal.out(&if blocks.is_empty() { blocks } else { format!("{blocks}\n") });
    }
    let mut found = vec![(&name, &verdict.findings)];
    let workbook = view.sheet.as_ref().map(|(_, sheet)| printable_path(&sheet.workbook));
    if let (Some(workbook), Some((_, sheet))) = (&workbook, &view.sheet) {
        found.push((workbook, &sheet.findings));
    }
    for (name, findings) in found {
        finding::faults(findings, name, language, terminal);
        finding::notes(findings, name, language, terminal);
    }
    terminal.out(&show::files(verdict));
    let transfer = view.sheet.as_ref().map(|(transfer, _)| *transfer);
    let workbook = workbook.unwrap_or_default();
    let end = match (verdict.exit, transfer) {
        (Exit::Done, Some(Transfer::In)) => Text::new(
            format!("{workbook} se ha leído y se ha escrito en {name}"),
            format!("{workbook} was read and written into {name}"),
        ),
        (Exit::Done, Some(Transfer::Out)) => Text::new(
            format!("{workbook} se ha escrito desde {name} y está listo para editar"),
            format!("{workbook} was written from {name} and is ready to edit"),
        ),
        (Exit::Done, None) if verdict.files.is_empty() => return,
        (Exit::Done, None) => Text::new(format!("{name} se ha escrito"), format!("{name} was written")),
        _ if !verdict.files.is_empty() => {
            t("solo se ha escrito lo que está en la lista", "only what is listed was written")
        }
        _ => Text::new(format!("{name}: no se ha escrito nada"), format!("{name}: nothing was written")),
    };
    let text = finding::wrapped(end.get(language), 2, width);
    if verdict.exit == Exit::Done { terminal.out(&text) } else { terminal.err(&text) }
}

/// The table: systems, G92, G28 and G30; X, Y, Z and every other axis that is not 0 somewhere.
fn table(file: &VarFile, unit: LengthUnit, language: Language) -> String {
    let (offsets, _) = Offsets::read(file, unit);
    let systems = System::ALL.map(|system| (system.name(), system.first_parameter()));
    let firsts: Vec<u32> = systems.iter().chain(&OTHERS).map(|(_, first)| *first).collect();
    let axes = axes(file, &firsts);
    let mut rows = vec![vec![String::new()]];
    if let Some(head) = rows.first_mut() {
        head.extend(axes.iter().map(|axis| axis.letter().to_string()));
        head.extend(["R".to_owned(), String::new()]);
    }
    let row = |name: &str, first: u32, rotation: Option<u32>, word: &Text| {
        let mut row = vec![name.to_owned()];
        row.extend(axes.iter().map(|axis| decimals(value(file, first, *axis))));
        row.push(rotation.map_or(String::new(), |at| decimals(file.get(at).unwrap_or(0.0))));
        row.push(word.get(language).to_owned());
        row
    };
    for system in System::ALL {
        let active = t("activo", "active");
        let word = if system == offsets.active { active } else { t("", "") };
        rows.push(row(system.name(), system.first_parameter(), Some(system.rotation_parameter()), &word));
    }
    for (name, first) in OTHERS {
        let word = match (name, offsets.g92_on) {
            ("G92", true) => t("en vigor", "in force"),
            ("G92", false) => t("no está en vigor", "not in force"),
            _ => t("posición de máquina", "machine position"),
        };
        rows.push(row(name, first, None, &word));
    }
    aligned(&rows)
}

/// Rows in columns: the first and the last to the left, numbers to the right.
fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|at| rows.iter().filter_map(|row| row.get(at)).map(|cell| cell.chars().count()).max().unwrap_or(0))
        .collect();
    rows.iter()
        .map(|row| {
            let cells: Vec<_> =
                row.iter()
                    .zip(&widths)
                    .enumerate()
                    .map(|(at, (cell, width))| {
                        if at == 0 || at + 1 == columns { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
                    })
                    .collect();
            format!("{}\n", cells.join("  ").trim_end())
        })
        .collect()
}

/// The whole document.
#[derive(Serialize)]
struct Document<'a> {
    schema: &'static str,
    rodete: &'static str,
    command: &'static str,
    exit: u8,
    status: &'static str,
    file: String,
    sha256: Option<&'a str>,
    unit: &'static str,
    offsets: Option<ShownOffsets>,
    preamble: &'a [String],
    findings: &'a [Finding],
    workbook: Option<Sheet<'a>>,
    files: Vec<json::File<'a>>,
}

/// The offsets, in the machine's unit and in degrees, by axis; `R` is the rotation.
#[derive(Serialize)]
struct ShownOffsets {
    active: &'static str,
    systems: BTreeMap<&'static str, BTreeMap<char, f64>>,
    g92_in_force: bool,
    g92: BTreeMap<char, f64>,
    g28: BTreeMap<char, f64>,
    g30: BTreeMap<char, f64>,
}

/// The workbook.
#[derive(Serialize)]
struct Sheet<'a> {
    workbook: String,
    way: &'static str,
    sha256: Option<&'a str>,
    findings: &'a [Finding],
}

/// The JSON document: the file's end, its offsets after all edits, the blocks, findings, and the files written. `sha256`
/// is that of the file as it was read.
pub(super) fn document(verdict: &Verdict, view: &View) -> String {
    json::laid_out(&Document {
        schema: json::SCHEMA,
        rodete: env!("CARGO_PKG_VERSION"),
        command: OFFSETS,
        exit: code(verdict.exit),
        status: status(verdict.exit),
        file: verdict.workbook.to_string_lossy().into_owned(),
        sha256: verdict.sha256.as_deref(),
        unit: view.unit.symbol(),
        offsets: view.file.as_ref().map(|file| shown_offsets(file, view.unit)),
        preamble: &view.preamble,
        findings: &verdict.findings,
        workbook: view.sheet.as_ref().map(|(transfer, sheet)| Sheet {
            workbook: sheet.workbook.to_string_lossy().into_owned(),
            way: match transfer {
                Transfer::In => "read",
                Transfer::Out => "written",
            },
            sha256: sheet.sha256.as_deref(),
            findings: &sheet.findings,
        }),
        files: json::files(&verdict.files),
    })
}

fn shown_offsets(file: &VarFile, unit: LengthUnit) -> ShownOffsets {
    let (offsets, _) = Offsets::read(file, unit);
    let pose = |first: u32| -> BTreeMap<char, f64> {
        Axis::ALL.into_iter().map(|axis| (axis.letter(), value(file, first, axis) + 0.0)).collect()
    };
    let systems = System::ALL.into_iter().map(|system| {
        let mut values = pose(system.first_parameter());
        values.insert('R', file.get(system.rotation_parameter()).unwrap_or(0.0) + 0.0);
        (system.name(), values)
    });
    ShownOffsets {
        active: offsets.active.name(),
        systems: systems.collect(),
        g92_in_force: offsets.g92_on,
        g92: pose(G92_FIRST),
        g28: pose(G28_FIRST),
        g30: pose(G30_FIRST),
    }
}
