//! From the cells of a workbook to the checked values of a form.
//!
//! Values are found by the symbol in column A, wherever its row stands; capitals count (N and n are two parameters). Where the sheet has
//! another name, or columns were moved, the defined names of the values lead to it. The
//! schema cell is read first: a workbook of another version is refused for that alone, unless the form says what an earlier one
//! called its parameters.

use std::collections::BTreeMap;

use crate::escape::excerpt;
use crate::finding::{CellPlace, Exit, Finding, Grade, Place, Raise, Refusal, gravest_first};
use crate::gcode::fields::SCHEMA;
use crate::kind::NamedFile;
use crate::limits::{EXCERPT, LISTED_FORMULAS, LISTED_SYMBOLS};
use crate::number::decimal;
use crate::parameter::{Earlier, FieldKind, Form, Parameter, Sheet, Value, Values};
use crate::text::{Language, Text, t};

use super::address::{self, Position};
use super::book::Book;
use super::gate::{Gated, gate};
use super::guard::CellCopies;
use super::list_rows;
use super::listing::{self, SheetEntry};
use super::passed_over;
use super::rules::form::*;
use super::sheet_cells::{Content, SheetCells};
use super::sheet_names::{find, first_sheet, list_sheets, no_cells, same_but_for_case};
use super::stamp;
use super::survey::COLUMNS;
use super::sweep_sheet;
use super::value::{self, expected, named};
use super::verified::{self, Verified};
use super::words::fold;

/// Values are looked for in the columns before this one.
const MOVED: u32 = 26;

/// A form, read.
#[derive(Debug)]
pub struct Filled {
    /// The form that the workbook follows.
    pub form: &'static Form,
    /// Its values, each within its own limits, and the cells they came from.
    pub values: Values,
    /// Notes and cautions.
    pub findings: Vec<Finding>,
    /// What was changed in a results workbook since its programs were made.
    pub stale: Option<Finding>,
    /// The names by which its formulas do not find the inputs any more.
    pub astray: Option<Finding>,
    /// Sheets of an earlier build were put into it, which is somebody's own.
    pub put_in: bool,
    /// The files that the workbook named when its programs were verified.
    pub named_files: Vec<NamedFile>,
    /// What the cells of the form and of its lists hold as they stand.
    pub copies: CellCopies,
    /// It has been built, so that sheets of another build may stand in it.
    pub stamped: bool,
    /// It has a sheet of variants, or one that may be.
    pub varied: bool,
}

/// Reads a workbook that follows one of `forms`.
///
/// # Errors
/// One [`Refusal`] with everything that was found: [`Exit::Unreadable`] for what is no sound `.xlsx`, [`Exit::Limit`]
/// for what exceeds [`limits`](super::limits), [`Exit::Refused`] for sheets, symbols, units and values that are wrong.
pub fn read(bytes: &[u8], forms: &[&'static Form]) -> Result<Filled, Refusal> {
    let mut book = Book::open(gate(bytes)?)?;
    let notes = std::mem::take(&mut book.gated.notes);
    let first = first(&mut book, forms)?;
    let (language, (form, earlier)) = (first.language, first.version);
    let mut taken = Taken::new(language, notes);
    taken.take_form(&mut book, first)?;
    taken.take_lists(&mut book, form)?;
    let Taken { values, copies, mut findings, exit, read } = taken;
    findings.extend(passed_over::cautions(&mut book, form, language, &read));
    if let Some(earlier) = earlier {
        let keys =
            earlier.renamed.iter().map(|(key, _)| *key).chain(form.schema_parameter().map(Parameter::key)).collect();
        findings.push(values.locate((earlier.told)(Place::Parameters(keys)).with(earlier.schema, form.schema)));
    }
    if findings.iter().any(|finding| finding.grade == Grade::Stop) {
        // A value that cannot be read differs from the one that the programs were made with, too.
        if exit == Exit::Refused
            && let Ok(verified) = verified::read(&mut book, form, &values, &copies)
        {
            findings.extend(verified.stale);
        }
        return Err(refusal(exit, findings));
    }
    let Verified { stale, astray, put_in, named_files } = verified::read(&mut book, form, &values, &copies)?;
    let (stamped, varied) = (stamp::is_named(&book.gated.names), sweep_sheet::may_be(&book.gated.sheets, language));
    Ok(Filled { form, values, findings, stale, astray, put_in, named_files, copies, stamped, varied })
}

/// The language of the form that is read in a workbook; `None` where it follows none of `forms`.
pub(super) fn language(book: &mut Book<'_>, forms: &[&'static Form]) -> Option<Language> {
    first(book, forms).ok().map(|first| first.language)
}

/// What was taken from the sheets of a form and of its lists, one after the other.
struct Taken {
    values: Values,
    copies: CellCopies,
    findings: Vec<Finding>,
    /// What a refusal ends with.
    exit: Exit,
    /// The names of the sheets.
    read: Vec<String>,
}

impl Taken {
    fn new(language: Language, findings: Vec<Finding>) -> Self {
        let values = Values { language, ..Values::default() };
        Self { values, copies: CellCopies::default(), findings, exit: Exit::Refused, read: Vec::new() }
    }

    /// Takes the sheets of the form, of which the first is read.
    fn take_form(&mut self, book: &mut Book<'_>, first: First) -> Result<(), Refusal> {
        let First { entry, language, sheet, version: (form, earlier) } = first;
        let mut first = Some((entry, sheet));
        for described in form.sheets {
            let opened = match first.take() {
                Some(first) => Ok(first),
                None => {
                    let found = find(&book.gated.sheets, &described.name, language, &mut self.findings)?;
                    let led = led(&book.gated, described);
                    let Some(entry) = found.or_else(|| led.as_ref().map(|led| led.entry.clone())) else {
                        if !described.optional {
                            let sheet = described.name.get(language);
                            self.findings.push(SheetMissing { sheet }.at(Place::File));
                        }
                        continue;
                    };
                    further(book, entry, led, described)
                }
            };
            let Some((entry, sheet)) = self.opened(opened) else { continue };
            self.read.push(entry.name.clone());
            if let Some(sheet) = self.readable(&entry, sheet) {
                take((form.schema, earlier), described, &sheet, &mut self.values, &mut self.findings);
                let inputs = described.sections.iter().flat_map(|section| section.parameters);
                self.copies.take(inputs.clone().map(|one| one.key), &self.values, &sheet);
                self.findings.extend(calculated(&sheet, inputs.filter_map(|one| self.values.cells.get(one.key))));
            }
        }
        Ok(())
    }

    /// Takes the sheets of the form's lists.
    fn take_lists(&mut self, book: &mut Book<'_>, form: &'static Form) -> Result<(), Refusal> {
        for list in form.lists {
            for entry in list_sheets(list, &book.gated.sheets, self.values.language, &mut self.findings)? {
                self.read.push(entry.name.clone());
                let opened = book.read(&entry, list_rows::COLUMNS);
                if let Some(sheet) = self.opened(opened).and_then(|sheet| self.readable(&entry, sheet)) {
                    let rows = list_rows::read(list, &sheet, &mut self.findings);
                    self.copies.columns.extend(list_rows::written(list, &sheet));
                    let inputs = rows.iter().flat_map(|rows| &rows.rows).flat_map(|row| row.cells.values());
                    self.findings.extend(calculated(&sheet, inputs));
                    self.values.lists.extend(rows);
                }
            }
        }
        Ok(())
    }

    /// A sheet that could be opened. Why another could not is told together with what was found on the sheets before it.
    fn opened<Sheet>(&mut self, opened: Result<Sheet, Refusal>) -> Option<Sheet> {
        let told = |mut refusal: Refusal| {
            self.exit = refusal.exit;
            self.findings.append(&mut refusal.findings);
        };
        opened.map_err(told).ok()
    }

    /// A sheet whose cells can be read; keeps what there is to tell of it, in either case.
    fn readable(&mut self, entry: &SheetEntry, mut sheet: SheetCells) -> Option<SheetCells> {
        self.findings.extend(hidden(entry));
        self.findings.append(&mut sheet.survey.findings);
        if self.exit == Exit::Refused {
            self.exit = sheet.survey.exit();
        }
        (!sheet.survey.unsound).then_some(sheet)
    }
}

/// The sheet that a form begins with, read.
struct First {
    entry: SheetEntry,
    language: Language,
    sheet: SheetCells,
    version: Version,
}

/// Where a defined name leads.
#[derive(Clone)]
struct Led {
    entry: SheetEntry,
    at: Position,
    symbol: &'static str,
}

/// Where the defined names of a sheet's parameters lead, by the first of them that leads to a sheet of cells: this finds a form
/// whose sheet has another name, or whose columns were moved.
fn led(gated: &Gated<'_>, described: &'static Sheet) -> Option<Led> {
    let parameters = described.sections.iter().flat_map(|section| section.parameters);
    parameters.filter_map(|one| leads(gated, one)).next()
}

/// Where the defined name of a parameter leads.
fn leads(gated: &Gated<'_>, parameter: &'static Parameter) -> Option<Led> {
    let (sheet, cell) = address::cell(gated.names.get(&parameter.name.to_lowercase())?)?;
    let entry = gated.sheets.iter().find(|entry| entry.name.to_lowercase() == sheet.to_lowercase())?;
    let at = address::parse(&cell).filter(|at| at.1 < MOVED)?;
    (entry.kind == listing::SheetKind::Cells).then(|| Led { entry: entry.clone(), at, symbol: parameter.symbol() })
}

/// A sheet of a form with its columns where a name leads.
fn read_led(book: &mut Book<'_>, led: &Led) -> Result<Option<SheetCells>, Refusal> {
    let mut sheet = book.read(&led.entry, COLUMNS.max(led.at.1 + 1 + COLUMNS))?;
    let Some(columns) = sheet.columns_about(led.at, led.symbol) else { return Ok(None) };
    sheet.columns = columns;
    Ok(Some(sheet))
}

/// A further sheet of a form: the one of its name, or where that has none of its symbols, the one that the names lead to.
fn further(
    book: &mut Book<'_>,
    entry: SheetEntry,
    led: Option<Led>,
    described: &'static Sheet,
) -> Result<(SheetEntry, SheetCells), Refusal> {
    let sheet = book.read(&entry, COLUMNS)?;
    let symbols = rows_by_symbol(&sheet);
    let parameters = || described.sections.iter().flat_map(|section| section.parameters);
    let known = parameters().any(|one| symbols.contains_key(one.symbol()));
    if let Some(led) = led.filter(|_| !known)
        && let Some(sheet) = read_led(book, &led)?
    {
        return Ok((led.entry, sheet));
    }
    Ok((entry, sheet))
}

/// The sheet that a form begins with: the one of its name; where that is no form, the one that the name of the schema cell leads
/// to.
fn first(book: &mut Book<'_>, forms: &[&'static Form]) -> Result<First, Refusal> {
    let refused = match first_named(book, forms) {
        Ok(first) => return Ok(first),
        Err(refused) => refused,
    };
    let schema = forms.iter().flat_map(|form| form.parameters()).map(|(_, one)| one);
    let led = schema.filter(|one| matches!(one.kind, FieldKind::Schema)).find_map(|one| leads(&book.gated, one));
    let Some(led) = led else { return Err(refused) };
    if refused.findings.iter().any(|one| one.is(SheetAmbiguous::RULE)) && several_forms(book, forms) {
        return Err(refused);
    }
    let Some(sheet) = read_led(book, &led)? else { return Err(refused) };
    let is = |name: &Text, language| *name.get(language) == *led.entry.name;
    let names = || forms.iter().filter_map(|form| form.sheets.first()).map(|sheet| &sheet.name);
    let named = Language::ALL.into_iter().find(|language| names().any(|name| is(name, *language)));
    let spoken = || if sheet.says("Significado") { Language::Es } else { Language::En };
    let language = named.unwrap_or_else(spoken);
    let version = form_of(&sheet, forms, None)?;
    sound(&sheet, &led.entry)?;
    Ok(First { entry: led.entry, language, sheet, version })
}

/// True where more than one sheet with the name of a form's first one is such a form: the names lead to one of them, and a person may have
/// filled in the other. A sheet of somebody else's that has the name alone is none.
fn several_forms(book: &mut Book<'_>, forms: &[&'static Form]) -> bool {
    let sheets = book.gated.sheets.clone();
    let names = || forms.iter().filter_map(|form| form.sheets.first()).flat_map(|one| [&one.name.es, &one.name.en]);
    let named = sheets.iter().filter(|entry| names().any(|name| same_but_for_case(name, &entry.name)));
    named.filter(|entry| is_form(book, entry)).count() > 1
}

/// True for a sheet that has a schema's row.
fn is_form(book: &mut Book<'_>, entry: &SheetEntry) -> bool {
    let sheet = book.read(entry, COLUMNS);
    sheet.is_ok_and(|sheet| rows_by_symbol(&sheet).contains_key(SCHEMA.key().symbol()))
}

/// The sheet that a form begins with, by its name.
fn first_named(book: &mut Book<'_>, forms: &[&'static Form]) -> Result<First, Refusal> {
    let sheets = book.gated.sheets.clone();
    // In a workbook of somebody else's, one of their sheets may have a name that is alike.
    let (entry, language) = first_sheet(&sheets, forms, |entry| is_form(book, entry))?;
    let sheet = book.read(&entry, COLUMNS)?;
    sound(&sheet, &entry)?;
    let version = form_of(&sheet, forms, Some(language))?;
    Ok(First { entry, language, sheet, version })
}

/// Refuses a sheet that cannot be read, and one without cells.
fn sound(sheet: &SheetCells, entry: &SheetEntry) -> Result<(), Refusal> {
    if sheet.survey.unsound {
        return Err(refusal(sheet.survey.exit(), sheet.survey.findings.clone()));
    }
    if sheet.survey.filled { Ok(()) } else { Err(no_cells(entry)) }
}

/// One refusal for everything that was found, gravest first.
pub(super) fn refusal(exit: Exit, mut findings: Vec<Finding>) -> Refusal {
    gravest_first(&mut findings);
    Refusal { exit, findings }
}

/// A note on a sheet that is read although it is not shown.
pub(super) fn hidden(entry: &SheetEntry) -> Option<Finding> {
    let sheet = excerpt(&entry.name, EXCERPT);
    entry.hidden.then(|| SheetHidden { sheet }.at(Place::Sheet(entry.name.clone())))
}

/// A note on inputs that are results of formulas: what is read is what the spreadsheet stored with them.
pub(super) fn calculated<'a>(sheet: &SheetCells, inputs: impl Iterator<Item = &'a CellPlace>) -> Option<Finding> {
    let mut cells: Vec<CellPlace> = inputs
        .filter(|place| address::parse(&place.cell).is_some_and(|at| sheet.survey.formulas.contains(&at)))
        .cloned()
        .collect();
    let (count, most) = (cells.len(), LISTED_FORMULAS);
    cells.truncate(most);
    let first = if count > most {
        Text::new(format!(" (las primeras {most})"), format!(" (the first {most})"))
    } else {
        t("", "")
    };
    (count > 0).then(|| FormulasRead { count, first }.at(Place::Cells(cells)))
}

/// A form, and its earlier version where the workbook follows that.
type Version = (&'static Form, Option<&'static Earlier>);

/// The form whose schema stands in the sheet's schema cell.
/// `language`: the one in which the sheet has the form's name; `None` where it has another name.
fn form_of(sheet: &SheetCells, forms: &[&'static Form], language: Option<Language>) -> Result<Version, Refusal> {
    let symbols = rows_by_symbol(sheet);
    let mut wanted: Vec<(&'static Form, &'static Parameter)> = Vec::new();
    for form in forms.iter().copied().filter(|form| {
        let is = |language| form.sheets.first().is_some_and(|one| *one.name.get(language) == *sheet.name);
        language.is_none_or(is)
    }) {
        wanted.extend(form.schema_parameter().map(|one| (form, one)));
    }
    let known = wanted.iter().map(|(form, _)| format!("\"{}\"", form.schema)).collect::<Vec<_>>().join(", ");
    let symbol = wanted.first().map_or(SCHEMA.key(), |(_, parameter)| parameter.key());
    let rows = symbols.get(symbol.symbol()).map_or(&[][..], Vec::as_slice);
    let [row] = rows else {
        return Err(if rows.is_empty() {
            SchemaRowMissing { symbol, known }.refused(Exit::Refused, Place::Sheet(sheet.name.clone()))
        } else {
            let cells = rows.iter().map(|row| sheet.place((*row, sheet.columns.symbol))).collect();
            SchemaRowTwice { symbol }.refused(Exit::Refused, Place::Cells(cells))
        });
    };
    let at = (*row, sheet.columns.value);
    let found = match sheet.cell(at).map(|cell| &cell.content) {
        Some(Content::Text(text, _)) => excerpt(text.trim(), EXCERPT),
        Some(Content::Number(number)) => decimal(*number),
        Some(Content::Error(error)) => excerpt(error, EXCERPT),
        Some(Content::Truth(_) | Content::Date(..)) | None => String::new(),
    };
    for (form, _) in &wanted {
        if form.schema == found {
            return Ok((form, None));
        }
        if let Some(earlier) = form.earlier.iter().find(|earlier| earlier.schema == found) {
            return Ok((form, Some(earlier)));
        }
    }
    let (place, limit) = (Place::Cells(vec![sheet.place(at)]), known.clone());
    let finding = if found.is_empty() {
        SchemaEmpty { symbol, known }.at(place)
    } else {
        OtherSchema { symbol, found: found.clone(), known }.at(place)
    };
    Err(Refusal::new(Exit::Refused, finding.with(found, limit)))
}

/// The rows of every symbol in column A.
pub(super) fn rows_by_symbol(sheet: &SheetCells) -> BTreeMap<&str, Vec<u32>> {
    let mut rows: BTreeMap<&str, Vec<u32>> = BTreeMap::new();
    for &row in sheet.rows.keys() {
        if let Some(symbol) = sheet.text((row, sheet.columns.symbol)) {
            rows.entry(symbol).or_default().push(row);
        }
    }
    rows
}

/// Takes the values of one sheet; the schema cell is known to say `schema`, or the version before it.
pub(super) fn take(
    (schema, earlier): (&'static str, Option<&'static Earlier>),
    described: &'static Sheet,
    sheet: &SheetCells,
    values: &mut Values,
    findings: &mut Vec<Finding>,
) {
    let rows = rows_by_symbol(sheet);
    let parameters: Vec<&'static Parameter> =
        described.sections.iter().flat_map(|section| section.parameters).copied().collect();
    // Under an earlier schema the symbol of then is read, and the one of now beside it: two of them are one too many.
    let then = |parameter: &Parameter| earlier.and_then(|earlier| earlier.symbol(parameter.key));
    let found = |parameter: &Parameter| -> Vec<u32> {
        let symbols = then(parameter).into_iter().chain([parameter.symbol()]);
        symbols.filter_map(|symbol| rows.get(symbol)).flatten().copied().collect()
    };
    let known: Vec<&str> = parameters.iter().flat_map(|one| then(one).into_iter().chain([one.symbol()])).collect();
    unknown(sheet, &known, findings);
    for parameter in &parameters {
        if let Some(row) = found(parameter).first() {
            values.cells.insert(parameter.key(), sheet.place((*row, sheet.columns.value)));
        }
    }
    let empty = parameters.iter().all(|one| found(one).iter().all(|row| !value::is_filled(sheet, *row)));
    if described.optional && empty {
        return;
    }
    for parameter in parameters {
        match found(parameter).as_slice() {
            [] if parameter.required => {
                findings.push(missing_row(parameter, mistyped(parameter, &rows, &known), sheet))
            }
            [] => {}
            [_] if matches!(parameter.kind, FieldKind::Schema) => {
                values.values.insert(parameter.key, Value::Line(schema.to_owned()));
            }
            [row] => {
                if let Some(value) = value::read(parameter, sheet, *row, findings) {
                    values.values.insert(parameter.key, value);
                }
            }
            rows => {
                let cells = rows.iter().take(10).map(|row| sheet.place((*row, sheet.columns.symbol))).collect();
                let row = SymbolTwice { symbol: parameter.key(), count: rows.len() };
                findings.push(row.at(Place::Cells(cells)));
            }
        }
    }
}

/// A row whose unknown symbol is that of a parameter but for a letter.
fn mistyped<'a>(parameter: &Parameter, rows: &BTreeMap<&'a str, Vec<u32>>, known: &[&str]) -> Option<(u32, &'a str)> {
    let near = |found: &str| {
        let (wanted, found) = (fold(parameter.symbol()), fold(found));
        let letters = strsim::damerau_levenshtein(&wanted, &found);
        letters <= 1 && letters < wanted.chars().count().max(found.chars().count())
    };
    let unknown = rows.iter().filter(|(symbol, _)| !known.contains(*symbol) && near(symbol));
    unknown.filter_map(|(symbol, rows)| Some((*rows.first()?, *symbol))).next()
}

fn missing_row(parameter: &'static Parameter, mistyped: Option<(u32, &str)>, sheet: &SheetCells) -> Finding {
    let (name, expected, symbol) = (named(parameter), expected(parameter), parameter.key());
    let Some((row, found)) = mistyped else {
        return RowMissing { name, symbol, expected }.at(Place::Sheet(sheet.name.clone()));
    };
    let at = (row, sheet.columns.symbol);
    let (cell, found) = (address::format(at), excerpt(found, EXCERPT));
    SymbolMistyped { name, cell, found, symbol, expected }.at(Place::Cells(vec![sheet.place(at)]))
}

/// Mentions rows that have a value and a symbol that the form does not know. Headings are not among them: what stands
/// above the first symbol, and rows whose value cell is empty or says "value" itself.
fn unknown(sheet: &SheetCells, symbols: &[&str], findings: &mut Vec<Finding>) {
    let known = |row: u32| sheet.text((row, sheet.columns.symbol)).is_some_and(|symbol| symbols.contains(&symbol));
    let rows = sheet.rows.keys().copied().skip_while(|row| !known(*row)).filter(|row| {
        let heading = sheet.text((*row, sheet.columns.value)).is_some_and(|text| ["Value", "Valor"].contains(&text));
        !known(*row) && !heading && sheet.cell((*row, 0)).is_some() && value::is_filled(sheet, *row)
    });
    let rows: Vec<u32> = rows.collect();
    for row in rows.iter().take(LISTED_SYMBOLS) {
        let symbol =
            sheet.text((*row, sheet.columns.symbol)).map_or_else(|| "?".to_owned(), |symbol| excerpt(symbol, EXCERPT));
        findings.push(SymbolUnknown { symbol }.at(Place::Cells(vec![sheet.place((*row, sheet.columns.symbol))])));
    }
    if let Some(count) = rows.len().checked_sub(LISTED_SYMBOLS).filter(|more| *more > 0) {
        findings.push(MoreSymbolsUnknown { count }.at(Place::Sheet(sheet.name.clone())));
    }
}
