//! The program as the sheets hold it: one block a row, subprograms on sheets of their own.

use std::collections::BTreeMap;

use crate::finding::{CellPlace, Place};
use crate::gcode::interpreter::{Files, Interpreter, Setting};
use crate::lathe::parameters::SUBPROGRAM_KEY;
use crate::parameter::Values;
use crate::parameter::list::Row;

/// The column of the blocks.
const BLOCK: &str = "program/BLOCK";

/// Lines of a program, each with the cell it stands in.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// The lines, each ended by a line feed.
    pub text: String,
    /// The cell of each line, where it came from a workbook.
    pub cells: Vec<Option<CellPlace>>,
}

impl Text {
    /// The lines of a list's rows; a row without a block is none.
    #[must_use]
    pub fn of(rows: &[Row]) -> Self {
        let mut text = Self::default();
        for row in rows {
            let block = row.line(BLOCK);
            if !block.is_empty() {
                text.text.push_str(block);
                text.text.push('\n');
                text.cells.push(row.cells.get(BLOCK).cloned());
            }
        }
        text
    }

    /// The lines of a file.
    #[must_use]
    pub fn of_file(text: String) -> Self {
        Self { text, cells: Vec::new() }
    }

    /// Where a line stands: in its cell, or in its file.
    #[must_use]
    pub fn place(&self, line: usize, columns: Vec<usize>) -> Place {
        let cell = line.checked_sub(1).and_then(|at| self.cells.get(at)).cloned().flatten();
        cell.map_or(Place::Line { line, columns }, |cell| Place::Cells(vec![cell]))
    }

    /// The block on a line, counted from 1; empty where there is none.
    #[must_use]
    pub fn line(&self, line: usize) -> &str {
        line.checked_sub(1).and_then(|at| self.text.lines().nth(at)).unwrap_or_default()
    }
}

/// A program with its subprograms.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// The program.
    pub main: Text,
    /// The external subprograms by their names, as `O0005`.
    pub subprograms: BTreeMap<String, Text>,
}

impl Source {
    /// The program of a list of a filled-in form, with the subprograms of its sheets; `None` where it has no block.
    #[must_use]
    pub fn of(values: &Values, list: &str) -> Option<Self> {
        let main = Text::of(values.rows(list));
        let subprograms = values
            .lists
            .iter()
            .filter(|rows| rows.list == SUBPROGRAM_KEY)
            .filter_map(|rows| {
                let number: u32 = rows.sheet.trim().trim_start_matches(['O', 'o']).parse().ok()?;
                Some((format!("O{number:04}"), Text::of(&rows.rows)))
            })
            .collect();
        (!main.text.is_empty()).then_some(Self { main, subprograms })
    }

    /// The interpreter over the program.
    #[must_use]
    pub fn read(&self, mut setting: Setting) -> Interpreter<'_> {
        setting.files = Box::new(Sheets(self.subprograms.clone()));
        Interpreter::over(self.main.text.as_bytes(), setting)
    }

    /// The text that a line stands in; `file` is the subprogram it is of.
    #[must_use]
    pub fn text(&self, file: Option<&str>) -> Option<&Text> {
        file.map_or(Some(&self.main), |name| self.subprograms.get(name))
    }

    /// Where a line stands; `file` is the subprogram it is of.
    #[must_use]
    pub fn place(&self, file: Option<&str>, line: usize, columns: Vec<usize>) -> Place {
        self.text(file).map_or(Place::File, |text| text.place(line, columns))
    }
}

/// Subprograms by their names.
struct Sheets(BTreeMap<String, Text>);

impl Files for Sheets {
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, String> {
        Ok(self.0.get(name).map(|text| text.text.clone().into_bytes()))
    }
}
