//! The live part of a form: beside the inputs what follows from them, with red and green, and a view that is drawn anew with
//! every value that is typed. A line beside the title says whether the limits hold.
//!
//! What its formulas come to for the values as they are written is worked out when the form is saved.

use rust_xlsxwriter::{
    Chart, ChartFont, ChartFormat, ChartLayout, ChartLine, ChartLineDashType, ChartMarker, ChartType, ColNum, Color,
    ConditionalFormatFormula, Format, RowNum, Workbook, Worksheet, quote_sheet_name,
};

use super::cell::{uncomputed, write_text};
use super::error::WriteError;
use super::list_sheet;
use super::live_ranges;
use super::style::{Styles, digits};
use crate::kind::live_form::{LiveForm, LiveLook, LiveRow, LiveView, Wrong};
use crate::parameter::list::List;
use crate::parameter::{Form, Sheet};
use crate::text::{Language, Text, t};

/// The hidden sheet of the view.
pub const SHEET: &str = "Plan";
/// The width of the view in pixels.
const WIDTH: u32 = 440;
/// How much of the view's width and height the axes take.
const AXES: [f64; 2] = [0.92, 0.86];
/// How far the view reaches, in half widths of the part.
const REACH: f64 = 1.15;
/// Widths of the columns in characters: symbol, value, unit, words.
const WIDTHS: [f64; 4] = [11.0, 12.0, 7.0, 42.0];

/// The live part on its way to the first sheet of a form.
#[derive(Debug)]
pub struct LivePart<'a> {
    /// What is computed.
    pub form: &'a LiveForm,
    /// The sheet of the form that it stands on.
    pub sheet: &'static Sheet,
    /// Its first column.
    pub column: ColNum,
    /// The language of its words.
    pub language: Language,
}

/// The size of a view in pixels: one scale on both axes.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast keeps within the type's range")]
pub fn size(view: &LiveView) -> [u32; 2] {
    let [across, up] = AXES;
    [WIDTH, (f64::from(WIDTH) * view.height * across / up).round() as u32]
}

impl LiveRow {
    /// The formula that is true where one of its limits is broken; none for a row without limits.
    fn broken(&self) -> Option<String> {
        let all = match self.wrong.as_slice() {
            [] => return None,
            [one] => one.when.to_string(),
            more => format!("OR({})", more.iter().map(|one| one.when.as_ref()).collect::<Vec<_>>().join(",")),
        };
        Some(self.once(&all, "FALSE"))
    }

    /// A formula, where the row waits for the inputs instead of another until they are there.
    fn once(&self, formula: &str, other: &str) -> String {
        if self.always { formula.to_owned() } else { format!("IF(live_ok,{formula},{other})") }
    }

    /// The formula of what is said of it.
    fn words(&self, language: Language) -> String {
        let mut meaning = format!("\"{}\"", self.meaning.get(language));
        if let Some((when, words)) = &self.undecided {
            meaning = format!("IF({when},\"{}\",{meaning})", words.get(language));
        }
        if self.wrong.is_empty() {
            return meaning;
        }
        let first = self
            .wrong
            .iter()
            .rev()
            .fold(meaning.clone(), |rest, one| format!("IF({},\"{}\",{rest})", one.when, one.words.get(language)));
        self.once(&first, &meaning)
    }
}

impl LivePart<'_> {
    /// Writes the line that says whether the limits hold, and what is wrong first, over some columns of a row: beside the title, where it
    /// stays in sight.
    ///
    /// # Errors
    /// For cells outside the sheet.
    pub fn write_line(
        &self,
        sheet: &mut Worksheet,
        row: RowNum,
        [first, last]: [ColNum; 2],
        styles: &Styles,
    ) -> Result<(), WriteError> {
        static HOLD: Text = t(
            "Los límites se cumplen; rodete check comprueba lo demás",
            "The limits hold; rodete check checks the rest",
        );
        static MISSING: Text = t("Faltan datos o no son números: ", "Inputs that are missing or are no numbers: ");
        let language = self.language;
        let mut hold = format!("\"{}\"", HOLD.get(language));
        if let Some((when, words)) = &self.form.undecided {
            hold = format!("IF({when},\"{}\",{hold})", words.get(language));
        }
        let unsound = self
            .form
            .unsound
            .iter()
            .rev()
            .fold("\"\"".to_owned(), |rest, one| format!("IF({},{},{rest})", one.when, self.told(one, "")));
        let formula = format!(
            "IF(live_outside>0,{outside}&IF(live_outside>1,\" (+\"&(live_outside-1)&\")\",\"\"),IF(live_wrong>0,{broken}&IF(live_wrong>1,\" (+\"&(live_wrong-1)&\")\",\"\"),IF(live_missing>0,\"{}\"&live_missing&\" (\"&{missing}&\")\",IF(live_ok,{hold},{unsound}))))",
            MISSING.get(language),
            outside = live_ranges::first_outside(),
            broken = live_ranges::first_broken(),
            missing = live_ranges::first_missing(),
        );
        sheet.merge_range(row, first, row, last, "", &styles.source)?;
        sheet.write_formula_with_format(row, first, uncomputed(&formula), &styles.source)?;
        let rule = |when: &str, format: &Format| {
            ConditionalFormatFormula::new().set_rule(format!("={when}").as_str()).set_format(format.clone())
        };
        let broken = "live_outside+live_wrong+live_missing>0";
        let undecided = self.form.undecided.as_ref().map_or_else(String::new, |(when, _)| format!(",NOT({when})"));
        let holds = format!("AND(live_ok,NOT({broken}){undecided})");
        sheet.add_conditional_format(
            row,
            first,
            row,
            last,
            &rule(&format!("OR(NOT(live_ok),{broken})"), &styles.stale),
        )?;
        sheet.add_conditional_format(row, first, row, last, &rule(&holds, &styles.holds))?;
        Ok(())
    }

    /// Writes the values beside the inputs from the row of the headings on, and the view below them. `inputs`: the inputs' defined
    /// names with their rows. Returns the defined names with their cells.
    ///
    /// # Errors
    /// For cells outside the sheet.
    pub fn write(
        &self,
        sheet: &mut Worksheet,
        first: RowNum,
        inputs: &[(&'static str, RowNum)],
        styles: &Styles,
    ) -> Result<Vec<(String, String)>, WriteError> {
        static HEADINGS: [Text; 4] =
            [t("Valores vivos", "Live"), t("Valor", "Value"), t("Unidad", "Unit"), t("Qué dice", "What it says")];
        let (language, form) = (self.language, self.form);
        for ((column, width), heading) in (self.column..).zip(WIDTHS).zip(&HEADINGS) {
            sheet.set_column_width(column, width)?;
            write_text(sheet, first, column, heading.get(language), &styles.header)?;
        }
        let quoted = quote_sheet_name(self.sheet.name.get(language));
        let letter = rust_xlsxwriter::utility::column_number_to_name(self.column + 1);
        let place = |row: RowNum| format!("={quoted}!${letter}${}", row + 1);
        let mut names = Vec::new();
        let mut row = first;
        for one in &form.rows {
            row += 1;
            write_text(sheet, row, self.column, one.symbol, &styles.symbol)?;
            let number = styles.number.clone().set_num_format(digits(one.unit));
            let formula = one.once(&one.formula, "\"\"");
            sheet.write_formula_with_format(row, self.column + 1, uncomputed(&formula), &number)?;
            write_text(sheet, row, self.column + 2, one.unit.label(), &styles.unit)?;
            sheet.write_formula_with_format(row, self.column + 3, uncomputed(&one.words(language)), &styles.text)?;
            names.push((one.name.to_owned(), place(row)));
            let Some(broken) = one.broken() else { continue };
            // What has no value holds nothing.
            let undecided = one.undecided.as_ref().map_or_else(String::new, |(when, _)| format!(",NOT({when})"));
            let holds = one.once(&format!("AND(LEN({})>0,NOT({broken}){undecided})", one.name), "FALSE");
            for (rule, format) in [(&broken, &styles.stale), (&holds, &styles.holds)] {
                let rule =
                    ConditionalFormatFormula::new().set_rule(format!("={rule}").as_str()).set_format(format.clone());
                sheet.add_conditional_format(row, self.column + 1, row, self.column + 3, &rule)?;
            }
            for wrong in &one.wrong {
                culprit(sheet, inputs, wrong.input, &one.once(&wrong.when, "FALSE"), styles)?;
            }
        }
        for wrong in &form.unsound {
            culprit(sheet, inputs, wrong.input, &format!("IF(live_given,{},FALSE)", wrong.when), styles)?;
        }
        names.extend((1..).zip(self.answers()).map(|(row, (name, _))| (name.to_owned(), live_ranges::answer(row))));
        static NOTHING: Text = t("Nada que dibujar: vea las celdas rojas", "Nothing to draw: see the red cells");
        let told = format!("IF({},\"\",\"{}\")", form.view.drawn, NOTHING.get(language));
        sheet.write_formula_with_format(row + 1, self.column, uncomputed(&told), &styles.source)?;
        let chart = self.chart();
        sheet.insert_chart(row + 2, self.column, &chart)?;
        Ok(names)
    }

    /// What the line says of a broken limit, as a formula: the input that is to be changed with its cell, where there is one; else the
    /// symbol of the row.
    fn told(&self, wrong: &Wrong, symbol: &str) -> String {
        let words = wrong.words.get(self.language);
        let mut own = self.sheet.sections.iter().flat_map(|section| section.parameters);
        match own.find(|one| one.name == wrong.input) {
            Some(input) => format!("{}&\": {words}\"", live_ranges::placed(input, None)),
            None => format!("\"{symbol}: {words}\""),
        }
    }

    /// What the other formulas ask, by defined names, with the formulas that answer.
    fn answers(&self) -> [(&'static str, String); 5] {
        let form = self.form;
        // Not AND: it would compute with what is no number.
        let unsound = form.unsound.iter().map(|one| one.when.as_ref()).collect::<Vec<_>>();
        let sound = match unsound.as_slice() {
            [] => "live_given".to_owned(),
            all => format!("IF(live_given,NOT(OR({})),FALSE)", all.join(",")),
        };
        [
            ("live_given", live_ranges::given(form.inputs.len())),
            ("live_ok", sound),
            ("live_wrong", live_ranges::broken()),
            ("live_outside", live_ranges::outside()),
            ("live_missing", live_ranges::missing()),
        ]
    }

    /// The view: both axes of one scale, without marks.
    fn chart(&self) -> Chart {
        let mut chart = Chart::new(ChartType::ScatterStraight);
        for curve in &self.form.view.curves {
            let (colour, width) = match curve.look {
                LiveLook::Part => (0x1F_4E79, 1.75),
                LiveLook::Dashed => (0x7F_5FA8, 1.0),
                LiveLook::Faint => (0xA0_A0A0, 0.75),
            };
            let mut line = ChartLine::new();
            line.set_color(Color::RGB(colour)).set_width(width);
            if curve.look == LiveLook::Dashed {
                line.set_dash_type(ChartLineDashType::Dash);
            }
            let range = |column: usize| {
                let rows = self.form.view.columns.get(column).map_or(0, Vec::len);
                let at = |count: usize| RowNum::try_from(count).unwrap_or(RowNum::MAX);
                (SHEET, 0, ColNum::try_from(column).unwrap_or(ColNum::MAX), at(rows.saturating_sub(1)))
            };
            let [x, y] = curve.columns.map(range);
            chart
                .add_series()
                .set_categories((x.0, x.1, x.2, x.3, x.2))
                .set_values((y.0, y.1, y.2, y.3, y.2))
                .set_marker(ChartMarker::new().set_none())
                .set_format(ChartFormat::new().set_line(&line));
        }
        // Axes of their own would jump with every value.
        let high = REACH * self.form.view.height;
        chart.x_axis().set_min(-REACH).set_max(REACH).set_hidden(true).set_major_gridlines(false);
        chart.y_axis().set_min(-high).set_max(high).set_hidden(true).set_major_gridlines(false);
        let [across, up] = AXES;
        chart.plot_area().set_layout(&ChartLayout::new().set_offset(0.04, 0.1).set_dimensions(across, up));
        chart.title().set_name(self.form.view.title.get(self.language)).set_font(ChartFont::new().set_size(11));
        chart.legend().set_hidden();
        chart.show_hidden_data();
        let [width, height] = size(&self.form.view);
        chart.set_width(width).set_height(height);
        chart.set_alt_text(self.form.view.title.get(self.language));
        chart
    }

    /// Writes the hidden sheets: the view, and the ranges of the form's numbers.
    ///
    /// # Errors
    /// For more cells than a sheet has.
    pub fn write_hidden(&self, workbook: &mut Workbook, form: &Form) -> Result<(), WriteError> {
        let told = |row: &LiveRow| {
            let first =
                row.wrong.iter().rev().fold("\"\"".to_owned(), |rest, one| {
                    format!("IF({},{},{rest})", one.when, self.told(one, row.symbol))
                });
            Some((row.broken()?, row.once(&first, "\"\"")))
        };
        let broken: Vec<_> = self.form.rows.iter().filter_map(told).collect();
        let answers = self.answers().map(|(_, answer)| answer);
        live_ranges::write(workbook, (form, self.form), &broken, answers, self.language)?;
        let sheet = workbook.add_worksheet().set_name(SHEET)?;
        sheet.set_hidden(true);
        for (column, formulas) in (0..).zip(&self.form.view.columns) {
            for (row, formula) in (0..).zip(formulas) {
                sheet.write_formula(row, column, uncomputed(&self.resolved(formula, form.lists)?))?;
            }
        }
        Ok(())
    }

    /// A formula with the columns of lists in it made ranges.
    fn resolved(&self, formula: &str, lists: &[List]) -> Result<String, WriteError> {
        let mut text = String::with_capacity(formula.len());
        let mut rest = formula;
        while let Some((before, after)) = rest.split_once('[') {
            let lost = || WriteError::Reference(formula.to_owned());
            let (reference, after) = after.split_once(']').ok_or_else(lost)?;
            let range = lists.iter().find_map(|list| list_sheet::cells(list, reference, self.language));
            text.push_str(before);
            text.push_str(&range.ok_or_else(lost)?);
            rest = after;
        }
        text.push_str(rest);
        Ok(text)
    }
}

/// Turns an input red where a formula is true.
fn culprit(
    sheet: &mut Worksheet,
    inputs: &[(&'static str, RowNum)],
    input: &str,
    when: &str,
    styles: &Styles,
) -> Result<(), WriteError> {
    let Some((_, row)) = inputs.iter().find(|(name, _)| *name == input) else { return Ok(()) };
    let rule = format!("={when}");
    let rule = ConditionalFormatFormula::new().set_rule(rule.as_str()).set_format(styles.stale.clone());
    sheet.add_conditional_format(*row, 2, *row, 2, &rule)?;
    Ok(())
}
