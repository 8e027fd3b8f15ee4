//! One row of a form: from its value cell and its unit cell to a checked value, or to what is wrong with it.

use crate::escape::excerpt;
use crate::finding::{Finding, Place, Raise, Typed};
use crate::limits::EXCERPT;
use crate::number::decimal;
use crate::parameter::{Choice, FieldKind, Parameter, Value};
use crate::text::{Text, t};

use super::address::{self, Position};
use super::calendar;
use super::limits;
use super::rules::value::*;
use super::sheet_cells::{Content, SheetCells};
use super::typed_number;
use super::{unit, words};

/// Most characters of machine codes.
const CODES: usize = 200;
/// Most characters of a date.
pub const DATE: usize = 40;

/// Reads the value of a parameter from a row; what is wrong with it goes to `findings`. `None` where it is empty or
/// wrong.
pub fn read(parameter: &'static Parameter, sheet: &SheetCells, row: u32, findings: &mut Vec<Finding>) -> Option<Value> {
    let mut reader = CellReader { parameter, sheet, at: (row, sheet.columns.value), findings };
    let value = reader.value();
    if is_filled(sheet, row) {
        reader.unit();
    }
    value
}

/// Reads the value of a parameter from any cell, without a unit cell beside it; otherwise as [`read`].
pub fn read_at(
    parameter: &'static Parameter,
    sheet: &SheetCells,
    at: Position,
    findings: &mut Vec<Finding>,
) -> Option<Value> {
    CellReader { parameter, sheet, at, findings }.value()
}

/// True where the value cell of a row holds anything, right or wrong.
#[must_use]
pub fn is_filled(sheet: &SheetCells, row: u32) -> bool {
    holds(sheet, (row, sheet.columns.value))
}

/// True where a cell holds anything, right or wrong.
#[must_use]
pub fn holds(sheet: &SheetCells, at: Position) -> bool {
    sheet.cell(at).is_some() || sheet.survey.uncalculated.contains(&at) || sheet.survey.judged.contains(&at)
}

/// A parameter's symbol and meaning, as a sentence begins with it.
#[must_use]
pub fn named(parameter: &Parameter) -> Text {
    let (symbol, meaning) = (parameter.symbol(), &parameter.meaning);
    Text::new(format!("{symbol} ({})", meaning.es), format!("{symbol} ({})", meaning.en))
}

/// What may stand in a value cell, as the object of "write".
#[must_use]
pub fn expected(parameter: &Parameter) -> Text {
    match &parameter.kind {
        FieldKind::Real { min, max } => {
            let (min, max) = (decimal(*min), unit::with(*max, parameter.unit));
            Text::new(format!("un número de {min} a {max}"), format!("a number from {min} to {max}"))
        }
        FieldKind::Whole { min, max } => {
            Text::new(format!("un número entero de {min} a {max}"), format!("a whole number from {min} to {max}"))
        }
        FieldKind::Choice(choices) => {
            let list = |pick: fn(&Choice) -> &str| choices.iter().map(pick).collect::<Vec<_>>().join(", ");
            let (es, en) = (list(|choice| &choice.label.es), list(|choice| &choice.label.en));
            Text::new(format!("una de estas palabras: {es}"), format!("one of: {en}"))
        }
        FieldKind::Line { max } => {
            Text::new(format!("un texto de hasta {max} caracteres"), format!("a text of up to {max} characters"))
        }
        FieldKind::Date => t("una fecha, como 2026-11-23", "a date, such as 2026-11-23"),
        FieldKind::Codes => {
            t("códigos M con número entero, separados por espacios", "M codes with whole numbers, separated by blanks")
        }
        FieldKind::Block => t(
            "un bloque que retira la herramienta, como G0 G53 Z0",
            "a block that takes the tool away, such as G0 G53 Z0",
        ),
        FieldKind::Schema => t("el esquema del libro", "the schema of the workbook"),
    }
}

/// The limits of a parameter, for the finding's own field; empty where there are none.
fn range(parameter: &Parameter) -> String {
    match &parameter.kind {
        FieldKind::Real { min, max } => format!("{} … {}", decimal(*min), unit::with(*max, parameter.unit)),
        FieldKind::Whole { min, max } => format!("{min} … {max}"),
        _ => String::new(),
    }
}

struct CellReader<'a> {
    parameter: &'static Parameter,
    sheet: &'a SheetCells,
    at: Position,
    findings: &'a mut Vec<Finding>,
}

impl CellReader<'_> {
    fn value(&mut self) -> Option<Value> {
        let sheet = self.sheet;
        if sheet.survey.judged.contains(&self.at) {
            return None;
        }
        let (name, cell) = (named(self.parameter), address::format(self.at));
        let expected = || expected(self.parameter);
        let row: Box<dyn Raise> = if let Some(range) = sheet.survey.covering(self.at) {
            let (range, corner) = (range.address(), address::format(range.start));
            Box::new(InsideMergedCells { name, range, corner, cell })
        } else if sheet.survey.uncalculated.contains(&self.at) {
            Box::new(FormulaNotCalculated { name, cell })
        } else {
            match sheet.cell(self.at).map(|held| (&held.content, held.percent)) {
                None if !self.parameter.required => return None,
                None => Box::new(ValueMissing { name, cell, expected: expected() }),
                Some((Content::Error(error), _)) => {
                    Box::new(ValueIsError { name, error: excerpt(error, EXCERPT), cell, expected: expected() })
                }
                Some((Content::Truth(truth), _)) => {
                    let truth = if *truth { t("VERDADERO", "TRUE") } else { t("FALSO", "FALSE") };
                    Box::new(ValueIsTruth { name, truth, cell, expected: expected() })
                }
                Some((Content::Date(day, number), _))
                    if matches!(self.parameter.kind, FieldKind::Date) && !day.is_empty() =>
                {
                    // Excel has a 29th of February 1900.
                    if calendar::never(day) || number.is_some() && !calendar::is_day_in_full(day) {
                        self.stop(&NoSuchDay { name, text: excerpt(day, EXCERPT), cell }, excerpt(day, EXCERPT));
                        return None;
                    }
                    return self.line(day, day.chars().count(), DATE);
                }
                Some((Content::Date(..), _)) => Box::new(ValueIsDate { name, cell }),
                Some((Content::Number(number), percent)) => return self.number(*number, percent),
                Some((Content::Text(text, characters), _)) => return self.text(text.trim_matches(' '), *characters),
            }
        };
        self.stop(&*row, String::new());
        None
    }

    fn number(&mut self, number: f64, percent: bool) -> Option<Value> {
        // -0 becomes 0.
        let number = number + 0.0;
        let unit = self.parameter.unit;
        match &self.parameter.kind {
            FieldKind::Real { min, max } => {
                if !(*min <= number && number <= *max) {
                    self.outside(number, [*min, *max], unit::meant(number, unit, *min, *max));
                    return None;
                }
                if percent {
                    self.percentage(number);
                }
                if let Some(degrees) = unit::likely_radians(number, unit) {
                    self.caution(&LikelyRadians { name: named(self.parameter), angle: number, degrees });
                }
                Some(Value::Real(number))
            }
            FieldKind::Whole { min, max } => {
                if number.fract() != 0.0 {
                    let (name, value) = (named(self.parameter), Typed { value: number, unit: "" });
                    let (cell, expected) = (address::format(self.at), expected(self.parameter));
                    self.stop(&NotWhole { name, value, cell, expected }, decimal(number));
                    return None;
                }
                let whole = decimal(number).parse::<u32>().ok().filter(|whole| min <= whole && whole <= max);
                if whole.is_none() {
                    self.outside(number, [f64::from(*min), f64::from(*max)], None);
                } else if percent {
                    self.percentage(number);
                }
                whole.map(Value::Whole)
            }
            // A part number, a material number: Excel makes numbers of them.
            FieldKind::Line { .. } | FieldKind::Date | FieldKind::Choice(_) | FieldKind::Codes | FieldKind::Block => {
                let text = decimal(number);
                self.text(&text, text.chars().count())
            }
            FieldKind::Schema => None,
        }
    }

    fn text(&mut self, typed: &str, characters: usize) -> Option<Value> {
        let text = typed.trim();
        let (name, shown) = (named(self.parameter), excerpt(text, EXCERPT));
        match &self.parameter.kind {
            FieldKind::Real { .. } | FieldKind::Whole { .. } => {
                let row = typed_number::told(name, text, shown.clone(), self.parameter.unit, &self.parameter.kind);
                self.stop(&*row, shown);
                None
            }
            FieldKind::Choice(choices) => self.choice(choices, typed),
            FieldKind::Line { max } => self.line(text, characters, *max),
            FieldKind::Date if calendar::never(text) => {
                self.stop(&NoSuchDay { name, text: shown.clone(), cell: address::format(self.at) }, shown);
                None
            }
            FieldKind::Date => self.line(text, characters, DATE),
            FieldKind::Codes => self.codes(text, characters, words::codes(text)),
            FieldKind::Block => self.codes(text, characters, words::block(text)),
            FieldKind::Schema => None,
        }
    }

    fn line(&mut self, text: &str, characters: usize, most: usize) -> Option<Value> {
        if characters > most {
            self.long(characters, most);
            return None;
        }
        if crate::escape::printable(text) != text {
            self.caution(&HiddenCharacters { name: named(self.parameter), text: excerpt(text, EXCERPT) });
        }
        Some(Value::Line(text.to_owned()))
    }

    /// The choice of a word. The formulas of a workbook drop plain blanks around it and no others, such as the one that does
    /// not break a line: they would take another value than what is read here.
    fn choice(&mut self, choices: &'static [Choice], typed: &str) -> Option<Value> {
        let text = typed.trim();
        let odd = typed.chars().find(|one| one.is_whitespace() && *one != ' ');
        let near = match (words::choose(choices, text), odd) {
            (Ok(key), None) => return Some(Value::Choice(key)),
            (Ok(_), Some(odd)) => {
                let (name, cell) = (named(self.parameter), address::format(self.at));
                let (text, character) = (excerpt(text, EXCERPT), format!("U+{:04X}", u32::from(odd)));
                self.stop(&ChoiceWithOddBlank { name, text: text.clone(), character, cell }, text);
                return None;
            }
            (Err(near), _) => near,
        };
        let (name, text, choices) = (named(self.parameter), excerpt(text, EXCERPT), expected(self.parameter));
        let value = text.clone();
        match near {
            Some(label) => self.stop(&ChoiceMisspelt { name, text, choices, label: label.clone() }, value),
            None => self.stop(&NoSuchChoice { name, text, choices, cell: address::format(self.at) }, value),
        }
        None
    }

    fn codes(&mut self, text: &str, characters: usize, read: Result<String, String>) -> Option<Value> {
        if characters > CODES {
            self.long(characters, CODES);
            return None;
        }
        let wrong = match read {
            Ok(codes) => return Some(Value::Line(codes)),
            Err(wrong) => excerpt(&wrong, EXCERPT),
        };
        let (name, value) = (named(self.parameter), excerpt(text, EXCERPT));
        let (cell, expected) = (address::format(self.at), expected(self.parameter));
        if matches!(self.parameter.kind, FieldKind::Block) {
            self.stop(&WrongBlock { name, wrong, cell, expected }, value);
        } else {
            self.stop(&WrongCode { name, wrong, cell, expected }, value);
        }
        None
    }

    /// Compares the unit cell with the unit the parameter has.
    fn unit(&mut self) {
        let at = (self.at.0, self.sheet.columns.unit);
        let written = match self.sheet.cell(at).map(|held| &held.content) {
            None => String::new(),
            Some(Content::Text(text, _)) => text.trim().to_owned(),
            Some(Content::Number(number)) => decimal(*number),
            Some(Content::Truth(_) | Content::Date(..) | Content::Error(_)) => "?".to_owned(),
        };
        let unit = self.parameter.unit;
        if unit::says(unit, &written) {
            return;
        }
        let (written, label, cell) = (excerpt(&written, EXCERPT), unit.label(), address::format(at));
        let (name, place) = (named(self.parameter), Place::Cells(vec![self.sheet.place(at)]));
        let finding = if written.is_empty() {
            // A label or a value merged over it hides it, and was not typed in its place.
            if self.sheet.survey.covering(at).is_some() {
                return;
            }
            UnitNotSaid { name, cell, unit: label }.at(place).with("", label)
        } else if !matches!(self.parameter.kind, FieldKind::Real { .. } | FieldKind::Whole { .. }) {
            UnitNotRead { name, written }.at(place)
        } else if label.is_empty() {
            UnitWhereNone { name, written: written.clone(), cell }.at(place).with(written, label)
        } else {
            OtherUnit { name, unit: label, written: written.clone(), cell }.at(place).with(written, label)
        };
        self.findings.push(finding);
    }

    fn percentage(&mut self, number: f64) {
        // Shown as the spreadsheet shows it, without the product's rounding.
        let read = Typed { value: number, unit: "" };
        let shown = Typed { value: (number * 1e8).round() / 1e6, unit: "%" };
        self.caution(&Percentage { name: named(self.parameter), read, shown });
    }

    fn long(&mut self, characters: usize, most: usize) {
        let counted = if characters > limits::CELL_TEXT {
            let cell = limits::CELL_TEXT;
            Text::new(format!("más de {cell}"), format!("more than {cell}"))
        } else {
            Text::same(characters.to_string())
        };
        self.stop(&TextTooLong { name: named(self.parameter), counted, most }, characters.to_string());
    }

    /// A number beyond its limits, and what it is in the unit that it was probably typed in.
    fn outside(&mut self, number: f64, [min, max]: [f64; 2], meant: Option<Text>) {
        let (name, unit) = (named(self.parameter), self.parameter.unit);
        let value = Typed { value: number, unit: unit.label() };
        let whole = matches!(self.parameter.kind, FieldKind::Whole { .. });
        let max = Typed { value: max, unit: if whole { "" } else { unit.label() } };
        let min = Typed { value: min, unit: "" };
        let shown = unit::with(number, unit);
        match meant {
            Some(meant) => self.stop(&LikelyOtherUnit { name, value, min, max, meant }, shown),
            None => {
                let (cell, expected) = (address::format(self.at), expected(self.parameter));
                self.stop(&OutOfLimits { name, value, min, max, cell, expected }, shown);
            }
        }
    }

    /// A stop, with the value found.
    fn stop(&mut self, row: &dyn Raise, value: String) {
        self.findings.push(row.at(self.place()).with(value, range(self.parameter)));
    }

    fn caution(&mut self, row: &dyn Raise) {
        self.findings.push(row.at(self.place()));
    }

    fn place(&self) -> Place {
        Place::Cells(vec![self.sheet.place(self.at)])
    }
}
