//! The programs as text, side by side on one sheet.
//!
//! Every program has a pair of columns: the block number, and the block. There is no heading: the first line is the
//! first row. A program with more lines than a sheet has rows goes on in further pairs to the right.

use rust_xlsxwriter::{ColNum, RowNum, Worksheet};

use super::error::WriteError;
use super::long_rows::{Rows, Source};
use super::page::Page;
use super::style::Styles;
use crate::gcode::program::Program;
use crate::text::Language;

/// The sheet's name, in both languages.
pub const NAME: &str = "INCR";

/// The rows of a sheet.
pub const ROWS: u64 = 1_048_576;

/// The programs in the order of their columns; one that is left out leaves its columns empty.
const ORDER: [&str; 4] = ["blade", "splitter", "impeller", "blank"];

/// From one pair of columns to the next.
const PITCH: usize = 3;

/// A pair of columns: a program from a line on.
#[derive(Clone, Copy, Debug)]
struct Strand<'a> {
    program: &'a Program,
    column: usize,
    skip: u64,
}

/// The programs laid out in columns.
#[derive(Debug)]
pub struct ProgramSheet<'a> {
    strands: Vec<Strand<'a>>,
    rows: RowNum,
}

impl<'a> ProgramSheet<'a> {
    /// Lays the programs out in columns of at most `most` rows. `None` where there is no line at all.
    #[must_use]
    pub fn new(programs: &'a [Program], most: u64) -> Option<Self> {
        let most = most.clamp(1, ROWS);
        let mut others = ORDER.len()..;
        let mut placed: Vec<(usize, &Program, u64)> = programs
            .iter()
            .filter_map(|program| {
                let place = ORDER.iter().position(|key| *key == program.key).or_else(|| others.next())?;
                Some((place, program, lines(program)))
            })
            .collect();
        placed.sort_by_key(|(place, ..)| *place);
        let mut further = others.start;
        let mut strands = Vec::new();
        for (place, program, count) in &placed {
            let mut skip = 0;
            while skip < *count {
                let place = if skip == 0 { *place } else { further };
                further += usize::from(skip > 0);
                strands.push(Strand { program, column: place * PITCH, skip });
                skip += most;
            }
        }
        strands.sort_by_key(|strand| strand.column);
        let longest = placed.iter().map(|(.., count)| *count).max()?.min(most);
        let rows = RowNum::try_from(longest).ok().filter(|rows| *rows > 0)?;
        Some(Self { strands, rows })
    }

    /// How many rows there are.
    #[must_use]
    pub const fn rows(&self) -> RowNum {
        self.rows
    }

    /// Writes the sheet's first row of formatted empty cells, to be replaced by [`ProgramSheet::source`].
    ///
    /// # Errors
    /// For more columns than a sheet has.
    pub fn write(
        &self,
        sheet: &mut Worksheet,
        language: Language,
        styles: &Styles,
        page: &Page<'_>,
    ) -> Result<(), WriteError> {
        for strand in &self.strands {
            let column = ColNum::try_from(strand.column).map_err(|_| WriteError::TooLarge(NAME))?;
            sheet.set_column_width(column, 9)?;
            sheet.set_column_width(column + 1, 58)?;
            sheet.write_blank(0, column, &styles.block_number)?;
            sheet.write_blank(0, column + 1, &styles.block)?;
        }
        // Across and down: a page is read as a program is.
        Page { landscape: self.strands.len() > 1, ..*page }.set_up_plain(sheet, language);
        Ok(())
    }

    /// Streams the rows, all programs in step.
    #[must_use]
    pub fn source(self) -> Source<'a> {
        Box::new(move |rows: &mut Rows<'_>| {
            let mut running: Vec<_> = self
                .strands
                .iter()
                .map(|strand| {
                    let mut lines = strand.program.lines();
                    let mut skipped = 0;
                    while skipped < strand.skip && lines.next().is_some() {
                        skipped += 1;
                    }
                    (strand.column, lines)
                })
                .collect();
            let mut label = String::new();
            for _ in 0..self.rows {
                rows.start()?;
                for (column, lines) in &mut running {
                    let Some((number, text)) = lines.next() else { continue };
                    if let Some(number) = number {
                        label.clear();
                        label.push('N');
                        label.push_str(&number.to_string());
                        rows.text(*column, &label)?;
                    }
                    if !text.is_empty() {
                        rows.text(*column + 1, text)?;
                    }
                }
            }
            Ok(())
        })
    }
}

/// How many lines a program has.
fn lines(program: &Program) -> u64 {
    let mut lines = program.lines();
    let mut count = 0;
    while lines.next().is_some() {
        count += 1;
    }
    count
}
