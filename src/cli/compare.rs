//! The command `compare`: two workbooks of one kind side by side.

use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use anstyle::Style;
use serde_json::{Value, json};
use textwrap::core::display_width;

use super::args::Compare;
use super::finding::wrapped;
use super::interrupt::AtWork;
use super::locale::spoken;
use super::made::Made;
use super::new::workbook_name;
use super::rules::*;
use super::terminal::Terminal;
use super::verdict::{code, gravest, status};
use super::{build, finding, interrupt, json, plan, reading, refused};
use crate::escape::printable_path;
use crate::finding::{Exit, Finding, Place, Raise, Refusal};
use crate::kind::comparison::sheets::Sheet;
use crate::kind::comparison::{Comparison, Found, Input, ProgramPair, Shown};
use crate::kind::{Kind, Wants};
use crate::limits::LISTED_DIFFERENCES;
use crate::machine::axis::{Axis, Pose};
use crate::report::comparison::{self, ComparedWorkbook};
use crate::store::rules::OutputIsInput;
use crate::store::{Existing, Folder, Set, WrittenFile};
use crate::text::{Language, Text, t};
use crate::workbook::{self, comparison_book};

/// Columns wider than this stand on lines of their own.
const WIDE: usize = 34;

/// Compares, and prints or writes what differs.
pub(super) fn run(arguments: &Compare, kinds: &[&dyn Kind], terminal: &mut Terminal) -> Exit {
    let asked = arguments.output.iter().try_for_each(|file| fit(file, [&arguments.one, &arguments.other]));
    if let Err(refusal) = asked {
        return refused(&refusal, spoken(arguments.lang, None), terminal);
    }
    let interrupted = interrupt::listen(spoken(arguments.lang, None));
    let sides = [&arguments.one, &arguments.other].map(|path| computed(path, kinds));
    let language = spoken(arguments.lang, sides[0].verdict.language);
    let mut exit = Exit::Done;
    for side in &sides {
        // Values that contradict each other can be compared; what could not be read cannot.
        if side.values.is_none() || side.verdict.exit != Exit::Refused {
            exit = gravest(exit, side.verdict.exit);
        }
        if side.values.is_none() {
            finding::faults(&side.verdict.findings, &printable_path(&side.verdict.workbook), language, terminal);
        }
    }
    let pair = match compared(&sides) {
        Ok(pair) => pair,
        Err(refusal) => {
            if arguments.json {
                let exit = gravest(exit, refusal.exit);
                terminal.out(&json::laid_out(&document(&sides, None, exit, &refusal.findings, &[])));
            }
            return refused(&refusal, language, terminal);
        }
    };
    let Some(comparison) = pair else {
        if arguments.json {
            terminal.out(&json::laid_out(&document(&sides, None, exit, &[], &[])));
        }
        return exit;
    };
    let (mut files, mut findings) = (Vec::new(), Vec::new());
    for file in &arguments.output {
        match write(file, &sides, &comparison, language, &interrupted) {
            Ok(written) => files.extend(written),
            Err(refusal) => {
                exit = gravest(exit, refusal.exit);
                findings.extend(refusal.findings);
            }
        }
    }
    if arguments.json {
        terminal.out(&json::laid_out(&document(&sides, Some(&comparison), exit, &findings, &files)));
    } else {
        print(&sides, &comparison, language, terminal);
        for path in files.iter().map(|file| printable_path(&file.path)) {
            let text = Text::new(format!("{path} está listo\n"), format!("{path} is ready\n"));
            terminal.out(text.get(language));
        }
    }
    finding::general(&findings, language, terminal);
    exit
}

/// Whether a file that the comparison is to be written into has a name for it, and is none of the two workbooks.
///
/// # Errors
/// Exit 2.
fn fit(file: &Path, inputs: [&PathBuf; 2]) -> Result<(), Refusal> {
    file_name(file)?;
    if inputs.into_iter().any(|input| same_file::is_same_file(input, file).unwrap_or(false)) {
        return Err(OutputIsInput { path: printable_path(file) }.refused(Exit::CommandLine, Place::File));
    }
    Ok(())
}

/// The name of a PDF or a workbook to write.
///
/// # Errors
/// Exit 2 where it ends in neither.
fn file_name(file: &Path) -> Result<&OsStr, Refusal> {
    match file.file_name() {
        Some(name) if is_pdf(file) => Ok(name),
        _ => workbook_name(file),
    }
}

fn is_pdf(file: &Path) -> bool {
    file.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pdf"))
}

/// What a workbook comes to; nothing is written.
fn computed(path: &Path, kinds: &[&dyn Kind]) -> Made {
    let mut made = Made::default();
    let verdict = reading::verdict(path, |verdict| {
        let (_, filled) = reading::read(path, kinds, verdict)?;
        made.read(&filled);
        made.outcome = Some(reading::compute(path, filled, kinds, Wants::default(), verdict)?);
        Ok(())
    });
    Made { verdict, ..made }
}

/// The comparison; `None` where one of the two could not be read.
///
/// # Errors
/// Exit 3 where they are of two kinds.
fn compared(sides: &[Made; 2]) -> Result<Option<Comparison<'_>>, Refusal> {
    let [one, other] = sides;
    let (Some(form), Some(another)) = (one.form, other.form) else { return Ok(None) };
    if form.kind != another.kind {
        let [one, other] = [one, other].map(|side| printable_path(&side.verdict.workbook));
        let (kind, other_kind) = (form.kind, another.kind);
        return Err(OtherKind { one, kind, other, other_kind }.refused(Exit::Refused, Place::File));
    }
    let (Some(one), Some(other)) = (one.side(), other.side()) else { return Ok(None) };
    Ok(Some(Comparison::of(form, [one, other])))
}

/// Writes the comparison into a file, a workbook or a PDF by its name.
fn write(
    file: &Path,
    sides: &[Made; 2],
    comparison: &Comparison<'_>,
    language: Language,
    interrupted: &Arc<AtomicBool>,
) -> Result<Vec<WrittenFile>, Refusal> {
    let (pdf, name) = (is_pdf(file), file_name(file)?);
    let folder = Folder::open(plan::beside(file))?;
    let inputs: Vec<&Path> = sides.iter().map(|side| side.verdict.workbook.as_path()).collect();
    let mut set = Set::new(&folder, &inputs, Existing::Replace);
    set.check(name)?;
    // It may be a design, also one that cannot be read.
    if !pdf && workbook::open(file).is_ok_and(|there| !comparison_book::is_comparison(&there)) {
        return Err(BookInTheWay { path: printable_path(file) }.refused(Exit::Unwritable, Place::File));
    }
    let names = sides.each_ref().map(|side| printable_path(&side.verdict.workbook));
    if pdf {
        let named = [0, 1].map(|at| ComparedWorkbook {
            name: &names[at],
            sha256: sides[at].verdict.sha256.as_deref().unwrap_or_default(),
            rejected: rejected(&sides[at]),
        });
        let at_work = AtWork::begin();
        let pdf = comparison::pdf(comparison, named, language, &build::typst(None, Arc::clone(interrupted)));
        drop(at_work);
        let pdf = pdf.map_err(|failure| {
            let document = t("la comparación", "the comparison");
            Refusal { exit: Exit::ReportFailed, findings: vec![failure.finding_on(&document)] }
        })?;
        set.write(name, |out| out.write_all(&pdf))?;
    } else {
        let names = names.each_ref().map(String::as_str);
        set.write(name, |out| comparison_book::write(comparison, names, language, out))?;
    }
    set.commit()
}

/// True where a workbook is rejected: then it has no programs.
fn rejected(side: &Made) -> bool {
    side.outcome.is_none() || side.verdict.exit != Exit::Done
}

fn print(sides: &[Made; 2], comparison: &Comparison<'_>, language: Language, terminal: &mut Terminal) {
    let bold = Style::new().bold();
    let mut text = String::new();
    for (side, letter) in sides.iter().zip(["A", "B"]) {
        let path = printable_path(&side.verdict.workbook);
        let schema = side.verdict.schema.unwrap_or_default();
        let end = if rejected(side) { t(", rechazado", ", rejected").get(language).to_owned() } else { String::new() };
        text.push_str(&format!("{bold}{letter}{bold:#}  {path}  {schema}{end}\n"));
    }
    for sheet in comparison.sheets() {
        text.push_str(&table(&sheet, language, terminal.width));
    }
    let same = t("no hay diferencias", "no difference");
    let other = t("hay diferencias", "they differ");
    text.push_str(&format!("{}\n", if comparison.same() { same } else { other }.get(language)));
    terminal.out(&text);
}

/// What differs in a table, its columns under one another, and how many rows are the same.
fn table(sheet: &Sheet, language: Language, width: Option<usize>) -> String {
    let bold = Style::new().bold();
    let differing: Vec<Vec<String>> =
        sheet.lines.iter().filter(|line| line.differs).map(|line| line.texts(language)).collect();
    let same = sheet.lines.len() - differing.len();
    let mut text = format!("{bold}{}{bold:#}\n", sheet.title.get(language));
    let widths: Vec<usize> = (0..sheet.headings.len())
        .map(|at| {
            let cells = differing.iter().filter_map(|row| row.get(at)).map(|cell| display_width(cell));
            let widest = cells.max().unwrap_or(0);
            if widest == 0 { 0 } else { widest.max(display_width(sheet.headings[at].get(language))) }
        })
        .collect();
    let narrow = |at: usize| widths[at] > 0 && widths[at] <= WIDE;
    let padded = |row: &[String]| {
        let cells = row.iter().enumerate().filter(|(at, _)| narrow(*at));
        let line: String =
            cells.map(|(at, cell)| format!("  {cell}{}", " ".repeat(widths[at] - display_width(cell)))).collect();
        line.trim_end().to_owned()
    };
    if !differing.is_empty() {
        let plain = |heading: &Text| heading.get(language).replace('\u{2212}', "-");
        let headings: Vec<String> = sheet.headings.iter().map(plain).collect();
        text.push_str(&format!("{}\n", padded(&headings)));
    }
    for row in differing.iter().take(LISTED_DIFFERENCES) {
        text.push_str(&format!("{}\n", padded(row)));
        for (at, cell) in row.iter().enumerate().filter(|(at, cell)| !narrow(*at) && !cell.is_empty()) {
            let heading = sheet.headings[at].get(language);
            let line = if heading.len() == 1 { format!("      {heading}: {cell}") } else { format!("      {cell}") };
            text.push_str(&wrapped(&line, 9, width));
        }
    }
    let count = |es: &str, en: &str, count: usize| {
        let text = Text::new(format!("  {count} {es}\n"), format!("  {count} {en}\n"));
        text.get(language).to_owned()
    };
    if differing.len() > LISTED_DIFFERENCES {
        text.push_str(&count("más que difieren", "more that differ", differing.len() - LISTED_DIFFERENCES));
    }
    if same > 0 {
        text.push_str(&count("iguales", "the same", same));
    } else if differing.is_empty() {
        text.push_str(t("  ninguna\n", "  none\n").get(language));
    }
    text
}

/// The document; the findings are those of the comparison as a whole.
fn document(
    sides: &[Made; 2],
    comparison: Option<&Comparison<'_>>,
    exit: Exit,
    findings: &[Finding],
    files: &[WrittenFile],
) -> Value {
    let workbooks: Vec<Value> = sides
        .iter()
        .map(|side| {
            let verdict = &side.verdict;
            json!({
                "workbook": verdict.workbook.to_string_lossy(),
                "sha256": verdict.sha256,
                "schema": verdict.schema,
                "exit": code(verdict.exit),
                "status": status(verdict.exit),
                "findings": verdict.findings,
            })
        })
        .collect();
    let found = |wanted: fn(&Found<'_>) -> bool, side: usize| {
        let all = comparison.iter().flat_map(|one| &one.findings).filter(|one| wanted(one));
        all.filter_map(|one| one.sides[side]).collect::<Vec<_>>()
    };
    let both = |one: &Found<'_>| one.sides.iter().all(Option::is_some);
    json!({
        "schema": json::SCHEMA,
        "rodete": env!("CARGO_PKG_VERSION"),
        "command": "compare",
        "exit": code(exit),
        "status": status(exit),
        "workbooks": workbooks,
        "same": comparison.map(Comparison::same),
        "inputs": comparison.map(|one| one.inputs.iter().map(input).collect::<Vec<_>>()),
        "quantities": comparison.map(|one| {
            let quantity = |one: &crate::kind::comparison::Derived| json!({
                "symbol": one.symbol,
                "meaning": one.meaning,
                "unit": one.unit.label(),
                "values": one.values,
            });
            one.quantities.iter().map(quantity).collect::<Vec<_>>()
        }),
        "only_a": { "findings": found(|one| one.sides[1].is_none(), 0) },
        "only_b": { "findings": found(|one| one.sides[0].is_none(), 1) },
        "both": { "findings": comparison.map(|_| {
            comparison.iter().flat_map(|one| &one.findings).filter(|one| both(one)).filter_map(|one| one.sides[1])
                .collect::<Vec<_>>()
        }) },
        "programs": comparison.map(|one| one.programs.iter().map(program).collect::<Vec<_>>()),
        "findings": findings,
        "files": json::files(files),
    })
}

fn input(one: &Input) -> Value {
    let value = |value: &Option<Shown>| match value {
        None => Value::Null,
        Some(Shown::Number(number)) => json!(number),
        Some(Shown::Text(text)) => json!(text.get(Language::En)),
    };
    json!({
        "symbol": one.symbol.get(Language::En),
        "meaning": one.meaning,
        "unit": one.unit.label(),
        "values": one.values.each_ref().map(value),
        "cells": one.cells.each_ref().map(|place| place.as_ref().map(|place| format!("{}!{}", place.sheet, place.cell))),
    })
}

fn program(one: &ProgramPair) -> Value {
    let axes = |wanted: &dyn Fn(Axis) -> Value| {
        Value::Object(Axis::ALL.into_iter().map(|axis| (axis.letter().to_string(), wanted(axis))).collect())
    };
    let end = |pose: Option<Pose>| pose.map(|pose| axes(&|axis| json!(pose.get(axis) + 0.0)));
    json!({
        "program": one.key,
        "title": one.title,
        "same": one.moves_alike(),
        "motions": one.motions,
        "first": one.first.map(|first| json!({ "motion": first.motion, "lines": first.lines })),
        "words": one.words.as_ref().map(|blocks| blocks.each_ref().map(|block| {
            block.as_ref().map(|block| json!({ "line": block.line, "text": block.text }))
        })),
        "apart": one.apart.iter().map(|apart| json!({
            "axis": apart.axis.letter().to_string(),
            "by": apart.by,
            "motion": apart.motion,
        })).collect::<Vec<_>>(),
        "end": one.end.map(end),
        "extents": one.extents.map(|extents| extents.map(|extents| axes(&|axis| json!(extents.of(axis))))),
        "seconds": one.seconds,
    })
}
