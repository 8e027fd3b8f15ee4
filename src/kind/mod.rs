//! A workbook kind, and what every one comes to: tables, programs, charts, drawings and findings in one outcome.
//!
//! [`Kind`] is all that commands and walls see of one. A kind that plans and writes programs is a [`Method`](method::Method):
//! the way from its values to an outcome is [`Of`](method::Of), written once.

pub mod checks;
pub mod comparison;
mod faults;
pub mod live_form;
pub mod measure;
pub mod method;
pub mod rules;
mod staging;

use std::fmt;
use std::ops::Deref;
use std::sync::LazyLock;

use serde::Serialize;

use self::rules::PositionOutOfFormat;
use crate::figure::{Arc, Figure, Paper};
use crate::finding::{Exit, Finding, Grade, Key, Raise, Refusal, Rule, gravest_first};
use crate::gcode::control::Control;
use crate::gcode::interpreter::Setting;
use crate::gcode::program::{Program, Style};
use crate::kind::live_form::LiveForm;
use crate::kind::measure::{Limits, Measure, Suggested};
use crate::number::grid::OutOfFormat;
use crate::number::{duration, least_duration};
use crate::parameter::field::Fields;
use crate::parameter::{Case, Form, at};
use crate::proof::account::Account;
use crate::proof::check::Check;
use crate::scene::Scene;
use crate::table::{Quantity, Table};
use crate::text::{Text, all_of};

/// A workbook kind: all that commands and walls see of it.
pub trait Kind: Send + Sync {
    /// What the user fills in: sheets, lists, the keys of what its builds write.
    fn form(&self) -> &'static Form;

    /// The cases that a new workbook can start from, the usual one first.
    fn cases(&self) -> &'static [Case];

    /// The part with the symbols of its form, for the form; `None` where there is nothing to draw.
    fn sketch(&self) -> Option<Figure> {
        None
    }

    /// What the form computes while it is being filled in; `None` where that is nothing.
    fn live(&self) -> Option<LiveForm> {
        None
    }

    /// What it brings to the report.
    fn chapters(&self) -> &'static Chapters;

    /// The rows of its own findings, one list for each of its `rules.rs`. Kinds may share lists.
    fn rules(&self) -> &'static [&'static [&'static Rule]];

    /// What a program of a filled-in form is read with; `None` where its control says it all.
    fn setting(&self, _fields: &Fields, _program: &Program) -> Option<Setting> {
        None
    }

    /// The contradictions between the values of a filled-in form, which are reported before anything is computed.
    ///
    /// # Errors
    /// Every one of them.
    fn design(&self, fields: &Fields) -> Result<(), Vec<Finding>>;

    /// What designs of it are compared by: every derived value, and what the programs come to.
    fn measures(&self) -> &'static [Measure] {
        &[]
    }

    /// What a new workbook suggests to vary.
    fn suggested(&self) -> &'static Suggested {
        &Suggested::NOTHING
    }

    /// What is found of one of its programs, by its key, when another text is read in the place of its own: `edited` makes that of
    /// it. The refusals of a form whose values contradict each other. `None` of a kind that judges no programs of its own, and of a key
    /// that none of them has.
    fn judged_text(&self, _: &Fields, _key: &str, _edited: &dyn Fn(&str) -> String) -> Option<Vec<Finding>> {
        None
    }

    /// What is known of a filled-in form before its programs are read back.
    ///
    /// # Errors
    /// A refusal with every contradiction between values.
    fn limits(&self, fields: &Fields) -> Result<Limits, Refusal>;

    /// Computes a filled-in form, of which `found` was found when it was read. The same values give the same outcome.
    ///
    /// # Errors
    /// A refusal with every contradiction between values.
    fn run(&self, fields: Fields, found: Vec<Finding>, source: Provenance, wants: Wants) -> Result<Outcome, Refusal>;
}

impl fmt::Debug for dyn Kind + '_ {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(self.form().kind)
    }
}

/// What is wanted of an outcome beside what it always holds.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wants {
    /// What can be shown in a browser.
    pub scene: bool,
    /// No more than a row of a sweep takes: advice that no finding needs is not worked out.
    pub row: bool,
}

/// The typst files that a kind brings to the report, their texts. They stand in the folder `kind` below the templates of all
/// kinds, and import those from there.
#[derive(Debug)]
pub struct Chapters {
    /// `labels.typ`: its `labels`, a dictionary of words for each language, and `figures`, the keys of the figures that stand
    /// before a table by the key of the table.
    pub labels: &'static str,
    /// `method-es.typ` and `method-en.typ`: how it is computed.
    pub method: [&'static str; 2],
    /// `setup.typ`: its `preparation`, what the machinist sets up, `assumes`, what the programs take for granted, and
    /// `before-items`, what is to be seen to before the start. Its sketches are the figures `setup` and `setup-side`, and
    /// `setup-2` of a second set-up.
    pub setup: &'static str,
    /// Further files that these import: name and text.
    pub further: &'static [(&'static str, &'static str)],
}

/// Where an outcome comes from, for headers and reports. All of it is input: nothing below the edge reads a clock or a
/// file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Provenance {
    /// The workbook's file name, cleaned for print.
    pub workbook: String,
    /// SHA-256 of the workbook's bytes, in lower-case hexadecimal.
    pub sha256: String,
    /// The version of rodete.
    pub version: &'static str,
}

/// A curve of a chart: two columns of tables.
#[derive(Clone, Debug)]
pub struct Series {
    /// The curve's name.
    pub name: Text,
    /// Table key and column symbol of the abscissa; an empty symbol means the point index.
    pub x: (&'static str, &'static str),
    /// Table key and column symbol of the ordinate.
    pub y: (&'static str, &'static str),
}

/// A chart on the sheet of a table.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The key of the table on whose sheet it stands.
    pub table: &'static str,
    /// The title above it.
    pub title: Text,
    /// Titles of the x and y axes, with units.
    pub axes: [Text; 2],
    /// Both axes have one scale (a drawing of shapes).
    pub equal: bool,
    /// The formula over the form's cells that is true while the part has what is drawn; `None` where it always has.
    pub when: Option<&'static str>,
    /// The curves.
    pub series: Vec<Series>,
}

/// Drawings made when they are first looked at: a build without a report needs none.
pub type Figures = LazyLock<Vec<Figure>, Box<dyn FnOnce() -> Vec<Figure> + Send + Sync>>;

/// A drawing at 1:1 that is delivered on its own, as DXF and SVG and, where it is to be printed, as PDF.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// One of [`Form::drawings`]: what its files are called, as `<stem>-<key>.dxf`.
    pub key: &'static str,
    /// What it is, as it is printed on it.
    pub title: Text,
    /// The drawing, in millimetres.
    pub figure: Figure,
    /// What of it is arcs of circles, drawn as such in DXF and SVG; a drawing that is printed has none.
    pub arcs: Vec<Arc>,
    /// The paper that it is printed on at 1:1, over as many sheets as it takes; `None`: it is not printed.
    pub paper: Option<Paper>,
}

/// A body that is delivered on its own, as STL: contours turned about the axis.
#[derive(Clone, Debug)]
pub struct Solid {
    /// One of [`Form::solids`]: what its file is called, as `<stem>-<key>.stl`.
    pub key: &'static str,
    /// The contours of its half section, `[z, r]` in mm, counter-clockwise, holes clockwise.
    pub contours: Vec<Vec<[f64; 2]>>,
    /// How far its facets may be from it, mm.
    pub tolerance: f64,
}

/// How long a program takes, rapid moves included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Duration {
    /// The time of the motions whose time is known, s.
    pub seconds: f64,
    /// How many of its motions have no known time, and are not in `seconds`.
    pub timeless: usize,
}

/// A program that is handed over, with what was found when it was followed. It is the program wherever one is asked for.
#[derive(Clone, Debug)]
pub struct Proved {
    /// The program as it was planned.
    pub program: Program,
    /// How far it reaches and how long its path is.
    pub account: Account,
    /// How long it takes, where the machine's rapid moves are known.
    pub duration: Option<Duration>,
}

/// What the time of a program counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Timed {
    /// Feed, dwells and rapid motions: at least so long, since machines must accelerate.
    Cycle,
    /// The same, but for motions whose time is not known.
    Part,
    /// Feed and dwells: how fast rapid motions are is not known.
    Feed,
    /// Nothing: a motion at feed has no known time.
    Unknown,
}

impl Proved {
    /// What is known of its time, and the time in s.
    #[must_use]
    pub fn time(&self) -> (Timed, Option<f64>) {
        match self.duration {
            Some(Duration { seconds, timeless: 0 }) => (Timed::Cycle, Some(seconds)),
            Some(Duration { seconds, .. }) => (Timed::Part, Some(seconds)),
            None if self.account.untimed || self.account.seconds <= 0.0 => (Timed::Unknown, None),
            None => (Timed::Feed, Some(self.account.seconds)),
        }
    }

    /// The same with the time in words, empty where nothing is known; a least time is rounded down.
    #[must_use]
    pub fn time_in_words(&self) -> (Timed, String) {
        let (timed, seconds) = self.time();
        let spelt = if timed == Timed::Feed { duration } else { least_duration };
        (timed, seconds.map(spelt).unwrap_or_default())
    }
}

impl Deref for Proved {
    type Target = Program;

    fn deref(&self) -> &Program {
        &self.program
    }
}

/// A value that the set-up chapter of a kind prints, and nothing else does.
#[derive(Clone, Debug, PartialEq)]
pub enum Shown {
    /// Whether something is so.
    Whether(bool),
    /// A length, mm.
    Length(f64),
    /// Words of a program.
    Words(String),
    /// Rows of a table, each with the texts of its cells.
    Rows(Vec<Vec<Text>>),
}

/// How the work ended: the one thing that says whether programs are handed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The work was done, and its programs are handed over.
    Whole,
    /// A finding stops the work.
    Stopped,
    /// A program was not read to its end, for it has none: a budget ended.
    Endless,
}

impl End {
    /// How work ends with these findings; `endless` where a budget ended.
    #[must_use]
    pub fn of(findings: &[Finding], endless: bool) -> Self {
        match (findings.iter().any(|finding| finding.grade == Grade::Stop), endless) {
            (false, _) => Self::Whole,
            (true, false) => Self::Stopped,
            (true, true) => Self::Endless,
        }
    }
}

/// A file that a workbook names, as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFile {
    /// Its name in the workbook.
    pub name: String,
    /// The SHA-256 of its bytes, in hexadecimal.
    pub sha256: String,
}

/// What came of a design: parts that are the same of every kind, so that who delivers them asks no kind.
#[derive(Debug)]
pub struct Outcome {
    /// The workbook kind whose design it is.
    pub kind: &'static dyn Kind,
    /// The values it was computed from.
    pub fields: Fields,
    /// Where they come from.
    pub source: Provenance,
    /// The control that its programs are for.
    pub control: &'static Control,
    /// The layout of its programs, for a kind that has several.
    pub style: Option<Style>,
    /// Derived limits, angles and lengths.
    pub quantities: Vec<Quantity>,
    /// The tables, in the order of their sheets.
    pub tables: Vec<Table>,
    /// The programs; empty where a finding stops the work.
    pub programs: Vec<Proved>,
    /// Charts for the sheets.
    pub charts: Vec<Chart>,
    /// Drawings for the report.
    pub figures: Figures,
    /// Drawings at 1:1 with files of their own.
    pub drawings: Vec<Drawing>,
    /// Bodies with files of their own.
    pub solids: Vec<Solid>,
    /// What can be shown in a browser, or why it cannot; `None` where it is not wanted, or there is nothing to show.
    pub scene: Option<Result<Scene, Refusal>>,
    /// What the set-up chapter of the kind prints beside values and derived quantities, by the names that it knows.
    pub setup: Vec<(&'static str, Shown)>,
    /// Every check of every program that was read back, in their order.
    pub checks: Vec<Check>,
    /// The files that the workbook names, as who reads files found them.
    pub named_files: Vec<NamedFile>,
    /// All findings, passed checks among them, gravest first.
    pub findings: Vec<Finding>,
    /// How the work ended.
    pub end: End,
}

impl Outcome {
    /// True where a finding stops the work: no program may be written.
    #[must_use]
    pub fn stopped(&self) -> bool {
        self.end != End::Whole
    }

    /// How the work ends, once what there is has been delivered. Where one of the stops is a fault of rodete's own, the
    /// input is not to blame.
    #[must_use]
    pub fn exit(&self) -> Exit {
        match self.end {
            End::Whole => Exit::Done,
            _ if self.findings.iter().any(Finding::is_fault) => Exit::Fault,
            End::Stopped => Exit::Refused,
            End::Endless => Exit::Limit,
        }
    }

    /// Takes in what was found of it afterwards, gravest first.
    pub fn told(&mut self, finding: Finding) {
        self.findings.push(finding);
        gravest_first(&mut self.findings);
    }

    /// The part's name.
    #[must_use]
    pub fn part(&self) -> &str {
        self.fields.values().line(self.fields.form().part)
    }

    /// The part's material; empty where it is not said.
    #[must_use]
    pub fn material(&self) -> &str {
        self.fields.form().material.map_or("", |material| self.fields.values().line(material))
    }

    /// The table whose [`Table::key`] this is; `None` where the kind has no such table.
    #[must_use]
    pub fn table(&self, key: &str) -> Option<&Table> {
        self.tables.iter().find(|table| table.key == key)
    }
}

/// The stop for a position that no program may carry, at the parameters that make it.
pub fn out_of_format<const N: usize>(error: OutOfFormat, keys: [Key; N]) -> Finding {
    let parameters = all_of(keys.map(|key| Text::same(key.name())));
    PositionOutOfFormat { position: error.0, parameters }.at(at(keys))
}
