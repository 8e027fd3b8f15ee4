//! Text into cells: whatever a user typed stays text and fits; and formulas that are not worked out yet.

use std::borrow::Cow;

use rust_xlsxwriter::{ColNum, Format, Formula, RowNum, Worksheet, XlsxError};

/// The most UTF-16 units that a cell holds.
pub(super) const CELL: usize = 32_767;

/// The most UTF-16 units of a page header or footer that are kept of one text.
const HEADER: usize = 80;

/// The stored result of a formula that has none: what it comes to is put in its place when the workbook is saved.
pub(super) const UNCOMPUTED: &str = "rodete:uncomputed";

/// A formula that is worked out when the workbook is saved.
pub(super) fn uncomputed(formula: &str) -> Formula {
    Formula::new(format!("={formula}")).set_result(UNCOMPUTED)
}

/// Writes a text, never as a formula: a text that a spreadsheet would take for one when the cell is edited is marked as
/// quoted. A text too long for a cell is cut and ends in an ellipsis.
///
/// # Errors
/// For a cell outside the sheet.
pub fn write_text(
    sheet: &mut Worksheet,
    row: RowNum,
    column: ColNum,
    text: &str,
    format: &Format,
) -> Result<(), XlsxError> {
    let text = shortened(text, CELL);
    if starts_formula(&text) {
        sheet.write_string_with_format(row, column, text, &format.clone().set_quote_prefix())?;
    } else {
        sheet.write_string_with_format(row, column, text, format)?;
    }
    Ok(())
}

/// True for a text that a spreadsheet would read as a formula if it were typed.
#[must_use]
pub fn starts_formula(text: &str) -> bool {
    text.starts_with(['=', '+', '-', '@', '\t', '\r', '\'', '\0'])
}

/// The text within `most` UTF-16 units, with an ellipsis at its end where it was cut.
#[must_use]
pub fn shortened(text: &str, most: usize) -> Cow<'_, str> {
    if text.encode_utf16().count() <= most {
        return Cow::Borrowed(text);
    }
    let mut room = most.saturating_sub(1);
    let mut short: String = text
        .chars()
        .take_while(|one| {
            let fits = one.len_utf16() <= room;
            room = room.saturating_sub(one.len_utf16());
            fits
        })
        .collect();
    short.push('…');
    Cow::Owned(short)
}

/// A text for a page's header or footer: one short line in which `&` is no command.
#[must_use]
pub fn header_text(text: &str) -> String {
    let line: String = text.chars().map(|one| if one.is_control() { ' ' } else { one }).collect();
    shortened(line.trim(), HEADER).replace('&', "&&")
}

/// The height, in points, of a row whose cells hold these texts wrapped to these widths (in characters).
///
/// Not every spreadsheet fits the height of a row when it opens a workbook, and none does for merged cells.
#[must_use]
pub fn row_height(cells: &[(&str, f64)]) -> f64 {
    const LINE: f64 = 15.0;
    /// The highest row that a sheet can have.
    const HIGHEST: f64 = 409.0;
    let most = cells.iter().map(|(text, width)| lines(text, *width)).fold(1.0, f64::max);
    f64::min(LINE * most, HIGHEST)
}

/// How many lines a text takes when it is wrapped between words, and after hyphens, to a width in characters.
fn lines(text: &str, width: f64) -> f64 {
    // A width counts digits; running text is narrower by about a fifth, and capitals are wider.
    let width = f64::max(1.15 * width, 1.0);
    text.split('\n')
        .map(|line| {
            let (mut count, mut used) = (1.0, 0.0);
            for word in line.split_inclusive([' ', '-']) {
                let long = word.chars().fold(0.0, |sum, letter| sum + if letter.is_uppercase() { 1.4 } else { 1.0 });
                if used > 0.0 && used + long > width {
                    count += 1.0;
                    used = 0.0;
                }
                // A word longer than the line is broken anywhere.
                count += f64::max((long / width).ceil() - 1.0, 0.0);
                used += long % width;
            }
            count
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::{header_text, row_height, shortened};

    #[test]
    fn a_row_is_as_high_as_its_longest_wrapped_text() {
        let height = |cells: &[(&str, f64)]| row_height(cells).to_bits();
        assert_eq!(height(&[("", 10.0)]), 15.0_f64.to_bits());
        assert_eq!(height(&[("one two three", 20.0)]), 15.0_f64.to_bits());
        assert_eq!(height(&[("one two three", 8.0), ("one", 8.0)]), 30.0_f64.to_bits());
        assert_eq!(height(&[("one\ntwo\nthree", 20.0)]), 45.0_f64.to_bits());
        assert_eq!(height(&[(&"x".repeat(50), 20.0)]), 45.0_f64.to_bits());
        assert_eq!(height(&[(&"x ".repeat(20_000), 20.0)]), 409.0_f64.to_bits());
    }

    #[test]
    fn a_long_text_is_cut_between_characters_and_says_so() {
        assert_eq!(shortened("álabe", 5), "álabe");
        assert_eq!(shortened("álabes", 5), "álab…");
        // A character outside the basic plane takes two units and is never halved.
        assert_eq!(shortened("ab\u{1F600}\u{1F600}", 5), "ab\u{1F600}…");
        assert_eq!(shortened("ab\u{1F600}\u{1F600}", 4), "ab…");
    }

    #[test]
    fn a_header_holds_no_command_and_no_control_character() {
        assert_eq!(header_text("A&P\u{0}\n&[File]"), "A&&P  &&[File]");
        assert!(header_text(&"&".repeat(500)).len() <= 2 * 80 + 2);
    }
}
