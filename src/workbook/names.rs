//! Names of sheets: within the rules, and unique ignoring case.

use std::collections::{BTreeMap, BTreeSet};

use super::guard::Written;
use crate::limits::SHEET_NAME;

/// The sheets of a workbook that others are put into.
#[derive(Clone, Debug, Default)]
pub struct Present {
    /// The names of all its sheets.
    pub taken: Vec<String>,
    /// The names of those that were put in before, by their keys: letters, digits and `_`.
    pub ours: BTreeMap<String, String>,
    /// The names of the form's sheets, by their places in the form; one that is missing has none.
    pub forms: BTreeMap<usize, String>,
    /// How the folder of the other files is called.
    pub folder: String,
    /// What the cells of the form and of its lists hold.
    pub written: Written,
}

/// What a sheet is called in marks and in names of parts: letters, digits and `_`.
#[must_use]
pub fn slug(key: &str) -> String {
    key.chars().map(|one| if one.is_ascii_alphanumeric() { one.to_ascii_lowercase() } else { '_' }).collect()
}

/// What a sheet of a workbook that was written is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Role {
    /// A sheet of the form or of a list: it is filled in.
    Form,
    /// A sheet of results, with its key.
    Result(String),
}

/// A sheet of a workbook that was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// Its name.
    pub name: String,
    /// What it is.
    pub role: Role,
}

/// The sheet and the cell that a formula names alone, as `'Annex 1'!$A$1`; `None` for any other formula.
#[must_use]
pub fn cell(formula: &str) -> Option<(String, String)> {
    let formula = formula.trim().trim_start_matches('=');
    let (sheet, cell) = formula.rsplit_once('!')?;
    let cell: String = cell.chars().filter(|one| *one != '$').collect();
    let plain = cell.chars().skip_while(char::is_ascii_alphabetic).collect::<String>();
    if plain.is_empty() || plain.len() == cell.len() || !plain.bytes().all(|one| one.is_ascii_digit()) {
        return None;
    }
    let sheet = match sheet.strip_prefix('\'').and_then(|sheet| sheet.strip_suffix('\'')) {
        Some(quoted) => quoted.replace("''", "'"),
        // LibreOffice may mark the sheet as absolute.
        None => sheet.trim_start_matches('$').to_owned(),
    };
    (!sheet.is_empty() && !sheet.starts_with('#')).then_some((sheet, cell))
}

/// A sheet's name as formulas write it.
#[must_use]
pub fn quoted(sheet: &str) -> String {
    format!("'{}'", sheet.replace('\'', "''"))
}

/// The names of a workbook's sheets that are taken.
#[derive(Debug, Default)]
pub struct SheetNames {
    taken: BTreeSet<String>,
}

impl SheetNames {
    /// The names beside those of a workbook.
    #[must_use]
    pub fn beside(present: &Present) -> Self {
        Self { taken: present.taken.iter().map(|name| name.to_lowercase()).collect() }
    }

    /// Takes a name as near to the one wanted as the rules allow.
    pub fn take(&mut self, wanted: &str) -> String {
        let cleaned = clean(wanted);
        let mut name = fitted(&cleaned, SHEET_NAME);
        let mut count = 2_u64;
        // `History` is kept by spreadsheets for themselves.
        while name.eq_ignore_ascii_case("History") || self.taken.contains(&name.to_lowercase()) {
            let suffix = format!(" ({count})");
            name = fitted(&cleaned, SHEET_NAME - suffix.len()) + &suffix;
            count += 1;
        }
        self.taken.insert(name.to_lowercase());
        name
    }
}

/// The text without what a sheet's name may not hold: `[ ] : * ? / \`, control characters, apostrophes at its ends.
fn clean(wanted: &str) -> String {
    let cleaned: String = wanted
        .chars()
        .map(|one| if one.is_control() || matches!(one, '[' | ']' | ':' | '*' | '?' | '/' | '\\') { '_' } else { one })
        .collect();
    let cleaned = cleaned.trim_matches(['\'', ' ']);
    if cleaned.is_empty() { "_".to_owned() } else { cleaned.to_owned() }
}

/// The beginning of a text that fits, without blanks or apostrophes at its end.
fn fitted(text: &str, most: usize) -> String {
    let mut room = most;
    let fits = text.chars().take_while(|one| {
        let fits = one.len_utf16() <= room;
        room = room.saturating_sub(one.len_utf16());
        fits
    });
    fits.collect::<String>().trim_end_matches(['\'', ' ']).to_owned()
}

#[cfg(test)]
mod tests {
    use super::{SheetNames, cell};

    #[test]
    fn a_formula_that_is_one_cell_is_told_from_others() {
        let own = |sheet: &str, cell: &str| Some((sheet.to_owned(), cell.to_owned()));
        assert_eq!(cell("'It''s 1'!$A$1"), own("It's 1", "A1"));
        assert_eq!(cell("DATA!$C$7"), own("DATA", "C7"));
        assert_eq!(cell("$Data.A1!$C$7"), own("Data.A1", "C7"));
        for other in ["#REF!$A$1", "'A'!$A$1:$B$2", "1+1", "'A'!#REF!", "\"text\"", "A1", "'A'!name"] {
            assert_eq!(cell(other), None, "{other}");
        }
    }

    #[test]
    fn every_name_taken_is_one_that_a_workbook_allows() {
        let mut names = SheetNames::default();
        for (wanted, got) in [
            ("Anexo 1", "Anexo 1"),
            ("ANEXO 1", "ANEXO 1 (2)"),
            ("anexo 1", "anexo 1 (3)"),
            ("History", "History (2)"),
            ("history", "history (3)"),
            ("a/b\\c[d]e:f*g?h", "a_b_c_d_e_f_g_h"),
            ("''quoted' ", "quoted"),
            ("", "_"),
            ("'", "_ (2)"),
            ("\u{1B}x", "_x"),
            ("0123456789012345678901234567890123", "0123456789012345678901234567890"),
            ("0123456789012345678901234567890987", "012345678901234567890123456 (2)"),
            ("01234567890123456789012345678' xx", "01234567890123456789012345678"),
            (
                "\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}",
                "\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}\u{1F600}",
            ),
        ] {
            let name = names.take(wanted);
            assert_eq!(name, got);
            rust_xlsxwriter::check_sheet_name(&name).expect("a name that a workbook allows");
        }
    }
}
