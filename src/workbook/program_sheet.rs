//! The programs as text, side by side on one sheet.
//!
//! Every program has a pair of columns: the block number, and the block. There is no heading: the first line is the
//! first row. A program with more lines than a sheet has rows goes on in further pairs to the right.
//!
//! A long program is printed as its first and last blocks: they are compared at the control, and nobody reads hundreds of pages.
//! Then a note to the right of the columns and the header of each page name the files of the whole programs.

use rust_xlsxwriter::{ColNum, RowNum, Worksheet};

use super::error::WriteError;
use super::guard::Guard;
use super::long_rows::{RowWriter, Rows};
use super::page::{Area, ENDS, NOTE, Page, WHOLE};
use super::style::Styles;
use super::summary_sheet::File;
use crate::gcode::program::Program;
use crate::text::{Language, Text, t};

/// The sheet's name, in both languages.
pub static NAME: Text = t("INCR", "INCR");

/// The sheet's name for the user's own programs, where one is too long for the sheet that it is read from.
pub static OWN: Text = t("LISTADO", "LISTING");

/// The rows of a sheet.
pub const ROWS: u64 = 1_048_576;

/// From one pair of columns to the next.
const PITCH: usize = 3;

/// A pair of columns: a program from a line on.
#[derive(Clone, Copy, Debug)]
struct Strand<'a> {
    program: &'a Program,
    column: usize,
    skip: u64,
    /// Its rows, and whether the program ends with them.
    rows: RowNum,
    ends: bool,
    /// The program is so long that its ends alone are printed.
    cut: bool,
    width: f64,
}

/// The programs laid out in columns.
#[derive(Debug)]
pub struct ProgramSheet<'a> {
    strands: Vec<Strand<'a>>,
    rows: RowNum,
    /// What is printed, and where the whole programs are; empty where all is printed.
    note: String,
    /// The same in the header of each page.
    header: String,
}

impl<'a> ProgramSheet<'a> {
    /// Lays the programs out in columns of at most `most` rows, in the order of their keys; one that is left out leaves its
    /// columns empty. `None` where there is no line at all.
    #[must_use]
    pub fn new(programs: impl IntoIterator<Item = &'a Program>, order: &[&str], most: u64) -> Option<Self> {
        let most = most.clamp(1, ROWS);
        let mut others = order.len()..;
        let mut placed: Vec<(usize, &Program, Extent)> = programs
            .into_iter()
            .filter_map(|program| {
                let place = order.iter().position(|key| *key == program.key).or_else(|| others.next())?;
                Some((place, program, Extent::of(program)))
            })
            .collect();
        placed.sort_by_key(|(place, ..)| *place);
        let mut further = others.start;
        let mut strands = Vec::new();
        for (place, program, extent) in &placed {
            let mut skip = 0;
            while skip < extent.lines {
                let place = if skip == 0 { *place } else { further };
                further += usize::from(skip > 0);
                let rows = RowNum::try_from(most.min(extent.lines - skip)).unwrap_or(RowNum::MAX);
                let (ends, cut) = (skip + most >= extent.lines, extent.lines > u64::from(WHOLE));
                strands.push(Strand { program, column: place * PITCH, skip, rows, ends, cut, width: extent.width() });
                skip += most;
            }
        }
        strands.sort_by_key(|strand| strand.column);
        let longest = placed.iter().map(|(.., extent)| extent.lines).max()?.min(most);
        let rows = RowNum::try_from(longest).ok().filter(|rows| *rows > 0)?;
        Some(Self { strands, rows, note: String::new(), header: String::new() })
    }

    /// Names the files that hold the whole of the programs, by what they are.
    #[must_use]
    pub fn with_files(mut self, files: &[File], language: Language) -> Self {
        if !self.strands.iter().any(|strand| strand.cut) {
            return self;
        }
        let of = |strand: &Strand<'_>| files.iter().find(|(_, what)| *what == strand.program.title);
        let first = self.strands.iter().filter(|strand| strand.cut && strand.skip == 0);
        let names: Vec<&str> = first.filter_map(of).map(|(name, _)| name.as_str()).collect();
        let printed = Text::new(
            format!("De un programa largo se imprimen las {ENDS} primeras y las {ENDS} últimas líneas; entero: "),
            format!("Of a long program the first and the last {ENDS} lines are printed; whole: "),
        );
        let ends = Text::new(
            format!("Las {ENDS} primeras y las {ENDS} últimas líneas; entero: "),
            format!("The first and the last {ENDS} lines; whole: "),
        );
        let files = t("los archivos .nc", "the .nc files").get(language).to_owned();
        let named = if names.is_empty() { files.clone() } else { names.join(", ") };
        self.note = format!("{}{named}", printed.get(language));
        let ends = ends.get(language);
        let room = NOTE.saturating_sub(ends.chars().count());
        self.header = format!("{ends}{}", if named.chars().count() > room { files } else { named });
        self
    }

    /// The areas that are printed, where not everything is.
    #[must_use]
    pub fn printed(&self) -> Vec<Area> {
        if self.note.is_empty() {
            return Vec::new();
        }
        let areas = |strand: &Strand<'_>| {
            let column = ColNum::try_from(strand.column).unwrap_or(ColNum::MAX - 1);
            let area = |first: RowNum, end: RowNum| [(first, column), (end.saturating_sub(1), column + 1)];
            let all = area(0, strand.rows);
            if !strand.cut {
                return vec![all];
            }
            let head = (strand.skip == 0).then(|| area(0, strand.rows.min(ENDS)));
            let end = strand.ends.then(|| area(strand.rows.saturating_sub(ENDS), strand.rows));
            head.into_iter().chain(end).collect()
        };
        self.strands.iter().flat_map(areas).collect()
    }

    /// The column of the note.
    fn beside(&self) -> usize {
        self.strands.last().map_or(0, |strand| strand.column + PITCH)
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
        guard: &Guard,
    ) -> Result<(), WriteError> {
        // Each pair of columns is printed on pages of its own, one program after the other.
        let mut breaks = Vec::new();
        for strand in &self.strands {
            let column = ColNum::try_from(strand.column).map_err(|_| WriteError::TooLarge("INCR"))?;
            if column > 0 {
                breaks.push(u32::from(column));
            }
            sheet.set_column_width(column, 9)?;
            sheet.set_column_width(column + 1, strand.width)?;
            sheet.write_blank(0, column, &styles.block_number)?;
            sheet.write_blank(0, column + 1, &styles.block)?;
        }
        if let Some(last) = self.strands.last() {
            let last = ColNum::try_from(last.column + 1).map_err(|_| WriteError::TooLarge("INCR"))?;
            guard.strike(sheet, [0, self.rows.saturating_sub(1)], [0, last], &styles.struck)?;
        }
        sheet.set_vertical_page_breaks(&breaks)?;
        page.set_up_columns(sheet, language);
        if !self.note.is_empty() {
            let column = ColNum::try_from(self.beside()).map_err(|_| WriteError::TooLarge("INCR"))?;
            sheet.write_blank(0, column, &styles.source)?;
            page.set_header(sheet, &self.header);
        }
        Ok(())
    }

    /// Streams the rows, all programs in step.
    #[must_use]
    pub fn source(self) -> RowWriter<'a> {
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
            for row in 0..self.rows {
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
                if row == 0 && !self.note.is_empty() {
                    rows.text(self.beside(), &self.note)?;
                }
            }
            Ok(())
        })
    }
}

/// How much a program is.
#[derive(Clone, Copy, Debug, Default)]
struct Extent {
    lines: u64,
    longest: usize,
}

impl Extent {
    fn of(program: &Program) -> Self {
        let mut extent = Self::default();
        let mut lines = program.lines();
        while let Some((_, text)) = lines.next() {
            extent.lines += 1;
            extent.longest = extent.longest.max(text.len());
        }
        extent
    }

    /// The width of the blocks' column, in characters.
    fn width(self) -> f64 {
        const LEAST: u8 = 12;
        const GREATEST: u8 = 60;
        f64::from(u8::try_from(self.longest).unwrap_or(GREATEST).clamp(LEAST, GREATEST))
    }
}
