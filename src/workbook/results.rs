//! The results workbook: the form again, every table, the programs, and the checks.

use std::io::{Seek, Write};

use rust_xlsxwriter::{RowNum, Workbook, Worksheet};

use super::charts::{Placed, draw};
use super::checks_sheet;
use super::derived;
use super::error::WriteError;
use super::form_sheet::{self, Filling};
use super::limits;
use super::long_rows::{LongRows, save};
use super::names::SheetNames;
use super::page::{Page, properties};
use super::program_sheet::{self, ProgramSheet};
use super::style::Styles;
use super::table_sheet::{FIRST, TableSheet};
use super::template::{HOW, OPTIONAL, write_lists};
use crate::kind::{Chart, Outcome, checks};
use crate::table::Table;
use crate::text::{Language, Text, t};

/// The height of a row in pixels.
const ROW: u32 = 20;

/// Writes the results of an outcome: first the form with the values it was computed from, to be edited and built again,
/// with the derived quantities beside them; then each table, the programs, and the checks. The same outcome gives the
/// same bytes. Long tables and programs are streamed and take no memory of their own.
///
/// # Errors
/// For a value that is not finite, for a table larger than a sheet, and for what `out` refuses.
pub fn write<W: Write + Seek + Send>(outcome: &Outcome, language: Language, out: W) -> Result<(), WriteError> {
    let mut results = Results {
        outcome,
        language,
        styles: Styles::default(),
        page: Page {
            part: outcome.part(),
            origin: &outcome.source.workbook,
            repeat: (0, 0),
            landscape: false,
            single: false,
        },
        names: SheetNames::default(),
        workbook: Workbook::new(),
        long: Vec::new(),
    };
    results.write_forms()?;
    results.write_tables()?;
    results.write_programs()?;
    results.write_checks()?;
    save(&mut results.workbook, results.long, out)
}

struct Results<'a> {
    outcome: &'a Outcome,
    language: Language,
    styles: Styles,
    page: Page<'a>,
    names: SheetNames,
    workbook: Workbook,
    long: Vec<LongRows<'a>>,
}

impl<'a> Results<'a> {
    fn write_forms(&mut self) -> Result<(), WriteError> {
        let (outcome, language) = (self.outcome, self.language);
        let source = &outcome.source;
        let origin = Text::new(
            format!(
                "Calculado por rodete {} a partir de {} (SHA-256 {}).",
                source.version, source.workbook, source.sha256
            ),
            format!("Computed by rodete {} from {} (SHA-256 {}).", source.version, source.workbook, source.sha256),
        );
        let again = if within_limits(outcome) {
            t(
                "Este libro es a su vez una entrada válida: cambie los valores y vuelva a calcular.",
                "This workbook is itself a valid input: change the values and build again.",
            )
        } else {
            t(
                "Este libro es demasiado grande para volver a leerlo: cambie los valores en el libro de entrada.",
                "This workbook is too large to be read again: change the values in the input workbook.",
            )
        };
        for (index, sheet) in outcome.fields.form().sheets.iter().enumerate() {
            let name = self.names.take(sheet.name.get(language));
            if index == 0 {
                self.workbook.set_properties(&properties(sheet.title.get(language))?);
            }
            let notes = match (index, sheet.optional) {
                (0, _) => vec![origin.get(language), again.get(language), HOW.get(language)],
                (_, true) => vec![OPTIONAL.get(language), HOW.get(language)],
                (_, false) => vec![HOW.get(language)],
            };
            let values = |key: &str| outcome.fields.values().values.get(key);
            let page = Page { landscape: index == 0, ..self.page };
            let worksheet = self.workbook.add_worksheet();
            let mut layout = Filling { sheet, values, notes: &notes, language }.write(worksheet, &self.styles)?;
            let mut last_column = form_sheet::LAST;
            if index == 0 && !outcome.quantities.is_empty() {
                derived::write(worksheet, &mut layout, &outcome.quantities, language, &self.styles)?;
                last_column = derived::LAST;
            }
            layout.finish(worksheet, last_column, &page, language)?;
            for (defined, cell) in layout.defined_names(&name) {
                self.workbook.define_name(defined, &cell)?;
            }
        }
        let names = &mut self.names;
        let lists = &outcome.fields.values().lists;
        write_lists(&mut self.workbook, outcome.fields.form(), lists, &self.styles, &self.page, language, |name| {
            names.take(name)
        })
    }

    fn write_tables(&mut self) -> Result<(), WriteError> {
        let (outcome, language) = (self.outcome, self.language);
        let placed: Vec<Placed<'_>> = outcome
            .tables
            .iter()
            .map(|table| Placed { sheet: self.names.take(table.name.get(language)), table })
            .collect();
        for Placed { sheet: name, table } in &placed {
            let charts: Vec<&Chart> = outcome.charts.iter().filter(|chart| chart.table == table.key).collect();
            let sheet = TableSheet { table, language };
            if sheet.long() {
                self.long.push(LongRows {
                    sheet: self.workbook.worksheets().len(),
                    name: name.clone(),
                    first: FIRST,
                    count: sheet.last_row()? + 1 - FIRST,
                    source: sheet.rows(),
                });
            }
            let worksheet = self.workbook.add_worksheet().set_name(name)?;
            sheet.write(worksheet, &self.styles)?;
            let below = insert_charts(worksheet, &sheet, &charts, &placed)?;
            sheet.finish(worksheet, &self.page, below)?;
        }
        Ok(())
    }

    /// The programs, where they do not stand on sheets of the form as the user's own.
    fn write_programs(&mut self) -> Result<(), WriteError> {
        let Outcome { fields, programs, .. } = self.outcome;
        let (form, values) = (fields.form(), fields.values());
        let mut sheets = form.lists.iter().filter(|list| list.is_program).peekable();
        let own = sheets.peek().is_some();
        if sheets.any(|list| !values.rows(list.key).is_empty()) {
            return Ok(());
        }
        let programs = programs.iter().map(|proved| &proved.program);
        let Some(programs) = ProgramSheet::new(programs, form.programs, program_sheet::ROWS) else {
            return Ok(());
        };
        let name = if own { program_sheet::OWN.get(self.language) } else { program_sheet::NAME };
        let name = self.names.take(name);
        let index = self.workbook.worksheets().len();
        let worksheet = self.workbook.add_worksheet().set_name(&name)?;
        programs.write(worksheet, self.language, &self.styles, &self.page)?;
        self.long.push(LongRows { sheet: index, name, first: 0, count: programs.rows(), source: programs.source() });
        Ok(())
    }

    fn write_checks(&mut self) -> Result<(), WriteError> {
        let findings = &self.outcome.findings;
        let table = checks::table(findings);
        let name = self.names.take(table.name.get(self.language));
        let worksheet = self.workbook.add_worksheet().set_name(name)?;
        checks_sheet::write(worksheet, &table, findings, self.language, &self.styles, &self.page)
    }
}

/// True where the results are small enough to be read as an input, by a safe estimate of their text.
fn within_limits(outcome: &Outcome) -> bool {
    /// Bytes of a cell with a number, and of a line of a program with its number.
    const CELL: u64 = 50;
    const LINE: u64 = 170;
    let cells = |table: &Table| (table.rows() as u64).saturating_mul(table.columns.len() as u64 + 1);
    let lines = outcome.programs.iter().map(|program| program.blocks()).fold(0_u64, u64::saturating_add);
    let programs = lines.saturating_mul(LINE);
    let tables: Vec<u64> = outcome.tables.iter().map(|table| cells(table).saturating_mul(CELL)).collect();
    let all = tables.iter().fold(programs, |sum, table| sum.saturating_add(*table));
    // Text of numbers is deflated to less than half.
    tables.iter().all(|table| *table < limits::PART)
        && programs < limits::PART
        && all < limits::TOTAL
        && all < 2 * limits::FILE
}

/// Puts charts beside a table, one below the other. Returns the row below them; `None` where there are none.
fn insert_charts(
    worksheet: &mut Worksheet,
    sheet: &TableSheet<'_>,
    charts: &[&Chart],
    placed: &[Placed<'_>],
) -> Result<Option<RowNum>, WriteError> {
    let mut below = None;
    for chart in charts {
        if let Some(drawn) = draw(chart, placed, sheet.language)? {
            let row = below.map_or(FIRST, |row| row + 1);
            worksheet.insert_chart(row, sheet.beside()?, &drawn.chart)?;
            below = Some(row + drawn.height.div_ceil(ROW));
        }
    }
    Ok(below)
}
