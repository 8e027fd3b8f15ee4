//! A sheet's part, looked at as it is written: where each cell stands and what it is said to hold.
//!
//! calamine gives a cell's value and hides how it came about: a text in a number cell, a formula never calculated, a
//! cell given twice, an address outside the grid. This walk sees them, and nothing it finds unsound reaches calamine.

use std::collections::BTreeSet;

use quick_xml::events::{BytesStart, Event};

use crate::escape::excerpt;
use crate::finding::{CellPlace, Finding, Place, Refusal};
use crate::text::Text;

use super::address::{self, Position, Range};
use super::limits;
use super::xml::{self, damaged, raw};

/// Columns A to E: all that is read of a form's sheet.
pub const COLUMNS: u32 = 5;
/// Cells beyond this column or row are so far out that they are mentioned.
const FAR: Position = (10_000, 26);
/// Most findings kept of one sheet.
const FINDINGS: usize = 1_000;
/// Characters of a raw value kept for a message.
const SHOWN: usize = 40;

/// What the walk over a sheet's part saw.
#[derive(Debug, Default)]
pub struct Survey {
    /// What is wrong with cells.
    pub findings: Vec<Finding>,
    /// Cells that a finding is about already.
    pub judged: BTreeSet<Position>,
    /// Cells with a formula and no value stored with it.
    pub uncalculated: BTreeSet<Position>,
    /// Merged cells that reach into columns A to E.
    pub merges: Vec<Range>,
    /// True where calamine must not read the sheet.
    pub unsound: bool,
    /// True where the package is damaged and not only a value wrong.
    pub damaged: bool,
    /// True where at least one cell holds something.
    pub filled: bool,
}

impl Survey {
    /// The merged cells that cover a cell without it being their corner.
    #[must_use]
    pub fn covering(&self, position: Position) -> Option<&Range> {
        self.merges.iter().find(|range| range.start != position && range.holds(position))
    }
}

/// Walks a sheet's part.
///
/// # Errors
/// [`Exit::Unreadable`](crate::finding::Exit::Unreadable) where the part is no sound XML or no sheet; faults of single cells are
/// listed in the survey instead.
pub fn survey(sheet: &str, part: &str, text: &str, strings: usize) -> Result<Survey, Refusal> {
    let mut walk = Walk { sheet, part, strings, ..Walk::default() };
    xml::walk(part, text, |depth, event| walk.visit(depth, event))?;
    if let Some(first) = walk.far {
        let address = address::format(first);
        walk.survey.findings.push(Finding::note(
            walk.place(first),
            say!(
                "hay celdas rellenas lejos del formulario (la primera, {address}): no se leen",
                "there are filled cells far from the form (the first is {address}): they are not read"
            ),
        ));
    }
    Ok(walk.survey)
}

/// A cell while its element is open.
#[derive(Default)]
struct Open {
    position: Position,
    kind: Option<String>,
    formula: bool,
    /// The value's raw text, as far as one unbroken text gives it.
    value: Option<String>,
    inline: bool,
    /// Written in a way that calamine reads differently from what stands there.
    twisted: bool,
}

#[derive(Default)]
struct Walk<'s> {
    sheet: &'s str,
    part: &'s str,
    strings: usize,
    survey: Survey,
    state: State,
    row: u32,
    column: u32,
    cell: Open,
    /// One bit for each of the columns A to E, by row.
    seen: Vec<u8>,
    far: Option<Position>,
}

#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum State {
    /// Before the cells.
    #[default]
    Before,
    /// Among the rows; the element of all cells has depth 2.
    Rows,
    /// In a row.
    Row,
    /// In a cell.
    Cell,
    /// In a cell's value.
    Value,
    /// In another part of a cell: formula, inline text.
    Inside,
    /// After the cells.
    After,
}

impl Walk<'_> {
    fn visit(&mut self, depth: usize, event: &Event<'_>) -> Result<(), Refusal> {
        match event {
            Event::Start(start) => self.start(depth, start),
            Event::End(_) => {
                self.end(depth);
                Ok(())
            }
            Event::Text(text) if self.state == State::Value => {
                let kept: String = text.chars().take(401).collect();
                self.cell.value.get_or_insert_default().push_str(&kept);
                Ok(())
            }
            // calamine takes the first text of a value alone: 1&#50; would be 1.
            Event::CData(_) | Event::GeneralRef(_) | Event::Comment(_) | Event::PI(_) if self.state == State::Value => {
                let whole = matches!(self.cell.kind.as_deref(), Some("str" | "d")) && !matches!(event, Event::CData(_));
                self.cell.twisted |= !whole;
                if self.cell.value.as_ref().is_none_or(String::is_empty) {
                    self.cell.value = Some("?".to_owned());
                }
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn start(&mut self, depth: usize, start: &BytesStart<'_>) -> Result<(), Refusal> {
        let name = start.local_name();
        let name = name.as_ref();
        match (self.state, name) {
            (State::Before, "dimension") if raw(start, "ref").is_none_or(|range| Range::parse(&range).is_none()) => {
                return Err(self.broken(&Text::fixed("su extensión no es válida", "its dimension is not valid")));
            }
            (State::Before, "sheetData") if depth == 2 => self.state = State::Rows,
            (State::Rows, "row") => {
                if let Some(number) = raw(start, "r") {
                    match address::row(&number) {
                        Some(row) => self.row = row,
                        None => self.outside(&number),
                    }
                }
                self.state = State::Row;
            }
            (State::Row, "c") => {
                self.open(start);
                self.state = State::Cell;
            }
            (State::Cell, "v") => {
                self.cell.twisted |= self.cell.value.is_some();
                self.cell.value = Some(String::new());
                self.state = State::Value;
            }
            (State::Cell, "f") => {
                // calamine forgets a value that stands before its formula.
                self.cell.twisted |= self.cell.value.is_some() || self.cell.inline;
                self.cell.formula = true;
                self.state = State::Inside;
            }
            (State::Cell, "is") => {
                self.cell.twisted |= self.cell.inline;
                self.cell.inline = true;
                self.state = State::Inside;
            }
            (State::Rows | State::Row | State::Cell | State::Value, _) => {
                let name = excerpt(name, SHOWN);
                return Err(self.broken(&say!(
                    "el elemento {name} no corresponde a una hoja",
                    "the element {name} does not belong to a sheet"
                )));
            }
            (_, "sheetData") => {
                return Err(self.broken(&Text::fixed("sus datos están repetidos", "its cells are given twice")));
            }
            (State::After, "mergeCell") => self.merge(start)?,
            _ => {}
        }
        Ok(())
    }

    fn end(&mut self, depth: usize) {
        self.state = match (self.state, depth) {
            (State::Rows, 2) => State::After,
            (State::Row, 3) => {
                self.row = self.row.saturating_add(1);
                self.column = 0;
                State::Rows
            }
            (State::Cell, 4) => {
                self.close();
                self.column = self.column.saturating_add(1);
                State::Row
            }
            (State::Value | State::Inside, 5) => State::Cell,
            (state, _) => state,
        };
    }

    fn open(&mut self, start: &BytesStart<'_>) {
        self.cell = Open { kind: raw(start, "t").map(std::borrow::Cow::into_owned), ..Open::default() };
        let mut position = (self.row, self.column);
        if let Some(written) = raw(start, "r") {
            match address::parse(&written) {
                Some(given) => position = given,
                None => self.outside(&written),
            }
        }
        self.column = position.1;
        self.cell.position = position;
        if position.0 >= limits::GRID_ROWS || position.1 >= limits::GRID_COLUMNS {
            self.outside(&address::format(position));
        }
        if position.0 != self.row {
            let row = u64::from(self.row) + 1;
            self.fault(position, false, say!("está escrita en la fila {row}", "is written in row {row}"));
        }
        self.mark();
    }

    /// Refuses a cell of columns A to E that is given twice.
    fn mark(&mut self) {
        let (row, column) = self.cell.position;
        let Ok(index) = usize::try_from(row) else { return };
        if column >= COLUMNS || row >= limits::GRID_ROWS {
            return;
        }
        if self.seen.len() <= index {
            self.seen.resize(index + 1, 0);
        }
        let bit = 1_u8 << column;
        if let Some(bits) = self.seen.get_mut(index) {
            let twice = *bits & bit != 0;
            *bits |= bit;
            if twice {
                let position = self.cell.position;
                self.fault(position, false, Text::fixed("está dos veces en el archivo", "is given twice in the file"));
            }
        }
    }

    /// Judges a cell when all of it is known.
    fn close(&mut self) {
        let cell = std::mem::take(&mut self.cell);
        let position = cell.position;
        let value = cell.value.as_deref().unwrap_or_default();
        let shown = excerpt(value, SHOWN);
        if cell.twisted {
            self.survey.damaged = true;
            return self.fault(
                position,
                true,
                Text::fixed(
                    "está escrita de un modo que no se lee con seguridad",
                    "is written in a way that cannot be read safely",
                ),
            );
        }
        let filled = !value.is_empty() || cell.inline || cell.formula;
        self.survey.filled |= filled;
        if filled && (position.0 >= FAR.0 || position.1 >= FAR.1) && self.far.is_none() {
            self.far = Some(position);
        }
        let near = position.1 < COLUMNS;
        let kind = cell.kind.as_deref();
        if near && cell.formula && value.is_empty() && !cell.inline && !(kind == Some("str") && cell.value.is_some()) {
            self.survey.uncalculated.insert(position);
        }
        match kind {
            None | Some("n") if !value.is_empty() => {
                if !is_number(value) {
                    let non_finite = ["nan", "inf", "+inf", "-inf", "infinity", "-infinity", "1.#inf", "-1.#ind"]
                        .iter()
                        .any(|one| value.trim().eq_ignore_ascii_case(one));
                    let what = if non_finite {
                        say!(
                            "guarda {shown}, que no es un número finito",
                            "holds {shown}, which is not a finite number"
                        )
                    } else {
                        say!("guarda \"{shown}\" como si fuera un número", "holds \"{shown}\" as if it were a number")
                    };
                    // Without a type given, calamine takes it for a text; with one, it gives the sheet up.
                    self.fault(position, kind.is_some(), what);
                } else if near && !value.parse::<f64>().is_ok_and(f64::is_finite) {
                    let what = say!(
                        "guarda {shown}, que no es un número finito",
                        "holds {shown}, which is not a finite number"
                    );
                    self.fault(position, false, what);
                }
            }
            Some("s") if !value.is_empty() => {
                let digits = value.len() <= 9 && value.bytes().all(|byte| byte.is_ascii_digit());
                if !digits || value.parse::<usize>().is_ok_and(|index| index >= self.strings) {
                    self.survey.damaged = true;
                    let count = self.strings;
                    self.fault(
                        position,
                        true,
                        say!(
                            "pide el texto {shown} y el libro tiene {count}",
                            "asks for shared text {shown}, and the workbook has {count}"
                        ),
                    );
                }
            }
            Some("b") if !matches!(value.trim().to_ascii_lowercase().as_str(), "" | "0" | "1" | "true" | "false") => {
                self.fault(
                    position,
                    true,
                    say!("guarda \"{shown}\" como valor lógico", "holds \"{shown}\" as a truth value"),
                );
            }
            Some("e") if !value.is_empty() => {
                let known = ["#DIV/0!", "#N/A", "#NAME?", "#NULL!", "#NUM!", "#REF!", "#VALUE!"].contains(&value);
                if !known {
                    self.fault(position, true, say!("contiene el error {shown}", "holds the error {shown}"));
                }
            }
            None | Some("n" | "s" | "b" | "e" | "str" | "inlineStr" | "d") => {}
            Some(other) => {
                let other = excerpt(other, SHOWN);
                self.survey.damaged = true;
                self.fault(
                    position,
                    true,
                    say!("es de la clase desconocida {other}", "is of the unknown type {other}"),
                );
            }
        }
    }

    fn merge(&mut self, start: &BytesStart<'_>) -> Result<(), Refusal> {
        let range = raw(start, "ref").and_then(|range| Range::parse(&range)).ok_or_else(|| {
            self.broken(&Text::fixed("una combinación de celdas no es válida", "a range of merged cells is not valid"))
        })?;
        if range.start.1 < COLUMNS {
            self.survey.merges.push(range);
        }
        Ok(())
    }

    fn place(&self, position: Position) -> Place {
        Place::Cells(vec![CellPlace { sheet: self.sheet.to_owned(), cell: address::format(position) }])
    }

    /// A fault of a cell, as what follows its address.
    fn fault(&mut self, position: Position, unsound: bool, what: Text) {
        let cell = address::format(position);
        let what = Text::new(format!("la celda {cell} {}", what.es), format!("cell {cell} {}", what.en));
        let remedy = say!(
            "borre la celda {cell}, escriba de nuevo su valor y guarde el libro",
            "clear cell {cell}, type its value again and save the workbook"
        );
        self.survey.unsound |= unsound;
        self.survey.judged.insert(position);
        if self.survey.findings.len() < FINDINGS {
            let finding = Finding::stop(self.place(position), what, remedy);
            self.survey.findings.push(finding);
        }
    }

    /// A cell or row whose address lies outside of the grid.
    fn outside(&mut self, written: &str) {
        let written = excerpt(written, SHOWN);
        self.survey.unsound = true;
        if self.survey.findings.len() < FINDINGS {
            self.survey.findings.push(Finding::stop(
                Place::Sheet(self.sheet.to_owned()),
                say!(
                    "hay una celda fuera de la hoja (\"{written}\"; la última es XFD1048576)",
                    "there is a cell outside the sheet grid (\"{written}\"; the last is XFD1048576)"
                ),
                xml::save_again(),
            ));
        }
    }

    fn broken(&self, what: &Text) -> Refusal {
        let sheet = excerpt(self.sheet, 80);
        let text = Text::new(
            format!("la hoja \"{sheet}\" está dañada: {}", what.es),
            format!("the sheet \"{sheet}\" is damaged: {}", what.en),
        );
        damaged(self.part, text)
    }
}

/// True for a number as spreadsheet programs write it: digits with an optional sign, point and exponent.
fn is_number(text: &str) -> bool {
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).map_or((unsigned, None), |(one, two)| (one, Some(two)));
    let (whole, fraction) = mantissa.split_once('.').map_or((mantissa, None), |(one, two)| (one, Some(two)));
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    text.len() <= 400
        && digits(whole)
        && fraction.is_none_or(digits)
        && exponent.is_none_or(|text| digits(text.strip_prefix(['+', '-']).unwrap_or(text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_a_spreadsheet_writes_is_a_number() {
        for number in ["0", "-0", "12.5", "1E-3", "1e+300", "0.30000000000000004", "1e400"] {
            assert!(is_number(number), "{number}");
        }
        for text in ["", " 12 ", "12x", "abc", "+1", ".5", "5.", "1e", "NaN", "0x10", "1_0", "1,5", "--1", "1e1.5"] {
            assert!(!is_number(text), "{text}");
        }
    }
}
