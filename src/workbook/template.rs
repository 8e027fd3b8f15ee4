//! A new workbook: the form of a workbook kind, ready to be filled in.

use std::io::{Seek, Write};

use rust_xlsxwriter::Workbook;

use super::error::WriteError;
use super::form_sheet::{Filling, LAST};
use super::long_rows::save;
use super::page::{Page, properties};
use super::style::Styles;
use crate::parameter::{Form, Value};
use crate::text::{Language, Text};

/// How the sheets are filled in; stands under the title of every form.
pub(super) static HOW: Text = Text::fixed(
    "Escriba sólo en las celdas amarillas de la columna C; al seleccionar una se ve qué admite. La hoja está protegida, sin contraseña, para que no se borre nada sin querer.",
    "Write only in the yellow cells of column C; selecting one shows what it admits. The sheet is protected, without a password, so that nothing is deleted by accident.",
);

/// What stands under the title of a sheet that may be left out.
pub(super) static OPTIONAL: Text = Text::fixed(
    "Esta hoja es opcional: si todos sus valores quedan vacíos, no se calcula nada con ella.",
    "This sheet is optional: if all its values stay empty, nothing is computed from it.",
);

/// Writes a new workbook with one sheet for each sheet of the form. `values` are by key, parameters without one stay
/// empty; `note` says where the values come from. The same input gives the same bytes.
///
/// # Errors
/// For a value that is not finite, for a form that a workbook cannot hold, and for what `out` refuses.
pub fn write<W: Write + Seek + Send>(
    form: &'static Form,
    values: &[(&'static str, Value)],
    note: &Text,
    language: Language,
    out: W,
) -> Result<(), WriteError> {
    let find = |key: &str| values.iter().find(|(one, _)| *one == key).map(|(_, value)| value);
    let part = match find("part") {
        Some(Value::Line(part)) => part.as_str(),
        _ => "",
    };
    let styles = Styles::default();
    let page = Page { part, origin: form.schema, repeat: (0, 0), landscape: false, single: false };
    let mut workbook = Workbook::new();
    if let Some(first) = form.sheets.first() {
        workbook.set_properties(&properties(first.title.get(language))?);
    }
    for sheet in form.sheets {
        let notes = if sheet.optional {
            [OPTIONAL.get(language), HOW.get(language)]
        } else {
            [note.get(language), HOW.get(language)]
        };
        let filling = Filling { sheet, values: find, notes: &notes, language };
        let worksheet = workbook.add_worksheet();
        let layout = filling.write(worksheet, &styles)?;
        layout.finish(worksheet, LAST, &page, language)?;
        for (name, cell) in layout.defined_names(sheet.name.get(language)) {
            workbook.define_name(name, &cell)?;
        }
    }
    save(&mut workbook, Vec::new(), out)
}
