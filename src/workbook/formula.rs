//! What the formulas of a form come to: as much of a spreadsheet's language as the live forms use.
//!
//! References are absolute, or names of cells. Ranges are parts of one column. Whatever is not known is an error; the test of the forms
//! compares each result with LibreOffice's.

use std::cmp::Ordering;

use super::address;
use super::calculated::Book;
use crate::number::{decimal, trig};

/// What a formula comes to, or the error that it shows.
pub(super) type Found = Result<Value, &'static str>;

const WRONG: &str = "#VALUE!";
/// The error of what is none of this language.
pub(super) const UNKNOWN: &str = "#NAME?";

/// A value of a cell or of a part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Value {
    Blank,
    Number(f64),
    Text(String),
    Truth(bool),
    /// Of a range or of what is computed from one.
    Many(Vec<Found>),
}

use Value::{Blank, Many, Number, Text, Truth};

impl Value {
    fn number(&self) -> Result<f64, &'static str> {
        match self {
            Blank => Ok(0.0),
            Number(number) => Ok(*number),
            Truth(truth) => Ok(f64::from(u8::from(*truth))),
            Text(text) => text.trim().parse().map_err(|_| WRONG),
            Many(_) => Err(WRONG),
        }
    }

    fn text(&self) -> Result<String, &'static str> {
        match self {
            Blank => Ok(String::new()),
            Number(number) => Ok(decimal(*number)),
            Text(text) => Ok(text.clone()),
            Truth(_) | Many(_) => Err(WRONG),
        }
    }

    /// The order of values: numbers before texts, whose capitals do not count.
    fn order(&self, other: &Self) -> Ordering {
        if let (Text(one), Text(other)) = (self, other) {
            return one.to_lowercase().cmp(&other.to_lowercase());
        }
        let number = |one: &Self| if let Text(_) = one { f64::INFINITY } else { one.number().unwrap_or(f64::INFINITY) };
        number(self).partial_cmp(&number(other)).unwrap_or(Ordering::Equal)
    }
}

/// A formula, read.
#[derive(Debug)]
enum Node {
    Constant(Value),
    /// A sheet, a column, and its cells from a row to another, all from 0.
    Cells(usize, u32, [u32; 2]),
    Call(String, Vec<Node>),
    Pair(&'static str, Box<[Node; 2]>),
}

/// The signs between two parts by how tightly they bind, the loosest first; the longer ones before their beginnings.
const SIGNS: [&[&str]; 5] = [&["<=", ">=", "<>", "=", "<", ">"], &["&"], &["+", "-"], &["*", "/"], &["^"]];

struct Reader<'a> {
    rest: &'a str,
    sheet: usize,
    book: &'a Book,
}

impl<'a> Reader<'a> {
    fn take(&mut self, sign: &str) -> bool {
        let found = self.rest.strip_prefix(sign);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    fn pairs(&mut self, level: usize) -> Option<Node> {
        let Some(signs) = SIGNS.get(level) else { return self.single() };
        let mut left = self.pairs(level + 1)?;
        while let Some(sign) = signs.iter().find(|sign| self.take(sign)) {
            left = Node::Pair(sign, Box::new([left, self.pairs(level + 1)?]));
        }
        Some(left)
    }

    fn single(&mut self) -> Option<Node> {
        if self.take("-") {
            return Some(Node::Pair("-", Box::new([Node::Constant(Number(0.0)), self.single()?])));
        }
        if self.take("(") {
            let inside = self.pairs(0)?;
            return self.take(")").then_some(inside);
        }
        if self.take("\"") {
            let (text, rest) = self.rest.split_once('"')?;
            self.rest = rest;
            return Some(Node::Constant(Text(text.to_owned())));
        }
        let (mut word, mut sheet) = (self.word(), self.sheet);
        if self.take("(") {
            let mut arguments = Vec::new();
            while !self.take(")") {
                arguments.push(self.pairs(0)?);
                self.take(",");
            }
            return Some(Node::Call(word.to_owned(), arguments));
        }
        if self.take("!") {
            (sheet, word) = (self.book.sheet(word.trim_matches('\''))?, self.word());
        }
        if word.contains('$') {
            return self.cells(sheet, word);
        }
        Some(match word {
            "TRUE" | "FALSE" => Node::Constant(Truth(word == "TRUE")),
            _ if word.starts_with(|one: char| one.is_ascii_digit()) => Node::Constant(Number(word.parse().ok()?)),
            _ => {
                let (sheet, (row, column)) = self.book.name(word)?;
                Node::Cells(sheet, column, [row; 2])
            }
        })
    }

    fn word(&mut self) -> &'a str {
        let end =
            self.rest.find(|one: char| !one.is_alphanumeric() && !"_.$'".contains(one)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at_checked(end).unwrap_or_default();
        self.rest = rest;
        word
    }

    /// The cells that a reference leads to: one, some of a column, or all of it.
    fn cells(&mut self, sheet: usize, first: &str) -> Option<Node> {
        let last = if self.take(":") { self.word() } else { first };
        let at = |one: &str, row: u32| {
            let plain = one.replace('$', "");
            address::parse(&plain).or_else(|| address::parse(&format!("{plain}{row}")))
        };
        let (first, last) = (at(first, 1)?, at(last, self.book.rows(sheet))?);
        (first.1 == last.1).then_some(Node::Cells(sheet, first.1, [first.0, last.0]))
    }
}

/// What a formula on a sheet comes to.
pub(super) fn value(formula: &str, sheet: usize, book: &Book) -> Found {
    let mut reader = Reader { rest: formula, sheet, book };
    let node = reader.pairs(0).filter(|_| reader.rest.is_empty());
    node.map_or(Err(UNKNOWN), |node| node.value(book))
}

impl Node {
    fn value(&self, book: &Book) -> Found {
        match self {
            Self::Constant(value) => Ok(value.clone()),
            Self::Cells(sheet, column, [first, last]) if first == last => book.cell((*sheet, (*first, *column))),
            Self::Cells(sheet, column, [first, last]) => {
                Ok(Many((*first..=*last).map(|row| book.cell((*sheet, (row, *column)))).collect()))
            }
            Self::Pair(sign, parts) => each(&parts.each_ref().map(|part| part.value(book)), &|found| pair(sign, found)),
            Self::Call(name, arguments) => call(name, arguments, book),
        }
    }

    /// Its values, one after the other.
    fn flat(&self, book: &Book) -> Vec<Found> {
        match self.value(book) {
            Ok(Many(all)) => all,
            one => vec![one],
        }
    }
}

/// Does something with values; of many, with each.
fn each(found: &[Found], of: &dyn Fn(&[Found]) -> Found) -> Found {
    let many = found.iter().find_map(|one| if let Ok(Many(all)) = one { Some(all.len()) } else { None });
    let Some(count) = many else { return of(found) };
    let at = |index: usize| -> Vec<Found> {
        let pick = |one: &Found| match one {
            Ok(Many(all)) => all.get(index).cloned().unwrap_or(Err("#N/A")),
            one => one.clone(),
        };
        found.iter().map(pick).collect()
    };
    Ok(Many((0..count).map(|index| of(&at(index))).collect()))
}

/// A number; of a division by zero, a root of what is below it, none.
fn finite(number: f64) -> Result<f64, &'static str> {
    if number.is_finite() { Ok(number) } else { Err("#NUM!") }
}

fn pair(sign: &str, found: &[Found]) -> Found {
    let [Ok(one), Ok(other)] = found else {
        return found.iter().find(|one| one.is_err()).cloned().unwrap_or(Err(WRONG));
    };
    if sign == "&" {
        return Ok(Text(one.text()? + &other.text()?));
    }
    let order = one.order(other);
    let numbers = || Ok::<_, &'static str>([one.number()?, other.number()?]);
    let computed = |of: fn(f64, f64) -> f64| numbers().map(|[one, other]| of(one, other)).and_then(finite).map(Number);
    Ok(match sign {
        "=" => Truth(order.is_eq()),
        "<>" => Truth(order.is_ne()),
        "<" => Truth(order.is_lt()),
        "<=" => Truth(order.is_le()),
        ">" => Truth(order.is_gt()),
        ">=" => Truth(order.is_ge()),
        "+" => computed(|one, other| one + other)?,
        "-" => computed(|one, other| one - other)?,
        "*" => computed(|one, other| one * other)?,
        "/" => computed(|one, other| one / other)?,
        _ => computed(trig::pow)?,
    })
}

/// What a function of ranges gives; what is none of single values.
fn call(name: &str, arguments: &[Node], book: &Book) -> Found {
    let number = |count: usize| Ok(Number(f64::from(u32::try_from(count).unwrap_or(u32::MAX))));
    let all = || arguments.iter().flat_map(|one| one.flat(book));
    let numbers = || {
        let counted = all().filter(|one| matches!(one, Ok(Number(_)) | Err(_)));
        counted.map(|one| one?.number()).collect::<Result<Vec<f64>, _>>().map(Vec::into_iter)
    };
    match (name, arguments) {
        ("IF", [when, then, otherwise]) => {
            if when.value(book)?.number()? != 0.0 { then } else { otherwise }.value(book)
        }
        ("AND", _) => all().try_fold(true, |so_far, one| Ok(so_far & (one?.number()? != 0.0))).map(Truth),
        ("OR", _) => all().try_fold(false, |so_far, one| Ok(so_far | (one?.number()? != 0.0))).map(Truth),
        ("COUNT", _) => number(all().filter(|one| matches!(one, Ok(Number(_)))).count()),
        ("COUNTA", _) => number(all().filter(|one| *one != Ok(Blank)).count()),
        ("COUNTIF", [cells, wanted]) => {
            let wanted = wanted.value(book)?;
            number(cells.flat(book).iter().flatten().filter(|one| counts(one, &wanted)).count())
        }
        ("SUM" | "SUMPRODUCT", _) => Ok(Number(numbers()?.sum())),
        ("MAX", _) => Ok(Number(numbers()?.reduce(f64::max).unwrap_or_default())),
        ("MIN", _) => Ok(Number(numbers()?.reduce(f64::min).unwrap_or_default())),
        ("INDEX", [cells, at]) => {
            let at = at.value(book)?.number()?;
            let found = (1..).zip(cells.flat(book)).find(|(row, _)| f64::from(*row) == at);
            found.map_or(Err("#REF!"), |(_, found)| found)
        }
        ("MATCH", [wanted, cells, _]) => {
            let wanted = wanted.value(book)?;
            let same = |one: &Found| one.as_ref().is_ok_and(|one| *one != Blank && one.order(&wanted).is_eq());
            cells.flat(book).iter().position(same).map_or(Err("#N/A"), |at| number(at + 1))
        }
        ("ROW", [Node::Cells(_, _, [row, last])]) if row == last => Ok(Number(f64::from(row + 1))),
        ("ROW", [Node::Cells(_, _, [first, last])]) => {
            Ok(Many((*first..=*last).map(|row| Ok(Number(f64::from(row + 1)))).collect()))
        }
        ("COLUMN", [Node::Cells(_, column, _)]) => Ok(Number(f64::from(column + 1))),
        _ => {
            let found: Vec<Found> = arguments.iter().map(|one| one.value(book)).collect();
            each(&found, &|found| single(name, found))
        }
    }
}

/// Whether a cell is counted: by what it holds, or by a comparison with a number.
fn counts(cell: &Value, wanted: &Value) -> bool {
    let than = |sign: char| match wanted {
        Text(text) => text.strip_prefix(sign)?.parse().ok().map(Number),
        _ => None,
    };
    match (cell, than('<'), than('>')) {
        (Blank, ..) => false,
        (Number(_), Some(most), _) => cell.order(&most).is_lt(),
        (Number(_), _, Some(least)) => cell.order(&least).is_gt(),
        _ => cell.order(wanted).is_eq(),
    }
}

/// What a function of single values gives.
fn single(name: &str, found: &[Found]) -> Found {
    match (name, found) {
        ("ISERROR", [one]) => return Ok(Truth(one.is_err())),
        ("ISNUMBER", [one]) => return Ok(Truth(matches!(one, Ok(Number(_))))),
        ("ISLOGICAL", [one]) => return Ok(Truth(matches!(one, Ok(Truth(_))))),
        _ => {}
    }
    let values = found.iter().cloned().collect::<Result<Vec<_>, _>>()?;
    let count = |value: &Value| value.text()?.parse::<usize>().map_err(|_| WRONG);
    Ok(match (name, values.as_slice()) {
        ("NOT", [one]) => Truth(one.number()? == 0.0),
        ("N", [one]) => Number(one.number().unwrap_or_default()),
        ("LEN", [text]) => Number(text.text()?.encode_utf16().fold(0.0, |sum, _| sum + 1.0)),
        ("TRIM", [text]) => Text(text.text()?.split(' ').filter(|one| !one.is_empty()).collect::<Vec<_>>().join(" ")),
        ("LOWER", [text]) => Text(text.text()?.to_lowercase()),
        ("UPPER", [text]) => Text(text.text()?.to_uppercase()),
        ("LEFT", [text, most]) => Text(text.text()?.chars().take(count(most)?).collect()),
        ("RIGHT", [text, most]) => {
            let text = text.text()?;
            Text(text.chars().skip(text.chars().count().saturating_sub(count(most)?)).collect())
        }
        ("MID", [text, from, most]) => {
            Text(text.text()?.chars().skip(count(from)?.checked_sub(1).ok_or(WRONG)?).take(count(most)?).collect())
        }
        // Beyond ASCII the character hangs on the reader's code page.
        ("CHAR", [code]) => {
            let code = count(code)?.try_into().ok().filter(u8::is_ascii).ok_or(WRONG)?;
            Text(char::from(code).to_string())
        }
        ("REPT", [text, times]) => Text(text.text()?.repeat(count(times)?)),
        ("SUBSTITUTE", [text, old, new]) => Text(text.text()?.replace(&old.text()?, &new.text()?)),
        ("FIND", [wanted, text]) => {
            let text = text.text()?;
            let (before, _) = text.split_once(&wanted.text()?).ok_or(WRONG)?;
            Number(before.chars().fold(1.0, |at, _| at + 1.0))
        }
        ("ADDRESS", [row, column, _]) => {
            let from_0 = |one| u32::try_from(count(one)?.checked_sub(1).ok_or(WRONG)?).map_err(|_| WRONG);
            Text(address::format((from_0(row)?, from_0(column)?)))
        }
        _ => {
            let numbers = values.iter().map(Value::number).collect::<Result<Vec<_>, _>>()?;
            Number(of_numbers(name, &numbers).and_then(finite)?)
        }
    })
}

fn of_numbers(name: &str, numbers: &[f64]) -> Result<f64, &'static str> {
    Ok(match (name, numbers) {
        ("PI", []) => std::f64::consts::PI,
        ("ABS", [x]) => x.abs(),
        ("SQRT", [x]) => x.sqrt(),
        ("SIN", [x]) => trig::sin(*x),
        ("COS", [x]) => trig::cos(*x),
        ("TAN", [x]) => trig::tan(*x),
        ("ASIN", [x]) => trig::asin(*x),
        ("ATAN", [x]) => trig::atan(*x),
        ("ATAN2", [x, y]) => trig::atan2(*y, *x),
        ("RADIANS", [x]) => x.to_radians(),
        ("DEGREES", [x]) => x.to_degrees(),
        ("INT", [x]) => x.floor(),
        ("ROUNDUP", [x, 0.0]) => x.abs().ceil().copysign(*x),
        _ => return Err(UNKNOWN),
    })
}
