//! Cell addresses as `C9`.

use super::limits::{GRID_COLUMNS, GRID_ROWS};

/// A cell's row and column, both counted from 0.
pub type Position = (u32, u32);

/// The position that an address names; `None` where it is no address of the sheet grid (A1 … XFD1048576).
#[must_use]
pub fn parse(address: &str) -> Option<Position> {
    let split = address.find(|character: char| !character.is_ascii_alphabetic())?;
    let (letters, digits) = address.split_at_checked(split)?;
    Some((row(digits)?, column(letters)?))
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

/// The row that a row number names, counted from 0; `None` outside 1 … 1048576.
#[must_use]
pub fn row(digits: &str) -> Option<u32> {
    if digits.is_empty() || digits.len() > 7 || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    digits.parse::<u32>().ok()?.checked_sub(1).filter(|row| *row < GRID_ROWS)
}

/// The column that letters name, counted from 0; `None` outside A … XFD.
fn column(letters: &str) -> Option<u32> {
    if letters.is_empty() || letters.len() > 3 {
        return None;
    }
    let number =
        letters.bytes().fold(0, |number, letter| number * 26 + u32::from(letter.to_ascii_uppercase() - b'A') + 1);
    number.checked_sub(1).filter(|column| *column < GRID_COLUMNS)
}

/// The address of a position.
#[must_use]
pub fn format((row, column): Position) -> String {
    format!("{}{}", letters(column), u64::from(row) + 1)
}

/// The letters of a column counted from 0.
#[must_use]
pub fn letters(column: u32) -> String {
    let mut letters = Vec::with_capacity(3);
    let mut rest = u64::from(column) + 1;
    while rest > 0 {
        let letter = u8::try_from((rest - 1) % 26).unwrap_or_default();
        letters.push(char::from(b'A' + letter));
        rest = (rest - 1) / 26;
    }
    letters.into_iter().rev().collect()
}

/// A rectangle of cells, both corners included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// The top left cell.
    pub start: Position,
    /// The bottom right cell.
    pub end: Position,
}

impl Range {
    /// The range that `B9:C9` or `B9` names; `None` outside the grid or with its corners the wrong way round.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (start, end) = text.split_once(':').unwrap_or((text, text));
        let (start, end) = (parse(start)?, parse(end)?);
        (start.0 <= end.0 && start.1 <= end.1).then_some(Self { start, end })
    }

    /// True where the cell lies inside.
    #[must_use]
    pub const fn holds(&self, (row, column): Position) -> bool {
        self.start.0 <= row && row <= self.end.0 && self.start.1 <= column && column <= self.end.1
    }

    /// The range as `B9:C9`.
    #[must_use]
    pub fn address(&self) -> String {
        format!("{}:{}", format(self.start), format(self.end))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_of_the_grid_go_there_and_back() {
        for (address, position) in
            [("A1", (0, 0)), ("C9", (8, 2)), ("AA10", (9, 26)), ("ZZ3", (2, 701)), ("XFD1048576", (1_048_575, 16_383))]
        {
            assert_eq!(parse(address), Some(position), "{address}");
            assert_eq!(format(position), address);
        }
    }

    #[test]
    fn what_lies_outside_the_grid_is_no_address() {
        for address in ["XFE1", "A1048577", "A0", "A", "1", "", "A99999999999", "ZZZZZZZZ1", "A-1", "A1 ", "Á1", "$A$1"]
        {
            assert_eq!(parse(address), None, "{address}");
        }
    }

    #[test]
    fn a_range_the_wrong_way_round_is_refused() {
        assert_eq!(Range::parse("C9:B9"), None);
        assert_eq!(Range::parse("B9:C9").map(|range| range.address()), Some("B9:C9".to_owned()));
    }

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
}
