//! From the sheet of work offsets to the parameters of a var file.
//!
//! Rows are found by the system's name in column A, columns by their headings, wherever they stand; a row or column that
//! is missing leaves what the var file holds, and this is said.

use std::collections::BTreeMap;

use crate::escape::excerpt;
use crate::finding::{CellPlace, Exit, Finding, Grade, Place, Raise, Refusal};
use crate::limits::{EXCERPT, LISTED_SYMBOLS};
use crate::machine::length_unit::LengthUnit;
use crate::machine::var_file::{Unfit, VarFile};
use crate::machine::work_offset::{ACTIVE, G92_FIRST, G92_SWITCH, System};
use crate::parameter::Value;
use crate::text::Language;

use super::address;
use super::book::Book;
use super::gate::gate;
use super::offsets_sheet::{Column, G92, NAME, SCHEMA, SCHEMA_LABEL, SYSTEM, YES};
use super::rules::form::*;
use super::rules::offsets::*;
use super::schema::{hidden, refusal};
use super::sheet_cells::{Content, SheetCells};
use super::sheet_names::{no_cells, sheet_named};
use super::value::{holds, read_at};
use super::words::fold;

/// Columns A to P: those of the sheet, and some that a user may have put between them.
const COLUMNS: u32 = 16;

/// The offsets that a sheet holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OffsetsTable {
    /// Values by parameter, in the machine's unit.
    pub values: Vec<(u32, f64)>,
    /// The active system, if the sheet marks one.
    pub active: Option<System>,
    /// Whether G92 is in force, if the sheet says so.
    pub g92_on: Option<bool>,
    /// Notes and cautions.
    pub findings: Vec<Finding>,
}

impl OffsetsTable {
    /// Reads the sheet `ORIGENES` or `OFFSETS` of a workbook, its lengths in the machine's unit.
    ///
    /// # Errors
    /// One [`Refusal`] with everything that was found: what the gate refuses; a sheet, schema, heading, unit or row that
    /// is missing or given twice, lengths in another unit than the machine's, cells that are empty or hold anything
    /// but a number within its limits, no active system or two.
    pub fn read(bytes: &[u8], unit: LengthUnit) -> Result<Self, Refusal> {
        let mut book = Book::open(gate(bytes)?)?;
        let names = Language::ALL.map(|language| (NAME.get(language), language));
        let (entry, language) = sheet_named(
            &book.gated.sheets,
            &names,
            |_| true,
            |wanted, there| OffsetsSheetNotFound { wanted, there }.at(Place::File),
        )?;
        let mut table = Self { findings: std::mem::take(&mut book.gated.notes), ..Self::default() };
        let mut sheet = book.read(&entry, COLUMNS)?;
        let exit = sheet.survey.exit();
        if sheet.survey.unsound {
            return Err(refusal(exit, sheet.survey.findings));
        }
        if !sheet.survey.filled {
            return Err(no_cells(&entry));
        }
        table.findings.extend(hidden(&entry));
        check_schema(&sheet)?;
        table.findings.append(&mut sheet.survey.findings);
        let head = heading(&sheet)?;
        let mut reader = OffsetsReader { sheet: &sheet, unit, language, table: &mut table };
        let columns = reader.columns(head);
        reader.units(head + 1, &columns);
        let rows = reader.rows(head);
        reader.values(&columns, &rows);
        if table.findings.iter().any(|finding| finding.grade == Grade::Stop) {
            return Err(refusal(exit, table.findings));
        }
        Ok(table)
    }

    /// Puts the offsets into a var file; what is there already keeps its digits.
    ///
    /// # Errors
    /// For a value that the file cannot hold.
    pub fn apply(&self, file: &mut VarFile) -> Result<(), Unfit> {
        for (number, value) in &self.values {
            file.set(*number, *value)?;
        }
        if let Some(system) = self.active {
            file.set(ACTIVE, f64::from(system.number()))?;
        }
        if let Some(on) = self.g92_on
            && on != (file.get(G92_SWITCH).unwrap_or(0.0) != 0.0)
        {
            file.set(G92_SWITCH, f64::from(u8::from(on)))?;
        }
        Ok(())
    }
}

/// Refuses a sheet of another version.
fn check_schema(sheet: &SheetCells) -> Result<(), Refusal> {
    let labels = Language::ALL.map(|language| SCHEMA_LABEL.get(language));
    let row = sheet.rows.keys().find(|row| sheet.text((**row, 0)).is_some_and(|text| labels.contains(&text)));
    let found = row.and_then(|row| sheet.text((*row, 1))).unwrap_or_default();
    if found == SCHEMA {
        return Ok(());
    }
    let place = row.map_or_else(|| Place::Sheet(sheet.name.clone()), |row| Place::Cells(vec![sheet.place((*row, 1))]));
    let finding = if found.is_empty() {
        OffsetsSchemaMissing { known: SCHEMA }.at(place)
    } else {
        OffsetsOtherSchema { found: excerpt(found, EXCERPT), known: SCHEMA }.at(place)
    };
    Err(Refusal::new(Exit::Refused, finding))
}

/// The row of the headings.
fn heading(sheet: &SheetCells) -> Result<u32, Refusal> {
    let labels = Language::ALL.map(|language| fold(SYSTEM.get(language)));
    let is_heading = |row: &u32| sheet.text((*row, 0)).is_some_and(|text| labels.contains(&fold(text)));
    let rows: Vec<u32> = sheet.rows.keys().copied().filter(is_heading).collect();
    match rows.as_slice() {
        [row] => Ok(*row),
        [] => Err(HeadingsMissing { first: SYSTEM.clone() }.refused(Exit::Refused, Place::Sheet(sheet.name.clone()))),
        rows => {
            let cells = rows.iter().map(|row| sheet.place((*row, 0))).collect();
            Err(SeveralTables {}.refused(Exit::Refused, Place::Cells(cells)))
        }
    }
}

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Row {
    System(System),
    G92,
}

impl Row {
    fn all() -> impl Iterator<Item = Self> {
        System::ALL.into_iter().map(Self::System).chain([Self::G92])
    }

    const fn name(self) -> &'static str {
        match self {
            Self::System(system) => system.name(),
            Self::G92 => G92,
        }
    }
}

struct OffsetsReader<'a> {
    sheet: &'a SheetCells,
    unit: LengthUnit,
    language: Language,
    table: &'a mut OffsetsTable,
}

impl OffsetsReader<'_> {
    /// The columns by where they stand.
    fn columns(&mut self, head: u32) -> Vec<(Column, u32)> {
        let wanted = |text: &str, column: Column| {
            let mut labels = Language::ALL.into_iter().map(|one| column.parameter(self.unit, one).symbol());
            labels.any(|label| fold(label) == fold(text))
        };
        let mut found: Vec<(Column, u32)> = Vec::new();
        let (mut twice, mut unknown) = (Vec::new(), Vec::new());
        for at in 1..COLUMNS {
            let Some(text) = self.sheet.text((head, at)) else { continue };
            match Column::all().find(|column| wanted(text, *column)) {
                None => unknown.push((text.to_owned(), (head, at))),
                Some(column) => match found.iter().find(|(other, _)| *other == column) {
                    Some((_, first)) => twice.push((text.to_owned(), vec![(head, *first), (head, at)])),
                    None => found.push((column, at)),
                },
            }
        }
        let lost = |column: &Column| found.iter().all(|(other, _)| other != column);
        let lost: Vec<_> =
            Column::all().filter(lost).map(|one| one.parameter(self.unit, self.language).symbol()).collect();
        self.labels(twice, unknown, &lost);
        self.kept(&lost);
        found
    }

    /// Compares the units under the headings with those of the machine.
    fn units(&mut self, row: u32, columns: &[(Column, u32)]) {
        for &(column, at) in columns {
            let wanted = column.unit(self.unit);
            let written = self.sheet.text((row, at)).unwrap_or_default();
            if wanted.is_empty() || spellings(wanted).contains(&fold(written).as_str()) {
                continue;
            }
            let column = (column, column.parameter(self.unit, self.language).symbol());
            let (cell, unit) = (address::format((row, at)), wanted);
            let other = [LengthUnit::Inch, LengthUnit::Millimetre].into_iter().find(|unit| *unit != self.unit);
            let is_other = |other: LengthUnit| spellings(column.0.unit(other)).contains(&fold(written).as_str());
            let (column, shown) = (column.1, excerpt(written, EXCERPT));
            let row_of: Box<dyn Raise> = match other.filter(|other| is_other(*other)) {
                _ if written.is_empty() => Box::new(OffsetsUnitNotSaid { column, unit, cell }),
                Some(LengthUnit::Inch) => Box::new(OffsetsInInches { column, written: shown, unit, cell }),
                Some(LengthUnit::Millimetre) => Box::new(OffsetsInMillimetres { column, written: shown, unit, cell }),
                None => Box::new(OffsetsOtherUnit { column, written: shown, unit, cell }),
            };
            self.stop(vec![(row, at)], &*row_of);
        }
    }

    /// The rows by what they are about.
    fn rows(&mut self, head: u32) -> BTreeMap<Row, u32> {
        let mut found: BTreeMap<Row, u32> = BTreeMap::new();
        let (mut twice, mut unknown) = (Vec::new(), Vec::new());
        for &row in self.sheet.rows.keys().filter(|row| **row > head + 1) {
            let label = self.sheet.text((row, 0)).unwrap_or_default();
            match Row::all().find(|one| one.name().eq_ignore_ascii_case(label)) {
                None => unknown.push((self.label(row), (row, 0))),
                Some(name) => match found.get(&name) {
                    Some(first) => twice.push((name.name().to_owned(), vec![(*first, 0), (row, 0)])),
                    None => drop(found.insert(name, row)),
                },
            }
        }
        let lost: Vec<_> = Row::all().filter(|row| !found.contains_key(row)).map(Row::name).collect();
        self.labels(twice, unknown, &lost);
        if found.is_empty() {
            self.stop(vec![(head, 0)], &NoSystems {});
        }
        self.kept(&lost);
        found
    }

    fn values(&mut self, columns: &[(Column, u32)], rows: &BTreeMap<Row, u32>) {
        let mut active = Vec::new();
        for (&name, &row) in rows {
            for &(column, at) in columns {
                let parameter = column.parameter(self.unit, self.language);
                if (name, column) == (Row::G92, Column::Rotation) {
                    if holds(self.sheet, (row, at)) {
                        let cell = address::format((row, at));
                        self.stop(vec![(row, at)], &G92Rotation { cell });
                    }
                    continue;
                }
                let value = read_at(parameter, self.sheet, (row, at), &mut self.table.findings);
                match (name, column, value) {
                    (Row::System(system), Column::Active, Some(Value::Choice(YES))) => active.push((system, (row, at))),
                    (Row::G92, Column::Active, value) => {
                        self.table.g92_on = Some(value == Some(Value::Choice(YES)));
                    }
                    (Row::System(system), Column::Axis(axis), Some(Value::Real(value))) => {
                        self.table.values.push((system.first_parameter() + axis as u32, value));
                    }
                    (Row::System(system), Column::Rotation, Some(Value::Real(value))) => {
                        self.table.values.push((system.rotation_parameter(), value));
                    }
                    (Row::G92, Column::Axis(axis), Some(Value::Real(value))) => {
                        self.table.values.push((G92_FIRST + axis as u32, value));
                    }
                    _ => {}
                }
            }
        }
        let Some((_, at)) = columns.iter().find(|(column, _)| *column == Column::Active) else { return };
        match active.as_slice() {
            [(system, _)] => self.table.active = Some(*system),
            [] => {
                let systems = rows.iter().filter(|(name, _)| **name != Row::G92);
                let cells: Vec<_> = systems.map(|(_, row)| (*row, *at)).collect();
                if !cells.is_empty() {
                    self.stop(cells, &NoActiveSystem {});
                }
            }
            several => {
                let names: Vec<_> = several.iter().map(|(system, _)| system.name()).collect();
                let cells = several.iter().map(|(_, cell)| *cell).collect();
                self.stop(cells, &SeveralActiveSystems { names: names.join(", ") });
            }
        }
    }

    /// What stands in column A of a row, if not a text.
    fn label(&self, row: u32) -> String {
        match self.sheet.cell((row, 0)).map(|cell| &cell.content) {
            Some(Content::Text(text, _)) => text.trim().to_owned(),
            Some(Content::Number(number)) => number.to_string(),
            _ => address::format((row, 0)),
        }
    }

    /// Refuses labels given twice, and mentions those that are not known.
    fn labels(
        &mut self,
        twice: Vec<(String, Vec<address::Position>)>,
        unknown: Vec<(String, address::Position)>,
        lost: &[&'static str],
    ) {
        for (label, cells) in twice {
            self.stop(cells, &HeadingTwice { heading: excerpt(&label, EXCERPT) });
        }
        let squeezed = |label: &str| fold(label).chars().filter(|one| one.is_alphanumeric()).collect::<String>();
        // Of a name of one letter every other letter is another name.
        let mistyped = |label: &str| {
            let label = squeezed(label);
            lost.iter().copied().find(|name| {
                let most = usize::from(name.len() > 1);
                strsim::damerau_levenshtein(&label, &squeezed(name)) <= most
            })
        };
        for (label, cell) in unknown.into_iter().take(LISTED_SYMBOLS) {
            if let Some(name) = mistyped(&label) {
                self.stop(vec![cell], &LabelMistyped { label: excerpt(&label, EXCERPT), name });
                continue;
            }
            let row = HeadingUnknown { heading: excerpt(&label, EXCERPT) };
            self.table.findings.push(row.at(Place::Cells(vec![self.sheet.place(cell)])));
        }
    }

    /// Says what the sheet does not have.
    fn kept(&mut self, names: &[&str]) {
        if !names.is_empty() {
            let row = NotOnSheet { names: names.join(", ") };
            self.table.findings.push(row.at(Place::Sheet(self.sheet.name.clone())));
        }
    }

    fn stop(&mut self, cells: Vec<address::Position>, row: &dyn Raise) {
        let cells: Vec<CellPlace> = cells.into_iter().map(|cell| self.sheet.place(cell)).collect();
        self.table.findings.push(row.at(Place::Cells(cells)));
    }
}

/// The ways of writing a unit, without capitals.
const fn spellings(unit: &str) -> &'static [&'static str] {
    match unit.as_bytes() {
        b"mm" => &["mm"],
        b"in" => &["in", "inch", "inches", "pulg", "pulgadas", "\""],
        _ => &["°", "º", "deg", "grados", "degrees"],
    }
}
