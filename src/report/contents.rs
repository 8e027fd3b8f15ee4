//! The contents for the templates: an outcome as texts and numbers ready to print, its figures and attachments as files.

use std::collections::{BTreeMap, VecDeque};
use std::fs;
use std::io;
use std::path::Path;

use super::attachments::files;
use super::document::{
    Answer, Check, Document, Drawing, Extent, File, Group, Heading, Key, Listed, OverallGrade, Row, SetUp, Sheet, Title,
};
use super::number;
use super::rules::CharactersByCode;
use super::shorten::{self, Listing};
use super::stationery::Logo;
use super::svg::svg;
use super::{Attachment, Role};
use crate::figure::{Figure, Ink};
use crate::finding::{Finding, Grade, Place, Raise};
use crate::gcode::control::FeedLaw;
use crate::gcode::program::{Part, Program, Style};
use crate::kind::{Outcome, Proved, Shown, checks};
use crate::machine::axis::Axis;
use crate::parameter::field::Chosen;
use crate::parameter::{FieldKind, Parameter, Value, title_block};
use crate::proof::check::Check as Checked;
use crate::table::{Entry, Print, Table};
use crate::text::{Language, Text, true_minus};
use crate::typeset::characters::{Words, code_point};
use crate::typeset::failure::ReportFailure;
use crate::typeset::pen::pen;

/// The input of a report.
pub(super) struct Contents<'a> {
    /// The outcome of the design.
    pub outcome: &'a Outcome,
    /// The files that it lists and attaches.
    pub attachments: &'a [Attachment<'a>],
    /// The picture in its title block.
    pub logo: Option<&'a Logo>,
    /// The findings about the report so far.
    pub found: Vec<Finding>,
    /// The language that it is set in.
    pub language: Language,
}

/// What the compiler sets: the JSON, with the findings of making it.
pub(super) struct Manuscript {
    /// The text of `contents.json`.
    pub json: Vec<u8>,
    /// The earlier findings, characters without a glyph, files not attached.
    pub findings: Vec<Finding>,
}

impl Contents<'_> {
    /// Puts figures, logo and attachments into the folder and returns the JSON.
    pub(super) fn write(&self, folder: &Path) -> Result<Manuscript, ReportFailure> {
        write(self, folder)
    }
}

#[expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]
fn write(contents: &Contents<'_>, folder: &Path) -> Result<Manuscript, ReportFailure> {
    let &Contents { outcome, attachments, logo, language, .. } = contents;
    let mut words = Words::new(language);
    let mut findings = contents.found.clone();
    if let Some(logo) = logo {
        fs::write(folder.join(logo.file()), logo.bytes())?;
    }
    let files = files(attachments, folder, &mut words, &mut findings)?;
    let mut programs = Vec::with_capacity(outcome.programs.len());
    for program in &outcome.programs {
        let file =
            attachments.iter().position(|one| one.role == Role::Program(program.key)).and_then(|at| files.get(at));
        programs.push(listed(program, file, &mut words)?);
    }
    let mut figures = BTreeMap::new();
    for (at, figure) in outcome.figures.iter().enumerate() {
        if let Some(drawing) = drawing(figure, at, folder, &mut words)? {
            figures.insert(figure.key, drawing);
        }
    }
    let mut document = Document {
        kind: outcome.fields.form().kind,
        language: language.code(),
        part: words.line(outcome.part()),
        material: words.line(outcome.material()),
        workbook: words.line(&outcome.source.workbook),
        sha256: outcome.source.sha256.clone(),
        version: outcome.source.version.to_owned(),
        dialect: outcome.control.name,
        style: outcome.style.map(Style::key).unwrap_or_default(),
        rotary: outcome.control.rotary.delivered.name(),
        feed_law: match feed_law(outcome) {
            FeedLaw::Resultant => "resultant",
            FeedLaw::Seconds => "seconds",
            FeedLaw::InverseTime => "inverse",
        },
        title: title(outcome, logo, &mut words),
        verdict: OverallGrade::default(),
        parameters: parameters(outcome, &mut words),
        values: outcome
            .fields
            .form()
            .parameters()
            .filter_map(|(_, parameter)| Some((parameter.key, value(outcome, parameter, &mut words)?)))
            .collect(),
        quantities: quantities(outcome, &mut words),
        tables: outcome
            .tables
            .iter()
            .filter(|table| !matches!(table.print, Print::No | Print::Formulas) && table.rows() > 0)
            .map(|one| sheet(one, &mut words))
            .collect(),
        figures,
        programs,
        setup: outcome.setup.iter().map(|(name, shown)| (*name, set_up(shown, &mut words))).collect(),
        answers: outcome.checks.iter().map(|check| answer(check, outcome, &mut words)).collect(),
        checks: Vec::new(),
        files,
    };
    let checks: Vec<Check> = outcome.findings.iter().map(|finding| check(finding, &mut words)).collect();
    if !words.missing.is_empty() {
        findings.push(without_glyph(&words.missing));
    }
    let (what, grade) = checks::verdict(outcome.stopped(), outcome.findings.iter().chain(&findings));
    let passed = words.text(&checks::passed(&outcome.checks));
    document.verdict = OverallGrade { grade: key(grade), what: words.text(&what), passed };
    document.checks = checks;
    document.checks.extend(findings.iter().map(|finding| check(finding, &mut words)));
    Ok(Manuscript { json: serde_json::to_vec(&document)?, findings })
}

/// What F is in the programs for the outcome's own control: a blank is turned on another.
fn feed_law(outcome: &Outcome) -> FeedLaw {
    let own = outcome.programs.iter().find(|program| program.is_for(outcome.control));
    own.map_or(outcome.control.feed.law, |program| program.law)
}

/// The note on characters that no font of the report has.
fn without_glyph(missing: &[char]) -> Finding {
    let mut list: String = missing.iter().take(12).map(|&one| code_point(one)).collect::<Vec<_>>().join(" ");
    if missing.len() > 12 {
        list.push_str(" …");
    }
    CharactersByCode {}.at(Place::File).with(list, "")
}

fn set_up(shown: &Shown, words: &mut Words) -> SetUp {
    match shown {
        Shown::Whether(so) => SetUp::Whether(*so),
        Shown::Length(length) => SetUp::Length(number::trimmed(*length, 4)),
        Shown::Words(line) => SetUp::Words(words.line(line)),
        Shown::Rows(rows) => {
            SetUp::Rows(rows.iter().map(|row| row.iter().map(|cell| words.text(cell)).collect()).collect())
        }
    }
}

fn value(outcome: &Outcome, parameter: &Parameter, words: &mut Words) -> Option<String> {
    match outcome.fields.values().values.get(parameter.key)? {
        Value::Real(value) => Some(number::given(*value)),
        Value::Whole(value) => Some(value.to_string()),
        Value::Choice(key) => match &parameter.kind {
            FieldKind::Choice(choices) => {
                choices.iter().find(|choice| choice.key == *key).map(|choice| words.text(&choice.label))
            }
            _ => Some((*key).to_owned()),
        },
        Value::Line(line) => Some(words.line(line)),
    }
}

fn title(outcome: &Outcome, logo: Option<&Logo>, words: &mut Words) -> Title {
    let mut line = |field| words.line(outcome.fields.values().line(field));
    Title {
        customer: line(&title_block::CUSTOMER),
        drawing: line(&title_block::DRAWING),
        revision: line(&title_block::REVISION),
        date: line(&title_block::DATE),
        author: line(&title_block::AUTHOR),
        checker: line(&title_block::CHECKER),
        logo: logo.map(Logo::file),
    }
}

/// The parameters by section, without sheets that have no value, and without the title block, which has its own place.
fn parameters(outcome: &Outcome, words: &mut Words) -> Vec<Group> {
    let mut groups = Vec::new();
    for (number, sheet) in outcome.fields.form().sheets.iter().enumerate() {
        let given = |parameter: &Parameter| outcome.fields.values().values.contains_key(parameter.key);
        if !sheet.sections.iter().flat_map(|section| section.parameters).any(|one| given(one)) {
            continue;
        }
        for section in sheet.sections {
            let rows: Vec<Row> = section
                .parameters
                .iter()
                .filter(|parameter| !matches!(parameter.kind, FieldKind::Schema) && !title_block::holds(parameter))
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
    let count = table.rows();
    let whole = table.print == Print::Whole;
    let (head, omitted, tail) = if whole { (0..count, 0, count..count) } else { shorten::rows(count) };
    let counted = table.index.counted();
    // Points keep the decimals of their unit, as published annexes do; elsewhere a column has those that its values need.
    let decimals: Vec<usize> = table
        .columns
        .iter()
        .map(|column| {
            let values = (0..column.values.len()).filter_map(|row| match column.values.get(row) {
                Entry::Number(value) => Some(value),
                Entry::Text(_) => None,
            });
            number::needed(values, number::decimals(column.unit), counted)
        })
        .collect();
    let mut line = |row: usize| -> Vec<String> {
        let index = counted.then(|| row.to_string());
        let cells = table.columns.iter().zip(&decimals).map(|(column, decimals)| {
            if row >= column.values.len() {
                return String::new();
            }
            match column.values.get(row) {
                Entry::Number(value) => number::fixed(value, *decimals),
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
                text: matches!(column.values, crate::table::Cells::Texts(_)),
            })
            .collect(),
        head,
        omitted,
        tail,
    }
}

#[expect(clippy::disallowed_methods, reason = "the door into the compiler's folder")]
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

fn listed(proved: &Proved, file: Option<&File>, words: &mut Words) -> io::Result<Listed> {
    let program = &proved.program;
    let mut listing = Listing::of(program)?;
    for line in listing.head.iter_mut().chain(&mut listing.tail) {
        *line = words.line(line);
    }
    let account = &proved.account;
    let mut summary = program.summary();
    if summary.blocks == 0 {
        // A program that is on a sheet line by line.
        summary.blocks = program.parts.len() as u64;
    }
    let path = account.feed_path + account.rapid_path;
    let (timed, time) = proved.time_in_words();
    Ok(Listed {
        key: program.key,
        title: words.text(&program.title),
        dialect: program.control.name,
        widest: listing.widest(),
        listing,
        ends: ends(program, words)?,
        file: file.map(|file| file.name.clone()).unwrap_or_default(),
        stored: stored(program).map(|name| words.text(&name)).unwrap_or_default(),
        sha256: file.map(|file| file.sha256.clone()).unwrap_or_default(),
        blocks: number::grouped(summary.blocks),
        bytes: number::grouped(summary.bytes),
        path: if path > 0.0 { number::fixed(path, 1) } else { String::new() },
        start: start(program),
        timed,
        time,
        extents: extents(proved),
    })
}

/// The extents of each axis that a program names, at feed and in all; X of a lathe as programmed, as a diameter.
fn extents(Proved { program, account, .. }: &Proved) -> Vec<Extent> {
    let Some(whole) = account.program else { return Vec::new() };
    let turning = program.control.turns();
    let named = |axis: &Axis| match axis {
        Axis::X => true,
        axis => whole.of(*axis) != [0.0, 0.0],
    };
    let reach = |axis: Axis| {
        let factor = if turning && axis == Axis::X { 2.0 } else { 1.0 };
        let ends = |[least, greatest]: [f64; 2]| [least, greatest].map(|at| number::fixed(factor * at, 3));
        let [least, greatest] = ends(whole.of(axis));
        Extent {
            axis: axis.letter().to_string(),
            unit: if axis.rotary() { "°" } else { "mm" },
            least,
            greatest,
            feed: account.feed.map(|feed| ends(feed.of(axis))),
        }
    };
    Axis::ALL.into_iter().filter(named).map(reach).collect()
}

/// How many blocks of a program are shown from its beginning and from its end, for comparing at the control.
const ENDS: usize = 3;

/// The first and the last blocks of a program, comments left out: what the control shows.
fn ends(program: &Program, words: &mut Words) -> io::Result<[Vec<String>; 2]> {
    let (mut first, mut last) = (Vec::new(), VecDeque::with_capacity(ENDS + 1));
    program.for_each(&mut |number, text| {
        if program.control.text.comment.is_no_block(text) {
            return Ok(());
        }
        let line = match number {
            Some(number) => format!("N{number} {text}"),
            None => text.to_owned(),
        };
        if first.len() < ENDS {
            first.push(line);
        } else {
            last.push_back(line);
            if last.len() > ENDS {
                last.pop_front();
            }
        }
        Ok(())
    })?;
    Ok([first, last.into()].map(|lines: Vec<String>| lines.iter().map(|line| words.line(line)).collect()))
}

/// How the program's file is named at the control, by the number in the program's opening; `None` where any name will do.
fn stored(program: &Program) -> Option<Text> {
    let text = &program.control.text;
    let lines = program.parts.iter().filter_map(|part| match part {
        Part::Opening(line) | Part::Line(line) => Some(line.as_str()),
        Part::Comment(_) | Part::Block(_) | Part::Away(_) | Part::Path(_) => None,
    });
    let number = text.opening.iter().zip(lines).find_map(|(opening, line)| opening.number(line));
    text.file.told(number)
}

/// The start position, in words, of a program that does not move there itself; empty for one that does.
fn start(program: &Program) -> String {
    if program.finds_its_start() {
        return String::new();
    }
    let named =
        |axis: &Axis| program.parts.iter().any(|part| matches!(part, Part::Path(path) if path.axes.contains(axis)));
    let word = |axis: Axis| format!("{}{}", axis.letter(), program.start.get(axis).value());
    Axis::ALL.into_iter().filter(named).map(word).collect::<Vec<_>>().join(" ")
}

fn answer(check: &Checked, outcome: &Outcome, words: &mut Words) -> Answer {
    let program = outcome.programs.iter().find(|program| program.key == check.program());
    Answer {
        key: check.key(),
        program: program.map_or_else(|| check.program().to_owned(), |program| words.text(&program.title)),
        what: words.text(check.name()),
        value: true_minus(&words.text(check.value())),
        limit: true_minus(&words.text(check.limit())),
        measured: check.measured().filter(|value| value.is_finite()),
        place: check.at().map_or_else(String::new, |at| words.text(&at.words())),
        verdict: check.grade().map_or("passed", key),
        word: words.text(&check.word()),
    }
}

/// A grade for the templates.
const fn key(grade: Grade) -> &'static str {
    match grade {
        Grade::Note => "note",
        Grade::Caution => "caution",
        Grade::Stop => "stop",
    }
}

fn check(finding: &Finding, words: &mut Words) -> Check {
    let [value, limit] = finding.shown(words.language);
    Check {
        grade: key(finding.grade),
        name: words.text(&finding.grade.name()),
        code: finding.code(),
        what: true_minus(&words.text(&finding.what)),
        place: words.text(&checks::place(&finding.place)),
        value: true_minus(&words.line(value)),
        limit: true_minus(&words.line(limit)),
        remedy: true_minus(&words.text(&finding.remedy)),
    }
}
