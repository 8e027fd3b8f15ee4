//! The results of a sweep as a workbook: the best designs, all of them, why the others are not among them, charts, and what each
//! input does.

use std::io::{Seek, Write};

use rust_xlsxwriter::{
    Chart, ChartAxisLabelPosition, ChartFont, ChartFormat, ChartLegendPosition, ChartLine, ChartMarker,
    ChartMarkerType, ChartSolidFill, ChartType, ColNum, Color, Format, FormatAlign, RowNum, Url, Workbook, Worksheet,
};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::page::{ENDS, Further, Page, WHOLE, both_ends, properties};
use super::save::{Additions, save};
use super::style::{Styles, digits, grade_fill};
use crate::finding::Grade;
use crate::parameter::Parameter;
use crate::sweep::results::Results;
use crate::sweep::table::{Cells, FRONT, Table};
use crate::table::Unit;
use crate::text::{Language, Text, t};

/// The most rows of the sheet of all designs.
pub const ALL_MOST: u64 = 20_000;
/// The row of the headings, from 0; the units stand above it.
pub(super) const HEADINGS: RowNum = 4;
/// The most inputs that stand beside the number of a design on every printed page; more would leave no room for what came out.
const REPEATED: ColNum = 6;
/// The place of the sheet of all designs, from 0.
const SECOND: usize = 1;
/// The widest column of texts.
const TEXT_MOST: usize = 40;
/// The most inputs and objectives that are charted against each other.
const CHARTED: usize = 8;
/// The most designs of the chart of parallel coordinates: a chart takes 255 curves.
const CURVES: usize = 50;
/// Size of a chart, pixels: a little less than ten columns of the usual width and twenty rows.
pub(super) const SIZE: [u32; 2] = [634, 396];
/// Columns below a chart.
const COLUMNS: ColNum = 10;
/// How far a chart stands from the upper left corner of its first cell, so that no page break runs along its frame.
const INSET: u32 = 3;
/// Rows that a chart takes, with its gap.
pub(super) const CHART_ROWS: RowNum = 21;
/// The row of the first chart, from 0.
const FIRST_CHART: RowNum = 4;
/// Charts of an upright page: their rows and those above the first fill it.
const ON_PAGE: RowNum = 2;

pub(super) const DONE: Color = Color::RGB(0x9D_B4CC);
pub(super) const BEST: Color = Color::RGB(0xC0_504D);

/// What the workbook shows.
#[derive(Clone, Copy, Debug)]
pub struct SweepBook<'a> {
    /// What came of the sweep.
    pub results: Results<'a>,
    /// The files of the best designs, as they are found from the folder of this workbook.
    pub links: &'a [Option<String>],
    /// The language.
    pub language: Language,
}

static TOP: Text = t("MEJORES", "TOP");
static ALL: Text = t("TODOS", "ALL");
static WHY: Text = t("POR_QUE", "WHY");
static CHARTS: Text = t("GRAFICOS", "CHARTS");
static YES: Text = t("sí", "yes");
static NO: Text = t("no", "no");
static CURVES_SHEET: Text = t("CURVAS", "CURVES");

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
        save(&mut workbook, Additions { printed, ..Additions::default() }, out)
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
        let shown = table.columns.iter().filter(|one| one.name == "id" || filled(&one.cells));
        let mut widths = Vec::new();
        for (at, column) in (first..).zip(shown) {
            let format = match &column.cells {
                Cells::Number(_) | Cells::Whole(_) => &styles.number_header,
                Cells::Text(_) | Cells::Truth(_) => &styles.text_header,
            };
            let shown = self.digits(&column.name);
            write_text(sheet, HEADINGS - 1, at, column.unit, &styles.number_unit)?;
            write_text(sheet, HEADINGS, at, &column.name, format)?;
            let width = heading_width(&column.name).max(cells_width(&column.cells, shown));
            sheet.set_column_width(at, width)?;
            let number = Format::new().set_num_format(shown);
            let words = styles.block.clone().set_indent(1);
            for (row, cell) in (HEADINGS + 1..).zip(0..table.rows()) {
                match &column.cells {
                    Cells::Text(_) => {
                        if let Some(text) = column.cells.text(cell) {
                            write_text(sheet, row, at, text, &words)?;
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

    /// How a column's numbers are shown.
    fn digits(&self, name: &str) -> &'static str {
        let measure = self.results.kind.measures().iter().find(|one| one.key == name).map(|one| one.unit);
        let input = self.results.plan.inputs.iter().find(|one| name.strip_prefix("in_") == Some(&one.symbol()));
        match (measure, input.map(|one| one.parameter)) {
            (Some(unit), _) => digits(unit),
            // As it was typed.
            (None, Some(Parameter { unit: Unit::None, .. })) | (None, _) => "General",
        }
    }

    fn write_top(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<(), WriteError> {
        static TITLE: Text = t("Los mejores diseños", "The best designs");
        static LINK: Text = t("libro", "workbook");
        static TOLD: Text = t(
            "Cada enlace abre un libro ya calculado, que se puede editar y volver a generar.",
            "Each link opens a workbook that is built already, and can be edited and built again.",
        );
        let listed = self.results.listed();
        self.head(sheet, styles, &TOP, &TITLE, &format!("{} {}", self.text(&listed), self.text(&TOLD)))?;
        write_text(sheet, HEADINGS, 0, self.text(&LINK), &styles.text_header)?;
        sheet.set_column_width(0, 30.0)?;
        for (row, link) in (HEADINGS + 1..).zip(self.links) {
            if let Some(link) = link {
                let name = link.rsplit('/').next().unwrap_or(link);
                // In a link these would begin a place in the file, or a character by its number.
                let link = link.replace('%', "%25").replace('#', "%23");
                sheet.write_url(row, 0, Url::new(format!("file:///{link}")).set_text(name))?;
            }
        }
        self.rows(sheet, styles, &self.results.brief(), 1)?;
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

    /// The charts, on a sheet before the cells that only they need.
    fn write_charts(&self, workbook: &mut Workbook, styles: &Styles) -> Result<(), WriteError> {
        static TITLE: Text = t("Objetivos y entradas", "Objectives and inputs");
        static COORDINATES: Text = t(
            "Coordenadas paralelas de los mejores diseños, cada columna de su mínimo (0) a su máximo (1)",
            "Parallel coordinates of the best designs, each column from its least (0) to its greatest (1)",
        );
        let charts = workbook.add_worksheet();
        self.head(charts, styles, &CHARTS, &TITLE, "")?;
        let mut row = FIRST_CHART;
        let objectives: Vec<&str> =
            self.results.plan.objectives.iter().map(|one| one.measure.key).take(CHARTED).collect();
        let inputs: Vec<String> =
            self.results.plan.inputs.iter().map(|one| format!("in_{}", one.symbol())).take(CHARTED).collect();
        let numbers = |name: &str| self.results.all.column(name).is_some_and(|cells| !matches!(cells, Cells::Text(_)));
        let mut pairs: Vec<(String, &str)> = Vec::new();
        for (at, x) in objectives.iter().enumerate() {
            pairs.extend(objectives[at + 1..].iter().map(|y| ((*x).to_owned(), *y)));
        }
        for y in &objectives {
            pairs.extend(inputs.iter().filter(|x| numbers(x)).map(|x| (x.clone(), *y)));
        }
        for (x, y) in pairs {
            if let Some(chart) = self.scatter(&x, y) {
                charts.insert_chart_with_offset(row, 0, &chart, INSET, INSET)?;
                row += CHART_ROWS;
            }
        }
        let coordinates = row;
        let count = self.results.top.rows().min(CURVES);
        let end = coordinates + if count > 0 { CHART_ROWS } else { 0 };
        let breaks: Vec<RowNum> =
            (FIRST_CHART + ON_PAGE * CHART_ROWS..end).step_by((ON_PAGE * CHART_ROWS) as usize).collect();
        if !breaks.is_empty() {
            charts.set_page_breaks(&breaks)?;
        }
        // The lines above are longer than a chart is wide.
        charts.set_print_area(0, 0, end.max(FIRST_CHART) - 1, COLUMNS - 1)?;
        Page { landscape: false, ..self.page() }.set_up_fitted(charts, self.language);
        if count > 0 {
            let curves = workbook.add_worksheet();
            let axes = self.write_curves(curves, styles, count)?;
            let mut chart = Chart::new(ChartType::Line);
            let name = self.text(&CURVES_SHEET);
            let last = ColNum::try_from(axes).unwrap_or_default();
            for at in (0..count).rev() {
                let line = RowNum::try_from(at).unwrap_or_default() + 1;
                // The rank by colour: the first is red, the last is pale.
                let part = u32::try_from(at * 150 / count).unwrap_or_default();
                let ink = if at == 0 { BEST } else { Color::RGB(((0x30 + part) << 16) | ((0x60 + part) << 8) | 0xB0) };
                let mut format = ChartFormat::new();
                format.set_line(ChartLine::new().set_color(ink).set_width(if at == 0 { 2.25 } else { 1.0 }));
                chart
                    .add_series()
                    .set_name((name, line, 0))
                    .set_categories((name, 0, 1, 0, last))
                    .set_values((name, line, 1, line, last))
                    .set_format(&mut format);
            }
            chart.title().set_name(self.text(&COORDINATES)).set_font(ChartFont::new().set_size(12));
            chart.y_axis().set_min(0.0).set_max(1.0);
            chart.legend().set_hidden();
            chart.set_width(SIZE[0]).set_height(SIZE[1]);
            chart.set_alt_text(self.text(&COORDINATES));
            workbook.worksheet_from_name(self.text(&CHARTS))?.insert_chart_with_offset(
                coordinates,
                0,
                &chart,
                INSET,
                INSET,
            )?;
        }
        Ok(())
    }

    /// One measure over another, or over an input: all designs, and those of the front.
    fn scatter(&self, x: &str, y: &str) -> Option<Chart> {
        static FEASIBLE: Text = t("Diseños", "Designs");
        static SHOWN: Text = t("Mejores", "Top");
        let column = |table: &Table, name: &str, first: ColNum| {
            let shown: Vec<_> = table.columns.iter().filter(|one| one.name == "id" || filled(&one.cells)).collect();
            shown.iter().position(|one| one.name == name).and_then(|at| ColNum::try_from(at).ok()).map(|at| at + first)
        };
        let brief = self.results.brief();
        let series = [(&ALL, self.results.all, 0, &FEASIBLE, DONE, 4), (&TOP, &brief, 1, &SHOWN, BEST, 7)];
        let mut chart = Chart::new(ChartType::Scatter);
        let mut drawn = 0;
        for (sheet, table, first, name, ink, size) in series {
            let (Some(across), Some(up)) = (column(table, x, first), column(table, y, first)) else { continue };
            let last = HEADINGS + RowNum::try_from(table.rows()).ok()?;
            let mut marker = ChartMarker::new();
            marker
                .set_type(ChartMarkerType::Circle)
                .set_size(size)
                .set_format(ChartFormat::new().set_solid_fill(ChartSolidFill::new().set_color(ink)).set_no_border());
            let sheet = self.text(sheet);
            chart
                .add_series()
                .set_name(self.text(name))
                .set_categories((sheet, HEADINGS + 1, across, last, across))
                .set_values((sheet, HEADINGS + 1, up, last, up))
                .set_marker(&marker);
            drawn += 1;
        }
        if drawn == 0 {
            return None;
        }
        let unit = |name: &str| {
            let unit = self.results.all.columns.iter().find(|one| one.name == name).map_or("", |one| one.unit);
            let plain = name.strip_prefix("in_").unwrap_or(name);
            if unit.is_empty() { plain.to_owned() } else { format!("{plain} [{unit}]") }
        };
        let (across, up) = (unit(x), unit(y));
        let font = ChartFont::new().set_size(9).clone();
        chart.x_axis().set_name(across.as_str()).set_font(&font).set_label_position(ChartAxisLabelPosition::Low);
        chart.y_axis().set_name(up.as_str()).set_font(&font).set_label_position(ChartAxisLabelPosition::Low);
        for (name, is_x) in [(x, true), (y, false)] {
            if let Some([low, high]) = extent(self.results.all, name) {
                let edge = if high > low { 0.02 * (high - low) } else { 0.5 };
                let unit = gridded(high - low + 2.0 * edge);
                let axis = if is_x { chart.x_axis() } else { chart.y_axis() };
                axis.set_min(((low - edge) / unit).floor() * unit).set_max(((high + edge) / unit).ceil() * unit);
                axis.set_major_unit(unit);
            }
        }
        let title = format!("{up} / {across}");
        chart.title().set_name(title.as_str()).set_font(ChartFont::new().set_size(12));
        chart.legend().set_position(ChartLegendPosition::Bottom);
        chart.set_width(SIZE[0]).set_height(SIZE[1]);
        chart.set_alt_text(title.as_str());
        Some(chart)
    }

    /// The columns of the parallel coordinates, one row a design, from 0 to 1; gives how many there are.
    fn write_curves(&self, sheet: &mut Worksheet, styles: &Styles, count: usize) -> Result<usize, WriteError> {
        sheet.set_name(self.text(&CURVES_SHEET))?;
        let inputs = self.results.plan.inputs.iter().map(|one| format!("in_{}", one.symbol()));
        let names: Vec<String> =
            inputs.chain(self.results.plan.objectives.iter().map(|one| one.measure.key.to_owned())).collect();
        let axes: Vec<(&String, &Cells, [f64; 2])> = names
            .iter()
            .filter_map(|name| Some((name, self.results.top.column(name)?, extent(self.results.top, name)?)))
            .collect();
        let number = Format::new().set_num_format("0.000");
        for (column, (name, cells, [low, high])) in (1..).zip(&axes) {
            let heading = name.strip_prefix("in_").unwrap_or(name);
            write_text(sheet, 0, column, heading, &styles.number_header)?;
            sheet.set_column_width(column, heading_width(heading).max(8.0))?;
            for (row, at) in (1..).zip(0..count) {
                if let Some(value) = cells.number(at) {
                    let part = if high > low { (value - low) / (high - low) } else { 0.5 };
                    sheet.write_number_with_format(row, column, part, &number)?;
                }
            }
        }
        for (row, at) in (1..).zip(0..count) {
            if let Some(id) = self.results.top.column("id").and_then(|cells| cells.number(at)) {
                sheet.write_number_with_format(row, 0, id, &styles.index)?;
            }
        }
        let fill = Format::new().set_background_color(grade_fill(Grade::Note));
        sheet.set_row_format(1, &fill)?;
        Ok(axes.len())
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

/// The least and greatest value of a column; `None` where it has none.
fn extent(table: &Table, name: &str) -> Option<[f64; 2]> {
    let cells = table.column(name).filter(|_| name != FRONT)?;
    let values = (0..table.rows()).filter_map(|row| cells.number(row));
    values.fold(None, |known, value| {
        let [low, high] = known.unwrap_or([value; 2]);
        Some([f64::min(low, value), f64::max(high, value)])
    })
}

/// The distance of grid lines that divides a length into some four to ten: 1, 2 or 5 times a power of ten.
fn gridded(length: f64) -> f64 {
    let mut ten = 1.0;
    while ten > length {
        ten /= 10.0;
    }
    while ten * 10.0 <= length {
        ten *= 10.0;
    }
    let times = length / ten;
    if times > 5.0 {
        ten
    } else if times > 2.0 {
        ten / 2.0
    } else {
        ten / 5.0
    }
}

/// A count as a cell holds it.
#[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
const fn count(number: u64) -> f64 {
    number as f64
}

/// The width of a column in which a heading stands clear of the next.
fn heading_width(heading: &str) -> f64 {
    f64::from(u16::try_from(heading.chars().count()).unwrap_or(u16::MAX)) * 1.2 + 2.0
}

/// The width of a column in which its values stand clear of the next, in the digits that are shown.
fn cells_width(cells: &Cells, shown: &str) -> f64 {
    let digits = shown.split_once('.').map(|(_, decimals)| decimals.len());
    let length = |row: usize| match (cells, digits) {
        (Cells::Text(_), _) => cells.text(row).map_or(0, |text| text.chars().count().min(TEXT_MOST)),
        (Cells::Truth(_), _) => 2,
        (_, Some(digits)) => cells.number(row).map_or(0, |value| format!("{value:.digits$}").len()),
        (_, None) if shown == "0" => cells.number(row).map_or(0, |value| format!("{value:.0}").len()),
        // A spreadsheet shortens what is shown in no given form.
        (_, None) => cells.number(row).map_or(0, |value| value.to_string().len().min(8)),
    };
    heading_width("")
        + (0..cells.len()).map(length).max().and_then(|most| u16::try_from(most).ok()).map_or(0.0, f64::from)
}

#[cfg(test)]
mod tests {
    use super::gridded;

    #[test]
    fn a_grid_has_some_four_to_ten_round_distances() {
        for (length, unit) in
            [(1.0, 0.2), (1.56, 0.2), (2.1, 0.5), (4.2, 0.5), (7.0, 1.0), (0.19, 0.02), (3100.0, 500.0)]
        {
            assert!((gridded(length) - unit).abs() < 1e-9 * unit, "{length}: {}", gridded(length));
        }
    }
}
