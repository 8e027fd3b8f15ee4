//! One row of a form: from its value cell and its unit cell to a checked value, or to what is wrong with it.

use crate::escape::excerpt;
use crate::finding::{Finding, Place};
use crate::parameter::{Choice, FieldKind, Parameter, Value};
use crate::table::Unit;
use crate::text::Text;

use super::address::{self, Position};
use super::limits;
use super::sheet_cells::{Content, SheetCells};
use super::typed_number::{self, decimal};
use super::{unit, words};

/// The column of the values, C.
pub const VALUE: u32 = 2;
/// The column of the units, D.
const UNIT: u32 = 3;
/// Most characters of machine codes.
const CODES: usize = 200;
/// What codes must be.
const CODE: [&str; 2] =
    ["un código de máquina (G o M y un número entero)", "a machine code (G or M and a whole number)"];
/// What the words of a block that takes the tool away must be.
const BLOCK: [&str; 2] = [
    "un código o X, Y, Z con su número, por este orden: G, ejes, M; aquí no gira nada",
    "a code or X, Y, Z with its number, in this order: G, axes, M; nothing turns here",
];
/// Characters of a cell's text shown in a message.
const SHOWN: usize = 40;

/// Reads the value of a parameter from a row; what is wrong with it goes to `findings`. `None` where it is empty or
/// wrong.
pub fn read(parameter: &'static Parameter, sheet: &SheetCells, row: u32, findings: &mut Vec<Finding>) -> Option<Value> {
    let mut reading = Reading { parameter, sheet, at: (row, VALUE), findings };
    let value = reading.value();
    if is_filled(sheet, row) {
        reading.unit();
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
    Reading { parameter, sheet, at, findings }.value()
}

/// True where the value cell of a row holds anything, right or wrong.
#[must_use]
pub fn is_filled(sheet: &SheetCells, row: u32) -> bool {
    holds(sheet, (row, VALUE))
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
            say!("un número de {min} a {max}", "a number from {min} to {max}")
        }
        FieldKind::Whole { min, max } => {
            say!("un número entero de {min} a {max}", "a whole number from {min} to {max}")
        }
        FieldKind::Choice(choices) => {
            let list = |pick: fn(&Choice) -> &str| choices.iter().map(pick).collect::<Vec<_>>().join(", ");
            let (es, en) = (list(|choice| &choice.label.es), list(|choice| &choice.label.en));
            say!("una de estas palabras: {es}", "one of: {en}")
        }
        FieldKind::Line { max } => say!("un texto de hasta {max} caracteres", "a text of up to {max} characters"),
        FieldKind::Codes => Text::fixed("códigos de máquina, como M3 M11 M13", "machine codes, such as M3 M11 M13"),
        FieldKind::Block => Text::fixed(
            "un bloque que retira la herramienta, como G0 G53 Z0",
            "a block that takes the tool away, such as G0 G53 Z0",
        ),
        FieldKind::Schema => Text::fixed("el esquema del libro", "the schema of the workbook"),
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

struct Reading<'a> {
    parameter: &'static Parameter,
    sheet: &'a SheetCells,
    at: Position,
    findings: &'a mut Vec<Finding>,
}

impl Reading<'_> {
    fn value(&mut self) -> Option<Value> {
        let (sheet, cell) = (self.sheet, address::format(self.at));
        if sheet.survey.judged.contains(&self.at) {
            return None;
        }
        if let Some(range) = sheet.survey.covering(self.at) {
            let (range, corner) = (range.address(), address::format(range.start));
            self.stop(
                say!(
                    ": su celda está dentro de las celdas combinadas {range}, cuyo valor está en {corner}",
                    ": its cell lies inside the merged cells {range}, whose value stands in {corner}"
                ),
                say!(
                    "separe las celdas {range} y escriba el valor en {cell}",
                    "unmerge {range} and write the value in {cell}"
                ),
            );
            return None;
        }
        if sheet.survey.uncalculated.contains(&self.at) {
            self.stop(
                say!(
                    ": {cell} tiene una fórmula sin valor guardado",
                    ": {cell} holds a formula without a stored value"
                ),
                Text::fixed(
                    "abra el libro en Excel o LibreOffice y guárdelo",
                    "open the workbook in Excel or LibreOffice and save it",
                ),
            );
            return None;
        }
        let Some(held) = sheet.cell(self.at) else {
            if self.parameter.required {
                let remedy = self.write();
                self.stop(Text::fixed(" falta", " is missing"), remedy);
            }
            return None;
        };
        match &held.content {
            Content::Error(error) => {
                let error = excerpt(error, SHOWN);
                let remedy = self.write();
                self.stop(say!(" es el error {error}", " is the error {error}"), remedy);
                None
            }
            Content::Truth(truth) => {
                let (es, en) = if *truth { ("VERDADERO", "TRUE") } else { ("FALSO", "FALSE") };
                let remedy = self.write();
                self.stop(say!(" es el valor lógico {es}", " is the truth value {en}"), remedy);
                None
            }
            Content::Date => {
                self.stop(
                    Text::fixed(": su celda tiene formato de fecha", ": its cell is formatted as a date"),
                    say!(
                        "dé a {cell} formato General y escriba de nuevo el valor",
                        "set the format of {cell} to General and type the value again"
                    ),
                );
                None
            }
            Content::Number(number) => self.number(*number, held.percent),
            Content::Text(text, characters) => self.text(text.trim(), *characters),
        }
    }

    fn number(&mut self, number: f64, percent: bool) -> Option<Value> {
        // -0 becomes 0.
        let number = number + 0.0;
        let unit = self.parameter.unit;
        match &self.parameter.kind {
            FieldKind::Real { min, max } => {
                if !(*min <= number && number <= *max) {
                    let remedy = unit::meant(number, unit, *min, *max).unwrap_or_else(|| self.write());
                    self.outside(number, remedy);
                    return None;
                }
                if percent {
                    self.percentage(number);
                }
                if let Some(degrees) = unit::likely_radians(number, unit) {
                    self.caution(
                        say!(
                            " es {number}°, muy poco para un ángulo en grados",
                            " is {number}°, very little for an angle in degrees"
                        ),
                        say!(
                            "si {number} son radianes, escriba {degrees}",
                            "if {number} is in radians, write {degrees}"
                        ),
                    );
                }
                Some(Value::Real(number))
            }
            FieldKind::Whole { min, max } => {
                if number.fract() != 0.0 {
                    let shown = decimal(number);
                    let remedy = self.write();
                    self.stop_with(
                        say!(" es {shown} y debe ser un número entero", " is {shown}, must be a whole number"),
                        shown,
                        remedy,
                    );
                    return None;
                }
                let whole = decimal(number).parse::<u32>().ok().filter(|whole| min <= whole && whole <= max);
                if whole.is_none() {
                    let remedy = self.write();
                    self.outside(number, remedy);
                } else if percent {
                    self.percentage(number);
                }
                whole.map(Value::Whole)
            }
            // A part number, a material number: Excel makes numbers of them.
            FieldKind::Line { .. } | FieldKind::Choice(_) | FieldKind::Codes | FieldKind::Block => {
                let text = decimal(number);
                self.text(&text, text.chars().count())
            }
            FieldKind::Schema => None,
        }
    }

    fn text(&mut self, text: &str, characters: usize) -> Option<Value> {
        let shown = excerpt(text, SHOWN);
        match &self.parameter.kind {
            FieldKind::Real { .. } | FieldKind::Whole { .. } => {
                let remedy = typed_number::hint(text, self.parameter.unit.label());
                self.stop_with(
                    say!(" es el texto \"{shown}\", no un número", " is the text \"{shown}\", not a number"),
                    shown,
                    remedy,
                );
                None
            }
            FieldKind::Choice(choices) => self.choice(choices, text),
            FieldKind::Line { max } => {
                if characters > *max {
                    self.long(characters, *max);
                    return None;
                }
                if crate::escape::printable(text) != text {
                    self.caution(
                        say!(
                            " lleva caracteres que no se ven: \"{shown}\"",
                            " has characters that are not seen: \"{shown}\""
                        ),
                        Text::fixed("escríbalo de nuevo sin ellos", "type it again without them"),
                    );
                }
                Some(Value::Line(text.to_owned()))
            }
            FieldKind::Codes => self.codes(text, characters, words::codes(text), CODE),
            FieldKind::Block => self.codes(text, characters, words::block(text), BLOCK),
            FieldKind::Schema => None,
        }
    }

    fn choice(&mut self, choices: &'static [Choice], text: &str) -> Option<Value> {
        let near = match words::choose(choices, text) {
            Ok(key) => return Some(Value::Choice(key)),
            Err(near) => near,
        };
        let remedy = match near {
            Some(label) => say!("¿quiere decir {label}?", "did you mean {label}?", label = label),
            None => self.write(),
        };
        let (shown, list) = (excerpt(text, SHOWN), expected(self.parameter));
        self.stop_with(
            Text::new(
                format!(" es \"{shown}\" y debe ser {}", list.es),
                format!(" is \"{shown}\", must be {}", list.en),
            ),
            shown,
            remedy,
        );
        None
    }

    fn codes(
        &mut self,
        text: &str,
        characters: usize,
        read: Result<String, String>,
        [es, en]: [&str; 2],
    ) -> Option<Value> {
        if characters > CODES {
            self.long(characters, CODES);
            return None;
        }
        match read {
            Ok(codes) => Some(Value::Line(codes)),
            Err(wrong) => {
                let wrong = excerpt(&wrong, SHOWN);
                let remedy = self.write();
                self.stop_with(
                    say!(" lleva \"{wrong}\", que no es {es}", " has \"{wrong}\", which is not {en}"),
                    excerpt(text, SHOWN),
                    remedy,
                );
                None
            }
        }
    }

    /// Compares the unit cell with the unit the parameter has.
    fn unit(&mut self) {
        let at = (self.at.0, UNIT);
        let written = match self.sheet.cell(at).map(|held| &held.content) {
            None => String::new(),
            Some(Content::Text(text, _)) => text.trim().to_owned(),
            Some(Content::Number(number)) => decimal(*number),
            Some(Content::Truth(_) | Content::Date | Content::Error(_)) => "?".to_owned(),
        };
        let unit = self.parameter.unit;
        if unit::says(unit, &written) {
            return;
        }
        let (written, label, cell) = (excerpt(&written, SHOWN), unit.label(), address::format(at));
        if written.is_empty() {
            // A label or a value merged over it hides it, and was not typed in its place.
            if self.sheet.survey.covering(at).is_some() {
                return;
            }
            let what = say!(
                ": la celda {cell} no dice su unidad; se da en {label}",
                ": cell {cell} does not say its unit; it is given in {label}"
            );
            let remedy = say!(
                "compruebe que el valor está en {label} y escriba {label} en {cell}",
                "check that the value is in {label} and write {label} in {cell}"
            );
            let place = Place::Cells(vec![self.sheet.place(at)]);
            self.findings.push(Finding::stop(place, join(&named(self.parameter), &what), remedy).with("", label));
            return;
        }
        let place = Place::Cells(vec![self.sheet.place(at)]);
        let name = named(self.parameter);
        let finding = if matches!(self.parameter.kind, FieldKind::Real { .. } | FieldKind::Whole { .. }) {
            let what = if unit == Unit::None || label.is_empty() {
                say!(
                    " no tiene unidad y su celda de unidad dice \"{written}\"",
                    " has no unit, and its unit cell says \"{written}\""
                )
            } else {
                say!(
                    " se da en {label} y su celda de unidad dice \"{written}\"",
                    " is given in {label}, and its unit cell says \"{written}\""
                )
            };
            let remedy = if label.is_empty() {
                say!("vacíe la celda {cell}", "empty cell {cell}")
            } else {
                say!(
                    "convierta el valor a {label} y escriba {label} en {cell}",
                    "convert the value to {label} and write {label} in {cell}"
                )
            };
            Finding::stop(place, join(&name, &what), remedy).with(written, label)
        } else {
            Finding::note(
                place,
                join(
                    &name,
                    &say!(" no tiene unidad; \"{written}\" no se lee", " has no unit; \"{written}\" is not read"),
                ),
            )
        };
        self.findings.push(finding);
    }

    fn percentage(&mut self, number: f64) {
        // Shown as the spreadsheet shows it, without the product's rounding.
        let (stored, shown) = (decimal(number), decimal((number * 1e8).round() / 1e6));
        self.caution(
            say!(
                " está en una celda con formato de porcentaje: se lee {stored}, y la hoja muestra {shown} %",
                " stands in a cell formatted as a percentage: {stored} is read, and the sheet shows {shown} %"
            ),
            Text::fixed(
                "dé a la celda formato General y compruebe el valor",
                "set its format to General and check the value",
            ),
        );
    }

    fn long(&mut self, characters: usize, most: usize) {
        let counted = if characters > limits::CELL_TEXT {
            let cell = limits::CELL_TEXT;
            say!("más de {cell}", "more than {cell}")
        } else {
            Text::same(characters.to_string())
        };
        self.stop_with(
            say!(" tiene {counted} caracteres", " is {counted} characters long", counted = counted),
            characters.to_string(),
            say!("acórtelo a {most} caracteres", "shorten it to {most} characters"),
        );
    }

    fn outside(&mut self, number: f64, remedy: Text) {
        let value = unit::with(number, self.parameter.unit);
        let (min, max) = match &self.parameter.kind {
            FieldKind::Real { min, max } => (decimal(*min), unit::with(*max, self.parameter.unit)),
            FieldKind::Whole { min, max } => (min.to_string(), max.to_string()),
            _ => return,
        };
        self.stop_with(
            say!(" es {value} y debe estar entre {min} y {max}", " is {value}, must be from {min} to {max}"),
            value.clone(),
            remedy,
        );
    }

    /// The remedy that says what to write and where.
    fn write(&self) -> Text {
        let (expected, cell) = (expected(self.parameter), address::format(self.at));
        Text::new(format!("escriba en {cell} {}", expected.es), format!("write {} in {cell}", expected.en))
    }

    fn stop(&mut self, what: Text, remedy: Text) {
        self.stop_with(what, String::new(), remedy);
    }

    fn stop_with(&mut self, what: Text, value: String, remedy: Text) {
        let finding = Finding::stop(self.place(), join(&named(self.parameter), &what), remedy);
        self.findings.push(finding.with(value, range(self.parameter)));
    }

    fn caution(&mut self, what: Text, remedy: Text) {
        let finding = Finding::caution(self.place(), join(&named(self.parameter), &what), remedy);
        self.findings.push(finding);
    }

    fn place(&self) -> Place {
        Place::Cells(vec![self.sheet.place(self.at)])
    }
}

fn join(start: &Text, end: &Text) -> Text {
    Text::new(format!("{}{}", start.es, end.es), format!("{}{}", start.en, end.en))
}
