//! Derived quantities beside the form, in columns G to K.

use rust_xlsxwriter::{ColNum, Worksheet};

use super::cell::{row_height, write_text};
use super::error::WriteError;
use super::form_sheet::Layout;
use super::style::Styles;
use crate::table::{Quantity, Unit};
use crate::text::{Language, Text, t};

const FIRST: ColNum = 6;

/// Widths of columns G to K, in characters.
const WIDTHS: [f64; 5] = [11.0, 42.0, 15.0, 9.0, 32.0];

/// The last column used.
pub const LAST: ColNum = 10;

/// Writes the quantities beside a form, from the row of its column headings on: symbol, meaning, value, unit, source.
///
/// # Errors
/// For a quantity that is not finite.
pub fn write(
    sheet: &mut Worksheet,
    layout: &mut Layout,
    quantities: &[Quantity],
    language: Language,
    styles: &Styles,
) -> Result<(), WriteError> {
    static HEADINGS: [Text; 5] = [
        t("Derivado", "Derived"),
        t("Significado", "Meaning"),
        t("Valor", "Value"),
        t("Unidad", "Unit"),
        t("Procedencia", "Source"),
    ];
    sheet.set_column_width(FIRST - 1, 3)?;
    for (column, (heading, width)) in (FIRST..).zip(HEADINGS.iter().zip(WIDTHS)) {
        let format = if column == FIRST + 2 { &styles.number_header } else { &styles.header };
        write_text(sheet, layout.header, column, heading.get(language), format)?;
        sheet.set_column_width(column, width)?;
    }
    for (row, quantity) in (layout.header + 1..).zip(quantities) {
        if !quantity.value.is_finite() {
            return Err(WriteError::NotFinite { place: quantity.symbol.to_owned() });
        }
        let (meaning, source) = (quantity.meaning.get(language), quantity.source.get(language));
        let value = if quantity.unit == Unit::Count { &styles.whole } else { &styles.number };
        write_text(sheet, row, FIRST, quantity.symbol, &styles.symbol)?;
        write_text(sheet, row, FIRST + 1, meaning, &styles.text)?;
        sheet.write_number_with_format(row, FIRST + 2, quantity.value, value)?;
        write_text(sheet, row, FIRST + 3, quantity.unit.label(), &styles.unit)?;
        write_text(sheet, row, FIRST + 4, source, &styles.faint)?;
        layout.raise(row, row_height(&[(meaning, WIDTHS[1]), (source, WIDTHS[4])]));
    }
    Ok(())
}
