//! The charts of a sweep: objectives over each other and over each input, and the best designs in parallel coordinates.

use std::collections::BTreeSet;

use rust_xlsxwriter::{
    Chart, ChartAxisLabelPosition, ChartFont, ChartFormat, ChartLegendPosition, ChartLine, ChartMarker,
    ChartMarkerType, ChartSolidFill, ChartType, ColNum, Color, Format, RowNum, Workbook, Worksheet,
};

use super::cell::write_text;
use super::error::WriteError;
use super::page::Page;
use super::style::{Styles, grade_fill};
use super::sweep_book::{SweepBook, heading_width};
use crate::finding::Grade;
use crate::sweep::plan::Input;
use crate::sweep::results::COLOURS;
use crate::sweep::row::State;
use crate::sweep::table::{Cells, FEASIBLE, FRONT, ID, STATE, Table, plain};
use crate::text::{Text, t};

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

static CHARTS: Text = t("GRAFICOS", "CHARTS");
static POINTS: Text = t("PUNTOS", "POINTS");
static CURVES_SHEET: Text = t("CURVAS", "CURVES");

/// What the charts over two axes show.
struct Points {
    /// The columns.
    names: Vec<String>,
    /// The kind of each design, the place of its colour, and its row in the table of all, in the order of the kinds.
    rows: Vec<(usize, usize)>,
}

impl SweepBook<'_> {
    /// The charts, on a sheet before the cells that only they need.
    pub(super) fn write_charts(&self, workbook: &mut Workbook, styles: &Styles) -> Result<(), WriteError> {
        static TITLE: Text = t("Objetivos y entradas", "Objectives and inputs");
        let charts = workbook.add_worksheet();
        self.head(charts, styles, &CHARTS, &TITLE, "")?;
        let mut row = FIRST_CHART;
        let (pairs, names) = self.pairs();
        let points = self.points(names);
        for (x, y) in pairs {
            if let Some(chart) = self.scatter(&points, &x, y) {
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
        self.write_points(workbook.add_worksheet(), styles, &points)?;
        if count > 0 {
            let curves = workbook.add_worksheet();
            let axes = self.write_curves(curves, styles, count)?;
            let chart = self.coordinates(axes, count);
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

    /// What is charted over what, the axis across first, and all columns of the charts.
    fn pairs(&self) -> (Vec<(String, &str)>, Vec<String>) {
        let objectives: Vec<&str> =
            self.results.plan.objectives.iter().map(|one| one.measure.key).take(CHARTED).collect();
        let inputs: Vec<String> = self.results.plan.inputs.iter().map(Input::column).take(CHARTED).collect();
        let numbers = |name: &str| self.results.all.column(name).is_some_and(|cells| !matches!(cells, Cells::Text(_)));
        let mut pairs: Vec<(String, &str)> = Vec::new();
        for (at, x) in objectives.iter().enumerate() {
            pairs.extend(objectives[at + 1..].iter().map(|y| ((*x).to_owned(), *y)));
        }
        for y in &objectives {
            pairs.extend(inputs.iter().filter(|x| numbers(x)).map(|x| (x.clone(), *y)));
        }
        let mut names: Vec<String> = inputs.iter().filter(|name| numbers(name)).cloned().collect();
        names.extend(objectives.iter().map(|name| (*name).to_owned()));
        (pairs, names)
    }

    /// The chart of parallel coordinates: of `count` designs over `axes` columns.
    fn coordinates(&self, axes: usize, count: usize) -> Chart {
        static COORDINATES: Text = t(
            "Coordenadas paralelas de los mejores diseños, cada columna de su mínimo (0) a su máximo (1)",
            "Parallel coordinates of the best designs, each column from its least (0) to its greatest (1)",
        );
        let mut chart = Chart::new(ChartType::Line);
        let name = self.text(&CURVES_SHEET);
        let last = ColNum::try_from(axes).unwrap_or_default();
        // The best first: it is to lie on top.
        for at in 0..count {
            let line = RowNum::try_from(at).unwrap_or_default() + 1;
            // The rank by colour: the first is red, the last is pale.
            let part = u32::try_from(at * 150 / count).unwrap_or_default();
            let ink = if at == 0 {
                Color::from(COLOURS[1])
            } else {
                Color::RGB(((0x30 + part) << 16) | ((0x60 + part) << 8) | 0xB0)
            };
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
        chart
    }

    /// The designs that are charted, kind by kind; those that are refused have no place in a chart.
    fn points(&self, names: Vec<String>) -> Points {
        let all = self.results.all;
        let (top, front) = (self.results.top.column(ID), all.column(FRONT));
        let best: BTreeSet<u64> =
            (0..self.results.top.rows()).filter_map(|row| top?.number(row)).map(f64::to_bits).collect();
        let kind = |row: usize| {
            let truth = |name: &str| all.column(name).is_some_and(|cells| cells.truth(row));
            let id = all.column(ID).and_then(|cells| cells.number(row));
            if front.is_some_and(|cells| cells.truth(row)) {
                0
            } else if id.is_some_and(|id| best.contains(&id.to_bits())) {
                1
            } else {
                3 - usize::from(truth(FEASIBLE))
            }
        };
        let state = all.column(STATE);
        let mut rows: Vec<(usize, usize)> = (0..all.rows())
            .filter(|row| state.and_then(|cells| cells.text(*row)) == Some(State::Done.word()))
            .map(|row| (kind(row), row))
            .collect();
        rows.sort_unstable();
        Points { names, rows }
    }

    /// The cells of the charts: index, then what is charted, kind by kind.
    fn write_points(&self, sheet: &mut Worksheet, styles: &Styles, points: &Points) -> Result<(), WriteError> {
        sheet.set_name(self.text(&POINTS))?.set_hidden(true);
        let columns = std::iter::once(ID).chain(points.names.iter().map(String::as_str));
        for (column, name) in (0..).zip(columns) {
            let heading = plain(name);
            write_text(sheet, 0, column, heading, &styles.number_header)?;
            sheet.set_column_width(column, heading_width(heading).max(8.0))?;
            let Some(cells) = self.results.all.column(name) else { continue };
            for (row, (_, from)) in (1..).zip(&points.rows) {
                if let Some(value) = cells.number(*from) {
                    sheet.write_number(row, column, value)?;
                }
            }
        }
        sheet.set_freeze_panes(1, 1)?;
        Ok(())
    }

    /// One measure over another, or over an input: the front, others of the best, what is feasible, and what breaks a constraint; the
    /// first lies on top.
    fn scatter(&self, points: &Points, x: &str, y: &str) -> Option<Chart> {
        static KINDS: [(Text, ChartMarkerType, u8); 4] = [
            (t("Frente", "Front"), ChartMarkerType::Diamond, 8),
            (t("Otros de los mejores", "Others of the top"), ChartMarkerType::Circle, 7),
            (t("Válidos", "Feasible"), ChartMarkerType::Circle, 4),
            (t("Incumplen una restricción", "Constraint broken"), ChartMarkerType::Circle, 4),
        ];
        let column =
            |name: &str| points.names.iter().position(|one| one == name).and_then(|at| ColNum::try_from(at + 1).ok());
        let (across, up) = (column(x)?, column(y)?);
        let sheet = self.text(&POINTS);
        let mut chart = Chart::new(ChartType::Scatter);
        let mut first = 1;
        for (kind, ((name, shape, size), ink)) in KINDS.iter().zip(COLOURS).enumerate() {
            let count = points.rows.iter().filter(|(one, _)| *one == kind).count();
            let Some(last) = RowNum::try_from(count).ok().filter(|count| *count > 0).map(|count| first + count - 1)
            else {
                continue;
            };
            let mut marker = ChartMarker::new();
            marker
                .set_type(*shape)
                .set_size(*size)
                .set_format(ChartFormat::new().set_solid_fill(ChartSolidFill::new().set_color(ink)).set_no_border());
            chart
                .add_series()
                .set_name(self.text(name))
                .set_categories((sheet, first, across, last, across))
                .set_values((sheet, first, up, last, up))
                .set_marker(&marker);
            first = last + 1;
        }
        if first == 1 {
            return None;
        }
        let unit = |name: &str| {
            let unit = self.results.all.columns.iter().find(|one| one.name == name).map_or("", |one| one.unit);
            let called = self.results.name(name);
            let called = self.text(&called);
            if unit.is_empty() { called.to_owned() } else { format!("{called} [{unit}]") }
        };
        let (across, up) = (unit(x), unit(y));
        let font = ChartFont::new().set_size(9).clone();
        chart.x_axis().set_name(across.as_str()).set_font(&font).set_label_position(ChartAxisLabelPosition::Low);
        chart.y_axis().set_name(up.as_str()).set_font(&font).set_label_position(ChartAxisLabelPosition::Low);
        for (name, is_x) in [(x, true), (y, false)] {
            if let Some([low, high]) = self.reach(points, name) {
                let edge = if high > low { 0.02 * (high - low) } else { 0.5 };
                let unit = gridded(high - low + 2.0 * edge);
                // Whole numbers of blades have nothing between them.
                let whole = matches!(self.results.all.column(name), Some(Cells::Whole(_)));
                let unit = if whole { unit.ceil() } else { unit };
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

    /// The least and greatest value of what is charted; `None` where there is none.
    fn reach(&self, points: &Points, name: &str) -> Option<[f64; 2]> {
        let cells = self.results.all.column(name)?;
        ends(points.rows.iter().filter_map(|(_, row)| cells.number(*row)))
    }

    /// The columns of the parallel coordinates, one row a design, from 0 to 1; gives how many there are.
    fn write_curves(&self, sheet: &mut Worksheet, styles: &Styles, count: usize) -> Result<usize, WriteError> {
        sheet.set_name(self.text(&CURVES_SHEET))?.set_hidden(true);
        let inputs = self.results.plan.inputs.iter().map(Input::column);
        let names: Vec<String> =
            inputs.chain(self.results.plan.objectives.iter().map(|one| one.measure.key.to_owned())).collect();
        let axes: Vec<(&String, &Cells, [f64; 2])> = names
            .iter()
            .filter_map(|name| Some((name, self.results.top.column(name)?, extent(self.results.top, name)?)))
            .collect();
        let number = Format::new().set_num_format("0.000");
        for (column, (name, cells, [low, high])) in (1..).zip(&axes) {
            let heading = self.results.name(name);
            let heading = self.text(&heading);
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
            if let Some(id) = self.results.top.column(ID).and_then(|cells| cells.number(at)) {
                sheet.write_number_with_format(row, 0, id, &styles.index)?;
            }
        }
        let fill = Format::new().set_background_color(grade_fill(Grade::Note));
        sheet.set_row_format(1, &fill)?;
        Ok(axes.len())
    }
}

/// A chart whose first series lies on top wherever it is shown: LibreOffice draws what comes first in the file above the others, and
/// Excel what has the greatest order. Charts of bars lay nothing over anything.
pub(super) fn layered(chart: &str) -> String {
    let mut parts = chart.split("<c:order val=\"");
    let last = parts.clone().count().saturating_sub(2);
    if !(chart.contains("<c:scatterChart>") || chart.contains("<c:lineChart>")) {
        return chart.to_owned();
    }
    let mut turned = parts.next().unwrap_or_default().to_owned();
    for (at, part) in parts.enumerate() {
        let rest = part.split_once('"').map_or("", |(_, rest)| rest);
        turned.push_str(&format!("<c:order val=\"{}\"{rest}", last - at));
    }
    turned
}

/// The least and greatest value of a column; `None` where it has none.
fn extent(table: &Table, name: &str) -> Option<[f64; 2]> {
    let cells = table.column(name).filter(|_| name != FRONT)?;
    ends((0..table.rows()).filter_map(|row| cells.number(row)))
}

/// The least and greatest of some values; `None` where there are none.
fn ends(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
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
