//! The results of a sweep as a workbook: the best designs, all of them, why the others are not among them; charts and what each input
//! does have files of their own.

use std::io::{Seek, Write};

use rust_xlsxwriter::{ColNum, Format, FormatAlign, RowNum, Url, Workbook, Worksheet};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::page::{ENDS, Further, Page, WHOLE, both_ends, properties};
use super::save::{Additions, save};
use super::style::{Styles, digits, grade_fill};
use super::sweep_charts::layered;
use crate::finding::Grade;
use crate::parameter::{FieldKind, Parameter};
use crate::sweep::results::{Results, heading, state};
use crate::sweep::table::{Cells, ID, STATE, Table};
use crate::table::Unit;
use crate::text::{Language, Text, t};

/// The row of the headings, from 0; the units stand above it.
pub(super) const HEADINGS: RowNum = 4;
/// The most inputs that stand beside the number of a design on every printed page; more would leave no room for what came out.
const REPEATED: ColNum = 6;
/// The place of the sheet of all designs, from 0.
const SECOND: usize = 1;
/// The width of the column that says what a whole build found.
const WHOLE_BUILD: f64 = 56.0;
/// The widest column of texts.
const TEXT_MOST: usize = 40;

/// What the workbook shows.
#[derive(Clone, Copy, Debug)]
pub struct SweepBook<'a> {
    /// What came of the sweep.
    pub results: Results<'a>,
    /// The language of its words.
    pub language: Language,
}

static TOP: Text = t("MEJORES", "TOP");
static ALL: Text = t("TODOS", "ALL");
static WHY: Text = t("POR_QUE", "WHY");
static YES: Text = t("sí", "yes");
static NO: Text = t("no", "no");

/// How a measure is shown: lengths and angles to a thousandth, since what lies beyond is rounding; else as on every sheet.
pub(super) const fn shown(unit: Unit) -> &'static str {
    match unit {
        Unit::Millimetre | Unit::Degree => "0.000",
        unit => digits(unit),
    }
}

impl SweepBook<'_> {
    /// Writes the workbook. The same rows give the same bytes.
    ///
    /// # Errors
    /// For what a workbook cannot hold, and for what `out` refuses.
    pub fn write<W: Write + Seek + Send>(&self, out: W) -> Result<(), WriteError> {
        static TITLE: Text = t("Barrido", "Sweep");
        let (mut workbook, styles) = (Workbook::new(), Styles::default());
        workbook.set_properties(&properties(self.text(&TITLE))?);
        self.write_top(workbook.add_worksheet(), &styles)?;
        let printed = self.write_all(workbook.add_worksheet(), &styles)?.into_iter().collect();
        self.write_why(workbook.add_worksheet(), &styles)?;
        self.write_effects(workbook.add_worksheet(), &styles)?;
        if self.results.all.rows() > 0 && !self.results.plan.objectives.is_empty() {
            self.write_charts(&mut workbook, &styles)?;
        }
        save(&mut workbook, Additions { printed, redrawn: Some(layered), ..Additions::default() }, out)
    }

    pub(super) const fn page(&self) -> Page<'_> {
        Page { part: "", origin: self.results.source, repeat: (HEADINGS - 1, HEADINGS), landscape: true, single: false }
    }

    pub(super) fn text<'t>(&self, text: &'t Text) -> &'t str {
        text.get(self.language)
    }

    /// Title, and two lines below it.
    pub(super) fn head(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        name: &Text,
        title: &Text,
        more: &str,
    ) -> Result<(), WriteError> {
        sheet.set_name(self.text(name))?;
        write_text(sheet, 0, 0, self.text(title), &styles.title)?;
        let counted = self.results.counted();
        let told = format!("{}: {}", self.results.source, self.text(&counted));
        write_text(sheet, 1, 0, &told, &styles.source)?;
        write_text(sheet, 2, 0, more, &styles.source)?;
        Ok(())
    }

    /// The rows of a table below headings and units, from a column on; columns that are empty in all rows are left out. Gives the
    /// widths of the columns.
    fn rows(
        &self,
        sheet: &mut Worksheet,
        styles: &Styles,
        table: &Table,
        first: ColNum,
    ) -> Result<Vec<f64>, WriteError> {
        let shown = table.columns.iter().filter(|one| one.name == ID || filled(&one.cells));
        let mut widths = Vec::new();
        for (at, column) in (first..).zip(shown) {
            let format = match &column.cells {
                Cells::Number(_) | Cells::Whole(_) => &styles.number_header,
                Cells::Text(_) | Cells::Truth(_) => &styles.text_header,
            };
            let shown = self.digits(&column.name);
            write_text(sheet, HEADINGS - 1, at, column.unit, &styles.number_unit)?;
            let heading = heading(&column.name);
            let heading = self.text(&heading);
            write_text(sheet, HEADINGS, at, heading, format)?;
            let width =
                heading_width(heading).max(cells_width(&column.cells, shown, |text| self.word(&column.name, text)));
            sheet.set_column_width(at, width)?;
            let number = Format::new().set_num_format(shown);
            let words = styles.block.clone().set_indent(1);
            for (row, cell) in (HEADINGS + 1..).zip(0..table.rows()) {
                match &column.cells {
                    Cells::Text(_) => {
                        if let Some(text) = column.cells.text(cell) {
                            write_text(sheet, row, at, &self.word(&column.name, text), &words)?;
                        }
                    }
                    Cells::Truth(cells) => {
                        if let Some(Some(truth)) = cells.get(cell) {
                            write_text(sheet, row, at, self.text(if *truth { &YES } else { &NO }), &words)?;
                        }
                    }
                    cells => {
                        if let Some(value) = cells.number(cell) {
                            sheet.write_number_with_format(row, at, value, &number)?;
                        }
                    }
                }
            }
            widths.push(width);
        }
        Ok(widths)
    }

    /// A text of a column in the words of the form: the rows hold the keys of choices.
    fn word(&self, name: &str, text: &str) -> String {
        if name == STATE {
            return self.text(&state(text)).to_owned();
        }
        let Some(Parameter { kind: FieldKind::Choice(choices), .. }) = self.input(name) else { return text.to_owned() };
        choices
            .iter()
            .find(|choice| choice.key == text)
            .map_or(text, |choice| choice.label.get(self.language))
            .to_owned()
    }

    /// The input of a column.
    fn input(&self, name: &str) -> Option<&'static Parameter> {
        let input = self.results.plan.inputs.iter().find(|one| one.column() == name);
        input.map(|one| one.parameter)
    }

    /// How a column's numbers are shown.
    fn digits(&self, name: &str) -> &'static str {
        let measure = self.results.kind.measures().iter().find(|one| one.key == name);
        // An input is shown as it was typed.
        measure.map_or("General", |one| shown(one.unit))
    }

    fn write_top(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<(), WriteError> {
        static TITLE: Text = t("Los mejores diseños", "The best designs");
        static LINK: Text = t("libro", "workbook");
        static BUILT: Text = t("generado", "built");
        static NONE: Text = t("", "");
        static TOLD: Text = t(
            "Cada enlace abre un libro ya calculado, que se puede editar y volver a generar.",
            "Each link opens a workbook that is built already, and can be edited and built again.",
        );
        static SOME: Text = t(
            "En rojo, el libro sin resultados de un diseño rechazado; los demás enlaces abren un libro ya calculado, que se puede editar y volver a generar.",
            "In red, the workbook without results of a design that was rejected; each of the other links opens a workbook that is built already, and can be edited and built again.",
        );
        static REJECTED: Text = t(
            "Cada enlace abre el libro sin resultados de un diseño rechazado, que se puede editar y volver a generar.",
            "Each link opens the workbook without results of a design that was rejected, which can be edited and built again.",
        );
        let told = match self.results.tried() {
            (0, _) => &NONE,
            (_, 0) => &TOLD,
            (built, rejected) if rejected < built => &SOME,
            _ => &REJECTED,
        };
        let listed = self.results.listed();
        self.head(sheet, styles, &TOP, &TITLE, &format!("{} {}", self.text(&listed), self.text(told)))?;
        write_text(sheet, HEADINGS, 0, self.text(&LINK), &styles.text_header)?;
        sheet.set_column_width(0, 30.0)?;
        write_text(sheet, HEADINGS, 2, self.text(&BUILT), &styles.text_header)?;
        let rejected = self.results.tried().1 > 0;
        sheet.set_column_width(2, if rejected { WHOLE_BUILD } else { heading_width(self.text(&BUILT)) })?;
        let plain = styles.text.clone().set_indent(1);
        let stop = plain.clone().set_background_color(grade_fill(Grade::Stop));
        let link = [
            Format::new().set_hyperlink(),
            Format::new().set_hyperlink().set_background_color(grade_fill(Grade::Stop)),
        ];
        for (row, built) in (HEADINGS + 1..).zip(self.results.built) {
            let Some(built) = built else {
                write_text(sheet, row, 2, self.text(&NO), &plain)?;
                continue;
            };
            let name = built.file.rsplit('/').next().unwrap_or(&built.file);
            // In a link these would begin a place in the file, or a character by its number.
            let file = built.file.replace('%', "%25").replace('#', "%23");
            let url = Url::new(format!("file:///{file}")).set_text(name);
            sheet.write_url_with_format(row, 0, url, &link[usize::from(built.rejected)])?;
            match built.stop() {
                None => write_text(sheet, row, 2, self.text(&YES), &plain)?,
                Some(found) => {
                    let told = format!("{}: {}", found.code(), self.text(&found.what));
                    write_text(sheet, row, 2, &told, &stop)?;
                    sheet.set_row_height(row, row_height(&[(&told, WHOLE_BUILD)]))?;
                }
            }
        }
        // The index beside the link, and the others behind what the build said.
        let mut id = self.results.brief();
        let others = Table { columns: id.columns.split_off(1) };
        self.rows(sheet, styles, &id, 1)?;
        self.rows(sheet, styles, &others, 3)?;
        sheet.set_freeze_panes(HEADINGS + 1, 2)?;
        self.page().set_up(sheet, self.language)?;
        Ok(())
    }

    /// The sheet of all designs; gives what is printed of a long one beside its first rows.
    fn write_all(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<Option<Further>, WriteError> {
        static TITLE: Text = t("Todos los diseños", "All designs");
        let told = if self.results.all.rows() as u64 == self.results.plan.count {
            t("Los filtros de los encabezados eligen filas.", "The filters in the headings choose rows.")
        } else {
            let rows = self.results.all.rows();
            Text::new(
                format!(
                    "Aquí están los {rows} mejores. Todos, también los rechazados, están en summary.parquet, para DuckDB o pandas, y con --csv en summary.csv."
                ),
                format!(
                    "The best {rows} are here. All of them, also those refused, are in summary.parquet, for DuckDB or pandas, and with --csv in summary.csv."
                ),
            )
        };
        self.head(sheet, styles, &ALL, &TITLE, self.text(&told))?;
        // On pages farther across only the first columns are repeated: figures cut off there could be misread.
        write_text(sheet, 1, 0, self.results.source, &styles.source)?;
        let widths = self.rows(sheet, styles, self.results.all, 0)?;
        let last = HEADINGS + RowNum::try_from(self.results.all.rows()).unwrap_or_default();
        let end = ColNum::try_from(widths.len()).unwrap_or(ColNum::MAX).saturating_sub(1);
        if last > HEADINGS {
            sheet.autofilter(HEADINGS, 0, last, end)?;
        }
        sheet.set_freeze_panes(HEADINGS + 1, 1)?;
        let inputs = ColNum::try_from(self.results.plan.inputs.len()).unwrap_or(REPEATED);
        let page = self.page();
        page.set_up_wide(sheet, self.language, &widths, 1 + inputs.min(REPEATED))?;
        let rows = self.results.all.rows();
        if rows <= WHOLE as usize {
            return Ok(None);
        }
        page.set_header(sheet, both_ends(rows).get(self.language));
        let areas = [[(0, 0), (HEADINGS + ENDS, end)], [(last + 1 - ENDS, 0), (last, end)]];
        Ok(Further::set(sheet, SECOND, &areas)?)
    }

    fn write_why(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<(), WriteError> {
        static TITLE: Text = t("Por qué los demás no valen", "Why the others are not good");
        static TOLD: Text = t(
            "Cada diseño cuenta una vez, por su primer motivo; rodete explain CÓDIGO lo explica.",
            "Each design counts once, by its first reason; rodete explain CODE explains it.",
        );
        static HEADS: [Text; 4] =
            [t("motivo", "reason"), t("diseños", "designs"), t("parte", "share"), t("qué dice", "what it says")];
        self.head(sheet, styles, &WHY, &TITLE, self.text(&TOLD))?;
        for (column, (heading, width)) in (0..).zip(HEADS.iter().zip([26.0, 12.0, 12.0, 90.0])) {
            let format = if column == 1 || column == 2 { &styles.number_header } else { &styles.text_header };
            write_text(sheet, HEADINGS, column, self.text(heading), format)?;
            sheet.set_column_width(column, width)?;
        }
        let number = Format::new().set_align(FormatAlign::Top);
        let share = number.clone().set_num_format("0.0 %");
        for (row, why) in (HEADINGS + 1..).zip(self.results.why) {
            write_text(sheet, row, 0, &why.code, &styles.symbol)?;
            let [count, all] = [why.count, self.results.plan.count].map(count);
            sheet.write_number_with_format(row, 1, count, &number)?;
            sheet.write_number_with_format(row, 2, count / all.max(1.0), &share)?;
            let what = self.text(&why.what);
            write_text(sheet, row, 3, what, &styles.text)?;
            sheet.set_row_height(row, row_height(&[(what, 90.0)]))?;
        }
        sheet.set_freeze_panes(HEADINGS + 1, 0)?;
        self.page().set_up(sheet, self.language)?;
        Ok(())
    }
}

/// True where a column has a value in any row; the mark of the front is not among what the sheets leave out.
fn filled(cells: &Cells) -> bool {
    match cells {
        Cells::Whole(cells) => cells.iter().any(Option::is_some),
        Cells::Number(cells) => cells.iter().any(Option::is_some),
        Cells::Text(cells) => cells.iter().any(|cell| cell.as_deref().is_some_and(|text| !text.is_empty())),
        Cells::Truth(cells) => cells.iter().any(Option::is_some),
    }
}

/// A count as a cell holds it.
#[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
const fn count(number: u64) -> f64 {
    number as f64
}

/// The width of a column in which a heading stands clear of the next.
pub(super) fn heading_width(heading: &str) -> f64 {
    f64::from(u16::try_from(heading.chars().count()).unwrap_or(u16::MAX)) * 1.2 + 2.0
}

/// The width of a column in which its values stand clear of the next, in the digits that are shown.
fn cells_width(cells: &Cells, shown: &str, word: impl Fn(&str) -> String) -> f64 {
    let digits = shown.split_once('.').map(|(_, decimals)| decimals.len());
    let length = |row: usize| match (cells, digits) {
        (Cells::Text(_), _) => cells.text(row).map_or(0, |text| word(text).chars().count().min(TEXT_MOST)),
        (Cells::Truth(_), _) => 2,
        (_, Some(digits)) => cells.number(row).map_or(0, |value| format!("{value:.digits$}").len()),
        (_, None) if shown == "0" => cells.number(row).map_or(0, |value| format!("{value:.0}").len()),
        // A spreadsheet shortens what is shown in no given form.
        (_, None) => cells.number(row).map_or(0, |value| value.to_string().len().min(8)),
    };
    heading_width("")
        + (0..cells.len()).map(length).max().and_then(|most| u16::try_from(most).ok()).map_or(0.0, f64::from)
}
