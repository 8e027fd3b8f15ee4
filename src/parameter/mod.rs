//! The parameters of a workbook kind: one table of meanings, units and limits.
//!
//! The input sheet, its cell validation, the refusals, the ranges of the property tests and the documentation all
//! follow from it, so that a limit is written once.

pub mod field;
mod fields;
pub mod list;
pub mod rules;
pub mod title_block;

use std::collections::BTreeMap;

use crate::finding::{CellPlace, Finding, Key, Place};
use crate::parameter::field::{Field, Optional, Required, Stated, Typed};
use crate::parameter::list::{List, Row, Rows};
use crate::table::Unit;
use crate::text::{Language, Text, t};

/// A word of a drop-down list.
#[derive(Debug)]
pub struct Choice {
    /// The key that the design uses.
    pub key: &'static str,
    /// What stands in the cell. Either language is accepted when reading.
    pub label: Text,
    /// What an earlier rodete wrote there: it is still read.
    pub once: &'static [&'static str],
}

impl Choice {
    /// One whose key is what stands in the cell, in either language.
    #[must_use]
    pub const fn named(key: &'static str) -> Self {
        Self { key, label: t(key, key), once: &[] }
    }

    /// Every word that is read as this choice: its key, its labels and what it was once called.
    pub fn words(&self) -> impl Iterator<Item = &str> {
        [self.key, &*self.label.es, &*self.label.en].into_iter().chain(self.once.iter().copied())
    }
}

/// What may stand in a value cell.
#[derive(Debug)]
pub enum FieldKind {
    /// A real number within bounds (both included).
    Real {
        /// Least value.
        min: f64,
        /// Greatest value.
        max: f64,
    },
    /// A whole number within bounds (both included).
    Whole {
        /// Least value.
        min: u32,
        /// Greatest value.
        max: u32,
    },
    /// One of a list.
    Choice(&'static [Choice]),
    /// One line of text.
    Line {
        /// Most characters.
        max: usize,
    },
    /// A date as it is to be printed: one line of text, or a cell that the spreadsheet formats as a date.
    Date,
    /// Machine codes as `M3 M11 M13`: letters G or M with whole numbers, separated by blanks.
    Codes,
    /// One block that takes the tool away as `G0 G53 Z0`: codes, then X, Y and Z, then M codes.
    Block,
    /// The name and version of the schema: text that must equal [`Form::schema`].
    Schema,
}

/// One parameter of a workbook kind.
#[derive(Debug)]
pub struct Parameter {
    /// Unique in its form. The symbol, preceded by `sheet/` on any but the first sheet (`calibration/d_t`).
    pub key: &'static str,
    /// The defined name of its value cell in the workbook.
    pub name: &'static str,
    /// What it is.
    pub meaning: Text,
    /// The unit that must stand in its unit cell.
    pub unit: Unit,
    /// What may stand in the cell.
    pub kind: FieldKind,
    /// An empty cell is refused.
    pub required: bool,
    /// Something follows from it; else it is a remark of its author.
    pub read: bool,
    /// True for a value of the field's type.
    pub admits: fn(&Value) -> bool,
    /// A note on the allowed range, for column E and the input message.
    pub note: Text,
    /// The key of the cell that gives the value where its own is empty: what is found of it is looked for there.
    pub given_by: Option<&'static str>,
}

impl Parameter {
    /// Its key, for a finding.
    #[must_use]
    pub const fn key(&self) -> Key {
        Key::of_row(self.key)
    }

    /// The symbol that stands in column A.
    #[must_use]
    pub fn symbol(&self) -> &'static str {
        self.key().symbol()
    }

    /// What stands in the cell of a choice.
    #[must_use]
    pub fn label(&self, key: &'static str, language: Language) -> &'static str {
        match self.kind {
            FieldKind::Choice(choices) => {
                choices.iter().find(|choice| choice.key == key).map_or(key, |choice| choice.label.get(language))
            }
            _ => key,
        }
    }
}

/// A group of parameters under one heading.
#[derive(Debug)]
pub struct Section {
    /// The heading on the sheet.
    pub title: Text,
    /// The parameters, in order.
    pub parameters: &'static [&'static Parameter],
    /// All of it may stay empty; so it comes folded.
    pub optional: bool,
}

/// One sheet of an input workbook.
#[derive(Debug)]
pub struct Sheet {
    /// The sheet's name.
    pub name: Text,
    /// The title in its first row.
    pub title: Text,
    /// The sheet may be missing; or present with every value cell empty, which means the same.
    pub optional: bool,
    /// The parameters.
    pub sections: &'static [Section],
}

/// A cell that is filled in: the key of its field and its value. [`Field::is`] and [`Field::says`] make it.
pub type Cell = (&'static str, Value);

/// A filled-in form to start from.
#[derive(Debug)]
pub struct Case {
    /// Its name on the command line.
    pub name: &'static str,
    /// A sentence on where the values come from, for the sheet.
    pub note: Text,
    /// The cells that it fills in, with texts in a language.
    pub filled: fn(Language) -> Vec<Cell>,
    /// The rows of its lists, likewise.
    pub listed: fn(Language) -> Vec<Rows>,
}

/// No list has rows.
const fn unlisted(_: Language) -> Vec<Rows> {
    Vec::new()
}

impl Case {
    /// A case of a form without lists.
    #[must_use]
    pub const fn new(name: &'static str, note: Text, filled: fn(Language) -> Vec<Cell>) -> Self {
        Self { name, note, filled, listed: unlisted }
    }

    /// The cells that it fills in; the others stay empty.
    #[must_use]
    pub fn values(&self, language: Language) -> Vec<Cell> {
        (self.filled)(language)
    }
}

/// An earlier version of a form that is still read.
#[derive(Debug)]
pub struct Earlier {
    /// Name and version, as in [`Form::schema`].
    pub schema: &'static str,
    /// The keys of parameters of the first sheet, each with the symbol that stood in column A then.
    pub renamed: &'static [(Key, &'static str)],
    /// What a person who has such a workbook must know, at the cells that it is of.
    pub told: fn(Place) -> Finding,
}

impl Earlier {
    /// The symbol of a parameter then; `None` where it is the same.
    #[must_use]
    pub fn symbol(&self, key: &str) -> Option<&'static str> {
        self.renamed.iter().find(|(renamed, _)| renamed.name() == key).map(|(_, symbol)| *symbol)
    }
}

/// A workbook kind: the form that a user fills in.
#[derive(Debug)]
pub struct Form {
    /// The kind's name on the command line, as `impeller`.
    pub kind: &'static str,
    /// Name and version, as `rodete-impeller 2`.
    pub schema: &'static str,
    /// Earlier versions that are still read.
    pub earlier: &'static [Earlier],
    /// The parameter that names the part, for the headings of sheets, drawings, pages and reports.
    pub part: &'static Field<String, Required>,
    /// The parameter that names its material; `None` where a form has none.
    pub material: Option<&'static Field<String, Optional>>,
    /// The keys of the programs that its builds may write, in the order of their sheets: a program of another key is a fault.
    pub programs: &'static [&'static str],
    /// The keys of the drawings at 1:1 that its builds may write; other than `report` and other than those of programs.
    pub drawings: &'static [&'static str],
    /// The keys of the bodies that its builds may write, with what they are.
    pub solids: &'static [(&'static str, Text)],
    /// Its builds write a page that shows the programs, too.
    pub viewer: bool,
    /// The sheets; the first is required and holds the schema cell.
    pub sheets: &'static [Sheet],
    /// The lists that follow on sheets of their own.
    pub lists: &'static [List],
}

impl Form {
    /// A form of nothing: others are this with fields of their own.
    pub const PLAIN: Self = {
        static NO_PART: Field<String, Required> = Field::line("", "", 0, t("", ""), t("", ""));
        Self {
            kind: "",
            schema: "",
            earlier: &[],
            part: &NO_PART,
            material: None,
            programs: &[],
            drawings: &[],
            solids: &[],
            viewer: false,
            sheets: &[],
            lists: &[],
        }
    };

    /// Every parameter with its sheet, in order.
    pub fn parameters(&self) -> impl Iterator<Item = (&'static Sheet, &'static Parameter)> {
        self.sheets.iter().flat_map(|sheet| {
            sheet.sections.iter().flat_map(move |section| section.parameters.iter().map(move |one| (sheet, *one)))
        })
    }

    /// The parameter whose cell says which schema a workbook follows.
    #[must_use]
    pub fn schema_parameter(&self) -> Option<&'static Parameter> {
        self.parameters().map(|(_, parameter)| parameter).find(|one| matches!(one.kind, FieldKind::Schema))
    }

    /// The parameter with this key; `None` where the form has no such parameter.
    #[must_use]
    pub fn parameter(&self, key: &str) -> Option<&'static Parameter> {
        self.parameters().map(|(_, parameter)| parameter).find(|parameter| parameter.key == key)
    }
}

/// A checked value.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A finite number within its limits, -0 as 0.
    Real(f64),
    /// A whole number within its limits.
    Whole(u32),
    /// The key of a choice.
    Choice(&'static str),
    /// A line of text or of codes, trimmed.
    Line(String),
}

/// The values of a filled-in form, each known to be within its own limits, with the cells they came from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values {
    /// The language of the workbook.
    pub language: Language,
    /// The values by key; an optional parameter left empty is absent.
    pub values: BTreeMap<&'static str, Value>,
    /// The value cell of every parameter whose symbol was found, filled or not.
    pub cells: BTreeMap<Key, CellPlace>,
    /// The lists, in the order of their sheets; one whose sheet is missing or has no rows is absent.
    pub lists: Vec<Rows>,
}

impl Values {
    /// The values of a case.
    #[must_use]
    pub fn of(case: &Case, language: Language) -> Self {
        let values = case.values(language).into_iter().collect();
        Self { language, values, lists: (case.listed)(language), ..Self::default() }
    }

    /// The value of a field before it is proved to be there; `None` where it is not, or of another type.
    #[must_use]
    pub fn found<T: Typed, P>(&self, field: &Field<T, P>) -> Option<T> {
        self.values.get(field.row.key).and_then(T::typed)
    }

    /// Puts a value into the cell of a field, or empties it.
    pub fn put<T: Stated, P>(&mut self, field: &Field<T, P>, value: Option<T>) {
        match value {
            Some(value) => self.values.insert(field.row.key, value.stated()),
            None => self.values.remove(field.row.key),
        };
    }

    /// The line of a field; empty where its cell is.
    #[must_use]
    pub fn line<P>(&self, field: &Field<String, P>) -> &str {
        if let Some(Value::Line(line)) = self.values.get(field.row.key) { line } else { "" }
    }

    /// The rows of a list's sheet; none where it is absent.
    #[must_use]
    pub fn rows(&self, list: &str) -> &[Row] {
        self.lists.iter().find(|rows| rows.list == list).map_or(&[], |rows| &rows.rows)
    }

    /// The finding with its parameters turned into the cells they came from.
    #[must_use]
    pub fn locate(&self, mut finding: Finding) -> Finding {
        if let Place::Parameters(keys) = &finding.place {
            let cells: Vec<CellPlace> = keys.iter().filter_map(|key| self.cells.get(key).cloned()).collect();
            if !cells.is_empty() {
                finding.place = Place::Cells(cells);
            }
        }
        finding
    }
}

/// The place of what is found of parameters, by their keys.
#[must_use]
pub fn at<const N: usize>(keys: [Key; N]) -> Place {
    Place::Parameters(keys.to_vec())
}
