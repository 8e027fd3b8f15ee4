//! The first sheet of the results: the verdict, what to check and the files, then the derived values and the contents of
//! the other sheets.

use rust_xlsxwriter::{Color, Format, RowNum, Url, Worksheet, quote_sheet_name};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::guard::Guard;
use super::live::{self, LiveTables};
use super::page::Page;
use super::style::{Styles, grade_fill};
use crate::finding::{Finding, Grade};
use crate::kind::{Outcome, Proved, Timed, checks};
use crate::number::grouped;
use crate::parameter::field::Chosen;
use crate::table::{Quantity, Unit};
use crate::text::{Language, Text, t};

/// The sheet's name.
pub static NAME: Text = t("RESUMEN", "SUMMARY");

/// Widths of columns A to E in characters: the derived values are the widest table.
const WIDTHS: [f64; 5] = [23.0, 58.0, 15.0, 9.0, 46.0];

/// The most cautions listed here; the sheet of the checks lists them all.
const CAUTIONS: usize = 4;

/// A file that is delivered with the results: its name and what it is.
pub type File = (String, Text);

/// The contents of the first sheet.
#[derive(Debug)]
pub struct Summary<'a> {
    /// The outcome of the design.
    pub outcome: &'a Outcome,
    /// The files that are delivered with the results.
    pub files: &'a [File],
    /// The folder that they are in, where it is not that of the workbook.
    pub beside: Option<&'a str>,
    /// The other sheets: their names and contents.
    pub sheets: &'a [(String, String)],
    /// The name of the one of them with all that was found.
    pub checks: &'a str,
    /// How to use this workbook as an input.
    pub again: &'a Text,
    /// The tables that formulas refer to.
    pub live: LiveTables<'a>,
    /// What tells whether the inputs are those that were verified.
    pub guard: &'a Guard,
    /// The language of its words.
    pub language: Language,
}

/// A line above the derived values.
struct SummaryRow {
    label: Text,
    text: Text,
    grade: Option<Grade>,
    /// It is what came out for the inputs.
    computed: bool,
}

impl Summary<'_> {
    /// Writes the sheet. Returns the defined names of derived values with the rows that they stand on, from 0, all in column C.
    ///
    /// # Errors
    /// For a quantity that is not finite.
    pub fn write(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        page: &Page<'_>,
    ) -> Result<Vec<(&'static str, RowNum)>, WriteError> {
        for (column, width) in (0..).zip(WIDTHS) {
            sheet.set_column_width(column, width)?;
        }
        static TITLE: Text = t("Resultados", "Results");
        write_text(sheet, 0, 0, TITLE.get(self.language), &styles.title)?;
        sheet.merge_range(1, 0, 1, 4, "", &styles.source)?;
        self.guard.banner(sheet, 1, [0, 4], "", self.language, [&styles.source, &styles.stale])?;
        let mut row = 1;
        for line in self.lines() {
            row += 1;
            let text = line.text.get(self.language);
            let format = match line.grade {
                Some(grade) => styles.text.clone().set_background_color(grade_fill(grade)),
                None => styles.text.clone(),
            };
            write_text(sheet, row, 0, line.label.get(self.language), &styles.symbol)?;
            sheet.merge_range(row, 1, row, 4, "", &format)?;
            write_text(sheet, row, 1, text, &format)?;
            if line.computed && self.live.on() {
                self.guard.strike(sheet, [row; 2], [1, 4], &styles.left)?;
            }
            sheet.set_row_height(row, row_height(&[(text, WIDTHS.iter().skip(1).sum())]))?;
        }
        let mut names = Vec::new();
        row = self.write_quantities(sheet, styles, row + 2, &mut names)?;
        let last = self.write_index(sheet, styles, row + 2)?;
        sheet.set_print_area(0, 0, last, 4)?;
        Page { single: true, ..*page }.set_up_fitted(sheet, self.language);
        Ok(names)
    }

    /// The lines in their order.
    fn lines(&self) -> Vec<SummaryRow> {
        let outcome = self.outcome;
        let found = &outcome.findings;
        let source = &outcome.source;
        let part: Vec<&str> = [outcome.part(), outcome.material()].into_iter().filter(|one| !one.is_empty()).collect();
        let control = |word: &str, language| {
            let style =
                outcome.style.map_or_else(String::new, |style| format!(", {word} {}", style.label().get(language)));
            format!("{}{style}", outcome.control.name)
        };
        let (words, grade) = checks::verdict(outcome.stopped(), found);
        let passed = checks::passed(&outcome.checks);
        let sentences = |words: &str, passed: &str| format!("{words}. {passed}").trim_end().to_owned();
        let verdict = Text::new(sentences(&words.es, &passed.es), sentences(&words.en, &passed.en));
        let looked = cautions(found, self.checks);
        let attention =
            if outcome.stopped() || found.iter().any(|one| one.grade != Grade::Note) { Some(grade) } else { None };
        let line = |label: Text, text: Text| SummaryRow { label, text, grade: None, computed: false };
        let computed = |label: Text, text: Text, grade| SummaryRow { label, text, grade, computed: true };
        let tables = self.live.note().map(|note| line(t("Tablas", "Tables"), note));
        let lines = vec![
            line(t("Pieza", "Part"), Text::same(part.join(", "))),
            line(t("Control", "Control"), Text::new(control("estilo", Language::Es), control("style", Language::En))),
            computed(t("Resultado", "Verdict"), verdict, Some(grade)),
            computed(t("Qué revisar", "What to check"), looked, attention),
            computed(t("Programas", "Programs"), programs(&outcome.programs), None),
            line(t("Archivos", "Files"), self.delivered()),
            line(
                t("Antes de cortar", "Before you cut"),
                t(
                    "Compare los primeros y los últimos bloques en el control y haga una prueba en vacío.",
                    "Compare the first and the last blocks at the control, and make a dry run.",
                ),
            ),
            line(t("Para cambiar algo", "To change something"), self.again.clone()),
            line(
                t("Calculado", "Computed"),
                Text::new(
                    format!(
                        "por rodete {} a partir de {} (SHA-256 {}).",
                        source.version, source.workbook, source.sha256
                    ),
                    format!("by rodete {} from {} (SHA-256 {}).", source.version, source.workbook, source.sha256),
                ),
            ),
        ];
        lines.into_iter().chain(tables).collect()
    }

    fn delivered(&self) -> Text {
        if self.files.is_empty() {
            return t("Solo este libro.", "Only this workbook.");
        }
        let beside = self.beside.map_or_else(
            || t("En la carpeta de este libro:", "In the folder of this workbook:"),
            |folder| Text::new(format!("En la carpeta {folder}:"), format!("In the folder {folder}:")),
        );
        let list = |language: Language| {
            let files = self.files.iter().map(|(name, what)| format!("{name}: {}", what.get(language)));
            std::iter::once(beside.get(language).to_owned()).chain(files).collect::<Vec<_>>().join("\n")
        };
        Text::new(list(Language::Es), list(Language::En))
    }

    /// The derived values from a row on: symbol, meaning, value, unit, source. Returns their last row.
    fn write_quantities(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        first: RowNum,
        names: &mut Vec<(&'static str, RowNum)>,
    ) -> Result<RowNum, WriteError> {
        static HEADINGS: [Text; 5] = [
            t("Derivado", "Derived"),
            t("Significado", "Meaning"),
            t("Valor", "Value"),
            t("Unidad", "Unit"),
            t("Procedencia", "Source"),
        ];
        if self.outcome.quantities.is_empty() {
            return Ok(first - 2);
        }
        for (column, heading) in (0..).zip(&HEADINGS) {
            let format = if column == 2 { &styles.number_header } else { &styles.header };
            write_text(sheet, first, column, heading.get(self.language), format)?;
        }
        let mut last = first;
        for quantity in &self.outcome.quantities {
            last += 1;
            self.write_quantity(sheet, styles, last, quantity)?;
            names.extend(quantity.cell.as_ref().map(|cell| (cell.name, last)));
        }
        Ok(last)
    }

    fn write_quantity(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        row: RowNum,
        quantity: &Quantity,
    ) -> Result<(), WriteError> {
        if !quantity.value.is_finite() {
            return Err(WriteError::NotFinite { place: quantity.symbol.to_owned() });
        }
        let (meaning, source) = (quantity.meaning.get(self.language), quantity.source.get(self.language));
        write_text(sheet, row, 0, quantity.symbol, &styles.symbol)?;
        write_text(sheet, row, 1, meaning, &styles.text)?;
        let format = styles.number(quantity.unit);
        let formula = quantity.cell.as_ref().and_then(|cell| cell.live.as_ref());
        match formula.map(|formula| self.live.outside(formula, "\"\"")).transpose()?.flatten() {
            Some(formula) => {
                let formula = live::number(&formula, quantity.value, || quantity.symbol.to_owned())?;
                sheet.write_formula_with_format(row, 2, formula, &format)?;
            }
            None => {
                sheet.write_number_with_format(row, 2, quantity.value, &format)?;
                if self.live.on() {
                    // With its source, which may say where it is reached.
                    self.guard.strike(sheet, [row; 2], [2, 4], &styles.left)?;
                }
            }
        }
        write_text(sheet, row, 3, quantity.unit.label(), &styles.unit)?;
        write_text(sheet, row, 4, source, &styles.faint)?;
        sheet.set_row_height(row, row_height(&[(meaning, WIDTHS[1]), (source, WIDTHS[4])]))?;
        Ok(())
    }

    /// The other sheets from a row on, each with a link. Returns the last row.
    fn write_index(&self, sheet: &mut Worksheet, styles: &Styles, first: RowNum) -> Result<RowNum, WriteError> {
        static HEADINGS: [Text; 2] = [t("Hoja", "Sheet"), t("Contenido", "Contents")];
        let link = styles
            .text
            .clone()
            .set_font_color(Color::RGB(0x1F_4FA3))
            .set_underline(rust_xlsxwriter::FormatUnderline::Single);
        let [name, what] = &HEADINGS;
        write_text(sheet, first, 0, name.get(self.language), &styles.header)?;
        sheet.merge_range(first, 1, first, 4, "", &styles.header)?;
        write_text(sheet, first, 1, what.get(self.language), &styles.header)?;
        let mut row = first;
        for (name, what) in self.sheets {
            row += 1;
            let url = Url::new(format!("internal:{}!A1", quote_sheet_name(name))).set_text(name);
            sheet.write_url_with_format(row, 0, url, &link)?;
            sheet.merge_range(row, 1, row, 4, "", &styles.text)?;
            write_text(sheet, row, 1, what, &styles.text)?;
            sheet.set_row_height(row, row_height(&[(what, WIDTHS.iter().skip(1).sum())]))?;
        }
        Ok(row)
    }
}

/// The gravest findings, one per line, and the sheet that has all of them.
fn cautions(findings: &[Finding], sheet: &str) -> Text {
    let mut grave: Vec<&Finding> = findings.iter().filter(|one| one.grade != Grade::Note).collect();
    // Of one grade first what the programs do to the part, as on the first page of the report.
    grave.sort_by_key(|one| (std::cmp::Reverse(one.grade), !one.code().starts_with('V')));
    let list = |language: Language, none: &str, more: &str, all: &str| {
        if grave.is_empty() {
            return none.to_owned();
        }
        let told = grave.iter().take(CAUTIONS).map(|one| format!("{} {}", one.code(), one.what.get(language)));
        let rest = grave.len().saturating_sub(CAUTIONS);
        let end = if rest > 0 { format!("{more} {rest}. {all}") } else { all.to_owned() };
        told.chain(std::iter::once(end)).collect::<Vec<_>>().join("\n")
    };
    Text::new(
        list(Language::Es, "Nada en particular.", "Y otras", &format!("Remedios y lugares, en la hoja {sheet}.")),
        list(Language::En, "Nothing in particular.", "And further", &format!("Remedies and places: sheet {sheet}.")),
    )
}

/// The programs, one per line: title, length, time.
fn programs(programs: &[Proved]) -> Text {
    if programs.is_empty() {
        return t("Ninguno.", "None.");
    }
    let line = |proved: &Proved, language: Language, blocks: &str| {
        let program = &proved.program;
        let count = if program.blocks() > 0 { program.blocks() } else { program.parts.len() as u64 };
        let title = program.title.get(language);
        let time = time(proved).map_or_else(String::new, |time| format!(", {}", time.get(language)));
        let count = grouped(count);
        format!("{title} ({}): {count} {blocks}{time}", program.key)
    };
    // What is turned is the blank of what is milled, and is made first.
    let mut in_order: Vec<&Proved> = programs.iter().collect();
    in_order.sort_by_key(|one| !one.program.control.turns());
    let list = |language: Language, blocks: &str| {
        in_order.iter().map(|one| line(one, language, blocks)).collect::<Vec<_>>().join("\n")
    };
    Text::new(list(Language::Es, "bloques"), list(Language::En, "blocks"))
}

/// The time of a program, as in the report.
fn time(proved: &Proved) -> Option<Text> {
    let (timed, time) = proved.time_in_words();
    Some(match timed {
        Timed::Unknown => return None,
        Timed::Feed => {
            Text::new(format!("{time} con avance, sin rápidos"), format!("{time} at feed, without rapid moves"))
        }
        Timed::Cycle | Timed::Part => Text::same(format!("≥ {time}")),
    })
}

impl Styles {
    /// The format of a computed value, boxed.
    fn number(&self, unit: Unit) -> Format {
        self.number.clone().set_num_format(super::style::digits(unit))
    }
}
