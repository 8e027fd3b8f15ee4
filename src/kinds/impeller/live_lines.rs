//! The blocks of the published programs as formulas: from the annexes' cells to the text that the machine reads.
//!
//! The sheet of the programs stays text: that is what was verified. Here each block is put together again by the spreadsheet,
//! and compared with it. Positions are rounded to 0.001 first and subtracted after, as the programs are.
//!
//! # References
//! The thesis, section 4.4: the same sheet, with a macro that copied the lines out.

use crate::gcode::program::{Part, Program};
use crate::kinds::impeller::operation::Operation;
use crate::kinds::impeller::tables::ToolPaths;
use crate::machine::axis::{Axis, Position};
use crate::table::{Column, Index, Law, Print, Table, Unit};
use crate::text::{Text, t};

const AXES: [(Axis, &str); 5] = [(Axis::X, "X"), (Axis::Y, "Y"), (Axis::Z, "Z"), (Axis::B, "B"), (Axis::C, "C")];

/// Where a program's passes run: two tables of paths, and rows of annex 8 for what lies between them.
struct Course {
    key: &'static str,
    name: Text,
    title: Text,
    /// The columns of x, y and z of the way out, and of the way back, which is run from its last point to its first.
    paths: [[&'static str; 3]; 2],
    /// The rows of annex 8, from 1: the start, the two safe points at the exit, and those behind the way back.
    start: u8,
    exits: [u8; 2],
    ends: &'static [u8],
    /// What C is turned on beside annex 4, as a term in thousandths.
    turned: &'static str,
    /// Its paths follow inputs only in part.
    in_part: bool,
}

const BLADE: Course = Course {
    key: "live-blade",
    name: t("Líneas álabe", "Lines blade"),
    title: t("Los bloques de un álabe, calculados por la hoja", "The blocks of one blade, computed by the sheet"),
    paths: [["annex-6.x", "annex-6.y", "annex-6.z"], ["annex-7.x", "annex-7.y", "annex-7.z"]],
    start: 1,
    exits: [3, 4],
    ends: &[2, 1, 1],
    turned: "",
    in_part: false,
};

const SPLITTER: Course = Course {
    key: "live-splitter",
    name: t("Líneas intermedio", "Lines splitter"),
    title: t(
        "Los bloques de un álabe intermedio, calculados por la hoja",
        "The blocks of one splitter blade, computed by the sheet",
    ),
    paths: [["splitter.x_1", "splitter.y_1", "splitter.z_1"], ["splitter.x_2", "splitter.y_2", "splitter.z_2"]],
    start: 2,
    exits: [4, 3],
    ends: &[2, 2],
    turned: "+ROUND(180000/blades_N,0)",
    in_part: true,
};

/// The sheets of the programs of one blade and of one splitter in the published layout; none of another program.
#[must_use]
pub fn tables(passes: &ToolPaths, programs: &[Program]) -> Vec<Table> {
    let points = passes.obverse.len();
    let of = |course: &Course, operation: Operation| {
        programs.iter().find(|program| program.key == operation.key()).and_then(|program| course.table(program, points))
    };
    [of(&BLADE, Operation::Blade), of(&SPLITTER, Operation::Splitter)].into_iter().flatten().collect()
}

impl Course {
    /// How many blocks there are beside two for each interval.
    const fn more(&self) -> usize {
        4 + self.ends.len()
    }

    /// The number of the last block.
    fn last(&self) -> String {
        format!("2*intervals_n+{}", self.more())
    }

    /// Row 0 is where the program starts, each further row one block. `None` where the program has other blocks than these.
    fn table(&self, program: &Program, points: usize) -> Option<Table> {
        let mut at = vec![program.start];
        for part in &program.parts {
            if let Part::Path(path) = part {
                at.extend((0..path.positions.len()).filter_map(|step| path.position(step)));
            }
        }
        let mut lines = program.lines();
        let mut texts = vec![String::new()];
        while let Some((_, text)) = lines.next() {
            if text.starts_with("G1 ") {
                texts.push(text.to_owned());
            }
        }
        let last = 2 * (points - 1) + self.more();
        if at.len() != last + 1 || texts.len() != at.len() {
            return None;
        }
        let j: Vec<f64> = (0..=last).map(|i| self.point(i, points - 1)).collect();
        let mut columns = vec![Column::numbers("j", Unit::Count, Law::Told("i → j"), j).by(self.point_formula())];
        for (axis, symbol) in AXES {
            let values: Vec<f64> =
                at.iter().map(|position: &Position| f64::from(position.get(axis).thousandths())).collect();
            let law = Law::Told("1000·x, B, C in thousandths");
            let column = Column::numbers(symbol, Unit::Count, law, values).by(self.axis_formula(axis));
            let of_path = matches!(axis, Axis::X | Axis::Y | Axis::Z);
            columns.push(if self.in_part && of_path { column.in_part() } else { column });
        }
        let same = |texts: &[String]| texts.iter().map(|text| Text::same(text.clone())).collect::<Vec<_>>();
        let blocks = Column::texts(t("bloque", "block"), Law::None, same(&texts)).by(self.text_formula());
        columns.push(if self.in_part { blocks.in_part() } else { blocks });
        columns.push(Column::texts(t("programa", "program"), Law::None, same(&texts)));
        let equal: Vec<f64> = (0..texts.len()).map(|row| if row == 0 { 0.0 } else { 1.0 }).collect();
        let equal = Column::numbers("equal", Unit::Count, Law::None, equal).named(t("igual", "equal"));
        columns.push(equal.by("IF([i]=0,0,IF(EXACT([block],TRIM([program])),1,0))"));
        let count = |row: usize| if row == 0 { Text::same(format!("{last} / {last}")) } else { t("", "") };
        let counted = Column::texts(t("líneas iguales", "equal lines"), Law::None, (0..=last).map(count).collect());
        columns.push(counted.by(format!("IF([i]=0,SUM([equal all])&\" / \"&({}),\"\")", self.last())));
        Some(Table {
            key: self.key,
            name: self.name.clone(),
            title: self.title.clone(),
            source: t(
                "Posiciones en milésimas; la línea 0 es el comienzo. Verificado es el texto de la columna «programa»",
                "Positions in thousandths; line 0 is the start. What was verified is the text in the column \"program\"",
            ),
            index: Index::Intervals { name: "intervals_n", times: 2, more: self.more() },
            print: Print::Formulas,
            columns,
        })
    }

    /// The point of the paths that a block goes to, or stands beside.
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^52")]
    fn point(&self, i: usize, n: usize) -> f64 {
        let j = match i {
            0 => 0,
            _ if i <= n + 1 => i - 1,
            _ if i <= n + 3 => n,
            _ if i <= 2 * n + 4 => 2 * n + 4 - i,
            _ => 0,
        };
        j as f64
    }

    fn point_formula(&self) -> &'static str {
        "IF([i]=0,0,IF([i]<=intervals_n+1,[i]-1,IF([i]<=intervals_n+3,intervals_n,IF([i]<=2*intervals_n+4,2*intervals_n+4-[i],0))))"
    }

    /// The position of an axis in thousandths.
    fn axis_formula(&self, axis: Axis) -> String {
        let last = self.last();
        let coordinate = |letter: char, at: usize| {
            let safe = |row: u8| format!("INDEX([annex-8.{letter} all],{row})");
            let [out, back] = self.paths.map(|path| format!("INDEX([{} all],[j]+1)", path[at]));
            let ends = match self.ends {
                [first, second, ..] if first != second => {
                    format!("IF([i]=2*intervals_n+5,{},{})", safe(*first), safe(*second))
                }
                [first, ..] => safe(*first),
                [] => String::new(),
            };
            format!(
                "ROUND(1000*IF([i]=0,{},IF([i]<=intervals_n+1,{out},IF([i]=intervals_n+2,{},IF([i]=intervals_n+3,{},IF([i]<=2*intervals_n+4,{back},{ends}))))),0)",
                safe(self.start),
                safe(self.exits[0]),
                safe(self.exits[1]),
            )
        };
        match axis {
            Axis::X => coordinate('x', 0),
            Axis::Y => coordinate('y', 1),
            Axis::Z => coordinate('z', 2),
            // In whole numbers, as in the programs: many of them lie between two thousandths.
            Axis::B => "IF([j]<intervals_n,ROUND(90000*(intervals_n-[j])/intervals_n,0),ROUND(1000*DEGREES([annex-4.B last]),0))".to_owned(),
            _ => format!(
                "ROUND(1000*DEGREES(INDEX([annex-4.C all],[j]+1)),0){}+IF([i]={last},ROUND(360000/blades_N,0),0)",
                self.turned
            ),
        }
    }

    /// The block: every axis by its increment, the last one C alone.
    fn text_formula(&self) -> String {
        let last = self.last();
        // A spreadsheet writes its own decimal sign; the machine reads a point.
        let word = |symbol: &str| format!("\"{symbol}\"&SUBSTITUTE(([{symbol}]-[{symbol} above])/1000,\",\",\".\")");
        let all = AXES.map(|(_, symbol)| word(symbol)).join("&\" \"&");
        format!("IF([i]=0,\"\",IF([i]={last},\"G1 \"&{},\"G1 \"&{all}))", word("C"))
    }
}
