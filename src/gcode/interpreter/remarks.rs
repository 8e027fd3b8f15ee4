//! What the interpreter remarks of a program.

use std::collections::BTreeSet;

use crate::finding::{Finding, Grade, Place, Raise, Size, gravest_first};
use crate::gcode::interpreter::library::{Library, Spot};
use crate::gcode::interpreter::refused::place;
use crate::gcode::rules::geometry::HalfTurn;
use crate::gcode::rules::modes::LongDwell;
use crate::limits::REMARKS;
use crate::text::{Language, Text, t};

/// What is worth saying about a program that is not refused: each thing once, with the first line it was seen in and how
/// often it was seen.
#[derive(Debug, Default)]
pub(super) struct Remarks {
    /// How often each was seen, and the text that its line stands in.
    list: Vec<(u64, usize, Finding)>,
    /// Blocks at feed that turn a rotary axis by more than half a turn, degrees.
    turns: Option<Greatest>,
    /// Dwells beyond a minute of a word that counts seconds, s.
    dwells: Option<Greatest>,
    /// The lines, each in its text, that cycles have read as blocks of their contour.
    contours: BTreeSet<(usize, usize)>,
}

/// Blocks that a program has several of, told once with the greatest of them.
#[derive(Debug)]
struct Greatest {
    count: u64,
    first: Spot,
    /// Letter, size and line of the greatest.
    greatest: (char, f64, usize),
}

impl Greatest {
    /// Takes a block in. The first of the greatest stays.
    fn take(of: &mut Option<Self>, spot: Spot, letter: char, size: f64) {
        let here = (letter, size, spot.line);
        let all = of.get_or_insert(Self { count: 0, first: spot, greatest: here });
        all.count += 1;
        if size.abs() > all.greatest.1.abs() {
            all.greatest = here;
        }
    }

    /// Where the first stands.
    fn place(&self, library: &Library<'_>) -> Place {
        place(library.file(self.first.text).map(String::as_str), self.first.line, Vec::new())
    }

    /// The end of the sentence where there are several: how many, and where the greatest stands.
    fn more(&self, several: &Text) -> Text {
        let (count, (.., line)) = (self.count, self.greatest);
        match count {
            1 => t("", ""),
            _ => Text::new(
                format!("; {count} {}, en la línea {line}", several.get(Language::Es)),
                format!("; {count} {} in line {line}", several.get(Language::En)),
            ),
        }
    }

    fn half_turn(&self) -> HalfTurn {
        let (axis, degrees, line) = self.greatest;
        let more = self.more(&t("bloques así, este es el mayor", "such blocks, the largest"));
        HalfTurn { axis, degrees: Size::degrees(degrees, 3), count: self.count, line, more }
    }

    fn long_dwell(&self) -> LongDwell {
        let (letter, seconds, line) = self.greatest;
        let time = Size { value: seconds, unit: "s", decimals: 3 };
        let more = self.more(&t("esperas así, esta es la mayor", "such dwells, the longest"));
        LongDwell { letter, time, count: self.count, line, more }
    }
}

impl Remarks {
    /// True where a line, a block of a contour, has been read by a cycle before: what several read of it, G71 and G70, is counted once.
    pub(super) fn counted(&mut self, spot: Spot) -> bool {
        !self.contours.insert((spot.text, spot.line))
    }

    /// Remarks a row at a place and column (counted from 0). Row and values tell one thing from another. Of a place that is read again it
    /// is counted once.
    pub(super) fn row(&mut self, row: &dyn Raise, spot: Spot, column: Option<usize>) {
        self.row_as(row.rule().grade, row, spot, column);
    }

    /// The same, less grave than the row is at its gravest.
    pub(super) fn row_as(&mut self, grade: Grade, row: &dyn Raise, spot: Spot, column: Option<usize>) {
        let (rule, data) = (row.rule(), row.carries());
        let same = |finding: &Finding| finding.is(rule) && finding.data == data;
        if let Some((count, ..)) = self.list.iter_mut().find(|(.., finding)| same(finding)) {
            *count += u64::from(!spot.again);
        } else if self.list.len() < REMARKS {
            let columns = column.map(|column| column + 1).into_iter().collect();
            self.list.push((1, spot.text, row.at(place(None, spot.line, columns)).graded(grade)));
        }
    }

    /// Remarks what was found before the first line.
    pub(super) fn found(&mut self, finding: Finding) {
        let same = |other: &Finding| other.is(finding.rule()) && other.data == finding.data;
        if let Some((count, ..)) = self.list.iter_mut().find(|(.., other)| same(other)) {
            *count += 1;
        } else if self.list.len() < REMARKS {
            self.list.push((1, 0, finding.placed(place(None, 1, Vec::new()))));
        }
    }

    /// Remarks a motion at feed that turns an axis by more than half a turn.
    pub(super) fn turned(&mut self, spot: Spot, axis: char, degrees: f64) {
        Greatest::take(&mut self.turns, spot, axis, degrees);
    }

    /// Remarks a dwell that is told, by a word that counts seconds.
    pub(super) fn dwelt(&mut self, spot: Spot, letter: char, seconds: f64) {
        Greatest::take(&mut self.dwells, spot, letter, seconds);
    }

    /// The remarks as findings, gravest first, with how often each was seen.
    pub(super) fn findings(&self, library: &Library<'_>) -> Vec<Finding> {
        let file = |text: usize| library.file(text).map(String::as_str);
        let mut findings: Vec<Finding> = self
            .list
            .iter()
            .map(|(count, text, finding)| {
                let mut finding = finding.clone();
                if let Place::Line { line, columns } = finding.place {
                    finding.place = place(file(*text), line, columns);
                }
                if *count > 1 { finding.repeated(*count) } else { finding }
            })
            .collect();
        findings.extend(self.turns.as_ref().map(|turns| turns.half_turn().at(turns.place(library))));
        findings.extend(self.dwells.as_ref().map(|dwells| dwells.long_dwell().at(dwells.place(library))));
        gravest_first(&mut findings);
        findings
    }
}
