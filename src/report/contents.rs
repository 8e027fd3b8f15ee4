//! What the templates set: an outcome as texts and numbers ready to print, and its figures and attachments as files.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use serde::Serialize;
use sha2::{Digest, Sha256};

use super::characters::{code_point, show};
use super::number;
use super::shorten::{self, Listing};
use super::svg::{pen, svg};
use super::{Attachment, Content, ReportFailure, Role};
use crate::figure::{Figure, Ink};
use crate::finding::{Finding, Grade, Place};
use crate::job::Outcome;
use crate::parameter::{Kind, Parameter, Value};
use crate::table::{Entry, Index, Table};
use crate::text::{Language, Text};

/// Attachments are carried up to this many bytes in all; larger ones are listed only.
const CARRIED: u64 = 32 * 1024 * 1024;

/// The JSON and what was found while it was made.
pub(super) struct Contents {
    /// The text of `contents.json`.
    pub json: Vec<u8>,
    /// Characters without a glyph, files not carried.
    pub findings: Vec<Finding>,
}

#[derive(Serialize)]
struct Document {
    kind: &'static str,
    language: &'static str,
    part: String,
    material: String,
    workbook: String,
    sha256: String,
    version: String,
    dialect: String,
    style: String,
    stopped: bool,
    parameters: Vec<Group>,
    values: std::collections::BTreeMap<&'static str, String>,
    quantities: Vec<Row>,
    tables: Vec<Sheet>,
    figures: std::collections::BTreeMap<&'static str, Drawing>,
    programs: Vec<Listed>,
    checks: Vec<Check>,
    files: Vec<File>,
}

#[derive(Serialize)]
struct Group {
    title: String,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    symbol: String,
    meaning: String,
    value: String,
    unit: &'static str,
    note: String,
}

#[derive(Serialize)]
struct Sheet {
    key: &'static str,
    name: String,
    title: String,
    source: String,
    counted: bool,
    columns: Vec<Heading>,
    head: Vec<Vec<String>>,
    omitted: usize,
    tail: Vec<Vec<String>>,
}

#[derive(Serialize)]
struct Heading {
    symbol: String,
    unit: &'static str,
    text: bool,
}

#[derive(Serialize)]
struct Drawing {
    file: String,
    caption: String,
    legend: Vec<Key>,
}

#[derive(Serialize)]
struct Key {
    colour: &'static str,
    width: f64,
    dash: &'static [f64],
    text: String,
}

#[derive(Serialize)]
struct Listed {
    key: &'static str,
    title: String,
    listing: Listing,
    widest: usize,
    file: String,
    sha256: String,
    blocks: String,
    bytes: String,
    path: String,
    time: String,
    extents: Vec<Extent>,
}

#[derive(Serialize)]
struct Extent {
    axis: String,
    unit: &'static str,
    least: String,
    greatest: String,
}

#[derive(Serialize)]
struct Check {
    grade: &'static str,
    name: String,
    what: String,
    place: String,
    value: String,
    limit: String,
    remedy: String,
}

#[derive(Serialize)]
struct File {
    name: String,
    description: String,
    sha256: String,
    bytes: String,
    mime: &'static str,
    relation: &'static str,
    carried: Option<String>,
}

/// Chooses the language and minds the characters.
struct Words {
    language: Language,
    missing: Vec<char>,
}

impl Words {
    fn text(&mut self, text: &Text) -> String {
        show(text.get(self.language), &mut self.missing)
    }

    fn line(&mut self, text: &str) -> String {
        show(text, &mut self.missing)
    }
}

/// Puts figures and attachments into the folder and returns the JSON.
pub(super) fn write(
    outcome: &Outcome,
    attachments: &[Attachment<'_>],
    language: Language,
    folder: &Path,
) -> Result<Contents, ReportFailure> {
    let mut words = Words { language, missing: Vec::new() };
    let mut findings = Vec::new();
    let files = files(attachments, folder, &mut words, &mut findings)?;
    let mut programs = Vec::with_capacity(outcome.programs.len());
    for program in &outcome.programs {
        let file =
            attachments.iter().position(|one| one.role == Role::Program(program.key)).and_then(|at| files.get(at));
        programs.push(listed(program, file, &mut words)?);
    }
    let mut figures = std::collections::BTreeMap::new();
    for (at, figure) in outcome.figures.iter().enumerate() {
        if let Some(drawing) = drawing(figure, at, folder, &mut words)? {
            figures.insert(figure.key, drawing);
        }
    }
    let line = |words: &mut Words, key| words.line(outcome.values.line(key));
    let mut document = Document {
        kind: outcome.form.kind,
        language: language.code(),
        part: line(&mut words, "part"),
        material: line(&mut words, "material"),
        workbook: words.line(&outcome.source.workbook),
        sha256: outcome.source.sha256.clone(),
        version: outcome.source.version.to_owned(),
        dialect: outcome.values.choice("dialect").unwrap_or_default().to_owned(),
        style: outcome.values.choice("style").unwrap_or_default().to_owned(),
        stopped: outcome.stopped(),
        parameters: parameters(outcome, &mut words),
        values: outcome
            .form
            .parameters()
            .filter_map(|(_, parameter)| Some((parameter.key, value(outcome, parameter, &mut words)?)))
            .collect(),
        quantities: quantities(outcome, &mut words),
        tables: outcome
            .tables
            .iter()
            .filter(|table| !matches!(table.key, "checks" | "views"))
            .map(|one| sheet(one, &mut words))
            .collect(),
        figures,
        programs,
        checks: Vec::new(),
        files,
    };
    let checks: Vec<Check> = outcome.findings.iter().map(|finding| check(finding, &mut words)).collect();
    if !words.missing.is_empty() {
        findings.push(without_glyph(&words.missing));
    }
    document.checks = checks;
    document.checks.extend(findings.iter().map(|finding| check(finding, &mut words)));
    Ok(Contents { json: serde_json::to_vec(&document)?, findings })
}

/// The note on characters that no font of the report has.
fn without_glyph(missing: &[char]) -> Finding {
    let mut list: String = missing.iter().take(12).map(|&one| code_point(one)).collect::<Vec<_>>().join(" ");
    if missing.len() > 12 {
        list.push_str(" …");
    }
    Finding::note(
        Place::File,
        Text::fixed(
            "el informe muestra por su código los caracteres que sus tipos de letra no tienen",
            "the report shows by their code the characters that its fonts do not have",
        ),
    )
    .with(list, "")
}

fn value(outcome: &Outcome, parameter: &Parameter, words: &mut Words) -> Option<String> {
    match outcome.values.values.get(parameter.key)? {
        Value::Real(value) => Some(number::given(*value)),
        Value::Whole(value) => Some(value.to_string()),
        Value::Choice(key) => match &parameter.kind {
            Kind::Choice(choices) => {
                choices.iter().find(|choice| choice.key == *key).map(|choice| words.text(&choice.label))
            }
            _ => Some((*key).to_owned()),
        },
        Value::Line(line) => Some(words.line(line)),
    }
}

/// The parameters by section; a sheet without any value is left out.
fn parameters(outcome: &Outcome, words: &mut Words) -> Vec<Group> {
    let mut groups = Vec::new();
    for (number, sheet) in outcome.form.sheets.iter().enumerate() {
        let given = |parameter: &Parameter| outcome.values.values.contains_key(parameter.key);
        if !sheet.sections.iter().flat_map(|section| section.parameters).any(given) {
            continue;
        }
        for section in sheet.sections {
            let rows: Vec<Row> = section
                .parameters
                .iter()
                .filter(|parameter| !matches!(parameter.kind, Kind::Schema))
                .map(|parameter| Row {
                    symbol: parameter.symbol().to_owned(),
                    meaning: words.text(&parameter.meaning),
                    value: value(outcome, parameter, words).unwrap_or_default(),
                    unit: parameter.unit.label(),
                    note: words.text(&parameter.note),
                })
                .collect();
            if !rows.is_empty() {
                let title = if number == 0 {
                    words.text(&section.title)
                } else {
                    format!("{}: {}", words.text(&sheet.title), words.text(&section.title))
                };
                groups.push(Group { title, rows });
            }
        }
    }
    groups
}

fn quantities(outcome: &Outcome, words: &mut Words) -> Vec<Row> {
    outcome
        .quantities
        .iter()
        .map(|quantity| Row {
            symbol: quantity.symbol.to_owned(),
            meaning: words.text(&quantity.meaning),
            value: number::quantity(quantity.value, quantity.unit),
            unit: quantity.unit.label(),
            note: words.text(&quantity.source),
        })
        .collect()
}

fn sheet(table: &Table, words: &mut Words) -> Sheet {
    let (head, omitted, tail) = shorten::rows(table.rows());
    let counted = table.index == Index::Point;
    let mut line = |row: usize| -> Vec<String> {
        let index = counted.then(|| row.to_string());
        let cells = table.columns.iter().map(|column| {
            if row >= column.values.len() {
                return String::new();
            }
            match column.values.get(row) {
                Entry::Number(value) => number::fixed(value, number::decimals(column.unit)),
                Entry::Text(text) => words.text(text),
            }
        });
        index.into_iter().chain(cells).collect()
    };
    let (head, tail) = (head.map(&mut line).collect(), tail.map(&mut line).collect());
    Sheet {
        key: table.key,
        name: words.text(&table.name),
        title: words.text(&table.title),
        source: words.text(&table.source),
        counted,
        columns: table
            .columns
            .iter()
            .map(|column| Heading {
                symbol: words.text(&column.symbol),
                unit: column.unit.label(),
                text: matches!(column.values, crate::table::Values::Texts(_)),
            })
            .collect(),
        head,
        omitted,
        tail,
    }
}

fn drawing(figure: &Figure, at: usize, folder: &Path, words: &mut Words) -> io::Result<Option<Drawing>> {
    let Some(text) = svg(figure, words.language) else { return Ok(None) };
    let file = format!("figure-{at}.svg");
    fs::write(folder.join(&file), text)?;
    let key = |(ink, text): &(Ink, Text)| {
        let pen = pen(*ink);
        Key { colour: pen.colour, width: pen.width, dash: pen.dash, text: words.text(text) }
    };
    let legend = figure.legend.iter().map(key).collect();
    Ok(Some(Drawing { file, caption: words.text(&figure.caption), legend }))
}

fn listed(program: &crate::gcode::program::Program, file: Option<&File>, words: &mut Words) -> io::Result<Listed> {
    let mut listing = Listing::of(program)?;
    for line in listing.head.iter_mut().chain(&mut listing.tail) {
        *line = words.line(line);
    }
    let summary = program.summary();
    Ok(Listed {
        key: program.key,
        title: words.text(&program.title),
        widest: listing.widest(),
        listing,
        file: file.map(|file| file.name.clone()).unwrap_or_default(),
        sha256: file.map(|file| file.sha256.clone()).unwrap_or_default(),
        blocks: number::grouped(summary.blocks),
        bytes: number::grouped(summary.bytes),
        path: number::fixed(summary.path, 1),
        time: summary.seconds.map(number::duration).unwrap_or_default(),
        extents: summary
            .extents
            .iter()
            .map(|&(axis, least, greatest)| Extent {
                axis: axis.to_string(),
                unit: if matches!(axis, 'A' | 'B' | 'C') { "°" } else { "mm" },
                least: number::fixed(least, 3),
                greatest: number::fixed(greatest, 3),
            })
            .collect(),
    })
}

fn check(finding: &Finding, words: &mut Words) -> Check {
    Check {
        grade: match finding.grade {
            Grade::Note => "note",
            Grade::Caution => "caution",
            Grade::Stop => "stop",
        },
        name: words.text(&finding.grade.name()),
        what: words.text(&finding.what),
        place: place(&finding.place, words),
        value: words.line(&finding.value),
        limit: words.line(&finding.limit),
        remedy: words.text(&finding.remedy),
    }
}

fn place(place: &Place, words: &mut Words) -> String {
    match place {
        Place::File => String::new(),
        Place::Part(name) | Place::Sheet(name) => words.line(name),
        Place::Cells(cells) => {
            let cells: Vec<String> = cells.iter().map(|one| format!("{}!{}", one.sheet, one.cell)).collect();
            words.line(&cells.join(", "))
        }
        Place::Parameters(keys) => keys.join(", "),
        Place::Point { table, index } => format!("{table}, i = {index}"),
        Place::Block { program, line } => match words.language {
            Language::Es => format!("{program}, línea {line}"),
            Language::En => format!("{program}, line {line}"),
        },
    }
}

/// Copies the attachments into the folder, with their SHA-256; what is too large is listed and not carried.
fn files(
    attachments: &[Attachment<'_>],
    folder: &Path,
    words: &mut Words,
    findings: &mut Vec<Finding>,
) -> io::Result<Vec<File>> {
    let mut carried = 0;
    let mut files = Vec::with_capacity(attachments.len());
    for (at, attachment) in attachments.iter().enumerate() {
        let (bytes, sha256) = match attachment.content {
            Content::Bytes(bytes) => (u64::try_from(bytes.len()).unwrap_or(u64::MAX), digest(bytes)?),
            Content::File(path) => (fs::metadata(path)?.len(), digest(fs::File::open(path)?)?),
        };
        let name = words.line(&attachment.name);
        let copy = (bytes <= CARRIED - carried).then(|| format!("attachment-{at}"));
        match &copy {
            Some(copy) => {
                carried += bytes;
                match attachment.content {
                    Content::Bytes(bytes) => fs::write(folder.join(copy), bytes)?,
                    Content::File(path) => fs::copy(path, folder.join(copy)).map(drop)?,
                }
            }
            None => findings.push(
                Finding::note(
                    Place::File,
                    Text::new(
                        format!("{name} es demasiado grande para adjuntarlo al informe; se da su SHA-256"),
                        format!("{name} is too large to be attached to the report; its SHA-256 is given"),
                    ),
                )
                .with(format!("{} bytes", number::grouped(bytes)), format!("{} bytes", number::grouped(CARRIED))),
            ),
        }
        files.push(File {
            name,
            description: words.text(&attachment.description),
            sha256,
            bytes: number::grouped(bytes),
            mime: attachment.mime,
            relation: if attachment.role == Role::Input { "source" } else { "supplement" },
            carried: copy,
        });
    }
    Ok(files)
}

/// SHA-256 in lower-case hexadecimal.
fn digest(mut bytes: impl Read) -> io::Result<String> {
    let mut hash = Sha256::new();
    let mut buffer = [0; 64 * 1024];
    loop {
        let count = match bytes.read(&mut buffer) {
            Ok(0) => break,
            Ok(count) => count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
        };
        hash.update(buffer.get(..count).unwrap_or_default());
    }
    Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}
