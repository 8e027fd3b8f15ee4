//! The sheet of work offsets: one row for each coordinate system and one for G92, one column for each axis.
//!
//! The same sheet is written from a var file, edited, and read back with [`offsets_table`](super::offsets_table).

use std::io::{Seek, Write};

use rust_xlsxwriter::{ColNum, ProtectionOptions, RowNum, Workbook, Worksheet};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::page::{Page, properties};
use super::save::{Additions, save};
use super::style::Styles;
use super::validation::validation;
use crate::gcode::offset_preamble::value;
use crate::machine::axis::Axis;
use crate::machine::length_unit::LengthUnit;
use crate::machine::offset_edit::{GREATEST_ROTATION, greatest};
use crate::machine::var_file::VarFile;
use crate::machine::work_offset::{G92_FIRST, Offsets, System};
use crate::parameter::field::{Chosen, Typed};
use crate::parameter::{FieldKind, Parameter};
use crate::table::Unit;
use crate::text::{Language, Text, t};

/// The sheet's name.
pub static NAME: Text = t("ORIGENES", "OFFSETS");
/// Name and version of the sheet's form.
pub const SCHEMA: &str = "rodete-offsets 1";
/// What stands before the schema.
pub static SCHEMA_LABEL: Text = t("esquema", "schema");
/// The heading of the rows' names.
pub static SYSTEM: Text = t("Sistema", "System");
/// The name of the row of G92's registers.
pub const G92: &str = "G92";
/// The key of the choice that marks the active system.
pub const YES: &str = "yes";

static TITLE: Text = t("Decalajes de origen", "Work offsets");
static HOW: Text = t(
    "Escriba solo en las celdas amarillas; al seleccionar una se ve qué admite. Una celda sin desplazamiento lleva un 0. \
     Activo es sí en el sistema que rige tras el arranque; en la fila G92, si G92 está en vigor.",
    "Write only in the yellow cells; selecting one shows what it admits. A cell without an offset holds a 0. Active is \
     yes for the system that is active after a start; in row G92, if G92 is in force.",
);

const fn real(key: &'static str, meaning: Text, most: f64) -> Parameter {
    Parameter {
        key,
        name: "",
        meaning,
        // The units stand in a row of their own.
        unit: Unit::None,
        kind: FieldKind::Real { min: -most, max: most },
        required: true,
        read: true,
        admits: f64::admits,
        note: t("", ""),
        given_by: None,
    }
}

/// The columns of lengths and angles: nine axes and the rotation.
const fn numbers(unit: LengthUnit) -> [Parameter; 10] {
    const fn axis(key: &'static str, axis: Axis, unit: LengthUnit) -> Parameter {
        let meaning = match unit {
            _ if axis.rotary() => t("eje giratorio, °", "rotary axis, °"),
            LengthUnit::Inch => t("eje lineal, in", "linear axis, in"),
            LengthUnit::Millimetre => t("eje lineal, mm", "linear axis, mm"),
        };
        real(key, meaning, greatest(axis, unit))
    }
    [
        axis("X", Axis::X, unit),
        axis("Y", Axis::Y, unit),
        axis("Z", Axis::Z, unit),
        axis("A", Axis::A, unit),
        axis("B", Axis::B, unit),
        axis("C", Axis::C, unit),
        axis("U", Axis::U, unit),
        axis("V", Axis::V, unit),
        axis("W", Axis::W, unit),
        real("R", t("giro alrededor de Z, °", "rotation about Z, °"), GREATEST_ROTATION),
    ]
}

static MILLIMETRES: [Parameter; 10] = numbers(LengthUnit::Millimetre);
static INCHES: [Parameter; 10] = numbers(LengthUnit::Inch);
static MARKS: [Parameter; 2] = [mark("Activo"), mark("Active")];

const fn mark(key: &'static str) -> Parameter {
    Parameter {
        key,
        name: "",
        meaning: t("sistema activo; G92 en vigor", "active system; G92 in force"),
        unit: Unit::None,
        kind: FieldKind::Choice(bool::CHOICES),
        required: false,
        read: true,
        admits: bool::admits,
        note: t("", ""),
        given_by: None,
    }
}

/// A column of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// The origins along an axis, in the machine's unit of length or in degrees.
    Axis(Axis),
    /// The rotation about Z.
    Rotation,
    /// The mark of the active system, and of G92 in force.
    Active,
}

impl Column {
    /// All of them, in order from column B on.
    pub fn all() -> impl Iterator<Item = Self> {
        Axis::ALL.into_iter().map(Self::Axis).chain([Self::Rotation, Self::Active])
    }

    /// What may stand in its cells; its symbol is the column's heading.
    #[must_use]
    pub fn parameter(self, unit: LengthUnit, language: Language) -> &'static Parameter {
        let numbers = match unit {
            LengthUnit::Millimetre => &MILLIMETRES,
            LengthUnit::Inch => &INCHES,
        };
        match self {
            Self::Axis(axis) => &numbers[axis as usize],
            Self::Rotation => &numbers[9],
            Self::Active => &MARKS[usize::from(language == Language::En)],
        }
    }

    /// The unit of its values.
    #[must_use]
    pub const fn unit(self, unit: LengthUnit) -> &'static str {
        match self {
            Self::Axis(axis) if !axis.rotary() => unit.symbol(),
            Self::Axis(_) | Self::Rotation => "°",
            Self::Active => "",
        }
    }

    const fn width(self) -> f64 {
        match self {
            Self::Axis(_) => 13.0,
            Self::Rotation => 11.0,
            Self::Active => 9.0,
        }
    }
}

/// Column A.
const NAMES: ColNum = 0;
const NAMES_WIDTH: f64 = 11.0;

/// Writes a workbook with the offsets of a var file, ready to be edited. `origin` is the file's name, for the foot of
/// the page. The same input gives the same bytes.
///
/// # Errors
/// For what `out` refuses.
pub fn write<W: Write + Seek + Send>(
    file: &VarFile,
    unit: LengthUnit,
    origin: &str,
    language: Language,
    out: W,
) -> Result<(), WriteError> {
    let mut workbook = Workbook::new();
    workbook.set_properties(&properties(TITLE.get(language))?);
    let sheet = workbook.add_worksheet();
    OffsetsSheet { file, unit, origin, language, styles: Styles::default() }.write(sheet)?;
    save(&mut workbook, Additions::default(), out)
}

struct OffsetsSheet<'a> {
    file: &'a VarFile,
    unit: LengthUnit,
    origin: &'a str,
    language: Language,
    styles: Styles,
}

impl OffsetsSheet<'_> {
    fn write(&self, sheet: &mut Worksheet) -> Result<(), WriteError> {
        sheet.set_name(NAME.get(self.language))?;
        sheet.set_column_width(NAMES, NAMES_WIDTH)?;
        let (mut last, mut across) = (NAMES, NAMES_WIDTH);
        for (at, column) in (1..).zip(Column::all()) {
            sheet.set_column_width(at, column.width())?;
            (last, across) = (at, across + column.width());
        }
        write_text(sheet, 0, NAMES, TITLE.get(self.language), &self.styles.title)?;
        let how = HOW.get(self.language);
        sheet.merge_range(1, NAMES, 1, last, "", &self.styles.note)?;
        write_text(sheet, 1, NAMES, how, &self.styles.note)?;
        sheet.set_row_height(1, row_height(&[(how, across)]))?;
        write_text(sheet, 2, NAMES, SCHEMA_LABEL.get(self.language), &self.styles.source)?;
        write_text(sheet, 2, 1, SCHEMA, &self.styles.source)?;
        let end = self.write_table(sheet, 3)?;
        sheet.set_freeze_panes(5, 1)?;
        sheet.set_selection(5, 1, 5, 1)?;
        sheet.set_print_area(0, NAMES, end, last)?;
        Page { part: "", origin: self.origin, repeat: (3, 4), landscape: true, single: true }
            .set_up(sheet, self.language)?;
        sheet.protect_with_options(&ProtectionOptions {
            format_cells: true,
            format_columns: true,
            format_rows: true,
            ..ProtectionOptions::new()
        });
        Ok(())
    }

    /// Headings, units and rows from a row on; returns the last row.
    fn write_table(&self, sheet: &mut Worksheet, heading: RowNum) -> Result<RowNum, WriteError> {
        let styles = &self.styles;
        write_text(sheet, heading, NAMES, SYSTEM.get(self.language), &styles.header)?;
        sheet.write_blank(heading + 1, NAMES, &styles.number_unit)?;
        for (at, column) in (1..).zip(Column::all()) {
            let symbol = column.parameter(self.unit, self.language).symbol();
            write_text(sheet, heading, at, symbol, &styles.number_header)?;
            write_text(sheet, heading + 1, at, column.unit(self.unit), &styles.number_unit)?;
        }
        let (offsets, _) = Offsets::read(self.file, self.unit);
        let mut row = heading + 1;
        for system in System::ALL {
            row += 1;
            let rotation = self.file.get(system.rotation_parameter()).unwrap_or(0.0);
            let active = system == offsets.active;
            self.write_row(sheet, row, system.name(), system.first_parameter(), Some(rotation), active)?;
        }
        row += 1;
        self.write_row(sheet, row, G92, G92_FIRST, None, offsets.g92_on)?;
        Ok(row)
    }

    fn write_row(
        &self,
        sheet: &mut Worksheet,
        row: RowNum,
        name: &str,
        first: u32,
        rotation: Option<f64>,
        active: bool,
    ) -> Result<(), WriteError> {
        let styles = &self.styles;
        // A table's numbers stand under their headings, which have no indent.
        let [input_number, input_text] =
            [&styles.input_number, &styles.input_text].map(|format| format.clone().set_indent(0));
        write_text(sheet, row, NAMES, name, &styles.symbol)?;
        for (at, column) in (1..).zip(Column::all()) {
            let number = match column {
                Column::Axis(axis) => Some(value(self.file, first, axis)),
                Column::Rotation => rotation,
                Column::Active => None,
            };
            let parameter = column.parameter(self.unit, self.language);
            match (column, number) {
                (Column::Active, _) => {
                    let FieldKind::Choice(choices) = parameter.kind else { continue };
                    let choice = choices.iter().find(|choice| (choice.key == YES) == active);
                    let label = choice.map_or("", |choice| choice.label.get(self.language));
                    write_text(sheet, row, at, label, &input_text)?;
                }
                (_, Some(number)) => {
                    sheet.write_number_with_format(row, at, number + 0.0, &input_number)?;
                }
                // G92 does not turn.
                (_, None) => {
                    sheet.write_blank(row, at, &styles.fixed)?;
                    continue;
                }
            }
            let validation = validation(parameter, !parameter.required, self.language)?;
            sheet.add_data_validation(row, at, row, at, &validation)?;
        }
        Ok(())
    }
}
