//! The program as the sheets hold it: one block a row, subprograms on sheets of their own.

use std::collections::BTreeMap;

use crate::finding::{CellPlace, Finding, Place, Raise};
use crate::gcode::interpreter::{Files, Interpreter, Refused, Setting, line_feeds};
use crate::gcode::program::Part;
use crate::kinds::lathe::parameters::{BLOCK, SUBPROGRAM_KEY};
use crate::kinds::lathe::rules::SubprogramOnTwoSheets;
use crate::parameter::field::{Entry, Fields};
use crate::text::Text;

/// Lines of a program, each with the cell it stands in.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lines {
    /// The lines, each ended by a line feed.
    pub text: String,
    /// The cell of each line, where it came from a workbook.
    pub cells: Vec<Option<CellPlace>>,
}

impl Lines {
    /// The lines of a list's rows; a row without a block is none.
    #[must_use]
    pub fn of<'a>(rows: impl Iterator<Item = Entry<'a>>) -> Self {
        let mut text = Self::default();
        for row in rows {
            let block = row.get(&BLOCK);
            if !block.is_empty() {
                text.text.push_str(&block);
                text.text.push('\n');
                text.cells.push(row.cell(&BLOCK.row).pop());
            }
        }
        text
    }

    /// The lines of a file.
    #[must_use]
    pub fn of_file(text: &str) -> Self {
        Self { text: line_feeds(text), cells: Vec::new() }
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
pub struct SheetProgram {
    /// The program.
    pub main: Lines,
    /// The external subprograms by their names, as `O0005`.
    pub subprograms: BTreeMap<String, Lines>,
}

impl SheetProgram {
    /// The program of a list of a filled-in form, with the subprograms of its sheets; `None` where it has no block.
    #[must_use]
    pub fn of(fields: &Fields, list: &str) -> Option<Self> {
        let main = Lines::of(fields.rows(list));
        let subprograms = fields
            .sheets(SUBPROGRAM_KEY)
            .filter_map(|(sheet, rows)| {
                let number = number(sheet)?;
                Some((format!("O{number:04}"), Lines::of(rows)))
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

    /// The program as it is delivered, whole: its lines, and those of the subprograms of other sheets and files that it
    /// calls, each behind its number; before the closing `%` where there is one.
    #[must_use]
    pub fn whole<'a>(&self, called: impl Iterator<Item = &'a str>) -> Vec<Part> {
        let mut lines: Vec<String> = self.main.text.lines().map(str::to_owned).collect();
        let percent = |line: &str| line.trim() == "%";
        let end = lines.iter().rposition(|line| !line.trim().is_empty()).filter(|at| *at > 0 && percent(&lines[*at]));
        let mut behind = end.map(|at| lines.split_off(at)).unwrap_or_default();
        for (name, text) in called.filter_map(|name| self.subprograms.get_key_value(name)) {
            let mut own = text.text.lines().filter(|line| !line.trim().is_empty() && !percent(line)).peekable();
            let numbered = own.peek().is_some_and(|line| line.trim_start().starts_with(['O', 'o', ':']));
            if let (false, Some(number)) = (numbered, number(name)) {
                lines.push(format!("O{number:04}"));
            }
            lines.extend(own.map(str::to_owned));
        }
        lines.append(&mut behind);
        lines.into_iter().map(Part::Line).collect()
    }

    /// The text that a line stands in; `file` is the subprogram it is of.
    #[must_use]
    pub fn text(&self, file: Option<&str>) -> Option<&Lines> {
        file.map_or(Some(&self.main), |name| self.subprograms.get(name))
    }

    /// Where a line stands: in its cell, or in its file; `file` is the subprogram it is of.
    #[must_use]
    pub fn place(&self, file: Option<&str>, line: usize, columns: Vec<usize>) -> Place {
        match (self.text(file).map(|text| text.place(line, columns)), file) {
            (Some(Place::Line { line, columns }), Some(file)) => {
                Place::Subprogram { file: file.to_owned(), line, columns }
            }
            (Some(place), _) => place,
            (None, _) => Place::File,
        }
    }

    /// A refusal that lies in more than one line, at the cells of all of them; `None` where it lies in one, or one stands in no
    /// cell.
    #[must_use]
    pub fn refused_together(&self, fault: &Refused) -> Option<Finding> {
        if fault.others.is_empty() {
            return None;
        }
        let cells = |(file, line): (Option<&str>, usize)| match self.place(file, line, Vec::new()) {
            Place::Cells(cells) => Some(cells),
            _ => None,
        };
        let others = fault.others.iter().map(|(file, line)| (file.as_deref(), *line));
        let lines = std::iter::once((fault.file.as_deref(), fault.line)).chain(others);
        let cells: Vec<Vec<CellPlace>> = lines.map(cells).collect::<Option<_>>()?;
        // The cells say where.
        let mut alone = fault.clone();
        alone.others.clear();
        Some(Finding::from(alone).placed(Place::Cells(cells.concat())))
    }

    /// A place of the interpreter's as one of the workbook's, where the line came from there.
    #[must_use]
    pub fn placed(&self, place: Place) -> Place {
        match place {
            Place::Line { line, columns } => self.place(None, line, columns),
            Place::Subprogram { file, line, columns } => self.place(Some(&file), line, columns),
            other => other,
        }
    }
}

/// The stops of subprograms that stand on two sheets: `O5` and `O0005` are one number.
#[must_use]
pub fn twice(fields: &Fields) -> Vec<Finding> {
    let mut sheets: BTreeMap<u32, Vec<&str>> = BTreeMap::new();
    for (sheet, _) in fields.sheets(SUBPROGRAM_KEY) {
        if let Some(number) = number(sheet) {
            sheets.entry(number).or_default().push(sheet);
        }
    }
    let of_one = |(number, sheets): (u32, Vec<&str>)| {
        let [first, .., last] = sheets.as_slice() else { return None };
        let [first, last] = [*first, *last].map(str::to_owned);
        let place = Place::Sheet(last.clone());
        Some(SubprogramOnTwoSheets { name: format!("O{number:04}"), first, last }.at(place))
    };
    sheets.into_iter().filter_map(of_one).collect()
}

/// The number of a subprogram's sheet.
fn number(sheet: &str) -> Option<u32> {
    sheet.trim().trim_start_matches(['O', 'o']).parse().ok()
}

/// Subprograms by their names.
struct Sheets(BTreeMap<String, Lines>);

impl Files for Sheets {
    fn find(&mut self, name: &str) -> Result<Option<Vec<u8>>, Text> {
        Ok(self.0.get(name).map(|text| text.text.clone().into_bytes()))
    }
}
