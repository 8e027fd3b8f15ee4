//! What each input of a sweep does, as a sheet: around the design of the workbook, and over the whole plan.

use rust_xlsxwriter::{
    Chart, ChartAxisLabelPosition, ChartFont, ChartLegendPosition, ChartSolidFill, ChartType, ColNum, Format, RowNum,
    Worksheet,
};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::page::Page;
use super::style::Styles;
use super::sweep_book::{HEADINGS, SweepBook, shown};
use super::sweep_charts::{CHART_ROWS, SIZE};
use crate::sweep::objective::Objective;
use crate::sweep::results::COLOURS;
use crate::sweep::sensitivity::Slope;
use crate::text::{Text, t};

static SENSITIVITY: Text = t("SENSIBILIDAD", "SENSITIVITY");

/// The width of the first column and of the others, in digits.
const WIDTHS: [f64; 2] = [18.0, 13.0];
/// So many rows go on an upright page at the least size at which the sheet is printed.
const ON_PAGE: RowNum = 48;

impl SweepBook<'_> {
    /// The sheet: what each input may do around the design of the workbook; below it, for each objective, what each input does
    /// to it; and charts of that.
    pub(super) fn write_effects(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<(), WriteError> {
        static TITLE: Text = t("Qué hace cada entrada", "What each input does");
        static INPUTS: [Text; 7] = [
            t("entrada", "input"),
            t("valor", "value"),
            t("unidad", "unit"),
            t("puede bajar", "may go down"),
            t("puede subir", "may go up"),
            t("desde", "from"),
            t("hasta", "to"),
        ];
        let told = self.results.explained();
        let told = told.iter().map(|one| self.text(one)).collect::<Vec<_>>().join(" ");
        self.head(sheet, styles, &SENSITIVITY, &TITLE, "")?;
        for (column, heading) in (0..).zip(&INPUTS) {
            write_text(sheet, HEADINGS, column, self.text(heading), &styles.header)?;
        }
        let last = ColNum::try_from(INPUTS.len().max(1 + self.what().len())).unwrap_or(1) - 1;
        sheet.set_column_width(0, WIDTHS[0])?;
        sheet.set_column_range_width(1, last, WIDTHS[1])?;
        // What is told stands over the tables, in as many lines as it takes.
        sheet.merge_range(2, 0, 2, last, "", &styles.note)?;
        write_text(sheet, 2, 0, &told, &styles.note)?;
        let across = WIDTHS[0] + WIDTHS[1] * f64::from(last);
        sheet.set_row_height(2, row_height(&[(&told, across)]))?;
        self.write_rooms(sheet, styles)?;
        for at in 0..self.results.plan.objectives.len() {
            self.write_changes(sheet, styles, at)?;
        }
        let charts = self.draw_effects(sheet)?;
        sheet.set_freeze_panes(HEADINGS + 1, 1)?;
        let end = self.block(self.results.plan.objectives.len()) + charts * CHART_ROWS;
        sheet.set_print_area(0, 0, end.saturating_sub(1), last)?;
        Page { landscape: false, ..self.page() }.set_up_fitted(sheet, self.language);
        Ok(())
    }

    /// The table of the inputs: value, what each may do around it, and the ends of the plan.
    fn write_rooms(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<(), WriteError> {
        let room = Format::new().set_num_format("0.####");
        let open = room.clone().set_num_format("\"≥ \"0.####");
        let value = Format::new().set_num_format("0.######");
        for (row, effect) in (HEADINGS + 1..).zip(self.results.effects) {
            write_text(sheet, row, 0, &effect.symbol, &styles.symbol)?;
            write_text(sheet, row, 2, effect.unit, &styles.unit)?;
            let mut cells: Vec<(ColNum, Option<f64>, &Format)> = vec![(1, effect.value, &value)];
            match &effect.room {
                Ok(both) => {
                    for ((column, by), ends) in (3..).zip(both).zip(effect.open) {
                        cells.push((column, Some(*by), if ends { &open } else { &room }));
                    }
                }
                Err(none) => {
                    for column in 3..5 {
                        write_text(sheet, row, column, self.text(&none.words()), &styles.faint)?;
                    }
                }
            }
            cells.extend((5..).zip(effect.ends.iter().flatten()).map(|(column, end)| (column, Some(*end), &room)));
            write_numbers(sheet, row, cells)?;
        }
        Ok(())
    }

    /// The table of one objective: what each input does to it.
    fn write_changes(&self, sheet: &mut Worksheet, styles: &Styles, at: usize) -> Result<(), WriteError> {
        let Some(Objective { measure, .. }) = self.results.plan.objectives.get(at) else { return Ok(()) };
        let (room, part) = (Format::new().set_num_format("0.####"), Format::new().set_num_format("0.0 %"));
        let (head, unit) = (self.block(at), measure.unit.label());
        let change = Format::new().set_num_format(shown(measure.unit));
        let name = if unit.is_empty() { measure.key.to_owned() } else { format!("{} [{unit}]", measure.key) };
        write_text(sheet, head, 0, &name, &styles.header)?;
        for (column, heading) in (1..).zip(self.what()) {
            write_text(sheet, head, column, self.text(&heading), &styles.header)?;
        }
        for (row, effect) in (head + 1..).zip(self.results.effects) {
            write_text(sheet, row, 0, &effect.symbol, &styles.symbol)?;
            let [low, high] = effect.changes.get(at).copied().unwrap_or_default();
            let slope = effect.slopes.get(at).copied().unwrap_or(Slope::Unknown);
            if slope == Slope::Rounding {
                write_text(sheet, row, 1, Slope::ROUNDING, &styles.faint)?;
            }
            let mut cells: Vec<(ColNum, Option<f64>, &Format)> =
                vec![(1, slope.known(), &room), (2, low, &change), (3, high, &change)];
            if self.results.triples.is_some() {
                let index = effect.indices.get(at).copied().flatten();
                let values = index.map(|index| [index.first, index.off[0], index.total, index.off[1]]);
                cells.extend(
                    (4..).zip(values.into_iter().flatten()).map(|(column, value)| (column, Some(value), &part)),
                );
            } else {
                cells.push((4, effect.shares.get(at).copied().flatten(), &part));
            }
            write_numbers(sheet, row, cells)?;
        }
        Ok(())
    }

    /// The rows of a table.
    fn inputs(&self) -> RowNum {
        RowNum::try_from(self.results.effects.len()).unwrap_or_default()
    }

    /// The row of the headings of an objective's table; behind the last one, that of the first chart.
    fn block(&self, at: usize) -> RowNum {
        HEADINGS + (self.inputs() + 2) * (1 + RowNum::try_from(at).unwrap_or_default())
    }

    /// What is told of what an input does to an objective.
    fn what(&self) -> Vec<Text> {
        let mut headings = vec![t("por unidad", "per unit"), t("(desde)", "(from)"), t("(hasta)", "(to)")];
        if self.results.shared() {
            headings.push(t("parte", "share"));
        } else if self.results.indexed() {
            headings.extend([t("sola", "alone"), t("±", "±"), t("total", "total"), t("±", "±")]);
        }
        headings
    }

    /// The charts below the tables: changes, and indices. How many there are.
    fn draw_effects(&self, sheet: &mut Worksheet) -> Result<RowNum, WriteError> {
        static CHANGE: Text = t(
            "al llevar cada entrada a un extremo del plan, las demás como en el libro",
            "as each input goes to an end of the plan, the others as in the workbook",
        );
        static SHARE: Text =
            t("qué parte de su varianza explica cada entrada", "which part of its variance each input explains");
        static ENDS: [Text; 2] = [t("desde", "from"), t("hasta", "to")];
        static BOTH: [Text; 2] = [t("sola", "alone"), t("total", "total")];
        let mut charts = Vec::new();
        for (at, Objective { measure, .. }) in self.results.plan.objectives.iter().enumerate() {
            let (unit, name) = (measure.unit.label(), measure.name());
            let name = self.text(&name);
            let axis = if unit.is_empty() { format!("Δ {name}") } else { format!("Δ {name} [{unit}]") };
            let first = self.block(at) + 1;
            let moves = self.results.effects.iter().any(|one| one.changes.iter().flatten().any(Option::is_some));
            if moves {
                let title = format!("{axis}: {}", self.text(&CHANGE));
                charts.push(self.bars(first, &title, &axis, [(&ENDS[0], 2), (&ENDS[1], 3)], 100));
            }
            if self.results.effects.iter().any(|one| one.indices.get(at).copied().flatten().is_some()) {
                let title = format!("{name}: {}", self.text(&SHARE));
                charts.push(self.bars(first, &title, "", [(&BOTH[0], 4), (&BOTH[1], 6)], 0));
            }
        }
        let count = RowNum::try_from(charts.len()).unwrap_or_default();
        let (mut row, mut page, mut breaks) = (self.block(self.results.plan.objectives.len()), 0, Vec::new());
        for chart in charts {
            // None is cut by the end of a page.
            if row + CHART_ROWS > page + ON_PAGE {
                page = row;
                breaks.push(row);
            }
            sheet.insert_chart(row, 0, &chart)?;
            row += CHART_ROWS;
        }
        sheet.set_page_breaks(&breaks)?;
        Ok(count)
    }

    /// Two bars for each input, the first input on top, from the row of the first.
    fn bars(&self, first: RowNum, title: &str, axis: &str, series: [(&Text, ColNum); 2], overlap: i8) -> Chart {
        let (name, last) = (self.text(&SENSITIVITY), (first + self.inputs()).saturating_sub(1));
        let mut chart = Chart::new(ChartType::Bar);
        for ((legend, column), ink) in series.into_iter().zip([COLOURS[2], COLOURS[1]]) {
            chart
                .add_series()
                .set_name(self.text(legend))
                .set_categories((name, first, 0, last, 0))
                .set_values((name, first, column, last, column))
                .set_format(ChartSolidFill::new().set_color(ink))
                .set_overlap(overlap)
                .set_gap(60);
        }
        let font = ChartFont::new().set_size(9).clone();
        // Of bars, the upright axis is that of the inputs.
        chart.y_axis().set_reverse().set_font(&font).set_label_position(ChartAxisLabelPosition::Low);
        chart.x_axis().set_font(&font).set_label_position(ChartAxisLabelPosition::High);
        if !axis.is_empty() {
            chart.x_axis().set_name(axis);
        }
        chart.title().set_name(title).set_font(ChartFont::new().set_size(11));
        chart.legend().set_position(ChartLegendPosition::Bottom);
        chart.set_width(SIZE[0]).set_height(SIZE[1]);
        chart.set_alt_text(title);
        chart
    }
}

/// Writes the numbers of a row that there are.
fn write_numbers(
    sheet: &mut Worksheet,
    row: RowNum,
    cells: Vec<(ColNum, Option<f64>, &Format)>,
) -> Result<(), WriteError> {
    for (column, value, format) in cells {
        if let Some(value) = value {
            sheet.write_number_with_format(row, column, value, format)?;
        }
    }
    Ok(())
}
