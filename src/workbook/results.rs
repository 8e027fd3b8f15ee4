//! The results workbook: what came out, the form again, charts, every table, the programs, and the checks.

use std::io::{Seek, Write};

use rust_xlsxwriter::{Workbook, quote_sheet_name};

use super::charts::draw;
use super::curves::Curves;
use super::drawn::Drawn;
use super::error::WriteError;
use super::form_sheet::Filling;
use super::guard::{self, Copy, Guard};
use super::limits;
use super::live::{self, LiveTables, Liveness};
use super::long_rows::LongRows;
use super::names::{Made, Present, Role, SheetNames, slug};
use super::page::{Further, Page, SheetStyle, properties};
use super::placed::{FIRST, PlacedTable};
use super::program_sheet::{self, ProgramSheet};
use super::save::{Additions, save};
use super::stamp;
use super::style::Styles;
use super::summary_sheet::{self, Summary};
use super::table_sheet::TableSheet;
use super::template::{HOW, OPTIONAL, write_lists};
use super::{chart_sheet, checks_sheet, curves};
use crate::figure::Figure;
use crate::kind::{Outcome, checks};
use crate::parameter::Sheet;
use crate::parameter::list::Naming;
use crate::table::Table;
use crate::text::{Language, Text, t};

pub use super::live::Tables;
pub use super::summary_sheet::File;

/// Writes the results of an outcome: first what came out, with the files that are delivered beside it; then the form with the
/// values it was computed from, to be edited and built again; then charts, each table, the programs, and the checks. The same
/// outcome gives the same bytes. Long tables and programs are streamed and take no memory of their own.
///
/// # Errors
/// For a value that is not finite, for a table larger than a sheet, and for what `out` refuses.
pub fn write<W: Write + Seek + Send>(
    outcome: &Outcome,
    files: &[File],
    tables: Tables,
    language: Language,
    out: W,
) -> Result<(), WriteError> {
    write_for(outcome, files, tables, language, None, out).map(|_| ())
}

/// The same for sheets that are put into the workbook of the form: the form and its lists are written, too, under the names that
/// they have there. Gives the sheets that were written.
///
/// # Errors
/// As [`write()`].
pub fn write_into<W: Write + Seek + Send>(
    outcome: &Outcome,
    files: &[File],
    tables: Tables,
    language: Language,
    present: &Present,
    out: W,
) -> Result<Vec<Made>, WriteError> {
    write_for(outcome, files, tables, language, Some(present), out)
}

fn write_for<W: Write + Seek + Send>(
    outcome: &Outcome,
    files: &[File],
    tables: Tables,
    language: Language,
    present: Option<&Present>,
    out: W,
) -> Result<Vec<Made>, WriteError> {
    let sketch = outcome.kind.sketch();
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
        names: present.map_or_else(SheetNames::default, SheetNames::beside),
        present,
        sheets: Vec::new(),
        made: Vec::new(),
        workbook: Workbook::new(),
        additions: Additions::default(),
        guard: Guard::new(stamp::of(outcome)),
    };
    let guarded = results.take(guard::KEY, &guard::NAME);
    // It stands first and is filled last, when the others are known.
    let first = results.take("summary", &summary_sheet::NAME);
    results.workbook.add_worksheet().set_name(&first)?;
    results.write_forms(sketch.as_ref())?;
    let liveness = Liveness::of(outcome.tables.iter(), tables);
    let placed = results.places(liveness);
    let live = LiveTables::new(&placed, liveness);
    results.write_tables(&placed, live)?;
    results.write_programs(files)?;
    let checks = &results.write_checks(live.on())?;
    let again = match present {
        Some(_) => &AGAIN_INTO,
        None if within_limits(outcome) => &AGAIN,
        None => &TOO_LARGE,
    };
    let beside = present.map(|present| present.folder.as_str());
    let (sheets, guard) = (&results.sheets, &results.guard);
    let summary = Summary { outcome, files, beside, sheets, checks, again, live, guard, language };
    let names = summary.write(results.workbook.worksheet_from_index(0)?, &results.styles, &results.page)?;
    let first = quote_sheet_name(&first);
    for (name, row) in names {
        results.workbook.define_name(name, &format!("={first}!$C${}", row + 1))?;
    }
    results.guard.keep(&outcome.named_files);
    let made: Vec<String> = files.iter().map(|(name, _)| name.clone()).collect();
    results.guard.write(&mut results.workbook, &guarded, &made, &results.styles)?;
    save(&mut results.workbook, results.additions, out)?;
    Ok(results.made)
}

static AGAIN: Text = t(
    "Este libro es a su vez una entrada válida: cambie los valores en la hoja siguiente y vuelva a generar.",
    "This workbook is itself a valid input: change the values on the next sheet and build again.",
);
static AGAIN_INTO: Text = t(
    "Este libro lleva sus entradas: cambie los valores en la hoja del formulario y vuelva a generar con --into.",
    "This workbook holds its inputs: change the values on the form's sheet and build again with --into.",
);
static TOO_LARGE: Text = t(
    "Este libro es demasiado grande para volver a leerlo: cambie los valores en el libro de entrada.",
    "This workbook is too large to be read again: change the values in the input workbook.",
);

struct Results<'a> {
    outcome: &'a Outcome,
    language: Language,
    styles: Styles,
    page: Page<'a>,
    names: SheetNames,
    /// The workbook that the sheets are put into.
    present: Option<&'a Present>,
    /// The names of the sheets behind the first, with what they hold.
    sheets: Vec<(String, String)>,
    /// Every sheet.
    made: Vec<Made>,
    workbook: Workbook,
    additions: Additions<'a>,
    guard: Guard,
}

impl<'a> Results<'a> {
    /// The name of a sheet of results: the one that it has already, else a free one.
    fn take(&mut self, key: &str, wanted: &Text) -> String {
        let there = self.present.and_then(|present| present.ours.get(&slug(key)));
        let name = there.cloned().unwrap_or_else(|| self.names.take(wanted.get(self.language)));
        self.made.push(Made { name: name.clone(), role: Role::Result(key.to_owned()) });
        name
    }

    /// The same, noted with what the sheet holds.
    fn name(&mut self, key: &str, wanted: &Text, holds: &Text) -> String {
        let name = self.take(key, wanted);
        self.sheets.push((name.clone(), holds.get(self.language).to_owned()));
        name
    }

    /// The name of a form's sheet, which is noted where there is one.
    fn form_name(&mut self, index: usize, sheet: &Sheet) -> String {
        let there = self.present.map(|present| present.forms.get(&index));
        let name = there.flatten().cloned().unwrap_or_else(|| self.names.take(sheet.name.get(self.language)));
        if there.is_none_or(|there| there.is_some()) {
            self.sheets.push((name.clone(), sheet.title.get(self.language).to_owned()));
        }
        self.made.push(Made { name: name.clone(), role: Role::Form });
        name
    }

    fn write_forms(&mut self, sketch: Option<&'a Figure>) -> Result<(), WriteError> {
        let (outcome, language) = (self.outcome, self.language);
        self.additions.drawn = sketch.map(|figure| Drawn { figure, language });
        for (index, sheet) in outcome.fields.form().sheets.iter().enumerate() {
            let name = self.form_name(index, sheet);
            if index == 0 {
                self.workbook.set_properties(&properties(sheet.title.get(language))?);
            }
            let notes = [if sheet.optional { OPTIONAL.get(language) } else { "" }, HOW.get(language)];
            let values = |key: &str| outcome.fields.values().values.get(key);
            let sketch = self.additions.drawn.filter(|_| index == 0);
            let worksheet = self.workbook.add_worksheet();
            let layout =
                Filling { sheet, values, notes: &notes, guard: Some(&self.guard), live: None, sketch, language }
                    .write(worksheet, &self.styles)?;
            worksheet.set_name(&name)?;
            layout.finish(worksheet, &self.page, language)?;
            for (defined, cell) in layout.defined_names(&name) {
                self.workbook.define_name(defined, &cell)?;
            }
            for parameter in sheet.sections.iter().flat_map(|section| section.parameters) {
                match self.present {
                    None => {
                        let at = layout.beside(parameter.name, &name);
                        self.guard.watch(parameter.name, at, Copy::of(parameter, values(parameter.key), language));
                    }
                    // One whose row the form does not have has no cell to be watched.
                    Some(present) => {
                        let copy = present.copies.inputs.get(parameter.key);
                        copy.into_iter().for_each(|copy| self.guard.watch(parameter.name, None, copy.clone()));
                    }
                }
            }
        }
        let Self { names, sheets, made, present, guard, .. } = self;
        let lists = &outcome.fields.values().lists;
        let form = outcome.fields.form();
        let look = SheetStyle { styles: &self.styles, page: &self.page, language };
        // The lists of a workbook of one's own stand where their owner put them, and as they were written.
        let guard = match present {
            None => Some(guard),
            Some(present) => {
                present.copies.columns.iter().for_each(|column| guard.watch_column(column.clone()));
                None
            }
        };
        write_lists(&mut self.workbook, form, lists, &look, guard, |wanted, list| {
            let one = matches!(list.naming, Naming::One(_));
            let there =
                present.map(|_| lists.iter().find(|rows| rows.list == list.key && (one || rows.sheet == wanted)));
            let name = there.flatten().map_or_else(|| names.take(wanted), |rows| rows.sheet.clone());
            if there.is_none_or(|there| there.is_some()) {
                sheets.push((name.clone(), list.title.get(language).to_owned()));
            }
            made.push(Made { name: name.clone(), role: Role::Form });
            name
        })
    }

    /// The sheets of the tables that have one: that of the charts stands before them.
    fn places(&mut self, liveness: Liveness) -> Vec<PlacedTable<'a>> {
        static CHARTS: Text = t("Gráficos de las tablas", "Charts of the tables");
        let outcome = self.outcome;
        if !outcome.charts.is_empty() {
            self.name("charts", &chart_sheet::NAME, &CHARTS);
        }
        outcome
            .tables
            .iter()
            .filter(|table| liveness.has(table))
            .map(|table| PlacedTable { sheet: self.name(table.key, &table.name, &table.title), table })
            .collect()
    }

    /// The charts, then the tables.
    fn write_tables(&mut self, placed: &[PlacedTable<'a>], live: LiveTables<'_>) -> Result<(), WriteError> {
        let (outcome, language) = (self.outcome, self.language);
        let before = self.sheets.len() - placed.len();
        let follows = live.on() && placed.iter().any(|one| live::last(one.table.index).is_some());
        let picked = follows && !outcome.charts.is_empty();
        let mut curves = Curves::new(live, if picked { self.take("curves", &curves::SHEET) } else { String::new() });
        if !outcome.charts.is_empty() {
            let mut drawn = Vec::new();
            for chart in &outcome.charts {
                let of = placed.iter().find(|one| one.table.key == chart.table).map(|one| one.sheet.clone());
                if let Some((chart, size)) = draw(chart, placed, &mut curves, language)? {
                    drawn.push((of.unwrap_or_default(), chart));
                    self.additions.charts.push(size);
                }
            }
            let (name, _) = &self.sheets[before - 1];
            let worksheet = self.workbook.add_worksheet().set_name(name)?;
            chart_sheet::write(worksheet, &drawn, language, &self.styles, &self.page, &self.guard)?;
        }
        for PlacedTable { sheet: name, table } in placed {
            let sheet = TableSheet { table, language };
            let at = self.workbook.worksheets().len();
            if sheet.long() {
                self.additions.long.push(LongRows {
                    sheet: at,
                    name: name.clone(),
                    first: FIRST,
                    count: sheet.last_row()? + 1 - FIRST,
                    source: sheet.rows(),
                });
            }
            let worksheet = self.workbook.add_worksheet().set_name(name)?;
            sheet.write(worksheet, &self.styles, &live, &self.guard)?;
            self.additions.printed.extend(sheet.finish(worksheet, at, &self.page, &live)?);
        }
        if picked { curves.write(&mut self.workbook) } else { Ok(()) }
    }

    /// The programs, where they do not stand on sheets of the form as the user's own.
    fn write_programs(&mut self, files: &[File]) -> Result<(), WriteError> {
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
        static BLOCKS: Text = t("Los programas, bloque a bloque", "The programs, block by block");
        let name = self.name("programs", if own { &program_sheet::OWN } else { &program_sheet::NAME }, &BLOCKS);
        let index = self.workbook.worksheets().len();
        let programs = programs.with_files(files, self.language);
        let worksheet = self.workbook.add_worksheet().set_name(&name)?;
        programs.write(worksheet, self.language, &self.styles, &self.page, &self.guard)?;
        self.additions.printed.extend(Further::set(worksheet, index, &programs.printed())?);
        let (count, source) = (programs.rows(), programs.source());
        self.additions.long.push(LongRows { sheet: index, name, first: 0, count, source });
        Ok(())
    }

    /// The sheet of what was found; gives its name.
    fn write_checks(&mut self, live: bool) -> Result<String, WriteError> {
        let findings = &self.outcome.findings;
        let table = checks::table(findings);
        static FOUND: Text = t(
            "Todo lo que se encontró: paradas, precauciones, notas y comprobaciones, con su lugar y su remedio",
            "All that was found: stops, cautions, notes and checks, with places and remedies",
        );
        let name = self.name(table.key, &table.name, &FOUND);
        let worksheet = self.workbook.add_worksheet().set_name(&name)?;
        let look = SheetStyle { styles: &self.styles, page: &self.page, language: self.language };
        checks_sheet::write(worksheet, &table, findings, &look, &self.guard, live)?;
        Ok(name)
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
