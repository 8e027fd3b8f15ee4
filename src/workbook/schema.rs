//! From the cells of a workbook to the checked values of a form.
//!
//! Values are found by the symbol in column A, wherever its row stands; capitals count (N and n are two parameters). Where the sheet has
//! another name, or columns were moved, the defined names of the values lead to it. The
//! schema cell is read first: a workbook of another version is refused for that alone, unless the form says what an earlier one
//! called its parameters.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::escape::excerpt;
use crate::finding::{CellPlace, Exit, Finding, Grade, Place, Raise, Refusal};
use crate::gcode::fields::SCHEMA;
use crate::kind::NamedFile;
use crate::limits::{LISTED_FORMULAS, LISTED_SYMBOLS};
use crate::number::decimal;
use crate::parameter::list::{List, Naming};
use crate::parameter::{Earlier, FieldKind, Form, Parameter, Sheet, Value, Values};
use crate::text::{Language, Text, t};

use super::address::{self, Position};
use super::book::Book;
use super::gate::{Gated, gate};
use super::guard::Written;
use super::list_rows;
use super::listing::{self, SheetEntry};
use super::passed_over;
use super::rules::form::*;
use super::sheet_cells::{Content, SheetCells};
use super::stamp;
use super::survey::COLUMNS;
use super::sweep_sheet;
use super::value::{self, expected, named};
use super::verified::{self, Verified};
use super::words;

/// Values are looked for in the columns before this one.
const MOVED: u32 = 26;
/// Characters of a name or a symbol shown in a message.
const SHOWN: usize = 40;

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
    pub files: Vec<NamedFile>,
    /// What the cells of the form and of its lists hold as they stand.
    pub written: Written,
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
    let mut findings = std::mem::take(&mut book.gated.notes);
    let First { entry, language, sheet, version: (form, earlier) } = first(&mut book, forms)?;
    let mut values = Values { language, ..Values::default() };
    let mut written = Written::default();
    let mut exit = Exit::Refused;
    let mut first = Some(sheet);
    let mut read = Vec::new();
    for (index, described) in form.sheets.iter().enumerate() {
        let found = if index == 0 {
            Some(entry.clone())
        } else {
            find(&book.gated.sheets, &described.name, language, &mut findings)?
        };
        let led = if index == 0 { None } else { led(&book.gated, described) };
        let Some(entry) = found.or_else(|| led.as_ref().map(|led| led.entry.clone())) else {
            if !described.optional {
                let sheet = described.name.get(language);
                findings.push(SheetMissing { sheet }.at(Place::File));
            }
            continue;
        };
        let (entry, mut sheet) = match first.take() {
            Some(sheet) => (entry, sheet),
            None => match further(&mut book, entry, led, described) {
                Ok(sheet) => sheet,
                // Told together with what was found on the sheets before it.
                Err(mut refusal) => {
                    exit = refusal.exit;
                    findings.append(&mut refusal.findings);
                    continue;
                }
            },
        };
        read.push(entry.name.clone());
        findings.extend(hidden(&entry));
        findings.append(&mut sheet.survey.findings);
        if exit == Exit::Refused {
            exit = sheet.survey.exit();
        }
        if !sheet.survey.unsound {
            take((form.schema, earlier), described, &sheet, &mut values, &mut findings);
            let inputs = described.sections.iter().flat_map(|section| section.parameters);
            written.take(inputs.clone().map(|one| one.key), &values, &sheet);
            findings.extend(calculated(&sheet, inputs.filter_map(|one| values.cells.get(one.key))));
        }
    }
    for list in form.lists {
        for entry in list_sheets(list, &book.gated.sheets, language, &mut findings)? {
            read.push(entry.name.clone());
            match book.read(&entry, list_rows::COLUMNS) {
                Ok(mut sheet) => {
                    findings.extend(hidden(&entry));
                    findings.append(&mut sheet.survey.findings);
                    if exit == Exit::Refused {
                        exit = sheet.survey.exit();
                    }
                    if !sheet.survey.unsound {
                        let rows = list_rows::read(list, &sheet, &mut findings);
                        written.columns.extend(list_rows::written(list, &sheet));
                        let inputs = rows.iter().flat_map(|rows| &rows.rows).flat_map(|row| row.cells.values());
                        findings.extend(calculated(&sheet, inputs));
                        values.lists.extend(rows);
                    }
                }
                Err(mut refusal) => {
                    exit = refusal.exit;
                    findings.append(&mut refusal.findings);
                }
            }
        }
    }
    findings.extend(passed_over::cautions(&mut book, form, language, &read));
    if let Some(earlier) = earlier {
        let keys =
            earlier.renamed.iter().map(|(key, _)| *key).chain(form.schema_parameter().map(Parameter::key)).collect();
        findings.push(values.locate((earlier.told)(Place::Parameters(keys)).with(earlier.schema, form.schema)));
    }
    if findings.iter().any(|finding| finding.grade == Grade::Stop) {
        // A value that cannot be read differs from the one that the programs were made with, too.
        if exit == Exit::Refused
            && let Ok(verified) = verified::read(&mut book, form, &values, &written)
        {
            findings.extend(verified.stale);
        }
        return Err(refusal(exit, findings));
    }
    let Verified { stale, astray, put_in, files } = verified::read(&mut book, form, &values, &written)?;
    let (stamped, varied) = (stamp::is_named(&book.gated.names), sweep_sheet::may_be(&book.gated.sheets, language));
    Ok(Filled { form, values, findings, stale, astray, put_in, files, written, stamped, varied })
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

/// The sheet that a form begins with, by its name.
fn first_named(book: &mut Book<'_>, forms: &[&'static Form]) -> Result<First, Refusal> {
    let sheets = book.gated.sheets.clone();
    // In a workbook of somebody else's, one of their sheets may have a name that is alike.
    let mut is_form = |entry: &SheetEntry| {
        let sheet = book.read(entry, COLUMNS);
        sheet.is_ok_and(|sheet| rows_by_symbol(&sheet).contains_key(SCHEMA.key().symbol()))
    };
    let (entry, language) = first_sheet(&sheets, forms, &mut is_form)?;
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
    findings.sort_by_key(|finding| Reverse(finding.grade));
    Refusal { exit, findings }
}

pub(super) fn no_cells(entry: &SheetEntry) -> Refusal {
    let sheet = excerpt(&entry.name, SHOWN);
    SheetWithoutCells { sheet }.refused(Exit::Refused, Place::Sheet(entry.name.clone()))
}

/// A note on a sheet that is read although it is not shown.
pub(super) fn hidden(entry: &SheetEntry) -> Option<Finding> {
    let sheet = excerpt(&entry.name, SHOWN);
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

/// The sheet that a form begins with, and its language.
fn first_sheet(
    sheets: &[SheetEntry],
    forms: &[&'static Form],
    is_form: impl FnMut(&SheetEntry) -> bool,
) -> Result<(SheetEntry, Language), Refusal> {
    let mut names: Vec<(&str, Language)> = Vec::new();
    for sheet in forms.iter().filter_map(|form| form.sheets.first()) {
        for language in Language::ALL {
            let name = sheet.name.get(language);
            if names.iter().all(|known| known.0 != name) {
                names.push((name, language));
            }
        }
    }
    sheet_named(sheets, &names, is_form, |wanted, there| SheetNotFound { wanted, there }.at(Place::File))
}

/// The one sheet that bears one of the names, and the language of that name; `is_it` judges one whose name is alike; `otherwise` tells
/// that there is no such sheet and none alike, from the names and from those that are there.
///
/// # Errors
/// [`Exit::Refused`] where there is none, or more than one that a person would take for it.
pub(super) fn sheet_named(
    sheets: &[SheetEntry],
    names: &[(&str, Language)],
    mut is_it: impl FnMut(&SheetEntry) -> bool,
    otherwise: impl FnOnce(Text, String) -> Finding,
) -> Result<(SheetEntry, Language), Refusal> {
    let found: Vec<_> = sheets
        .iter()
        .filter_map(|entry| names.iter().find(|name| name.0 == entry.name).map(|name| (entry, name.1)))
        .collect();
    let alike: Vec<_> =
        sheets.iter().filter(|entry| names.iter().any(|name| same_but_for_case(name.0, &entry.name))).collect();
    let wanted = |or: &str| names.iter().map(|name| format!("\"{}\"", name.0)).collect::<Vec<_>>().join(or);
    match found.as_slice() {
        [] => {
            let (wanted, there) = (Text::new(wanted(" o "), wanted(" or ")), list(sheets));
            let finding = match alike.iter().find(|entry| is_it(entry)) {
                Some(entry) => {
                    let name = excerpt(&entry.name, SHOWN);
                    let right =
                        names.iter().find(|name| same_but_for_case(name.0, &entry.name)).map_or("", |name| name.0);
                    SheetMisnamed { wanted, there, name, right: right.to_owned() }.at(Place::File)
                }
                None => otherwise(wanted, there),
            };
            Err(Refusal::new(Exit::Refused, finding))
        }
        [(entry, language)] if alike.len() == 1 => {
            if entry.kind == listing::SheetKind::Cells {
                Ok(((*entry).clone(), *language))
            } else {
                Err(no_cells(entry))
            }
        }
        _ => Err(ambiguous(&alike)),
    }
}

/// A further sheet of a form, in either language.
pub(super) fn find(
    sheets: &[SheetEntry],
    name: &'static Text,
    language: Language,
    findings: &mut Vec<Finding>,
) -> Result<Option<SheetEntry>, Refusal> {
    let names = Language::ALL.map(|language| name.get(language));
    let mut alike: Vec<_> =
        sheets.iter().filter(|entry| names.iter().any(|name| same_but_for_case(name, &entry.name))).collect();
    if alike.iter().any(|entry| names.contains(&entry.name.as_str())) {
        // Beside the sheet itself, one whose name has an accent more is another: the table `Calibración` of results.
        let plain = |name: &str| name.trim().to_lowercase();
        alike.retain(|entry| names.iter().any(|name| plain(name) == plain(&entry.name)));
    }
    let [entry] = alike.as_slice() else {
        return if alike.is_empty() { Ok(None) } else { Err(ambiguous(&alike)) };
    };
    if entry.kind != listing::SheetKind::Cells {
        return Err(no_cells(entry));
    }
    if names.contains(&entry.name.as_str()) {
        return Ok(Some((*entry).clone()));
    }
    // The name that it has in a workbook of this language, whatever the language of the message.
    let (right, name) = (name.get(language), excerpt(&entry.name, SHOWN));
    findings.push(SheetNotRead { name, right }.at(Place::Sheet(entry.name.clone())));
    Ok(None)
}

/// The sheets of a list, in the order of the workbook.
fn list_sheets(
    list: &'static List,
    sheets: &[SheetEntry],
    language: Language,
    findings: &mut Vec<Finding>,
) -> Result<Vec<SheetEntry>, Refusal> {
    match &list.naming {
        Naming::One(name) => {
            let found = find(sheets, name, language, findings)?;
            if found.is_none() && !list.optional {
                findings.push(SheetMissing { sheet: name.get(language) }.at(Place::File));
            }
            Ok(found.into_iter().collect())
        }
        Naming::Numbered(_) => Ok(sheets
            .iter()
            .filter(|entry| entry.kind == listing::SheetKind::Cells && is_numbered(&entry.name))
            .cloned()
            .collect()),
    }
}

/// True for `O` and one to four digits.
fn is_numbered(name: &str) -> bool {
    let digits = name.trim().strip_prefix(['O', 'o']).unwrap_or_default();
    (1..=4).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit())
}

fn ambiguous(alike: &[&SheetEntry]) -> Refusal {
    let names = alike.iter().map(|entry| format!("\"{}\"", excerpt(&entry.name, SHOWN))).collect::<Vec<_>>().join(", ");
    SheetAmbiguous { names }.refused(Exit::Refused, Place::File)
}

/// The names of the sheets, ten of them at most.
fn list(sheets: &[SheetEntry]) -> String {
    let mut names: Vec<_> =
        sheets.iter().take(10).map(|entry| format!("\"{}\"", excerpt(&entry.name, SHOWN))).collect();
    if sheets.len() > 10 {
        names.push("…".to_owned());
    }
    names.join(", ")
}

/// True for names that a person takes for one: alike but for capitals, accents and blanks around.
fn same_but_for_case(one: &str, other: &str) -> bool {
    words::fold(one) == words::fold(other)
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
        Some(Content::Text(text, _)) => excerpt(text.trim(), SHOWN),
        Some(Content::Number(number)) => decimal(*number),
        Some(Content::Error(error)) => excerpt(error, SHOWN),
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
            [] if parameter.required => findings.push(missing_row(parameter, sheet)),
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

fn missing_row(parameter: &'static Parameter, sheet: &SheetCells) -> Finding {
    let (name, expected, symbol) = (named(parameter), expected(parameter), parameter.key());
    RowMissing { name, symbol, expected }.at(Place::Sheet(sheet.name.clone()))
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
            sheet.text((*row, sheet.columns.symbol)).map_or_else(|| "?".to_owned(), |symbol| excerpt(symbol, SHOWN));
        findings.push(SymbolUnknown { symbol }.at(Place::Cells(vec![sheet.place((*row, sheet.columns.symbol))])));
    }
    if let Some(count) = rows.len().checked_sub(LISTED_SYMBOLS).filter(|more| *more > 0) {
        findings.push(MoreSymbolsUnknown { count }.at(Place::Sheet(sheet.name.clone())));
    }
}
