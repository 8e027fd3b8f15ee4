//! What a workbook may not exceed: the caps that keep time and memory bounded.

const MIB: u64 = 1024 * 1024;

/// The file, in bytes.
pub const FILE: u64 = 64 * MIB;
/// Entries of the package.
pub const ENTRIES: usize = 1_000;
/// One part of the package, unpacked, in bytes.
pub const PART: u64 = 64 * MIB;
/// All parts together, unpacked, in bytes.
pub const TOTAL: u64 = 256 * MIB;
/// A part that describes the workbook (its list of sheets, relationships, styles), unpacked, in bytes.
pub const STRUCTURE: u64 = 8 * MIB;
/// An attribute of such a part, in bytes: they are copied for every sheet.
pub const ATTRIBUTE: usize = 1_024;
/// Attributes of one tag.
pub const ATTRIBUTES: usize = 100_000;
/// Elements inside of one another.
pub const DEPTH: usize = 256;
/// Sheets of the workbook.
pub const SHEETS: usize = 1_000;
/// Defined names that are kept; a form has fewer than a hundred.
pub const NAMES: usize = 10_000;
/// An attribute of the part of cell formats, in bytes: they are copied for every format.
pub const FORMAT_ATTRIBUTE: usize = 320;
/// Cell formats, as many as spreadsheet programs allow.
pub const FORMATS: usize = 65_536;
/// Brackets in one number format: the reader counts them in eight bits.
pub const BRACKETS: usize = 100;
/// Shared texts.
pub const STRINGS: usize = 1_000_000;
/// Rows of a form's sheet with anything in columns A to E.
pub const ROWS: usize = 10_000;
/// Characters kept of one cell's text: more than any parameter may have.
pub const TEXT: usize = 1_024;
/// Characters that a cell can hold in a spreadsheet program; a longer text is not counted further.
pub const CELL_TEXT: usize = 32_767;
/// Rows of a sheet's grid.
pub const GRID_ROWS: u32 = 1_048_576;
/// Columns of a sheet's grid.
pub const GRID_COLUMNS: u32 = 16_384;

/// A number of bytes in MiB, for messages.
#[must_use]
pub const fn mebibytes(bytes: u64) -> u64 {
    bytes / MIB
}
