//! Names of sheets: within the rules, and unique ignoring case.

use std::collections::{BTreeMap, BTreeSet};

use super::guard::CellCopies;
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
    pub copies: CellCopies,
}

/// How the hidden name begins that leads to a sheet which was put into somebody's workbook.
pub const MARK: &str = "rodete_sheet_";

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
    /// The name on its tab.
    pub name: String,
    /// What it is.
    pub role: Role,
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
    use super::SheetNames;

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
