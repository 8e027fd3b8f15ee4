//! What each input of a sweep does, as a sheet: around the design of the workbook, and over the whole plan.

use rust_xlsxwriter::{
    Chart, ChartAxisLabelPosition, ChartFont, ChartLegendPosition, ChartSolidFill, ChartType, ColNum, Format, RowNum,
    Worksheet,
};

use super::cell::write_text;
use super::error::WriteError;
use super::style::Styles;
use super::sweep_book::{BEST, CHART_ROWS, DONE, HEADINGS, SIZE, SweepBook};
use crate::sweep::objective::Objective;
use crate::text::{Text, t};

static SENSITIVITY: Text = t("SENSIBILIDAD", "SENSITIVITY");

/// The columns before those of the objectives.
const BEFORE: ColNum = 7;
/// Columns of an objective around the design of the workbook.
const AROUND: ColNum = 3;
/// Columns of an objective's indices.
const OF_INDICES: ColNum = 4;

impl SweepBook<'_> {
    /// The sheet, with a chart of the changes for each objective, and one of the indices where there are any.
    pub(super) fn write_effects(&self, sheet: &mut Worksheet, styles: &Styles) -> Result<(), WriteError> {
        static TITLE: Text = t("Qué hace cada entrada", "What each input does");
        let told = self.results.explained();
        let told = told.each_ref().map(|one| self.text(one)).join(" ");
        self.head(sheet, styles, &SENSITIVITY, &TITLE, &told)?;
        for (column, (heading, unit)) in (0..).zip(self.headings()) {
            write_text(sheet, HEADINGS - 1, column, &unit, &styles.number_unit)?;
            write_text(sheet, HEADINGS, column, &heading, &styles.header)?;
            sheet.set_column_width(column, 15.0)?;
        }
        sheet.set_row_height(HEADINGS, 30)?;
        let (room, part) = (Format::new().set_num_format("0.####"), Format::new().set_num_format("0.0 %"));
        let open = room.clone().set_num_format("\"≥ \"0.####");
        for (row, effect) in (HEADINGS + 1..).zip(self.results.effects) {
            write_text(sheet, row, 0, &effect.symbol, &styles.symbol)?;
            write_text(sheet, row, 2, effect.unit, &styles.unit)?;
            let mut cells: Vec<(ColNum, Option<f64>, &Format)> = vec![(1, effect.value, &room)];
            for ((column, by), ends) in (3..).zip(effect.room.iter().flatten()).zip(effect.open) {
                cells.push((column, Some(*by), if ends { &open } else { &room }));
            }
            cells.extend((5..).zip(effect.ends.iter().flatten()).map(|(column, end)| (column, Some(*end), &room)));
            for (at, (slope, [low, high])) in (0..).zip(effect.slopes.iter().zip(&effect.changes)) {
                let column = BEFORE + at * AROUND;
                cells.extend([(column, *slope), (column + 1, *low), (column + 2, *high)].map(|(c, v)| (c, v, &room)));
            }
            let behind = self.behind();
            if self.results.triples.is_some() {
                for (at, index) in (0..).zip(&effect.indices) {
                    let Some(index) = index else { continue };
                    let values = [index.first, index.off[0], index.total, index.off[1]];
                    cells.extend(
                        (behind + at * OF_INDICES..).zip(values).map(|(column, value)| (column, Some(value), &part)),
                    );
                }
            } else {
                cells.extend((behind..).zip(&effect.shares).map(|(column, share)| (column, *share, &part)));
            }
            for (column, value, format) in cells {
                if let Some(value) = value {
                    sheet.write_number_with_format(row, column, value, format)?;
                }
            }
        }
        self.draw_effects(sheet)?;
        sheet.set_freeze_panes(HEADINGS + 1, 1)?;
        self.page().set_up(sheet, self.language)?;
        Ok(())
    }

    /// The first column behind those around the design of the workbook.
    fn behind(&self) -> ColNum {
        BEFORE + AROUND * ColNum::try_from(self.results.plan.objectives.len()).unwrap_or_default()
    }

    /// The headings with their units.
    fn headings(&self) -> Vec<(String, String)> {
        static INPUTS: [Text; BEFORE as usize] = [
            t("entrada", "input"),
            t("valor", "value"),
            t("unidad", "unit"),
            t("puede bajar", "may go down"),
            t("puede subir", "may go up"),
            t("desde", "from"),
            t("hasta", "to"),
        ];
        static AROUND: [Text; 3] = [t("por unidad", "per unit"), t("en desde", "at from"), t("en hasta", "at to")];
        static INDICES: [Text; 4] = [t("sola", "alone"), t("±", "±"), t("total", "total"), t("±", "±")];
        let mut headings: Vec<(String, String)> =
            INPUTS.iter().map(|one| (self.text(one).to_owned(), String::new())).collect();
        for Objective { measure, .. } in &self.results.plan.objectives {
            let unit = measure.unit.label();
            headings.extend(AROUND.iter().map(|one| (format!("{} {}", measure.key, self.text(one)), unit.to_owned())));
        }
        for Objective { measure, .. } in &self.results.plan.objectives {
            if self.results.triples.is_some() {
                headings
                    .extend(INDICES.iter().map(|one| (format!("{} {}", measure.key, self.text(one)), String::new())));
            } else {
                let share = t("parte de", "share of");
                headings.push((format!("{} {}", self.text(&share), measure.key), String::new()));
            }
        }
        headings
    }

    /// The charts below the table: changes, and indices.
    fn draw_effects(&self, sheet: &mut Worksheet) -> Result<(), WriteError> {
        static CHANGE: Text = t(
            "al llevar cada entrada a un extremo del plan, las demás como en el libro",
            "as each input goes to an end of the plan, the others as in the workbook",
        );
        static SHARE: Text =
            t("qué parte de su varianza explica cada entrada", "which part of its variance each input explains");
        static ENDS: [Text; 2] = [t("desde", "from"), t("hasta", "to")];
        static BOTH: [Text; 2] = [t("sola", "alone"), t("total", "total")];
        let mut row = HEADINGS + 3 + RowNum::try_from(self.results.effects.len()).unwrap_or_default();
        for (at, Objective { measure, .. }) in (0..).zip(&self.results.plan.objectives) {
            let unit = measure.unit.label();
            let axis =
                if unit.is_empty() { format!("Δ {}", measure.key) } else { format!("Δ {} [{unit}]", measure.key) };
            let column = BEFORE + at * AROUND;
            let moves = self.results.effects.iter().any(|one| one.changes.iter().flatten().any(Option::is_some));
            if moves {
                let title = format!("{axis}: {}", self.text(&CHANGE));
                let series = [(&ENDS[0], column + 1), (&ENDS[1], column + 2)];
                sheet.insert_chart(row, 0, &self.bars(&title, &axis, series, 100))?;
                row += CHART_ROWS;
            }
            if self.results.effects.iter().any(|one| one.indices.iter().any(Option::is_some)) {
                let title = format!("{}: {}", measure.key, self.text(&SHARE));
                let column = self.behind() + at * OF_INDICES;
                let series = [(&BOTH[0], column), (&BOTH[1], column + 2)];
                sheet.insert_chart(row, 0, &self.bars(&title, "", series, 0))?;
                row += CHART_ROWS;
            }
        }
        Ok(())
    }

    /// Two bars for each input, the first input on top.
    fn bars(&self, title: &str, axis: &str, series: [(&Text, ColNum); 2], overlap: i8) -> Chart {
        let name = self.text(&SENSITIVITY);
        let (first, last) = (HEADINGS + 1, HEADINGS + RowNum::try_from(self.results.effects.len()).unwrap_or_default());
        let mut chart = Chart::new(ChartType::Bar);
        for ((legend, column), ink) in series.into_iter().zip([DONE, BEST]) {
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
