//! Two workbooks of one kind side by side: inputs, derived values, findings and programs.
//!
//! Programs are compared as the control would run them, motion by motion, then word by word: a header that names another
//! workbook makes no other program.

mod motions;
pub mod sheets;

use crate::finding::{CellPlace, Finding, Place};
use crate::kind::Outcome;
use crate::parameter::list::{List, Row};
use crate::parameter::{FieldKind, Form, Parameter, Value, Values};
use crate::table::{Quantity, Unit};
use crate::text::Text;

pub use self::motions::{Apart, Block, Difference, ProgramPair};

/// The last decimal that is shown of a derived value.
const LAST_DECIMAL: f64 = 1e-6;

/// One of the two workbooks that are compared.
#[derive(Clone, Copy, Debug)]
pub struct Side<'a> {
    /// The values of the form.
    pub values: &'a Values,
    /// Everything found.
    pub findings: &'a [Finding],
    /// What came of the values; `None` where they contradict each other.
    pub outcome: Option<&'a Outcome>,
}

/// An input that differs: a cell of the form, or of a row of a list.
#[derive(Clone, Debug)]
pub struct Input {
    /// The symbol, as it stands on the sheet; of a list with its row, as `R (TOOLS, row 3)`.
    pub symbol: Text,
    /// What it is, as the form has it.
    pub meaning: Text,
    /// The unit of both values.
    pub unit: Unit,
    /// The values, of each side; `None` for an empty cell or a row that is not there.
    pub values: [Option<Shown>; 2],
    /// The cells, where they are known.
    pub cells: [Option<CellPlace>; 2],
}

/// A value as a cell shows it.
#[derive(Clone, Debug, PartialEq)]
pub enum Shown {
    /// A number.
    Number(f64),
    /// A word of a list, a line of text.
    Text(Text),
}

/// A derived value of both sides.
#[derive(Clone, Debug)]
pub struct Derived {
    /// The symbol, as in the source.
    pub symbol: &'static str,
    /// What it is, in words.
    pub meaning: Text,
    /// The unit of both values.
    pub unit: Unit,
    /// The values, of each side; `None` where it is not derived.
    pub values: [Option<f64>; 2],
}

impl Derived {
    /// True where the two are not the same.
    #[must_use]
    pub fn differs(&self) -> bool {
        match self.values {
            // What is below the last decimal shown is no difference, nor are the last bits of a large value.
            [Some(one), Some(other)] => (one - other).abs() > (1e-9 * one.abs()).max(LAST_DECIMAL),
            [one, other] => one.is_some() || other.is_some(),
        }
    }
}

/// A finding, of each side: the same code at the same place is the same finding, whatever its figures.
#[derive(Clone, Debug)]
pub struct Found<'a> {
    /// The finding of each side; at least one is there.
    pub sides: [Option<&'a Finding>; 2],
}

impl<'a> Found<'a> {
    /// The finding: of the second side where it is there.
    ///
    /// # Panics
    /// Never: one of the two is there.
    #[must_use]
    pub fn finding(&self) -> &'a Finding {
        let [one, other] = self.sides;
        other.or(one).unwrap_or_else(|| unreachable!("a finding of neither side"))
    }

    /// True where one side alone has it, or its figures are others.
    #[must_use]
    pub fn differs(&self) -> bool {
        match self.sides {
            [Some(one), Some(other)] => !one.alike(other) || one.grade != other.grade,
            _ => true,
        }
    }
}

/// Two workbooks side by side.
#[derive(Debug)]
pub struct Comparison<'a> {
    /// The inputs that differ, in the order of the form.
    pub inputs: Vec<Input>,
    /// All derived values.
    pub quantities: Vec<Derived>,
    /// All findings, those of one side first.
    pub findings: Vec<Found<'a>>,
    /// All programs of either side, paired by their keys.
    pub programs: Vec<ProgramPair>,
}

impl<'a> Comparison<'a> {
    /// Compares two sides of one form.
    #[must_use]
    pub fn of(form: &'static Form, sides: [Side<'a>; 2]) -> Self {
        let outcomes = sides.map(|side| side.outcome);
        Self {
            inputs: inputs(form, sides.map(|side| side.values)),
            quantities: quantities(outcomes.map(|one| one.map_or(&[][..], |one| &one.quantities))),
            findings: findings(sides),
            programs: motions::programs(outcomes),
        }
    }

    /// True where nothing differs.
    #[must_use]
    pub fn same(&self) -> bool {
        self.inputs.is_empty()
            && !self.quantities.iter().any(Derived::differs)
            && !self.findings.iter().any(Found::differs)
            && self.programs.iter().all(ProgramPair::equal)
    }
}

/// A value as its parameter shows it.
fn shown(parameter: &Parameter, value: &Value) -> Shown {
    match value {
        Value::Real(value) => Shown::Number(*value),
        Value::Whole(value) => Shown::Number(f64::from(*value)),
        Value::Choice(key) => {
            let choices = if let FieldKind::Choice(choices) = parameter.kind { choices } else { &[] };
            let choice = choices.iter().find(|choice| choice.key == *key);
            Shown::Text(choice.map_or_else(|| Text::same(*key), |choice| choice.label.clone()))
        }
        Value::Line(line) => Shown::Text(Text::same(line.clone())),
    }
}

fn inputs(form: &'static Form, values: [&Values; 2]) -> Vec<Input> {
    let mut found = Vec::new();
    for (_, parameter) in form.parameters() {
        let key = parameter.key;
        let pair = values.map(|one| one.values.get(key));
        if pair[0] != pair[1] && !matches!(parameter.kind, FieldKind::Schema) {
            found.push(Input {
                symbol: Text::same(parameter.symbol()),
                meaning: parameter.meaning.clone(),
                unit: parameter.unit,
                values: pair.map(|value| value.map(|value| shown(parameter, value))),
                cells: values.map(|one| one.cells.get(key).cloned()),
            });
        }
    }
    for list in form.lists {
        let sheets = values.map(|one| one.lists.iter().filter(|rows| rows.list == list.key).collect::<Vec<_>>());
        let mut names: Vec<&str> = sheets.iter().flatten().map(|rows| rows.sheet.as_str()).collect();
        names.dedup();
        // The one sheet of a list may bear its name in either language; numbered ones are the same by their names.
        if sheets.iter().all(|sheets| sheets.len() <= 1) {
            names.truncate(1);
        }
        let mut seen: Vec<&str> = Vec::new();
        for name in names {
            if seen.contains(&name) {
                continue;
            }
            seen.push(name);
            let single = sheets.iter().all(|sheets| sheets.len() <= 1);
            let rows = sheets.each_ref().map(|sheets| {
                let sheet = sheets.iter().find(|rows| single || rows.sheet == name);
                sheet.map_or(&[][..], |rows| rows.rows.as_slice())
            });
            list_rows(list, name, rows, &mut found);
        }
    }
    found
}

/// The cells of two lists that differ. Rows that are the same at the head and at the tail are left out, so that one row put
/// in between moves none; the rest is compared row by row.
fn list_rows(list: &'static List, sheet: &str, rows: [&[Row]; 2], found: &mut Vec<Input>) {
    let same = |one: &Row, other: &Row| one.values == other.values;
    let head = rows[0].iter().zip(rows[1]).take_while(|(one, other)| same(one, other)).count();
    let rest = rows.map(|rows| &rows[head..]);
    let tail = rest[0].iter().rev().zip(rest[1].iter().rev()).take_while(|(one, other)| same(one, other)).count();
    let rest = rest.map(|rows| &rows[..rows.len() - tail]);
    for at in 0..rest[0].len().max(rest[1].len()) {
        let pair = rest.map(|rows| rows.get(at));
        for column in list.columns {
            let values = pair.map(|row| row.and_then(|row| row.values.get(column.key)));
            if values[0] != values[1] {
                found.push(Input {
                    symbol: row_name(column.symbol(), sheet, head + at + 1),
                    meaning: column.meaning.clone(),
                    unit: column.unit,
                    values: values.map(|value| value.map(|value| shown(column, value))),
                    cells: pair.map(|row| row.and_then(|row| row.cells.get(column.key).cloned())),
                });
            }
        }
    }
}

/// The symbol of a column in a row of a list, from 1.
fn row_name(symbol: &str, sheet: &str, row: usize) -> Text {
    Text::new(format!("{symbol} ({sheet}, fila {row})"), format!("{symbol} ({sheet}, row {row})"))
}

fn quantities(sides: [&[Quantity]; 2]) -> Vec<Derived> {
    let derived =
        |one: &Quantity, values| Derived { symbol: one.symbol, meaning: one.meaning.clone(), unit: one.unit, values };
    let is = |one: &Quantity, other: &Quantity| one.symbol == other.symbol && one.unit == other.unit;
    let mut all: Vec<Derived> = Vec::new();
    let mut taken = vec![false; sides[1].len()];
    for one in sides[0] {
        let at = sides[1].iter().zip(&taken).position(|(other, taken)| !taken && is(one, other));
        if let Some(at) = at {
            taken[at] = true;
        }
        all.push(derived(one, [Some(one.value), at.map(|at| sides[1][at].value)]));
    }
    let alone = sides[1].iter().zip(&taken).filter(|(_, taken)| !**taken);
    all.extend(alone.map(|(other, _)| derived(other, [None, Some(other.value)])));
    all
}

/// An input, wherever its cell stands: of the form its key; of a list also which of its sheets it is on, and in which row.
type Spot = (&'static str, Option<[usize; 2]>);

/// The inputs that a finding is about, whatever cells and sheets they stand in; its place where it is none of inputs alone.
fn place(finding: &Finding, values: &Values) -> Result<Vec<Spot>, Place> {
    let cells = match &finding.place {
        Place::Cells(cells) => cells,
        Place::Parameters(keys) => return Ok(keys.iter().map(|key| (key.name(), None)).collect()),
        other => return Err(other.clone()),
    };
    let of_form =
        |cell: &CellPlace| values.cells.iter().find(|(_, own)| *own == cell).map(|(key, _)| (key.name(), None));
    let of_list = |cell: &CellPlace| {
        values.lists.iter().enumerate().find_map(|(sheet, rows)| {
            rows.rows.iter().enumerate().find_map(|(row, one)| {
                one.cells.iter().find(|(_, own)| *own == cell).map(|(key, _)| (*key, Some([sheet, row])))
            })
        })
    };
    let spots = cells.iter().map(|cell| of_form(cell).or_else(|| of_list(cell))).collect::<Option<Vec<Spot>>>();
    spots.ok_or_else(|| finding.place.clone())
}

fn findings<'a>(both: [Side<'a>; 2]) -> Vec<Found<'a>> {
    let sides = both.map(|side| side.findings);
    // What is said of one program is not held against what is said of another.
    let program = |one: &Finding| one.data.iter().find(|(name, _)| *name == "program").map(|(_, told)| told.clone());
    let is = |one: &Finding, other: &Finding| {
        one.is(other.rule())
            && place(one, both[0].values) == place(other, both[1].values)
            && program(one) == program(other)
    };
    let mut taken = vec![false; sides[1].len()];
    let mut all: [Vec<Found<'a>>; 3] = Default::default();
    for one in sides[0] {
        // The very same comes before one with other figures.
        let find = |same: &dyn Fn(&Finding) -> bool| {
            sides[1].iter().zip(&taken).position(|(other, taken)| !taken && same(other) && is(one, other))
        };
        let at = find(&|other| other.alike(one)).or_else(|| find(&|_| true));
        if let Some(at) = at {
            taken[at] = true;
        }
        let other = at.map(|at| &sides[1][at]);
        all[if other.is_none() { 0 } else { 2 }].push(Found { sides: [Some(one), other] });
    }
    let alone = sides[1].iter().zip(&taken).filter(|(_, taken)| !**taken);
    all[1].extend(alone.map(|(other, _)| Found { sides: [None, Some(other)] }));
    all.into_iter().flatten().collect()
}
