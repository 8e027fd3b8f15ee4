//! The shape of `contents.json`: texts and numbers ready to print.

use std::collections::BTreeMap;

use serde::Serialize;

use super::shorten::Listing;
use crate::kind::Timed;

/// Everything that the templates print.
#[derive(Serialize)]
pub(super) struct Document {
    pub kind: &'static str,
    pub language: &'static str,
    pub part: String,
    pub material: String,
    pub workbook: String,
    pub sha256: String,
    pub version: String,
    pub dialect: &'static str,
    pub style: &'static str,
    /// How rotary axes count with the control's delivered settings: `rollover`, `linear`.
    pub rotary: &'static str,
    /// How F counts: `resultant`, `seconds`, `inverse`.
    pub feed_law: &'static str,
    pub title: Title,
    pub verdict: OverallGrade,
    pub parameters: Vec<Group>,
    pub values: BTreeMap<&'static str, String>,
    pub quantities: Vec<Row>,
    pub tables: Vec<Sheet>,
    pub figures: BTreeMap<&'static str, Drawing>,
    pub programs: Vec<Listed>,
    /// Values that only the kind's set-up chapter prints.
    pub setup: BTreeMap<&'static str, SetUp>,
    /// The checks of the programs that were read back.
    pub answers: Vec<Answer>,
    pub checks: Vec<Check>,
    pub files: Vec<File>,
}

/// What the outcome comes to, as the results say it too.
#[derive(Default, Serialize)]
pub(super) struct OverallGrade {
    /// `note`, `caution` or `stop`.
    pub grade: &'static str,
    /// The verdict in words.
    pub what: String,
    /// What was read back and passed; empty where nothing was asked.
    pub passed: String,
}

/// The title block; fields that are not given are empty.
#[derive(Serialize)]
pub(super) struct Title {
    pub customer: String,
    pub drawing: String,
    pub revision: String,
    pub date: String,
    pub author: String,
    pub checker: String,
    /// The file of the logo, if there is one.
    pub logo: Option<&'static str>,
}

/// A value of the set-up.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum SetUp {
    /// Yes or no.
    Whether(bool),
    /// A length in mm, ready to print.
    Length(String),
    /// Words of a program.
    Words(String),
    /// Rows of a table, each with its cells.
    Rows(Vec<Vec<String>>),
}

/// Parameters under one heading.
#[derive(Serialize)]
pub(super) struct Group {
    pub title: String,
    pub rows: Vec<Row>,
}

/// One parameter or derived quantity.
#[derive(Serialize)]
pub(super) struct Row {
    pub symbol: String,
    pub meaning: String,
    pub value: String,
    pub unit: &'static str,
    pub note: String,
}

/// A table, shortened if it is long.
#[derive(Serialize)]
pub(super) struct Sheet {
    pub key: &'static str,
    pub name: String,
    pub title: String,
    pub source: String,
    pub counted: bool,
    pub columns: Vec<Heading>,
    pub head: Vec<Vec<String>>,
    pub omitted: usize,
    pub tail: Vec<Vec<String>>,
}

/// The head of a column.
#[derive(Serialize)]
pub(super) struct Heading {
    pub symbol: String,
    pub unit: &'static str,
    pub text: bool,
}

/// A figure: the file of its picture, its caption and legend.
#[derive(Serialize)]
pub(super) struct Drawing {
    pub file: String,
    pub caption: String,
    pub legend: Vec<Key>,
}

/// A line of a legend.
#[derive(Serialize)]
pub(super) struct Key {
    pub colour: &'static str,
    pub width: f64,
    pub dash: &'static [f64],
    pub text: String,
}

/// A program with its listing and its totals.
#[derive(Serialize)]
pub(super) struct Listed {
    pub key: &'static str,
    pub title: String,
    /// The control that it is for.
    pub dialect: &'static str,
    pub listing: Listing,
    pub widest: usize,
    /// Its first and its last blocks, without comments.
    pub ends: [Vec<String>; 2],
    pub file: String,
    /// How the file is named at the control; empty where any name will do.
    pub stored: String,
    pub sha256: String,
    pub blocks: String,
    pub bytes: String,
    pub path: String,
    pub start: String,
    pub timed: Timed,
    pub time: String,
    pub extents: Vec<Extent>,
}

/// The extents of an axis.
#[derive(Serialize)]
pub(super) struct Extent {
    pub axis: String,
    pub unit: &'static str,
    pub least: String,
    pub greatest: String,
    /// Minimum and maximum while it moves at feed; `None` if it does not.
    pub feed: Option<[String; 2]>,
}

/// A check of a program.
#[derive(Serialize)]
pub(super) struct Answer {
    pub key: &'static str,
    pub program: String,
    pub what: String,
    pub value: String,
    pub limit: String,
    /// The number that was measured, in the unit of the value; none where it is not one number.
    pub measured: Option<f64>,
    pub place: String,
    /// `passed`, `note`, `caution` or `stop`.
    pub verdict: &'static str,
    pub word: String,
}

/// A finding.
#[derive(Serialize)]
pub(super) struct Check {
    pub grade: &'static str,
    pub name: String,
    /// Empty if it has none.
    pub code: &'static str,
    pub what: String,
    pub place: String,
    pub value: String,
    pub limit: String,
    pub remedy: String,
}

/// A file listed in the report; `carried` is its copy in the folder if it is attached.
#[derive(Serialize)]
pub(super) struct File {
    pub name: String,
    pub description: String,
    pub sha256: String,
    pub bytes: String,
    pub mime: &'static str,
    pub relation: &'static str,
    pub carried: Option<String>,
}
