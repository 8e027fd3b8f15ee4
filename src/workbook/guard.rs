//! The guard against old figures: a copy of every input that the programs were verified with, and a banner on every sheet
//! that turns red as soon as an input differs, or the sheet is not of the workbook's last [build](super::stamp).
//!
//! The copies stand on a hidden sheet, one row an input: its defined name, or its cell in a list; the copy; and a flag that is 1
//! where they differ. A number must stay a number, a text the same text, an empty cell empty. A difference of one unit in the
//! last place of a number is not seen: it moves nothing by 0.001 mm. The flags ask for the time and make nothing of it, so
//! that a spreadsheet which keeps stored results computes them when it opens the file.

use crate::finding::{CellPlace, Key};
use std::collections::{BTreeMap, BTreeSet};

use rust_xlsxwriter::{
    ColNum, ConditionalFormatFormula, Format, Formula, RowNum, Workbook, Worksheet, quote_sheet_name,
    utility::column_number_to_name,
};

use super::address::{self, Position};
use super::cell::{CELL, shortened, write_text};
use super::error::WriteError;
use super::limits;
use super::sheet_cells::{Content, SheetCells};
use super::stamp;
use super::stamp::STALE;
use super::style::Styles;
use crate::kind::NamedFile;
use crate::parameter::{Form, Parameter, Value, Values};
use crate::text::{Language, Text, t};

/// The sheet of the copies.
pub const SHEET: &str = "Verified";
/// By what it is known again in the workbook of somebody else's.
pub const KEY: &str = "verified";
/// Its name, in both languages.
pub static NAME: Text = t(SHEET, SHEET);
/// The cell of the guard's sheet that it leads to.
pub const COUNT: &str = "C1";
/// The row and the column, from 0, of the build's stamp on that sheet.
const STAMP: (RowNum, ColNum) = (0, 1);
/// What stands in the first cell of that sheet.
const MARK: &str = "rodete";
/// How many columns of that sheet are read.
pub(super) const COLUMNS: u32 = 256;
/// The columns, from 0, of the keys of lists' columns, of the files that were made, and of the sheets of the lists.
const KEYS: ColNum = 3;
const FILES: ColNum = 4;
const SHEETS: ColNum = 5;
/// The most characters of a text inside a formula.
const LITERAL: usize = 255;
/// What the row of a file that the workbook names begins with; its name follows.
const FILE: &str = "SHA-256 ";

/// What an input held when the programs were verified.
#[derive(Clone, Debug, PartialEq)]
pub enum Copy {
    /// A number, in the unit of its cell.
    Number(f64),
    /// A text, as the cell held it.
    Text(String),
    /// Nothing.
    Empty,
}

impl Copy {
    /// What a cell of a form holds for a value.
    #[must_use]
    pub fn of(parameter: &Parameter, value: Option<&Value>, language: Language) -> Self {
        match value {
            Some(Value::Real(value)) => Self::Number(*value),
            Some(Value::Whole(value)) => Self::Number(f64::from(*value)),
            Some(Value::Choice(key)) => Self::Text(parameter.label(key, language).to_owned()),
            Some(Value::Line(text)) if text.is_empty() => Self::Empty,
            Some(Value::Line(text)) => Self::Text(shortened(text, CELL).into_owned()),
            None => Self::Empty,
        }
    }

    /// What a cell holds as it stands: what a formula compares.
    pub(super) fn held(sheet: &SheetCells, position: Position) -> Self {
        match sheet.cell(position).map(|cell| &cell.content) {
            Some(Content::Number(value) | Content::Date(_, Some(value))) => Self::Number(*value),
            Some(Content::Text(text, _)) => Self::Text(text.clone()),
            None => sheet.blanks.get(&position).map_or(Self::Empty, |blank| Self::Text(blank.clone())),
            _ => Self::Empty,
        }
    }

    /// True where both hold the same, as the banner's formula compares them; numbers to the last bit.
    fn same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(one), Self::Number(other)) => one.to_bits() == other.to_bits(),
            _ => self == other,
        }
    }

    fn write(&self, sheet: &mut Worksheet, row: RowNum, column: ColNum, styles: &Styles) -> Result<(), WriteError> {
        match self {
            Self::Number(value) if value.is_finite() => drop(sheet.write_number(row, column, *value)?),
            Self::Number(_) => return Err(WriteError::NotFinite { place: SHEET.to_owned() }),
            Self::Text(text) => write_text(sheet, row, column, text, &styles.entry)?,
            Self::Empty => {}
        }
        Ok(())
    }
}

/// A column of a list: the cells that were filled or stood ready to be.
#[derive(Clone, Debug)]
pub struct Column {
    /// The key of the column in its form.
    pub key: &'static str,
    /// The list's sheet.
    pub sheet: String,
    /// The column on the sheet, from 0.
    pub column: ColNum,
    /// The row of the first cell, from 0.
    pub first: RowNum,
    /// What the cells held.
    pub copies: Vec<Copy>,
}

/// What the cells of a form and of its lists hold as they stand in a workbook, whose owner may have typed `Yes` for `yes`.
#[derive(Clone, Debug, Default)]
pub struct CellCopies {
    /// The inputs that have a cell, by the keys of their parameters.
    pub inputs: BTreeMap<&'static str, Copy>,
    /// The columns of the lists.
    pub columns: Vec<Column>,
}

impl CellCopies {
    /// Takes the inputs that a sheet holds.
    pub(super) fn take(&mut self, keys: impl Iterator<Item = &'static str>, values: &Values, sheet: &SheetCells) {
        let held = |key| Some((key, Copy::held(sheet, address::parse(&values.cells.get(key)?.cell)?)));
        self.inputs.extend(keys.filter_map(held));
    }
}

/// The inputs with what they held, and the stamp of the build.
#[derive(Debug, Default)]
pub struct Guard {
    stamp: String,
    inputs: Vec<(&'static str, Option<[CellPlace; 2]>, Copy)>,
    columns: Vec<Column>,
    named_files: Vec<NamedFile>,
}

/// The first column of the copies of lists.
const LISTS: ColNum = 6;

impl Guard {
    /// The guard of a build with a [stamp].
    #[must_use]
    pub fn new(stamp: String) -> Self {
        Self { stamp, ..Self::default() }
    }

    /// Watches an input by its defined name, which must go on leading to the row of its symbol and the column of the heading, where these
    /// cells are known: a cell that is cut and pasted elsewhere takes its name along.
    pub fn watch(&mut self, input: &'static str, at: Option<[CellPlace; 2]>, copy: Copy) {
        self.inputs.push((input, at, copy));
    }

    /// Watches a column of a list.
    pub fn watch_column(&mut self, column: Column) {
        self.columns.push(column);
    }

    /// Keeps the SHA-256 of the files that the workbook names. No formula asks a file: `rodete check` compares them.
    pub fn keep(&mut self, named_files: &[NamedFile]) {
        self.named_files.extend_from_slice(named_files);
    }

    /// Writes the hidden sheet under a name and defines the name of its count. `files` are what was made from these inputs.
    ///
    /// # Errors
    /// For a number that is not finite, and for more inputs than a sheet has rows.
    pub fn write(
        &self,
        workbook: &mut Workbook,
        name: &str,
        files: &[String],
        styles: &Styles,
    ) -> Result<(), WriteError> {
        workbook.define_name(STALE, &format!("={}!$C$1", quote_sheet_name(name)))?;
        let (row, column) = (STAMP.0 + 1, column_number_to_name(STAMP.1));
        workbook.define_name(stamp::NAME, &format!("={}!${column}${row}", quote_sheet_name(name)))?;
        let sheet = workbook.add_worksheet().set_name(name)?;
        sheet.set_hidden(true).set_column_width(0, 32)?.set_column_width(1, 32)?;
        let rows = self.inputs.len() + self.columns.len();
        let last = RowNum::try_from(rows).map_err(|_| WriteError::TooLarge("guard"))? + 1;
        write_text(sheet, 0, 0, MARK, &styles.header)?;
        write_text(sheet, STAMP.0, STAMP.1, &self.stamp, &styles.entry)?;
        let count = format!("=IF(ISERROR(SUM(C2:C{last})),{},SUM(C2:C{last}))", last - 1);
        sheet.write_formula(0, 2, Formula::new(count).set_result("0"))?;
        let mut row = 0;
        for (input, at, copy) in &self.inputs {
            row += 1;
            write_text(sheet, row, 0, input, &styles.entry)?;
            copy.write(sheet, row, 1, styles)?;
            let flag = flag(input, at.as_ref(), row + 1);
            sheet.write_formula(row, 2, Formula::new(flag).set_result("0"))?;
        }
        for (at, column) in (LISTS..).zip(&self.columns) {
            row += 1;
            let (cells, flag) = column.flag(at);
            write_text(sheet, row, 0, &cells, &styles.entry)?;
            write_text(sheet, row, KEYS, column.key, &styles.entry)?;
            write_text(sheet, row, SHEETS, &column.sheet, &styles.entry)?;
            sheet.write_formula(row, 2, Formula::new(flag).set_result("0"))?;
            for (to, copy) in (0..).zip(&column.copies) {
                copy.write(sheet, to, at, styles)?;
            }
        }
        for file in &self.named_files {
            row += 1;
            write_text(sheet, row, 0, &format!("{FILE}{}", file.name), &styles.entry)?;
            write_text(sheet, row, 1, &file.sha256, &styles.entry)?;
        }
        for (row, file) in (0..).zip(files) {
            write_text(sheet, row, FILES, file, &styles.entry)?;
        }
        sheet.protect();
        Ok(())
    }

    /// Writes a banner into the first of some columns of a row: what is told while the inputs are as verified, else a warning in
    /// white on red over all of the columns. `told` may be empty. The formats are the usual one and the warning's.
    ///
    /// # Errors
    /// For a cell outside the sheet.
    pub fn banner(
        &self,
        sheet: &mut Worksheet,
        row: RowNum,
        columns: [ColNum; 2],
        told: &str,
        language: Language,
        formats: [&Format; 2],
    ) -> Result<(), WriteError> {
        self.banner_of_rows(sheet, row, columns, (told, None), language, formats)
    }

    /// A banner over rows that may become more than are printed: the formula that is true then, and the last row that is printed, from 0.
    ///
    /// # Errors
    /// For a cell outside the sheet.
    pub fn banner_of_rows(
        &self,
        sheet: &mut Worksheet,
        row: RowNum,
        [first, last]: [ColNum; 2],
        (told, grown): (&str, Option<(&str, RowNum)>),
        language: Language,
        [format, stale]: [&Format; 2],
    ) -> Result<(), WriteError> {
        static VERIFIED: Text = t("Datos verificados", "Verified inputs");
        let verified = VERIFIED.get(language);
        let told = if told.is_empty() { verified.to_owned() } else { format!("{told} · {verified}") };
        let [before, after] = WARNING.each_ref().map(|text| literal(text.get(language)));
        let mut warning = format!("{before}&{STALE}&{after}");
        if let Some((grown, printed)) = grown {
            let [before, row, after] = GROWN.each_ref().map(|text| text.get(language));
            let [before, after] = [literal(before), literal(&format!("{row}{}{after}", printed + 1))];
            warning = format!("IF({grown},{before}&{STALE}&{after},{warning})");
        }
        let (differs, other) = (stamp::differs(&self.stamp), literal(OTHER.get(language)));
        let formula = format!("=IF({differs},{other},IF({STALE}=0,{},{warning}))", literal(&told));
        sheet.write_formula_with_format(row, first, Formula::new(formula).set_result(told), format)?;
        sheet.add_conditional_format(row, first, row, last, &self.when_stale(stale.clone()))?;
        Ok(())
    }

    /// Strikes out what was made from the inputs and does not follow them, as soon as one differs, or the workbook is built of others.
    ///
    /// # Errors
    /// For a cell outside the sheet.
    pub fn strike(
        &self,
        sheet: &mut Worksheet,
        [first, last]: [RowNum; 2],
        columns: [ColNum; 2],
        struck: &Format,
    ) -> Result<(), WriteError> {
        sheet.add_conditional_format(first, columns[0], last, columns[1], &self.when_stale(struck.clone()))?;
        Ok(())
    }

    fn when_stale(&self, format: Format) -> ConditionalFormatFormula {
        let rule = format!("=IF(ISERROR({STALE}),TRUE,IF({STALE}<>0,TRUE,{}))", stamp::differs(&self.stamp));
        ConditionalFormatFormula::new().set_rule(rule.as_str()).set_format(format)
    }
}

/// The files that the workbook named when its programs were verified, by the sheet [`SHEET`]; none where that is not rodete's.
#[must_use]
pub(super) fn named_files(sheet: &SheetCells) -> Vec<NamedFile> {
    if sheet.text((0, 0)) != Some(MARK) {
        return Vec::new();
    }
    let file = |&row: &u32| {
        let (name, sha256) = (sheet.text((row, 0))?.strip_prefix(FILE)?, sheet.text((row, 1))?);
        Some(NamedFile { name: name.to_owned(), sha256: sha256.to_owned() })
    };
    sheet.rows.keys().filter_map(file).collect()
}

/// The files whose inputs differ from what they were made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Stale {
    /// The keys of the inputs that differ.
    pub inputs: Vec<Key>,
    /// The sheets of the lists that differ, with the cells that do.
    pub lists: Vec<(String, Vec<Position>)>,
    /// The files that were made, by their names.
    pub files: Vec<String>,
}

/// Compares the values of a form with the copies on the sheet [`SHEET`] of the same workbook. `None` where they are the same,
/// or where the sheet is not rodete's. The same is what is written as it was: the banner compares cells, not meanings, and a blank
/// more in `part` stands in the programs' comments, too.
#[must_use]
pub(super) fn stale(sheet: &SheetCells, form: &'static Form, values: &Values, copies: &CellCopies) -> Option<Stale> {
    if sheet.text((0, 0)) != Some(MARK) {
        return None;
    }
    let language = values.language;
    let held = |position: Position| Copy::held(sheet, position);
    let rows: BTreeMap<&str, u32> = sheet.rows.keys().filter_map(|&row| Some((sheet.text((row, 0))?, row))).collect();
    let parameters = form.sheets.iter().flat_map(|one| one.sections).flat_map(|section| section.parameters);
    let differs = |parameter: &Parameter| {
        // An input whose row the form did not have was empty.
        let copy = rows.get(parameter.name).map_or(Copy::Empty, |&row| held((row, 1)));
        match copies.inputs.get(parameter.key) {
            Some(cell) => !cell.same(&copy),
            None => !Copy::of(parameter, values.values.get(parameter.key), language).same(&copy),
        }
    };
    let inputs: Vec<Key> = parameters.filter(|parameter| differs(parameter)).map(|parameter| parameter.key()).collect();
    let last = sheet.rows.keys().next_back().map_or(0, |row| row + 1);
    let columns: Vec<(&str, &str)> = sheet
        .rows
        .keys()
        .filter_map(|&row| {
            Some((sheet.text((row, u32::from(KEYS)))?, sheet.text((row, u32::from(SHEETS))).unwrap_or_default()))
        })
        .collect();
    let mut lists: Vec<(String, Vec<Position>)> = values
        .lists
        .iter()
        // Without a column the form had no list when it was verified, or an earlier rodete did not watch it.
        .filter(|one| !columns.is_empty() && columns.iter().all(|(_, name)| *name != one.sheet))
        .map(|one| (one.sheet.clone(), Vec::new()))
        .collect();
    for (column, (key, name)) in (u32::from(LISTS)..).zip(&columns) {
        let of = values.lists.iter().find(|one| one.sheet == *name);
        let parameter = form.lists.iter().flat_map(|list| list.columns).find(|parameter| parameter.key == *key);
        let Some(parameter) = parameter.filter(|one| one.read) else { continue };
        let now = |at: usize| of.and_then(|rows| rows.rows.get(at)).and_then(|row| row.values.get(parameter.key));
        let filled = of.map_or(0, |rows| u32::try_from(rows.rows.len()).unwrap_or(u32::MAX));
        let same = || {
            let mut rows = (0..last.max(filled)).zip(0..);
            rows.all(|(row, at)| Copy::of(parameter, now(at), language).same(&held((row, column))))
        };
        let changed = |one: &Column| -> Vec<Position> {
            let count = u32::try_from(one.copies.len()).unwrap_or(u32::MAX);
            let copies = one.copies.iter().chain(std::iter::repeat(&Copy::Empty));
            let rows = (0..last.max(count)).zip(copies).filter(|(row, copy)| !copy.same(&held((*row, column))));
            rows.map(|(row, _)| (one.first + row, u32::from(one.column))).collect()
        };
        let mut columns = copies.columns.iter().filter(|one| one.key == *key && one.sheet == *name);
        let cells = columns.next().map(changed);
        if cells.as_ref().map_or_else(same, Vec::is_empty) {
            continue;
        }
        let at = lists.iter().position(|(one, _)| one == name).unwrap_or_else(|| {
            lists.push(((*name).to_owned(), Vec::new()));
            lists.len() - 1
        });
        lists[at].1.extend(cells.unwrap_or_default());
    }
    let files: Vec<String> = (0..).map_while(|row| sheet.text((row, u32::from(FILES))).map(str::to_owned)).collect();
    (!inputs.is_empty() || !lists.is_empty()).then_some(Stale { inputs, lists, files })
}

/// The inputs that the sheet [`SHEET`] watches by a defined name which is gone, or leads to another cell than the one that is read: its
/// flag and the formulas look there.
#[must_use]
pub(super) fn astray(
    sheet: &SheetCells,
    form: &'static Form,
    values: &Values,
    names: &BTreeMap<String, String>,
) -> Vec<&'static Parameter> {
    // Of so many names the others were not read.
    if sheet.text((0, 0)) != Some(MARK) || names.len() >= limits::NAMES {
        return Vec::new();
    }
    let watched: BTreeSet<&str> = sheet.rows.keys().filter_map(|&row| sheet.text((row, 0))).collect();
    let leads = |parameter: &Parameter| {
        let (named, cell) = address::cell(names.get(&parameter.name.to_lowercase())?)?;
        let read = values.cells.get(parameter.key)?;
        Some(named.to_lowercase() == read.sheet.to_lowercase() && cell.eq_ignore_ascii_case(&read.cell))
    };
    let all = form.parameters().map(|(_, parameter)| parameter);
    all.filter(|one| watched.contains(one.name) && leads(one) != Some(true)).collect()
}

impl Column {
    /// The cells, and 1 where one of them differs from its copy in a column of the copies or one is filled below them.
    fn flag(&self, copies: ColNum) -> (String, String) {
        const LAST: RowNum = 1_048_576;
        let (own, name) = (column_number_to_name(copies), column_number_to_name(self.column));
        let sheet = quote_sheet_name(&self.sheet);
        let count = RowNum::try_from(self.copies.len()).unwrap_or(LAST);
        let (first, last) = (self.first + 1, (self.first + count).min(LAST - 1));
        let cells = format!("{sheet}!${name}${first}:${name}${last}");
        let copies = format!("${own}$1:${own}${count}");
        // Not EXACT alone: over a range, LibreOffice finds no two numbers exact. Not `=` alone: it takes no notice of capitals,
        // and an empty cell equals 0.
        let kind = |of: &str| format!("({of}({cells})={of}({copies}))");
        let equal = format!("(ISTEXT({copies})*EXACT({cells},{copies})+(1-ISTEXT({copies}))*({cells}={copies}))");
        let differ = format!("SUMPRODUCT(1-{}*{}*{equal})", kind("ISTEXT"), kind("ISBLANK"));
        let below = format!("COUNTA({sheet}!${name}${}:${name}${LAST})", last + 1);
        // A row that is put in right above the first one moves all of the cells, and is none of them; cells that are cut and pasted
        // elsewhere leave their heading.
        let above = if self.first > 0 {
            let (own, heading) = (format!("{sheet}!${name}${first}"), format!("{sheet}!${name}${}", self.first));
            format!("+ABS(ROW({own})-ROW({heading})-1)+ABS(COLUMN({own})-COLUMN({heading}))")
        } else {
            String::new()
        };
        let differ = format!("{differ}{above}");
        let flag = format!("=IF(ISERROR({differ}),1,IF({differ}+{below}=0,0,1))+0*NOW()");
        (cells, flag)
    }
}

/// 1 where an input differs from the copy on a row or stands elsewhere, 0 where it does not.
fn flag(input: &str, at: Option<&[CellPlace; 2]>, row: RowNum) -> String {
    let copy = format!("B{row}");
    // Rows and columns that are put in, taken away or moved as a whole take symbol and heading with them; a cell that is moved leaves them.
    let absolute = |place: &CellPlace| {
        let (row, column) = address::parse(&place.cell)?;
        Some(format!("{}!${}${}", quote_sheet_name(&place.sheet), address::letters(column), u64::from(row) + 1))
    };
    let elsewhere = at.and_then(|[symbol, heading]| {
        let (symbol, heading) = (absolute(symbol)?, absolute(heading)?);
        Some(format!("ABS(ROW({input})-ROW({symbol}))+ABS(COLUMN({input})-COLUMN({heading}))>0"))
    });
    let elsewhere = elsewhere.unwrap_or_else(|| "FALSE".to_owned());
    format!(
        "=IF(ISERROR({input}),1,IF({elsewhere},1,IF(ISBLANK({copy}),IF(ISBLANK({input}),0,1),IF(ISNUMBER({copy}),IF(ISNUMBER({input}),IF(({input}-{copy})=0,IF(EXACT({input},{copy}),0,1),1),1),IF(ISTEXT({input}),IF(EXACT({input},{copy}),0,1),1)))))+0*NOW()"
    )
}

static WARNING: [Text; 2] = [
    t(
        "NO VERIFICADO: datos cambiados desde que se hicieron los programas: ",
        "NOT VERIFIED: inputs changed since the programs were made: ",
    ),
    t("; vuelva a generar", "; build again"),
];

static OTHER: Text = t(
    "NO VERIFICADO: esta hoja no es de la última generación del libro",
    "NOT VERIFIED: this sheet is not of the workbook's last build",
);

/// The same where there are more rows than are printed, no longer than that.
static GROWN: [Text; 3] = [
    t("NO VERIFICADO: datos cambiados: ", "NOT VERIFIED: inputs changed: "),
    t("; la impresión acaba en la fila ", "; the print ends at row "),
    t("; vuelva a generar", "; build again"),
];

/// The most characters that a banner shows as a warning.
#[must_use]
pub fn warning(language: Language) -> usize {
    const COUNT: usize = 3;
    let changed = WARNING.iter().map(|text| text.get(language).chars().count()).sum::<usize>() + COUNT;
    changed.max(OTHER.get(language).chars().count())
}

/// A text inside a formula: quotes doubled, parted where it is longer than a spreadsheet allows.
fn literal(text: &str) -> String {
    let mut parts = vec![String::new()];
    let mut room = LITERAL;
    for one in text.chars() {
        let length = if one == '"' { 2 } else { one.len_utf16() };
        if length > room {
            parts.push(String::new());
            room = LITERAL;
        }
        room -= length;
        if let Some(part) = parts.last_mut() {
            part.push(one);
            if one == '"' {
                part.push(one);
            }
        }
    }
    parts.iter().map(|part| format!("\"{part}\"")).collect::<Vec<_>>().join("&")
}
