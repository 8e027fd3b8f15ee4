//! Rows by columns: what stands in a file, and what is read from one.

use crc32fast::Hasher;

use crate::kind::Kind;
use crate::parameter::{FieldKind, Value};
use crate::sweep::plan::{INPUT, Plan};
use crate::sweep::row::Row;

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Whole numbers.
    Whole(Vec<Option<i64>>),
    /// Numbers.
    Number(Vec<Option<f64>>),
    /// Texts.
    Text(Vec<Option<Box<str>>>),
    /// Yes or no.
    Truth(Vec<Option<bool>>),
}

impl Cells {
    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Whole(cells) => cells.len(),
            Self::Number(cells) => cells.len(),
            Self::Text(cells) => cells.len(),
            Self::Truth(cells) => cells.len(),
        }
    }

    /// True where there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Without values, of the same type.
    #[must_use]
    pub const fn emptied(&self) -> Self {
        match self {
            Self::Whole(_) => Self::Whole(Vec::new()),
            Self::Number(_) => Self::Number(Vec::new()),
            Self::Text(_) => Self::Text(Vec::new()),
            Self::Truth(_) => Self::Truth(Vec::new()),
        }
    }

    /// The first so many, taken off.
    #[must_use]
    pub fn split(&mut self, count: usize) -> Self {
        fn first<T>(cells: &mut Vec<T>, count: usize) -> Vec<T> {
            let rest = cells.split_off(count.min(cells.len()));
            std::mem::replace(cells, rest)
        }
        match self {
            Self::Whole(cells) => Self::Whole(first(cells, count)),
            Self::Number(cells) => Self::Number(first(cells, count)),
            Self::Text(cells) => Self::Text(first(cells, count)),
            Self::Truth(cells) => Self::Truth(first(cells, count)),
        }
    }

    /// Takes the values of a column of the same type over.
    pub fn append(&mut self, other: Self) {
        match (self, other) {
            (Self::Whole(cells), Self::Whole(mut more)) => cells.append(&mut more),
            (Self::Number(cells), Self::Number(mut more)) => cells.append(&mut more),
            (Self::Text(cells), Self::Text(mut more)) => cells.append(&mut more),
            (Self::Truth(cells), Self::Truth(mut more)) => cells.append(&mut more),
            _ => {}
        }
    }

    /// Adds the values to a checksum. An empty cell counts too: values that moved by a row have another one.
    pub fn add_to(&self, sum: &mut Hasher) {
        fn each<T>(sum: &mut Hasher, cells: &[Option<T>], add: impl Fn(&T, &mut Vec<u8>)) {
            let mut bytes = Vec::new();
            // In pieces: a checksum of a few bytes costs as much as one of many.
            for piece in cells.chunks(1000) {
                bytes.clear();
                for cell in piece {
                    bytes.push(u8::from(cell.is_some()));
                    cell.iter().for_each(|value| add(value, &mut bytes));
                }
                sum.update(&bytes);
            }
        }
        match self {
            Self::Whole(cells) => each(sum, cells, |one, to| to.extend(one.to_le_bytes())),
            Self::Number(cells) => each(sum, cells, |one, to| to.extend(one.to_bits().to_le_bytes())),
            Self::Truth(cells) => each(sum, cells, |one, to| to.push(u8::from(*one))),
            // No text holds the byte that ends it here.
            Self::Text(cells) => each(sum, cells, |one, to| to.extend(one.bytes().chain([0xff]))),
        }
    }

    /// A cell as a number; `None` where it is empty, or no number.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts and whole inputs are far below 2^52")]
    pub fn number(&self, row: usize) -> Option<f64> {
        match self {
            Self::Number(cells) => cells.get(row).copied().flatten(),
            Self::Whole(cells) => cells.get(row).copied().flatten().map(|whole| whole as f64),
            Self::Text(_) | Self::Truth(_) => None,
        }
    }

    /// A cell as a text; `None` where it is empty, or no text.
    #[must_use]
    pub fn text(&self, row: usize) -> Option<&str> {
        if let Self::Text(cells) = self { cells.get(row).and_then(Option::as_deref) } else { None }
    }

    /// True where a cell says yes.
    #[must_use]
    pub fn truth(&self, row: usize) -> bool {
        matches!(self, Self::Truth(cells) if cells.get(row) == Some(&Some(true)))
    }
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// The unit of its values; empty for none.
    pub unit: &'static str,
    /// Its values.
    pub cells: Cells,
}

/// Rows by columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The columns, all of one length.
    pub columns: Vec<Column>,
}

/// The column of the design's index in the plan.
pub const ID: &str = "id";
/// The column of how the work on it ended, a word of [`State`](crate::sweep::row::State).
pub const STATE: &str = "state";
/// The column of whether it is feasible.
pub const FEASIBLE: &str = "feasible";
/// The column of how many stops it has.
pub const STOP: &str = "stop";
/// The column of how many cautions it has.
pub const CAUTION: &str = "caution";
/// The column of the codes of both.
pub const CODES: &str = "codes";
/// The column of why it is not feasible.
pub const REASON: &str = "reason";
/// The column of the value that the reason found.
pub const VALUE: &str = "value";
/// The column of the limit that it missed.
pub const LIMIT: &str = "limit";
/// The column of by how much.
pub const MARGIN: &str = "margin";
/// The column of what a failure said.
pub const MESSAGE: &str = "message";
/// The column of the summary that marks the front.
pub const FRONT: &str = "front";

/// The name of a column as it is shown: of an input without its mark.
#[must_use]
pub fn plain(name: &str) -> &str {
    name.strip_prefix(INPUT).unwrap_or(name)
}

/// An index, or another count, that was read as a number.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "counts are whole and far below 2^52")]
pub const fn whole(number: f64) -> u64 {
    number as u64
}

impl Table {
    /// The columns of a plan, without rows. Those of the summary alone are not among them.
    #[must_use]
    pub fn of(kind: &dyn Kind, plan: &Plan) -> Self {
        const fn column(name: String, unit: &'static str, cells: Cells) -> Column {
            Column { name, unit, cells }
        }
        let inputs = plan.inputs.iter().map(|one| {
            let cells = match one.parameter.kind {
                FieldKind::Real { .. } => Cells::Number(Vec::new()),
                FieldKind::Whole { .. } => Cells::Whole(Vec::new()),
                _ => Cells::Text(Vec::new()),
            };
            column(one.column(), one.parameter.unit.label(), cells)
        });
        let measures =
            kind.measures().iter().map(|one| column(one.key.to_owned(), one.unit.label(), Cells::Number(Vec::new())));
        let bare = |name: &str, cells: Cells| column(name.to_owned(), "", cells);
        let end = [
            bare(STATE, Cells::Text(Vec::new())),
            bare(FEASIBLE, Cells::Truth(Vec::new())),
            bare(STOP, Cells::Whole(Vec::new())),
            bare(CAUTION, Cells::Whole(Vec::new())),
            bare(CODES, Cells::Text(Vec::new())),
            bare(REASON, Cells::Text(Vec::new())),
            bare(VALUE, Cells::Number(Vec::new())),
            bare(LIMIT, Cells::Number(Vec::new())),
            bare(MARGIN, Cells::Number(Vec::new())),
            bare(MESSAGE, Cells::Text(Vec::new())),
        ];
        let first = bare(ID, Cells::Whole(Vec::new()));
        Self { columns: std::iter::once(first).chain(inputs).chain(measures).chain(end).collect() }
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |one| one.cells.len())
    }

    /// The same columns without rows.
    #[must_use]
    pub fn emptied(&self) -> Self {
        let column = |one: &Column| Column { cells: one.cells.emptied(), ..one.clone() };
        Self { columns: self.columns.iter().map(column).collect() }
    }

    /// The column of a name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&Cells> {
        self.columns.iter().find(|one| one.name == name).map(|one| &one.cells)
    }

    /// The indices of the designs, row by row.
    pub fn ids(&self) -> impl Iterator<Item = u64> {
        let ids = self.column(ID);
        (0..self.rows()).filter_map(move |row| ids?.number(row)).map(whole)
    }

    /// Takes the rows of a table with the same columns over.
    pub fn append(&mut self, other: Self) {
        for (own, other) in self.columns.iter_mut().zip(other.columns) {
            own.cells.append(other.cells);
        }
    }

    /// The first so many rows, taken off.
    #[must_use]
    pub fn split(&mut self, count: usize) -> Self {
        let column =
            |one: &mut Column| Column { name: one.name.clone(), unit: one.unit, cells: one.cells.split(count) };
        Self { columns: self.columns.iter_mut().map(column).collect() }
    }

    /// The rows that are wanted.
    #[must_use]
    pub fn picked(&self, wanted: &[bool]) -> Self {
        self.ordered(&(0..).zip(wanted).filter(|(_, wanted)| **wanted).map(|(row, _)| row).collect::<Vec<_>>())
    }

    /// These rows, in this order.
    #[must_use]
    pub fn ordered(&self, rows: &[usize]) -> Self {
        fn pick<T: Clone>(cells: &[Option<T>], rows: &[usize]) -> Vec<Option<T>> {
            rows.iter().filter_map(|row| cells.get(*row).cloned()).collect()
        }
        let column = |one: &Column| {
            let cells = match &one.cells {
                Cells::Whole(cells) => Cells::Whole(pick(cells, rows)),
                Cells::Number(cells) => Cells::Number(pick(cells, rows)),
                Cells::Text(cells) => Cells::Text(pick(cells, rows)),
                Cells::Truth(cells) => Cells::Truth(pick(cells, rows)),
            };
            Column { cells, ..one.clone() }
        };
        Self { columns: self.columns.iter().map(column).collect() }
    }

    /// Takes a row in.
    pub fn push(&mut self, row: Row) {
        let text = |text: Option<String>| One::Text(text.map(Into::into));
        let some = |text: &str| One::Text(Some(text.into()));
        let inputs = row.inputs.into_iter().map(|value| match value {
            Value::Real(number) => One::Number(Some(number)),
            Value::Whole(whole) => One::Whole(Some(whole.into())),
            Value::Choice(key) => some(key),
            Value::Line(line) => text(Some(line)),
        });
        let measures = row.measures.into_iter().map(One::Number);
        let end = [
            some(row.state.word()),
            One::Truth(Some(row.feasible)),
            One::Whole(Some(row.stops)),
            One::Whole(Some(row.cautions)),
            text(Some(row.codes.join(";"))),
            text(row.reason),
            One::Number(row.value),
            One::Number(row.limit),
            One::Number(row.margin),
            text(row.message),
        ];
        let first = One::Whole(i64::try_from(row.id).ok());
        for (column, one) in
            self.columns.iter_mut().zip(std::iter::once(first).chain(inputs).chain(measures).chain(end))
        {
            match (&mut column.cells, one) {
                (Cells::Whole(cells), One::Whole(one)) => cells.push(one),
                (Cells::Number(cells), One::Number(one)) => cells.push(one),
                (Cells::Text(cells), One::Text(one)) => cells.push(one),
                (Cells::Truth(cells), One::Truth(one)) => cells.push(one),
                (cells, _) => cells.empty(),
            }
        }
    }
}

impl Cells {
    /// Takes an empty cell in.
    fn empty(&mut self) {
        match self {
            Self::Whole(cells) => cells.push(None),
            Self::Number(cells) => cells.push(None),
            Self::Text(cells) => cells.push(None),
            Self::Truth(cells) => cells.push(None),
        }
    }
}

/// One cell.
enum One {
    Whole(Option<i64>),
    Number(Option<f64>),
    Text(Option<Box<str>>),
    Truth(Option<bool>),
}
